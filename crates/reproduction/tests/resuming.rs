//! A run that is interrupted goes on where it was, and two runs say the same.

use pairtrawl_reproduction::{CHAPTERS, Host, Lab, Stopped, make};
use std::collections::BTreeMap;
use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};

#[derive(Default)]
struct Kept {
    texts: Mutex<BTreeMap<String, String>>,
    written: AtomicUsize,
    stops: AtomicBool,
}

impl Host for Kept {
    fn interrupted(&self) -> bool {
        self.stops.load(Ordering::SeqCst)
    }

    fn recall(&self, name: &str) -> Option<String> {
        self.texts.lock().expect("unpoisoned").get(name).cloned()
    }

    fn keep(&self, name: &str, text: &str) {
        self.written.fetch_add(1, Ordering::SeqCst);
        let mut texts = self.texts.lock().expect("unpoisoned");
        texts.insert(name.to_owned(), text.to_owned());
    }
}

#[test]
fn what_is_finished_is_not_made_again() {
    let chapter = CHAPTERS.iter().find(|c| c.id == "setup").expect("a part");
    let kept = Kept::default();
    let lab = Lab {
        quick: true,
        host: &kept,
        authors: None,
    };
    kept.stops.store(true, Ordering::SeqCst);
    assert_eq!(make(chapter, &lab), Err(Stopped::Interrupted));
    kept.stops.store(false, Ordering::SeqCst);
    let first = make(chapter, &lab).expect("made");
    assert_eq!(kept.written.load(Ordering::SeqCst), 1);
    // Even a stopped run has what was kept.
    kept.stops.store(true, Ordering::SeqCst);
    let again = make(chapter, &lab).expect("kept");
    assert_eq!(kept.written.load(Ordering::SeqCst), 1);
    assert_eq!(first, again);
    let anew = make(chapter, &Lab { host: &(), ..lab }).expect("made");
    assert_eq!(first, anew);
}
