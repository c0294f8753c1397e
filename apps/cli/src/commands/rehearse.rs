use super::planning::{create_folder, list};
use crate::arguments::RehearseArguments;
use crate::exit::{Exit, Failure};
use crate::interrupt;
use crate::output::{self, Done};
use crate::progress::Progress;
use crate::summary_text::{rehearsal_json, rehearsal_text};
use pairtrawl::files::{read_plan, read_scene, write_atomically};
use pairtrawl::model::{Rehearsal, RehearsalRecord};
use pairtrawl::simulation::Options;
use serde_json::{Value, json};
use std::fmt::Write;

/// `pairtrawl rehearse`: what happens when a plan is driven in physics.
pub fn rehearse(arguments: &RehearseArguments) -> Result<Done, Failure> {
    let loaded = read_scene(&arguments.scene)?;
    let file = read_plan(&arguments.plan)?;
    if let Some(folder) = &arguments.output {
        create_folder(folder)?;
    }
    let options = if arguments.quick {
        Options::quick()
    } else {
        Options::default()
    };
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

    let mut files = Vec::new();
    if let Some(folder) = &arguments.output {
        let summary = pairtrawl::summarize(&loaded.scene, &rehearsed.plan, &[], Some(record));
        let path = folder.join("report.html");
        let page = pairtrawl::report::report_html(&summary);
        interrupt::while_writing(|| write_atomically(&path, page.as_bytes()))?;
        files.push(path);
    }

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
    output::warnings(&mut text, &warnings);
    if !files.is_empty() {
        let _ = writeln!(text, "wrote {}", list(&files));
    }
    let mut object = record_json(record);
    object["command"] = json!("rehearse");
    object["scene"] = json!(loaded.scene.name);
    object["certificate_valid"] = json!(valid);
    object["warnings"] = json!(warnings);
    object["files"] = files
        .iter()
        .map(|file| file.display().to_string())
        .collect();
    let exit = if record.verdict == Rehearsal::Passed {
        Exit::Done
    } else {
        Exit::NotGathered
    };
    Ok(Done { exit, text, object })
}

fn record_text(name: &str, record: &RehearsalRecord) -> String {
    let mut text = String::new();
    let home = record.gathered.iter().filter(|gathered| **gathered).count();
    let [left, right] = record.max_tension;
    let [left_off, right_off] = record.max_deviation;
    let [left_force, right_force] = record.mean_drive_force;
    let _ = writeln!(
        text,
        "{name}: rehearsal {}",
        rehearsal_text(&record.verdict)
    );
    let _ = writeln!(
        text,
        "  gathered   {home} of {} objects",
        record.gathered.len()
    );
    let _ = writeln!(
        text,
        "  tension    at most {left:.2} N left, {right:.2} N right"
    );
    let _ = writeln!(
        text,
        "  drive      {left_force:.2} N left, {right_force:.2} N right on average"
    );
    let _ = writeln!(
        text,
        "  off path   at most {left_off:.4} m left, {right_off:.4} m right"
    );
    let _ = writeln!(text, "  simulated  {:.1} s", record.duration);
    for event in &record.events {
        let (time, place) = (event.time, event.place);
        let _ = writeln!(
            text,
            "  {time:>7.2} s  at ({:.3}, {:.3})  {}",
            place.x,
            place.y,
            event.kind.describe()
        );
    }
    text
}

fn record_json(record: &RehearsalRecord) -> Value {
    json!({
        "rehearsal": rehearsal_json(&record.verdict),
        "gathered": record.gathered,
        "max_tension": record.max_tension,
        "max_deviation": record.max_deviation,
        "mean_drive_force": record.mean_drive_force,
        "duration": record.duration,
        "events": record.events.iter().map(|event| json!({
            "event": event.kind.describe(),
            "time": event.time,
            "where": <[f64; 2]>::from(event.place),
        })).collect::<Vec<_>>(),
    })
}
