//! A table of the manual: each column as wide as its texts where there is room, else wide columns share what is left and their texts
//! go on in further lines.

use eframe::egui::{Layout, Rect, Shape, Ui, vec2};

use super::text::{job, mark_shape, spans_ui};
use crate::gui::theme::{palette, space};
use crate::gui::view::View;
use crate::session::help::{HelpMark, HelpWords, Span};

/// Between two columns.
const GAP: f32 = 4.0;

/// The table; a marked row stands out. Returns where that is.
pub(super) fn table_ui(
    ui: &mut Ui,
    view: &mut View<'_>,
    (head, rows): (&[Vec<Span>], &[Vec<Vec<Span>>]),
    mark: Option<&HelpMark>,
) -> Option<Rect> {
    let wanted = wanted(ui, head, rows);
    let gaps = wanted.iter().skip(1).fold(0.0, |gaps, _| gaps + space(GAP));
    let widths = shared(&wanted, ui.available_width() - gaps);
    let bold = |cell: &Vec<Span>| cell.iter().map(|span| Span { is_bold: true, ..span.clone() }).collect();
    let head: Vec<Vec<Span>> = head.iter().map(bold).collect();
    let mut marked = None;
    ui.scope(|ui| {
        ui.spacing_mut().item_spacing.y = space(1.0);
        row_ui(ui, view, &widths, &head, None);
        for (number, row) in rows.iter().enumerate() {
            line_ui(ui);
            let mark = mark.filter(|mark| mark.row == Some(number));
            let ground = ui.painter().add(Shape::Noop);
            let rect = row_ui(ui, view, &widths, row, mark.map(|mark| &mark.words));
            if mark.is_some() {
                ui.painter().set(ground, mark_shape(ui, rect));
                marked = Some(rect);
            }
        }
    });
    marked
}

/// The widths that the columns have when each text is one line.
fn wanted(ui: &Ui, head: &[Vec<Span>], rows: &[Vec<Vec<Span>>]) -> Vec<f32> {
    let width = |cell: &Vec<Span>| ui.painter().layout_job(job(ui, cell, None)).size().x;
    let column = |number: usize| {
        let cells = rows.iter().filter_map(|row| row.get(number)).chain(head.get(number));
        cells.map(width).fold(0.0, f32::max).ceil() + 2.0
    };
    (0..head.len()).map(column).collect()
}

/// The widths within a room. Columns that want less than an even share get what they want, and the others share the rest.
fn shared(wanted: &[f32], room: f32) -> Vec<f32> {
    let mut open: Vec<usize> = (0..wanted.len()).collect();
    let mut widths = wanted.to_vec();
    let mut left = room;
    loop {
        let count = open.iter().fold(0.0, |count, _| count + 1.0);
        let share = (left / f32::max(count, 1.0)).max(space(6.0));
        let fits = |column: &usize| wanted.get(*column).is_some_and(|wanted| *wanted <= share);
        let (fitting, wide): (Vec<usize>, Vec<usize>) = open.iter().partition(|column| fits(column));
        if fitting.is_empty() {
            for column in wide {
                if let Some(width) = widths.get_mut(column) {
                    *width = share;
                }
            }
            return widths;
        }
        left -= fitting.iter().filter_map(|column| wanted.get(*column)).sum::<f32>();
        open = wide;
    }
}

fn row_ui(ui: &mut Ui, view: &mut View<'_>, widths: &[f32], cells: &[Vec<Span>], words: Option<&HelpWords>) -> Rect {
    let row = ui.horizontal_top(|ui| {
        ui.spacing_mut().item_spacing.x = space(GAP);
        ui.spacing_mut().interact_size.y = 0.0;
        for (width, cell) in widths.iter().zip(cells) {
            ui.allocate_ui_with_layout(vec2(*width, 0.0), Layout::top_down(eframe::egui::Align::LEFT), |ui| {
                ui.set_width(*width);
                spans_ui(ui, view, cell, words);
            });
        }
    });
    row.response.rect
}

/// A thin line between two rows.
fn line_ui(ui: &mut Ui) {
    let (rect, _) = ui.allocate_exact_size(vec2(ui.available_width(), 1.0), eframe::egui::Sense::hover());
    ui.painter().rect_filled(rect, 0.0, palette(ui.ctx()).line.0);
}
