//! Dry friction between a support point and the floor.
//!
//! A bristle (Cundall and Strack, Geotechnique 29, 1979) carries the point: with its deflection z, the point's velocity v,
//! stiffness k and damping c, both chosen per point,
//!
//! ```text
//! z <- z + v dt,   f = -(k z + c v),   |f| <= mu N; where the bound is reached the bristle's foot slides along: |z| <= mu N / k.
//! ```
//!
//! Sliding friction is exactly mu N against the motion, in every direction alike; a point at rest under a load below mu N stays
//! where it is, up to a deflection of some 20 micrometers, and does not creep. Stability: with k = m (w/dt)^2 and
//! c = 2 zeta m w/dt for the least inertia m that the point can feel, the semi-implicit step is stable while
//! w^2 + 4 zeta w < 4; we take w = 0.5, zeta = 0.7.

use pairtrawl_geometry::Point;

/// Angular frequency of a bristle times the time step.
const FREQUENCY: f64 = 0.5;
/// Damping ratio.
const DAMPING: f64 = 0.7;

/// What stays constant at a support point.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Bristle {
    /// mu N, N.
    limit: f64,
    /// k, N/m.
    stiffness: f64,
    /// c, N s/m.
    damping: f64,
    /// dt, s.
    time_step: f64,
}

impl Bristle {
    /// For a point that carries `normal_force` (N) with coefficient `friction` and feels at least `inertia` (kg).
    pub(crate) fn new(friction: f64, normal_force: f64, inertia: f64, time_step: f64) -> Self {
        let frequency = FREQUENCY / time_step;
        Self {
            limit: friction * normal_force,
            stiffness: inertia * frequency * frequency,
            damping: 2.0 * DAMPING * inertia * frequency,
            time_step,
        }
    }

    /// Advances a deflection by one step of the point's velocity; returns the force on the body, N.
    pub(crate) fn force(&self, deflection: &mut Point, velocity: Point) -> Point {
        let z = *deflection + velocity * self.time_step;
        let force = (z * self.stiffness + velocity * self.damping) * -1.0;
        let magnitude = force.norm();
        if magnitude <= self.limit {
            *deflection = z;
            return force;
        }
        let reach = self.limit / self.stiffness;
        let stretch = z.norm();
        *deflection = if stretch > reach {
            z * (reach / stretch)
        } else {
            z
        };
        force * (self.limit / magnitude)
    }

    /// Like [`Self::force`] along one line, with another bound on this step, N.
    pub(crate) fn force_along(&self, deflection: &mut f64, velocity: f64, limit: f64) -> f64 {
        let z = *deflection + velocity * self.time_step;
        let reach = limit / self.stiffness;
        *deflection = z.clamp(-reach, reach);
        (-(self.stiffness * z + self.damping * velocity)).clamp(-limit, limit)
    }

    /// Energy in a bristle, J.
    pub(crate) fn energy(&self, deflection: Point) -> f64 {
        0.5 * self.stiffness * deflection.norm_squared()
    }
}
