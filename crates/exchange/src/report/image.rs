//! The picture of a part for a page: a PNG, JPEG or SVG file as it is, once it is known to be one and not too large.
//!
//! A page shows it as a picture, so an SVG file runs no script and opens no other file.

use fitcheck_core::text::Within as _;
use std::fmt;
use std::path::{Component, Path};
use std::sync::Arc;

use fitcheck_core::message::{Message, message};
use quick_xml::Reader;
use quick_xml::events::Event;

/// The largest PNG or JPEG file, KiB.
pub const MOST_KIB: usize = 16 << 10;

/// The largest SVG file, KiB: its shapes are counted in it, not in its dots.
pub const MOST_SVG_KIB: usize = 2 << 10;

/// The most dots of a picture: that of a good camera.
pub const MOST_DOTS: u64 = 40_000_000;

/// The bytes of a picture.
#[derive(Clone, PartialEq, Eq)]
pub struct Image {
    kind: ImageKind,
    /// Width and height in dots; `None` where it has shapes instead.
    dots: Option<(u32, u32)>,
    bytes: Arc<[u8]>,
}

impl fmt::Debug for Image {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Image({}, {} bytes)", self.kind.media(), self.bytes.len())
    }
}

/// What a file can be.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ImageKind {
    Png,
    Jpeg,
    /// SVG; packed ones are not read.
    Svg,
}

impl ImageKind {
    /// What a file seems to be by its first bytes.
    pub fn of(bytes: &[u8]) -> Option<Self> {
        if bytes.starts_with(PNG) {
            return Some(Self::Png);
        }
        if bytes.starts_with(b"\xff\xd8\xff") {
            return Some(Self::Jpeg);
        }
        let head = String::from_utf8_lossy(bytes.within(..bytes.len().min(4_096)));
        let is_svg = head.trim_start_matches('\u{feff}').trim_start().starts_with('<') && head.contains("<svg");
        is_svg.then_some(Self::Svg)
    }

    /// The largest file, KiB.
    pub const fn most_kib(self) -> usize {
        match self {
            Self::Png | Self::Jpeg => MOST_KIB,
            Self::Svg => MOST_SVG_KIB,
        }
    }

    const fn media(self) -> &'static str {
        match self {
            Self::Png => "image/png",
            Self::Jpeg => "image/jpeg",
            Self::Svg => "image/svg+xml",
        }
    }
}

/// What a PNG file begins with.
const PNG: &[u8] = b"\x89PNG\r\n\x1a\n";

impl Image {
    /// A picture of a file with this name.
    ///
    /// # Errors
    /// Why it is refused: another kind of file, too large, or cut off.
    pub fn read(name: &str, bytes: &[u8]) -> Result<Self, Message> {
        let kind = ImageKind::of(bytes).ok_or_else(|| message!("parts-page-picture-kind").text("name", name))?;
        if kind.most_kib() < bytes.len() >> 10 {
            return Err(too_large(name, bytes.len(), kind.most_kib()));
        }
        let dots = match kind {
            ImageKind::Png => Some(png(bytes).ok_or_else(|| broken(name, &"PNG"))?),
            ImageKind::Jpeg => Some(jpeg(bytes).ok_or_else(|| broken(name, &"JPEG"))?),
            ImageKind::Svg => {
                check_svg(name, bytes)?;
                None
            }
        };
        dots.map_or(Ok(()), |dots| check_dots(name, dots))?;
        Ok(Self { kind, dots, bytes: bytes.into() })
    }

    /// The picture as an address that a page can show.
    pub fn address(&self) -> String {
        format!("data:{};base64,{}", self.kind.media(), base64(&self.bytes))
    }

    /// How many bytes it has.
    pub fn size(&self) -> usize {
        self.bytes.len()
    }

    /// What kind of file it is.
    pub const fn kind(&self) -> ImageKind {
        self.kind
    }

    /// Its width and height in dots; `None` where it has shapes instead.
    pub const fn dots(&self) -> Option<(u32, u32)> {
        self.dots
    }

    /// The bytes of its file.
    pub const fn bytes(&self) -> &Arc<[u8]> {
        &self.bytes
    }
}

/// Why a file is too large, with its size in bytes and the largest one in KiB.
pub fn too_large(name: &str, bytes: usize, most_kib: usize) -> Message {
    message!("parts-page-picture-large").text("name", name).text("given", bytes >> 10).text("most", most_kib)
}

/// Why a file cannot be read as a picture; what a decoder says of it is shortened.
pub fn broken(name: &str, reason: &impl ToString) -> Message {
    let mut reason = reason.to_string();
    reason.truncate(reason.char_indices().nth(200).map_or(reason.len(), |(end, _)| end));
    message!("parts-page-picture-broken").text("name", name).text("reason", reason)
}

/// Refuses too many dots.
///
/// # Errors
/// How many there are, and how many are allowed.
pub fn check_dots(name: &str, (width, height): (u32, u32)) -> Result<(), Message> {
    if u64::from(width) * u64::from(height) <= MOST_DOTS {
        return Ok(());
    }
    let message = message!("parts-page-picture-dots").text("name", name).text("width", width);
    Err(message.text("height", height).text("most", MOST_DOTS / 1_000_000))
}

/// Whether a text is the name of a file without a folder.
pub fn is_plain_name(name: &str) -> bool {
    let mut parts = Path::new(name).components();
    matches!((parts.next(), parts.next()), (Some(Component::Normal(_)), None)) && !name.contains(['/', '\\', ':'])
}

/// A number of four bytes, the first one the largest.
fn wide(bytes: &[u8], at: usize) -> Option<u32> {
    bytes.get(at..)?.first_chunk().map(|four| u32::from_be_bytes(*four))
}

/// The same of two bytes.
fn short(bytes: &[u8], at: usize) -> Option<u16> {
    bytes.get(at..)?.first_chunk().map(|two| u16::from_be_bytes(*two))
}

/// Width and height of a PNG file (ISO/IEC 15948, 5.3 and 11.2.2) whose pieces are all there, up to the last one.
fn png(bytes: &[u8]) -> Option<(u32, u32)> {
    let mut at = PNG.len();
    let mut size = None;
    loop {
        let length = usize::try_from(wide(bytes, at)?).ok()?;
        match bytes.get(at + 4..at + 8)? {
            b"IHDR" => size = Some((wide(bytes, at + 8)?, wide(bytes, at + 12)?)),
            b"IEND" => return size.filter(|(width, height)| 0 < *width && 0 < *height),
            _ => {}
        }
        // Length, name, content and check sum.
        at = at.checked_add(length)?.checked_add(12)?;
    }
}

/// Width and height of a JPEG file (ITU-T T.81, B.1.1 and B.2.2): those of its frame.
fn jpeg(bytes: &[u8]) -> Option<(u32, u32)> {
    let mut at = 2;
    loop {
        let (0xff, marker) = (*bytes.get(at)?, *bytes.get(at + 1)?) else { return None };
        match marker {
            // Any number of these may stand before a marker.
            0xff => at += 1,
            // Frames; the others in this range are tables.
            0xc0..=0xcf if ![0xc4, 0xc8, 0xcc].contains(&marker) => {
                let height = short(bytes, at + 5)?;
                let width = short(bytes, at + 7)?;
                return (0 < width && 0 < height).then(|| (width.into(), height.into()));
            }
            // The picture itself, or its end, without a frame before it.
            0xd9 | 0xda => return None,
            _ => at = at.checked_add(2)?.checked_add(short(bytes, at + 2)?.into())?,
        }
    }
}

/// Refuses what is no SVG from its beginning to its end.
fn check_svg(name: &str, bytes: &[u8]) -> Result<(), Message> {
    let mut reader = Reader::from_reader(bytes);
    let mut deep = 0_usize;
    let mut has_root = false;
    loop {
        let event = reader.read_event().map_err(|error| broken(name, &error))?;
        match &event {
            Event::Start(element) | Event::Empty(element) => {
                let local = element.local_name();
                if deep == 0 && local.as_ref() != "svg" {
                    return Err(broken(name, &"SVG"));
                }
                has_root = true;
                deep += usize::from(matches!(event, Event::Start(_)));
            }
            Event::End(_) => deep = deep.saturating_sub(1),
            Event::Eof if deep == 0 && has_root => return Ok(()),
            Event::Eof => return Err(broken(name, &"SVG")),
            _ => {}
        }
    }
}

/// Bytes as text (RFC 4648, 4).
fn base64(bytes: &[u8]) -> String {
    const SIGNS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let mut text = String::with_capacity(bytes.len().div_ceil(3) * 4);
    for three in bytes.chunks(3) {
        // What is missing of the last three bytes is 0.
        let byte = |at: usize| three.get(at).map_or(0, |byte| u32::from(*byte));
        let all = byte(0) << 16 | byte(1) << 8 | byte(2);
        for (at, shift) in [18, 12, 6, 0].into_iter().enumerate() {
            let sign = usize::try_from(all >> shift & 63).ok().and_then(|at| SIGNS.get(at));
            let sign = sign.filter(|_| at <= three.len()).copied().unwrap_or(b'=');
            text.push(char::from(sign));
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bytes_become_the_text_of_the_standard() {
        // RFC 4648, 10.
        for (bytes, text) in [
            ("", ""),
            ("f", "Zg=="),
            ("fo", "Zm8="),
            ("foo", "Zm9v"),
            ("foob", "Zm9vYg=="),
            ("fooba", "Zm9vYmE="),
            ("foobar", "Zm9vYmFy"),
        ] {
            assert_eq!(base64(bytes.as_bytes()), text);
        }
        assert_eq!(base64(&[0xfb, 0xff, 0xbf]), "+/+/");
    }

    #[test]
    fn a_picture_is_beside_its_plan() {
        assert!(is_plain_name("flange.png"));
        for name in ["", "..", "a/b.png", "/b.png", "..\\b.png", "c:b.png"] {
            assert!(!is_plain_name(name), "{name}");
        }
    }

    #[track_caller]
    fn refused(bytes: &[u8]) -> String {
        Image::read("p", bytes).unwrap_err().to_string()
    }

    /// A PNG with a frame alone: no decoder looks at it here.
    fn png_of(width: u32, height: u32) -> Vec<u8> {
        let mut bytes = PNG.to_vec();
        bytes.extend([0, 0, 0, 13]);
        bytes.extend(b"IHDR");
        bytes.extend(width.to_be_bytes());
        bytes.extend(height.to_be_bytes());
        bytes.extend([8, 2, 0, 0, 0, 0, 0, 0, 0]);
        bytes.extend([0, 0, 0, 0]);
        bytes.extend(b"IEND");
        bytes.extend([0, 0, 0, 0]);
        bytes
    }

    #[test]
    fn what_is_no_picture_cut_off_or_too_large_is_refused_with_its_reason() {
        assert!(Image::read("p", &png_of(3, 2)).is_ok());
        assert_eq!(refused(b"callout;measured"), "p is not a PNG, JPEG or SVG picture");
        let whole = png_of(3, 2);
        assert_eq!(refused(&whole[..whole.len() - 9]), "p cannot be read as a picture: PNG");
        assert_eq!(refused(&png_of(8_000, 5_001)), "p has 8000 × 5001 pixels; a picture has at most 40 million pixels");
        assert_eq!(refused(&png_of(0, 5)), "p cannot be read as a picture: PNG");
        assert_eq!(refused(b"\xff\xd8\xff\xe0\x00\x04ab\xff\xd9"), "p cannot be read as a picture: JPEG");
        let frame = b"\xff\xd8\xff\xe0\x00\x04ab\xff\xff\xc2\x00\x11\x08\x00\x02\x00\x03\x01";
        assert!(Image::read("p", frame).is_ok());
        let svg = |inner: &str| format!("<svg xmlns=\"http://www.w3.org/2000/svg\">{inner}</svg>");
        assert!(Image::read("p", svg("<g><path d=\"M0 0\"/></g>").as_bytes()).is_ok());
        assert!(refused(b"<svg><g></svg>").starts_with("p cannot be read as a picture"));
        assert!(refused(b"<svg><g>").starts_with("p cannot be read as a picture"));
        assert!(refused(b"<html><svg/></html>").starts_with("p cannot be read as a picture"));
        let large = svg(&" ".repeat((MOST_SVG_KIB << 10) + 1_024));
        assert_eq!(refused(large.as_bytes()), "p has 2049 KiB; a picture has at most 2048 KiB");
    }
}
