//! Local search for more circles than the exact method can take: 2-opt and Or-opt on neighbor lists with don't-look
//! bits, then seeded perturbation by exchanging two neighboring runs (Or-3opt). Both ends stay fixed.

use super::Stops;
use std::collections::VecDeque;

/// Stops that a stop may be joined to.
const NEIGHBORS: usize = 10;
/// Longest run that Or-opt moves.
const RUN: usize = 3;
/// Perturbations per circle, and most of them.
const KICKS_PER_CIRCLE: usize = 40;
const MAX_KICKS: usize = 20_000;
/// Longest run that a perturbation exchanges.
const KICK_RUN: usize = 25;
/// Least gain that counts, m: below it rounding could make the search circle.
const GAIN: f64 = 1e-9;

/// A good order: 2-opt and Or-opt from the nearest-neighbor path, improved by perturbations.
pub(crate) fn best(stops: &Stops) -> Vec<usize> {
    let mut search = Search::new(stops);
    let mut queue: VecDeque<usize> = search.path[1..=stops.count()].iter().copied().collect();
    search.descend(&mut queue);
    let mut random = SplitMix(0x5EED_0F_0A7E5);
    let n = stops.count();
    if n < 4 {
        return search.order();
    }
    let mut cost = search.cost();
    let mut saved = search.path.clone();
    for _ in 0..(KICKS_PER_CIRCLE * n).min(MAX_KICKS) {
        let first = 1 + random.below(n - 1);
        let middle = first + 1 + random.below((n - first).min(KICK_RUN));
        let last = middle + random.below((n + 1 - middle).min(KICK_RUN));
        // Exchange path[first..middle] with path[middle..=last].
        let touched: Vec<usize> = [first - 1, first, middle - 1, middle, last, last + 1]
            .into_iter()
            .map(|k| search.path[k])
            .collect();
        search.path[first..=last].rotate_left(middle - first);
        search.renumber(first, last);
        let mut queue: VecDeque<usize> = touched.into_iter().filter(|&s| s < n).collect();
        search.descend(&mut queue);
        let new = search.cost();
        if new < cost - GAIN {
            cost = new;
            saved.copy_from_slice(&search.path);
        } else {
            search.path.copy_from_slice(&saved);
            search.renumber(0, n + 1);
        }
    }
    search.order()
}

/// `best` and up to `count - 1` other orders in rising cost, from the exchanges of the cheapest ones found.
pub(crate) fn alternatives(stops: &Stops, best: Vec<usize>, count: usize) -> Vec<Vec<usize>> {
    let mut found = vec![(stops.cost(&best), best)];
    for round in 0..count.saturating_sub(1).min(2) {
        let parents: Vec<Vec<usize>> = found
            .iter()
            .take(if round == 0 { 1 } else { count })
            .map(|f| f.1.clone())
            .collect();
        for parent in parents {
            for order in exchanges(&parent) {
                found.push((stops.cost(&order), order));
            }
        }
        found[1..].sort_by(|a, b| a.0.total_cmp(&b.0).then_with(|| a.1.cmp(&b.1)));
        found.dedup_by(|a, b| a.1 == b.1);
        let (first, rest) = found.split_at(1);
        let rest: Vec<_> = rest
            .iter()
            .filter(|f| f.1 != first[0].1)
            .take(count.max(2) - 1)
            .cloned()
            .collect();
        found.truncate(1);
        found.extend(rest);
    }
    found.truncate(count.max(1));
    found.into_iter().map(|f| f.1).collect()
}

/// All reversals of a run and displacements of a run of up to [`RUN`] circles, with runs of at most 60 circles.
fn exchanges(order: &[usize]) -> Vec<Vec<usize>> {
    let n = order.len();
    let mut all = Vec::new();
    for i in 0..n {
        for j in i + 1..n.min(i + 60) {
            let mut reversed = order.to_vec();
            reversed[i..=j].reverse();
            all.push(reversed);
            for run in 1..=RUN.min(j - i) {
                let mut forth = order.to_vec();
                forth[i..=j].rotate_left(run);
                all.push(forth);
                let mut back = order.to_vec();
                back[i..=j].rotate_right(run);
                all.push(back);
            }
        }
    }
    all
}

struct Search<'s> {
    stops: &'s Stops,
    /// Start, circles in order, end.
    path: Vec<usize>,
    position: Vec<usize>,
    neighbors: Vec<Vec<usize>>,
    scratch: Vec<usize>,
}

impl<'s> Search<'s> {
    fn new(stops: &'s Stops) -> Self {
        let n = stops.count();
        let neighbors: Vec<Vec<usize>> = (0..n + 2)
            .map(|i| {
                let mut others: Vec<usize> = (0..n + 2).filter(|&j| j != i).collect();
                others.sort_by(|&a, &b| {
                    stops
                        .length(i, a)
                        .total_cmp(&stops.length(i, b))
                        .then(a.cmp(&b))
                });
                others.truncate(NEIGHBORS);
                others
            })
            .collect();
        let mut path = vec![n];
        let mut left: Vec<usize> = (0..n).collect();
        while !left.is_empty() {
            let here = path[path.len() - 1];
            let mut k = 0;
            for (candidate, &stop) in left.iter().enumerate() {
                if stops.length(here, stop) < stops.length(here, left[k]) {
                    k = candidate;
                }
            }
            path.push(left.swap_remove(k));
        }
        path.push(n + 1);
        let mut search = Self {
            stops,
            position: vec![0; n + 2],
            neighbors,
            scratch: path.clone(),
            path,
        };
        search.renumber(0, n + 1);
        search
    }

    fn order(&self) -> Vec<usize> {
        self.path[1..self.path.len() - 1].to_vec()
    }

    fn cost(&self) -> f64 {
        self.stops.cost_between(&self.path, 0, self.path.len() - 1)
    }

    fn renumber(&mut self, from: usize, to: usize) {
        for k in from..=to {
            self.position[self.path[k]] = k;
        }
    }

    /// Improves until no stop of the queue, or of those that its moves touch, can be improved.
    fn descend(&mut self, queue: &mut VecDeque<usize>) {
        let n = self.stops.count();
        let mut waiting = vec![false; n + 2];
        for &s in queue.iter() {
            waiting[s] = true;
        }
        while let Some(stop) = queue.pop_front() {
            waiting[stop] = false;
            while let Some((from, to)) = self.improve(stop) {
                let ends = [
                    from - 1,
                    from,
                    from + 1,
                    to.saturating_sub(1),
                    to,
                    to + 1,
                    self.position[stop],
                ];
                for k in ends {
                    let s = self.path[k.min(n + 1)];
                    if s < n && s != stop && !waiting[s] {
                        waiting[s] = true;
                        queue.push_back(s);
                    }
                }
            }
        }
    }

    /// Tries every move that joins `stop` to a neighbor; makes the first that gains and returns the span it changed.
    fn improve(&mut self, stop: usize) -> Option<(usize, usize)> {
        let n = self.stops.count();
        let k = self.position[stop];
        for c in 0..self.neighbors[stop].len() {
            let other = self.neighbors[stop][c];
            let q = self.position[other];
            let d = self.stops.length(stop, other);
            if d >= self
                .stops
                .length(stop, self.path[k - 1])
                .max(self.stops.length(stop, self.path[k + 1]))
                + self.slack(k)
            {
                break;
            }
            let (low, high) = (k.min(q), k.max(q));
            // 2-opt: `other` becomes the one behind, or the one before.
            if low < high && high <= n && self.attempt(low + 1, high, |run| run.reverse()) {
                return Some((low + 1, high));
            }
            if low >= 1 && low < high && self.attempt(low, high - 1, |run| run.reverse()) {
                return Some((low, high - 1));
            }
            // Or-opt: a run that begins or ends at `stop` moves beside `other`, either way round.
            for run in 1..=RUN {
                for begins in [true, false] {
                    let (a, b) = if begins {
                        (k, k + run - 1)
                    } else {
                        ((k + 1).saturating_sub(run), k)
                    };
                    if a < 1 || b > n || (a..=b).contains(&q) {
                        continue;
                    }
                    for beyond in [false, true] {
                        // The run goes between positions gap and gap + 1.
                        let gap = if beyond { q } else { q.wrapping_sub(1) };
                        if gap > n || (gap + 1 >= a && gap <= b) {
                            continue;
                        }
                        for flip in [false, true] {
                            let span = if gap > b { (a, gap) } else { (gap + 1, b) };
                            let moved = self.attempt(span.0, span.1, |s| {
                                if gap > b {
                                    if flip {
                                        s[..run].reverse();
                                    }
                                    s.rotate_left(run);
                                } else {
                                    let m = s.len();
                                    if flip {
                                        s[m - run..].reverse();
                                    }
                                    s.rotate_right(run);
                                }
                            });
                            if moved {
                                return Some(span);
                            }
                        }
                    }
                }
            }
        }
        None
    }

    /// What the turns around position `k` cost now: more than this no move can gain there beyond its lengths.
    fn slack(&self, k: usize) -> f64 {
        let from = k.saturating_sub(1);
        let to = (k + 1).min(self.path.len() - 1);
        self.stops.cost_between(&self.path, from, to)
            - self.path[from..=to]
                .windows(2)
                .map(|w| self.stops.length(w[0], w[1]))
                .sum::<f64>()
    }

    /// Rearranges path[from..=to] when that makes the path cheaper.
    fn attempt(&mut self, from: usize, to: usize, rearrange: impl Fn(&mut [usize])) -> bool {
        if from > to {
            return false;
        }
        let (low, high) = (from - 1, (to + 1).min(self.path.len() - 1));
        let old = self.stops.cost_between(&self.path, low, high);
        self.scratch.clear();
        self.scratch.extend_from_slice(&self.path[from..=to]);
        rearrange(&mut self.path[from..=to]);
        if self.stops.cost_between(&self.path, low, high) < old - GAIN {
            self.renumber(from, to);
            return true;
        }
        self.path[from..=to].copy_from_slice(&self.scratch);
        false
    }
}

/// SplitMix64 (Steele, Lea and Flood 2014): seeded, the same on every machine.
struct SplitMix(u64);

impl SplitMix {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^ (z >> 31)
    }

    /// A number in 0..n (n > 0).
    fn below(&mut self, n: usize) -> usize {
        (self.next() % n as u64) as usize
    }
}
