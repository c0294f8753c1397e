//! The map: what is drawn where, for the picture and for the page.

mod labels;
mod layers;
mod legend;
mod projection;

pub(crate) use labels::{labels, mark_name};
pub(crate) use layers::Layer;
pub(crate) use legend::{Sign, sign};
pub(crate) use projection::{Projection, View};

/// Style of everything on a map, light and dark.
pub(crate) const STYLE: &str = include_str!("../assets/map.css");
