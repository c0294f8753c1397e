use crate::anchor::PairAt;
use crate::problem::{Problem, SeparationRule};
use crate::rule::{Rule, Stake};
use crate::sight::Sight;
use crate::term::{Jet, PAIR, Term};
use pairtrawl_geometry::Point;
use pairtrawl_model::ClaimId;

/// `d >= lower + ratio d_max`: robots keep clear of each other.
pub struct SeparationAbove {
    /// m.
    pub lower: f64,
    /// Share of the net length.
    pub ratio: f64,
}

/// `d <= ratio d_max - reserve`: the net is long enough between the axle centers (`ratio` 1).
pub struct SeparationBelow {
    /// m.
    pub reserve: f64,
    /// Share of the net length.
    pub ratio: f64,
}

/// `sign d + offset + slope d_max`.
struct Linear {
    sign: f64,
    offset: f64,
    slope: f64,
}

impl Linear {
    #[inline]
    fn slope(&self, &[rx, ry, _, _, d_max]: &[f64; PAIR]) -> (f64, [f64; PAIR]) {
        let d = Point::new(rx, ry).norm();
        let scale = self.sign / d;
        (
            self.sign * d + self.offset + self.slope * d_max,
            [scale * rx, scale * ry, 0.0, 0.0, self.slope],
        )
    }

    fn jet(&self, z: &[f64; PAIR]) -> Jet<PAIR> {
        let (value, gradient) = self.slope(z);
        let mut jet = Jet::constant(value);
        jet.gradient = gradient;
        let (ux, uy) = (self.sign * gradient[0], self.sign * gradient[1]);
        let bend = self.sign / Point::new(z[0], z[1]).norm();
        jet.hessian[0][0] = bend * uy * uy;
        jet.hessian[1][1] = bend * ux * ux;
        jet.set_mixed(0, 1, -bend * ux * uy);
        jet
    }
}

impl SeparationAbove {
    fn linear(&self) -> Linear {
        Linear {
            sign: 1.0,
            offset: -self.lower,
            slope: -self.ratio,
        }
    }
}

impl SeparationBelow {
    fn linear(&self) -> Linear {
        Linear {
            sign: -1.0,
            offset: -self.reserve,
            slope: self.ratio,
        }
    }
}

impl Term<PAIR> for SeparationAbove {
    #[inline]
    fn value(&self, &[rx, ry, _, _, d_max]: &[f64; PAIR]) -> f64 {
        Point::new(rx, ry).norm() - self.lower - self.ratio * d_max
    }

    #[inline]
    fn slope(&self, z: &[f64; PAIR]) -> (f64, [f64; PAIR]) {
        self.linear().slope(z)
    }

    fn jet(&self, z: &[f64; PAIR]) -> Jet<PAIR> {
        self.linear().jet(z)
    }
}

impl Term<PAIR> for SeparationBelow {
    #[inline]
    fn value(&self, &[rx, ry, _, _, d_max]: &[f64; PAIR]) -> f64 {
        self.ratio * d_max - self.reserve - Point::new(rx, ry).norm()
    }

    #[inline]
    fn slope(&self, z: &[f64; PAIR]) -> (f64, [f64; PAIR]) {
        self.linear().slope(z)
    }

    fn jet(&self, z: &[f64; PAIR]) -> Jet<PAIR> {
        self.linear().jet(z)
    }
}

/// A rigid separation holds to this.
const RIGID_TOLERANCE: f64 = 5e-3;

/// The ratio at which the separation is held at a waypoint, if it is.
#[inline]
fn held_at(problem: &Problem, at: PairAt) -> Option<f64> {
    match problem.separation {
        SeparationRule::Rigid { from, to } if (from..=to).contains(&(at.0 as usize)) => {
            Some(problem.planner.rest_ratio)
        }
        _ => None,
    }
}

/// At every waypoint: far enough apart.
#[derive(Clone, Copy, Debug)]
pub(crate) struct FarEnoughApart;

impl Rule<PairAt, PAIR> for FarEnoughApart {
    fn look_up(sight: &mut Sight, at: PairAt, add: &mut impl FnMut(Self)) {
        if sight.is_inner(at.0 as usize) {
            add(Self);
        }
    }

    #[inline]
    fn term(self, problem: &Problem, at: PairAt) -> impl Term<PAIR> {
        if let Some(ratio) = held_at(problem, at) {
            return SeparationAbove {
                lower: -RIGID_TOLERANCE,
                ratio,
            };
        }
        let least = problem.robot.least_separation();
        let min_ratio = problem.planner.min_ratio;
        let (of_net, ratio) = match problem.net_length {
            Some(length) => (min_ratio * length, 0.0),
            // 0.1 d_max stays below two radii up to 20 radii.
            None if least > 0.0 => (0.0, 0.0),
            None => (0.0, min_ratio),
        };
        SeparationAbove {
            lower: of_net.max(least) + problem.reserve.separation,
            ratio,
        }
    }

    fn stake(self, problem: &Problem) -> Option<Stake<'_>> {
        Stake::claim(ClaimId::Separation, problem.reserve.separation)
    }
}

/// At every waypoint: close enough for the net; the rows of the ends bound a net length that is free.
#[derive(Clone, Copy, Debug)]
pub(crate) struct CloseEnough;

impl Rule<PairAt, PAIR> for CloseEnough {
    fn look_up(sight: &mut Sight, at: PairAt, add: &mut impl FnMut(Self)) {
        let problem = sight.problem;
        let bounded = problem.separation != SeparationRule::Free;
        if bounded && (sight.is_inner(at.0 as usize) || problem.net_length.is_none()) {
            add(Self);
        }
    }

    #[inline]
    fn term(self, problem: &Problem, at: PairAt) -> impl Term<PAIR> {
        match held_at(problem, at) {
            Some(ratio) => SeparationBelow {
                reserve: -RIGID_TOLERANCE,
                ratio,
            },
            None => SeparationBelow {
                reserve: problem.reserve.greatest_separation,
                ratio: 1.0,
            },
        }
    }

    fn stake(self, _: &Problem) -> Option<Stake<'_>> {
        Stake::claim(ClaimId::Separation, 0.0)
    }
}
