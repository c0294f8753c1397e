use crate::error::PlanError;
use crate::observer::{Observer, Stage};
use crate::options::PlanOptions;
use pairtrawl_model::StageTime;

/// One planning run under way: its clock, its observer and the seconds of its stages. The clock is the observer's, and is
/// read nowhere below this crate.
pub(crate) struct Run<'a> {
    observer: &'a mut dyn Observer,
    begin: f64,
    limit: Option<f64>,
    last: Stage,
    /// The round of optimization, from 1.
    pub round: usize,
    /// Seconds per stage, in the order of their first start.
    pub stages: Vec<StageTime>,
}

impl<'a> Run<'a> {
    pub fn new(options: &PlanOptions, observer: &'a mut dyn Observer) -> Self {
        let begin = observer.now();
        Self {
            observer,
            begin,
            limit: options.time_limit.map(|limit| limit.as_secs_f64()),
            last: Stage::Proofs,
            round: 1,
            stages: Vec::new(),
        }
    }

    /// Runs a stage, unless the time is up or someone wants to stop; the same is asked again after it.
    pub fn stage<T>(&mut self, stage: Stage, work: impl FnOnce() -> T) -> Result<T, PlanError> {
        self.watched_stage(stage, |_| work())
    }

    /// Runs a stage that asks now and then, perhaps from several threads, whether it may go on. When it may not, its result
    /// is thrown away.
    pub fn watched_stage<T>(
        &mut self,
        stage: Stage,
        work: impl FnOnce(&(dyn Fn() -> bool + Sync)) -> T,
    ) -> Result<T, PlanError> {
        let result = self.unfinished_stage(stage, work)?;
        self.may_go_on(1.0)?;
        Ok(result)
    }

    /// The same for a stage whose result is of use even when it was stopped.
    pub fn unfinished_stage<T>(
        &mut self,
        stage: Stage,
        work: impl FnOnce(&(dyn Fn() -> bool + Sync)) -> T,
    ) -> Result<T, PlanError> {
        self.stage_until(1.0, stage, work)
    }

    /// The same for a stage that leaves some time for what comes after it: it ends when this share of the time limit is over.
    pub fn stage_until<T>(
        &mut self,
        share: f64,
        stage: Stage,
        work: impl FnOnce(&(dyn Fn() -> bool + Sync)) -> T,
    ) -> Result<T, PlanError> {
        self.may_go_on(1.0)?;
        self.last = stage;
        self.observer.started(stage, self.round);
        let begin = self.observer.now();
        let result = work(&|| self.may_go_on(share).is_ok());
        let seconds = self.observer.now() - begin;
        self.observer.finished(stage, seconds);
        match self
            .stages
            .iter_mut()
            .find(|seen| seen.name == stage.name())
        {
            Some(seen) => seen.seconds += seconds,
            None => self.stages.push(StageTime {
                name: stage.name().to_owned(),
                seconds,
            }),
        }
        Ok(result)
    }

    /// Tells the observer something.
    pub fn note(&mut self, message: &str) {
        self.observer.noted(message);
    }

    /// Seconds spent in a stage so far.
    pub fn seconds(&self, stage: Stage) -> f64 {
        self.stages
            .iter()
            .filter(|seen| seen.name == stage.name())
            .map(|seen| seen.seconds)
            .sum()
    }

    /// Refuses when someone wants to stop, or when this share of the time limit is over.
    fn may_go_on(&self, share: f64) -> Result<(), PlanError> {
        if self.observer.interrupted() {
            return Err(PlanError::Interrupted);
        }
        match self.limit {
            Some(limit) if self.observer.now() - self.begin > share * limit => {
                Err(PlanError::TimeLimit {
                    limit,
                    stage: self.last,
                })
            }
            _ => Ok(()),
        }
    }
}
