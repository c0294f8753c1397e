//! Iterators over independent pieces of work. With feature `threads` they run on rayon's current pool, without it one after
//! the other. Results come in the order of their inputs either way, so they are the same.
//!
//! ```
//! use pairtrawl_parallel::prelude::*;
//!
//! let squares: Vec<i32> = [1, 2, 3].par_iter().map(|x| x * x).collect();
//! assert_eq!(squares, [1, 4, 9]);
//! ```

/// What callers import.
pub mod prelude {
    #[cfg(not(feature = "threads"))]
    pub use super::one_thread::{IntoParallelIterator, IntoParallelRefIterator};
    #[cfg(feature = "threads")]
    pub use rayon::prelude::*;
}

#[cfg(not(feature = "threads"))]
mod one_thread {
    /// Rayon's name for an iterator that takes its items.
    pub trait IntoParallelIterator: IntoIterator + Sized {
        /// The items, one after the other.
        fn into_par_iter(self) -> Self::IntoIter {
            self.into_iter()
        }
    }

    impl<T: IntoIterator> IntoParallelIterator for T {}

    /// Rayon's name for an iterator over references.
    pub trait IntoParallelRefIterator<T> {
        /// References to the items, one after the other.
        fn par_iter(&self) -> std::slice::Iter<'_, T>;
    }

    impl<T> IntoParallelRefIterator<T> for [T] {
        fn par_iter(&self) -> std::slice::Iter<'_, T> {
            self.iter()
        }
    }
}
