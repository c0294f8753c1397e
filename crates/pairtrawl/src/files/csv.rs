use super::{FileError, write_atomically};
use pairtrawl_model::PairTrajectory;
use std::fmt::Write;
use std::path::Path;

/// Writes `plan.csv`, atomically.
///
/// # Errors
/// When the system refuses.
pub fn write_csv(path: &Path, trajectory: &PairTrajectory) -> Result<(), FileError> {
    write_atomically(path, csv_text(trajectory).as_bytes())
}

/// A header and a line for each waypoint: s, m and rad; numbers are the shortest that read back as the same bits.
pub fn csv_text(trajectory: &PairTrajectory) -> String {
    let mut text = String::from("t,left_x,left_y,left_heading,right_x,right_y,right_heading\n");
    for (i, (l, r)) in trajectory.left.iter().zip(&trajectory.right).enumerate() {
        let t = i as f64 * trajectory.step_time;
        // Writing into a string cannot fail.
        let _ = writeln!(
            text,
            "{t},{},{},{},{},{},{}",
            l.x, l.y, l.heading, r.x, r.y, r.heading
        );
    }
    text
}
