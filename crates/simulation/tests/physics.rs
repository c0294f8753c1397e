//! The physics against theory.

mod scenes;

use pairtrawl_geometry::Point;
use pairtrawl_model::{Obstacle, Scene};
use pairtrawl_simulation::{Options, Part, RobotDrive, Simulation};
use rayon::prelude::*;
use scenes::{CUBE, Numbers, cube, empty};

const CRUISE: RobotDrive = RobotDrive::Velocity {
    forward: 0.2,
    turn_rate: 0.0,
};

/// This project's engine and rapier.
fn engines() -> [Options; 2] {
    [Options::default(), Options::rapier()]
}

/// Dry friction: once the net slides as a whole along its pull, the robots together pull with mu m g, at any speed.
#[test]
fn an_empty_net_drags_with_mu_m_g() {
    for options in [Options::default(), Options::quick(), Options::rapier()] {
        for length in [1.45, 2.0] {
            let scene = empty();
            let mut simulation = Simulation::new(&scene, length, &options).unwrap();
            let (mut load, mut drive, mut steps) = (0.0, 0.0, 0.0);
            while simulation.time() < 7.0 {
                simulation.step([CRUISE; 2]).unwrap();
                if simulation.time() > 4.0 {
                    let loads = simulation.loads();
                    load -= loads[0].load.y + loads[1].load.y;
                    drive += loads[0].drive_force + loads[1].drive_force;
                    steps += 1.0;
                }
            }
            let expected = 0.2 * 0.02 * length * 9.81;
            for (name, mean) in [("load", load / steps), ("drive force", drive / steps)] {
                assert!(
                    (mean / expected - 1.0).abs() < 0.005,
                    "{name} {mean} N, expected {expected} N"
                );
            }
        }
    }
}

/// Both robots pull with 10 N on a net that hangs on a post: it holds.
#[test]
fn a_snagged_net_holds_on_its_post() {
    let post = (Point::new(0.02, -0.3), 0.08);
    let mut round = empty();
    round.obstacles.push(Obstacle::Circle {
        center: post.0,
        radius: post.1,
    });
    let mut square = empty();
    square
        .obstacles
        .push(scenes::block(-0.06, -0.4, 0.1, -0.25));
    let cases = engines().map(|options| [(round.clone(), options), (square.clone(), options)]);
    for (scene, options) in cases.into_iter().flatten() {
        let mut simulation = Simulation::new(&scene, 2.0, &options).unwrap();
        // 5 N a wheel, and some damping of the yaw: a robot on a taut rope is a pendulum.
        let pull = |turn_rate: f64| RobotDrive::Torques {
            left: (5.0 + 0.2 * turn_rate) * scene.physics.wheel_radius,
            right: (5.0 - 0.2 * turn_rate) * scene.physics.wheel_radius,
        };
        let (mut depth, mut gap): (f64, f64) = (0.0, 0.0);
        while simulation.time() < 4.5 {
            simulation.step([CRUISE; 2]).unwrap();
        }
        while simulation.time() < 8.0 {
            let drive = simulation.robots().map(|r| pull(r.turn_rate));
            simulation.step(drive).unwrap();
            gap = gap.max(simulation.joint_gap());
            for contact in simulation.contacts() {
                if matches!(
                    (contact.first, contact.second),
                    (Part::Obstacle(_), Part::Link(_))
                ) {
                    depth = depth.max(contact.depth);
                }
            }
            if let Obstacle::Circle { center, radius } = scene.obstacles[0] {
                let nearest = simulation
                    .net()
                    .iter()
                    .map(|p| p.distance(center))
                    .fold(f64::INFINITY, f64::min);
                depth = depth.max(radius - nearest);
            }
        }
        let held = simulation.loads().map(|l| l.load.norm());
        let robots = simulation.robots();
        assert!(
            held.iter().all(|force| (9.0..11.0).contains(force)),
            "{held:?} N"
        );
        assert!(robots.iter().all(|r| r.forward.abs() < 1e-3), "{robots:?}");
        assert!(depth < 1e-3, "penetration {depth} m");
        assert!(gap < 1e-3, "joint gap {gap} m");
    }
}

/// Random drives of both robots with cubes in and around the net: no cube's center ever comes nearer to the net's middle line
/// than its half side and the net's half thickness allow.
#[test]
fn no_cube_passes_through_the_net_in_100_random_drives() {
    let nearest = |seed: u64| -> f64 {
        // Every tenth drive in rapier, which is slow.
        let options = match seed % 10 {
            0 => Options::rapier(),
            _ => Options::quick(),
        };
        let mut numbers = Numbers(seed);
        let mut scene = empty();
        scene.objects = (0..4)
            .map(|i| cube(0.07 * f64::from(i) - 0.1, numbers.between(-0.5, -0.32)))
            .collect();
        scene
            .objects
            .push(cube(numbers.between(-0.6, 0.6), numbers.between(0.4, 0.6)));
        scene.objects.push(cube(
            numbers.between(-0.6, 0.6),
            numbers.between(-1.2, -1.0),
        ));
        let mut simulation = Simulation::new(&scene, numbers.between(1.3, 2.0), &options).unwrap();
        let mut nearest = f64::INFINITY;
        for _ in 0..4 {
            let drive = [0, 1].map(|_| RobotDrive::Velocity {
                forward: numbers.between(-0.1, 0.26),
                turn_rate: numbers.between(-1.0, 1.0),
            });
            for _ in 0..(1.0 / options.time_step) as usize {
                simulation.step(drive).unwrap();
            }
            nearest = nearest.min(clearance(&simulation));
        }
        nearest
    };
    let all: Vec<f64> = (0..100u64).into_par_iter().map(nearest).collect();
    let worst = all.iter().copied().fold(f64::INFINITY, f64::min);
    assert!(
        worst > 0.5 * CUBE + 0.005 - 1e-3,
        "a cube's center came within {worst} m of the net's middle line"
    );
}

/// Least distance of a cube's center from the net's middle line, m.
fn clearance(simulation: &Simulation) -> f64 {
    let net = simulation.net();
    let distance = |p: Point, a: Point, b: Point| {
        let t = ((p - a).dot(b - a) / (b - a).norm_squared()).clamp(0.0, 1.0);
        p.distance(a.lerp(b, t))
    };
    let to_net = |p: Point| {
        net.windows(2)
            .map(|s| distance(p, s[0], s[1]))
            .fold(f64::INFINITY, f64::min)
    };
    simulation
        .objects()
        .iter()
        .map(|o| to_net(o.position()))
        .fold(f64::INFINITY, f64::min)
}

/// Friction and contacts only take energy away.
#[test]
fn energy_never_grows_without_drive() {
    let mut scene = empty();
    scene.objects = vec![
        cube(-0.1, 0.25),
        cube(0.0, 0.2),
        cube(0.04, -0.5),
        cube(0.1, -0.45),
    ];
    scene.obstacles.push(scenes::block(-0.2, 1.1, 0.1, 1.3));
    for options in engines() {
        energy_falls(&scene, &options);
    }
}

fn energy_falls(scene: &Scene, options: &Options) {
    let mut simulation = Simulation::new(scene, 1.6, options).unwrap();
    let turn = [-0.4, 0.4].map(|turn_rate| RobotDrive::Velocity {
        forward: 0.25,
        turn_rate,
    });
    while simulation.time() < 3.0 {
        simulation.step(turn).unwrap();
    }
    let mut before = simulation.energy();
    assert!(before > 0.02, "{before} J");
    while simulation.time() < 6.0 {
        simulation.step([RobotDrive::COAST; 2]).unwrap();
        let now = simulation.energy();
        assert!(
            now <= before + 1e-9,
            "grew from {before} J to {now} J at {} s",
            simulation.time()
        );
        before = now;
    }
}

/// Runs do not influence each other, and the number of threads does not matter: same bits.
#[test]
fn runs_are_equal_to_the_last_bit_at_one_and_two_threads() {
    let run = |seed: u64| -> Vec<u64> {
        let mut numbers = Numbers(seed);
        let mut scene = empty();
        scene.objects = (0..6)
            .map(|i| cube(0.08 * f64::from(i) - 0.2, numbers.between(0.3, 0.5)))
            .collect();
        let mut simulation = Simulation::new(&scene, 1.5, &Options::default()).unwrap();
        let drive = [0, 1].map(|_| RobotDrive::Velocity {
            forward: 0.2,
            turn_rate: numbers.between(-0.1, 0.1),
        });
        while simulation.time() < 4.0 {
            simulation.step(drive).unwrap();
        }
        let poses = simulation.objects().into_iter().chain(simulation.links());
        poses
            .flat_map(|p| [p.x.to_bits(), p.y.to_bits(), p.heading.to_bits()])
            .collect()
    };
    let all = |threads: usize| -> Vec<Vec<u64>> {
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(threads)
            .build()
            .unwrap();
        pool.install(|| (0..4u64).into_par_iter().map(run).collect())
    };
    let one = all(1);
    assert_eq!(one, all(2));
    assert_ne!(one[0], one[1]);
}
