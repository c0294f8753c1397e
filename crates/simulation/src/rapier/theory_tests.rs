//! Parts of the physics alone against theory.

#![allow(
    clippy::disallowed_methods,
    reason = "tests compare with the standard library"
)]

use super::objects::Objects;
use super::robots::RobotBody;
use super::settings::{new_world, point, vector};
use super::tag;
use crate::test_scene::scene;
use crate::{Engine, Options, Parameters, RobotDrive};
use pairtrawl_geometry::{Point, Pose};
use pairtrawl_model::{Footprint, Object};
use rapier2d_f64::prelude::{ColliderBuilder, RigidBodyBuilder};

fn solver() -> crate::RapierSolver {
    match Options::rapier().engine {
        Engine::Rapier(solver) => solver,
        Engine::Implicit => unreachable!("the options are rapier's"),
    }
}

/// A wall pushes a cube for 5 s at 0.2 m/s, moving at `angle` to its normal; how far the wall slips along the cube, m.
fn slip_along_wall(angle: f64) -> f64 {
    let objects = vec![Object {
        position: Point::new(0.0, 0.0251),
        footprint: Footprint::Box(0.05, 0.05),
        mass: 0.025,
        leave: false,
    }];
    let scene = scene(objects);
    let parameters = Parameters::new(&scene, 2.0, &Options::rapier()).unwrap();
    let mut world = new_world(&parameters, solver());
    let velocity = Point::unit(std::f64::consts::FRAC_PI_2 - angle) * 0.2;
    let body = RigidBodyBuilder::kinematic_velocity_based().linvel(vector(velocity));
    let wall = ColliderBuilder::cuboid(2.0, 0.05)
        .translation(vector(Point::new(0.0, -0.05)))
        .friction(0.2);
    let (wall, _) = world.insert(body, wall);
    let mut objects = Objects::insert(&mut world, &parameters, &scene.objects);
    let (mut settled, mut offset) = (0.0, 0.0);
    for step in 0..5500 {
        objects.update_sleep(&mut world, &[], &[(Point::ZERO, 100.0)]);
        objects.apply(&mut world);
        world.step();
        objects.observe(&world);
        offset = point(world.bodies[wall].translation()).x - objects.poses()[0].x;
        if step == 499 {
            settled = offset;
        }
    }
    offset - settled
}

/// Coulomb's cone at mu = 0.2 opens at 11.3 degrees: at 8 degrees the cube sticks, at 20 degrees it moves along the cone's
/// edge, so the wall slips by v (sin a - mu cos a).
#[test]
fn an_oblique_wall_sticks_at_8_degrees_and_slips_at_20_as_theory_says() {
    let stuck = slip_along_wall(8f64.to_radians());
    assert!(stuck.abs() < 3e-3, "{stuck} m");
    let angle = 20f64.to_radians();
    let expected = 0.2 * 5.0 * (angle.sin() - 0.2 * angle.cos());
    let slipped = slip_along_wall(angle);
    assert!(
        (slipped / expected - 1.0).abs() < 0.02,
        "{slipped} m, expected {expected} m"
    );
}

/// A robot alone under changing torques, against RK4 of M v' + C v = B tau with M = diag(m, I + m d^2) and
/// C = [[0, -m d w], [m d w, 0]].
#[test]
fn a_lone_robot_follows_its_equations() {
    for time_step in [1e-3, 2e-3] {
        let scene = scene(Vec::new());
        let options = Options {
            time_step,
            ..Options::rapier()
        };
        let parameters = Parameters::new(&scene, 2.0, &options).unwrap();
        let physics = parameters.physics;
        let torque = |t: f64| -> [f64; 2] {
            let (s, c) = libm::sincos(0.9 * t);
            [
                0.0040 * c + 0.0012 * s,
                0.0040 * c - 0.0009 * libm::sin(2.3 * t),
            ]
        };
        let mut world = new_world(&parameters, solver());
        let mut robot = RobotBody::insert(
            &mut world,
            &parameters,
            Pose::new(0.0, 0.0, 0.4),
            tag::robot(pairtrawl_model::Side::Left),
        );
        let (m, d) = (physics.robot_mass, physics.center_of_mass);
        let inertia = physics.robot_inertia + m * d * d;
        // [x, y, heading, v, w]
        let rate = |t: f64, s: [f64; 5]| -> [f64; 5] {
            let [left, right] = torque(t).map(|tau| tau / physics.wheel_radius);
            let [_, _, heading, v, w] = s;
            [
                v * heading.cos(),
                v * heading.sin(),
                w,
                (left + right + m * d * w * w) / m,
                ((right - left) * parameters.robot.half_track - m * d * w * v) / inertia,
            ]
        };
        let add = |s: [f64; 5], k: [f64; 5], h: f64| std::array::from_fn(|i| s[i] + h * k[i]);
        let (mut exact, h) = ([0.0, 0.0, 0.4, 0.0, 0.0], 1e-3);
        for i in 0..10_000 {
            let t = f64::from(i) * h;
            let k1 = rate(t, exact);
            let k2 = rate(t + 0.5 * h, add(exact, k1, 0.5 * h));
            let k3 = rate(t + 0.5 * h, add(exact, k2, 0.5 * h));
            let k4 = rate(t + h, add(exact, k3, h));
            exact = std::array::from_fn(|j| {
                exact[j] + h / 6.0 * (k1[j] + 2.0 * k2[j] + 2.0 * k3[j] + k4[j])
            });
        }
        let steps = (10.0 / time_step).round() as usize;
        for i in 0..steps {
            let [left, right] = torque((i as f64 + 0.5) * time_step);
            robot.apply(
                &mut world,
                &parameters,
                &RobotDrive::Torques { left, right },
            );
            world.step();
            robot.observe(&world, &parameters);
        }
        let pose = robot.state.pose;
        let off = pose.position().distance(Point::new(exact[0], exact[1]));
        let traveled = exact[0].hypot(exact[1]);
        assert!(traveled > 0.3 && exact[2].abs() > 0.5, "{exact:?}");
        assert!(
            off < 5e-3,
            "{off} m off after 10 s at {time_step} s: {pose:?} against {exact:?}"
        );
        assert!(
            (pose.heading - exact[2]).abs() < 0.01,
            "{pose:?} against {exact:?}"
        );
    }
}
