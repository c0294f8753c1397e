use crate::{
    Area, BodyCircle, Footprint, NetSpec, Object, Obstacle, OccupancyMap, PairPose,
    PhysicsParameters, PlannerParameters, Robot, Scene,
};
use pairtrawl_geometry::{Point, Pose};

/// Units in which a scene can be expressed instead of SI. Equations of motion and costs hold in any of them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Units {
    /// Unit of length, m.
    pub length: f64,
    /// Unit of time, s.
    pub time: f64,
    /// Unit of mass, kg.
    pub mass: f64,
}

impl Units {
    /// SI units.
    pub const SI: Self = Self {
        length: 1.0,
        time: 1.0,
        mass: 1.0,
    };

    /// Decimal numbers stay decimal: rounded to 14 digits, a scene that is written in decimals has the same bits at every
    /// scale, so that no choice of the planner and no bounce in the physics depends on how a division was rounded.
    pub fn tidy(&self, x: f64) -> f64 {
        if *self == Self::SI {
            return x;
        }
        format!("{x:.13e}").parse().unwrap_or(x)
    }

    /// Unit of speed, m/s.
    pub fn speed(&self) -> f64 {
        self.length / self.time
    }

    /// Unit of force, N.
    pub fn force(&self) -> f64 {
        self.mass * self.length / (self.time * self.time)
    }

    /// Unit of torque, N m.
    pub fn torque(&self) -> f64 {
        self.force() * self.length
    }

    /// A pose given in m, expressed in these units.
    pub fn pose(&self, pose: Pose) -> Pose {
        let length = |x: f64| self.tidy(x / self.length);
        Pose::new(length(pose.x), length(pose.y), pose.heading)
    }

    /// The way back: a place in these units, in m.
    pub fn place_in_si(&self, place: Point) -> Point {
        place * self.length
    }

    /// The way back: a pose in these units, in m.
    pub fn pose_in_si(&self, pose: Pose) -> Pose {
        Pose::at(self.place_in_si(pose.position()), pose.heading)
    }

    /// A scene given in SI units, expressed in these. Angles and ratios stay.
    pub fn scene(&self, scene: &Scene) -> Scene {
        let tidy = |x| self.tidy(x);
        let (l, time, mass) = (self.length, self.time, self.mass);
        let length = |x: f64| tidy(x / l);
        let point = |p: Point| Point::new(length(p.x), length(p.y));
        let pose = |p: Pose| self.pose(p);
        let pair = |pair: PairPose| PairPose {
            left: pose(pair.left),
            right: pose(pair.right),
        };
        let Scene {
            name,
            area,
            obstacles,
            map,
            objects,
            start,
            end,
            robot,
            net,
            planner,
            physics,
        } = scene;
        let obstacle = |obstacle: &Obstacle| match obstacle {
            Obstacle::Box { min, max } => Obstacle::Box {
                min: point(*min),
                max: point(*max),
            },
            Obstacle::Polygon(vertices) => {
                Obstacle::Polygon(vertices.iter().map(|&v| point(v)).collect())
            }
            Obstacle::Circle { center, radius } => Obstacle::Circle {
                center: point(*center),
                radius: length(*radius),
            },
        };
        let circle = |circle: BodyCircle| BodyCircle {
            center: point(circle.center),
            radius: length(circle.radius),
        };
        let object = |object: &Object| Object {
            position: point(object.position),
            footprint: match object.footprint {
                Footprint::Box(w, d) => Footprint::Box(length(w), length(d)),
                Footprint::Disc(radius) => Footprint::Disc(length(radius)),
            },
            mass: tidy(object.mass / mass),
            leave: object.leave,
        };
        Scene {
            name: name.clone(),
            area: Area {
                min: point(area.min),
                max: point(area.max),
                resolution: length(area.resolution),
            },
            obstacles: obstacles.iter().map(obstacle).collect(),
            map: map.as_ref().map(|map| OccupancyMap {
                origin: pose(map.origin),
                resolution: length(map.resolution),
                ..map.clone()
            }),
            objects: objects.iter().map(object).collect(),
            start: pair(*start),
            end: pair(*end),
            robot: Robot {
                radius: length(robot.radius),
                hitch: length(robot.hitch),
                v_max: tidy(robot.v_max / self.speed()),
                omega_max: tidy(robot.omega_max * time),
                half_track: length(robot.half_track),
                body: robot.body.map(|body| body.map(circle)),
            },
            net: NetSpec {
                length: net.length.map(length),
                start: net
                    .start
                    .as_ref()
                    .map(|points| points.iter().map(|&p| point(p)).collect()),
            },
            planner: self.planner(planner),
            physics: self.physics(physics),
        }
    }

    pub(crate) fn planner(&self, planner: &PlannerParameters) -> PlannerParameters {
        let tidy = |x| self.tidy(x);
        let l = self.length;
        let length = |x: f64| tidy(x / l);
        PlannerParameters {
            max_step: length(planner.max_step),
            clearance: length(planner.clearance),
            cruise: tidy(planner.cruise / self.speed()),
            half_separation: length(planner.half_separation),
            circle_margin: planner.circle_margin.map(length),
            k2: tidy(planner.k2 / (l * l)),
            t1: tidy(planner.t1 * l),
            kd2: tidy(planner.kd2 * (l * l)),
            b1: tidy(planner.b1 * (l * l)),
            b2: tidy(planner.b2 * (l * l)),
            ..*planner
        }
    }

    pub(crate) fn physics(&self, physics: &PhysicsParameters) -> PhysicsParameters {
        let tidy = |x| self.tidy(x);
        let (l, time, mass) = (self.length, self.time, self.mass);
        let length = |x: f64| tidy(x / l);
        PhysicsParameters {
            gravity: tidy(physics.gravity * time * time / l),
            robot_mass: tidy(physics.robot_mass / mass),
            robot_inertia: tidy(physics.robot_inertia / (mass * l * l)),
            center_of_mass: length(physics.center_of_mass),
            wheel_radius: length(physics.wheel_radius),
            max_torque: tidy(physics.max_torque / self.torque()),
            net_mass: tidy(physics.net_mass * l / mass),
            net_link: length(physics.net_link),
            net_thickness: length(physics.net_thickness),
            net_height: length(physics.net_height),
            hinge_damping: tidy(physics.hinge_damping / (self.torque() * time)),
            tension_limit: tidy(physics.tension_limit / self.force()),
            ..*physics
        }
    }
}
