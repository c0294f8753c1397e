use crate::pace::PaceLimit;

/// One time law for both robots: how fast the pair moves through the steps of its plan.
///
/// The step number u grows by r a second; r is 0 at both ends, and r^2 is linear in u between nodes at every half step, so
/// each stretch has a constant d2u/dt2.
#[derive(Clone, Debug)]
pub(crate) struct Clock {
    /// r at each node, 1/s.
    paces: Vec<f64>,
    /// When the pair passes each node, s.
    times: Vec<f64>,
}

/// Where the pair is on its way.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Progress {
    /// u: steps done, with the fraction of the one under way.
    pub steps: f64,
    /// r = du/dt, 1/s.
    pub pace: f64,
    /// dr/dt, 1/s^2.
    pub pace_rate: f64,
}

/// Between two nodes u grows by this.
const HALF: f64 = 0.5;

impl Clock {
    /// The fastest time law within limits; `limits[k]` holds on the stretch between nodes k and k + 1.
    pub fn new(limits: &[PaceLimit]) -> Self {
        let count = limits.len() + 1;
        let mut squares = vec![0.0; count];
        for k in 1..limits.len() {
            let cap = limits[k - 1].square.min(limits[k].square);
            squares[k] = cap.min(squares[k - 1] + limits[k - 1].slope * HALF);
        }
        for k in (1..limits.len()).rev() {
            squares[k] = squares[k].min(squares[k + 1] + limits[k].slope * HALF);
        }
        let paces: Vec<f64> = squares.iter().map(|s: &f64| s.sqrt()).collect();
        let mut times = vec![0.0];
        for k in 1..count {
            times.push(times[k - 1] + 2.0 * HALF / (paces[k - 1] + paces[k]));
        }
        Self { paces, times }
    }

    /// Time from the first waypoint to the last, s.
    pub fn duration(&self) -> f64 {
        self.times.last().copied().unwrap_or(0.0)
    }

    /// When the pair passes waypoint `i`, s.
    pub fn waypoint_time(&self, i: usize) -> f64 {
        let node = self.times.get(2 * i).copied();
        node.unwrap_or_else(|| self.duration())
    }

    /// r^2 at u = `steps`, 1/s^2.
    pub fn square_at(&self, steps: f64) -> f64 {
        let last = self.paces.len() - 1;
        let k = ((steps / HALF) as usize).min(last - 1);
        let part = (steps / HALF - k as f64).clamp(0.0, 1.0);
        let [from, to] = [k, k + 1].map(|node| self.paces[node] * self.paces[node]);
        from + (to - from) * part
    }

    /// The progress at a time, s; before the start and after the end the pair stands, at NaN as before the start.
    pub fn at(&self, time: f64) -> Progress {
        let last = self.times.len() - 1;
        let standing = |steps| Progress {
            steps,
            pace: 0.0,
            pace_rate: 0.0,
        };
        if time.is_nan() || time <= 0.0 {
            return standing(0.0);
        }
        if time >= self.times[last] {
            return standing(HALF * last as f64);
        }
        let k = (self.times.partition_point(|t| *t <= time) - 1).min(last - 1);
        let elapsed = time - self.times[k];
        let rate = (self.paces[k + 1] - self.paces[k]) / (self.times[k + 1] - self.times[k]);
        let way = (self.paces[k] + 0.5 * rate * elapsed) * elapsed;
        Progress {
            steps: HALF * k as f64 + way.clamp(0.0, HALF),
            pace: self.paces[k] + rate * elapsed,
            pace_rate: rate,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_time_that_is_not_a_number_is_before_the_start() {
        let limit = PaceLimit {
            square: 1.0,
            slope: 1.0,
        };
        let progress = Clock::new(&[limit; 4]).at(f64::NAN);
        assert_eq!((progress.steps, progress.pace), (0.0, 0.0));
    }
}
