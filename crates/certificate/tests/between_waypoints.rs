//! Faults between waypoints of plans that hold every claim with poses linear between them: the smooth curve breaks one.

mod support;

use pairtrawl_certificate::{certify, judge_stated_time_law};
use pairtrawl_geometry::{Point, Pose};
use pairtrawl_model::{
    Claim, ClaimId, Footprint, Object, Obstacle, PairTrajectory, PlannerParameters, Robot,
};
use pairtrawl_reference::{Reference, ReferenceLimits};
use support::Case;
use support::build::hall;

/// Length of a step, m, and its turn, rad: the arc strays from the chord by 0.05 * 0.1 / 8 = 0.625 mm.
const STEP: f64 = 0.05;
const TURN: f64 = 0.1;
/// Room left on the linear reading, m: less than the arc strays.
const ROOM: f64 = 3e-4;
/// The step under test: there the robot under test moves along +x in the middle.
const MIDDLE: usize = 2;

/// A robot that rolls through these turns, such that step `MIDDLE` goes along +x from x = 1.
fn rolled(turns: [f64; 5], y: f64) -> Vec<Pose> {
    let before: f64 = turns[..MIDDLE].iter().sum();
    let mut pose = Pose::new(0.0, 0.0, -before - 0.5 * turns[MIDDLE]);
    let mut poses = vec![pose];
    for turn in turns {
        let middle = Point::unit(pose.heading + 0.5 * turn);
        pose = Pose::at(pose.position() + middle * STEP, pose.heading + turn);
        poses.push(pose);
    }
    let shift = Point::new(1.0, y) - poses[MIDDLE].position();
    poses
        .iter()
        .map(|p| Pose::at(p.position() + shift, p.heading))
        .collect()
}

/// Left robot at y = 2.4 and right robot at y = 1.6 in step `MIDDLE`.
fn case(left: [f64; 5], right: [f64; 5]) -> Case {
    let mut scene = hall(8.0, 4.0, 2.0, 5.0);
    let trajectory = PairTrajectory {
        left: rolled(left, 2.4),
        right: rolled(right, 1.6),
        step_time: 0.3,
    };
    scene.start = trajectory.pair(0);
    scene.end = trajectory.pair(trajectory.len() - 1);
    Case {
        scene,
        net_length: 1.5,
        trajectory,
    }
}

fn reference(case: &Case) -> Reference {
    Reference::of_scene(&case.scene, &case.trajectory).unwrap()
}

fn claim(case: &Case, id: ClaimId, reference: Option<&Reference>) -> Claim {
    let certificate = certify(&case.scene, case.net_length, &case.trajectory, reference);
    let claim = certificate.claims.into_iter().find(|c| c.id == id);
    claim.expect("every claim is judged")
}

/// The claim holds with `ROOM` linearly, and misses by what the arc strays beyond it on the smooth curve.
fn assert_caught(case: &Case, id: ClaimId, strays: f64) {
    let linear = claim(case, id, None);
    assert!(linear.holds && linear.margin > 0.0, "{linear:?}");
    let smooth = claim(case, id, Some(&reference(case)));
    assert!(!smooth.holds, "{smooth:?}");
    assert!(
        smooth.detail.ends_with("(on the smooth curve)"),
        "{smooth:?}"
    );
    assert_eq!(smooth.step, Some(MIDDLE));
    let expected = linear.margin - strays;
    assert!(
        (smooth.margin - expected).abs() < 2e-6,
        "{} instead of {expected}",
        smooth.margin
    );
}

const ARC: f64 = STEP * TURN / 8.0;
const STRAIGHT: [f64; 5] = [0.0; 5];
const TO_THE_LEFT: [f64; 5] = [TURN; 5];
const TO_THE_RIGHT: [f64; 5] = [-TURN; 5];

/// Middle of step `MIDDLE` of the right robot, and a place this far outside of it, m.
fn below(case: &Case, distance: f64) -> Point {
    let [a, b] = [MIDDLE, MIDDLE + 1].map(|i| case.trajectory.right[i].position());
    a.lerp(b, 0.5) - Point::new(0.0, distance)
}

#[test]
fn an_arc_that_bulges_towards_an_obstacle_an_object_or_the_border_is_seen() {
    let plain = case(STRAIGHT, TO_THE_LEFT);
    let radius = 0.05;
    let mut touched = plain.clone();
    let center = below(&plain, plain.scene.robot.radius + radius + ROOM);
    touched.scene.obstacles = vec![Obstacle::Circle { center, radius }];
    assert_caught(&touched, ClaimId::RobotClearance, ARC);

    let mut touched = plain.clone();
    let footprint = Footprint::Disc(radius);
    touched.scene.objects = vec![Object {
        position: center,
        footprint,
        mass: 0.1,
        leave: false,
    }];
    assert_caught(&touched, ClaimId::RobotsMissObjects, ARC);

    let mut swept = plain.clone();
    let center = below(&plain, radius + ROOM);
    swept.scene.obstacles = vec![Obstacle::Circle { center, radius }];
    assert_caught(&swept, ClaimId::NetEnclosesNoObstacle, ARC);

    let mut outside = plain.clone();
    outside.scene.area.min.y = 1.6 - ROOM;
    assert_caught(&outside, ClaimId::InsideArea, ARC);
}

#[test]
fn arcs_that_part_the_robots_or_bring_them_together_are_seen() {
    // The net is long enough between the hitches: the left robot turns its own inward.
    let mut apart = case(TO_THE_RIGHT, STRAIGHT);
    apart.net_length = 0.8 + ROOM;
    assert_caught(&apart, ClaimId::Separation, ARC);
    let mut together = case(TO_THE_LEFT, STRAIGHT);
    together.scene.robot.radius = 0.5 * (0.8 - ROOM);
    assert_caught(&together, ClaimId::Separation, ARC);
}

#[test]
fn a_heading_that_swings_farther_than_both_waypoints_is_seen() {
    // The left robot turns outward, holds its heading over a step, and turns back. Its smooth heading swings on by a fortieth
    // of the turn: of -x / 2 + 5 x^2 / 2 turns, x = w (1 - w), which brings it back onto its chord, the least at x = 0.1.
    let mut case = case([0.0, -TURN, 0.0, TURN, 0.0], STRAIGHT);
    // Its partner drives straight on along the same step.
    for poses in [&mut case.trajectory.left, &mut case.trajectory.right] {
        let pivot = poses[MIDDLE].position();
        for pose in poses {
            let d = pose.position() - pivot;
            let back = Point::unit(-TURN);
            let turned = d * back.x + d.perp() * back.y;
            *pose = Pose::at(pivot + turned, pose.heading - TURN);
        }
    }
    let swing = TURN / 40.0;

    let room = claim(&case, ClaimId::NetReach, None).margin;
    case.net_length -= room - ROOM;
    let smooth = claim(&case, ClaimId::NetReach, Some(&reference(&case)));
    assert!(claim(&case, ClaimId::NetReach, None).holds && !smooth.holds);
    assert!(
        smooth.margin < 0.9 * (ROOM - 0.207 * swing) && smooth.detail.ends_with("curve)"),
        "{smooth:?}"
    );

    let room = claim(&case, ClaimId::Abreast, None).margin;
    case.scene.planner.max_skew -= room - ROOM;
    let smooth = claim(&case, ClaimId::Abreast, Some(&reference(&case)));
    assert!(claim(&case, ClaimId::Abreast, None).holds && !smooth.holds);
    assert!(
        smooth.margin < 0.8 * (ROOM - swing) && smooth.detail.ends_with("curve)"),
        "{smooth:?}"
    );
}

#[test]
fn an_object_beside_the_curve_is_not_passed_over() {
    // The left robot's arc bulges towards its partner: the object lies between arc and chord.
    let mut case = case(TO_THE_LEFT, STRAIGHT);
    let object = |depth: f64| {
        vec![Object {
            position: Point::new(1.0 + 0.5 * STEP, 2.4 - depth),
            footprint: Footprint::Disc(0.01),
            mass: 0.1,
            leave: false,
        }]
    };
    case.scene.objects = object(ROOM);
    let id = ClaimId::EveryObjectCovered;
    assert!(claim(&case, id, None).holds);
    let smooth = claim(&case, id, Some(&reference(&case)));
    assert!(
        !smooth.holds && smooth.detail.ends_with("curve)"),
        "{smooth:?}"
    );
    // A little deeper it is passed over, with what is left beyond the arc.
    case.scene.objects = object(2.0 * ARC);
    let smooth = claim(&case, id, Some(&reference(&case)));
    assert!(
        smooth.holds && (smooth.margin - ARC).abs() < 1e-6,
        "{smooth:?}"
    );
}

#[test]
fn a_time_law_that_is_too_fast_for_the_robot_is_seen() {
    let case = case(STRAIGHT, TO_THE_LEFT);
    let robot = &case.scene.robot;
    let hasty = PlannerParameters {
        cruise: 2.0 * robot.v_max,
        ..case.scene.planner
    };
    let fast = Robot {
        v_max: 2.0 * robot.v_max,
        ..*robot
    };
    let limits = ReferenceLimits {
        linear: 50.0,
        angular: 250.0,
    };
    let r = Reference::new(&fast, &hasty, &case.trajectory, &limits).unwrap();
    assert!(claim(&case, ClaimId::Speed, None).holds);
    assert!(claim(&case, ClaimId::Speed, Some(&reference(&case))).holds);
    let smooth = claim(&case, ClaimId::Speed, Some(&r));
    assert!(
        !smooth.holds && smooth.detail.ends_with("curve)"),
        "{smooth:?}"
    );
}

#[test]
fn a_curve_that_rolls_back_or_misses_its_end_is_seen() {
    let case = case(STRAIGHT, STRAIGHT);
    let mut back = case.clone();
    back.trajectory.left.reverse();
    let forward = claim(&case, ClaimId::Forward, Some(&reference(&back)));
    assert!(
        !forward.holds && forward.detail.ends_with("curve)"),
        "{forward:?}"
    );
    // A last step too short to say where it goes: the curve does not follow its slip, which the linear claim allows.
    let mut slips = case.clone();
    let last = slips.trajectory.left[5];
    let end = Pose::new(last.x + 1e-5, last.y + 5e-5, last.heading);
    slips.trajectory.left.push(end);
    slips.trajectory.right.push(slips.trajectory.right[5]);
    slips.scene.end = slips.trajectory.pair(6);
    assert!(claim(&slips, ClaimId::Endpoints, None).holds);
    let ends = claim(&slips, ClaimId::Endpoints, Some(&reference(&slips)));
    assert!(!ends.holds && (ends.margin + 5e-5).abs() < 2e-6, "{ends:?}");
}

#[test]
fn a_reference_of_another_plan_and_times_that_are_too_fast_are_refused() {
    let plan = case(STRAIGHT, TO_THE_LEFT);
    let mut shorter = plan.clone();
    shorter.trajectory.left.pop();
    shorter.trajectory.right.pop();
    let certificate = certify(
        &plan.scene,
        plan.net_length,
        &plan.trajectory,
        Some(&reference(&shorter)),
    );
    assert!(certificate.claims.iter().all(|c| !c.holds));

    let r = reference(&plan);
    let speed = claim(&plan, ClaimId::Speed, Some(&r));
    let with = |law: &[f64]| {
        let mut claim = speed.clone();
        judge_stated_time_law(&mut claim, &plan.scene.robot, &plan.trajectory, (&r, law));
        claim
    };
    let law = r.time_law();
    let rounded: Vec<f64> = law.iter().map(|t| (t * 1e7).round() / 1e7).collect();
    assert!(with(&law).holds && with(&rounded).holds);
    for i in 0..law.len() {
        let edited = |time: f64| {
            let mut edited = law.clone();
            edited[i] = time;
            with(&edited)
        };
        // Too late for the next waypoint, or too early after the one before.
        let (too_fast, step) = if i + 1 < law.len() {
            (law[i + 1] - 0.01, i)
        } else {
            (law[i - 1] + 0.01, i - 1)
        };
        for (time, step) in [(too_fast, step), (f64::NAN, i.saturating_sub(1))] {
            let claim = edited(time);
            assert!(!claim.holds && claim.step == Some(step), "{claim:?}");
            assert!(claim.detail.contains("edited"), "{claim:?}");
        }
        // Another law that keeps the limits is no danger, but it is said.
        let claim = edited(law[i] + 2e-6);
        assert!(
            claim.holds && claim.detail.contains("another time law"),
            "{claim:?}"
        );
    }
    assert!(!with(&law[1..]).holds && !with(&law[..5]).holds);
}
