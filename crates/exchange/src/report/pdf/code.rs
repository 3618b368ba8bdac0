//! A code that a phone or a scanner reads: the hash of a record, with which `fitcheck journal show` finds it.

use fast_qr::{ECL, QRBuilder, QRCode};

use super::flow::Flow;
use super::look::{PAPER, TEXT};
use super::sheet::{Area, Shape};
use super::tags::{Kind, Tags};

/// The side of a code on a page: at this size a code of 64 signs is read from paper that was copied once.
pub(super) const CODE: f32 = 66.0;

/// How many free squares are around a code (ISO/IEC 18004).
const QUIET: usize = 4;

/// A code.
pub(super) struct Code(QRCode);

impl Code {
    /// The code of a text; `None` where it is too long.
    pub fn of(text: &str) -> Option<Self> {
        QRBuilder::new(text).ecl(ECL::M).build().ok().map(Self)
    }

    /// Draws it, with what a person hears of it.
    pub fn write(&self, flow: &mut Flow<'_>, area: Area, said: String) {
        let place = Some((flow.page(), [area.x, area.y, area.width, area.height]));
        let figure = flow.tags.add(Tags::ROOT, Kind::Figure(said, place));
        flow.put(Some(figure), Shape::Block { area, radius: 0.0, fill: Some(PAPER), edge: None });
        let size = self.0.size;
        let step = area.width / super::cells::count(size + 2 * QUIET);
        let at = |place: usize| step * super::cells::count(place + QUIET);
        for row in 0..size {
            let mut from = None;
            for column in 0..=size {
                let is_dark = column < size && self.is_dark(row, column);
                match (from, is_dark) {
                    (None, true) => from = Some(column),
                    (Some(begin), false) => {
                        // Squares beside each other are one: no thin line shows between them.
                        let run = Area::new(area.x + at(begin), area.y + at(row), at(column) - at(begin), step * 1.02);
                        flow.put(Some(figure), Shape::Block { area: run, radius: 0.0, fill: Some(TEXT), edge: None });
                        from = None;
                    }
                    _ => {}
                }
            }
        }
    }

    fn is_dark(&self, row: usize, column: usize) -> bool {
        self.0.data.get(row * self.0.size + column).is_some_and(|module| module.value())
    }
}
