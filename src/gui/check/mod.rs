//! The check page: is it good, and if not, what do I do?
//!
//! | file | what |
//! |---|---|
//! | `asked_panel` | left: callout, limits, measured value, probe position, simulated workpiece |
//! | `rule_panel` | left: decision rule, uncertainty, temperature |
//! | `record_panel` | left: what is recorded besides; right: the number of the record |
//! | `band_plot`, `contacts_plot`, `last_values` | middle: what was seen |
//! | `answer_panel`, `worth_lines`, `status_panel` | right: the verdict, what it is worth, and the control's window |
//! | `history_panel`, `history_list` | bottom: earlier checks |
//! | `rows_panel`, `rows_list`, `row_texts` | in their place: the rows of a large file |

mod answer_panel;
mod asked_panel;
mod band_plot;
mod contacts_plot;
mod field_pairs;
mod history_list;
mod history_panel;
mod last_values;
mod record_panel;
mod row_texts;
mod rows_list;
mod rows_panel;
mod rule_panel;
mod status_panel;
mod worth_lines;

pub(super) use answer_panel::card as check_card;
use eframe::egui::{Align, Layout, Ui, vec2};
#[cfg(test)]
pub(super) use history_list::COLUMNS as HISTORY;
pub(super) use record_panel::recorded_ui;
pub(super) use row_texts::grouped;
#[cfg(test)]
pub(super) use rows_list::COLUMNS as ROWS;
pub(super) use status_panel::mask_chooser_ui;
pub(super) use worth_lines::{lines as worth_lines, reasons as worth_reasons};

use super::columns::{Page, Shape, Side, area_ui, bar_ui, column_ui, columns_ui, panel_ui, rest_ui};
use super::keypad::keypad_ui;
use super::page::{Group, PageView, measurements};
use super::theme::{Icon, space};
use super::verdict_card::least_width;
use super::view::View;

/// From this width on there is room for the history beside everything else.
const ULTRA_WIDE: f32 = 650.0;

/// From this width on the columns are wider, and the history is a table whatever the height.
const WIDE: f32 = 400.0;

pub(super) const PAGE: PageView =
    PageView { group: Group::Measure, icon: Icon::Ruler, ui: check_ui, dropped: measurements };

/// The check page: left what is asked, middle what was seen, right the answer, bottom the earlier checks.
fn check_ui(ui: &mut Ui, view: &mut View<'_>) {
    let size = ui.available_size();
    let is_wide = space(WIDE) <= size.x;
    let page = Page {
        // Another size of window has widths and heights of its own.
        name: if is_wide { "check-wide" } else { "check" },
        left: if is_wide { space(85.0) } else { space(74.0) },
        right: if is_wide { space(105.0) } else { space(88.0) },
        head: None,
        asked: asked_panel::asked_panel_ui,
        seen: seen_ui,
        seen_height: space(110.0),
        verdict: |ui, view| answer_panel::answer_ui(ui, view),
        least: least_width(ui, view),
        answer: |ui, view| {
            rows_panel::shown_row_ui(ui, view);
            answer_panel::reasons_ui(ui, view);
            ui.add_space(space(2.0));
            status_panel::status_ui(ui, view);
        },
    };
    if space(ULTRA_WIDE) <= size.x {
        let sizes = (size.x * 0.3, space(150.0)..=size.x * 0.45);
        panel_ui(ui, view, Side::Right, "history-beside", sizes, |ui, view| {
            below_ui(ui, view, false);
        });
    } else {
        history_below_ui(ui, view, &page);
    }
    if size.x * 1.3 < size.y && Shape::of(ui, page.least) != Shape::One {
        return tall_ui(ui, view, &page);
    }
    columns_ui(ui, view, &page);
}

/// The history over the width of the page: a table, or one line that unfolds where the window is small.
fn history_below_ui(ui: &mut Ui, view: &mut View<'_>, page: &Page) {
    let size = ui.available_size();
    if view.session.check().shows_rows() {
        let share = if size.y < space(175.0) { 0.55 } else { 0.45 };
        let sizes = (size.y * share, space(50.0)..=(size.y * 0.7).max(space(50.0)));
        return panel_ui(ui, view, Side::Bottom, (page.name, "rows"), sizes, |ui, view| below_ui(ui, view, false));
    }
    let has_keypad = view.session.has_keypad() && size.y < space(230.0);
    let folded = has_keypad || (size.x < space(300.0) && size.y < size.x * 1.3) || size.y < space(175.0);
    if folded && !history_panel::is_unfolded(ui) {
        bar_ui(ui, view, Side::Bottom, "strip", history_panel::strip_ui);
        return;
    }
    let share = if folded || size.x * 1.3 < size.y || space(WIDE) <= size.x { 0.38 } else { 0.24 };
    let sizes = (size.y * share, space(32.0)..=(size.y * 0.6).max(space(32.0)));
    panel_ui(ui, view, Side::Bottom, (page.name, "history", folded), sizes, |ui, view| {
        below_ui(ui, view, folded);
    });
}

/// The history, or the rows of a large file in its place.
fn below_ui(ui: &mut Ui, view: &mut View<'_>, can_fold: bool) {
    let check = view.session.check();
    match check.rows.as_ref().filter(|_| check.shows_rows()) {
        Some(rows) => rows_panel::rows_ui(ui, view, rows),
        None => history_panel::history_ui(ui, view, can_fold),
    }
}

/// A window on its side: the verdict beside the band, what is asked beside the rest.
fn tall_ui(ui: &mut Ui, view: &mut View<'_>, page: &Page) {
    let height = ui.available_height();
    let sizes = (height * 0.4, height * 0.25..=height * 0.6);
    area_ui(ui, view, Side::Top, "check-tall", sizes, |ui, view| {
        let width = ui.available_width();
        let sizes = (page.least.max(width * 0.5), page.least.max(width * 0.35)..=page.least.max(width * 0.65));
        area_ui(ui, view, Side::Left, "check-tall-answer", sizes, |ui, view| (page.verdict)(ui, view));
        rest_ui(ui, view, seen_ui);
    });
    let width = ui.available_width();
    panel_ui(ui, view, Side::Left, "check-tall-asked", (width * 0.5, width * 0.35..=width * 0.65), |ui, view| {
        keypad_ui(ui, view);
        column_ui(ui, "check-tall-asked", |ui| (page.asked)(ui, view));
    });
    rest_ui(ui, view, |ui, view| {
        column_ui(ui, "check-tall-rest", |ui| (page.answer)(ui, view));
    });
}

/// The band; below it the contacts, or the last values where no contacts are known, or both where there is room.
fn seen_ui(ui: &mut Ui, view: &mut View<'_>) {
    let width = ui.available_width();
    let height = ui.available_height();
    band_plot::band_ui(ui, view, (height * 0.36).clamp(space(34.0), space(70.0)));
    ui.separator();
    let has_contacts = contacts_plot::has_picture(view);
    if has_contacts && space(160.0) < width {
        let height = ui.available_height();
        let gap = space(4.0);
        ui.horizontal_top(|ui| {
            ui.spacing_mut().item_spacing.x = gap;
            let half = vec2((width - gap) / 2.0, height);
            ui.allocate_ui_with_layout(half, Layout::top_down(Align::Min), |ui| {
                contacts_plot::contacts_ui(ui, view);
            });
            ui.allocate_ui_with_layout(half, Layout::top_down(Align::Min), |ui| {
                last_values::last_values_ui(ui, view);
            });
        });
    } else if has_contacts || view.session.check().shown.is_none() && view.session.history().is_empty() {
        contacts_plot::contacts_ui(ui, view);
    } else {
        last_values::last_values_ui(ui, view);
        contacts_plot::remarks_ui(ui, view);
    }
}
