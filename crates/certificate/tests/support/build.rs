//! Scenes and exactly driven plans, made by hand.

use super::Case;
use pairtrawl_geometry::{Point, Pose};
use pairtrawl_model::{
    Area, Footprint, NetSpec, Object, Obstacle, PairPose, PairTrajectory, PhysicsParameters,
    PlannerParameters, Robot, Scene,
};

/// An empty scene in a rectangle from the origin; the pair drives along +x from x = 1 to x = `to_x` around y = `y`,
/// 0.8 m apart.
pub fn hall(width: f64, height: f64, y: f64, to_x: f64) -> Scene {
    let pair = |x: f64| PairPose {
        left: Pose::new(x, y + 0.4, 0.0),
        right: Pose::new(x, y - 0.4, 0.0),
    };
    Scene {
        name: "hall".to_owned(),
        area: Area {
            min: Point::ZERO,
            max: Point::new(width, height),
            resolution: 0.05,
        },
        obstacles: Vec::new(),
        map: None,
        objects: Vec::new(),
        start: pair(1.0),
        end: pair(to_x),
        robot: Robot::default(),
        net: NetSpec::default(),
        planner: PlannerParameters::default(),
        physics: PhysicsParameters::default(),
    }
}

pub fn wall(x0: f64, y0: f64, x1: f64, y1: f64) -> Obstacle {
    Obstacle::Box {
        min: Point::new(x0, y0),
        max: Point::new(x1, y1),
    }
}

pub fn cube(x: f64, y: f64) -> Object {
    Object {
        position: Point::new(x, y),
        footprint: Footprint::Box(0.05, 0.05),
        mass: 0.025,
        leave: false,
    }
}

/// A piece of a drive: `steps` steps in which the pair's middle moves `forward` meters and turns `turn` radians.
pub struct Leg {
    pub steps: usize,
    pub forward: f64,
    pub turn: f64,
}

/// Both robots abreast at a fixed distance, driven exactly by p[i+1] = p[i] + s (cos, sin)(phi + dphi / 2), with the
/// scene's start and end set to the drive's. A rigid pair on an arc: each robot's chord is its radius times
/// 2 sin(dphi / 2), along the mid-step heading.
pub fn drive(scene: &Scene, legs: &[Leg], net_length: f64) -> Case {
    let mut scene = scene.clone();
    let half = 0.5 * scene.start.separation();
    let mut middle = scene.start.midpoint();
    let mut heading = scene.start.left.heading;
    let mut trajectory = PairTrajectory {
        left: Vec::new(),
        right: Vec::new(),
        step_time: 0.3,
    };
    let mut push = |middle: Point, heading: f64| {
        let across = Point::unit(heading).perp() * half;
        trajectory.left.push(Pose::at(middle + across, heading));
        trajectory.right.push(Pose::at(middle - across, heading));
    };
    push(middle, heading);
    for leg in legs {
        for _ in 0..leg.steps {
            // The chord of the arc that the middle drives.
            middle += Point::unit(heading + 0.5 * leg.turn) * leg.forward;
            heading += leg.turn;
            push(middle, heading);
        }
    }
    scene.start = trajectory.pair(0);
    scene.end = trajectory.pair(trajectory.len() - 1);
    Case {
        scene,
        net_length,
        trajectory,
    }
}

/// Ten steps of 4 cm along +x around y = 2, robots at y = 2.4 and y = 1.6, a net of 1.5 m.
pub fn straight() -> Case {
    drive(
        &hall(8.0, 4.0, 2.0, 5.0),
        &[Leg {
            steps: 10,
            forward: 0.04,
            turn: 0.0,
        }],
        1.5,
    )
}
