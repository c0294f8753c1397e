//! Pickles: a function of this module and the bytes that it makes the object of again.

use crate::errors::bad_input;
use pyo3::inspect::PyStaticExpr;
use pyo3::prelude::*;
use pyo3::types::{PyBytes, PyModule, PyTuple};
use pyo3::{type_hint_identifier, type_hint_subscript};
use serde::Serialize;
use serde::de::DeserializeOwned;
use std::convert::Infallible;

/// What `__reduce__` returns.
pub struct Reduced<'py>(Bound<'py, PyTuple>);

impl<'py> IntoPyObject<'py> for Reduced<'py> {
    type Target = PyTuple;
    type Output = Bound<'py, PyTuple>;
    type Error = Infallible;

    const OUTPUT_TYPE: PyStaticExpr = type_hint_subscript!(
        type_hint_identifier!("builtins", "tuple"),
        type_hint_identifier!("typing", "Any"),
        PyStaticExpr::Constant {
            value: pyo3::inspect::PyStaticConstant::Ellipsis
        }
    );

    fn into_pyobject(self, _: Python<'py>) -> Result<Self::Output, Self::Error> {
        Ok(self.0)
    }
}

/// The name of a function of this module, and the bytes of a state.
pub fn reduce<'py>(
    py: Python<'py>,
    function: &str,
    state: &impl Serialize,
) -> PyResult<Reduced<'py>> {
    let bytes = postcard::to_stdvec(state).map_err(|error| bad_input(py, &error.to_string()))?;
    let function = PyModule::import(py, "pairtrawl._native")?.getattr(function)?;
    let arguments = (PyBytes::new(py, &bytes),).into_pyobject(py)?;
    Ok(Reduced((function, arguments).into_pyobject(py)?))
}

/// The state of bytes.
pub fn restore<T: DeserializeOwned>(py: Python<'_>, bytes: &[u8]) -> PyResult<T> {
    postcard::from_bytes(bytes)
        .map_err(|error| bad_input(py, &format!("this pickle is of another version: {error}")))
}
