//! Drives a run that is given as JSON on standard input and prints what happened as JSON: the bridge by which other programs
//! (`bench/mujoco`) compare themselves with this engine.
//!
//! Input: `scene` as in a scene file (`obstacles`, `objects`, optional `robot.hitch`, `physics`, `net.start`), `net_length`,
//! `left`, `right` (poses), `step_time`, optional `engine` (`implicit` or `rapier`), `time_step`, `settle_time`, `frame_interval`; `export`: `mjcf` or `sdf` to print that instead.

use pairtrawl_execution::{evenly_sampled, rehearse};
use pairtrawl_geometry::{Point, Pose};
use pairtrawl_model::{
    Area, Footprint, NetSpec, Object, Obstacle, PairPose, PairTrajectory, PhysicsParameters,
    PlannerParameters, RehearsalRecord, Robot, Scene,
};
use pairtrawl_reference::Reference;
use pairtrawl_simulation::{Options, export};
use serde_json::{Value, json};
use std::error::Error;
use std::time::Instant;

fn main() -> Result<(), Box<dyn Error>> {
    let input: Value = serde_json::from_reader(std::io::stdin())?;
    let left = poses(&input["left"])?;
    let right = poses(&input["right"])?;
    let trajectory = PairTrajectory {
        left,
        right,
        step_time: number(&input["step_time"])?,
    };
    let scene = scene(&input["scene"], &trajectory)?;
    let net_length = number(&input["net_length"])?;
    let mut options = Options::default();
    if input["quick"].as_bool() == Some(true) {
        options = Options::quick();
    }
    if input["engine"] == "rapier" {
        options = Options::rapier();
    }
    let given = |key: &str, default: f64| input[key].as_f64().unwrap_or(default);
    options.time_step = given("time_step", options.time_step);
    options.settle_time = given("settle_time", options.settle_time);
    options.frame_interval = given("frame_interval", options.frame_interval);
    let reference = Reference::of_scene(&scene, &trajectory)?;
    // Other engines follow poses that are linear in time: the same motion, finely sampled.
    let sampled = evenly_sampled(&reference, 0.02);
    match input["export"].as_str() {
        Some("mjcf") => {
            println!("{}", export::mjcf(&scene, net_length, &sampled)?);
            return Ok(());
        }
        Some("sdf") => {
            println!("{}", export::sdf(&scene, net_length, &sampled)?);
            return Ok(());
        }
        _ => {}
    }
    let started = Instant::now();
    let record = rehearse(&scene, net_length, &reference, &options)?;
    let seconds = started.elapsed().as_secs_f64();
    println!("{}", report(&record, seconds));
    Ok(())
}

fn report(record: &RehearsalRecord, seconds: f64) -> Value {
    let pose = |p: Pose| json!([p.x, p.y, p.heading]);
    let frames: Vec<Value> = record
        .frames
        .iter()
        .map(|f| {
            json!({
                "time": f.time,
                "left": pose(f.robots.left), "right": pose(f.robots.right),
                "net": f.net.iter().map(|p| [p.x, p.y]).collect::<Vec<_>>(),
                "objects": f.objects.iter().map(|&p| pose(p)).collect::<Vec<_>>(),
                "tension": f.tension, "drive_force": f.drive_force,
            })
        })
        .collect();
    let events: Vec<Value> = record
        .events
        .iter()
        .map(|e| json!({"event": e.kind.describe(), "time": e.time, "place": [e.place.x, e.place.y]}))
        .collect();
    json!({
        "verdict": format!("{:?}", record.verdict), "events": events, "gathered": record.gathered,
        "max_tension": record.max_tension, "max_deviation": record.max_deviation,
        "mean_drive_force": record.mean_drive_force, "duration": record.duration,
        "real_time_factor": record.duration / seconds, "frames": frames, "warnings": record.warnings.iter().map(ToString::to_string).collect::<Vec<_>>(),
    })
}

fn scene(value: &Value, trajectory: &PairTrajectory) -> Result<Scene, Box<dyn Error>> {
    let list = |value: &Value| value.as_array().cloned().unwrap_or_default();
    let obstacles = list(&value["obstacles"])
        .iter()
        .map(|o| {
            let b = &o["box"];
            let c = &o["circle"];
            Ok(if b.is_array() {
                Obstacle::Box {
                    min: Point::new(number(&b[0])?, number(&b[1])?),
                    max: Point::new(number(&b[2])?, number(&b[3])?),
                }
            } else if c.is_array() {
                Obstacle::Circle {
                    center: Point::new(number(&c[0])?, number(&c[1])?),
                    radius: number(&c[2])?,
                }
            } else {
                Obstacle::Polygon(points(&o["polygon"])?)
            })
        })
        .collect::<Result<_, Box<dyn Error>>>()?;
    let objects = list(&value["objects"])
        .iter()
        .map(|o| {
            let footprint = match o["radius"].as_f64() {
                Some(radius) => Footprint::Disc(radius),
                None => Footprint::Box(number(&o["size"][0])?, number(&o["size"][1])?),
            };
            let position = Point::new(number(&o["position"][0])?, number(&o["position"][1])?);
            Ok(Object {
                position,
                footprint,
                mass: o["mass"].as_f64().unwrap_or(0.025),
                leave: false,
            })
        })
        .collect::<Result<_, Box<dyn Error>>>()?;
    let ends = |i: usize| -> Result<PairPose, Box<dyn Error>> {
        let pick = |poses: &[Pose]| poses.get(i).copied().ok_or("no waypoints");
        Ok(PairPose {
            left: pick(&trajectory.left)?,
            right: pick(&trajectory.right)?,
        })
    };
    let mut physics = PhysicsParameters::default();
    if let Some(friction) = value["physics"]["contact_friction"].as_f64() {
        physics.contact_friction = friction;
    }
    let start = match value["net"]["start"].is_array() {
        true => Some(points(&value["net"]["start"])?),
        false => None,
    };
    Ok(Scene {
        name: "drive".to_owned(),
        area: Area {
            min: Point::new(-100.0, -100.0),
            max: Point::new(100.0, 100.0),
            resolution: 0.05,
        },
        obstacles,
        map: None,
        objects,
        start: ends(0)?,
        end: ends(trajectory.len().saturating_sub(1))?,
        robot: Robot::default(),
        net: NetSpec {
            length: None,
            start,
        },
        planner: PlannerParameters::default(),
        physics,
    })
}

fn number(value: &Value) -> Result<f64, String> {
    value
        .as_f64()
        .ok_or_else(|| format!("{value} is not a number"))
}

fn points(value: &Value) -> Result<Vec<Point>, String> {
    let list = value
        .as_array()
        .ok_or_else(|| format!("{value} is not a list of points"))?;
    list.iter()
        .map(|p| Ok(Point::new(number(&p[0])?, number(&p[1])?)))
        .collect()
}

fn poses(value: &Value) -> Result<Vec<Pose>, String> {
    let list = value
        .as_array()
        .ok_or_else(|| format!("{value} is not a list of poses"))?;
    list.iter()
        .map(|p| Ok(Pose::new(number(&p[0])?, number(&p[1])?, number(&p[2])?)))
        .collect()
}
