//! Exact Euclidean distance transform of a grid in linear time.
//!
//! For each cell p of a grid with a set S of seed cells: nearest(p) = argmin over q in S of |p - q|^2, distances between
//! cell centers in cells. Two passes in integers (Meijster, Roerdink, Hesselink, "A general algorithm for computing
//! distance transforms in linear time", 2000): nearest seed in each column, then the lower envelope of parabolas in each row.

/// No seed anywhere.
pub const NONE: u32 = u32::MAX;

/// Index `row * columns + column` of the seed nearest to each cell, [`NONE`] when there is no seed. The first found wins
/// among seeds at the same distance, the same one in every run.
pub fn nearest_seeds(columns: usize, rows: usize, is_seed: impl Fn(usize) -> bool) -> Vec<u32> {
    let row_of_nearest = nearest_in_columns(columns, rows, is_seed);
    let mut nearest = vec![NONE; columns * rows];
    let mut envelope: Vec<Parabola> = Vec::with_capacity(columns);
    for row in 0..rows {
        let line = &row_of_nearest[row * columns..(row + 1) * columns];
        envelope.clear();
        for (column, &seed_row) in line.iter().enumerate() {
            if seed_row != NONE {
                let height = i64::from(seed_row) - row as i64;
                push(
                    &mut envelope,
                    Parabola {
                        vertex: column as i64,
                        height: height * height,
                        from: 0,
                    },
                    columns as i64,
                );
            }
        }
        let mut k = envelope.len();
        for column in (0..columns).rev() {
            while k > 1 && envelope[k - 1].from > column as i64 {
                k -= 1;
            }
            if k > 0 {
                let vertex = envelope[k - 1].vertex as usize;
                nearest[row * columns + column] = line[vertex] * columns as u32 + vertex as u32;
            }
        }
    }
    nearest
}

/// x -> (x - vertex)^2 + height, lowest of all from `from` on.
struct Parabola {
    vertex: i64,
    height: i64,
    from: i64,
}

impl Parabola {
    fn at(&self, x: i64) -> i64 {
        (x - self.vertex) * (x - self.vertex) + self.height
    }
}

/// Adds a parabola whose vertex lies right of all others to the lower envelope over `0..columns`.
fn push(envelope: &mut Vec<Parabola>, mut new: Parabola, columns: i64) {
    while envelope
        .last()
        .is_some_and(|last| last.at(last.from) > new.at(last.from))
    {
        envelope.pop();
    }
    if let Some(last) = envelope.last() {
        let rise = new.vertex * new.vertex - last.vertex * last.vertex + new.height - last.height;
        new.from = 1 + rise.div_euclid(2 * (new.vertex - last.vertex));
    }
    if new.from < columns {
        envelope.push(new);
    }
}

/// Row of the nearest seed in the same column.
fn nearest_in_columns(columns: usize, rows: usize, is_seed: impl Fn(usize) -> bool) -> Vec<u32> {
    let mut nearest = vec![NONE; columns * rows];
    for row in 0..rows {
        for column in 0..columns {
            let i = row * columns + column;
            if is_seed(i) {
                nearest[i] = row as u32;
            } else if row > 0 {
                nearest[i] = nearest[i - columns];
            }
        }
    }
    for row in (0..rows.saturating_sub(1)).rev() {
        for column in 0..columns {
            let i = row * columns + column;
            let (below, above) = (nearest[i], nearest[i + columns]);
            if above != NONE
                && (below == NONE || above.abs_diff(row as u32) < below.abs_diff(row as u32))
            {
                nearest[i] = above;
            }
        }
    }
    nearest
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn squared(columns: usize, a: usize, b: usize) -> i64 {
        let dx = (a % columns) as i64 - (b % columns) as i64;
        let dy = (a / columns) as i64 - (b / columns) as i64;
        dx * dx + dy * dy
    }

    proptest! {
        #[test]
        fn distances_are_exactly_those_of_brute_force(
            columns in 1_usize..24, rows in 1_usize..24, density in 0.0..0.3_f64, noise in prop::collection::vec(0.0..1.0_f64, 576),
        ) {
            let seed = |i: usize| noise[i] < density;
            let nearest = nearest_seeds(columns, rows, seed);
            let seeds: Vec<usize> = (0..columns * rows).filter(|&i| seed(i)).collect();
            for (i, &found) in nearest.iter().enumerate() {
                match seeds.iter().map(|&s| squared(columns, i, s)).min() {
                    None => prop_assert_eq!(found, NONE),
                    Some(best) => {
                        prop_assert!(seed(found as usize));
                        prop_assert_eq!(squared(columns, i, found as usize), best);
                    }
                }
            }
        }
    }

    #[test]
    fn empty_grids_are_fine() {
        assert!(nearest_seeds(0, 0, |_| true).is_empty());
    }
}
