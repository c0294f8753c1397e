//! Tests of the crate's inner parts, by subject.

#![allow(
    clippy::disallowed_methods,
    reason = "tests compare with the standard library"
)]

mod band;
mod bodies;
mod case;
mod cost;
mod derivative_check;
mod features;
mod filter;
mod lagrangian;
mod line_search;
mod look_up;
mod matrix;
mod optimality;
mod parts;
mod quads;
mod reinforcement;
mod rows;
mod steps;
mod terms;

use pairtrawl_geometry::{Convex, Point};

/// Uniform in [low, high).
fn between(random: &mut fastrand::Rng, low: f64, high: f64) -> f64 {
    low + (high - low) * random.f64()
}

/// Convex regions of every make: a sliver, a box, a rounded polygon, discs.
fn regions() -> Vec<Convex> {
    let polygon = |vertices: &[(f64, f64)]| {
        Convex::Polygon(vertices.iter().map(|&(x, y)| Point::new(x, y)).collect())
    };
    let round = (0..7)
        .map(|k| Point::new(-0.2, 0.1) + Point::unit(0.9 * f64::from(k)) * 0.4)
        .collect();
    vec![
        polygon(&[(-0.5, 0.0), (0.6, -0.02), (0.5, 0.05)]),
        polygon(&[(-0.3, -0.2), (0.3, -0.2), (0.3, 0.2), (-0.3, 0.2)]),
        Convex::Polygon(round),
        Convex::Circle {
            center: Point::new(0.1, -0.2),
            radius: 0.25,
        },
    ]
}
