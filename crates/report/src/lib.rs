//! Pages, pictures and tables of plans and runs. Everything here renders what is finished already and computes nothing but
//! where on the paper things go: a [`pairtrawl_model::Summary`], a [`pairtrawl_model::FailedSummary`], a
//! [`pairtrawl_model::LengthCurve`] or a [`pairtrawl_model::Bench`]; recordings show a [`pairtrawl_model::Trial`]; a
//! [`study::Study`] is a page of tables, charts and pictures.

mod axis;
mod bench_page;
mod csv;
mod frame;
mod length_svg;
mod map;
pub mod mcap;
mod page;
mod plan_svg;
pub mod study;
mod svg;
mod words;

pub use bench_page::bench_html;
pub use csv::{length_csv, series_csv};
pub use length_svg::length_svg;
pub use page::{failed_html, report_html};
pub use plan_svg::{failed_svg, plan_svg, scene_svg};
