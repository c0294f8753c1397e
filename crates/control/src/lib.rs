//! Controllers for one robot of the pair: from a reference and measurements to two wheel torques.
//!
//! No operating system, no allocation, no panic path, `f32` or `f64`. Equation numbers are those of the paper's source:
//! 12-21 dynamics, 22 model-based law, 23-24 tracking law, 25-30 adaptive law. `docs/control.md` derives every law.
//!
//! Two rates: [`RobotController::track`] takes a pose and a reference sample (100 Hz) and turns them into a desired
//! velocity; [`RobotController::torque`] takes the measured velocity (500 Hz) and returns wheel torques. There is no clock
//! here: the caller passes the time that has gone by.
//!
//! Frames: poses in the map frame of REP-103; errors, velocities and forces in the robot's frame (x forward, y left).
//! Torques of wheels are named, not ordered: `right` and `left`.
#![no_std]

mod controller;
mod dynamics;
mod estimator;
mod integral;
mod kinematics;
mod limits;
mod mode;
mod model_based;
mod mrac;
mod parameter;
mod real;
mod state;
mod supervisor;
mod tracking;

pub use controller::{ControllerParameters, LawParameters, RobotController};
pub use dynamics::{CoriolisForm, PlantModel, ReducedModel, RobotModel, reduce};
pub use estimator::PoseEstimator;
pub use integral::{IntegralGains, IntegralLaw};
pub use kinematics::{constraint_row, null_basis, null_basis_rate, pose_rate};
pub use limits::{Limits, PoseGuard, PoseRefusal, TorqueLimiter};
pub use mode::{Mode, StopCause};
pub use model_based::model_based_force;
pub use mrac::{AdaptedParameters, InertiaSplit, MracGains, MracLaw};
pub use parameter::ParameterError;
pub use real::Real;
pub use state::{BodyForce, Pose, ReferenceSample, Step, Velocity, WheelTorque};
pub use supervisor::{
    PairRobot, PairState, PairStopCause, PairSupervisor, RobotReport, SupervisorLimits,
};
pub use tracking::{Desired, TrackingError, TrackingForm, TrackingGains, desired_velocity};
