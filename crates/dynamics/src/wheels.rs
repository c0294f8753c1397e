//! The wheels of a robot: two that push, and tires that do not slip sideways as long as they hold.
//!
//! With the heading's unit vector f at the middle of the step, its normal n, the velocity V of the center of mass (d ahead of the
//! axle) and the turning rate w, the (left, right) wheel moves along the floor at f V -+ R w and the axle slips sideways at
//! n V - d w. A wheel pushes with torque / r, or, when a speed is to be held, in proportion to its speed error; it cannot
//! push harder than its motor or than half the traction mu m g. What the traction leaves holds the axle sideways. Both act
//! through the step's end velocities, so that the stiff speed loop is stable at any step.

use crate::block::Triple;
use crate::body::Body;
use crate::friction;
use crate::matrix::Matrix;
use crate::pattern::Pattern;
use crate::row::{Row, Tie};
use pairtrawl_geometry::Point;

/// Bandwidth of the speed loop, 1/s.
const BANDWIDTH: f64 = 150.0;

/// What drives a robot for a step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Drive {
    /// Torques of the (left, right) wheel, N m.
    Torques([f64; 2]),
    /// Speed along the heading (m/s) and turning rate (rad/s) to hold.
    Velocity {
        /// m/s.
        forward: f64,
        /// rad/s.
        turn_rate: f64,
    },
}

/// What stays constant of a robot's wheels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WheelParameters {
    /// R, m.
    pub half_track: f64,
    /// r, m.
    pub radius: f64,
    /// Greatest torque of a wheel, N m.
    pub max_torque: f64,
    /// Greatest force of the tires of one robot on the floor, N.
    pub traction: f64,
    /// The center of mass lies this far ahead of the axle, m.
    pub center_of_mass: f64,
}

/// The wheels' part in the system of a step.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Wheels {
    pub(crate) parameters: WheelParameters,
    /// Left wheel, right wheel, sideways: the speed as a form of the unknowns, force and -d(force)/d(speed).
    terms: [(Row, f64, f64); 3],
    forward: Point,
}

impl Wheels {
    pub(crate) fn new(parameters: WheelParameters) -> Self {
        Self {
            parameters,
            terms: [(Row::default(), 0.0, 0.0); 3],
            forward: Point::ZERO,
        }
    }

    /// At the beginning of a step: the directions at its middle, as the last step foresees it.
    pub(crate) fn begin(&mut self, dt: f64, body: &Body, slot: u32, pattern: &Pattern) {
        let p = self.parameters;
        let forward = Point::unit(body.heading + 0.5 * dt * body.spin);
        self.forward = forward;
        // A point at this arm moves along the direction with the turning rate times `turn`.
        let form = |direction: Point, turn: f64| {
            let mut row = Row::default();
            let arm = direction.perp() * -turn;
            row.push(Tie::Held { slot, arm }, direction, Point::ZERO);
            row.locate(pattern);
            row
        };
        self.terms[0].0 = form(forward, -p.half_track);
        self.terms[1].0 = form(forward, p.half_track);
        self.terms[2].0 = form(forward.perp(), -p.center_of_mass);
    }

    /// Adds minus the impulses of the floor on the wheels at the velocities `u` to the gradient. At the `first` look the tires hold.
    pub(crate) fn evaluate(
        &mut self,
        dt: f64,
        first: bool,
        mass: f64,
        drive: &Drive,
        u: &[Triple],
        gradient: &mut [Triple],
    ) {
        let speeds = [0, 1, 2].map(|k: usize| self.terms[k].0.at(u).0);
        let forces = self.forces(first, mass, drive, speeds);
        for ((row, force, slope), now) in self.terms.iter_mut().zip(forces) {
            (*force, *slope) = now;
            row.spread(-dt * now.0, 0.0, gradient);
        }
    }

    /// Minus the power of these impulses along a direction, at so far along it.
    pub(crate) fn slope(
        &self,
        dt: f64,
        mass: f64,
        drive: &Drive,
        (u, direction, length): (&[Triple], &[Triple], f64),
    ) -> f64 {
        let rates = [0, 1, 2].map(|k: usize| self.terms[k].0.at(direction).0);
        let speeds = [0, 1, 2].map(|k: usize| self.terms[k].0.at(u).0 + length * rates[k]);
        let forces = self.forces(false, mass, drive, speeds);
        let power: f64 = rates.iter().zip(forces).map(|(r, (f, _))| r * f).sum();
        -dt * power
    }

    /// Force and -d(force)/d(speed) of the left wheel, the right wheel and sideways, at these speeds.
    fn forces(&self, holds: bool, mass: f64, drive: &Drive, speeds: [f64; 3]) -> [(f64, f64); 3] {
        let p = &self.parameters;
        let limit = (p.max_torque / p.radius).min(0.5 * p.traction);
        let gain = 0.5 * mass * BANDWIDTH;
        let mut forces = [(0.0, 0.0); 3];
        let mut along = 0.0;
        for (wheel, sign) in [-1.0, 1.0].into_iter().enumerate() {
            forces[wheel] = match *drive {
                Drive::Torques(torques) => ((torques[wheel] / p.radius).clamp(-limit, limit), 0.0),
                Drive::Velocity { forward, turn_rate } => {
                    let wanted = gain * (forward + sign * p.half_track * turn_rate - speeds[wheel]);
                    let free = wanted.abs() < limit;
                    (wanted.clamp(-limit, limit), if free { gain } else { 0.0 })
                }
            };
            along += forces[wheel].0;
        }
        let room = (p.traction * p.traction - along * along).max(0.0).sqrt();
        forces[2] = friction::drag_along(room, speeds[2], holds);
        forces
    }

    /// Adds the derivative of [`Self::evaluate`]'s terms.
    pub(crate) fn add_stiffness(&self, dt: f64, matrix: &mut Matrix) {
        for (row, _, slope) in &self.terms {
            if *slope > 0.0 {
                row.square(dt * slope, 0.0, matrix);
            }
        }
    }

    /// Force of the (left, right) wheel along the heading, N.
    pub(crate) fn push(&self) -> [f64; 2] {
        [self.terms[0].1, self.terms[1].1]
    }

    /// Force of the floor on the robot, N.
    pub(crate) fn force(&self) -> Point {
        let [left, right] = self.push();
        self.forward * (left + right) + self.forward.perp() * self.terms[2].1
    }

    /// Velocity of the axle along and across the heading at the middle of the last step, m/s.
    pub(crate) fn axle_velocity(&self, body: &Body) -> (f64, f64) {
        (
            self.forward.dot(body.velocity),
            self.forward.perp().dot(body.velocity) - self.parameters.center_of_mass * body.spin,
        )
    }
}
