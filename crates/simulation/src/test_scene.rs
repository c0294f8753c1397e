//! A scene for the tests of this crate's own modules.

use pairtrawl_geometry::{Point, Pose};
use pairtrawl_model::{
    Area, NetSpec, Object, PairPose, PhysicsParameters, PlannerParameters, Robot, Scene,
};

/// Two robots 0.6 m apart that head for +x, these objects, and nothing else.
pub(crate) fn scene(objects: Vec<Object>) -> Scene {
    let pair = PairPose {
        left: Pose::new(-0.3, 0.0, 0.0),
        right: Pose::new(0.3, 0.0, 0.0),
    };
    Scene {
        name: "test".to_owned(),
        area: Area {
            min: Point::new(-9.0, -9.0),
            max: Point::new(9.0, 9.0),
            resolution: 0.05,
        },
        obstacles: Vec::new(),
        map: None,
        objects,
        start: pair,
        end: pair,
        robot: Robot::default(),
        net: NetSpec::default(),
        planner: PlannerParameters::default(),
        physics: PhysicsParameters::default(),
    }
}
