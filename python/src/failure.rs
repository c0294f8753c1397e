//! The picture of a search that found no plan.

use crate::scene_state::SceneState;
use pairtrawl::model::FailedSummary;
use pairtrawl::report::{failed_html, failed_svg};
use pairtrawl::{PlanError, PlanOptions, summarize_failure};
use pyo3::prelude::*;
use std::sync::Arc;

/// What a picture of a failed search is drawn from. Exceptions carry it; see `PlanningError.svg`.
#[pyclass(frozen, module = "pairtrawl._native")]
pub struct Failure {
    error: PlanError,
    scene: Arc<SceneState>,
    options: PlanOptions,
}

impl Failure {
    /// A failure to plan a scene with some options.
    pub fn new(error: PlanError, scene: Arc<SceneState>, options: PlanOptions) -> Self {
        Self {
            error,
            scene,
            options,
        }
    }

    fn summary(&self) -> Option<FailedSummary> {
        summarize_failure(&self.scene.loaded.scene, &self.options, &self.error)
    }
}

#[pymethods]
impl Failure {
    /// The map with what is in the way, as SVG; None where there is nothing to see.
    fn svg(&self) -> Option<String> {
        self.summary().map(|summary| failed_svg(&summary))
    }

    /// The page about it, as HTML; None where there is nothing to see.
    fn html(&self) -> Option<String> {
        self.summary().map(|summary| failed_html(&summary))
    }
}
