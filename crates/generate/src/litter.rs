//! Scenes as they are found: litter on the floor of a mapped building, or in an open hall. Nobody built them to be solvable.

use crate::floor::Floor;
use crate::hall;
use crate::random::Random;
use pairtrawl_geometry::{Point, Pose};
use pairtrawl_model::{
    Area, Footprint, NetSpec, Object, OccupancyMap, PairPose, PhysicsParameters, PlannerParameters,
    Robot, Scene,
};

/// How much litter lies where.
#[derive(Clone, Debug, PartialEq)]
pub struct Litter {
    /// The scene's name.
    pub name: String,
    /// How many objects lie there.
    pub objects: usize,
    /// Every object's center keeps this from walls, m, and from the edge of the area.
    pub near: f64,
    /// The same seed gives the same scene.
    pub seed: u64,
}

/// Why no litter was scattered.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum LitterError {
    /// The pair fits nowhere.
    #[error(
        "nowhere is there room for two robots of radius {radius} m beside each other: take another map, or a larger hall"
    )]
    NoFloor {
        /// Radius of a robot, m.
        radius: f64,
    },
    /// The pair has no place to start or end.
    #[error(
        "no place to {what} was found in {ATTEMPTS} attempts: two robots abreast need {width:.2} m by {length:.2} m there"
    )]
    NoStand {
        /// Start or end.
        what: &'static str,
        /// Width of the free rectangle that they need, m.
        width: f64,
        /// Its length, m.
        length: f64,
    },
    /// The floor is full.
    #[error(
        "only {placed} of {wanted} objects found a place {near} m from walls and off one another: take fewer, or a lower --near"
    )]
    Full {
        /// How many there are.
        placed: usize,
        /// How many there should be.
        wanted: usize,
        /// What they keep from walls, m.
        near: f64,
    },
    /// The boxes of a hall do not fit.
    #[error(
        "only {placed} of {wanted} boxes found a place in the hall: take fewer, or a larger hall"
    )]
    Boxes {
        /// How many there are.
        placed: usize,
        /// How many there should be.
        wanted: usize,
    },
}

/// Tries for one thing before it is given up.
const ATTEMPTS: usize = 20_000;
/// Between the footprint circles of two objects at least this is left, m.
const APART: f64 = 0.01;
/// Between a robot at the start or end and an object at least this is left, m.
const OFF_ROBOTS: f64 = 0.02;
/// Least and greatest separation of the robots at start and end, in radii.
const SEPARATION: (f64, f64) = (2.4, 3.0);
/// Free floor that the pair has ahead of it at the start and behind it at the end, in radii: nobody sets it down before a wall.
const AHEAD: f64 = 2.5;
/// Free floor on the other side, in radii.
const BEHIND: f64 = 1.25;

/// Scatters litter over the floor of a map, as map_server gives it.
///
/// Objects lie uniformly where they keep `near` from walls and the pair could come at all: in the free disc around a cell
/// of the largest region of the map that two robots which touch can pass at their greatest skew. Start and end are anywhere
/// there where the pair has free floor for a few robot radii ahead and behind.
///
/// # Errors
/// When there is no room for the pair or for so many objects.
pub fn litter(map: OccupancyMap, area: Area, about: &Litter) -> Result<Scene, LitterError> {
    let mut random = Random::of_litter(about.seed, map.columns, map.rows);
    let scene = empty(about, area, Some(map));
    scatter(scene, about, &mut random)
}

/// Scatters litter in an open hall of this width and depth, m, with this many boxes in it.
///
/// # Errors
/// When there is no room for the boxes, the pair or so many objects.
pub fn litter_hall(size: [f64; 2], boxes: usize, about: &Litter) -> Result<Scene, LitterError> {
    let mut random = Random::of_hall(about.seed);
    let area = Area {
        min: Point::ZERO,
        max: Point::new(size[0], size[1]),
        resolution: 0.05,
    };
    let mut scene = empty(about, area, None);
    scene.obstacles =
        hall::boxes(&mut random, &scene.area, boxes).map_err(|placed| LitterError::Boxes {
            placed,
            wanted: boxes,
        })?;
    scatter(scene, about, &mut random)
}

/// A scene without objects whose start and end are still to be found.
fn empty(about: &Litter, area: Area, map: Option<OccupancyMap>) -> Scene {
    let nowhere = PairPose {
        left: Pose::at(area.min, 0.0),
        right: Pose::at(area.min, 0.0),
    };
    Scene {
        name: about.name.clone(),
        area,
        obstacles: Vec::new(),
        map,
        objects: Vec::new(),
        start: nowhere,
        end: nowhere,
        robot: Robot::default(),
        net: NetSpec::default(),
        planner: PlannerParameters::default(),
        physics: PhysicsParameters::default(),
    }
}

/// Finds a start, an end and a place for each object.
fn scatter(mut scene: Scene, about: &Litter, random: &mut Random) -> Result<Scene, LitterError> {
    let radius = scene.robot.radius;
    let floor = Floor::of(&scene).ok_or(LitterError::NoFloor { radius })?;
    let no_stand = |what| LitterError::NoStand {
        what,
        width: (SEPARATION.0 + 2.0) * radius,
        length: (AHEAD + BEHIND + 2.0) * radius,
    };
    let start = stand(&floor, &scene, random, [-BEHIND, AHEAD]).ok_or(no_stand("start"))?;
    let end = stand(&floor, &scene, random, [-AHEAD, BEHIND]).ok_or(no_stand("end"))?;
    let robots = [start.left, start.right, end.left, end.right].map(|pose| pose.position());
    let mut objects: Vec<Object> = Vec::with_capacity(about.objects);
    while objects.len() < about.objects {
        let mut item = draw_item(random);
        let rho = item.footprint_radius();
        let lies_well = |p: &Point| {
            let p = *p;
            floor.is_free(p, about.near.max(rho))
                && floor.touches(p)
                && robots
                    .iter()
                    .all(|r| r.distance(p) >= radius + rho + OFF_ROBOTS)
                && objects
                    .iter()
                    .all(|o| o.position.distance(p) >= rho + o.footprint_radius() + APART)
        };
        let place = (0..ATTEMPTS)
            .map(|_| rounded(floor.draw_free(random)))
            .find(lies_well);
        item.position = place.ok_or(LitterError::Full {
            placed: objects.len(),
            wanted: about.objects,
            near: about.near,
        })?;
        objects.push(item);
    }
    scene.start = start;
    scene.end = end;
    scene.objects = objects;
    Ok(scene)
}

/// A place for the pair: abreast, both robots on the floor, and free floor from `along[0]` to `along[1]` radii ahead.
fn stand(
    floor: &Floor<'_>,
    scene: &Scene,
    random: &mut Random,
    along: [f64; 2],
) -> Option<PairPose> {
    let radius = scene.robot.radius;
    (0..ATTEMPTS).find_map(|_| {
        let middle = floor.draw(random);
        let heading = random.between(-std::f64::consts::PI, std::f64::consts::PI);
        // A tenth of a milliradian and of a millimeter, as a person would write them.
        let heading = (heading * 1e4).round() / 1e4;
        let half = 0.5 * radius * random.between(SEPARATION.0, SEPARATION.1);
        let forward = Point::unit(heading);
        let side = forward.perp() * half;
        let (left, right) = (rounded(middle + side), rounded(middle - side));
        let corners = along.map(|a| forward * (a * radius));
        let corners = [
            left + corners[0],
            left + corners[1],
            right + corners[0],
            right + corners[1],
        ];
        let fits = floor.holds(left)
            && floor.holds(right)
            && floor.has_room(&corners, radius + scene.planner.clearance);
        fits.then_some(PairPose {
            left: Pose::at(left, heading),
            right: Pose::at(right, heading),
        })
    })
}

/// A cup, a can or a small box, somewhere; m and kg.
fn draw_item(random: &mut Random) -> Object {
    let millimeters = |v: f64| (v * 1e3).round() / 1e3;
    let (footprint, mass) = match random.index(0, 4) {
        // An empty can: 66 mm across.
        0 => (Footprint::Disc(0.033), random.between(0.013, 0.03)),
        // A paper cup: 70 to 90 mm across.
        1 => (
            Footprint::Disc(millimeters(random.between(0.035, 0.045))),
            random.between(0.008, 0.02),
        ),
        // Small packages and cubes of 3 to 10 cm, of cardboard or foam: 60 to 150 kg per cubic meter.
        _ => {
            let edge = millimeters(random.between(0.03, 0.1));
            let other = millimeters((edge * random.between(0.6, 1.0)).max(0.03));
            let density = random.between(60.0, 150.0);
            let mass = edge * other * other * density;
            (Footprint::Box(edge, other), mass.max(0.005))
        }
    };
    Object {
        position: Point::ZERO,
        footprint,
        mass: millimeters(mass),
        leave: false,
    }
}

/// To a tenth of a millimeter.
fn rounded(p: Point) -> Point {
    Point::new((p.x * 1e4).round() / 1e4, (p.y * 1e4).round() / 1e4)
}
