use super::planning::plan_into;
use crate::arguments::PlanArguments;
use crate::exit::Failure;
use crate::output::Done;
use pairtrawl::files::read_scene;

/// `pairtrawl plan`: from a scene file to a certified plan.
pub fn plan(arguments: &PlanArguments) -> Result<Done, Failure> {
    let loaded = read_scene(&arguments.scene)?;
    plan_into("plan", &loaded, &arguments.planning, &arguments.output)
}
