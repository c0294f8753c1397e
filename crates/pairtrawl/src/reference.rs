//! The reference of a plan, see [`pairtrawl_reference`], and what the controllers make of it.

pub use pairtrawl_reference::{Reference, ReferenceError, ReferenceLimits, Sample};

use pairtrawl_control::{Pose, ReferenceSample, Velocity};

/// A sample in the controllers' words.
pub(crate) fn control_sample(sample: &Sample) -> ReferenceSample<f64> {
    let pose = sample.pose;
    ReferenceSample {
        pose: Pose {
            x: pose.x,
            y: pose.y,
            heading: pose.heading,
        },
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
