//! One command a file. A command returns what it has to say; `main` prints it.

mod check;
mod completions;
mod demo;
mod export;
mod generate;
mod given_plan;
mod length;
mod monte_carlo;
mod new;
mod plan;
mod planning;
mod rehearse;
mod run;

pub use check::check;
pub use completions::completions;
pub use demo::demo;
pub use export::export;
pub use generate::generate;
pub use length::length;
pub use monte_carlo::monte_carlo;
pub use new::new;
pub use plan::plan;
pub use rehearse::rehearse;
pub use run::run;
