use crate::anchor::{Anchor, PointAt};
use crate::problem::Problem;
use crate::rule::{Rule, Stake};
use crate::sight::{LOOK_AHEAD, Sight};
use crate::term::{Jet, POINT, Term};
use pairtrawl_model::{ClaimId, Side};

/// A robot stays on its side of an object where the line between the robots passes over it, or inside the area:
/// `n . p - offset >= 0`.
#[derive(Clone, Copy, Debug)]
pub struct HalfPlane {
    /// Unit normal.
    pub normal: [f64; 2],
    /// m.
    pub offset: f64,
}

impl Term<POINT> for HalfPlane {
    #[inline]
    fn value(&self, p: &[f64; POINT]) -> f64 {
        self.normal[0] * p[0] + self.normal[1] * p[1] - self.offset
    }

    #[inline]
    fn slope(&self, p: &[f64; POINT]) -> (f64, [f64; POINT]) {
        (self.value(p), self.normal)
    }

    fn jet(&self, p: &[f64; POINT]) -> Jet<POINT> {
        let mut jet = Jet::constant(self.value(p));
        jet.gradient = self.normal;
        jet
    }
}

/// A robot beside an object, at the waypoint where the line between the robots passes over it: beyond the distance that it
/// keeps. A help for the coverage of the object, which no claim needs at one waypoint or another.
#[derive(Clone, Copy, Debug)]
pub(crate) struct BesideObject {
    pub object: u32,
    pub plane: HalfPlane,
}

/// What a unit of violation costs, in units of what it costs elsewhere.
const PRICE: f64 = 10.0;

impl Rule<PointAt, POINT> for BesideObject {
    fn look_up(sight: &mut Sight, at: PointAt, add: &mut impl FnMut(Self)) {
        let (i, x) = (at.stage(), sight.x);
        let (l, r) = (x.position(i, Side::Left), x.position(i, Side::Right));
        let out = (l - r) / l.distance(r) * at.robot().sign();
        for object in sight.crossed(i) {
            let (center, footprint) = sight.problem.objects[object as usize];
            let keep = footprint + sight.problem.half_width;
            let plane = HalfPlane {
                normal: out.into(),
                offset: out.dot(center) + 0.9 * keep,
            };
            add(Self { object, plane });
        }
    }

    #[inline]
    fn term(self, _: &Problem, _: PointAt) -> impl Term<POINT> {
        self.plane
    }

    /// An object left outside saves the way to it and back: that must never be the cheaper thing to do.
    fn price(self, _: &Problem, elastic: f64) -> f64 {
        PRICE * elastic
    }

    fn key(self) -> u32 {
        self.object
    }
}

/// Kept within the area, so that rounding does not break the claim.
const ROUNDING: f64 = 1e-6;

/// A robot near a side of the area, within which it stays.
#[derive(Clone, Copy, Debug)]
pub(crate) struct InsideArea(pub Border);

/// A side of the area.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Border {
    LowX,
    HighX,
    LowY,
    HighY,
}

impl Border {
    const ALL: [Self; 4] = [Self::LowX, Self::HighX, Self::LowY, Self::HighY];

    #[inline]
    fn half_plane(self, problem: &Problem) -> HalfPlane {
        let (min, max) = (problem.area.min, problem.area.max);
        let (normal, offset) = match self {
            Self::LowX => ([1.0, 0.0], min.x),
            Self::HighX => ([-1.0, 0.0], -max.x),
            Self::LowY => ([0.0, 1.0], min.y),
            Self::HighY => ([0.0, -1.0], -max.y),
        };
        HalfPlane {
            normal,
            offset: offset + ROUNDING,
        }
    }
}

impl Rule<PointAt, POINT> for InsideArea {
    fn look_up(sight: &mut Sight, at: PointAt, add: &mut impl FnMut(Self)) {
        let p = sight.x.point(at.stage(), at.robot());
        for border in Border::ALL {
            if border.half_plane(sight.problem).value(&p) < LOOK_AHEAD {
                add(Self(border));
            }
        }
    }

    #[inline]
    fn term(self, problem: &Problem, _: PointAt) -> impl Term<POINT> {
        self.0.half_plane(problem)
    }

    fn key(self) -> u32 {
        self.0 as u32
    }

    fn price(self, _: &Problem, _: f64) -> f64 {
        f64::INFINITY
    }

    fn stake(self, _: &Problem) -> Option<Stake<'_>> {
        Stake::claim(ClaimId::InsideArea, 0.0)
    }
}
