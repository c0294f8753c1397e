use pairtrawl_model::Side;
use pairtrawl_reference::Reference;
use std::fmt::Write;

/// A line `t x y z qx qy qz qw` for each waypoint, with the time at which the robot passes it, in s and m, map frame: z is 0
/// and the quaternion is a turn by the heading about +z.
pub fn tum_text(reference: &Reference, side: Side) -> String {
    let mut text = String::new();
    for i in 0..reference.waypoints() {
        let t = reference.waypoint_time(i);
        let p = reference.at(t)[side.index()].pose;
        let (qz, qw) = libm::sincos(0.5 * p.heading);
        // Writing into a string cannot fail.
        let _ = writeln!(text, "{t} {} {} 0 0 0 {qz} {qw}", p.x, p.y);
    }
    text
}
