use pairtrawl_geometry::{Point, Pose};
use pairtrawl_model::{BodyCircle, Obstacle, Scene};

/// Obstacle cost J_obs of a robot at one waypoint (the paper's eqs. 4 to 6), of every circle of its body.
pub(crate) fn obstacle_cost(scene: &Scene, pose: Pose) -> f64 {
    let body = scene.robot.circles();
    let of_circle = |c: &BodyCircle| circle_cost(scene, c.center_at(pose), c.radius);
    body.circles().iter().map(of_circle).sum()
}

/// K1 inside an obstacle, plus the potential of every object's circle. Its margin gamma is the radius of the robot's circle,
/// which is what the constraints keep; a scene's `circle_margin` is about order, centerline and baseline alone.
fn circle_cost(scene: &Scene, p: Point, radius: f64) -> f64 {
    let k = &scene.planner;
    let mut cost = if in_obstacle(scene, p) { k.k1 } else { 0.0 };
    for object in &scene.objects {
        let reach = object.footprint_radius() + radius;
        let distance = p.distance(object.position).max(f64::MIN_POSITIVE.sqrt());
        // Exactly on the circle the potential is zero; rounding there must not count.
        if distance < reach {
            let steep = 1.0 / distance - 1.0 / reach;
            cost += 0.5 * k.k2 * steep * steep;
        }
    }
    cost
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
