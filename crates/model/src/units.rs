use crate::{
    Area, Footprint, NetSpec, Object, Obstacle, OccupancyMap, PairPose, PhysicsParameters,
    PlannerParameters, Robot, Scene,
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

    /// A scene given in SI units, expressed in these. Angles and ratios stay.
    pub fn scene(&self, scene: &Scene) -> Scene {
        let &Self {
            length: l,
            time,
            mass,
        } = self;
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
        let pair = |pair: &PairPose| PairPose {
            left: self.pose(pair.left),
            right: self.pose(pair.right),
        };
        Scene {
            name: name.clone(),
            area: Area {
                min: area.min / l,
                max: area.max / l,
                resolution: area.resolution / l,
            },
            obstacles: obstacles.iter().map(|o| self.obstacle(o)).collect(),
            map: map.as_ref().map(|map| OccupancyMap {
                origin: self.pose(map.origin),
                resolution: map.resolution / l,
                ..map.clone()
            }),
            objects: objects.iter().map(|o| self.object(o)).collect(),
            start: pair(start),
            end: pair(end),
            robot: Robot {
                radius: robot.radius / l,
                hitch: robot.hitch / l,
                v_max: robot.v_max / self.speed(),
                omega_max: robot.omega_max * time,
                half_track: robot.half_track / l,
            },
            net: NetSpec {
                length: net.length.map(|length| length / l),
                start: net
                    .start
                    .as_ref()
                    .map(|points| points.iter().map(|&p| p / l).collect()),
            },
            planner: PlannerParameters {
                max_step: planner.max_step / l,
                clearance: planner.clearance / l,
                cruise: planner.cruise / self.speed(),
                half_separation: planner.half_separation / l,
                circle_margin: planner.circle_margin.map(|margin| margin / l),
                k2: planner.k2 / (l * l),
                t1: planner.t1 * l,
                kd2: planner.kd2 * (l * l),
                b1: planner.b1 * (l * l),
                b2: planner.b2 * (l * l),
                ..*planner
            },
            physics: PhysicsParameters {
                gravity: physics.gravity * time * time / l,
                robot_mass: physics.robot_mass / mass,
                robot_inertia: physics.robot_inertia / (mass * l * l),
                center_of_mass: physics.center_of_mass / l,
                wheel_radius: physics.wheel_radius / l,
                max_torque: physics.max_torque / self.torque(),
                net_mass: physics.net_mass * l / mass,
                net_link: physics.net_link / l,
                net_thickness: physics.net_thickness / l,
                net_height: physics.net_height / l,
                hinge_damping: physics.hinge_damping / (self.torque() * time),
                tension_limit: physics.tension_limit / self.force(),
                ..*physics
            },
        }
    }

    /// A pose given in m, expressed in these units.
    pub fn pose(&self, pose: Pose) -> Pose {
        Pose::at(pose.position() / self.length, pose.heading)
    }

    fn obstacle(&self, obstacle: &Obstacle) -> Obstacle {
        let scaled = |p: &Point| *p / self.length;
        match obstacle {
            Obstacle::Box { min, max } => Obstacle::Box {
                min: scaled(min),
                max: scaled(max),
            },
            Obstacle::Polygon(vertices) => Obstacle::Polygon(vertices.iter().map(scaled).collect()),
            Obstacle::Circle { center, radius } => Obstacle::Circle {
                center: scaled(center),
                radius: radius / self.length,
            },
        }
    }

    fn object(&self, object: &Object) -> Object {
        Object {
            position: object.position / self.length,
            footprint: match object.footprint {
                Footprint::Box(w, d) => Footprint::Box(w / self.length, d / self.length),
                Footprint::Disc(radius) => Footprint::Disc(radius / self.length),
            },
            mass: object.mass / self.mass,
        }
    }
}
