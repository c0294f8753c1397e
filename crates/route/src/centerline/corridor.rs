//! What a pose of the centerline costs: room for both robots, a free line between them, objects well inside or outside.

use crate::terrain::{PairMeasures, Terrain};
use pairtrawl_geometry::{Point, Pose};

/// How much is asked of the way. Stricter first; the planner walks down this list until it finds one.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Strictness {
    /// Turning radius.
    pub radius: f64,
    /// Least distance of the midpoint to obstacles, in robot radii.
    pub floor: f64,
    /// Least distance of the points where the robots drive closest together.
    pub side_floor: f64,
    /// How far from a circle's center the way may pass.
    pub reach: f64,
}

/// From comfortable to barely possible: turning radius and reach first, then the room of a pair abreast. The turning radius
/// goes from the comfortable one down to half the usual separation, where the inner robot turns on the spot. How far from a
/// circle the way may pass goes with the comfortable one: a pair that turns widely cannot meet circles close to each other.
pub(crate) fn ladder(pair: &PairMeasures) -> [Strictness; 5] {
    let tightest = pair.half_separation;
    let radius = |share: f64| tightest + share * (pair.turning - tightest);
    let reach = |share: f64| share * pair.turning;
    [
        Strictness {
            radius: radius(1.0),
            floor: 1.0,
            side_floor: 0.04,
            reach: reach(0.2),
        },
        Strictness {
            radius: radius(0.5),
            floor: 1.0,
            side_floor: 0.04,
            reach: reach(0.2),
        },
        Strictness {
            radius: radius(0.5),
            floor: 1.0,
            side_floor: 0.04,
            reach: reach(0.5),
        },
        Strictness {
            radius: radius(1.0 / 6.0),
            floor: 0.8,
            side_floor: -0.1,
            reach: reach(0.5),
        },
        Strictness {
            radius: radius(0.0),
            floor: 0.5,
            side_floor: f64::NEG_INFINITY,
            reach: reach(5.0 / 6.0),
        },
    ]
}

/// Extra cost per length driven and length of room missing for a robot at half the usual separation.
const NARROW: f64 = 4.0;
/// The same where not even the least separation fits.
const TOO_NARROW: f64 = 20.0;
/// Extra cost per length driven and length that the band has to widen or move because of an object.
const OBJECT: f64 = 4.0;
/// An object counts while it lies within this of the line between the robots.
const ABREAST: f64 = 0.12;

/// The terrain as the centerline sees it.
#[derive(Clone, Copy)]
pub(crate) struct Corridor<'t> {
    pub terrain: &'t Terrain,
    pub strictness: Strictness,
}

impl Corridor<'_> {
    /// Cost per length beyond 1, or `None` where the pair cannot be.
    pub fn penalty(&self, pose: Pose) -> Option<f64> {
        self.penalty_at(pose.position(), pose.forward())
    }

    /// As [`Self::penalty`], with the unit vector along the heading.
    pub fn penalty_at(&self, p: Point, forward: Point) -> Option<f64> {
        let pair = &self.terrain.pair;
        let left = forward.perp();
        let d = self.terrain.distance(p);
        if d < self.strictness.floor * pair.radius {
            return None;
        }
        let mut penalty = 0.0;
        // Far from everything nothing needs a closer look.
        if d < pair.half_separation + pair.radius + pair.clearance {
            for side in [left, -left] {
                let near = self.terrain.distance(p + side * pair.min_half);
                if near < self.strictness.side_floor {
                    return None;
                }
                let usual = self.terrain.distance(p + side * pair.half_separation);
                penalty += NARROW * (pair.radius + pair.clearance - usual).max(0.0)
                    + TOO_NARROW * (pair.radius - near).max(0.0);
            }
        }
        for object in self.terrain.objects_near(p) {
            let r = object.center - p;
            if r.dot(forward).abs() < ABREAST {
                let offset = r.dot(left).abs();
                let keep = object.radius + pair.radius + pair.clearance;
                // Either the band widens until the robot passes beyond the object, or it moves away.
                let widen = offset + keep - pair.half_separation;
                let widen = if offset + keep > pair.max_half * 2.0 - pair.min_half {
                    f64::INFINITY
                } else {
                    widen
                };
                let shift = pair.half_separation + keep - offset;
                penalty += OBJECT * widen.min(shift).max(0.0);
            }
        }
        Some(penalty)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::terrain::tests::{box_distance, pair_pose, scene};

    #[test]
    fn objects_cost_where_a_robot_would_drive_over_them_and_narrowness_costs_until_it_forbids() {
        let s = scene(
            10.0,
            6.0,
            &[[5.0, 3.0]],
            pair_pose(1.0, 1.0, 0.0),
            pair_pose(9.0, 1.0, 0.0),
        );
        let wall = |p| box_distance(p, [-1.0, 5.0, 11.0, 7.0]);
        let terrain = Terrain::sample(&s, wall);
        let corridor = Corridor {
            terrain: &terrain,
            strictness: ladder(&terrain.pair)[0],
        };
        let at = |x, y| corridor.penalty(Pose::new(x, y, 0.0));
        let (middle, track, outside) = (at(5.0, 3.0), at(5.0, 2.7), at(5.0, 2.3));
        assert!(middle.is_some_and(|p| p < 0.2), "{middle:?}");
        assert!(track.is_some_and(|p| p > 0.8), "{track:?}");
        assert_eq!(outside, Some(0.0));
        // Only abreast: past the object nothing is left of it.
        assert_eq!(at(5.3, 2.7), Some(0.0));
        // Along the wall: free, dear, impossible. Across it only the midpoint and the robot ahead of it matter.
        let (free, dear, dearer) = (at(2.0, 4.4), at(2.0, 4.55), at(2.0, 4.65));
        assert_eq!(free, Some(0.0));
        assert!(
            dear.is_some_and(|p| p > 0.3) && dearer > dear,
            "{dear:?} {dearer:?}"
        );
        assert_eq!(at(2.0, 4.75), None);
    }
}
