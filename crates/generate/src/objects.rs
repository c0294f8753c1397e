use crate::band::Band;
use crate::level::Level;
use crate::random::Random;
use pairtrawl_geometry::Point;
use pairtrawl_model::{Footprint, Object, Robot};

/// Waypoints at both ends of the course beside which no object lies.
const ENDS: usize = 12;
/// Least distance of two objects' centers, m.
const APART: f64 = 0.075;

/// Cubes and discs in the band, some as close to a robot's path as the level allows.
pub(crate) fn scatter(
    random: &mut Random,
    level: &Level,
    band: &Band<'_>,
    robot: &Robot,
) -> Vec<Object> {
    let wanted = ((band.length() * level.objects_per_meter).round() as usize).max(3);
    let mut placed: Vec<Object> = Vec::with_capacity(wanted);
    let mut attempts = 0;
    while placed.len() < wanted && attempts < 60 * wanted {
        attempts += 1;
        let object = draw(random, level, band, robot);
        let apart = placed
            .iter()
            .all(|o| o.position.distance(object.position) >= APART);
        let keep = robot.radius + object.footprint_radius() + 0.2 * level.object_margin;
        if apart && band.covers(object.position) && band.path_distance(object.position, 2.0) >= keep
        {
            placed.push(object);
        }
    }
    placed
}

fn draw(random: &mut Random, level: &Level, band: &Band<'_>, robot: &Robot) -> Object {
    let footprint = if random.chance(0.85) {
        Footprint::Box(0.05, 0.05)
    } else {
        Footprint::Disc((random.between(0.02, 0.035) * 1000.0).round() / 1000.0)
    };
    let mass = (random.between(0.015, 0.05) * 1000.0).round() / 1000.0;
    let at = random.index(ENDS, band.witness.len() - ENDS);
    let pair = band.witness.pair(at);
    let (left, right) = (pair.left.position(), pair.right.position());
    let mut object = Object {
        position: Point::ZERO,
        footprint,
        mass,
        leave: false,
    };
    let miss = robot.radius + object.footprint_radius();
    let share = if random.chance(level.tight_objects) {
        // Within the level's margin of the miss distance of one robot; the other robot may be as close.
        let tight = (miss + level.object_margin * random.between(0.3, 1.0)) / pair.separation();
        if random.chance(0.5) {
            tight
        } else {
            1.0 - tight
        }
    } else {
        let free = (miss + level.object_margin) / pair.separation();
        random.between(free.min(0.5), (1.0 - free).max(0.5))
    };
    let p = left.lerp(right, share);
    // A tenth of a millimeter, as the files of real scenes have it.
    object.position = Point::new((p.x * 1e4).round() / 1e4, (p.y * 1e4).round() / 1e4);
    object
}
