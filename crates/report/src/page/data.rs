//! The data that a page carries for its script, as compact JSON.

use crate::axis::{decade, power_of_ten};
use crate::map::View;
use pairtrawl_geometry::{Point, Pose};
use pairtrawl_model::numbers::LengthUnit;
use pairtrawl_model::{BodyCircle, Footprint, Frames, Panel, Role, Sampling, Summary};
use serde_json::{Value, json};

/// Resolutions of packed angles, rad, and times, s. The script knows them too.
const ANGLE: f64 = 1e-3;
const TIME: f64 = 1e-4;

/// Resolution of packed lengths, m: better than a thousandth of a robot's radius.
fn length_unit(robot_radius: f64) -> f64 {
    power_of_ten(decade(robot_radius) - 3)
}

/// JSON that may stand in a script element: no `<` opens or closes anything there.
pub(super) fn embedded(summary: &Summary) -> String {
    data(summary).to_string().replace('<', "\\u003c")
}

fn data(summary: &Summary) -> Value {
    let view = View::of(&summary.outline);
    let plan = &summary.trajectory;
    let unit = length_unit(summary.outline.robot.radius);
    let axis = view.unit();
    let mut motions = vec![json!({
        "name": "plan",
        "t": packed(summary.times.iter().copied(), TIME),
        "left": poses(plan.left.iter(), unit),
        "right": poses(plan.right.iter(), unit),
    })];
    motions.extend(
        summary
            .frames
            .as_ref()
            .map(|f| motion("rehearsal", f, unit)),
    );
    let execution = summary.execution.as_ref();
    motions.extend(
        execution
            .and_then(|e| e.frames.as_ref())
            .map(|f| motion("run", f, unit)),
    );
    let mut time_lists = Vec::new();
    let panels: Vec<Value> = summary
        .panels
        .iter()
        .chain(execution.iter().flat_map(|e| &e.panels))
        .map(|p| panel(p, &mut time_lists))
        .collect();
    let times: Vec<Value> = time_lists
        .iter()
        .map(|t| packed(t.iter().copied(), TIME))
        .collect();
    let objects: Vec<Value> = summary
        .outline
        .objects
        .iter()
        .enumerate()
        .map(|(i, o)| {
            let swept = summary.swept_at.get(i).copied().flatten();
            let leave = o.leave;
            match o.footprint {
                Footprint::Box(w, d) => json!({"size": [w, d], "swept": swept, "leave": leave}),
                Footprint::Disc(r) => json!({"radius": r, "swept": swept, "leave": leave}),
            }
        })
        .collect();
    let body = summary.outline.robot.circles();
    let triple = |c: &BodyCircle| [c.center.x, c.center.y, c.radius];
    let circles: Vec<_> = body.circles().iter().map(triple).collect();
    json!({
        "view": [view.min.x, view.min.y, view.max.x, view.max.y],
        "axis": {"name": axis.name, "perMeter": axis.per_meter},
        "lengthUnit": unit,
        "radius": summary.outline.robot.radius,
        "body": circles,
        "front": body.front(),
        "hitch": summary.outline.robot.hitch,
        "motions": motions,
        "times": times,
        "panels": panels,
        "objects": objects,
    })
}

fn motion(name: &str, frames: &Frames, unit: f64) -> Value {
    // Transposed: one list per coordinate of each net point and object, whose differences in time are small.
    let nodes = frames.net.iter().map(Vec::len).min().unwrap_or(0);
    let net: Vec<Value> = (0..nodes)
        .map(|k| points(frames.net.iter().map(|net| net[k]), unit))
        .collect();
    let count = frames.objects.iter().map(Vec::len).min().unwrap_or(0);
    let objects: Vec<Value> = (0..count)
        .map(|k| poses(frames.objects.iter().map(|o| &o[k]), unit))
        .collect();
    json!({
        "name": name,
        "t": packed(frames.times.iter().copied(), TIME),
        "left": poses(frames.left.iter(), unit),
        "right": poses(frames.right.iter(), unit),
        "net": net,
        "objects": objects,
    })
}

fn poses<'a>(poses: impl Iterator<Item = &'a Pose> + Clone, unit: f64) -> Value {
    json!([
        packed(poses.clone().map(|p| p.x), unit),
        packed(poses.clone().map(|p| p.y), unit),
        packed(poses.map(|p| p.heading), ANGLE),
    ])
}

fn points(points: impl Iterator<Item = Point> + Clone, unit: f64) -> Value {
    json!([
        packed(points.clone().map(|p| p.x), unit),
        packed(points.map(|p| p.y), unit),
    ])
}

fn panel(panel: &Panel, time_lists: &mut Vec<Vec<f64>>) -> Value {
    let known = time_lists.iter().position(|t| *t == panel.times);
    let index = known.unwrap_or_else(|| {
        time_lists.push(panel.times.clone());
        time_lists.len() - 1
    });
    let values = || {
        panel
            .lines
            .iter()
            .flat_map(|l| &l.values)
            .filter(|v| v.is_finite())
    };
    let greatest = values().fold(0.0, |m: f64, v| m.max(v.abs()));
    // Lengths are shown in the unit that suits them.
    let (measure, factor) = match panel.unit.as_str() {
        "m" => {
            let unit = LengthUnit::of(greatest);
            (unit.name, unit.per_meter)
        }
        other => (other, 1.0),
    };
    // Five significant digits of the greatest value.
    let unit = power_of_ten(decade((factor * greatest).max(1e-9)) - 4);
    let lines: Vec<Value> = panel
        .lines
        .iter()
        .map(|l| {
            let values = l.values.iter().map(|v| factor * v);
            json!({"label": l.label, "role": role(l.role), "v": numbers(values, unit)})
        })
        .collect();
    let limits: Vec<Value> = panel
        .limits
        .iter()
        .map(|l| json!({"label": l.label, "value": factor * l.value}))
        .collect();
    json!({
        "title": panel.title,
        "measure": measure,
        "t": index,
        "steps": panel.sampling == Sampling::Step,
        "unit": unit,
        "lines": lines,
        "limits": limits,
    })
}

fn role(role: Role) -> &'static str {
    match role {
        Role::Left => "left",
        Role::Right => "right",
        Role::Net => "net",
        Role::Other => "other",
    }
}

/// Multiples of a unit as differences: the first one from zero. A number that is not finite repeats the one before.
fn packed(values: impl Iterator<Item = f64>, unit: f64) -> Value {
    let mut last = 0;
    values
        .map(|v| {
            let now = if v.is_finite() {
                (v / unit).round() as i64
            } else {
                last
            };
            let difference = now.saturating_sub(last);
            last = now;
            difference
        })
        .collect()
}

/// Multiples of a unit; null where there is no number.
fn numbers(values: impl Iterator<Item = f64>, unit: f64) -> Value {
    values
        .map(|v| v.is_finite().then_some((v / unit).round() as i64))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn differences_add_up_to_the_rounded_numbers() {
        let values = [1.234_56, 1.234_44, f64::NAN, -2.0, -2.000_04];
        let Value::Array(list) = packed(values.into_iter(), length_unit(0.24)) else {
            panic!("a list")
        };
        let mut sum = 0;
        let back: Vec<i64> = list
            .iter()
            .map(|d| {
                sum += d.as_i64().unwrap();
                sum
            })
            .collect();
        assert_eq!(back, [12346, 12344, 12344, -20000, -20000]);
    }
}
