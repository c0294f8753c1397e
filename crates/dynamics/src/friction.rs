//! Dry friction of a point on the floor, and of the tires sideways.
//!
//! Coulomb's law for a known limit F is the subgradient of F |v|. It is smoothed below a creeping speed s:
//!
//! ```text
//! f(v) = -F v / max(|v|, s),
//! ```
//!
//! the gradient of a convex function (Huber's), so that a step's velocities are the minimum of a convex function as long as
//! nothing else bends it. Sliding friction is exactly F against the motion, in every direction alike; what is held creeps
//! by at most s.

use pairtrawl_geometry::Point;

/// What holds still may creep at this speed, in units of the machine's speed.
pub(crate) const CREEP: f64 = 1e-4;

/// Force of friction, and its derivative -df/dv = `along` (t t^T) + `across` (I - t t^T) with t the direction of motion.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Drag {
    pub(crate) force: Point,
    pub(crate) direction: Point,
    pub(crate) along: f64,
    pub(crate) across: f64,
    /// The point is held: it moves below the creeping speed.
    pub(crate) holds: bool,
}

/// Friction with limit `limit` (N) at a velocity. A point that is taken for `held` resists as below the creeping speed, whatever
/// its speed.
pub(crate) fn drag(limit: f64, velocity: Point, held: bool) -> Drag {
    let speed = velocity.norm();
    if held || speed < CREEP {
        let stiffness = limit / CREEP;
        return Drag {
            force: velocity * -stiffness,
            direction: Point::new(1.0, 0.0),
            along: stiffness,
            across: stiffness,
            holds: true,
        };
    }
    let direction = velocity / speed;
    Drag {
        force: direction * -limit,
        direction,
        along: 0.0,
        across: limit / speed,
        holds: false,
    }
}

/// The force alone.
pub(crate) fn force(limit: f64, velocity: Point) -> Point {
    velocity * (-limit / velocity.norm().max(CREEP))
}

/// The same along a line: force and -df/dv.
pub(crate) fn drag_along(limit: f64, velocity: f64, held: bool) -> (f64, f64) {
    if held || velocity.abs() < CREEP {
        let stiffness = limit / CREEP;
        (-stiffness * velocity, stiffness)
    } else {
        (-limit * velocity.signum(), 0.0)
    }
}
