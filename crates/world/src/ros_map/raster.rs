use super::error::RosMapError;
use crate::grid::MAX_CELLS;
use image::codecs::png::PngDecoder;
use image::codecs::pnm::{PnmDecoder, PnmSubtype, SampleEncoding};
use image::{DynamicImage, ImageDecoder, ImageError, Limits};
use std::io::Cursor;

/// Bytes that a decoder may allocate: [`MAX_CELLS`] pixels of 4 x 16 bit, and as much again to work with.
const MAX_BYTES: u64 = 16 * MAX_CELLS as u64;

/// Decodes a PNM or PNG image. The header is judged before memory is taken for the pixels.
pub(super) fn read_image(bytes: &[u8]) -> Result<DynamicImage, RosMapError> {
    const PNG: [u8; 8] = [0x89, b'P', b'N', b'G', 0x0d, 0x0a, 0x1a, 0x0a];
    match bytes {
        // The decoder takes the two bytes alone and would read `P39151` as a P3 of width 9151.
        [b'P', b'1'..=b'7', next, ..] if next.is_ascii_whitespace() || *next == b'#' => {
            read_pnm(bytes)
        }
        _ if bytes.starts_with(&PNG) => {
            let mut limits = Limits::default();
            limits.max_alloc = Some(MAX_BYTES);
            let decoder = PngDecoder::with_limits(Cursor::new(bytes), limits).map_err(refuse)?;
            check_size(decoder.dimensions())?;
            DynamicImage::from_decoder(decoder).map_err(refuse)
        }
        _ => {
            let start = bytes
                .iter()
                .take(8)
                .flat_map(|b| std::ascii::escape_default(*b))
                .map(char::from)
                .collect();
            Err(RosMapError::Magic { start })
        }
    }
}

fn read_pnm(bytes: &[u8]) -> Result<DynamicImage, RosMapError> {
    let mut data = bytes;
    let decoder = PnmDecoder::new(&mut data).map_err(refuse)?;
    let (columns, rows) = decoder.dimensions();
    check_size((columns, rows))?;
    let pixels = u64::from(columns) * u64::from(rows);
    let needed = match decoder.subtype() {
        PnmSubtype::Bitmap(SampleEncoding::Binary) => {
            u64::from(columns.div_ceil(8)) * u64::from(rows)
        }
        PnmSubtype::Bitmap(SampleEncoding::Ascii) => pixels,
        // A digit a sample and a separator between two.
        PnmSubtype::Graymap(SampleEncoding::Ascii) => 2 * pixels - 1,
        PnmSubtype::Pixmap(SampleEncoding::Ascii) => 6 * pixels - 1,
        _ => decoder.total_bytes(),
    };
    // What is left of the slice is what the decoder has not read yet.
    let (reader, _) = decoder.into_inner();
    let found = reader.len() as u64;
    if found < needed {
        return Err(RosMapError::Truncated {
            columns,
            rows,
            needed,
            found,
        });
    }
    DynamicImage::from_decoder(PnmDecoder::new(Cursor::new(bytes)).map_err(refuse)?).map_err(refuse)
}

fn check_size((columns, rows): (u32, u32)) -> Result<(), RosMapError> {
    if columns == 0 || rows == 0 {
        return Err(RosMapError::Empty { columns, rows });
    }
    if u64::from(columns) * u64::from(rows) > MAX_CELLS as u64 {
        return Err(RosMapError::TooLarge {
            columns,
            rows,
            bound: MAX_CELLS,
        });
    }
    Ok(())
}

fn refuse(error: ImageError) -> RosMapError {
    RosMapError::Image {
        reason: error.to_string(),
    }
}

/// One pixel: mean of its color channels in 0..1, and whether it is opaque.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Pixel {
    pub shade: f64,
    pub is_opaque: bool,
}

/// The pixels row by row from the top.
pub(super) fn pixels(image: &DynamicImage) -> Result<Vec<Pixel>, RosMapError> {
    let channels = usize::from(image.color().channel_count());
    let has_alpha = image.color().has_alpha();
    let decode = |samples: &mut dyn Iterator<Item = u32>, full: u32| {
        let samples: Vec<u32> = samples.collect();
        (samples.chunks_exact(channels))
            .map(|pixel| {
                let (colors, alpha) = pixel.split_at(channels - usize::from(has_alpha));
                let sum: u32 = colors.iter().sum();
                let shade = f64::from(sum) / (colors.len() as f64 * f64::from(full));
                Pixel {
                    shade,
                    is_opaque: alpha.iter().all(|&a| a == full),
                }
            })
            .collect()
    };
    if let Some(samples) = eight_bit(image) {
        return Ok(decode(&mut samples.iter().map(|&s| u32::from(s)), 255));
    }
    if let Some(samples) = sixteen_bit(image) {
        return Ok(decode(&mut samples.iter().map(|&s| u32::from(s)), 65535));
    }
    Err(RosMapError::Image {
        reason: format!("samples of kind {:?} are not supported", image.color()),
    })
}

fn eight_bit(image: &DynamicImage) -> Option<&[u8]> {
    match image {
        DynamicImage::ImageLuma8(i) => Some(i.as_raw()),
        DynamicImage::ImageLumaA8(i) => Some(i.as_raw()),
        DynamicImage::ImageRgb8(i) => Some(i.as_raw()),
        DynamicImage::ImageRgba8(i) => Some(i.as_raw()),
        _ => None,
    }
}

fn sixteen_bit(image: &DynamicImage) -> Option<&[u16]> {
    match image {
        DynamicImage::ImageLuma16(i) => Some(i.as_raw()),
        DynamicImage::ImageLumaA16(i) => Some(i.as_raw()),
        DynamicImage::ImageRgb16(i) => Some(i.as_raw()),
        DynamicImage::ImageRgba16(i) => Some(i.as_raw()),
        _ => None,
    }
}
