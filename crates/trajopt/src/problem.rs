use crate::own::{OwnTerm, OwnTerms, Role};
use crate::pieces::PieceIndex;
use crate::term::{PAIR, POINT, Term};
use pairtrawl_geometry::{Convex, Point};
use pairtrawl_model::{Area, Body, BodyCircle, PairPose, PlannerParameters, Robot, Scene, Side};
use std::ops::Range;
use std::sync::Arc;

/// What is optimized: costs, constraints, fixed ends. Immutable while solving.
#[derive(Clone, Debug)]
pub struct Problem {
    /// First poses.
    pub start: PairPose,
    /// Last poses.
    pub end: PairPose,
    /// The robot.
    pub robot: Robot,
    /// Weights and limits.
    pub planner: PlannerParameters,
    /// Bounds of the axle centers.
    pub area: Area,
    /// d_max, m; `None`: a variable.
    pub net_length: Option<f64>,
    /// The circles that contain a robot.
    pub(crate) body: Body,
    /// Radius of the body's circle around the axle center, if it has one, m.
    pub(crate) disc: Option<f64>,
    /// The other circles of the body: their centers move when the robot turns.
    pub(crate) circles: Vec<BodyCircle>,
    /// How far the body extends to the side, m.
    pub(crate) half_width: f64,
    /// Object centers with the radii of their footprint circles, m.
    pub(crate) objects: Vec<(Point, f64)>,
    /// Which of them the line between the robots is to pass over: all but those that are left where they are.
    pub(crate) wanted: Vec<bool>,
    /// The same as discs, enlarged by the largest circle of the body, to find those near a point.
    pub(crate) object_index: PieceIndex,
    /// Convex cover of the obstacles.
    pub(crate) pieces: PieceIndex,
    /// How much is kept in reserve beyond each claim.
    pub reserve: Reserve,
    /// What is asked of the separation between its bounds.
    pub separation: SeparationRule,
    /// The robot that stays where it is, as in Algorithm 1.
    pub frozen: Option<Side>,
    /// Costs and constraints of the user's.
    pub(crate) own: OwnTerms,
}

/// What is asked of the separation `d`. All but the first are the paper's comparisons: studies, whose results break claims.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum SeparationRule {
    /// The U-shaped cost J_e.
    #[default]
    UShape,
    /// No expansion cost and no upper bound: whatever net length it takes (the paper's baseline 1).
    Free,
    /// `d = d_rest` from one waypoint to another, ramps at both ends (the paper's baseline 2).
    Rigid {
        /// First waypoint at rest.
        from: usize,
        /// Last waypoint at rest.
        to: usize,
    },
}

/// Margins beyond the claims: `clearance` is wished for and shrinks where there is no room, the rest makes up for what
/// happens between waypoints and is raised by the planner where a certificate fails.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reserve {
    /// Beyond the robot radius from obstacles and objects, m.
    pub clearance: f64,
    /// Between the net's straight line and obstacles, m.
    pub net_clearance: f64,
    /// From obstacles and objects even where what is wished for gives way, m: what a chord between waypoints comes nearer to
    /// a corner that is a robot radius away than the waypoints do, with a little reserve.
    pub sag: f64,
    /// Least separation, m.
    pub separation: f64,
    /// Greatest separation, m.
    pub greatest_separation: f64,
    /// Net reach, m.
    pub net_reach: f64,
    /// Subtracted from max_skew, rad.
    pub skew: f64,
}

/// Obstacles are looked up at least this far from a point, in units of the length scale.
const LEAST_REACH: f64 = 1.0;
/// And this far beyond what robots keep from them and drive in a step.
const AHEAD: f64 = 0.2;

/// What a chord between two waypoints comes nearer to a corner than the waypoints do, m: that of a circle whose center is
/// its radius away from the corner at both, and what turning adds to the way of a center that is off the axle.
fn sag(body: &Body, planner: &PlannerParameters) -> f64 {
    let of_circle = |c: &BodyCircle| {
        let way = planner.max_step + c.offset() * planner.max_turn;
        way * way / (8.0 * c.radius) + c.offset() * planner.max_turn * planner.max_turn / 8.0
    };
    body.circles().iter().map(of_circle).fold(0.0, f64::max)
}

impl Problem {
    /// The problem of a scene with a net of `net_length` (`None`: to be chosen) among convex obstacles.
    pub fn new(scene: &Scene, net_length: Option<f64>, obstacles: &[Convex]) -> Self {
        let robot = scene.robot;
        let body = robot.circles();
        let (centered, circles): (Vec<BodyCircle>, Vec<BodyCircle>) = body
            .circles()
            .iter()
            .copied()
            .partition(BodyCircle::is_centered);
        let disc = centered.into_iter().map(|c| c.radius).reduce(f64::max);
        let largest = body.largest_radius();
        let objects: Vec<(Point, f64)> = scene
            .objects
            .iter()
            .map(|o| (o.position, o.footprint_radius()))
            .collect();
        let kept_off = |&(center, footprint): &(Point, f64)| Convex::Circle {
            center,
            radius: footprint + largest,
        };
        let discs: Vec<Convex> = objects.iter().map(kept_off).collect();
        // Twice what is kept, since more may be asked for after a failure, and what lies ahead.
        let kept = largest + scene.planner.clearance;
        let reach = (2.0 * kept + scene.planner.max_step + AHEAD).max(LEAST_REACH);
        Self {
            start: scene.start,
            end: scene.end,
            robot,
            planner: scene.planner,
            area: scene.area,
            net_length,
            object_index: PieceIndex::new(&discs, &scene.area, reach),
            body,
            disc,
            circles,
            half_width: body.half_width(),
            objects,
            wanted: scene.objects.iter().map(|object| !object.leave).collect(),
            pieces: PieceIndex::new(obstacles, &scene.area, reach),
            reserve: Reserve {
                clearance: scene.planner.clearance,
                net_clearance: scene.planner.clearance,
                sag: 1.4 * sag(&body, &scene.planner),
                separation: 1e-3,
                greatest_separation: 1e-6,
                net_reach: 5e-4,
                skew: 1.6e-2,
            },
            separation: SeparationRule::UShape,
            frozen: None,
            own: OwnTerms::default(),
        }
    }

    /// The paper's baseline 2 for `waypoints` waypoints: the separation of rest but for the shortest ramps at both ends that
    /// steps and turns allow. The net length must be given.
    pub fn with_rigid_separation(mut self, waypoints: usize, net_length: f64) -> Self {
        let rest = self.planner.rest_ratio * net_length;
        let ramp = |pair: &PairPose| 1 + self.ramp_steps((pair.separation() - rest).abs());
        let (from, ramp_down) = (ramp(&self.start), ramp(&self.end));
        let to = waypoints.saturating_sub(1 + ramp_down).max(from);
        self.separation = SeparationRule::Rigid { from, to };
        self.net_length = Some(net_length);
        self
    }

    /// Fewest steps in which a pair that drives abreast, and does so again at the end, changes its separation by `change`:
    /// both robots turn away from each other as fast as they may, drive at full step, and turn back.
    fn ramp_steps(&self, change: f64) -> usize {
        let p = &self.planner;
        let reached = |steps: usize| -> f64 {
            let skew = |k: usize| (k.min(steps - k) as f64 * p.max_turn).min(p.max_skew);
            (0..steps)
                .map(|k| 2.0 * p.max_step * libm::sin(0.5 * (skew(k) + skew(k + 1))))
                .sum()
        };
        (0..).find(|&steps| reached(steps) >= change).unwrap_or(0)
    }

    /// Adds a cost or constraint of the user's on the pair at a range of waypoints. Its local coordinates are
    /// `rx, ry, phi_l, phi_r, d_max` ([`PAIR`]), in units of the length scale. A constraint is not asked of the ends, which are fixed; one that is not
    /// met is named in `Solution::unmet`.
    #[must_use]
    pub fn with_pair_term(
        mut self,
        name: &str,
        role: Role,
        waypoints: Range<usize>,
        term: impl Term<PAIR> + Send + Sync + 'static,
    ) -> Self {
        self.own.pair.push(OwnTerm {
            name: name.to_owned(),
            role,
            waypoints,
            term: Arc::new(term),
        });
        self
    }

    /// As [`Self::with_pair_term`], on a robot's axle center `x, y` ([`POINT`]).
    #[must_use]
    pub fn with_point_term(
        mut self,
        name: &str,
        role: Role,
        robot: Side,
        waypoints: Range<usize>,
        term: impl Term<POINT> + Send + Sync + 'static,
    ) -> Self {
        let own = OwnTerm {
            name: name.to_owned(),
            role,
            waypoints,
            term: Arc::new(term),
        };
        self.own.point[robot.index()].push(own);
        self
    }
}
