use crate::DistanceField;
use pairtrawl_geometry::Point;
use std::sync::{Arc, OnceLock};

/// A square lattice of points.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lattice {
    /// The first one.
    pub min: Point,
    /// Their spacing.
    pub pitch: f64,
    /// How many there are along x.
    pub columns: usize,
    /// How many there are along y.
    pub rows: usize,
}

impl Lattice {
    /// All points, row by row.
    pub fn points(&self) -> impl Iterator<Item = Point> {
        let Self { min, pitch, .. } = *self;
        (0..self.rows).flat_map(move |row| {
            (0..self.columns).map(move |column| min + Point::new(column as f64, row as f64) * pitch)
        })
    }
}

/// Distances at the points of a lattice, found when they are first asked for: every route asks for the same ones.
#[derive(Clone, Debug, Default)]
pub(crate) struct Sampled(OnceLock<(Lattice, Arc<[f64]>)>);

impl Sampled {
    pub fn on(&self, lattice: &Lattice, field: &DistanceField) -> Arc<[f64]> {
        let sample = || {
            lattice
                .points()
                .map(|p| field.distance(p))
                .collect::<Arc<[f64]>>()
        };
        let (of, samples) = self.0.get_or_init(|| (*lattice, sample()));
        if of == lattice {
            Arc::clone(samples)
        } else {
            sample()
        }
    }
}
