use super::path::{Block, Path};
use super::*;
use crate::error::RouteError;
use crate::random::SplitMix;
use crate::terrain::tests::{box_distance, pair_pose, scene};
use pairtrawl_geometry::Point;

/// Random circles in a square hall with a wall in its middle that leaves a gap of 2 m at either end.
fn stops(n: usize, seed: u64, size: f64) -> Stops {
    let mut random = SplitMix::new(seed);
    let wall = [0.5 * size - 0.2, 2.0, 0.5 * size + 0.2, size - 2.0];
    let mut centers = Vec::new();
    while centers.len() < n {
        let p = Point::new(size * random.unit(), size * random.unit());
        let inside = p.x.min(p.y).min(size - p.x).min(size - p.y) > 0.5;
        if inside && box_distance(p, wall) > 0.5 {
            centers.push(p);
        }
    }
    let s = scene(
        size,
        size,
        &[],
        pair_pose(1.0, 1.0, 1.0),
        pair_pose(size - 1.0, 1.0, -1.0),
    );
    let terrain = Terrain::sample(&s, |p| box_distance(p, wall));
    Stops::new(&terrain, centers, &s).unwrap()
}

fn least_cost_by_brute_force(stops: &Stops, order: &mut Vec<usize>, k: usize) -> f64 {
    if k == order.len() {
        return stops.cost(order);
    }
    let mut least = f64::INFINITY;
    for i in k..order.len() {
        order.swap(k, i);
        least = least.min(least_cost_by_brute_force(stops, order, k + 1));
        order.swap(k, i);
    }
    least
}

fn is_permutation(order: &[usize], n: usize) -> bool {
    let mut seen = order.to_vec();
    seen.sort_unstable();
    seen == (0..n).collect::<Vec<_>>()
}

#[test]
fn exact_orders_are_the_best_of_all_permutations() {
    for n in 0..=7 {
        for seed in 0..4 {
            let stops = stops(n, 100 * n as u64 + seed, 10.0);
            let order = exact::best(&stops);
            assert!(is_permutation(&order, n));
            let least = least_cost_by_brute_force(&stops, &mut (0..n).collect(), 0);
            assert!(
                (stops.cost(&order) - least).abs() < 1e-9,
                "n = {n}: {} {least}",
                stops.cost(&order)
            );
        }
    }
}

#[test]
fn turns_decide_between_orders_of_equal_length() {
    // Two circles mirrored about the line from start to end; the start looks towards the upper one.
    let s = scene(
        10.0,
        6.0,
        &[],
        pair_pose(2.0, 3.0, 0.9),
        pair_pose(8.0, 3.0, 0.0),
    );
    let terrain = Terrain::sample(&s, |_| 50.0);
    let order = |centers| orders_on(&terrain, centers, &s, 1).unwrap().swap_remove(0);
    let (up, down) = (Point::new(5.0, 4.0), Point::new(5.0, 2.0));
    assert_eq!(order(vec![up, down]), [0, 1]);
    assert_eq!(order(vec![down, up]), [1, 0]);
}

#[test]
fn walls_make_near_circles_far() {
    // The second circle is near the first, but behind the wall.
    let s = scene(
        12.0,
        8.0,
        &[],
        pair_pose(1.0, 1.0, 1.5),
        pair_pose(11.0, 1.0, -1.5),
    );
    let terrain = Terrain::sample(&s, |p| box_distance(p, [5.8, -1.0, 6.2, 6.0]));
    let centers = vec![
        Point::new(5.0, 1.0),
        Point::new(7.0, 1.0),
        Point::new(5.0, 4.5),
    ];
    let order = orders_on(&terrain, centers, &s, 1).unwrap().swap_remove(0);
    assert_eq!(order, [0, 2, 1]);
}

#[test]
fn a_change_costs_what_it_says_and_can_be_undone() {
    let n = 15;
    let stops = stops(n, 7, 10.0);
    let mut random = SplitMix::new(3);
    let mut path = Path::new(&exact_start(n));
    for round in 0..3000 {
        let a = 1 + random.below(n - 1);
        let m = a + random.below(n - a);
        let b = m + 1 + random.below(n - m);
        let half = |from, to, flip| {
            if flip {
                Block::flipped(from, to)
            } else {
                Block::new(from, to)
            }
        };
        let blocks = match round % 3 {
            0 => vec![Block::flipped(a, b)],
            1 => vec![Block::new(m + 1, b), half(a, m, round % 2 == 0)],
            _ => vec![half(m + 1, b, round % 2 == 0), Block::new(a, m)],
        };
        let (before, order) = (stops.cost(&path.order()), path.order());
        let change = path.change(&stops, &blocks);
        path.forget();
        path.rearrange(&blocks);
        let after = stops.cost(&path.order());
        assert!(
            (after - before - change).abs() < 1e-9,
            "{blocks:?}: {} {change}",
            after - before
        );
        assert!(is_permutation(&path.order(), n));
        assert!((0..n + 2).all(|s| path.stop(path.position(s)) == s));
        if round % 4 == 0 {
            path.undo();
            assert_eq!(path.order(), order);
        }
    }
}

fn exact_start(n: usize) -> Vec<usize> {
    (0..n).rev().collect()
}

#[test]
fn local_search_finds_the_exact_optimum_of_small_sets_twice_alike() {
    for seed in 0..12 {
        let stops = stops(9, 40 + seed, 12.0);
        let best = stops.cost(&exact::best(&stops));
        let order = local_search::best(&stops);
        assert_eq!(order, local_search::best(&stops));
        let found = stops.cost(&order);
        assert!(found <= best * 1.005 + 1e-9, "seed {seed}: {found} {best}");
    }
}

#[test]
fn alternatives_are_different_and_rise_in_cost() {
    let stops = stops(8, 5, 10.0);
    let orders = local_search::alternatives(&stops, exact::best(&stops), 6);
    assert_eq!(orders.len(), 6);
    let costs: Vec<f64> = orders.iter().map(|o| stops.cost(o)).collect();
    assert!(costs.windows(2).all(|w| w[0] <= w[1]), "{costs:?}");
    for (i, a) in orders.iter().enumerate() {
        assert!(is_permutation(a, 8));
        assert!(orders[..i].iter().all(|b| a != b));
    }
    // No order at all has alternatives: none are made up.
    assert_eq!(
        local_search::alternatives(&stops, exact::best(&stops), 1).len(),
        1
    );
}

#[test]
fn a_thousand_circles_come_out_near_the_best_known_length() {
    let (n, size) = (1000, 60.0);
    let stops = stops(n, 1, size);
    let order = local_search::best(&stops);
    assert!(is_permutation(&order, n));
    let length: f64 = order.windows(2).map(|w| stops.length(w[0], w[1])).sum();
    // Beardwood, Halton and Hammersley: the best path through n random points is about 0.7124 sqrt(n A) long, 3 % more
    // at n = 1000 from the border; turns and the wall are allowed to cost the rest.
    let optimum = 0.7124 * (n as f64 * size * size).sqrt();
    assert!(length < 1.2 * optimum, "{length} {optimum}");
}

#[test]
fn an_enclosed_circle_is_an_error() {
    let s = scene(
        10.0,
        10.0,
        &[],
        pair_pose(1.0, 1.0, 0.0),
        pair_pose(9.0, 1.0, 0.0),
    );
    let center = Point::new(5.0, 5.0);
    let terrain = Terrain::sample(&s, |p| (p.distance(center) - 1.5).abs() - 0.1);
    let error = orders_on(&terrain, vec![Point::new(2.0, 8.0), center], &s, 1).unwrap_err();
    assert_eq!(
        error,
        RouteError::NoPath {
            from: Point::new(1.0, 1.0),
            to: center
        }
    );
}
