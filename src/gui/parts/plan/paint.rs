//! How cells and heads look: what is wrong is marked by a frame and a sign, never by colour alone.

use eframe::egui::{Align2, Painter, Rect, vec2};

use crate::gui::table::grid::{cursor_frame, ground, head_ground, wrong_frame};
use crate::gui::table::{PAD, text_ui};
use crate::gui::theme::{self, Palette, sizes, space};

/// What is shown of a cell.
#[expect(clippy::struct_excessive_bools, reason = "each may stand with each")]
pub(super) struct PlanCellView<'a> {
    pub palette: &'a Palette,
    pub text: &'a str,
    pub is_wrong: bool,
    /// It cannot be edited.
    pub is_fixed: bool,
    pub is_selected: bool,
    /// Figures stand at the right.
    pub is_figure: bool,
    /// The keys are there; whether the table has the focus.
    pub cursor: Option<bool>,
}

pub(super) fn cell(painter: &Painter, rect: Rect, look: &PlanCellView<'_>) {
    let palette = look.palette;
    let fill = match (look.is_selected, look.is_fixed) {
        (true, _) => palette.tint,
        (false, true) => palette.sunken,
        (false, false) => palette.surface,
    };
    ground(painter, rect, fill);
    let mut room = rect.shrink2(vec2(PAD, 0.0));
    if look.is_wrong {
        wrong_frame(painter, rect);
        let font = theme::bold(sizes().body);
        painter.text(room.right_center(), Align2::RIGHT_CENTER, "!", font, palette.error.0);
        room.max.x -= space(2.0);
    }
    let colour = if look.is_fixed { palette.quiet.0 } else { palette.text.0 };
    let font = theme::font(sizes().body);
    if look.is_figure {
        let width = painter.layout_no_wrap(look.text.to_owned(), font.clone(), colour).size().x;
        room.min.x = room.min.x.max(room.max.x - width - 1.0);
    }
    text_ui(painter, room, look.text, &font, colour);
    if let Some(is_focused) = look.cursor {
        cursor_frame(painter, rect, is_focused);
    }
}

/// A head of a column or a row.
pub(super) fn head(painter: &Painter, rect: Rect, palette: &Palette, text: &str, (is_marked, is_wrong): (bool, bool)) {
    head_ground(painter, rect, is_marked);
    let mut room = rect.shrink2(vec2(PAD, 0.0));
    if is_wrong {
        painter.text(room.right_center(), Align2::RIGHT_CENTER, "!", theme::bold(sizes().body), palette.error.0);
        room.max.x -= space(2.0);
    }
    text_ui(painter, room, text, &theme::bold(sizes().small), palette.text.0);
}
