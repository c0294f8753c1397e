use crate::{Options, SimulationError};
use pairtrawl_geometry::Point;
use pairtrawl_model::{BodyCircle, Footprint, PhysicsParameters, Robot, Scene, Units};

/// Side of the TurtleBot3 Waffle Pi's square base, m.
const BASE_SIDE: f64 = 0.266;
/// How far its center lies behind the axle, m.
const BASE_OFFSET: f64 = 0.064;
/// Radius of the circle around the axle center that the scenes give this robot, m.
const BASE_RADIUS: f64 = 0.24;

/// Everything that stays constant during a simulation, in SI units or, inside of it, in units of the machine.
#[derive(Clone, Debug, PartialEq)]
pub struct Parameters {
    /// Masses and frictions.
    pub physics: PhysicsParameters,
    /// The robot's limits and hitch.
    pub robot: Robot,
    /// The robot's box.
    pub base: Base,
    /// Number of links n.
    pub links: usize,
    /// Length of a link, m.
    pub link_length: f64,
    /// Mass of a link, kg.
    pub link_mass: f64,
    /// Time step, s.
    pub time_step: f64,
}

/// The outline of a robot without a body: a square in the body frame (x forward, origin on the axle).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Base {
    /// Half of its side, m.
    pub half_side: f64,
    /// Its center lies this far behind the axle, m.
    pub behind_axle: f64,
}

impl Parameters {
    /// Derives them from a scene. Robots of another radius get the same base, scaled.
    ///
    /// # Errors
    /// When a mass, a friction, a length or an option is out of range.
    pub fn new(scene: &Scene, net_length: f64, options: &Options) -> Result<Self, SimulationError> {
        options.in_units(&Units::of_machine(scene)).validate()?;
        let physics = scene.physics;
        let positive = [
            ("net length", net_length),
            ("physics.net_link", physics.net_link),
            ("physics.net_thickness", physics.net_thickness),
            ("physics.net_height", physics.net_height),
            ("physics.net_mass", physics.net_mass),
            ("physics.robot_mass", physics.robot_mass),
            ("physics.robot_inertia", physics.robot_inertia),
            ("physics.wheel_radius", physics.wheel_radius),
            ("physics.wheel_friction", physics.wheel_friction),
            ("physics.max_torque", physics.max_torque),
            ("physics.tension_limit", physics.tension_limit),
            ("physics.gravity", physics.gravity),
            ("robot.radius", scene.robot.radius),
            ("robot.half_track", scene.robot.half_track),
        ];
        for (name, value) in positive {
            require(name, value, value > 0.0, "positive and finite")?;
        }
        let not_negative = [
            ("physics.net_friction", physics.net_friction),
            ("physics.object_friction", physics.object_friction),
            ("physics.contact_friction", physics.contact_friction),
            ("physics.hinge_damping", physics.hinge_damping),
            ("robot.hitch", scene.robot.hitch),
        ];
        for (name, value) in not_negative {
            require(name, value, value >= 0.0, "zero or positive, and finite")?;
        }
        require(
            "physics.center_of_mass",
            physics.center_of_mass,
            true,
            "finite",
        )?;
        for (i, object) in scene.objects.iter().enumerate() {
            let size = match object.footprint {
                Footprint::Box(w, d) => w.min(d),
                Footprint::Disc(r) => r,
            };
            require(
                &format!("mass of object {i}"),
                object.mass,
                object.mass > 0.0,
                "positive and finite",
            )?;
            require(
                &format!("size of object {i}"),
                size,
                size > 0.0,
                "positive and finite",
            )?;
        }
        let links = (net_length / physics.net_link).round().max(1.0);
        require(
            "net length / physics.net_link",
            links,
            links <= 1000.0,
            "at most 1000 links",
        )?;
        let scale = scene.robot.radius / BASE_RADIUS;
        Ok(Self {
            physics,
            robot: scene.robot,
            base: Base {
                half_side: 0.5 * BASE_SIDE * scale,
                behind_axle: BASE_OFFSET * scale,
            },
            links: links as usize,
            link_length: net_length / links,
            link_mass: physics.net_mass * net_length / links,
            time_step: options.time_step,
        })
    }

    /// What a robot touches with: the circles of its body, or its base. Centers in the robot's frame (x forward, origin on the
    /// axle), m, and footprints.
    pub fn outline(&self) -> Vec<(Point, Footprint)> {
        let Some(body) = self.robot.body else {
            let side = 2.0 * self.base.half_side;
            let center = Point::new(-self.base.behind_axle, 0.0);
            return vec![(center, Footprint::Box(side, side))];
        };
        let disc = |c: &BodyCircle| (c.center, Footprint::Disc(c.radius));
        body.circles().iter().map(disc).collect()
    }

    /// How many links at each end of the net lie within the robot's body when the net trails behind it, because the hitch is
    /// that deep inside: the circles of a body contain more than the machine, and the net is tied outside of it. They do not
    /// touch robots.
    pub fn links_within_body(&self) -> usize {
        let hitch = Point::new(-self.robot.hitch, 0.0);
        let depth = |c: &BodyCircle| c.radius - c.center.distance(hitch);
        let body = self.robot.body.iter().flat_map(|body| body.circles());
        let deepest = body.map(depth).fold(0.0, f64::max);
        ((deepest / self.link_length).ceil() as usize).min(self.links)
    }

    /// Tells whether a link of the net, counted from the left, is one of [`Self::links_within_body`] at either end.
    pub fn is_within_body(&self) -> impl Fn(usize) -> bool + use<> {
        let (within, links) = (self.links_within_body(), self.links);
        move |link| link < within || link + within >= links
    }

    /// Greatest force that the tires of one robot can pass to the floor in one direction: mu m g, N.
    pub fn traction(&self) -> f64 {
        self.physics.wheel_friction * self.physics.robot_mass * self.physics.gravity
    }
}

fn require(
    name: &str,
    value: f64,
    holds: bool,
    requirement: &'static str,
) -> Result<(), SimulationError> {
    if holds && value.is_finite() {
        Ok(())
    } else {
        Err(SimulationError::Parameter {
            name: name.to_owned(),
            value,
            requirement,
        })
    }
}
