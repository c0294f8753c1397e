//! The reference of a plan, see [`pairtrawl_reference`], with what the controllers and the certificate make of it.

pub use pairtrawl_reference::{Reference, ReferenceError, ReferenceLimits, Sample};

use pairtrawl_control::{Pose, ReferenceSample, Velocity};
use pairtrawl_model::{Certificate, PairTrajectory, Scene};

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

/// The claims of the certificate on the reference, sampled four times as finely as the plan.
pub fn certify_reference(reference: &Reference, scene: &Scene, net_length: f64) -> Certificate {
    let count = 4 * (reference.waypoints() - 1);
    let mut fine = PairTrajectory {
        step_time: reference.duration() / count as f64,
        ..PairTrajectory::default()
    };
    for k in 0..=count {
        let [left, right] = reference.at(k as f64 * fine.step_time);
        fine.left.push(left.pose);
        fine.right.push(right.pose);
    }
    pairtrawl_certificate::certify(scene, net_length, &fine)
}
