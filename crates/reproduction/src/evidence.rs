//! The vocabulary of verdicts: claims, the numbers that they are judged by, and what comes out.

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

/// `Shown` or `NotShown`, with its reason.
pub(crate) fn shown_when(holds: bool, yes: &str, no: &str) -> Outcome {
    match holds {
        true => Outcome::Shown(yes.to_owned()),
        false => Outcome::NotShown(no.to_owned()),
    }
}
