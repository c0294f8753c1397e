//! Claims of the paper and what numbers say about them. A verdict is a function of its evidence and of nothing else, so
//! whoever holds the evidence can judge again: [`judge`].

use crate::claims::CLAIMS;
use pairtrawl::model::numbers::quantity;
use pairtrawl::report::study::{Finding, Tone};
use serde::{Deserialize, Serialize};

/// What numbers say about a claim.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Outcome {
    /// They bear it out.
    Shown(String),
    /// They do not, and why.
    NotShown(String),
    /// They do so under a condition, which is named.
    ShownIf(String),
}

impl Outcome {
    /// `shown`, `not shown` or `shown if`.
    pub const fn name(&self) -> &'static str {
        match self {
            Self::Shown(_) => "shown",
            Self::NotShown(_) => "not shown",
            Self::ShownIf(_) => "shown if",
        }
    }

    /// Why, or the condition.
    pub fn words(&self) -> &str {
        let (Self::Shown(words) | Self::NotShown(words) | Self::ShownIf(words)) = self;
        words
    }
}

/// Named numbers, in the order in which they were added.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Evidence(Vec<Number>);

/// A number with its name and unit.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Number {
    /// Its name, such as `rms_error`.
    pub name: String,
    /// Its value; `None`: there is none.
    pub value: Option<f64>,
    /// Its unit; may be empty.
    pub unit: String,
}

impl Evidence {
    /// The same with one more number. What is not finite is kept as missing.
    #[must_use]
    pub fn with(mut self, name: &str, value: f64, unit: &str) -> Self {
        self.0.push(Number {
            name: name.to_owned(),
            value: value.is_finite().then_some(value),
            unit: unit.to_owned(),
        });
        self
    }

    /// The number of this name; NaN, which is neither more nor less than anything, when there is none.
    pub fn get(&self, name: &str) -> f64 {
        let found = self.0.iter().find(|number| number.name == name);
        found.and_then(|number| number.value).unwrap_or(f64::NAN)
    }

    /// All of them.
    pub fn numbers(&self) -> &[Number] {
        &self.0
    }
}

/// A claim of the paper.
#[derive(Clone, Copy)]
pub struct Claim {
    /// A name for programs.
    pub key: &'static str,
    /// What is claimed.
    pub text: &'static str,
    /// Where in the paper.
    pub place: &'static str,
    /// What numbers say about it.
    pub rule: fn(&Evidence) -> Outcome,
}

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
