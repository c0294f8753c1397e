//! `infeasible.json`, format `pairtrawl-infeasible/1`: proofs that a scene has no plan, or none that gathers an object.

mod convert;
pub(super) mod file;

use super::json::{from_json, stated_format};
use super::parts::Reference;
use super::plan::file::FileOverrides;
use super::{FileError, Problem};
use file::{FORMAT, File, FileProof};
use pairtrawl_certificate::infeasibility::{Move, Proof, ProofKind};
use pairtrawl_model::{Overrides, SceneReference};
use std::path::Path;

/// Proofs as they stand in a file, perhaps one made by another program. They are claims until they are verified.
#[derive(Clone, Debug, PartialEq)]
pub struct InfeasibleFile {
    /// The scene that they say they are about.
    pub scene: Option<SceneReference>,
    /// What the command line changed against the scene.
    pub overrides: Overrides,
    /// The number of waypoints that was asked for; `None`: the scene's, or the planner's choice.
    pub waypoints: Option<usize>,
    /// The proofs, at least one.
    pub proofs: Vec<StatedProof>,
}

/// A proof as a file states it.
#[derive(Clone, Debug, PartialEq)]
pub struct StatedProof {
    /// The argument with its numbers.
    pub kind: ProofKind,
    /// The least move that would help, where one is stated.
    pub least_move: Option<Move>,
    /// The proof for people.
    pub text: String,
}

/// Proofs as one JSON object with a line end.
///
/// # Errors
/// Never for proofs that fit into memory; the JSON library wants it.
pub fn infeasible_json(
    proofs: &[Proof],
    scene: &SceneReference,
    overrides: &Overrides,
    waypoints: Option<usize>,
) -> Result<String, serde_json::Error> {
    let file = File {
        format: FORMAT.to_owned(),
        scene: Some(Reference::from(scene)),
        overrides: FileOverrides::from(overrides),
        waypoints,
        proofs: proofs.iter().map(FileProof::from).collect(),
    };
    Ok(serde_json::to_string_pretty(&file)? + "\n")
}

/// Reads the text of a file with proofs; `path` stands for the file in messages.
///
/// # Errors
/// When it is not JSON, is of another format, has no proof, or one that does not name what it is about.
pub fn parse_infeasible(text: &str, path: &Path) -> Result<InfeasibleFile, FileError> {
    let found = stated_format(text, path)?.unwrap_or_default();
    if found != FORMAT {
        let expected = FORMAT;
        return Err(FileError::new(path, Problem::Format { found, expected }));
    }
    let file: File = from_json(text, path)?;
    let refuse = |field: String, value: String, bound: &str| {
        let bound = bound.to_owned();
        FileError::new(
            path,
            Problem::Value {
                field,
                value,
                bound,
            },
        )
    };
    if file.proofs.is_empty() {
        return Err(refuse(
            "proofs".to_owned(),
            "an empty list".to_owned(),
            "a list of at least one proof",
        ));
    }
    let proofs = (file.proofs.into_iter().enumerate()).map(|(i, proof)| {
        let objects = format!("{:?}", proof.objects);
        proof.into_stated().map_err(|bound| {
            let field = format!("proofs[{i}].objects");
            refuse(field, objects, bound)
        })
    });
    Ok(InfeasibleFile {
        proofs: proofs.collect::<Result<_, _>>()?,
        scene: file.scene.map(SceneReference::from),
        overrides: file.overrides.into(),
        waypoints: file.waypoints,
    })
}

/// True when a text says that it is a file with proofs.
#[cfg(feature = "fs")]
pub(super) fn is_infeasible(text: &str, path: &Path) -> bool {
    stated_format(text, path).is_ok_and(|format| format.as_deref() == Some(FORMAT))
}
