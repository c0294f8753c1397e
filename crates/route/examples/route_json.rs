//! Plans the route of a generated scene and prints it as JSON with the seconds of each stage, for plots and profiles.
//!
//! `cargo run --release -p pairtrawl-route --example route_json -- witness:7:1:250 > route.json`
//! A second argument is a seed and takes RRT* instead of hybrid A*.

use pairtrawl_generate::{Kind, generate};
use pairtrawl_geometry::{Convex, Pose};
use pairtrawl_route::{baseline, hybrid_a_star, rrt_star, visiting_order};
use pairtrawl_world::World;
use serde_json::{Value, json};
use std::time::Instant;

fn poses(poses: &[Pose]) -> Vec<[f64; 3]> {
    poses.iter().map(|&p| p.into()).collect()
}

fn main() {
    let what = std::env::args()
        .nth(1)
        .expect("usage: route_json KIND:DIFFICULTY:SEED:WAYPOINTS [RRT_SEED]");
    let parts: Vec<&str> = what.split(':').collect();
    let kind = if parts[0] == "serpentine" {
        Kind::Serpentine
    } else {
        Kind::Witness
    };
    let number = |i: usize| parts[i].parse::<u64>().expect("a number");
    let made =
        generate(kind, number(1) as u8, number(2), number(3) as usize).expect("a generated scene");
    let (scene, witness) = (made.scene, made.witness);
    let t0 = Instant::now();
    let world = World::new(&scene, scene.net.length).expect("a world");
    let t1 = Instant::now();
    let order = visiting_order(&world, &scene).expect("an order");
    let t2 = Instant::now();
    let centerline = match std::env::args().nth(2) {
        Some(seed) => {
            rrt_star::centerline(&world, &scene, &order, seed.parse().expect("a seed"), 2000)
        }
        None => hybrid_a_star::centerline(&world, &scene, &order),
    }
    .expect("a centerline");
    let t3 = Instant::now();
    let pair = baseline(&world, &scene, &centerline, &order, None).expect("a baseline");
    let t4 = Instant::now();
    let pieces: Vec<Value> = world
        .pieces
        .iter()
        .map(|p| match p {
            Convex::Polygon(v) => json!(v.iter().map(|p| [p.x, p.y]).collect::<Vec<_>>()),
            Convex::Circle { center, radius } => {
                json!({"center": [center.x, center.y], "radius": radius})
            }
        })
        .collect();
    let out = json!({
        "name": scene.name,
        "area": [scene.area.min.x, scene.area.min.y, scene.area.max.x, scene.area.max.y],
        "net_length": scene.net.length,
        "obstacles": pieces,
        "objects": scene.objects.iter().map(|o| [o.position.x, o.position.y, o.footprint_radius()]).collect::<Vec<_>>(),
        "circles": world.circles.iter().map(|c| [c.center.x, c.center.y, c.radius]).collect::<Vec<_>>(),
        "order": order,
        "centerline": poses(&centerline),
        "left": poses(&pair.left),
        "right": poses(&pair.right),
        "witness": [poses(&witness.left), poses(&witness.right)],
        "seconds": {
            "world": (t1 - t0).as_secs_f64(), "order": (t2 - t1).as_secs_f64(),
            "centerline": (t3 - t2).as_secs_f64(), "baseline": (t4 - t3).as_secs_f64(),
        },
    });
    println!("{out}");
}
