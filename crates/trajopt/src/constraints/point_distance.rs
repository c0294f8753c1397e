use crate::anchor::{Anchor, PointAt};
use crate::pieces::Piece;
use crate::problem::Problem;
use crate::rule::{Rule, Stake};
use crate::sight::{LOOK_AHEAD, Sight, tiers};
use crate::term::{Jet, POINT, Term};
use crate::tier::Tier;
use pairtrawl_geometry::Point;
use pairtrawl_model::{ClaimId, Side};

/// A point keeps `keep` from a convex region: signed distance minus `keep`.
pub struct PointDistance<'a> {
    /// The region.
    pub region: &'a Piece,
    /// m.
    pub keep: f64,
}

/// A point keeps `keep` from another one.
pub struct CenterDistance {
    /// The point.
    pub center: Point,
    /// m.
    pub keep: f64,
}

/// What of the region is nearest.
enum Nearest {
    /// A vertex or center.
    Corner(Point),
    /// A point of an edge and its outward unit normal.
    Edge(Point, Point),
}

fn nearest(region: &Piece, p: Point) -> Nearest {
    let vertices = &region.vertices;
    if region.edges.is_empty() {
        return Nearest::Corner(vertices[0]);
    }
    // The foremost edge is nearest inside, and outside when the point lies over it; else a corner or another edge that
    // faces the point is.
    let mut foremost = (f64::NEG_INFINITY, 0);
    let mut best = (f64::INFINITY, Nearest::Corner(vertices[0]));
    for (i, (&a, &(normal, length))) in vertices.iter().zip(&region.edges).enumerate() {
        let out = p - a;
        let outside = normal.dot(out);
        if outside > foremost.0 {
            foremost = (outside, i);
        }
        if outside > 0.0 {
            let t = normal.perp().dot(out);
            let squared = if t < 0.0 {
                out.norm_squared()
            } else if t > length {
                outside * outside + (t - length) * (t - length)
            } else {
                outside * outside
            };
            if squared < best.0 {
                let feature = if t < 0.0 {
                    Nearest::Corner(a)
                } else if t > length {
                    Nearest::Corner(vertices[(i + 1) % vertices.len()])
                } else {
                    Nearest::Edge(a, normal)
                };
                best = (squared, feature);
            }
        }
    }
    if best.0.is_finite() {
        best.1
    } else {
        Nearest::Edge(vertices[foremost.1], region.edges[foremost.1].0)
    }
}

impl Term<POINT> for CenterDistance {
    #[inline]
    fn value(&self, &[x, y]: &[f64; POINT]) -> f64 {
        Point::new(x, y).distance(self.center) - self.keep
    }

    #[inline]
    fn slope(&self, &[x, y]: &[f64; POINT]) -> (f64, [f64; POINT]) {
        let p = Point::new(x, y);
        let d = p.distance(self.center).max(1e-9);
        let u = (p - self.center) / d;
        (d - self.keep, [u.x, u.y])
    }

    fn jet(&self, z: &[f64; POINT]) -> Jet<POINT> {
        let (value, gradient) = self.slope(z);
        let mut jet = Jet::constant(value);
        jet.gradient = gradient;
        let u = Point::from(gradient);
        let d = value + self.keep;
        jet.hessian = [
            [u.y * u.y / d, -u.x * u.y / d],
            [-u.x * u.y / d, u.x * u.x / d],
        ];
        jet
    }
}

impl Term<POINT> for PointDistance<'_> {
    #[inline]
    fn value(&self, &[x, y]: &[f64; POINT]) -> f64 {
        let p = Point::new(x, y);
        let keep = self.keep + self.region.radius;
        match nearest(self.region, p) {
            Nearest::Corner(center) => CenterDistance { center, keep }.value(&[x, y]),
            Nearest::Edge(a, n) => n.dot(p - a) - keep,
        }
    }

    #[inline]
    fn slope(&self, &[x, y]: &[f64; POINT]) -> (f64, [f64; POINT]) {
        let p = Point::new(x, y);
        let keep = self.keep + self.region.radius;
        match nearest(self.region, p) {
            Nearest::Corner(center) => CenterDistance { center, keep }.slope(&[x, y]),
            Nearest::Edge(a, n) => (n.dot(p - a) - keep, [n.x, n.y]),
        }
    }

    fn jet(&self, &[x, y]: &[f64; POINT]) -> Jet<POINT> {
        let p = Point::new(x, y);
        let keep = self.keep + self.region.radius;
        match nearest(self.region, p) {
            Nearest::Corner(center) => CenterDistance { center, keep }.jet(&[x, y]),
            Nearest::Edge(a, n) => {
                let mut jet = Jet::constant(n.dot(p - a) - keep);
                jet.gradient = [n.x, n.y];
                jet
            }
        }
    }
}

/// A circle that a robot has near a thing, from which it keeps.
pub(crate) trait KeepOff: Copy {
    /// Those in play for a circle of this radius that a robot has at a point.
    fn near(sight: &mut Sight, here: (usize, Side), p: Point, radius: f64, add: impl FnMut(Self));

    /// For the center of a circle of this radius.
    fn distance(self, problem: &Problem, radius: f64) -> impl Term<POINT>;
}

/// A circle of a robot near an object, from which it keeps; as a rule of a point, the one around the axle center.
#[derive(Clone, Copy, Debug)]
pub(crate) struct OffObject {
    pub object: u32,
    pub tier: Tier,
}

impl KeepOff for OffObject {
    fn near(
        sight: &mut Sight,
        (stage, robot): (usize, Side),
        p: Point,
        radius: f64,
        mut add: impl FnMut(Self),
    ) {
        let problem = sight.problem;
        let margin = problem.reserve.clearance;
        for &object in problem.object_index.near(p) {
            let (center, footprint) = problem.objects[object as usize];
            let c = p.distance(center) - (footprint + radius) - margin;
            if c < LOOK_AHEAD && !sight.must_pass(robot, stage, object) {
                for tier in tiers(problem, c, margin) {
                    add(Self { object, tier });
                }
            }
        }
    }

    #[inline]
    fn distance(self, problem: &Problem, radius: f64) -> impl Term<POINT> {
        let (center, footprint) = problem.objects[self.object as usize];
        let reserve = self.tier.reserve(problem, problem.reserve.clearance);
        CenterDistance {
            center,
            keep: footprint + radius + reserve,
        }
    }
}

impl Rule<PointAt, POINT> for OffObject {
    fn look_up(sight: &mut Sight, at: PointAt, add: &mut impl FnMut(Self)) {
        let p = sight.x.position(at.stage(), at.robot());
        if let Some(radius) = sight.problem.disc {
            Self::near(sight, (at.stage(), at.robot()), p, radius, add);
        }
    }

    #[inline]
    fn term(self, problem: &Problem, _: PointAt) -> impl Term<POINT> {
        self.distance(problem, problem.disc.unwrap_or(0.0))
    }

    fn key(self) -> u32 {
        self.tier.key(self.object)
    }

    fn price(self, _: &Problem, elastic: f64) -> f64 {
        elastic * self.tier.price()
    }

    fn stake(self, problem: &Problem) -> Option<Stake<'_>> {
        let margin = self.tier.reserve(problem, problem.reserve.clearance);
        Stake::claim_about(ClaimId::RobotsMissObjects, self.object, margin)
    }
}

/// A circle of a robot near an obstacle, from which it keeps; as a rule of a point, the one around the axle center.
#[derive(Clone, Copy, Debug)]
pub(crate) struct OffObstacle {
    pub piece: u32,
    pub tier: Tier,
}

impl KeepOff for OffObstacle {
    fn near(sight: &mut Sight, _: (usize, Side), p: Point, radius: f64, mut add: impl FnMut(Self)) {
        let problem = sight.problem;
        let margin = problem.reserve.clearance;
        let reach = radius + margin + LOOK_AHEAD;
        let value = |piece: u32| {
            let tier = Tier::Margin;
            let of_margin = Self { piece, tier };
            of_margin.distance(problem, radius).value(&p.into())
        };
        sight.pieces_near((p, p), reach, margin, value, |piece, tier| {
            add(Self { piece, tier });
        });
    }

    #[inline]
    fn distance(self, problem: &Problem, radius: f64) -> impl Term<POINT> {
        PointDistance {
            region: problem.pieces.get(self.piece),
            keep: radius + self.tier.reserve(problem, problem.reserve.clearance),
        }
    }
}

impl Rule<PointAt, POINT> for OffObstacle {
    fn look_up(sight: &mut Sight, at: PointAt, add: &mut impl FnMut(Self)) {
        let p = sight.x.position(at.stage(), at.robot());
        if let Some(radius) = sight.problem.disc {
            Self::near(sight, (at.stage(), at.robot()), p, radius, add);
        }
    }

    #[inline]
    fn term(self, problem: &Problem, _: PointAt) -> impl Term<POINT> {
        self.distance(problem, problem.disc.unwrap_or(0.0))
    }

    fn key(self) -> u32 {
        self.tier.key(self.piece)
    }

    fn price(self, _: &Problem, elastic: f64) -> f64 {
        elastic * self.tier.price()
    }

    fn stake(self, problem: &Problem) -> Option<Stake<'_>> {
        let margin = self.tier.reserve(problem, problem.reserve.clearance);
        Stake::claim_about(ClaimId::RobotClearance, self.piece, margin)
    }
}
