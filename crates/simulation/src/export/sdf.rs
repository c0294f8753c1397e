use super::layout::Layout;
use super::{TALL, escape, number, numbers};
use crate::obstacles::FixedShape;
use crate::{Parameters, SimulationError};
use pairtrawl_geometry::{Point, Pose};
use pairtrawl_model::{Footprint, PairTrajectory, Scene, Side};
use std::fmt::{Result as Written, Write};

/// Friction of the casters.
const CASTER_FRICTION: f64 = 0.1;
/// Width of a wheel, m.
const WHEEL_WIDTH: f64 = 0.018;
/// Mass of a wheel and of a caster, kg.
const WHEEL_MASS: f64 = 0.03;
/// Height of the objects, m.
const OBJECT_HEIGHT: f64 = 0.05;

/// The run as an SDF 1.9 world for Gazebo: robots with driven wheels and casters (topics `/left/cmd_vel`, `/right/cmd_vel`), the
/// net as a chain of links tied to both, objects, obstacles.
///
/// Gazebo has one friction a surface, not one a pair: a link or an object has its friction with the floor, which is also the
/// one with other bodies unless theirs is less.
///
/// # Errors
/// When scene, net length or trajectory cannot be simulated.
pub fn sdf(
    scene: &Scene,
    net_length: f64,
    trajectory: &PairTrajectory,
) -> Result<String, SimulationError> {
    let layout = Layout::new(scene, net_length, trajectory)?;
    let mut out = String::new();
    // Writing to a string cannot fail.
    let _ = write_world(&mut out, scene, &layout);
    Ok(out)
}

fn write_world(out: &mut String, scene: &Scene, layout: &Layout) -> Written {
    let physics = &layout.parameters.physics;
    writeln!(
        out,
        "<?xml version=\"1.0\"?>\n<sdf version=\"1.9\">\n<world name=\"{}\">",
        escape(&scene.name)
    )?;
    writeln!(out, "<gravity>0 0 {}</gravity>", number(-physics.gravity))?;
    writeln!(
        out,
        "<physics name=\"1ms\" type=\"ode\"><max_step_size>0.001</max_step_size></physics>"
    )?;
    for (library, class) in [
        ("physics", "Physics"),
        ("user-commands", "UserCommands"),
        ("scene-broadcaster", "SceneBroadcaster"),
    ] {
        writeln!(
            out,
            "<plugin filename=\"gz-sim-{library}-system\" name=\"gz::sim::systems::{class}\"/>"
        )?;
    }
    writeln!(
        out,
        "<light type=\"directional\" name=\"sun\"><pose>0 0 10 0 0 0</pose><direction>-0.3 0.2 -1</direction></light>"
    )?;
    writeln!(
        out,
        "<model name=\"floor\"><static>true</static><link name=\"link\">"
    )?;
    let plane = "<geometry><plane><normal>0 0 1</normal><size>100 100</size></plane></geometry>";
    writeln!(
        out,
        "<collision name=\"collision\">{plane}{}</collision>",
        surface(1.0, None)
    )?;
    writeln!(
        out,
        "<visual name=\"visual\">{plane}</visual></link></model>"
    )?;
    for (i, shape) in layout.obstacles.iter().enumerate() {
        write_obstacle(out, i, shape, physics.contact_friction)?;
    }
    writeln!(out, "<model name=\"duo\">")?;
    for side in Side::BOTH {
        write_robot(out, layout, side)?;
    }
    write_net(out, layout)?;
    writeln!(out, "</model>")?;
    for (i, object) in scene.objects.iter().enumerate() {
        let (w, d, geometry) = match object.footprint {
            Footprint::Box(w, d) => (w, d, box_geometry(w, d, OBJECT_HEIGHT)),
            Footprint::Disc(r) => (
                3f64.sqrt() * r,
                3f64.sqrt() * r,
                cylinder_geometry(r, OBJECT_HEIGHT),
            ),
        };
        let place = Pose::at(object.position, 0.0);
        writeln!(
            out,
            "<model name=\"object_{i}\">{}",
            pose(place, 0.5 * OBJECT_HEIGHT)
        )?;
        let inertia = inertial(object.mass, [w, d, OBJECT_HEIGHT], Point::ZERO);
        writeln!(
            out,
            "{}</model>",
            link(
                "link",
                "",
                &inertia,
                &geometry,
                &surface(physics.object_friction, None)
            )
        )?;
    }
    writeln!(out, "</world>\n</sdf>")
}

fn write_obstacle(out: &mut String, index: usize, shape: &FixedShape, friction: f64) -> Written {
    let (place, geometry) = match shape {
        FixedShape::Box { center, half, turn } => (
            Pose::at(*center, *turn),
            box_geometry(2.0 * half.x, 2.0 * half.y, TALL),
        ),
        FixedShape::Disc { center, radius } => {
            (Pose::at(*center, 0.0), cylinder_geometry(*radius, TALL))
        }
        FixedShape::Convex(vertices) => {
            let points: Vec<String> = vertices
                .iter()
                .map(|v| format!("<point>{}</point>", numbers([v.x, v.y])))
                .collect();
            let outline = points.concat();
            let polyline = format!(
                "<geometry><polyline>{outline}<height>{TALL}</height></polyline></geometry>"
            );
            (Pose::default(), polyline)
        }
    };
    // A polyline is extruded upwards from the floor, a box and a cylinder are centered.
    let height = if matches!(shape, FixedShape::Convex(_)) {
        0.0
    } else {
        0.5 * TALL
    };
    writeln!(
        out,
        "<model name=\"obstacle_{index}\"><static>true</static>{}",
        pose(place, height)
    )?;
    writeln!(
        out,
        "{}</model>",
        link("link", "", "", &geometry, &surface(friction, None))
    )
}

fn write_robot(out: &mut String, layout: &Layout, side: Side) -> Written {
    let parameters = &layout.parameters;
    let (physics, robot) = (&parameters.physics, parameters.robot);
    let radius = physics.wheel_radius;
    writeln!(
        out,
        "<model name=\"{}\">{}",
        side.name(),
        pose(layout.robots[side.index()], 0.0)
    )?;
    // Wheels and casters count in the robot's mass.
    let mass = physics.robot_mass - 4.0 * WHEEL_MASS;
    let gyration = physics.robot_inertia * 6.0 / physics.robot_mass;
    let body = inertial(
        mass,
        [gyration.sqrt(), gyration.sqrt(), 0.1],
        Point::new(physics.center_of_mass, 0.0),
    );
    writeln!(
        out,
        "<link name=\"base_link\">{}{body}",
        pose(Pose::default(), 0.08)
    )?;
    write_solids(out, parameters)?;
    writeln!(out, "</link>")?;
    for (name, y) in [
        ("left_wheel", robot.half_track),
        ("right_wheel", -robot.half_track),
    ] {
        let place = format!(
            "<pose>{} -1.570796327 0 0</pose>",
            numbers([0.0, y, radius])
        );
        let inertia = inertial(
            WHEEL_MASS,
            [2.0 * radius, 2.0 * radius, WHEEL_WIDTH],
            Point::ZERO,
        );
        let shape = cylinder_geometry(radius, WHEEL_WIDTH);
        writeln!(
            out,
            "{}",
            link(
                name,
                &place,
                &inertia,
                &shape,
                &surface(physics.wheel_friction, None)
            )
        )?;
        writeln!(
            out,
            "<joint name=\"{name}_joint\" type=\"revolute\"><parent>base_link</parent><child>{name}</child><axis><xyz>0 0 1</xyz></axis></joint>"
        )?;
    }
    for (name, y) in [("left_caster", 0.064), ("right_caster", -0.064)] {
        let place = format!("<pose>{} 0 0 0</pose>", numbers([-0.177, y, 0.005]));
        let inertia = inertial(WHEEL_MASS, [0.01; 3], Point::ZERO);
        let shape = "<geometry><sphere><radius>0.005</radius></sphere></geometry>";
        writeln!(
            out,
            "{}",
            link(
                name,
                &place,
                &inertia,
                shape,
                &surface(CASTER_FRICTION, None)
            )
        )?;
        writeln!(
            out,
            "<joint name=\"{name}_joint\" type=\"ball\"><parent>base_link</parent><child>{name}</child></joint>"
        )?;
    }
    writeln!(
        out,
        "<plugin filename=\"gz-sim-diff-drive-system\" name=\"gz::sim::systems::DiffDrive\"><left_joint>left_wheel_joint</left_joint><right_joint>right_wheel_joint</right_joint><wheel_separation>{}</wheel_separation><wheel_radius>{}</wheel_radius><topic>/{}/cmd_vel</topic></plugin>",
        number(2.0 * robot.half_track),
        number(radius),
        side.name()
    )?;
    writeln!(out, "</model>")
}

/// What the robot touches with: its square base, or a cylinder for each circle of its body.
fn write_solids(out: &mut String, parameters: &Parameters) -> Written {
    let base = parameters.base;
    let Some(body) = parameters.robot.body else {
        let offset = pose(Pose::new(-base.behind_axle, 0.0, 0.0), 0.0);
        let size = 2.0 * base.half_side;
        for kind in ["collision", "visual"] {
            let shape = box_geometry(size, size, 0.14);
            writeln!(out, "<{kind} name=\"{kind}\">{offset}{shape}</{kind}>")?;
        }
        return Ok(());
    };
    for (i, circle) in body.circles().iter().enumerate() {
        let offset = pose(Pose::at(circle.center, 0.0), 0.0);
        let shape = cylinder_geometry(circle.radius, 0.14);
        let surface = surface(parameters.physics.contact_friction, Some(ROBOT_MASK));
        writeln!(
            out,
            "<collision name=\"collision_{i}\">{offset}{shape}{surface}</collision><visual name=\"visual_{i}\">{offset}{shape}</visual>"
        )?;
    }
    Ok(())
}

/// Two things touch when their masks have a bit in common; all have, unless they say otherwise.
fn contact_mask(mask: u16) -> String {
    format!("<contact><collide_bitmask>{mask}</collide_bitmask></contact>")
}

/// Of robots with a body, and of the links of the net within them.
const ROBOT_MASK: u16 = 2;
const WITHIN_MASK: u16 = 1;

fn write_net(out: &mut String, layout: &Layout) -> Written {
    let parameters = &layout.parameters;
    let physics = &parameters.physics;
    let size = [
        parameters.link_length,
        physics.net_thickness,
        physics.net_height,
    ];
    let is_within_body = parameters.is_within_body();
    for (i, place) in layout.links.iter().enumerate() {
        let inertia = inertial(parameters.link_mass, size, Point::ZERO);
        let placed = pose(*place, 0.5 * physics.net_height);
        let shape = box_geometry(size[0], size[1], size[2]);
        let mask = is_within_body(i).then_some(WITHIN_MASK);
        writeln!(
            out,
            "{}",
            link(
                &format!("link_{i}"),
                &placed,
                &inertia,
                &shape,
                &surface(physics.net_friction, mask)
            )
        )?;
    }
    let half = 0.5 * parameters.link_length;
    let last = layout.links.len() - 1;
    let mut hinge = |name: String, parent: &str, child: &str, at: f64| {
        writeln!(
            out,
            "<joint name=\"{name}\" type=\"revolute\"><parent>{parent}</parent><child>{child}</child><pose>{} 0 0 0</pose><axis><xyz>0 0 1</xyz><dynamics><damping>{}</damping></dynamics></axis></joint>",
            numbers([at, 0.0, 0.0]),
            number(physics.hinge_damping)
        )
    };
    hinge("left_hitch".to_owned(), "left::base_link", "link_0", -half)?;
    for i in 1..=last {
        hinge(
            format!("hinge_{i}"),
            &format!("link_{}", i - 1),
            &format!("link_{i}"),
            -half,
        )?;
    }
    hinge(
        "right_hitch".to_owned(),
        "right::base_link",
        &format!("link_{last}"),
        half,
    )
}

fn link(name: &str, place: &str, inertia: &str, geometry: &str, surface: &str) -> String {
    format!(
        "<link name=\"{name}\">{place}{inertia}<collision name=\"collision\">{geometry}{surface}</collision><visual name=\"visual\">{geometry}</visual></link>"
    )
}

fn surface(friction: f64, mask: Option<u16>) -> String {
    let mu = number(friction);
    let mask = mask.map_or_else(String::new, contact_mask);
    format!("<surface>{mask}<friction><ode><mu>{mu}</mu><mu2>{mu}</mu2></ode></friction></surface>")
}

fn pose(place: Pose, height: f64) -> String {
    format!(
        "<pose>{} 0 0 {}</pose>",
        numbers([place.x, place.y, height]),
        number(place.heading)
    )
}

/// Mass and inertia of a box of this size, about a center of mass at `center`.
fn inertial(mass: f64, size: [f64; 3], center: Point) -> String {
    let [x, y, z] = size.map(|s| s * s);
    let [xx, yy, zz] = [y + z, x + z, x + y].map(|sum| mass * sum / 12.0);
    format!(
        "<inertial>{}<mass>{}</mass><inertia><ixx>{xx:e}</ixx><iyy>{yy:e}</iyy><izz>{zz:e}</izz></inertia></inertial>",
        pose(Pose::at(center, 0.0), 0.0),
        number(mass)
    )
}

fn box_geometry(x: f64, y: f64, z: f64) -> String {
    format!(
        "<geometry><box><size>{}</size></box></geometry>",
        numbers([x, y, z])
    )
}

fn cylinder_geometry(radius: f64, height: f64) -> String {
    format!(
        "<geometry><cylinder><radius>{}</radius><length>{}</length></cylinder></geometry>",
        number(radius),
        number(height)
    )
}
