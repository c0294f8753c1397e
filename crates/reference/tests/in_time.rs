//! The reference of a plan: exact at waypoints, rolling without slip between them, smooth in time.

mod course;

use course::{course, with_waits};
use pairtrawl_geometry::{Point, Pose};
use pairtrawl_model::{PairTrajectory, PlannerParameters, Robot};
use pairtrawl_reference::{Reference, ReferenceError, ReferenceLimits, Sample};

fn reference(trajectory: &PairTrajectory) -> Reference {
    Reference::new(
        &Default::default(),
        &Default::default(),
        trajectory,
        &ReferenceLimits::of(&Default::default()),
    )
    .unwrap()
}

fn place(s: &Sample) -> Point {
    s.pose.position()
}

#[test]
fn both_robots_meet_every_waypoint_at_the_same_instant() {
    for t in [course(100, 1.0), with_waits()] {
        let r = reference(&t);
        for i in 0..t.len() {
            let pair = r.at(r.waypoint_time(i));
            for (sample, pose) in [(pair[0], t.left[i]), (pair[1], t.right[i])] {
                assert!(
                    place(&sample).distance(pose.position()) < 1e-9,
                    "waypoint {i}"
                );
                assert!(
                    (sample.pose.heading - pose.heading).abs() < 1e-9,
                    "waypoint {i}"
                );
            }
        }
        assert_eq!(r.waypoints(), t.len());
        let (left, right) = t.path_lengths();
        assert!(r.duration() > left.max(right) / PlannerParameters::default().cruise);
    }
}

#[test]
fn velocities_are_derivatives_and_there_is_no_slip() {
    let t = with_waits();
    let r = reference(&t);
    let h = 1e-5;
    let count = (r.duration() / 0.0137) as usize;
    let mut compared = 0;
    for k in 1..count {
        let time = k as f64 * 0.0137;
        let (before, now, after) = (r.at(time - h), r.at(time), r.at(time + h));
        for (b, n, a) in [(before[0], now[0], after[0]), (before[1], now[1], after[1])] {
            let velocity = (place(&a) - place(&b)) / (2.0 * h);
            let forward = Point::unit(n.pose.heading);
            assert!((velocity.dot(forward) - n.v).abs() < 1e-4, "at {time}");
            assert!(
                velocity.cross(forward).abs() < 1e-4,
                "slips at {time}: {}",
                velocity.cross(forward)
            );
            let turn = (a.pose.heading - b.pose.heading) / (2.0 * h);
            assert!((turn - n.omega).abs() < 1e-3, "at {time}");
            // At a node of the time law or of the curve accelerations jump; elsewhere they are derivatives.
            let jump = |f: fn(&Sample) -> f64| (f(&a) - f(&b)).abs() > 1e-3;
            if !jump(|s| s.v_dot) && !jump(|s| s.omega_dot) {
                let push = (a.v - b.v) / (2.0 * h);
                let twist = (a.omega - b.omega) / (2.0 * h);
                assert!((push - n.v_dot).abs() < 1e-3, "at {time}: {push}");
                assert!((twist - n.omega_dot).abs() < 1e-3, "at {time}: {twist}");
                compared += 1;
            }
        }
    }
    assert!(compared > count, "{compared} of {count} instants");
}

#[test]
fn speeds_are_smooth_and_within_the_robots_limits() {
    let t = with_waits();
    let r = reference(&t);
    let dt = 0.002;
    let mut last = r.at(0.0);
    assert_eq!(last[0].v, 0.0);
    let mut waited = false;
    for k in 1..=(r.duration() / dt) as usize + 100 {
        let now = r.at(k as f64 * dt);
        for (a, b) in [(last[0], now[0]), (last[1], now[1])] {
            let jump = (b.v - a.v).abs() / dt;
            let twist = (b.omega - a.omega).abs() / dt;
            assert!(
                jump < 1.0 && twist < 5.0,
                "at {}: {jump} m/s^2, {twist} rad/s^2",
                k as f64 * dt
            );
            let wheel = b.v.abs() + 0.144 * b.omega.abs();
            assert!(wheel <= 0.26 && b.omega.abs() <= 1.82, "wheel {wheel} m/s");
        }
        let middle = (k as f64 * dt - r.waypoint_time(21)).abs() < 0.1;
        waited |= middle && now[0].v == 0.0 && now[1].v == 0.0;
        last = now;
    }
    assert!(waited, "the pair must stand still in its wait");
    assert_eq!((last[0].v, last[0].omega), (0.0, 0.0));
}

#[test]
fn what_is_no_trajectory_is_refused() {
    let make = |t: &PairTrajectory| {
        Reference::new(
            &Default::default(),
            &Default::default(),
            t,
            &ReferenceLimits::of(&Default::default()),
        )
        .unwrap_err()
    };
    let mut t = course(100, 1.0);
    let left = t.len();
    t.right.pop();
    let right = left - 1;
    assert_eq!(make(&t), ReferenceError::Waypoints { left, right });
    let mut t = course(100, 1.0);
    t.left[7].x = f64::NAN;
    assert!(matches!(
        make(&t),
        ReferenceError::NotFinite { index: 7, .. }
    ));
    let t = PairTrajectory {
        step_time: 0.0,
        ..course(100, 1.0)
    };
    assert!(make(&t).to_string().contains("step time"));
}

/// Both robots' samples at many instants.
fn drive(r: &Reference, instants: usize) -> impl Iterator<Item = Sample> {
    (0..=instants).flat_map(move |k| r.at(r.duration() * k as f64 / instants as f64))
}

#[test]
fn cruise_speed_turning_rate_and_accelerations_hold_at_every_instant() {
    let (robot, planner) = (Robot::default(), PlannerParameters::default());
    let limits = ReferenceLimits::of(&robot);
    assert!((limits.linear - 0.7).abs() < 1e-12 && (limits.angular - 3.5).abs() < 1e-12);
    for t in [course(100, 1.0), course(1000, 1.0), with_waits()] {
        let (mut fastest, mut hardest) = (0.0_f64, 0.0_f64);
        for s in drive(&reference(&t), 20_000) {
            assert!(
                s.v >= -1e-12 && s.v <= planner.cruise * (1.0 + 1e-12),
                "{s:?}"
            );
            let turning = planner.cruise * planner.max_turn / planner.max_step;
            assert!(s.omega.abs() <= turning * (1.0 + 1e-12), "{s:?}");
            assert!(s.v_dot.abs() <= limits.linear * (1.0 + 1e-9), "{s:?}");
            assert!(s.omega_dot.abs() <= limits.angular * (1.0 + 1e-9), "{s:?}");
            fastest = fastest.max(s.v);
            hardest = hardest.max(s.v_dot);
        }
        assert!(fastest > 0.99 * planner.cruise, "{fastest} m/s");
        assert!(hardest > 0.19, "{hardest} m/s^2");
    }
}

#[test]
fn more_waypoints_sample_the_same_motion_more_finely() {
    let coarse = reference(&course(100, 1.0));
    for (count, apart) in [(200, 1e-3), (400, 1e-3), (2000, 1e-3)] {
        let fine = reference(&course(count, 1.0));
        let ratio = fine.duration() / coarse.duration();
        assert!((ratio - 1.0).abs() < 0.02, "{count} waypoints: {ratio}");
        for i in 0..=100 {
            let time = coarse.waypoint_time(i);
            let ratio = fine.waypoint_time(i * count / 100) / time;
            assert!(i == 0 || (ratio - 1.0).abs() < 0.05, "at {time} s: {ratio}");
            let [a, b] = [
                coarse.at(time),
                fine.at(fine.waypoint_time(i * count / 100)),
            ];
            assert!(place(&a[0]).distance(place(&b[0])) < apart);
        }
    }
}

#[test]
fn a_scaled_plan_has_the_scaled_curve_at_the_same_times() {
    let planner = PlannerParameters::default();
    let robot = Robot::default();
    let one = reference(&with_waits());
    for scale in [0.02, 0.1, 4.0, 1000.0] {
        let mut t = with_waits();
        for pose in t.left.iter_mut().chain(&mut t.right) {
            *pose = Pose::at(pose.position() * scale, pose.heading);
        }
        let robot = Robot {
            v_max: robot.v_max * scale,
            half_track: robot.half_track * scale,
            ..robot
        };
        let planner = PlannerParameters {
            max_step: planner.max_step * scale,
            cruise: planner.cruise * scale,
            ..planner
        };
        let limits = ReferenceLimits::of(&robot);
        let r = Reference::new(&robot, &planner, &t, &limits).unwrap();
        assert!((r.duration() / one.duration() - 1.0).abs() < 1e-9);
        for k in 0..1000 {
            let time = one.duration() * f64::from(k) / 1000.0;
            for (a, b) in one.at(time).into_iter().zip(r.at(time)) {
                let off = place(&a).distance(place(&b) / scale);
                assert!(off < 1e-9, "times {scale}: {off} at {time} s");
                assert!((a.pose.heading - b.pose.heading).abs() < 1e-9);
                assert!((a.v - b.v / scale).abs() < 1e-7 && (a.omega - b.omega).abs() < 1e-7);
            }
        }
    }
}

#[test]
fn a_pair_that_waits_all_the_time_needs_a_finite_time() {
    let t = PairTrajectory {
        left: vec![Pose::new(0.0, 0.4, 0.0); 5],
        right: vec![Pose::new(0.0, -0.4, 0.0); 5],
        step_time: 0.248,
    };
    let r = reference(&t);
    assert!(
        r.duration() > 0.0 && r.duration() < 1.0,
        "{} s",
        r.duration()
    );
    assert_eq!(r.at(0.5 * r.duration())[0].pose, t.left[0]);
}
