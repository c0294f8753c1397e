/// Violation and barrier function at a point.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Point {
    pub theta: f64,
    pub phi: f64,
}

/// The filter of a line search: pairs of violation and barrier function that no later iterate may be worse than in both.
#[derive(Clone, Debug, Default)]
pub(crate) struct Filter {
    entries: Vec<(f64, f64)>,
    least: f64,
    most: f64,
}

/// Entries for which there is room from the start, so that the iterations need not make it.
const ROOM: usize = 128;
const VIOLATION_DECREASE: f64 = 1e-5;
const BARRIER_DECREASE: f64 = 1e-5;
const ARMIJO: f64 = 1e-4;

impl Filter {
    pub fn clear(&mut self) {
        self.entries.clear();
        self.entries.reserve(ROOM);
        self.most = 0.0;
    }

    /// Whether a trial point is accepted; an accepted step that is not justified by the barrier function alone adds the
    /// point that it left to the filter.
    pub fn accepts(&mut self, from: Point, to: Point, alpha: f64, slope: f64) -> bool {
        if self.most == 0.0 {
            self.least = 1e-4 * from.theta.max(1.0);
            self.most = 1e4 * from.theta.max(1.0);
        }
        if !to.phi.is_finite() || to.theta > self.most {
            return false;
        }
        // Rounding of sums over thousands of rows.
        let noise = 1e-13 * from.phi.abs();
        if self
            .entries
            .iter()
            .any(|&(theta, phi)| to.theta >= theta && to.phi >= phi)
        {
            return false;
        }
        let switching = slope < 0.0
            && from.theta <= self.least
            && alpha * libm::pow(-slope, 2.3) > libm::pow(from.theta, 1.1);
        if switching {
            return to.phi <= from.phi + ARMIJO * alpha * slope + noise;
        }
        let accepted = to.theta <= (1.0 - VIOLATION_DECREASE) * from.theta
            || to.phi <= from.phi - BARRIER_DECREASE * from.theta + noise;
        if accepted {
            self.entries.push((
                (1.0 - VIOLATION_DECREASE) * from.theta,
                from.phi - BARRIER_DECREASE * from.theta,
            ));
        }
        accepted
    }
}
