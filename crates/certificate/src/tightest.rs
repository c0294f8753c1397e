use pairtrawl_geometry::Point;
use pairtrawl_model::{Claim, ClaimId};

/// The tightest place of a claim found so far.
#[derive(Clone, Debug)]
pub(crate) struct Tightest {
    margin: f64,
    step: Option<usize>,
    place: Option<Point>,
    detail: String,
}

impl Tightest {
    /// Nothing to hold the plan against yet.
    pub(crate) fn new() -> Self {
        Self {
            margin: f64::INFINITY,
            step: None,
            place: None,
            detail: String::new(),
        }
    }

    /// The claim cannot be judged, for this reason.
    pub(crate) fn unusable(step: Option<usize>, reason: impl Into<String>) -> Self {
        Self {
            margin: f64::NEG_INFINITY,
            step,
            place: None,
            detail: reason.into(),
        }
    }

    /// The least margin so far.
    pub(crate) fn margin(&self) -> f64 {
        self.margin
    }

    /// Takes the place when it is tighter; a NaN margin is the worst of all. The first one wins a tie.
    pub(crate) fn consider(
        &mut self,
        margin: f64,
        step: usize,
        place: Point,
        detail: impl FnOnce() -> String,
    ) {
        let margin = if margin.is_nan() {
            f64::NEG_INFINITY
        } else {
            margin
        };
        if margin < self.margin {
            *self = Self {
                margin,
                step: Some(step),
                place: Some(place),
                detail: detail(),
            };
        }
    }

    /// The finished claim: it holds when the margin is at least `-tolerance`.
    pub(crate) fn into_claim(self, id: ClaimId, tolerance: f64) -> Claim {
        let holds = self.margin >= -tolerance;
        Claim {
            id,
            holds,
            margin: self.margin,
            step: self.step,
            place: self.place,
            detail: self.detail,
        }
    }
}
