//! The parts of the paper's J, one file each with its equation: what the solver minimizes and what reports say.
//!
//! J_obs is reported only: obstacles are constraints. J_dist is linear in the coordinates of a step, and counted with it.

pub(crate) mod distance;
pub(crate) mod expansion;
pub(crate) mod obstacle;
pub(crate) mod smoothness;
pub(crate) mod turning;

use crate::own::{OwnTerm, Role};
use crate::problem::Problem;
use crate::term::{BEND, PAIR, POINT, Term};
use expansion::Expansion;
use pairtrawl_model::Side;
use smoothness::Smoothness;

/// Shows the costs of the pair at a waypoint.
#[inline]
pub(crate) fn of_pair(problem: &Problem, stage: usize, show: &mut impl FnMut(&dyn Term<PAIR>)) {
    show(&Expansion::of(problem));
    own(&problem.own.pair, stage).for_each(show);
}

/// Shows the costs of a variable at an inner waypoint and its neighbors.
#[inline]
pub(crate) fn of_bend(problem: &Problem, variable: usize, show: &mut impl FnMut(&dyn Term<BEND>)) {
    show(&Smoothness::of_coordinate(&problem.planner, variable % 3));
}

/// Shows the costs of a robot's axle center at a waypoint.
#[inline]
pub(crate) fn of_point(
    problem: &Problem,
    (stage, robot): (usize, Side),
    show: &mut impl FnMut(&dyn Term<POINT>),
) {
    own(&problem.own.point[robot.index()], stage).for_each(show);
}

/// The user's own costs at a waypoint.
#[inline]
fn own<const K: usize>(terms: &[OwnTerm<K>], stage: usize) -> impl Iterator<Item = &dyn Term<K>> {
    terms
        .iter()
        .filter(move |own| own.is_at(Role::Cost, stage))
        .map(|own| &*own.term as &dyn Term<K>)
}
