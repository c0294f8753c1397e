/// The paper's J on a pair of trajectories, term by term, each with its weight a1..a4 applied.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Cost {
    /// a1 J_s: second differences of x, y and heading, both robots.
    pub smoothness: f64,
    /// a2 J_dist: t1 times driven distance plus t2 times turning, both robots.
    pub distance: f64,
    /// a3 J_obs: 0 on a valid plan.
    pub obstacle: f64,
    /// a4 J_e: expansion of the net, summed over the waypoints, counted once.
    pub expansion: f64,
}

impl Cost {
    /// J_total.
    pub fn total(&self) -> f64 {
        self.smoothness + self.distance + self.obstacle + self.expansion
    }
}
