//! Topics of a recording, with their message definitions.

/// What a topic carries.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Topic {
    pub name: &'static str,
    pub message: &'static str,
    pub definition: &'static str,
    /// True when a late listener should get the last message: plans and the map, which are sent once.
    pub latched: bool,
}

const PATH: (&str, &str) = ("nav_msgs/msg/Path", include_str!("schemas/Path.msg"));
const ODOMETRY: (&str, &str) = (
    "nav_msgs/msg/Odometry",
    include_str!("schemas/Odometry.msg"),
);
const ARRAY: (&str, &str) = (
    "std_msgs/msg/Float64MultiArray",
    include_str!("schemas/Float64MultiArray.msg"),
);
const TF: (&str, &str) = (
    "tf2_msgs/msg/TFMessage",
    include_str!("schemas/TFMessage.msg"),
);
const GRID: (&str, &str) = (
    "nav_msgs/msg/OccupancyGrid",
    include_str!("schemas/OccupancyGrid.msg"),
);
const MARKERS: (&str, &str) = (
    "visualization_msgs/msg/MarkerArray",
    include_str!("schemas/MarkerArray.msg"),
);

const fn topic(
    name: &'static str,
    (message, definition): (&'static str, &'static str),
    latched: bool,
) -> Topic {
    Topic {
        name,
        message,
        definition,
        latched,
    }
}

/// Plans of the (left, right) robot.
pub(super) const PLAN: [Topic; 2] = [
    topic("/left/plan", PATH, true),
    topic("/right/plan", PATH, true),
];
/// Poses and velocities of the (left, right) robot.
pub(super) const ODOM: [Topic; 2] = [
    topic("/left/odom", ODOMETRY, false),
    topic("/right/odom", ODOMETRY, false),
];
/// Wheel torques (left, right) of the (left, right) robot, N m.
pub(super) const TORQUE: [Topic; 2] = [
    topic("/left/torque", ARRAY, false),
    topic("/right/torque", ARRAY, false),
];
/// Frames.
pub(super) const FRAMES: Topic = topic("/tf", TF, false);
/// The occupancy grid.
pub(super) const MAP: Topic = topic("/map", GRID, true);
/// Net and objects.
pub(super) const WORLD: Topic = topic("/markers", MARKERS, false);

/// All topics, in the order of their channels.
pub(super) const ALL: [Topic; 9] = [
    PLAN[0], PLAN[1], ODOM[0], ODOM[1], TORQUE[0], TORQUE[1], FRAMES, MAP, WORLD,
];

/// The quality of service of a latched topic as rosbag2 writes it: reliable, transient local, no deadline.
pub(super) const LATCHED_QOS: &str = "- history: 1\n  depth: 1\n  reliability: 1\n  durability: 1\n  \
deadline:\n    sec: 9223372036\n    nsec: 854775807\n  lifespan:\n    sec: 9223372036\n    nsec: 854775807\n  \
liveliness: 1\n  liveliness_lease_duration:\n    sec: 9223372036\n    nsec: 854775807\n  \
avoid_ros_namespace_conventions: false\n";

impl Topic {
    /// Its `offered_qos_profiles`; empty stands for the default.
    pub fn qos(&self) -> &'static str {
        if self.latched { LATCHED_QOS } else { "" }
    }
}
