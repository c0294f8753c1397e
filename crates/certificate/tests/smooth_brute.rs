//! Margins on both readings against dense samples of the curve, on random drives.

#![allow(
    clippy::disallowed_methods,
    reason = "tests compare with the standard library"
)]

mod support;

use pairtrawl_certificate::{Clearance, certify};
use pairtrawl_geometry::{Hull, Point, Pose, Segment, wrap_angle};
use pairtrawl_model::{Body, BodyCircle, ClaimId, Object, PairPose, PairTrajectory, Robot, Side};
use pairtrawl_reference::Reference;
use support::Case;
use support::build::hall;
use support::furnish::{on_a_line, shape};
use support::random::Random;

/// Samples of each step.
const SAMPLES: usize = 256;

/// Two robots that roll beside each other, each with turns of its own.
fn drive(random: &mut Random) -> Case {
    let mut scene = hall(9.0, 9.0, 4.0, 5.0);
    let mut poses = |y: f64| {
        let mut pose = Pose::new(3.0, y, random.within(-0.2, 0.2));
        let mut poses = vec![pose];
        let (mut turn, mut step) = (0.0_f64, 0.03_f64);
        for _ in 0..25 {
            turn = (turn + random.within(-0.04, 0.04)).clamp(-0.1, 0.1);
            step = (step + random.within(-0.02, 0.02)).clamp(0.0, 0.05);
            let middle = Point::unit(pose.heading + 0.5 * turn);
            pose = Pose::at(pose.position() + middle * step, pose.heading + turn);
            poses.push(pose);
        }
        poses
    };
    let trajectory = PairTrajectory {
        left: poses(4.5),
        right: poses(3.5),
        step_time: 0.3,
    };
    scene.start = trajectory.pair(0);
    scene.end = trajectory.pair(25);
    let mut case = Case {
        scene,
        net_length: 1.2,
        trajectory,
    };
    for k in 0..6 {
        let p = on_a_line(&case, random, -0.8, 1.8);
        let shape = shape(p, random.within(0.02, 0.3), k, random);
        case.scene.obstacles.push(shape);
    }
    for _ in 0..3 {
        let position = on_a_line(&case, random, -0.2, 1.2);
        case.scene.objects.push(pairtrawl_model::Object {
            position,
            footprint: pairtrawl_model::Footprint::Disc(0.03),
            mass: 0.02,
            leave: false,
        });
    }
    case
}

/// The least of `gap` at the centers of a robot's circles, less their radii. Centers are found by a rotation matrix.
fn of_circles(robot: &Robot, pose: Pose, gap: &dyn Fn(Point) -> f64) -> f64 {
    let disc = [[0.0, 0.0, robot.radius]];
    let body = robot.body.map(|body| {
        let triple = |c: &BodyCircle| [c.center.x, c.center.y, c.radius];
        body.circles().iter().map(triple).collect::<Vec<_>>()
    });
    let (sin, cos) = pose.heading.sin_cos();
    let circles = body.unwrap_or_else(|| disc.to_vec());
    let gaps = circles.into_iter().map(|[x, y, radius]| {
        gap(Point::new(
            pose.x + cos * x - sin * y,
            pose.y + sin * x + cos * y,
        )) - radius
    });
    gaps.fold(f64::INFINITY, f64::min)
}

/// One to four circles, wherever: the certificate does not care whether they make a machine.
fn any_body(random: &mut Random) -> Body {
    let mut circles = Vec::new();
    for _ in 0..1 + random.below(4) {
        circles.push(BodyCircle {
            center: Point::new(random.within(-0.3, 0.3), random.within(-0.1, 0.1)),
            radius: random.within(0.03, 0.2),
        });
    }
    Body::of(&circles).unwrap()
}

/// The least margin of a claim among dense samples of the pair's motion, for the steps that the claim is about.
fn sampled(case: &Case, id: ClaimId, pose: impl Fn(Side, usize, f64) -> Pose) -> f64 {
    let (scene, length) = (&case.scene, case.net_length);
    let robot = &scene.robot;
    let clearance = Clearance::new(scene).unwrap();
    let last = case.trajectory.len() - 1;
    let steps = if id == ClaimId::Abreast {
        1..last - 1
    } else {
        0..last
    };
    let mut least = f64::INFINITY;
    for step in steps {
        for k in 0..=SAMPLES {
            let w = k as f64 / SAMPLES as f64;
            let pair = Side::BOTH.map(|side| pose(side, step, w));
            let [l, r] = pair.map(Pose::position);
            let each = |f: &dyn Fn(Pose) -> f64| f(pair[0]).min(f(pair[1]));
            let margin = match id {
                ClaimId::RobotClearance => each(&|p| {
                    of_circles(robot, p, &|c| clearance.distance(&Hull::of(&[c])).unwrap())
                }),
                ClaimId::RobotsMissObjects => each(&|p| {
                    of_circles(robot, p, &|c| {
                        let gap = |o: &Object| o.position.distance(c) - o.footprint_radius();
                        scene.objects.iter().map(gap).fold(f64::INFINITY, f64::min)
                    })
                }),
                ClaimId::RobotsApart => of_circles(robot, pair[0], &|left| {
                    of_circles(robot, pair[1], &|right| left.distance(right))
                }),
                ClaimId::NetEnclosesNoObstacle => {
                    clearance.distance(&Hull::of(&[l, r])).unwrap().max(0.0)
                }
                ClaimId::Separation => {
                    let d = l.distance(r);
                    let least = match robot.body {
                        None => (0.1 * length).max(2.0 * robot.radius),
                        Some(_) => 0.1 * length,
                    };
                    (d - least).min(length - d)
                }
                ClaimId::NetReach => {
                    let [a, b] = pair.map(|p| p.hitch_point(robot.hitch));
                    length - a.distance(b)
                }
                ClaimId::InsideArea => each(&|p| {
                    let (min, max) = (scene.area.min, scene.area.max);
                    (p.x - min.x)
                        .min(max.x - p.x)
                        .min(p.y - min.y)
                        .min(max.y - p.y)
                }),
                _ => {
                    let [left, right] = pair;
                    let normal = PairPose { left, right }.normal_heading();
                    each(&|p| scene.planner.max_skew - wrap_angle(p.heading - normal).abs())
                }
            };
            least = least.min(margin);
        }
    }
    least
}

/// The best margin with which a line of the dense samples passes over a point, or `None`.
fn passed(case: &Case, p: Point, pose: impl Fn(Side, usize, f64) -> Pose) -> Option<f64> {
    let lines =
        (0..case.trajectory.len() - 1).flat_map(|step| (0..=SAMPLES).map(move |k| (step, k)));
    let mut best: Option<f64> = None;
    let mut before: Option<(f64, Segment)> = None;
    for (step, k) in lines {
        let w = k as f64 / SAMPLES as f64;
        let [l, r] = Side::BOTH.map(|side| pose(side, step, w).position());
        let now = (r - l).cross(p - l);
        if let Some((side, line)) = before
            && side * now <= 0.0
            && line.distance(p) < 1e-3
        {
            let margin = l.distance(p).min(r.distance(p));
            best = Some(best.map_or(margin, |b| b.max(margin)));
        }
        before = Some((now, Segment::new(l, r)));
    }
    best
}

#[test]
fn margins_are_those_of_dense_samples_and_never_more() {
    compare(9, |_| None);
}

#[test]
fn margins_of_bodies_are_those_of_dense_samples_and_never_more() {
    compare(10, |random| Some(any_body(random)));
}

fn compare(seed: u64, body: impl Fn(&mut Random) -> Option<Body>) {
    let mut random = Random(seed);
    let mut smooth_is_tighter = 0;
    for round in 0..60 {
        let mut case = drive(&mut random);
        if let Some(body) = body(&mut random) {
            case.scene.robot = case.scene.robot.with_body(body);
        }
        let smallest = {
            let circles = case.scene.robot.circles();
            let radii = circles.circles().iter().map(|c| c.radius);
            radii.fold(f64::INFINITY, f64::min)
        };
        let r = Reference::of_scene(&case.scene, &case.trajectory).unwrap();
        let certificate = certify(&case.scene, case.net_length, &case.trajectory, Some(&r));
        let linear = certify(&case.scene, case.net_length, &case.trajectory, None);
        let smooth = |side: Side, step: usize, w: f64| r.steps(side)[step].pose(w);
        let even = |side: Side, step: usize, w: f64| {
            let poses = [&case.trajectory.left, &case.trajectory.right][side.index()];
            poses[step].lerp(poses[step + 1], w)
        };
        for (claim, linear) in certificate.claims.iter().zip(&linear.claims) {
            assert!(
                claim.margin <= linear.margin,
                "{round}: {claim:?} {linear:?}"
            );
            let id = claim.id;
            let compared = match id {
                ClaimId::RobotClearance
                | ClaimId::RobotsMissObjects
                | ClaimId::RobotsApart
                | ClaimId::Separation
                | ClaimId::NetReach
                | ClaimId::InsideArea
                | ClaimId::Abreast => sampled(&case, id, smooth).min(sampled(&case, id, even)),
                // The linear reading takes the hull of each step, which is more than its lines.
                ClaimId::NetEnclosesNoObstacle => sampled(&case, id, smooth).min(linear.margin),
                _ => continue,
            };
            // The depth of an overlap is not a distance, but an overlap is one.
            let overlaps = match id {
                ClaimId::NetEnclosesNoObstacle => compared <= 0.0,
                ClaimId::RobotClearance => compared <= -smallest,
                _ => false,
            };
            if overlaps {
                assert!(!claim.holds || compared == 0.0, "{round}: {claim:?}");
                continue;
            }
            assert!(
                claim.margin <= compared + 1e-9,
                "{round}: {claim:?}, sampled {compared}"
            );
            // Samples miss the least margin by what lies between them.
            assert!(
                claim.margin >= compared - 3e-4,
                "{round}: {claim:?}, sampled {compared}"
            );
            smooth_is_tighter += usize::from(claim.detail.ends_with("curve)"));
        }
        let covered = certificate
            .claims
            .iter()
            .find(|c| c.id == ClaimId::EveryObjectCovered);
        let covered = covered.unwrap();
        let passages = case.scene.objects.iter().map(|o| {
            let both = (
                passed(&case, o.position, smooth),
                passed(&case, o.position, even),
            );
            Some(both.0?.min(both.1?))
        });
        let least = passages.reduce(|a, b| Some(a?.min(b?))).flatten();
        match least {
            Some(least) if least > 1e-3 => assert!(
                covered.margin <= least + 1e-3 && covered.margin >= least - 1e-3,
                "{round}: {covered:?}, sampled {least}"
            ),
            Some(_) => {}
            None => assert!(
                !covered.holds || covered.margin < 1e-3,
                "{round}: {covered:?}"
            ),
        }
    }
    assert!(smooth_is_tighter > 60, "{smooth_is_tighter}");
}
