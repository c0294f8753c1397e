//! The engine against theory.

use crate::{
    Drive, Footprint, NetParameters, ObjectParameters, RobotParameters, Setup, Solid,
    WheelParameters, World,
};
use pairtrawl_geometry::{Convex, Point, Pose};
use std::f64::consts::FRAC_PI_2;

const GRAVITY: f64 = 9.81;

/// Two robots 0.8 m apart that head for +y, a net of 2 m in a V behind them with this mass (kg/m), and nothing else.
fn setup(net_mass: f64) -> Setup {
    let (links, half_gap, hitch) = (20, 0.4, 0.207);
    let length = 2.0 / f64::from(links);
    let mass = net_mass * length;
    let depth = (1.0_f64 - half_gap * half_gap).sqrt();
    let node = |i: i32| {
        let s = f64::from(i) * length;
        Point::new(
            half_gap * (s - 1.0),
            -hitch - depth * (1.0 - (s - 1.0).abs()),
        )
    };
    let robot = RobotParameters {
        mass: 1.43,
        inertia: 0.0146,
        wheels: WheelParameters {
            half_track: 0.144,
            radius: 0.033,
            max_torque: 3.0,
            traction: 0.8 * 1.43 * GRAVITY,
            center_of_mass: 0.02,
        },
        hitch,
    };
    let base = Footprint::Box(Point::new(0.133, 0.133));
    Setup {
        robot,
        robot_outline: vec![(Point::new(-0.064, 0.0), base)],
        links_within_robot: 1,
        poses: [-half_gap, half_gap].map(|x| Pose::new(x, 0.0, FRAC_PI_2)),
        net: NetParameters {
            link_length: length,
            link_mass: mass,
            link_inertia: mass * (length * length + 1e-4) / 12.0,
            thickness: 0.01,
            hinge_damping: 1e-3,
            floor_limit: 0.2 * mass * GRAVITY,
        },
        nodes: (0..=links).map(node).collect(),
        objects: Vec::new(),
        obstacles: Vec::new(),
        contact_friction: 0.2,
    }
}

fn cube(x: f64, y: f64) -> ObjectParameters {
    ObjectParameters {
        place: Point::new(x, y),
        footprint: Footprint::Box(Point::new(0.025, 0.025)),
        mass: 0.025,
        floor_limit: 0.2 * 0.025 * GRAVITY,
    }
}

const REST: [Drive; 2] = [Drive::Torques([0.0; 2]); 2];
const CRUISE: [Drive; 2] = [Drive::Velocity {
    forward: 0.2,
    turn_rate: 0.0,
}; 2];

/// A wall (an object of a thousand tons that slides freely) pushes a cube for 5 s at 0.2 m/s, moving at `angle` to its normal;
/// how far the wall slips along the cube after half a second, m.
fn slip_along_wall(angle: f64, dt: f64) -> f64 {
    let mut setup = setup(0.02);
    setup.objects = vec![
        ObjectParameters {
            place: Point::new(0.0, 4.95),
            footprint: Footprint::Box(Point::new(2.0, 0.05)),
            mass: 1e6,
            floor_limit: 0.0,
        },
        cube(0.0, 5.0252),
    ];
    let mut world = World::new(setup);
    world.bodies[2].awake = true;
    world.bodies[2].velocity = Point::unit(FRAC_PI_2 - angle) * 0.2;
    let offset = |world: &World| world.object_pose(0).x - world.object_pose(1).x;
    let mut settled = 0.0;
    for step in 0..(5.5 / dt).round() as usize {
        if step == (0.5 / dt).round() as usize {
            settled = offset(&world);
        }
        world.step(dt, &REST);
    }
    offset(&world) - settled
}

/// Coulomb's cone at mu = 0.2 opens at 11.3 degrees: at 8 degrees the cube sticks, at 20 degrees it moves along the cone's edge,
/// so the wall slips by v (sin a - mu cos a).
#[test]
fn an_oblique_wall_sticks_at_8_degrees_and_slips_at_20_as_theory_says() {
    for dt in [2e-3_f64, 1e-2, 2e-2] {
        let stuck = slip_along_wall(8_f64.to_radians(), dt);
        assert!(stuck.abs() < 1e-3, "{stuck} m at {dt} s");
        let angle = 20_f64.to_radians();
        let expected = 0.2 * 5.0 * (libm::sin(angle) - 0.2 * libm::cos(angle));
        let slipped = slip_along_wall(angle, dt);
        assert!(
            (slipped / expected - 1.0).abs() < 0.01,
            "{slipped} m, expected {expected} m at {dt} s"
        );
    }
}

/// [x, y, heading, v, w] of a robot after `time` under changing torques, by RK4 of M v' + C v = B tau with
/// M = diag(m, I + m d^2) and C = [[0, -m d w], [m d w, 0]].
fn exact_robot(robot: &RobotParameters, start: Pose, time: f64) -> [f64; 5] {
    let (m, d) = (robot.mass, robot.wheels.center_of_mass);
    let inertia = robot.inertia + m * d * d;
    let rate = |t: f64, s: [f64; 5]| -> [f64; 5] {
        let [left, right] = torques(t).map(|tau| tau / robot.wheels.radius);
        let [_, _, heading, v, w] = s;
        let forward = Point::unit(heading) * v;
        let turn = (right - left) * robot.wheels.half_track - m * d * w * v;
        [
            forward.x,
            forward.y,
            w,
            (left + right + m * d * w * w) / m,
            turn / inertia,
        ]
    };
    let add = |s: [f64; 5], k: [f64; 5], h: f64| std::array::from_fn(|i| s[i] + h * k[i]);
    let (mut state, h) = ([start.x, start.y, start.heading, 0.0, 0.0], 1e-3);
    for i in 0..(time / h).round() as u32 {
        let t = f64::from(i) * h;
        let k1 = rate(t, state);
        let k2 = rate(t + 0.5 * h, add(state, k1, 0.5 * h));
        let k3 = rate(t + 0.5 * h, add(state, k2, 0.5 * h));
        let k4 = rate(t + h, add(state, k3, h));
        state = std::array::from_fn(|j| {
            state[j] + h / 6.0 * (k1[j] + 2.0 * k2[j] + 2.0 * k3[j] + k4[j])
        });
    }
    state
}

fn torques(t: f64) -> [f64; 2] {
    let (s, c) = libm::sincos(0.9 * t);
    [
        0.0040 * c + 0.0012 * s,
        0.0040 * c - 0.0009 * libm::sin(2.3 * t),
    ]
}

/// Both robots drive alike, with a net that weighs next to nothing.
#[test]
fn a_lone_robot_follows_its_equations() {
    for dt in [1e-3_f64, 2e-3, 1e-2] {
        let mut setup = setup(1e-5);
        setup.net.floor_limit = 0.0;
        setup.net.hinge_damping = 0.0;
        let (robot, start) = (setup.robot, setup.poses[0]);
        let mut world = World::new(setup);
        for i in 0..(10.0 / dt).round() as u32 {
            world.step(dt, &[Drive::Torques(torques((f64::from(i) + 0.5) * dt)); 2]);
        }
        let [x, y, heading, v, _] = exact_robot(&robot, start, 10.0);
        let pose = world.robot_pose(0);
        let off = pose.position().distance(Point::new(x, y));
        assert!(Point::new(x, y).distance(start.position()) > 0.3, "{x} {y}");
        // Euler's first order: a step's worth of the way that the speed gained makes.
        assert!(off < 1e-3 + dt * (0.3 + v.abs()), "{off} m off at {dt} s");
        assert!(
            (pose.heading - heading).abs() < 2e-3 + dt,
            "{pose:?}, exactly {heading}"
        );
    }
}

/// Dry friction: once the net slides as a whole along its pull, the robots together pull with mu m g.
#[test]
fn an_empty_net_drags_with_mu_m_g() {
    for dt in [2e-3_f64, 1e-2, 2e-2] {
        let mut world = World::new(setup(0.02));
        let (mut load, mut steps) = (0.0, 0.0);
        for step in 0..(7.0 / dt) as usize {
            world.step(dt, &CRUISE);
            if step as f64 * dt > 4.0 {
                load -= world.load(0).y + world.load(1).y;
                steps += 1.0;
            }
        }
        let expected = 0.2 * 0.04 * GRAVITY;
        assert!(
            (load / steps / expected - 1.0).abs() < 1e-3,
            "{} N",
            load / steps
        );
        assert_eq!(world.work().unconverged, 0);
    }
}

/// A cube shot at a wall that is much thinner than a step's way stops in front of it, even if the step is long.
#[test]
fn what_is_fast_does_not_pass_through_a_thin_wall() {
    for speed in [1.0, 10.0, 50.0] {
        let mut setup = setup(0.02);
        let wall = [(0.3, 2.9), (0.301, 2.9), (0.301, 3.1), (0.3, 3.1)];
        setup.obstacles = vec![Solid::new(Convex::Polygon(
            wall.map(|(x, y)| Point::new(x, y)).to_vec(),
        ))];
        setup.objects = vec![cube(0.0, 3.0)];
        let mut world = World::new(setup);
        world.bodies[2].awake = true;
        world.bodies[2].velocity = Point::new(speed, 0.0);
        let mut farthest: f64 = 0.0;
        for _ in 0..50 {
            world.step(2e-2, &REST);
            farthest = farthest.max(world.object_pose(0).x);
        }
        let touch = 0.275;
        assert!(
            farthest < touch + 5e-3,
            "at {speed} m/s it came to {farthest} m"
        );
        // It may spring back a little before it is looked at; at 1 m/s the floor stops it after 25 cm.
        assert!(
            farthest > if speed > 2.0 { touch - 0.03 } else { 0.2 },
            "{farthest}"
        );
    }
}

/// Every step of a drive through cubes is solved to the tolerance, with few linear systems.
#[test]
fn steps_are_solved() {
    let mut setup = setup(0.02);
    setup.objects = (0..13)
        .map(|i| {
            cube(
                0.06 * f64::from((i * 5) % 7) - 0.18,
                0.3 + 0.25 * f64::from(i),
            )
        })
        .collect();
    let mut world = World::new(setup);
    for _ in 0..2000 {
        world.step(1e-2, &CRUISE);
    }
    let work = world.work();
    assert!(work.unconverged * 500 <= work.steps, "{work:?}");
    assert!(work.systems <= 3 * work.steps, "{work:?}");
    let y = world.robot_pose(0).y;
    for object in 0..12 {
        assert!(
            world.object_pose(object).y < y,
            "{:?}",
            world.object_pose(object)
        );
    }
}
