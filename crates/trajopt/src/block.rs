//! All rows of one anchor: the interior point treats them alike, whatever they say.

use crate::anchor::Anchor;
use crate::iterate::Iterate;
use crate::merit::Merit;
use crate::problem::Problem;
use crate::row::Row;
use crate::rule::Rules;
use crate::step::Step;
use std::ops::Range;

/// A row with what it says.
#[derive(Clone, Debug)]
pub(crate) struct Item<R: Rules<K>, const K: usize> {
    pub at: R::At,
    pub rule: R,
    /// Gradient of the constraint at the iterate.
    pub gradient: [f64; K],
    pub row: Row,
}

/// Rows in the order of anchors, rules and keys.
#[derive(Clone, Debug)]
pub(crate) struct Block<R: Rules<K>, const K: usize> {
    pub items: Vec<Item<R, K>>,
}

impl<R: Rules<K>, const K: usize> Default for Block<R, K> {
    fn default() -> Self {
        Self { items: Vec::new() }
    }
}

impl<R: Rules<K>, const K: usize> Item<R, K> {
    fn key(&self) -> (R::At, (u8, u32)) {
        (self.at, self.rule.key())
    }
}

impl<R: Rules<K>, const K: usize> Block<R, K> {
    /// Adds a row on the central path of `mu`, where its constraint has value `c`.
    pub fn push(&mut self, at: R::At, rule: R, c: f64, price: f64, mu: f64) {
        self.items.push(Item {
            at,
            rule,
            gradient: [0.0; K],
            row: Row::centered(c, price, mu),
        });
    }

    pub fn rows_mut(&mut self) -> impl Iterator<Item = &mut Row> {
        self.items.iter_mut().map(|item| &mut item.row)
    }

    /// The rows of a range of stages, and of the steps from them.
    pub fn within(&mut self, stages: &Range<usize>) -> &mut [Item<R, K>] {
        let first = self.items.partition_point(|r| r.at.stage() < stages.start);
        let rest = &self.items[first..];
        let count = rest.partition_point(|r| r.at.stage() < stages.end);
        &mut self.items[first..first + count]
    }

    /// Adds all rows to a merit at a trial point, slacks stepped by `alpha`; they keep their values there.
    pub fn add_to(
        &mut self,
        merit: &mut Merit,
        problem: &Problem,
        (x, frames): (&Iterate, &[Step]),
        alpha: f64,
    ) {
        let Some(mut last) = self.items.first().map(|item| item.at) else {
            return;
        };
        let mut z = last.coordinates(x, frames);
        for Item { at, rule, row, .. } in &mut self.items {
            if *at != last {
                last = *at;
                z = last.coordinates(x, frames);
            }
            row.c = rule.value(problem, last, &z);
            let (s, e) = row.stepped(alpha, row.c);
            merit.theta += (row.c - s + e).abs();
            row.add_to(merit, s, e);
        }
    }

    /// Copies slack, violation and multiplier of rows that were there before.
    pub fn carry_over(&mut self, old: &Self) {
        let mut rest = old.items.iter().peekable();
        for item in &mut self.items {
            let key = item.key();
            while rest.next_if(|o| o.key() < key).is_some() {}
            if let Some(o) = rest.next_if(|o| o.key() == key) {
                let c = item.row.c;
                item.row = o.row;
                item.row.c = c;
                item.row.s = item.row.s.max(c + item.row.e);
            }
        }
    }
}

/// Rows by what they are anchored to: they share coordinates.
pub(crate) fn by_anchor<R: Rules<K>, const K: usize>(
    items: &mut [Item<R, K>],
) -> impl Iterator<Item = &mut [Item<R, K>]> {
    items.chunk_by_mut(|a, b| a.at == b.at)
}
