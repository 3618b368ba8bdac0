//! A label as a picture for printers that take no PDF: PNG, 300 dots an inch, black and white with the greys of smooth edges.
//!
//! Drawings in SVG, such as charts, become pictures here, too.
//!
//! It is drawn from the same plain values as the label of the PDF. It has no data attached: the code on the label leads back to its record. The
//! same report always gives the same bytes.

use std::io::{self, Write};

use fitcheck_core::message::Message;
use fitcheck_core::words::Words;
use png::{BitDepth, ColorType, Encoder, PixelDimensions, Unit};

use super::pdf::{Pages, raster};
use super::{Holds, RenderError, Rendering, Report, shapes};

pub const RENDERING: Rendering =
    Rendering { name: "png", title: "PNG", is_for_people: true, holds: Holds::Label, endings: &["png"], render };

/// Dots an inch.
const FINENESS: u32 = 300;

/// The same, a metre.
const FINENESS_PER_METRE: u32 = 11_811;

/// How much is written at once.
const PIECE: usize = 16 << 10;

fn render(report: &Report, words: &Words, out: &mut dyn Write) -> io::Result<()> {
    let refused = || io::Error::other(RenderError::LabelAlone { format: RENDERING.title }.to_string());
    let size = report.paper.label_mm().ok_or_else(refused)?.map(dots);
    let grey = raster(&Pages::of(report, words)?, size)?;
    let bytes = encoded(size, ColorType::Grayscale, &grey)?;
    bytes.chunks(PIECE).try_for_each(|piece| out.write_all(piece))
}

/// A drawing in SVG as a picture with this many dots for each of its units.
///
/// # Errors
/// A drawing that is refused, as [`shapes::tree`] says.
pub fn of_svg(name: &str, svg: &str, fineness: u16) -> io::Result<Vec<u8>> {
    let refused = |why: Message| io::Error::other(why.to_string());
    let tree = shapes::tree(name, svg.as_bytes()).map_err(refused)?;
    let size = tree.size().to_int_size();
    let size = [size.width(), size.height()].map(|side| side.saturating_mul(fineness.into()));
    let dots = shapes::dots(name, &tree, size).map_err(refused)?;
    encoded(size, ColorType::Rgba, &dots)
}

fn encoded([width, height]: [u32; 2], colour: ColorType, dots: &[u8]) -> io::Result<Vec<u8>> {
    let mut bytes = Vec::new();
    let mut encoder = Encoder::new(&mut bytes, width, height);
    encoder.set_color(colour);
    encoder.set_depth(BitDepth::Eight);
    let (xppu, yppu) = (FINENESS_PER_METRE, FINENESS_PER_METRE);
    encoder.set_pixel_dims(Some(PixelDimensions { xppu, yppu, unit: Unit::Meter }));
    encoder.write_header().and_then(|mut writer| writer.write_image_data(dots)).map_err(io::Error::other)?;
    Ok(bytes)
}

/// Dots of so many millimetres, to the nearest one.
const fn dots(mm: u32) -> u32 {
    (mm * FINENESS * 10 + 127) / 254
}
