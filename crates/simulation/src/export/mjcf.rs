mod foot;

use super::layout::Layout;
use super::{TALL, escape, number, numbers};
use crate::SimulationError;
use crate::obstacles::FixedShape;
use foot::{FOOT, FOOT_SHARE, Foot};
use pairtrawl_geometry::{Point, Pose, wrap_angle};
use pairtrawl_model::{BodyCircle, Footprint, Object, PairTrajectory, Scene, Side};
use std::fmt::Write;

/// Height of the objects, m.
const OBJECT_HEIGHT: f64 = 0.05;

/// The run as a `MuJoCo` model (MJCF) with a keyframe `start`: robots at the trajectory's first poses, the net as it lies then.
///
/// A robot is a planar body (joints `left_x`, `left_y`, `left_heading`) with one velocity actuator a joint; the plan itself is in
/// the model's custom numbers `plan_left`, `plan_right` (x y heading ...) and `plan_step_time`.
///
/// Links and objects are planar bodies too; each stands on feet that alone can move up and down and press on the floor with
/// its weight. As free bodies they would hop by micrometers, and contacts between them would spend friction on
/// up and down: a cube that an oblique wall pushes at 8 degrees, which must stick at mu = 0.2, then slips by 4 cm in 5 s.
///
/// # Errors
/// When scene, net length or trajectory cannot be simulated.
pub fn mjcf(
    scene: &Scene,
    net_length: f64,
    trajectory: &PairTrajectory,
) -> Result<String, SimulationError> {
    let layout = Layout::new(scene, net_length, trajectory)?;
    let mut out = String::new();
    // Writing to a string cannot fail.
    let _ = write_model(&mut out, scene, trajectory, &layout);
    Ok(out)
}

fn write_model(
    out: &mut String,
    scene: &Scene,
    trajectory: &PairTrajectory,
    layout: &Layout,
) -> std::fmt::Result {
    let physics = &layout.parameters.physics;
    let links = layout.links.len();
    writeln!(out, "<mujoco model=\"{}\">", escape(&scene.name))?;
    writeln!(out, "  <compiler angle=\"radian\" autolimits=\"true\"/>")?;
    // Soft friction creeps: the elliptic cone, a high impedance ratio and the no-slip pass hold what must stick.
    writeln!(
        out,
        "  <option timestep=\"0.001\" gravity=\"0 0 {}\" cone=\"elliptic\" impratio=\"20\" noslip_iterations=\"10\" integrator=\"implicitfast\"/>",
        number(-physics.gravity)
    )?;
    writeln!(out, "  <default>")?;
    writeln!(
        out,
        "    <default class=\"solid\"><geom contype=\"1\" conaffinity=\"1\" condim=\"3\" mass=\"0\" friction=\"{} 0.001 0.0001\" solref=\"0.004 1\"/></default>",
        number(physics.contact_friction)
    )?;
    for (name, friction) in [
        ("net_foot", physics.net_friction),
        ("object_foot", physics.object_friction),
    ] {
        writeln!(
            out,
            "    <default class=\"{name}\"><geom type=\"sphere\" size=\"{FOOT}\" contype=\"4\" conaffinity=\"0\" condim=\"3\" mass=\"0\" friction=\"{} 0.001 0.0001\" solref=\"0.02 1\" priority=\"1\" rgba=\"0 0 0 0\"/></default>",
            number(friction)
        )?;
    }
    writeln!(out, "  </default>")?;
    write_assets(out, layout)?;
    writeln!(out, "  <worldbody>")?;
    writeln!(
        out,
        "    <light pos=\"0 0 10\" dir=\"0 0 -1\" directional=\"true\"/>"
    )?;
    writeln!(
        out,
        "    <geom name=\"floor\" type=\"plane\" size=\"50 50 1\" contype=\"0\" conaffinity=\"4\" friction=\"0 0 0\" rgba=\"0.9 0.9 0.9 1\"/>"
    )?;
    write_obstacles(out, layout)?;
    write_robot(out, layout, Side::Left)?;
    write_robot(out, layout, Side::Right)?;
    for (i, object) in scene.objects.iter().enumerate() {
        write_object(out, i, object, physics.gravity)?;
    }
    writeln!(out, "  </worldbody>")?;
    writeln!(out, "  <equality>")?;
    writeln!(
        out,
        "    <connect name=\"right_hitch\" site1=\"net_end\" site2=\"right_ring\" solref=\"0.004 1\"/>"
    )?;
    writeln!(out, "  </equality>")?;
    // What is tied together does not touch, nor do links of the net within the body that tows them.
    let mut apart = vec![("right", links - 1)];
    for i in 1..layout.parameters.links_within_body().min(links) {
        apart.extend([("left", i), ("right", links - 1 - i)]);
    }
    write!(out, "  <contact>")?;
    for (side, link) in apart {
        write!(out, "<exclude body1=\"{side}\" body2=\"link_{link}\"/>")?;
    }
    writeln!(out, "</contact>")?;
    writeln!(out, "  <actuator>")?;
    for side in ["left", "right"] {
        for (joint, gain) in [("x", 1000.0), ("y", 1000.0), ("heading", 20.0)] {
            writeln!(
                out,
                "    <velocity name=\"{side}_{joint}\" joint=\"{side}_{joint}\" kv=\"{}\"/>",
                number(gain)
            )?;
        }
    }
    writeln!(out, "  </actuator>")?;
    write_plan(out, trajectory)?;
    writeln!(
        out,
        "  <keyframe><key name=\"start\" qpos=\"{}\"/></keyframe>",
        start(scene, layout)
    )?;
    writeln!(out, "</mujoco>")
}

fn write_assets(out: &mut String, layout: &Layout) -> std::fmt::Result {
    let pieces = layout
        .obstacles
        .iter()
        .enumerate()
        .filter_map(|(i, shape)| match shape {
            FixedShape::Convex(vertices) => Some((i, vertices)),
            _ => None,
        });
    writeln!(out, "  <asset>")?;
    for (i, vertices) in pieces {
        let corners: Vec<String> = [0.0, TALL]
            .iter()
            .flat_map(|&z| vertices.iter().map(move |v| numbers([v.x, v.y, z])))
            .collect();
        writeln!(
            out,
            "    <mesh name=\"piece_{i}\" vertex=\"{}\"/>",
            corners.join("  ")
        )?;
    }
    writeln!(out, "  </asset>")
}

fn write_obstacles(out: &mut String, layout: &Layout) -> std::fmt::Result {
    for (i, shape) in layout.obstacles.iter().enumerate() {
        write!(
            out,
            "    <geom name=\"obstacle_{i}\" class=\"solid\" rgba=\"0.5 0.5 0.5 1\" "
        )?;
        let half_height = 0.5 * TALL;
        match shape {
            FixedShape::Box { center, half, turn } => writeln!(
                out,
                "type=\"box\" pos=\"{}\" euler=\"0 0 {}\" size=\"{}\"/>",
                numbers([center.x, center.y, half_height]),
                number(*turn),
                numbers([half.x, half.y, half_height])
            )?,
            FixedShape::Disc { center, radius } => writeln!(
                out,
                "type=\"cylinder\" pos=\"{}\" size=\"{}\"/>",
                numbers([center.x, center.y, half_height]),
                numbers([*radius, half_height])
            )?,
            FixedShape::Convex(_) => writeln!(out, "type=\"mesh\" mesh=\"piece_{i}\"/>")?,
        }
    }
    Ok(())
}

fn write_robot(out: &mut String, layout: &Layout, side: Side) -> std::fmt::Result {
    let (physics, base) = (&layout.parameters.physics, layout.parameters.base);
    let hitch = layout.parameters.robot.hitch;
    let name = side.name();
    writeln!(out, "    <body name=\"{name}\">")?;
    for (joint, kind, axis) in [
        ("x", "slide", "1 0 0"),
        ("y", "slide", "0 1 0"),
        ("heading", "hinge", "0 0 1"),
    ] {
        writeln!(
            out,
            "      <joint name=\"{name}_{joint}\" type=\"{kind}\" axis=\"{axis}\"/>"
        )?;
    }
    let tilt = physics.robot_inertia;
    writeln!(
        out,
        "      <inertial pos=\"{}\" mass=\"{}\" diaginertia=\"{}\"/>",
        numbers([physics.center_of_mass, 0.0, 0.05]),
        number(physics.robot_mass),
        numbers([tilt, tilt, physics.robot_inertia])
    )?;
    let solids = match layout.parameters.robot.body {
        None => vec![(
            "box",
            numbers([-base.behind_axle, 0.0, 0.08]),
            numbers([base.half_side, base.half_side, 0.07]),
        )],
        Some(body) => {
            let cylinder = |c: &BodyCircle| {
                let place = numbers([c.center.x, c.center.y, 0.08]);
                ("cylinder", place, numbers([c.radius, 0.07]))
            };
            body.circles().iter().map(cylinder).collect()
        }
    };
    for (shape, place, size) in solids {
        writeln!(
            out,
            "      <geom class=\"solid\" type=\"{shape}\" pos=\"{place}\" size=\"{size}\" rgba=\"0.2 0.3 0.7 1\"/>"
        )?;
    }
    match side {
        Side::Left => write_link(out, layout, 0, Point::new(-hitch, 0.0))?,
        Side::Right => {
            writeln!(
                out,
                "      <site name=\"right_ring\" pos=\"{}\"/>",
                numbers([-hitch, 0.0, 0.0])
            )?;
        }
    }
    writeln!(out, "    </body>")
}

/// A link and, inside it, all that follow.
fn write_link(out: &mut String, layout: &Layout, index: usize, place: Point) -> std::fmt::Result {
    let parameters = &layout.parameters;
    let physics = &parameters.physics;
    let (length, mass) = (parameters.link_length, parameters.link_mass);
    let (thickness, height) = (physics.net_thickness, physics.net_height);
    // Feet at both ends carry a part of the mass, and of the moment of inertia.
    let yaw = mass * (length * length + thickness * thickness) / 12.0
        - FOOT_SHARE * mass * 0.25 * length * length;
    writeln!(
        out,
        "<body name=\"link_{index}\" pos=\"{}\">",
        numbers([place.x, place.y, 0.0])
    )?;
    writeln!(
        out,
        "<joint name=\"hinge_{index}\" type=\"hinge\" axis=\"0 0 1\" damping=\"{}\"/>",
        number(physics.hinge_damping)
    )?;
    writeln!(
        out,
        "<inertial pos=\"{}\" mass=\"{}\" diaginertia=\"{}\"/>",
        numbers([0.5 * length, 0.0, 0.5 * height]),
        number(mass * (1.0 - FOOT_SHARE)),
        format_args!("{yaw:e} {yaw:e} {yaw:e}")
    )?;
    writeln!(
        out,
        "<geom class=\"solid\" type=\"box\" pos=\"{}\" size=\"{}\" rgba=\"0.8 0.5 0.1 1\"/>",
        numbers([0.5 * length, 0.0, 0.5 * height]),
        numbers([0.5 * length, 0.5 * thickness, 0.5 * height])
    )?;
    for (end, x) in [("head", 0.0), ("tail", length)] {
        let foot = Foot {
            place: Point::new(x, 0.0),
            mass: 0.5 * mass,
            gravity: physics.gravity,
            class: "net_foot",
        };
        foot.write(out, &format!("link_{index}_{end}"))?;
    }
    if index + 1 < layout.links.len() {
        write_link(out, layout, index + 1, Point::new(length, 0.0))?;
    } else {
        writeln!(
            out,
            "<site name=\"net_end\" pos=\"{}\"/>",
            numbers([length, 0.0, 0.0])
        )?;
    }
    writeln!(out, "</body>")
}

fn write_object(out: &mut String, index: usize, object: &Object, gravity: f64) -> std::fmt::Result {
    let half_height = 0.5 * OBJECT_HEIGHT;
    let mass = object.mass;
    let (shape, size, yaw, foot) = match object.footprint {
        Footprint::Box(w, d) => {
            let half = Point::new(0.5 * w, 0.5 * d);
            (
                "box",
                numbers([half.x, half.y, half_height]),
                mass * (w * w + d * d) / 12.0,
                half,
            )
        }
        Footprint::Disc(r) => {
            let s = r * 2.0 / 3.0 * std::f64::consts::FRAC_1_SQRT_2;
            (
                "cylinder",
                numbers([r, half_height]),
                0.5 * mass * r * r,
                Point::new(s, s),
            )
        }
    };
    let yaw = yaw - FOOT_SHARE * mass * foot.norm_squared();
    writeln!(out, "    <body name=\"object_{index}\">")?;
    for (joint, kind, axis) in [
        ("x", "slide", "1 0 0"),
        ("y", "slide", "0 1 0"),
        ("heading", "hinge", "0 0 1"),
    ] {
        writeln!(
            out,
            "      <joint name=\"object_{index}_{joint}\" type=\"{kind}\" axis=\"{axis}\"/>"
        )?;
    }
    writeln!(
        out,
        "      <inertial pos=\"{}\" mass=\"{}\" diaginertia=\"{yaw:e} {yaw:e} {yaw:e}\"/>",
        numbers([0.0, 0.0, half_height]),
        number(mass * (1.0 - FOOT_SHARE))
    )?;
    writeln!(
        out,
        "      <geom class=\"solid\" type=\"{shape}\" pos=\"{}\" size=\"{size}\" rgba=\"0.7 0.1 0.1 1\"/>",
        numbers([0.0, 0.0, half_height])
    )?;
    for (i, (x, y)) in [(1.0, 1.0), (-1.0, 1.0), (-1.0, -1.0), (1.0, -1.0)]
        .into_iter()
        .enumerate()
    {
        let place = Point::new(x * foot.x, y * foot.y);
        let foot = Foot {
            place,
            mass: 0.25 * mass,
            gravity,
            class: "object_foot",
        };
        foot.write(out, &format!("object_{index}_{i}"))?;
    }
    writeln!(out, "    </body>")
}

fn write_plan(out: &mut String, trajectory: &PairTrajectory) -> std::fmt::Result {
    let list = |poses: &[Pose]| {
        let all: Vec<String> = poses
            .iter()
            .map(|p| numbers([p.x, p.y, p.heading]))
            .collect();
        all.join(" ")
    };
    writeln!(out, "  <custom>")?;
    writeln!(
        out,
        "    <numeric name=\"plan_step_time\" data=\"{}\"/>",
        number(trajectory.step_time)
    )?;
    writeln!(
        out,
        "    <numeric name=\"plan_left\" data=\"{}\"/>",
        list(&trajectory.left)
    )?;
    writeln!(
        out,
        "    <numeric name=\"plan_right\" data=\"{}\"/>",
        list(&trajectory.right)
    )?;
    writeln!(out, "  </custom>")
}

/// Joint positions at the start, in the order of the bodies.
fn start(scene: &Scene, layout: &Layout) -> String {
    let [left, right] = layout.robots;
    let mut q = vec![numbers([left.x, left.y, left.heading])];
    let mut before = left.heading;
    // A body's own joints come first, then its feet's, then the next link's.
    for link in &layout.links {
        q.push(numbers([wrap_angle(link.heading - before), 0.0, 0.0]));
        before = link.heading;
    }
    q.push(numbers([right.x, right.y, right.heading]));
    for object in &scene.objects {
        q.push(numbers([
            object.position.x,
            object.position.y,
            0.0,
            0.0,
            0.0,
            0.0,
            0.0,
        ]));
    }
    q.join(" ")
}
