use crate::subject::Subject;
use crate::tightest::Tightest;
use pairtrawl_geometry::Hull;

/// Every segment of each path keeps at least the robot radius from every obstacle; margin in m beyond the radius.
pub(super) fn judge(subject: &Subject<'_>) -> Tightest {
    let obstacles = match &subject.obstacles {
        Ok(obstacles) => obstacles,
        Err(reason) => return Tightest::unusable(None, reason.as_str()),
    };
    let radius = subject.scene.robot.radius;
    let mut tightest = Tightest::new();
    for (side, i, from, to) in subject.robot_steps() {
        let path = Hull::of(&[from.position(), to.position()]);
        if let Some((gap, part)) = obstacles.gap(&path, tightest.margin() + radius) {
            tightest.consider(gap.distance - radius, i, gap.place, || {
                format!(
                    "{side}, {:.4} m from {part}, radius {radius} m",
                    gap.distance
                )
            });
        }
    }
    tightest
}
