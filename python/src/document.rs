//! A scene as a TOML document, which dictionaries become and edits change. What it says is judged by the reader of scene files
//! alone, so that a scene made in Python is held to the same rules.

use crate::typed::ArrayLike;
use pyo3::exceptions::{PyKeyError, PyTypeError};
use pyo3::prelude::*;
use pyo3::types::{PyBool, PyDict, PyFloat, PyInt, PyList, PyString};
use toml::{Table, Value};

/// A Python value as TOML; None: there is nothing. Numbers of numpy are numbers, its arrays are lists.
pub fn value(given: &Bound<'_, PyAny>) -> PyResult<Option<Value>> {
    if given.is_none() {
        return Ok(None);
    }
    if given.is_instance_of::<PyBool>() {
        return Ok(Some(Value::Boolean(given.extract()?)));
    }
    if given.is_instance_of::<PyString>() {
        return Ok(Some(Value::String(given.extract()?)));
    }
    if given.is_instance_of::<PyFloat>() {
        return Ok(Some(Value::Float(given.extract()?)));
    }
    if given.is_instance_of::<PyInt>() {
        return Ok(Some(Value::Integer(given.extract()?)));
    }
    if given.hasattr("keys")? {
        return Ok(Some(Value::Table(table(given)?)));
    }
    // Scalars of numpy and whatever else counts as a number, unless it has elements.
    if !given.hasattr("__len__")?
        || given.hasattr("ndim")? && given.getattr("ndim")?.extract::<usize>()? == 0
    {
        if given.hasattr("__index__")? {
            return Ok(Some(Value::Integer(given.extract()?)));
        }
        if given.hasattr("__float__")? {
            return Ok(Some(Value::Float(
                given.call_method0("__float__")?.extract()?,
            )));
        }
        let kind = given.get_type().name()?;
        return Err(PyTypeError::new_err(format!(
            "a scene holds numbers, texts, lists and dictionaries, but {given} is a {kind}"
        )));
    }
    let mut values = Vec::new();
    for element in given.try_iter()? {
        match value(&element?)? {
            Some(element) => values.push(element),
            None => {
                return Err(PyTypeError::new_err(
                    "a list in a scene holds None: leave the element out",
                ));
            }
        }
    }
    Ok(Some(Value::Array(values)))
}

/// A mapping as a TOML table; keys whose value is None are left out.
pub fn table(given: &Bound<'_, PyAny>) -> PyResult<Table> {
    let mut table = Table::new();
    for key in given.call_method0("keys")?.try_iter()? {
        let key = key?;
        if let Some(value) = value(&given.get_item(&key)?)? {
            table.insert(key.extract()?, value);
        }
    }
    Ok(table)
}

/// A TOML table as a dictionary.
pub fn dictionary<'py>(py: Python<'py>, table: &Table) -> PyResult<Bound<'py, PyDict>> {
    let given = PyDict::new(py);
    for (key, value) in table {
        given.set_item(key, object(py, value)?)?;
    }
    Ok(given)
}

/// A TOML value as a Python object.
pub fn object<'py>(py: Python<'py>, value: &Value) -> PyResult<Bound<'py, PyAny>> {
    Ok(match value {
        Value::String(text) => text.into_pyobject(py)?.into_any(),
        Value::Integer(number) => number.into_pyobject(py)?.into_any(),
        Value::Float(number) => number.into_pyobject(py)?.into_any(),
        Value::Boolean(truth) => truth.into_pyobject(py)?.to_owned().into_any(),
        // No key of a scene is a date.
        Value::Datetime(date) => date.to_string().into_pyobject(py)?.into_any(),
        Value::Array(values) => {
            let values = values.iter().map(|value| object(py, value));
            PyList::new(py, values.collect::<PyResult<Vec<_>>>()?)?.into_any()
        }
        Value::Table(table) => dictionary(py, table)?.into_any(),
    })
}

/// What is to be changed in a document. It is made of Python's values before the document is touched.
pub enum Edit {
    /// One more element of a list of tables.
    Push(&'static str, Table),
    /// One element less.
    Remove(&'static str, usize),
    /// Keys of a table that are set; `None`: removed.
    Update(&'static str, Vec<(String, Option<Value>)>),
    /// A table or a value that is replaced.
    Replace(&'static str, Value),
}

impl Edit {
    /// Keys of a table from keywords; None removes a key.
    pub fn update(table: &'static str, keywords: Option<&Bound<'_, PyDict>>) -> PyResult<Self> {
        let mut keys = Vec::new();
        for (key, given) in keywords.into_iter().flatten() {
            keys.push((key.extract()?, value(&given)?));
        }
        Ok(Self::Update(table, keys))
    }

    /// Changes a document.
    pub fn apply(self, document: &mut Table) -> PyResult<()> {
        match self {
            Self::Push(list, element) => match document
                .entry(list)
                .or_insert_with(|| Value::Array(Vec::new()))
            {
                Value::Array(elements) => elements.push(Value::Table(element)),
                _ => return Err(PyKeyError::new_err(format!("{list} is no list"))),
            },
            Self::Remove(list, index) => match document.get_mut(list) {
                Some(Value::Array(elements)) if index < elements.len() => {
                    elements.remove(index);
                }
                elements => {
                    let count = elements
                        .and_then(|e| e.as_array().map(Vec::len))
                        .unwrap_or(0);
                    let words =
                        format!("{list} has {count} elements, so there is no element {index}");
                    return Err(pyo3::exceptions::PyIndexError::new_err(words));
                }
            },
            Self::Update(name, keys) => {
                let table = document
                    .entry(name)
                    .or_insert_with(|| Value::Table(Table::new()));
                if let Value::Table(table) = table {
                    for (key, value) in keys {
                        match value {
                            Some(value) => table.insert(key, value),
                            None => table.remove(&key),
                        };
                    }
                }
            }
            Self::Replace(name, value) => {
                document.insert(name.to_owned(), value);
            }
        }
        Ok(())
    }
}

/// `[start]` or `[end]` of two positions and their headings.
pub fn pair_table(
    left: &ArrayLike,
    right: &ArrayLike,
    heading: Option<f64>,
    left_heading: Option<f64>,
    right_heading: Option<f64>,
) -> PyResult<Value> {
    let mut table = Table::new();
    for (key, position) in [("left", left), ("right", right)] {
        if let Some(position) = value(&position.0)? {
            table.insert(key.to_owned(), position);
        }
    }
    let headings = [
        ("heading", heading),
        ("left_heading", left_heading),
        ("right_heading", right_heading),
    ];
    for (key, heading) in headings {
        if let Some(heading) = heading {
            table.insert(key.to_owned(), Value::Float(heading));
        }
    }
    Ok(Value::Table(table))
}

/// A table of those keys that are given.
pub fn given_table<const N: usize>(keys: [(&str, Option<ArrayLike>); N]) -> PyResult<Table> {
    let mut table = Table::new();
    for (key, given) in keys {
        if let Some(given) = given.map(|given| value(&given.0)).transpose()?.flatten() {
            table.insert(key.to_owned(), given);
        }
    }
    Ok(table)
}
