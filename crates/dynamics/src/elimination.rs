//! The order in which parts are eliminated, and what fills in: minimum degree.
//!
//! The part with the fewest neighbors goes next, and its neighbors become each other's (Tinney and Walker, Proceedings of the IEEE
//! 55, 1967; George and Liu, The evolution of the minimum degree ordering algorithm, SIAM Review 31, 1989). Neighbors are bits, so
//! that making them each other's is one instruction for 64 of them. Among equals the last that came to have its degree goes first:
//! the order depends on the graph only.

/// No part, no position.
pub(crate) const NONE: u32 = u32::MAX;

/// A graph that is taken apart, part by part, and the parts in the order in which they went.
#[derive(Clone, Debug, Default)]
pub(crate) struct Elimination {
    /// Parts in the order in which they are eliminated.
    pub(crate) sequence: Vec<u32>,
    /// The place of each part in this order.
    pub(crate) ranks: Vec<u32>,
    /// Neighbors of every part when it went: from `begins[k]` to `begins[k + 1]` for the k-th.
    pub(crate) fill: Vec<u32>,
    pub(crate) begins: Vec<usize>,
    /// Words of 64 bits a part.
    words: usize,
    bits: Vec<u64>,
    went: Vec<u64>,
    degrees: Vec<u32>,
    /// The first part of each degree, and doubly linked lists of those with the same.
    heads: Vec<u32>,
    next: Vec<u32>,
    previous: Vec<u32>,
}

impl Elimination {
    /// So many parts without neighbors.
    pub(crate) fn begin(&mut self, count: usize) {
        self.words = count.div_ceil(64);
        self.bits.clear();
        self.bits.resize(count * self.words, 0);
    }

    /// Two different parts are neighbors.
    pub(crate) fn tie(&mut self, a: u32, b: u32) {
        for (a, b) in [(a as usize, b as usize), (b as usize, a as usize)] {
            self.bits[a * self.words + b / 64] |= 1 << (b % 64);
        }
    }

    /// Eliminates all parts.
    pub(crate) fn run(&mut self, count: usize) {
        self.sequence.clear();
        self.fill.clear();
        self.begins.clear();
        for list in [
            &mut self.heads,
            &mut self.next,
            &mut self.previous,
            &mut self.ranks,
        ] {
            list.clear();
            list.resize(count, NONE);
        }
        self.degrees.clear();
        self.degrees.resize(count, 0);
        for part in (0..count).rev() {
            let row = &self.bits[part * self.words..(part + 1) * self.words];
            let degree = row.iter().map(|word| word.count_ones()).sum();
            self.insert(part as u32, degree);
        }
        let mut least = 0;
        while self.sequence.len() < count {
            while self.heads[least] == NONE {
                least += 1;
            }
            let part = self.heads[least];
            self.eliminate(part);
            least = least.saturating_sub(1);
        }
        self.begins.push(self.fill.len());
    }

    fn eliminate(&mut self, part: u32) {
        self.remove(part);
        self.ranks[part as usize] = self.sequence.len() as u32;
        self.sequence.push(part);
        let first = self.fill.len();
        self.begins.push(first);
        let (words, own) = (self.words, part as usize);
        self.went.clear();
        self.went
            .extend_from_slice(&self.bits[own * words..(own + 1) * words]);
        for (k, &word) in self.went.iter().enumerate() {
            let mut rest = word;
            while rest != 0 {
                self.fill.push(64 * k as u32 + rest.trailing_zeros());
                rest &= rest - 1;
            }
        }
        for k in first..self.fill.len() {
            let other = self.fill[k];
            let at = other as usize;
            let row = &mut self.bits[at * words..(at + 1) * words];
            for (word, more) in row.iter_mut().zip(&self.went) {
                *word |= more;
            }
            row[at / 64] &= !(1 << (at % 64));
            row[own / 64] &= !(1 << (own % 64));
            let degree = row.iter().map(|word| word.count_ones()).sum();
            if degree != self.degrees[at] {
                self.remove(other);
                self.insert(other, degree);
            }
        }
    }

    fn insert(&mut self, part: u32, degree: u32) {
        let head = std::mem::replace(&mut self.heads[degree as usize], part);
        self.degrees[part as usize] = degree;
        self.next[part as usize] = head;
        self.previous[part as usize] = NONE;
        if head != NONE {
            self.previous[head as usize] = part;
        }
    }

    fn remove(&mut self, part: u32) {
        let at = part as usize;
        let (before, after) = (self.previous[at], self.next[at]);
        if before == NONE {
            self.heads[self.degrees[at] as usize] = after;
        } else {
            self.next[before as usize] = after;
        }
        if after != NONE {
            self.previous[after as usize] = before;
        }
    }
}
