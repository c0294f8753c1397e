//! Looks up the rows in play around an iterate.

use crate::active::ActiveSet;
use crate::anchor::{Anchor, LineAt, PairAt, PointAt, PoseAt, StepAt};
use crate::block::Block;
use crate::crossings::refresh_crossings;
use crate::iterate::Iterate;
use crate::problem::Problem;
use crate::row::Beginning;
use crate::rule::Rules;
use crate::sight::Sight;
use crate::step::{Coordinate, Step};
use pairtrawl_model::Side;

impl ActiveSet {
    /// The rows of a problem around an iterate.
    pub fn new(problem: &Problem, x: &Iterate, beginning: Beginning) -> Self {
        let count = x.stages.len();
        let mut set = Self::default();
        let robot_steps = (0..count - 1).flat_map(|step| Side::BOTH.map(|robot| (step, robot)));
        let frame = |(i, robot)| Step::seen(problem, x, i, robot);
        set.frames = robot_steps.clone().map(frame).collect();
        let mut sight = Sight::new(problem, x, &[]);
        let of_steps = robot_steps.flat_map(|(step, robot)| {
            Coordinate::BOTH.map(|coordinate| StepAt::new(step, robot, coordinate))
        });
        look_up(&mut set.steps, of_steps, &mut sight, &set.frames, beginning);
        let of_pairs = (0..count as u32).map(PairAt);
        look_up(&mut set.pairs, of_pairs, &mut sight, &set.frames, beginning);
        set.refresh(problem, x, beginning);
        set
    }

    /// Looks up again what is near, keeping the multipliers of what stays in play.
    pub fn refresh(&mut self, problem: &Problem, x: &Iterate, beginning: Beginning) {
        let count = x.stages.len();
        refresh_crossings(&mut self.crossings, problem, x);
        let mut sight = Sight::new(problem, x, &self.crossings);
        let of_points =
            (1..count - 1).flat_map(|stage| Side::BOTH.map(|robot| PointAt::new(stage, robot)));
        let of_lines = (0..count as u32 - 1).map(LineAt);
        let frames = &self.frames;
        if problem.robot.body.is_some() {
            // Circles of both bodies come near each other, or leave.
            let of_pairs = (0..count as u32).map(PairAt);
            look_up(&mut self.pairs, of_pairs, &mut sight, frames, beginning);
            let of_bodies =
                (1..count - 1).flat_map(|stage| Side::BOTH.map(|robot| PoseAt::new(stage, robot)));
            look_up(&mut self.bodies, of_bodies, &mut sight, frames, beginning);
        }
        look_up(&mut self.points, of_points, &mut sight, frames, beginning);
        look_up(&mut self.lines, of_lines, &mut sight, frames, beginning);
    }
}

/// Fills a block again with the rows of anchors, which ascend.
fn look_up<R: Rules<K>, const K: usize>(
    block: &mut Block<R, K>,
    anchors: impl Iterator<Item = R::At>,
    sight: &mut Sight,
    frames: &[Step],
    beginning: Beginning,
) {
    // Room for a few more rows than before: growing lists cost more than looking things up.
    let room = block.items.len() + block.items.len() / 4;
    let mut new = Block {
        items: Vec::with_capacity(room),
    };
    let (problem, x) = (sight.problem, sight.x);
    for at in anchors {
        R::look_up(sight, at, &mut |rule| {
            new.push(problem, (at, rule), &at.coordinates(x, frames), beginning);
        });
    }
    new.carry_over(block);
    *block = new;
}
