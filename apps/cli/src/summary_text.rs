//! A finished summary as text for the terminal, and the same numbers as an object for machines.

use pairtrawl::model::{ClaimSummary, Rehearsal, SolverStatus, Summary};
use serde_json::{Value, json};
use std::fmt::Write;

/// How many of the tightest claims the terminal shows.
const TIGHTEST: usize = 6;
/// Below this margin, in its own unit, a claim counts as exhausted.
const AT_LIMIT: f64 = 2e-4;

/// The short summary that follows planning.
pub fn plan_text(summary: &Summary) -> String {
    let mut text = String::new();
    let chosen = if summary.net_length_chosen {
        " (chosen by the planner)"
    } else {
        ""
    };
    let cost = &summary.cost;
    let lines = [
        ("net", format!("{:.3} m{chosen}", summary.net_length)),
        (
            "paths",
            format!(
                "{:.2} m left, {:.2} m right, {} waypoints",
                summary.left_length,
                summary.right_length,
                summary.trajectory.len()
            ),
        ),
        ("drive", format!("{:.1} s", summary.duration)),
        (
            "cost J",
            format!(
                "{:.1} = smoothness {:.1} + distance {:.1} + obstacles {:.1} + expansion {:.1}",
                cost.total(),
                cost.smoothness,
                cost.distance,
                cost.obstacle,
                cost.expansion
            ),
        ),
        ("rehearsal", rehearsal_text(&summary.rehearsal)),
        (
            "solver",
            format!(
                "{}, {} iterations, KKT error {:.1e}",
                status_name(summary.solver.status),
                summary.solver.iterations,
                summary.solver.kkt_error
            ),
        ),
    ];
    let _ = writeln!(
        text,
        "{}: certified plan, {} claims hold",
        summary.title,
        summary.claims.len()
    );
    for (name, value) in lines {
        let _ = writeln!(text, "  {name:<10} {value}");
    }
    let exhausted: Vec<_> = summary
        .claims
        .iter()
        .filter(|claim| claim.claim.place.is_some() && at_limit(claim))
        .map(|claim| claim.claim.id.name())
        .collect();
    if !exhausted.is_empty() {
        let _ = writeln!(text, "  at limit   {}", exhausted.join(", "));
    }
    let _ = writeln!(text, "  tightest claims");
    for claim in tightest(&summary.claims) {
        let _ = writeln!(text, "    {}", claim_text(claim));
    }
    if !summary.stages.is_empty() {
        let stages: Vec<String> = summary
            .stages
            .iter()
            .map(|stage| format!("{} {:.3}", stage.name, stage.seconds))
            .collect();
        let _ = writeln!(text, "  seconds    {}", stages.join(", "));
    }
    text
}

/// A claim on one line: name, margin, where and when.
pub fn claim_text(summary: &ClaimSummary) -> String {
    let claim = &summary.claim;
    let mut line = format!(
        "{:<25} {}",
        claim.id,
        if claim.holds { "holds" } else { "FAILS" }
    );
    if claim.margin.is_finite() {
        let _ = write!(line, "  margin {:>10.6} {:<5}", claim.margin, summary.unit);
    }
    if let Some(step) = claim.step {
        let _ = write!(line, "  step {step}");
    }
    if let Some(time) = summary.time {
        let _ = write!(line, ", {time:.2} s");
    }
    if let Some(place) = claim.place {
        let _ = write!(line, "  at ({:.3}, {:.3})", place.x, place.y);
    }
    if !claim.detail.is_empty() {
        let _ = write!(line, "  {}", claim.detail);
    }
    line.trim_end().to_owned()
}

/// The summary's numbers for machines.
pub fn plan_json(summary: &Summary) -> Value {
    json!({
        "scene": summary.title,
        "net_length": summary.net_length,
        "net_length_chosen": summary.net_length_chosen,
        "waypoints": summary.trajectory.len(),
        "step_time": summary.trajectory.step_time,
        "left_length": summary.left_length,
        "right_length": summary.right_length,
        "duration": summary.duration,
        "cost": {
            "total": summary.cost.total(),
            "smoothness": summary.cost.smoothness,
            "distance": summary.cost.distance,
            "obstacle": summary.cost.obstacle,
            "expansion": summary.cost.expansion,
        },
        "claims": summary.claims.iter().map(claim_json).collect::<Vec<_>>(),
        "rehearsal": rehearsal_json(&summary.rehearsal),
        "solver": {
            "status": status_name(summary.solver.status),
            "iterations": summary.solver.iterations,
            "kkt_error": number(summary.solver.kkt_error),
        },
        "seconds": summary.stages.iter().map(|stage| (stage.name.clone(), json!(stage.seconds))).collect::<serde_json::Map<_, _>>(),
        "warnings": summary.warnings.iter().map(ToString::to_string).collect::<Vec<_>>(),
    })
}

/// A claim for machines.
pub fn claim_json(summary: &ClaimSummary) -> Value {
    let claim = &summary.claim;
    json!({
        "name": claim.id.name(),
        "holds": claim.holds,
        "margin": number(claim.margin),
        "unit": summary.unit,
        "step": claim.step,
        "time": summary.time,
        "where": claim.place.map(<[f64; 2]>::from),
        "detail": claim.detail,
    })
}

/// A rehearsal's verdict for machines.
pub fn rehearsal_json(rehearsal: &Rehearsal) -> Value {
    match rehearsal {
        Rehearsal::Passed => json!({ "status": "passed" }),
        Rehearsal::Skipped => json!({ "status": "skipped" }),
        Rehearsal::Failed { event, time, place } => {
            json!({ "status": "failed", "event": event, "time": time, "where": <[f64; 2]>::from(*place) })
        }
    }
}

/// A rehearsal's verdict for people.
pub fn rehearsal_text(rehearsal: &Rehearsal) -> String {
    match rehearsal {
        Rehearsal::Passed => "passed".to_owned(),
        Rehearsal::Skipped => "skipped".to_owned(),
        Rehearsal::Failed { event, time, place } => {
            format!(
                "FAILED: {event}, {time:.1} s, at ({:.3}, {:.3})",
                place.x, place.y
            )
        }
    }
}

/// The solver's status as files and people call it.
pub fn status_name(status: SolverStatus) -> &'static str {
    match status {
        SolverStatus::Converged => "converged",
        SolverStatus::LocallyInfeasible => "locally_infeasible",
        SolverStatus::IterationLimit => "iteration_limit",
        SolverStatus::TimeLimit => "time_limit",
        SolverStatus::NumericalTrouble => "numerical_trouble",
        SolverStatus::NotStated => "not_stated",
    }
}

/// JSON knows no infinity and no NaN: null.
fn number(value: f64) -> Value {
    if value.is_finite() {
        json!(value)
    } else {
        Value::Null
    }
}

/// Claims that say how much room there is, the one with the least margin first.
fn tightest(claims: &[ClaimSummary]) -> Vec<&ClaimSummary> {
    let mut placed: Vec<_> = claims
        .iter()
        .filter(|summary| summary.claim.place.is_some() && !at_limit(summary))
        .collect();
    placed.sort_by(|a, b| a.claim.margin.total_cmp(&b.claim.margin));
    placed.truncate(TIGHTEST);
    placed
}

/// Claims that a good plan exhausts or whose whole bound is a tolerance: there is nothing to see in their margins.
fn at_limit(summary: &ClaimSummary) -> bool {
    summary.claim.holds && summary.claim.margin.abs() < AT_LIMIT
}
