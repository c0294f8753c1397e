use super::FORMAT;
use super::file::{File, FileLeftOut, FileNetLength, FileRehearsal, FileSolver};
use crate::files::json::{from_json, stated_format};
use crate::files::{FileError, Problem};
use pairtrawl_geometry::{Point, Pose};
use pairtrawl_model::{
    Circle, Cost, LeftOut, Overrides, PairTrajectory, Rehearsal, Scene, SceneReference,
    SolverReport, SolverStatus, default_step_time,
};
use std::path::Path;

/// A plan as it stands in a file, perhaps one made by another program. Its certificate is not read: claims are derived anew.
#[derive(Clone, Debug, PartialEq)]
pub struct PlanFile {
    /// d_max, m.
    pub net_length: f64,
    /// Poses of the left robot, at least two.
    pub left: Vec<Pose>,
    /// Poses of the right robot, as many.
    pub right: Vec<Pose>,
    /// Time from one waypoint to the next, s, when the file has it.
    pub step_time: Option<f64>,
    /// When the pair passes each waypoint, s from the start, when the file has it.
    pub time_law: Option<Vec<f64>>,
    /// The scene that the plan says it is for.
    pub scene: Option<SceneReference>,
    /// What the command line changed against the scene.
    pub overrides: Overrides,
    /// The pair's centerline; empty when the file has none.
    pub centerline: Vec<Pose>,
    /// The baseline pair of the left and the right robot.
    pub baseline: Option<(Vec<Pose>, Vec<Pose>)>,
    /// Merged object circles; empty when the file has none.
    pub circles: Vec<Circle>,
    /// Visiting order; empty when the file has none.
    pub order: Vec<usize>,
    /// Objects that it leaves where they are, ascending; empty when it gathers everything.
    pub left_out: Vec<LeftOut>,
    /// The paper's J as the file states it.
    pub cost: Option<Cost>,
    /// What the rehearsal said, as the file states it.
    pub rehearsal: Rehearsal,
    /// How the optimization ended, as the file states it.
    pub solver: SolverReport,
}

impl PlanFile {
    /// The trajectories, on the plan's clock or, when the file has none, on the scene's default one.
    pub fn trajectory(&self, scene: &Scene) -> PairTrajectory {
        let step_time = self
            .step_time
            .unwrap_or_else(|| default_step_time(&scene.robot, &scene.planner));
        PairTrajectory {
            left: self.left.clone(),
            right: self.right.clone(),
            step_time,
        }
    }
}

/// Reads the text of a plan; `path` stands for the file in messages.
///
/// # Errors
/// When it is not JSON, lacks one of the first four fields, or has numbers that mean nothing.
pub fn parse_plan(text: &str, path: &Path) -> Result<PlanFile, FileError> {
    match stated_format(text, path)? {
        Some(format) if format == FORMAT => {}
        Some(found) => {
            return Err(FileError::new(
                path,
                Problem::Format {
                    found,
                    expected: FORMAT,
                },
            ));
        }
        None => {
            let remedy = format!("a plan starts with \"format\": {FORMAT:?}");
            return Err(FileError::new(
                path,
                Problem::MissingKey {
                    field: "format".to_owned(),
                    remedy,
                },
            ));
        }
    }
    let file: File = from_json(text, path)?;
    file.check()
        .map_err(|problem| FileError::new(path, problem))?;
    Ok(file.into())
}

impl File {
    fn check(&self) -> Result<(), Problem> {
        let refuse = |field: &str, value: String, bound: &str| {
            Err(Problem::Value {
                field: field.to_owned(),
                value,
                bound: bound.to_owned(),
            })
        };
        let positive = |x: f64| x.is_finite() && x > 0.0;
        if !positive(self.net_length) {
            return refuse(
                "net_length",
                self.net_length.to_string(),
                "finite and above zero (m)",
            );
        }
        if let Some(step_time) = self.step_time
            && !positive(step_time)
        {
            return refuse(
                "step_time",
                step_time.to_string(),
                "finite and above zero (s)",
            );
        }
        if self.left.len() < 2 {
            return refuse(
                "left",
                format!("an array of {}", self.left.len()),
                "an array of at least 2 poses",
            );
        }
        if self.left.len() != self.right.len() {
            let bound = format!("as long as left ({} poses)", self.left.len());
            return refuse("right", format!("an array of {}", self.right.len()), &bound);
        }
        // JSON has no NaN and no infinity, and numbers that overflow are refused by its parser.
        if let Some(FileNetLength::Fixed(length)) = self
            .overrides
            .as_ref()
            .and_then(|changed| changed.net_length)
            && !positive(length)
        {
            return refuse(
                "overrides.net_length",
                length.to_string(),
                "finite and above zero (m), or \"auto\"",
            );
        }
        Ok(())
    }
}

impl From<FileRehearsal> for Rehearsal {
    fn from(rehearsal: FileRehearsal) -> Self {
        match rehearsal {
            FileRehearsal::Passed => Self::Passed,
            FileRehearsal::Skipped => Self::Skipped,
            FileRehearsal::Failed { event, time, place } => Self::Failed {
                event,
                time,
                place: place.into(),
            },
        }
    }
}

impl From<FileSolver> for SolverReport {
    fn from(solver: FileSolver) -> Self {
        match SolverStatus::ALL
            .into_iter()
            .find(|status| status.name() == solver.status)
        {
            None => Self::NOT_STATED,
            Some(status) => Self {
                status,
                iterations: solver.iterations,
                kkt_error: solver.kkt_error.unwrap_or(f64::NAN),
                seconds: solver.seconds,
            },
        }
    }
}

/// Ascending, each object once.
fn left_out(listed: Vec<FileLeftOut>) -> Vec<LeftOut> {
    let mut left: Vec<LeftOut> = listed.into_iter().map(LeftOut::from).collect();
    left.sort_by_key(|left| left.object);
    left.dedup_by_key(|left| left.object);
    left
}

impl From<File> for PlanFile {
    fn from(file: File) -> Self {
        let poses = |raw: Vec<[f64; 3]>| raw.into_iter().map(Pose::from).collect::<Vec<_>>();
        Self {
            net_length: file.net_length,
            left: poses(file.left),
            right: poses(file.right),
            step_time: file.step_time,
            time_law: file.time_law.filter(|law| !law.is_empty()),
            scene: file.scene.map(SceneReference::from),
            overrides: file.overrides.unwrap_or_default().into(),
            centerline: poses(file.centerline.unwrap_or_default()),
            baseline: file.baseline.map(|b| (poses(b.left), poses(b.right))),
            circles: (file.circles.unwrap_or_default().into_iter())
                .map(|c| Circle {
                    center: Point::from(c.center),
                    radius: c.radius,
                    objects: c.objects,
                })
                .collect(),
            order: file.order.unwrap_or_default(),
            left_out: left_out(file.left_out),
            cost: file.cost.map(|c| Cost {
                smoothness: c.smoothness,
                distance: c.distance,
                obstacle: c.obstacle,
                expansion: c.expansion,
            }),
            rehearsal: file.rehearsal.map_or(Rehearsal::Skipped, Rehearsal::from),
            solver: file
                .solver
                .map_or(SolverReport::NOT_STATED, SolverReport::from),
        }
    }
}
