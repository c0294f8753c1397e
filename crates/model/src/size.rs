use crate::scales::PAPER_RADIUS;
use crate::{ExpansionPer, PhysicsParameters, PlannerParameters, Robot, Units};
use std::f64::consts::SQRT_2;

/// Cruise speed over the greatest speed of a wheel, unless a scene gives it: 0.22 m/s of 0.26 m/s.
const CRUISE: f64 = 0.22;

/// How large a robot is against the paper's: the power of two that is nearest to the ratio of the radii. What a scene
/// leaves out follows from it, so all machines of about the paper's size (radius 0.17 m to 0.34 m) have the paper's values.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RobotSize {
    /// Times the paper's machine; a power of two.
    pub times: f64,
}

impl RobotSize {
    /// The size of a robot. It is 1 for a robot without a usable radius, which later checks refuse.
    pub fn of(robot: &Robot) -> Self {
        let ratio = robot.radius / PAPER_RADIUS;
        let mut times = 1.0;
        if ratio.is_finite() && ratio > 0.0 {
            while times * SQRT_2 < ratio {
                times *= 2.0;
            }
            while times > ratio * SQRT_2 {
                times *= 0.5;
            }
        }
        Self { times }
    }

    /// Units in which the paper's values are those of a robot of this size: lengths grow with it, masses with its cube,
    /// times with its root, so that gravity and friction stay what they are.
    fn units(self) -> Units {
        let times = self.times;
        Units {
            length: 1.0 / times,
            time: 1.0 / times.sqrt(),
            mass: 1.0 / (times * times * times),
        }
    }

    /// A length that is `paper` m for the paper's machine, m.
    pub fn length(self, paper: f64) -> f64 {
        paper * self.times
    }

    /// A mass that is `paper` kg for the paper's machine, kg.
    pub fn mass(self, paper: f64) -> f64 {
        paper * (self.times * self.times * self.times)
    }

    /// The planner's parameters when a scene gives none: lengths grow with the size, gains of the cost with the power that
    /// their unit asks for; the cruise speed follows from the greatest speed of the robot.
    pub fn planner(self, robot: &Robot) -> PlannerParameters {
        PlannerParameters {
            cruise: CRUISE * (robot.v_max / Robot::default().v_max),
            ..self.units().planner(&PlannerParameters::default())
        }
    }

    /// Weight of the expansion cost of one waypoint: a4, per meter in proportion to `max_step`, as much as in the paper's setup
    /// where that is 0.05 m (for machines of the paper's size).
    pub fn expansion_weight(self, planner: &PlannerParameters) -> f64 {
        match planner.expansion_per {
            ExpansionPer::Waypoint => planner.a4,
            ExpansionPer::Meter => {
                let paper = self.length(PlannerParameters::default().max_step);
                planner.a4 * planner.max_step / paper
            }
        }
    }

    /// Masses, frictions and torques when a scene gives none. Gravity and frictions stay.
    pub fn physics(self) -> PhysicsParameters {
        let paper = PhysicsParameters::default();
        PhysicsParameters {
            gravity: paper.gravity,
            ..self.units().physics(&paper)
        }
    }
}
