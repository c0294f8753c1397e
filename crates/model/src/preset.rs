use crate::{Body, BodyCircle, PhysicsParameters, Robot};
use pairtrawl_geometry::Point;

/// A machine that is known by its name: what a scene does not say of it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Preset {
    /// The TurtleBot3 Waffle Pi, the paper's machine.
    WafflePi,
    /// The TurtleBot3 Burger.
    Burger,
}

impl Preset {
    /// All of them.
    pub const ALL: [Self; 2] = [Self::WafflePi, Self::Burger];

    /// The name in scene files.
    pub const fn name(self) -> &'static str {
        match self {
            Self::WafflePi => "waffle-pi",
            Self::Burger => "burger",
        }
    }

    /// The machine, with its body.
    pub fn robot(self) -> Robot {
        match self {
            // The base is a square of 0.266 m, its middle 0.064 m behind the axle; the wheels' outer corners lie within the
            // same circle.
            Self::WafflePi => Robot {
                body: Some(circle_behind(0.064, 0.19)),
                ..Robot::default()
            },
            // The base is a square of 0.14 m, its middle 0.032 m behind the axle; the wheels are 0.178 m apart outside.
            // The net is tied as far behind the base as with the Waffle Pi.
            Self::Burger => Robot {
                radius: 0.125,
                hitch: 0.112,
                v_max: 0.22,
                omega_max: 2.84,
                half_track: 0.08,
                body: Some(circle_behind(0.023, 0.106)),
            },
        }
    }

    /// Its masses, torques and frictions. Both tow the paper's net.
    pub fn physics(self) -> PhysicsParameters {
        match self {
            Self::WafflePi => PhysicsParameters::default(),
            Self::Burger => PhysicsParameters {
                robot_mass: 1.0,
                robot_inertia: 0.0026,
                center_of_mass: 0.0,
                wheel_radius: 0.033,
                max_torque: 1.5,
                ..PhysicsParameters::default()
            },
        }
    }
}

fn circle_behind(behind: f64, radius: f64) -> Body {
    Body::circle(BodyCircle {
        center: Point::new(-behind, 0.0),
        radius,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Corners of a robot's base and of its wheels, seen from above, m.
    fn corners(preset: Preset) -> Vec<Point> {
        let (half_base, behind) = match preset {
            Preset::WafflePi => (0.133, 0.064),
            Preset::Burger => (0.07, 0.032),
        };
        let outside = preset.robot().half_track + 0.009;
        let mut corners = Vec::new();
        for side in [-1.0, 1.0] {
            for end in [-1.0, 1.0] {
                corners.push(Point::new(end * half_base - behind, side * half_base));
                corners.push(Point::new(end * 0.033, side * outside));
            }
        }
        corners
    }

    #[test]
    fn bodies_contain_their_machines() {
        for preset in Preset::ALL {
            let robot = preset.robot();
            let circles = robot.circles();
            for corner in corners(preset) {
                let contains = |c: &BodyCircle| c.center.distance(corner) <= c.radius;
                assert!(
                    circles.circles().iter().any(contains),
                    "{preset:?} {corner:?}"
                );
                assert!(corner.norm() <= robot.radius, "{preset:?} {corner:?}");
            }
        }
    }
}
