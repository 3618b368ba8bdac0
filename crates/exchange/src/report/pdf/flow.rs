//! Where the next thing goes: page after page from top to bottom.

use super::fonts::Fonts;
use super::look::{BOTTOM, SIDE, Style, TOP, TOP_AFTER};
use super::sheet::{Piece, Place, Shape, Sheet};
use super::tags::{TagId, Tags};
use super::wrap::wrap;

/// The pages as far as they are filled.
pub(super) struct Flow<'a> {
    pub fonts: &'a Fonts,
    pub tags: Tags,
    pub sheets: Vec<Sheet>,
    /// Where the next thing goes.
    pub y: f32,
    /// Whether a text had to be cut.
    pub is_cut: bool,
    size: [f32; 2],
    /// What the last piece of this page belongs to, where there is one.
    piece: Option<TagId>,
    is_begun: bool,
}

impl<'a> Flow<'a> {
    /// Pages of this size; the first one is begun.
    pub fn new(fonts: &'a Fonts, size: [f32; 2]) -> Self {
        Self {
            fonts,
            tags: Tags::new(),
            sheets: vec![Sheet::default()],
            y: TOP,
            is_cut: false,
            size,
            piece: None,
            is_begun: false,
        }
    }

    /// Width and height of a page.
    pub const fn size(&self) -> [f32; 2] {
        self.size
    }

    /// The width between the margins.
    pub const fn width(&self) -> f32 {
        self.size[0] - 2.0 * SIDE
    }

    /// The right end of what is between the margins.
    pub const fn right(&self) -> f32 {
        self.size[0] - SIDE
    }

    /// The lower end of what is between the margins.
    pub const fn bottom(&self) -> f32 {
        self.size[1] - BOTTOM
    }

    /// The number of this page, from 0.
    pub const fn page(&self) -> usize {
        self.sheets.len().saturating_sub(1)
    }

    /// Begins the next page.
    pub fn turn(&mut self) {
        self.sheets.push(Sheet::default());
        self.y = TOP_AFTER;
        self.is_begun = false;
    }

    /// Turns the page where this much does not fit; whether it did.
    pub fn room(&mut self, height: f32) -> bool {
        let is_full = self.bottom() < self.y + height && TOP_AFTER < self.y;
        if is_full {
            self.turn();
        }
        is_full
    }

    /// Draws something that belongs to an element of the structure, or is without a meaning of its own.
    pub fn put(&mut self, element: Option<TagId>, shape: Shape) {
        if !self.is_begun || self.piece != element {
            self.piece = element;
            self.is_begun = true;
            let piece = element.map_or(Piece::Layout, |element| Piece::Of(self.tags.piece(element)));
            if let Some(sheet) = self.sheets.last_mut() {
                sheet.pieces.push((sheet.shapes.len(), piece));
            }
        }
        if let Some(sheet) = self.sheets.last_mut() {
            sheet.shapes.push(shape);
        }
    }

    /// Sets a text in one line, from the left.
    pub fn say(&mut self, element: Option<TagId>, at: Place, style: Style, text: String) {
        self.put(element, Shape::Text(at, style, text));
    }

    /// The same, up to a place on the right.
    pub fn say_to(&mut self, element: Option<TagId>, [right, y]: Place, style: Style, text: String) {
        // The space that parts it from the next line is beyond the edge.
        let width = self.fonts.width(text.trim_end(), style.weight, style.size);
        self.say(element, [right - width, y], style, text);
    }

    /// The same, round a place.
    pub fn say_round(&mut self, element: Option<TagId>, [x, y]: Place, style: Style, text: String) {
        let width = self.fonts.width(&text, style.weight, style.size);
        self.say(element, [x - width / 2.0, y], style, text);
    }

    /// A text in lines of a width.
    pub fn wrap(&mut self, text: &str, style: Style, width: f32, most: usize) -> Vec<String> {
        let wrapped = wrap(self.fonts, &Fonts::clean(text), style, width, most);
        self.is_cut |= wrapped.is_cut;
        wrapped.lines
    }

    /// Sets lines one below the other from here on; they may go on on the next page.
    pub fn lines(&mut self, element: TagId, x: f32, style: Style, lines: Vec<String>) {
        for line in lines {
            self.room(style.line());
            self.say(Some(element), [x, base(self.y, style.line(), style)], style, line);
            self.y += style.line();
        }
    }

    /// Sets a paragraph over the whole width.
    pub fn paragraph(&mut self, section: TagId, style: Style, text: &str) {
        let element = self.tags.add(section, super::tags::Kind::Paragraph);
        let lines = self.wrap(text, style, self.width(), MOST_LINES);
        self.lines(element, SIDE, style, lines);
    }

    /// Draws a line over the whole width.
    pub fn rule(&mut self, y: f32, width: f32, ink: super::look::Ink) {
        let shape = Shape::Line { from: [SIDE, y], to: [self.right(), y], width, ink };
        self.put(None, shape);
    }
}

/// Lines that belong together, with a space between them for whoever hears or copies them.
pub(super) fn apart(mut lines: Vec<String>) -> Vec<String> {
    let all = lines.len();
    for line in lines.iter_mut().take(all.saturating_sub(1)).filter(|line| !line.ends_with(' ')) {
        line.push(' ');
    }
    lines
}

/// The most lines of a paragraph.
const MOST_LINES: usize = 12;

/// The base line of a text in the middle of a row that begins here.
pub(super) fn base(top: f32, height: f32, style: Style) -> f32 {
    // Half the height of a capital.
    top + height / 2.0 + style.size * 0.33
}
