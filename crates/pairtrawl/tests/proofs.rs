//! Proofs are sound, verify from their file, and do not when a number of theirs is changed.

use pairtrawl::certificate::certify;
use pairtrawl::certificate::infeasibility::prove;
use pairtrawl::files::{infeasible_json, parse_infeasible, parse_scene, read_scene};
use pairtrawl::generate::{Kind, generate};
use pairtrawl::geometry::Point;
use pairtrawl::model::{Footprint, Object, Overrides, PairTrajectory, Scene, SceneReference};
use pairtrawl::{check_proofs, model::Obstacle};
use serde_json::Value;
use std::path::Path;

/// Numbers that look random and are the same in every run.
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.next()
    }
}

/// Objects close to obstacles and to the edge that the known plan sweeps and misses all the same.
fn tempting_objects(
    scene: &Scene,
    trajectory: &PairTrajectory,
    net_length: f64,
    random: &mut Random,
) -> Vec<Object> {
    let mut found = Vec::new();
    for k in 0..80 {
        // Every fourth one lies under the first or the last line, where nothing else need pass beside it.
        let i = match k % 8 {
            0 => 0,
            4 => trajectory.len() - 1,
            _ => (random.next() * trajectory.len() as f64) as usize,
        };
        let pair = trajectory.pair(i);
        // As close to a robot as it can be, on either side.
        let beside = random.between(1.01, 1.3) * (scene.robot.radius + 0.03) / pair.separation();
        let share = if k % 2 == 0 { beside } else { 1.0 - beside };
        let at = pair.left.position().lerp(pair.right.position(), share);
        let object = Object {
            position: at,
            footprint: Footprint::Disc(random.between(0.005, 0.03)),
            mass: 0.02,
            leave: false,
        };
        let keep = scene.robot.radius + object.footprint_radius();
        let missed = [&trajectory.left, &trajectory.right]
            .into_iter()
            .flatten()
            .all(|pose| pose.position().distance(at) > keep);
        let lies_free = scene.objects.iter().all(|other| {
            other.position.distance(at) > other.footprint_radius() + object.footprint_radius()
        });
        if !missed || !lies_free {
            continue;
        }
        let mut with = scene.clone();
        with.objects = vec![object];
        if certify(&with, net_length, trajectory, None).is_valid() {
            found.push(object);
        }
    }
    found
}

#[test]
fn no_object_of_a_known_plan_is_called_impossible() {
    let (mut scenes, mut objects, mut near) = (0, 0, 0);
    let mut random = Random(5);
    for seed in 0..200_u64 {
        let difficulty = (seed % 10 + 1) as u8;
        let kind = match seed % 3 {
            0 => Kind::Serpentine,
            _ => Kind::Witness,
        };
        let Ok(made) = generate(kind, difficulty, 1000 + seed, 300) else {
            continue;
        };
        let mut scene = made.scene;
        scenes += 1;
        if seed % 4 == 0 {
            let more = tempting_objects(&scene, &made.witness, made.net_length, &mut random);
            near += more.iter().filter(|object| is_near(&scene, object)).count();
            scene.objects.extend(more);
        }
        objects += scene.objects.len();
        for net_length in [Some(made.net_length), None] {
            let proofs = prove(&scene, net_length);
            assert!(proofs.is_empty(), "seed {seed}: {}", proofs[0]);
        }
    }
    println!("{scenes} scenes, {objects} objects, {near} of them in narrow places");
    assert!(
        scenes >= 150 && near >= 20,
        "{scenes} scenes, {near} in narrow places"
    );
}

/// True when an obstacle is not much farther away than a robot needs.
fn is_near(scene: &Scene, object: &Object) -> bool {
    let reach = 3.0 * scene.robot.radius + object.footprint_radius();
    scene.obstacles.iter().any(|obstacle| {
        let p = object.position;
        match obstacle {
            Obstacle::Box { min, max } => {
                let nearest = Point::new(p.x.clamp(min.x, max.x), p.y.clamp(min.y, max.y));
                nearest.distance(p) < reach
            }
            Obstacle::Circle { center, radius } => center.distance(p) - radius < reach,
            Obstacle::Polygon(vertices) => vertices.iter().any(|v| v.distance(p) < reach),
        }
    })
}

#[test]
fn no_object_of_a_shipped_scene_is_called_impossible() {
    let library = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes");
    let mut count = 0;
    for entry in std::fs::read_dir(library).expect("the library") {
        let path = entry.expect("an entry").path().join("scene.toml");
        if path.is_file() {
            let loaded = read_scene(&path).expect("a scene");
            for net_length in [loaded.scene.net.length, None] {
                assert_eq!(prove(&loaded.scene, net_length), [], "{}", path.display());
            }
            count += 1;
        }
    }
    assert!(count >= 14, "{count} scenes");
}

/// A scene with every kind of proof about objects.
const ALL_KINDS: &str = r#"
format = "pairtrawl-scene/1"
name = "all kinds"
area = { min = [0.0, 0.0], max = [12.0, 8.0] }
start = { left = [1.0, 4.4], right = [1.0, 3.6], heading = 0.0 }
end = { left = [10.0, 4.4], right = [10.0, 3.6], heading = 0.0 }
net = { length = 2.0 }
obstacles = [
    { box = [2.0, 6.0, 7.0, 6.3] },
    { box = [8.0, 1.0, 9.6, 1.1] }, { box = [8.0, 2.5, 9.6, 2.6] },
    { box = [8.0, 1.0, 8.1, 2.6] }, { box = [9.5, 1.0, 9.6, 2.6] },
]
objects = [
    { position = [5.0, 4.0], radius = 0.03 },
    { position = [3.0, 5.7], radius = 0.03 },
    { position = [6.0, 0.1], radius = 0.03 },
    { position = [8.8, 1.8], radius = 0.03 },
    { position = [6.0, 2.0], radius = 0.8 },
]
"#;

struct Case {
    scene: Scene,
    reference: SceneReference,
    overrides: Overrides,
    waypoints: Option<usize>,
}

/// Scenes that together have every kind of proof.
fn cases() -> Vec<Case> {
    let case = |text: &str, net: Option<f64>, waypoints: Option<usize>| {
        let loaded = parse_scene(text, "a test").expect("a scene");
        Case {
            scene: loaded.scene,
            reference: loaded.reference,
            overrides: Overrides {
                net_length: net.map(Some),
                leave: None,
            },
            waypoints,
        }
    };
    let wall = ALL_KINDS.replace(
        "{ box = [2.0, 6.0, 7.0, 6.3] },",
        "{ box = [4.0, 0.0, 4.2, 8.0] },",
    );
    vec![
        case(ALL_KINDS, None, None),
        case(ALL_KINDS, Some(0.7), None),
        case(ALL_KINDS, Some(9.0), None),
        case(ALL_KINDS, None, Some(20)),
        case(&wall, None, None),
    ]
}

#[test]
fn every_number_of_every_proof_is_verified() {
    let mut kinds = Vec::new();
    for case in cases() {
        let net_length = case.overrides.net_length.unwrap_or(case.scene.net.length);
        let mut proofs = prove(&case.scene, net_length);
        proofs.extend(case.waypoints.and_then(|n| {
            pairtrawl::certificate::infeasibility::too_few_waypoints(&case.scene, n)
        }));
        assert!(!proofs.is_empty());
        kinds.extend(proofs.iter().map(|proof| proof.kind.name()));
        let text = infeasible_json(&proofs, &case.reference, &case.overrides, case.waypoints)
            .expect("JSON");
        assert!(is_valid(&case, &text), "{text}");
        let file: Value = serde_json::from_str(&text).expect("JSON");
        let mut places = Vec::new();
        for (i, proof) in file["proofs"]
            .as_array()
            .expect("proofs")
            .iter()
            .enumerate()
        {
            for part in ["evidence", "least_move", "objects"] {
                numbers(&proof[part], format!("/proofs/{i}/{part}"), &mut places);
            }
        }
        assert!(places.len() >= 2);
        for place in places {
            let mut changed = file.clone();
            let number = changed.pointer_mut(&place).expect("a number");
            *number = match number.as_u64() {
                Some(count) => (count + 1).into(),
                // A place beside the way of a move is hardly farther away.
                None if place.contains("least_move") => {
                    (number.as_f64().expect("a number") + 1e-3).into()
                }
                None => (number.as_f64().expect("a number") + 1e-6).into(),
            };
            assert!(!is_valid(&case, &changed.to_string()), "{place} in {text}");
        }
        // Which robot, and which scene.
        if text.contains("\"robot\": \"left\"") {
            let other = text.replacen("\"robot\": \"left\"", "\"robot\": \"right\"", 1);
            assert!(!is_valid(&case, &other));
        }
        let elsewhere = text.replace(&case.reference.sha256, "00").replace(
            case.reference.content_sha256.as_deref().expect("a hash"),
            "11",
        );
        assert!(!is_valid(&case, &elsewhere));
    }
    kinds.sort_unstable();
    kinds.dedup();
    assert_eq!(
        kinds,
        [
            "net_too_long",
            "net_too_short",
            "object_at_edge",
            "object_enclosed",
            "object_pinned",
            "object_too_wide",
            "too_few_waypoints",
            "way_cut",
        ]
    );
}

fn is_valid(case: &Case, text: &str) -> bool {
    match parse_infeasible(text, Path::new("infeasible.json")) {
        Ok(file) => check_proofs(&case.scene, &case.reference, &file).is_valid(),
        Err(_) => false,
    }
}

/// JSON pointers to all numbers of a value.
fn numbers(value: &Value, at: String, found: &mut Vec<String>) {
    match value {
        Value::Number(_) => found.push(at),
        Value::Array(list) => {
            for (i, value) in list.iter().enumerate() {
                numbers(value, format!("{at}/{i}"), found);
            }
        }
        Value::Object(map) => {
            for (key, value) in map {
                numbers(value, format!("{at}/{key}"), found);
            }
        }
        _ => {}
    }
}

#[test]
fn files_with_proofs_that_mean_nothing_are_refused_in_words() {
    let case = &cases()[0];
    let proofs = prove(&case.scene, case.scene.net.length);
    let text = infeasible_json(&proofs, &case.reference, &case.overrides, None).expect("JSON");
    let refusal = |text: &str| {
        let read = parse_infeasible(text, Path::new("infeasible.json"));
        read.expect_err("refused").to_string()
    };
    let mut file: Value = serde_json::from_str(&text).expect("JSON");
    file["proofs"][0]["objects"] = serde_json::json!([]);
    assert!(refusal(&file.to_string()).contains("proofs[0].objects"));
    file["proofs"] = serde_json::json!([]);
    assert!(refusal(&file.to_string()).contains("at least one proof"));
    assert!(
        refusal(&text.replace("infeasible/1", "infeasible/2")).contains("pairtrawl-infeasible/1")
    );
    assert!(refusal("{").contains("infeasible.json"));
}
