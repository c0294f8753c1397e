use super::enclosed::{self, Verdict};
use super::free_space::FreeSpace;
use super::least_move::{Move, is_place};
use super::proof::{GridEvidence, Proof, ProofKind};
use super::things::Things;
use super::{net_too_long, net_too_short, pinned, too_few_waypoints, too_wide, usable, way_cut};
use pairtrawl_model::Scene;
use std::fmt;

/// Numbers agree when they differ by no more than this part of themselves, or this much.
const AGREE: f64 = 1e-9;

/// Why a proof does not hold.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Refusal {
    /// It rests on a net length or on a number of waypoints that is not given.
    NotGiven(&'static str),
    /// It is about an object that the scene does not have, or about a scene that is malformed.
    NoSuchThing,
    /// Its grid is not one on which proofs are seen.
    NoSuchGrid,
    /// Its argument says nothing here.
    DoesNotHold,
    /// Its argument holds, but a number is another one than it states.
    Differs {
        /// Which number.
        name: &'static str,
        /// What it states.
        stated: String,
        /// What follows from the scene.
        found: String,
    },
}

impl fmt::Display for Refusal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NotGiven(what) => write!(f, "it rests on {what}, which is not given"),
            Self::NoSuchThing => f.write_str("it is about something that the scene does not have"),
            Self::NoSuchGrid => f.write_str("its grid is none on which this is looked at"),
            Self::DoesNotHold => f.write_str("its argument does not hold in this scene"),
            Self::Differs {
                name,
                stated,
                found,
            } => write!(f, "it states {name} {stated}, but it is {found}"),
        }
    }
}

/// Verifies one proof without searching: its argument is followed once, on the grid, object, robot, net length and number
/// of waypoints that it names, and every number that it states must come out again. The least move is verified as one that
/// helps, not as the least.
///
/// # Errors
/// When the argument does not hold, or a number is another one.
pub fn verify(
    scene: &Scene,
    net_length: Option<f64>,
    waypoints: Option<usize>,
    kind: &ProofKind,
    least_move: Option<Move>,
) -> Result<(), Refusal> {
    let object_is_there = |object: usize| object < scene.objects.len();
    if !usable(scene, net_length) || !kind.object().is_none_or(object_is_there) {
        return Err(Refusal::NoSuchThing);
    }
    let mut things = Things::new(scene).ok_or(Refusal::NoSuchThing)?;
    // Only numbers are compared: no least move is searched for.
    things.in_words = false;
    let net = || net_length.ok_or(Refusal::NotGiven("a net length"));
    let found = match *kind {
        ProofKind::NetTooShort { .. } => net_too_short::prove(scene, net()?),
        ProofKind::NetTooLong { .. } => net_too_long::prove(scene, net()?),
        ProofKind::TooFewWaypoints { .. } => {
            let given = waypoints.ok_or(Refusal::NotGiven("a number of waypoints"))?;
            too_few_waypoints(scene, given)
        }
        ProofKind::ObjectTooWide { object, .. } => too_wide::about(scene, net()?, object),
        ProofKind::ObjectAtEdge { object, .. } | ProofKind::ObjectPinned { object, .. } => {
            pinned::about(&things, object)
        }
        ProofKind::WayCut { ref grid, .. } => {
            let space = grid_of(&things, grid)?;
            let reached = space.reach(scene).ok_or(Refusal::DoesNotHold)?;
            reached
                .robot_without_way(&space, scene)
                .map(|run| way_cut::proof(&things, &space, &reached, run))
        }
        ProofKind::ObjectEnclosed {
            object, ref grid, ..
        } => {
            let space = grid_of(&things, grid)?;
            let reached = space.reach(scene).ok_or(Refusal::DoesNotHold)?;
            match enclosed::judge(&things, &space, &reached, object, net_length, false) {
                Verdict::Enclosed(proof) => Some(proof),
                Verdict::Reachable | Verdict::Open => None,
            }
        }
    };
    let found = found.ok_or(Refusal::DoesNotHold)?;
    agree(kind, &found.kind)?;
    match least_move {
        Some(least) => helps(&things, &found, least),
        None => Ok(()),
    }
}

/// The grid of a proof, found as the search finds it: by halving cells.
fn grid_of(things: &Things<'_>, grid: &GridEvidence) -> Result<FreeSpace, Refusal> {
    let mut space = FreeSpace::new(things);
    loop {
        let (columns, rows) = space.shape();
        if (columns, rows) == (grid.columns, grid.rows) {
            return Ok(space);
        }
        if columns >= grid.columns {
            return Err(Refusal::NoSuchGrid);
        }
        space = space.refined(things).ok_or(Refusal::NoSuchGrid)?;
    }
}

fn agree(stated: &ProofKind, found: &ProofKind) -> Result<(), Refusal> {
    if stated.name() != found.name() || stated.object() != found.object() {
        return Err(Refusal::DoesNotHold);
    }
    if stated.robot() != found.robot() {
        let name = |kind: &ProofKind| kind.robot().map_or("none", |robot| robot.name()).to_owned();
        return Err(Refusal::Differs {
            name: "robot",
            stated: name(stated),
            found: name(found),
        });
    }
    for ((name, stated), (_, found)) in stated.numbers().into_iter().zip(found.numbers()) {
        same(name, stated, found)?;
    }
    Ok(())
}

fn same(name: &'static str, stated: f64, found: f64) -> Result<(), Refusal> {
    if (stated - found).abs() <= AGREE * (1.0 + found.abs()) {
        return Ok(());
    }
    Err(Refusal::Differs {
        name,
        stated: stated.to_string(),
        found: found.to_string(),
    })
}

/// After the move the same argument says nothing against the object.
fn helps(things: &Things<'_>, proof: &Proof, least: Move) -> Result<(), Refusal> {
    let object = proof.object().ok_or(Refusal::DoesNotHold)?;
    let from = things.scene.objects[object].position;
    same("move.distance", least.distance, least.to.distance(from))?;
    let useless = Refusal::Differs {
        name: "move.to",
        stated: format!("[{}, {}]", least.to.x, least.to.y),
        found: "a place where the argument holds as well".to_owned(),
    };
    let helps = match proof.kind {
        ProofKind::ObjectEnclosed {
            reach, ref grid, ..
        } => {
            let space = grid_of(things, grid)?;
            let reached = space.reach(things.scene).ok_or(Refusal::DoesNotHold)?;
            enclosed::is_surely_reachable(things, &space, &reached, (object, reach), least.to)
        }
        _ => true,
    };
    let helps = helps && pinned::is_free(things, object, least.to);
    match helps && is_place(things, object, least.to) {
        true => Ok(()),
        false => Err(useless),
    }
}
