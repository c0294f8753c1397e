//! The reference of a plan: exact at waypoints, rolling without slip between them, smooth in time.

mod drive;

use pairtrawl::geometry::Point;
use pairtrawl::model::PairTrajectory;
use pairtrawl::reference::{Reference, ReferenceError, ReferenceLimits, Sample, certify_reference};

fn reference(trajectory: &PairTrajectory) -> Reference {
    Reference::new(
        &Default::default(),
        &Default::default(),
        trajectory,
        &ReferenceLimits::default(),
    )
    .unwrap()
}

fn place(s: &Sample) -> Point {
    s.pose.position()
}

/// The drive with a wait of three steps and a turn on the spot of the left robot, which ends its way.
fn with_waits() -> PairTrajectory {
    let mut t = drive::trajectory();
    for _ in 0..3 {
        t.left.insert(20, t.left[20]);
        t.right.insert(20, t.right[20]);
    }
    for _ in 0..4 {
        let mut left = *t.left.last().unwrap();
        left.heading += 0.08;
        t.left.push(left);
        t.right.push(*t.right.last().unwrap());
    }
    t
}

#[test]
fn both_robots_meet_every_waypoint_at_the_same_instant() {
    for t in [drive::trajectory(), with_waits()] {
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
        assert!(r.duration() > t.duration());
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
fn the_certificate_holds_on_the_reference_as_on_the_plan() {
    let t = drive::trajectory();
    let scene = drive::scene(&t);
    let plan = pairtrawl_certificate::certify(&scene, drive::NET, &t);
    let fine = certify_reference(&reference(&t), &scene, drive::NET);
    for (a, b) in plan.claims.iter().zip(&fine.claims) {
        assert!(
            a.holds && b.holds,
            "{}: {} on the plan, {} on the reference",
            a.id,
            a.margin,
            b.margin
        );
    }
}

#[test]
fn what_is_no_trajectory_is_refused() {
    let make = |t: &PairTrajectory| {
        Reference::new(
            &Default::default(),
            &Default::default(),
            t,
            &ReferenceLimits::default(),
        )
        .unwrap_err()
    };
    let mut t = drive::trajectory();
    let left = t.len();
    t.right.pop();
    let right = left - 1;
    assert_eq!(make(&t), ReferenceError::Waypoints { left, right });
    let mut t = drive::trajectory();
    t.left[7].x = f64::NAN;
    assert!(matches!(
        make(&t),
        ReferenceError::NotFinite { index: 7, .. }
    ));
    let t = PairTrajectory {
        step_time: 0.0,
        ..drive::trajectory()
    };
    assert!(make(&t).to_string().contains("step time"));
}
