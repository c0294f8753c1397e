//! Readings of the paper's planning problem.

use crate::lab::Stopped;
use pairtrawl::geometry::Pose;
use pairtrawl::model::{ExpansionPer, Footprint, Object, Scene};
use pairtrawl::world::World;

/// gamma in the authors' data, m.
const AUTHORS_GAMMA: f64 = 0.4;
/// kd1 and kd2 by the balance of forces in the authors' data.
const BALANCED_GAINS: [f64; 2] = [10.0, 100.0];

/// A reading of the paper's problem.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reading {
    /// dL_max, m.
    pub max_step: f64,
    /// gamma is 0.4 m, clusters are merged.
    pub wide_circles: bool,
    /// Robots drive abreast and keep clearance.
    pub abreast: bool,
    /// The ends are the last rows of the authors' files, which are overshoot, not their last knots.
    pub overshoot: bool,
    /// kd1 and kd2 by the balance of forces instead of those printed.
    pub balanced: bool,
    /// J_e is summed per meter.
    pub per_meter: bool,
    /// Nearly the problem in x and y alone: headings turn by up to 0.6 rad in a step at a tenth of the printed cost, and the
    /// net is tied to the axles.
    pub literal: bool,
}

impl Reading {
    /// Ours.
    pub const OURS: Self = Self {
        max_step: 0.05,
        wide_circles: false,
        abreast: true,
        overshoot: false,
        balanced: false,
        per_meter: false,
        literal: false,
    };

    /// The scene under this reading.
    ///
    /// # Errors
    /// When circles cannot be made of its objects.
    pub fn scene(&self, scene: &Scene) -> Result<Scene, Stopped> {
        let mut scene = scene.clone();
        let p = &mut scene.planner;
        p.max_step = self.max_step;
        if !self.abreast {
            p.max_skew = std::f64::consts::FRAC_PI_2;
            p.clearance = 0.0;
        }
        if self.balanced {
            [p.kd1, p.kd2] = BALANCED_GAINS;
        }
        if self.per_meter {
            p.expansion_per = ExpansionPer::Meter;
        }
        if self.overshoot {
            (scene.end.left, scene.end.right) = overshoot(&scene);
        }
        if self.wide_circles {
            widen(&mut scene)?;
        }
        Ok(scene)
    }

    /// The scene to optimize in: in the literal reading headings cost nothing and turn freely.
    pub(crate) fn problem(&self, scene: &Scene) -> Scene {
        let mut scene = scene.clone();
        if self.literal {
            // Enough to go anywhere in steps of 0.2 m; a heading that costs nothing is undetermined where a robot stands.
            scene.planner.max_turn = 0.6;
            scene.planner.t2 = 1.0;
            scene.robot.hitch = 0.0;
        }
        scene
    }
}

/// The last rows of the authors' files, where our scenes used to end.
fn overshoot(scene: &Scene) -> (Pose, Pose) {
    match scene.objects.len() {
        8 => (
            Pose::new(6.5732, 2.2497, 0.0),
            Pose::new(6.5519, 1.7115, 0.0),
        ),
        _ => (
            Pose::new(14.321, 0.328_37, -1.8045),
            Pose::new(13.703, 0.475_47, -1.8045),
        ),
    }
}

/// Objects become their circles with gamma as in the authors' data, those that overlap closely merged: robots keep out of
/// them, and the line between the robots passes over their centers.
fn widen(scene: &mut Scene) -> Result<(), Stopped> {
    let mut wide = scene.clone();
    wide.planner.circle_margin = Some(AUTHORS_GAMMA);
    let world = World::new(&wide, None).map_err(|error| Stopped::failed(&scene.name, error))?;
    let radius = scene.robot.radius;
    let object = |circle: &pairtrawl::model::Circle| Object {
        position: circle.center,
        footprint: Footprint::Disc((circle.radius - radius).max(1e-3)),
        mass: 0.025,
        leave: false,
    };
    scene.objects = world.circles.iter().map(object).collect();
    Ok(())
}
