//! The finished summary of a plan and of what became of it: everything that a page, a picture or a table shows,
//! already computed. Reports render it and compute nothing, so all of them show the same numbers.

use crate::{
    Area, Circle, Claim, Cost, LeftOut, Mark, Object, Obstacle, PairPose, PairTrajectory,
    Rehearsal, Robot, SolverReport, TrackingStatistics, Warning,
};
use pairtrawl_geometry::{Point, Pose};
use std::fmt;

/// Everything that is shown about a plan.
#[derive(Clone, Debug, PartialEq)]
pub struct Summary {
    /// The scene's name.
    pub title: String,
    /// d_max, m.
    pub net_length: f64,
    /// True when the planner chose the net length.
    pub net_length_chosen: bool,
    /// What stands and lies where.
    pub outline: SceneOutline,
    /// Merged object circles.
    pub circles: Vec<Circle>,
    /// Visiting order: indices into `circles`.
    pub order: Vec<usize>,
    /// Objects that are left where they are, and why, ascending.
    pub left_out: Vec<LeftOut>,
    /// The pair's centerline.
    pub centerline: Vec<Pose>,
    /// The baseline pair; empty when there is none.
    pub baseline: PairTrajectory,
    /// What the robots drive.
    pub trajectory: PairTrajectory,
    /// When they pass each waypoint of `trajectory`, s.
    pub times: Vec<f64>,
    /// Driven length of the left robot, m.
    pub left_length: f64,
    /// Driven length of the right robot, m.
    pub right_length: f64,
    /// Time to drive, s.
    pub duration: f64,
    /// When the line between the robots first sweeps each object's center, s; one entry per object.
    pub swept_at: Vec<Option<f64>>,
    /// Curves over time, in the order in which they are shown.
    pub panels: Vec<Panel>,
    /// The paper's J.
    pub cost: Cost,
    /// The certificate, claim by claim.
    pub claims: Vec<ClaimSummary>,
    /// What the physics said.
    pub rehearsal: Rehearsal,
    /// What the optimizer said.
    pub solver: SolverReport,
    /// Time of each stage of planning, in order; empty when it was not measured.
    pub stages: Vec<StageTime>,
    /// Warnings for people.
    pub warnings: Vec<Warning>,
    /// Places on the map that are to be seen; none on the map of a plan.
    pub marks: Vec<Mark>,
    /// The rehearsal in motion, when there was one.
    pub frames: Option<Frames>,
    /// An execution of the plan, when there was one.
    pub execution: Option<ExecutionSummary>,
}

impl Summary {
    /// How many objects the plan gathers.
    pub fn gathers(&self) -> usize {
        self.outline.objects.len() - self.left_out.len()
    }
}

/// The scene as it is drawn.
#[derive(Clone, Debug, PartialEq)]
pub struct SceneOutline {
    /// Bounds of robot centers and objects.
    pub area: Area,
    /// Obstacles given as shapes.
    pub obstacles: Vec<Obstacle>,
    /// The boundary of a ROS map's free cells as closed rings (outer ones and holes, to be filled by the even-odd
    /// rule), m: within the area everything outside of it is obstacle. `None`: the scene has no map.
    pub free_rings: Option<Vec<Vec<Point>>>,
    /// What is to be gathered and what is left, where it lies at the start.
    pub objects: Vec<Object>,
    /// The robot.
    pub robot: Robot,
    /// Where the pair starts.
    pub start: PairPose,
    /// Where the pair ends.
    pub end: PairPose,
}

/// A claim of the certificate with what a reader needs to understand it.
#[derive(Clone, Debug, PartialEq)]
pub struct ClaimSummary {
    /// The claim.
    pub claim: Claim,
    /// What it says, in a short sentence.
    pub meaning: &'static str,
    /// The unit of its margin; empty when the margin has none.
    pub unit: &'static str,
    /// When it is tightest, s.
    pub time: Option<f64>,
}

/// Time spent in one stage.
#[derive(Clone, Debug, PartialEq)]
pub struct StageTime {
    /// The stage's name.
    pub name: String,
    /// Time spent, s.
    pub seconds: f64,
}

/// Curves of one quantity over time that share a vertical axis.
#[derive(Clone, Debug, PartialEq)]
pub struct Panel {
    /// A name for files, such as `step_length`.
    pub key: String,
    /// A name for people.
    pub title: String,
    /// Unit of all values; empty when they have none.
    pub unit: String,
    /// Instants, s, increasing.
    pub times: Vec<f64>,
    /// Where on the time axis the values belong.
    pub sampling: Sampling,
    /// The curves.
    pub lines: Vec<Line>,
    /// Horizontal lines for bounds and marks.
    pub limits: Vec<Limit>,
}

/// Where on the time axis values belong.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sampling {
    /// Value i belongs to instant i.
    Instant,
    /// Value i belongs to the step from instant i to instant i + 1: one value fewer than instants.
    Step,
}

/// One curve.
#[derive(Clone, Debug, PartialEq)]
pub struct Line {
    /// A name for people and, together with the panel's key, for columns of files.
    pub label: String,
    /// Whose it is, which decides its color.
    pub role: Role,
    /// Values in the panel's unit; NaN where there is none.
    pub values: Vec<f64>,
}

/// Whose a curve is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Role {
    /// The left robot's.
    Left,
    /// The right robot's.
    Right,
    /// The net's.
    Net,
    /// The pair's or anything else.
    Other,
}

/// A horizontal line in a panel.
#[derive(Clone, Debug, PartialEq)]
pub struct Limit {
    /// A name for people.
    pub label: String,
    /// Its height, in the panel's unit.
    pub value: f64,
}

/// Robots, net and objects in motion, as the physics had them.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Frames {
    /// Instants, s, increasing. All other lists have one entry per instant.
    pub times: Vec<f64>,
    /// Poses of the left robot.
    pub left: Vec<Pose>,
    /// Poses of the right robot.
    pub right: Vec<Pose>,
    /// The net from the left hitch to the right one, m; the same number of points at every instant.
    pub net: Vec<Vec<Point>>,
    /// Center and angle of every object.
    pub objects: Vec<Vec<Pose>>,
    /// Tension at the left hitch, N.
    pub left_tension: Vec<f64>,
    /// Tension at the right hitch, N.
    pub right_tension: Vec<f64>,
    /// Tension above which the net counts as snagged, N.
    pub tension_limit: f64,
    /// What happened, in order of time.
    pub events: Vec<Event>,
}

/// Something that happened at a time and a place.
#[derive(Clone, Debug, PartialEq)]
pub struct Event {
    /// When, s.
    pub time: f64,
    /// Where, m.
    pub place: Point,
    /// What, for people.
    pub text: String,
}

/// An execution of the plan by controllers in the simulated world.
#[derive(Clone, Debug, PartialEq)]
pub struct ExecutionSummary {
    /// Name of the controller.
    pub controller: String,
    /// What came of each trial that was finished.
    pub trials: Vec<TrialSummary>,
    /// How many trials were wanted.
    pub trials_wanted: usize,
    /// Index into `trials` of the one that `frames` and `panels` show.
    pub shown: usize,
    /// That trial in motion.
    pub frames: Option<Frames>,
    /// Tracking error, drag, torque, adapted parameters and whatever else that trial recorded, over time.
    pub panels: Vec<Panel>,
    /// The left robot's driven path over all trials.
    pub left_ribbon: Option<Ribbon>,
    /// The right robot's driven path over all trials.
    pub right_ribbon: Option<Ribbon>,
}

/// What came of a trial.
#[derive(Clone, Debug, PartialEq)]
pub struct TrialSummary {
    /// Its seed.
    pub seed: u64,
    /// Objects gathered.
    pub gathered: usize,
    /// True when the pair came to the end of its way with every object inside the net.
    pub complete: bool,
    /// Position error of the (left, right) robot.
    pub tracking: [TrackingStatistics; 2],
    /// J on the driven path.
    pub cost: Cost,
    /// The first thing that went wrong; `None`: nothing did.
    pub event: Option<Event>,
}

/// The mean of several paths and the band that contains them, over the same instants.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Ribbon {
    /// Mean path, m.
    pub mean: Vec<Point>,
    /// The band's border to the left of the direction of travel, m; as many points.
    pub left_border: Vec<Point>,
    /// The band's border to the right, m; as many points.
    pub right_border: Vec<Point>,
}

/// The curve J(d_max) with the route fixed.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct LengthCurve {
    /// The scene's name.
    pub title: String,
    /// By increasing net length.
    pub points: Vec<LengthPoint>,
    /// The best net length found, m, and its cost.
    pub minimum: Option<(f64, Cost)>,
    /// True when it was stopped before all lengths were solved: the others are missing.
    pub interrupted: bool,
}

/// One net length of the curve.
#[derive(Clone, Debug, PartialEq)]
pub struct LengthPoint {
    /// d_max, m.
    pub net_length: f64,
    /// J of the certified plan with this net, or why there is none.
    pub outcome: Result<Cost, LengthRefusal>,
}

/// Why there is no certified plan with a net length; the words are for people.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum LengthRefusal {
    /// There is a proof that no plan exists.
    Proven(String),
    /// None was found within the budget.
    NotFound(String),
}

impl fmt::Display for LengthRefusal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Proven(reason) => write!(f, "proven infeasible: {reason}"),
            Self::NotFound(reason) => f.write_str(reason),
        }
    }
}

impl LengthCurve {
    /// The range of net lengths (m) around the best one in which J is at most `share` above the least (0.01: 1 %), J taken
    /// to be linear between solved lengths. It ends at a length without a plan, and at the ends of the curve.
    pub fn flat_range(&self, share: f64) -> Option<(f64, f64)> {
        let (best, cost) = self.minimum?;
        let bound = cost.total() * (1.0 + share);
        let known = |point: &LengthPoint| {
            let cost = point.outcome.as_ref().ok();
            (point.net_length, cost.map(Cost::total))
        };
        let reach = |points: &mut dyn Iterator<Item = (f64, Option<f64>)>| {
            let (mut from, mut at) = (best, cost.total());
            for (length, total) in points {
                match total {
                    Some(total) if total <= bound => (from, at) = (length, total),
                    Some(total) => return from + (length - from) * (bound - at) / (total - at),
                    None => break,
                }
            }
            from
        };
        let shorter = self.points.iter().rev().map(known);
        let longer = self.points.iter().map(known);
        Some((
            reach(&mut shorter.filter(|(length, _)| *length < best)),
            reach(&mut longer.filter(|(length, _)| *length > best)),
        ))
    }
}
