use crate::anchor::{Anchor, PairAt, PointAt};
use crate::own::{OwnTerm, Role};
use crate::problem::Problem;
use crate::rule::{Rule, Stake};
use crate::sight::Sight;
use crate::term::{PAIR, POINT, Term};
use pairtrawl_model::Side;

/// The user's own constraint on the pair, by its number.
#[derive(Clone, Copy, Debug)]
pub(crate) struct OwnPair(u32);

/// The user's own constraint on a robot's axle center, by its number.
#[derive(Clone, Copy, Debug)]
pub(crate) struct OwnPoint {
    robot: Side,
    number: u32,
}

impl Rule<PairAt, PAIR> for OwnPair {
    fn look_up(sight: &mut Sight, at: PairAt, add: &mut impl FnMut(Self)) {
        let stage = at.0 as usize;
        if sight.is_inner(stage) {
            let own = sight.problem.own.pair.iter().zip(0..);
            own.filter(|(own, _)| own.is_at(Role::Constraint, stage))
                .for_each(|(_, number)| add(Self(number)));
        }
    }

    #[inline]
    fn term(self, problem: &Problem, _: PairAt) -> impl Term<PAIR> {
        &*problem.own.pair[self.0 as usize].term
    }

    fn key(self) -> u32 {
        self.0
    }

    fn stake(self, problem: &Problem) -> Option<Stake<'_>> {
        Stake::own(&problem.own.pair[self.0 as usize].name)
    }
}

impl Rule<PointAt, POINT> for OwnPoint {
    fn look_up(sight: &mut Sight, at: PointAt, add: &mut impl FnMut(Self)) {
        let own = sight.problem.own.point[at.robot().index()].iter().zip(0..);
        own.filter(|(own, _)| own.is_at(Role::Constraint, at.stage()))
            .for_each(|(_, number)| {
                add(Self {
                    robot: at.robot(),
                    number,
                })
            });
    }

    #[inline]
    fn term(self, problem: &Problem, _: PointAt) -> impl Term<POINT> {
        &*self.own(problem).term
    }

    fn key(self) -> u32 {
        self.number
    }

    fn stake(self, problem: &Problem) -> Option<Stake<'_>> {
        Stake::own(&self.own(problem).name)
    }
}

impl OwnPoint {
    fn own(self, problem: &Problem) -> &OwnTerm<POINT> {
        &problem.own.point[self.robot.index()][self.number as usize]
    }
}
