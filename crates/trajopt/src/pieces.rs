use pairtrawl_geometry::{Bounds, Convex, Point};
use pairtrawl_model::Area;

/// A convex region with what its distances need: a polygon (no radius) or a disc (one vertex).
#[derive(Clone, Debug)]
pub struct Piece {
    /// Counter-clockwise, or the center.
    pub vertices: Vec<Point>,
    /// Outward unit normals of the edges from each vertex to the next, and their lengths; none for a disc.
    pub edges: Vec<(Point, f64)>,
    /// Of a disc, else 0.
    pub radius: f64,
    low: Point,
    high: Point,
}

impl Piece {
    /// From a convex region.
    pub fn new(region: &Convex) -> Self {
        let Bounds {
            min: low,
            max: high,
        } = region.bounds();
        match region {
            Convex::Circle { center, radius } => Self {
                vertices: vec![*center],
                edges: Vec::new(),
                radius: *radius,
                low,
                high,
            },
            Convex::Polygon(vertices) => {
                let next = vertices.iter().cycle().skip(1);
                let edges = vertices.iter().zip(next).map(|(&a, &b)| {
                    let length = a.distance(b);
                    (-(b - a).perp() / length, length)
                });
                Self {
                    edges: edges.collect(),
                    vertices: vertices.clone(),
                    radius: 0.0,
                    low,
                    high,
                }
            }
        }
    }

    /// True when the piece may be nearer than `reach` to the box between two points.
    pub fn may_be_near(&self, a: Point, b: Point, reach: f64) -> bool {
        self.low.x - reach <= a.x.max(b.x)
            && self.high.x + reach >= a.x.min(b.x)
            && self.low.y - reach <= a.y.max(b.y)
            && self.high.y + reach >= a.y.min(b.y)
    }
}

/// Convex pieces of the obstacles with a bucket grid, to find those near a point without looking at all.
#[derive(Clone, Debug)]
pub(crate) struct PieceIndex {
    pieces: Vec<Piece>,
    origin: Point,
    cell: f64,
    columns: usize,
    rows: usize,
    buckets: Vec<Vec<u32>>,
    /// Pieces farther than this from a point are not found.
    pub reach: f64,
}

impl PieceIndex {
    pub(crate) fn new(pieces: &[Convex], area: &Area, reach: f64) -> Self {
        let size = area.max - area.min;
        // At most about 10^5 buckets, at least half a meter wide.
        let cell = (size.x * size.y / 1e5).sqrt().max(0.5);
        let columns = (size.x / cell).ceil() as usize + 1;
        let rows = (size.y / cell).ceil() as usize + 1;
        let mut index = Self {
            pieces: pieces.iter().map(Piece::new).collect(),
            origin: area.min,
            cell,
            columns,
            rows,
            buckets: vec![Vec::new(); columns * rows],
            reach,
        };
        for (id, piece) in pieces.iter().enumerate() {
            let Bounds { min: lo, max: hi } = piece.bounds();
            let reach = Point::new(reach, reach);
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

    /// Candidates for what lies within reach of a point, in ascending order.
    pub(crate) fn near(&self, p: Point) -> &[u32] {
        let (column, row) = self.bucket(p);
        &self.buckets[row * self.columns + column]
    }

    pub(crate) fn get(&self, id: u32) -> &Piece {
        &self.pieces[id as usize]
    }
}
