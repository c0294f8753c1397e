use pairtrawl_geometry::{Bounds, Point, Pose};
use pairtrawl_model::{BodyCircle, PairTrajectory, Scales, Scene, Side};
use pairtrawl_reference::Reference;

/// How the motion between waypoints is read.
#[derive(Clone, Copy)]
pub(crate) enum Reading<'a> {
    /// Positions and headings are linear in time.
    Linear(&'a PairTrajectory),
    /// Each robot rolls along the smooth curve of the reference.
    Smooth(&'a Reference),
}

/// A stretch of one step, with bounds on how far both robots stray from even motion between its ends. Arrays over robots
/// are by [`Side::index`].
#[derive(Clone, Copy, Debug)]
pub(crate) struct Stretch {
    /// The step.
    pub(crate) step: usize,
    /// Where in the step the stretch begins and ends, in [0, 1].
    pub(crate) span: [f64; 2],
    /// Poses at its beginning.
    pub(crate) from: [Pose; 2],
    /// Poses at its end.
    pub(crate) to: [Pose; 2],
    bend: [Bend; 2],
    bow: [f64; 2],
}

/// Greatest magnitudes of derivatives by the part of the stretch that is done. A robot's position p and heading phi obey
/// p'' = (s' + i s phi') u, where u is the unit vector along the heading and i turns by +90 degrees; for linear positions
/// s = s' = 0 serves, since only departures from even motion count.
#[derive(Clone, Copy, Debug, Default)]
struct Bend {
    /// |s|, m.
    speed: f64,
    /// |s'|, m.
    speed_slope: f64,
    /// |s''|, m.
    speed_bend: f64,
    /// |phi'|, rad.
    rate: f64,
    /// |phi''|, rad.
    rate_slope: f64,
    /// |phi'''|, rad.
    rate_bend: f64,
}

/// Where a point of a robot is in the middle of a stretch, with derivatives by the part of the stretch that is done, m.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Middle {
    pub(crate) place: Point,
    pub(crate) velocity: Point,
    pub(crate) acceleration: Point,
}

impl Stretch {
    /// How far the robot may be from even motion between the ends, m: a curve stays within max|p''| / 8 of its chord.
    pub(crate) fn bow(&self, side: Side) -> f64 {
        self.bow[side.index()]
    }

    /// How far the heading may be from even turning between the ends, rad.
    pub(crate) fn heading_bow(&self, side: Side) -> f64 {
        self.bend[side.index()].rate_slope / 8.0
    }

    /// How far a point of the robot that is `offset` m away from the axle center, in whatever direction, may be from even
    /// motion between the ends, m.
    pub(crate) fn bow_off_axle(&self, side: Side, offset: f64) -> f64 {
        let b = &self.bend[side.index()];
        self.bow(side) + offset.abs() * Point::new(b.rate_slope, b.rate * b.rate).norm() / 8.0
    }

    /// The center of a circle of a robot's body at the beginning and at the end, and how far it may be from even motion
    /// between them, m.
    pub(crate) fn path_of(&self, side: Side, circle: &BodyCircle) -> ([Point; 2], f64) {
        let ends = [self.from, self.to].map(|pair| circle.center_at(pair[side.index()]));
        (ends, self.bow_off_axle(side, circle.offset()))
    }

    /// Bound of the third derivative of that point, m.
    pub(crate) fn third_behind(&self, side: Side, behind: f64) -> f64 {
        let b = &self.bend[side.index()];
        let turned = 2.0 * b.speed_slope * b.rate + b.speed * b.rate_slope;
        let place = Point::new(b.speed_bend + b.speed * b.rate * b.rate, turned);
        let cubed = b.rate * b.rate * b.rate;
        let unit = Point::new(3.0 * b.rate * b.rate_slope, b.rate_bend + cubed);
        place.norm() + behind.abs() * unit.norm()
    }

    /// No point of the line between the robots moves farther than this, m.
    pub(crate) fn travel(&self) -> f64 {
        let [l0, l1, r1, r0] = self.corners();
        let chord = l0.distance(l1).max(r0.distance(r1));
        chord.max(self.bend[0].speed).max(self.bend[1].speed)
    }

    /// The greater bow of both robots, m.
    pub(crate) fn greatest_bow(&self) -> f64 {
        self.bow(Side::Left).max(self.bow(Side::Right))
    }

    /// A box that the line between the robots does not leave.
    pub(crate) fn bounds(&self) -> Bounds {
        Bounds::of(&self.corners()).grown(self.greatest_bow())
    }

    /// The positions left and right at the beginning, right and left at the end, in order around the swept region.
    pub(crate) fn corners(&self) -> [Point; 4] {
        let [[l0, r0], [l1, r1]] = [self.from, self.to].map(|pair| pair.map(Pose::position));
        [l0, l1, r1, r0]
    }
}

impl<'a> Reading<'a> {
    /// A tolerance of the waypoints, as it applies here: the smooth curve of a machine larger than the paper's meets its
    /// waypoints to the same part of its size.
    pub(crate) fn tolerance(&self, tolerance: f64, scene: &Scene) -> f64 {
        match self {
            Self::Linear(_) => tolerance,
            Self::Smooth(_) => tolerance * Scales::of(scene).length.max(1.0),
        }
    }

    /// What is added to the words about a place.
    pub(crate) fn suffix(&self) -> &'static str {
        match self {
            Self::Linear(_) => "",
            Self::Smooth(_) => " (on the smooth curve)",
        }
    }

    /// All steps, whole.
    pub(crate) fn steps(&self) -> Vec<Stretch> {
        let count = match self {
            Self::Linear(trajectory) => trajectory.len(),
            Self::Smooth(reference) => reference.waypoints(),
        };
        let poses = |step, w| Side::BOTH.map(|side| self.pose(side, step, w));
        (0..count.saturating_sub(1))
            .map(|step| self.stretch(step, [0.0, 1.0], poses(step, 0.0), poses(step, 1.0)))
            .collect()
    }

    /// The pose of a robot at w in [0, 1] of a step.
    pub(crate) fn pose(&self, side: Side, step: usize, w: f64) -> Pose {
        match self {
            Self::Linear(_) if w == 1.0 => self.chord(side, step)[1],
            Self::Linear(_) => {
                let [from, to] = self.chord(side, step);
                from.lerp(to, w)
            }
            Self::Smooth(reference) => reference.steps(side)[step].pose(w),
        }
    }

    /// The two halves of a stretch.
    pub(crate) fn halves(&self, stretch: &Stretch) -> [Stretch; 2] {
        let [a, b] = stretch.span;
        let m = 0.5 * (a + b);
        let middle = Side::BOTH.map(|side| self.pose(side, stretch.step, m));
        [
            self.stretch(stretch.step, [a, m], stretch.from, middle),
            self.stretch(stretch.step, [m, b], middle, stretch.to),
        ]
    }

    /// The point of a robot `behind` m behind its axle, in the middle of a stretch.
    pub(crate) fn middle(&self, side: Side, stretch: &Stretch, behind: f64) -> Middle {
        let [a, b] = stretch.span;
        let (m, h) = (0.5 * (a + b), b - a);
        let (pose, velocity, speed, speed_slope, rate, rate_slope) = match self {
            Self::Linear(_) => {
                let [from, to] = self.chord(side, stretch.step);
                let velocity = (to.position() - from.position()) * h;
                let rate = (to.heading - from.heading) * h;
                (from.lerp(to, m), velocity, 0.0, 0.0, rate, 0.0)
            }
            Self::Smooth(reference) => {
                let s = reference.steps(side)[stretch.step].at(m);
                let velocity = s.pose.forward() * (s.speed * h);
                let h2 = h * h;
                let slopes = (s.speed_slope * h2, s.rate_slope * h2);
                (
                    s.pose,
                    velocity,
                    s.speed * h,
                    slopes.0,
                    s.rate * h,
                    slopes.1,
                )
            }
        };
        let u = pose.forward();
        let across = u.perp();
        Middle {
            place: pose.position() - u * behind,
            velocity: velocity - across * (rate * behind),
            acceleration: u * (speed_slope + behind * rate * rate)
                + across * (speed * rate - behind * rate_slope),
        }
    }

    fn chord(&self, side: Side, step: usize) -> [Pose; 2] {
        match self {
            Self::Linear(trajectory) => {
                let poses = [&trajectory.left, &trajectory.right][side.index()];
                [poses[step], poses[step + 1]]
            }
            Self::Smooth(_) => [0.0, 1.0].map(|w| self.pose(side, step, w)),
        }
    }

    fn stretch(&self, step: usize, span: [f64; 2], from: [Pose; 2], to: [Pose; 2]) -> Stretch {
        let h = span[1] - span[0];
        let bend = Side::BOTH.map(|side| match self {
            Self::Linear(_) => Bend {
                rate: (to[side.index()].heading - from[side.index()].heading).abs(),
                ..Bend::default()
            },
            Self::Smooth(reference) => {
                let b = reference.steps(side)[step].bounds(span);
                let (h2, h3) = (h * h, h * h * h);
                Bend {
                    speed: b.fastest() * h,
                    speed_slope: b.speed_slope * h2,
                    speed_bend: b.speed_bend * h3,
                    rate: b.sharpest() * h,
                    rate_slope: b.rate_slope * h2,
                    rate_bend: b.rate_bend * h3,
                }
            }
        });
        let bow = bend.map(|b| Point::new(b.speed_slope, b.speed * b.rate).norm() / 8.0);
        Stretch {
            step,
            span,
            from,
            to,
            bend,
            bow,
        }
    }
}
