use pairtrawl_geometry::Point;
use pairtrawl_model::{Cost, Obstacle, PairTrajectory, Scene};
use std::f64::consts::FRAC_PI_2;

/// The paper's J on a pair of trajectories, literally but for the sign of the outer branch of J_e: J_dist over the steps
/// and J_s over the inner waypoints of both robots, J_e over all waypoints, counted once, J_obs over both robots.
pub fn evaluate(scene: &Scene, pair: &PairTrajectory, net_length: f64) -> Cost {
    let p = &scene.planner;
    let mut cost = Cost::default();
    for robot in [&pair.left, &pair.right] {
        for w in robot.windows(2) {
            cost.distance += p.a2
                * (p.t1 * w[0].position().distance(w[1].position())
                    + p.t2 * (w[1].heading - w[0].heading).abs());
        }
        for w in robot.windows(3) {
            let second = |f: fn(&pairtrawl_geometry::Pose) -> f64| {
                square(f(&w[0]) - 2.0 * f(&w[1]) + f(&w[2]))
            };
            cost.smoothness += p.a1
                * (p.b1 * second(|q| q.x) + p.b2 * second(|q| q.y) + p.b3 * second(|q| q.heading));
        }
        for q in robot {
            cost.obstacle += p.a3 * obstacle_cost(scene, q.position());
        }
    }
    for (l, r) in pair.left.iter().zip(&pair.right) {
        cost.expansion +=
            p.a4 * expansion_cost(scene, l.position().distance(r.position()), net_length);
    }
    cost
}

/// J_obs of one waypoint: K1 inside an obstacle, plus the potential of every object's circle (radius with margin gamma).
fn obstacle_cost(scene: &Scene, p: Point) -> f64 {
    let k = &scene.planner;
    let margin = k.circle_margin.unwrap_or(scene.robot.radius);
    let mut cost = if in_obstacle(scene, p) { k.k1 } else { 0.0 };
    for object in &scene.objects {
        let radius = object.footprint_radius() + margin;
        let distance = p.distance(object.position).max(f64::MIN_POSITIVE.sqrt());
        // Exactly on the circle the potential is zero; rounding there must not count.
        if distance < radius {
            cost += 0.5 * k.k2 * square(1.0 / distance - 1.0 / radius);
        }
    }
    cost
}

/// J_e of one waypoint.
fn expansion_cost(scene: &Scene, d: f64, d_max: f64) -> f64 {
    let p = &scene.planner;
    let (d_min, d_rest) = (p.min_ratio * d_max, p.rest_ratio * d_max);
    if d < d_min || d > d_max {
        p.k3
    } else if d <= d_rest {
        let gamma_1 = FRAC_PI_2 / (d_rest - d_min);
        p.kd1 * square(libm::tan(gamma_1 * (d - d_rest)))
    } else {
        p.kd2 * square(d - d_rest) + square(d - d_rest) / square(d - d_max)
    }
}

fn square(x: f64) -> f64 {
    x * x
}

fn in_obstacle(scene: &Scene, p: Point) -> bool {
    let in_map = scene.map.as_ref().is_some_and(|map| {
        let c = map.to_cells(p);
        map.is_blocked(c.x.floor() as i64, c.y.floor() as i64)
    });
    in_map
        || scene.obstacles.iter().any(|obstacle| match obstacle {
            Obstacle::Box { min, max } => {
                p.x >= min.x && p.x <= max.x && p.y >= min.y && p.y <= max.y
            }
            Obstacle::Circle { center, radius } => p.distance(*center) <= *radius,
            Obstacle::Polygon(vertices) => {
                pairtrawl_geometry::Polygon::new(vertices.clone()).contains(p)
            }
        })
}
