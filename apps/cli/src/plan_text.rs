//! A finished summary as text for the terminal.

use pairtrawl::model::numbers::{cost, duration, index_list, length, place, quantity, residual};
use pairtrawl::model::{ClaimSummary, LeftOut, LeftWhy, Rehearsal, Summary};
use std::fmt::Write;

/// How many of the tightest claims the terminal shows.
const TIGHTEST: usize = 6;
/// Below this margin, in its own unit, a claim counts as exhausted.
const AT_LIMIT: f64 = 2e-4;
/// Reasons for objects that are left are told for this many of them.
const MOST_REASONS: usize = 6;

/// The short summary that follows planning, what went wrong first.
pub fn plan_text(summary: &Summary) -> String {
    let mut text = String::new();
    let _ = writeln!(
        text,
        "{}: certified plan, {} claims hold{}",
        summary.title,
        summary.claims.len(),
        match &summary.rehearsal {
            Rehearsal::Failed { .. } => ", but the REHEARSAL FAILED",
            Rehearsal::Passed | Rehearsal::Skipped => "",
        }
    );
    let chosen = if summary.net_length_chosen {
        " (chosen by the planner)"
    } else {
        ""
    };
    let j = &summary.cost;
    text.push_str(&left_text(summary));
    let lines = [
        ("rehearsal", rehearsal_text(&summary.rehearsal)),
        ("net", format!("{}{chosen}", length(summary.net_length))),
        (
            "paths",
            format!(
                "{} left, {} right, {} waypoints",
                length(summary.left_length),
                length(summary.right_length),
                summary.trajectory.len()
            ),
        ),
        ("drive", duration(summary.duration)),
        (
            "cost J",
            format!(
                "{} = smoothness {} + distance {} + obstacles {} + expansion {}",
                cost(j.total()),
                cost(j.smoothness),
                cost(j.distance),
                cost(j.obstacle),
                cost(j.expansion)
            ),
        ),
        (
            "solver",
            format!(
                "{}, {} iterations, KKT error {}",
                summary.solver.status.name(),
                summary.solver.iterations,
                residual(summary.solver.kkt_error)
            ),
        ),
    ];
    for (name, value) in lines {
        let _ = writeln!(text, "  {name:<10} {value}");
    }
    let exhausted: Vec<_> = (summary.claims.iter())
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
        let stages: Vec<String> = (summary.stages.iter())
            .map(|stage| format!("{} {}", stage.name, duration(stage.seconds)))
            .collect();
        let _ = writeln!(text, "  took       {}", stages.join(", "));
    }
    text
}

/// What is gathered and what is left, each object with its reason; nothing where everything is gathered.
fn left_text(summary: &Summary) -> String {
    let left = &summary.left_out;
    let mut text = left_summary(left, summary.outline.objects.len());
    for left in left.iter().take(MOST_REASONS) {
        let _ = writeln!(text, "    {}", left.text);
    }
    if left.len() > MOST_REASONS {
        let _ = writeln!(
            text,
            "    and {} more, each with its reason in plan.json and report.html",
            left.len() - MOST_REASONS
        );
    }
    text
}

/// How many of the scene's objects are gathered, and which are left on what grounds; nothing where none is left.
pub fn left_summary(left: &[LeftOut], objects: usize) -> String {
    if left.is_empty() {
        return String::new();
    }
    let mut text = format!(
        "  gathers    {} of {objects} objects, {} LEFT\n",
        objects.saturating_sub(left.len()),
        left.len()
    );
    for why in LeftWhy::ALL {
        let of_kind = left.iter().filter(|l| l.why == why).map(|l| l.object);
        let of_kind: Vec<usize> = of_kind.collect();
        if !of_kind.is_empty() {
            let _ = writeln!(text, "    {}: {}", why.describe(), index_list(&of_kind));
        }
    }
    text
}

/// A claim on one line: name, verdict, margin, where and when.
pub fn claim_text(summary: &ClaimSummary) -> String {
    let claim = &summary.claim;
    let verdict = if claim.holds { "holds" } else { "FAILS" };
    let mut line = format!("{:<25} {verdict}", claim.id);
    if claim.margin.is_finite() {
        let _ = write!(
            line,
            "  margin {:>12}",
            quantity(claim.margin, summary.unit)
        );
    }
    if let Some(step) = claim.step {
        let _ = write!(line, "  step {step}");
    }
    if let Some(time) = summary.time {
        let _ = write!(line, ", {}", duration(time));
    }
    if let Some(where_) = claim.place {
        let _ = write!(line, "  at {}", place(where_));
    }
    if !claim.detail.is_empty() {
        let _ = write!(line, "  {}", claim.detail);
    }
    line.trim_end().to_owned()
}

/// A rehearsal's verdict for people.
pub fn rehearsal_text(rehearsal: &Rehearsal) -> String {
    match rehearsal {
        Rehearsal::Passed => "passed".to_owned(),
        Rehearsal::Skipped => "skipped".to_owned(),
        Rehearsal::Failed {
            event,
            time,
            place: at,
        } => format!(
            "FAILED: {event}, after {}, at {}",
            duration(*time),
            place(*at)
        ),
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
