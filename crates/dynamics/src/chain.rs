//! The net: rigid links with hinges, as the places of the hinges.
//!
//! A rigid link between a and b with mass m, length l and inertia I about its center has the kinetic energy
//!
//! ```text
//! T = m/2 |(v_a + v_b)/2|^2 + I/(2 l^2) |v_b - v_a|^2
//! ```
//!
//! for every velocity that keeps its length, so hinges with this constant mass matrix move exactly as rigid links do. The length
//! is held by an axial stiffness K: tension S = K (L - l) with the length L at the end of the step. For the length only, the step is linear:
//! L+^2 - L^2 = 2 dt (v_b - v_a).(d + dt/2 (v_b - v_a)) with d = x_b - x_a, where the bracket, the link at the middle of the step, is foreseen
//! with the velocities of the step before. What that misses is a length of second order in the change of the
//! velocities, which the next step takes back. A taut link resists being turned: S of the step before also acts
//! along the link's direction at the end of the step. Hinges dissipate
//! c/2 (difference of the turning rates)^2. Every hinge stands on the floor with half of each adjacent link's weight.

use crate::block::{Block, Triple};
use crate::friction::{self, Drag};
use crate::matrix::Matrix;
use crate::pattern::Pattern;
use crate::row::{Row, Tie, scatter};
use pairtrawl_geometry::Point;

/// Axial stiffness K of a link, N/m: 10 N stretch it by a tenth of a millimeter.
const STIFFNESS: f64 = 1e5;

/// What stays constant of a net.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NetParameters {
    /// Length of a link, m.
    pub link_length: f64,
    /// Mass of a link, kg.
    pub link_mass: f64,
    /// Inertia of a link about its center, kg m^2.
    pub link_inertia: f64,
    /// Thickness, m.
    pub thickness: f64,
    /// Damping of a hinge, N m s/rad.
    pub hinge_damping: f64,
    /// Friction of a link on the floor: mu m g, N.
    pub floor_limit: f64,
}

/// The chain and its terms in the system of a step.
#[derive(Clone, Debug)]
pub(crate) struct Chain {
    pub(crate) parameters: NetParameters,
    /// Left hitch, hinges, right hitch.
    pub(crate) places: Vec<Point>,
    pub(crate) velocities: Vec<Point>,
    /// At the middle of the step.
    pub(crate) ties: Vec<Tie>,
    found: Vec<Point>,
    springs: Vec<Spring>,
    drags: Vec<Drag>,
}

/// A link in a step.
#[derive(Clone, Copy, Debug, Default)]
struct Spring {
    /// From end to end at the middle of the step, over the length.
    direction: Point,
    /// At the beginning of the step, m.
    length: f64,
    /// Velocity of the second end from the first in the step before, m/s.
    foreseen: Point,
    /// At the end of the step before, N.
    tension: f64,
    /// At the end of the step that was solved last, N.
    ended: f64,
}

impl Chain {
    pub(crate) fn new(parameters: NetParameters, nodes: Vec<Point>) -> Self {
        let count = nodes.len();
        Self {
            parameters,
            velocities: vec![Point::ZERO; count],
            ties: vec![Tie::Free { slot: 0 }; count],
            found: vec![Point::ZERO; count],
            springs: vec![Spring::default(); count - 1],
            drags: vec![Drag::default(); count],
            places: nodes,
        }
    }

    pub(crate) fn links(&self) -> usize {
        self.springs.len()
    }

    /// Friction limit of a hinge or hitch, N.
    fn floor_limit(&self, node: usize) -> f64 {
        let links = if node == 0 || node == self.links() {
            1.0
        } else {
            2.0
        };
        0.5 * links * self.parameters.floor_limit
    }

    /// Adds the links' mass.
    pub(crate) fn add_mass(&self, pattern: &Pattern, matrix: &mut Matrix) {
        let NetParameters {
            link_length,
            link_mass,
            link_inertia,
            ..
        } = self.parameters;
        let turning = link_inertia / (link_length * link_length);
        let (x, y) = (Point::new(1.0, 0.0), Point::new(0.0, 1.0));
        for ties in self.ties.windows(2) {
            if let [Tie::Free { slot: a }, Tie::Free { slot: b }] = *ties {
                let (own, shared) = (0.25 * link_mass + turning, 0.25 * link_mass - turning);
                for (at, value) in [(a, own), (b, own)] {
                    add_diagonal(&mut matrix.blocks[at as usize], value);
                }
                add_diagonal(&mut matrix.blocks[pattern.block(a, b)], shared);
                continue;
            }
            let (mut middle, mut difference) = (Row::default(), Row::default());
            middle.push(ties[0], x * 0.5, y * 0.5);
            middle.push(ties[1], x * 0.5, y * 0.5);
            difference.push(ties[0], -x, -y);
            difference.push(ties[1], x, y);
            for row in [&mut middle, &mut difference] {
                row.locate(pattern);
            }
            middle.square(link_mass, link_mass, matrix);
            difference.square(turning, turning, matrix);
        }
    }

    /// Adds the hinges' damping over a step of `dt`; `robots` are the robots' slots.
    pub(crate) fn add_damping(
        &self,
        dt: f64,
        robots: [u32; 2],
        pattern: &Pattern,
        matrix: &mut Matrix,
    ) {
        let damping = dt * self.parameters.hinge_damping;
        if damping == 0.0 {
            return;
        }
        let last = self.links();
        for hinge in 0..=last {
            let mut row = Row::default();
            for (link, sign) in [(hinge, 1.0), (hinge.wrapping_sub(1), -1.0)] {
                if link < last {
                    let along = self.places[link + 1] - self.places[link];
                    let rate = along.perp() * (sign / along.norm_squared());
                    row.push(self.ties[link + 1], rate, Point::ZERO);
                    row.push(self.ties[link], -rate, Point::ZERO);
                } else {
                    row.push_turn(robots[usize::from(hinge == last)], sign);
                }
            }
            row.locate(pattern);
            row.square(damping, 0.0, matrix);
        }
    }

    /// At the beginning of a step: the links' directions at its middle, as far as the last step foresees them.
    pub(crate) fn begin(&mut self, dt: f64) {
        for link in 0..self.links() {
            let before = self.places[link + 1] - self.places[link];
            let relative = self.velocities[link + 1] - self.velocities[link];
            let length = before.norm();
            let spring = &mut self.springs[link];
            spring.direction = (before + relative * (0.5 * dt)) / length;
            spring.length = length;
            spring.foreseen = relative;
        }
    }

    /// Adds the links' stiffness to the matrix and what it does not multiply to `constant`.
    pub(crate) fn add_springs(
        &self,
        dt: f64,
        pattern: &Pattern,
        matrix: &mut Matrix,
        constant: &mut [Triple],
    ) {
        for (spring, ties) in self.springs.iter().zip(self.ties.windows(2)) {
            let t = spring.direction;
            let along = dt * dt * STIFFNESS;
            let across = dt * dt * spring.tension.max(0.0) / spring.length;
            let n = t.perp();
            let impulse = t * (dt * STIFFNESS * (self.parameters.link_length - spring.length))
                + n * (0.5 * across * n.dot(spring.foreseen));
            scatter(ties[0], -impulse, constant);
            scatter(ties[1], impulse, constant);
            if let [Tie::Free { slot: a }, Tie::Free { slot: b }] = *ties {
                for at in [a, b] {
                    add_directed(&mut matrix.blocks[at as usize], t, along, across, 1.0);
                }
                let shared = &mut matrix.blocks[pattern.block(a, b)];
                add_directed(shared, t, along, across, -1.0);
                continue;
            }
            let mut row = Row::default();
            row.push(ties[0], -t, -n);
            row.push(ties[1], t, n);
            row.locate(pattern);
            row.square(along, across, matrix);
        }
    }

    /// Adds minus the impulses of the floor at the velocities `u` to the gradient.
    pub(crate) fn evaluate(&mut self, dt: f64, first: bool, u: &[Triple], gradient: &mut [Triple]) {
        for node in 0..=self.links() {
            let held = first && self.drags[node].holds;
            let drag = friction::drag(self.floor_limit(node), self.ties[node].velocity(u), held);
            scatter(self.ties[node], drag.force * -dt, gradient);
            self.drags[node] = drag;
        }
    }

    /// Minus the power of these impulses along a direction, at so far along it.
    pub(crate) fn slope(&self, dt: f64, (u, d, length): (&[Triple], &[Triple], f64)) -> f64 {
        let power = |(node, tie): (usize, &Tie)| {
            let rate = tie.velocity(d);
            let velocity = tie.velocity(u) + rate * length;
            friction::force(self.floor_limit(node), velocity).dot(rate)
        };
        -dt * self.ties.iter().enumerate().map(power).sum::<f64>()
    }

    /// Adds the derivative of [`Self::evaluate`]'s terms.
    pub(crate) fn add_stiffness(&self, dt: f64, pattern: &Pattern, matrix: &mut Matrix) {
        for (drag, tie) in self.drags.iter().zip(&self.ties) {
            let (t, n) = (drag.direction, drag.direction.perp());
            let (along, across) = (dt * drag.along, dt * drag.across);
            match *tie {
                Tie::Free { slot } => {
                    add_directed(&mut matrix.blocks[slot as usize], t, along, across, 1.0);
                }
                held @ Tie::Held { .. } => {
                    let mut row = Row::default();
                    row.push(held, t, n);
                    row.locate(pattern);
                    row.square(along, across, matrix);
                }
            }
        }
    }

    /// Looks at the velocities `u` that a step ended with.
    pub(crate) fn finish(&mut self, dt: f64, u: &[Triple]) {
        for (velocity, tie) in self.found.iter_mut().zip(&self.ties) {
            *velocity = tie.velocity(u);
        }
        for (link, spring) in self.springs.iter_mut().enumerate() {
            let relative = self.found[link + 1] - self.found[link];
            let stretch =
                spring.length - self.parameters.link_length + dt * relative.dot(spring.direction);
            spring.ended = STIFFNESS * stretch;
        }
    }

    /// Moves on with the velocities of [`Self::finish`]; the ends go where the hitches are.
    pub(crate) fn accept(&mut self, dt: f64, hitches: [Point; 2]) {
        self.velocities.clone_from(&self.found);
        for (place, velocity) in self.places.iter_mut().zip(&self.velocities) {
            *place += *velocity * dt;
        }
        let last = self.links();
        self.places[0] = hitches[0];
        self.places[last] = hitches[1];
        for spring in &mut self.springs {
            spring.tension = spring.ended;
        }
    }

    /// Velocities of hinges and hitches in the step that was solved last.
    pub(crate) fn found(&self) -> &[Point] {
        &self.found
    }

    /// Greatest speed of a hinge or hitch in the step that was solved last, m/s.
    pub(crate) fn greatest_speed_found(&self) -> f64 {
        self.found.iter().map(|v| v.norm()).fold(0.0, f64::max)
    }

    /// How much longer or shorter than it should be a link is at most, m.
    pub(crate) fn greatest_stretch(&self) -> f64 {
        let off = |ends: &[Point]| (ends[1].distance(ends[0]) - self.parameters.link_length).abs();
        self.places.windows(2).map(off).fold(0.0, f64::max)
    }

    /// Kinetic and elastic energy, J.
    pub(crate) fn energy(&self) -> f64 {
        let p = &self.parameters;
        let turning = p.link_inertia / (p.link_length * p.link_length);
        let of_link = |i: usize| {
            let (a, b) = (self.velocities[i], self.velocities[i + 1]);
            let stretch = self.places[i + 1].distance(self.places[i]) - p.link_length;
            0.5 * p.link_mass * ((a + b) * 0.5).norm_squared()
                + 0.5 * turning * (b - a).norm_squared()
                + 0.5 * STIFFNESS * stretch * stretch
        };
        (0..self.links()).map(of_link).sum()
    }
}

fn add_diagonal(block: &mut Block, value: f64) {
    block[0][0] += value;
    block[1][1] += value;
}

/// Adds sign (along t t^T + across n n^T) for two velocities of hinges.
fn add_directed(block: &mut Block, t: Point, along: f64, across: f64, sign: f64) {
    let xy = sign * (along - across) * t.x * t.y;
    block[0][0] += sign * (along * t.x * t.x + across * t.y * t.y);
    block[1][1] += sign * (along * t.y * t.y + across * t.x * t.x);
    block[0][1] += xy;
    block[1][0] += xy;
}
