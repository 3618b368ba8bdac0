//! What was measured last, newest first.

use std::sync::Arc;

use eframe::egui::{Align, Button, Id, Layout, RichText, Sense, Ui, vec2};

use crate::gui::card::page_card_ui;
use crate::gui::check::check_card;
use crate::gui::columns::of_height;
use crate::gui::shapes::{self, Edge, lines_of};
use crate::gui::theme::{self, control, palette, sizes, space};
use crate::gui::verdict_card::edged_chip_ui;
use crate::gui::view::{Digits, View, heading, quiet, remembered};
use crate::journal::Record;
use crate::session::{Page, WindowAction};

/// The height of a row.
const ROW: f32 = 56.0;

/// As many results are looked through at most.
const MOST: usize = 200;

pub(super) fn results_ui(ui: &mut Ui, view: &mut View<'_>) {
    page_card_ui(ui, |ui| {
        heading(ui, view.text("operator-results"));
        let records: Vec<Arc<Record>> = newest(view).take(MOST).collect();
        if records.is_empty() {
            quiet(ui, view.text("operator-no-results"));
            return;
        }
        let rows =
            lines_of((ui.available_height() - control(ui) - space(4.0)) / (ROW + ui.spacing().item_spacing.y)).max(1);
        let last = (records.len() - 1) / rows;
        let page: usize = remembered::<usize>(ui, page_id()).min(last);
        let shown = records.iter().skip(page * rows).take(rows);
        of_height(ui, ui.available_height() - control(ui) - space(3.0), |ui| {
            // The buttons below keep their place.
            ui.set_min_height(ui.available_height());
            for record in shown {
                row_ui(ui, view, record);
            }
        });
        pages_ui(ui, view, (page, last));
    });
}

fn page_id() -> Id {
    Id::unique("operator-results-page")
}

fn opened_id() -> Id {
    Id::unique("operator-result")
}

/// The result that is open.
pub(super) fn opened(ui: &Ui) -> Option<Arc<Record>> {
    remembered(ui, opened_id())
}

pub(super) fn is_open(ui: &Ui) -> bool {
    opened(ui).is_some()
}

/// Opens a result, or shows the list again.
pub(super) fn open(ui: &Ui, record: Option<Arc<Record>>) {
    ui.data_mut(|data| data.insert_temp(opened_id(), record));
}

/// Newer and older ones, by buttons: nobody has to drag.
fn pages_ui(ui: &mut Ui, view: &View<'_>, (page, last): (usize, usize)) {
    ui.horizontal(|ui| {
        let width = (ui.available_width() - ui.spacing().item_spacing.x) / 2.0;
        let newer = page.checked_sub(1);
        let older = (page < last).then_some(page + 1);
        for (id, to) in [("operator-newer", newer), ("operator-older", older)] {
            let text = RichText::new(view.text(id)).font(theme::bold(sizes().limits));
            let button = Button::new(text).min_size(vec2(width, control(ui)));
            let pressed = theme::looking(ui, theme::tonal, |ui| ui.add_enabled(to.is_some(), button)).clicked();
            if let Some(to) = to.filter(|_| pressed) {
                ui.data_mut(|data| data.insert_temp(page_id(), to));
            }
        }
    });
}

/// The last ones, as many as there is room for.
pub(super) fn last_ui(ui: &mut Ui, view: &mut View<'_>) {
    heading(ui, view.text("operator-last"));
    let count = lines_of(ui.available_height() / (ROW + ui.spacing().item_spacing.y));
    let records: Vec<Arc<Record>> = newest(view).take(count).collect();
    if records.is_empty() {
        quiet(ui, view.text("operator-no-results"));
    }
    for record in &records {
        row_ui(ui, view, record);
    }
}

fn newest<'a>(view: &View<'a>) -> impl Iterator<Item = Arc<Record>> + use<'a> {
    view.session.history().iter().rev().cloned()
}

/// The shape, the name and the callout, the value, the word, and when it was. Pressed, it opens with its reasons.
fn row_ui(ui: &mut Ui, view: &mut View<'_>, record: &Arc<Record>) {
    let palette = palette(ui.ctx());
    let (rect, response) = ui.allocate_exact_size(vec2(ui.available_width(), ROW), Sense::click());
    if response.hovered() || response.has_focus() {
        ui.painter().rect_filled(rect, 8.0, palette.hover.0);
    }
    ui.painter().hline(rect.x_range(), rect.bottom(), theme::line(ui.ctx()));
    let mut row =
        ui.new_child(eframe::egui::UiBuilder::new().max_rect(rect).layout(Layout::left_to_right(Align::Center)));
    row.spacing_mut().item_spacing.x = space(3.0);
    // The whole row is pressed.
    row.style_mut().interaction.selectable_labels = false;
    let (mark, _) = row.allocate_exact_size(vec2(space(6.0), space(6.0)), Sense::hover());
    shapes::status(row.painter(), mark, Some(record.verdict.status()), palette.text.0);
    let callout = record.callout.map_or_else(String::new, |callout| callout.to_string());
    let name = if record.id.is_empty() { callout.clone() } else { format!("{}  {callout}", record.id) };
    let value = Digits::of(record).mm(view.words, record.measurement.diameter, 3);
    let word = check_card(view.words, record, true).word;
    let edge = Edge::of(record);
    let time = record.time.strftime("%H:%M").to_string();
    row.with_layout(Layout::right_to_left(Align::Center), |ui| {
        ui.label(RichText::new(&time).font(theme::font(sizes().limits)));
        edged_chip_ui(ui, (record.verdict.status(), edge), &word);
        ui.label(RichText::new(format!("{value} mm")).font(theme::bold(sizes().figure)));
        ui.with_layout(Layout::left_to_right(Align::Center), |ui| {
            ui.add(eframe::egui::Label::new(RichText::new(&name).font(theme::font(sizes().limits))).truncate());
        });
    });
    let said = format!("{name}, {value} mm, {word}, {time}");
    response.widget_info(|| eframe::egui::WidgetInfo::labeled(eframe::egui::accesskit::Role::Button, true, &said));
    if response.clicked() {
        open(ui, Some(Arc::clone(record)));
        if view.session.page() != Page::Records {
            view.act(WindowAction::Open(Page::Records));
        }
    }
}
