//! The icon of the program: one drawing, and its pictures in every size that a system asks for.
//!
//! `UPDATE_SNAPSHOTS=1 cargo test --features gui-tests --test gui icons` draws them anew.
#![expect(clippy::disallowed_methods, reason = "the pictures are made anew from the drawing")]

use std::path::{Path, PathBuf};

use fitcheck::report::shapes;
use image::RgbaImage;

const SIZES: [u32; 7] = [16, 32, 48, 64, 128, 256, 512];

fn icons() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("assets/icons")
}

fn drawn(size: u32) -> RgbaImage {
    let drawing = std::fs::read(icons().join("fitcheck.svg")).unwrap();
    let tree = shapes::tree("fitcheck.svg", &drawing).unwrap();
    RgbaImage::from_raw(size, size, shapes::dots("fitcheck.svg", &tree, [size, size]).unwrap()).unwrap()
}

fn is_made_anew() -> bool {
    std::env::var_os("UPDATE_SNAPSHOTS").is_some()
}

#[test]
fn every_size_is_the_drawing() {
    for size in SIZES {
        let path = icons().join(format!("{size}.png"));
        if is_made_anew() {
            drawn(size).save(&path).unwrap();
        }
        assert_eq!(image::open(&path).unwrap().into_rgba8(), drawn(size), "{}", path.display());
    }
}

/// The file of icons that a program for Windows carries: a head, a line of sixteen bytes for each picture, the pictures as PNG.
#[test]
fn the_icon_for_windows_has_the_same_pictures() {
    let pictures: Vec<(u8, Vec<u8>)> = SIZES
        .into_iter()
        .filter(|size| *size <= 256)
        // A side of 256 is written as zero.
        .map(|size| (u8::try_from(size % 256).unwrap(), std::fs::read(icons().join(format!("{size}.png"))).unwrap()))
        .collect();
    let count = u16::try_from(pictures.len()).unwrap();
    let mut bytes = [&[0, 0, 1, 0], &count.to_le_bytes()[..]].concat();
    let mut place = 6 + 16 * u32::from(count);
    for (side, picture) in &pictures {
        let length = u32::try_from(picture.len()).unwrap();
        bytes.extend([*side, *side, 0, 0, 1, 0, 32, 0]);
        bytes.extend(length.to_le_bytes());
        bytes.extend(place.to_le_bytes());
        place += length;
    }
    bytes.extend(pictures.into_iter().flat_map(|(_, picture)| picture));
    let path = icons().join("fitcheck.ico");
    if is_made_anew() {
        std::fs::write(&path, &bytes).unwrap();
    }
    assert!(std::fs::read(&path).unwrap() == bytes, "{}", path.display());
}
