use crate::statistics::{settled_max, settled_rms};
use pairtrawl_model::TrackingStatistics;

/// What came of a run.
pub(crate) struct Outcome {
    /// Position error of each robot.
    pub(crate) tracking: [TrackingStatistics; 2],
    /// The supervisor stopped the pair.
    pub(crate) stopped: bool,
    /// Greatest torque of a wheel, N m.
    pub(crate) max_torque: f64,
    /// Its drag was more than the tires could bear.
    pub(crate) beyond_traction: bool,
    /// Objects in the net at the end, where there are any.
    pub(crate) gathered: usize,
}

impl Outcome {
    /// Greatest position error of either robot after the first second, m.
    pub(crate) fn worst(&self) -> f64 {
        settled_max(&self.tracking)
    }

    /// Root mean square error of both robots after the first second, m.
    pub(crate) fn rms(&self) -> f64 {
        settled_rms(&self.tracking)
    }
}
