//! Letters and numbers on the map: L and R at robots and paths, objects by number, circles in the order of their visits.

use super::layers::{Layer, MARK};
use super::projection::View;
use pairtrawl_geometry::{Point, Pose};
use pairtrawl_model::{Footprint, Summary};

/// A text on the map. Its size stays the same whatever the zoom, so it hangs on a place in meters by an offset in pixels.
#[derive(Clone, Debug)]
pub(crate) struct Label {
    /// The layer that it appears and disappears with.
    pub layer: Layer,
    /// `letter`, `visit` or `index`.
    pub class: &'static str,
    /// What it says.
    pub text: String,
    /// What it hangs on, m.
    pub anchor: Point,
    /// From there to the middle of the text, px, y down.
    pub offset: Point,
}

/// Half the height of a label, px.
const HALF_HEIGHT: f64 = 6.0;
/// Space between a label and what it names, px.
const GAP: f64 = 2.0;
/// Half a robot smaller than this has its letter beside itself, px.
const LEAST_BODY: f64 = 8.0;
/// What a point of a path under a label costs, in px^2 of overlap with another label.
const PATH_POINT: f64 = 4.0;

/// All labels of a map that is drawn with `scale` pixels a meter. Where there is a choice each one goes where it covers
/// least.
pub(crate) fn labels(summary: &Summary, view: &View, scale: f64) -> Vec<Label> {
    let mut board = Board::new(summary, view, scale);
    ends(&mut board, summary);
    paths(&mut board, summary);
    circles(&mut board, summary);
    objects(&mut board, summary);
    marks(&mut board, summary);
    board.labels
}

fn ends(board: &mut Board, summary: &Summary) {
    let radius = summary.outline.robot.radius;
    for pair in [summary.outline.start, summary.outline.end] {
        for (text, pose) in [("L", pair.left), ("R", pair.right)] {
            let place = pose.position();
            if board.scale * radius >= LEAST_BODY {
                board.put(Layer::Ends, "letter", text, place, Point::ZERO);
            } else {
                board.beside(Layer::Ends, "letter", text, place, [radius; 2]);
            }
        }
    }
}

/// One letter on each path, halfway, on the outer side of the pair.
fn paths(board: &mut Board, summary: &Summary) {
    let t = &summary.trajectory;
    for (text, poses, side) in [("L", &t.left, 1.0), ("R", &t.right, -1.0)] {
        if let Some(pose) = halfway(poses) {
            let outward = pose.forward().perp() * (side * (HALF_HEIGHT + 3.0));
            let offset = Point::new(outward.x, -outward.y);
            let patch = Patch {
                center: board.pixel(pose.position()) + offset,
                half: Board::half(text),
            };
            // A path too short to hold a letter is told by those of its ends.
            if board.taken.iter().all(|t| t.overlap(&patch) == 0.0) {
                board.put(Layer::Paths, "letter", text, pose.position(), offset);
            }
        }
    }
}

/// The waypoint at which half of the way is driven; `None` when nothing is driven.
fn halfway(poses: &[Pose]) -> Option<&Pose> {
    let step = |w: &[Pose]| w[0].position().distance(w[1].position());
    let total: f64 = poses.windows(2).map(step).sum();
    let mut driven = 0.0;
    let at = poses.windows(2).position(|w| {
        driven += step(w);
        driven > 0.5 * total
    })?;
    poses.get(at + 1)
}

fn circles(board: &mut Board, summary: &Summary) {
    for (visit, index) in summary.order.iter().enumerate() {
        if let Some(circle) = summary.circles.get(*index) {
            let text = (visit + 1).to_string();
            let half = [circle.radius; 2];
            board.beside(Layer::Circles, "visit", &text, circle.center, half);
        }
    }
}

fn objects(board: &mut Board, summary: &Summary) {
    for (i, object) in summary.outline.objects.iter().enumerate() {
        let half = match object.footprint {
            Footprint::Box(width, depth) => [0.5 * width, 0.5 * depth],
            Footprint::Disc(radius) => [radius; 2],
        };
        let text = i.to_string();
        board.beside(Layer::Objects, "index", &text, object.position, half);
    }
}

/// Marks by letters: a, b, ..., z, aa, ab, ...
fn marks(board: &mut Board, summary: &Summary) {
    let half = [MARK * summary.outline.robot.radius; 2];
    for (i, mark) in summary.marks.iter().enumerate() {
        board.beside(Layer::Marks, "note", &mark_name(i), mark.place, half);
    }
}

/// The name of a mark on the map and in lists.
pub(crate) fn mark_name(index: usize) -> String {
    let letter = char::from(b'a' + (index % 26) as u8);
    match index / 26 {
        0 => letter.to_string(),
        more => mark_name(more - 1) + &letter.to_string(),
    }
}

/// A box of the picture, px.
#[derive(Clone, Copy, Debug)]
struct Patch {
    center: Point,
    half: Point,
}

impl Patch {
    fn overlap(&self, other: &Self) -> f64 {
        let reach = self.half + other.half;
        let apart = self.center - other.center;
        (reach.x - apart.x.abs()).max(0.0) * (reach.y - apart.y.abs()).max(0.0)
    }

    fn contains(&self, p: Point) -> bool {
        let d = p - self.center;
        d.x.abs() <= self.half.x && d.y.abs() <= self.half.y
    }
}

/// What is taken of the picture, and the labels so far.
struct Board<'a> {
    view: &'a View,
    scale: f64,
    taken: Vec<Patch>,
    /// Points of the paths, px.
    paths: Vec<Point>,
    labels: Vec<Label>,
}

impl<'a> Board<'a> {
    fn new(summary: &Summary, view: &'a View, scale: f64) -> Self {
        let mut board = Self {
            view,
            scale,
            taken: Vec::new(),
            paths: Vec::new(),
            labels: Vec::new(),
        };
        let objects = summary.outline.objects.iter().map(|o| Patch {
            center: board.pixel(o.position),
            half: Point::new(1.0, 1.0) * (scale * o.footprint_radius()),
        });
        board.taken = objects.collect();
        let poses = summary
            .trajectory
            .left
            .iter()
            .chain(&summary.trajectory.right);
        board.paths = poses.map(|p| board.pixel(p.position())).collect();
        board
    }

    /// Pixels from the view's upper left corner, y down.
    fn pixel(&self, p: Point) -> Point {
        Point::new(p.x - self.view.min.x, self.view.max.y - p.y) * self.scale
    }

    fn half(text: &str) -> Point {
        Point::new(4.0 * text.len() as f64, HALF_HEIGHT)
    }

    fn put(&mut self, layer: Layer, class: &'static str, text: &str, anchor: Point, offset: Point) {
        let View { min, max } = *self.view;
        let inside = |v: f64, low: f64, high: f64| (low..=high).contains(&v);
        if !inside(anchor.x, min.x, max.x) || !inside(anchor.y, min.y, max.y) {
            return; // Nobody would see it.
        }
        self.taken.push(Patch {
            center: self.pixel(anchor) + offset,
            half: Self::half(text),
        });
        self.labels.push(Label {
            layer,
            class,
            text: text.to_owned(),
            anchor,
            offset,
        });
    }

    /// Beside something of the given half width and half height in meters, in that of eight directions in which the label
    /// covers least.
    fn beside(
        &mut self,
        layer: Layer,
        class: &'static str,
        text: &str,
        center: Point,
        half: [f64; 2],
    ) {
        let size = Self::half(text);
        let diagonal = std::f64::consts::FRAC_1_SQRT_2;
        let directions = [
            (1.0, 1.0),
            (-1.0, 1.0),
            (1.0, -1.0),
            (-1.0, -1.0),
            (0.0, 1.0),
            (1.0, 0.0),
            (0.0, -1.0),
            (-1.0, 0.0),
        ];
        let candidates = directions.map(|(x, y): (f64, f64)| {
            let share = if x * y == 0.0 { 1.0 } else { diagonal };
            let anchor = center + Point::new(x * half[0], y * half[1]) * share;
            let offset = Point::new(x * (size.x + GAP), -y * (size.y + GAP));
            let patch = Patch {
                center: self.pixel(anchor) + offset,
                half: size,
            };
            (self.covered(&patch), anchor, offset)
        });
        // The first of equals: up and to the right is where people look first.
        let best = candidates
            .into_iter()
            .reduce(|best, other| if other.0 < best.0 { other } else { best });
        if let Some((_, anchor, offset)) = best {
            self.put(layer, class, text, anchor, offset);
        }
    }

    fn covered(&self, patch: &Patch) -> f64 {
        let others: f64 = self.taken.iter().map(|t| t.overlap(patch)).sum();
        let points = self.paths.iter().filter(|p| patch.contains(**p)).count();
        others + PATH_POINT * points as f64
    }
}
