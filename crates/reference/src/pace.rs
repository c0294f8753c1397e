use crate::ReferenceLimits;
use crate::step::StepBounds;
use pairtrawl_model::{PlannerParameters, Robot, default_step_time};

/// This part of the greatest acceleration is for changes of the pace (starts and stops), the rest for the curve's own.
const FOR_PACE: f64 = 2.0 / 7.0;
/// No step takes less than this part of the plan's default step time, not even one in which both robots wait.
const LEAST_TIME: f64 = 0.01;

/// How fast the pair may move through a stretch of its plan.
#[derive(Clone, Copy, Debug)]
pub(crate) struct PaceLimit {
    /// Greatest r^2, 1/s^2.
    pub square: f64,
    /// Greatest magnitude of d(r^2)/du, 1/s^2.
    pub slope: f64,
}

/// What the pace must respect: with speed s and turning rate p a step, and u'' = (r^2)'/2,
/// v = s r, v' = s' r^2 + s u'', omega = p r, omega' = p' r^2 + p u''.
pub(crate) struct PaceRules {
    cruise: f64,
    turning: f64,
    wheel: f64,
    half_track: f64,
    limits: ReferenceLimits,
    fastest: f64,
}

impl PaceRules {
    pub fn new(robot: &Robot, planner: &PlannerParameters, limits: &ReferenceLimits) -> Self {
        let turning = planner.cruise * planner.max_turn / planner.max_step;
        Self {
            cruise: planner.cruise,
            turning: turning.min(robot.omega_max),
            wheel: robot.v_max,
            half_track: robot.half_track,
            limits: *limits,
            fastest: 1.0 / (LEAST_TIME * default_step_time(robot, planner)),
        }
    }

    /// The limit on a stretch on which both robots keep to these bounds.
    pub fn limit(&self, robots: [StepBounds; 2]) -> PaceLimit {
        let mut limit = PaceLimit {
            square: self.fastest * self.fastest,
            slope: f64::INFINITY,
        };
        let (linear, angular) = (self.limits.linear, self.limits.angular);
        for bounds in robots {
            let (s, p) = (bounds.fastest(), bounds.sharpest());
            let pace = (self.cruise / s)
                .min(self.turning / p)
                .min(self.wheel / (s + self.half_track * p));
            let curve = (linear / bounds.speed_slope).min(angular / bounds.rate_slope);
            let change = (linear / s).min(angular / p);
            limit.square = limit.square.min(pace * pace).min((1.0 - FOR_PACE) * curve);
            limit.slope = limit.slope.min(2.0 * FOR_PACE * change);
        }
        limit
    }
}
