//! Everything that moves and what it moves among, and its steps.

use crate::body::Body;
use crate::chain::Chain;
use crate::contact::ContactTerm;
use crate::floor::{self, Supports};
use crate::near::{Mover, Near};
use crate::neighbors::{Grid, Neighbors, SKIN};
use crate::newton::System;
use crate::outline::MovingShape;
use crate::pattern::Pattern;
use crate::setup::{Footprint, Setup};
use crate::solid::Solid;
use crate::wheels::{Drive, Wheels};
use crate::work::{Stage, Stopwatch, Work};
use pairtrawl_geometry::Point;

/// Two robots, the net and the objects in motion among obstacles.
#[derive(Clone, Debug)]
pub struct World {
    /// Left robot, right robot, objects.
    pub(crate) bodies: Vec<Body>,
    pub(crate) wheels: [Wheels; 2],
    pub(crate) supports: Vec<Supports>,
    pub(crate) chain: Chain,
    pub(crate) contacts: Vec<ContactTerm>,
    pub(crate) pattern: Pattern,
    /// The pattern is a new one.
    pub(crate) reordered: bool,
    pub(crate) system: System,
    /// Places where something may touch in this step.
    pub(crate) near: Vec<Near>,
    /// Places that are near but do not take part in this step, unless they turn out to close.
    pub(crate) watched: Vec<Near>,
    /// The contacts of the step before.
    pub(crate) before: Vec<ContactTerm>,
    /// In the map frame, in the order of `movers`.
    pub(crate) shapes: Vec<MovingShape>,
    pub(crate) movers: Vec<Mover>,
    pub(crate) links_within_robot: usize,
    pub(crate) fixed: Vec<Solid>,
    pub(crate) grid: Grid,
    pub(crate) neighbors: Neighbors,
    pub(crate) contact_friction: f64,
    /// How far anything can have moved since the neighbors were found.
    pub(crate) drift: f64,
    /// How far anything can have moved since the start.
    pub(crate) traveled: f64,
    /// Per object: it need not be looked at before `traveled` is this.
    pub(crate) look_again: Vec<f64>,
    pub(crate) loads: [Point; 2],
    pub(crate) pushes: [[f64; 2]; 2],
    pub(crate) work: Work,
    pub(crate) watch: Stopwatch,
}

/// In a step nothing moves farther than this, else the step is divided, in units of the machine: most of the net's thickness.
const LONGEST_MOVE: f64 = 8e-3;
/// A step is halved so often at most.
const DIVISIONS: usize = 8;

impl World {
    /// At rest.
    pub fn new(setup: Setup) -> Self {
        let Setup {
            robot,
            robot_outline,
            links_within_robot,
            poses,
            net,
            nodes,
            objects,
            obstacles,
            contact_friction,
        } = setup;
        let d = robot.wheels.center_of_mass;
        let part = |(center, shape): &(Point, Footprint)| {
            let center = *center - Point::new(d, 0.0);
            match *shape {
                Footprint::Box(half) => MovingShape::of_box(center, half),
                Footprint::Disc(radius) => MovingShape::disc(center, radius),
            }
        };
        let outline: Vec<MovingShape> = robot_outline.iter().map(part).collect();
        let mut bodies: Vec<Body> = poses
            .iter()
            .map(|pose| {
                let place = pose.position() + pose.forward() * d;
                let outline = outline.clone();
                let mut body = Body::new(robot.mass, robot.inertia, place, pose.heading, outline);
                body.hitch = robot.hitch + d;
                body
            })
            .collect();
        let mut supports = Vec::new();
        for object in &objects {
            let (shape, gyration, corner) = match object.footprint {
                Footprint::Box(half) => (
                    MovingShape::of_box(Point::ZERO, half),
                    half.norm_squared() / 3.0,
                    half,
                ),
                Footprint::Disc(r) => (
                    MovingShape::disc(Point::ZERO, r),
                    0.5 * r * r,
                    floor::disc_corner(r),
                ),
            };
            let mut body = Body::new(
                object.mass,
                object.mass * gyration,
                object.place,
                0.0,
                vec![shape],
            );
            body.awake = false;
            bodies.push(body);
            supports.push(Supports::new(corner, object.floor_limit));
        }
        let chain = Chain::new(net, nodes);
        let count = objects.len();
        let of_bodies = bodies.iter().enumerate();
        let mut movers: Vec<Mover> = of_bodies
            .flat_map(|(i, body)| std::iter::repeat_n(Mover::Body(i), body.shapes.len()))
            .collect();
        movers.extend((0..chain.links()).map(Mover::Link));
        Self {
            wheels: [Wheels::new(robot.wheels); 2],
            supports,
            shapes: vec![MovingShape::disc(Point::ZERO, 0.0); movers.len()],
            movers,
            links_within_robot: links_within_robot.max(1),
            bodies,
            chain,
            contacts: Vec::new(),
            before: Vec::new(),
            pattern: Pattern::default(),
            reordered: true,
            system: System::default(),
            near: Vec::new(),
            watched: Vec::new(),
            grid: Grid::new(&obstacles),
            fixed: obstacles,
            neighbors: Neighbors::default(),
            contact_friction,
            drift: f64::INFINITY,
            traveled: 0.0,
            look_again: vec![0.0; count],
            loads: [Point::ZERO; 2],
            pushes: [[0.0; 2]; 2],
            work: Work::default(),
            watch: Stopwatch::default(),
        }
    }

    /// Has the stages of the steps timed with this clock: [`Work::times`].
    pub fn measure(&mut self, clock: fn() -> u64) {
        self.watch = Stopwatch::new(clock);
    }

    /// Advances by `dt` (s) with these drives of the (left, right) robot.
    pub fn step(&mut self, dt: f64, drives: &[Drive; 2]) {
        self.watch.start();
        let before = [0, 1].map(|i| self.bodies[i].velocity);
        let mut impulse = [Point::ZERO; 2];
        self.pushes = [[0.0; 2]; 2];
        self.update_sleep();
        self.advance(dt, drives, DIVISIONS, &mut impulse);
        for i in 0..2 {
            let gained = (self.bodies[i].velocity - before[i]) * self.bodies[i].mass;
            self.loads[i] = (gained - impulse[i]) / dt;
            self.pushes[i] = self.pushes[i].map(|push| push / dt);
        }
    }

    fn advance(
        &mut self,
        dt: f64,
        drives: &[Drive; 2],
        divisions: usize,
        impulse: &mut [Point; 2],
    ) {
        let mut reach = 1e-3 + 2.5 * dt * self.greatest_speed();
        self.place_shapes();
        let mut all = false;
        loop {
            if self.drift + self.drift + reach > SKIN {
                self.find_neighbors();
            }
            self.find_contacts(dt, reach, all);
            self.solve(dt, drives);
            let moved = self.greatest_displacement(dt);
            if moved > LONGEST_MOVE && divisions > 0 {
                for _ in 0..2 {
                    self.advance(0.5 * dt, drives, divisions - 1, impulse);
                }
                return;
            }
            if !all && self.something_closed(dt) {
                all = true;
                continue;
            }
            if 2.0 * moved <= reach {
                self.accept(dt, moved, impulse);
                self.watch.ends(Stage::Motion, &mut self.work);
                return;
            }
            reach = 2.5 * moved;
        }
    }

    fn accept(&mut self, dt: f64, moved: f64, impulse: &mut [Point; 2]) {
        for part in 0..self.bodies.len() {
            if self.bodies[part].awake {
                let [x, y, spin] = self.solution(part);
                let body = &mut self.bodies[part];
                body.velocity = Point::new(x, y);
                body.spin = spin;
                body.place += body.velocity * dt;
                body.heading += spin * dt;
            }
        }
        let hitches = [0, 1].map(|i: usize| self.bodies[i].hitch_place());
        self.chain.accept(dt, hitches);
        self.drift += moved;
        self.traveled += moved;
        for ((wheels, impulse), pushes) in self.wheels.iter().zip(impulse).zip(&mut self.pushes) {
            *impulse += wheels.force() * dt;
            for (sum, force) in pushes.iter_mut().zip(wheels.push()) {
                *sum += force * dt;
            }
        }
    }

    fn greatest_speed(&self) -> f64 {
        let bodies = self.bodies.iter().filter(|b| b.awake);
        let of_bodies = bodies.map(|b| b.velocity.norm() + b.spin.abs() * b.reach);
        let of_net = self.chain.velocities.iter().map(|v| v.norm());
        of_bodies.chain(of_net).fold(0.0, f64::max)
    }

    fn greatest_displacement(&self, dt: f64) -> f64 {
        let bodies = self.bodies.iter().enumerate().filter(|(_, b)| b.awake);
        let of_bodies = bodies.map(|(part, body)| {
            let [x, y, spin] = self.solution(part);
            dt * (Point::new(x, y).norm() + spin.abs() * body.reach)
        });
        of_bodies.fold(dt * self.chain.greatest_speed_found(), f64::max)
    }
}
