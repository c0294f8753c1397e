//! The same run for other simulators: MJCF for `MuJoCo`, SDF for Gazebo. Heights are real there; everything else is what this
//! crate simulates.

mod layout;
mod mjcf;
mod sdf;

pub use mjcf::mjcf;
pub use sdf::sdf;

/// Height of obstacles and robots, m.
const TALL: f64 = 0.3;

/// Text with what is special in XML escaped.
fn escape(text: &str) -> String {
    text.replace('&', "&amp;")
        .replace('<', "&lt;")
        .replace('>', "&gt;")
        .replace('"', "&quot;")
}

/// Numbers separated by blanks, short and exact enough (1e-9).
fn numbers<const N: usize>(values: [f64; N]) -> String {
    values.map(number).join(" ")
}

fn number(value: f64) -> String {
    let text = format!("{value:.9}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" || text.is_empty() {
        "0".to_owned()
    } else {
        text.to_owned()
    }
}
