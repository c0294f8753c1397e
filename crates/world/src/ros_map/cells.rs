use super::error::RosMapError;
use super::metadata::{MapMetadata, Mode};
use super::raster::{Pixel, pixels, read_image};
use pairtrawl_model::{OccupancyMap, Warning};

/// The gray that map_saver writes for unknown cells, of 255.
const UNKNOWN_GRAY: f64 = 205.0;

/// What cells that are neither occupied nor free count as.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Unknown {
    /// Obstacles.
    #[default]
    Occupied,
    /// Free.
    Free,
}

/// A decoded map.
#[derive(Clone, Debug, PartialEq)]
pub struct DecodedMap {
    /// Occupancy of each cell as map_server publishes it: 0 (free) to 100 (occupied), `None` unknown; index
    /// `row * columns + column`, row 0 the lowest.
    pub values: Vec<Option<u8>>,
    /// The same as obstacles.
    pub map: OccupancyMap,
    /// What a person should know about it.
    pub warnings: Vec<Warning>,
}

/// Decodes the image of a map.
///
/// # Errors
/// When the image has an unknown format, no pixel, too many pixels ([`crate::MAX_CELLS`]), or is damaged.
pub fn decode(
    metadata: &MapMetadata,
    image: &[u8],
    unknown: Unknown,
) -> Result<DecodedMap, RosMapError> {
    let image = read_image(image)?;
    let (columns, rows) = (image.width() as usize, image.height() as usize);
    let top_down = pixels(&image)?;
    let bottom_up = || top_down.chunks_exact(columns).rev().flatten();
    let values: Vec<Option<u8>> = bottom_up().map(|p| occupancy(metadata, p)).collect();
    let map = OccupancyMap {
        origin: metadata.origin,
        resolution: metadata.resolution,
        columns,
        rows,
        blocked: values
            .iter()
            .map(|&v| is_blocked(metadata, v, unknown))
            .collect(),
    };
    Ok(DecodedMap {
        warnings: threshold_warning(metadata, &top_down).into_iter().collect(),
        values,
        map,
    })
}

/// The value of a pixel as map_server publishes it.
fn occupancy(metadata: &MapMetadata, pixel: &Pixel) -> Option<u8> {
    let MapMetadata {
        free_thresh,
        occupied_thresh,
        ..
    } = *metadata;
    let occ = occ(metadata, pixel.shade);
    match metadata.mode {
        Mode::Raw => {
            let byte = (pixel.shade * 255.0).round() as u8;
            (byte <= 100).then_some(byte)
        }
        Mode::Scale if !pixel.is_opaque => None,
        _ if occ > occupied_thresh => Some(100),
        _ if occ < free_thresh => Some(0),
        Mode::Trinary => None,
        // Equal thresholds leave the one value between them.
        Mode::Scale if occupied_thresh == free_thresh => None,
        Mode::Scale => Some(
            ((occ - free_thresh) / (occupied_thresh - free_thresh) * 100.0).round_ties_even() as u8,
        ),
    }
}

fn occ(metadata: &MapMetadata, shade: f64) -> f64 {
    if metadata.negate { shade } else { 1.0 - shade }
}

fn is_blocked(metadata: &MapMetadata, value: Option<u8>, unknown: Unknown) -> bool {
    let (free, occupied) = match (metadata.mode, value) {
        (_, None) => (false, false),
        (Mode::Raw, Some(v)) => {
            let part = f64::from(v) / 100.0;
            (part < metadata.free_thresh, part > metadata.occupied_thresh)
        }
        (_, Some(v)) => (v == 0, v == 100),
    };
    occupied || (!free && unknown == Unknown::Occupied)
}

/// map_saver writes unknown cells as gray 205, occ 0.196: a free threshold above that makes them free.
fn threshold_warning(metadata: &MapMetadata, pixels: &[Pixel]) -> Option<Warning> {
    let unknown_shade = UNKNOWN_GRAY / 255.0;
    if metadata.mode == Mode::Raw || occ(metadata, unknown_shade) >= metadata.free_thresh {
        return None;
    }
    let count = pixels
        .iter()
        .filter(|p| (p.shade - unknown_shade).abs() < 1e-9)
        .count();
    (count > 0).then_some(Warning::UnknownCellsFree {
        free_threshold: metadata.free_thresh,
        cells: count,
    })
}
