//! Pictures of parts become dots: PNG, JPEG and SVG, each within bounds, on a thread of its own.
//!
//! A picture comes with a plan from anybody: how large it is is known before its dots are made, and an SVG picture opens no file.

mod svg;

use std::io::Cursor;
use std::path::Path;
use std::thread::Builder;

use image::{DynamicImage, ImageDecoder as _, ImageFormat, ImageReader, Limits};

use crate::files;
use crate::message::{Message, Say as _};
use crate::session::parts::PartPicture;

/// The largest file, KiB.
const MOST_KIB: usize = 16 << 10;

/// The most dots of a picture: that of a good camera.
const MOST_DOTS: u64 = 40_000_000;

/// The longest side that is shown, in dots: graphics cards take no larger pictures, and nobody sees more.
const LONGEST: u32 = 2_048;

/// The largest SVG file, KiB: its shapes are counted in it, not in its dots.
const MOST_SVG_KIB: usize = 2 << 10;

/// The stack of the thread that reads pictures, bytes: shapes within shapes need it.
const STACK: usize = 64 << 20;

/// Reads a picture.
///
/// # Errors
/// Why it is refused.
pub(super) fn read(path: &Path) -> Result<PartPicture, Message> {
    let name = path.file_name().unwrap_or(path.as_os_str()).to_string_lossy();
    let bytes = files::read_file(path).map_err(|error| error.message())?;
    // Decoders are by others: what goes wrong there ends with their thread, and not with the window.
    std::thread::scope(|scope| {
        let thread = Builder::new().name("picture".to_owned()).stack_size(STACK);
        let thread = thread.spawn_scoped(scope, || decode(&name, &bytes)).map_err(|error| broken(&name, &error))?;
        thread.join().unwrap_or_else(|_panic| Err(broken(&name, &"?")))
    })
}

fn decode(name: &str, bytes: &[u8]) -> Result<PartPicture, Message> {
    let is_large = |most: usize| most < bytes.len() >> 10;
    let large = |most| {
        let message = Message::new("parts-page-picture-large").text("name", name);
        Err(message.text("given", bytes.len() >> 10).text("most", most))
    };
    match image::guess_format(bytes).ok() {
        Some(ImageFormat::Png | ImageFormat::Jpeg) if is_large(MOST_KIB) => large(MOST_KIB),
        Some(format @ (ImageFormat::Png | ImageFormat::Jpeg)) => dots(name, bytes, format),
        _ if !is_svg(bytes) => Err(Message::new("parts-page-picture-kind").text("name", name)),
        _ if is_large(MOST_SVG_KIB) => large(MOST_SVG_KIB),
        _ => svg::shapes(name, bytes),
    }
}

fn broken(name: &str, reason: &impl ToString) -> Message {
    let mut reason = reason.to_string();
    reason.truncate(reason.char_indices().nth(200).map_or(reason.len(), |(end, _)| end));
    Message::new("parts-page-picture-broken").text("name", name).text("reason", reason)
}

/// Whether so many dots are too many.
fn check_size(name: &str, width: u32, height: u32) -> Result<(), Message> {
    if u64::from(width) * u64::from(height) <= MOST_DOTS {
        return Ok(());
    }
    let message = Message::new("parts-page-picture-dots").text("name", name).text("width", width);
    Err(message.text("height", height).text("most", MOST_DOTS / 1_000_000))
}

/// PNG and JPEG: the size is read first, then as many dots as are shown.
fn dots(name: &str, bytes: &[u8], format: ImageFormat) -> Result<PartPicture, Message> {
    let reader = || ImageReader::with_format(Cursor::new(bytes), format);
    let (width, height) = reader().into_dimensions().map_err(|error| broken(name, &error))?;
    check_size(name, width, height)?;
    let mut limits = Limits::no_limits();
    // Eight bytes a dot, for a picture with 16 bits a colour, and some more for what the decoder needs.
    limits.max_alloc = Some(MOST_DOTS * 10);
    let mut reader = reader();
    reader.limits(limits);
    let mut decoder = reader.into_decoder().map_err(|error| broken(name, &error))?;
    // A camera that was held upright says so beside the dots.
    let turned = decoder.orientation().ok();
    let mut picture = DynamicImage::from_decoder(decoder).map_err(|error| broken(name, &error))?;
    if let Some(turned) = turned {
        picture.apply_orientation(turned);
    }
    let picture = if LONGEST < width.max(height) { picture.thumbnail(LONGEST, LONGEST) } else { picture };
    let picture = picture.into_rgba8();
    let size = [picture.width(), picture.height()].map(|side| usize::try_from(side).unwrap_or_default());
    Ok(PartPicture { size, dots: picture.into_raw() })
}

/// Whether a text begins as an SVG picture does; packed ones are not read.
fn is_svg(bytes: &[u8]) -> bool {
    let head = String::from_utf8_lossy(bytes.get(..4_096.min(bytes.len())).unwrap_or_default());
    head.trim_start_matches('\u{feff}').trim_start().starts_with('<') && head.contains("<svg")
}
