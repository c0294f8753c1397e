//! The momentum balance of a step: what of the world enters the system, and where.

use crate::envelope::Envelope;
use crate::newton::{System, Terms};
use crate::wheels::Drive;
use crate::world::World;

/// All that acts in a step besides what is linear.
struct Balance<'a> {
    world: &'a mut World,
    dt: f64,
    drives: &'a [Drive; 2],
}

impl World {
    /// Solves a step of `dt`; terms and `system` are then those of the solution.
    pub(crate) fn solve(&mut self, dt: f64, drives: &[Drive; 2]) {
        let mut system = std::mem::take(&mut self.system);
        self.fill(&mut system, dt);
        self.work.steps += 1;
        let world = &mut *self;
        let outcome = system.solve(&mut Balance { world, dt, drives }, dt);
        self.work.systems += outcome.systems;
        self.work.unconverged += u64::from(!outcome.solved);
        self.chain.finish(dt, &system.u);
        self.system = system;
    }

    /// The solution for a body: velocity and turning rate.
    pub(crate) fn solution(&self, part: usize) -> [f64; 3] {
        let o = self.order.offset(part);
        [self.system.u[o], self.system.u[o + 1], self.system.u[o + 2]]
    }

    /// The velocities of the step before as a guess, and what is linear in them.
    fn fill(&mut self, s: &mut System, dt: f64) {
        s.reset(self.order.first_columns());
        for (part, body) in self.bodies.iter().enumerate() {
            if !body.awake {
                continue;
            }
            let o = self.order.offset(part);
            s.u[o] = body.velocity.x;
            s.u[o + 1] = body.velocity.y;
            s.u[o + 2] = body.spin;
            s.turning[o + 2] = true;
            s.linear.add(o, o, body.mass);
            s.linear.add(o + 1, o + 1, body.mass);
            s.linear.add(o + 2, o + 2, body.inertia);
        }
        for node in 1..self.chain.links() {
            let o = self.order.offset(self.bodies.len() + node - 1);
            s.u[o] = self.chain.velocities[node].x;
            s.u[o + 1] = self.chain.velocities[node].y;
        }
        self.chain.add_mass(&mut s.linear);
        s.linear.multiply(&s.u, &mut s.constant);
        for contact in &mut self.contacts {
            contact.soften(dt, |unknown| 1.0 / s.linear.diagonal(unknown));
        }
        let robots = [self.order.offset(0), self.order.offset(1)];
        self.chain.begin(dt);
        self.chain.add_damping(dt, robots, &mut s.linear);
        self.chain.add_springs(dt, &mut s.linear, &mut s.constant);
        for (i, wheels) in self.wheels.iter_mut().enumerate() {
            wheels.begin(dt, &self.bodies[i], robots[i]);
        }
    }
}

impl Terms for Balance<'_> {
    fn evaluate(&mut self, first: bool, u: &[f64], gradient: &mut [f64]) {
        let (world, dt) = (&mut *self.world, self.dt);
        let (robots, objects) = world.bodies.split_at(2);
        for (i, wheels) in world.wheels.iter_mut().enumerate() {
            wheels.evaluate(dt, first, robots[i].mass, &self.drives[i], u, gradient);
        }
        for (i, (body, supports)) in objects.iter().zip(&mut world.supports).enumerate() {
            if body.awake {
                supports.evaluate(dt, first, world.order.offset(2 + i), u, gradient);
            }
        }
        world.chain.evaluate(dt, first, u, gradient);
        for contact in &mut world.contacts {
            contact.evaluate(dt, first, u, gradient);
        }
    }

    fn add_stiffness(&self, matrix: &mut Envelope) {
        let (world, dt) = (&*self.world, self.dt);
        for wheels in &world.wheels {
            wheels.add_stiffness(dt, matrix);
        }
        for (i, supports) in world.supports.iter().enumerate() {
            if world.bodies[2 + i].awake {
                supports.add_stiffness(dt, world.order.offset(2 + i), matrix);
            }
        }
        world.chain.add_stiffness(dt, matrix);
        for contact in &world.contacts {
            contact.add_stiffness(dt, matrix);
        }
    }
}
