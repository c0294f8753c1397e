use crate::term::{Jet, Term};

/// Which second derivatives the matrix gets.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Curvature {
    /// Those that are convex: every step goes downhill, from wherever.
    Convex,
    /// Those of the Lagrangian: near an optimum Newton's steps then converge quadratically.
    Exact,
}

impl Curvature {
    /// A cost with its second derivatives.
    #[inline]
    pub fn of<const K: usize>(self, cost: &dyn Term<K>, z: &[f64; K]) -> Jet<K> {
        match self {
            Self::Convex => cost.convex_jet(z),
            Self::Exact => cost.jet(z),
        }
    }
}
