use crate::sensing::{Sensing, TORQUE_PERIOD};
use crate::{ExecutionError, LawOptions};
use pairtrawl_control::{
    ControllerParameters, CoriolisForm, IntegralGains, LawParameters, Limits, MracGains,
    RobotModel, SupervisorLimits, TrackingGains, Velocity,
};
use pairtrawl_model::{ControllerKind, Scene};

/// J of the controllers' model.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum NominalInertia {
    /// The paper's table: 0.146 kg m^2, ten times the robot's.
    #[default]
    PaperTable,
    /// The scene's robot.
    Robot,
}

impl NominalInertia {
    /// The name in files and on the command line.
    pub const fn name(self) -> &'static str {
        match self {
            Self::PaperTable => "table",
            Self::Robot => "robot",
        }
    }
}

/// How to execute a plan. The default is what the program does without options.
#[derive(Clone, Debug, PartialEq)]
pub struct ExecutionOptions {
    /// Which law drives.
    pub controller: ControllerKind,
    /// How many trials.
    pub trials: usize,
    /// Seed of everything random; trial k has its own, mixed from this one.
    pub seed: u64,
    /// Robot mass over the scene's, drawn for each trial.
    pub robot_mass: [f64; 2],
    /// Robot inertia over the scene's, drawn for each trial.
    pub robot_inertia: [f64; 2],
    /// Masses of objects, kg, drawn for each; `None`: the scene's.
    pub object_mass: Option<[f64; 2]>,
    /// Mass of all objects together, kg: scales their masses; `None`: as they are.
    pub payload: Option<f64>,
    /// Friction of net and objects on the floor over the scene's, drawn for each trial.
    pub friction: [f64; 2],
    /// Age of poses, s, drawn for each trial.
    pub pose_delay: [f64; 2],
    /// Age of measured velocities, s, drawn for each trial.
    pub velocity_delay: [f64; 2],
    /// Measured over true speed, drawn for each robot and trial.
    pub odometry_scale: [f64; 2],
    /// The sensors otherwise.
    pub sensing: Sensing,
    /// What is changed about the laws' default gains.
    pub law: LawOptions,
    /// J of the controllers' model.
    pub nominal_inertia: NominalInertia,
    /// When the pair stops; the tension limit is the scene's.
    pub supervisor: SupervisorLimits<f64>,
    /// Physics: time step (a whole part of the torque loop's period of 2 ms; longer ones are shortened to it) and frames.
    pub physics: pairtrawl_simulation::Options,
    /// Time between two control samples that are kept, s.
    pub sample_interval: f64,
    /// True: a plan that cannot be proven is driven as well.
    pub unproven: bool,
}

impl Default for ExecutionOptions {
    fn default() -> Self {
        Self {
            controller: ControllerKind::Mrac,
            trials: 5,
            seed: 1,
            robot_mass: [1.0, 1.0],
            robot_inertia: [1.0, 1.0],
            object_mass: None,
            payload: None,
            friction: [1.0, 1.0],
            pose_delay: [0.0, 0.06],
            velocity_delay: [0.002, 0.002],
            odometry_scale: [0.99, 1.01],
            sensing: Sensing::default(),
            law: LawOptions::default(),
            nominal_inertia: NominalInertia::PaperTable,
            supervisor: SupervisorLimits::default(),
            physics: pairtrawl_simulation::Options::default(),
            sample_interval: 0.05,
            unproven: false,
        }
    }
}

impl ExecutionOptions {
    /// Checks every range.
    ///
    /// # Errors
    /// Names the first option that cannot be used.
    pub fn validate(&self) -> Result<(), ExecutionError> {
        let positive = "two numbers above 0, the lower first";
        let not_negative = "two numbers, none below 0, the lower first";
        range("robot_mass", self.robot_mass, f64::MIN_POSITIVE, positive)?;
        range(
            "robot_inertia",
            self.robot_inertia,
            f64::MIN_POSITIVE,
            positive,
        )?;
        if let Some(masses) = self.object_mass {
            range("object_mass", masses, f64::MIN_POSITIVE, positive)?;
        }
        range("friction", self.friction, 0.0, not_negative)?;
        range("pose_delay", self.pose_delay, 0.0, not_negative)?;
        range("velocity_delay", self.velocity_delay, 0.0, not_negative)?;
        range(
            "odometry_scale",
            self.odometry_scale,
            f64::MIN_POSITIVE,
            positive,
        )?;
        single(
            "position_noise",
            self.sensing.position_noise,
            0.0,
            "finite and not below 0",
        )?;
        single(
            "heading_noise",
            self.sensing.heading_noise,
            0.0,
            "finite and not below 0",
        )?;
        single(
            "payload",
            self.payload.unwrap_or(1.0),
            f64::MIN_POSITIVE,
            "finite and above 0, kg",
        )?;
        single(
            "law.feedback",
            self.law.feedback,
            f64::MIN_POSITIVE,
            "finite and above 0",
        )?;
        single("law.rates", self.law.rates, 0.0, "finite and not below 0")?;
        single(
            "law.torque_limit",
            self.law.torque_limit.unwrap_or(1.0),
            f64::MIN_POSITIVE,
            "finite and above 0, N m",
        )?;
        single(
            "supervisor.tracking_error",
            self.supervisor.tracking_error,
            f64::MIN_POSITIVE,
            "finite and above 0, m",
        )?;
        single("trials", self.trials as f64, 1.0, "at least 1")?;
        single(
            "sample_interval",
            self.sample_interval,
            0.01,
            "at least 0.01 s",
        )?;
        // A step that is longer than a tick is shortened to it (`Options::for_control`).
        let ticks = TORQUE_PERIOD / self.physics.time_step;
        if ticks < 0.0 || (ticks > 1.0 && (ticks - ticks.round()).abs() > 1e-9) {
            let bound = "a whole part of the torque loop's period of 0.002 s";
            return Err(ExecutionError::Option {
                name: "physics.time_step",
                value: self.physics.time_step,
                bound,
            });
        }
        Ok(())
    }
}

fn range(
    name: &'static str,
    [low, high]: [f64; 2],
    least: f64,
    bound: &'static str,
) -> Result<(), ExecutionError> {
    single(name, low, least, bound)?;
    single(name, high, low, bound)
}

fn single(
    name: &'static str,
    value: f64,
    least: f64,
    bound: &'static str,
) -> Result<(), ExecutionError> {
    if value.is_finite() && value >= least {
        Ok(())
    } else {
        Err(ExecutionError::Option { name, value, bound })
    }
}

/// Default gains of a law for the scene's robot.
pub fn controller_parameters(
    scene: &Scene,
    kind: ControllerKind,
    nominal_inertia: NominalInertia,
) -> ControllerParameters<f64> {
    let physics = &scene.physics;
    let model = RobotModel {
        mass: physics.robot_mass,
        inertia: match nominal_inertia {
            NominalInertia::PaperTable => RobotModel::<f64>::paper().inertia,
            NominalInertia::Robot => physics.robot_inertia,
        },
        half_track: scene.robot.half_track,
        wheel_radius: physics.wheel_radius,
        offset: physics.center_of_mass.max(0.0),
        coriolis_form: CoriolisForm::Corrected,
    };
    let inertia = [physics.robot_mass, physics.robot_inertia];
    let law = match kind {
        ControllerKind::Mrac => LawParameters::Mrac(MracGains::for_inertia(inertia)),
        ControllerKind::Integral => LawParameters::Integral(IntegralGains::for_inertia(inertia)),
        ControllerKind::ModelBased => LawParameters::ModelBased,
    };
    // Room above the plan's own speeds to catch up.
    let desired = Velocity {
        linear: 1.5 * scene.robot.v_max,
        angular: 1.2 * scene.robot.omega_max,
    };
    let limits = Limits {
        torque: physics.max_torque,
        desired,
        ..Limits::default()
    };
    ControllerParameters {
        tracking: TrackingGains::default(),
        limits,
        model,
        ..ControllerParameters::with_law(law)
    }
}
