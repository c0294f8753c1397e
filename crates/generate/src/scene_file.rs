use pairtrawl_geometry::{Point, Pose};
use pairtrawl_model::{Footprint, Obstacle, PhysicsParameters, PlannerParameters, Robot, Scene};
use std::fmt::Write;

/// Why a scene cannot be written as one TOML file.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum SceneTomlError {
    /// The scene has a ROS map, which lives in files of its own.
    #[error(
        "scene {0:?} has an occupancy map, which a scene file names but does not contain: write its obstacles as shapes"
    )]
    Map(String),
}

/// The scene as a `pairtrawl-scene/1` file. Floats are written so that they read back as the same bits; sections whose
/// values are all defaults are left out, and so are default values.
///
/// # Errors
/// When the scene has an occupancy map.
pub fn scene_toml(scene: &Scene) -> Result<String, SceneTomlError> {
    if scene.map.is_some() {
        return Err(SceneTomlError::Map(scene.name.clone()));
    }
    Ok(text(scene, |out| {
        out.line(format_args!("min = {}", pair(scene.area.min)));
        out.line(format_args!("max = {}", pair(scene.area.max)));
        out.line(format_args!("resolution = {:?}", scene.area.resolution));
    }))
}

/// The same for a scene on a map, which the file names: `map` is the path of the map's YAML relative to the scene file.
pub fn scene_toml_on_map(scene: &Scene, map: &str) -> String {
    text(scene, |out| {
        out.line(format_args!("map = {}", quoted(map)));
    })
}

/// The file, with what `area` writes below `[area]`.
fn text(scene: &Scene, area: impl FnOnce(&mut Text)) -> String {
    let mut out = Text::default();
    out.line(format_args!("format = \"pairtrawl-scene/1\""));
    out.line(format_args!("name = {}", quoted(&scene.name)));
    out.section("[area]");
    area(&mut out);
    for obstacle in &scene.obstacles {
        out.section("[[obstacles]]");
        match obstacle {
            Obstacle::Box { min, max } => {
                out.line(format_args!(
                    "box = [{:?}, {:?}, {:?}, {:?}]",
                    min.x, min.y, max.x, max.y
                ));
            }
            Obstacle::Polygon(vertices) => out.line(format_args!("polygon = {}", list(vertices))),
            Obstacle::Circle { center, radius } => {
                out.line(format_args!(
                    "circle = [{:?}, {:?}, {radius:?}]",
                    center.x, center.y
                ));
            }
        }
    }
    for object in &scene.objects {
        out.section("[[objects]]");
        out.line(format_args!("position = {}", pair(object.position)));
        match object.footprint {
            Footprint::Box(w, d) => out.line(format_args!("size = [{w:?}, {d:?}]")),
            Footprint::Disc(r) => out.line(format_args!("radius = {r:?}")),
        }
        out.line(format_args!("mass = {:?}", object.mass));
    }
    for (name, p) in [("[start]", scene.start), ("[end]", scene.end)] {
        out.section(name);
        out.line(format_args!("left = {}", position(p.left)));
        out.line(format_args!("right = {}", position(p.right)));
        if p.left.heading == p.right.heading {
            out.line(format_args!("heading = {:?}", p.left.heading));
        } else {
            out.line(format_args!("left_heading = {:?}", p.left.heading));
            out.line(format_args!("right_heading = {:?}", p.right.heading));
        }
    }
    out.values("[robot]", &robot(&scene.robot), &robot(&Robot::default()));
    if scene.net.length.is_some() || scene.net.start.is_some() {
        out.section("[net]");
        if let Some(length) = scene.net.length {
            out.line(format_args!("length = {length:?}"));
        }
        if let Some(start) = &scene.net.start {
            out.line(format_args!("start = {}", list(start)));
        }
    }
    out.values(
        "[planner]",
        &planner(&scene.planner),
        &planner(&PlannerParameters::default()),
    );
    out.values(
        "[physics]",
        &physics(&scene.physics),
        &physics(&PhysicsParameters::default()),
    );
    out.0
}

/// Text under construction.
#[derive(Default)]
struct Text(String);

impl Text {
    fn line(&mut self, content: std::fmt::Arguments<'_>) {
        // Writing to a String does not fail.
        let _ = self.0.write_fmt(content);
        self.0.push('\n');
    }

    fn section(&mut self, header: &str) {
        self.line(format_args!("\n{header}"));
    }

    /// A section of the values that differ from the defaults; nothing when none does.
    fn values(&mut self, header: &str, values: &[(&str, String)], defaults: &[(&str, String)]) {
        let changed: Vec<_> = values
            .iter()
            .zip(defaults)
            .filter(|(v, d)| v.1 != d.1)
            .collect();
        if !changed.is_empty() {
            self.section(header);
            for (value, _) in changed {
                self.line(format_args!("{} = {}", value.0, value.1));
            }
        }
    }
}

fn pair(p: Point) -> String {
    format!("[{:?}, {:?}]", p.x, p.y)
}

fn position(p: Pose) -> String {
    pair(p.position())
}

fn list(points: &[Point]) -> String {
    format!(
        "[{}]",
        points
            .iter()
            .map(|p| pair(*p))
            .collect::<Vec<_>>()
            .join(", ")
    )
}

/// A TOML basic string.
fn quoted(text: &str) -> String {
    let mut out = String::from('"');
    for c in text.chars() {
        match c {
            '"' | '\\' => out.extend(['\\', c]),
            c if c.is_control() => {
                let _ = write!(out, "\\u{:04X}", u32::from(c));
            }
            c => out.push(c),
        }
    }
    out.push('"');
    out
}

/// Names each field by its key in the file.
macro_rules! fields {
    ($value:expr; $($field:ident),+ $(,)?) => {
        vec![$((stringify!($field), format!("{:?}", $value.$field))),+]
    };
}

type Fields = Vec<(&'static str, String)>;

fn robot(r: &Robot) -> Fields {
    fields!(r; radius, hitch, v_max, omega_max, half_track)
}

fn planner(p: &PlannerParameters) -> Fields {
    let mut fields = fields!(
        p; max_step, max_turn, max_skew, clearance, cruise, half_separation, alternations, min_ratio, rest_ratio,
        k1, k2, k3, t1, t2, kd1, kd2, b1, b2, b3, a1, a2, a3, a4
    );
    // Absent when the planner decides; an absent key cannot be told from a default, which is the same thing here.
    fields.push((
        "circle_margin",
        p.circle_margin
            .map_or_else(String::new, |v| format!("{v:?}")),
    ));
    fields.push((
        "waypoints",
        p.waypoints.map_or_else(String::new, |v| v.to_string()),
    ));
    fields
}

fn physics(p: &PhysicsParameters) -> Fields {
    fields!(
        p; gravity, robot_mass, robot_inertia, center_of_mass, wheel_radius, max_torque, wheel_friction, net_mass,
        net_link, net_thickness, net_height, hinge_damping, net_friction, object_friction, contact_friction,
        tension_limit
    )
}
