use crate::problem::Problem;

/// Price of a claim, as a multiple of that of a margin.
const CLAIM_PRICE: f64 = 30.0;

/// How much is kept from a thing: the wished-for margin, which may give way at a price, or what the claim needs, which
/// costs far more. Without the second a squeezed robot would give up all of one distance to save another.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Tier {
    Margin,
    Claim,
}

impl Tier {
    pub const BOTH: [Self; 2] = [Self::Margin, Self::Claim];

    /// Price of a unit of length, as a multiple of the elastic weight.
    pub fn price(self) -> f64 {
        match self {
            Self::Margin => 1.0,
            Self::Claim => CLAIM_PRICE,
        }
    }

    /// Distance kept beyond the claim's bound, where `margin` is wished for: it may be used up before the claim fails.
    pub fn reserve(self, problem: &Problem, margin: f64) -> f64 {
        match self {
            Self::Margin => margin,
            Self::Claim => problem.reserve.sag.min(margin),
        }
    }

    /// Tells the rows about a thing from each other.
    pub fn key(self, thing: u32) -> u32 {
        2 * thing + self as u32
    }
}
