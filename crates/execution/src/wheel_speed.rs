//! What wheel encoders see: the speed of the rims, which is that of the floor only while the tires hold.
//!
//! The physics bounds the force of a wheel by its traction and knows no rims. Here each rim has a small mass of its own: what
//! torque is beyond the traction spins it up, and it grips again once its speed has come back to the floor's.

use pairtrawl_control::Velocity;
use pairtrawl_model::Scene;

/// Inertia of a rim and its motor as a mass at the floor, as a share of the robot's mass.
const RIM: f64 = 0.03;

/// The rims of one robot.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Rims {
    half_track: f64,
    wheel_radius: f64,
    /// Greatest force of one tire, N.
    traction: f64,
    /// kg.
    mass: f64,
    /// Speed of the (left, right) rim while it slips, m/s.
    slipping: [Option<f64>; 2],
}

impl Rims {
    pub fn new(scene: &Scene) -> Self {
        let physics = &scene.physics;
        let weight = physics.robot_mass * physics.gravity;
        Self {
            half_track: scene.robot.half_track,
            wheel_radius: physics.wheel_radius,
            traction: 0.5 * physics.wheel_friction * weight,
            mass: RIM * physics.robot_mass,
            slipping: [None; 2],
        }
    }

    /// One tick under the torques of the (left, right) wheel (N m) on a robot that moves over the floor with `truth`; the
    /// velocity that the encoders show.
    pub fn tick(&mut self, torques: [f64; 2], truth: Velocity<f64>, dt: f64) -> Velocity<f64> {
        let turning = self.half_track * truth.angular;
        let floor = [truth.linear - turning, truth.linear + turning];
        for i in [0, 1] {
            self.slipping[i] = self.slips(self.slipping[i], torques[i], floor[i], dt);
        }
        if self.slipping == [None; 2] {
            return truth;
        }
        let [left, right] = [0, 1].map(|i| self.slipping[i].unwrap_or(floor[i]));
        Velocity {
            linear: 0.5 * (left + right),
            angular: (right - left) / (2.0 * self.half_track),
        }
    }

    /// The speed of a rim after a tick; `None`: it grips.
    fn slips(&self, before: Option<f64>, torque: f64, floor: f64, dt: f64) -> Option<f64> {
        let force = torque / self.wheel_radius;
        let beyond = force.abs() > self.traction;
        let slip = before.map_or(0.0, |rim| rim - floor);
        // The floor holds against the slip, or against the force where there is none yet.
        let against = if slip == 0.0 { force } else { slip };
        if before.is_none() && !beyond {
            return None;
        }
        let held = self.traction.copysign(against);
        let rim = before.unwrap_or(floor) + dt * (force - held) / self.mass;
        let grips = !beyond && (rim - floor) * slip <= 0.0;
        (!grips).then_some(rim)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rims() -> Rims {
        Rims {
            half_track: 0.144,
            wheel_radius: 0.033,
            traction: 5.6,
            mass: 0.04,
            slipping: [None; 2],
        }
    }

    #[test]
    fn tires_that_hold_show_the_floor() {
        let truth = Velocity {
            linear: 0.2,
            angular: 0.3,
        };
        assert_eq!(rims().tick([0.18, -0.18], truth, 0.002), truth);
    }

    #[test]
    fn a_wheel_that_spins_shows_more_and_grips_again() {
        let (mut rims, stands) = (rims(), Velocity::default());
        let mut seen = stands;
        for _ in 0..50 {
            seen = rims.tick([0.25, 0.25], stands, 0.002);
        }
        // 0.25 N m are 7.58 N; 1.98 N beyond the traction on 0.04 kg for 0.1 s.
        assert!((seen.linear - 4.94).abs() < 0.01, "{seen:?}");
        assert!(seen.angular.abs() < 1e-12);
        for _ in 0..50 {
            seen = rims.tick([0.0, 0.0], stands, 0.002);
        }
        assert_eq!(seen, stands);
    }
}
