use super::planning::plan_into;
use crate::arguments::DemoArguments;
use crate::failure::Failure;
use crate::output::Done;
use pairtrawl::files::parse_scene;

/// The paper's simulation.
const SCENE: &str = include_str!("../../../../scenes/paper-simulation/scene.toml");

/// `pairtrawl demo`: the paper's simulation, from the scene in the program to its report.
pub fn demo(arguments: &DemoArguments) -> Result<Done, Failure> {
    let (planning, folder) = (&arguments.planning, &arguments.output);
    let mut done = plan_into("demo", planning, folder, |work| {
        let loaded = parse_scene(SCENE, "the embedded scene")?;
        work(&loaded).map_err(|failure| failure.about(&loaded.scene.name))
    })?;
    done.text.push_str(&format!(
        "\nopen {} in a browser\n",
        folder.join("report.html").display()
    ));
    Ok(done)
}
