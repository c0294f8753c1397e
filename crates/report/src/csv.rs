use pairtrawl_model::{LengthCurve, Panel};
use std::fmt::Write;

/// All curves of some panels as one table in CSV: a row per instant, a column per curve named
/// `<panel key>_<curve>_<unit>`, empty where a curve has no value. A value that belongs to a step stands in the row of
/// the instant at which the step begins. Numbers have full precision.
pub fn series_csv(panels: &[Panel]) -> String {
    let mut times: Vec<f64> = panels
        .iter()
        .flat_map(|p| &p.times)
        .copied()
        .filter(|t| t.is_finite())
        .collect();
    times.sort_by(f64::total_cmp);
    times.dedup();
    let mut out = String::from("t");
    for panel in panels {
        for line in &panel.lines {
            let name = [&panel.key, &line.label, &panel.unit];
            let name: Vec<String> = name
                .into_iter()
                .filter(|n| !n.is_empty())
                .map(|n| word(n))
                .collect();
            out.push(',');
            out.push_str(&name.join("_"));
        }
    }
    out.push('\n');
    // Each panel's next instant that was not written yet.
    let mut next = vec![0; panels.len()];
    for t in times {
        push(&mut out, t);
        for (panel, next) in panels.iter().zip(&mut next) {
            let here = panel.times.get(*next) == Some(&t);
            for line in &panel.lines {
                out.push(',');
                let value = line.values.get(*next).filter(|v| here && v.is_finite());
                if let Some(value) = value {
                    push(&mut out, *value);
                }
            }
            *next += usize::from(here);
        }
        out.push('\n');
    }
    out
}

/// The curve J(d_max) as CSV: net length, total, terms, and the reason where there is no plan.
pub fn length_csv(curve: &LengthCurve) -> String {
    let mut out = String::from("net_length,total,smoothness,distance,obstacle,expansion,reason\n");
    for point in &curve.points {
        push(&mut out, point.net_length);
        match &point.outcome {
            Ok(cost) => {
                let terms = [
                    cost.total(),
                    cost.smoothness,
                    cost.distance,
                    cost.obstacle,
                    cost.expansion,
                ];
                for value in terms {
                    out.push(',');
                    push(&mut out, value);
                }
                out.push_str(",\n");
            }
            Err(reason) => {
                out.push_str(",,,,,,\"");
                out.push_str(
                    &reason
                        .to_string()
                        .replace('"', "\"\"")
                        .replace(['\n', '\r'], " "),
                );
                out.push_str("\"\n");
            }
        }
    }
    out
}

fn push(out: &mut String, value: f64) {
    // Writing to a String cannot fail.
    let _ = write!(out, "{value}");
}

/// A name that needs no quotes in any program: letters and digits, the rest becomes underscores.
fn word(text: &str) -> String {
    let legal = |c: char| if c.is_alphanumeric() { c } else { '_' };
    text.chars().map(legal).collect()
}
