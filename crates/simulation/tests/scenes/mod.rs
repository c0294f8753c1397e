//! Small scenes for the tests.
#![allow(dead_code, reason = "each test file uses some of them")]

use pairtrawl_geometry::{Point, Pose};
use pairtrawl_model::{
    Area, Footprint, NetSpec, Object, Obstacle, PairPose, PairTrajectory, PhysicsParameters,
    PlannerParameters, Robot, Scene,
};
use std::f64::consts::FRAC_PI_2;

/// Side of the test cubes, m.
pub const CUBE: f64 = 0.05;

/// Two robots 0.6 m apart at the origin, heading +y, and nothing else.
pub fn empty() -> Scene {
    let pair = |y: f64| PairPose {
        left: Pose::new(-0.3, y, FRAC_PI_2),
        right: Pose::new(0.3, y, FRAC_PI_2),
    };
    Scene {
        name: "test".to_owned(),
        area: Area {
            min: Point::new(-10.0, -10.0),
            max: Point::new(10.0, 10.0),
            resolution: 0.05,
        },
        obstacles: Vec::new(),
        map: None,
        objects: Vec::new(),
        start: pair(0.0),
        end: pair(2.0),
        robot: Robot::default(),
        net: NetSpec::default(),
        planner: PlannerParameters::default(),
        physics: PhysicsParameters::default(),
    }
}

/// A cube of 25 g.
pub fn cube(x: f64, y: f64) -> Object {
    Object {
        position: Point::new(x, y),
        footprint: Footprint::Box(CUBE, CUBE),
        mass: 0.025,
        leave: false,
    }
}

pub fn block(x0: f64, y0: f64, x1: f64, y1: f64) -> Obstacle {
    Obstacle::Box {
        min: Point::new(x0, y0),
        max: Point::new(x1, y1),
    }
}

/// From the scene's start straight along +y for `distance` (m) at 0.2 m/s.
pub fn straight(scene: &Scene, distance: f64) -> PairTrajectory {
    let steps = (distance / 0.05).round() as usize;
    let drive = |from: Pose| -> Vec<Pose> {
        (0..=steps)
            .map(|i| {
                Pose::new(
                    from.x,
                    from.y + distance * i as f64 / steps as f64,
                    from.heading,
                )
            })
            .collect()
    };
    PairTrajectory {
        left: drive(scene.start.left),
        right: drive(scene.start.right),
        step_time: 0.25,
    }
}

/// Reproducible numbers in [0, 1) (SplitMix64).
pub struct Numbers(pub u64);

impl Numbers {
    pub fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1u64 << 53) as f64
    }

    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.next()
    }
}
