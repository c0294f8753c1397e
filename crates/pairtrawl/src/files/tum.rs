use super::{FileError, write_atomically};
use pairtrawl_geometry::Pose;
use std::fmt::Write;
use std::path::Path;

/// Writes one robot's trajectory as a TUM file, atomically; `step_time` in s.
///
/// # Errors
/// When the system refuses.
pub fn write_tum(path: &Path, poses: &[Pose], step_time: f64) -> Result<(), FileError> {
    write_atomically(path, tum_text(poses, step_time).as_bytes())
}

/// Lines `t x y z qx qy qz qw` in s and m, map frame: z is 0 and the quaternion is a turn by the heading about +z.
pub fn tum_text(poses: &[Pose], step_time: f64) -> String {
    let mut text = String::new();
    for (i, p) in poses.iter().enumerate() {
        let (qz, qw) = (0.5 * p.heading).sin_cos();
        // Writing into a string cannot fail.
        let _ = writeln!(
            text,
            "{} {} {} 0 0 0 {qz} {qw}",
            i as f64 * step_time,
            p.x,
            p.y
        );
    }
    text
}
