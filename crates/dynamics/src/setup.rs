//! What a world is made of, and how much work it was.

use crate::chain::NetParameters;
use crate::solid::Solid;
use crate::wheels::WheelParameters;
use pairtrawl_geometry::{Point, Pose};

/// A robot: a body on two wheels.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RobotParameters {
    /// kg.
    pub mass: f64,
    /// About the center of mass, kg m^2.
    pub inertia: f64,
    /// Its wheels.
    pub wheels: WheelParameters,
    /// The net is tied this far behind the axle, m.
    pub hitch: f64,
}

/// A footprint.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Footprint {
    /// Half width and half depth, m.
    Box(Point),
    /// Radius, m.
    Disc(f64),
}

/// A body that lies on the floor.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ObjectParameters {
    /// Its center at the start, m.
    pub place: Point,
    /// Its outline.
    pub footprint: Footprint,
    /// kg.
    pub mass: f64,
    /// Friction on the floor: mu m g, N.
    pub floor_limit: f64,
}

/// All that a world is made of.
#[derive(Clone, Debug)]
pub struct Setup {
    /// Both robots are alike.
    pub robot: RobotParameters,
    /// What a robot touches with: centers from the axle (x forward, m) and shapes, in the robot's frame.
    pub robot_outline: Vec<(Point, Footprint)>,
    /// So many links at each end, one at least, do not touch the robot that holds them.
    pub links_within_robot: usize,
    /// Axle centers and headings of the (left, right) robot.
    pub poses: [Pose; 2],
    /// The net.
    pub net: NetParameters,
    /// Left hitch, hinges, right hitch.
    pub nodes: Vec<Point>,
    /// Objects.
    pub objects: Vec<ObjectParameters>,
    /// Obstacles.
    pub obstacles: Vec<Solid>,
    /// Coulomb's coefficient between things that touch.
    pub contact_friction: f64,
}
