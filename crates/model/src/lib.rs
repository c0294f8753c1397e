//! The vocabulary of Pairtrawl: types, and [`numbers`] as people read them. How they are read from and written to files is
//! elsewhere.
//!
//! SI units and radians; map frame of REP-103. `left` and `right` are as seen by someone who walks behind the pair.

mod bench;
mod body;
mod certificate;
mod claim_id;
mod cost;
mod execution;
mod expansion_per;
mod failed;
mod leave;
mod left_out;
mod mark;
pub mod numbers;
mod parameters;
mod physics;
mod plan;
mod preset;
mod rehearsal;
mod scales;
mod scene;
mod side;
mod size;
mod summary;
mod trajectory;
mod units;
mod warning;

pub use bench::{Bench, BenchFailures, BenchGroup, BenchScene};
pub use body::{Body, BodyCircle};
pub use certificate::{Certificate, Claim};
pub use claim_id::ClaimId;
pub use cost::Cost;
pub use execution::{
    ControlSample, ControllerKind, DragStatistics, Execution, ExecutionEvent, ExecutionEventKind,
    TrackingStatistics, Trial, TrialConditions,
};
pub use expansion_per::ExpansionPer;
pub use failed::FailedSummary;
pub use leave::Leave;
pub use left_out::{LeftOut, LeftWhy};
pub use mark::Mark;
pub use parameters::PlannerParameters;
pub use physics::PhysicsParameters;
pub use plan::{Circle, Overrides, Plan, Rehearsal, SceneReference, SolverReport, SolverStatus};
pub use preset::Preset;
pub use rehearsal::{RehearsalEvent, RehearsalEventKind, RehearsalFrame, RehearsalRecord};
pub use scales::Scales;
pub use scene::{Area, Footprint, NetSpec, Object, Obstacle, OccupancyMap, PairPose, Robot, Scene};
pub use side::Side;
pub use size::RobotSize;
pub use summary::{
    ClaimSummary, Event, ExecutionSummary, Frames, LengthCurve, LengthPoint, LengthRefusal, Limit,
    Line, Panel, Ribbon, Role, Sampling, SceneOutline, StageTime, Summary, TrialSummary,
};
pub use trajectory::{PairTrajectory, default_step_time};
pub use units::Units;
pub use warning::Warning;
