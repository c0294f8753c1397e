use crate::anchor::LineAt;
use crate::constraints::point_distance::PointDistance;
use crate::pieces::Piece;
use crate::problem::Problem;
use crate::rule::{Rule, Stake};
use crate::sight::{LOOK_AHEAD, Sight};
use crate::term::{Jet, QUAD, Term};
use crate::tier::Tier;
use pairtrawl_geometry::Point;
use pairtrawl_model::{ClaimId, Side};

/// What the line between the robots sweeps in a step, the convex hull of its four ends, keeps `keep` from a convex region:
/// signed distance (along the best separating axis when they overlap) minus `keep`.
pub struct QuadDistance<'a> {
    /// The region.
    pub region: &'a Piece,
    /// m.
    pub keep: f64,
}

/// Which pair of features is nearest.
enum Nearest {
    /// An end of a line.
    End(usize),
    /// A corner (or center) of the region over the side of the hull from one end to another, and 1 when it lies to the left
    /// of that, else -1.
    Side(usize, usize, Point, f64),
    /// An edge of the region is the best separating axis of an overlap: a point of it, its normal, the deepest end.
    Axis(Point, Point, usize),
}

/// Pairs of ends; those that are no sides of the hull find that out themselves.
const PAIRS: [(usize, usize); 6] = [(0, 1), (2, 3), (0, 2), (1, 3), (0, 3), (1, 2)];
/// Shorter sides have no direction, m.
const SHORTEST_SIDE: f64 = 1e-9;

fn ends(z: &[f64; QUAD]) -> [Point; 4] {
    std::array::from_fn(|k| Point::new(z[2 * k], z[2 * k + 1]))
}

/// The widest gap along the normal of a side of the hull, which lies wholly on one side of the line through it.
fn widest_side_gap(region: &Piece, q: &[Point; 4]) -> (f64, Nearest) {
    let mut widest = (f64::NEG_INFINITY, Nearest::End(0));
    for (a, b) in PAIRS {
        let side = q[b] - q[a];
        let length = side.norm();
        if length < SHORTEST_SIDE {
            continue;
        }
        let normal = side.perp() / length;
        let heights = q.map(|p| normal.dot(p - q[a]));
        for sign in [1.0, -1.0] {
            if heights.iter().any(|h| sign * h > SHORTEST_SIDE) {
                continue;
            }
            let mut nearest = (f64::INFINITY, region.vertices[0]);
            for &v in &region.vertices {
                let gap = sign * normal.dot(v - q[a]);
                if gap < nearest.0 {
                    nearest = (gap, v);
                }
            }
            if nearest.0 > widest.0 {
                widest = (nearest.0, Nearest::Side(a, b, nearest.1, sign));
            }
        }
    }
    widest
}

/// The widest gap along the normal of an edge of the region.
fn widest_edge_gap(region: &Piece, q: &[Point; 4]) -> (f64, Nearest) {
    let mut widest = (f64::NEG_INFINITY, Nearest::End(0));
    for (&a, &(n, _)) in region.vertices.iter().zip(&region.edges) {
        let mut deepest = (f64::INFINITY, 0);
        for (k, p) in q.iter().enumerate() {
            let gap = n.dot(*p - a);
            if gap < deepest.0 {
                deepest = (gap, k);
            }
        }
        if deepest.0 > widest.0 {
            widest = (deepest.0, Nearest::Axis(a, n, deepest.1));
        }
    }
    widest
}

/// Nearest features of a hull and a region that are apart.
fn nearest_apart(region: &Piece, q: &[Point; 4]) -> Nearest {
    let mut best = (f64::INFINITY, Nearest::End(0));
    let point = PointDistance { region, keep: 0.0 };
    for (k, p) in q.iter().enumerate() {
        let gap = point.value(&[p.x, p.y]) + region.radius;
        if gap < best.0 {
            best = (gap, Nearest::End(k));
        }
    }
    for (a, b) in PAIRS {
        let side = q[b] - q[a];
        let length = side.norm();
        for &v in &region.vertices {
            let t = (v - q[a]).dot(side);
            if t > 0.0 && t < length * length {
                let aside = side.cross(v - q[a]) / length;
                if aside.abs() < best.0 {
                    best = (aside.abs(), Nearest::Side(a, b, v, aside.signum()));
                }
            }
        }
    }
    best.1
}

fn nearest(region: &Piece, q: &[Point; 4]) -> Nearest {
    let (side, edge) = (widest_side_gap(region, q), widest_edge_gap(region, q));
    if side.0 > 0.0 || edge.0 > 0.0 || !(side.0.is_finite() || edge.0.is_finite()) {
        nearest_apart(region, q)
    } else if side.0 > edge.0 {
        side.1
    } else {
        edge.1
    }
}

impl QuadDistance<'_> {
    fn point(&self) -> PointDistance<'_> {
        PointDistance {
            region: self.region,
            keep: self.keep,
        }
    }
}

impl Term<QUAD> for QuadDistance<'_> {
    fn value(&self, z: &[f64; QUAD]) -> f64 {
        let q = ends(z);
        match nearest(self.region, &q) {
            Nearest::End(k) => self.point().value(&q[k].into()),
            Nearest::Side(a, b, v, sign) => {
                let side = q[b] - q[a];
                sign * side.cross(v - q[a]) / side.norm() - self.region.radius - self.keep
            }
            Nearest::Axis(a, n, k) => n.dot(q[k] - a) - self.keep,
        }
    }

    fn slope(&self, z: &[f64; QUAD]) -> (f64, [f64; QUAD]) {
        let q = ends(z);
        let mut gradient = [0.0; QUAD];
        let mut set = |k: usize, g: Point| (gradient[2 * k], gradient[2 * k + 1]) = (g.x, g.y);
        let value = match nearest(self.region, &q) {
            Nearest::End(k) => {
                let (value, [x, y]) = self.point().slope(&q[k].into());
                set(k, Point::new(x, y));
                value
            }
            Nearest::Side(a, b, v, sign) => {
                // The side turns about the corner: either end counts by its share of the lever.
                let side = q[b] - q[a];
                let length = side.norm();
                let normal = side.perp() * (sign / length);
                let share = (v - q[a]).dot(side) / (length * length);
                set(a, normal * (share - 1.0));
                set(b, normal * -share);
                normal.dot(v - q[a]) - self.region.radius - self.keep
            }
            Nearest::Axis(a, n, k) => {
                set(k, n);
                n.dot(q[k] - a) - self.keep
            }
        };
        (value, gradient)
    }

    fn jet(&self, z: &[f64; QUAD]) -> Jet<QUAD> {
        let (value, gradient) = self.slope(z);
        let mut jet = Jet::constant(value);
        jet.gradient = gradient;
        let q = ends(z);
        match nearest(self.region, &q) {
            Nearest::End(k) => {
                let end = self.point().jet(&q[k].into());
                for i in 0..2 {
                    for j in 0..2 {
                        jet.hessian[2 * k + i][2 * k + j] = end.hessian[i][j];
                    }
                }
            }
            Nearest::Side(a, b, v, sign) => bend(&mut jet, &q, (a, b), v, sign),
            Nearest::Axis(..) => {}
        }
        jet
    }
}

/// Second derivatives of `sign (b - a) x (v - a) / |b - a|` in `a` and `b`.
fn bend(jet: &mut Jet<QUAD>, q: &[Point; 4], (a, b): (usize, usize), v: Point, sign: f64) {
    let side = q[b] - q[a];
    let length = side.norm();
    let (along, across) = (side / length, side.perp() * (sign / length));
    let share = (v - q[a]).dot(along) / length;
    let height = across.dot(v - q[a]);
    // A change of the ends turns the side by `turn` and shifts the foot of the corner along it; with `p` the weight of each
    // end in the foot, the second variation is 2 turn (p . along) - height turn^2.
    let at = [2 * a, 2 * a + 1, 2 * b, 2 * b + 1];
    let across_of = [-across.x, -across.y, across.x, across.y].map(|c| c / length);
    let weights = [1.0 - share, 1.0 - share, share, share];
    let along_of = [along.x, along.y, along.x, along.y];
    for i in 0..4 {
        for j in 0..4 {
            let (ti, tj) = (across_of[i], across_of[j]);
            let (pi, pj) = (weights[i] * along_of[i], weights[j] * along_of[j]);
            jet.hessian[at[i]][at[j]] = ti * pj + tj * pi - height * ti * tj;
        }
    }
}

/// The line over a step near an obstacle, from which it keeps. Robots keep farther away themselves, so that only what is
/// nearer to the inside of the line comes so close.
#[derive(Clone, Copy, Debug)]
pub(crate) struct LineOffObstacle {
    pub piece: u32,
    pub tier: Tier,
}

impl LineOffObstacle {
    #[inline]
    fn distance(self, problem: &Problem) -> QuadDistance<'_> {
        QuadDistance {
            region: problem.pieces.get(self.piece),
            keep: self.tier.reserve(problem, problem.reserve.net_clearance),
        }
    }
}

impl Rule<LineAt, QUAD> for LineOffObstacle {
    fn look_up(sight: &mut Sight, at: LineAt, add: &mut impl FnMut(Self)) {
        let (problem, x, i) = (sight.problem, sight.x, at.0 as usize);
        let quad = x.quad(i);
        let ends = |i: usize| (x.position(i, Side::Left), x.position(i, Side::Right));
        let ((l, r), (to_l, to_r)) = (ends(i), ends(i + 1));
        let margin = problem.reserve.net_clearance;
        let farthest = l.distance(to_l).max(r.distance(to_r));
        let value = |piece: u32| {
            let tier = Tier::Margin;
            Self { piece, tier }.distance(problem).value(&quad)
        };
        let reach = margin + LOOK_AHEAD + farthest;
        sight.pieces_near((l, r), reach, margin, value, |piece, tier| {
            add(Self { piece, tier });
        });
    }

    #[inline]
    fn term(self, problem: &Problem, _: LineAt) -> impl Term<QUAD> {
        self.distance(problem)
    }

    fn key(self) -> u32 {
        self.tier.key(self.piece)
    }

    fn price(self, _: &Problem, elastic: f64) -> f64 {
        elastic * self.tier.price()
    }

    fn stake(self, problem: &Problem) -> Option<Stake<'_>> {
        let margin = self.tier.reserve(problem, problem.reserve.net_clearance);
        Stake::claim_about(ClaimId::NetEnclosesNoObstacle, self.piece, margin)
    }
}
