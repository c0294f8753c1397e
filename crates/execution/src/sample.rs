use pairtrawl_control::{Pose, ReferenceSample, Velocity};
use pairtrawl_reference::Sample;

/// A sample of the reference in the controllers' words.
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
