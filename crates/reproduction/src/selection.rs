//! The paper's Fig. 3: which two of four candidates become the baseline at a point of the centerline.

use pairtrawl::geometry::{Point, Pose};
use pairtrawl::model::Circle;

/// Where the outer two candidates lie.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Case {
    /// Case 1: both on the circle.
    Circle,
    /// Case 2: one on the circle, one at l from the centerline.
    Mixed,
    /// Case 3: both at l.
    Line,
}

/// The candidates at one point of a centerline.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Selection {
    /// The point.
    pub pose: Pose,
    /// The circle that it lies in or on, as an index.
    pub circle: usize,
    /// P1, P2 (left, right): on the circle.
    pub on_circle: [Point; 2],
    /// P3, P4 (left, right): at l.
    pub on_line: [Point; 2],
    /// The outer two (left, right).
    pub taken: [Point; 2],
    /// Where these lie.
    pub case: Case,
}

/// The candidates at every point of a centerline in or on a circle; `half_separation` is l, m.
pub fn selections(centerline: &[Pose], circles: &[Circle], half_separation: f64) -> Vec<Selection> {
    let at = |pose: &Pose| {
        let near = |c: &Circle| c.center.distance(pose.position()) - c.radius;
        let (index, circle) =
            (circles.iter().enumerate()).min_by(|a, b| near(a.1).total_cmp(&near(b.1)))?;
        let normal = pose.forward().perp();
        let to_center = circle.center - pose.position();
        let middle = to_center.dot(normal);
        let square = circle.radius * circle.radius - (to_center.norm_squared() - middle * middle);
        if near(circle) > 1e-9 || square < 0.0 {
            return None;
        }
        let (low, high) = (middle - square.sqrt(), middle + square.sqrt());
        let point = |offset: f64| pose.position() + normal * offset;
        let outer = [half_separation.max(high), (-half_separation).min(low)];
        let case = match (high > half_separation, low < -half_separation) {
            (true, true) => Case::Circle,
            (false, false) => Case::Line,
            _ => Case::Mixed,
        };
        Some(Selection {
            pose: *pose,
            circle: index,
            on_circle: [high, low].map(point),
            on_line: [half_separation, -half_separation].map(point),
            taken: outer.map(point),
            case,
        })
    };
    centerline.iter().filter_map(at).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_outer_two_are_taken_in_each_case() {
        let circle = |x: f64, y: f64, radius: f64| Circle {
            center: Point::new(x, y),
            radius,
            objects: vec![0],
        };
        let pose = [Pose::new(0.0, 0.0, 0.0)];
        for (circle, case, taken) in [
            (circle(0.3, 0.0, 0.5), Case::Circle, [0.4, -0.4]),
            (circle(0.0, 0.2, 0.35), Case::Mixed, [0.55, -0.3]),
            (circle(0.1, 0.0, 0.2), Case::Line, [0.3, -0.3]),
        ] {
            let found = selections(&pose, &[circle], 0.3);
            assert_eq!(found[0].case, case);
            let offsets = found[0].taken.map(|p| p.y);
            assert!((offsets[0] - taken[0]).abs() < 1e-12 && (offsets[1] - taken[1]).abs() < 1e-12);
        }
        assert!(selections(&pose, &[circle(2.0, 0.0, 0.5)], 0.3).is_empty());
    }
}
