//! Whole solves: feasible, infeasible and cut short; the same bits every time; equivalent formulations agree.

use pairtrawl_certificate::certify;
use pairtrawl_generate::{Generated, Kind, generate};
use pairtrawl_geometry::{Point, Pose};
use pairtrawl_model::{
    Area, ClaimId, Footprint, Object, Obstacle, PairPose, PairTrajectory, Scene, Side, SolverStatus,
};
use pairtrawl_trajopt::{Problem, Settings, Solution, evaluate, optimize, optimize_watched};
use pairtrawl_world::World;

fn problem(scene: &Scene, net_length: Option<f64>) -> Problem {
    let world = World::new(scene, net_length).expect("a world");
    Problem::new(scene, net_length, &world.pieces)
}

fn witness(difficulty: u8, seed: u64, waypoints: usize) -> Generated {
    generate(Kind::Witness, difficulty, seed, waypoints).expect("a scene")
}

fn solve(made: &Generated, net_length: Option<f64>) -> Solution {
    let problem = problem(&made.scene, net_length);
    optimize(&problem, &made.witness, &Settings::default())
}

#[test]
fn generated_scenes_are_solved_and_certified() {
    for difficulty in [1, 4, 7, 10] {
        for (seed, waypoints) in [(1, 120), (2, 200)] {
            let made = witness(difficulty, seed, waypoints);
            for net_length in [Some(made.net_length), None] {
                let at = format!("difficulty {difficulty}, seed {seed}, net {net_length:?}");
                let solution = solve(&made, net_length);
                assert_eq!(solution.status, SolverStatus::Converged, "{at}");
                assert!(solution.violations.is_empty(), "{at}");
                assert!(solution.iterations <= 150, "{at}: {}", solution.iterations);
                let certificate =
                    certify(&made.scene, solution.net_length, &solution.trajectory, None);
                let failing: Vec<_> = certificate.claims.iter().filter(|c| !c.holds).collect();
                assert!(failing.is_empty(), "{at}: {failing:?}");
                let cost = evaluate(&made.scene, &solution.trajectory, solution.net_length);
                let before = evaluate(&made.scene, &made.witness, made.net_length);
                // Where margins are tight the optimum pays for more of them than the witness keeps.
                assert!(
                    difficulty > 7 || cost.total() < before.total(),
                    "{at}: no better than the start"
                );
                assert_eq!(cost.obstacle, 0.0, "{at}");
            }
        }
    }
}

/// A pair that is to drive straight on through a gap between two walls.
fn gap_scene(half_gap: f64) -> (Scene, PairTrajectory) {
    let mut scene = witness(1, 1, 60).scene;
    scene.objects.clear();
    scene.area = Area {
        min: Point::new(-1.0, -2.0),
        max: Point::new(5.0, 2.0),
        resolution: 0.05,
    };
    let wall = |low: f64, high: f64| Obstacle::Box {
        min: Point::new(1.9, low),
        max: Point::new(2.1, high),
    };
    scene.obstacles = vec![wall(half_gap, 3.0), wall(-3.0, -half_gap)];
    let at = |x: f64| PairPose {
        left: Pose::new(x, 0.4, 0.0),
        right: Pose::new(x, -0.4, 0.0),
    };
    (scene.start, scene.end) = (at(0.0), at(4.0));
    let x = |i: usize| 4.0 * i as f64 / 99.0;
    let start = PairTrajectory {
        left: (0..100).map(|i| at(x(i)).left).collect(),
        right: (0..100).map(|i| at(x(i)).right).collect(),
        step_time: 0.25,
    };
    (scene, start)
}

/// Checks what an infeasible problem says of itself, and that the certificate agrees.
fn assert_named(scene: &Scene, solution: &Solution, claims: &[&str]) {
    for v in &solution.violations {
        assert!((30..70).contains(&v.step), "{v:?}");
        assert!((v.place.x - 2.0).abs() < 0.8, "{v:?}");
        assert!(v.amount > 0.0 && v.amount < 1.2, "{v:?}");
    }
    for claim in claims {
        assert!(
            solution.violations.iter().any(|v| v.claim.name() == *claim),
            "{claim} is not named: {:?}",
            solution.violations
        );
    }
    let amounts: Vec<f64> = solution.violations.iter().map(|v| v.amount).collect();
    assert!(amounts.is_sorted_by(|a, b| a >= b), "worst first");
    let certificate = certify(scene, solution.net_length, &solution.trajectory, None);
    assert!(!certificate.is_valid());
}

#[test]
fn a_gap_too_narrow_for_both_robots_is_locally_infeasible() {
    // 0.72 m: robots of radius 0.24 m, as far askew as they may be, need 0.74 m.
    let (scene, start) = gap_scene(0.36);
    for net_length in [Some(1.3), None] {
        let problem = problem(&scene, net_length);
        let settings = Settings {
            max_iterations: 600,
            ..Settings::default()
        };
        let solution = optimize(&problem, &start, &settings);
        assert_eq!(solution.status, SolverStatus::LocallyInfeasible);
        assert_named(&scene, &solution, &["separation"]);
    }
}

#[test]
fn an_object_without_room_beside_it_is_named() {
    let (mut scene, start) = gap_scene(0.6);
    scene.objects = vec![Object {
        position: Point::new(2.0, 0.0),
        footprint: Footprint::Disc(0.2),
        mass: 0.02,
        leave: false,
    }];
    let problem = problem(&scene, Some(1.4));
    let solution = optimize(&problem, &start, &Settings::default());
    assert_eq!(solution.status, SolverStatus::LocallyInfeasible);
    assert_named(&scene, &solution, &["robots_miss_objects"]);
    let object = solution
        .violations
        .iter()
        .find(|v| v.claim == ClaimId::RobotsMissObjects);
    assert_eq!(object.and_then(|v| v.subject), Some(0));
}

#[test]
fn a_wall_in_the_way_is_never_called_solved() {
    // 0.3 m: no single robot fits. Inside a wall the distance has kinks on which the solver need not settle.
    let (scene, start) = gap_scene(0.15);
    let problem = problem(&scene, Some(1.3));
    let solution = optimize(&problem, &start, &Settings::default());
    assert!(
        [
            SolverStatus::LocallyInfeasible,
            SolverStatus::IterationLimit
        ]
        .contains(&solution.status),
        "{:?}",
        solution.status
    );
    assert_named(&scene, &solution, &["robot_clearance"]);
    let worst = &solution.violations[0];
    assert!(worst.subject.is_some_and(|piece| piece < 2), "{worst:?}");
}

#[test]
fn the_same_gap_made_wider_is_passed() {
    let (scene, start) = gap_scene(0.75);
    let problem = problem(&scene, Some(1.3));
    let solution = optimize(&problem, &start, &Settings::default());
    assert_eq!(solution.status, SolverStatus::Converged);
    let certificate = certify(&scene, 1.3, &solution.trajectory, None);
    assert!(certificate.is_valid(), "{certificate:?}");
}

#[test]
fn a_net_that_is_too_short_for_the_ends_is_not_called_solved() {
    let (scene, start) = gap_scene(0.75);
    let problem = problem(&scene, Some(0.7));
    let solution = optimize(&problem, &start, &Settings::default());
    assert_ne!(solution.status, SolverStatus::Converged);
    let certificate = certify(&scene, 0.7, &solution.trajectory, None);
    assert!(!certificate.is_valid());
}

#[test]
fn budgets_are_kept_and_said() {
    let made = witness(4, 1, 120);
    let problem = problem(&made.scene, Some(made.net_length));
    let settings = Settings {
        max_iterations: 3,
        ..Settings::default()
    };
    let solution = optimize(&problem, &made.witness, &settings);
    assert_eq!(solution.status, SolverStatus::IterationLimit);
    assert_eq!(solution.iterations, 3);
    let mut asked = 0;
    let mut go_on = |iteration: usize, _: &_| {
        assert_eq!(iteration, asked);
        asked += 1;
        iteration < 5
    };
    let solution = optimize_watched(&problem, &made.witness, &Settings::default(), &mut go_on);
    assert_eq!(solution.status, SolverStatus::TimeLimit);
    assert_eq!((solution.iterations, asked), (5, 6));
}

#[test]
fn the_same_input_gives_the_same_bits() {
    let made = witness(7, 2, 120);
    let bits = |solution: &Solution| -> Vec<u64> {
        let t = &solution.trajectory;
        t.left
            .iter()
            .chain(&t.right)
            .flat_map(|p| [p.x, p.y, p.heading])
            .chain([solution.net_length, solution.residuals.gap])
            .map(f64::to_bits)
            .collect()
    };
    let (first, second) = (solve(&made, None), solve(&made, None));
    assert_eq!(first.iterations, second.iterations);
    assert!(bits(&first) == bits(&second));
}

#[test]
fn fixing_the_net_at_its_best_length_changes_nothing() {
    for (difficulty, seed) in [(1, 3), (5, 1), (8, 2)] {
        let made = witness(difficulty, seed, 120);
        let solve = |start: &PairTrajectory, net_length: Option<f64>| {
            // Well below the tolerance of the comparison.
            let settings = Settings {
                relative_gap: 2e-5,
                relative_decrease: 5e-6,
                ..Settings::default()
            };
            optimize(&problem(&made.scene, net_length), start, &settings)
        };
        let free = solve(&made.witness, None);
        let fixed = solve(&free.trajectory, Some(free.net_length));
        let cost = |s: &Solution| evaluate(&made.scene, &s.trajectory, s.net_length).total();
        let (a, b) = (cost(&free), cost(&fixed));
        assert_eq!(free.status, SolverStatus::Converged);
        assert_eq!(fixed.status, SolverStatus::Converged);
        assert!((a - b).abs() <= 1e-4 * b, "{a} free, {b} fixed");
        // From the first start the way may lead to a neighboring optimum: an object is passed at another waypoint.
        let afresh = solve(&made.witness, Some(free.net_length));
        assert!(
            (cost(&afresh) - a).abs() <= 1e-3 * a,
            "{a}, afresh {}",
            cost(&afresh)
        );
        // And it is a minimum: lengths to either side cost more.
        for aside in [-0.15, 0.15] {
            let other = solve(&made.witness, Some(free.net_length + aside));
            assert!(cost(&other) > a, "{} at {aside}", cost(&other));
        }
    }
}

#[test]
fn a_warm_start_from_a_plan_leads_to_that_plan_soon() {
    for (difficulty, seed) in [(2, 1), (6, 2), (9, 1)] {
        let made = witness(difficulty, seed, 120);
        let problem = problem(&made.scene, Some(made.net_length));
        let cold = optimize(&problem, &made.witness, &Settings::default());
        let warm = optimize(&problem, &cold.trajectory, &Settings::warm());
        assert_eq!(warm.status, SolverStatus::Converged);
        let cost = |s: &Solution| evaluate(&made.scene, &s.trajectory, s.net_length).total();
        let (a, b) = (cost(&cold), cost(&warm));
        assert!(b <= a * (1.0 + 3e-4), "{a} cold, {b} warm");
        assert!(
            warm.iterations < cold.iterations,
            "{} warm, {} cold",
            warm.iterations,
            cold.iterations
        );
        // A scene that changed a little: an object moved by a centimeter.
        let mut scene = made.scene.clone();
        scene.objects[0].position.x += 0.01;
        let changed = self::problem(&scene, Some(made.net_length));
        let again = optimize(&changed, &cold.trajectory, &Settings::warm());
        assert_eq!(again.status, SolverStatus::Converged);
        assert!(certify(&scene, again.net_length, &again.trajectory, None).is_valid());
    }
}

#[test]
fn a_frozen_robot_stays_where_it_is_while_the_other_gains() {
    let made = witness(4, 1, 120);
    for frozen in Side::BOTH {
        let mut problem = problem(&made.scene, Some(made.net_length));
        problem.frozen = Some(frozen);
        let solution = optimize(&problem, &made.witness, &Settings::default());
        let robots = |t: &PairTrajectory| [t.left.clone(), t.right.clone()];
        let (before, after) = (robots(&made.witness), robots(&solution.trajectory));
        let farthest = |robot: Side| {
            before[robot.index()]
                .iter()
                .zip(&after[robot.index()])
                .map(|(a, b)| a.position().distance(b.position()))
                .fold(0.0, f64::max)
        };
        assert!(farthest(frozen) < 1e-9, "{}", farthest(frozen));
        assert!(
            farthest(frozen.other()) > 1e-2,
            "{}",
            farthest(frozen.other())
        );
        let cost = |t: &PairTrajectory| evaluate(&made.scene, t, made.net_length).total();
        assert!(cost(&solution.trajectory) < cost(&made.witness));
        // Joint is never worse.
        let joint = solve(&made, Some(made.net_length));
        assert!(cost(&joint.trajectory) < cost(&solution.trajectory));
    }
}

#[test]
fn what_is_minimized_is_j_whichever_robot_is_held() {
    let made = witness(4, 1, 120);
    for frozen in [None, Some(Side::Left), Some(Side::Right)] {
        let mut problem = problem(&made.scene, Some(made.net_length));
        // Without margins there is nothing else to pay for.
        problem.reserve.clearance = 0.0;
        problem.reserve.net_clearance = 0.0;
        problem.frozen = frozen;
        let solution = optimize(&problem, &made.witness, &Settings::default());
        assert!(solution.violations.is_empty() && solution.shrunk_margins.is_empty());
        let j = evaluate(&made.scene, &solution.trajectory, made.net_length).total();
        let share = solution.objective / j;
        assert!((share - 1.0).abs() < 1e-3, "{frozen:?}: {share}");
    }
}

/// A pair that drives straight on, a disc in the way of the line between them; `None`: nothing in the way.
fn disc_scene(disc: Option<(Point, f64)>) -> (Scene, PairTrajectory) {
    let (mut scene, start) = gap_scene(1.9);
    scene.obstacles = disc
        .map(|(center, radius)| Obstacle::Circle { center, radius })
        .into_iter()
        .collect();
    (scene, start)
}

#[test]
fn a_disc_between_the_robots_is_not_overlooked() {
    // The line between the robots sweeps over it, far from either. Waypoints are 4 cm apart: the small ones fit between two
    // lines, on which nothing is seen of them.
    let between = 0.5 * (2.0 + 4.0 * 50.0 / 99.0);
    for (center, radius) in [
        (Point::new(2.0, 0.0), 0.05),
        (Point::new(2.0, 0.0), 0.01),
        (Point::new(between, 0.1), 0.01),
        (Point::new(2.0, -0.2), 2e-3),
    ] {
        let (scene, start) = disc_scene(Some((center, radius)));
        for net_length in [Some(1.3), None] {
            let problem = problem(&scene, net_length);
            let solution = optimize(&problem, &start, &Settings::default());
            let certificate = certify(&scene, solution.net_length, &solution.trajectory, None);
            let at = format!("{center:?}, radius {radius}: {:?}", solution.status);
            if certificate.is_valid() {
                assert_eq!(solution.status, SolverStatus::Converged, "{at}");
            } else {
                assert_ne!(solution.status, SolverStatus::Converged, "{at}");
                assert_named(&scene, &solution, &["net_encloses_no_obstacle"]);
                assert_eq!(solution.violations[0].subject, Some(0), "{at}");
            }
        }
    }
}

#[test]
fn a_small_disc_beside_the_way_is_passed_with_all_of_the_net() {
    // Just within the band that the straight way sweeps, by the left robot's path: the pair swerves.
    let (scene, start) = disc_scene(Some((Point::new(2.0, 0.41), 0.01)));
    let straight = certify(&scene, 1.3, &start, None);
    assert!(!straight.is_valid(), "the straight way meets it");
    let problem = problem(&scene, Some(1.3));
    let solution = optimize(&problem, &start, &Settings::default());
    assert_eq!(solution.status, SolverStatus::Converged);
    let certificate = certify(&scene, 1.3, &solution.trajectory, None);
    assert!(certificate.is_valid(), "{certificate:?}");
}
