//! Pictures of parts become dots: PNG, JPEG and SVG, each within bounds, on a thread of its own.
//!
//! A picture comes with a plan from anybody: how large it is is known before its dots are made, and an SVG picture opens no file.

mod svg;

use std::io::Cursor;
use std::path::Path;
use std::thread::Builder;

use image::{DynamicImage, ImageDecoder as _, ImageFormat, ImageReader, Limits};

use super::file_contents::file_or_sample;
use crate::message::Message;
use crate::report::image::{Image, ImageKind, MOST_DOTS, broken, check_dots};
use crate::report::pdf::PictureDots;
use crate::session::parts::PartPicture;

/// The longest side that is shown, in dots: graphics cards take no larger pictures, and nobody sees more.
const LONGEST: u32 = 2_048;

/// The stack of the thread that reads pictures, bytes: shapes within shapes need it.
const STACK: usize = 64 << 20;

/// Reads a picture.
///
/// # Errors
/// Why it is refused.
pub(super) fn read(path: &Path) -> Result<PartPicture, Message> {
    let name = path.file_name().unwrap_or(path.as_os_str()).to_string_lossy();
    let bytes = file_or_sample(path)?;
    apart(&name, || decode(&name, &bytes))
}

/// The dots of a picture that was read.
///
/// # Errors
/// It cannot be decoded.
pub(super) fn dots_of(name: &str, image: &Image) -> Result<PictureDots, Message> {
    let PartPicture { size, dots, .. } = apart(name, || decode(name, image.bytes()))?;
    Ok(PictureDots { name: name.to_owned(), size, bytes: dots })
}

/// Decoders are by others: what goes wrong there ends with their thread, and not with the window.
fn apart(name: &str, decode: impl FnOnce() -> Result<PartPicture, Message> + Send) -> Result<PartPicture, Message> {
    std::thread::scope(|scope| {
        let thread = Builder::new().name("picture".to_owned()).stack_size(STACK);
        let thread = thread.spawn_scoped(scope, decode).map_err(|error| broken(name, &error))?;
        thread.join().unwrap_or_else(|_panic| Err(broken(name, &"?")))
    })
}

fn decode(name: &str, bytes: &[u8]) -> Result<PartPicture, Message> {
    let file = Image::read(name, bytes)?;
    let (size, dots) = match ImageKind::of(bytes) {
        Some(ImageKind::Png) => dots(name, bytes, ImageFormat::Png)?,
        Some(ImageKind::Jpeg) => dots(name, bytes, ImageFormat::Jpeg)?,
        Some(ImageKind::Svg) | None => svg::shapes(name, bytes)?,
    };
    Ok(PartPicture { size, dots, file })
}

/// Width and height, and the colours of all dots.
type Dots = ([usize; 2], Vec<u8>);

/// PNG and JPEG: the size is read first, then as many dots as are shown.
fn dots(name: &str, bytes: &[u8], format: ImageFormat) -> Result<Dots, Message> {
    let reader = || ImageReader::with_format(Cursor::new(bytes), format);
    let (width, height) = reader().into_dimensions().map_err(|error| broken(name, &error))?;
    check_dots(name, (width, height))?;
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
    let side = |dots: u32| usize::try_from(dots).map_err(|error| broken(name, &error));
    let size = [side(picture.width())?, side(picture.height())?];
    Ok((size, picture.into_raw()))
}
