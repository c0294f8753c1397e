//! One command a file. A command returns what it has to say; `main` prints it.

mod check;
mod completions;
mod demo;
mod generate;
mod length;
mod new;
mod plan;
mod planning;
mod rehearse;

pub use check::check;
pub use completions::completions;
pub use demo::demo;
pub use generate::generate;
pub use length::length;
pub use new::new;
pub use plan::plan;
pub use rehearse::rehearse;
