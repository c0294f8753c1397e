//! The four candidates of the paper's Fig. 3 at one centerline point.

use pairtrawl_geometry::{Point, Pose};
use pairtrawl_model::Circle;

/// Offsets of (left, right) robot from the centerline along its normal, left positive and right negative.
///
/// Eq. 1 gives +-`half_separation`; eqs. 2 and 3 give the two points where the perpendicular through the centerline point
/// cuts the circle. The outer two of the four are taken: both of the circle (case 1), one of each pair (case 2), or both of
/// eq. 1 (case 3). Without an intersection eq. 1 stands alone.
pub(crate) fn outer_candidates(pose: Pose, circle: &Circle, half_separation: f64) -> (f64, f64) {
    let normal = pose.forward().perp();
    match chord(pose.position(), normal, circle) {
        Some((low, high)) => (half_separation.max(high), (-half_separation).min(low)),
        None => (half_separation, -half_separation),
    }
}

/// Where the line p + t normal cuts the circle: t at both points, rising.
fn chord(p: Point, normal: Point, circle: &Circle) -> Option<(f64, f64)> {
    let to_center = circle.center - p;
    let middle = to_center.dot(normal);
    let square = circle.radius * circle.radius - (to_center.norm_squared() - middle * middle);
    (square >= 0.0).then(|| (middle - square.sqrt(), middle + square.sqrt()))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn circle(x: f64, y: f64, radius: f64) -> Circle {
        Circle {
            center: Point::new(x, y),
            radius,
            objects: vec![0],
        }
    }

    // The centerline runs along +x through the origin: left is +y.
    const POSE: Pose = Pose::new(0.0, 0.0, 0.0);

    #[test]
    fn case_1_both_points_on_the_circle_are_outer() {
        // 3-4-5: abeam the chord of radius 0.5 at distance 0.3 ends at +-0.4.
        let (left, right) = outer_candidates(POSE, &circle(0.3, 0.0, 0.5), 0.3);
        assert!((left - 0.4).abs() < 1e-12 && (right + 0.4).abs() < 1e-12);
    }

    #[test]
    fn case_2_one_of_each_is_outer() {
        let (left, right) = outer_candidates(POSE, &circle(0.0, 0.2, 0.35), 0.3);
        assert!((left - 0.55).abs() < 1e-12 && (right + 0.3).abs() < 1e-12);
        let (left, right) = outer_candidates(POSE, &circle(0.0, -0.2, 0.35), 0.3);
        assert!((left - 0.3).abs() < 1e-12 && (right + 0.55).abs() < 1e-12);
    }

    #[test]
    fn case_3_both_points_of_equation_1_are_outer() {
        let (left, right) = outer_candidates(POSE, &circle(0.1, 0.0, 0.2), 0.3);
        assert_eq!((left, right), (0.3, -0.3));
        // No intersection at all.
        assert_eq!(
            outer_candidates(POSE, &circle(1.0, 0.0, 0.5), 0.3),
            (0.3, -0.3)
        );
    }

    #[test]
    fn the_perpendicular_follows_the_heading() {
        let pose = Pose::new(1.0, 2.0, std::f64::consts::FRAC_PI_2);
        // Heading +y: left is -x. The circle lies 0.2 to the left.
        let (left, right) = outer_candidates(pose, &circle(0.8, 2.0, 0.35), 0.3);
        assert!((left - 0.55).abs() < 1e-12 && (right + 0.3).abs() < 1e-12);
    }
}
