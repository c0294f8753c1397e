//! The region that the net holds: bounded by the net and the line between the hitches.

use pairtrawl_geometry::{Point, Segment};

/// True when the net (from hitch to hitch) and the hitch line enclose a point: the winding number is not zero.
pub fn encloses(net: &[Point], place: Point) -> bool {
    let mut winding = 0;
    for i in 0..net.len() {
        let (a, b) = (net[i], net[(i + 1) % net.len()]);
        let side = (b - a).cross(place - a);
        if a.y <= place.y && place.y < b.y && side > 0.0 {
            winding += 1;
        } else if b.y <= place.y && place.y < a.y && side < 0.0 {
            winding -= 1;
        }
    }
    winding != 0
}

/// How far a point lies outside that region, m: 0 inside.
pub fn distance_outside(net: &[Point], place: Point) -> f64 {
    if encloses(net, place) {
        return 0.0;
    }
    (0..net.len())
        .map(|i| Segment::new(net[i], net[(i + 1) % net.len()]).distance(place))
        .fold(f64::INFINITY, f64::min)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_u_encloses_what_lies_in_it_in_either_orientation() {
        let mut net = [
            [0.0, 0.0],
            [0.0, -1.0],
            [0.5, -1.4],
            [1.0, -1.0],
            [1.0, 0.0],
        ]
        .map(Point::from)
        .to_vec();
        for _ in 0..2 {
            assert!(encloses(&net, Point::new(0.5, -1.2)));
            assert!(encloses(&net, Point::new(0.1, -0.1)));
            assert!(!encloses(&net, Point::new(0.5, 0.1)));
            assert!(!encloses(&net, Point::new(0.1, -1.3)));
            assert!((distance_outside(&net, Point::new(0.5, 0.25)) - 0.25).abs() < 1e-12);
            assert_eq!(distance_outside(&net, Point::new(0.5, -0.25)), 0.0);
            net.reverse();
        }
    }
}
