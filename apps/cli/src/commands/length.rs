use super::planning::{create_folder, list};
use crate::arguments::LengthArguments;
use crate::exit::{Exit, Failure};
use crate::interrupt;
use crate::output::{self, Done};
use crate::progress::Progress;
use pairtrawl::files::{read_scene, write_atomically};
use pairtrawl::model::{Cost, LengthCurve};
use pairtrawl::{LengthRange, OrderMethod, PlanOptions, SeparationStudy, report};
use serde_json::{Value, json};
use std::fmt::Write;

/// A net is as good as the best one while its cost is within this share of the least.
const FLAT: f64 = 0.01;

/// `pairtrawl length`: the cost of the best plan over the length of the net.
pub fn length(arguments: &LengthArguments) -> Result<Done, Failure> {
    let loaded = read_scene(&arguments.scene)?;
    create_folder(&arguments.output)?;
    let fallback = LengthRange::default_for(&loaded.scene);
    let from = arguments.from.unwrap_or(fallback.from);
    let range = LengthRange {
        from,
        to: arguments.to.unwrap_or(fallback.to.max(from + 1.0)),
        points: arguments
            .points
            .map_or(fallback.points, |points| points as usize),
    };
    if range.from >= range.to {
        return Err(Failure::new(
            Exit::Usage,
            format!(
                "--from is {} m and --to is {} m: the first must be less",
                range.from, range.to
            ),
        ));
    }
    let options = PlanOptions {
        waypoints: arguments.waypoints.map(|n| n as usize),
        order: arguments.order.map_or(OrderMethod::Shortest, Into::into),
        ..PlanOptions::default()
    };
    let mut progress = Progress::new();
    let curve = pairtrawl::length_curve(&loaded.scene, &options, &range, &mut progress);
    let study = arguments
        .compare
        .then(|| pairtrawl::separation_study(&loaded.scene, &options, &range, &mut progress));
    progress.finish();
    let curve = curve?;
    let study = study.transpose()?;

    let mut object = curve_json(&curve);
    if let Some(study) = &study {
        object["separation"] = study_json(study);
    }
    let json_text = format!("{object}\n");
    let (csv, svg) = (report::length_csv(&curve), report::length_svg(&curve));
    let study_csv = study.as_ref().map(|study| study_csv(&curve, study));
    let mut contents = vec![
        ("length.csv", &csv),
        ("length.svg", &svg),
        ("length.json", &json_text),
    ];
    contents.extend(study_csv.as_ref().map(|text| ("separation.csv", text)));
    let files: Vec<_> = contents
        .iter()
        .map(|(name, _)| arguments.output.join(name))
        .collect();
    interrupt::while_writing(|| {
        files
            .iter()
            .zip(&contents)
            .try_for_each(|(path, (_, text))| write_atomically(path, text.as_bytes()))
    })?;

    let mut text = curve_text(&curve);
    if let Some(study) = &study {
        text.push_str(&study_text(study));
    }
    output::warnings(&mut text, &loaded.warnings);
    let _ = writeln!(text, "wrote {}", list(&files));
    object["command"] = json!("length");
    object["warnings"] = json!(loaded.warnings);
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

fn curve_text(curve: &LengthCurve) -> String {
    let mut text = String::new();
    let _ = writeln!(text, "{}: cost over net length", curve.title);
    let _ = writeln!(
        text,
        "  {:>8} {:>12} {:>12} {:>12} {:>12}",
        "net m", "J", "smoothness", "distance", "expansion"
    );
    for point in &curve.points {
        let _ = match &point.outcome {
            Ok(cost) => writeln!(
                text,
                "  {:>8.3} {:>12.1} {:>12.1} {:>12.1} {:>12.1}",
                point.net_length,
                cost.total(),
                cost.smoothness,
                cost.distance,
                cost.expansion
            ),
            Err(reason) => writeln!(text, "  {:>8.3} no plan: {reason}", point.net_length),
        };
    }
    if let Some((length, cost)) = &curve.minimum {
        let _ = writeln!(
            text,
            "  least J {:.1} with a net of {length:.3} m",
            cost.total()
        );
    }
    if let Some((low, high)) = curve.flat_range(FLAT) {
        let _ = writeln!(
            text,
            "  within {:.0} % of it from {low:.3} to {high:.3} m",
            FLAT * 100.0
        );
    }
    text
}

fn terms(cost: &Cost) -> Value {
    json!({
        "total": cost.total(),
        "smoothness": cost.smoothness,
        "distance": cost.distance,
        "obstacle": cost.obstacle,
        "expansion": cost.expansion,
    })
}

fn curve_json(curve: &LengthCurve) -> Value {
    json!({
        "scene": curve.title,
        "interrupted": curve.interrupted,
        "points": curve.points.iter().map(|point| match &point.outcome {
            Ok(cost) => json!({ "net_length": point.net_length, "cost": terms(cost) }),
            Err(reason) => json!({ "net_length": point.net_length, "reason": reason.to_string() }),
        }).collect::<Vec<_>>(),
        "minimum": curve.minimum.as_ref().map(|(length, cost)| json!({ "net_length": length, "cost": terms(cost) })),
        "flat": curve.flat_range(FLAT).map(|(low, high)| json!({ "share": FLAT, "from": low, "to": high })),
    })
}

fn study_text(study: &SeparationStudy) -> String {
    let mut text = String::from("  other rules for the separation (studies: no plans)\n");
    let _ = match &study.free {
        Ok((needed, cost)) => writeln!(
            text,
            "    none at all: distance cost {:.1}, takes a net of {needed:.2} m",
            cost.distance
        ),
        Err(reason) => writeln!(text, "    none at all: no solution: {reason}"),
    };
    for (length, outcome) in &study.rigid {
        let _ = match outcome {
            Ok(cost) => writeln!(
                text,
                "    rigid, net {length:.3} m: distance cost {:.1}",
                cost.distance
            ),
            Err(reason) => writeln!(text, "    rigid, net {length:.3} m: no solution: {reason}"),
        };
    }
    text
}

fn study_json(study: &SeparationStudy) -> Value {
    json!({
        "free": match &study.free {
            Ok((needed, cost)) => json!({ "net_length": needed, "cost": terms(cost) }),
            Err(reason) => json!({ "reason": reason }),
        },
        "rigid": study.rigid.iter().map(|(length, outcome)| match outcome {
            Ok(cost) => json!({ "net_length": length, "cost": terms(cost) }),
            Err(reason) => json!({ "net_length": length, "reason": reason }),
        }).collect::<Vec<_>>(),
    })
}

/// Distance cost of the three rules over the net length; empty where there is no solution.
fn study_csv(curve: &LengthCurve, study: &SeparationStudy) -> String {
    let cell = |cost: Option<f64>| cost.map_or(String::new(), |cost| cost.to_string());
    let free = study.free.as_ref().ok().map(|(_, cost)| cost.distance);
    let mut text = String::from("net_length,u_shape_distance,rigid_distance,free_distance\n");
    for (point, (length, rigid)) in curve.points.iter().zip(&study.rigid) {
        let u_shape = point.outcome.as_ref().ok().map(|cost| cost.distance);
        let rigid = rigid.as_ref().ok().map(|cost| cost.distance);
        let _ = writeln!(
            text,
            "{length},{},{},{}",
            cell(u_shape),
            cell(rigid),
            cell(free)
        );
    }
    text
}
