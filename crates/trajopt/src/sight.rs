//! What rules see of the course when they look up their rows.

use crate::iterate::Iterate;
use crate::pieces::PieceIndex;
use crate::problem::Problem;
use crate::tier::Tier;
use pairtrawl_geometry::Point;
use pairtrawl_model::Side;

/// Objects and obstacles are in play up to this far beyond the distance that is kept from them, in units of the length
/// scale.
pub(crate) const LOOK_AHEAD: f64 = 0.2;
/// Rows of the claim itself are in play up to this far.
const CLAIM_AHEAD: f64 = 0.15;
/// A robot that is astray of an object may drive over it this far before and behind the place where the line passes over it.
const ASTRAY: f64 = 2.0;
/// At most this many obstacle pieces a robot or line at a waypoint: the nearest ones.
const MOST_PIECES: usize = 6;

/// The point at which rows are looked up, and lists that are filled again at every anchor.
pub(crate) struct Sight<'a> {
    pub problem: &'a Problem,
    pub x: &'a Iterate,
    /// Waypoints at which the line between the robots passes over an object, ascending, and the object.
    crossings: Vec<(usize, u32)>,
    /// Robots that have an object on their outer side where the line passes over its abscissa: robot, object, waypoint.
    astray: Vec<(Side, u32, usize)>,
    candidates: Vec<u32>,
    /// Values of margins and what they are about.
    near: Vec<(f64, u32)>,
}

impl<'a> Sight<'a> {
    /// `crossings` has the waypoint at which the line passes over each object.
    pub fn new(problem: &'a Problem, x: &'a Iterate, crossings: &[usize]) -> Self {
        let wanted = |(_, object): &(usize, u32)| problem.wanted[*object as usize];
        let mut crossings: Vec<_> = crossings.iter().copied().zip(0..).filter(wanted).collect();
        crossings.sort_unstable();
        let astray = crossings.iter().flat_map(|&(stage, object)| {
            let (center, _) = problem.objects[object as usize];
            let (l, r) = (
                x.position(stage, Side::Left),
                x.position(stage, Side::Right),
            );
            let is_astray = move |robot: &Side| {
                let out = (l - r) * robot.sign();
                out.dot(x.position(stage, *robot) - center) < 0.0
            };
            let robots = Side::BOTH.into_iter().filter(is_astray);
            robots.map(move |robot| (robot, object, stage))
        });
        Self {
            problem,
            x,
            astray: astray.collect(),
            crossings,
            candidates: Vec::new(),
            near: Vec::new(),
        }
    }

    /// True unless it is one of the fixed ends.
    pub fn is_inner(&self, stage: usize) -> bool {
        stage > 0 && stage + 1 < self.x.stages.len()
    }

    /// True when a robot must get past an object to have it on its inner side: what keeps it off the object would keep it
    /// astray.
    pub fn must_pass(&self, robot: Side, stage: usize, object: u32) -> bool {
        let window = (ASTRAY / self.problem.planner.max_step) as usize;
        (self.astray.iter())
            .any(|&(r, o, at)| r == robot && o == object && at.abs_diff(stage) <= window)
    }

    /// The objects to be gathered that the line passes over at a waypoint.
    pub fn crossed(&self, stage: usize) -> impl Iterator<Item = u32> + '_ {
        let from = self.crossings.partition_point(|c| c.0 < stage);
        let here = self.crossings[from..].iter();
        here.take_while(move |c| c.0 == stage).map(|c| c.1)
    }

    /// The obstacle pieces whose margin is at most `LOOK_AHEAD` away from the line between two points, the nearest few of
    /// them: calls `add` with each of their tiers that is in play, in ascending order. `reach` is how far from the box
    /// around the points they may be.
    pub fn pieces_near(
        &mut self,
        (a, b): (Point, Point),
        reach: f64,
        margin: f64,
        value: impl Fn(u32) -> f64,
        mut add: impl FnMut(u32, Tier),
    ) {
        let index: &PieceIndex = &self.problem.pieces;
        self.candidates.clear();
        // Near enough to each other that what is near the line is found from one of them.
        let stretches = (a.distance(b) / index.reach).ceil();
        for k in 0..=stretches as usize {
            let p = a.lerp(b, k as f64 / stretches.max(1.0));
            let may_be_near = |id: &&u32| index.get(**id).may_be_near(a, b, reach);
            let found = index.near(p).iter().filter(may_be_near);
            self.candidates.extend(found);
        }
        if stretches > 0.0 {
            self.candidates.sort_unstable();
            self.candidates.dedup();
        }
        self.near.clear();
        for &id in &self.candidates {
            let c = value(id);
            if c < LOOK_AHEAD {
                self.near.push((c, id));
            }
        }
        if self.near.len() > MOST_PIECES {
            self.near
                .sort_unstable_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
            self.near.truncate(MOST_PIECES);
        }
        self.near.sort_unstable_by_key(|n| n.1);
        for &(c, id) in &self.near {
            for tier in tiers(self.problem, c, margin) {
                add(id, tier);
            }
        }
    }
}

/// The tiers in play of a thing whose margin row has value `c`.
pub(crate) fn tiers(problem: &Problem, c: f64, margin: f64) -> impl Iterator<Item = Tier> {
    let of_claim = c + margin - Tier::Claim.reserve(problem, margin);
    let in_play = move |tier: &Tier| *tier == Tier::Margin || of_claim < CLAIM_AHEAD;
    Tier::BOTH.into_iter().filter(in_play)
}
