//! The pages as a window shows them before they are written: the same plain values that become the file, handed to a canvas.

use std::io;

use fitcheck_core::words::Words;

use super::bands::{BandShape, Mark};
use super::brush::{Hatch, hatched};
use super::look::{Ink, PAPER, TEXT, ZONE, ZONE_EDGE};
use super::sheet::{Area, Edge, Piece, Place, Shape, Sheet};
use super::signs::Outline;
use crate::report::Report;
use crate::report::image::Image;

/// What pages are drawn on. Places and sizes are in points from the left and upper edge of the page, colours red, green, blue.
pub trait Canvas {
    /// A text from a place of its base line on.
    fn text(&mut self, at: [f32; 2], size: f32, is_bold: bool, ink: [u8; 3], text: &str);

    /// An icon of the window's font, in the middle of its place.
    fn icon(&mut self, middle: [f32; 2], size: f32, ink: [u8; 3], icon: char);

    /// A rectangle: left, top, width, height; its corners are round.
    fn block(&mut self, area: [f32; 4], radius: f32, fill: Option<[u8; 3]>, edge: Option<CanvasEdge>);

    /// A shape with straight sides.
    fn polygon(&mut self, corners: &[[f32; 2]], fill: Option<[u8; 3]>, edge: Option<CanvasEdge>);

    /// Straight lines, as far as they are within an area.
    fn lines(&mut self, lines: &[[[f32; 2]; 2]], within: [f32; 4], edge: CanvasEdge);

    /// A picture by its number.
    fn picture(&mut self, area: [f32; 4], number: usize);
}

/// A line on a canvas.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CanvasEdge {
    pub ink: [u8; 3],
    pub width: f32,
    pub is_dashed: bool,
}

impl From<Edge> for CanvasEdge {
    fn from(Edge { ink, width, is_dashed }: Edge) -> Self {
        Self { ink, width, is_dashed }
    }
}

/// A picture as dots.
#[derive(Debug, Clone)]
pub struct PictureDots {
    pub name: String,
    /// Width and height.
    pub size: [usize; 2],
    /// Red, green, blue and how opaque, a byte each, row by row.
    pub bytes: Vec<u8>,
}

/// The pages of a report.
#[derive(Debug)]
pub struct Pages {
    size: [f32; 2],
    sheets: Vec<Sheet>,
    /// The pictures on them, by their numbers.
    pub pictures: Vec<(String, Image)>,
    /// The same as dots, once somebody has decoded them.
    pub dots: Vec<Option<PictureDots>>,
}

impl Pages {
    /// Sets the pages of a report.
    ///
    /// # Errors
    /// The checks cannot be read.
    pub fn of(report: &Report, words: &Words) -> io::Result<Self> {
        super::pages(report, words)
    }

    pub(super) const fn new(size: [f32; 2], sheets: Vec<Sheet>, pictures: Vec<(String, Image)>) -> Self {
        Self { size, sheets, pictures, dots: Vec::new() }
    }

    pub const fn count(&self) -> usize {
        self.sheets.len()
    }

    /// Width and height in points, 72 of which are an inch.
    pub const fn size(&self) -> [f32; 2] {
        self.size
    }

    /// The text of a page in its order, for those who hear it: what stands on every page is left out.
    pub fn text(&self, page: usize) -> String {
        let Some(sheet) = self.sheets.get(page) else { return String::new() };
        let mut text = String::new();
        for (at, shape) in sheet.shapes.iter().enumerate() {
            let Shape::Text(_, _, said) = shape else { continue };
            let piece = sheet.pieces.iter().rev().find(|(from, _)| *from <= at);
            if piece.is_some_and(|(_, piece)| matches!(piece, Piece::Of(_))) {
                if !text.is_empty() && !text.ends_with(' ') {
                    text.push(' ');
                }
                text.push_str(said);
            }
        }
        text
    }

    /// Draws a page.
    pub fn draw(&self, page: usize, canvas: &mut dyn Canvas) {
        for shape in self.sheets.get(page).iter().flat_map(|sheet| &sheet.shapes) {
            draw(shape, canvas);
        }
    }
}

fn draw(shape: &Shape, canvas: &mut dyn Canvas) {
    match shape {
        Shape::Text(at, style, text) => {
            canvas.text(*at, style.size, style.weight == super::fonts::Weight::Semibold, style.ink, text);
        }
        Shape::Block { area, radius, fill, edge } => canvas.block(sides(*area), *radius, *fill, edge.map(Into::into)),
        Shape::Line { from, to, width, ink } => {
            let edge = CanvasEdge { ink: *ink, width: *width, is_dashed: false };
            canvas.lines(&[[*from, *to]], [f32::MIN / 2.0, f32::MIN / 2.0, f32::MAX, f32::MAX], edge);
        }
        Shape::Sign { sign, middle, size, ink } => canvas.icon(*middle, *size, *ink, sign.icon()),
        Shape::Outline { outline, middle, radius, fill, edge } => {
            outlined(canvas, (*outline, *middle, *radius), *fill, (*edge).into());
        }
        Shape::Band(area, shape) => band(canvas, *area, shape),
        Shape::Picture(area, number) => canvas.picture(sides(*area), *number),
    }
}

const fn sides(area: Area) -> [f32; 4] {
    [area.x, area.y, area.width, area.height]
}

fn outlined(canvas: &mut dyn Canvas, (outline, [x, y], radius): (Outline, Place, f32), fill: Ink, edge: CanvasEdge) {
    let square = |half: f32, round: f32, canvas: &mut dyn Canvas| {
        canvas.block([x - half, y - half, 2.0 * half, 2.0 * half], round, Some(fill), Some(edge));
    };
    match outline {
        Outline::Circle => square(radius, radius, canvas),
        Outline::Square => square(radius * 0.94, radius * 0.25, canvas),
        Outline::Diamond | Outline::Hexagon | Outline::Triangle => {
            let corners: Vec<_> = outline.corners().iter().map(|[dx, dy]| [x + dx * radius, y + dy * radius]).collect();
            canvas.polygon(&corners, Some(fill), Some(edge));
        }
    }
}

fn band(canvas: &mut dyn Canvas, area: Area, band: &BandShape) {
    let at = |share: f32| area.x + area.width * share;
    let hatch = |canvas: &mut dyn Canvas, [from, to]: [f32; 2], hatch: Hatch| {
        let part = Area::new(from, area.y + 0.8, to - from, area.height - 1.6);
        if 0.6 < part.width {
            let (lines, ink) = hatched(hatch, area);
            canvas.lines(&lines, sides(part), CanvasEdge { ink, width: 0.5, is_dashed: false });
        }
    };
    for (side, span) in band.sides {
        hatch(canvas, span.map(at), side.into());
    }
    let [from, to] = band.zone.map(at);
    let tall = |x: f32, width: f32, more: f32| [x - width / 2.0, area.y - more, width, area.height + 2.0 * more];
    canvas.block([from, area.y + 0.8, to - from, area.height - 1.6], 0.0, Some(ZONE), None);
    for (span, guarded) in &band.guards {
        hatch(canvas, span.map(at), (*guarded).into());
    }
    canvas.block(tall(from, 1.0, 0.6), 0.0, Some(ZONE_EDGE), None);
    canvas.block(tall(to, 1.0, 0.6), 0.0, Some(ZONE_EDGE), None);
    let [_, middle] = area.middle();
    match band.mark {
        Mark::At(share) => {
            canvas.block(tall(at(share), 4.0, 0.6), 0.0, Some(PAPER), None);
            canvas.block(tall(at(share), 2.2, 1.2), 0.0, Some(TEXT), None);
        }
        Mark::Left => arrow(canvas, [area.x, middle], -1.0),
        Mark::Right => arrow(canvas, [area.right(), middle], 1.0),
    }
}

/// That a value lies farther out than the band shows.
fn arrow(canvas: &mut dyn Canvas, [x, y]: Place, direction: f32) {
    let corners = [[x, y], [x - 7.0 * direction, y - 5.0], [x - 7.0 * direction, y + 5.0]];
    let edge = CanvasEdge { ink: PAPER, width: 0.8, is_dashed: false };
    canvas.polygon(&corners, Some(TEXT), Some(edge));
}
