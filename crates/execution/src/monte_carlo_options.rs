use crate::NominalInertia;
use pairtrawl_model::ControllerKind;

/// What the laws drive.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Plants {
    /// Each robot alone, under a drag that grows in eight steps and swings.
    #[default]
    Reduced,
    /// Both robots, the net and the objects in physics. What is drawn as drag is what sliding all objects takes.
    Full {
        /// d_max, m.
        net_length: f64,
        /// Steps are those of the torque loop (2 ms) at most.
        physics: pairtrawl_simulation::Options,
    },
}

/// What is drawn, each evenly between two bounds.
#[derive(Clone, Debug, PartialEq)]
pub struct MonteCarloOptions {
    /// What the laws drive.
    pub plants: Plants,
    /// Runs for each law; all laws see the same runs.
    pub runs: usize,
    /// Seed of everything drawn.
    pub seed: u64,
    /// Robot mass over the nominal one; in full physics both robots have the same.
    pub mass_factor: [f64; 2],
    /// Robot inertia over that of its model file.
    pub inertia_factor: [f64; 2],
    /// Drag of a robot at the end of the run, N; on reduced plants it grows in eight steps and turns by up to 60 degrees.
    pub drag: [f64; 2],
    /// Standard deviation of positions, m.
    pub position_noise: f64,
    /// Standard deviation of headings, rad.
    pub heading_noise: f64,
    /// Delay, s.
    pub delay: [f64; 2],
    /// True: the delay concerns measured velocities (or, which is the same to the loop, torques) as well as poses.
    pub delayed_velocity: bool,
    /// A run succeeds when neither robot is ever farther than this from its reference after the first second, m.
    pub tolerance: f64,
    /// J of the controllers' model.
    pub nominal_inertia: NominalInertia,
    /// The laws.
    pub controllers: Vec<ControllerKind>,
}

impl Default for MonteCarloOptions {
    fn default() -> Self {
        Self {
            plants: Plants::Reduced,
            runs: 1000,
            seed: 1,
            mass_factor: [0.5, 3.0],
            inertia_factor: [0.5, 1.5],
            drag: [0.0, 4.0],
            position_noise: 0.01,
            heading_noise: 1f64.to_radians(),
            delay: [0.0, 0.06],
            delayed_velocity: false,
            tolerance: 0.10,
            nominal_inertia: NominalInertia::default(),
            controllers: ControllerKind::ALL.to_vec(),
        }
    }
}
