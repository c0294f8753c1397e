//! What `plan` and `demo` leave in their folder when there is no plan: a picture, a page, proofs.

use crate::failure::Failure;
use crate::results::Results;
use pairtrawl::files::{LoadedScene, infeasible_json};
use pairtrawl::model::Overrides;
use pairtrawl::{NetLength, PlanError, PlanOptions, report};

/// The files of a run without a plan.
pub const FILES: [&str; 3] = ["failed.html", "failed.svg", "infeasible.json"];

/// Writes what is to be seen of an error of planning, after the results of an earlier run were set aside.
pub fn write(
    results: &Results<'_>,
    loaded: &LoadedScene,
    options: &PlanOptions,
    error: PlanError,
) -> Failure {
    let Some(summary) = pairtrawl::summarize_failure(&loaded.scene, options, &error) else {
        return error.into();
    };
    let mut contents = vec![
        ("failed.svg", report::failed_svg(&summary)),
        ("failed.html", report::failed_html(&summary)),
    ];
    if let PlanError::Infeasible(infeasible) = &error {
        let overrides = Overrides {
            net_length: options.net_length.map(NetLength::fixed),
            leave: options.leave,
        };
        let text = infeasible_json(
            &infeasible.proofs,
            &loaded.reference,
            &overrides,
            options.waypoints,
        );
        contents.extend(text.ok().map(|text| ("infeasible.json", text)));
    }
    let mut failure = Failure::from(error);
    failure.details.set_aside = results.set_aside();
    // That there is no plan is what counts; a picture that cannot be written does not change it.
    if let Ok(files) = results.write(&contents) {
        let names = files.iter().map(|file| file.display().to_string());
        failure.details.files = names.collect();
    }
    failure
}
