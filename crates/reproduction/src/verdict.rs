//! Claims of the paper and what numbers say about them. A verdict is a function of its evidence and of nothing else, so
//! whoever holds the evidence can judge again: [`judge`].

use crate::claims::CLAIMS;
use crate::evidence::{Claim, Evidence, Number, Outcome};
use pairtrawl::model::numbers::quantity;
use pairtrawl::report::study::{Finding, Tone};
use serde::{Deserialize, Serialize};

/// A claim with the numbers and what they say.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Verdict {
    /// The claim's name.
    pub key: String,
    /// The numbers.
    pub evidence: Evidence,
}

impl Verdict {
    /// What the numbers say about a claim. The claim must be one of [`CLAIMS`].
    pub fn of(key: &str, evidence: Evidence) -> Self {
        debug_assert!(claim(key).is_some(), "there is no claim {key}");
        Self {
            key: key.to_owned(),
            evidence,
        }
    }

    /// The claim; `None`: it is not one of ours.
    pub fn claim(&self) -> Option<&'static Claim> {
        claim(&self.key)
    }

    /// What the numbers say.
    pub fn outcome(&self) -> Outcome {
        judge(&self.key, &self.evidence)
    }

    /// As it is shown.
    pub fn finding(&self) -> Finding {
        let outcome = self.outcome();
        Finding {
            claim: self.claim().map_or(&*self.key, |c| c.text).to_owned(),
            place: self.claim().map_or("", |c| c.place).to_owned(),
            verdict: outcome.name(),
            tone: match outcome {
                Outcome::Shown(_) => Tone::For,
                Outcome::ShownIf(_) => Tone::Partly,
                Outcome::NotShown(_) => Tone::Against,
            },
            because: outcome.words().to_owned(),
            evidence: (self.evidence.numbers().iter())
                .map(|n| (n.name.replace('_', " "), shown(n)))
                .collect(),
        }
    }
}

/// A number for people.
fn shown(number: &Number) -> String {
    match number.value {
        None => "none".to_owned(),
        Some(value) if number.unit.is_empty() && value == value.round() && value.abs() < 1e6 => {
            format!("{value}")
        }
        Some(value) => quantity(value, &number.unit),
    }
}

fn claim(key: &str) -> Option<&'static Claim> {
    CLAIMS.iter().find(|claim| claim.key == key)
}

/// What numbers say about a claim.
pub fn judge(key: &str, evidence: &Evidence) -> Outcome {
    match claim(key) {
        Some(claim) => (claim.rule)(evidence),
        None => Outcome::NotShown("there is no such claim".to_owned()),
    }
}
