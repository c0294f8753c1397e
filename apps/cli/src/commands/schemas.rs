use crate::arguments::SchemasArguments;
use crate::exit::Exit;
use crate::failure::Failure;
use crate::output::{Done, FilesAlone, Report};
use crate::results::in_folder;
use crate::schemas::all;

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
