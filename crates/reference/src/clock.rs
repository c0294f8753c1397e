/// One time law for both robots: how fast the pair moves through the steps of its plan.
///
/// At pace r the step number u grows by r / step_time a second; r is 0 at both ends, at most 1, and r^2 is linear in u between
/// nodes at every half step, so each stretch has constant acceleration dr/dt.
#[derive(Clone, Debug)]
pub(super) struct Clock {
    step_time: f64,
    paces: Vec<f64>,
    times: Vec<f64>,
}

/// Where the pair is on its way.
#[derive(Clone, Copy, Debug)]
pub(super) struct Progress {
    /// u: steps done, with the fraction of the one under way.
    pub steps: f64,
    /// r.
    pub pace: f64,
    /// dr/dt, 1/s.
    pub pace_rate: f64,
}

/// Between two nodes u grows by this.
const HALF: f64 = 0.5;

impl Clock {
    /// `caps[k]` bounds the pace on the stretch between nodes k and k + 1 (half steps); `acceleration` bounds dr/dt, 1/s.
    pub fn new(step_time: f64, caps: &[f64], acceleration: f64) -> Self {
        let count = caps.len() + 1;
        let cap_at = |k: usize| {
            let left = k.checked_sub(1).map_or(0.0, |j| caps[j]);
            caps.get(k).copied().unwrap_or(0.0).min(left)
        };
        let mut squares: Vec<f64> = (0..count).map(|k| cap_at(k).powi(2)).collect();
        let slope = 2.0 * step_time * acceleration * HALF;
        for k in 1..count {
            squares[k] = squares[k].min(squares[k - 1] + slope);
        }
        for k in (0..count - 1).rev() {
            squares[k] = squares[k].min(squares[k + 1] + slope);
        }
        let paces: Vec<f64> = squares.iter().map(|s| s.sqrt()).collect();
        let mut times = vec![0.0];
        for k in 1..count {
            let duration = 2.0 * HALF * step_time / (paces[k - 1] + paces[k]);
            times.push(times[k - 1] + duration);
        }
        Self {
            step_time,
            paces,
            times,
        }
    }

    /// Time from the first waypoint to the last, s.
    pub fn duration(&self) -> f64 {
        self.times.last().copied().unwrap_or(0.0)
    }

    /// When the pair passes waypoint `i`, s.
    pub fn waypoint_time(&self, i: usize) -> f64 {
        self.times
            .get(2 * i)
            .copied()
            .unwrap_or_else(|| self.duration())
    }

    /// The progress at a time, s; before the start and after the end the pair stands.
    pub fn at(&self, time: f64) -> Progress {
        let last = self.times.len() - 1;
        if time <= 0.0 {
            return Progress {
                steps: 0.0,
                pace: 0.0,
                pace_rate: 0.0,
            };
        }
        if time >= self.times[last] {
            return Progress {
                steps: HALF * last as f64,
                pace: 0.0,
                pace_rate: 0.0,
            };
        }
        let k = (self.times.partition_point(|t| *t <= time) - 1).min(last - 1);
        let elapsed = time - self.times[k];
        let rate = (self.paces[k + 1] - self.paces[k]) / (self.times[k + 1] - self.times[k]);
        let way = (self.paces[k] + 0.5 * rate * elapsed) * elapsed / self.step_time;
        Progress {
            steps: HALF * k as f64 + way.clamp(0.0, HALF),
            pace: self.paces[k] + rate * elapsed,
            pace_rate: rate,
        }
    }
}
