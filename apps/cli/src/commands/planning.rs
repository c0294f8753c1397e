//! What `plan` and `demo` share: planning with progress, then the files and the summary.

use crate::arguments::PlanningArguments;
use crate::exit::{Exit, Failure};
use crate::interrupt;
use crate::output::{self, Done};
use crate::progress::Progress;
use crate::summary_text;
use pairtrawl::PlanError;
use pairtrawl::files::{self, LoadedScene};
use pairtrawl::model::{Plan, Scene, Side, Summary, Warning};
use pairtrawl::reference::Reference;
use serde_json::json;
use std::path::{Path, PathBuf};

/// Plans a scene and writes everything about the plan to a folder.
pub fn plan_into(
    command: &str,
    loaded: &LoadedScene,
    planning: &PlanningArguments,
    folder: &Path,
) -> Result<Done, Failure> {
    let created = create_folder(folder)?;
    let written = plan_and_write(command, loaded, planning, folder);
    if written.is_err() && created {
        // Only succeeds while it is empty; a folder that stays behind does no harm.
        let _ = std::fs::remove_dir(folder);
    }
    written
}

fn plan_and_write(
    command: &str,
    loaded: &LoadedScene,
    planning: &PlanningArguments,
    folder: &Path,
) -> Result<Done, Failure> {
    let mut progress = Progress::new();
    let planned = pairtrawl::plan(
        &loaded.scene,
        &loaded.reference,
        &planning.options(),
        &mut progress,
    );
    progress.finish();
    let mut planned = planned.map_err(Failure::from)?;
    planned
        .plan
        .warnings
        .splice(0..0, loaded.warnings.iter().cloned().map(Warning::Stated));
    let summary = pairtrawl::summarize(
        &loaded.scene,
        &planned.plan,
        &planned.stages,
        planned.rehearsal.as_ref(),
    );
    let files = interrupt::while_writing(|| write(folder, &loaded.scene, &planned.plan, &summary))?;

    let mut text = summary_text::plan_text(&summary);
    output::warnings(&mut text, &summary.warnings);
    text.push_str(&format!("wrote {}\n", list(&files)));
    let mut object = summary_text::plan_json(&summary);
    object["command"] = json!(command);
    object["files"] = files
        .iter()
        .map(|file| file.display().to_string())
        .collect();
    Ok(Done {
        exit: Exit::Done,
        text,
        object,
    })
}

/// Makes sure that the folder is there; true when it was not.
pub fn create_folder(folder: &Path) -> Result<bool, Failure> {
    let missing = !folder.exists();
    std::fs::create_dir_all(folder).map_err(|error| {
        Failure::new(
            Exit::Files,
            format!("cannot create the folder {}: {error}", folder.display()),
        )
        .with_remedy("give a folder that you may write to, with -o")
    })?;
    Ok(missing)
}

/// Writes the plan last: where it stands, everything stands.
fn write(
    folder: &Path,
    scene: &Scene,
    plan: &Plan,
    summary: &Summary,
) -> Result<Vec<PathBuf>, Failure> {
    let file = |name: &str| folder.join(name);
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
    let texts = [
        ("plan.csv", files::csv_text(&driven)),
        ("left.tum", files::tum_text(&driven, Side::Left)),
        ("right.tum", files::tum_text(&driven, Side::Right)),
        ("plan.svg", pairtrawl::report::plan_svg(summary)),
        ("report.html", pairtrawl::report::report_html(summary)),
        ("plan.json", plan_json),
    ];
    for (name, text) in &texts {
        files::write_atomically(&file(name), text.as_bytes())?;
    }
    Ok(texts.iter().map(|(name, _)| file(name)).collect())
}

pub fn list(files: &[PathBuf]) -> String {
    files
        .iter()
        .map(|file| file.display().to_string())
        .collect::<Vec<_>>()
        .join(", ")
}

impl From<PlanError> for Failure {
    fn from(error: PlanError) -> Self {
        let exit = match &error {
            PlanError::BadInput { .. } => Exit::BadInput,
            PlanError::Infeasible { .. } => Exit::Infeasible,
            PlanError::NoPlan { .. } | PlanError::TimeLimit { .. } => Exit::NoPlan,
            PlanError::Interrupted => Exit::Interrupted,
        };
        let details = match &error {
            PlanError::NoPlan(missing) => json!({
                "claim": missing.claim().map(|claim| claim.id.name()),
                "step": missing.claim().and_then(|claim| claim.step),
                "where": missing.place().map(<[f64; 2]>::from),
                "margin": missing.claim().map(|claim| claim.margin),
            }),
            PlanError::TimeLimit { limit, stage } => {
                json!({ "limit": limit, "stage": stage.name() })
            }
            _ => serde_json::Value::Null,
        };
        let remedy = error.remedy();
        Self {
            exit,
            message: error.to_string(),
            remedy,
            details,
        }
    }
}

impl From<files::FileError> for Failure {
    fn from(error: files::FileError) -> Self {
        let exit = if error.is_from_system() {
            Exit::Files
        } else {
            Exit::BadInput
        };
        let details = json!({ "file": error.path.display().to_string(), "line": error.line });
        Self {
            details,
            ..Self::new(exit, error.to_string())
        }
    }
}
