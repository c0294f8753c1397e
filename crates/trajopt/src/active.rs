use crate::block::Block;
use crate::constraints::{BodyRules, LineRules, PairRules, PointRules, StepRules};
use crate::row::Row;
use crate::step::Step;
use crate::term::{PAIR, POINT, POSE, QUAD, STEP};

/// All rows in play: those of every step and of the pair, and those of objects and obstacles nearby, which are looked up
/// again as the trajectories move.
#[derive(Clone, Debug, Default)]
pub(crate) struct ActiveSet {
    pub steps: Block<StepRules, STEP>,
    pub pairs: Block<PairRules, PAIR>,
    pub points: Block<PointRules, POINT>,
    pub bodies: Block<BodyRules, POSE>,
    pub lines: Block<LineRules, QUAD>,
    /// Every robot-step, at the iterate or at the last trial point.
    pub frames: Vec<Step>,
    /// Waypoint at which the line passes over each object.
    pub crossings: Vec<usize>,
}

impl ActiveSet {
    /// Every row.
    pub fn rows_mut(&mut self) -> impl Iterator<Item = &mut Row> {
        self.steps
            .rows_mut()
            .chain(self.pairs.rows_mut())
            .chain(self.points.rows_mut())
            .chain(self.bodies.rows_mut())
            .chain(self.lines.rows_mut())
    }
}
