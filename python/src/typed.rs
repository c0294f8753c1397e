//! What arguments and results are called in the stubs where Rust's types say too little.

use pairtrawl::model::Obstacle;
use pyo3::inspect::PyStaticExpr;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList};
use pyo3::{type_hint_identifier, type_hint_subscript, type_hint_union};
use std::convert::Infallible;

const ANY_DICT: PyStaticExpr = type_hint_subscript!(
    type_hint_identifier!("builtins", "dict"),
    type_hint_identifier!("builtins", "str"),
    type_hint_identifier!("typing", "Any")
);

/// Declares an argument that is taken as it is, with the type that the stubs show.
macro_rules! argument {
    ($(#[$about:meta])* $name:ident, $type:expr) => {
        $(#[$about])*
        pub struct $name<'py>(pub Bound<'py, PyAny>);

        impl<'py> FromPyObject<'_, 'py> for $name<'py> {
            type Error = PyErr;

            const INPUT_TYPE: PyStaticExpr = $type;

            fn extract(given: Borrowed<'_, 'py, PyAny>) -> PyResult<Self> {
                Ok(Self(given.to_owned()))
            }
        }
    };
}

argument!(
    /// Numbers in rows: a numpy array or whatever becomes one.
    ArrayLike,
    type_hint_identifier!("numpy.typing", "ArrayLike")
);
argument!(
    /// Keys and values.
    Mapping,
    type_hint_subscript!(
        type_hint_identifier!("collections.abc", "Mapping"),
        type_hint_identifier!("builtins", "str"),
        type_hint_identifier!("typing", "Any")
    )
);
argument!(
    /// What is called with keywords when there is something to report; None: nothing is.
    Progress,
    type_hint_union!(
        type_hint_subscript!(
            type_hint_identifier!("collections.abc", "Callable"),
            PyStaticExpr::Constant {
                value: pyo3::inspect::PyStaticConstant::Ellipsis
            },
            type_hint_identifier!("builtins", "object")
        ),
        PyStaticExpr::Constant {
            value: pyo3::inspect::PyStaticConstant::None
        }
    )
);

impl<'py> Progress<'py> {
    /// The callable, where there is one.
    pub fn callable(&self) -> Option<&Bound<'py, PyAny>> {
        (!self.0.is_none()).then_some(&self.0)
    }
}

/// A dictionary with names as keys.
pub struct AnyDict<'py>(pub Bound<'py, PyDict>);

impl<'py> IntoPyObject<'py> for AnyDict<'py> {
    type Target = PyDict;
    type Output = Bound<'py, PyDict>;
    type Error = Infallible;

    const OUTPUT_TYPE: PyStaticExpr = ANY_DICT;

    fn into_pyobject(self, _: Python<'py>) -> Result<Self::Output, Self::Error> {
        Ok(self.0)
    }
}

impl<'py> FromPyObject<'_, 'py> for AnyDict<'py> {
    type Error = PyErr;

    const INPUT_TYPE: PyStaticExpr = ANY_DICT;

    fn extract(given: Borrowed<'_, 'py, PyAny>) -> PyResult<Self> {
        Ok(Self(given.to_owned().cast_into::<PyDict>()?))
    }
}

/// Dictionaries with names as keys.
pub struct AnyDicts<'py>(Bound<'py, PyList>);

impl<'py> IntoPyObject<'py> for AnyDicts<'py> {
    type Target = PyList;
    type Output = Bound<'py, PyList>;
    type Error = Infallible;

    const OUTPUT_TYPE: PyStaticExpr =
        type_hint_subscript!(type_hint_identifier!("builtins", "list"), ANY_DICT);

    fn into_pyobject(self, _: Python<'py>) -> Result<Self::Output, Self::Error> {
        Ok(self.0)
    }
}

impl<'py> AnyDicts<'py> {
    /// Obstacles with the keys of a scene file.
    pub fn obstacles(py: Python<'py>, obstacles: &[Obstacle]) -> PyResult<Self> {
        let list = PyList::empty(py);
        for obstacle in obstacles {
            let dict = PyDict::new(py);
            match obstacle {
                Obstacle::Box { min, max } => {
                    dict.set_item("box", [min.x, min.y, max.x, max.y])?;
                }
                Obstacle::Polygon(vertices) => {
                    let vertices = vertices.iter().map(|&vertex| <[f64; 2]>::from(vertex));
                    dict.set_item("polygon", vertices.collect::<Vec<_>>())?;
                }
                Obstacle::Circle { center, radius } => {
                    dict.set_item("circle", [center.x, center.y, *radius])?;
                }
            }
            list.append(dict)?;
        }
        Ok(Self(list))
    }
}
