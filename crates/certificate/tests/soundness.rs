//! What a valid plan solves is never proven infeasible.

mod support;

use pairtrawl_certificate::certify;
use pairtrawl_certificate::infeasibility::{Proof, ProofKind, prove, verify};
use pairtrawl_geometry::Point;
use pairtrawl_model::{Body, BodyCircle, Footprint, Object, Obstacle, Preset, Robot};
use support::build::{Leg, drive, hall};
use support::furnish::furnish;
use support::random::Random;

#[test]
fn scenes_with_a_valid_plan_have_no_proof() {
    check(7, Robot::default());
}

#[test]
fn scenes_with_a_valid_plan_for_a_body_have_no_proof() {
    check(8, Preset::WafflePi.robot());
    let circle = |x: f64, y: f64, radius: f64| BodyCircle {
        center: Point::new(x, y),
        radius,
    };
    let boat = [
        circle(0.12, 0.0, 0.08),
        circle(0.0, 0.02, 0.12),
        circle(-0.12, 0.0, 0.1),
    ];
    check(9, Robot::default().with_body(Body::of(&boat).unwrap()));
}

/// A gap that a Waffle passes and its disc does not, and one that is too narrow for the Waffle as well.
#[test]
fn ways_are_cut_for_what_a_body_does_not_pass() {
    for (gap, robot, cut) in [
        (0.49, Robot::default(), false),
        (0.40, Robot::default(), true),
        (0.40, Preset::WafflePi.robot(), false),
        (0.35, Preset::WafflePi.robot(), true),
    ] {
        let mut scene = hall(9.0, 7.0, 3.0, 7.0);
        scene.robot = robot;
        let wall = |low: f64, high: f64| Obstacle::Box {
            min: Point::new(4.0, low),
            max: Point::new(4.2, high),
        };
        // From one side of the area to the other.
        scene.obstacles = vec![wall(0.0, 3.0), wall(3.0 + gap, 7.0)];
        let proofs = prove(&scene, Some(1.2));
        let way_cut = |proof: &Proof| matches!(proof.kind, ProofKind::WayCut { .. });
        assert_eq!(
            proofs.iter().any(way_cut),
            cut,
            "{gap} {robot:?}: {proofs:?}"
        );
        for proof in &proofs {
            verify(&scene, Some(1.2), None, &proof.kind, proof.least_move).unwrap();
            if robot.body.is_some() {
                let words = "wide, a robot needs 0.380 m";
                assert!(proof.message.contains(words), "{}", proof.message);
            }
        }
    }
}

/// Behind the start an object stays out of reach of a line whose robots cannot turn, but beside a wall it is the body that
/// decides: a Waffle passes between both where its disc does not.
#[test]
fn objects_are_pinned_for_what_a_body_does_not_pass() {
    for (gap, robot, pinned) in [
        (0.50, Robot::default(), false),
        (0.40, Robot::default(), true),
        (0.40, Preset::WafflePi.robot(), false),
        (0.355, Preset::WafflePi.robot(), true),
    ] {
        let mut scene = hall(9.0, 7.0, 3.0, 7.0);
        scene.robot = robot;
        scene.obstacles = vec![Obstacle::Box {
            min: Point::new(3.0, 4.5),
            max: Point::new(5.0, 4.7),
        }];
        let object = Object {
            position: Point::new(4.0, 4.5 - gap - 0.03),
            footprint: Footprint::Disc(0.03),
            mass: 0.02,
            leave: false,
        };
        scene.objects = vec![object];
        let is_pin = |proof: &Proof| matches!(proof.kind, ProofKind::ObjectPinned { .. });
        let proofs = prove(&scene, Some(1.2));
        assert_eq!(
            proofs.iter().any(is_pin),
            pinned,
            "{gap} {robot:?}: {proofs:?}"
        );
        for proof in &proofs {
            verify(&scene, Some(1.2), None, &proof.kind, proof.least_move).unwrap();
        }
    }
}

fn check(seed: u64, robot: Robot) {
    let mut random = Random(seed);
    let mut pinned_but_for_a_line = 0;
    for round in 0..42 {
        let mut scene = hall(9.0, 7.0, 3.0, 5.0);
        scene.robot = robot;
        let mut leg = |steps: usize| Leg {
            steps: 5 + random.below(steps),
            forward: random.within(0.02, 0.035),
            turn: random.within(-0.03, 0.03),
        };
        let legs = [leg(20), leg(20), leg(20), leg(20)];
        let mut case = drive(&scene, &legs, 1.2);
        furnish(&mut case, round % 7, &mut random, |case| {
            certify(&case.scene, case.net_length, &case.trajectory, None).is_valid()
        });
        let certificate = certify(&case.scene, case.net_length, &case.trajectory, None);
        assert!(certificate.is_valid(), "round {round}: {certificate:#?}");
        for net_length in [Some(case.net_length), None] {
            let proof = prove(&case.scene, net_length);
            assert!(proof.is_empty(), "round {round}: {proof:?}");
        }
        // Had no line stood between, an object this close to an obstacle would have been a proof.
        let mut away = case.scene.clone();
        for pair in [&mut away.start, &mut away.end] {
            for pose in [&mut pair.left, &mut pair.right] {
                pose.y += 100.0;
            }
        }
        let pinned = |proof: &Proof| matches!(proof.kind, ProofKind::ObjectPinned { .. });
        pinned_but_for_a_line += usize::from(prove(&away, None).iter().any(pinned));
    }
    assert!(
        pinned_but_for_a_line >= 10,
        "{pinned_but_for_a_line}: the scenes are too easy"
    );
}
