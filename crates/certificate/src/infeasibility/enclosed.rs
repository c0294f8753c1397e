use super::free_space::{FreeSpace, Reached, Run, runs};
use super::joined::joined;
use super::least_move::{Move, advice, least_move};
use super::narrowest::narrowest;
use super::pinned;
use super::proof::{Proof, ProofKind};
use super::things::Things;
use crate::limits::CAUTION;
use pairtrawl_geometry::{Bounds, Convex, Hull, Point, Polygon, Segment};
use pairtrawl_model::Scene;
use pairtrawl_model::numbers::{enough_length, length, place};

/// What is known of an object.
pub(super) enum Verdict {
    /// The line cannot get to it.
    Enclosed(Proof),
    /// Each robot surely gets to a place from which the line could reach it.
    Reachable,
    /// Neither is shown on this grid.
    Open,
}

/// An overlap less deep than this does not hide a cell, m: the claim allows touching.
const TOUCH: f64 = 1e-6;
/// How many times the least distance between robot and object counts as close by.
const CLOSE_BY: f64 = 4.0;
/// A sure place is sought among this many of the nearest cells.
const TRIES: usize = 64;
/// Walls are looked for as chains of cells once the cells' diagonal is below this, in units of the length
/// scale.
const FINE: f64 = 0.2;
/// d_max is at most this many times the separation at the start (claim `separation`).
const MOST_LENGTH: f64 = 10.0;

/// The longest net that the claim `separation` allows at start and end, with some slack for the endpoints' tolerance.
fn longest_net(scene: &Scene) -> f64 {
    MOST_LENGTH * scene.start.separation().min(scene.end.separation()) + 1e-4
}

/// Judges whether both halves of the line can reach an object's center. The words of a proof take longer than the proof: they
/// are found only when they are asked for.
pub(super) fn judge(
    things: &Things<'_>,
    space: &FreeSpace,
    reached: &Reached,
    object: usize,
    net_length: Option<f64>,
    in_words: bool,
) -> Verdict {
    let scene = things.scene;
    let center = scene.objects[object].position;
    if things.obstacles.distance(center, CAUTION).is_some() {
        return Verdict::Reachable; // On or in an obstacle: bad input, nothing to prove.
    }
    let keep = things.keep + scene.objects[object].footprint_radius();
    let longest = longest_net(scene);
    let reach = net_length.unwrap_or(longest).min(longest) - keep + CAUTION;
    // Most objects are settled by what is close by.
    let close = View::new(things, center, reach.min(CLOSE_BY * keep));
    if reached
        .surely
        .iter()
        .all(|surely| close.is_sure(things, space, |i| surely[i]))
    {
        return Verdict::Reachable;
    }
    let mut view = View::new(things, center, reach);
    for (run, may) in runs(scene).into_iter().zip(&reached.may) {
        let mut possible = view.is_possible(space, may);
        if possible && space.size().norm() < FINE * things.scale {
            if view.joined.is_none() {
                view.joined = joined(things, space, center, reach);
            }
            possible = view.is_possible(space, may);
        }
        if !possible {
            let kind = ProofKind::ObjectEnclosed {
                object,
                robot: run.side,
                reach,
                grid: space.evidence(may),
            };
            let (message, least_move) = if in_words {
                words(things, space, reached, (object, reach), run)
            } else {
                (in_brief(things, object, run), None)
            };
            return Verdict::Enclosed(Proof {
                kind,
                message,
                least_move,
            });
        }
    }
    Verdict::Open
}

/// What can be seen from an object's center, and how far its half of the line reaches.
struct View {
    center: Point,
    reach: f64,
    near: Bounds,
    pieces: Vec<Piece>,
    /// The cells that a line may get to, once asked for.
    joined: Option<Vec<bool>>,
}

impl View {
    fn new(things: &Things<'_>, center: Point, reach: f64) -> Self {
        let near = Bounds::of_disc(center, reach.max(0.0));
        let pieces = things
            .obstacles
            .convex_pieces(&near)
            .into_iter()
            .map(Piece::from)
            .collect();
        Self {
            center,
            reach,
            near,
            pieces,
            joined: None,
        }
    }

    /// True when some cell nearby is surely reached and surely in sight.
    fn is_sure(
        &self,
        things: &Things<'_>,
        space: &FreeSpace,
        surely: impl Fn(usize) -> bool,
    ) -> bool {
        let away = |i: usize| space.center(i).distance(self.center);
        let mut cells: Vec<usize> = space
            .cells_near(&self.near)
            .filter(|&i| surely(i))
            .collect();
        cells.sort_by(|&i, &j| away(i).total_cmp(&away(j)).then(i.cmp(&j)));
        let within = cells.into_iter().filter(|&i| away(i) < self.reach);
        within
            .take(TRIES)
            .any(|i| is_clear(things, self.center, space.center(i)))
    }

    /// True when some cell may be reached and in sight.
    fn is_possible(&self, space: &FreeSpace, may: &[bool]) -> bool {
        let at = Bounds::of(&[self.center]);
        let joined = |i: usize| self.joined.as_ref().is_none_or(|joined| joined[i]);
        space
            .cells_near(&self.near)
            .filter(|&i| may[i] && joined(i))
            .any(|i| {
                let cell = space.bounds(i);
                cell.distance(&at) <= self.reach && self.hiding(&cell).is_none()
            })
    }

    /// A piece that hides the whole cell from the center.
    fn hiding(&self, cell: &Bounds) -> Option<&Piece> {
        let Bounds { min, max } = *cell;
        let corners = [min, Point::new(max.x, min.y), max, Point::new(min.x, max.y)];
        self.pieces.iter().find(|piece| {
            corners
                .iter()
                .all(|&corner| piece.cuts(self.center, corner))
        })
    }
}

/// True when a line between the points enters no obstacle. (Pieces do not tell: their seams are no way through.)
fn is_clear(things: &Things<'_>, a: Point, b: Point) -> bool {
    things.obstacles.gap(&Hull::of(&[a, b]), -TOUCH).is_none()
}

/// The points of a convex obstacle piece that are deeper than a touch.
struct Piece {
    region: Region,
    bounds: Bounds,
}

enum Region {
    Disc {
        center: Point,
        radius: f64,
    },
    /// Inward unit normals n and offsets o: the points with n . p >= o.
    HalfPlanes(Vec<(Point, f64)>),
}

impl From<Convex> for Piece {
    fn from(piece: Convex) -> Self {
        match piece {
            Convex::Circle { center, radius } => Self {
                bounds: Bounds::of_disc(center, radius),
                region: Region::Disc {
                    center,
                    radius: radius - TOUCH,
                },
            },
            Convex::Polygon(vertices) => {
                let polygon = Polygon::new(vertices);
                let inward = polygon.signed_area().signum();
                let planes = polygon.edges().filter(|e| e.length() > 0.0).map(|e| {
                    let normal = (e.b - e.a).perp() * (inward / e.length());
                    (normal, normal.dot(e.a) + TOUCH)
                });
                Self {
                    bounds: polygon.bounds(),
                    region: Region::HalfPlanes(planes.collect()),
                }
            }
        }
    }
}

impl Piece {
    /// True when the segment meets the region.
    fn cuts(&self, a: Point, b: Point) -> bool {
        if self.bounds.distance(&Bounds::of(&[a, b])) > 0.0 {
            return false;
        }
        match &self.region {
            Region::Disc { center, radius } => Segment::new(a, b).distance(*center) < *radius,
            Region::HalfPlanes(planes) => {
                // Clip a + t (b - a), t in [0, 1], by every half-plane.
                let (mut low, mut high) = (0.0_f64, 1.0_f64);
                for &(normal, offset) in planes {
                    let (at, slope) = (normal.dot(a) - offset, normal.dot(b - a));
                    if slope > 0.0 {
                        low = low.max(-at / slope);
                    } else if slope < 0.0 {
                        high = high.min(-at / slope);
                    } else if at < 0.0 {
                        return false;
                    }
                }
                low < high
            }
        }
    }
}

/// True when both robots surely get to places with a free line to a point where the object could lie instead, with a
/// robot's distance from it and no farther than `reach`.
pub(super) fn is_surely_reachable(
    things: &Things<'_>,
    space: &FreeSpace,
    reached: &Reached,
    (object, reach): (usize, f64),
    p: Point,
) -> bool {
    let keep = things.keep + things.scene.objects[object].footprint_radius();
    let view = View::new(things, p, reach.min(CLOSE_BY * keep));
    let beside = |surely: &Vec<bool>| {
        let far = |i: usize| space.center(i).distance(p) >= keep;
        view.is_sure(things, space, |i| surely[i] && far(i))
    };
    reached.surely.iter().all(beside)
}

/// That an object is enclosed, without the reason in full.
fn in_brief(things: &Things<'_>, object: usize, run: Run) -> String {
    format!(
        "object {object} at {} is enclosed: no free line leads from it to a place that the {} can reach",
        place(things.scene.objects[object].position),
        run.name
    )
}

/// Why one robot's half of the line, which reaches that far, cannot get to an object, and the least move that would help.
fn words(
    things: &Things<'_>,
    space: &FreeSpace,
    reached: &Reached,
    (object, reach): (usize, f64),
    run: Run,
) -> (String, Option<Move>) {
    let Run {
        side, name: robot, ..
    } = run;
    let may = &reached.may[side.index()];
    let scene = things.scene;
    let center = scene.objects[object].position;
    let keep = things.keep + scene.objects[object].footprint_radius();
    let here = format!("object {object} at {} is enclosed", place(center));
    // Would a longer net do? Cells in sight beyond the reach.
    let longest = longest_net(scene) - keep;
    let view = View::new(things, center, longest);
    let at = Bounds::of(&[center]);
    let mut nearest = f64::INFINITY;
    for i in space.cells_near(&view.near).filter(|&i| may[i]) {
        let cell = space.bounds(i);
        let distance = cell.distance(&at);
        if distance < nearest && view.hiding(&cell).is_none() {
            nearest = distance;
        }
    }
    let message = if nearest <= longest && nearest > reach {
        format!(
            "{here}: the {robot} can stand no nearer than {} with a free line to it, but this net lets it be at most {} away; \
             lengthen the net to at least {}, or open a gap of {} in what encloses it",
            length(nearest),
            length(reach),
            enough_length(nearest + keep),
            enough_length(2.0 * things.largest.radius)
        )
    } else {
        let [start, _] = things.ends_of_largest(side);
        let narrowest = narrowest(things, start, center, Some(object));
        format!(
            "{here}: no free line leads from it to a place that the {robot} can reach; on the widest way there, {}",
            narrowest.words
        )
    };
    let helps = |p: Point| {
        pinned::is_free(things, object, p)
            && is_surely_reachable(things, space, reached, (object, reach), p)
    };
    let least_move = least_move(things, object, helps);
    let message = match least_move {
        Some(_) => format!("{message}; {}", advice(least_move)),
        None => message,
    };
    (message, least_move)
}
