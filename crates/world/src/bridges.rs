//! Between an object that is left and an obstacle near it there may be no room for a robot. The pair then passes both on the
//! same side, for the net sweeps over no obstacle. To route and optimizer a bridge from one to the other says so: no plan is
//! lost by it. The certificate does not know it.

use crate::shape::edges;
use pairtrawl_geometry::{Convex, Point, Segment};
use pairtrawl_model::{Object, Scene};

/// Bridges of one object leave it in directions farther apart than this has as its cosine: one for each wall.
const SAME_WAY: f64 = 0.7;

/// A thin piece from every object that is left to each obstacle between which and it no robot fits.
pub(crate) fn bridges(scene: &Scene, obstacles: &[Convex]) -> Vec<Convex> {
    let width = 2.0 * scene.robot.circles().half_width();
    let left = scene.objects.iter().filter(|object| object.leave);
    left.flat_map(|object| bridges_of(object, width, obstacles))
        .collect()
}

fn bridges_of(object: &Object, width: f64, obstacles: &[Convex]) -> Vec<Convex> {
    let (from, radius) = (object.position, object.footprint_radius());
    let mut ways: Vec<(f64, Point)> = (obstacles.iter())
        .map(|obstacle| nearest(obstacle, from))
        .map(|to| (from.distance(to), to))
        .filter(|&(distance, _)| distance > radius && distance - radius < width)
        .collect();
    ways.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut taken: Vec<Point> = Vec::new();
    let mut bridges = Vec::new();
    for (distance, to) in ways {
        let forward = (to - from) / distance;
        if taken.iter().any(|other| other.dot(forward) > SAME_WAY) {
            continue;
        }
        taken.push(forward);
        let aside = forward.perp() * radius;
        bridges.push(Convex::Polygon(vec![
            from - aside,
            to - aside,
            to + aside,
            from + aside,
        ]));
    }
    bridges
}

/// The point of an obstacle's border nearest to a point.
fn nearest(obstacle: &Convex, p: Point) -> Point {
    match obstacle {
        Convex::Circle { center, radius } => {
            let outwards = p - *center;
            *center + outwards * (radius / outwards.norm().max(f64::MIN_POSITIVE))
        }
        Convex::Polygon(vertices) => {
            let on_edge = edges(vertices).map(|(a, b)| Segment::new(a, b).nearest(p));
            let near = on_edge.min_by(|a, b| a.distance(p).total_cmp(&b.distance(p)));
            near.unwrap_or(p)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use pairtrawl_model::Footprint;

    #[test]
    fn a_bridge_leads_to_each_wall_that_leaves_no_room() {
        let wall = |x0: f64, y0: f64, x1: f64, y1: f64| {
            let corners = [(x0, y0), (x1, y0), (x1, y1), (x0, y1)];
            Convex::Polygon(corners.map(|(x, y)| Point::new(x, y)).to_vec())
        };
        // In a corner 0.3 m from either wall, of which one is in two pieces, and 0.6 m from a third one.
        let walls = [
            wall(-1.0, -1.0, 5.0, 0.0),
            wall(-1.0, -1.0, 0.0, 2.0),
            wall(-1.0, 2.0, 0.0, 5.0),
            wall(-1.0, 0.95, 5.0, 2.0),
        ];
        let object = Object {
            position: Point::new(0.3, 0.3),
            footprint: Footprint::Disc(0.05),
            mass: 0.02,
            leave: true,
        };
        let bridges = bridges_of(&object, 0.48, &walls);
        assert_eq!(bridges.len(), 2, "{bridges:?}");
        for bridge in &bridges {
            let Convex::Polygon(corners) = bridge else {
                panic!("{bridge:?}")
            };
            let area: f64 = edges(corners).map(|(a, b)| 0.5 * a.cross(b)).sum();
            assert!(
                (area - 0.3 * 0.1).abs() < 1e-12,
                "counter-clockwise: {area}"
            );
        }
        assert!(bridges_of(&object, 0.2, &walls).is_empty());
    }
}
