//! Distances for the brute-force checker, written for it alone.

#![allow(
    clippy::disallowed_methods,
    reason = "tests compare with the standard library"
)]

use pairtrawl_model::{Obstacle, OccupancyMap, Scene};

/// A point as plain numbers.
pub type Xy = [f64; 2];

/// Signed distance to the nearest obstacle; exact below `range`, negative inside.
pub fn obstacle_distance(scene: &Scene, p: Xy, range: f64) -> f64 {
    let shapes = scene.obstacles.iter().map(|o| match o {
        Obstacle::Box { min, max } => {
            let dx = (min.x - p[0]).max(p[0] - max.x);
            let dy = (min.y - p[1]).max(p[1] - max.y);
            if dx.max(dy) <= 0.0 {
                dx.max(dy)
            } else {
                dx.max(0.0).hypot(dy.max(0.0))
            }
        }
        Obstacle::Circle { center, radius } => (p[0] - center.x).hypot(p[1] - center.y) - radius,
        Obstacle::Polygon(v) => {
            polygon_distance(&v.iter().map(|q| [q.x, q.y]).collect::<Vec<_>>(), p)
        }
    });
    let map = scene.map.as_ref().map(|map| map_distance(map, p, range));
    shapes.chain(map).fold(f64::INFINITY, f64::min)
}

fn polygon_distance(v: &[Xy], p: Xy) -> f64 {
    let mut inside = false;
    let mut nearest = f64::INFINITY;
    let mut a = v[v.len() - 1];
    for &b in v {
        if (a[1] > p[1]) != (b[1] > p[1])
            && p[0] < a[0] + (b[0] - a[0]) * (p[1] - a[1]) / (b[1] - a[1])
        {
            inside = !inside;
        }
        let (d, e) = ([b[0] - a[0], b[1] - a[1]], [p[0] - a[0], p[1] - a[1]]);
        let t = ((d[0] * e[0] + d[1] * e[1]) / (d[0] * d[0] + d[1] * d[1])).clamp(0.0, 1.0);
        nearest = nearest.min((e[0] - t * d[0]).hypot(e[1] - t * d[1]));
        a = b;
    }
    if inside { -nearest } else { nearest }
}

/// Every cell within range, one by one; whatever lies outside the map is blocked.
fn map_distance(map: &OccupancyMap, p: Xy, range: f64) -> f64 {
    let (dx, dy) = (p[0] - map.origin.x, p[1] - map.origin.y);
    let (s, c) = (map.origin.heading.sin(), map.origin.heading.cos());
    let (u, v) = (
        (dx * c + dy * s) / map.resolution,
        (dy * c - dx * s) / map.resolution,
    );
    let (w, h) = (map.columns as f64, map.rows as f64);
    let mut nearest = u.min(v).min(w - u).min(h - v);
    let reach = (range / map.resolution).ceil() + 1.0;
    let span = |x: f64, n: usize| {
        let low = (x - reach).floor().clamp(0.0, n as f64) as usize;
        low..((x + reach).ceil().clamp(0.0, n as f64) as usize)
    };
    for row in span(v, map.rows) {
        for column in span(u, map.columns) {
            if map.blocked[row * map.columns + column] {
                let ex = (column as f64 - u).max(u - column as f64 - 1.0);
                let ey = (row as f64 - v).max(v - row as f64 - 1.0);
                let d = if ex.max(ey) <= 0.0 {
                    ex.max(ey)
                } else {
                    ex.max(0.0).hypot(ey.max(0.0))
                };
                nearest = nearest.min(d);
            }
        }
    }
    nearest * map.resolution
}
