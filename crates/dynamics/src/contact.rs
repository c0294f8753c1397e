//! Contacts: a stiff normal compliance with Coulomb friction along the face, as the gradient of a convex function.
//!
//! With the normal n and the face's direction t of the beginning of the step, a contact that is `gap` open then and moves with
//! (v_n, v_t) would, without a cone, answer with the impulses
//!
//! ```text
//! y_n = (-gap/dt - v_n) / R_n,   y_t = -v_t / R_t,   R_n = 1 / (K dt^2),   R_t = min(w/500, s / (mu N dt)).
//! ```
//!
//! w is the inverse mass that is felt along the face, N the contact's normal force in the step before, s a creeping speed: what sticks
//! creeps by at most s.
//! Where the contact is pressed in at the beginning, the time T = dt + 2 ms takes the place of one dt: y_n = -K dt (gap + T v_n),
//! which takes the bounce out of an impact in steps that are shorter than the impact.
//! A contact that is still open but will close in this step already counts, so nothing passes through anything between two
//! looks. The impulse is the projection of y on Coulomb's cone |y_t| <= mu y_n in the metric of R (Castro, Permenter and Han,
//! IEEE T-RO 39, 2023): y itself where it sticks, a point of the cone's edge where it slides, nothing beyond the polar cone. That
//! is the gradient of a convex function, so a step has one solution and Newton's method finds it. The price is that
//! sliding contacts ride on a gap of dt mu |v_t| (0.2 mm at 0.1 m/s and steps of 10 ms); forces and slip are Coulomb's.

use crate::envelope::Envelope;
use crate::friction::CREEP;
use crate::row::Row;
use pairtrawl_geometry::Point;

/// Stiffness K of a contact, N/m: 10 N press a tenth of a millimeter deep.
pub(crate) const STIFFNESS: f64 = 1e5;
/// Relaxation of a contact that has been pressed in, in units of the machine's time.
const REBOUND: f64 = 2e-3;
/// R_t over the inverse mass that is felt along the face, at most.
const SLIP: f64 = 2e-3;

/// A contact of a step.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ContactTerm {
    /// Indices of what touches: two that move, or one that moves and a fixed shape.
    pub(crate) pair: (usize, Other),
    pub(crate) place: Point,
    /// Velocity of the second from the first along the normal and along the face.
    pub(crate) row: Row,
    /// At the beginning of the step, m.
    pub(crate) gap: f64,
    /// mu.
    friction: f64,
    /// R_t, 1/kg.
    softness: f64,
    /// Normal force at the iterate, N.
    pub(crate) force: f64,
    state: State,
}

/// How a contact stands at the iterate.
#[derive(Clone, Copy, Debug, PartialEq)]
enum State {
    Open,
    Sticks,
    /// Towards positive or negative t (the sign of the impulse).
    Slides(f64),
}

/// The second partner of a contact.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Other {
    /// Something that moves.
    Moving(usize),
    /// A fixed shape.
    Fixed(usize),
}

impl ContactTerm {
    /// An open contact; [`Self::soften`] sets its R_t.
    pub(crate) fn new(
        pair: (usize, Other),
        place: Point,
        row: Row,
        gap: f64,
        friction: f64,
    ) -> Self {
        Self {
            pair,
            place,
            row,
            gap,
            friction,
            softness: 0.0,
            force: 0.0,
            state: State::Open,
        }
    }

    /// Stands as it did in the step before.
    pub(crate) fn stand_as(&mut self, before: &Self) {
        self.state = before.state;
        self.force = before.force;
    }

    /// Sets R_t, with the inverse of the mass matrix's diagonal.
    pub(crate) fn soften(&mut self, dt: f64, inverse_mass: impl Fn(usize) -> f64) {
        let felt = SLIP * self.row.across_squared(inverse_mass);
        let held = self.friction * self.force * dt;
        self.softness = felt.min(CREEP / held.max(f64::MIN_POSITIVE));
    }

    /// Adds minus the contact's impulse at the velocities `u` to the gradient. At the `first` look it is assumed to stand as it did at
    /// the end of the step before.
    pub(crate) fn evaluate(&mut self, dt: f64, first: bool, u: &[f64], gradient: &mut [f64]) {
        let (opening, sliding) = self.row.at(u);
        let (horizon, stiffness) = self.response(dt);
        let mu = self.friction;
        let normal = -(self.gap / horizon + opening) * stiffness;
        let face = -sliding / self.softness;
        let mixed = mu * self.softness * stiffness;
        let sum = normal + mixed * face.abs();
        if !first {
            self.state = if face.abs() <= mu * normal {
                State::Sticks
            } else if sum > 0.0 {
                State::Slides(face.signum())
            } else {
                State::Open
            };
        }
        let (push, drag) = match self.state {
            State::Open => (0.0, 0.0),
            State::Sticks => (normal, face),
            State::Slides(sign) => {
                let push = (normal + mixed * face * sign) / (1.0 + mu * mixed);
                (push, mu * push * sign)
            }
        };
        self.force = push.max(0.0) / dt;
        if self.state != State::Open {
            self.row.spread(-push, -drag, gradient);
        }
    }

    /// The time in which the contact would close, and the impulse by which it resists a velocity that is too high (1/R_n). One that has
    /// been pressed in does not bounce.
    fn response(&self, dt: f64) -> (f64, f64) {
        let horizon = if self.gap < 0.0 { dt + REBOUND } else { dt };
        (horizon, STIFFNESS * dt * horizon)
    }

    /// Adds the derivative of [`Self::evaluate`]'s terms.
    pub(crate) fn add_stiffness(&self, dt: f64, matrix: &mut Envelope) {
        let (_, stiffness) = self.response(dt);
        match self.state {
            State::Open => {}
            State::Sticks => self.row.square(stiffness, 1.0 / self.softness, matrix),
            State::Slides(sign) => {
                let mu = self.friction;
                let weight = stiffness / (1.0 + mu * mu * self.softness * stiffness);
                self.row.mixed(mu * sign).square(weight, 0.0, matrix);
            }
        }
    }
}

impl ContactTerm {
    /// How deep it is at the iterate, m.
    pub(crate) fn depth(&self) -> f64 {
        self.force / STIFFNESS
    }
}
