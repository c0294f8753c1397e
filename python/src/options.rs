//! Options of planning by keyword.

use crate::errors::bad_input;
use pairtrawl::model::Leave;
use pairtrawl::{CenterlineMethod, Method, NetLength, OrderMethod, PlanOptions, RehearsalMode};
use pyo3::exceptions::PyTypeError;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use std::time::Duration;

/// The keywords.
const KEYS: [&str; 14] = [
    "net_length",
    "waypoints",
    "order",
    "orders",
    "explore",
    "centerline",
    "method",
    "tolerance",
    "seed",
    "time_limit",
    "leave",
    "rehearsal",
    "rounds",
    "rehearsal_rounds",
];

/// Greatest net length that is taken, m, and greatest number of waypoints, as on the command line.
const LONGEST_NET: f64 = 1000.0;
const MOST_WAYPOINTS: usize = 100_000;

/// Options as they were given.
#[derive(Clone, Debug, Default)]
pub struct Given {
    /// The same for the library.
    pub plan: PlanOptions,
}

/// Reads keywords; None stands for the default.
pub fn options(given: &Bound<'_, PyDict>) -> PyResult<Given> {
    let mut plan = PlanOptions::default();
    for (key, value) in given {
        let key: String = key.extract()?;
        if !KEYS.contains(&key.as_str()) {
            return Err(unknown(&key));
        }
        if value.is_none() {
            continue;
        }
        set(&mut plan, &key, &value)?;
    }
    Ok(Given { plan })
}

fn unknown(key: &str) -> PyErr {
    let near = KEYS.iter().max_by(|a, b| {
        let (a, b) = (strsim::jaro_winkler(a, key), strsim::jaro_winkler(b, key));
        a.total_cmp(&b)
    });
    let near = near.map_or_else(String::new, |near| format!("; did you mean {near}?"));
    PyTypeError::new_err(format!("there is no option {key}{near}"))
}

fn set(plan: &mut PlanOptions, key: &str, value: &Bound<'_, PyAny>) -> PyResult<()> {
    let py = value.py();
    let refuse = |bound: &str| {
        let shown = value
            .repr()
            .map_or_else(|_| "?".to_owned(), |shown| shown.to_string());
        bad_input(py, &format!("{key} is {shown}, it must be {bound}"))
    };
    let count = |least: usize, most: usize, bound: &str| match value.extract::<usize>() {
        Ok(count) if (least..=most).contains(&count) => Ok(count),
        _ => Err(refuse(bound)),
    };
    let name = || value.extract::<String>().unwrap_or_default();
    match key {
        "net_length" => {
            plan.net_length = Some(match value.extract::<f64>() {
                Ok(length) if length > 0.0 && length <= LONGEST_NET => NetLength::Fixed(length),
                Err(_) if name() == "auto" => NetLength::Auto,
                _ => return Err(refuse("a length above 0 and up to 1000 (m), or \"auto\"")),
            });
        }
        "waypoints" => plan.waypoints = Some(count(3, MOST_WAYPOINTS, "from 3 to 100000")?),
        "orders" => plan.orders = count(1, 1000, "from 1 to 1000")?,
        "rounds" => plan.rounds = count(1, 1000, "from 1 to 1000")?,
        "rehearsal_rounds" => plan.rehearsal_rounds = count(0, 1000, "from 0 to 1000")?,
        "seed" => {
            plan.seed = value
                .extract()
                .map_err(|_| refuse("a whole number, 0 or more"))?
        }
        "explore" => plan.explore = value.extract().map_err(|_| refuse("True or False"))?,
        "order" => {
            plan.order = match name().as_str() {
                "given" => OrderMethod::Given,
                "shortest" => OrderMethod::Shortest,
                _ => return Err(refuse("\"given\" or \"shortest\"")),
            };
        }
        "centerline" => {
            plan.centerline = Some(match name().as_str() {
                "hybrid-a-star" => CenterlineMethod::HybridAStar,
                "rrt-star" => CenterlineMethod::RrtStar,
                _ => return Err(refuse("\"hybrid-a-star\" or \"rrt-star\"")),
            });
        }
        "method" => {
            plan.method = match name().as_str() {
                "joint" => Method::Joint,
                "alternating" => Method::Alternating,
                "alternating-bounded" => Method::AlternatingBounded,
                _ => {
                    return Err(refuse(
                        "\"joint\", \"alternating\" or \"alternating-bounded\"",
                    ));
                }
            };
        }
        "tolerance" => {
            plan.tolerance = match value.extract::<f64>() {
                Ok(tolerance) if (1e-9..=1e-3).contains(&tolerance) => Some(tolerance),
                _ => return Err(refuse("a relative residual from 1e-9 to 1e-3")),
            };
        }
        "time_limit" => {
            plan.time_limit = match value.extract::<f64>() {
                Ok(limit) if limit > 0.0 && limit <= 1e6 => Some(Duration::from_secs_f64(limit)),
                _ => return Err(refuse("a number of seconds above 0 and up to 1000000")),
            };
        }
        "leave" => {
            let leave = Leave::ALL.into_iter().find(|leave| leave.name() == name());
            plan.leave = Some(leave.ok_or_else(|| refuse("\"none\" or \"unreachable\""))?);
        }
        _ => {
            plan.rehearsal = match (value.extract::<bool>(), name().as_str()) {
                (Ok(false), _) | (_, "skip") => RehearsalMode::Skip,
                (Ok(true), _) | (_, "report") => RehearsalMode::Report,
                (_, "require") => RehearsalMode::Require,
                _ => {
                    return Err(refuse(
                        "\"skip\", \"report\" or \"require\", or True or False",
                    ));
                }
            };
        }
    }
    Ok(())
}
