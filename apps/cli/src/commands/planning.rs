//! What `plan` and `demo` share: planning with progress, then the files and the summary.

use crate::arguments::PlanningArguments;
use crate::exit::Exit;
use crate::failed;
use crate::failure::Failure;
use crate::objects::{ClaimObject, CostObject, LeftOutObject, RehearsalObject};
use crate::output::{Done, Report, finite};
use crate::plan_text::plan_text;
use crate::progress::Progress;
use crate::results::{Results, in_folder};
use pairtrawl::files::{self, LoadedScene};
use pairtrawl::model::{Plan, Scene, Side, SolverStatus, Summary};
use pairtrawl::reference::Reference;
use schemars::JsonSchema;
use serde::Serialize;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// The files of a plan, the plan itself first: where it stands, everything stands.
const FILES: &[&str] = &[
    "plan.json",
    "report.html",
    "plan.svg",
    "plan.csv",
    "left.tum",
    "right.tum",
];

/// A plan in numbers.
#[derive(Serialize, JsonSchema)]
pub struct PlanReport {
    /// Length of the net, d_max, m.
    net_length: f64,
    /// True when the planner chose it.
    net_length_chosen: bool,
    /// Number of waypoints N.
    waypoints: usize,
    /// Time from one waypoint to the next, s.
    step_time: f64,
    /// Length of the left robot's path, m.
    left_length: f64,
    /// Length of the right robot's path, m.
    right_length: f64,
    /// Time to drive, s.
    duration: f64,
    /// How many objects the plan gathers.
    gathers: usize,
    /// Objects that it leaves where they are, ascending.
    left_out: Vec<LeftOutObject>,
    /// The paper's J.
    cost: CostObject,
    /// The proof, claim by claim.
    claims: Vec<ClaimObject>,
    /// What the simulated drive said.
    rehearsal: RehearsalObject,
    /// How the optimization ended.
    solver: SolverObject,
    /// Time of each stage of planning, s.
    seconds: BTreeMap<String, f64>,
}

/// How the optimization ended.
#[derive(Serialize, JsonSchema)]
struct SolverObject {
    /// Its status.
    #[schemars(extend("enum" = SolverStatus::ALL.map(SolverStatus::name)))]
    status: &'static str,
    /// Iterations of the last optimization.
    iterations: usize,
    /// Scaled error of the optimality conditions; null when it is not known.
    kkt_error: Option<f64>,
}

impl From<&Summary> for PlanReport {
    fn from(summary: &Summary) -> Self {
        Self {
            net_length: summary.net_length,
            net_length_chosen: summary.net_length_chosen,
            waypoints: summary.trajectory.len(),
            step_time: summary.trajectory.step_time,
            left_length: summary.left_length,
            right_length: summary.right_length,
            duration: summary.duration,
            gathers: summary.gathers(),
            left_out: LeftOutObject::all(&summary.left_out),
            cost: CostObject::from(&summary.cost),
            claims: summary.claims.iter().map(ClaimObject::from).collect(),
            rehearsal: RehearsalObject::from(&summary.rehearsal),
            solver: SolverObject {
                status: summary.solver.status.name(),
                iterations: summary.solver.iterations,
                kkt_error: finite(summary.solver.kkt_error),
            },
            seconds: (summary.stages.iter())
                .map(|stage| (stage.name.clone(), stage.seconds))
                .collect(),
        }
    }
}

/// What is done with a scene once it is there.
type WithScene<'a> = &'a dyn Fn(&LoadedScene) -> Result<Done, Failure>;

/// Plans the scene that `scene` provides and writes everything about the plan to a folder.
pub fn plan_into(
    command: &'static str,
    planning: &PlanningArguments,
    folder: &Path,
    scene: impl FnOnce(WithScene<'_>) -> Result<Done, Failure>,
) -> Result<Done, Failure> {
    in_folder(folder, FILES, |results| {
        // What an earlier run said of its failure is not about this one.
        results.clear(&failed::FILES);
        scene(&|loaded| plan_and_write(command, loaded, planning, results))
    })
}

fn plan_and_write(
    command: &'static str,
    loaded: &LoadedScene,
    planning: &PlanningArguments,
    results: &Results<'_>,
) -> Result<Done, Failure> {
    let mut progress = Progress::new();
    let options = planning.options();
    let planned = pairtrawl::plan(&loaded.scene, &loaded.reference, &options, &mut progress);
    progress.finish();
    let mut planned = match planned {
        Ok(planned) => planned,
        Err(error) => return Err(failed::write(results, loaded, &options, error)),
    };
    planned
        .plan
        .warnings
        .splice(0..0, loaded.warnings.iter().cloned());
    let summary = pairtrawl::summarize(
        &loaded.scene,
        &planned.plan,
        &planned.stages,
        planned.rehearsal.as_ref(),
    );
    let files = write(results, &loaded.scene, &planned.plan, &summary)?;
    Report::new(command, Exit::Done, PlanReport::from(&summary))
        .scene(&summary.title)
        .done(Exit::Done, plan_text(&summary), &summary.warnings, &files)
}

/// Writes the plan last.
fn write(
    results: &Results<'_>,
    scene: &Scene,
    plan: &Plan,
    summary: &Summary,
) -> Result<Vec<PathBuf>, Failure> {
    let plan_json = files::plan_json(plan).map_err(|error| {
        Failure::new(
            Exit::Internal,
            format!("the plan cannot be written as JSON: {error}"),
        )
    })?;
    let driven = Reference::of_scene(scene, &plan.trajectory).map_err(|error| {
        Failure::new(
            Exit::Internal,
            format!("the plan cannot be driven: {error}"),
        )
    })?;
    results.write(&[
        ("plan.csv", files::csv_text(&driven)),
        ("left.tum", files::tum_text(&driven, Side::Left)),
        ("right.tum", files::tum_text(&driven, Side::Right)),
        ("plan.svg", pairtrawl::report::plan_svg(summary)),
        ("report.html", pairtrawl::report::report_html(summary)),
        ("plan.json", plan_json),
    ])
}
