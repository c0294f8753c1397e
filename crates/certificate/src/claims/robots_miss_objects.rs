use crate::subject::Subject;
use crate::tightest::Tightest;
use pairtrawl_geometry::{Bounds, Segment};

/// Every segment of each path keeps at least the robot radius from every object's footprint circle; margin in m.
pub(super) fn judge(subject: &Subject<'_>) -> Tightest {
    let radius = subject.scene.robot.radius;
    let mut tightest = Tightest::new();
    for (j, object) in subject.scene.objects.iter().enumerate() {
        let reach = object.footprint_radius() + radius;
        if !(object.position.is_finite() && reach.is_finite()) {
            return Tightest::unusable(
                None,
                format!("object {j} has a position or size that is not finite"),
            );
        }
        let center = Bounds::of(&[object.position]);
        for (side, i, from, to) in subject.robot_steps() {
            let path = Segment::new(from.position(), to.position());
            if Bounds::of(&[path.a, path.b]).distance(&center) - reach >= tightest.margin() {
                continue;
            }
            let gap = path.gap_to_disc(object.position, reach);
            tightest.consider(gap.distance, i, gap.place, || {
                format!(
                    "{side}, {:.4} m from the footprint circle of object {j}, radius {radius} m",
                    gap.distance + radius
                )
            });
        }
    }
    tightest
}
