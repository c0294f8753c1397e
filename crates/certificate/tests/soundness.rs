//! What a valid plan solves is never proven infeasible.

mod support;

use pairtrawl_certificate::certify;
use pairtrawl_certificate::infeasibility::{Proof, ProofKind, prove};
use support::build::{Leg, drive, hall};
use support::furnish::furnish;
use support::random::Random;

#[test]
fn scenes_with_a_valid_plan_have_no_proof() {
    let mut random = Random(7);
    let mut pinned_but_for_a_line = 0;
    for round in 0..42 {
        let scene = hall(9.0, 7.0, 3.0, 5.0);
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
