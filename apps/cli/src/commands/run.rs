use super::given_plan::{given_plan, refuse_unproven, unproven};
use super::with_scene;
use crate::arguments::{Adapted, RunArguments};
use crate::exit::Exit;
use crate::failure::Failure;
use crate::interrupt;
use crate::objects::LeftOutObject;
use crate::output::{Done, Report};
use crate::plan_text::left_summary;
use crate::results::{Results, in_folder};
use crate::trials::Trials;
use pairtrawl::execute::{AdaptedParts, ExecutionOptions, LawOptions, recording};
use pairtrawl::files::{ExecutionFigures, LoadedScene, execution_json};
use pairtrawl::model::numbers::{cost, duration, lengths, quantity};
use pairtrawl::model::{Execution, Trial};
use pairtrawl::report::mcap::RECORDING_NAME;
use schemars::JsonSchema;
use serde::Serialize;
use std::fmt::Write;

/// The files of a run, `execution.json` first.
const FILES: &[&str] = &[
    "execution.json",
    "report.html",
    RECORDING_NAME,
    "metadata.yaml",
];

/// What came of the drives.
#[derive(Serialize, JsonSchema)]
pub struct RunReport {
    /// The control law.
    controller: &'static str,
    /// True when it was stopped before all drives were finished.
    interrupted: bool,
    /// Objects that the plan leaves where they are, ascending: no drive is to gather them.
    left_out: Vec<LeftOutObject>,
    /// What came of all finished drives together.
    summary: ExecutionFigures,
}

/// `pairtrawl run`: controllers drive a plan in full physics.
pub fn run(arguments: &RunArguments) -> Result<Done, Failure> {
    in_folder(&arguments.output, FILES, |results| {
        with_scene(&arguments.scene, &|loaded| {
            run_in(loaded, arguments, results)
        })
    })
}

fn run_in(
    loaded: &LoadedScene,
    arguments: &RunArguments,
    results: &Results<'_>,
) -> Result<Done, Failure> {
    let scene = &loaded.scene;
    let plan = given_plan(loaded, arguments.plan.as_deref())?;
    if !arguments.unproven {
        refuse_unproven(&plan)?;
    }
    let options = options(arguments);
    let trials = Trials::new(options.trials, "driving");
    let execution =
        interrupt::gracefully(|| pairtrawl::execute::execute(scene, &plan, &options, &trials));
    trials.finish();
    let execution = execution.map_err(|error| Failure::new(Exit::BadInput, error.to_string()))?;

    let mut summary = pairtrawl::summarize(scene, &plan, &[], None);
    summary.execution = Some(pairtrawl::summarize_execution(scene, &execution));
    let file = execution_json(&execution, &options, &loaded.reference);
    let page = pairtrawl::report::report_html(&summary);
    let mut contents = vec![
        ("report.html", page.into_bytes()),
        ("execution.json", file.into_bytes()),
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
    let files = results.write(&contents)?;

    let mut warnings = loaded.warnings.clone();
    warnings.extend(unproven(&plan));
    warnings.extend(execution.warnings.iter().cloned());
    let exit = match &execution {
        stopped if stopped.interrupted => Exit::Interrupted,
        complete if complete.gathered_everything() => Exit::Done,
        _ => Exit::NotGathered,
    };
    let about = RunReport {
        controller: execution.controller.name(),
        interrupted: execution.interrupted,
        left_out: LeftOutObject::all(&plan.left_out),
        summary: ExecutionFigures::from(&execution),
    };
    Report::new("run", exit, about).scene(&scene.name).done(
        exit,
        execution_text(&scene.name, &execution)
            + &left_summary(&plan.left_out, scene.objects.len()),
        &warnings,
        &files,
    )
}

fn options(arguments: &RunArguments) -> ExecutionOptions {
    let mut options = ExecutionOptions {
        controller: arguments.controller.into(),
        trials: arguments.trials as usize,
        seed: arguments.seed,
        object_mass: arguments.object_mass,
        payload: arguments.payload,
        unproven: arguments.unproven,
        law: law(arguments),
        nominal_inertia: arguments.nominal_inertia.into(),
        ..ExecutionOptions::default()
    };
    let given = [
        (&mut options.robot_mass, arguments.robot_mass),
        (&mut options.robot_inertia, arguments.robot_inertia),
        (&mut options.friction, arguments.friction),
        (&mut options.pose_delay, arguments.delay),
        (&mut options.velocity_delay, arguments.velocity_delay),
    ];
    for (option, value) in given {
        *option = value.unwrap_or(*option);
    }
    let supervisor = &mut options.supervisor;
    supervisor.tracking_error = arguments.stop_error.unwrap_or(supervisor.tracking_error);
    let sensing = &mut options.sensing;
    sensing.position_noise = arguments.position_noise.unwrap_or(sensing.position_noise);
    sensing.heading_noise = arguments.heading_noise.unwrap_or(sensing.heading_noise);
    #[cfg(not(feature = "rapier"))]
    if arguments.quick {
        options.physics = pairtrawl::simulation::Options::quick();
    }
    #[cfg(feature = "rapier")]
    {
        options.physics = arguments.engine.options(arguments.quick);
    }
    options
}

/// What is changed about the law's default gains.
fn law(arguments: &RunArguments) -> LawOptions {
    let default = LawOptions::default();
    let has = |all: &Vec<Adapted>, part| all.contains(&part);
    LawOptions {
        feedback: arguments.feedback.unwrap_or(default.feedback),
        rates: arguments.rates.unwrap_or(default.rates),
        adapts: (arguments.adapt.as_ref()).map_or(default.adapts, |all| AdaptedParts {
            state: has(all, Adapted::State),
            input: has(all, Adapted::Input),
            bias: has(all, Adapted::Bias),
        }),
        torque_limit: arguments.torque_limit,
    }
}

fn execution_text(name: &str, execution: &Execution) -> String {
    let mut text = String::new();
    let trials = &execution.trials;
    let complete = trials.iter().filter(|t| t.gathered_everything()).count();
    let verdict = match execution {
        stopped if stopped.interrupted => "INTERRUPTED: ",
        complete if complete.gathered_everything() => "",
        _ => "FAILED: ",
    };
    let _ = writeln!(
        text,
        "{name}: {verdict}{} gathered everything in {complete} of {} trials",
        execution.controller.name(),
        trials.len(),
    );
    if trials.is_empty() {
        return text;
    }
    let _ = writeln!(
        text,
        "  position errors are those of the worse robot, rms / greatest: over the whole drive, and settled, after its first second"
    );
    if trials.iter().any(Trial::was_stopped) {
        let _ = writeln!(
            text,
            "  J in brackets: of a stopped drive, as far as it came"
        );
    }
    let _ = writeln!(
        text,
        "  {:>5} {:>9} {:>18} {:>18} {:>10} {:>9}  first event",
        "trial", "gathered", "whole drive", "settled", "mean drag", "J"
    );
    // What went wrong comes first.
    let mut ordered: Vec<&Trial> = trials.iter().collect();
    ordered.sort_by_key(|trial| trial.gathered_everything());
    for trial in ordered {
        let _ = writeln!(text, "{}", trial_text(trial));
    }
    text
}

fn trial_text(trial: &Trial) -> String {
    let [left, right] = &trial.tracking;
    let event = trial.events.first().map_or_else(
        || "none".to_owned(),
        |event| format!("{} after {}", event.kind.describe(), duration(event.time)),
    );
    format!(
        "  {:>5} {:>6}/{:<2} {:>18} {:>18} {:>10} {:>9}  {event}",
        trial.index,
        trial.gathered_count(),
        trial.wanted(),
        lengths(&[left.rms.max(right.rms), left.max.max(right.max)]),
        lengths(&[
            left.settled_rms.max(right.settled_rms),
            left.settled_max.max(right.settled_max)
        ]),
        quantity(trial.drag[0].mean.max(trial.drag[1].mean), "N"),
        if trial.was_stopped() {
            // Not to be compared with the J of a plan.
            format!("({})", cost(trial.cost.total()))
        } else {
            cost(trial.cost.total())
        },
    )
}
