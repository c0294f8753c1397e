//! Scenes that are solvable by construction, each with the solution that it was built around ([`generate`]), and scenes
//! as they are found, which nobody built to be solvable ([`litter()`], [`litter_hall`]).
//!
//! By construction: the pair's trajectory comes first: a centerline of smooth bends and a smooth separation profile, sampled so that
//! every step obeys the planner's mid-step kinematics p\[i+1\] = p\[i\] + s (cos, sin)(phi + dphi/2) exactly. Objects are
//! then put into its band and obstacles outside it. The witness passes every claim of a certificate; it is a proof
//! that the scene can be done, not a good plan.
//!
//! SI units, radians, map frame. The same arguments give the same bits on the same machine.
//!
//! ```
//! use pairtrawl_generate::{Kind, generate, scene_toml, witness_json};
//! let made = generate(Kind::Witness, 5, 1, 200)?;
//! assert_eq!(made.witness.len(), 200);
//! let scene_file = scene_toml(&made.scene)?;
//! let plan_file = witness_json(&made);
//! # assert!(scene_file.starts_with("format = \"pairtrawl-scene/1\"") && plan_file.contains("pairtrawl-plan/1"));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod band;
mod course;
mod floor;
mod hall;
mod kind;
mod level;
mod litter;
mod objects;
mod obstacles;
mod pair;
mod random;
mod scene_file;
mod serpentine;
mod shape;
mod witness_file;

pub use kind::Kind;
pub use litter::{Litter, LitterError, litter, litter_hall};
pub use scene_file::{SceneTomlError, scene_toml, scene_toml_on_map};
pub use witness_file::witness_json;

use band::Band;
use level::Level;
use pairtrawl_geometry::Point;
use pairtrawl_model::{
    Area, NetSpec, PairTrajectory, PhysicsParameters, PlannerParameters, Robot, Scene,
    default_step_time,
};
use random::Random;

/// A scene and its known solution.
#[derive(Clone, Debug, PartialEq)]
pub struct Generated {
    /// The scene. Its net has the length `net_length`; `planner.waypoints` is left to the planner.
    pub scene: Scene,
    /// A trajectory that passes every claim on this scene with this net.
    pub witness: PairTrajectory,
    /// d_max that the witness was built for, m.
    pub net_length: f64,
}

/// Why no scene was made.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum GenerateError {
    /// The difficulty is not on the scale.
    #[error("difficulty is {0}, it must be from 1 (easy) to 10")]
    Difficulty(u8),
    /// Too few waypoints for a course, or too many.
    #[error("waypoints is {0}, it must be from {MIN_WAYPOINTS} to {MAX_WAYPOINTS}")]
    Waypoints(usize),
    /// No course without self-overlap was found.
    #[error("no course without self-overlap in {0} attempts: try another seed or fewer waypoints")]
    NoCourse(usize),
}

/// Fewest waypoints of a generated course.
pub const MIN_WAYPOINTS: usize = 60;
/// Most waypoints of a generated course.
pub const MAX_WAYPOINTS: usize = 50_000;
const ATTEMPTS: usize = 200;

/// Makes a scene with `waypoints` waypoints in its witness (about 4 cm of driving each).
///
/// `difficulty` 1: margins of half a meter, gentle bends, few objects; 10: obstacles within 2 cm of the robots' circles,
/// objects within 5 mm of the miss distance, S-bends, gaps below 1.1 m. In between everything scales geometrically.
///
/// # Errors
/// When an argument is out of its range, or (not seen so far) no course without self-overlap is found.
pub fn generate(
    kind: Kind,
    difficulty: u8,
    seed: u64,
    waypoints: usize,
) -> Result<Generated, GenerateError> {
    if !(1..=10).contains(&difficulty) {
        return Err(GenerateError::Difficulty(difficulty));
    }
    if !(MIN_WAYPOINTS..=MAX_WAYPOINTS).contains(&waypoints) {
        return Err(GenerateError::Waypoints(waypoints));
    }
    let level = Level::new(difficulty);
    let robot = Robot::default();
    let planner = PlannerParameters::default();
    let mut random = Random::new(kind, difficulty, seed);

    let (witness, wall_plan) = (0..ATTEMPTS)
        .find_map(|attempt| {
            let (course, walls) = match kind {
                Kind::Witness => (
                    course::meander(&mut random, &level, waypoints, attempt),
                    None,
                ),
                Kind::Serpentine => {
                    let (course, walls) = serpentine::course(&mut random, &level, waypoints);
                    (course, Some(walls))
                }
            };
            pair::drive(&course, waypoints, &planner, &robot).map(|t| (t, walls))
        })
        .ok_or(GenerateError::NoCourse(ATTEMPTS))?;

    let widest = (0..witness.len())
        .map(|i| {
            let p = witness.pair(i);
            p.separation().max(
                p.left
                    .hitch_point(robot.hitch)
                    .distance(p.right.hitch_point(robot.hitch)),
            )
        })
        .fold(0.0, f64::max);
    // Rounded up to centimeters: a length that a person would write.
    let net_length = (widest * level.net_slack * 100.0).ceil() / 100.0;

    let band = Band::new(&witness, &robot, net_length);
    let obstacles = match &wall_plan {
        Some(walls) => serpentine::walls(walls, &mut random, &level, &band, &robot),
        None => obstacles::scatter(&mut random, &level, &band, &robot),
    };
    let objects = objects::scatter(&mut random, &level, &band, &robot);
    let mut witness = witness;
    witness.step_time = default_step_time(&robot, &planner);

    let last = witness.len() - 1;
    let scene = Scene {
        name: format!("{}-{difficulty}-{seed}-{waypoints}", kind.name()),
        area: area(&witness),
        obstacles,
        map: None,
        objects,
        start: witness.pair(0),
        end: witness.pair(last),
        robot,
        net: NetSpec {
            length: Some(net_length),
            start: None,
        },
        planner,
        physics: PhysicsParameters::default(),
    };
    Ok(Generated {
        scene,
        witness,
        net_length,
    })
}

/// A rectangle around the course with room to go around what stands beside it.
fn area(witness: &PairTrajectory) -> Area {
    const ROOM: f64 = 1.2;
    let points = || {
        witness
            .left
            .iter()
            .chain(&witness.right)
            .map(|p| p.position())
    };
    let bound = |f: fn(f64, f64) -> f64, pick: fn(Point) -> f64| {
        points().map(pick).reduce(f).unwrap_or(0.0)
    };
    let min = Point::new(bound(f64::min, |p| p.x), bound(f64::min, |p| p.y));
    let max = Point::new(bound(f64::max, |p| p.x), bound(f64::max, |p| p.y));
    let decimeters = |v: f64, round: fn(f64) -> f64| round(v * 10.0) / 10.0;
    Area {
        min: Point::new(
            decimeters(min.x - ROOM, f64::floor),
            decimeters(min.y - ROOM, f64::floor),
        ),
        max: Point::new(
            decimeters(max.x + ROOM, f64::ceil),
            decimeters(max.y + ROOM, f64::ceil),
        ),
        resolution: 0.05,
    }
}
