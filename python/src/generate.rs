//! Generated scenes.

use crate::errors::{bad_input, file_error};
use crate::scene::Scene;
use crate::scene_state::SceneState;
use pairtrawl::files::read_map;
use pairtrawl::generate::{self as scenes, Kind, Litter};
use pyo3::prelude::*;
use std::path::PathBuf;
use std::sync::Arc;

/// Makes a scene that is solvable by construction.
#[pyfunction]
pub fn generate_solvable(
    py: Python<'_>,
    kind: &str,
    difficulty: u8,
    seed: u64,
    waypoints: usize,
) -> PyResult<Scene> {
    let kind = match kind {
        "serpentine" => Kind::Serpentine,
        _ => Kind::Witness,
    };
    let made = py.detach(|| scenes::generate(kind, difficulty, seed, waypoints));
    let made = made.map_err(|error| bad_input(py, &error.to_string()))?;
    let text =
        scenes::scene_toml(&made.scene).map_err(|error| bad_input(py, &error.to_string()))?;
    let state = SceneState::of_text(text).map_err(|error| file_error(py, &error, false))?;
    Ok(Scene::of(Arc::new(state)))
}

/// Scatters litter in an open hall.
#[pyfunction]
pub fn generate_hall(
    py: Python<'_>,
    size: [f64; 2],
    boxes: usize,
    objects: usize,
    near: f64,
    seed: u64,
) -> PyResult<Scene> {
    if !size.iter().all(|side| (1.0..=200.0).contains(side)) {
        return Err(bad_input(
            py,
            &format!("size is {size:?}, both sides must be from 1 to 200 m"),
        ));
    }
    let name = format!(
        "hall-{}x{}-{boxes}-{objects}-{near}-{seed}",
        size[0], size[1]
    );
    let about = litter(py, name, objects, near, seed)?;
    let made = py
        .detach(|| scenes::litter_hall(size, boxes, &about))
        .map_err(|error| bad_input(py, &error.to_string()))?;
    let text = scenes::scene_toml(&made).map_err(|error| bad_input(py, &error.to_string()))?;
    let state = SceneState::of_text(text).map_err(|error| file_error(py, &error, false))?;
    Ok(Scene::of(Arc::new(state)))
}

/// Scatters litter on the floor of a ROS map.
#[pyfunction]
pub fn generate_litter(
    py: Python<'_>,
    map: PathBuf,
    objects: usize,
    near: f64,
    seed: u64,
) -> PyResult<Scene> {
    let about = litter(
        py,
        format!("litter-{objects}-{near}-{seed}"),
        objects,
        near,
        seed,
    )?;
    let map = std::path::absolute(&map).unwrap_or(map);
    let loaded = py
        .detach(|| read_map(&map))
        .map_err(|error| file_error(py, &error, true))?;
    let made = py.detach(|| scenes::litter(loaded.map, loaded.area, &about));
    let made = made.map_err(|error| bad_input(py, &error.to_string()))?;
    let text = scenes::scene_toml_on_map(&made, &map.display().to_string());
    let state = SceneState::with_files(String::new(), false, text)
        .map_err(|error| file_error(py, &error, false))?;
    Ok(Scene::of(Arc::new(state)))
}

fn litter(py: Python<'_>, name: String, objects: usize, near: f64, seed: u64) -> PyResult<Litter> {
    if !(near >= 0.0 && near.is_finite()) {
        return Err(bad_input(
            py,
            &format!("near is {near}, it must be finite and not below 0 (m)"),
        ));
    }
    if !(1..=10_000).contains(&objects) {
        return Err(bad_input(
            py,
            &format!("objects is {objects}, it must be from 1 to 10000"),
        ));
    }
    Ok(Litter {
        name,
        objects,
        near,
        seed,
    })
}
