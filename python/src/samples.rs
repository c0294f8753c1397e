//! What the controllers did, over time.

use crate::arrays::Floats;
use pairtrawl::model::ControlSample;
use pyo3::prelude::*;
use pyo3::types::PyDict;

/// What is shown of a sample: a value for each robot.
type Pick = fn(&ControlSample) -> [f64; 2];

/// As keyword arguments: sample_times (S), error, forward, turn_rate and drag (S x 2), torque (S x 2 x 2).
pub fn samples_into(fields: &Bound<'_, PyDict>, samples: &[ControlSample]) -> PyResult<()> {
    let py = fields.py();
    let count = samples.len();
    let times = samples.iter().map(|sample| sample.time).collect();
    fields.set_item("sample_times", Floats::list(py, times)?)?;
    let pairs: [(&str, Pick); 4] = [
        ("error", |sample| sample.error),
        ("forward", |sample| sample.forward),
        ("turn_rate", |sample| sample.turn_rate),
        ("drag", |sample| sample.drag),
    ];
    for (name, pick) in pairs {
        let values = samples.iter().flat_map(pick).collect();
        fields.set_item(name, Floats::new(py, &[count, 2], values)?)?;
    }
    let torques = samples
        .iter()
        .flat_map(|sample| sample.torque.into_iter().flatten());
    fields.set_item(
        "torque",
        Floats::new(py, &[count, 2, 2], torques.collect())?,
    )
}
