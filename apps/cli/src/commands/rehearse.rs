use super::with_scene;
use crate::arguments::RehearseArguments;
use crate::exit::Exit;
use crate::failure::Failure;
use crate::objects::{LeftOutObject, RehearsalObject};
use crate::output::{Done, Report};
use crate::plan_text::rehearsal_text;
use crate::progress::Progress;
use crate::results::{Results, in_folder};
use pairtrawl::Rehearsed;
use pairtrawl::files::{LoadedScene, read_plan};
use pairtrawl::model::numbers::{duration, length, place, quantity};
use pairtrawl::model::{Rehearsal, RehearsalRecord};
#[cfg(not(feature = "rapier"))]
use pairtrawl::simulation::Options;
use schemars::JsonSchema;
use serde::Serialize;
use std::fmt::Write;

/// What happened when a plan was driven in physics. Pairs are the left and the right robot's values.
#[derive(Serialize, JsonSchema)]
pub struct RehearseReport {
    /// The verdict.
    rehearsal: RehearsalObject,
    /// For each object of the scene: true when it lies in the net at the end.
    gathered: Vec<bool>,
    /// Objects that the plan leaves where they are, ascending: they do not count.
    left_out: Vec<LeftOutObject>,
    /// Greatest tension at the hitches, N.
    max_tension: [f64; 2],
    /// Greatest distance from the plan, m.
    max_deviation: [f64; 2],
    /// Mean force that drives the robots, N.
    mean_drive_force: [f64; 2],
    /// Simulated time, s.
    duration: f64,
    /// What should not have happened and did, in order of time.
    events: Vec<EventObject>,
    /// True when every claim of the plan's certificate holds.
    certificate_valid: bool,
}

/// Something that should not have happened.
#[derive(Serialize, JsonSchema)]
struct EventObject {
    /// What, for people.
    event: String,
    /// When, s.
    time: f64,
    /// Where, m.
    #[serde(rename = "where")]
    place: [f64; 2],
}

/// `pairtrawl rehearse`: what happens when a plan is driven in physics.
pub fn rehearse(arguments: &RehearseArguments) -> Result<Done, Failure> {
    let work = |results: Option<&Results<'_>>| {
        with_scene(&arguments.scene, &|loaded| {
            rehearse_in(loaded, arguments, results)
        })
    };
    match &arguments.output {
        Some(folder) => in_folder(folder, &[], |results| work(Some(results))),
        None => work(None),
    }
}

fn rehearse_in(
    loaded: &LoadedScene,
    arguments: &RehearseArguments,
    results: Option<&Results<'_>>,
) -> Result<Done, Failure> {
    let file = read_plan(&arguments.plan)?;
    #[cfg(not(feature = "rapier"))]
    let options = if arguments.quick {
        Options::quick()
    } else {
        Options::default()
    };
    #[cfg(feature = "rapier")]
    let options = arguments.engine.options(arguments.quick);
    let progress = Progress::saying("rehearsing in physics");
    let rehearsed = pairtrawl::rehearse(&loaded.scene, &loaded.reference, &file, &options);
    progress.finish();
    let rehearsed = rehearsed.map_err(|error| {
        Failure::new(
            Exit::BadInput,
            format!("{} cannot be rehearsed: {error}", arguments.plan.display()),
        )
    })?;
    let record = &rehearsed.record;

    let files = match results {
        Some(results) => {
            let summary = pairtrawl::summarize(&loaded.scene, &rehearsed.plan, &[], Some(record));
            results.write(&[("report.html", pairtrawl::report::report_html(&summary))])?
        }
        None => Vec::new(),
    };

    let valid = rehearsed.plan.certificate.is_valid();
    let mut text = record_text(&loaded.scene.name, record);
    let proven = if valid {
        "every claim of the certificate holds"
    } else {
        "the certificate does NOT hold, see check"
    };
    let _ = writeln!(text, "  proven     {proven}");
    let mut warnings = loaded.warnings.clone();
    warnings.extend(record.warnings.iter().cloned());
    let exit = if record.verdict == Rehearsal::Passed {
        Exit::Done
    } else {
        Exit::NotGathered
    };
    Report::new("rehearse", exit, report(&rehearsed, valid))
        .scene(&loaded.scene.name)
        .done(exit, text, &warnings, &files)
}

fn record_text(name: &str, record: &RehearsalRecord) -> String {
    let mut text = String::new();
    let both = |[left, right]: [f64; 2], say: &dyn Fn(f64) -> String| {
        format!("{} left, {} right", say(left), say(right))
    };
    let newtons = |force: f64| quantity(force, "N");
    let lines = [
        (
            "gathered",
            format!(
                "{} of {} objects{}",
                record.gathered_count(),
                record.wanted(),
                match record.left.len() {
                    0 => String::new(),
                    left => format!(", {left} left as planned"),
                }
            ),
        ),
        (
            "tension",
            format!("at most {}", both(record.max_tension, &newtons)),
        ),
        (
            "drive",
            format!("{} on average", both(record.mean_drive_force, &newtons)),
        ),
        (
            "off path",
            format!("at most {}", both(record.max_deviation, &length)),
        ),
        ("simulated", duration(record.duration)),
    ];
    let _ = writeln!(
        text,
        "{name}: rehearsal {}",
        rehearsal_text(&record.verdict)
    );
    for (name, value) in lines {
        let _ = writeln!(text, "  {name:<10} {value}");
    }
    for event in &record.events {
        let _ = writeln!(
            text,
            "  after {}, at {}: {}",
            duration(event.time),
            place(event.place),
            event.kind.describe()
        );
    }
    text
}

fn report(rehearsed: &Rehearsed, certificate_valid: bool) -> RehearseReport {
    let record = &rehearsed.record;
    RehearseReport {
        rehearsal: RehearsalObject::from(&record.verdict),
        gathered: record.gathered.clone(),
        left_out: LeftOutObject::all(&rehearsed.plan.left_out),
        max_tension: record.max_tension,
        max_deviation: record.max_deviation,
        mean_drive_force: record.mean_drive_force,
        duration: record.duration,
        events: (record.events.iter())
            .map(|event| EventObject {
                event: event.kind.describe(),
                time: event.time,
                place: event.place.into(),
            })
            .collect(),
        certificate_valid,
    }
}
