use crate::course::Course;
use pairtrawl_geometry::{Point, Pose, wrap_angle};
use pairtrawl_model::{PairTrajectory, PlannerParameters, Robot};

/// Share of every limit that the witness uses at most.
const LIMIT_SHARE: f64 = 0.99;

/// Drives the pair along a course: positions on the offset curves, headings such that every chord points along the
/// mid-step heading exactly.
///
/// With chord directions chi\[i\] the recursion phi\[i+1\] = 2 chi\[i\] - phi\[i\] makes the slip zero. Its alternating
/// error stays of the order of step^3 because the curves have a continuous slope of curvature.
///
/// `None` when the course overlaps itself or a limit of the planner is touched.
pub(crate) fn drive(
    course: &Course,
    waypoints: usize,
    planner: &PlannerParameters,
    robot: &Robot,
) -> Option<PairTrajectory> {
    let mut center = course.start();
    let mut u = 0.0;
    let mut centers = Vec::with_capacity(waypoints);
    let (mut left, mut right) = (Vec::with_capacity(waypoints), Vec::with_capacity(waypoints));
    for _ in 0..waypoints {
        let s = course.station(u);
        let normal = Point::unit(s.heading).perp();
        centers.push((u, center, s.half));
        left.push(center + normal * s.half);
        right.push(center - normal * s.half);
        let next = u + course.step / outer_speed(course, u);
        // The faster of both ends of the step decides.
        let next = u + course.step / outer_speed(course, u).max(outer_speed(course, next));
        center += displacement(course, u, next);
        u = next;
    }
    if overlaps_itself(&centers, robot) {
        return None;
    }
    let trajectory = PairTrajectory {
        left: with_headings(&left, course, 1.0),
        right: with_headings(&right, course, -1.0),
        step_time: 0.0,
    };
    within_limits(&trajectory, planner, robot).then_some(trajectory)
}

/// Speed of the faster robot per meter of centerline.
fn outer_speed(course: &Course, u: f64) -> f64 {
    let s = course.station(u);
    Point::new(1.0 + (s.curvature * s.half).abs(), s.half_slope).norm()
}

/// Displacement of the center from arc length `a` to `b` (Gauss-Legendre, four points).
fn displacement(course: &Course, a: f64, b: f64) -> Point {
    const NODES: [(f64, f64); 4] = [
        (-0.861_136_311_594_052_6, 0.347_854_845_137_453_85),
        (-0.339_981_043_584_856_26, 0.652_145_154_862_546_1),
        (0.339_981_043_584_856_26, 0.652_145_154_862_546_1),
        (0.861_136_311_594_052_6, 0.347_854_845_137_453_85),
    ];
    let (middle, half) = (0.5 * (a + b), 0.5 * (b - a));
    NODES.iter().fold(Point::ZERO, |sum, &(x, w)| {
        sum + Point::unit(course.station(middle + half * x).heading) * (w * half)
    })
}

/// Poses through the points of one side (+1 left, -1 right).
fn with_headings(points: &[Point], course: &Course, side: f64) -> Vec<Pose> {
    let s = course.station(0.0);
    let mut heading =
        s.heading + libm::atan2(side * s.half_slope, 1.0 - side * s.curvature * s.half);
    let mut poses = vec![Pose::at(points[0], heading)];
    for w in points.windows(2) {
        let chord = (w[1] - w[0]).angle();
        heading += 2.0 * wrap_angle(chord - heading);
        poses.push(Pose::at(w[1], heading));
    }
    poses
}

/// True when two distant parts of the course come closer than both robots need to pass each other's tracks.
fn overlaps_itself(centers: &[(f64, Point, f64)], robot: &Robot) -> bool {
    const STRIDE: usize = 4;
    let sparse: Vec<_> = centers.iter().step_by(STRIDE).collect();
    sparse.iter().enumerate().any(|(i, a)| {
        sparse[i + 1..].iter().any(|b| {
            let room = a.2 + b.2 + 2.0 * robot.radius;
            // A U-turn of diameter `room` has an arc of pi/2 times that.
            b.0 - a.0 > 1.8 * room && a.1.distance(b.1) < room
        })
    })
}

fn within_limits(t: &PairTrajectory, planner: &PlannerParameters, robot: &Robot) -> bool {
    let steps = |poses: &[Pose]| {
        poses.windows(2).all(|w| {
            let chord = w[1].position() - w[0].position();
            let turn = w[1].heading - w[0].heading;
            chord.norm() <= LIMIT_SHARE * planner.max_step
                && chord.norm() >= 1e-3
                && turn.abs() <= LIMIT_SHARE * planner.max_turn
        })
    };
    let abreast = (0..t.len()).all(|i| {
        let p = t.pair(i);
        let normal = p.normal_heading();
        let skew = |h: f64| wrap_angle(h - normal).abs();
        skew(p.left.heading).max(skew(p.right.heading)) <= 0.8 * planner.max_skew
            && p.separation() >= 2.0 * robot.radius + 0.02
    });
    steps(&t.left) && steps(&t.right) && abreast
}
