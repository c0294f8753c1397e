//! The classes of `pairtrawl.results`, which are written in Python: plain data needs no Rust. They are made here by keyword.

use pyo3::prelude::*;
use pyo3::sync::PyOnceLock;
use pyo3::types::{PyDict, PyModule};

static RESULTS: PyOnceLock<Py<PyModule>> = PyOnceLock::new();

/// An object of a class of `pairtrawl.results`.
pub fn make<'py>(
    py: Python<'py>,
    class: &str,
    fields: &Bound<'py, PyDict>,
) -> PyResult<Bound<'py, PyAny>> {
    let results = RESULTS.get_or_try_init(py, || {
        PyModule::import(py, "pairtrawl.results").map(Bound::unbind)
    })?;
    results.bind(py).getattr(class)?.call((), Some(fields))
}

/// Declares what is returned to Python as an object of a class of `pairtrawl.results`, so that the stubs name it.
macro_rules! python_class {
    ($(#[$about:meta])* $name:ident) => {
        $(#[$about])*
        pub struct $name<'py>(pub Bound<'py, PyAny>);

        impl<'py> IntoPyObject<'py> for $name<'py> {
            type Target = PyAny;
            type Output = Bound<'py, PyAny>;
            type Error = std::convert::Infallible;

            const OUTPUT_TYPE: pyo3::inspect::PyStaticExpr =
                pyo3::type_hint_identifier!("pairtrawl.results", stringify!($name));

            fn into_pyobject(self, _: Python<'py>) -> Result<Self::Output, Self::Error> {
                Ok(self.0)
            }
        }

        impl<'py> $name<'py> {
            /// Made of its fields.
            pub fn make(py: Python<'py>, fields: &Bound<'py, pyo3::types::PyDict>) -> PyResult<Self> {
                crate::python_class::make(py, stringify!($name), fields).map(Self)
            }
        }
    };
}
pub(crate) use python_class;

/// A dictionary of fields.
macro_rules! fields {
    ($py:expr; $($key:ident: $value:expr),* $(,)?) => {{
        let fields = pyo3::types::PyDict::new($py);
        $(pyo3::types::PyDictMethods::set_item(&fields, pyo3::intern!($py, stringify!($key)), $value)?;)*
        fields
    }};
}
pub(crate) use fields;
