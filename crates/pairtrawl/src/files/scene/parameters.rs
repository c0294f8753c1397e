//! `[robot]`, `[net]`, `[planner]` and `[physics]`. Keys are named as the fields of the model's types.

use super::body;
use crate::files::FileError;
use crate::files::toml_reader::Range::{Length, NotNegative, Positive, UpTo};
use crate::files::toml_reader::{Range, Table, Value};
use pairtrawl_model::{
    ExpansionPer, Leave, NetSpec, PhysicsParameters, PlannerParameters, Preset, Robot, RobotSize,
    Warning,
};
use std::f64::consts::{FRAC_PI_2, PI};

/// Bounds that keep a run finite.
const MOST_WAYPOINTS: usize = 100_000;
const MOST_ALTERNATIONS: usize = 10_000;
const MOST_NET_POINTS: usize = 10_000;
/// Longest step of a machine of the paper's size, m: four radii, beyond which a step is a leap.
const LONGEST_STEP: f64 = 1.0;
/// A cruise speed below this part of the robot's greatest one is worth a warning.
const SLOW: f64 = 0.2;

/// `[robot]`, and the preset that it names.
pub(super) fn robot(
    root: &Table<'_>,
    warnings: &mut Vec<Warning>,
) -> Result<(Robot, Option<Preset>), FileError> {
    let Some(table) = root.table("robot")? else {
        return Ok((Robot::default(), None));
    };
    let preset = table.get("preset");
    let preset = preset
        .map(|v| named(&v, Preset::ALL, Preset::name))
        .transpose()?;
    let standard = preset.map_or_else(Robot::default, Preset::robot);
    let mut robot = standard;
    set(
        &table,
        &mut [
            ("radius", Length, &mut robot.radius),
            ("hitch", NotNegative, &mut robot.hitch),
            ("v_max", Length, &mut robot.v_max),
            ("omega_max", UpTo(1e3), &mut robot.omega_max),
            ("half_track", Length, &mut robot.half_track),
        ],
        &["preset", "body"],
    )?;
    let given = table.get("body").map(|v| body::read(&v)).transpose()?;
    if let Some(body) = given {
        robot = robot.with_body(body);
    } else if robot.body.is_some() {
        robot.radius = standard.radius;
    }
    if robot.body.is_some() && table.get("radius").is_some() {
        let instead = match given {
            Some(_) => "robot.body",
            None => "the body of robot.preset",
        };
        let key = "robot.radius";
        warnings.push(Warning::Unused { key, instead });
    }
    Ok((robot, preset))
}

/// The one of these that has the name.
fn named<T: Copy, const N: usize>(
    value: &Value<'_>,
    all: [T; N],
    name: impl Fn(T) -> &'static str,
) -> Result<T, FileError> {
    let given = value.text()?;
    let known = all.into_iter().find(|&one| name(one) == given);
    known.ok_or_else(|| {
        let names = all.map(|one| format!("{:?}", name(one)));
        value.refuse(names.join(" or "))
    })
}

pub(super) fn net(root: &Table<'_>) -> Result<NetSpec, FileError> {
    let Some(table) = root.table("net")? else {
        return Ok(NetSpec::default());
    };
    table.expect_keys(&["length", "start"])?;
    let length = table.get("length").map(|v| v.number(Length)).transpose()?;
    let start = (table.get("start"))
        .map(|v| {
            v.elements(2, MOST_NET_POINTS)?
                .iter()
                .map(|p| p.point())
                .collect::<Result<Vec<_>, _>>()
        })
        .transpose()?;
    Ok(NetSpec { length, start })
}

/// `[planner]`; what it leaves out follows from the robot.
pub(super) fn planner(
    root: &Table<'_>,
    robot: &Robot,
    warnings: &mut Vec<Warning>,
) -> Result<PlannerParameters, FileError> {
    let size = RobotSize::of(robot);
    let mut p = size.planner(robot);
    let Some(table) = root.table("planner")? else {
        return Ok(p);
    };
    set(
        &table,
        &mut [
            ("max_step", UpTo(size.length(LONGEST_STEP)), &mut p.max_step),
            ("max_turn", UpTo(PI), &mut p.max_turn),
            ("max_skew", UpTo(FRAC_PI_2), &mut p.max_skew),
            ("clearance", NotNegative, &mut p.clearance),
            ("cruise", Length, &mut p.cruise),
            ("half_separation", Length, &mut p.half_separation),
            ("min_ratio", UpTo(1.0), &mut p.min_ratio),
            ("rest_ratio", UpTo(1.0), &mut p.rest_ratio),
            ("k1", NotNegative, &mut p.k1),
            ("k2", NotNegative, &mut p.k2),
            ("k3", NotNegative, &mut p.k3),
            ("t1", NotNegative, &mut p.t1),
            ("t2", NotNegative, &mut p.t2),
            ("kd1", NotNegative, &mut p.kd1),
            ("kd2", NotNegative, &mut p.kd2),
            ("b1", NotNegative, &mut p.b1),
            ("b2", NotNegative, &mut p.b2),
            ("b3", NotNegative, &mut p.b3),
            ("a1", NotNegative, &mut p.a1),
            ("a2", NotNegative, &mut p.a2),
            ("a3", NotNegative, &mut p.a3),
            ("a4", NotNegative, &mut p.a4),
        ],
        &[
            "circle_margin",
            "waypoints",
            "alternations",
            "expansion_per",
            "leave",
        ],
    )?;
    if p.cruise < SLOW * robot.v_max {
        warnings.push(Warning::SlowCruise {
            cruise: p.cruise,
            v_max: robot.v_max,
        });
    }
    if let Some(value) = table.get("circle_margin") {
        p.circle_margin = Some(value.number(NotNegative)?);
    }
    if let Some(value) = table.get("waypoints") {
        p.waypoints = Some(value.count(3, MOST_WAYPOINTS)?);
    }
    if let Some(value) = table.get("alternations") {
        p.alternations = value.count(1, MOST_ALTERNATIONS)?;
    }
    if let Some(value) = table.get("expansion_per") {
        p.expansion_per = named(&value, ExpansionPer::ALL, ExpansionPer::name)?;
    }
    if let Some(value) = table.get("leave") {
        p.leave = named(&value, Leave::ALL, Leave::name)?;
    }
    for (low, high, which) in [
        (p.min_ratio, p.rest_ratio, "rest_ratio"),
        (p.rest_ratio, 1.0, "1"),
    ] {
        if low >= high {
            let key = if which == "1" {
                "rest_ratio"
            } else {
                "min_ratio"
            };
            return Err(table.get(key).map_or_else(
                || table.error(ratio_problem(&table, key, low, which, high)),
                |v| v.error(ratio_problem(&table, key, low, which, high)),
            ));
        }
    }
    Ok(p)
}

fn ratio_problem(
    table: &Table<'_>,
    key: &str,
    value: f64,
    bound: &str,
    limit: f64,
) -> crate::files::Problem {
    let bound = if bound == "1" {
        "below 1".to_owned()
    } else {
        format!("below {bound} ({limit})")
    };
    crate::files::Problem::Value {
        field: table.field(key),
        value: value.to_string(),
        bound,
    }
}

/// `[physics]`; what it leaves out is the preset's, or follows from the robot's size.
pub(super) fn physics(
    root: &Table<'_>,
    robot: &Robot,
    preset: Option<Preset>,
) -> Result<PhysicsParameters, FileError> {
    let mut p = preset.map_or_else(|| RobotSize::of(robot).physics(), Preset::physics);
    let Some(table) = root.table("physics")? else {
        return Ok(p);
    };
    set(
        &table,
        &mut [
            ("gravity", UpTo(1e3), &mut p.gravity),
            ("robot_mass", Positive, &mut p.robot_mass),
            ("robot_inertia", Positive, &mut p.robot_inertia),
            ("center_of_mass", NotNegative, &mut p.center_of_mass),
            ("wheel_radius", Length, &mut p.wheel_radius),
            ("max_torque", Positive, &mut p.max_torque),
            ("wheel_friction", UpTo(1e3), &mut p.wheel_friction),
            ("net_mass", Positive, &mut p.net_mass),
            ("net_link", Length, &mut p.net_link),
            ("net_thickness", Length, &mut p.net_thickness),
            ("net_height", Length, &mut p.net_height),
            ("hinge_damping", NotNegative, &mut p.hinge_damping),
            ("net_friction", NotNegative, &mut p.net_friction),
            ("object_friction", NotNegative, &mut p.object_friction),
            ("contact_friction", NotNegative, &mut p.contact_friction),
            ("tension_limit", Positive, &mut p.tension_limit),
        ],
        &[],
    )?;
    Ok(p)
}

/// Refuses unknown keys and sets the fields whose keys are there; `others` are keys that the caller reads itself.
fn set(
    table: &Table<'_>,
    fields: &mut [(&str, Range, &mut f64)],
    others: &[&str],
) -> Result<(), FileError> {
    let known: Vec<&str> = fields
        .iter()
        .map(|(key, ..)| *key)
        .chain(others.iter().copied())
        .collect();
    table.expect_keys(&known)?;
    fields
        .iter_mut()
        .try_for_each(|(key, range, target)| table.update(key, *range, target))
}
