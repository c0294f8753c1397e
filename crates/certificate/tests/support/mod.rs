//! Reads the compact witness files; the project's own readers live above this crate.

#![allow(dead_code, reason = "each test file uses a part of this module")]

pub mod brute;
pub mod brute_shapes;
pub mod build;
pub mod furnish;
pub mod random;

use pairtrawl_certificate::certify;
use pairtrawl_geometry::{Point, Pose};
use pairtrawl_model::{
    Area, Claim, Footprint, NetSpec, Object, Obstacle, PairPose, PairTrajectory, PhysicsParameters,
    PlannerParameters, Robot, Scene,
};
use serde_json::Value;

/// A scene with a net length and trajectories.
#[derive(Clone, Debug)]
pub struct Case {
    pub scene: Scene,
    pub net_length: f64,
    pub trajectory: PairTrajectory,
}

/// One claim of a case's certificate.
pub fn claim(case: &Case, name: &str) -> Claim {
    let certificate = certify(&case.scene, case.net_length, &case.trajectory, None);
    certificate
        .claims
        .into_iter()
        .find(|c| c.id.name() == name)
        .expect("a known claim")
}

/// `tests/data/witness-<n>.json`.
pub fn witness(n: usize) -> Case {
    let path = format!("{}/tests/data/witness-{n}.json", env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read_to_string(&path).expect("the witness file is part of the repository");
    let value: Value = serde_json::from_str(&text).expect("valid JSON");
    let poses = |key: &str| {
        list(&value[key])
            .iter()
            .map(|p| Pose::new(number(&p[0]), number(&p[1]), number(&p[2])))
            .collect()
    };
    Case {
        scene: scene(&value["scene"]),
        net_length: number(&value["net_length"]),
        trajectory: PairTrajectory {
            left: poses("left"),
            right: poses("right"),
            step_time: number(&value["step_time"]),
        },
    }
}

fn scene(value: &Value) -> Scene {
    let area = &value["area"];
    Scene {
        name: value["name"].as_str().expect("a name").to_owned(),
        area: Area {
            min: point(&area["min"]),
            max: point(&area["max"]),
            resolution: number(&area["resolution"]),
        },
        obstacles: list(&value["obstacles"]).iter().map(obstacle).collect(),
        map: None,
        objects: list(&value["objects"]).iter().map(object).collect(),
        start: pair(&value["start"]),
        end: pair(&value["end"]),
        robot: Robot {
            radius: number(&value["robot"]["radius"]),
            ..Robot::default()
        },
        net: NetSpec {
            length: value["net"]["length"].as_f64(),
            start: None,
        },
        planner: PlannerParameters::default(),
        physics: PhysicsParameters::default(),
    }
}

fn obstacle(value: &Value) -> Obstacle {
    let b = &value["box"];
    Obstacle::Box {
        min: Point::new(number(&b[0]), number(&b[1])),
        max: Point::new(number(&b[2]), number(&b[3])),
    }
}

fn object(value: &Value) -> Object {
    let size = &value["size"];
    Object {
        position: point(&value["position"]),
        footprint: Footprint::Box(number(&size[0]), number(&size[1])),
        mass: number(&value["mass"]),
        leave: false,
    }
}

fn pair(value: &Value) -> PairPose {
    let heading = number(&value["heading"]);
    PairPose {
        left: Pose::at(point(&value["left"]), heading),
        right: Pose::at(point(&value["right"]), heading),
    }
}

fn list(value: &Value) -> &[Value] {
    value.as_array().map_or(&[], Vec::as_slice)
}

fn number(value: &Value) -> f64 {
    value.as_f64().expect("a number")
}

fn point(value: &Value) -> Point {
    Point::new(number(&value[0]), number(&value[1]))
}
