use pairtrawl_certificate::infeasibility::Proof;
use pairtrawl_model::{LeftOut, LeftWhy, numbers};
use std::fmt;

/// Proofs that a scene has no plan that gathers everything. There is at least one.
#[derive(Clone, Debug, PartialEq)]
pub struct Infeasible {
    /// Those that are not about an object first, then one for each object that cannot be swept, ascending.
    pub proofs: Vec<Proof>,
    /// How many objects were to be gathered.
    pub wanted: usize,
}

/// More proofs than this are not all told in full.
const TOLD: usize = 8;

impl Infeasible {
    /// The proof that no choice of objects gets around; `None` when all of them are about objects.
    pub fn of_everything(&self) -> Option<&Proof> {
        self.proofs.iter().find(|proof| proof.object().is_none())
    }

    /// The objects that cannot be swept.
    pub fn objects(&self) -> Vec<usize> {
        self.proofs.iter().filter_map(Proof::object).collect()
    }

    /// True when a plan is possible that leaves the objects that cannot be swept and gathers others.
    pub fn can_leave(&self) -> bool {
        self.of_everything().is_none() && self.proofs.len() < self.wanted
    }

    /// The objects that cannot be swept as those that a plan leaves.
    pub fn left_out(&self) -> Vec<LeftOut> {
        let left = |proof: &Proof| {
            Some(LeftOut {
                object: proof.object()?,
                why: LeftWhy::Proven,
                text: proof.message.clone(),
            })
        };
        self.proofs.iter().filter_map(left).collect()
    }

    /// What would help beyond what the proofs say.
    pub fn remedy(&self) -> Option<String> {
        if self.of_everything().is_some() {
            return None;
        }
        if !self.can_leave() {
            let words = "nothing can be gathered, so that leaving what cannot be swept (--leave unreachable) leaves no plan";
            return Some(words.to_owned());
        }
        let others = self.wanted - self.proofs.len();
        let others = match others {
            1 => "the other object".to_owned(),
            n => format!("the other {n} objects"),
        };
        let it = match self.proofs.len() {
            1 => "it lies",
            _ => "they lie",
        };
        Some(format!(
            "--leave unreachable (or planner.leave = \"unreachable\") gathers {others} and leaves where {it} what cannot be swept"
        ))
    }
}

impl fmt::Display for Infeasible {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let [proof] = self.proofs.as_slice() {
            return proof.fmt(f);
        }
        let objects = self.objects();
        if let Some(proof) = self.of_everything() {
            proof.fmt(f)?;
            if !objects.is_empty() {
                write!(f, "; besides, {} cannot be swept", list(&objects))?;
            }
            return Ok(());
        }
        write!(
            f,
            "{} of {} objects cannot be swept",
            objects.len(),
            self.wanted
        )?;
        if objects.len() > TOLD {
            write!(f, " ({})", numbers::index_list(&objects))?;
        }
        for proof in self.proofs.iter().take(TOLD) {
            write!(f, "\n  - {proof}")?;
        }
        match self.proofs.len().saturating_sub(TOLD) {
            0 => Ok(()),
            more => write!(f, "\n  - and {more} more, in full in infeasible.json"),
        }
    }
}

fn list(objects: &[usize]) -> String {
    match objects {
        [one] => format!("object {one}"),
        many => format!("objects {}", numbers::index_list(many)),
    }
}
