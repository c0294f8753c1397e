//! All rows of one anchor: the interior point treats them alike, whatever they say.

use crate::anchor::Anchor;
use crate::curvature::Curvature;
use crate::iterate::Iterate;
use crate::local::Local;
use crate::merit::Merit;
use crate::problem::Problem;
use crate::row::{Beginning, Row};
use crate::rule::Rules;
use crate::step::Step;
use std::ops::Range;

/// A row with what it says.
#[derive(Clone, Debug)]
pub(crate) struct Item<R: Rules<K>, const K: usize> {
    pub at: R::At,
    pub rule: R,
    /// Value of an affine constraint where all coordinates are zero; of others nothing.
    offset: f64,
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

    /// The constraint's value.
    #[inline(always)]
    fn value(&self, problem: &Problem, z: &[f64; K]) -> f64 {
        if R::At::AFFINE {
            self.offset + inner(&self.gradient, z)
        } else {
            self.rule.value(problem, self.at, z)
        }
    }

    /// Takes the constraint's value and gradient.
    #[inline(always)]
    fn evaluate(&mut self, problem: &Problem, z: &[f64; K]) {
        if R::At::AFFINE {
            self.row.c = self.value(problem, z);
        } else {
            (self.row.c, self.gradient) = self.rule.slope(problem, self.at, z);
        }
    }
}

impl<R: Rules<K>, const K: usize> Block<R, K> {
    /// Adds a row on the central path at coordinates `z`.
    pub fn push(
        &mut self,
        problem: &Problem,
        (at, rule): (R::At, R),
        z: &[f64; K],
        Beginning { elastic, mu }: Beginning,
    ) {
        let (offset, gradient) = if R::At::AFFINE {
            rule.slope(problem, at, &[0.0; K])
        } else {
            (0.0, [0.0; K])
        };
        let c = rule.value(problem, at, z);
        self.items.push(Item {
            at,
            rule,
            offset,
            gradient,
            row: Row::centered(c, rule.price(problem, elastic), mu),
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
        for item in &mut self.items {
            if item.at != last {
                last = item.at;
                z = last.coordinates(x, frames);
            }
            item.row.c = item.value(problem, &z);
            let row = &item.row;
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

/// Rows that are not assembled yet.
pub(crate) struct Remaining<'a, R: Rules<K>, const K: usize>(&'a mut [Item<R, K>]);

impl<R: Rules<K>, const K: usize> Block<R, K> {
    /// All rows, to be assembled.
    pub fn remaining(&mut self) -> Remaining<'_, R, K> {
        Remaining(&mut self.items)
    }
}

impl<R: Rules<K>, const K: usize> Remaining<'_, R, K> {
    /// The anchor of the next row.
    #[inline]
    pub fn anchor(&self) -> Option<R::At> {
        self.0.first().map(|item| item.at)
    }

    /// Adds the next rows as far as they have this anchor, whose coordinates are `z`, at barrier parameter `mu`; how many
    /// there are.
    #[inline(always)]
    pub fn add_to(
        &mut self,
        local: &mut Local<K>,
        problem: &Problem,
        (at, z): (R::At, &[f64; K]),
        mu: f64,
        curvature: Curvature,
    ) -> usize {
        let mut items = std::mem::take(&mut self.0).iter_mut();
        let mut count = 0;
        while let Some(item) = items.as_slice().first()
            && item.at == at
            && let Some(item) = items.next()
        {
            item.evaluate(problem, z);
            local.add_row(&mut item.row, &item.gradient, mu);
            if curvature == Curvature::Exact && !R::At::AFFINE {
                local.add_bend(&item.rule.jet(problem, at, z), item.row.z);
            }
            count += 1;
        }
        self.0 = items.into_slice();
        count
    }
}

/// Scalar product.
#[inline]
pub(crate) fn inner<const K: usize>(a: &[f64; K], b: &[f64; K]) -> f64 {
    (0..K).map(|i| a[i] * b[i]).sum()
}
