//! The folder of a run, as the program writes it.

use pairtrawl::execute::{ExecutionOptions, WriteRecordingError, write_recording};
use pairtrawl::files::{FileError, LoadedScene, execution_json, write_atomically};
use pairtrawl::model::{Execution, Plan};
use pairtrawl::report::report_html;
use pairtrawl::{summarize, summarize_execution};
use std::path::Path;

/// Why a run was not written: a file, or other words.
pub type RunFileError = Result<FileError, String>;

/// Writes execution.json, report.html and the ROS 2 recording of the first trial into a folder, which is made when missing.
pub fn write_run(
    folder: &Path,
    scene: &LoadedScene,
    plan: &Plan,
    options: &ExecutionOptions,
    execution: &Execution,
) -> Result<(), RunFileError> {
    std::fs::create_dir_all(folder).map_err(|error| {
        Err(format!(
            "cannot create the folder {}: {error}",
            folder.display()
        ))
    })?;
    let mut summary = summarize(&scene.scene, plan, &[], None);
    summary.execution = Some(summarize_execution(&scene.scene, execution));
    let page = report_html(&summary);
    write_atomically(&folder.join("report.html"), page.as_bytes()).map_err(Ok)?;
    if let Some(first) = execution.trials.first() {
        let (net_length, driven) = (plan.net_length, &plan.trajectory);
        write_recording(
            folder,
            &scene.scene,
            net_length,
            driven,
            &plan.times(),
            first,
        )
        .map_err(|error| match error {
            WriteRecordingError::File(error) => Ok(error),
            other => Err(other.to_string()),
        })?;
    }
    let text = execution_json(execution, options, &scene.reference);
    write_atomically(&folder.join("execution.json"), text.as_bytes()).map_err(Ok)
}
