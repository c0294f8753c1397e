use pairtrawl_geometry::Pose;
use pairtrawl_model::PairTrajectory;

/// Length, at the greatest step, in which a lead builds up at the start and goes away before the end.
const RAMP: f64 = 1.2;

/// The same paths with the left robot ahead of its time by the waypoints that `lead` takes at steps of `max_step`, and the
/// right one as many behind; negative: the right one leads. Both ends stay as they are.
///
/// Who leads is a choice with many local optima: a line that runs askew is longer, which suits a net that is at rest wider
/// than the way is. The optimizer hardly changes sides in this by itself.
pub fn with_lead(pair: &PairTrajectory, lead: f64, max_step: f64) -> PairTrajectory {
    let (waypoints, ramp) = (lead / max_step, (RAMP / max_step).round());
    PairTrajectory {
        left: shifted(&pair.left, waypoints, ramp),
        right: shifted(&pair.right, -waypoints, ramp),
        step_time: pair.step_time,
    }
}

/// Poses at `i + lead`, the lead ramped at both ends; in between linear.
fn shifted(path: &[Pose], lead: f64, ramp: f64) -> Vec<Pose> {
    let last = path.len().saturating_sub(1) as f64;
    let ramp = ramp.min(0.5 * last).max(1.0);
    let at = |i: usize| {
        let i = i as f64;
        let share = (i / ramp).min((last - i) / ramp).min(1.0);
        let place = (i + lead * share).clamp(0.0, last);
        let (k, t) = (place.floor() as usize, place.fract());
        let (a, b) = (path[k], path[(k + 1).min(path.len() - 1)]);
        Pose::new(
            a.x + t * (b.x - a.x),
            a.y + t * (b.y - a.y),
            a.heading + t * (b.heading - a.heading),
        )
    };
    (0..path.len()).map(at).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Left and right drive east, 1 m apart, 0.05 m a step.
    fn abreast(n: usize) -> PairTrajectory {
        let path = |y: f64| (0..n).map(|i| Pose::new(0.05 * i as f64, y, 0.0)).collect();
        PairTrajectory {
            left: path(0.5),
            right: path(-0.5),
            step_time: 0.25,
        }
    }

    #[test]
    fn the_left_robot_is_ahead_in_the_middle_and_nobody_at_the_ends() {
        for n in [100, 20, 3, 2] {
            let pair = abreast(n);
            let led = with_lead(&pair, 0.2, 0.05);
            assert_eq!(led.len(), n);
            assert_eq!(led.pair(0), pair.pair(0));
            assert_eq!(led.pair(n - 1), pair.pair(n - 1));
            let ahead = |i: usize| led.left[i].x - led.right[i].x;
            if n == 100 {
                assert!(
                    (ahead(50) - 0.4).abs() < 1e-12,
                    "8 waypoints: {}",
                    ahead(50)
                );
                assert!(
                    (ahead(12) - 0.2).abs() < 1e-12,
                    "half way up: {}",
                    ahead(12)
                );
            }
            assert!((0..n).all(|i| ahead(i) >= 0.0 && led.left[i].y == 0.5));
            assert!(led.left.windows(2).all(|w| w[1].x >= w[0].x), "never back");
        }
    }

    #[test]
    fn the_right_one_leads_where_the_lead_is_negative() {
        let led = with_lead(&abreast(100), -0.2, 0.05);
        assert!(led.right[50].x - led.left[50].x > 0.39);
        assert_eq!(with_lead(&abreast(100), 0.0, 0.05), abreast(100));
    }
}
