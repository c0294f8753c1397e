//! The iteration loop does not allocate: only looking up again what is near does.

use pairtrawl_generate::{Kind, generate};
use pairtrawl_trajopt::{Problem, Settings, optimize};
use pairtrawl_world::World;

/// Allocations of a solve with a bounded number of iterations, and how many iterations it took.
fn allocations(
    problem: &Problem,
    start: &pairtrawl_model::PairTrajectory,
    max_iterations: usize,
) -> (u64, usize) {
    let settings = Settings {
        max_iterations,
        ..Settings::default()
    };
    let mut iterations = 0;
    let info = allocation_counter::measure(|| {
        iterations = optimize(problem, start, &settings).iterations;
    });
    (info.count_total, iterations)
}

#[test]
fn iterations_make_no_allocations() {
    for free in [false, true] {
        let made = generate(Kind::Witness, 5, 1, 200).expect("a scene");
        let net_length = (!free).then_some(made.net_length);
        let world = World::new(&made.scene, net_length).expect("a world");
        let problem = Problem::new(&made.scene, net_length, &world.pieces);
        let counts: Vec<(u64, usize)> = (0..60)
            .map(|most| allocations(&problem, &made.witness, most))
            .collect();
        // Work space grows in the first iterations; from then on counts only rise where robots have moved far enough for
        // what is near to be looked up again.
        let (_, iterations) = counts[counts.len() - 1];
        assert!((10..59).contains(&iterations), "converged: {counts:?}");
        let rises: Vec<u64> = counts[5..]
            .windows(2)
            .map(|w| w[1].0 - w[0].0)
            .filter(|rise| *rise > 0)
            .collect();
        assert!(rises.len() <= iterations / 5, "{counts:?}");
        // A few lists each time, not some for every waypoint.
        assert!(rises.iter().all(|rise| *rise <= 20), "{counts:?}");
        let still = counts[iterations - 5..=iterations].windows(2);
        assert!(still.clone().all(|w| w[1].0 == w[0].0), "{counts:?}");
    }
}
