use super::{execution, infeasible, plan, scene};
use schemars::generate::SchemaSettings;
use schemars::{JsonSchema, Schema};

/// The JSON schemas (draft 2020-12) of the file formats with the names of their files. A scene is TOML; its schema is that of
/// the same tables in JSON.
pub fn schemas() -> [(&'static str, Schema); 4] {
    let read = SchemaSettings::draft2020_12();
    let written = read.clone().for_serialize();
    [
        ("scene", of::<scene::content::SceneFile>(read)),
        ("plan", of::<plan::file::File>(written.clone())),
        ("infeasible", of::<infeasible::file::File>(written.clone())),
        ("execution", of::<execution::file::File>(written)),
    ]
}

fn of<T: JsonSchema>(settings: SchemaSettings) -> Schema {
    settings.into_generator().into_root_schema_for::<T>()
}
