//! Five executions of the experiment with masses of 15 to 50 g: the paper's Figs. 4, 7 and 8.

use crate::chapter::Content;
use crate::drawing::{driven, points, track, whole};
use crate::drives::{drive, errors};
use crate::evidence::Evidence;
use crate::lab::{Lab, Stopped};
use crate::planning::plan_scene;
use crate::scenes;
use crate::verdict::Verdict;
use pairtrawl::execute::ExecutionOptions;
use pairtrawl::geometry::Point;
use pairtrawl::model::numbers::{cost, lengths};
use pairtrawl::model::{ControlSample, Footprint, Plan, Scene, Trial};
use pairtrawl::report::study::{Axis, Band, Chart, Curve, Line, Pen, Picture, Table, Wash};
use pairtrawl::{PlanOptions, RehearsalMode};

/// Executions in the paper.
pub const EXECUTIONS: usize = 5;
/// Masses of its objects, kg.
pub const MASSES: [f64; 2] = [0.015, 0.05];

/// The experiment's plan and its executions by the adaptive law.
///
/// # Errors
/// When there is no plan, or the host stops it.
pub fn executions(lab: &Lab) -> Result<(Scene, Plan, Vec<Trial>), Stopped> {
    let loaded = scenes::experiment()?;
    let options = PlanOptions {
        rehearsal: RehearsalMode::Skip,
        ..PlanOptions::default()
    };
    let plan = plan_scene(lab, &loaded, &options)?.plan;
    let options = ExecutionOptions {
        trials: EXECUTIONS,
        object_mass: Some(MASSES),
        ..ExecutionOptions::default()
    };
    let driven = (&plan.trajectory, plan.net_length);
    let trials = drive(lab, &loaded.scene, driven, &options)?;
    Ok((loaded.scene, plan, trials))
}

/// The chapter.
pub(crate) fn chapter(lab: &Lab) -> Result<Content, Stopped> {
    let mut content = Content::default();
    lab.host.doing("five executions of the experiment");
    let (scene, plan, trials) = executions(lab)?;
    content.text("Five executions by the adaptive law on the experiment's plan (net 1.45 m). Masses of the objects are drawn from 15 to 50 g, poses have a noise of 1 cm and 1 degree as of a lidar localization and are up to 60 ms late, and wheel odometry is off by up to 1 %.");
    content.figures(
        vec![
            error_chart(&trials, 0, "left"),
            error_chart(&trials, 1, "right"),
        ],
        vec![paths(&scene, &plan, &trials)],
    );
    let mut table = Table::new(
        "Errors of the worse robot after the first second",
        &[
            "execution",
            "gathered",
            "#rms",
            "#greatest",
            "#J executed",
            "#mean drag",
        ],
    );
    for trial in &trials {
        let (rms, greatest) = errors(trial);
        table.row([
            (trial.index + 1).to_string(),
            format!("{} of {}", trial.gathered_count(), trial.wanted()),
            lengths(&[rms]),
            lengths(&[greatest]),
            cost(trial.cost.total()),
            format!("{:.3} N", trial.drag[0].mean.max(trial.drag[1].mean)),
        ]);
    }
    content.table(table);
    content.heading("Keyframes (Figs. 4 and 7)");
    if let Some(first) = trials.first() {
        content.pictures(keyframes(&scene, first));
    }
    theirs(lab, &mut content, &scene);
    let all = trials.len() as f64;
    let complete = trials.iter().filter(|t| t.gathered_everything()).count() as f64;
    let greatest = trials.iter().map(|t| errors(t).1).fold(0.0, f64::max);
    let rms = trials.iter().map(|t| errors(t).0).fold(0.0, f64::max);
    content.verdict(Verdict::of(
        "executions",
        Evidence::default()
            .with("executions", all, "")
            .with("executions_that_gather_everything", complete, "")
            .with("greatest_rms_error", rms, "m")
            .with("greatest_error", greatest, "m"),
    ));
    Ok(content)
}

/// Mean positions over all trials and how far they go from there, for one robot.
fn ribbon(trials: &[Trial], robot: fn(&ControlSample) -> Point) -> (Vec<Point>, Wash) {
    let count = trials.iter().map(|t| t.samples.len()).min().unwrap_or(0);
    let (mut mean, mut left, mut right) = (Vec::new(), Vec::new(), Vec::new());
    for i in 0..count {
        let places = trials.iter().map(|t| robot(&t.samples[i]));
        let middle = places.clone().fold(Point::ZERO, |a, b| a + b) * (1.0 / trials.len() as f64);
        let ahead = (i + 1).min(count - 1);
        let way =
            robot(&trials[0].samples[ahead]) - robot(&trials[0].samples[ahead.saturating_sub(1)]);
        let normal = if way.norm() > 1e-9 {
            way.perp() * (1.0 / way.norm())
        } else {
            Point::new(0.0, 1.0)
        };
        let off = places.map(|p| (p - middle).dot(normal));
        let (low, high) = off.fold((0.0_f64, 0.0_f64), |(l, h), o| (l.min(o), h.max(o)));
        mean.push(middle);
        left.push(middle + normal * high);
        right.push(middle + normal * low);
    }
    let wash = Wash {
        left,
        right,
        name: "range of five executions".to_owned(),
    };
    (mean, wash)
}

fn paths(scene: &Scene, plan: &Plan, trials: &[Trial]) -> Picture {
    let mut picture = whole(scene, "Fig. 8: reference and mean of five executions");
    for (reference, robot) in [
        (
            &plan.trajectory.left,
            (|s: &ControlSample| s.robots.left.position()) as fn(&ControlSample) -> Point,
        ),
        (&plan.trajectory.right, |s: &ControlSample| {
            s.robots.right.position()
        }),
    ] {
        let (mean, wash) = ribbon(trials, robot);
        picture.washes.push(wash);
        picture
            .tracks
            .push(track(mean, Pen::Driven, "mean of five executions"));
        picture
            .tracks
            .push(track(points(reference), Pen::Planned, "reference"));
    }
    picture.caption =
        "The range is within 2 cm and hardly wider than the line; the charts beside show it."
            .to_owned();
    picture
}

/// Error over time: mean and range of all trials.
fn error_chart(trials: &[Trial], robot: usize, name: &str) -> Chart {
    let count = trials.iter().map(|t| t.samples.len()).min().unwrap_or(0);
    // Every fifth sample: four a second.
    let at: Vec<usize> = (0..count).step_by(5).collect();
    let values = |i: usize| trials.iter().map(move |t| 1e3 * t.samples[i].error[robot]);
    let mean = |i: &usize| values(*i).sum::<f64>() / trials.len().max(1) as f64;
    Chart {
        title: format!("Error of the {name} robot"),
        x: Axis::named("time (s)"),
        y: Axis::from_zero("distance from the reference (mm)"),
        curves: vec![Curve {
            label: "mean".to_owned(),
            points: at
                .iter()
                .map(|i| (trials[0].samples[*i].time, mean(i)))
                .collect(),
            line: Line::Plain,
            look: robot,
            band: Some(Band {
                low: at
                    .iter()
                    .map(|i| values(*i).fold(f64::INFINITY, f64::min))
                    .collect(),
                high: at.iter().map(|i| values(*i).fold(0.0, f64::max)).collect(),
            }),
        }],
        marks: Vec::new(),
        caption: "The band holds all five executions.".to_owned(),
    }
}

/// Five moments of a trial: robots, net and objects.
pub(crate) fn keyframes(scene: &Scene, trial: &Trial) -> Vec<Picture> {
    let last = trial.frames.len().saturating_sub(1);
    let frame = |k: usize| {
        let frame = &trial.frames[k * last / 4];
        let mut picture = whole(scene, &format!("after {:.1} s", frame.time));
        for (object, pose) in picture.scene.outline.objects.iter_mut().zip(&frame.objects) {
            object.position = pose.position();
            // As they turn, cubes are drawn as discs of their size.
            object.footprint = Footprint::Disc(0.035);
        }
        (picture.scene.outline.start, picture.scene.outline.end) = (frame.robots, frame.robots);
        picture.tracks = driven(
            &trial.samples,
            frame.time,
            Pen::Planned,
            "driven so far",
            false,
        )
        .to_vec();
        picture
            .tracks
            .push(track(frame.net.clone(), Pen::Net, "net"));
        picture
    };
    (0..5).map(frame).collect()
}

/// The authors' reference and their tracked path, when they are at hand.
fn theirs(lab: &Lab, content: &mut Content, scene: &Scene) {
    content.heading("The authors' published run");
    let Some(authors) = lab.authors else {
        content.text("Left out: their files are not at hand (--authors-data).");
        return;
    };
    let mut picture = whole(scene, "Their reference, and where the right robot drove");
    let [left, right] = &authors.experiment;
    picture.tracks = vec![
        track(left.clone(), Pen::Planned, "their reference"),
        track(right.clone(), Pen::Planned, "their reference"),
        track(
            authors.tracked_right.clone(),
            Pen::Driven,
            "tracked, right robot",
        ),
    ];
    let end = |path: &[Point]| path.last().copied().unwrap_or(Point::ZERO);
    let distance = end(right).distance(end(&authors.tracked_right));
    let nearest = |p: &Point| {
        right
            .iter()
            .map(|q| q.distance(*p))
            .fold(f64::INFINITY, f64::min)
    };
    let squares: f64 = authors
        .tracked_right
        .iter()
        .map(|p| nearest(p) * nearest(p))
        .sum();
    let rms = (squares / authors.tracked_right.len() as f64).sqrt();
    content.pictures(vec![picture]);
    content.text(format!("Their tracked path lies {} from their reference (root mean square of the distance to the nearest point of the path, whatever the time), and ends {} from its end.", lengths(&[rms]), lengths(&[distance])));
}
