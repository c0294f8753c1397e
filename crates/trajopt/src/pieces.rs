use pairtrawl_geometry::{Convex, Point};
use pairtrawl_model::Area;

/// Convex pieces of the obstacles with a bucket grid, to find those near a point without looking at all.
#[derive(Clone, Debug)]
pub(crate) struct PieceIndex {
    pieces: Vec<Convex>,
    origin: Point,
    cell: f64,
    columns: usize,
    rows: usize,
    buckets: Vec<Vec<u32>>,
}

/// Pieces farther than this from a point are not found.
pub(crate) const SEARCH_RADIUS: f64 = 1.0;

fn bounds(piece: &Convex) -> (Point, Point) {
    match piece {
        Convex::Circle { center, radius } => {
            let r = Point::new(*radius, *radius);
            (*center - r, *center + r)
        }
        Convex::Polygon(vertices) => vertices.iter().fold(
            (
                Point::new(f64::INFINITY, f64::INFINITY),
                Point::new(f64::NEG_INFINITY, f64::NEG_INFINITY),
            ),
            |(lo, hi), v| {
                (
                    Point::new(lo.x.min(v.x), lo.y.min(v.y)),
                    Point::new(hi.x.max(v.x), hi.y.max(v.y)),
                )
            },
        ),
    }
}

impl PieceIndex {
    pub(crate) fn new(pieces: &[Convex], area: &Area) -> Self {
        let size = area.max - area.min;
        // At most about 10^5 buckets, at least half a meter wide.
        let cell = (size.x * size.y / 1e5).sqrt().max(0.5);
        let columns = (size.x / cell).ceil() as usize + 1;
        let rows = (size.y / cell).ceil() as usize + 1;
        let mut index = Self {
            pieces: pieces.to_vec(),
            origin: area.min,
            cell,
            columns,
            rows,
            buckets: vec![Vec::new(); columns * rows],
        };
        for (id, piece) in pieces.iter().enumerate() {
            let (lo, hi) = bounds(piece);
            let reach = Point::new(SEARCH_RADIUS, SEARCH_RADIUS);
            let ((c0, r0), (c1, r1)) = (index.bucket(lo - reach), index.bucket(hi + reach));
            for row in r0..=r1 {
                for column in c0..=c1 {
                    index.buckets[row * columns + column].push(id as u32);
                }
            }
        }
        index
    }

    fn bucket(&self, p: Point) -> (usize, usize) {
        let q = (p - self.origin) / self.cell;
        let clamp = |v: f64, n: usize| (v.max(0.0) as usize).min(n - 1);
        (clamp(q.x, self.columns), clamp(q.y, self.rows))
    }

    /// Candidates for what lies within [`SEARCH_RADIUS`] of a point, in ascending order.
    pub(crate) fn near(&self, p: Point) -> &[u32] {
        let (column, row) = self.bucket(p);
        &self.buckets[row * self.columns + column]
    }

    pub(crate) fn get(&self, id: u32) -> &Convex {
        &self.pieces[id as usize]
    }

    pub(crate) fn all(&self) -> &[Convex] {
        &self.pieces
    }
}
