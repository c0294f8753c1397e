use super::given_plan::{given_plan, unproven};
use super::planning::{create_folder, list};
use crate::arguments::RunArguments;
use crate::exit::{Exit, Failure};
use crate::interrupt;
use crate::output::{self, Done};
use crate::trials::Trials;
use pairtrawl::execute::{ExecutionOptions, recording};
use pairtrawl::files::{execution_json, read_scene, write_atomically};
use pairtrawl::model::{Execution, Trial};
use pairtrawl::report::mcap::RECORDING_NAME;
use serde_json::{Value, json};
use std::fmt::Write;

/// `pairtrawl run`: controllers drive a plan in full physics.
pub fn run(arguments: &RunArguments) -> Result<Done, Failure> {
    let loaded = read_scene(&arguments.scene)?;
    let scene = &loaded.scene;
    let plan = given_plan(&loaded, arguments.plan.as_deref())?;
    let folder = &arguments.output;
    create_folder(folder)?;
    let options = options(arguments);
    let trials = Trials::new(options.trials, "driving");
    let execution =
        interrupt::gracefully(|| pairtrawl::execute::execute(scene, &plan, &options, &trials));
    trials.finish();
    let execution = execution.map_err(|error| Failure::new(Exit::BadInput, error.to_string()))?;

    let mut summary = pairtrawl::summarize(scene, &plan, &[], None);
    summary.execution = Some(pairtrawl::summarize_execution(scene, &execution));
    let file = execution_json(&execution, &options, &loaded.reference);
    let object: Value = serde_json::from_str(&file).map_err(|error| {
        Failure::new(
            Exit::Internal,
            format!("execution.json is no JSON: {error}"),
        )
    })?;
    let mut contents = vec![
        ("execution.json", file.into_bytes()),
        (
            "report.html",
            pairtrawl::report::report_html(&summary).into_bytes(),
        ),
    ];
    if let Some(first) = execution.trials.first() {
        let bag = recording(
            scene,
            plan.net_length,
            &plan.trajectory,
            &plan.times(),
            first,
        )
        .map_err(|error| Failure::new(Exit::Internal, error.to_string()))?;
        contents.push((RECORDING_NAME, bag.mcap));
        contents.push(("metadata.yaml", bag.metadata.into_bytes()));
    }
    let files: Vec<_> = contents.iter().map(|(name, _)| folder.join(name)).collect();
    interrupt::while_writing(|| {
        files
            .iter()
            .zip(&contents)
            .try_for_each(|(path, (_, bytes))| write_atomically(path, bytes))
    })?;

    let mut warnings = loaded.warnings.clone();
    warnings.extend(unproven(&plan));
    warnings.extend(execution.warnings.iter().cloned());
    let mut text = execution_text(&scene.name, &execution);
    output::warnings(&mut text, &warnings);
    let _ = writeln!(text, "wrote {}", list(&files));
    let object = json!({
        "command": "run",
        "scene": scene.name,
        "controller": execution.controller.name(),
        "interrupted": execution.interrupted,
        "summary": object["summary"],
        "warnings": warnings,
        "files": files.iter().map(|file| file.display().to_string()).collect::<Value>(),
    });
    let exit = match &execution {
        stopped if stopped.interrupted => Exit::Interrupted,
        complete if complete.gathered_everything() => Exit::Done,
        _ => Exit::NotGathered,
    };
    Ok(Done { exit, text, object })
}

fn options(arguments: &RunArguments) -> ExecutionOptions {
    let mut options = ExecutionOptions {
        controller: arguments.controller.into(),
        trials: arguments.trials as usize,
        seed: arguments.seed,
        object_mass: arguments.object_mass,
        payload: arguments.payload,
        ..ExecutionOptions::default()
    };
    let given = [
        (&mut options.robot_mass, arguments.robot_mass),
        (&mut options.robot_inertia, arguments.robot_inertia),
        (&mut options.friction, arguments.friction),
        (&mut options.pose_delay, arguments.delay),
    ];
    for (option, value) in given {
        *option = value.unwrap_or(*option);
    }
    let sensing = &mut options.sensing;
    sensing.position_noise = arguments.position_noise.unwrap_or(sensing.position_noise);
    sensing.heading_noise = arguments.heading_noise.unwrap_or(sensing.heading_noise);
    if arguments.quick {
        options.physics = pairtrawl::simulation::Options::quick();
    }
    options
}

fn execution_text(name: &str, execution: &Execution) -> String {
    let mut text = String::new();
    let complete = execution
        .trials
        .iter()
        .filter(|trial| trial.gathered_everything())
        .count();
    let _ = writeln!(
        text,
        "{name}: {} gathered everything in {complete} of {} trials{}",
        execution.controller.name(),
        execution.trials.len(),
        if execution.interrupted {
            " (INTERRUPTED)"
        } else {
            ""
        }
    );
    let _ = writeln!(
        text,
        "  {:>5} {:>9} {:>12} {:>12} {:>11} {:>8}  first event",
        "trial", "gathered", "rms error m", "max error m", "mean drag N", "J"
    );
    for trial in &execution.trials {
        let _ = writeln!(text, "{}", trial_text(trial));
    }
    text
}

fn trial_text(trial: &Trial) -> String {
    let [left, right] = &trial.tracking;
    let event = trial.events.first().map_or_else(
        || "none".to_owned(),
        |event| format!("{} at {:.1} s", event.kind.describe(), event.time),
    );
    format!(
        "  {:>5} {:>6}/{:<2} {:>12.4} {:>12.4} {:>11.2} {:>8.0}  {event}",
        trial.index,
        trial.gathered_count(),
        trial.gathered.len(),
        left.settled_rms.max(right.settled_rms),
        left.settled_max.max(right.settled_max),
        trial.drag[0].mean.max(trial.drag[1].mean),
        trial.cost.total(),
    )
}
