use crate::{Circle, PairPose, PairTrajectory, Robot, Scene, Units};
use pairtrawl_geometry::{Point, Pose};

/// The scale of a scene: the planner works in units of it, so that it sees every machine as one of the paper's size.
///
/// Planning has no length of its own: multiply all lengths of a scene by the same factor (and the gains of the cost by
/// the powers of it that their units ask for) and the plan is multiplied as well. So constants inside the planner are
/// lengths in units of [`Scales::length`], which is 1 m for the default machine.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scales {
    /// The unit of length, m: the robot radius over that of the paper's machine, 0.24 m.
    pub length: f64,
}

/// Radius of the machine whose unit of length is 1 m, m.
pub(crate) const PAPER_RADIUS: f64 = 0.24;

impl Scales {
    /// The scale of a scene.
    pub fn of(scene: &Scene) -> Self {
        Self::of_robot(&scene.robot)
    }

    /// The scale of a robot. It is 1 for one without a usable radius, which later checks refuse.
    pub fn of_robot(robot: &Robot) -> Self {
        let radius = robot.radius;
        let usable = radius.is_finite() && radius > 0.0;
        Self {
            length: if usable { radius / PAPER_RADIUS } else { 1.0 },
        }
    }

    /// The scene in units of the length scale: lengths, and whatever else has a length in its unit, gains of the cost
    /// included. Angles, ratios, masses and times stay.
    pub fn scene(&self, scene: &Scene) -> Scene {
        self.units().scene(scene)
    }

    /// A length in m in units of the length scale.
    pub fn scaled(&self, meters: f64) -> f64 {
        self.units().tidy(meters / self.length)
    }

    /// A trajectory in m in units of the length scale.
    pub fn scaled_trajectory(&self, trajectory: &PairTrajectory) -> PairTrajectory {
        trajectory.map(|pose| self.units().pose(pose))
    }

    fn units(&self) -> Units {
        Units {
            length: self.length,
            ..Units::SI
        }
    }

    /// A length in units of the length scale in m.
    pub fn meters(&self, length: f64) -> f64 {
        length * self.length
    }

    /// A place in units of the length scale in m.
    pub fn place(&self, place: Point) -> Point {
        self.units().place_in_si(place)
    }

    /// A pose in units of the length scale in m.
    pub fn pose(&self, pose: Pose) -> Pose {
        self.units().pose_in_si(pose)
    }

    /// A circle in units of the length scale in m.
    pub fn circle(&self, circle: &Circle) -> Circle {
        Circle {
            center: self.place(circle.center),
            radius: self.meters(circle.radius),
            objects: circle.objects.clone(),
        }
    }

    /// A trajectory in units of the length scale in m. Where it begins or ends at the scaled scene's pose, it gets the
    /// pose of `scene`, the scene in m, itself: nothing is lost by scaling there and back.
    pub fn trajectory(&self, scene: &Scene, trajectory: &PairTrajectory) -> PairTrajectory {
        let mut back = trajectory.map(|pose| self.pose(pose));
        let Some(last) = back.len().checked_sub(1) else {
            return back;
        };
        for (i, ends) in [(0, scene.start), (last, scene.end)] {
            let PairPose { left, right } = ends;
            for (end, scaled, pose) in [
                (left, trajectory.left.get(i), back.left.get_mut(i)),
                (right, trajectory.right.get(i), back.right.get_mut(i)),
            ] {
                if let (Some(scaled), Some(pose)) = (scaled, pose)
                    && scaled.position() == self.units().pose(end).position()
                {
                    *pose = Pose::at(end.position(), scaled.heading);
                }
            }
        }
        back
    }
}

/// Gravity that the unit of time of a machine is made for, m/s^2.
const EARTH_GRAVITY: f64 = 9.81;

impl Units {
    /// Units in which a machine looks like the paper's: lengths in units of the length scale, times such that gravity is
    /// what it is on Earth, masses in proportion to the volume. SI units for the default machine.
    pub fn of_machine(scene: &Scene) -> Self {
        let length = Scales::of(scene).length;
        Self {
            length,
            time: (length * EARTH_GRAVITY / scene.physics.gravity).sqrt(),
            mass: length * length * length,
        }
    }
}
