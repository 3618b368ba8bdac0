//! How cells and heads look: figures right-aligned on their decimal sign, and marks that need no colour.

use eframe::egui::{Align2, Color32, FontId, Painter, Rect, Stroke, pos2, vec2};

use crate::gui::table::grid::{cursor_frame, ground, head_ground, wrong_frame};
use crate::gui::theme::{self, Palette, sizes, space};
use crate::length::Length;
use crate::tolerance::Deviations;
use crate::words::Words;

/// What is shown of a cell.
pub(super) struct TableCellView<'a> {
    pub palette: &'a Palette,
    pub words: &'a Words,
    /// How much room the decimals of the column need.
    pub decimals: f32,
    pub cell: Option<Deviations>,
    pub differs: bool,
    /// The keys are there; whether the grid has the focus.
    pub cursor: Option<bool>,
    /// The filter names its row.
    pub marked: bool,
}

/// A cell: upper over lower deviation, or a quiet dash.
pub(super) fn cell(painter: &Painter, rect: Rect, look: &TableCellView<'_>) {
    let palette = look.palette;
    ground(painter, rect, if look.cursor.is_none() { palette.surface } else { palette.tint });
    if let Some(pair) = look.cell {
        let third = rect.height() * 0.29;
        figure(painter, rect, rect.top() + third, look, pair.upper());
        figure(painter, rect, rect.bottom() - third, look, pair.lower());
    } else {
        let at = rect.center();
        let half = vec2(space(1.0), 0.0);
        painter.line_segment([at - half, at + half], Stroke::new(1.0, palette.quiet.0));
    }
    if look.marked {
        let line = Stroke::new(2.0, palette.focus.0);
        painter.hline(rect.x_range(), rect.top() + 1.0, line);
        painter.hline(rect.x_range(), rect.bottom() - 1.0, line);
    }
    if look.differs {
        wrong_frame(painter, rect);
        let mark = Rect::from_center_size(rect.left_center() + vec2(space(3.0), 0.0), vec2(space(3.0), space(3.0)));
        unequal(painter, mark, palette.error.0);
    }
    if let Some(is_focused) = look.cursor {
        cursor_frame(painter, rect, is_focused);
    }
}

/// A deviation; its decimals take the room that the column's longest ones need.
fn figure(painter: &Painter, rect: Rect, y: f32, look: &TableCellView<'_>, length: Length) {
    let text = look.words.signed_um(length);
    let sign = look.words.decimal_sign();
    let (whole, rest) = text.split_at(text.find(sign).unwrap_or(text.len()));
    let font = if look.differs { theme::bold(sizes().small) } else { theme::font(sizes().small) };
    let x = rect.right() - space(2.5) - look.decimals;
    painter.text(pos2(x, y), Align2::RIGHT_CENTER, whole, font.clone(), look.palette.text.0);
    if !rest.is_empty() {
        painter.text(pos2(x, y), Align2::LEFT_CENTER, rest, font, look.palette.text.0);
    }
}

/// The room that the longest decimals of a column need, points.
pub(super) fn decimals(painter: &Painter, cells: &[Option<Deviations>]) -> f32 {
    let lengths = cells.iter().flatten().flat_map(|pair| [pair.upper(), pair.lower()]);
    let longest = lengths.map(|length| places(length.nanometres())).fold(0, usize::max);
    let Some(digits) = [None, Some(".0"), Some(".00"), Some(".000")].get(longest).copied().flatten() else {
        return 0.0;
    };
    width(painter, digits, theme::font(sizes().small))
}

/// How many decimals a number of micrometres has.
const fn places(nm: i64) -> usize {
    match nm {
        nm if nm % 1000 == 0 => 0,
        nm if nm % 100 == 0 => 1,
        nm if nm % 10 == 0 => 2,
        _ => 3,
    }
}

fn width(painter: &Painter, text: &str, font: FontId) -> f32 {
    painter.layout_no_wrap(text.to_owned(), font, Color32::PLACEHOLDER).size().x
}

/// A head of a column or a row, with a remark below it.
pub(super) struct Head<'a> {
    pub palette: &'a Palette,
    pub text: &'a str,
    /// `own`, or how many cells differ.
    pub remark: &'a str,
    /// The remark is about differences.
    pub differs: bool,
    /// The selected cell is in this column or row, or the filter names it.
    pub marked: bool,
}

/// Draws a head.
pub(super) fn head(painter: &Painter, rect: Rect, head: &Head<'_>) {
    let palette = head.palette;
    head_ground(painter, rect, head.marked);
    let raised = if head.remark.is_empty() { 0.0 } else { rect.height() * 0.18 };
    let font = theme::bold(sizes().body);
    painter.text(rect.center() - vec2(0.0, raised), Align2::CENTER_CENTER, head.text, font, palette.text.0);
    if !head.remark.is_empty() {
        let colour = if head.differs { palette.error.0 } else { palette.quiet.0 };
        let at = rect.center() + vec2(0.0, rect.height() * 0.25);
        painter.text(at, Align2::CENTER_CENTER, head.remark, theme::font(sizes().small), colour);
    }
}

/// The sign "not equal".
pub(super) fn unequal(painter: &Painter, rect: Rect, colour: Color32) {
    let at = rect.center();
    let size = rect.size().min_elem();
    let stroke = Stroke::new((size * 0.13).max(1.0), colour);
    for y in [-0.14, 0.14] {
        painter.line_segment([at + vec2(-0.42, y) * size, at + vec2(0.42, y) * size], stroke);
    }
    painter.line_segment([at + vec2(-0.22, 0.42) * size, at + vec2(0.22, -0.42) * size], stroke);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn decimals_are_counted_in_micrometres() {
        for (nm, expected) in [(21_000, 0), (43_500, 1), (-7_250, 2), (1, 3), (0, 0)] {
            assert_eq!(places(nm), expected, "{nm} nm");
        }
    }
}
