use crate::Summary;

/// Everything that is shown when there is no plan.
#[derive(Clone, Debug, PartialEq)]
pub struct FailedSummary {
    /// The scene, and the best attempt where there is one. It is no plan. The places that are to be seen are its marks.
    pub summary: Summary,
    /// Why there is no plan, in a few words.
    pub verdict: String,
    /// Why there is no plan.
    pub message: String,
    /// What would help.
    pub help: Option<String>,
    /// Every start that was tried and what was missing there, or nothing.
    pub tried: Vec<(String, String)>,
}
