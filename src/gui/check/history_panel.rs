//! Bottom: earlier checks, newest first. Only the rows in sight are drawn.

use eframe::egui::{Align, Button, Checkbox, Id, Layout, RichText, Sense, Ui, UiBuilder, vec2};
use egui_extras::{Column, TableBuilder};

use crate::gui::shapes;
use crate::gui::theme::{self, control, palette, sizes, space};
use crate::gui::verdict_card::status_id;
use crate::gui::view::{Digits, View, heading, quiet};
use crate::journal::Record;
use crate::message::{Message, Say as _};
use crate::session::CheckCommand;
use crate::words::Words;

fn unfolded_id() -> Id {
    Id::unique("history-unfolded")
}

/// Whether the user opened the table on a small window.
pub(super) fn is_unfolded(ui: &Ui) -> bool {
    ui.data(|data| data.get_temp(unfolded_id())).unwrap_or(false)
}

/// The heading; on a small window a button that folds and unfolds.
fn title_ui(ui: &mut Ui, view: &View<'_>, can_fold: bool) {
    if !can_fold {
        heading(ui, view.text("history"));
        return;
    }
    let open = is_unfolded(ui);
    let text = RichText::new(view.text("history")).font(theme::bold(sizes().heading));
    if ui.add(Button::new(text).selected(open)).clicked() {
        ui.data_mut(|data| data.insert_temp(unfolded_id(), !open));
        ui.ctx().request_repaint();
    }
}

/// Title row and table.
pub(super) fn history_ui(ui: &mut Ui, view: &mut View<'_>, can_fold: bool) {
    ui.horizontal(|ui| {
        title_ui(ui, view, can_fold);
        let count = view.session.history().len();
        quiet(ui, view.words.say(&Message::new("history-count").count("count", count)));
        if 0 < view.session.chosen_count() {
            let chosen = Message::new("history-chosen").count("count", view.session.chosen_count());
            quiet(ui, view.words.say(&chosen));
        }
    });
    if view.session.history().is_empty() {
        quiet(ui, view.text("history-empty"));
        return;
    }
    table_ui(ui, view);
}

/// One line instead of the table, where there is no room for it.
pub(super) fn strip_ui(ui: &mut Ui, view: &View<'_>) {
    ui.horizontal(|ui| {
        title_ui(ui, view, true);
        for record in view.session.history().iter().rev().take(4) {
            let (rect, _) = ui.allocate_exact_size(vec2(space(4.0), space(4.0)), Sense::hover());
            let status = record.verdict.status();
            shapes::status(ui.painter(), rect, Some(status), palette(ui.ctx()).text.0);
            let said =
                format!("{}  {}", callout(record), Digits::of(record).mm(view.words, record.measurement.diameter, 3));
            ui.label(said).on_hover_text(view.text(status_id(Some(status))));
        }
        let count = view.session.history().len();
        quiet(ui, view.words.say(&Message::new("history-count").count("count", count)));
    });
}

fn callout(record: &Record) -> String {
    record.callout.map_or_else(|| format!("Ø {}", record.limits.nominal), |callout| callout.to_string())
}

fn table_ui(ui: &mut Ui, view: &mut View<'_>) {
    const HEADS: [&str; 8] = [
        "head-chosen",
        "head-time",
        "head-part",
        "head-callout",
        "head-measured",
        "head-deviation",
        "head-status",
        "head-from",
    ];
    let row_height = control(ui);
    let count = view.session.history().len();
    TableBuilder::new(ui)
        .id_salt("history")
        .striped(true)
        .min_scrolled_height(0.0)
        .auto_shrink(false)
        .cell_layout(Layout::left_to_right(Align::Center))
        .column(Column::exact(space(10.0)))
        .columns(Column::initial(space(26.0)).at_least(space(20.0)).clip(true), 5)
        .column(Column::initial(space(38.0)).at_least(space(20.0)).clip(true))
        .column(Column::remainder().clip(true))
        .header(sizes().body + 6.0, |mut header| {
            for head in HEADS {
                header.col(|ui| _ = quiet(ui, view.text(head)));
            }
        })
        .body(|body| {
            body.rows(row_height, count, |mut row| {
                let number = count - 1 - row.index();
                let Some(record) = view.session.history().get(number).cloned() else { return };
                let cells = Cells::of(view.words, &record);
                row.col(|ui| choose_ui(ui, view, number, &cells));
                row.col(|ui| show_ui(ui, view, number, &cells));
                for text in [&cells.part, &cells.callout, &cells.measured, &cells.deviation] {
                    row.col(|ui| _ = ui.label(text));
                }
                row.col(|ui| status_ui(ui, &record, &cells.status));
                row.col(|ui| _ = ui.label(&cells.from));
            });
        });
}

fn choose_ui(ui: &mut Ui, view: &mut View<'_>, number: usize, cells: &Cells) {
    let mut chosen = view.session.is_chosen(number);
    let name = Message::new("choose-check").text("callout", &cells.callout).text("time", &cells.time);
    let response = ui.add(Checkbox::without_text(&mut chosen)).accessible_name(view.words.say(&name));
    if response.changed() {
        view.send(CheckCommand::Choose(number, chosen));
    }
}

fn show_ui(ui: &mut Ui, view: &mut View<'_>, number: usize, cells: &Cells) {
    let shown = view.session.check().shown().is_some_and(|shown| {
        view.session.history().get(number).is_some_and(|record| std::sync::Arc::ptr_eq(&shown.record, record))
    });
    let name = Message::new("show-check")
        .text("time", &cells.time)
        .text("callout", &cells.callout)
        .text("status", &cells.status);
    let response = ui.selectable_label(shown, &cells.time).accessible_name(view.words.say(&name));
    if response.clicked() {
        view.send(CheckCommand::Show(number));
    }
}

fn status_ui(ui: &mut Ui, record: &Record, word: &str) {
    let status = record.verdict.status();
    let (fill, colour) = palette(ui.ctx()).of_status(Some(status));
    let (rect, _) = ui.allocate_exact_size(vec2(space(36.0).min(ui.available_width()), space(6.0)), Sense::hover());
    ui.painter().rect_filled(rect, 3.0, fill);
    let (shape, text) = rect.split_left_right_at_x(rect.left() + rect.height());
    shapes::status(ui.painter(), shape.shrink(3.0), Some(status), colour);
    let text = text.shrink2(vec2(2.0, 0.0));
    let id = Id::unique(("history-status", std::ptr::from_ref(record).addr()));
    ui.scope_builder(UiBuilder::new().id_salt(id).max_rect(text).layout(Layout::left_to_right(Align::Center)), |ui| {
        ui.add(eframe::egui::Label::new(RichText::new(word).font(theme::bold(sizes().small)).color(colour)).truncate());
    });
}

/// The texts of a row.
struct Cells {
    time: String,
    part: String,
    callout: String,
    measured: String,
    deviation: String,
    status: String,
    from: String,
}

impl Cells {
    fn of(words: &Words, record: &Record) -> Self {
        let digits = Digits::of(record);
        Self {
            time: record.time.strftime("%H:%M:%S").to_string(),
            part: record.id.clone(),
            callout: callout(record),
            measured: digits.mm(words, record.measurement.diameter, 4),
            deviation: format!("{} µm", digits.signed_um(words, record.verdict.size.deviation)),
            status: words.get(status_id(Some(record.verdict.status()))),
            from: words.say(&record.measurement.origin.message()),
        }
    }
}
