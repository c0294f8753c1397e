//! Input that cannot be judged fails with a reason; claims about files.

mod support;

use pairtrawl_certificate::{certify, net_length_claim, scene_claim};
use pairtrawl_geometry::{Point, Pose};
use pairtrawl_model::{Obstacle, OccupancyMap, Overrides, PairTrajectory, SceneReference};
use support::build::{cube, straight, wall};
use support::{Case, claim};

#[test]
fn what_cannot_be_judged_fails_with_a_reason() {
    let fails_all = |case: &Case, word: &str| {
        let certificate = certify(&case.scene, case.net_length, &case.trajectory, None);
        assert_eq!(certificate.claims.len(), 14);
        for claim in certificate.claims {
            assert!(!claim.holds && claim.detail.contains(word), "{claim:?}");
        }
    };
    let fails = |case: &Case, name: &str, word: &str| {
        let claim = claim(case, name);
        assert!(!claim.holds && claim.detail.contains(word), "{claim:?}");
    };
    let base = straight();
    let mut case = base.clone();
    case.trajectory.right.pop();
    fails_all(&case, "equally many");
    case.trajectory = PairTrajectory::default();
    fails_all(&case, "at least 2");
    for bad in [f64::NAN, f64::INFINITY, 1e300] {
        let mut case = base.clone();
        case.trajectory.right[3].heading = bad;
        fails_all(&case, "right robot");
        let mut case = base.clone();
        case.net_length = bad;
        if !bad.is_finite() {
            fails(&case, "separation", "net length");
            fails(&case, "net_reach", "net length");
        }
        let mut case = base.clone();
        case.scene.obstacles.push(wall(3.0, 0.0, bad, 1.0));
        fails(&case, "robot_clearance", "obstacle 0");
        fails(&case, "net_encloses_no_obstacle", "obstacle 0");
        let mut case = base.clone();
        case.scene.objects.push(cube(bad, 0.0));
        assert!(!claim(&case, "every_object_covered").holds);
    }
    for bad in [f64::NAN, 0.0, -0.3] {
        let mut case = base.clone();
        case.trajectory.step_time = bad;
        fails(&case, "speed", "step_time");
        let mut case = base.clone();
        case.net_length = bad;
        fails(&case, "net_reach", "net length");
    }
    let mut case = base.clone();
    case.scene.planner.max_step = f64::NAN;
    case.scene.robot.v_max = f64::NAN;
    for name in ["step", "speed", "inside_area"] {
        assert_eq!(claim(&case, name).holds, name == "inside_area", "{name}");
    }
    for bad in [f64::NAN, f64::INFINITY, 0.0, -0.24] {
        let mut case = base.clone();
        case.scene.robot.radius = bad;
        fails_all(&case, "radius");
    }
    let mut case = base.clone();
    let bow = [(3.0, 0.0), (4.0, 1.0), (4.0, 0.0), (3.0, 1.0)].map(|(x, y)| Point::new(x, y));
    case.scene.obstacles.push(Obstacle::Polygon(bow.to_vec()));
    fails(&case, "robot_clearance", "crosses or touches itself");
    let mut case = base.clone();
    let map = OccupancyMap {
        origin: Pose::default(),
        resolution: 0.1,
        columns: 1 << 40,
        rows: 1 << 40,
        blocked: vec![],
    };
    case.scene.map = Some(map);
    fails(&case, "robot_clearance", "map");
}

#[test]
fn files_claims_compare_hash_and_length() {
    let reference = |files: &str, content: Option<&str>| SceneReference {
        sha256: files.to_owned(),
        content_sha256: content.map(str::to_owned),
        ..SceneReference::default()
    };
    let scene = reference("ab12", Some("77"));
    assert!(scene_claim(&scene, &reference("AB12", None)).holds);
    assert!(!scene_claim(&scene, &reference("ab13", None)).holds);
    assert!(!scene_claim(&scene, &reference("ab13", Some("78"))).holds);
    let commented = scene_claim(&scene, &reference("ab13", Some("77")));
    assert!(commented.holds && commented.detail.contains("bytes of its files differ"));
    assert!(!scene_claim(&reference("ab12", None), &reference("ab13", None)).holds);
    let asked = |length| Overrides {
        net_length: Some(length),
        ..Overrides::default()
    };
    let as_is = Overrides::default();
    assert!(net_length_claim(1.5, Some(1.5), &as_is).holds);
    assert!(!net_length_claim(1.5, Some(1.4), &as_is).holds);
    assert!(net_length_claim(1.5, None, &as_is).holds);
    assert!(net_length_claim(1.5, Some(1.4), &asked(Some(1.5))).holds);
    assert!(!net_length_claim(1.4, Some(1.4), &asked(Some(1.5))).holds);
    assert!(net_length_claim(1.5, Some(1.4), &asked(None)).holds);
    for bad in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(!net_length_claim(bad, None, &as_is).holds);
    }
}
