//! What the controllers get to see: late, noisy poses and late, slightly wrong velocities.

use pairtrawl_control::{Pose, Velocity};
use rand::{RngExt, SeedableRng};
use rand_chacha::ChaCha8Rng;
use std::collections::VecDeque;

/// Time between two ticks of the torque loop, s: 500 Hz.
pub const TORQUE_PERIOD: f64 = 0.002;
/// Ticks of the torque loop between two of the tracker: 100 Hz.
pub const TRACKER_TICKS: u64 = 5;

/// How well a robot senses.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sensing {
    /// Standard deviation of each coordinate of a pose, m.
    pub position_noise: f64,
    /// Standard deviation of its heading, rad.
    pub heading_noise: f64,
    /// Time over which the noise of poses forgets itself, s; a scanning lidar's is about a scan.
    pub noise_time: f64,
    /// Age of a pose when it reaches the controller, s. The age is known: poses carry time stamps.
    pub pose_delay: f64,
    /// Age of a measured velocity when it reaches the controller, s. Together with the actuator's.
    pub velocity_delay: f64,
    /// Measured over true velocity.
    pub odometry_scale: f64,
    /// Standard deviations of the measured velocity, m/s and rad/s, white.
    pub velocity_noise: [f64; 2],
}

impl Default for Sensing {
    /// A lidar with 1 cm and 1 degree, poses 30 ms late, wheel encoders one tick late.
    fn default() -> Self {
        Self {
            position_noise: 0.01,
            heading_noise: 1f64.to_radians(),
            noise_time: 0.1,
            pose_delay: 0.03,
            velocity_delay: TORQUE_PERIOD,
            odometry_scale: 1.0,
            velocity_noise: [0.002, 0.005],
        }
    }
}

impl Sensing {
    /// Poses and velocities as they are.
    pub fn perfect() -> Self {
        Self {
            position_noise: 0.0,
            heading_noise: 0.0,
            pose_delay: 0.0,
            velocity_delay: 0.0,
            velocity_noise: [0.0; 2],
            ..Self::default()
        }
    }
}

/// A source of normally distributed numbers with the same bits on every platform.
#[derive(Clone, Debug)]
pub struct Normal(ChaCha8Rng);

impl Normal {
    /// From a seed.
    pub fn new(seed: u64) -> Self {
        Self(ChaCha8Rng::seed_from_u64(seed))
    }

    /// A number of mean 0 and variance 1 (Box and Muller).
    pub fn draw(&mut self) -> f64 {
        let radius = (-2.0 * libm::log(1.0 - self.0.random::<f64>())).sqrt();
        radius * libm::cos(std::f64::consts::TAU * self.0.random::<f64>())
    }

    /// A number between two bounds, each equally likely.
    pub fn between(&mut self, [low, high]: [f64; 2]) -> f64 {
        low + (high - low) * self.0.random::<f64>()
    }
}

/// The sensors of one robot.
#[derive(Clone, Debug)]
pub struct Sensors {
    sensing: Sensing,
    normal: Normal,
    noise: [f64; 3],
    poses: VecDeque<Pose<f64>>,
    velocities: VecDeque<Velocity<f64>>,
}

impl Sensors {
    /// Sensors that start with noise drawn from its stationary distribution.
    pub fn new(sensing: Sensing, seed: u64) -> Self {
        let mut normal = Normal::new(seed);
        let noise = std::array::from_fn(|_| normal.draw());
        Self {
            sensing,
            normal,
            noise,
            poses: VecDeque::new(),
            velocities: VecDeque::new(),
        }
    }

    /// Takes the truth of a torque tick and returns the velocity that the controller sees.
    pub fn velocity(&mut self, truth: Velocity<f64>) -> Velocity<f64> {
        let s = &self.sensing;
        let late = delayed(
            &mut self.velocities,
            truth,
            ticks(s.velocity_delay, TORQUE_PERIOD),
        );
        Velocity {
            linear: s.odometry_scale * late.linear + s.velocity_noise[0] * self.normal.draw(),
            angular: s.odometry_scale * late.angular + s.velocity_noise[1] * self.normal.draw(),
        }
    }

    /// Takes the truth of a tracker tick and returns the pose that the controller sees and its age, s.
    ///
    /// At the start, before the first late pose arrives, the pose of the start stands in: it is known and the robot stands.
    pub fn pose(&mut self, truth: Pose<f64>) -> (Pose<f64>, f64) {
        let period = TRACKER_TICKS as f64 * TORQUE_PERIOD;
        let s = &self.sensing;
        let keep = libm::exp(-period / s.noise_time.max(1e-9));
        let fresh = (1.0 - keep * keep).sqrt();
        for n in &mut self.noise {
            *n = keep * *n + fresh * self.normal.draw();
        }
        let [x, y, heading] = self.noise;
        let seen = Pose {
            x: truth.x + s.position_noise * x,
            y: truth.y + s.position_noise * y,
            heading: truth.heading + s.heading_noise * heading,
        };
        let wanted = ticks(s.pose_delay, period);
        let age = self.poses.len().min(wanted) as f64 * period;
        (delayed(&mut self.poses, seen, wanted), age)
    }
}

fn ticks(delay: f64, period: f64) -> usize {
    (delay / period).round().max(0.0) as usize
}

/// Puts a value into a line of `length` and returns the oldest.
fn delayed<T: Copy>(line: &mut VecDeque<T>, value: T, length: usize) -> T {
    line.push_back(value);
    if line.len() > length + 1 {
        line.pop_front();
    }
    line.front().copied().unwrap_or(value)
}
