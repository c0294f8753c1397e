use super::with_scene;
use crate::arguments::LengthArguments;
use crate::exit::Exit;
use crate::failure::Failure;
use crate::interrupt;
use crate::objects::CostObject;
use crate::output::{Done, Report, to_json};
use crate::progress::Progress;
use crate::results::{Results, in_folder};
use pairtrawl::files::LoadedScene;
use pairtrawl::model::numbers::{cost, length as meters};
use pairtrawl::model::{Cost, LengthCurve, LengthRefusal};
use pairtrawl::report::study::{Axis, Chart, Curve, Line, Mark};
use pairtrawl::{LengthRange, OrderMethod, PlanError, PlanOptions, SeparationStudy, report};
use schemars::JsonSchema;
use serde::Serialize;
use std::fmt::Write;

/// A net is as good as the best one while its cost is within this share of the least.
const FLAT: f64 = 0.01;

/// The files of a study, its numbers first.
const FILES: &[&str] = &[
    "length.json",
    "length.csv",
    "length.svg",
    "separation.csv",
    "separation.svg",
];

/// The cost of the best plan over the length of the net.
#[derive(Clone, Serialize, JsonSchema)]
pub struct LengthReport {
    /// Name of the scene.
    #[serde(skip_serializing_if = "Option::is_none")]
    scene: Option<String>,
    /// True when it was stopped before all lengths were solved: the others are missing.
    interrupted: bool,
    /// By increasing length.
    points: Vec<OutcomeObject>,
    /// The best length and its cost; null when no length has a plan.
    minimum: Option<SolvedObject>,
    /// The lengths that are almost as good; null when no length has a plan.
    flat: Option<FlatObject>,
    /// With `--compare`: the paper's two other rules for the separation.
    #[serde(skip_serializing_if = "Option::is_none")]
    separation: Option<SeparationObject>,
}

/// A length with its cost, or why it has no plan.
#[derive(Clone, Serialize, JsonSchema)]
#[serde(untagged)]
enum OutcomeObject {
    Solved(SolvedObject),
    Unsolved(UnsolvedObject),
}

/// A length and its cost.
#[derive(Clone, Serialize, JsonSchema)]
struct SolvedObject {
    /// Length of the net, m.
    net_length: f64,
    /// The paper's J.
    cost: CostObject,
}

/// A length without a plan.
#[derive(Clone, Serialize, JsonSchema)]
struct UnsolvedObject {
    /// Length of the net, m; left out when the length was free.
    #[serde(skip_serializing_if = "Option::is_none")]
    net_length: Option<f64>,
    /// Why there is none, for people.
    reason: String,
    /// True when it is proven that there is none; false when none was found.
    proven: bool,
}

/// Lengths whose cost is close to the least.
#[derive(Clone, Serialize, JsonSchema)]
struct FlatObject {
    /// How close: a share of the least cost.
    share: f64,
    /// The least of them, m.
    from: f64,
    /// The greatest of them, m.
    to: f64,
}

/// The paper's two other rules for the separation. These are studies: what they find is no plan.
#[derive(Clone, Serialize, JsonSchema)]
struct SeparationObject {
    /// Without any rule: the net that this takes.
    free: OutcomeObject,
    /// With a rigid bar instead of the net, for every length.
    rigid: Vec<OutcomeObject>,
}

/// `pairtrawl length`: the cost of the best plan over the length of the net.
pub fn length(arguments: &LengthArguments) -> Result<Done, Failure> {
    in_folder(&arguments.output, FILES, |results| {
        with_scene(&arguments.scene, &|loaded| {
            length_in(loaded, arguments, results)
        })
    })
}

fn length_in(
    loaded: &LoadedScene,
    arguments: &LengthArguments,
    results: &Results<'_>,
) -> Result<Done, Failure> {
    let range = range(loaded, arguments)?;
    let options = PlanOptions {
        waypoints: arguments.waypoints.map(|n| n as usize),
        order: arguments.order.map_or(OrderMethod::Shortest, Into::into),
        ..PlanOptions::default()
    };
    let mut progress = Progress::new();
    let (curve, study) = interrupt::gracefully(|| {
        let curve = pairtrawl::length_curve(&loaded.scene, &options, &range, &mut progress);
        let compare = arguments.compare && !crate::interrupt::requested();
        let study = compare
            .then(|| pairtrawl::separation_study(&loaded.scene, &options, &range, &mut progress));
        (curve, study)
    });
    progress.finish();
    let mut curve = curve?;
    let study = match study.transpose() {
        // The curve is there: it is kept.
        Err(PlanError::Interrupted) => {
            curve.interrupted = true;
            None
        }
        study => study?,
    };

    let scene = &loaded.scene.name;
    let about = about(&curve, study.as_ref());
    let file = LengthReport {
        scene: Some(scene.clone()),
        ..about.clone()
    };
    let mut contents = vec![
        ("length.csv", report::length_csv(&curve)),
        ("length.svg", report::length_svg(&curve)),
    ];
    if let Some(study) = &study {
        contents.push(("separation.csv", study_csv(&curve, study)));
        let chart = study_chart(&curve, study);
        contents.push(("separation.svg", report::study::chart_svg(&chart)));
    }
    contents.push(("length.json", format!("{}\n", to_json(&file)?)));
    let files = results.write(&contents)?;

    let mut text = curve_text(&curve);
    if let Some(study) = &study {
        text.push_str(&study_text(study));
    }
    let exit = verdict(&curve);
    Report::new("length", exit, about)
        .scene(scene)
        .done(exit, text, &loaded.warnings, &files)
}

/// Good as soon as one length has a plan; proven infeasible when every length of the range is.
fn verdict(curve: &LengthCurve) -> Exit {
    let proven = |outcome: &Result<_, _>| matches!(outcome, Err(LengthRefusal::Proven(_)));
    if curve.interrupted {
        Exit::Interrupted
    } else if curve.points.iter().any(|point| point.outcome.is_ok()) {
        Exit::Done
    } else if curve.points.iter().all(|point| proven(&point.outcome)) {
        Exit::Infeasible
    } else {
        Exit::NoPlan
    }
}

fn range(loaded: &LoadedScene, arguments: &LengthArguments) -> Result<LengthRange, Failure> {
    let fallback = LengthRange::default_for(&loaded.scene);
    let from = arguments.from.unwrap_or(fallback.from);
    let range = LengthRange {
        from,
        to: arguments.to.unwrap_or(fallback.to.max(from + 1.0)),
        points: arguments
            .points
            .map_or(fallback.points, |points| points as usize),
    };
    if range.from < range.to {
        return Ok(range);
    }
    Err(Failure::new(
        Exit::Usage,
        format!(
            "--from is {} and --to is {}: the first must be less",
            meters(range.from),
            meters(range.to)
        ),
    ))
}

fn curve_text(curve: &LengthCurve) -> String {
    let mut text = String::new();
    let verdict = match verdict(curve) {
        Exit::Interrupted => "INTERRUPTED: ",
        Exit::Infeasible | Exit::NoPlan => "NO PLAN: ",
        _ => "",
    };
    let _ = writeln!(text, "{}: {verdict}cost over net length", curve.title);
    let _ = writeln!(
        text,
        "  {:>8} {:>12} {:>12} {:>12} {:>12}",
        "net", "J", "smoothness", "distance", "expansion"
    );
    for point in &curve.points {
        let net = meters(point.net_length);
        let _ = match &point.outcome {
            Ok(j) => writeln!(
                text,
                "  {net:>8} {:>12} {:>12} {:>12} {:>12}",
                cost(j.total()),
                cost(j.smoothness),
                cost(j.distance),
                cost(j.expansion)
            ),
            Err(reason) => writeln!(text, "  {net:>8} no plan: {reason}"),
        };
    }
    if let Some((length, j)) = &curve.minimum {
        let _ = writeln!(
            text,
            "  least J {} with a net of {}",
            cost(j.total()),
            meters(*length)
        );
    }
    if let Some((low, high)) = curve.flat_range(FLAT) {
        let _ = writeln!(
            text,
            "  within {:.0} % of it from {} to {}",
            FLAT * 100.0,
            meters(low),
            meters(high)
        );
    }
    text
}

fn about(curve: &LengthCurve, study: Option<&SeparationStudy>) -> LengthReport {
    LengthReport {
        scene: None,
        interrupted: curve.interrupted,
        points: (curve.points.iter())
            .map(|point| outcome(point.net_length, point.outcome.as_ref()))
            .collect(),
        minimum: (curve.minimum.as_ref()).map(|(length, cost)| solved(*length, cost)),
        flat: curve.flat_range(FLAT).map(|(from, to)| FlatObject {
            share: FLAT,
            from,
            to,
        }),
        separation: study.map(|study| SeparationObject {
            free: match &study.free {
                Ok((needed, cost)) => OutcomeObject::Solved(solved(*needed, cost)),
                Err(reason) => OutcomeObject::Unsolved(UnsolvedObject {
                    net_length: None,
                    reason: reason.clone(),
                    proven: false,
                }),
            },
            rigid: (study.rigid.iter())
                .map(|(length, rigid)| match rigid {
                    Ok(cost) => OutcomeObject::Solved(solved(*length, cost)),
                    Err(reason) => OutcomeObject::Unsolved(UnsolvedObject {
                        net_length: Some(*length),
                        reason: reason.clone(),
                        proven: false,
                    }),
                })
                .collect(),
        }),
    }
}

fn solved(net_length: f64, cost: &Cost) -> SolvedObject {
    SolvedObject {
        net_length,
        cost: CostObject::from(cost),
    }
}

fn outcome(net_length: f64, outcome: Result<&Cost, &LengthRefusal>) -> OutcomeObject {
    match outcome {
        Ok(cost) => OutcomeObject::Solved(solved(net_length, cost)),
        Err(reason) => OutcomeObject::Unsolved(UnsolvedObject {
            net_length: Some(net_length),
            reason: reason.to_string(),
            proven: matches!(reason, LengthRefusal::Proven(_)),
        }),
    }
}

fn study_text(study: &SeparationStudy) -> String {
    let mut text = String::from("  other rules for the separation (studies: no plans)\n");
    let _ = match &study.free {
        Ok((needed, j)) => writeln!(
            text,
            "    none at all: distance cost {}, takes a net of {}",
            cost(j.distance),
            meters(*needed)
        ),
        Err(reason) => writeln!(text, "    none at all: no solution: {reason}"),
    };
    for (length, outcome) in &study.rigid {
        let net = meters(*length);
        let _ = match outcome {
            Ok(j) => writeln!(
                text,
                "    rigid, net {net}: distance cost {}",
                cost(j.distance)
            ),
            Err(reason) => writeln!(text, "    rigid, net {net}: no solution: {reason}"),
        };
    }
    text
}

/// Distance cost of the three rules over the net length.
fn study_chart(curve: &LengthCurve, study: &SeparationStudy) -> Chart {
    let chart_curve = |label: &str, look: usize, line: Line, points: Vec<(f64, f64)>| Curve {
        label: label.to_owned(),
        points,
        line,
        look,
        band: None,
    };
    let u_shape = curve.points.iter().map(|point| {
        let cost = point.outcome.as_ref().map_or(f64::NAN, |c| c.distance);
        (point.net_length, cost)
    });
    let rigid = study.rigid.iter().map(|(length, outcome)| {
        let cost = outcome.as_ref().map_or(f64::NAN, |c| c.distance);
        (*length, cost)
    });
    let mut curves = vec![
        chart_curve("rigid", 1, Line::Dashed, rigid.collect()),
        chart_curve("U-shape", 0, Line::Solid, u_shape.collect()),
    ];
    let mut marks = Vec::new();
    if let Ok((needed, cost)) = &study.free {
        let ends = [curve.points.first(), curve.points.last()];
        let ends = ends
            .into_iter()
            .flatten()
            .map(|p| (p.net_length, cost.distance));
        curves.push(chart_curve("none", 2, Line::Plain, ends.collect()));
        marks.push(Mark {
            x: *needed,
            label: "none needs".to_owned(),
        });
    }
    Chart {
        title: format!("{}: rules for the separation", curve.title),
        x: Axis::named("net length d_max (m)"),
        y: Axis::named("distance cost J_dist"),
        curves,
        marks,
        caption: "A gap in a curve: no solution.".to_owned(),
    }
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
