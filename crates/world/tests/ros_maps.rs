//! ROS maps against an independent decoder, byte by byte, written from the specification of map_server.

#![allow(
    clippy::disallowed_methods,
    reason = "tests compare with the standard library"
)]

use pairtrawl_world::ros_map::{DecodedMap, MapMetadata, Mode, RosMapError, Unknown, decode};
use proptest::prelude::*;

fn metadata(free: f64, occupied: f64, negate: bool, mode: Mode) -> MapMetadata {
    let mode = match mode {
        Mode::Trinary => "trinary",
        Mode::Scale => "scale",
        Mode::Raw => "raw",
    };
    let yaml = format!(
        "image: map.pgm\nresolution: 0.05\norigin: [-1.0, 2.0, 0.5]\noccupied_thresh: {occupied}\nfree_thresh: {free}\nnegate: {negate}\nmode: {mode}\n"
    );
    MapMetadata::parse(yaml.as_bytes()).unwrap()
}

/// What a sample (of `full`) of a gray image means, in map_server's own words; `None` unknown.
fn expected(sample: u32, full: u32, m: &MapMetadata) -> Option<u8> {
    // Samples of an odd maxval are first brought to the nearest of 255 or 65535, as image libraries do.
    let unit = if full < 256 { 255.0 } else { 65535.0 };
    let shade = (f64::from(sample) * unit / f64::from(full)).round() / unit;
    let occ = if m.negate { shade } else { 1.0 - shade };
    match m.mode {
        Mode::Raw => {
            let byte = (shade * 255.0).round();
            if byte <= 100.0 {
                Some(byte as u8)
            } else {
                None
            }
        }
        _ if occ > m.occupied_thresh => Some(100),
        _ if occ < m.free_thresh => Some(0),
        Mode::Trinary => None,
        Mode::Scale => Some(
            ((occ - m.free_thresh) / (m.occupied_thresh - m.free_thresh) * 100.0).round_ties_even()
                as u8,
        ),
    }
}

/// A PGM with comments where they may stand.
fn pgm(columns: usize, rows: usize, full: u32, samples: &[u32], ascii: bool) -> Vec<u8> {
    let magic = if ascii { "P2" } else { "P5" };
    let mut bytes =
        format!("{magic}\n# a comment 9 9\n{columns} # width\n{rows}\n{full}\n").into_bytes();
    for &s in samples {
        match (ascii, full < 256) {
            (true, _) => bytes.extend(format!("{s}\n").bytes()),
            (false, true) => bytes.push(s as u8),
            (false, false) => bytes.extend((s as u16).to_be_bytes()),
        }
    }
    bytes
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    #[test]
    fn gray_maps_agree_with_the_specification(
        columns in 1_usize..9, rows in 1_usize..9, full in prop::sample::select(vec![1_u32, 7, 100, 205, 255, 256, 999, 65535]),
        ascii in any::<bool>(), negate in any::<bool>(), mode in prop::sample::select(vec![Mode::Trinary, Mode::Scale, Mode::Raw]),
        thresholds in prop::sample::select(vec![(0.196, 0.65), (0.25, 0.65), (0.0, 1.0), (0.3, 0.4)]), noise in prop::collection::vec(0.0..=1.0_f64, 64),
    ) {
        let samples: Vec<u32> = noise[..columns * rows].iter().map(|x| (x * f64::from(full)).round() as u32).collect();
        let m = metadata(thresholds.0, thresholds.1, negate, mode);
        let DecodedMap { values, map, .. } = decode(&m, &pgm(columns, rows, full, &samples, ascii), Unknown::Occupied).unwrap();
        let free = decode(&m, &pgm(columns, rows, full, &samples, ascii), Unknown::Free).unwrap().map;
        prop_assert_eq!((map.columns, map.rows, map.resolution), (columns, rows, 0.05));
        for row in 0..rows {
            for column in 0..columns {
                // The first line of the image is the highest row of the map.
                let value = expected(samples[(rows - 1 - row) * columns + column], full, &m);
                prop_assert_eq!(values[row * columns + column], value);
                if mode != Mode::Raw {
                    prop_assert_eq!(map.blocked[row * columns + column], value != Some(0));
                    prop_assert_eq!(free.blocked[row * columns + column], value == Some(100));
                }
            }
        }
    }

    #[test]
    fn random_bytes_never_panic(yaml in prop::collection::vec(any::<u8>(), 0..80), image in prop::collection::vec(any::<u8>(), 0..80), start in 0_usize..9) {
        let _ = MapMetadata::parse(&yaml);
        let magic: [&[u8]; 9] = [b"", b"P1\n", b"P2\n", b"P3 ", b"P4\n", b"P5\n3 3\n255\n", b"P6 2 2 9\n", b"P7\n", b"\x89PNG\r\n\x1a\n"];
        let _ = decode(&metadata(0.2, 0.6, false, Mode::Trinary), &[magic[start], &image].concat(), Unknown::Free);
    }
}

fn png(color: image::ColorType, columns: u32, rows: u32, bytes: &[u8]) -> Vec<u8> {
    use image::ImageEncoder;
    let mut file = Vec::new();
    image::codecs::png::PngEncoder::new(&mut file)
        .write_image(bytes, columns, rows, color.into())
        .unwrap();
    file
}

#[test]
fn colors_are_averaged_and_transparency_is_unknown_in_scale_mode() {
    // Two rows of two: opaque black, transparent black; opaque blue-ish gray, opaque white.
    let rgba = [
        0, 0, 0, 255, 0, 0, 0, 254, 10, 20, 225, 255, 255, 255, 255, 255,
    ];
    let file = png(image::ColorType::Rgba8, 2, 2, &rgba);
    let scale = decode(
        &metadata(0.1, 0.9, false, Mode::Scale),
        &file,
        Unknown::Occupied,
    )
    .unwrap();
    // Mean of (10, 20, 225) is 85: occ 2/3, (2/3 - 0.1) / 0.8 = 0.708.
    assert_eq!(scale.values, [Some(71), Some(0), Some(100), None]);
    let trinary = decode(
        &metadata(0.1, 0.9, false, Mode::Trinary),
        &file,
        Unknown::Occupied,
    )
    .unwrap();
    assert_eq!(trinary.values, [None, Some(0), Some(100), Some(100)]);

    let rgb16: Vec<u8> = [0_u16, 0, 65535]
        .iter()
        .flat_map(|s| s.to_ne_bytes())
        .collect();
    let deep = decode(
        &metadata(0.1, 0.9, false, Mode::Scale),
        &png(image::ColorType::Rgb16, 1, 1, &rgb16),
        Unknown::Occupied,
    )
    .unwrap();
    assert_eq!(deep.values, [Some(71)]);
}

#[test]
fn raw_mode_judges_the_value_by_the_thresholds() {
    let m = metadata(0.196, 0.65, true, Mode::Raw);
    let DecodedMap { values, map, .. } = decode(
        &m,
        &pgm(5, 1, 255, &[0, 19, 50, 66, 101], false),
        Unknown::Occupied,
    )
    .unwrap();
    assert_eq!(values, [Some(0), Some(19), Some(50), Some(66), None]);
    assert_eq!(map.blocked, [false, false, true, true, true]);
    let free = decode(
        &m,
        &pgm(5, 1, 255, &[0, 19, 50, 66, 101], false),
        Unknown::Free,
    )
    .unwrap()
    .map;
    assert_eq!(free.blocked, [false, false, false, true, false]);
}

#[test]
fn origin_and_yaw_place_the_cells() {
    let map = decode(
        &metadata(0.196, 0.65, false, Mode::Trinary),
        &pgm(3, 2, 255, &[0; 6], false),
        Unknown::Occupied,
    )
    .unwrap()
    .map;
    let corner = map.from_cells(pairtrawl_geometry::Point::new(3.0, 0.0));
    assert!(
        (corner.x - (-1.0 + 0.15 * 0.5_f64.cos())).abs() < 1e-12
            && (corner.y - (2.0 + 0.15 * 0.5_f64.sin())).abs() < 1e-12
    );
}

#[test]
fn thresholds_are_strict_and_a_free_threshold_over_the_unknown_gray_warns() {
    // Shade 51/255 is 0.2 exactly in the arithmetic used: occ 0.8.
    let at = |free: f64, occupied: f64| {
        decode(
            &metadata(free, occupied, false, Mode::Trinary),
            &pgm(1, 1, 255, &[51], false),
            Unknown::Occupied,
        )
        .unwrap()
        .values[0]
    };
    assert_eq!(
        (at(0.1, 0.8), at(0.8, 0.9), at(0.1, 0.79), at(0.81, 0.9)),
        (None, None, Some(100), Some(0))
    );

    let warnings = |free, samples: &[u32], negate| {
        decode(
            &metadata(free, 0.65, negate, Mode::Trinary),
            &pgm(2, 1, 255, samples, false),
            Unknown::Occupied,
        )
        .unwrap()
        .warnings
    };
    assert_eq!(warnings(0.25, &[205, 254], false).len(), 1);
    assert!(
        warnings(0.25, &[205, 205], false)[0]
            .to_string()
            .contains("2 cells")
    );
    assert!(warnings(0.196, &[205, 254], false).is_empty());
    assert!(warnings(0.25, &[204, 254], false).is_empty());
    assert!(warnings(0.25, &[205, 254], true).is_empty());
}

#[test]
fn yaml_forms() {
    let yaml = |negate: &str| {
        format!(
            "image: a.png\nresolution: 1\norigin: [0, 0, 0]\nnegate: {negate}\noccupied_thresh: 1\nfree_thresh: 0\nsomething_else: 3\n"
        )
    };
    for (text, negate) in [
        ("0", false),
        ("1", true),
        ("false", false),
        ("true", true),
        ("True", true),
    ] {
        let m = MapMetadata::parse(yaml(text).as_bytes()).unwrap_or_else(|e| panic!("{text}: {e}"));
        assert_eq!(
            (m.negate, m.mode, m.image.as_str()),
            (negate, Mode::Trinary, "a.png")
        );
    }
    assert!(matches!(
        MapMetadata::parse(yaml("maybe").as_bytes()),
        Err(RosMapError::Yaml { .. })
    ));
    assert!(matches!(
        MapMetadata::parse(b"\xff"),
        Err(RosMapError::Yaml { .. })
    ));
    assert!(matches!(
        MapMetadata::parse(b""),
        Err(RosMapError::Yaml { .. })
    ));
    assert!(matches!(
        MapMetadata::parse("[".repeat(100_000).as_bytes()),
        Err(RosMapError::Yaml { .. })
    ));
}

#[test]
fn damaged_images() {
    let m = metadata(0.196, 0.65, false, Mode::Trinary);
    let refuse = |bytes: &[u8]| decode(&m, bytes, Unknown::Occupied).unwrap_err();
    assert!(matches!(
        refuse(b"P5\n65536 65536\n255\n"),
        RosMapError::TooLarge {
            columns: 65536,
            rows: 65536,
            ..
        }
    ));
    assert!(matches!(refuse(b"P5 0 4 255\n"), RosMapError::Empty { .. }));
    assert!(matches!(
        refuse(b"P2 4000 4000 255\n0 0 0"),
        RosMapError::Truncated {
            needed: 31_999_999,
            ..
        }
    ));
    assert!(matches!(
        refuse(b"P4 4000 4000\n0"),
        RosMapError::Truncated {
            needed: 2_000_000,
            found: 1,
            ..
        }
    ));
    for bytes in [
        b"P39151".as_slice(),
        b"P39151 4\n255\n",
        b"P8\n1 1\n255\n1",
        b"P",
        b"",
        b"BM",
    ] {
        assert!(matches!(refuse(bytes), RosMapError::Magic { .. }));
    }
    for bytes in [
        b"P5\n4 -4\n255\n".as_slice(),
        b"P5\n4 4\n0\n0123456789abcdef",
        b"P5\n1 1\n99999\n0",
        b"P5\n99999999999 1\n255\n",
    ] {
        assert!(
            matches!(refuse(bytes), RosMapError::Image { .. }),
            "{:?}",
            refuse(bytes)
        );
    }
    let whole = png(image::ColorType::L8, 40, 40, &[7; 1600]);
    assert!(decode(&m, &whole, Unknown::Occupied).is_ok());
    for cut in [10, 30, 45, whole.len() / 2] {
        assert!(
            matches!(refuse(&whole[..cut]), RosMapError::Image { .. }),
            "cut at {cut}"
        );
    }
    // A PNG header that declares 65536 x 65536.
    let mut huge = whole.clone();
    huge[16..24].copy_from_slice(&[0, 1, 0, 0, 0, 1, 0, 0]);
    let crc = crc32(&huge[12..29]);
    huge[29..33].copy_from_slice(&crc.to_be_bytes());
    assert!(matches!(
        refuse(&huge),
        RosMapError::TooLarge { columns: 65536, .. } | RosMapError::Image { .. }
    ));
}

fn crc32(bytes: &[u8]) -> u32 {
    !bytes.iter().fold(!0_u32, |crc, &b| {
        (0..8).fold(crc ^ u32::from(b), |c, _| {
            if c & 1 == 1 {
                (c >> 1) ^ 0xEDB8_8320
            } else {
                c >> 1
            }
        })
    })
}
