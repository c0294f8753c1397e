//! Local search for more circles than the exact method can take: 2-opt and Or-opt on neighbor lists with don't-look
//! bits, then seeded perturbation by exchanging two neighboring runs (Or-3opt). Both ends stay fixed.

use super::path::{Block, Path};
use super::stops::Stops;
use crate::random::SplitMix;
use std::collections::VecDeque;

/// Stops that a stop may be joined to.
const NEIGHBORS: usize = 10;
/// Longest run that Or-opt moves.
const RUN: usize = 3;
/// Perturbations per circle, and most of them.
const KICKS_PER_CIRCLE: usize = 30;
const MAX_KICKS: usize = 20_000;
/// Longest run that a perturbation exchanges.
const KICK_RUN: usize = 10;
/// Least gain that counts, m: below it rounding could make the search circle.
const GAIN: f64 = 1e-9;
/// Where the perturbations' random numbers start.
const SEED: u64 = 0x5eed_0f0a_7e50;

/// A good order: 2-opt and Or-opt from the nearest-neighbor path, improved by perturbations.
pub(crate) fn best(stops: &Stops) -> Vec<usize> {
    let n = stops.count();
    let mut search = Search::new(stops);
    let mut queue: VecDeque<usize> = (0..n).collect();
    search.descend(&mut queue);
    if n < 4 {
        return search.path.order();
    }
    let mut random = SplitMix::new(SEED);
    for _ in 0..(KICKS_PER_CIRCLE * n).min(MAX_KICKS) {
        search.path.forget();
        let first = 1 + random.below(n - 1);
        let middle = first + 1 + random.below((n - first).min(KICK_RUN));
        let last = middle + random.below((n + 1 - middle).min(KICK_RUN));
        let exchanged = [Block::new(middle, last), Block::new(first, middle - 1)];
        queue.extend(
            [first - 1, first, middle - 1, middle, last, last + 1]
                .into_iter()
                .map(|k| search.path.stop(k))
                .filter(|&s| s < n),
        );
        let kick = search.path.change(stops, &exchanged);
        search.path.rearrange(&exchanged);
        if kick + search.descend(&mut queue) > -GAIN {
            search.path.undo();
        }
    }
    search.path.order()
}

/// `best` and up to `count - 1` other orders in rising cost, from the exchanges of the cheapest ones found.
pub(crate) fn alternatives(stops: &Stops, best: Vec<usize>, count: usize) -> Vec<Vec<usize>> {
    let mut found = vec![(stops.cost(&best), best.clone())];
    for parents in [1, count].into_iter().take(count.saturating_sub(1)) {
        let parents: Vec<Vec<usize>> = found.iter().take(parents).map(|f| f.1.clone()).collect();
        for order in parents
            .iter()
            .flat_map(|parent| exchanges(parent))
            .filter(|o| *o != best)
        {
            found.push((stops.cost(&order), order));
        }
        found[1..].sort_by(|a, b| a.0.total_cmp(&b.0).then_with(|| a.1.cmp(&b.1)));
        found.dedup_by(|a, b| a.1 == b.1);
        found.truncate(count);
    }
    found.into_iter().map(|f| f.1).collect()
}

/// All reversals of a run of at most 40 circles, and displacements of a run of up to [`RUN`] circles as far.
fn exchanges(order: &[usize]) -> Vec<Vec<usize>> {
    let n = order.len();
    let mut all = Vec::new();
    for i in 0..n {
        for j in i + 1..n.min(i + 40) {
            let mut with = |rearrange: &dyn Fn(&mut [usize])| {
                let mut new = order.to_vec();
                rearrange(&mut new[i..=j]);
                all.push(new);
            };
            with(&|s| s.reverse());
            for run in 1..=RUN.min(j - i) {
                with(&|s| s.rotate_left(run));
                with(&|s| s.rotate_right(run));
            }
        }
    }
    all
}

struct Search<'s> {
    stops: &'s Stops,
    path: Path,
    neighbors: Vec<Vec<usize>>,
}

impl<'s> Search<'s> {
    fn new(stops: &'s Stops) -> Self {
        let n = stops.count();
        let neighbors = (0..n)
            .map(|i| {
                let mut others: Vec<usize> = (0..n + 2).filter(|&j| j != i).collect();
                let nearer = |&a: &usize, &b: &usize| {
                    stops
                        .length(i, a)
                        .total_cmp(&stops.length(i, b))
                        .then(a.cmp(&b))
                };
                if others.len() > NEIGHBORS {
                    others.select_nth_unstable_by(NEIGHBORS - 1, nearer);
                    others.truncate(NEIGHBORS);
                }
                others.sort_by(nearer);
                others
            })
            .collect();
        let mut order = Vec::with_capacity(n);
        let mut here = n;
        let mut left: Vec<usize> = (0..n).collect();
        while let Some(next) = (0..left.len()).min_by(|&a, &b| {
            stops
                .length(here, left[a])
                .total_cmp(&stops.length(here, left[b]))
        }) {
            here = left.swap_remove(next);
            order.push(here);
        }
        Self {
            stops,
            path: Path::new(&order),
            neighbors,
        }
    }

    /// Improves until no stop of the queue, or of those that its moves touch, can be improved. Returns the change of cost.
    fn descend(&mut self, queue: &mut VecDeque<usize>) -> f64 {
        let n = self.stops.count();
        let mut change = 0.0;
        let mut waiting = vec![false; n];
        for &s in queue.iter() {
            waiting[s] = true;
        }
        while let Some(stop) = queue.pop_front() {
            waiting[stop] = false;
            while let Some((gain, from, to)) = self.improve(stop) {
                change += gain;
                for k in [from - 1, from, from + 1, to - 1, to, to + 1] {
                    let s = self.path.stop(k.min(n + 1));
                    if s < n && s != stop && !waiting[s] {
                        waiting[s] = true;
                        queue.push_back(s);
                    }
                }
            }
        }
        change
    }

    /// Tries every move that joins `stop` to a neighbor; makes the first that gains. Returns the change and its span.
    fn improve(&mut self, stop: usize) -> Option<(f64, usize, usize)> {
        let n = self.stops.count();
        let k = self.path.position(stop);
        let length = |a: usize, b: usize| self.stops.length(a, b);
        let longest = length(stop, self.path.stop(k - 1)).max(length(stop, self.path.stop(k + 1)));
        // Turns around the stop may get cheaper too, but by no more than they cost now.
        let worth = longest + self.path.turns_around(self.stops, k);
        for c in 0..self.neighbors[stop].len() {
            let other = self.neighbors[stop][c];
            if self.stops.length(stop, other) >= worth {
                break;
            }
            let q = self.path.position(other);
            let (low, high) = (k.min(q), k.max(q));
            // 2-opt: `other` becomes the one behind, or the one before.
            for (from, to) in [(low + 1, high), (low, high - 1)] {
                if from >= 1
                    && to <= n
                    && from < to
                    && let Some(gain) = self.attempt(&[Block::flipped(from, to)])
                {
                    return Some((gain, from, to));
                }
            }
            // Or-opt: a run that begins or ends at `stop` moves beside `other`, with `stop` at `other`'s side.
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
                    // The run goes between positions gap and gap + 1.
                    for beyond in [false, true] {
                        let gap = if beyond { q } else { q.wrapping_sub(1) };
                        if gap > n || (gap + 1 >= a && gap <= b) {
                            continue;
                        }
                        let moved = if begins == beyond {
                            Block::new(a, b)
                        } else {
                            Block::flipped(a, b)
                        };
                        let (blocks, from, to) = if gap > b {
                            ([Block::new(b + 1, gap), moved], a, gap)
                        } else {
                            ([moved, Block::new(gap + 1, a - 1)], gap + 1, b)
                        };
                        if let Some(gain) = self.attempt(&blocks) {
                            return Some((gain, from, to));
                        }
                    }
                }
            }
        }
        None
    }

    /// Makes a change that gains, and returns by how much the cost changed.
    fn attempt(&mut self, blocks: &[Block]) -> Option<f64> {
        let change = self.path.change_below(self.stops, blocks, -GAIN)?;
        self.path.rearrange(blocks);
        Some(change)
    }
}
