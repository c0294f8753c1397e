use super::cell::Cell;
use super::things::Things;
use pairtrawl_model::BodyCircle;

/// The largest circle of a robot's body, when its center is off the axle: what is known of the cells of a grid as places for
/// that center.
pub(super) struct Carried {
    pub(super) circle: BodyCircle,
    pub(super) cells: Vec<Cell>,
}

impl Carried {
    /// On a grid of so many cells, of which nothing is known yet.
    pub(super) fn new(things: &Things<'_>, cells: usize) -> Option<Self> {
        let circle = things.largest;
        (!circle.is_centered()).then(|| Self {
            circle,
            cells: vec![Cell::Mixed; cells],
        })
    }

    /// On a finer grid, whose cells lie within those that `parent` names.
    pub(super) fn refined(&self, cells: usize, parent: impl Fn(usize) -> usize) -> Self {
        Self {
            circle: self.circle,
            cells: (0..cells).map(|i| self.cells[parent(i)]).collect(),
        }
    }
}

/// The cells of a grid within so many columns and rows of one that is marked.
pub(super) fn spread(marked: &[bool], columns: usize, [aside, above]: [usize; 2]) -> Vec<bool> {
    let rows = marked.len() / columns;
    let along = |from: &[bool], count: usize, reach: usize, place: &dyn Fn(usize) -> usize| {
        let mut near = vec![false; count];
        let mut last = None;
        for k in 0..count + reach {
            if k < count && from[place(k)] {
                last = Some(k);
            }
            // Cell k - reach sees marks up to k.
            if let Some(at) = k.checked_sub(reach) {
                near[at] = last.is_some_and(|last: usize| last + reach >= at);
            }
        }
        near
    };
    let mut wide = vec![false; marked.len()];
    for row in 0..rows {
        let near = along(marked, columns, aside, &|k| row * columns + k);
        wide[row * columns..(row + 1) * columns].copy_from_slice(&near);
    }
    let mut all = vec![false; marked.len()];
    for column in 0..columns {
        let near = along(&wide, rows, above, &|k| k * columns + column);
        for (row, near) in near.into_iter().enumerate() {
            all[row * columns + column] = near;
        }
    }
    all
}

#[cfg(test)]
mod tests {
    use super::spread;

    #[test]
    fn marks_spread_as_far_as_asked() {
        let (columns, rows) = (9, 7);
        let marked: Vec<bool> = (0..columns * rows)
            .map(|i| i == 2 * columns + 3 || i == 0)
            .collect();
        for (aside, above) in [(0, 0), (1, 2), (3, 1), (20, 20)] {
            let near = spread(&marked, columns, [aside, above]);
            for (i, &near) in near.iter().enumerate() {
                let (column, row) = (i % columns, i / columns);
                let within =
                    |c: usize, r: usize| column.abs_diff(c) <= aside && row.abs_diff(r) <= above;
                assert_eq!(near, within(3, 2) || within(0, 0), "{i}: {aside} {above}");
            }
        }
    }
}
