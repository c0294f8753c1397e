//! Does the scene make sense? What is refused here is bad input; what only turns out to be impossible needs a proof.

use crate::files::toml_reader::Table;
use crate::files::{FileError, Problem};
use pairtrawl_geometry::{Convex, Point, Pose};
use pairtrawl_model::{Object, Obstacle, PairPose, RobotSize, Scene};
use pairtrawl_world::{convex_cover, footprint_outline, obstacle_pieces, overlap, signed_distance};

/// Bounds hold to this, m, as in the certificate.
const TOLERANCE: f64 = 1e-9;
/// The ends of a given net lie this close to the hitches, m, for robots of the paper's size.
const NET_END_TOLERANCE: f64 = 0.01;

pub(super) fn check(scene: &Scene, root: &Table<'_>) -> Result<(), FileError> {
    let pieces = convex_cover(scene).map_err(|e| root.error(e))?;
    let objects = root.array("objects", usize::MAX)?;
    for (i, object) in scene.objects.iter().enumerate() {
        if let Some(reason) = object_trouble(scene, &pieces, object) {
            return Err(objects[i].error(Problem::Conflict {
                field: format!("objects[{i}]"),
                reason,
            }));
        }
    }
    for (key, pair) in [("start", &scene.start), ("end", &scene.end)] {
        let table = root.require(key, "")?.table()?;
        if let Some((robot, reason)) = pair_trouble(scene, &pieces, key, pair) {
            return Err(table.error(Problem::Conflict {
                field: table.field(robot),
                reason,
            }));
        }
    }
    if let (Some(net), Some(table)) = (&scene.net.start, root.table("net")?)
        && let Some(reason) = net_trouble(scene, net)
    {
        return Err(table.error(Problem::Conflict {
            field: table.field("start"),
            reason,
        }));
    }
    Ok(())
}

fn object_trouble(scene: &Scene, pieces: &[Convex], object: &Object) -> Option<String> {
    let p = object.position;
    if is_outside(scene, p) {
        return Some(format!(
            "its center ({}, {}) lies outside of the area, {}: move it inside",
            p.x,
            p.y,
            area_text(scene)
        ));
    }
    let footprint = footprint_outline(object);
    let hit = pieces
        .iter()
        .position(|piece| overlap(&footprint, piece, TOLERANCE));
    if hit.is_none() && !is_blocked(scene, p) {
        return None;
    }
    let what = obstacle_under(scene, &footprint);
    Some(format!(
        "at ({}, {}) it overlaps {what}: move it or the obstacle",
        p.x, p.y
    ))
}

/// The robot in trouble, and why.
fn pair_trouble(
    scene: &Scene,
    pieces: &[Convex],
    key: &str,
    pair: &PairPose,
) -> Option<(&'static str, String)> {
    for (name, pose) in [("left", pair.left), ("right", pair.right)] {
        let p = pose.position();
        if is_outside(scene, p) {
            let reason = format!(
                "({}, {}) lies outside of the area, {}: move the robot inside",
                p.x,
                p.y,
                area_text(scene)
            );
            return Some((name, reason));
        }
        if let Some(reason) = collision(scene, pieces, pose) {
            return Some((name, reason));
        }
    }
    // Seen along the headings of both, the side that is to the right must not be where the left robot stands.
    let normal = Point::unit(pair.normal_heading());
    if pair.left.forward().dot(normal) < 0.0 && pair.right.forward().dot(normal) < 0.0 {
        let reason = format!(
            "{key}.left lies to the right of {key}.right as seen along their headings: swapped? Exchange left and right, or \
             turn the headings by pi"
        );
        return Some(("left", reason));
    }
    too_close(scene, pair).map(|reason| ("left", reason))
}

/// Why two robots stand too close to each other.
fn too_close(scene: &Scene, pair: &PairPose) -> Option<String> {
    let separation = pair.separation();
    if let Some(body) = scene.robot.body {
        let gap = body.gap(pair.left, pair.right);
        return (gap < -TOLERANCE).then(|| {
            format!(
                "the robots stand {separation:.4} m apart, where circles of robot.body overlap by {:.4} m: move them apart",
                -gap
            )
        });
    }
    let radius = scene.robot.radius;
    (separation < 2.0 * radius - TOLERANCE).then(|| {
        format!(
            "the robots stand {separation:.4} m apart, two robots of radius {radius} m need at least {:.4} m: move them apart",
            2.0 * radius
        )
    })
}

/// Why a robot cannot stand at a pose: what its circles overlap.
fn collision(scene: &Scene, pieces: &[Convex], pose: Pose) -> Option<String> {
    let here = format!("the robot at ({}, {})", pose.x, pose.y);
    let body = scene.robot.circles();
    let mut circles = body.circles().iter().enumerate();
    circles.find_map(|(i, circle)| {
        let name = match scene.robot.body {
            None => here.clone(),
            Some(_) => format!("{here}, circle {i} of its body,"),
        };
        circle_collision(scene, pieces, &name, circle.center_at(pose), circle.radius)
    })
}

fn circle_collision(
    scene: &Scene,
    pieces: &[Convex],
    here: &str,
    p: Point,
    radius: f64,
) -> Option<String> {
    let nearest = pieces
        .iter()
        .map(|piece| signed_distance(piece, p))
        .fold(f64::INFINITY, f64::min);
    if nearest < radius - TOLERANCE || is_blocked(scene, p) {
        let disc = Convex::Circle { center: p, radius };
        let what = obstacle_under(scene, &disc);
        let distance = if is_blocked(scene, p) {
            nearest.min(0.0)
        } else {
            nearest
        };
        return Some(format!(
            "{here} collides with {what}: {distance:.4} m away, its radius is {radius} m: move it away"
        ));
    }
    let (i, gap) = (scene.objects.iter().enumerate())
        .map(|(i, o)| (i, o.position.distance(p) - o.footprint_radius()))
        .min_by(|a, b| a.1.total_cmp(&b.1))?;
    (gap < radius - TOLERANCE)
        .then(|| format!("{here} stands on objects[{i}]: {gap:.4} m away, its radius is {radius} m: move one of them away"))
}

fn net_trouble(scene: &Scene, net: &[Point]) -> Option<String> {
    let hitch = scene.robot.hitch;
    let bound = RobotSize::of(&scene.robot).length(NET_END_TOLERANCE);
    for (name, end, robot) in [
        ("first", net.first(), scene.start.left),
        ("last", net.last(), scene.start.right),
    ] {
        let (end, tied) = (*end?, robot.hitch_point(hitch));
        if end.distance(tied) > bound {
            return Some(format!(
                "its {name} point ({}, {}) lies {:.3} m from the hitch at ({:.4}, {:.4}), the bound is {bound} m",
                end.x,
                end.y,
                end.distance(tied),
                tied.x,
                tied.y
            ));
        }
    }
    None
}

fn is_outside(scene: &Scene, p: Point) -> bool {
    let (min, max) = (scene.area.min, scene.area.max);
    !(p.x >= min.x && p.x <= max.x && p.y >= min.y && p.y <= max.y)
}

fn area_text(scene: &Scene) -> String {
    let (min, max) = (scene.area.min, scene.area.max);
    format!("[{}, {}] to [{}, {}]", min.x, min.y, max.x, max.y)
}

/// True when a blocked cell of the map holds the point; the pieces need not cover those deep inside.
fn is_blocked(scene: &Scene, p: Point) -> bool {
    scene.map.as_ref().is_some_and(|map| {
        let c = map.to_cells(p);
        map.is_blocked(c.x.floor() as i64, c.y.floor() as i64)
    })
}

/// What a shape overlaps, for people.
fn obstacle_under(scene: &Scene, shape: &Convex) -> String {
    match scene.obstacles.iter().position(|o| is_hit(o, shape)) {
        Some(i) => format!("obstacles[{i}]"),
        None => "blocked cells of the map or its outside".to_owned(),
    }
}

fn is_hit(obstacle: &Obstacle, shape: &Convex) -> bool {
    obstacle_pieces(obstacle)
        .is_some_and(|pieces| pieces.iter().any(|piece| overlap(shape, piece, TOLERANCE)))
}
