//! One command a file. A command returns what it has to say; `main` prints it.

mod check;
mod completions;
mod demo;
mod new;
mod plan;
mod planning;

pub use check::check;
pub use completions::completions;
pub use demo::demo;
pub use new::new;
pub use plan::plan;
