use crate::rehearsal::gathered_count;
use crate::{Certificate, Cost, PairPose, RehearsalEventKind, RehearsalFrame, Side, Warning};
use pairtrawl_geometry::Point;

/// Several drives of one plan by controllers in the simulated world.
#[derive(Clone, Debug, PartialEq)]
pub struct Execution {
    /// Which law drove.
    pub controller: ControllerKind,
    /// d_max of the plan, m.
    pub net_length: f64,
    /// Duration of the reference that the plan became, s.
    pub reference_duration: f64,
    /// The claims of the certificate, checked again on the reference.
    pub reference_certificate: Certificate,
    /// The trials that were finished, in the order of their index.
    pub trials: Vec<Trial>,
    /// How many were wanted.
    pub trials_wanted: usize,
    /// True when it was stopped before all of them were finished.
    pub interrupted: bool,
    /// Warnings for people.
    pub warnings: Vec<Warning>,
}

impl Execution {
    /// True when every wanted trial was finished and gathered every object.
    pub fn gathered_everything(&self) -> bool {
        !self.interrupted
            && self.trials.len() == self.trials_wanted
            && self.trials.iter().all(Trial::gathered_everything)
    }
}

/// The law that turns a desired velocity into force.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum ControllerKind {
    /// The adaptive law, eqs. 25 to 30.
    #[default]
    Mrac,
    /// Eq. 22 as printed.
    ModelBased,
    /// Eq. 22 with integral velocity feedback.
    Integral,
}

impl ControllerKind {
    /// All, in the order in which tables show them.
    pub const ALL: [Self; 3] = [Self::Mrac, Self::Integral, Self::ModelBased];

    /// The name in files and on the command line.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Mrac => "mrac",
            Self::ModelBased => "model-based",
            Self::Integral => "integral",
        }
    }
}

/// One drive.
#[derive(Clone, Debug, PartialEq)]
pub struct Trial {
    /// 0 for the first.
    pub index: usize,
    /// Seed of everything random in it.
    pub seed: u64,
    /// What was drawn for it.
    pub conditions: TrialConditions,
    /// Per object: true when at the end its center lies inside the region bounded by the net and the hitch line.
    pub gathered: Vec<bool>,
    /// Objects that were to be left where they are: it does not matter whether they are in the net.
    pub left: Vec<usize>,
    /// What must not happen and did, in order of time.
    pub events: Vec<ExecutionEvent>,
    /// Position error of the (left, right) robot against the reference.
    pub tracking: [TrackingStatistics; 2],
    /// The paper's J on the driven path.
    pub cost: Cost,
    /// Force of net and contacts on the (left, right) robot, mean over 20 ms each.
    pub drag: [DragStatistics; 2],
    /// Greatest torque of a wheel of the (left, right) robot, N m.
    pub max_torque: [f64; 2],
    /// Robots, net and objects at intervals; the first is the start, the last the end. Never empty.
    pub frames: Vec<RehearsalFrame>,
    /// What the controllers did, at intervals.
    pub samples: Vec<ControlSample>,
    /// Simulated time, s.
    pub duration: f64,
    /// Time it took to compute, s. The only number that differs between runs.
    pub seconds: f64,
}

impl Trial {
    /// True when the pair came to the end of its way with every object inside the net.
    pub fn gathered_everything(&self) -> bool {
        !self.was_stopped() && self.gathered_count() == self.wanted()
    }

    /// True when the supervisor stopped the pair on its way.
    pub fn was_stopped(&self) -> bool {
        self.events
            .iter()
            .any(|e| matches!(e.kind, ExecutionEventKind::PairStopped { .. }))
    }

    /// How many of the objects that were to be gathered are inside the net at the end.
    pub fn gathered_count(&self) -> usize {
        gathered_count(&self.gathered, &self.left)
    }

    /// How many objects were to be gathered.
    pub fn wanted(&self) -> usize {
        self.gathered.len() - self.left.len()
    }
}

/// What was drawn for a trial.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct TrialConditions {
    /// Mass of each robot (left, right), times the scene's.
    pub robot_mass_factor: f64,
    /// Inertia of each robot, times the scene's.
    pub robot_inertia_factor: f64,
    /// Masses of the objects, kg.
    pub object_masses: Vec<f64>,
    /// Friction of net and objects on the floor, times the scene's.
    pub friction_factor: f64,
    /// Age of poses when they reach the controllers, s.
    pub pose_delay: f64,
    /// Age of measured velocities when they reach the controllers, s.
    pub velocity_delay: f64,
    /// Measured over true speed of the (left, right) robot.
    pub odometry_scale: [f64; 2],
}

/// Position error over a drive.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct TrackingStatistics {
    /// Root mean square, m.
    pub rms: f64,
    /// Greatest, m.
    pub max: f64,
    /// Root mean square after the first second, m.
    pub settled_rms: f64,
    /// Greatest after the first second, m.
    pub settled_max: f64,
}

/// Drag over a drive.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct DragStatistics {
    /// Mean magnitude, N.
    pub mean: f64,
    /// Greatest magnitude, N.
    pub max: f64,
}

/// Something that must not happen in a drive.
#[derive(Clone, Debug, PartialEq)]
pub struct ExecutionEvent {
    /// What happened.
    pub kind: ExecutionEventKind,
    /// When it began, s.
    pub time: f64,
    /// Where, m.
    pub place: Point,
}

/// What can go wrong in a drive.
#[derive(Clone, Debug, PartialEq)]
pub enum ExecutionEventKind {
    /// What can go wrong in a rehearsal as well.
    Physical(RehearsalEventKind),
    /// The supervisor stopped the pair.
    PairStopped {
        /// Why, for people.
        cause: String,
        /// Whose report it was.
        robot: Side,
    },
}

impl ExecutionEventKind {
    /// The event in a few words, for people.
    pub fn describe(&self) -> String {
        match self {
            Self::Physical(kind) => kind.describe(),
            Self::PairStopped { cause, robot } => {
                format!("the pair is stopped: {} robot, {cause}", robot.name())
            }
        }
    }
}

/// What the controllers did at an instant. Arrays over robots are (left, right).
#[derive(Clone, Debug, PartialEq)]
pub struct ControlSample {
    /// Time since the start, s.
    pub time: f64,
    /// Where both robots should be.
    pub reference: PairPose,
    /// Where they are.
    pub robots: PairPose,
    /// Their speeds, m/s.
    pub forward: [f64; 2],
    /// Their turning rates, rad/s.
    pub turn_rate: [f64; 2],
    /// Distance from the reference, m.
    pub error: [f64; 2],
    /// Force of net and contacts on them, mean over 20 ms, N.
    pub drag: [f64; 2],
    /// Torques of the (left, right) wheel of each, N m.
    pub torque: [[f64; 2]; 2],
    /// Delta_b: what the law has learned of a constant force (N) and torque (N m); zero for the printed law.
    pub bias: [[f64; 2]; 2],
    /// Delta_X, row by row: force by nu, omega; torque by nu, omega.
    pub state_gain: [[f64; 4]; 2],
    /// Delta_m, row by row.
    pub input_gain: [[f64; 4]; 2],
}
