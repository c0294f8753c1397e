use crate::limits::COORDINATE_LIMIT;
use crate::motion::{Reading, Stretch};
use crate::obstacles::Obstacles;
use crate::tightest::Tightest;
use pairtrawl_geometry::Pose;
use pairtrawl_model::{Body, BodyCircle, PairTrajectory, Scene, Side};
use pairtrawl_reference::Reference;

/// What is judged: at least two waypoints per robot, equally many, all finite and within bounds.
pub(crate) struct Subject<'a> {
    pub(crate) scene: &'a Scene,
    pub(crate) net_length: f64,
    pub(crate) trajectory: &'a PairTrajectory,
    /// The circles that contain a robot.
    pub(crate) body: Body,
    /// How the motion is read, each with its steps: linear first, then the smooth curve when there is one.
    pub(crate) readings: Vec<(Reading<'a>, Vec<Stretch>)>,
    /// `Err` says what is malformed.
    pub(crate) obstacles: Result<Obstacles<'a>, String>,
}

impl<'a> Subject<'a> {
    /// Checks what every claim relies on; the error stands for all claims.
    pub(crate) fn new(
        scene: &'a Scene,
        net_length: f64,
        trajectory: &'a PairTrajectory,
        reference: Option<&'a Reference>,
    ) -> Result<Self, Tightest> {
        let (left, right) = (&trajectory.left, &trajectory.right);
        if left.len() != right.len() {
            let reason = format!(
                "the trajectories have {} and {} waypoints: they must have equally many",
                left.len(),
                right.len()
            );
            return Err(Tightest::unusable(None, reason));
        }
        if left.len() < 2 {
            let reason = format!(
                "the trajectories have {} waypoints: at least 2 are needed",
                left.len()
            );
            return Err(Tightest::unusable(None, reason));
        }
        for (side, poses) in [(Side::Left, left), (Side::Right, right)] {
            if let Some(i) = poses.iter().position(|p| !is_usable(p)) {
                let Pose { x, y, heading } = poses[i];
                let reason = format!(
                    "the {side}'s pose [{x}, {y}, {heading}] at waypoint {i} is not finite and within {COORDINATE_LIMIT:e}"
                );
                return Err(Tightest::unusable(Some(i), reason));
            }
        }
        if let Some(curve) = reference.filter(|curve| curve.waypoints() != left.len()) {
            let reason = format!(
                "the reference has {} waypoints, the trajectories have {}: it is another plan's",
                curve.waypoints(),
                left.len()
            );
            return Err(Tightest::unusable(None, reason));
        }
        let robot = &scene.robot;
        if !(robot.radius.is_finite() && robot.radius > 0.0 && robot.hitch.is_finite()) {
            let reason = format!(
                "the robot's radius {} m must be positive and finite, its hitch {} m finite",
                robot.radius, robot.hitch
            );
            return Err(Tightest::unusable(None, reason));
        }
        let body = robot.circles();
        let malformed = |c: &BodyCircle| {
            let finite = c.center.is_finite() && c.radius.is_finite();
            !(finite && c.radius > 0.0 && c.offset() <= COORDINATE_LIMIT)
        };
        if let Some(i) = body.circles().iter().position(malformed) {
            let BodyCircle { center, radius } = body.circles()[i];
            let reason = format!(
                "circle {i} of the robot's body, at ({}, {}) with radius {radius} m, must be finite and its radius positive",
                center.x, center.y
            );
            return Err(Tightest::unusable(None, reason));
        }
        Ok(Self {
            scene,
            net_length,
            trajectory,
            body,
            readings: std::iter::once(Reading::Linear(trajectory))
                .chain(reference.map(Reading::Smooth))
                .map(|reading| (reading, reading.steps()))
                .collect(),
            obstacles: Obstacles::new(scene),
        })
    }

    /// Number of steps N - 1.
    pub(crate) fn steps(&self) -> usize {
        self.trajectory.len() - 1
    }

    /// True when the plan is driven along its reference.
    pub(crate) fn is_driven(&self) -> bool {
        self.readings.len() > 1
    }

    /// Both robots with every circle of their bodies, and what to call it.
    pub(crate) fn circles(&self) -> impl Iterator<Item = (Side, BodyCircle, String)> + '_ {
        let with_body = self.scene.robot.body.is_some();
        let circles = |side: Side| {
            self.body
                .circles()
                .iter()
                .enumerate()
                .map(move |c| (side, c))
        };
        Side::BOTH
            .into_iter()
            .flat_map(circles)
            .map(move |(side, (i, circle))| {
                let name = if with_body {
                    format!("circle {i} of the {side}'s body")
                } else {
                    side.to_string()
                };
                (side, *circle, name)
            })
    }

    /// Both robots with their poses.
    fn robots(&self) -> [(Side, &'a [Pose]); 2] {
        [
            (Side::Left, &self.trajectory.left),
            (Side::Right, &self.trajectory.right),
        ]
    }

    /// Each step of each robot: which robot, the index, the poses before and after.
    pub(crate) fn robot_steps(&self) -> impl Iterator<Item = (Side, usize, Pose, Pose)> + 'a {
        self.robots().into_iter().flat_map(|(side, poses)| {
            poses
                .windows(2)
                .enumerate()
                .map(move |(i, w)| (side, i, w[0], w[1]))
        })
    }
}

fn is_usable(pose: &Pose) -> bool {
    [pose.x, pose.y, pose.heading]
        .iter()
        .all(|v| v.abs() <= COORDINATE_LIMIT)
}
