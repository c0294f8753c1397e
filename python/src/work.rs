//! Work in the background: the interpreter's lock is free meanwhile, the calling thread hands on what is reported and looks
//! for Ctrl-C twenty times a second.

use crate::errors::internal;
use crate::pools::pool;
use pairtrawl::execute::ExecutionObserver;
use pairtrawl::{Observer, Stage};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use std::any::Any;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Condvar, Mutex, PoisonError};
use std::time::Duration;

/// How often the calling thread looks for signals.
const GLANCE: Duration = Duration::from_millis(50);
/// Memory for the stack of the thread that works: as much as a main thread has.
pub const STACK_BYTES: usize = 8 << 20;

/// What is reported to a callback.
pub enum Event {
    /// A stage of planning begins.
    Started(Stage, usize),
    /// A stage ended after so many seconds.
    Finished(Stage, f64),
    /// Words for people.
    Noted(String),
    /// One of many is done.
    Done(usize),
}

#[derive(Default)]
struct Inbox {
    events: Vec<Event>,
    is_over: bool,
}

/// What the working and the calling thread share.
#[derive(Default)]
pub struct Watch {
    stop: AtomicBool,
    reports: bool,
    inbox: Mutex<Inbox>,
    news: Condvar,
}

impl Watch {
    fn tell(&self, change: impl FnOnce(&mut Inbox)) {
        let mut inbox = self.inbox.lock().unwrap_or_else(PoisonError::into_inner);
        change(&mut inbox);
        self.news.notify_one();
    }

    /// Reports something.
    pub fn report(&self, event: Event) {
        if self.reports {
            self.tell(|inbox| inbox.events.push(event));
        }
    }

    /// True when the work is to end.
    pub fn is_stopped(&self) -> bool {
        self.stop.load(Ordering::Relaxed)
    }

    /// What was reported since the last time, and whether the work is over.
    fn wait(&self) -> (Vec<Event>, bool) {
        let inbox = self.inbox.lock().unwrap_or_else(PoisonError::into_inner);
        let quiet = |inbox: &mut Inbox| inbox.events.is_empty() && !inbox.is_over;
        let waited = self.news.wait_timeout_while(inbox, GLANCE, quiet);
        let (mut inbox, _) = waited.unwrap_or_else(PoisonError::into_inner);
        (std::mem::take(&mut inbox.events), inbox.is_over)
    }
}

/// The planner's reports go to a watch.
pub struct PlanWatch<'a>(pub &'a Watch);

impl Observer for PlanWatch<'_> {
    fn started(&mut self, stage: Stage, round: usize) {
        self.0.report(Event::Started(stage, round));
    }

    fn finished(&mut self, stage: Stage, seconds: f64) {
        self.0.report(Event::Finished(stage, seconds));
    }

    fn noted(&mut self, message: &str) {
        self.0.report(Event::Noted(message.to_owned()));
    }

    fn interrupted(&self) -> bool {
        self.0.is_stopped()
    }
}

/// One of many plans: only its end is reported.
pub struct QuietWatch<'a>(pub &'a Watch);

impl Observer for QuietWatch<'_> {
    fn interrupted(&self) -> bool {
        self.0.is_stopped()
    }
}

impl ExecutionObserver for Watch {
    fn finished(&self, index: usize) {
        self.report(Event::Done(index));
    }

    fn interrupted(&self) -> bool {
        self.is_stopped()
    }
}

/// The words of a panic.
pub fn words(panic: &(dyn Any + Send)) -> String {
    (panic
        .downcast_ref::<&str>()
        .map(|words| (*words).to_owned()))
    .or_else(|| panic.downcast_ref::<String>().cloned())
    .unwrap_or_else(|| "a panic without words".to_owned())
}

/// Does work on a pool of `threads` threads (`None`: all of the machine). What it reports goes to `progress`, a callable
/// that takes keywords. An exception of the callback or of a signal ends the work and comes out of here; so does a panic,
/// as an `InternalError`.
pub fn watched<T: Send>(
    py: Python<'_>,
    threads: Option<usize>,
    progress: Option<&Bound<'_, PyAny>>,
    work: impl FnOnce(&Watch) -> T + Send,
) -> PyResult<T> {
    let pool = pool(threads.unwrap_or(0)).map_err(|words| internal(py, &words))?;
    let watch = Watch {
        reports: progress.is_some(),
        ..Watch::default()
    };
    let mut failed = None;
    let result = std::thread::scope(|scope| {
        let thread = std::thread::Builder::new().stack_size(STACK_BYTES);
        let worker = thread.spawn_scoped(scope, || {
            let result = catch_unwind(AssertUnwindSafe(|| pool.install(|| work(&watch))));
            watch.tell(|inbox| inbox.is_over = true);
            result
        });
        let worker = worker.map_err(|error| error.to_string())?;
        loop {
            let (events, is_over) = py.detach(|| watch.wait());
            if failed.is_none() {
                failed = py.check_signals().err().or_else(|| {
                    let progress = progress?;
                    events.into_iter().find_map(|e| hand_on(progress, e).err())
                });
                watch.stop.store(failed.is_some(), Ordering::Relaxed);
            }
            if is_over {
                break;
            }
        }
        let joined = worker.join().unwrap_or_else(Err);
        joined.map_err(|panic| words(panic.as_ref()))
    });
    match failed {
        Some(error) => Err(error),
        None => result.map_err(|words| internal(py, &words)),
    }
}

fn hand_on(progress: &Bound<'_, PyAny>, event: Event) -> PyResult<()> {
    let keywords = PyDict::new(progress.py());
    match event {
        Event::Started(stage, round) => {
            keywords.set_item("kind", "started")?;
            keywords.set_item("stage", stage.name())?;
            keywords.set_item("round", round)?;
        }
        Event::Finished(stage, seconds) => {
            keywords.set_item("kind", "finished")?;
            keywords.set_item("stage", stage.name())?;
            keywords.set_item("seconds", seconds)?;
        }
        Event::Noted(message) => {
            keywords.set_item("kind", "noted")?;
            keywords.set_item("message", message)?;
        }
        Event::Done(index) => {
            keywords.set_item("kind", "done")?;
            keywords.set_item("index", index)?;
        }
    }
    progress.call((), Some(&keywords)).map(|_| ())
}
