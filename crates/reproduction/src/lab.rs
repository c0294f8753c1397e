//! Where experiments are made: what they may ask of whoever runs them.

use crate::authors::Authors;
use pairtrawl::execute::ExecutionObserver;
use pairtrawl::{Observer, PlanError};
use serde::Serialize;
use serde::de::DeserializeOwned;
use thiserror::Error;

/// Whoever runs experiments: tells the time, may stop them, and keeps what is finished. Asked from several threads.
pub trait Host: Sync {
    /// A step of work begins; it is in words for people.
    fn doing(&self, _what: &str) {}

    /// True ends the work.
    fn interrupted(&self) -> bool {
        false
    }

    /// Seconds since some instant; only timings come from it.
    fn now(&self) -> f64 {
        0.0
    }

    /// What [`Self::keep`] was given under this name for the same program and the same input.
    fn recall(&self, _name: &str) -> Option<String> {
        None
    }

    /// Keeps a finished piece of work.
    fn keep(&self, _name: &str, _text: &str) {}
}

impl Host for () {}

/// Why an experiment has no result.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
pub enum Stopped {
    /// The host stopped it; what is finished is kept.
    #[error("interrupted")]
    Interrupted,
    /// It cannot be made.
    #[error("{what}: {why}")]
    Failed {
        /// The experiment.
        what: String,
        /// What went wrong.
        why: String,
    },
}

impl Stopped {
    /// An experiment that cannot be made.
    pub fn failed(what: &str, why: impl ToString) -> Self {
        Self::Failed {
            what: what.to_owned(),
            why: why.to_string(),
        }
    }

    /// From a planner that was to find a plan.
    pub fn from_plan(what: &str, error: &PlanError) -> Self {
        match error {
            PlanError::Interrupted => Self::Interrupted,
            other => Self::failed(what, other),
        }
    }
}

/// Everything that an experiment works with.
#[derive(Clone, Copy)]
pub struct Lab<'a> {
    /// Fewer lengths, seeds and variants.
    pub quick: bool,
    /// Who runs it.
    pub host: &'a dyn Host,
    /// The trajectories that the paper's authors published, when they are at hand.
    pub authors: Option<&'a Authors>,
}

impl<'a> Lab<'a> {
    /// What watches planning and driving for the host.
    pub fn watch(&self) -> Watch<'a> {
        Watch(self.host)
    }

    /// # Errors
    /// When the host stops the work.
    pub fn may_go_on(&self) -> Result<(), Stopped> {
        match self.host.interrupted() {
            true => Err(Stopped::Interrupted),
            false => Ok(()),
        }
    }

    /// Does a piece of work, or takes its result from an earlier run that was interrupted.
    ///
    /// # Errors
    /// What the work says.
    pub fn remember<T: Serialize + DeserializeOwned>(
        &self,
        name: &str,
        work: impl FnOnce() -> Result<T, Stopped>,
    ) -> Result<T, Stopped> {
        if let Some(text) = self.host.recall(name)
            && let Ok(known) = serde_json::from_str(&text)
        {
            return Ok(known);
        }
        self.may_go_on()?;
        let result = work()?;
        if let Ok(text) = serde_json::to_string(&result) {
            self.host.keep(name, &text);
        }
        Ok(result)
    }
}

/// Watches planners and drives for a host.
#[derive(Clone, Copy)]
pub struct Watch<'a>(&'a dyn Host);

impl Observer for Watch<'_> {
    fn now(&self) -> f64 {
        self.0.now()
    }

    fn interrupted(&self) -> bool {
        self.0.interrupted()
    }
}

impl ExecutionObserver for Watch<'_> {
    fn interrupted(&self) -> bool {
        self.0.interrupted()
    }
}
