use super::FORMAT;
use crate::files::{FileError, write_atomically};
use pairtrawl_geometry::Pose;
use pairtrawl_model::{Certificate, Plan, Rehearsal, SolverStatus};
use serde::Serialize;
use std::path::Path;

/// Writes `plan.json`, every field of the format, atomically.
///
/// # Errors
/// When the system refuses (exit code 8).
pub fn write_plan(path: &Path, plan: &Plan) -> Result<(), FileError> {
    let text =
        plan_json(plan).map_err(|e| FileError::system(path, "write the plan as JSON", e.into()))?;
    write_atomically(path, text.as_bytes())
}

/// The plan as one JSON object, a line for each field, with a line end. Numbers are the shortest that read back as the
/// same bits; a margin without bound (no obstacle to keep clear of) is null.
///
/// # Errors
/// Never for a plan that fits into memory; the JSON library wants it.
pub fn plan_json(plan: &Plan) -> Result<String, serde_json::Error> {
    let mut text = String::from("{\n");
    let fields: [(&str, String); 16] = [
        ("format", json(&FORMAT)?),
        ("net_length", json(&plan.net_length)?),
        ("left", poses(&plan.trajectory.left)?),
        ("right", poses(&plan.trajectory.right)?),
        ("step_time", json(&plan.trajectory.step_time)?),
        ("time_law", json(&plan.time_law)?),
        (
            "scene",
            json(&Reference {
                name: &plan.scene.name,
                sha256: &plan.scene.sha256,
            })?,
        ),
        (
            "overrides",
            json(&Overrides {
                net_length: plan.overrides.net_length.map(net_length),
            })?,
        ),
        ("centerline", poses(&plan.centerline)?),
        (
            "baseline",
            format!(
                "{{\"left\": {}, \"right\": {}}}",
                poses(&plan.baseline.left)?,
                poses(&plan.baseline.right)?
            ),
        ),
        ("circles", json(&circles(plan))?),
        ("order", json(&plan.order)?),
        ("cost", json(&cost(plan))?),
        ("certificate", json(&certificate(&plan.certificate))?),
        ("rehearsal", json(&rehearsal(&plan.rehearsal))?),
        ("solver", json(&solver(plan))?),
    ];
    for (name, value) in &fields {
        text += &format!("  \"{name}\": {value},\n");
    }
    text += &format!("  \"warnings\": {}\n}}\n", json(&plan.warnings)?);
    Ok(text)
}

fn json(value: &impl Serialize) -> Result<String, serde_json::Error> {
    serde_json::to_string(value)
}

fn poses(poses: &[Pose]) -> Result<String, serde_json::Error> {
    json(
        &poses
            .iter()
            .map(|&p| <[f64; 3]>::from(p))
            .collect::<Vec<_>>(),
    )
}

#[derive(Serialize)]
struct Reference<'a> {
    name: &'a str,
    sha256: &'a str,
}

#[derive(Serialize)]
struct Overrides {
    #[serde(skip_serializing_if = "Option::is_none")]
    net_length: Option<NetLength>,
}

#[derive(Serialize)]
#[serde(untagged)]
enum NetLength {
    Fixed(f64),
    Auto(&'static str),
}

fn net_length(choice: Option<f64>) -> NetLength {
    choice.map_or(NetLength::Auto("auto"), NetLength::Fixed)
}

#[derive(Serialize)]
struct FileCircle<'a> {
    center: [f64; 2],
    radius: f64,
    objects: &'a [usize],
}

fn circles(plan: &Plan) -> Vec<FileCircle<'_>> {
    plan.circles
        .iter()
        .map(|c| FileCircle {
            center: c.center.into(),
            radius: c.radius,
            objects: &c.objects,
        })
        .collect()
}

#[derive(Serialize)]
struct FileCost {
    total: f64,
    smoothness: f64,
    distance: f64,
    obstacle: f64,
    expansion: f64,
}

fn cost(plan: &Plan) -> FileCost {
    let c = plan.cost;
    FileCost {
        total: c.total(),
        smoothness: c.smoothness,
        distance: c.distance,
        obstacle: c.obstacle,
        expansion: c.expansion,
    }
}

#[derive(Serialize)]
struct FileCertificate<'a> {
    valid: bool,
    claims: Vec<FileClaim<'a>>,
}

#[derive(Serialize)]
struct FileClaim<'a> {
    name: &'a str,
    holds: bool,
    margin: f64,
    step: Option<usize>,
    #[serde(rename = "where")]
    place: Option<[f64; 2]>,
    #[serde(skip_serializing_if = "str::is_empty")]
    detail: &'a str,
}

fn certificate(certificate: &Certificate) -> FileCertificate<'_> {
    FileCertificate {
        valid: certificate.is_valid(),
        claims: (certificate.claims.iter())
            .map(|c| FileClaim {
                name: c.id.name(),
                holds: c.holds,
                margin: c.margin,
                step: c.step,
                place: c.place.map(Into::into),
                detail: &c.detail,
            })
            .collect(),
    }
}

#[derive(Serialize)]
#[serde(tag = "status", rename_all = "lowercase")]
enum FileRehearsal<'a> {
    Passed,
    Failed {
        event: &'a str,
        time: f64,
        #[serde(rename = "where")]
        place: [f64; 2],
    },
    Skipped,
}

fn rehearsal(rehearsal: &Rehearsal) -> FileRehearsal<'_> {
    match rehearsal {
        Rehearsal::Passed => FileRehearsal::Passed,
        Rehearsal::Failed { event, time, place } => FileRehearsal::Failed {
            event,
            time: *time,
            place: (*place).into(),
        },
        Rehearsal::Skipped => FileRehearsal::Skipped,
    }
}

#[derive(Serialize)]
struct FileSolver {
    status: &'static str,
    iterations: usize,
    kkt_error: f64,
    seconds: f64,
}

fn solver(plan: &Plan) -> FileSolver {
    let s = &plan.solver;
    let status = match s.status {
        SolverStatus::Converged => "converged",
        SolverStatus::LocallyInfeasible => "locally_infeasible",
        SolverStatus::IterationLimit => "iteration_limit",
        SolverStatus::TimeLimit => "time_limit",
        SolverStatus::NumericalTrouble => "numerical_trouble",
        SolverStatus::NotStated => "not_stated",
    };
    FileSolver {
        status,
        iterations: s.iterations,
        kkt_error: s.kkt_error,
        seconds: s.seconds,
    }
}
