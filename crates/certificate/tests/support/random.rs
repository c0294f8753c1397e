//! Reproducible numbers (SplitMix64).

#![allow(
    clippy::disallowed_methods,
    reason = "tests compare with the standard library"
)]

pub struct Random(pub u64);

impl Random {
    pub fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// Uniform in [low, high).
    pub fn within(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * (self.bits() >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// Uniform below n.
    pub fn below(&mut self, n: usize) -> usize {
        (self.bits() % n as u64) as usize
    }

    /// Log-uniform in [low, high), with a random sign.
    pub fn of_any_size(&mut self, low: f64, high: f64) -> f64 {
        let size = self.within(low.ln(), high.ln()).exp();
        if self.bits() & 1 == 0 { size } else { -size }
    }
}
