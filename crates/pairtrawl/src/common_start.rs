use crate::error::PlanError;
use crate::no_plan::NoPlan;
use crate::observer::Stage;
use crate::options::{NetLength, PlanOptions};
use crate::prepare::{Prepared, prepare};
use crate::run::Run;
use crate::starts::starts;
use pairtrawl_geometry::Pose;
use pairtrawl_model::{PairTrajectory, Scene};

/// What studies over the net length have in common: the start that is best with the length open, for every length. In
/// units of the length scale.
pub(crate) struct CommonStart {
    pub order: Vec<usize>,
    pub centerline: Vec<Pose>,
    /// What is optimized from.
    pub pair: PairTrajectory,
}

/// The options of a study: those given, with the net length open and without a rehearsal.
pub(crate) fn study_options(options: &PlanOptions) -> PlanOptions {
    PlanOptions {
        net_length: Some(NetLength::Auto),
        ..options.clone()
    }
}

impl CommonStart {
    /// Prepares a scene with the net length open (see [`study_options`]) and finds the start.
    pub fn find<'a>(
        scene: &'a Scene,
        open: &'a PlanOptions,
        run: &mut Run,
    ) -> Result<(Prepared<'a>, Self), PlanError> {
        let prepared = prepare(scene, open, run)?;
        let start = (starts(&prepared, run)?.into_iter().next()).ok_or(NoPlan::NoStart)?;
        let centerline = run
            .stage(Stage::Centerline, || start.centerline(&prepared))?
            .map_err(|error| prepared.route_error(error))?;
        let pair = match start.pair() {
            Some(pair) => pair.clone(),
            None => run
                .stage(Stage::Baseline, || start.baseline(&prepared))?
                .map_err(|error| prepared.route_error(error))?,
        };
        let order = start.order;
        Ok((
            prepared,
            Self {
                order,
                centerline,
                pair,
            },
        ))
    }
}
