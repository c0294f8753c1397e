//! The class `Scene`.

use crate::arrays::Floats;
use crate::document::{Edit, dictionary, given_table, pair_table, table};
use crate::errors::{bad_input, file_error, plan_error};
use crate::options::Given;
use crate::pickle;
use crate::scene_state::{FILE_BYTES, SceneState, Source};
use crate::typed::{AnyDict, AnyDicts, ArrayLike, Mapping};
use pairtrawl::files::{read_bounded, read_scene, write_atomically};
use pairtrawl::model::PairPose;
use pairtrawl::{PlanOptions, preview, report};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use std::path::PathBuf;
use std::sync::{Arc, Mutex, PoisonError};
use toml::{Table, Value};

/// The first key of a scene.
const FORMAT: &str = "pairtrawl-scene/1";

/// Everything that a run is planned from: area, obstacles, objects, start and end, robot and net. SI units, radians, map frame.
///
/// Make one with `Scene.from_file`, `Scene.from_toml` or `Scene.from_dict`. The methods `add_...`, `remove_...` and `set_...` change
/// it in place and check it as a whole: a change that makes no sense raises `InputError` and leaves the scene as it was.
#[pyclass(frozen, module = "pairtrawl")]
pub struct Scene {
    state: Mutex<Arc<SceneState>>,
}

impl Scene {
    /// A scene of a state.
    pub fn of(state: Arc<SceneState>) -> Self {
        Self {
            state: Mutex::new(state),
        }
    }

    /// What it is now.
    pub fn state(&self) -> Arc<SceneState> {
        Arc::clone(&self.state.lock().unwrap_or_else(PoisonError::into_inner))
    }

    fn read(py: Python<'_>, source: Source) -> PyResult<Self> {
        let named = source.is_named();
        let read = py.detach(|| SceneState::read(source));
        read.map(|state| Self::of(Arc::new(state)))
            .map_err(|error| file_error(py, &error, named))
    }

    fn edit(&self, py: Python<'_>, edit: Edit) -> PyResult<()> {
        let mut state = self.state.lock().unwrap_or_else(PoisonError::into_inner);
        let mut document = state.document().map_err(|error| bad_input(py, &error))?;
        edit.apply(&mut document)?;
        let text = toml::to_string(&document).map_err(|error| bad_input(py, &error.to_string()))?;
        let changed = state
            .with_text(text)
            .map_err(|error| file_error(py, &error, false))?;
        *state = Arc::new(changed);
        Ok(())
    }
}

/// Left and right pose, 2 x 3.
fn pair(py: Python<'_>, pair: PairPose) -> PyResult<Floats> {
    Floats::poses(py, [pair.left, pair.right].into_iter())
}

#[pymethods]
impl Scene {
    /// Reads a scene file, format pairtrawl-scene/1, and the map that it names.
    #[staticmethod]
    fn from_file(py: Python<'_>, path: PathBuf) -> PyResult<Self> {
        let read = py.detach(|| {
            // The bounds of each kind of file are checked here; its errors name the file.
            read_scene(&path)?;
            let bytes = read_bounded(&path, FILE_BYTES)?;
            let text = String::from_utf8_lossy(&bytes).into_owned();
            SceneState::with_files(path.display().to_string(), true, text)
        });
        read.map(|state| Self::of(Arc::new(state)))
            .map_err(|error| file_error(py, &error, true))
    }

    /// Reads a scene from the text of a scene file. Paths in it are relative to `folder`; left out, it must name no map.
    #[staticmethod]
    #[pyo3(signature = (text, *, folder=None))]
    fn from_toml(py: Python<'_>, text: String, folder: Option<PathBuf>) -> PyResult<Self> {
        let read = match folder {
            Some(folder) => {
                let name = folder.join("scene.toml").display().to_string();
                SceneState::with_files(name, true, text)
            }
            None => SceneState::of_text(text),
        };
        read.map(|state| Self::of(Arc::new(state)))
            .map_err(|error| file_error(py, &error, true))
    }

    /// Makes a scene of a dictionary with the keys of a scene file. `format` may be left out; numpy's numbers and arrays are
    /// taken as numbers and lists, None as a key that is left out. A map is read relative to the current folder.
    #[staticmethod]
    fn from_dict(py: Python<'_>, scene: Mapping<'_>) -> PyResult<Self> {
        let mut document = Table::new();
        document.insert("format".to_owned(), Value::String(FORMAT.to_owned()));
        document.extend(table(&scene.0)?);
        let text = toml::to_string(&document).map_err(|error| bad_input(py, &error.to_string()))?;
        let read = SceneState::with_files(String::new(), false, text);
        read.map(|state| Self::of(Arc::new(state)))
            .map_err(|error| file_error(py, &error, false))
    }

    /// The scene as a dictionary with the keys of a scene file.
    fn to_dict<'py>(&self, py: Python<'py>) -> PyResult<AnyDict<'py>> {
        let document = self
            .state()
            .document()
            .map_err(|error| bad_input(py, &error))?;
        dictionary(py, &document).map(AnyDict)
    }

    /// The text of the scene file. A scene that was not edited has its file's text, comments and all.
    fn to_toml(&self) -> String {
        self.state().source().text().to_owned()
    }

    /// Writes the scene file; with a map, its files must lie where the scene names them.
    fn save(&self, py: Python<'_>, path: PathBuf) -> PyResult<()> {
        let state = self.state();
        let written = py.detach(|| write_atomically(&path, state.source().text().as_bytes()));
        written.map_err(|error| file_error(py, &error, true))
    }

    /// A scene of its own with the same content.
    fn copy(&self) -> Self {
        Self::of(self.state())
    }

    fn __copy__(&self) -> Self {
        self.copy()
    }

    fn __deepcopy__(&self, _memo: AnyDict<'_>) -> Self {
        self.copy()
    }

    /// A name for people.
    #[getter]
    fn name(&self) -> String {
        self.state().loaded.scene.name.clone()
    }

    #[setter]
    fn set_name(&self, py: Python<'_>, name: String) -> PyResult<()> {
        self.edit(py, Edit::Replace("name", Value::String(name)))
    }

    /// SHA-256 of the scene file, then of its map: what plans name the scene by.
    #[getter]
    fn sha256(&self) -> String {
        self.state().loaded.reference.sha256.clone()
    }

    /// What a person should know about the scene.
    #[getter]
    fn warnings(&self) -> Vec<String> {
        self.state()
            .loaded
            .warnings
            .iter()
            .map(ToString::to_string)
            .collect()
    }

    /// Bounds of the area, 2 x 2: the lower left and the upper right corner, m.
    #[getter]
    fn bounds(&self, py: Python<'_>) -> PyResult<Floats> {
        let area = self.state().loaded.scene.area;
        Floats::points(py, [area.min, area.max].into_iter())
    }

    /// Centers of the objects, N x 2, m.
    #[getter]
    fn objects(&self, py: Python<'_>) -> PyResult<Floats> {
        let state = self.state();
        Floats::points(
            py,
            state
                .loaded
                .scene
                .objects
                .iter()
                .map(|object| object.position),
        )
    }

    /// Radius of the smallest circle around each object's footprint, N, m.
    #[getter]
    fn object_radii(&self, py: Python<'_>) -> PyResult<Floats> {
        let state = self.state();
        let objects = state.loaded.scene.objects.iter();
        Floats::list(
            py,
            objects.map(|object| object.footprint_radius()).collect(),
        )
    }

    /// The obstacles, each a dictionary with one key: box = [xmin, ymin, xmax, ymax], polygon = [[x, y], ...] or
    /// circle = [x, y, radius], m.
    #[getter]
    fn obstacles<'py>(&self, py: Python<'py>) -> PyResult<AnyDicts<'py>> {
        AnyDicts::obstacles(py, &self.state().loaded.scene.obstacles)
    }

    /// The boundary of a map's free floor as closed rings, each N x 2, m, to be filled by the even-odd rule; None without a map.
    #[getter]
    fn free_rings(&self, py: Python<'_>) -> PyResult<Option<Vec<Floats>>> {
        let scene = &self.state().loaded.scene;
        if scene.map.is_none() {
            return Ok(None);
        }
        let outline = pairtrawl::summarize_scene(scene, None, None).outline;
        let rings = outline.free_rings.unwrap_or_default();
        let rings = rings
            .into_iter()
            .map(|ring| Floats::points(py, ring.into_iter()));
        rings.collect::<PyResult<Vec<_>>>().map(Some)
    }

    /// Poses of the left and the right robot at the start, 2 x 3: x and y in m, heading in rad.
    #[getter]
    fn start(&self, py: Python<'_>) -> PyResult<Floats> {
        pair(py, self.state().loaded.scene.start)
    }

    /// Poses of the left and the right robot at the end, 2 x 3.
    #[getter]
    fn end(&self, py: Python<'_>) -> PyResult<Floats> {
        pair(py, self.state().loaded.scene.end)
    }

    /// Length of the net, m; None: the planner chooses it.
    #[getter]
    fn net_length(&self) -> Option<f64> {
        self.state().loaded.scene.net.length
    }

    /// Radius of the circle around the axle center that contains a robot, m.
    #[getter]
    fn robot_radius(&self) -> f64 {
        self.state().loaded.scene.robot.radius
    }

    /// How far behind the axle center the net is tied, m.
    #[getter]
    fn hitch(&self) -> f64 {
        self.state().loaded.scene.robot.hitch
    }

    /// Puts an obstacle there: box = (xmin, ymin, xmax, ymax), polygon = ((x, y), ...) or circle = (x, y, radius), m.
    #[pyo3(signature = (*, r#box=None, polygon=None, circle=None))]
    fn add_obstacle(
        &self,
        py: Python<'_>,
        r#box: Option<ArrayLike>,
        polygon: Option<ArrayLike>,
        circle: Option<ArrayLike>,
    ) -> PyResult<()> {
        let table = given_table([("box", r#box), ("polygon", polygon), ("circle", circle)])?;
        self.edit(py, Edit::Push("obstacles", table))
    }

    /// Puts an object there, to be gathered: its center (x, y), its size (width, depth) or radius, m; its mass, kg.
    #[pyo3(signature = (position, *, size=None, radius=None, mass=None))]
    fn add_object(
        &self,
        py: Python<'_>,
        position: ArrayLike,
        size: Option<ArrayLike>,
        radius: Option<f64>,
        mass: Option<f64>,
    ) -> PyResult<()> {
        let mut table = given_table([("position", Some(position)), ("size", size)])?;
        for (key, number) in [("radius", radius), ("mass", mass)] {
            if let Some(number) = number {
                table.insert(key.to_owned(), Value::Float(number));
            }
        }
        self.edit(py, Edit::Push("objects", table))
    }

    /// Takes an obstacle away, by its index.
    fn remove_obstacle(&self, py: Python<'_>, index: usize) -> PyResult<()> {
        self.edit(py, Edit::Remove("obstacles", index))
    }

    /// Takes an object away, by its index.
    fn remove_object(&self, py: Python<'_>, index: usize) -> PyResult<()> {
        self.edit(py, Edit::Remove("objects", index))
    }

    /// Sets where the pair starts: axle centers (x, y), m, and the heading of both, or one for each, rad.
    #[pyo3(signature = (left, right, heading=None, *, left_heading=None, right_heading=None))]
    fn set_start(
        &self,
        py: Python<'_>,
        left: ArrayLike,
        right: ArrayLike,
        heading: Option<f64>,
        left_heading: Option<f64>,
        right_heading: Option<f64>,
    ) -> PyResult<()> {
        let pair = pair_table(&left, &right, heading, left_heading, right_heading)?;
        self.edit(py, Edit::Replace("start", pair))
    }

    /// Sets where the pair ends, as `set_start`.
    #[pyo3(signature = (left, right, heading=None, *, left_heading=None, right_heading=None))]
    fn set_end(
        &self,
        py: Python<'_>,
        left: ArrayLike,
        right: ArrayLike,
        heading: Option<f64>,
        left_heading: Option<f64>,
        right_heading: Option<f64>,
    ) -> PyResult<()> {
        let pair = pair_table(&left, &right, heading, left_heading, right_heading)?;
        self.edit(py, Edit::Replace("end", pair))
    }

    /// Sets keys of `[area]`, such as min, max, resolution; None removes a key.
    #[pyo3(signature = (**keys: "object"))]
    fn set_area(&self, py: Python<'_>, keys: Option<&Bound<'_, PyDict>>) -> PyResult<()> {
        self.edit(py, Edit::update("area", keys)?)
    }

    /// Sets keys of `[robot]`, such as radius, hitch, v_max, omega_max, half_track, body, preset; None removes a key.
    #[pyo3(signature = (**keys: "object"))]
    fn set_robot(&self, py: Python<'_>, keys: Option<&Bound<'_, PyDict>>) -> PyResult<()> {
        self.edit(py, Edit::update("robot", keys)?)
    }

    /// Sets keys of `[net]`: length, m, and start, how it lies at first; None removes a key.
    #[pyo3(signature = (**keys: "object"))]
    fn set_net(&self, py: Python<'_>, keys: Option<&Bound<'_, PyDict>>) -> PyResult<()> {
        self.edit(py, Edit::update("net", keys)?)
    }

    /// Sets keys of `[planner]`, such as max_step, clearance, cruise; None removes a key. NOTATION.md lists all.
    #[pyo3(signature = (**keys: "object"))]
    fn set_planner(&self, py: Python<'_>, keys: Option<&Bound<'_, PyDict>>) -> PyResult<()> {
        self.edit(py, Edit::update("planner", keys)?)
    }

    /// Sets keys of `[physics]`, such as robot_mass, net_mass; None removes a key. NOTATION.md lists all.
    #[pyo3(signature = (**keys: "object"))]
    fn set_physics(&self, py: Python<'_>, keys: Option<&Bound<'_, PyDict>>) -> PyResult<()> {
        self.edit(py, Edit::update("physics", keys)?)
    }

    /// The map as SVG, with circles and visiting order, and with the objects marked that provably cannot be gathered.
    fn svg(&self, py: Python<'_>) -> PyResult<String> {
        let state = self.state();
        let options = PlanOptions::default();
        let drawn = py.detach(|| {
            preview(&state.loaded.scene, &options)
                .map(|preview| report::scene_svg(&preview.summary))
        });
        drawn.map_err(|error| plan_error(py, error, &state, &Given::default()))
    }

    fn _repr_html_(&self, py: Python<'_>) -> PyResult<String> {
        self.svg(py)
    }

    fn __repr__(&self) -> String {
        let state = self.state();
        let scene = &state.loaded.scene;
        let (objects, obstacles) = (scene.objects.len(), scene.obstacles.len());
        format!(
            "<Scene {:?}: {objects} objects, {obstacles} obstacles>",
            scene.name
        )
    }

    fn __eq__(&self, other: PyRef<'_, Self>) -> bool {
        self.state().loaded.scene == other.state().loaded.scene
    }

    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<pickle::Reduced<'py>> {
        pickle::reduce(py, "_restore_scene", self.state().source())
    }
}

/// A scene of its pickle.
#[pyfunction]
pub fn _restore_scene(py: Python<'_>, state: &[u8]) -> PyResult<Scene> {
    Scene::read(py, pickle::restore(py, state)?)
}
