//! Joint trajectory optimization of a robot pair and its net length.
//!
//! With poses `p_i = (x, y, phi)` of both robots at `N` waypoints, ends fixed, and the net length `d_max`:
//!
//! ```text
//! minimize    a1 J_s + a2 J_dist + a4 sum_i J_e(d_i, d_max)
//! subject to  h = 0                      no sideways slip over a step (mid-step heading)
//!             0 <= s <= Delta L_max      forward, step length
//!             |delta| <= Delta phi_max   turn
//!             2 R <= d <= d_max          separation
//!             |hitch - hitch| <= d_max   net reach
//!             skew <= max_skew           abreast
//!             robots and the line between them keep off obstacles and objects, objects on their sides
//! ```
//!
//! An interior point with elastic inequalities solves it; its Newton system is banded, with one dense row for `d_max`.

#[macro_use]
mod rule;

mod active;
mod alternating;
mod anchor;
mod assembly;
mod block;
mod constraints;
mod cost;
mod costs;
mod crossings;
mod curvature;
mod filter;
mod interior_point;
mod iterate;
mod line_search;
mod linear;
mod local;
mod look_up;
mod measure;
mod merit;
mod newton;
mod optimize;
mod own;
mod pieces;
mod polish;
mod problem;
mod reinforce;
mod row;
mod settings;
mod shortfalls;
mod sight;
mod state;
mod step;
mod step_bound;
mod system;
mod term;
mod tier;
mod workspace;

pub use alternating::{Alternation, FirstLength, alternate};
pub use cost::evaluate;
pub use merit::Residuals;
pub use optimize::{Solution, optimize, optimize_from, optimize_watched};
pub use own::Role;
pub use problem::{Problem, Reserve, SeparationRule};
pub use settings::Settings;
pub use shortfalls::{ShrunkMargin, Unmet, Violation};
pub use term::{Jet, PAIR, POINT, Term};

#[cfg(test)]
mod tests;
