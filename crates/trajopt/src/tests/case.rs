//! Generated scenes, their problems, and states near their witnesses.

use super::between;
use crate::iterate::Iterate;
use crate::problem::Problem;
use crate::settings::Settings;
use crate::state::State;
use crate::tier::Tier;
use pairtrawl_generate::{Generated, Kind, generate};
use pairtrawl_geometry::{Bounds, Convex, Point};
use pairtrawl_model::Obstacle;
use pairtrawl_world::World;

/// A generated scene with everything that its problem is made from.
pub struct Case {
    pub made: Generated,
    pub pieces: Vec<Convex>,
    pub problem: Problem,
}

impl Case {
    pub fn new(difficulty: u8, seed: u64, waypoints: usize, free_length: bool) -> Self {
        let made = generate(Kind::Witness, difficulty, seed, waypoints).expect("a scene");
        Self::of(made, free_length)
    }

    /// As [`Self::new`], small obstacles in the way of the line between the robots, and every other bound so tight that the
    /// witness comes near it somewhere: every kind of row is in play.
    pub fn tight(difficulty: u8, seed: u64, waypoints: usize, free_length: bool) -> Self {
        let mut made = generate(Kind::Witness, difficulty, seed, waypoints).expect("a scene");
        let pairs: Vec<_> = (0..waypoints).map(|i| made.witness.pair(i)).collect();
        let tip = Point::new(0.04, 0.01);
        for (k, i) in (5..waypoints - 5).step_by(11).enumerate() {
            let (l, r) = (pairs[i].left.position(), pairs[i].right.position());
            let at = l.lerp(r, [0.5, 0.45, 0.6][k % 3]);
            made.scene.obstacles.push(if k % 2 == 0 {
                Obstacle::Circle {
                    center: at,
                    radius: 0.01,
                }
            } else {
                Obstacle::Polygon(vec![at - tip, at + tip, at + tip.perp()])
            });
        }
        let positions: Vec<Point> = pairs
            .iter()
            .flat_map(|p| [p.left.position(), p.right.position()])
            .collect();
        let room = Bounds::of(&positions).grown(0.05);
        (made.scene.area.min, made.scene.area.max) = (room.min, room.max);
        let apart = |pick: fn(f64, f64) -> f64| {
            pairs
                .iter()
                .map(|p| p.separation())
                .reduce(pick)
                .expect("waypoints")
        };
        made.net_length = apart(f64::max) + 0.02;
        let mut case = Self::of(made, free_length);
        let reserve = &mut case.problem.reserve;
        reserve.separation = apart(f64::min) - 0.02 - 2.0 * case.problem.robot.radius;
        let skewed = pairs.iter().flat_map(|p| {
            let across = p.left.position() - p.right.position();
            let normal = across.angle() - std::f64::consts::FRAC_PI_2;
            [p.left.heading, p.right.heading].map(|h| (h - normal).cos().clamp(-1.0, 1.0).acos())
        });
        let most = skewed.fold(0.0, f64::max);
        reserve.skew = case.problem.planner.max_skew - most - 0.05;
        case
    }

    fn of(made: Generated, free_length: bool) -> Self {
        let net_length = (!free_length).then_some(made.net_length);
        let pieces = World::new(&made.scene, net_length).expect("a world").pieces;
        let problem = Problem::new(&made.scene, net_length, &pieces);
        Self {
            made,
            pieces,
            problem,
        }
    }

    /// Distance kept beyond a claim's bound.
    pub fn kept(&self, tier: Tier, margin: f64) -> f64 {
        match tier {
            Tier::Margin => margin,
            Tier::Claim => {
                let (step, radius) = (
                    self.made.scene.planner.max_step,
                    self.made.scene.robot.radius,
                );
                (1.4 * step * step / (8.0 * radius)).min(margin)
            }
        }
    }

    pub fn start(&self) -> Iterate {
        Iterate::from_trajectory(&self.made.witness, self.made.net_length)
    }
}

/// A state near a witness with random multipliers.
pub fn shaken(case: &Case, seed: u64) -> State {
    let mut random = fastrand::Rng::with_seed(seed);
    let mut x = case.start();
    let last = x.stages.len() - 1;
    for stage in &mut x.stages[1..last] {
        for z in stage {
            *z += between(&mut random, -0.01, 0.01);
        }
    }
    let mut state = State::new(&case.problem, x, &Settings::default());
    for row in state.set.rows_mut() {
        row.z = row.weight.min(100.0) * between(&mut random, 0.01, 0.99);
    }
    for lambda in &mut state.lambda {
        *lambda = between(&mut random, -100.0, 100.0);
    }
    state
}
