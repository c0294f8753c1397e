//! Rows of robots with a body: which are in play, and their gradients among the variables, against the formulas.

use super::case::{Case, shaken};
use crate::anchor::Anchor;
use crate::constraints::body_distance::{BodyOffObject, BodyOffObstacle};
use crate::constraints::{BodyRules, PairRules};
use crate::curvature::Curvature;
use crate::iterate::{Iterate, STAGE};
use crate::problem::Problem;
use crate::state::State;
use crate::system::System;
use pairtrawl_geometry::{Convex, Point, Polygon};
use pairtrawl_model::{Body, BodyCircle, Side};

/// A generated scene for robots of three circles, one of them around the axle center.
fn case(seed: u64) -> Case {
    let mut case = Case::new(7, seed, 60, false);
    let circle = |x: f64, y: f64, radius: f64| BodyCircle {
        center: Point::new(x, y),
        radius,
    };
    let circles = [
        circle(0.0, 0.0, 0.12),
        circle(-0.1, 0.02, 0.15),
        circle(0.12, -0.03, 0.1),
    ];
    let body = Body::of(&circles).expect("some circles");
    case.made.scene.robot.body = Some(body);
    let net_length = Some(case.made.net_length);
    case.problem = Problem::new(&case.made.scene, net_length, &case.pieces);
    // So much that the robots are too close.
    case.problem.reserve.separation = 0.6;
    case
}

/// Where a circle of a robot is at a waypoint.
fn center(case: &Case, x: &Iterate, stage: usize, robot: Side, number: usize) -> Point {
    let z = &x.stages[stage][3 * robot.index()..];
    let c = case.made.scene.robot.circles().circles()[number].center;
    let (sin, cos) = z[2].sin_cos();
    Point::new(z[0] + cos * c.x - sin * c.y, z[1] + sin * c.x + cos * c.y)
}

/// Minus the multipliers times the constraints of all rows that only a body has.
fn of_bodies(case: &Case, state: &State, x: &Iterate) -> f64 {
    let scene = &case.made.scene;
    let radius = |number: usize| scene.robot.circles().circles()[number].radius;
    let mut sum = 0.0;
    for item in &state.set.bodies.items {
        // The circles off the axle are the second and the third.
        let at = |circle: u8| {
            let number = 1 + usize::from(circle);
            (
                center(case, x, item.at.stage(), item.at.robot(), number),
                radius(number),
            )
        };
        let c = match item.rule {
            BodyRules::BodyOffObject(BodyOffObject { circle, off }) => {
                let (p, radius) = at(circle);
                let object = scene.objects[off.object as usize];
                let keep = off
                    .tier
                    .reserve(&case.problem, case.problem.reserve.clearance);
                p.distance(object.position) - object.footprint_radius() - radius - keep
            }
            BodyRules::BodyOffObstacle(BodyOffObstacle { circle, off }) => {
                let (p, radius) = at(circle);
                let keep = off
                    .tier
                    .reserve(&case.problem, case.problem.reserve.clearance);
                let gap = match &case.pieces[off.piece as usize] {
                    Convex::Polygon(v) => Polygon::new(v.clone()).signed_distance(p),
                    Convex::Circle { center, radius } => p.distance(*center) - radius,
                };
                gap - radius - keep
            }
        };
        sum -= item.row.z * c;
    }
    for item in &state.set.pairs.items {
        if let PairRules::BodiesApart(rule) = item.rule {
            let stage = item.at.stage();
            let (l, r) = (usize::from(rule.left), usize::from(rule.right));
            let left = center(case, x, stage, Side::Left, l);
            let right = center(case, x, stage, Side::Right, r);
            let keep = radius(l) + radius(r) + case.problem.reserve.separation;
            sum -= item.row.z * (left.distance(right) - keep);
        }
    }
    sum
}

fn gradient(case: &Case, state: &mut State) -> Vec<f64> {
    let mut system = System::default();
    let lambda = state.lambda.clone();
    system.assemble(
        &case.problem,
        &state.x,
        &mut state.set,
        &lambda,
        (1e-2, Curvature::Convex),
    );
    system.lagrangian
}

#[test]
fn gradients_of_circles_are_those_of_their_formulas() {
    for seed in [1, 2, 3] {
        let case = case(seed);
        let mut state = shaken(&case, seed);
        let with = gradient(&case, &mut state);
        let mut without = state.clone();
        without.set.bodies.items.clear();
        let is_apart = |rule: &PairRules| matches!(rule, PairRules::BodiesApart(_));
        without.set.pairs.items.retain(|item| !is_apart(&item.rule));
        let without = gradient(&case, &mut without);

        let (mut objects, mut obstacles) = (0, 0);
        for item in &state.set.bodies.items {
            match item.rule {
                BodyRules::BodyOffObject(_) => objects += 1,
                BodyRules::BodyOffObstacle(_) => obstacles += 1,
            }
        }
        let apart = state.set.pairs.items.iter();
        let apart = apart.filter(|item| is_apart(&item.rule)).count();
        assert!(
            objects > 5 && obstacles > 5 && apart > 50,
            "{objects} {obstacles} {apart}"
        );

        let mut x = state.x.clone();
        let scale = with.iter().fold(1.0_f64, |m, g| m.max(g.abs()));
        for k in 0..with.len() {
            let (stage, v) = (k / STAGE + 1, k % STAGE);
            let at = x.stages[stage][v];
            let mut value = |h: f64| {
                x.stages[stage][v] = at + h;
                of_bodies(&case, &state, &x)
            };
            const H: f64 = 3e-5;
            let difference =
                (8.0 * (value(H) - value(-H)) - (value(2.0 * H) - value(-2.0 * H))) / (12.0 * H);
            x.stages[stage][v] = at;
            let assembled = with[k] - without[k];
            assert!(
                (assembled - difference).abs() < 1e-6 * scale,
                "variable {v} of waypoint {stage}: {assembled} for {difference}"
            );
        }
    }
}

#[test]
fn a_disc_has_no_rows_of_a_body() {
    let case = Case::new(7, 1, 60, false);
    let state = shaken(&case, 1);
    assert!(state.set.bodies.items.is_empty());
    let is_apart = |rule: &PairRules| matches!(rule, PairRules::BodiesApart(_));
    assert!(
        !state
            .set
            .pairs
            .items
            .iter()
            .any(|item| is_apart(&item.rule))
    );
}
