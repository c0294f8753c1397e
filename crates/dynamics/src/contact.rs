//! Contacts: a stiff normal compliance with Coulomb friction along the face, as the gradient of a convex function.
//!
//! With the normal n and the face's direction t of the beginning of the step, a contact that is `gap` open then and moves with
//! (v_n, v_t) would, without a cone, answer with the impulses
//!
//! ```text
//! y_n = (-gap/dt - v_n) / R_n,   y_t = -v_t / R_t,   R_n = 1 / (K dt^2),   R_t = min(w/100, s / (mu N dt)).
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

use crate::block::Triple;
use crate::friction::CREEP;
use crate::matrix::Matrix;
use crate::row::Row;
use pairtrawl_geometry::Point;

/// Stiffness K of a contact, N/m: 10 N press a tenth of a millimeter deep.
pub(crate) const STIFFNESS: f64 = 1e5;
/// Relaxation of a contact that has been pressed in, in units of the machine's time.
const REBOUND: f64 = 2e-3;
/// R_t over the inverse mass that is felt along the face, at most.
const SLIP: f64 = 1e-2;

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
    /// 1/R_n, kg.
    stiffness: f64,
    /// mu R_t / R_n.
    mixed: f64,
    /// The velocity at which it would just close, or would not press any more, m/s.
    bias: f64,
    /// Opening and sliding velocity at the iterate, m/s.
    now: (f64, f64),
    /// What they are along the direction of the search.
    rate: (f64, f64),
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
            stiffness: 0.0,
            mixed: 0.0,
            bias: 0.0,
            now: (0.0, 0.0),
            rate: (0.0, 0.0),
            force: 0.0,
            state: State::Open,
        }
    }

    /// Stands as it did in the step before.
    pub(crate) fn stand_as(&mut self, before: &Self) {
        self.state = before.state;
        self.force = before.force;
    }

    /// Sets R_t, with the inverse of the mass matrix's diagonal, and what else stays constant in a step of `dt`.
    pub(crate) fn soften(&mut self, dt: f64, inverse_mass: impl Fn(u32) -> Triple) {
        let felt = SLIP * self.row.across_squared(inverse_mass);
        let held = self.friction * self.force * dt;
        self.softness = felt.min(CREEP / held.max(f64::MIN_POSITIVE));
        // One that has been pressed in does not bounce.
        let horizon = if self.gap < 0.0 { dt + REBOUND } else { dt };
        self.stiffness = STIFFNESS * dt * horizon;
        self.mixed = self.friction * self.softness * self.stiffness;
        self.bias = -self.gap / horizon;
    }

    /// Looks at the velocities `u`, from which a search begins.
    pub(crate) fn begin(&mut self, u: &[Triple]) {
        self.now = self.row.at(u);
    }

    /// Looks at the direction of a search.
    pub(crate) fn direct(&mut self, direction: &[Triple]) {
        self.rate = self.row.at(direction);
    }

    /// Goes so far along the direction.
    pub(crate) fn advance(&mut self, length: f64) {
        self.now.0 += length * self.rate.0;
        self.now.1 += length * self.rate.1;
    }

    /// Minus the power of the contact's impulse along the direction, at so far along it.
    pub(crate) fn slope(&self, length: f64) -> f64 {
        let (opening, sliding) = (
            self.now.0 + length * self.rate.0,
            self.now.1 + length * self.rate.1,
        );
        let (normal, face) = self.free(opening, sliding);
        let (push, drag) = self.answer(normal, face, self.stand(normal, face));
        -(push * self.rate.0 + drag * self.rate.1)
    }

    /// Adds minus the contact's impulse at the iterate to the gradient. At the `first` look it is assumed to stand as it did at
    /// the end of the step before.
    pub(crate) fn evaluate(&mut self, dt: f64, first: bool, gradient: &mut [Triple]) {
        let (normal, face) = self.free(self.now.0, self.now.1);
        if !first {
            self.state = self.stand(normal, face);
        }
        let (push, drag) = self.answer(normal, face, self.state);
        self.force = push.max(0.0) / dt;
        if self.state != State::Open {
            self.row.spread(-push, -drag, gradient);
        }
    }

    /// The impulses without a cone.
    fn free(&self, opening: f64, sliding: f64) -> (f64, f64) {
        (
            (self.bias - opening) * self.stiffness,
            -sliding / self.softness,
        )
    }

    /// How a contact stands that would answer so without a cone.
    fn stand(&self, normal: f64, face: f64) -> State {
        if face.abs() <= self.friction * normal {
            State::Sticks
        } else if normal + self.mixed * face.abs() > 0.0 {
            State::Slides(face.signum())
        } else {
            State::Open
        }
    }

    /// The impulses along the normal and along the face.
    fn answer(&self, normal: f64, face: f64, state: State) -> (f64, f64) {
        match state {
            State::Open => (0.0, 0.0),
            State::Sticks => (normal, face),
            State::Slides(sign) => {
                let mu = self.friction;
                let push = (normal + self.mixed * face * sign) / (1.0 + mu * self.mixed);
                (push, mu * push * sign)
            }
        }
    }

    /// Adds the derivative of [`Self::evaluate`]'s terms.
    pub(crate) fn add_stiffness(&self, matrix: &mut Matrix) {
        match self.state {
            State::Open => {}
            State::Sticks => self.row.square(self.stiffness, 1.0 / self.softness, matrix),
            State::Slides(sign) => {
                let mu = self.friction;
                let weight = self.stiffness / (1.0 + mu * self.mixed);
                self.row.mixed(mu * sign).square(weight, 0.0, matrix);
            }
        }
    }

    /// How deep it is at the iterate, m.
    pub(crate) fn depth(&self) -> f64 {
        self.force / STIFFNESS
    }
}
