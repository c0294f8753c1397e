//! Files of a plan.

use crate::errors::{bad_input, file_error};
use crate::plan::Plan;
use pairtrawl::files::{FileError, csv_text, tum_text, write_atomically};
use pairtrawl::model::Side;
use pairtrawl::reference::{Reference, ReferenceError};
use pairtrawl::report::{plan_svg, report_html};
use pyo3::prelude::*;
use std::path::Path;

/// Why nothing was written.
pub enum SaveError {
    /// The system refuses.
    File(FileError),
    /// There is no smooth curve through the plan.
    Reference(ReferenceError),
    /// The folder cannot be made, or the ending says nothing.
    Words(String),
}

impl SaveError {
    /// The same as an exception.
    pub fn into_exception(self, py: Python<'_>) -> PyErr {
        match self {
            Self::File(error) => file_error(py, &error, true),
            Self::Reference(error) => bad_input(py, &error.to_string()),
            Self::Words(words) => bad_input(py, &words),
        }
    }
}

fn driven(plan: &Plan) -> Result<Reference, SaveError> {
    Reference::of_scene(&plan.scene.loaded.scene, &plan.plan.trajectory)
        .map_err(SaveError::Reference)
}

fn write(path: &Path, content: &str) -> Result<(), SaveError> {
    write_atomically(path, content.as_bytes()).map_err(SaveError::File)
}

/// Writes one file, by its ending.
pub fn one_file(plan: &Plan, path: &Path, ending: &str) -> Result<(), SaveError> {
    let content = match ending {
        "json" => plan.json(),
        "csv" => csv_text(&driven(plan)?),
        "svg" => plan_svg(&plan.summary()),
        "html" => report_html(&plan.summary()),
        _ => {
            return Err(SaveError::Words(format!(
                "{} ends in .{ending}: plans are written as .json, .csv, .svg or .html, or into a folder without an ending",
                path.display()
            )));
        }
    };
    write(path, &content)
}

/// Writes what the program writes into a folder, which is made when it is missing; the plan file last.
pub fn in_folder(plan: &Plan, folder: &Path) -> Result<(), SaveError> {
    std::fs::create_dir_all(folder).map_err(|error| {
        SaveError::Words(format!(
            "cannot create the folder {}: {error}",
            folder.display()
        ))
    })?;
    let (reference, summary) = (driven(plan)?, plan.summary());
    let contents = [
        ("plan.csv", csv_text(&reference)),
        ("left.tum", tum_text(&reference, Side::Left)),
        ("right.tum", tum_text(&reference, Side::Right)),
        ("plan.svg", plan_svg(&summary)),
        ("report.html", report_html(&summary)),
        ("plan.json", plan.json()),
    ];
    contents
        .iter()
        .try_for_each(|(name, content)| write(&folder.join(name), content))
}
