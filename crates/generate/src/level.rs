/// What a difficulty from 1 to 10 means, in meters and radians.
#[derive(Clone, Debug)]
pub(crate) struct Level {
    /// 0 at difficulty 1, 1 at difficulty 10.
    pub(crate) fraction: f64,
    /// The tight obstacles stand at most this far outside the robots' circles.
    pub(crate) obstacle_margin: f64,
    /// The tight objects lie at most this far beyond the miss distance.
    pub(crate) object_margin: f64,
    /// Least and greatest separation of the robots.
    pub(crate) separation: (f64, f64),
    /// Least and greatest angle of a bend.
    pub(crate) bend: (f64, f64),
    /// Greatest curvature of the centerline times half the separation: 1 would be a turn on the inner robot.
    pub(crate) inner: f64,
    /// Net length over the greatest distance that the witness needs.
    pub(crate) net_slack: f64,
    /// Objects per meter of centerline.
    pub(crate) objects_per_meter: f64,
    /// Tight obstacles per meter of centerline.
    pub(crate) obstacles_per_meter: f64,
    /// Share of the objects that lie at the tight margin.
    pub(crate) tight_objects: f64,
}

/// Footprint radius of the 5 cm cubes, m.
pub(crate) const CUBE_RADIUS: f64 = 0.0354;
/// Robot radius that the scale was made for (the default robot's), m.
const ROBOT_RADIUS: f64 = 0.24;

impl Level {
    pub(crate) fn new(difficulty: u8) -> Self {
        let fraction = (f64::from(difficulty) - 1.0) / 9.0;
        let linear = |easy: f64, hard: f64| easy + (hard - easy) * fraction;
        let geometric = |easy: f64, hard: f64| easy * libm::pow(hard / easy, fraction);
        let object_margin = geometric(0.12, 0.005);
        // The narrowest place still lets an object through at the tight margin on both sides.
        let narrowest = 2.0 * (ROBOT_RADIUS + CUBE_RADIUS + object_margin) + 0.003;
        Self {
            fraction,
            obstacle_margin: geometric(0.5, 0.02),
            object_margin,
            separation: (narrowest, linear(1.1, 0.95)),
            bend: (linear(0.15, 0.8), linear(0.6, 2.1)),
            inner: linear(0.35, 0.72),
            net_slack: linear(1.57, 1.12),
            objects_per_meter: linear(0.4, 1.3),
            obstacles_per_meter: linear(0.4, 1.6),
            tight_objects: linear(0.1, 0.6),
        }
    }
}
