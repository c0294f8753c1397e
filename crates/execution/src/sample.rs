//! The reference in the words of the controllers and of the model.

use pairtrawl_control::{Pose as ControlPose, ReferenceSample, Velocity};
use pairtrawl_geometry::Pose;
use pairtrawl_model::{PairPose, PairTrajectory};
use pairtrawl_reference::{Reference, Sample};

/// A pose for the controllers.
pub(crate) fn control_pose(pose: Pose) -> ControlPose<f64> {
    ControlPose {
        x: pose.x,
        y: pose.y,
        heading: pose.heading,
    }
}

/// A sample of the reference for the controllers.
pub(crate) fn control_sample(sample: &Sample) -> ReferenceSample<f64> {
    ReferenceSample {
        pose: control_pose(sample.pose),
        velocity: Velocity {
            linear: sample.v,
            angular: sample.omega,
        },
        acceleration: Velocity {
            linear: sample.v_dot,
            angular: sample.omega_dot,
        },
    }
}

/// Where both robots should be.
pub(crate) fn pair_pose([left, right]: &[Sample; 2]) -> PairPose {
    PairPose {
        left: left.pose,
        right: right.pose,
    }
}

/// The reference as poses at even intervals of time of at most `interval` (s), for programs that know nothing but poses linear
/// in time.
pub fn evenly_sampled(reference: &Reference, interval: f64) -> PairTrajectory {
    let steps = (reference.duration() / interval).ceil().max(1.0);
    let step_time = reference.duration() / steps;
    let pairs = (0..=steps as usize).map(|k| pair_pose(&reference.at(k as f64 * step_time)));
    let (left, right) = pairs.map(|pair| (pair.left, pair.right)).unzip();
    PairTrajectory {
        left,
        right,
        step_time,
    }
}
