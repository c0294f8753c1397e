//! Dynamic programming of Held and Karp, with the last two stops in the state because turns have a price.

use super::stops::{Place, Stops};

/// The best order. Time O(2^n n^3), memory O(2^n n^2): meant for n <= 12.
pub(crate) fn best(stops: &Stops) -> Vec<usize> {
    let n = stops.count();
    if n == 0 {
        return Vec::new();
    }
    // Prices, looked up in the inner loop: stop n is the start.
    let place = |i: usize| Place::Stop(i);
    let m = n + 1;
    let mut turn = vec![0.0; m * n * n];
    for a in 0..m {
        for b in 0..n {
            for c in 0..n {
                turn[(a * n + b) * n + c] = stops.turn(place(a), b, place(c));
            }
        }
    }
    // cost[(set * n + last) * m + previous]: least cost from the start through `set`, turn at `last` not yet paid.
    let index = |set: usize, last: usize, previous: usize| (set * n + last) * m + previous;
    let sets = 1usize << n;
    let mut cost = vec![f64::INFINITY; sets * n * m];
    let mut before = vec![u8::MAX; sets * n * m];
    for last in 0..n {
        cost[index(1 << last, last, n)] =
            stops.turn(Place::Outside, n, place(last)) + stops.length(n, last);
    }
    for set in 1..sets {
        for last in (0..n).filter(|&i| set >> i & 1 == 1) {
            for previous in 0..m {
                let c = cost[index(set, last, previous)];
                if !c.is_finite() {
                    continue;
                }
                for next in (0..n).filter(|&i| set >> i & 1 == 0) {
                    let total =
                        c + turn[(previous * n + last) * n + next] + stops.length(last, next);
                    let k = index(set | 1 << next, next, last);
                    if total < cost[k] {
                        cost[k] = total;
                        before[k] = previous as u8;
                    }
                }
            }
        }
    }
    let full = sets - 1;
    let end = n + 1;
    let mut least = f64::INFINITY;
    let mut state = (0, n);
    for last in 0..n {
        for previous in 0..m {
            let total = cost[index(full, last, previous)]
                + stops.turn(place(previous), last, place(end))
                + stops.length(last, end)
                + stops.turn(place(last), end, Place::Outside);
            if total < least {
                least = total;
                state = (last, previous);
            }
        }
    }
    let mut order = Vec::with_capacity(n);
    let mut set = full;
    let (mut last, mut previous) = state;
    loop {
        order.push(last);
        if previous == n {
            break;
        }
        let earlier = usize::from(before[index(set, last, previous)]);
        set &= !(1 << last);
        (last, previous) = (previous, earlier);
    }
    order.reverse();
    order
}
