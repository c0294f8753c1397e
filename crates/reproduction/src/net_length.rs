//! The length of the net: the paper's Fig. 5.

use crate::chapter::Content;
use crate::drawing::{driven, points, track, whole};
use crate::drives::{UNLIMITED, drive, errors, first_collision, in_the_net, lost_at};
use crate::evidence::Evidence;
use crate::lab::{Lab, Stopped};
use crate::planning::plan_scene;
use crate::scenes;
use crate::verdict::Verdict;
use pairtrawl::execute::ExecutionOptions;
use pairtrawl::model::numbers::{cost, length, lengths};
use pairtrawl::model::{ControllerKind, Cost, LengthCurve, Plan, Scene, Trial};
use pairtrawl::report::study::{Axis, Chart, Curve, Line, Mark, Pen, Picture, Table};
use pairtrawl::{LengthRange, NetLength, PlanError, PlanOptions, RehearsalMode, length_curve};

/// The lengths of the paper's figure beside the estimated optimum, m.
pub const LENGTHS: [f64; 4] = [1.5, 2.0, 2.5, 3.0];
/// The optimum of the paper, m.
pub const PAPER_OPTIMUM: f64 = 2.32;

/// A plan for one length and how it was driven.
#[derive(Clone, Debug)]
pub struct Case {
    /// True: the planner chose the length.
    pub is_optimum: bool,
    /// The plan.
    pub plan: Plan,
    /// Driven by the adaptive law.
    pub mrac: Trial,
    /// Driven by the model-based law, the net dragging on the floor.
    pub model_based: Trial,
    /// The same with a net that does not touch the floor.
    pub model_based_lifted: Trial,
}

/// One of the drives of a case.
type DriveOf = fn(&Case) -> &Trial;

/// Plans and drives the simulation for each length, by increasing length.
///
/// # Errors
/// When there is no plan, or the host stops it.
pub fn cases(lab: &Lab) -> Result<Vec<Case>, Stopped> {
    let loaded = scenes::simulation()?;
    let wanted = LENGTHS.map(NetLength::Fixed);
    let wanted = wanted.into_iter().chain([NetLength::Auto]);
    let mut cases = Vec::new();
    for wanted in wanted {
        lab.may_go_on()?;
        let options = PlanOptions {
            net_length: Some(wanted),
            rehearsal: RehearsalMode::Skip,
            ..PlanOptions::default()
        };
        let plan = plan_scene(lab, &loaded, &options)?.plan;
        lab.host.doing(&format!(
            "driving with a net of {}",
            length(plan.net_length)
        ));
        let lifted = lifted(&loaded.scene);
        let mrac = one(lab, &loaded.scene, &plan, ControllerKind::Mrac)?;
        let model_based = one(lab, &loaded.scene, &plan, ControllerKind::ModelBased)?;
        let model_based_lifted = one(lab, &lifted, &plan, ControllerKind::ModelBased)?;
        cases.push(Case {
            is_optimum: wanted == NetLength::Auto,
            plan,
            mrac,
            model_based,
            model_based_lifted,
        });
    }
    cases.sort_by(|a, b| a.plan.net_length.total_cmp(&b.plan.net_length));
    Ok(cases)
}

/// The same scene with a net that does not touch the floor, as that of the authors' model file.
pub fn lifted(scene: &Scene) -> Scene {
    let mut scene = scene.clone();
    scene.physics.net_friction = 0.0;
    scene
}

/// One drive that goes on when a robot is lost.
fn one(lab: &Lab, scene: &Scene, plan: &Plan, law: ControllerKind) -> Result<Trial, Stopped> {
    let mut options = ExecutionOptions {
        controller: law,
        trials: 1,
        ..ExecutionOptions::default()
    };
    options.supervisor.tracking_error = UNLIMITED;
    let mut scene = scene.clone();
    scene.physics.tension_limit = UNLIMITED;
    let driven = (&plan.trajectory, plan.net_length);
    let trials = drive(lab, &scene, driven, &options)?;
    let first = trials.into_iter().next();
    first.ok_or_else(|| Stopped::failed(&scene.name, "no drive"))
}

/// J over the net length with visiting order and sides fixed.
///
/// # Errors
/// When there is no plan at all, or the host stops it.
pub fn curve(lab: &Lab) -> Result<LengthCurve, Stopped> {
    let loaded = scenes::simulation()?;
    let range = LengthRange {
        from: 1.2,
        to: 3.0,
        points: if lab.quick { 7 } else { 19 },
    };
    let mut watch = lab.watch();
    let found = length_curve(&loaded.scene, &PlanOptions::default(), &range, &mut watch);
    match found {
        Ok(curve) if curve.interrupted => Err(Stopped::Interrupted),
        Ok(curve) => Ok(curve),
        Err(PlanError::Interrupted) => Err(Stopped::Interrupted),
        Err(error) => Err(Stopped::failed("cost over the net length", error)),
    }
}

/// The chapter.
pub(crate) fn chapter(lab: &Lab) -> Result<Content, Stopped> {
    let mut content = Content::default();
    let scene = scenes::simulation()?.scene;
    let cases = cases(lab)?;
    lab.host.doing("planning for many lengths of the net");
    let curve = curve(lab)?;
    content.text("Planned dashed, driven solid, as in the paper's figure. Controllers see poses with a noise of 1 cm and 1 degree that are up to 60 ms late. Drives are not stopped when a robot is lost (more than 25 cm from its reference), so that what follows is seen; tracks of the model-based law are drawn until then.");
    content.pictures(cases.iter().map(|case| picture(&scene, case)).collect());
    content.table(drives_table(&cases));
    content.charts(vec![
        cost_chart("Total cost", &cases, Cost::total),
        cost_chart("Distance cost", &cases, |c| c.distance),
        curve_chart(&curve),
    ]);
    content.text(format!(
        "With order and sides fixed (third chart) the least J is {} at {}; within 1 % of it from {} to {}. In the first two charts each length is planned by itself.",
        curve.minimum.as_ref().map_or("none".to_owned(), |m| cost(m.1.total())),
        curve.minimum.as_ref().map_or("none".to_owned(), |m| length(m.0)),
        curve.flat_range(0.01).map_or("none".to_owned(), |r| length(r.0)),
        curve.flat_range(0.01).map_or("none".to_owned(), |r| length(r.1)),
    ));
    cost_verdicts(&mut content, &cases);
    drive_verdicts(&mut content, &cases);
    Ok(content)
}

fn name(case: &Case) -> String {
    match case.is_optimum {
        true => format!("{} (optimum)", length(case.plan.net_length)),
        false => length(case.plan.net_length),
    }
}

fn picture(scene: &Scene, case: &Case) -> Picture {
    let mut picture = whole(scene, &format!("d_max {}", name(case)));
    let planned = &case.plan.trajectory;
    picture.tracks = vec![
        track(points(&planned.left), Pen::Planned, "planned"),
        track(points(&planned.right), Pen::Planned, "planned"),
    ];
    let all = f64::INFINITY;
    picture.tracks.extend(driven(
        &case.mrac.samples,
        all,
        Pen::Driven,
        "adaptive",
        false,
    ));
    let lifted = &case.model_based_lifted;
    let until = lost_at(lifted).unwrap_or(all);
    let stops = until < all;
    picture.tracks.extend(driven(
        &lifted.samples,
        until,
        Pen::Other,
        "model-based, net above the floor",
        stops,
    ));
    let until = lost_at(&case.model_based).unwrap_or(all);
    let stops = until < all;
    picture.tracks.extend(driven(
        &case.model_based.samples,
        until,
        Pen::Third,
        "model-based, net on the floor",
        stops,
    ));
    picture
}

fn drives_table(cases: &[Case]) -> Table {
    let mut table = Table::new(
        "Drives: lost is the time at which a robot is first 25 cm off, with the objects in the net at that moment",
        &[
            "net",
            "law",
            "gathered at the end",
            "#error rms / greatest",
            "lost",
            "first collision",
        ],
    );
    for case in cases {
        for (law, trial) in [
            ("adaptive", &case.mrac),
            ("model-based, net above the floor", &case.model_based_lifted),
            ("model-based, net on the floor", &case.model_based),
        ] {
            let (rms, greatest) = errors(trial);
            let lost = lost_at(trial).map_or("never".to_owned(), |time| {
                format!("{time:.1} s, {} in the net", in_the_net(trial, time))
            });
            let collision = first_collision(trial);
            table.row([
                name(case),
                law.to_owned(),
                format!("{} of {}", trial.gathered_count(), trial.wanted()),
                lengths(&[rms, greatest]),
                lost,
                collision.map_or("none".to_owned(), |(what, time)| {
                    format!("{what}, {time:.1} s")
                }),
            ]);
        }
    }
    table
}

fn cost_chart(title: &str, cases: &[Case], of: fn(&Cost) -> f64) -> Chart {
    let curve = |label: &str, line: Line, look: usize, cost: &dyn Fn(&Case) -> Cost| Curve {
        label: label.to_owned(),
        points: cases
            .iter()
            .map(|c| (c.plan.net_length, of(&cost(c))))
            .collect(),
        line,
        look,
        band: None,
    };
    let optimum = cases.iter().find(|c| c.is_optimum);
    Chart {
        title: format!("{title} over d_max, planned and executed"),
        x: Axis::named("net length d_max (m)"),
        y: Axis::named("cost"),
        curves: vec![
            curve("executed", Line::Solid, 1, &|c| c.mrac.cost),
            curve("planned", Line::Dashed, 0, &|c| c.plan.cost),
        ],
        marks: (optimum.iter())
            .map(|c| Mark {
                x: c.plan.net_length,
                label: "optimum".to_owned(),
            })
            .collect(),
        caption: String::new(),
    }
}

fn curve_chart(found: &LengthCurve) -> Chart {
    let curve = |label: &str, look: usize, of: fn(&Cost) -> f64| Curve {
        label: label.to_owned(),
        points: (found.points.iter())
            .map(|p| (p.net_length, p.outcome.as_ref().map_or(f64::NAN, of)))
            .collect(),
        line: Line::Solid,
        look,
        band: None,
    };
    Chart {
        title: "One order and sides, many lengths".to_owned(),
        x: Axis::named("net length d_max (m)"),
        y: Axis::named("planned cost"),
        curves: vec![
            curve("J_total", 2, Cost::total),
            curve("J_dist", 3, |c| c.distance),
        ],
        marks: (found.minimum.iter())
            .map(|(x, _)| Mark {
                x: *x,
                label: "least".to_owned(),
            })
            .collect(),
        caption: String::new(),
    }
}

fn cost_verdicts(content: &mut Content, cases: &[Case]) {
    let (Some(optimum), Some(first), Some(last)) = (
        cases.iter().find(|c| c.is_optimum),
        cases.first(),
        cases.last(),
    ) else {
        return;
    };
    content.verdict(Verdict::of(
        "longer-net",
        Evidence::default()
            .with("optimum", optimum.plan.net_length, "m")
            .with("shortest", first.plan.net_length, "m")
            .with("longest", last.plan.net_length, "m")
            .with("J_total_at_shortest", first.plan.cost.total(), "")
            .with("J_total_at_optimum", optimum.plan.cost.total(), "")
            .with("J_total_at_longest", last.plan.cost.total(), ""),
    ));
    let at = |wanted: f64| {
        let case = cases
            .iter()
            .find(|c| !c.is_optimum && (c.plan.net_length - wanted).abs() < 1e-9);
        case.map_or(f64::NAN, |c| c.plan.cost.distance)
    };
    content.verdict(Verdict::of(
        "distance-alone",
        Evidence::default()
            .with("J_dist_at_optimum", optimum.plan.cost.distance, "")
            .with("J_dist_at_2.5_m", at(2.5), "")
            .with("J_dist_at_3.0_m", at(3.0), ""),
    ));
    let planned: Vec<f64> = cases.iter().map(|c| c.plan.cost.total()).collect();
    let executed: Vec<f64> = cases.iter().map(|c| c.mrac.cost.total()).collect();
    let rank = |values: &[f64], i: usize| values.iter().filter(|v| **v < values[i]).count();
    let same = (0..cases.len()).filter(|&i| rank(&planned, i) == rank(&executed, i));
    let same = same.count() as f64;
    let off = |(p, e): (&f64, &f64)| 100.0 * (e - p).abs() / p;
    let greatest = planned.iter().zip(&executed).map(off).fold(0.0, f64::max);
    content.verdict(Verdict::of(
        "executed-costs",
        Evidence::default()
            .with("lengths", cases.len() as f64, "")
            .with("lengths_with_the_same_rank", same, "")
            .with("greatest_difference_of_J_total", greatest, "%"),
    ));
}

fn drive_verdicts(content: &mut Content, cases: &[Case]) {
    let drives = cases.len() as f64;
    let greatest = cases.iter().map(|c| errors(&c.mrac).1).fold(0.0, f64::max);
    let complete = |of: fn(&Case) -> &Trial| {
        cases.iter().filter(|c| of(c).gathered_everything()).count() as f64
    };
    content.verdict(Verdict::of(
        "mrac-gathers",
        Evidence::default()
            .with("drives", drives, "")
            .with("drives_that_gather_everything", complete(|c| &c.mrac), "")
            .with("greatest_error", greatest, "m"),
    ));
    let collisions = |of: fn(&Case) -> &Trial| {
        cases
            .iter()
            .filter(|c| first_collision(of(c)).is_some())
            .count() as f64
    };
    // The fewest, so that the verdict holds for every length.
    let held = |of: fn(&Case) -> &Trial| {
        let counts = cases
            .iter()
            .map(|c| lost_at(of(c)).map_or(f64::INFINITY, |t| in_the_net(of(c), t) as f64));
        counts.fold(f64::INFINITY, f64::min)
    };
    let earliest = |of: fn(&Case) -> &Trial| {
        let times = cases
            .iter()
            .map(|c| lost_at(of(c)).unwrap_or(f64::INFINITY));
        times.fold(f64::INFINITY, f64::min)
    };
    let mut evidence = Evidence::default().with("drives", drives, "");
    let variants: [(&str, DriveOf); 2] = [
        ("on_the_floor", |c| &c.model_based),
        ("of_a_net_above_the_floor", |c| &c.model_based_lifted),
    ];
    for (what, of) in variants {
        evidence = evidence
            .with(&format!("complete_drives_{what}"), complete(of), "")
            .with(&format!("objects_when_lost_{what}"), held(of), "")
            .with(&format!("earliest_loss_{what}"), earliest(of), "s")
            .with(&format!("collisions_{what}"), collisions(of), "");
    }
    content.verdict(Verdict::of("model-based-fails", evidence));
}
