//! Makes the parts of the reproduction and keeps what is finished.

pub mod unfinished;

use crate::failure::Failure;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use pairtrawl_reproduction::{Chapter, Host, Lab, Made, Stopped, make};
use std::path::Path;
use std::time::{Duration, Instant};
use unfinished::Unfinished;

/// The host of the experiments: a bar on a terminal, the system's clock, a folder for what is finished.
pub struct Bench {
    bar: ProgressBar,
    begin: Instant,
    kept: Unfinished,
}

impl Bench {
    /// For a number of parts; finished work goes to a subfolder of `output`. It counts for the same program, the same
    /// options and the same data of the authors' only.
    ///
    /// # Errors
    /// When the subfolder cannot be made.
    pub fn new(
        output: &Path,
        chapters: &[&Chapter],
        quick: bool,
        authors: Option<&str>,
    ) -> Result<Self, Failure> {
        let target = ProgressDrawTarget::stderr();
        let bar = ProgressBar::with_draw_target(Some(chapters.len() as u64), target);
        let style = "{spinner} {pos} of {len} parts: {prefix}: {msg} [{elapsed}]";
        if let Ok(style) = ProgressStyle::with_template(style) {
            bar.set_style(style);
        }
        if !bar.is_hidden() {
            bar.enable_steady_tick(Duration::from_millis(100));
        }
        Ok(Self {
            bar,
            begin: Instant::now(),
            kept: Unfinished::new(output, quick, authors)?,
        })
    }

    /// Makes all parts, one after the other.
    ///
    /// # Errors
    /// When one cannot be made, or somebody stops it.
    pub fn all(&self, lab: &Lab, chapters: &[&Chapter]) -> Result<Vec<Made>, Stopped> {
        let one = |chapter: &&Chapter| {
            self.bar.set_prefix(chapter.title);
            self.bar.set_message("");
            let made = make(chapter, lab);
            self.bar.inc(1);
            made
        };
        chapters.iter().map(one).collect()
    }

    /// Clears the bar.
    pub fn finish(&self) {
        self.bar.finish_and_clear();
    }
}

impl Host for Bench {
    fn doing(&self, what: &str) {
        self.bar.set_message(what.to_owned());
    }

    fn interrupted(&self) -> bool {
        crate::interrupt::requested()
    }

    fn now(&self) -> f64 {
        self.begin.elapsed().as_secs_f64()
    }

    fn recall(&self, name: &str) -> Option<String> {
        self.kept.read(name)
    }

    fn keep(&self, name: &str, text: &str) {
        self.kept.write(name, text);
    }
}
