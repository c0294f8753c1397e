use super::given_plan::{given_plan, unproven};
use super::planning::{create_folder, list};
use crate::arguments::MonteCarloArguments;
use crate::exit::{Exit, Failure};
use crate::interrupt;
use crate::output::{self, Done};
use crate::trials::Trials;
use pairtrawl::execute::{MonteCarlo, MonteCarloOptions};
use pairtrawl::files::{read_scene, write_atomically};
use serde_json::{Value, json};
use std::fmt::Write;

/// `pairtrawl monte-carlo`: success rate and errors of the three laws over random plants.
pub fn monte_carlo(arguments: &MonteCarloArguments) -> Result<Done, Failure> {
    let loaded = read_scene(&arguments.scene)?;
    let plan = given_plan(&loaded, arguments.plan.as_deref())?;
    if let Some(folder) = &arguments.output {
        create_folder(folder)?;
    }
    let options = MonteCarloOptions {
        runs: arguments.runs as usize,
        seed: arguments.seed,
        delayed_velocity: arguments.delayed_velocity,
        ..MonteCarloOptions::default()
    };
    let trials = Trials::new(options.runs * options.controllers.len(), "driving");
    let table = interrupt::gracefully(|| {
        pairtrawl::execute::monte_carlo(&loaded.scene, &plan.trajectory, &options, &trials)
    });
    trials.finish();
    let table = table.map_err(|error| Failure::new(Exit::BadInput, error.to_string()))?;

    let mut warnings = loaded.warnings.clone();
    warnings.extend(unproven(&plan));
    let mut object = table_json(&table, &options);
    object["scene"] = json!(loaded.scene.name);
    let mut text = table_text(&table, &options);
    output::warnings(&mut text, &warnings);
    let mut files = Vec::new();
    if let Some(folder) = &arguments.output {
        let path = folder.join("monte-carlo.json");
        interrupt::while_writing(|| write_atomically(&path, format!("{object}\n").as_bytes()))?;
        files.push(path);
        let _ = writeln!(text, "wrote {}", list(&files));
    }
    object["command"] = json!("monte-carlo");
    object["warnings"] = json!(warnings);
    object["files"] = files
        .iter()
        .map(|file| file.display().to_string())
        .collect();
    let exit = if table.interrupted {
        Exit::Interrupted
    } else {
        Exit::Done
    };
    Ok(Done { exit, text, object })
}

fn table_text(table: &MonteCarlo, options: &MonteCarloOptions) -> String {
    let mut text = String::new();
    let _ = writeln!(
        text,
        "{} runs for each law, success within {:.2} m{}",
        options.runs,
        options.tolerance,
        if table.interrupted {
            " (INTERRUPTED)"
        } else {
            ""
        }
    );
    let _ = writeln!(
        text,
        "  {:<12} {:>8} {:>9} {:>8}   {:<24}   {:<24} {:>10}",
        "law",
        "runs",
        "success",
        "stopped",
        "rms error p50/90/99 m",
        "max error p50/90/99 m",
        "torque N m"
    );
    for row in &table.rows {
        let triple = |q: [f64; 3]| format!("{:.4} {:.4} {:.4}", q[0], q[1], q[2]);
        let rate = 100.0 * row.successes as f64 / row.runs.max(1) as f64;
        let _ = writeln!(
            text,
            "  {:<12} {:>8} {:>7.1} % {:>8}   {:<24}   {:<24} {:>10.2}",
            row.controller.name(),
            row.runs,
            rate,
            row.stopped,
            triple(row.rms),
            triple(row.max),
            row.max_torque
        );
    }
    text
}

fn table_json(table: &MonteCarlo, options: &MonteCarloOptions) -> Value {
    json!({
        "runs": options.runs,
        "seed": options.seed,
        "tolerance": options.tolerance,
        "interrupted": table.interrupted,
        "rows": table.rows.iter().map(|row| json!({
            "controller": row.controller.name(),
            "runs": row.runs,
            "successes": row.successes,
            "stopped": row.stopped,
            "rms": { "p50": row.rms[0], "p90": row.rms[1], "p99": row.rms[2] },
            "max": { "p50": row.max[0], "p90": row.max[1], "p99": row.max[2] },
            "max_torque": row.max_torque,
        })).collect::<Vec<_>>(),
    })
}
