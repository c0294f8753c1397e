//! Planning many scenes, each by a process of its own: what one of them uses of memory is its own, and what it does to
//! itself the others do not feel.

mod child;
mod scenes;

pub use child::{Child, Ended};
pub use scenes::{SceneFile, scenes_below};
