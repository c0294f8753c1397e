use super::with_scene;
use crate::arguments::ShowArguments;
use crate::details::ProofObject;
use crate::exit::Exit;
use crate::failure::Failure;
use crate::interrupt;
use crate::output::{Done, Report};
use crate::results::create_folder;
use pairtrawl::PlanOptions;
use pairtrawl::files::{LoadedScene, write_atomically};
use pairtrawl::model::numbers::index_list;
use schemars::JsonSchema;
use serde::Serialize;
use std::fmt::Write;
use std::path::{Path, PathBuf};

/// A scene before it is planned.
#[derive(Serialize, JsonSchema)]
pub struct ShowReport {
    /// How many objects there are.
    objects: usize,
    /// How many circles they make; objects that cannot be swept are in none.
    circles: usize,
    /// The objects of each circle, in the shortest visiting order; empty where no order leads to all of them.
    visits: Vec<Vec<usize>>,
    /// Proofs that there is no plan, or none that gathers an object.
    proofs: Vec<ProofObject>,
}

/// `pairtrawl show`: a picture of a scene before it is planned.
pub fn show(arguments: &ShowArguments) -> Result<Done, Failure> {
    with_scene(&arguments.scene, &|loaded| show_in(loaded, arguments))
}

fn show_in(loaded: &LoadedScene, arguments: &ShowArguments) -> Result<Done, Failure> {
    let options = PlanOptions {
        net_length: arguments.net_length,
        ..PlanOptions::default()
    };
    let preview = pairtrawl::preview(&loaded.scene, &options)?;
    let summary = &preview.summary;
    let proofs = (preview.infeasible.iter()).flat_map(|infeasible| &infeasible.proofs);
    let visits = summary.order.iter().filter_map(|i| summary.circles.get(*i));
    let about = ShowReport {
        objects: summary.outline.objects.len(),
        circles: summary.circles.len(),
        visits: visits.map(|circle| circle.objects.clone()).collect(),
        proofs: proofs.map(ProofObject::from).collect(),
    };
    let mut text = format!(
        "{}: {} objects, {} circles\n",
        summary.title, about.objects, about.circles
    );
    if !about.visits.is_empty() {
        let visits: Vec<String> = about.visits.iter().map(|v| index_list(v)).collect();
        let _ = writeln!(text, "  shortest order of visits: {}", visits.join(" | "));
    }
    match &preview.infeasible {
        Some(infeasible) => {
            let _ = writeln!(text, "  proven: {infeasible}");
        }
        None => text.push_str("  no proof is known against it\n"),
    }
    let path = picture_path(&arguments.output);
    let picture = pairtrawl::report::scene_svg(summary);
    interrupt::while_writing(|| {
        if let Some(folder) = path.parent() {
            create_folder(folder)?;
        }
        Ok::<_, Failure>(write_atomically(&path, picture.as_bytes())?)
    })?;
    Report::new("show", Exit::Done, about)
        .scene(&summary.title)
        .done(Exit::Done, text, &loaded.warnings, &[path])
}

/// The file itself, or `scene.svg` in a folder.
fn picture_path(output: &Path) -> PathBuf {
    match output.extension() {
        Some(extension) if extension.eq_ignore_ascii_case("svg") && !output.is_dir() => {
            output.to_owned()
        }
        _ => output.join("scene.svg"),
    }
}
