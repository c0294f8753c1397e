//! What the generator promises: every scene comes with a solution that holds every claim, the same for the same seed, and
//! harder the higher the difficulty.

use pairtrawl_certificate::certify;
use pairtrawl_generate::{GenerateError, Generated, Kind, generate};

fn generated(kind: Kind, difficulty: u8, seed: u64, waypoints: usize) -> Generated {
    generate(kind, difficulty, seed, waypoints).expect("a scene for every seed")
}

fn margin(generated: &Generated, claim: &str) -> f64 {
    let certificate = certify(
        &generated.scene,
        generated.net_length,
        &generated.witness,
        None,
    );
    certificate
        .claims
        .iter()
        .find(|c| c.id.name() == claim)
        .map_or(f64::NAN, |c| c.margin)
}

#[test]
fn every_witness_holds_every_claim() {
    for difficulty in 1..=10 {
        for seed in 1..=8 {
            let g = generated(Kind::Witness, difficulty, seed, 120);
            let certificate = certify(&g.scene, g.net_length, &g.witness, None);
            let broken: Vec<_> = certificate.claims.iter().filter(|c| !c.holds).collect();
            assert!(
                certificate.is_valid(),
                "difficulty {difficulty}, seed {seed}: {broken:?}"
            );
            assert!(
                !g.scene.objects.is_empty(),
                "difficulty {difficulty}, seed {seed}: nothing to gather"
            );
        }
    }
}

#[test]
fn every_serpentine_witness_holds_every_claim() {
    for difficulty in [1, 5, 10] {
        let g = generated(Kind::Serpentine, difficulty, 3, 900);
        let certificate = certify(&g.scene, g.net_length, &g.witness, None);
        let broken: Vec<_> = certificate.claims.iter().filter(|c| !c.holds).collect();
        assert!(
            certificate.is_valid(),
            "difficulty {difficulty}: {broken:?}"
        );
    }
}

#[test]
fn a_seed_gives_the_same_bits_and_another_seed_another_scene() {
    let bits = |g: &Generated| {
        g.witness
            .left
            .iter()
            .map(|p| p.x.to_bits())
            .collect::<Vec<_>>()
    };
    let (a, b) = (
        generated(Kind::Witness, 6, 11, 150),
        generated(Kind::Witness, 6, 11, 150),
    );
    assert_eq!(bits(&a), bits(&b));
    assert_eq!(a.scene, b.scene);
    assert_ne!(a.scene, generated(Kind::Witness, 6, 12, 150).scene);
}

#[test]
fn difficulty_takes_the_room_away() {
    let median = |difficulty: u8, claim: &str| {
        let mut margins: Vec<f64> = (1..=7)
            .map(|seed| margin(&generated(Kind::Witness, difficulty, seed, 120), claim))
            .collect();
        margins.sort_by(f64::total_cmp);
        margins[margins.len() / 2]
    };
    for claim in ["robot_clearance", "robots_miss_objects"] {
        let (easy, hard) = (median(1, claim), median(10, claim));
        assert!(
            hard < 0.5 * easy,
            "{claim}: {hard} m at difficulty 10, {easy} m at 1"
        );
        assert!(hard < 0.02, "{claim}: {hard} m is left at difficulty 10");
    }
}

#[test]
fn arguments_out_of_range_are_refused() {
    assert!(matches!(
        generate(Kind::Witness, 0, 1, 200),
        Err(GenerateError::Difficulty(0))
    ));
    assert!(matches!(
        generate(Kind::Witness, 11, 1, 200),
        Err(GenerateError::Difficulty(11))
    ));
    assert!(matches!(
        generate(Kind::Witness, 5, 1, 3),
        Err(GenerateError::Waypoints(3))
    ));
}
