//! Facts and verdicts in words.

use pairtrawl_model::{
    Cost, FailedSummary, Rehearsal, SolverReport, SolverStatus, Summary, numbers,
};

/// The facts that head a picture or a page.
pub(crate) fn facts(summary: &Summary) -> String {
    let chosen = match summary.net_length_chosen {
        true => " (chosen)",
        false => "",
    };
    let left = match summary.left_out.len() {
        0 => String::new(),
        left => format!(
            "gathers {} of {} objects, {left} left \u{b7} ",
            summary.gathers(),
            summary.outline.objects.len()
        ),
    };
    format!(
        "{left}net {}{chosen} \u{b7} paths {} and {} \u{b7} {} to drive \u{b7} J {}",
        numbers::length(summary.net_length),
        numbers::length(summary.left_length),
        numbers::length(summary.right_length),
        numbers::duration(summary.duration),
        cost(summary.cost.total()),
    )
}

/// The facts that head the picture of a scene.
pub(crate) fn scene_facts(summary: &Summary) -> String {
    let count = |n: usize, noun: &str| match n {
        1 => format!("1 {noun}"),
        n => format!("{n} {noun}s"),
    };
    let objects = &summary.outline.objects;
    let left = objects.iter().filter(|object| object.leave).count();
    let mut facts = count(objects.len(), "object");
    if left > 0 {
        facts += &format!(", {left} of them out of reach");
    }
    if !summary.circles.is_empty() {
        let circles = count(summary.circles.len(), "circle");
        let ordered = match summary.order.is_empty() {
            true => "",
            false => " in the order of visits",
        };
        facts += &format!(" \u{b7} {circles}{ordered}");
    }
    if summary.net_length.is_finite() {
        facts += &format!(" \u{b7} net {}", numbers::length(summary.net_length));
    }
    facts
}

/// What a picture or page says at its head when there is no plan.
pub(crate) fn no_plan(failed: &FailedSummary) -> String {
    let attempt = match failed.summary.trajectory.is_empty() {
        true => "",
        false => "; this is the best attempt",
    };
    format!("NOT A PLAN: {}{attempt}", failed.verdict)
}

/// A number's text with a true minus sign.
pub(crate) fn typeset(number: &str) -> String {
    number.replace('-', "\u{2212}")
}

/// A cost with a thin space between thousands.
pub(crate) fn cost(value: f64) -> String {
    let text = typeset(&numbers::cost(value));
    let whole = text.split(['.', 'e']).next().unwrap_or(&text);
    let digits = whole.chars().filter(char::is_ascii_digit).count();
    let mut out = String::new();
    let mut left = digits;
    for (i, c) in text.char_indices() {
        if i < whole.len() && c.is_ascii_digit() {
            if left < digits && left.is_multiple_of(3) {
                out.push('\u{202f}');
            }
            left -= 1;
        }
        out.push(c);
    }
    out
}

/// The terms of J with their symbols.
pub(crate) fn terms(cost: &Cost) -> [(&'static str, &'static str, f64); 4] {
    [
        ("J_s", "smoothness", cost.smoothness),
        ("J_dist", "distance and turning", cost.distance),
        ("J_obs", "obstacles and objects", cost.obstacle),
        ("J_e", "expansion of the net", cost.expansion),
    ]
}

/// The objects in the order in which their circles are visited: `1: object 4 → 2: objects 0, 3`. Empty without an order.
pub(crate) fn visits(summary: &Summary) -> String {
    let circles = summary.order.iter().filter_map(|i| summary.circles.get(*i));
    let visits = circles.enumerate().map(|(i, circle)| {
        let list: Vec<String> = circle.objects.iter().map(usize::to_string).collect();
        let noun = if list.len() == 1 { "object" } else { "objects" };
        format!("{}: {noun} {}", i + 1, list.join(", "))
    });
    visits.collect::<Vec<_>>().join(" \u{2192} ")
}

/// How the optimizer ended.
pub(crate) fn solver(solver: &SolverReport) -> String {
    let status = solver.status.name().replace('_', " ");
    if solver.status == SolverStatus::NotStated {
        return status;
    }
    let mut words = format!("{status} after {} iterations", solver.iterations);
    if solver.kkt_error.is_finite() {
        words += &format!(", KKT error {}", numbers::residual(solver.kkt_error));
    }
    if solver.seconds.is_finite() {
        words += &format!(", {}", numbers::duration(solver.seconds));
    }
    words
}

/// What the rehearsal said.
pub(crate) fn rehearsal(summary: &Summary) -> String {
    match &summary.rehearsal {
        Rehearsal::Passed if summary.left_out.is_empty() => {
            "passed: nothing was touched and every object came home".to_owned()
        }
        Rehearsal::Passed => {
            "passed: nothing was touched and every object that is not left came home".to_owned()
        }
        Rehearsal::Failed { event, time, place } => {
            let (time, place) = (numbers::duration(*time), numbers::place(*place));
            format!("failed after {time} at {place}: {event}")
        }
        Rehearsal::Skipped => no_rehearsal(summary).to_owned(),
    }
}

/// Why there is no verdict of a rehearsal: of a plan that does not even name its solver nothing is known.
pub(crate) fn no_rehearsal(summary: &Summary) -> &'static str {
    match summary.solver.status {
        SolverStatus::NotStated => "rehearsal not stated",
        _ => "not rehearsed",
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn thousands_are_kept_apart() {
        assert_eq!(cost(5588.04), "5\u{202f}588.0");
        assert_eq!(cost(1_234_567.0), "1\u{202f}234\u{202f}567.0");
        assert_eq!(cost(-112.34), "\u{2212}112.3");
        assert_eq!(cost(0.0), "0");
        assert_eq!(cost(2.5e12), "2.500e12");
        assert_eq!(cost(f64::NAN), "\u{2013}");
    }

    #[test]
    fn what_is_not_known_is_not_made_up() {
        let unknown = SolverReport {
            status: SolverStatus::NotStated,
            iterations: 0,
            kkt_error: f64::NAN,
            seconds: 0.0,
        };
        assert_eq!(solver(&unknown), "not stated");
        let known = SolverReport {
            status: SolverStatus::Converged,
            iterations: 31,
            ..unknown
        };
        assert_eq!(solver(&known), "converged after 31 iterations, 0 s");
    }
}
