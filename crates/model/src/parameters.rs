use crate::{ExpansionPer, Leave};
use std::f64::consts::FRAC_2_PI;

/// The planner's parameters (`[planner]` of a scene). Defaults are the paper's where it gives one.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(
    feature = "schema",
    derive(schemars::JsonSchema),
    schemars(default, deny_unknown_fields)
)]
pub struct PlannerParameters {
    /// Delta L_max: greatest distance a robot moves in a step, m.
    pub max_step: f64,
    /// Delta phi_max: greatest heading change in a step, rad.
    pub max_turn: f64,
    /// Greatest angle between a heading and the normal of the line between the robots, rad.
    pub max_skew: f64,
    /// Margin kept beyond the robot radius from obstacles and objects, m. Not a claim: it shrinks where there is no room.
    pub clearance: f64,
    /// Cruise speed that `step_time` is computed for, m/s.
    pub cruise: f64,
    /// l of eq. 1: half the separation of the baseline pair away from circles, m.
    pub half_separation: f64,
    /// gamma: margin of an object's circle beyond its minimum bounding circle, m, for order, centerline and baseline; `None`:
    /// the robot radius, of a body half its width. Constraints and J_obs keep to the robot's circles.
    pub circle_margin: Option<f64>,
    /// N: waypoints of the plan; `None`: from the length of the baseline.
    pub waypoints: Option<usize>,
    /// N_total of Algorithm 1: rounds of the alternating method.
    pub alternations: usize,
    /// d_min / d_max.
    pub min_ratio: f64,
    /// d_rest / d_max.
    pub rest_ratio: f64,
    /// K1: cost of a waypoint inside an obstacle.
    pub k1: f64,
    /// K2: gain of the objects' potential.
    pub k2: f64,
    /// K3: cost of a separation outside [d_min, d_max].
    pub k3: f64,
    /// t1: cost of driven distance, 1/m.
    pub t1: f64,
    /// t2: cost of turning, 1/rad.
    pub t2: f64,
    /// kd1: gain of the expansion cost below d_rest.
    pub kd1: f64,
    /// kd2: gain of the expansion cost above d_rest, 1/m^2.
    pub kd2: f64,
    /// b1: smoothness gain of x, 1/m^2.
    pub b1: f64,
    /// b2: smoothness gain of y, 1/m^2.
    pub b2: f64,
    /// b3: smoothness gain of the heading, 1/rad^2.
    pub b3: f64,
    /// a1: weight of the smoothness cost.
    pub a1: f64,
    /// a2: weight of the distance cost.
    pub a2: f64,
    /// a3: weight of the obstacle cost.
    pub a3: f64,
    /// a4: weight of the expansion cost.
    pub a4: f64,
    /// What the expansion cost is summed over.
    #[cfg_attr(
        feature = "serde",
        serde(skip_serializing_if = "ExpansionPer::is_waypoint")
    )]
    pub expansion_per: ExpansionPer,
    /// What is done with objects that cannot be gathered.
    #[cfg_attr(feature = "serde", serde(skip_serializing_if = "Leave::is_none"))]
    pub leave: Leave,
}

impl Default for PlannerParameters {
    fn default() -> Self {
        Self {
            max_step: 0.05,
            max_turn: 0.1,
            max_skew: 1.0,
            clearance: 0.05,
            cruise: 0.22,
            half_separation: 0.3,
            circle_margin: None,
            waypoints: None,
            alternations: 8,
            min_ratio: 0.1,
            rest_ratio: FRAC_2_PI,
            k1: 1e7,
            k2: 1e7,
            k3: 1e7,
            t1: 300.0,
            t2: 10.0,
            kd1: 20.0,
            kd2: 15.0,
            b1: 110.0,
            b2: 110.0,
            b3: 1.0,
            a1: 1.0,
            a2: 1.0,
            a3: 1.0,
            a4: 1.0,
            expansion_per: ExpansionPer::Waypoint,
            leave: Leave::None,
        }
    }
}
