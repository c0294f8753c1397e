//! The finished summary of a plan: everything that reports show, computed once.

mod claims;
mod execution;
mod failed;
mod frames;
mod panels;
mod rings;

pub use claims::claim_summaries;
pub use execution::summarize_execution;
pub use failed::{summarize_failure, summarize_scene};

use crate::check::without_left;
use crate::passage::first_passage;
use pairtrawl_geometry::Point;
use pairtrawl_model::{
    Event, PairTrajectory, Plan, RehearsalRecord, Scene, SceneOutline, StageTime, Summary,
};

/// Computes the summary of a plan: curves over time, exact clearances, when each object is swept, path lengths.
///
/// `stages` are the planner's times, empty when they were not measured; `rehearsal` is the record of this plan's
/// rehearsal, when there was one. An execution is added by
/// setting [`Summary::execution`] to what [`summarize_execution`] returns.
pub fn summarize(
    scene: &Scene,
    plan: &Plan,
    stages: &[StageTime],
    rehearsal: Option<&RehearsalRecord>,
) -> Summary {
    let scene = &*without_left(scene, &plan.left_out);
    let trajectory = &plan.trajectory;
    let times = plan.times();
    let (left_length, right_length) = trajectory.path_lengths();
    let mut panels = panels::of_plan(scene, plan, &times);
    panels.extend(
        rehearsal
            .into_iter()
            .flat_map(|r| panels::of_rehearsal(scene, r)),
    );
    let mut warnings = plan.warnings.clone();
    warnings.extend(rehearsal.iter().flat_map(|r| r.warnings.clone()));
    Summary {
        title: scene.name.clone(),
        net_length: plan.net_length,
        net_length_chosen: match plan.overrides.net_length {
            Some(length) => length.is_none(),
            None => scene.net.length.is_none(),
        },
        outline: SceneOutline {
            area: scene.area,
            obstacles: scene.obstacles.clone(),
            free_rings: scene.map.as_ref().map(rings::free_rings),
            objects: scene.objects.clone(),
            robot: scene.robot,
            start: scene.start,
            end: scene.end,
        },
        circles: plan.circles.clone(),
        order: plan.order.clone(),
        left_out: plan.left_out.clone(),
        centerline: plan.centerline.clone(),
        baseline: plan.baseline.clone(),
        trajectory: trajectory.clone(),
        left_length,
        right_length,
        duration: times.last().copied().unwrap_or(0.0),
        swept_at: scene
            .objects
            .iter()
            .map(|o| match o.leave {
                true => None,
                false => swept_at(trajectory, &times, o.position),
            })
            .collect(),
        panels,
        cost: plan.cost,
        claims: claim_summaries(&plan.certificate, &times),
        rehearsal: plan.rehearsal.clone(),
        solver: plan.solver.clone(),
        stages: stages.to_vec(),
        warnings,
        marks: Vec::new(),
        frames: rehearsal.and_then(|r| frames::of(&r.frames, events(r), scene)),
        execution: None,
        times,
    }
}

/// When the line between the robots first passes over a point, s.
fn swept_at(trajectory: &PairTrajectory, times: &[f64], point: Point) -> Option<f64> {
    let (step, instant) = first_passage(trajectory, point)?;
    Some(times[step] + instant * (times[step + 1] - times[step]))
}

fn events(record: &RehearsalRecord) -> Vec<Event> {
    let event = |e: &pairtrawl_model::RehearsalEvent| Event {
        time: e.time,
        place: e.place,
        text: e.kind.describe(),
    };
    record.events.iter().map(event).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use pairtrawl_geometry::Pose;
    use pairtrawl_model::{
        Area, Cost, Footprint, NetSpec, Object, Obstacle, PairPose, Rehearsal, RehearsalFrame,
        SolverReport, SolverStatus, Warning,
    };

    /// A pair that drives 2 m along +x, 1 m apart, past a box above it and over one object.
    pub(super) fn scene() -> Scene {
        let pair = |x: f64| PairPose {
            left: Pose::new(x, 2.0, 0.0),
            right: Pose::new(x, 1.0, 0.0),
        };
        Scene {
            name: "straight".to_owned(),
            area: Area {
                min: Point::ZERO,
                max: Point::new(4.0, 3.0),
                resolution: 0.05,
            },
            obstacles: vec![Obstacle::Box {
                min: Point::new(1.5, 2.5),
                max: Point::new(2.0, 3.0),
            }],
            map: None,
            objects: vec![Object {
                position: Point::new(1.51, 1.6),
                footprint: Footprint::Disc(0.03),
                mass: 0.02,
                leave: false,
            }],
            start: pair(1.0),
            end: pair(3.0),
            robot: Default::default(),
            net: NetSpec::default(),
            planner: Default::default(),
            physics: Default::default(),
        }
    }

    fn plan(scene: &Scene) -> Plan {
        let poses = |start: Pose| {
            (0..=40).map(move |i| Pose {
                x: start.x + 0.05 * i as f64,
                ..start
            })
        };
        let trajectory = PairTrajectory {
            left: poses(scene.start.left).collect(),
            right: poses(scene.start.right).collect(),
            step_time: 0.25,
        };
        Plan {
            net_length: 1.5,
            certificate: pairtrawl_certificate::certify(scene, 1.5, &trajectory, None),
            trajectory,
            scene: Default::default(),
            time_law: Vec::new(),
            overrides: Default::default(),
            centerline: Vec::new(),
            baseline: Default::default(),
            circles: Vec::new(),
            order: Vec::new(),
            left_out: Vec::new(),
            cost: Cost::default(),
            rehearsal: Rehearsal::Skipped,
            solver: SolverReport {
                status: SolverStatus::Converged,
                iterations: 3,
                kkt_error: 1e-9,
                seconds: 0.01,
            },
            warnings: vec![Warning::Stated("one".to_owned())],
        }
    }

    fn values<'a>(summary: &'a Summary, key: &str, label: &str) -> &'a [f64] {
        let panel = summary.panels.iter().find(|p| p.key == key).unwrap();
        &panel
            .lines
            .iter()
            .find(|l| l.label == label)
            .unwrap()
            .values
    }

    fn is_near(a: f64, b: f64) -> bool {
        (a - b).abs() < 1e-9
    }

    #[test]
    fn curves_are_those_of_a_straight_drive() {
        let scene = scene();
        let summary = summarize(&scene, &plan(&scene), &[], None);
        assert!(
            values(&summary, "separation", "robots")
                .iter()
                .all(|v| is_near(*v, 1.0))
        );
        assert!(
            values(&summary, "separation", "hitches")
                .iter()
                .all(|v| is_near(*v, 1.0))
        );
        assert!(
            values(&summary, "step_length", "right")
                .iter()
                .all(|v| is_near(*v, 0.05))
        );
        assert!(
            values(&summary, "turn", "left")
                .iter()
                .all(|v| is_near(*v, 0.0))
        );
        assert!(
            values(&summary, "skew", "left")
                .iter()
                .all(|v| is_near(*v, 0.0))
        );
        // At the start the box is 0.5 m ahead of and 0.5 m above the left robot; later it is right above.
        let left = values(&summary, "clearance", "left");
        assert_eq!(left.len(), 40);
        assert!(is_near(left[0], libm::hypot(0.45, 0.5) - 0.24));
        assert!(is_near(left[15], 0.5 - 0.24));
        assert!(is_near(values(&summary, "clearance", "net")[15], 0.5));
        assert!(is_near(
            values(&summary, "clearance", "right")[15],
            1.5 - 0.24
        ));
        let nearest = values(&summary, "object_clearance", "left")[10];
        assert!(is_near(nearest, 0.4 - 0.03 - 0.24), "{nearest}");
        assert!(is_near(summary.left_length, 2.0) && is_near(summary.duration, 10.0));
        // The object is 0.51 m from the start line: 10.2 steps.
        assert!(is_near(summary.swept_at[0].unwrap(), 10.2 * 0.25));
        assert!(summary.net_length_chosen);
        assert_eq!(stated(&summary), ["one"]);
        assert!(summary.frames.is_none());
    }

    #[test]
    fn times_are_those_of_the_time_law() {
        let scene = scene();
        let mut plan = plan(&scene);
        // Twice as fast in the second half.
        plan.time_law = (0..=40)
            .map(|i| 0.4 * f64::min(i as f64, 20.0) + 0.2 * f64::max(i as f64 - 20.0, 0.0))
            .collect();
        let summary = summarize(&scene, &plan, &[], None);
        assert!(is_near(summary.duration, 12.0));
        assert!(is_near(summary.times[30], 10.0));
        assert!(summary.panels.iter().all(|p| p.times == plan.time_law));
        // The object is passed over 10.2 steps after the start.
        assert!(is_near(summary.swept_at[0].unwrap(), 10.2 * 0.4));
        for c in summary.claims.iter().filter(|c| c.claim.step.is_some()) {
            assert_eq!(c.time, plan.time_law.get(c.claim.step.unwrap()).copied());
        }
        // A law for another number of waypoints does not apply.
        plan.time_law.pop();
        assert!(is_near(summarize(&scene, &plan, &[], None).duration, 10.0));
    }

    #[test]
    fn skew_has_the_sign_of_the_heading() {
        let scene = scene();
        let mut plan = plan(&scene);
        plan.trajectory.left[5].heading = 0.3 + std::f64::consts::TAU;
        plan.trajectory.right[6].heading = -0.2;
        let summary = summarize(&scene, &plan, &[], None);
        assert!(is_near(values(&summary, "skew", "left")[5], 0.3));
        assert!(is_near(values(&summary, "skew", "right")[6], -0.2));
    }

    #[test]
    fn a_scene_without_obstacles_has_no_clearance_from_them() {
        let mut scene = scene();
        scene.obstacles.clear();
        let summary = summarize(&scene, &plan(&scene), &[], None);
        assert!(summary.panels.iter().all(|p| p.key != "clearance"));
    }

    fn stated(summary: &Summary) -> Vec<String> {
        summary.warnings.iter().map(ToString::to_string).collect()
    }

    #[test]
    fn long_rehearsals_are_thinned_out_but_keep_both_ends() {
        let scene = scene();
        let frame = |i: usize| RehearsalFrame {
            time: 0.01 * i as f64,
            robots: scene.start,
            net: vec![Point::ZERO; 3],
            objects: vec![Pose::default()],
            tension: [i as f64, 0.5],
            drive_force: [0.1, 0.2],
        };
        let record = RehearsalRecord {
            frames: (0..5000).map(frame).collect(),
            warnings: vec![Warning::Stated("two".to_owned())],
            ..Default::default()
        };
        let summary = summarize(&scene, &plan(&scene), &[], Some(&record));
        let frames = summary.frames.as_ref().unwrap();
        assert!(frames.times.len() <= super::frames::MOST + 1);
        assert_eq!(frames.times[0], 0.0);
        assert!(is_near(*frames.times.last().unwrap(), 49.99));
        assert!(frames.times.windows(2).all(|w| w[0] < w[1]));
        // The curve keeps every frame: a peak must not vanish.
        assert_eq!(values(&summary, "tension", "left").len(), 5000);
        assert_eq!(stated(&summary), ["one", "two"]);
    }
}
