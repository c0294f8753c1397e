//! Numbers and verdicts in words.

use pairtrawl_model::{Cost, Rehearsal, SolverStatus, Summary};

/// The facts that head a picture or a page.
pub(crate) fn facts(summary: &Summary) -> String {
    format!(
        "net {:.3} m{} \u{b7} paths {:.2} + {:.2} m \u{b7} {} to drive \u{b7} J {}",
        summary.net_length,
        if summary.net_length_chosen {
            " (chosen)"
        } else {
            ""
        },
        summary.left_length,
        summary.right_length,
        duration(summary.duration),
        cost(summary.cost.total()),
    )
}

/// Seconds as people say them.
pub(crate) fn duration(seconds: f64) -> String {
    match seconds {
        s if !s.is_finite() => "\u{2013}".to_owned(),
        s if s < 0.1 => format!("{:.1} ms", 1e3 * s),
        s if s < 10.0 => format!("{s:.2} s"),
        s if s < 99.95 => format!("{s:.1} s"),
        s => {
            let s = s.round() as u64;
            format!("{} min {:02} s", s / 60, s % 60)
        }
    }
}

/// A cost with a separator between thousands.
pub(crate) fn cost(value: f64) -> String {
    if !value.is_finite() || value.abs() >= 1e9 {
        return format!("{value:.3e}");
    }
    let text = format!("{:.1}", value.abs());
    let (whole, fraction) = text.split_once('.').unwrap_or((&text, "0"));
    let mut out = String::new();
    for (i, digit) in whole.chars().enumerate() {
        if i > 0 && (whole.len() - i).is_multiple_of(3) {
            out.push('\u{202f}');
        }
        out.push(digit);
    }
    let sign = if value < -0.05 { "\u{2212}" } else { "" };
    format!("{sign}{out}.{fraction}")
}

/// A signed margin with its unit, with three significant digits.
pub(crate) fn margin(value: f64, unit: &str) -> String {
    if !value.is_finite() {
        return "\u{2013}".to_owned();
    }
    let size = value.abs();
    let number = match size {
        0.0 => "0".to_owned(),
        s if !(1e-4..1e5).contains(&s) => format!("{s:.1e}"),
        s if s < 1.0 => format!("{s:.4}"),
        s if s < 100.0 => format!("{s:.3}"),
        s => format!("{s:.1}"),
    };
    let sign = if value < 0.0 { "\u{2212}" } else { "" };
    let space = if unit.is_empty() { "" } else { " " };
    format!("{sign}{number}{space}{unit}")
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

/// How the optimizer ended.
pub(crate) fn status(status: SolverStatus) -> &'static str {
    match status {
        SolverStatus::Converged => "converged",
        SolverStatus::LocallyInfeasible => "locally infeasible",
        SolverStatus::IterationLimit => "iteration limit reached",
        SolverStatus::TimeLimit => "time limit reached",
        SolverStatus::NumericalTrouble => "numerical trouble",
        SolverStatus::NotStated => "not stated",
    }
}

/// What the rehearsal said.
pub(crate) fn rehearsal(rehearsal: &Rehearsal) -> String {
    match rehearsal {
        Rehearsal::Passed => "passed: nothing was touched and every object came home".to_owned(),
        Rehearsal::Failed { event, time, place } => {
            format!(
                "failed at {time:.1} s, ({:.2}, {:.2}) m: {event}",
                place.x, place.y
            )
        }
        Rehearsal::Skipped => "not rehearsed".to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_read_well() {
        assert_eq!(cost(5588.04), "5\u{202f}588.0");
        assert_eq!(cost(1_234_567.0), "1\u{202f}234\u{202f}567.0");
        assert_eq!(cost(-12.34), "\u{2212}12.3");
        assert_eq!(cost(0.0), "0.0");
        assert_eq!(margin(0.031_24, "m"), "0.0312 m");
        assert_eq!(margin(-0.5, "rad"), "\u{2212}0.5000 rad");
        assert_eq!(margin(0.0, ""), "0");
        assert_eq!(margin(3e-7, "m"), "3.0e-7 m");
        assert_eq!(duration(0.012), "12.0 ms");
        assert_eq!(duration(81.34), "81.3 s");
        assert_eq!(duration(248.0), "4 min 08 s");
        assert_eq!(duration(99.97), "1 min 40 s");
    }
}
