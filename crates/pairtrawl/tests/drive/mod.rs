//! A short drive for tests: straight on, then a left turn, two objects on the way.

#![allow(
    clippy::disallowed_methods,
    reason = "tests compare with the standard library"
)]

use pairtrawl::geometry::{Point, Pose};
use pairtrawl::model::{Area, Footprint, NetSpec, Object, PairTrajectory, Scene};

/// Distance of each robot from the middle, m.
const HALF: f64 = 0.4;

/// A pair abreast along the x axis for 1 m and then along an arc of radius 1.5 m by 0.8 rad, in steps of 36 mm.
pub fn trajectory() -> PairTrajectory {
    let step = 0.036;
    let mut trajectory = PairTrajectory {
        step_time: 0.248,
        ..PairTrajectory::default()
    };
    let (mut middle, mut heading) = (Point::new(0.0, 0.0), 0.0_f64);
    for i in 0..60 {
        let side = Point::unit(heading).perp() * HALF;
        trajectory.left.push(Pose::at(middle + side, heading));
        trajectory.right.push(Pose::at(middle - side, heading));
        let turn: f64 = if f64::from(i) * step < 1.0 {
            0.0
        } else {
            step / 1.5
        };
        // The chord of an arc, so that both robots roll without slip.
        let chord = if turn == 0.0 {
            step
        } else {
            2.0 * 1.5 * (0.5 * turn).sin()
        };
        middle += Point::unit(heading + 0.5 * turn) * chord;
        heading += turn;
    }
    trajectory
}

/// Net length, m.
pub const NET: f64 = 1.5;

/// A free area with two cubes between the robots.
pub fn scene(trajectory: &PairTrajectory) -> Scene {
    let cube = |x, y| Object {
        position: Point::new(x, y),
        footprint: Footprint::Box(0.05, 0.05),
        mass: 0.025,
        leave: false,
    };
    Scene {
        name: "drive".to_owned(),
        area: Area {
            min: Point::new(-2.0, -2.0),
            max: Point::new(5.0, 4.0),
            resolution: 0.05,
        },
        obstacles: Vec::new(),
        map: None,
        objects: vec![cube(0.5, 0.05), cube(1.2, -0.05)],
        start: trajectory.pair(0),
        end: trajectory.pair(trajectory.len() - 1),
        robot: Default::default(),
        net: NetSpec {
            length: Some(NET),
            start: None,
        },
        planner: Default::default(),
        physics: Default::default(),
    }
}
