//! Hybrid A* (Dolgov et al. 2010) for the pair's midpoint, all circles in one layered search.
//!
//! Leg k is searched from every heading in which leg k - 1 arrived at its circle, so the heading in which a circle is
//! passed is chosen by what it costs before and after. The last leg ends with Dubins shots at the exact end pose. The
//! heuristic is the fast-marching distance to the leg's goal. The result is smoothed as an elastic band.

use super::corridor::{Corridor, ladder};
use super::dubins::Dubins;
use super::itinerary::Itinerary;
use super::lattice::{BINS, Lattice, TURNING};
use super::smooth;
use crate::error::RouteError;
use crate::geodesic::{CostGrid, Geodesic};
use crate::terrain::Terrain;
use pairtrawl_geometry::{Point, Pose};
use pairtrawl_model::Scene;
use pairtrawl_world::World;
use std::cmp::Reverse;

/// Arrivals this much dearer than the cheapest are still worth keeping for the next leg.
const SLACK: f64 = 1.6;
/// How far beyond the leg's beginning the heuristic is known: the way may swing out that far.
const MARGIN: f64 = 4.0;
/// Dubins shots at the end are tried from states nearer than this, and nearer than this number of turning radii.
const SHOT_RANGE: f64 = 4.0;
const SHOT_RADII: f64 = 6.0;
/// Spacing at which shots are checked.
const SHOT_SPACING: f64 = 0.1;
/// Expansions per leg, at most.
const MAX_EXPANSIONS: usize = 400_000;

/// The centerline: poses about 0.05 apart from the start midpoint through the circles to the end midpoint.
///
/// It passes every circle's center within about 0.1 in the given order (further off in sharp corners, and where an
/// obstacle leaves no other way), turns with the comfortable radius of the pair or, where that finds no way, down to half
/// its separation, and begins and ends in the direction of a pair that stands abreast. Headings are continuous.
///
/// # Errors
/// [`RouteError::BadOrder`] when `order` is not a permutation of the circles, [`RouteError::NoPath`] when there is no
/// way even for the smallest radius and margin, [`RouteError::SearchLimit`] when none was found before the search ended.
pub fn centerline(world: &World, scene: &Scene, order: &[usize]) -> Result<Vec<Pose>, RouteError> {
    let itinerary = Itinerary::new(&world.circles, scene, order)?;
    on_terrain(&Terrain::new(world, scene), &itinerary)
}

pub(crate) fn on_terrain(
    terrain: &Terrain,
    itinerary: &Itinerary,
) -> Result<Vec<Pose>, RouteError> {
    let grid = CostGrid::new(terrain);
    let mut march = Geodesic::new(&grid);
    let mut failure = RouteError::NoPath {
        from: itinerary.start.position(),
        to: itinerary.end.position(),
    };
    for strictness in ladder(&terrain.pair) {
        match search(
            &Corridor {
                terrain,
                strictness,
            },
            &mut march,
            itinerary,
        ) {
            Ok(raw) => return Ok(smooth::smooth(terrain, itinerary, &raw)),
            Err(e) => failure = e,
        }
    }
    Err(failure)
}

/// The cheapest way through all goals at one strictness, unsmoothed.
pub(crate) fn search(
    corridor: &Corridor,
    march: &mut Geodesic,
    itinerary: &Itinerary,
) -> Result<Vec<Pose>, RouteError> {
    let mut lattice = Lattice::new(corridor, itinerary.start);
    let mut seeds = vec![0u32];
    let mut from = itinerary.start.position();
    for &to in &itinerary.goals {
        let arrivals =
            leg(&mut lattice, march, &seeds, to).map_err(|ended| ended.into_error(from, to))?;
        seeds = lattice.finish_leg(&arrivals);
        from = to;
    }
    let to = itinerary.end.position();
    let (last, shot) = last_leg(&mut lattice, march, &seeds, itinerary.end)
        .map_err(|ended| ended.into_error(from, to))?;
    let mut poses = lattice.trace(last);
    poses.extend_from_slice(&shot[1..]);
    Ok(poses)
}

/// Distances to the leg's goal, into `march`.
fn aim(lattice: &Lattice, march: &mut Geodesic, seeds: &[u32], goal: Point) {
    // The front runs until it has passed all seeds by a margin, so that detours find values too.
    let mut ahead: Vec<Point> = seeds.iter().map(|&s| lattice.node(s).position).collect();
    let mut limit = f64::INFINITY;
    march.march(goal, move |p, t| {
        ahead.retain(|s| s.distance(p) > 0.3);
        if ahead.is_empty() && limit.is_infinite() {
            limit = t + MARGIN;
        }
        t > limit
    });
}

/// How a search ended that did not find its goal.
enum Ended {
    /// It has seen every state that it can get to.
    Exhausted,
    /// It was given up.
    Limit,
}

impl Ended {
    fn into_error(self, from: Point, to: Point) -> RouteError {
        match self {
            Self::Exhausted => RouteError::NoPath { from, to },
            Self::Limit => RouteError::SearchLimit {
                from,
                to,
                states: MAX_EXPANSIONS,
            },
        }
    }

    fn after(expansions: usize) -> Self {
        if expansions > MAX_EXPANSIONS {
            Self::Limit
        } else {
            Self::Exhausted
        }
    }
}

/// Searches one leg; returns the cheapest arrival of every heading, cheapest first. Never empty.
fn leg(
    lattice: &mut Lattice,
    march: &mut Geodesic,
    seeds: &[u32],
    goal: Point,
) -> Result<Vec<u32>, Ended> {
    aim(lattice, march, seeds, goal);
    let reach = lattice.corridor.strictness.reach;
    let mut arrivals: [Option<(f64, u32)>; BINS] = [None; BINS];
    let mut bound = f64::INFINITY;
    let mut open = lattice.open(seeds, march);
    let mut expansions = 0;
    while let Some((Reverse(bits), Reverse(n))) = open.pop() {
        if f64::from_bits(bits) > bound || expansions > MAX_EXPANSIONS {
            break;
        }
        if lattice.is_stale(n) {
            continue;
        }
        let node = lattice.node(n);
        let miss = node.position.distance(goal);
        if miss < reach {
            let cost = node.cost + miss;
            let best = &mut arrivals[usize::from(node.bin)];
            if best.is_none_or(|b| cost < b.0) {
                *best = Some((cost, n));
                bound = bound.min(cost + SLACK);
            }
            // Nothing is gained by going on from here: the next leg does.
            continue;
        }
        expansions += 1;
        lattice.expand(n, march, &mut open);
    }
    let mut found: Vec<(f64, u32)> = arrivals.into_iter().flatten().collect();
    found.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
    if found.is_empty() {
        return Err(Ended::after(expansions));
    }
    Ok(found.into_iter().map(|f| f.1).collect())
}

/// Searches the last leg; returns the node from which the final shot leaves, and the shot.
fn last_leg(
    lattice: &mut Lattice,
    march: &mut Geodesic,
    seeds: &[u32],
    end: Pose,
) -> Result<(u32, Vec<Pose>), Ended> {
    let range = SHOT_RANGE.max(SHOT_RADII * lattice.corridor.strictness.radius);
    aim(lattice, march, seeds, end.position());
    let mut best: Option<(f64, u32, Vec<Pose>)> = None;
    let mut open = lattice.open(seeds, march);
    let mut expansions = 0;
    while let Some((Reverse(bits), Reverse(n))) = open.pop() {
        let bound = best.as_ref().map_or(f64::INFINITY, |b| b.0);
        if f64::from_bits(bits) >= bound || expansions > MAX_EXPANSIONS {
            break;
        }
        if lattice.is_stale(n) {
            continue;
        }
        let (pose, cost) = (lattice.pose(n), lattice.node(n).cost);
        if pose.position().distance(end.position()) < range {
            let shot = Dubins::new(pose, end, lattice.corridor.strictness.radius);
            if cost + shot.length() < bound {
                let poses = shot.sample(SHOT_SPACING);
                if let Some(price) = shot_price(lattice.corridor, &poses, shot.length())
                    && cost + price < bound
                {
                    best = Some((cost + price, n, poses));
                }
            }
        }
        expansions += 1;
        lattice.expand(n, march, &mut open);
    }
    best.map(|b| (b.1, b.2))
        .ok_or_else(|| Ended::after(expansions))
}

/// Cost of a sampled shot, or `None` when the pair does not fit. The end pose is the scene's: it is not judged.
pub(crate) fn shot_price(corridor: &Corridor, poses: &[Pose], length: f64) -> Option<f64> {
    let spacing = length / (poses.len() - 1).max(1) as f64;
    let mut price = 0.0;
    for w in poses.windows(2) {
        price += spacing * (1.0 + corridor.penalty(w[0])?)
            + TURNING * (w[1].heading - w[0].heading).abs();
    }
    Some(price)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_a_search_that_has_seen_everything_says_that_there_is_no_way() {
        let (from, to) = (Point::ZERO, Point::new(1.0, 0.0));
        let after = |expansions| Ended::after(expansions).into_error(from, to);
        assert_eq!(after(MAX_EXPANSIONS), RouteError::NoPath { from, to });
        let states = MAX_EXPANSIONS;
        assert_eq!(
            after(MAX_EXPANSIONS + 1),
            RouteError::SearchLimit { from, to, states }
        );
    }
}
