use super::planning::plan_into;
use crate::arguments::DemoArguments;
use crate::exit::Failure;
use crate::output::Done;
use pairtrawl::files::parse_scene;

/// The paper's simulation.
const SCENE: &str = include_str!("../../../../scenes/paper-simulation/scene.toml");

/// `pairtrawl demo`: the paper's simulation, from the scene in the program to its report.
pub fn demo(arguments: &DemoArguments) -> Result<Done, Failure> {
    let loaded = parse_scene(SCENE, "the embedded scene")?;
    let mut done = plan_into("demo", &loaded, &arguments.planning, &arguments.output)?;
    done.text.push_str(&format!(
        "\nopen {} in a browser\n",
        arguments.output.join("report.html").display()
    ));
    Ok(done)
}
