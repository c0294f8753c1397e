/// Why a ROS map cannot be read.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum RosMapError {
    /// The YAML file is not UTF-8 or not YAML, or lacks a key.
    #[error("the map's YAML cannot be read: {reason}")]
    Yaml {
        /// What the parser says, with line and column where it knows them.
        reason: String,
    },
    /// A key of the YAML file has a value that it cannot have.
    #[error("{key} is {value}, it must be {bound}")]
    Value {
        /// The key.
        key: &'static str,
        /// Its value.
        value: String,
        /// What is allowed.
        bound: &'static str,
    },
    /// The image's first bytes are those of no known format.
    #[error(
        "the map image starts with {start:?}: that is neither PNM (P1 to P7 and white space) nor PNG"
    )]
    Magic {
        /// The first bytes, escaped.
        start: String,
    },
    /// The image has no pixel.
    #[error("the map image is {columns} x {rows} pixels: a map needs at least one")]
    Empty {
        /// Width.
        columns: u32,
        /// Height.
        rows: u32,
    },
    /// The image is too large.
    #[error(
        "the map image is {columns} x {rows} pixels, the bound is {bound} altogether: crop it or use a coarser resolution"
    )]
    TooLarge {
        /// Width.
        columns: u32,
        /// Height.
        rows: u32,
        /// The greatest number of pixels.
        bound: usize,
    },
    /// The file ends before the last pixel.
    #[error(
        "the map image is cut off: its header declares {columns} x {rows} pixels, at least {needed} bytes, and {found} bytes follow"
    )]
    Truncated {
        /// Width.
        columns: u32,
        /// Height.
        rows: u32,
        /// Least number of bytes that an image with that many pixels has.
        needed: u64,
        /// Bytes in the file.
        found: u64,
    },
    /// The image decoder gives up.
    #[error("the map image cannot be decoded: {reason}")]
    Image {
        /// What the decoder says.
        reason: String,
    },
}
