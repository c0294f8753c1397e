use super::given_plan::{given_plan, unproven};
use super::with_scene;
use crate::arguments::{MonteCarloArguments, PlantsArgument};
use crate::exit::Exit;
use crate::failure::Failure;
use crate::interrupt;
use crate::objects::LeftOutObject;
use crate::output::{Done, Report, to_json};
use crate::results::{Results, in_folder};
use crate::trials::Trials;
use pairtrawl::execute::{MonteCarlo, MonteCarloOptions, MonteCarloRow, Plants};
use pairtrawl::files::LoadedScene;
use pairtrawl::model::numbers::{length, lengths, quantity};
use pairtrawl::model::{ControllerKind, LeftOut};
use pairtrawl::simulation::Options as SimulationOptions;
use schemars::JsonSchema;
use serde::Serialize;
use std::fmt::Write;

/// Comparison of the control laws over many random plants.
#[derive(Clone, Serialize, JsonSchema)]
pub struct MonteCarloReport {
    /// Name of the scene.
    #[serde(skip_serializing_if = "Option::is_none")]
    scene: Option<String>,
    /// What the laws drove: `full` (robots, net and objects in physics) or `reduced` (each robot alone, under a drag).
    #[schemars(extend("enum" = ["full", "reduced"]))]
    physics: &'static str,
    /// Drives for each law.
    runs: usize,
    /// Seed of everything that is random.
    seed: u64,
    /// A drive succeeds when neither robot is ever farther than this from its path after the first second, m.
    tolerance: f64,
    /// True when it was stopped before all drives were finished.
    interrupted: bool,
    /// Objects that the plan leaves where they are, ascending.
    left_out: Vec<LeftOutObject>,
    /// A row for each law that finished a drive.
    rows: Vec<RowObject>,
}

/// What one law did.
#[derive(Clone, Serialize, JsonSchema)]
struct RowObject {
    /// The law.
    #[schemars(extend("enum" = ControllerKind::ALL.map(ControllerKind::name)))]
    controller: &'static str,
    /// Finished drives.
    runs: usize,
    /// Of these, how many stayed within the tolerance and reached the end.
    successes: usize,
    /// Of these, how many the supervisor stopped.
    stopped: usize,
    /// Root mean square of a drive's position error after the first second, m.
    rms: QuantilesObject,
    /// Greatest position error of a drive after the first second, m.
    max: QuantilesObject,
    /// Greatest torque of a wheel in any drive, N m.
    max_torque: f64,
    /// Mean number of objects in the net at the end of a drive; in full physics only.
    #[serde(skip_serializing_if = "Option::is_none")]
    gathered: Option<f64>,
}

/// Quantiles over the drives.
#[derive(Clone, Serialize, JsonSchema)]
struct QuantilesObject {
    /// 50 % of the drives have no more.
    p50: f64,
    /// 90 % of the drives have no more.
    p90: f64,
    /// 99 % of the drives have no more.
    p99: f64,
}

/// `pairtrawl monte-carlo`: success rate and errors of the three laws over random plants.
pub fn monte_carlo(arguments: &MonteCarloArguments) -> Result<Done, Failure> {
    let work = |results: Option<&Results<'_>>| {
        with_scene(&arguments.scene, &|loaded| {
            monte_carlo_in(loaded, arguments, results)
        })
    };
    match &arguments.output {
        Some(folder) => in_folder(folder, &["monte-carlo.json"], |results| work(Some(results))),
        None => work(None),
    }
}

fn monte_carlo_in(
    loaded: &LoadedScene,
    arguments: &MonteCarloArguments,
    results: Option<&Results<'_>>,
) -> Result<Done, Failure> {
    let plan = given_plan(loaded, arguments.plan.as_deref())?;
    let plants = match arguments.physics {
        PlantsArgument::Full => Plants::Full {
            net_length: plan.net_length,
            physics: SimulationOptions::default(),
        },
        PlantsArgument::Reduced => Plants::Reduced,
    };
    let options = MonteCarloOptions {
        plants,
        runs: arguments.runs as usize,
        seed: arguments.seed,
        delayed_velocity: arguments.delayed_velocity,
        ..MonteCarloOptions::default()
    };
    let trials = Trials::new(options.runs * options.controllers.len(), "driving");
    let table = interrupt::gracefully(|| {
        pairtrawl::execute::compare_laws(&loaded.scene, &plan, &options, &trials)
    });
    trials.finish();
    let mut table = table.map_err(|error| Failure::new(Exit::BadInput, error.to_string()))?;
    // Quantiles of nothing are no numbers.
    table.rows.retain(|row| row.runs > 0);

    let mut warnings = loaded.warnings.clone();
    warnings.extend(unproven(&plan));
    let scene = &loaded.scene.name;
    let about = report(&table, &options, &plan.left_out);
    let files = match results {
        Some(results) => {
            let file = MonteCarloReport {
                scene: Some(scene.clone()),
                ..about.clone()
            };
            results.write(&[("monte-carlo.json", format!("{}\n", to_json(&file)?))])?
        }
        None => Vec::new(),
    };
    let exit = if table.interrupted {
        Exit::Interrupted
    } else {
        Exit::Done
    };
    Report::new("monte-carlo", exit, about).scene(scene).done(
        exit,
        table_text(&table, &options),
        &warnings,
        &files,
    )
}

fn table_text(table: &MonteCarlo, options: &MonteCarloOptions) -> String {
    let mut text = String::new();
    let full = matches!(options.plants, Plants::Full { .. });
    let _ = writeln!(
        text,
        "{}{} runs for each law {}, success within {}",
        if table.interrupted {
            format!(
                "INTERRUPTED after {} of {} runs: ",
                table.runs, table.runs_wanted
            )
        } else {
            String::new()
        },
        options.runs,
        match options.plants {
            Plants::Full { .. } => "in full physics",
            Plants::Reduced => "on reduced plants",
        },
        length(options.tolerance),
    );
    if table.rows.is_empty() {
        let _ = writeln!(text, "  no run was finished");
        return text;
    }
    let _ = writeln!(
        text,
        "  {:<12} {:>8} {:>9} {:>8}   {:<26}   {:<26} {:>12}{}",
        "law",
        "runs",
        "success",
        "stopped",
        "rms error p50 / 90 / 99 %",
        "max error p50 / 90 / 99 %",
        "most torque",
        if full { "  in the net" } else { "" },
    );
    for row in &table.rows {
        let rate = 100.0 * row.successes as f64 / row.runs as f64;
        let _ = writeln!(
            text,
            "  {:<12} {:>8} {:>7.1} % {:>8}   {:<26}   {:<26} {:>12}{}",
            row.controller.name(),
            row.runs,
            rate,
            row.stopped,
            lengths(&row.rms),
            lengths(&row.max),
            quantity(row.max_torque, "N m"),
            (row.gathered).map_or_else(String::new, |objects| format!("{objects:>12.1}")),
        );
    }
    text
}

fn report(table: &MonteCarlo, options: &MonteCarloOptions, left: &[LeftOut]) -> MonteCarloReport {
    MonteCarloReport {
        scene: None,
        physics: match options.plants {
            Plants::Full { .. } => PlantsArgument::Full.name(),
            Plants::Reduced => PlantsArgument::Reduced.name(),
        },
        runs: options.runs,
        seed: options.seed,
        tolerance: options.tolerance,
        interrupted: table.interrupted,
        left_out: LeftOutObject::all(left),
        rows: table.rows.iter().map(row).collect(),
    }
}

fn row(row: &MonteCarloRow) -> RowObject {
    let quantiles = |[p50, p90, p99]: [f64; 3]| QuantilesObject { p50, p90, p99 };
    RowObject {
        controller: row.controller.name(),
        runs: row.runs,
        successes: row.successes,
        stopped: row.stopped,
        rms: quantiles(row.rms),
        max: quantiles(row.max),
        max_torque: row.max_torque,
        gathered: row.gathered,
    }
}
