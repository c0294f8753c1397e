//! What a point falls short of: claims that are not met, and margins that gave way.

use crate::anchor::Anchor;
use crate::block::Block;
use crate::iterate::Iterate;
use crate::problem::Problem;
use crate::rule::{Rules, Subject};
use crate::state::State;
use pairtrawl_geometry::Point;
use pairtrawl_model::ClaimId;

/// A constraint that the returned trajectories do not meet.
#[derive(Clone, Debug, PartialEq)]
pub struct Violation {
    /// The claim that it stands for.
    pub claim: ClaimId,
    /// Waypoint or step.
    pub step: usize,
    /// By how much, m or rad.
    pub amount: f64,
    /// Index of the object, or of the obstacle piece.
    pub subject: Option<usize>,
    /// Where, m.
    pub place: Point,
}

/// A margin that shrank below the wish.
#[derive(Clone, Debug, PartialEq)]
pub struct ShrunkMargin {
    /// `robot_clearance`, `robots_miss_objects` or `net_encloses_no_obstacle`.
    pub claim: ClaimId,
    /// Waypoint.
    pub step: usize,
    /// What is left of the margin, m.
    pub left: f64,
    /// Where, m.
    pub place: Point,
}

/// A constraint of the user's that the returned trajectories do not meet.
#[derive(Clone, Debug, PartialEq)]
pub struct Unmet {
    /// The name that the user gave it.
    pub name: String,
    /// Waypoint.
    pub step: usize,
    /// By how much, in the constraint's own unit.
    pub amount: f64,
    /// Where.
    pub place: Point,
}

/// Everything that a point falls short of.
#[derive(Clone, Debug, Default)]
pub(crate) struct Shortfalls {
    pub violations: Vec<Violation>,
    pub unmet: Vec<Unmet>,
    pub margins: Vec<ShrunkMargin>,
}

/// Shortfalls below this are rounding.
const NOISE: f64 = 1e-5;
/// Margins that are as small as this, or shrink by as little, are not worth a word.
const NOTABLE: f64 = 1e-3;
/// Margins of the same claim that shrink nearer to each other than this are told once.
const SAME_PLACE: f64 = 1.0;

/// Claims that rows stand for fail when a row gives way by more than its margin.
pub(crate) fn shortfalls(problem: &Problem, state: &State) -> Shortfalls {
    let (x, set) = (&state.x, &state.set);
    let mut found = Shortfalls::default();
    found.judge_rows(&set.steps, problem, x);
    found.judge_rows(&set.pairs, problem, x);
    found.judge_rows(&set.points, problem, x);
    found.judge_rows(&set.bodies, problem, x);
    found.judge_rows(&set.lines, problem, x);
    let violations = &mut found.violations;
    violations.sort_by(|a, b| b.amount.total_cmp(&a.amount));
    // Both rows of a thing, that of its margin and that of its claim, tell the same.
    violations.dedup_by(|b, a| {
        (a.claim, a.step, a.subject, a.place) == (b.claim, b.step, b.subject, b.place)
    });
    found.unmet.sort_by(|a, b| b.amount.total_cmp(&a.amount));
    found
}

impl Shortfalls {
    /// True when something is not met; margins may shrink.
    pub fn any(&self) -> bool {
        !(self.violations.is_empty() && self.unmet.is_empty())
    }

    /// Sum of all violations.
    pub fn total(&self) -> f64 {
        let of_claims: f64 = self.violations.iter().map(|v| v.amount).sum();
        of_claims + self.unmet.iter().map(|u| u.amount).sum::<f64>()
    }

    fn judge_rows<R: Rules<K>, const K: usize>(
        &mut self,
        block: &Block<R, K>,
        problem: &Problem,
        x: &Iterate,
    ) {
        for item in &block.items {
            if let Some(stake) = item.rule.stake(problem) {
                let (step, c) = (item.at.stage(), item.row.c);
                match stake.what {
                    Subject::Claim(claim) if c < -stake.margin - NOISE => {
                        self.violations.push(Violation {
                            claim,
                            step,
                            amount: -c - stake.margin,
                            subject: stake.thing,
                            place: item.at.location(x),
                        });
                    }
                    Subject::Claim(claim) if c < -NOTABLE && stake.margin > NOTABLE => {
                        self.note(ShrunkMargin {
                            claim,
                            step,
                            left: stake.margin + c,
                            place: item.at.location(x),
                        });
                    }
                    Subject::Own(name) if c < -NOISE => self.unmet.push(Unmet {
                        name: name.to_owned(),
                        step,
                        amount: -c,
                        place: item.at.location(x),
                    }),
                    _ => {}
                }
            }
        }
    }

    /// Keeps the tightest of the margins that shrank at about the same place.
    fn note(&mut self, margin: ShrunkMargin) {
        let near = |m: &&mut ShrunkMargin| {
            m.claim == margin.claim && m.place.distance(margin.place) < SAME_PLACE
        };
        match self.margins.iter_mut().find(near) {
            Some(m) if m.left <= margin.left => {}
            Some(m) => *m = margin,
            None => self.margins.push(margin),
        }
    }
}
