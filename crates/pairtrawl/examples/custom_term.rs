//! Adds a cost and a constraint of one's own to a plan: `cargo run --release --example custom_term`.
//!
//! A pair drives through a hall. In the middle of the way it is to spread to 0.8 m (a cost), and the left robot has to keep
//! off a wet strip along the wall, of which the scene knows nothing (a constraint). The plan is optimized again with both,
//! and certified as every plan is.

use pairtrawl::model::{Overrides, Plan, Scales, Side};
use pairtrawl::trajopt::{Jet, PAIR, POINT, Problem, Role, Settings, Term, optimize_from};
use pairtrawl::{Candidate, PlanOptions, RehearsalMode, check, files, plan, world::World};

const SCENE: &str = r#"
    format = "pairtrawl-scene/1"
    area = { min = [0.0, 0.0], max = [6.0, 3.0], resolution = 0.05 }
    objects = [{ position = [3.0, 1.5], radius = 0.03 }]
    start = { left = [0.5, 1.85], right = [0.5, 1.15], heading = 0.0 }
    end = { left = [5.5, 1.85], right = [5.5, 1.15], heading = 0.0 }
"#;

/// `weight (d - wished)^2` of the separation `d`.
struct PreferredSeparation {
    weight: f64,
    wished: f64,
}

impl Term<PAIR> for PreferredSeparation {
    fn value(&self, &[rx, ry, ..]: &[f64; PAIR]) -> f64 {
        let off = (rx * rx + ry * ry).sqrt() - self.wished;
        self.weight * off * off
    }

    fn jet(&self, z: &[f64; PAIR]) -> Jet<PAIR> {
        let d = (z[0] * z[0] + z[1] * z[1]).sqrt();
        let (ux, uy) = (z[0] / d, z[1] / d);
        let w = 2.0 * self.weight;
        // The curvature across the line is negative below the wished separation: left out, for a convex stand-in.
        let across = w * ((d - self.wished) / d).max(0.0);
        let mut jet = Jet::constant(self.value(z));
        jet.gradient[0] = w * (d - self.wished) * ux;
        jet.gradient[1] = w * (d - self.wished) * uy;
        jet.hessian[0][0] = w * ux * ux + across * uy * uy;
        jet.hessian[1][1] = w * uy * uy + across * ux * ux;
        jet.set_mixed(0, 1, (w - across) * ux * uy);
        jet
    }
}

/// `limit - y >= 0`: the robot's axle center stays below a line.
struct Below {
    limit: f64,
}

impl Term<POINT> for Below {
    fn value(&self, &[_, y]: &[f64; POINT]) -> f64 {
        self.limit - y
    }

    fn jet(&self, z: &[f64; POINT]) -> Jet<POINT> {
        Jet::linear(self.value(z), [0.0, -1.0])
    }
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let loaded = files::parse_scene(SCENE, "hall")?;
    let scene = &loaded.scene;
    let options = PlanOptions {
        rehearsal: RehearsalMode::Skip,
        ..PlanOptions::default()
    };
    let before = plan(scene, &loaded.reference, &options, &mut ())?.plan;
    describe("as planned", &before);

    // The optimizer works in units of the length scale (1 m for a robot of 0.24 m radius).
    let scales = Scales::of(scene);
    let scaled = scales.scene(scene);
    let start = scales.scaled_trajectory(&before.trajectory);
    let count = start.len();
    let middle = count / 3..2 * count / 3;
    let world = World::new(&scaled, None)?;
    let problem = Problem::new(&scaled, None, &world.pieces)
        .with_pair_term(
            "spread in the middle",
            Role::Cost,
            middle,
            PreferredSeparation {
                weight: 300.0,
                wished: scales.scaled(0.8),
            },
        )
        .with_point_term(
            "off the wet strip",
            Role::Constraint,
            Side::Left,
            0..count,
            Below {
                limit: scales.scaled(1.87),
            },
        );
    let length = scales.scaled(before.net_length);
    let solution = optimize_from(
        &problem,
        &start,
        length,
        &Settings::default(),
        &mut |_, _| true,
    );
    for unmet in &solution.unmet {
        println!(
            "{} is missed by {:.3} at waypoint {}",
            unmet.name, unmet.amount, unmet.step
        );
    }

    // Whatever was added, the same claims decide whether this is a plan.
    let trajectory = scales.trajectory(scene, &solution.trajectory);
    let net_length = scales.meters(solution.net_length);
    let candidate = Candidate {
        net_length,
        trajectory: &trajectory,
        scene: Some(&loaded.reference),
        time_law: None,
        left_out: &[],
        overrides: &Overrides::default(),
    };
    let certificate = check(scene, &loaded.reference, &candidate);
    println!(
        "{:?} after {} iterations",
        solution.status, solution.iterations
    );
    let after = Plan {
        certificate,
        net_length,
        trajectory,
        ..before
    };
    describe("with terms of our own", &after);
    Ok(())
}

fn describe(name: &str, plan: &Plan) {
    let highest = plan.trajectory.left.iter().map(|p| p.y).fold(0.0, f64::max);
    let halfway = plan.trajectory.pair(plan.trajectory.len() / 2).separation();
    let holding = plan.certificate.claims.iter().filter(|c| c.holds).count();
    println!(
        "{name}: net {:.3} m, {halfway:.3} m apart half way, left robot up to y = {highest:.3} m, {holding} of {} claims hold",
        plan.net_length,
        plan.certificate.claims.len()
    );
}
