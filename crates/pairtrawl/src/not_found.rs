use crate::no_plan::NoPlan;
use pairtrawl_model::{Plan, numbers};
use std::fmt;

/// A search that found no certified plan: what is missing in the best attempt, and everything that was tried.
#[derive(Clone, Debug, PartialEq)]
pub struct NotFound {
    /// What is missing in the best attempt.
    pub missing: NoPlan,
    /// Every start that was tried, in that order, and what was missing there.
    pub tried: Vec<Tried>,
    /// Objects without which there is a certified plan, ascending; empty when none were found. Only where the options do
    /// not allow to leave them.
    pub could_leave: Vec<usize>,
    /// The best attempt, for pictures. It is no plan: a claim of its certificate fails, or its rehearsal.
    pub best: Option<Box<Plan>>,
}

/// A start that led to no certified plan.
#[derive(Clone, Debug, PartialEq)]
pub struct Tried {
    /// The start, for people.
    pub start: String,
    /// What was missing.
    pub missing: NoPlan,
}

/// More starts than this are not all told.
const TOLD: usize = 12;

impl NotFound {
    /// What would help, when the message does not say so itself.
    pub fn remedy(&self) -> Option<String> {
        let leave = (!self.could_leave.is_empty()).then(|| {
            let objects = numbers::index_list(&self.could_leave);
            format!(
                "--leave unreachable (or planner.leave = \"unreachable\") leaves {} {objects}, for which no plan was found, \
                 and gathers the rest",
                match self.could_leave.len() {
                    1 => "object",
                    _ => "objects",
                }
            )
        });
        match (leave, self.missing.remedy()) {
            (Some(leave), Some(other)) => Some(format!("{leave}; or {other}")),
            (leave, other) => leave.or(other),
        }
    }

    /// The better of two attempts: that which fails fewer claims, then the earlier one.
    pub(crate) fn is_better_than(&self, other: &Self) -> bool {
        self.failures() < other.failures()
    }

    fn failures(&self) -> usize {
        self.best.as_ref().map_or(usize::MAX, |best| {
            let claims = best.certificate.claims.iter();
            claims.filter(|claim| !claim.holds).count()
        })
    }
}

impl fmt::Display for NotFound {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.missing.fmt(f)?;
        if self.tried.len() < 2 {
            return Ok(());
        }
        write!(f, "\n  {} starts were tried:", self.tried.len())?;
        for tried in self.tried.iter().take(TOLD) {
            write!(f, "\n  - {}: {}", tried.start, tried.missing)?;
        }
        match self.tried.len().saturating_sub(TOLD) {
            0 => Ok(()),
            more => write!(f, "\n  - and {more} more"),
        }
    }
}

impl From<NoPlan> for NotFound {
    fn from(missing: NoPlan) -> Self {
        Self {
            missing,
            tried: Vec::new(),
            could_leave: Vec::new(),
            best: None,
        }
    }
}
