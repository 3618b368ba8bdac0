//! Where the columns of letters are: the same in the staircase and in the grid.

use eframe::egui::Rect;

use crate::gui::theme::space;
use crate::tolerance::iso286::Letter;

/// Where the columns of letters are: the same in the staircase and in the grid.
#[derive(Debug, Clone, Copy)]
pub(super) struct Columns {
    /// Where the first letter begins.
    pub left: f32,
    /// The width of a letter.
    pub step: f32,
}

impl Columns {
    pub(super) fn of(rect: Rect) -> Self {
        let count = f32::from(u8::try_from(Letter::ALL.len()).unwrap_or(u8::MAX));
        let left = rect.left() + space(9.0);
        Self { left, step: (rect.right() - left) / count }
    }

    /// Every letter with the left edge of its column.
    pub fn letters(self) -> impl Iterator<Item = (Letter, f32)> {
        let mut x = self.left - self.step;
        Letter::ALL.into_iter().map(move |letter| {
            x += self.step;
            (letter, x)
        })
    }
}
