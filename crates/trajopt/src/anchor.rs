//! Where the local coordinates of a term are among the variables: of the pair, of one robot, of the line between them, of a
//! step.

use crate::iterate::{Direction, Iterate};
use crate::local::Local;
use crate::step::{Coordinate, Step};
use crate::system::{StepDerivatives, System, Variable};
use crate::term::{PAIR, POINT, POSE, QUAD, STEP};
use pairtrawl_geometry::Point;
use pairtrawl_model::Side;
use std::fmt::Debug;

/// What `K` local coordinates are, at one place of the course.
pub(crate) trait Anchor<const K: usize>: Copy + Ord + Debug {
    /// Whether all constraints here are affine in the coordinates: they are then written down once, when they are looked up.
    const AFFINE: bool = false;

    /// The coordinates of a point, whose steps have these frames.
    fn coordinates(self, x: &Iterate, frames: &[Step]) -> [f64; K];
    /// Adds derivatives to the variables that the coordinates move with.
    fn scatter(self, local: &Local<K>, frames: &[Step], system: &mut System);
    /// The waypoint, or the one that the step begins at.
    fn stage(self) -> usize;
    /// First-order change of the coordinates along a direction.
    fn change(self, direction: &Direction, frames: &[Step]) -> [f64; K];
    /// Where it is in the plane, for reports, m.
    fn location(self, x: &Iterate) -> Point;
}

/// A coordinate of one robot over the step from a waypoint: one number, since there are many of them.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct StepAt(u32);

/// The pair at a waypoint.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct PairAt(pub u32);

/// A robot's axle center at a waypoint: one number, since there are many of them.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct PointAt(u32);

/// A robot's pose at a waypoint: one number, as that of its axle center.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct PoseAt(u32);

/// The line between the robots over the step from a waypoint.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct LineAt(pub u32);

impl StepAt {
    pub fn new(step: usize, robot: Side, coordinate: Coordinate) -> Self {
        Self::of(2 * step + robot.index(), coordinate)
    }

    /// A coordinate of the robot-step that has this place in lists of them.
    #[inline]
    pub fn of(index: usize, coordinate: Coordinate) -> Self {
        Self((2 * index) as u32 + u32::from(coordinate == Coordinate::Turn))
    }

    /// Place of the robot-step in lists of them.
    #[inline]
    pub fn index(self) -> usize {
        self.0 as usize / 2
    }

    #[inline]
    pub fn robot(self) -> Side {
        Side::BOTH[self.index() % 2]
    }

    #[inline]
    pub fn coordinate(self) -> Coordinate {
        if self.0.is_multiple_of(2) {
            Coordinate::Along
        } else {
            Coordinate::Turn
        }
    }
}

impl PointAt {
    pub fn new(stage: usize, robot: Side) -> Self {
        Self((2 * stage + robot.index()) as u32)
    }

    #[inline]
    pub fn robot(self) -> Side {
        Side::BOTH[self.0 as usize % 2]
    }
}

impl PoseAt {
    pub fn new(stage: usize, robot: Side) -> Self {
        Self((2 * stage + robot.index()) as u32)
    }

    #[inline]
    pub fn robot(self) -> Side {
        Side::BOTH[self.0 as usize % 2]
    }
}

impl Anchor<STEP> for StepAt {
    const AFFINE: bool = true;

    #[inline]
    fn coordinates(self, _: &Iterate, frames: &[Step]) -> [f64; STEP] {
        [frames[self.index()].coordinate(self.coordinate())]
    }

    fn scatter(self, local: &Local<STEP>, frames: &[Step], system: &mut System) {
        let mut d = StepDerivatives::default();
        d.add(self.coordinate(), local);
        let frame = &frames[self.index()];
        system.scatter_step(self.stage(), self.robot(), frame, &d);
    }

    #[inline]
    fn stage(self) -> usize {
        self.index() / 2
    }

    #[inline]
    fn change(self, direction: &Direction, frames: &[Step]) -> [f64; STEP] {
        let (i, k) = (self.stage(), 3 * self.robot().index());
        let (a, b) = (direction.stage(i), direction.stage(i + 1));
        let (along, _, turn) = frames[self.index()].change(&a[k..k + 3], &b[k..k + 3]);
        match self.coordinate() {
            Coordinate::Along => [along],
            Coordinate::Turn => [turn],
        }
    }

    fn location(self, x: &Iterate) -> Point {
        x.position(self.stage(), self.robot())
    }
}

impl Anchor<PAIR> for PairAt {
    #[inline]
    fn coordinates(self, x: &Iterate, _: &[Step]) -> [f64; PAIR] {
        x.pair(self.0 as usize)
    }

    #[inline]
    fn scatter(self, local: &Local<PAIR>, _: &[Step], system: &mut System) {
        let Some(b) = system.base(self.0 as usize) else {
            return system.scatter_length(&[], PAIR - 1, local);
        };
        // rx = lx - rx, ry = ly - ry, both headings.
        let variables = [
            (b, 0, 1.0),
            (b + 1, 1, 1.0),
            (b + 2, 2, 1.0),
            (b + 3, 0, -1.0),
            (b + 4, 1, -1.0),
            (b + 5, 3, 1.0),
        ];
        system.scatter(&variables, local);
        system.scatter_length(&variables, PAIR - 1, local);
    }

    #[inline]
    fn stage(self) -> usize {
        self.0 as usize
    }

    #[inline]
    fn change(self, direction: &Direction, _: &[Step]) -> [f64; PAIR] {
        let d = direction.stage(self.stage());
        [d[0] - d[3], d[1] - d[4], d[2], d[5], direction.length]
    }

    fn location(self, x: &Iterate) -> Point {
        x.middle(self.stage())
    }
}

impl Anchor<POINT> for PointAt {
    #[inline]
    fn coordinates(self, x: &Iterate, _: &[Step]) -> [f64; POINT] {
        x.point(self.stage(), self.robot())
    }

    #[inline]
    fn scatter(self, local: &Local<POINT>, _: &[Step], system: &mut System) {
        if let Some(b) = system.base(self.stage()) {
            let v = b + 3 * self.robot().index();
            system.scatter(&[(v, 0, 1.0), (v + 1, 1, 1.0)], local);
        }
    }

    #[inline]
    fn stage(self) -> usize {
        self.0 as usize / 2
    }

    #[inline]
    fn change(self, direction: &Direction, _: &[Step]) -> [f64; POINT] {
        let (d, k) = (direction.stage(self.stage()), 3 * self.robot().index());
        [d[k], d[k + 1]]
    }

    fn location(self, x: &Iterate) -> Point {
        x.position(self.stage(), self.robot())
    }
}

impl Anchor<POSE> for PoseAt {
    #[inline]
    fn coordinates(self, x: &Iterate, _: &[Step]) -> [f64; POSE] {
        x.pose(self.stage(), self.robot())
    }

    fn scatter(self, local: &Local<POSE>, _: &[Step], system: &mut System) {
        if let Some(b) = system.base(self.stage()) {
            let v = b + 3 * self.robot().index();
            system.scatter(&[(v, 0, 1.0), (v + 1, 1, 1.0), (v + 2, 2, 1.0)], local);
        }
    }

    #[inline]
    fn stage(self) -> usize {
        self.0 as usize / 2
    }

    #[inline]
    fn change(self, direction: &Direction, _: &[Step]) -> [f64; POSE] {
        let (d, k) = (direction.stage(self.stage()), 3 * self.robot().index());
        std::array::from_fn(|v| d[k + v])
    }

    fn location(self, x: &Iterate) -> Point {
        x.position(self.stage(), self.robot())
    }
}

impl Anchor<QUAD> for LineAt {
    #[inline]
    fn coordinates(self, x: &Iterate, _: &[Step]) -> [f64; QUAD] {
        x.quad(self.0 as usize)
    }

    fn scatter(self, local: &Local<QUAD>, _: &[Step], system: &mut System) {
        const POSITIONS: [usize; 4] = [0, 1, 3, 4];
        let bases = [0, 1].map(|k| system.base(self.0 as usize + k));
        let of = |k: usize| (bases[k / 4].unwrap_or(0) + POSITIONS[k % 4], k, 1.0);
        let variables: [Variable; QUAD] = std::array::from_fn(of);
        match bases {
            [Some(_), Some(_)] => system.scatter(&variables, local),
            [None, _] => system.scatter(&variables[4..], local),
            [_, None] => system.scatter(&variables[..4], local),
        }
    }

    #[inline]
    fn stage(self) -> usize {
        self.0 as usize
    }

    #[inline]
    fn change(self, direction: &Direction, _: &[Step]) -> [f64; QUAD] {
        let (a, b) = (
            direction.stage(self.stage()),
            direction.stage(self.stage() + 1),
        );
        [a[0], a[1], a[3], a[4], b[0], b[1], b[3], b[4]]
    }

    fn location(self, x: &Iterate) -> Point {
        x.middle(self.stage())
    }
}
