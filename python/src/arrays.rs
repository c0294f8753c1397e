//! What numpy sees of our numbers: read-only arrays of floats that own their memory, so that they outlive what they come from.

use numpy::ndarray::ArrayD;
use numpy::{PyArrayDyn, PyArrayMethods};
use pairtrawl::geometry::{Point, Pose};
use pyo3::exceptions::PyRuntimeError;
use pyo3::inspect::PyStaticExpr;
use pyo3::prelude::*;
use pyo3::sync::PyOnceLock;
use pyo3::{type_hint_identifier, type_hint_subscript};
use std::convert::Infallible;

/// An array of floats that nobody writes to.
pub struct Floats(Py<PyArrayDyn<f64>>);

impl Floats {
    /// Values in C order in a shape. The values are moved, not copied.
    pub fn new(py: Python<'_>, shape: &[usize], values: Vec<f64>) -> PyResult<Self> {
        let array = ArrayD::from_shape_vec(shape, values)
            .map_err(|error| PyRuntimeError::new_err(error.to_string()))?;
        let array = PyArrayDyn::from_owned_array(py, array);
        array.readwrite().make_nonwriteable();
        Ok(Self(array.unbind()))
    }

    /// N values.
    pub fn list(py: Python<'_>, values: Vec<f64>) -> PyResult<Self> {
        Self::new(py, &[values.len()], values)
    }

    /// N x 3: x and y in m, heading in rad.
    pub fn poses(py: Python<'_>, poses: impl ExactSizeIterator<Item = Pose>) -> PyResult<Self> {
        let shape = [poses.len(), 3];
        Self::new(py, &shape, poses.flat_map(<[f64; 3]>::from).collect())
    }

    /// N x 2: x and y in m.
    pub fn points(py: Python<'_>, points: impl ExactSizeIterator<Item = Point>) -> PyResult<Self> {
        let shape = [points.len(), 2];
        Self::new(py, &shape, points.flat_map(<[f64; 2]>::from).collect())
    }
}

impl<'py> IntoPyObject<'py> for Floats {
    type Target = PyArrayDyn<f64>;
    type Output = Bound<'py, PyArrayDyn<f64>>;
    type Error = Infallible;

    const OUTPUT_TYPE: PyStaticExpr = type_hint_subscript!(
        type_hint_identifier!("numpy.typing", "NDArray"),
        type_hint_identifier!("numpy", "float64")
    );

    fn into_pyobject(self, py: Python<'py>) -> Result<Self::Output, Self::Error> {
        Ok(self.0.into_bound(py))
    }
}

/// An array that is made when it is first asked for, and the same object from then on.
pub struct Lazy(PyOnceLock<Py<PyArrayDyn<f64>>>);

impl Default for Lazy {
    fn default() -> Self {
        Self(PyOnceLock::new())
    }
}

impl Lazy {
    /// The array.
    pub fn get(
        &self,
        py: Python<'_>,
        make: impl FnOnce(Python<'_>) -> PyResult<Floats>,
    ) -> PyResult<Floats> {
        let array = self.0.get_or_try_init(py, || make(py).map(|made| made.0))?;
        Ok(Floats(array.clone_ref(py)))
    }
}
