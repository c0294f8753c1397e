//! What is particular to pages and charts of studies.

pub(super) const STYLE: &str = include_str!("../../assets/study.css");
