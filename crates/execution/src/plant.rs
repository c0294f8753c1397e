//! One robot reduced to its equation of motion: the consistent dynamics with a dry drag at the hitch.

use crate::control_loop::Truth;
use pairtrawl_control::{BodyForce, PlantModel, Pose, Velocity, WheelTorque, pose_rate};
use pairtrawl_model::{PhysicsParameters, Robot};

/// What stays constant.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlantParameters {
    /// Mass, inertia about the center of mass, center of mass.
    pub model: PlantModel<f64>,
    /// R, m.
    pub half_track: f64,
    /// r, m.
    pub wheel_radius: f64,
    /// The drag acts this far behind the axle, m.
    pub hitch: f64,
    /// Greatest force of a wheel on the floor, N.
    pub traction: f64,
}

impl PlantParameters {
    /// The scene's robot with factors on its mass and its inertia. The tires carry the robot's weight and hold by the
    /// scene's wheel friction.
    pub fn new(
        robot: &Robot,
        physics: &PhysicsParameters,
        mass_factor: f64,
        inertia_factor: f64,
    ) -> Self {
        let mass = physics.robot_mass * mass_factor;
        Self {
            model: PlantModel {
                mass,
                inertia: physics.robot_inertia * inertia_factor,
                center_of_mass: physics.center_of_mass,
            },
            half_track: robot.half_track,
            wheel_radius: physics.wheel_radius,
            hitch: robot.hitch,
            traction: 0.5 * physics.wheel_friction * mass * physics.gravity,
        }
    }
}

/// Drag at the hitch at an instant.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Drag {
    /// Its magnitude while the hitch moves, N.
    pub force: f64,
    /// Its direction from straight back, counter-clockwise, rad.
    pub direction: f64,
}

/// Below this speed of the hitch dry friction turns smoothly through zero, m/s.
const STICTION_SPEED: f64 = 0.005;

/// A robot that rolls without slip.
#[derive(Clone, Copy, Debug)]
pub struct ReducedPlant {
    parameters: PlantParameters,
    state: [f64; 5],
}

impl ReducedPlant {
    /// At rest at a pose.
    pub fn new(parameters: PlantParameters, pose: Pose<f64>) -> Self {
        Self {
            parameters,
            state: [pose.x, pose.y, pose.heading, 0.0, 0.0],
        }
    }

    /// Pose and velocity.
    pub fn truth(&self) -> Truth {
        let [x, y, heading, linear, angular] = self.state;
        Truth {
            pose: Pose { x, y, heading },
            velocity: Velocity { linear, angular },
            tension: 0.0,
        }
    }

    /// Moves on by `dt` s (Runge and Kutta, fourth order) under constant torques and drag.
    pub fn step(&mut self, torque: WheelTorque<f64>, drag: Drag, dt: f64) {
        let s = self.state;
        let add = |k: &[f64; 5], f: f64| -> [f64; 5] { std::array::from_fn(|i| s[i] + f * k[i]) };
        let k1 = self.rate(&s, torque, drag);
        let k2 = self.rate(&add(&k1, 0.5 * dt), torque, drag);
        let k3 = self.rate(&add(&k2, 0.5 * dt), torque, drag);
        let k4 = self.rate(&add(&k3, dt), torque, drag);
        self.state =
            std::array::from_fn(|i| s[i] + dt / 6.0 * (k1[i] + 2.0 * (k2[i] + k3[i]) + k4[i]));
    }

    fn rate(&self, s: &[f64; 5], torque: WheelTorque<f64>, drag: Drag) -> [f64; 5] {
        let p = &self.parameters;
        let velocity = Velocity {
            linear: s[3],
            angular: s[4],
        };
        let wheel = |torque: f64| (torque / p.wheel_radius).clamp(-p.traction, p.traction);
        let (right, left) = (wheel(torque.right), wheel(torque.left));
        let hitch_speed = libm::hypot(s[3], p.hitch * s[4]);
        let force = drag.force * hitch_speed / libm::hypot(hitch_speed, STICTION_SPEED);
        let (sin, cos) = libm::sincos(drag.direction);
        let body = BodyForce {
            force: right + left - force * cos,
            torque: (right - left) * p.half_track + p.hitch * force * sin,
        };
        let a = p.model.acceleration(velocity, body);
        let [x, y, heading] = pose_rate(s[2], velocity, 0.0);
        [x, y, heading, a.linear, a.angular]
    }
}
