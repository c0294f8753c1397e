use super::check::CheckReport;
use super::completions::CompletionsReport;
use super::generate::GenerateReport;
use super::length::LengthReport;
use super::monte_carlo::MonteCarloReport;
use super::planning::PlanReport;
use super::rehearse::RehearseReport;
use super::reproduce::ReproductionReport;
use super::run::RunReport;
use super::show::ShowReport;
use crate::arguments::SchemasArguments;
use crate::exit::Exit;
use crate::failure::{Failure, FailureReport};
use crate::output::{Done, FilesAlone, Report};
use crate::results::in_folder;
use pairtrawl::model::Bench;
use schemars::generate::SchemaSettings;
use schemars::{JsonSchema, Schema};
use serde_json::json;

/// `pairtrawl schemas`: the JSON schemas of all files and of what commands print.
pub fn schemas(arguments: &SchemasArguments) -> Result<Done, Failure> {
    in_folder(&arguments.directory, &[], |results| {
        let schemas = all();
        let contents: Vec<_> = (schemas.iter())
            .map(|(name, text)| (name.as_str(), text))
            .collect();
        let files = results.write(&contents)?;
        Report::new("schemas", Exit::Done, FilesAlone {}).done(
            Exit::Done,
            String::new(),
            &[],
            &files,
        )
    })
}

/// File names and contents of all schemas.
fn all() -> Vec<(String, String)> {
    let files = pairtrawl::files::schemas()
        .into_iter()
        .chain([
            ("length", of::<LengthReport>()),
            ("monte-carlo", of::<MonteCarloReport>()),
            ("bench", of::<Bench>()),
            ("reproduction", of::<ReproductionReport>()),
        ])
        .map(|(name, schema)| (name.to_owned(), schema));
    let printed = [
        ("plan", of::<Report<PlanReport>>()),
        ("demo", of::<Report<PlanReport>>()),
        ("check", of::<Report<CheckReport>>()),
        ("show", of::<Report<ShowReport>>()),
        ("rehearse", of::<Report<RehearseReport>>()),
        ("run", of::<Report<RunReport>>()),
        ("monte-carlo", of::<Report<MonteCarloReport>>()),
        ("export", of::<Report<FilesAlone>>()),
        ("length", of::<Report<LengthReport>>()),
        ("reproduce", of::<Report<ReproductionReport>>()),
        ("generate", of::<Report<GenerateReport>>()),
        ("bench-plan", of::<Report<Bench>>()),
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
