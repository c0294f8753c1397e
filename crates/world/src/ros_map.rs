//! ROS maps as map_server reads them: a YAML file and the image that it names.
//!
//! This module decodes bytes; who calls it reads the files. Conventions: image row 0 is the top row of the map, `origin`
//! is the pose of the outer corner of its lower left pixel (yaw counter-clockwise), occ = shade when `negate`, else
//! 1 - shade, where shade is the mean of red, green and blue in 0..1. What a pixel means then depends on the mode:
//!
//! | mode | occupied (100) | free (0) | else |
//! |---|---|---|---|
//! | trinary | occ > occupied_thresh | occ < free_thresh | unknown |
//! | scale | as trinary | as trinary | 0..100, linear between the thresholds; unknown where the pixel is not opaque |
//! | raw | | | the byte when it is at most 100, else unknown (negate does not apply) |
//!
//! A planner needs a yes or a no: a cell is an obstacle when its value is above 100 occupied_thresh (trinary and scale: is
//! 100) and free when it is below 100 free_thresh (is 0). Anything else, graded or unknown, is treated as unknown: an
//! obstacle unless the scene says `unknown = "free"`.

mod cells;
mod error;
mod metadata;
mod raster;

pub use cells::{DecodedMap, Unknown, decode};
pub use error::RosMapError;
pub use metadata::{MapMetadata, Mode};
