//! JSON schemas of all files and of what commands print, made from the types that write them.

use crate::commands::{
    CheckReport, CompletionsReport, GenerateReport, LengthReport, MonteCarloReport, PlanReport,
    RehearseReport, RunReport,
};
use crate::failure::FailureReport;
use crate::output::{FilesAlone, Report};
use schemars::generate::SchemaSettings;
use schemars::{JsonSchema, Schema};
use serde_json::json;

/// File names and contents of all schemas.
pub fn all() -> Vec<(String, String)> {
    let files = pairtrawl::files::schemas()
        .into_iter()
        .chain([
            ("length", of::<LengthReport>()),
            ("monte-carlo", of::<MonteCarloReport>()),
        ])
        .map(|(name, schema)| (name.to_owned(), schema));
    let printed = [
        ("plan", of::<Report<PlanReport>>()),
        ("demo", of::<Report<PlanReport>>()),
        ("check", of::<Report<CheckReport>>()),
        ("rehearse", of::<Report<RehearseReport>>()),
        ("run", of::<Report<RunReport>>()),
        ("monte-carlo", of::<Report<MonteCarloReport>>()),
        ("export", of::<Report<FilesAlone>>()),
        ("length", of::<Report<LengthReport>>()),
        ("generate", of::<Report<GenerateReport>>()),
        ("new", of::<Report<FilesAlone>>()),
        ("completions", of::<Report<CompletionsReport>>()),
    ];
    let printed = printed.into_iter().map(|(command, mut schema)| {
        if let Some(value) = schema.pointer_mut("/properties/command") {
            *value = json!({ "const": command, "description": "The command." });
        }
        schema.insert(
            "title".to_owned(),
            json!(format!("pairtrawl {command} --json")),
        );
        (format!("output-{command}"), schema)
    });
    let failure = ("output-error".to_owned(), of::<FailureReport<'static>>());
    files
        .chain(printed)
        .chain([failure])
        .map(|(name, schema)| (format!("{name}.schema.json"), text(&schema)))
        .collect()
}

fn of<T: JsonSchema>() -> Schema {
    let settings = SchemaSettings::draft2020_12().for_serialize();
    settings.into_generator().into_root_schema_for::<T>()
}

fn text(schema: &Schema) -> String {
    format!("{:#}\n", schema.as_value())
}
