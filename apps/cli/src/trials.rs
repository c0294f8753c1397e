//! Progress of runs that go on in parallel: a bar on a terminal, nothing when standard error is piped.

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use pairtrawl::execute::ExecutionObserver;
use std::sync::Mutex;

/// Steps of the bar for each run.
const RESOLUTION: f64 = 1000.0;

/// A bar over runs.
pub struct Trials {
    bar: ProgressBar,
    parts: Mutex<Vec<f64>>,
}

impl Trials {
    /// A bar for this number of runs.
    pub fn new(runs: usize, what: &'static str) -> Self {
        let length = (runs as f64 * RESOLUTION) as u64;
        let bar = ProgressBar::with_draw_target(Some(length), ProgressDrawTarget::stderr());
        if let Ok(style) =
            ProgressStyle::with_template("{msg} {wide_bar} {percent} % [{elapsed}, {eta} left]")
        {
            bar.set_style(style);
        }
        bar.set_message(what);
        Self {
            bar,
            parts: Mutex::new(vec![0.0; runs]),
        }
    }

    /// Clears the bar.
    pub fn finish(self) {
        self.bar.finish_and_clear();
    }

    fn set(&self, index: usize, part: f64) {
        if self.bar.is_hidden() {
            return;
        }
        let mut parts = self
            .parts
            .lock()
            .unwrap_or_else(|poisoned| poisoned.into_inner());
        if let Some(entry) = parts.get_mut(index) {
            *entry = part;
        }
        self.bar
            .set_position((parts.iter().sum::<f64>() * RESOLUTION) as u64);
    }
}

impl ExecutionObserver for Trials {
    fn progressed(&self, index: usize, part: f64) {
        self.set(index, part);
    }

    fn finished(&self, index: usize) {
        self.set(index, 1.0);
    }

    fn interrupted(&self) -> bool {
        crate::interrupt::requested()
    }
}
