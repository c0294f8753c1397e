use pairtrawl_reference::Reference;
use std::fmt::Write;

/// What the robots drive: a header and a line for each waypoint with the time at which they pass it (s), their poses (m and
/// rad), and then speed along the heading (`v`, m/s) and turning rate (`omega`, rad/s) of each. Numbers are the shortest that
/// read back as the same bits.
pub fn csv_text(reference: &Reference) -> String {
    let mut text = String::from(
        "t,left_x,left_y,left_heading,right_x,right_y,right_heading,left_v,left_omega,right_v,right_omega\n",
    );
    for i in 0..reference.waypoints() {
        let t = reference.waypoint_time(i);
        let [left, right] = reference.at(t);
        let (l, r) = (left.pose, right.pose);
        // Writing into a string cannot fail.
        let _ = writeln!(
            text,
            "{t},{},{},{},{},{},{},{},{},{},{}",
            l.x, l.y, l.heading, r.x, r.y, r.heading, left.v, left.omega, right.v, right.omega
        );
    }
    text
}
