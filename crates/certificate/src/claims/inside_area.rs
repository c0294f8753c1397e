use crate::subject::Subject;
use crate::tightest::Tightest;

/// The axle centers stay in the scene's rectangle; paths are made of segments, so the waypoints decide. Margin in m.
pub(super) fn judge(subject: &Subject<'_>) -> Tightest {
    let area = subject.scene.area;
    let mut tightest = Tightest::new();
    for (side, poses) in subject.robots() {
        for (i, pose) in poses.iter().enumerate() {
            let sides = [
                ("left", pose.x - area.min.x),
                ("right", area.max.x - pose.x),
                ("lower", pose.y - area.min.y),
                ("upper", area.max.y - pose.y),
            ];
            for (which, room) in sides {
                tightest.consider(room, i, pose.position(), || {
                    format!("{side}, the {which} side of the area")
                });
            }
        }
    }
    tightest
}
