//! Enough of the scene format for development: no maps, no checks.

use pairtrawl_geometry::{Point, Pose};
use pairtrawl_model::{
    Area, Footprint, NetSpec, Object, Obstacle, PairPose, PhysicsParameters, PlannerParameters,
    Robot, Scene,
};
use toml::{Table, Value};

fn number(v: &Value) -> f64 {
    v.as_float()
        .or_else(|| v.as_integer().map(|i| i as f64))
        .expect("a number")
}

fn numbers(v: &Value) -> Vec<f64> {
    v.as_array().expect("an array").iter().map(number).collect()
}

fn point(v: &Value) -> Point {
    let n = numbers(v);
    Point::new(n[0], n[1])
}

fn pair(t: &Table, key: &str) -> PairPose {
    let end = t[key].as_table().expect("a table");
    let heading = |side: &str| number(end.get(side).unwrap_or_else(|| &end["heading"]));
    PairPose {
        left: Pose::at(point(&end["left"]), heading("left_heading")),
        right: Pose::at(point(&end["right"]), heading("right_heading")),
    }
}

fn list<'t>(t: &'t Table, key: &str) -> Vec<&'t Table> {
    t.get(key)
        .map(|v| {
            v.as_array()
                .expect("an array")
                .iter()
                .map(|e| e.as_table().expect("a table"))
                .collect()
        })
        .unwrap_or_default()
}

pub fn read(text: &str) -> Scene {
    let t: Table = text.parse().expect("TOML");
    let area = t["area"].as_table().expect("a table");
    let obstacle = |o: &&Table| {
        if let Some(b) = o.get("box") {
            let n = numbers(b);
            Obstacle::Box {
                min: Point::new(n[0], n[1]),
                max: Point::new(n[2], n[3]),
            }
        } else if let Some(c) = o.get("circle") {
            let n = numbers(c);
            Obstacle::Circle {
                center: Point::new(n[0], n[1]),
                radius: n[2],
            }
        } else {
            Obstacle::Polygon(
                o["polygon"]
                    .as_array()
                    .expect("an array")
                    .iter()
                    .map(point)
                    .collect(),
            )
        }
    };
    let object = |o: &&Table| Object {
        position: point(&o["position"]),
        footprint: match o.get("size") {
            Some(s) => Footprint::Box(numbers(s)[0], numbers(s)[1]),
            None => Footprint::Disc(number(&o["radius"])),
        },
        mass: o.get("mass").map_or(0.025, number),
    };
    Scene {
        name: t["name"].as_str().expect("a string").into(),
        area: Area {
            min: point(&area["min"]),
            max: point(&area["max"]),
            resolution: number(&area["resolution"]),
        },
        obstacles: list(&t, "obstacles").iter().map(obstacle).collect(),
        map: None,
        objects: list(&t, "objects").iter().map(object).collect(),
        start: pair(&t, "start"),
        end: pair(&t, "end"),
        robot: Robot::default(),
        net: NetSpec {
            length: t.get("net").and_then(|n| n.get("length")).map(number),
            start: None,
        },
        planner: PlannerParameters::default(),
        physics: PhysicsParameters::default(),
    }
}
