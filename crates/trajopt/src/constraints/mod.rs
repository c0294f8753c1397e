//! Constraints `c >= 0` in local coordinates, one file each, and the lists in which the solver finds them.

pub(crate) mod abreast;
pub(crate) mod bodies_apart;
pub(crate) mod body_distance;
pub(crate) mod carried;
pub(crate) mod half_plane;
pub(crate) mod net_reach;
pub(crate) mod own;
pub(crate) mod point_distance;
pub(crate) mod quad_distance;
pub(crate) mod separation;
pub(crate) mod step_bounds;

use crate::anchor::{LineAt, PairAt, PointAt, PoseAt, StepAt};
use crate::costs::turning::TurnCost;
use crate::term::{PAIR, POINT, POSE, QUAD, STEP};
use abreast::KeepAbreast;
use bodies_apart::BodiesApart;
use body_distance::{BodyOffObject, BodyOffObstacle};
use half_plane::{BesideObject, InsideArea};
use net_reach::HitchesWithinReach;
use own::{OwnPair, OwnPoint};
use point_distance::{OffObject, OffObstacle};
use quad_distance::LineOffObstacle;
use separation::{CloseEnough, FarEnoughApart};
use step_bounds::{Forward, StepLength, TurnLimit};

rules! {
    /// Of one robot over one step.
    StepRules at StepAt, STEP;
    Forward,
    StepLength,
    TurnLimit,
    TurnCost,
}

rules! {
    /// Of the pair at one waypoint.
    PairRules at PairAt, PAIR;
    FarEnoughApart,
    CloseEnough,
    HitchesWithinReach,
    KeepAbreast,
    OwnPair,
    BodiesApart,
}

rules! {
    /// Of one robot's axle center at one waypoint.
    PointRules at PointAt, POINT;
    OffObject,
    OffObstacle,
    BesideObject,
    InsideArea,
    OwnPoint,
}

rules! {
    /// Of one robot's pose at one waypoint: circles of its body that are off the axle.
    BodyRules at PoseAt, POSE;
    BodyOffObject,
    BodyOffObstacle,
}

rules! {
    /// Of the line between the robots over one step.
    LineRules at LineAt, QUAD;
    LineOffObstacle,
}
