//! Signed distances at the cell centers, in linear time.
//!
//! Outside of obstacles: the distance transform names an obstacle cell near each center, the pieces in such cells are the
//! candidates, and the distance to them is exact geometry, not cells. The nearest obstacle cell need not hold the nearest
//! piece, so two sweeps let each center try its neighbors' pieces. Inside: see [`depth`].

use crate::distance_transform::{NONE, nearest_seeds};
use crate::grid::{Cell, OccupancyGrid, Owners};
use crate::shape::signed_distance;
use pairtrawl_geometry::{Convex, Point};

/// One sample a cell, m.
pub(crate) fn signed_distances(
    grid: &OccupancyGrid,
    owners: &Owners,
    pieces: &[Convex],
) -> Vec<f64> {
    let (columns, rows) = (grid.columns, grid.rows);
    let is_obstacle = |i: usize| grid.cells[i] == Cell::Obstacle;
    let nearest_obstacle = nearest_seeds(columns, rows, is_obstacle);
    let nearest_free = nearest_seeds(columns, rows, |i| !is_obstacle(i));
    let center = |i: usize| grid.center(i % columns, i / columns);
    // What to call the distance when there is nothing to be distant from: the diagonal of the grid.
    let far = grid.resolution * Point::new(columns as f64, rows as f64).norm();
    let between = |i: usize, j: u32| {
        if j == NONE {
            far
        } else {
            center(i).distance(center(j as usize))
        }
    };

    let mut samples: Vec<Sample> = (0..columns * rows)
        .map(|i| {
            let mut own = Sample {
                distance: f64::INFINITY,
                piece: NONE,
            };
            own.try_pieces(owners.of(i), pieces, center(i));
            if is_obstacle(i) && (own.distance <= 0.0 || own.piece == NONE) {
                return Sample {
                    distance: depth(own.distance, grid.resolution, between(i, nearest_free[i])),
                    piece: NONE,
                };
            }
            if nearest_obstacle[i] != NONE {
                // A piece may reach out of a cell that another one fills, so the cells around count too.
                for cell in neighborhood(nearest_obstacle[i] as usize, columns, rows) {
                    own.try_pieces(owners.of(cell), pieces, center(i));
                }
            }
            // Only deep inside of a map do cells have no piece, and such a cell is nearest to none outside.
            if own.piece == NONE {
                Sample {
                    distance: between(i, nearest_obstacle[i]),
                    piece: NONE,
                }
            } else {
                own
            }
        })
        .collect();
    for forward in [true, false] {
        for k in 0..columns * rows {
            let i = if forward { k } else { columns * rows - 1 - k };
            let mut best = samples[i];
            if best.piece == NONE {
                continue;
            }
            for n in neighborhood(i, columns, rows) {
                let piece = samples[n].piece;
                if piece != NONE && piece != best.piece {
                    best.try_pieces(&[piece], pieces, center(i));
                }
            }
            samples[i] = best;
        }
    }
    samples.into_iter().map(|s| s.distance).collect()
}

/// The nearest piece found so far.
#[derive(Clone, Copy)]
struct Sample {
    distance: f64,
    /// Index of the piece; [`NONE`] inside of obstacles and where there are none.
    piece: u32,
}

impl Sample {
    fn try_pieces(&mut self, candidates: &[u32], pieces: &[Convex], p: Point) {
        for &piece in candidates {
            if piece == self.piece {
                continue;
            }
            let distance = signed_distance(&pieces[piece as usize], p);
            if distance < self.distance {
                *self = Self { distance, piece };
            }
        }
    }
}

/// Minus the depth inside an obstacle, m: at least as deep as in one piece, and nearly as deep as the nearest wholly free
/// cell is far, which counts where pieces lie side by side.
fn depth(in_piece: f64, resolution: f64, to_free_cell: f64) -> f64 {
    in_piece.min(resolution - to_free_cell).min(0.0)
}

/// The cell and its eight neighbors inside the grid.
fn neighborhood(i: usize, columns: usize, rows: usize) -> impl Iterator<Item = usize> {
    let (column, row) = (i % columns, i / columns);
    (row.saturating_sub(1)..(row + 2).min(rows)).flat_map(move |r| {
        (column.saturating_sub(1)..(column + 2).min(columns)).map(move |c| r * columns + c)
    })
}
