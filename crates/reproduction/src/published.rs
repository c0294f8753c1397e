//! The trajectories that the authors published, on their own scenes, beside ours.

use crate::chapter::Content;
use crate::drawing::{points, track, whole};
use crate::evidence::Evidence;
use crate::judged::Judged;
use crate::lab::{Lab, Stopped};
use crate::planning::plan_scene;
use crate::scenes;
use crate::verdict::Verdict;
use pairtrawl::files::LoadedScene;
use pairtrawl::geometry::{Point, Pose};
use pairtrawl::model::numbers::{cost, length, lengths};
use pairtrawl::model::{ClaimId, PairTrajectory, Scene, default_step_time};
use pairtrawl::report::study::{Pen, Picture, Table};
use pairtrawl::{NetLength, PlanOptions};

/// Rows of their files up to the last knot; what follows is overshoot of their interpolation.
pub const KNOT_ROWS: [usize; 2] = [109 * 20 + 1, 253 * 50 + 1];
/// Longest step after sampling anew, m.
const STEP: f64 = 0.048;
/// The net of their simulation is not stated; both plans there are judged with this one, m.
const SIMULATION_NET: f64 = 2.0;

/// Their rows as waypoints of a scene: evenly sampled in steps of less than 5 cm of the faster robot, headings those of the
/// motion, since the files have none.
pub fn waypoints(scene: &Scene, rows: &[Vec<Point>; 2], knots: usize) -> PairTrajectory {
    let rows = [0, 1].map(|robot| &rows[robot][..knots.min(rows[robot].len())]);
    let mut way = vec![0.0];
    for i in 1..rows[0].len().min(rows[1].len()) {
        let step = rows.map(|r| r[i].distance(r[i - 1]));
        way.push(way[i - 1] + step[0].max(step[1]));
    }
    let whole = way.last().copied().unwrap_or(0.0);
    let count = (whole / STEP).ceil().max(1.0) as usize;
    let place = |robot: usize, k: usize| {
        let s = whole * k as f64 / count as f64;
        let after = way.partition_point(|w| *w < s).clamp(1, way.len() - 1);
        let (a, b) = (way[after - 1], way[after]);
        let part = if b > a {
            ((s - a) / (b - a)).clamp(0.0, 1.0)
        } else {
            0.0
        };
        rows[robot][after - 1].lerp(rows[robot][after], part)
    };
    let robot = |robot: usize, first: Pose, last: Pose| -> Vec<Pose> {
        let mut poses = vec![first];
        for k in 1..count {
            let before = poses[k - 1];
            let way = place(robot, k + 1) - place(robot, k - 1);
            // A robot that stands keeps its heading.
            let heading = if way.norm() > 1e-4 {
                nearest_turn(way.angle(), before.heading)
            } else {
                before.heading
            };
            poses.push(Pose::at(place(robot, k), heading));
        }
        let before = poses[poses.len() - 1];
        poses.push(Pose::at(
            last.position(),
            nearest_turn(last.heading, before.heading),
        ));
        poses
    };
    PairTrajectory {
        left: robot(0, scene.start.left, scene.end.left),
        right: robot(1, scene.start.right, scene.end.right),
        step_time: default_step_time(&scene.robot, &scene.planner),
    }
}

/// The angle, whole turns added so that it is nearest to another.
fn nearest_turn(angle: f64, to: f64) -> f64 {
    to + pairtrawl::geometry::wrap_angle(angle - to)
}

/// The chapter.
pub(crate) fn chapter(lab: &Lab) -> Result<Content, Stopped> {
    let mut content = Content::default();
    let Some(authors) = lab.authors else {
        content.text("Left out: the authors' files are not at hand. With --authors-data their published trajectories are judged and driven here, beside ours.");
        return Ok(content);
    };
    content.text("The authors' published references, up to their last knot, sampled anew in steps below 5 cm of the faster robot with headings along the motion, since the files have none; ours on the same scenes. That of the simulation is their baseline, not an optimum: 177 of its 254 knots lie at exactly 0.6 m of separation, so a comparison with it says little.");
    let (experiment, simulation) = (scenes::experiment()?, scenes::authors_simulation()?);
    let net = experiment.scene.net.length.unwrap_or(1.45);
    let mut table = Table::new(
        "Judged by the certificate on poses that are linear between waypoints, and driven closely in physics with the net",
        &[
            "trajectory",
            "#net",
            "#paths",
            "#J",
            "#separation",
            "#clearance beyond the radius",
            "claims that fail",
            "driven",
        ],
    );
    let mut pictures = Vec::new();
    let mut evidence = Evidence::default();
    for (i, (loaded, rows, net)) in [
        (&experiment, &authors.experiment, net),
        (&simulation, &authors.simulation, SIMULATION_NET),
    ]
    .into_iter()
    .enumerate()
    {
        lab.host
            .doing(&format!("the authors' trajectory: {}", loaded.scene.name));
        let theirs = waypoints(&loaded.scene, rows, KNOT_ROWS[i]);
        let ours = ours(lab, loaded, net)?;
        let judged = [&theirs, &ours].map(|t| Judged::of(&loaded.scene, t, net));
        for (who, j) in ["theirs", "ours"].iter().zip(&judged) {
            table.row([
                format!("{}, {who}", loaded.scene.name),
                length(j.net_length),
                length(j.paths),
                cost(j.cost),
                lengths(&j.separation),
                length(j.clearance()),
                j.failing(),
                j.driven(),
            ]);
        }
        pictures.push(picture(&loaded.scene, &theirs, &ours));
        if i == 0 {
            let [theirs, ours] = &judged;
            evidence = evidence
                .with("objects", loaded.scene.objects.len() as f64, "")
                .with("gathered_theirs", theirs.gathered() as f64, "")
                .with("gathered_ours", ours.gathered() as f64, "")
                .with("clearance_theirs", theirs.clearance(), "m")
                .with("clearance_ours", ours.clearance(), "m")
                .with(
                    "no_collision_theirs",
                    f64::from(
                        theirs.holds(ClaimId::RobotClearance)
                            && theirs.holds(ClaimId::RobotsMissObjects),
                    ),
                    "",
                );
        }
        lab.may_go_on()?;
    }
    content.pictures(pictures);
    content.table(table);
    content.verdict(Verdict::of("published", evidence));
    Ok(content)
}

fn ours(lab: &Lab, loaded: &LoadedScene, net: f64) -> Result<PairTrajectory, Stopped> {
    let options = PlanOptions {
        net_length: Some(NetLength::Fixed(net)),
        ..PlanOptions::default()
    };
    Ok(plan_scene(lab, loaded, &options)?.plan.trajectory)
}

fn picture(scene: &Scene, theirs: &PairTrajectory, ours: &PairTrajectory) -> Picture {
    let mut picture = whole(scene, &scene.name);
    for (pair, pen, name) in [(theirs, Pen::Other, "theirs"), (ours, Pen::Driven, "ours")] {
        for robot in [&pair.left, &pair.right] {
            picture.tracks.push(track(points(robot), pen, name));
        }
    }
    picture
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_become_waypoints_with_short_steps_from_start_to_end() {
        let scene = scenes::experiment().expect("shipped").scene;
        let line = |a: Point, b: Point| {
            (0..=40)
                .map(|i| a.lerp(b, f64::from(i) / 40.0))
                .collect::<Vec<_>>()
        };
        let rows = [
            line(scene.start.left.position(), scene.end.left.position()),
            line(scene.start.right.position(), scene.end.right.position()),
        ];
        let found = waypoints(&scene, &rows, usize::MAX);
        assert_eq!(found.pair(0), scene.start);
        let last = found.pair(found.len() - 1);
        assert_eq!(last.left.position(), scene.end.left.position());
        let steps = found.left.windows(2).chain(found.right.windows(2));
        assert!(
            steps
                .into_iter()
                .all(|w| w[0].position().distance(w[1].position()) < 0.05)
        );
    }
}
