use super::planning::plan_into;
use super::with_scene;
use crate::arguments::PlanArguments;
use crate::failure::Failure;
use crate::output::Done;

/// `pairtrawl plan`: from a scene file to a certified plan.
pub fn plan(arguments: &PlanArguments) -> Result<Done, Failure> {
    let (planning, folder) = (&arguments.planning, &arguments.output);
    plan_into("plan", planning, folder, |work| {
        with_scene(&arguments.scene, work)
    })
}
