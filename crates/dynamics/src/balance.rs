//! The momentum balance of a step: what of the world enters the system, and where.

use crate::block::Triple;
use crate::matrix::Matrix;
use crate::newton::{System, Terms};
use crate::pattern::Pattern;
use crate::wheels::Drive;
use crate::work::Stage;
use crate::world::World;

/// All that acts in a step besides what is linear.
struct Balance<'a> {
    world: &'a mut World,
    pattern: &'a Pattern,
    dt: f64,
    drives: &'a [Drive; 2],
}

impl World {
    /// Solves a step of `dt`; terms and `system` are then those of the solution.
    pub(crate) fn solve(&mut self, dt: f64, drives: &[Drive; 2]) {
        let mut system = std::mem::take(&mut self.system);
        let pattern = std::mem::take(&mut self.pattern);
        let (mut work, mut watch) = (self.work, self.watch);
        self.fill(&mut system, &pattern, dt);
        watch.ends(Stage::Rows, &mut work);
        work.steps += 1;
        work.parts += pattern.size() as u64;
        work.contacts += self.contacts.len() as u64;
        let mut balance = Balance {
            world: &mut *self,
            pattern: &pattern,
            dt,
            drives,
        };
        system.solve(&pattern, &mut balance, dt, (&mut work, &mut watch));
        self.chain.finish(dt, &system.u);
        (self.work, self.watch) = (work, watch);
        self.system = system;
        self.pattern = pattern;
    }

    /// The solution for a body: velocity and turning rate.
    pub(crate) fn solution(&self, part: usize) -> Triple {
        self.system.u[self.pattern.slot(part) as usize]
    }

    /// The velocities of the step before as a guess, and what is linear in them.
    fn fill(&mut self, s: &mut System, pattern: &Pattern, dt: f64) {
        s.reset(pattern, std::mem::take(&mut self.reordered));
        for (part, body) in self.bodies.iter().enumerate() {
            if !body.awake {
                continue;
            }
            let slot = pattern.slot(part) as usize;
            s.u[slot] = [body.velocity.x, body.velocity.y, body.spin];
            let block = &mut s.linear.blocks[slot];
            for (k, inertia) in [body.mass, body.mass, body.inertia].into_iter().enumerate() {
                block[k][k] = inertia;
            }
        }
        for node in 1..self.chain.links() {
            let slot = pattern.slot(self.bodies.len() + node - 1) as usize;
            let velocity = self.chain.velocities[node];
            s.u[slot] = [velocity.x, velocity.y, 0.0];
            s.linear.blocks[slot][2][2] = 1.0;
        }
        self.chain.add_mass(pattern, &mut s.linear);
        s.linear.multiply(pattern, &s.u, &mut s.constant);
        for contact in &mut self.contacts {
            contact.soften(dt, |slot| s.linear.diagonal(slot).map(|mass| 1.0 / mass));
        }
        let robots = [pattern.slot(0), pattern.slot(1)];
        self.chain.begin(dt);
        self.chain.add_damping(dt, robots, pattern, &mut s.linear);
        self.chain
            .add_springs(dt, pattern, &mut s.linear, &mut s.constant);
        for (i, wheels) in self.wheels.iter_mut().enumerate() {
            wheels.begin(dt, &self.bodies[i], robots[i], pattern);
        }
    }
}

impl Terms for Balance<'_> {
    fn begin(&mut self, u: &[Triple]) {
        for contact in &mut self.world.contacts {
            contact.begin(u);
        }
    }

    fn direct(&mut self, direction: &[Triple]) {
        for contact in &mut self.world.contacts {
            contact.direct(direction);
        }
    }

    fn slope(&self, u: &[Triple], d: &[Triple], length: f64) -> f64 {
        let (world, dt) = (&*self.world, self.dt);
        let line = (u, d, length);
        let mut slope = world.chain.slope(dt, line);
        for (i, wheels) in world.wheels.iter().enumerate() {
            slope += wheels.slope(dt, world.bodies[i].mass, &self.drives[i], line);
        }
        for (i, supports) in world.supports.iter().enumerate() {
            if world.bodies[2 + i].awake {
                let slot = self.pattern.slot(2 + i) as usize;
                let (from, rate) = (&u[slot], &d[slot]);
                let there = [0, 1, 2].map(|k: usize| from[k] + length * rate[k]);
                slope += supports.slope(dt, &there, rate);
            }
        }
        for contact in &world.contacts {
            slope += contact.slope(length);
        }
        slope
    }

    fn advance(&mut self, length: f64) {
        for contact in &mut self.world.contacts {
            contact.advance(length);
        }
    }

    fn evaluate(&mut self, first: bool, u: &[Triple], gradient: &mut [Triple]) {
        let (world, dt) = (&mut *self.world, self.dt);
        let (robots, objects) = world.bodies.split_at(2);
        for (i, wheels) in world.wheels.iter_mut().enumerate() {
            wheels.evaluate(dt, first, robots[i].mass, &self.drives[i], u, gradient);
        }
        for (i, (body, supports)) in objects.iter().zip(&mut world.supports).enumerate() {
            if body.awake {
                let slot = self.pattern.slot(2 + i) as usize;
                supports.evaluate(dt, first, &u[slot], &mut gradient[slot]);
            }
        }
        world.chain.evaluate(dt, first, u, gradient);
        for contact in &mut world.contacts {
            contact.evaluate(dt, first, gradient);
        }
    }

    fn add_stiffness(&self, matrix: &mut Matrix) {
        let (world, dt) = (&*self.world, self.dt);
        for wheels in &world.wheels {
            wheels.add_stiffness(dt, matrix);
        }
        for (i, supports) in world.supports.iter().enumerate() {
            if world.bodies[2 + i].awake {
                supports.add_stiffness(dt, self.pattern.slot(2 + i), matrix);
            }
        }
        world.chain.add_stiffness(dt, self.pattern, matrix);
        for contact in &world.contacts {
            contact.add_stiffness(matrix);
        }
    }
}
