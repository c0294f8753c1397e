use pairtrawl_model::Side;
use thiserror::Error;

/// Why a simulation cannot be set up.
#[derive(Clone, Debug, PartialEq, Error)]
pub enum SimulationError {
    /// An option is out of its range.
    #[error(
        "simulation option {name} is {value}, must lie in [{low}, {high}]: choose a value inside"
    )]
    Option {
        /// Its name.
        name: &'static str,
        /// Its value.
        value: f64,
        /// Least value.
        low: f64,
        /// Greatest value.
        high: f64,
    },
    /// A physical quantity of the scene is not usable.
    #[error("{name} is {value}, must be {requirement}: correct it in the scene")]
    Parameter {
        /// Its name in the scene.
        name: String,
        /// Its value.
        value: f64,
        /// What it must be.
        requirement: &'static str,
    },
    /// The hitches stand farther apart than the net is long.
    #[error(
        "the hitches are {gap:.4} m apart at the start but the net is {length:.4} m long: use a net of at least {gap:.4} m"
    )]
    NetTooShort {
        /// Distance of the hitch points, m.
        gap: f64,
        /// Net length, m.
        length: f64,
    },
    /// The net's given start shape does not run from hitch to hitch.
    #[error(
        "net.start ends {distance:.3} m from the hitch of the {side} at ({x:.3}, {y:.3}): it must run from the left hitch to the right one"
    )]
    NetStart {
        /// Whose hitch.
        side: Side,
        /// How far off it is, m.
        distance: f64,
        /// Where the hitch is, m.
        x: f64,
        /// Where the hitch is, m.
        y: f64,
    },
    /// A polygon obstacle has no interior or crosses itself.
    #[error(
        "obstacle {index} is not a simple polygon with an interior: give its vertices in order, without crossings"
    )]
    Polygon {
        /// Index in `scene.obstacles`.
        index: usize,
    },
    /// The trajectory cannot be driven.
    #[error(
        "the trajectory has {left} and {right} waypoints and a step time of {step_time} s: both need the same number, at least 2, all finite, and a positive step time"
    )]
    Trajectory {
        /// Waypoints of the left robot.
        left: usize,
        /// Waypoints of the right robot.
        right: usize,
        /// Step time, s.
        step_time: f64,
    },
    /// Numbers left the finite range: the physics broke down.
    #[error("the physics broke down at {time:.3} s: use a smaller time step")]
    Diverged {
        /// When, s.
        time: f64,
    },
}
