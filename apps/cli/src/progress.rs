//! Progress by stage: a spinner on a terminal, nothing when standard error is piped.

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use pairtrawl::{Observer, Stage};
use std::time::Duration;

/// Shows the stage at work.
pub struct Progress {
    spinner: ProgressBar,
}

impl Progress {
    /// A spinner on standard error when that is a terminal.
    pub fn new() -> Self {
        let spinner = ProgressBar::with_draw_target(None, ProgressDrawTarget::stderr());
        if let Ok(style) = ProgressStyle::with_template("{spinner} {msg} [{elapsed}]") {
            spinner.set_style(style);
        }
        if !spinner.is_hidden() {
            spinner.enable_steady_tick(Duration::from_millis(100));
        }
        Self { spinner }
    }

    /// A spinner beside one message.
    pub fn saying(message: &'static str) -> Self {
        let progress = Self::new();
        progress.spinner.set_message(message);
        progress
    }

    /// Clears the spinner.
    pub fn finish(self) {
        self.spinner.finish_and_clear();
    }
}

impl Observer for Progress {
    fn started(&mut self, stage: Stage, round: usize) {
        let doing = match stage {
            Stage::Proofs => "looking for a proof of infeasibility",
            Stage::World => "mapping obstacles and objects",
            Stage::Order => "ordering the circles",
            Stage::Explore => "exploring several starts",
            Stage::Centerline => "searching the centerline",
            Stage::Baseline => "laying out the baseline pair",
            Stage::Optimize => "optimizing both trajectories",
            Stage::Certify => "proving the plan",
            Stage::Rehearse => "rehearsing in physics",
        };
        let round = if round > 1 {
            format!(" (round {round})")
        } else {
            String::new()
        };
        self.spinner.set_message(format!("{doing}{round}"));
    }

    fn noted(&mut self, message: &str) {
        if !self.spinner.is_hidden() {
            self.spinner.println(message);
        }
    }

    fn interrupted(&self) -> bool {
        crate::interrupt::requested()
    }
}
