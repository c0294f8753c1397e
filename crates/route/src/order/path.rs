//! A path through all stops that is rearranged in blocks, at a price known beforehand in constant time.

use super::stops::{Place, Stops};

/// A run of positions of a path that moves as a whole, perhaps turned round.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Block {
    from: usize,
    to: usize,
    flip: bool,
}

impl Block {
    /// Positions `from..=to` as they stand.
    pub fn new(from: usize, to: usize) -> Self {
        Self {
            from,
            to,
            flip: false,
        }
    }

    /// Positions `from..=to` in reverse.
    pub fn flipped(from: usize, to: usize) -> Self {
        Self {
            from,
            to,
            flip: true,
        }
    }
}

/// Start, circles in order, end, with the position of every stop and a record of changes.
pub(crate) struct Path {
    stops: Vec<usize>,
    position: Vec<usize>,
    /// What stood where, before each change since the last `forget`: first position, length.
    changes: Vec<(usize, usize)>,
    before: Vec<usize>,
}

/// The stops whose edges and turns a change may touch, in order, with gaps where nothing changes.
struct View {
    entries: [Entry; 20],
    len: usize,
}

#[derive(Clone, Copy, PartialEq)]
enum Entry {
    At(Place),
    Gap,
}

impl View {
    fn push(&mut self, entry: Entry) {
        self.entries[self.len] = entry;
        self.len += 1;
    }

    fn lengths(&self, stops: &Stops) -> f64 {
        let pairs = self.entries[..self.len].windows(2);
        let length = |w: &[Entry]| match w {
            [Entry::At(Place::Stop(a)), Entry::At(Place::Stop(b))] => stops.length(*a, *b),
            _ => 0.0,
        };
        pairs.map(length).sum()
    }

    fn turns(&self, stops: &Stops) -> f64 {
        let triples = self.entries[..self.len].windows(3);
        let turn = |w: &[Entry]| match w {
            [Entry::At(a), Entry::At(Place::Stop(b)), Entry::At(c)] => stops.turn(*a, *b, *c),
            _ => 0.0,
        };
        triples.map(turn).sum()
    }
}

impl Path {
    /// The path of an order of circles 0..n; the start is stop n, the end stop n + 1.
    pub fn new(order: &[usize]) -> Self {
        let n = order.len();
        let mut stops = vec![n];
        stops.extend_from_slice(order);
        stops.push(n + 1);
        let mut position = vec![0; n + 2];
        for (k, &s) in stops.iter().enumerate() {
            position[s] = k;
        }
        Self {
            stops,
            position,
            changes: Vec::new(),
            before: Vec::new(),
        }
    }

    pub fn order(&self) -> Vec<usize> {
        self.stops[1..self.stops.len() - 1].to_vec()
    }

    pub fn stop(&self, position: usize) -> usize {
        self.stops[position]
    }

    pub fn position(&self, stop: usize) -> usize {
        self.position[stop]
    }

    fn entry(&self, position: Option<usize>) -> Entry {
        Entry::At(
            position
                .and_then(|k| self.stops.get(k))
                .map_or(Place::Outside, |&s| Place::Stop(s)),
        )
    }

    /// What the turns at a position and beside it cost.
    pub fn turns_around(&self, stops: &Stops, k: usize) -> f64 {
        let place = |k: Option<usize>| match self.entry(k) {
            Entry::At(place) => place,
            Entry::Gap => Place::Outside,
        };
        (k.saturating_sub(1)..=(k + 1).min(self.stops.len() - 1))
            .map(|k| stops.turn(place(k.checked_sub(1)), self.stops[k], place(Some(k + 1))))
            .sum()
    }

    /// How the cost changes when neighboring blocks, one or two, come to stand in this order.
    pub fn change(&self, stops: &Stops, blocks: &[Block]) -> f64 {
        self.change_below(stops, blocks, f64::INFINITY)
            .unwrap_or(0.0)
    }

    /// As [`Self::change`], when it is less than `limit`.
    pub fn change_below(&self, stops: &Stops, blocks: &[Block], limit: f64) -> Option<f64> {
        let mut standing = [blocks[0]; 2];
        for (s, b) in standing.iter_mut().zip(blocks) {
            *s = Block::new(b.from, b.to);
        }
        let standing = &mut standing[..blocks.len()];
        standing.sort_by_key(|b| b.from);
        let (old, new) = (self.view(standing), self.view(blocks));
        // The turns cannot get cheaper than nothing, so most changes need no look at the new ones.
        let so_far = new.lengths(stops) - old.lengths(stops) - old.turns(stops);
        (so_far < limit)
            .then(|| so_far + new.turns(stops))
            .filter(|&c| c < limit)
    }

    fn view(&self, blocks: &[Block]) -> View {
        let mut view = View {
            entries: [Entry::Gap; 20],
            len: 0,
        };
        let from = blocks.iter().map(|b| b.from).min().unwrap_or(1);
        let to = blocks.iter().map(|b| b.to).max().unwrap_or(0);
        view.push(self.entry(from.checked_sub(2)));
        view.push(self.entry(from.checked_sub(1)));
        for block in blocks {
            let length = block.to - block.from + 1;
            let at = |i: usize| {
                if block.flip {
                    block.to - i
                } else {
                    block.from + i
                }
            };
            if length <= 4 {
                (0..length).for_each(|i| view.push(self.entry(Some(at(i)))));
            } else {
                for i in [0, 1] {
                    view.push(self.entry(Some(at(i))));
                }
                view.push(Entry::Gap);
                for i in [length - 2, length - 1] {
                    view.push(self.entry(Some(at(i))));
                }
            }
        }
        view.push(self.entry(Some(to + 1)));
        view.push(self.entry(Some(to + 2)));
        view
    }

    /// Puts neighboring blocks in this order.
    pub fn rearrange(&mut self, blocks: &[Block]) {
        let from = blocks.iter().map(|b| b.from).min().unwrap_or(0);
        let length = blocks.iter().map(|b| b.to - b.from + 1).sum();
        let start = self.before.len();
        self.before
            .extend_from_slice(&self.stops[from..from + length]);
        self.changes.push((from, length));
        let mut k = from;
        for block in blocks {
            for i in 0..=block.to - block.from {
                let source = if block.flip {
                    block.to - i
                } else {
                    block.from + i
                };
                let stop = self.before[start + source - from];
                self.stops[k] = stop;
                self.position[stop] = k;
                k += 1;
            }
        }
    }

    /// Makes the changes so far final.
    pub fn forget(&mut self) {
        self.changes.clear();
        self.before.clear();
    }

    /// Takes all changes back that are not final.
    pub fn undo(&mut self) {
        while let Some((from, length)) = self.changes.pop() {
            let start = self.before.len() - length;
            for (k, &stop) in (from..).zip(&self.before[start..]) {
                self.stops[k] = stop;
                self.position[stop] = k;
            }
            self.before.truncate(start);
        }
    }
}
