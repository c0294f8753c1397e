use crate::{Certificate, Cost, Leave, LeftOut, PairTrajectory, Warning};
use pairtrawl_geometry::{Point, Pose};

/// A planned run and how it came about.
#[derive(Clone, Debug, PartialEq)]
pub struct Plan {
    /// d_max, m.
    pub net_length: f64,
    /// What the robots drive.
    pub trajectory: PairTrajectory,
    /// When the reference passes each waypoint, s from the start: one time law for both robots at cruise speed, which
    /// starts, turns and stops smoothly. Empty when there is none: for a plan made elsewhere.
    pub time_law: Vec<f64>,
    /// Which scene it is for.
    pub scene: SceneReference,
    /// What was changed against the scene.
    pub overrides: Overrides,
    /// The pair's centerline.
    pub centerline: Vec<Pose>,
    /// The baseline pair that the optimization started from.
    pub baseline: PairTrajectory,
    /// Merged object circles, as used for order, centerline and baseline.
    pub circles: Vec<Circle>,
    /// Visiting order: indices into `circles`.
    pub order: Vec<usize>,
    /// Objects that it leaves where they are, ascending; the certificate is about all others.
    pub left_out: Vec<LeftOut>,
    /// The paper's J.
    pub cost: Cost,
    /// The proof.
    pub certificate: Certificate,
    /// What the physics said.
    pub rehearsal: Rehearsal,
    /// What the optimizer said.
    pub solver: SolverReport,
    /// Warnings for people: margins that shrank, thresholds, fallbacks.
    pub warnings: Vec<Warning>,
}

impl Plan {
    /// The last waypoint that a pair which keeps to the plan has passed `time` s after it set out; by the time law, or by
    /// the step time where there is none.
    pub fn waypoint_at(&self, time: f64) -> usize {
        let last = self.trajectory.len().saturating_sub(1);
        let passed = if self.time_law.is_empty() {
            (time / self.trajectory.step_time).max(0.0) as usize
        } else {
            self.time_law
                .partition_point(|t| *t <= time)
                .saturating_sub(1)
        };
        passed.min(last)
    }
}

impl Plan {
    /// When each waypoint is passed, s: by the time law, or at every `step_time` where there is none.
    pub fn times(&self) -> Vec<f64> {
        match self.time_law.len() == self.trajectory.len() {
            true => self.time_law.clone(),
            false => self.trajectory.times(),
        }
    }
}

/// Which scene a plan is for.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SceneReference {
    /// The scene's name.
    pub name: String,
    /// Hexadecimal SHA-256 of the scene file, then the map YAML, then the image.
    pub sha256: String,
    /// Hexadecimal SHA-256 of what the files say: it does not change with comments, order or layout. `None` in plans that
    /// do not state it.
    pub content_sha256: Option<String>,
}

/// What the command line changed against the scene.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Overrides {
    /// `Some(Some(L))`: `--net-length L`; `Some(None)`: `--net-length auto`; `None`: as in the scene.
    pub net_length: Option<Option<f64>>,
    /// `--leave`; `None`: as in the scene.
    pub leave: Option<Leave>,
}

/// A circle around one object or several close ones.
#[derive(Clone, Debug, PartialEq)]
pub struct Circle {
    /// Its center, m.
    pub center: Point,
    /// r_o: its radius, margin included, m.
    pub radius: f64,
    /// Indices of the scene's objects inside.
    pub objects: Vec<usize>,
}

/// The verdict of the rehearsal. Never a proof.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum Rehearsal {
    /// Every object was gathered and nothing else was touched.
    Passed,
    /// What went wrong first.
    Failed {
        /// The first event, for people.
        event: String,
        /// When, s.
        time: f64,
        /// Where, m.
        place: Point,
    },
    /// Not rehearsed.
    #[default]
    Skipped,
}

/// How the optimization ended.
#[derive(Clone, Debug, PartialEq)]
pub struct SolverReport {
    /// Its status.
    pub status: SolverStatus,
    /// Interior-point iterations of the last optimization.
    pub iterations: usize,
    /// Scaled KKT error of the returned point.
    pub kkt_error: f64,
    /// Time spent on optimizing from the start that was chosen, s. The only number in a plan that differs between runs.
    pub seconds: f64,
}

impl SolverReport {
    /// Of a plan that does not say how it was found.
    pub const NOT_STATED: Self = Self {
        status: SolverStatus::NotStated,
        iterations: 0,
        kkt_error: f64::NAN,
        seconds: 0.0,
    };
}

/// How the optimization ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SolverStatus {
    /// Optimality residuals are below the tolerance.
    Converged,
    /// Stationary for the violation of the constraints: no better point nearby.
    LocallyInfeasible,
    /// The iteration budget ran out.
    IterationLimit,
    /// The time limit ran out.
    TimeLimit,
    /// The linear algebra broke down.
    NumericalTrouble,
    /// The plan comes from a file: how it was found is not known.
    NotStated,
}

impl SolverStatus {
    /// All, in the order of their declaration.
    pub const ALL: [Self; 6] = [
        Self::Converged,
        Self::LocallyInfeasible,
        Self::IterationLimit,
        Self::TimeLimit,
        Self::NumericalTrouble,
        Self::NotStated,
    ];

    /// How the optimizer ended, for people.
    pub const fn describe(self) -> &'static str {
        match self {
            Self::Converged => "the optimizer converged",
            Self::LocallyInfeasible => "the optimizer found no way to meet all constraints nearby",
            Self::IterationLimit => "the optimizer ran out of iterations",
            Self::TimeLimit => "the optimizer was stopped",
            Self::NumericalTrouble => "the optimizer broke down numerically",
            Self::NotStated => "how it was found is not known",
        }
    }

    /// The name in files.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Converged => "converged",
            Self::LocallyInfeasible => "locally_infeasible",
            Self::IterationLimit => "iteration_limit",
            Self::TimeLimit => "time_limit",
            Self::NumericalTrouble => "numerical_trouble",
            Self::NotStated => "not_stated",
        }
    }
}
