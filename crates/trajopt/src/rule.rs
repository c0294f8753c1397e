//! How a constraint takes part in the problem: which rows it has, and what each of them says.

use crate::anchor::Anchor;
use crate::problem::Problem;
use crate::sight::Sight;
use crate::term::{Jet, Term};
use pairtrawl_model::ClaimId;
use std::fmt::Debug;

/// A constraint of one anchor: a small value that tells its rows from each other, such as the number of an object.
///
/// A new constraint is a file with a [`Term`] and its rule, one line where the rules of its anchor are listed
/// (`constraints/mod.rs`), and one line in the derivative test (`tests/terms.rs`).
pub(crate) trait Rule<A, const K: usize>: Copy {
    /// The rows in play at an anchor, in the order of their keys.
    fn look_up(sight: &mut Sight, at: A, add: &mut impl FnMut(Self));

    /// What a row says: its constraint `c >= 0`.
    fn term(self, problem: &Problem, at: A) -> impl Term<K>;

    /// Tells the rows of this rule at one anchor from each other; multipliers are kept by it when rows are looked up again.
    fn key(self) -> u32 {
        0
    }

    /// Cost of a unit of violation, where that of most is `elastic`. Infinite: the row does not give way.
    fn price(self, _problem: &Problem, elastic: f64) -> f64 {
        elastic
    }

    /// What fails when the row gives way by more than a margin; `None` for what only helps.
    fn stake(self, _problem: &Problem) -> Option<Stake<'_>> {
        None
    }
}

/// What a row stands for.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Stake<'a> {
    pub what: Subject<'a>,
    /// Index of the object, or of the obstacle piece.
    pub thing: Option<usize>,
    /// How far the row may fall below zero before that fails, m or rad.
    pub margin: f64,
}

/// A claim, or the user's own constraint by its name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Subject<'a> {
    Claim(ClaimId),
    Own(&'a str),
}

impl<'a> Stake<'a> {
    pub fn own(name: &'a str) -> Option<Self> {
        Some(Self {
            what: Subject::Own(name),
            thing: None,
            margin: 0.0,
        })
    }

    pub fn claim(claim: ClaimId, margin: f64) -> Option<Self> {
        Some(Self {
            what: Subject::Claim(claim),
            thing: None,
            margin,
        })
    }

    pub fn claim_about(claim: ClaimId, thing: u32, margin: f64) -> Option<Self> {
        Some(Self {
            what: Subject::Claim(claim),
            thing: Some(thing as usize),
            margin,
        })
    }
}

/// All rules of an anchor, as an enum of them.
pub(crate) trait Rules<const K: usize>: Copy + Debug {
    type At: Anchor<K>;

    fn look_up(sight: &mut Sight, at: Self::At, add: &mut impl FnMut(Self));
    fn value(self, problem: &Problem, at: Self::At, z: &[f64; K]) -> f64;
    fn slope(self, problem: &Problem, at: Self::At, z: &[f64; K]) -> (f64, [f64; K]);
    fn jet(self, problem: &Problem, at: Self::At, z: &[f64; K]) -> Jet<K>;
    fn price(self, problem: &Problem, elastic: f64) -> f64;
    fn stake(self, problem: &Problem) -> Option<Stake<'_>>;
    /// Ascends within an anchor: place of the rule in the list, then its own key.
    fn key(self) -> (u8, u32);
}

/// Makes the enum of an anchor's rules from a list of them.
macro_rules! rules {
    ($(#[$doc:meta])* $name:ident at $anchor:ty, $k:expr; $($rule:ident),+ $(,)?) => {
        $(#[$doc])*
        #[derive(Clone, Copy, Debug)]
        pub(crate) enum $name { $($rule($rule)),+ }

        impl $crate::rule::Rules<{ $k }> for $name {
            type At = $anchor;

            fn look_up(sight: &mut $crate::sight::Sight, at: $anchor, add: &mut impl FnMut(Self)) {
                $( $crate::rule::Rule::look_up(sight, at, &mut |rule: $rule| add(Self::$rule(rule))); )+
            }

            #[inline(always)]
            fn value(self, problem: &$crate::problem::Problem, at: $anchor, z: &[f64; $k]) -> f64 {
                match self { $( Self::$rule(rule) => $crate::term::Term::value(&$crate::rule::Rule::term(rule, problem, at), z), )+ }
            }

            #[inline(always)]
            fn slope(self, problem: &$crate::problem::Problem, at: $anchor, z: &[f64; $k]) -> (f64, [f64; $k]) {
                match self { $( Self::$rule(rule) => $crate::term::Term::slope(&$crate::rule::Rule::term(rule, problem, at), z), )+ }
            }

            fn jet(self, problem: &$crate::problem::Problem, at: $anchor, z: &[f64; $k]) -> $crate::term::Jet<{ $k }> {
                match self { $( Self::$rule(rule) => $crate::term::Term::jet(&$crate::rule::Rule::term(rule, problem, at), z), )+ }
            }

            fn price(self, problem: &$crate::problem::Problem, elastic: f64) -> f64 {
                match self { $( Self::$rule(rule) => $crate::rule::Rule::<$anchor, { $k }>::price(rule, problem, elastic), )+ }
            }

            fn stake(self, problem: &$crate::problem::Problem) -> Option<$crate::rule::Stake<'_>> {
                match self { $( Self::$rule(rule) => $crate::rule::Rule::<$anchor, { $k }>::stake(rule, problem), )+ }
            }

            fn key(self) -> (u8, u32) {
                enum Place { $($rule),+ }
                match self { $( Self::$rule(rule) => (Place::$rule as u8, $crate::rule::Rule::<$anchor, { $k }>::key(rule)), )+ }
            }
        }
    };
}
