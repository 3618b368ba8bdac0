//! What is drawn on a page, as plain values: `emit` makes a PDF of them.

use krilla::geom::Rect;

use super::bands::BandShape;
use super::look::{Ink, Style};
use super::signs::{Outline, Sign};

/// A place on a page, from its left and upper edge.
pub(super) type Place = [f32; 2];

/// A rectangle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Area {
    pub x: f32,
    pub y: f32,
    pub width: f32,
    pub height: f32,
}

impl Area {
    pub const fn new(x: f32, y: f32, width: f32, height: f32) -> Self {
        Self { x, y, width, height }
    }

    pub const fn right(self) -> f32 {
        self.x + self.width
    }

    pub const fn bottom(self) -> f32 {
        self.y + self.height
    }

    pub const fn middle(self) -> Place {
        [self.x + self.width / 2.0, self.y + self.height / 2.0]
    }

    pub fn rect(self) -> Option<Rect> {
        Rect::from_xywh(self.x, self.y, self.width, self.height)
    }
}

/// A line round something.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Edge {
    pub ink: Ink,
    pub width: f32,
    /// What nobody measured has a dashed one.
    pub is_dashed: bool,
}

/// Something on a page.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Shape {
    /// Text from this place of its base line on.
    Text(Place, Style, String),
    /// A rectangle with round corners.
    Block { area: Area, radius: f32, fill: Option<Ink>, edge: Option<Edge> },
    /// A straight line.
    Line { from: Place, to: Place, width: f32, ink: Ink },
    /// A sign, in the middle of its place.
    Sign { sign: Sign, middle: Place, size: f32, ink: Ink },
    /// The outline of a verdict, filled, round its middle.
    Outline { outline: Outline, middle: Place, radius: f32, fill: Ink, edge: Edge },
    /// A limit band.
    Band(Area, Box<BandShape>),
    /// The picture of a part, by its number.
    Picture(Area, usize),
}

/// What a piece of a page belongs to.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Piece {
    /// An element of the structure, which has this piece by its number.
    Of(usize),
    /// Lines, fills and signs without a meaning of their own, and heads of tables that stand there again.
    Layout,
    /// What stands on every page: its running line and its foot.
    Running,
}

/// A page: what is on it in the order of drawing, cut into pieces.
#[derive(Debug, Default)]
pub(super) struct Sheet {
    pub shapes: Vec<Shape>,
    /// Where each piece begins.
    pub pieces: Vec<(usize, Piece)>,
}
