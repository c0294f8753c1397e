use crate::kind::Kind;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{Rng, SeedableRng};

/// The source of chance: raw words of ChaCha8, turned into numbers here, so that no distribution code of a library
/// decides what a seed means.
pub(crate) struct Random(ChaCha8Rng);

impl Random {
    /// A stream of its own for each kind, difficulty and seed.
    pub(crate) fn new(kind: Kind, difficulty: u8, seed: u64) -> Self {
        let kind = match kind {
            Kind::Witness => 1,
            Kind::Serpentine => 2,
        };
        Self::keyed(seed, difficulty, kind, [0, 0])
    }

    /// The stream of litter on a map of this many columns and rows: one seed does not mean the same headings everywhere.
    pub(crate) fn of_litter(seed: u64, columns: usize, rows: usize) -> Self {
        Self::keyed(seed, 0, 3, [columns as u64, rows as u64])
    }

    /// The stream of a hall with litter.
    pub(crate) fn of_hall(seed: u64) -> Self {
        Self::keyed(seed, 0, 4, [0, 0])
    }

    /// The stream of a key: seed, difficulty, number of the kind and size, each at its place.
    fn keyed(seed: u64, difficulty: u8, kind: u8, size: [u64; 2]) -> Self {
        let mut key = [0u8; 32];
        key[..8].copy_from_slice(&seed.to_le_bytes());
        key[8] = difficulty;
        key[9] = kind;
        key[16..24].copy_from_slice(&size[0].to_le_bytes());
        key[24..].copy_from_slice(&size[1].to_le_bytes());
        Self(ChaCha8Rng::from_seed(key))
    }

    /// Uniform in [0, 1).
    pub(crate) fn unit(&mut self) -> f64 {
        (self.0.next_u64() >> 11) as f64 / (1u64 << 53) as f64
    }

    /// Uniform in [low, high).
    pub(crate) fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }

    /// Uniform in low..high; `low` when the range is empty.
    pub(crate) fn index(&mut self, low: usize, high: usize) -> usize {
        low + (self.unit() * high.saturating_sub(low) as f64) as usize
    }

    /// True with this probability.
    pub(crate) fn chance(&mut self, probability: f64) -> bool {
        self.unit() < probability
    }

    /// +1 or -1.
    pub(crate) fn sign(&mut self) -> f64 {
        if self.chance(0.5) { 1.0 } else { -1.0 }
    }
}
