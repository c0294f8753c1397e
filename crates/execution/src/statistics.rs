use pairtrawl_model::TrackingStatistics;

/// Errors in the first second are those of starting.
const SETTLING: f64 = 1.0;

/// Greatest position error of either robot after the first second, m.
pub(crate) fn settled_max([a, b]: &[TrackingStatistics; 2]) -> f64 {
    a.settled_max.max(b.settled_max)
}

/// Root mean square position error of both robots after the first second, m.
pub(crate) fn settled_rms([a, b]: &[TrackingStatistics; 2]) -> f64 {
    (0.5 * (a.settled_rms * a.settled_rms + b.settled_rms * b.settled_rms)).sqrt()
}

/// Collects a robot's position error.
#[derive(Clone, Copy, Debug, Default)]
pub struct ErrorCollector {
    sum: [f64; 2],
    count: [f64; 2],
    max: [f64; 2],
}

impl ErrorCollector {
    /// Takes an error (m) at a time (s).
    pub fn take(&mut self, time: f64, error: f64) {
        for (i, counts) in [true, time > SETTLING].into_iter().enumerate() {
            if counts {
                self.sum[i] += error * error;
                self.count[i] += 1.0;
                self.max[i] = self.max[i].max(error);
            }
        }
    }

    /// What was collected.
    pub fn statistics(&self) -> TrackingStatistics {
        let rms = |i: usize| (self.sum[i] / self.count[i].max(1.0)).sqrt();
        TrackingStatistics {
            rms: rms(0),
            max: self.max[0],
            settled_rms: rms(1),
            settled_max: self.max[1],
        }
    }
}

/// The value below which a part `q` of the values lies, linear between ranks; NaN for none.
pub fn quantile(values: &mut [f64], q: f64) -> f64 {
    values.sort_by(f64::total_cmp);
    let Some(last) = values.len().checked_sub(1) else {
        return f64::NAN;
    };
    let rank = q.clamp(0.0, 1.0) * last as f64;
    let (low, part) = (rank.floor() as usize, rank.fract());
    let high = (low + 1).min(last);
    values[low] + part * (values[high] - values[low])
}

/// The seed of trial `index`: below 2^53, so that programs that read every number of a JSON file as a double keep its digits.
pub(crate) fn trial_seed(seed: u64, index: usize) -> u64 {
    mixed_seed(seed, index as u64) >> 11
}

/// The seed of a part of a trial, well mixed (the finalizer of SplitMix64).
pub fn mixed_seed(seed: u64, part: u64) -> u64 {
    let mut z = seed.wrapping_add(part.wrapping_add(1).wrapping_mul(0x9e37_79b9_7f4a_7c15));
    z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    z ^ (z >> 31)
}
