//! All objects that cannot be swept are found, what is left needs no proof, least moves help, and proofs verify.

mod support;

use pairtrawl_certificate::certify;
use pairtrawl_certificate::infeasibility::{ProofKind, Refusal, impossible_objects, prove, verify};
use pairtrawl_geometry::Point;
use pairtrawl_model::Scene;
use support::build::{cube, hall, straight, wall};

/// Objects 1 and 4 too close to a wall, 2 too close to the edge, 3 in a closed box; 0 and 5 free.
fn cluttered() -> Scene {
    let mut scene = hall(12.0, 8.0, 4.0, 10.0);
    scene.obstacles.push(wall(2.0, 6.0, 7.0, 6.3));
    scene.obstacles.extend([
        wall(8.0, 1.0, 9.6, 1.1),
        wall(8.0, 2.5, 9.6, 2.6),
        wall(8.0, 1.0, 8.1, 2.6),
        wall(9.5, 1.0, 9.6, 2.6),
    ]);
    scene.objects = vec![
        cube(5.0, 4.0),
        cube(3.0, 5.7),
        cube(6.0, 0.1),
        cube(8.8, 1.8),
        cube(4.0, 6.5),
        cube(7.0, 4.2),
    ];
    scene
}

#[test]
fn every_object_that_cannot_be_swept_is_named_with_its_own_proof() {
    let scene = cluttered();
    let proofs = prove(&scene, Some(2.0));
    let kinds: Vec<_> = (proofs.iter())
        .map(|proof| (proof.object(), proof.kind.name()))
        .collect();
    assert_eq!(
        kinds,
        [
            (Some(1), "object_pinned"),
            (Some(2), "object_at_edge"),
            (Some(3), "object_enclosed"),
            (Some(4), "object_pinned"),
        ]
    );
    assert_eq!(impossible_objects(&scene, Some(2.0)), [1, 2, 3, 4]);
    // What is left needs no proof, and the rest is not called impossible.
    assert_eq!(prove(&scene.leaving([1, 2, 3, 4]), Some(2.0)), []);
    let without_one = prove(&scene.leaving([1, 3, 4]), Some(2.0));
    assert_eq!(without_one.len(), 1);
    assert_eq!(without_one[0].object(), Some(2));
}

#[test]
fn the_least_move_helps_and_half_of_it_does_not() {
    let scene = cluttered();
    let mut seen = 0;
    for proof in prove(&scene, Some(2.0)) {
        let (Some(object), Some(least)) = (proof.object(), proof.least_move) else {
            continue;
        };
        seen += 1;
        let at = |p: Point| {
            let mut moved = scene.clone();
            moved.objects[object].position = p;
            let proofs = prove(&moved, Some(2.0));
            proofs.iter().any(|other| other.object() == Some(object))
        };
        let from = scene.objects[object].position;
        assert!((least.distance - least.to.distance(from)).abs() < 1e-12);
        assert!(!at(least.to), "{}", proof.message);
        assert!(at(from.lerp(least.to, 0.5)), "{}", proof.message);
    }
    assert_eq!(seen, 4, "every object of this scene has a place nearby");
    // Away from a straight wall nothing is nearer than straight away from it.
    let proofs = prove(&scene, None);
    let rho = 0.5 * Point::new(0.05, 0.05).norm();
    let least = proofs[0].least_move.expect("a move").distance;
    let exact = 0.48 - (0.3 - rho);
    assert!((least - exact).abs() < 1e-4, "{least} for {exact}");
}

#[test]
fn proofs_verify_and_change_with_the_scene() {
    let scene = cluttered();
    let net = Some(2.0);
    for proof in prove(&scene, net) {
        let verified = verify(&scene, net, None, &proof.kind, proof.least_move);
        assert_eq!(verified, Ok(()), "{proof}");
        // In a scene where the object lies elsewhere the argument is another one, or none.
        let mut moved = scene.clone();
        let object = proof.object().expect("all are about objects");
        moved.objects[object].position = Point::new(5.5, 3.5);
        let verified = verify(&moved, net, None, &proof.kind, None);
        assert_eq!(verified, Err(Refusal::DoesNotHold), "{proof}");
    }
    let gone = ProofKind::ObjectTooWide {
        object: 6,
        net_length: 2.0,
        needed: 3.0,
    };
    let verified = verify(&scene, net, None, &gone, None);
    assert_eq!(verified, Err(Refusal::NoSuchThing));
}

#[test]
fn an_object_that_is_left_need_not_be_covered_but_must_be_missed() {
    let mut case = straight();
    let far = case.scene.objects.len();
    case.scene.objects.push(cube(6.0, 3.5));
    let valid = |scene: &Scene| {
        certify(scene, case.net_length, &case.trajectory, None)
            .claims
            .into_iter()
            .filter(|claim| !claim.holds)
            .map(|claim| claim.id.name())
            .collect::<Vec<_>>()
    };
    assert_eq!(valid(&case.scene), ["every_object_covered"]);
    assert!(valid(&case.scene.leaving([far])).is_empty());
    // On the path of the left robot it stays in the way.
    let mut in_the_way = case.scene.leaving([far]);
    in_the_way.objects[far].position = case.trajectory.left[5].position();
    assert_eq!(valid(&in_the_way), ["robots_miss_objects"]);
}
