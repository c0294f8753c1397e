use crate::{Body, BodyCircle, PhysicsParameters, PlannerParameters, Side};
use pairtrawl_geometry::{Point, Pose};

/// Everything that a run is planned from.
#[derive(Clone, Debug, PartialEq)]
pub struct Scene {
    /// A name for people.
    pub name: String,
    /// Bounds of robot centers and objects. Not an obstacle: the net may cross it.
    pub area: Area,
    /// Obstacles given as shapes.
    pub obstacles: Vec<Obstacle>,
    /// Obstacles given as a ROS map, when the scene has one; its outside counts as obstacle.
    pub map: Option<OccupancyMap>,
    /// What is to be gathered, but for those that are to be left.
    pub objects: Vec<Object>,
    /// Where the pair starts.
    pub start: PairPose,
    /// Where the pair ends.
    pub end: PairPose,
    /// The robot; both are alike.
    pub robot: Robot,
    /// The net.
    pub net: NetSpec,
    /// The planner's parameters.
    pub planner: PlannerParameters,
    /// Masses and frictions for rehearsal and execution.
    pub physics: PhysicsParameters,
}

/// The rectangle of the scene and the cell size of its occupancy grid.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Area {
    /// Lower left corner, m.
    pub min: Point,
    /// Upper right corner, m.
    pub max: Point,
    /// Cell size of the occupancy grid, m.
    pub resolution: f64,
}

/// A fixed obstacle.
#[derive(Clone, Debug, PartialEq)]
pub enum Obstacle {
    /// Axis-parallel box.
    Box {
        /// Lower left corner, m.
        min: Point,
        /// Upper right corner, m.
        max: Point,
    },
    /// Simple polygon, in either orientation, at least three vertices, convex or not.
    Polygon(Vec<Point>),
    /// Disc.
    Circle {
        /// Its center, m.
        center: Point,
        /// Its radius, m.
        radius: f64,
    },
}

/// An occupancy map: square cells on a grid that may be turned against the map frame.
#[derive(Clone, Debug, PartialEq)]
pub struct OccupancyMap {
    /// Pose of the outer corner of cell (column 0, row 0), the lower left one.
    pub origin: Pose,
    /// Edge length of a cell, m.
    pub resolution: f64,
    /// Cells along the map's x axis.
    pub columns: usize,
    /// Cells along the map's y axis.
    pub rows: usize,
    /// True where a cell is an obstacle (occupied, or unknown unless the scene says otherwise);
    /// index `row * columns + column`, row 0 the lowest.
    pub blocked: Vec<bool>,
}

impl OccupancyMap {
    /// True when the cell is an obstacle; every cell outside the map is one.
    pub fn is_blocked(&self, column: i64, row: i64) -> bool {
        match (usize::try_from(column), usize::try_from(row)) {
            (Ok(c), Ok(r)) if c < self.columns && r < self.rows => {
                self.blocked[r * self.columns + c]
            }
            _ => true,
        }
    }

    /// A map-frame point in cell units: the integer parts are column and row.
    pub fn to_cells(&self, p: Point) -> Point {
        let (sin, cos) = libm::sincos(self.origin.heading);
        let d = p - self.origin.position();
        Point::new(cos * d.x + sin * d.y, cos * d.y - sin * d.x) / self.resolution
    }

    /// The inverse of [`Self::to_cells`].
    pub fn from_cells(&self, c: Point) -> Point {
        let (sin, cos) = libm::sincos(self.origin.heading);
        let d = c * self.resolution;
        self.origin.position() + Point::new(cos * d.x - sin * d.y, sin * d.x + cos * d.y)
    }
}

/// Something to be gathered.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Object {
    /// Its center, m.
    pub position: Point,
    /// Its footprint.
    pub footprint: Footprint,
    /// Its mass, kg.
    pub mass: f64,
    /// True when it is to lie where it is: robots miss it like the rest, and nothing demands that it is gathered.
    pub leave: bool,
}

/// The outline of an object on the floor.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Footprint {
    /// A box of this width and depth, m, axis-parallel at the start.
    Box(f64, f64),
    /// A disc of this radius, m.
    Disc(f64),
}

impl Object {
    /// Radius of the smallest circle around the center that contains the footprint, m.
    pub fn footprint_radius(&self) -> f64 {
        match self.footprint {
            Footprint::Box(w, d) => 0.5 * Point::new(w, d).norm(),
            Footprint::Disc(r) => r,
        }
    }
}

/// Poses of both robots at one instant.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PairPose {
    /// The left robot.
    pub left: Pose,
    /// The right robot.
    pub right: Pose,
}

impl PairPose {
    /// The pose of one robot.
    pub fn robot(&self, side: Side) -> Pose {
        match side {
            Side::Left => self.left,
            Side::Right => self.right,
        }
    }

    /// Distance between the axle centers, m.
    pub fn separation(&self) -> f64 {
        self.left.position().distance(self.right.position())
    }

    /// The point half way between the axle centers.
    pub fn midpoint(&self) -> Point {
        self.left.position().lerp(self.right.position(), 0.5)
    }

    /// Direction of travel of a pair that drives abreast: the vector from right to left turned by -90 degrees, rad.
    pub fn normal_heading(&self) -> f64 {
        (-(self.left.position() - self.right.position()).perp()).angle()
    }
}

/// The robot. The default is the TurtleBot3 Waffle Pi.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(
    feature = "schema",
    derive(schemars::JsonSchema),
    schemars(default, deny_unknown_fields)
)]
pub struct Robot {
    /// Radius of the circle around the axle center that contains the robot, m. With a body it only tells the size of the
    /// machine.
    pub radius: f64,
    /// The net is tied this far behind the axle center, m.
    pub hitch: f64,
    /// Greatest speed of a wheel over the floor, m/s.
    pub v_max: f64,
    /// Greatest turning rate, rad/s.
    pub omega_max: f64,
    /// Half the distance between the wheels, R, m.
    pub half_track: f64,
    /// Circles that contain the machine, each x forward of and y to the left of the axle center, then its radius, m; left
    /// out: one of `radius` around the axle center.
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "Option::is_none"))]
    #[cfg_attr(
        feature = "schema",
        schemars(with = "Option<Vec<[f64; 3]>>", length(min = 1, max = 16))
    )]
    pub body: Option<Body>,
}

impl Default for Robot {
    fn default() -> Self {
        Self {
            radius: 0.24,
            hitch: 0.207,
            v_max: 0.26,
            omega_max: 1.82,
            half_track: 0.144,
            body: None,
        }
    }
}

impl Robot {
    /// The circles that contain the machine: those of its body, or the one of its radius.
    pub fn circles(&self) -> Body {
        let disc = || Body::circle(BodyCircle::around_reference(self.radius));
        self.body.unwrap_or_else(disc)
    }

    /// The same robot with this body; its radius becomes that of the smallest circle around the axle center that contains
    /// the body.
    #[must_use]
    pub fn with_body(self, body: Body) -> Self {
        Self {
            radius: body.reach(),
            body: Some(body),
            ..self
        }
    }

    /// The distance that the claim `separation` keeps between the axle centers for the robots' sake, m: two radii, or 0
    /// where the claim `robots_apart` keeps the bodies apart.
    pub fn least_separation(&self) -> f64 {
        match self.body {
            None => 2.0 * self.radius,
            Some(_) => 0.0,
        }
    }
}

/// The net.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct NetSpec {
    /// d_max, m; `None`: the planner chooses it.
    pub length: Option<f64>,
    /// How the net lies at the start, from the left hitch to the right one; `None`: a symmetric U behind the hitches.
    pub start: Option<Vec<Point>>,
}
