//! Where the zones of one grade lie, letter by letter: the staircase of the textbooks. A click on a column takes it.

use eframe::egui::{Align2, Rect, Sense, Stroke, StrokeKind, Ui, pos2, vec2};

use super::letter_columns::Columns;
use crate::gui::shapes::screen;
use crate::gui::spoken;
use crate::gui::theme::{self, palette, sizes, space};
use crate::gui::view::View;
use crate::message::message;
use crate::session::{ClassMap, FitCommand};
use crate::tolerance::Feature;
use crate::tolerance::iso286::Grade;

/// The zones of a grade over a height.
pub(super) fn staircase_ui(
    ui: &mut Ui,
    view: &mut View<'_>,
    map: &ClassMap,
    grade: Grade,
    height: f32,
    columns: impl Fn(Rect) -> Columns,
) {
    let palette = palette(ui.ctx());
    let side = view.session.fit().side();
    let chosen = view.session.fit().class(side);
    let (rect, response) = ui.allocate_exact_size(vec2(ui.available_width(), height), Sense::CLICK);
    let columns = columns(rect);
    let (lowest, highest) = map.range_um(grade);
    let body = rect.shrink2(vec2(0.0, space(2.0)));
    let y = |um: f64| body.bottom() - body.height() * screen((um - lowest) / (highest - lowest));
    let painter = ui.painter();
    let fill = match side {
        Feature::Hole => palette.hole.0,
        Feature::Shaft => palette.shaft.0,
    };
    let small = || theme::font(sizes().small);
    for (um, anchor) in [(lowest, Align2::LEFT_BOTTOM), (highest, Align2::LEFT_TOP)] {
        if um != 0.0 {
            let text = view.words.number(&format!("{um:+}"));
            let at = pos2(rect.left(), if anchor == Align2::LEFT_TOP { rect.top() } else { rect.bottom() });
            painter.text(at, anchor, text, small(), palette.quiet.0);
        }
    }
    painter.hline(columns.left..=rect.right(), y(0.0), Stroke::new(1.5, palette.text.0));
    let pointer = response.interact_pointer_pos().map(|pointer| pointer.x);
    for (letter, x) in columns.letters() {
        let Some(cell) = map.cell(letter, grade) else { continue };
        let top = y(cell.upper_um);
        let bottom = y(cell.lower_um);
        let bar = Rect::from_x_y_ranges(x + 2.0..=x + columns.step - 2.0, top..=bottom.max(top + 2.0));
        let is_chosen = chosen == Some(cell.class);
        if is_chosen {
            let column = Rect::from_x_y_ranges(x..=x + columns.step, rect.y_range());
            painter.rect_filled(column, 2.0, palette.tint.0);
            painter.hline(column.x_range(), y(0.0), Stroke::new(1.5, palette.text.0));
        }
        let (fill, edge) = if is_chosen { (palette.data.0, 2.0) } else { (fill, 1.0) };
        painter.rect(bar, 0.0, fill, Stroke::new(edge, palette.text.0), StrokeKind::Middle);
        let is_hit = pointer.is_some_and(|pointer| x <= pointer && pointer < x + columns.step);
        if is_hit && response.clicked() {
            view.send(FitCommand::ChooseClass(cell.class));
        }
    }
    let name = view.words.say(&message!("fit-staircase").text("grade", grade));
    spoken::picture(ui, &response, name, describe(view, map, grade));
}

/// Every zone of the grade in words, for users who cannot see it.
fn describe(view: &View<'_>, map: &ClassMap, grade: Grade) -> String {
    let cells = crate::tolerance::iso286::Letter::ALL.into_iter().filter_map(|letter| map.cell(letter, grade));
    let said: Vec<String> = cells
        .map(|cell| {
            let lower = cell.deviations.lower();
            let upper = cell.deviations.upper();
            format!("{} {} … {} µm", cell.class, view.words.signed_um(lower), view.words.signed_um(upper))
        })
        .collect();
    said.join(", ")
}
