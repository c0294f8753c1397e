use super::error::RosMapError;
use pairtrawl_geometry::Pose;
use serde::Deserialize;

/// What a map_server YAML file says.
#[derive(Clone, Debug, PartialEq)]
pub struct MapMetadata {
    /// The image file, relative to the YAML file unless absolute.
    pub image: String,
    /// Edge length of a pixel, m.
    pub resolution: f64,
    /// Pose of the outer corner of the lower left pixel, map frame.
    pub origin: Pose,
    /// A pixel with occ below this is free, 0..1.
    pub free_thresh: f64,
    /// A pixel with occ above this is occupied, 0..1.
    pub occupied_thresh: f64,
    /// True when white is occupied.
    pub negate: bool,
    /// How pixels become values.
    pub mode: Mode,
}

/// How pixels become occupancy values.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Mode {
    /// Occupied, free or unknown.
    #[default]
    Trinary,
    /// Like trinary, but linear between the thresholds.
    Scale,
    /// The byte itself.
    Raw,
}

/// The file as it stands. Keys that map_server does not know are ignored, as it does.
#[derive(Deserialize)]
struct File {
    image: String,
    resolution: f64,
    origin: Vec<f64>,
    free_thresh: f64,
    occupied_thresh: f64,
    negate: Negate,
    mode: Option<String>,
}

#[derive(Deserialize)]
#[serde(untagged)]
enum Negate {
    Flag(bool),
    Number(i64),
}

impl MapMetadata {
    /// Reads a YAML file.
    ///
    /// # Errors
    /// When it is not UTF-8 or not YAML, a key is missing or of the wrong type, or a value out of range.
    pub fn parse(yaml: &[u8]) -> Result<Self, RosMapError> {
        let text = std::str::from_utf8(yaml).map_err(|e| RosMapError::Yaml {
            reason: format!("it is not UTF-8: {e}"),
        })?;
        let file: File = serde_saphyr::from_str(text).map_err(|e| RosMapError::Yaml {
            reason: one_line(&e.to_string()),
        })?;
        let negate = match file.negate {
            Negate::Flag(flag) => flag,
            Negate::Number(0) => false,
            Negate::Number(1) => true,
            Negate::Number(n) => return Err(value_error("negate", n, "0, 1, true or false")),
        };
        let mode = match file.mode.as_deref() {
            None | Some("trinary") => Mode::Trinary,
            Some("scale") => Mode::Scale,
            Some("raw") => Mode::Raw,
            Some(other) => {
                return Err(value_error("mode", other, "trinary, scale or raw"));
            }
        };
        if file.image.is_empty() {
            return Err(value_error(
                "image",
                "empty",
                "the name of a PGM or PNG file",
            ));
        }
        if !(file.resolution.is_finite() && file.resolution > 0.0) {
            return Err(value_error(
                "resolution",
                file.resolution,
                "finite and above zero (m per pixel)",
            ));
        }
        let origin = match *file.origin.as_slice() {
            [x, y, yaw] if Pose::new(x, y, yaw).is_finite() => Pose::new(x, y, yaw),
            _ => {
                return Err(value_error(
                    "origin",
                    format!("{:?}", file.origin),
                    "three finite numbers: x, y (m), yaw (rad)",
                ));
            }
        };
        for (key, value) in [
            ("free_thresh", file.free_thresh),
            ("occupied_thresh", file.occupied_thresh),
        ] {
            if !(0.0..=1.0).contains(&value) {
                return Err(value_error(key, value, "from 0 to 1"));
            }
        }
        if file.free_thresh > file.occupied_thresh {
            return Err(value_error(
                "free_thresh",
                file.free_thresh,
                "at most occupied_thresh",
            ));
        }
        Ok(Self {
            image: file.image,
            resolution: file.resolution,
            origin,
            free_thresh: file.free_thresh,
            occupied_thresh: file.occupied_thresh,
            negate,
            mode,
        })
    }
}

impl MapMetadata {
    /// The YAML file of a copy of the map whose image lies beside it under this name.
    pub fn to_yaml(&self, image: &str) -> String {
        let Pose { x, y, heading } = self.origin;
        let mode = match self.mode {
            Mode::Trinary => "trinary",
            Mode::Scale => "scale",
            Mode::Raw => "raw",
        };
        format!(
            "image: {image}\nmode: {mode}\nresolution: {:?}\norigin: [{x:?}, {y:?}, {heading:?}]\nnegate: {}\n\
             occupied_thresh: {:?}\nfree_thresh: {:?}\n",
            self.resolution,
            u8::from(self.negate),
            self.occupied_thresh,
            self.free_thresh
        )
    }
}

fn value_error(key: &'static str, value: impl ToString, bound: &'static str) -> RosMapError {
    RosMapError::Value {
        key,
        value: value.to_string(),
        bound,
    }
}

/// The parser's message without its drawing of the line in question.
fn one_line(message: &str) -> String {
    let line = message.lines().next().unwrap_or_default().trim();
    line.strip_prefix("error: ").unwrap_or(line).to_owned()
}
