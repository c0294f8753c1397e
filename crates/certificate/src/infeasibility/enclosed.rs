use super::free_space::{FreeSpace, Reached, Run, runs};
use super::joined::joined;
use super::narrowest::narrowest;
use super::things::Things;
use super::{CAUTION, Proof, ProofKind, rounded_up};
use pairtrawl_geometry::{Bounds, Convex, Hull, Point, Polygon, Segment};
use pairtrawl_model::Scene;

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
/// Walls are looked for as chains of cells once the cells' diagonal is below this, m.
const FINE: f64 = 0.2;
/// d_max is at most this many times the separation at the start (claim `separation`).
const MOST_LENGTH: f64 = 10.0;

/// The longest net that the claim `separation` allows at start and end, with some slack for the endpoints' tolerance.
fn longest_net(scene: &Scene) -> f64 {
    MOST_LENGTH * scene.start.separation().min(scene.end.separation()) + 1e-4
}

/// Judges whether both halves of the line can reach an object's center.
pub(super) fn judge(
    things: &Things<'_>,
    space: &FreeSpace,
    reached: &Reached,
    object: usize,
    net_length: Option<f64>,
) -> Verdict {
    let scene = things.scene;
    let center = scene.objects[object].position;
    if things.obstacles.distance(center, CAUTION).is_some() {
        return Verdict::Reachable; // On or in an obstacle: bad input, nothing to prove.
    }
    let keep = scene.robot.radius + scene.objects[object].footprint_radius();
    let longest = longest_net(scene);
    let reach = net_length.unwrap_or(longest).min(longest) - keep + CAUTION;
    // Most objects are settled by what is close by.
    let close = View::new(things, center, reach.min(CLOSE_BY * keep));
    if [0, 1]
        .iter()
        .all(|&side| close.look(things, space, reached, side) == Sight::Sure)
    {
        return Verdict::Reachable;
    }
    let mut view = View::new(things, center, reach);
    let mut verdict = Verdict::Reachable;
    for (side, run) in runs(scene).into_iter().enumerate() {
        let mut sight = view.look(things, space, reached, side);
        if sight == Sight::Possible && view.joined.is_none() && space.size().norm() < FINE {
            view.joined = joined(things, space, center, reach);
            sight = view.look(things, space, reached, side);
        }
        match sight {
            Sight::None => {
                return Verdict::Enclosed(proof(
                    things,
                    space,
                    &reached.may[side],
                    object,
                    run,
                    reach,
                ));
            }
            Sight::Possible => verdict = Verdict::Open,
            Sight::Sure => {}
        }
    }
    verdict
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

/// Whether a robot can stand in sight and in reach.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Sight {
    None,
    Possible,
    Sure,
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

    fn look(
        &self,
        things: &Things<'_>,
        space: &FreeSpace,
        reached: &Reached,
        side: usize,
    ) -> Sight {
        let mut sight = Sight::None;
        let joined = self.joined.as_ref();
        for i in nearest_first(space, &self.near, &reached.may[side], self.center) {
            let cell = space.bounds(i);
            if joined.is_some_and(|joined| !joined[i]) {
                continue;
            }
            if cell.distance(&Bounds::of(&[self.center])) > self.reach {
                continue;
            }
            let place = space.center(i);
            if reached.surely[side][i]
                && place.distance(self.center) < self.reach
                && is_clear(things, self.center, place)
            {
                return Sight::Sure;
            }
            if sight == Sight::None && self.hiding(&cell).is_none() {
                sight = Sight::Possible;
            }
        }
        sight
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

/// The reached cells that a box meets, by the distance of their centers from a point, so that searches end early.
fn nearest_first(space: &FreeSpace, near: &Bounds, reached: &[bool], center: Point) -> Vec<usize> {
    let mut cells: Vec<usize> = space.cells_near(near).filter(|&i| reached[i]).collect();
    cells.sort_by(|&i, &j| {
        space
            .center(i)
            .distance(center)
            .total_cmp(&space.center(j).distance(center))
            .then(i.cmp(&j))
    });
    cells
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

/// Words for an object that one robot's half of the line cannot reach.
fn proof(
    things: &Things<'_>,
    space: &FreeSpace,
    may: &[bool],
    object: usize,
    run: Run,
    reach: f64,
) -> Proof {
    let Run {
        name: robot, start, ..
    } = run;
    let scene = things.scene;
    let center = scene.objects[object].position;
    let keep = scene.robot.radius + scene.objects[object].footprint_radius();
    let here = format!(
        "object {object} at ({:.3}, {:.3}) is enclosed",
        center.x, center.y
    );
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
            "{here}: the {robot} can stand no nearer than {nearest:.3} m with a free line to it, but this net lets it be at \
             most {reach:.3} m away; lengthen the net to at least {:.3} m, or open a gap of {:.3} m in what encloses it",
            rounded_up(nearest + keep),
            2.0 * scene.robot.radius
        )
    } else {
        let narrowest = narrowest(things, start, center, Some(object));
        format!(
            "{here}: no free line leads from it to a place that the {robot} can reach; on the widest way there, {}",
            narrowest.words
        )
    };
    Proof {
        kind: ProofKind::ObjectEnclosed { object },
        message,
    }
}
