//! The check page: is it good, and if not, what do I do?
//!
//! | file | what |
//! |---|---|
//! | `asked_panel` | left: callout, limits, measured value, probe position, simulated workpiece |
//! | `rule_panel` | left: decision rule, uncertainty, temperature |
//! | `record_panel` | left: what is recorded besides; right: the number of the record |
//! | `band_plot`, `contacts_plot`, `last_values` | middle: what was seen |
//! | `answer_panel`, `worth_lines`, `status_panel` | right: the verdict, what it is worth, and the control's window |
//! | `first_panel` | at the first start, in the place of what was seen and of earlier checks: settings, and three ways in |
//! | `history_panel`, `history_list` | bottom: earlier checks |
//! | `rows_panel`, `rows_list`, `row_texts` | in their place: the rows of a large file |

mod answer_panel;
mod asked_panel;
mod band_plot;
mod contacts_plot;
mod field_pairs;
mod first_panel;
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

pub(super) use answer_panel::{asks_ui, card as check_card, distances, why_ui};
pub(super) use band_plot::band_of_ui;
use std::ops::RangeInclusive;

pub(super) use crate::text::grouped;
use eframe::egui::{Align, Frame, Id, Layout, Panel, Ui, vec2};
#[cfg(test)]
pub(super) use history_list::COLUMNS as HISTORY;
pub(super) use record_panel::recorded_ui;
#[cfg(test)]
pub(super) use rows_list::COLUMNS as ROWS;
pub(super) use status_panel::mask_chooser_ui;
pub(super) use worth_lines::{lines as worth_lines, reasons as worth_reasons};

use super::card::{close_card_ui, close_frame, page_frame};
use super::columns::{
    GAP, Shape, Side, THREE, area_ui, column_ui, footed_column_ui, kept_size, lean_bar_ui, of_height, panel_ui, rest_ui,
};
use super::keypad::{self, keypad_ui};
use super::page::{Group, PageView};
use super::records::{correction_card_ui, correction_ui};
use super::room::is_low;
use super::theme::{Icon, space};
use super::verdict_card::least_width;
use super::view::{View, remembered};

/// From this width on there is room for the history beside everything else.
const ULTRA_WIDE: f32 = 620.0;

/// From this width on the answer has a column of its own, with the history below it.
const WIDE: f32 = 375.0;

/// Below this width the band stands below the verdict.
const NARROW: f32 = 210.0;

/// Below this height the fields above the keypad stand beside each other.
const CLOSE: f32 = 110.0;

/// What is left below the verdict at least, for two rows.
const LEAST_BELOW: f32 = 20.0;

/// What the verdict takes of a column, so that nothing moves when it comes.
const VERDICT: f32 = 69.0;

pub(super) const PAGE: PageView = PageView { opened, ..PageView::of(Group::Measure, Icon::Ruler, check_ui) };

/// The large file whose rows are listed.
fn opened(view: &View<'_>) -> Vec<String> {
    view.session.check().rows.iter().map(|rows| rows.name.clone()).collect()
}

/// The check page: left what is asked, right of it the band with the verdict, what else was seen, and the earlier checks.
fn check_ui(ui: &mut Ui, view: &mut View<'_>) {
    note_list(ui, !view.session.check().shows_rows());
    let size = ui.available_size();
    let least = least_width(ui, view);
    match Shape::of(ui, least, THREE) {
        Shape::One => one_ui(ui, view),
        _ if size.x * 1.3 < size.y => tall_ui(ui, view, least),
        _ if space(WIDE) <= size.x && space(200.0) <= size.y => wide_ui(ui, view, least),
        _ if size.x < space(NARROW) => narrow_ui(ui, view, least),
        _ => desk_ui(ui, view, least),
    }
}

/// Whether the list of checks is in sight, with the correction of the one that is shown.
fn lists_checks(ui: &Ui) -> bool {
    remembered(ui, Id::unique("check-lists-checks"))
}

fn note_list(ui: &Ui, is_in_sight: bool) {
    ui.data_mut(|data| data.insert_temp(Id::unique("check-lists-checks"), is_in_sight));
}

fn asked_ui(ui: &mut Ui, view: &mut View<'_>) {
    keypad_ui(ui, view);
    let session = view.session;
    if let Some(form) = session.records().correcting.as_ref() {
        return correction_card_ui(ui, view, form);
    }
    // Above the keypad there is little room: what is typed does not scroll.
    let is_close = session.has_keypad() && ui.available_height() < space(CLOSE);
    if is_close {
        asked_panel::typed_ui(ui, view);
    }
    column_ui(ui, "check-asked", |ui| asked_panel::asked_panel_ui(ui, view, is_close));
}

/// The width of the left column, and what the user may make of it.
fn asked_sizes(ui: &Ui, view: &View<'_>, usual: f32, rest: f32) -> (f32, RangeInclusive<f32>) {
    let least = space(61.0).max(keypad::width(view));
    let most = (ui.available_width() - rest).max(least);
    (usual.clamp(least, most), least..=most)
}

/// The verdict over all of its place.
fn verdict_ui(ui: &mut Ui, view: &mut View<'_>) {
    let height = ui.available_height();
    answer_panel::answer_ui(ui, view, height);
}

/// A strip of the page over the width that is left, of a height that does not depend on what is in it.
fn row_ui(ui: &mut Ui, view: &mut View<'_>, salt: &str, height: f32, content: impl FnOnce(&mut Ui, &mut View<'_>)) {
    let panel = Panel::top(salt).resizable(false).exact_size(height).show_separator_line(false);
    panel.frame(Frame::new().inner_margin(Side::Top.gap())).show(ui, |ui| {
        ui.set_min_size(ui.available_size());
        content(ui, view);
    });
}

/// The desk: the band beside the verdict, below them what else was seen beside the control's window, then the history.
fn desk_ui(ui: &mut Ui, view: &mut View<'_>, least: f32) {
    let sizes = asked_sizes(ui, view, space(68.0), least + space(90.0));
    panel_ui(ui, view, Side::Left, "check-asked", sizes, asked_ui);
    let welcomes = view.session.welcomes();
    let width = ui.available_width();
    let verdict = least.max((width * 0.35).min(space(78.0)));
    let sizes = (verdict, least..=(width * 0.6).max(least));
    let row = row_of_verdict(ui, view, "check-verdict", (verdict, sizes.1.clone())).max(space(VERDICT) + space(3.0));
    // Rows of the history give way before the control's window does, and stay where they are when a usual result comes.
    let answer = answer_panel::usual_height_in(ui, view, verdict - f32::from(GAP)) + f32::from(GAP);
    let status = status_panel::usual_height(ui) + close_frame(ui).total_margin().sum().y;
    history_below_ui(ui, view, row.max(answer) + status);
    let size = ui.available_size();
    if row + space(LEAST_BELOW) < size.y {
        if welcomes {
            row_ui(ui, view, "check-answer", row, |ui, view| {
                area_ui(ui, view, Side::Right, "check-verdict", sizes.clone(), verdict_ui);
                rest_ui(ui, view, band_card_ui);
            });
            return first_panel::first_ui(ui, view);
        }
        area_ui(ui, view, Side::Right, "check-verdict", sizes, |ui, view| {
            row_ui(ui, view, "check-verdict-row", row, verdict_ui);
            close_card_ui(ui, |ui| status_card_ui(ui, view));
        });
        // A verdict that has more to say takes its room from what is below it: the band stays where it was.
        row_ui(ui, view, "check-band-row", space(VERDICT) + space(3.0), |ui, view| rest_ui(ui, view, band_card_ui));
        rest_ui(ui, view, seen_ui);
    } else {
        // Too low for two rows: the window of the control scrolls below the verdict.
        area_ui(ui, view, Side::Right, "check-verdict", sizes, |ui, view| {
            let height = (ui.available_height() * 0.66).min(space(VERDICT));
            answer_panel::answer_ui(ui, view, height);
            ui.add_space(space(1.0));
            rest_ui(ui, view, |ui, view| {
                column_ui(ui, "check-status-low", |ui| {
                    if welcomes {
                        first_panel::ways_ui(ui, view);
                        ui.separator();
                    }
                    status_ui(ui, view);
                    ui.separator();
                    of_height(ui, space(90.0), |ui| seen_ui(ui, view));
                });
            });
        });
        rest_ui(ui, view, band_card_ui);
    }
}

/// The height of the row in which the whole answer has room, in the panel of a name.
fn row_of_verdict(ui: &Ui, view: &View<'_>, salt: &str, sizes: (f32, RangeInclusive<f32>)) -> f32 {
    // As wide as the card will be: the words of a wider one are larger, those of a narrower one break.
    let width = kept_size(ui, salt, sizes) - f32::from(GAP);
    answer_panel::height_in(ui, view, width) + f32::from(GAP)
}

/// A wide window: what is asked, what is seen, and the answer over the history.
fn wide_ui(ui: &mut Ui, view: &mut View<'_>, least: f32) {
    if space(ULTRA_WIDE) <= ui.available_width() {
        let all = ui.available_width();
        let sizes = (all * 0.28, space(125.0)..=all * 0.45);
        panel_ui(ui, view, Side::Right, "history-beside", sizes, |ui, view| below_ui(ui, view, false));
        return columns_of_three_ui(ui, view, least, false);
    }
    columns_of_three_ui(ui, view, least, true);
}

/// Where the history has a column of its own, the control's window stands below the verdict.
fn columns_of_three_ui(ui: &mut Ui, view: &mut View<'_>, least: f32, has_history: bool) {
    let sizes = asked_sizes(ui, view, space(80.0), least + space(150.0));
    panel_ui(ui, view, Side::Left, "check-asked-wide", sizes, asked_ui);
    let answer = least.max(space(122.0));
    let most = (ui.available_width() - space(100.0)).max(answer);
    let row = row_of_verdict(ui, view, "check-answer-wide", (answer, least..=most));
    let row = space(94.0 + 3.0).min(ui.available_height() * 0.5).max(row);
    if view.session.welcomes() && has_history {
        row_ui(ui, view, "check-first-wide", row, |ui, view| {
            area_ui(ui, view, Side::Right, "check-answer-wide", (answer, least..=most), verdict_ui);
            rest_ui(ui, view, band_card_ui);
        });
        return first_panel::first_ui(ui, view);
    }
    area_ui(ui, view, Side::Right, "check-answer-wide", (answer, least..=most), |ui, view| {
        row_ui(ui, view, "check-verdict-wide", row, verdict_ui);
        if has_history {
            rest_ui(ui, view, |ui, view| below_ui(ui, view, false));
        } else {
            rest_ui(ui, view, status_card_ui);
        }
    });
    row_ui(ui, view, "check-band-wide", row, |ui, view| rest_ui(ui, view, band_card_ui));
    if has_history {
        let height = (space(64.0), space(40.0)..=ui.available_height() * 0.6);
        panel_ui(ui, view, Side::Bottom, "check-status-wide", height, status_card_ui);
    }
    rest_ui(ui, view, seen_ui);
}

/// Two columns: the verdict above the band, the rest below it.
fn narrow_ui(ui: &mut Ui, view: &mut View<'_>, least: f32) {
    history_below_ui(ui, view, 0.0);
    let sizes = asked_sizes(ui, view, space(65.0), least);
    panel_ui(ui, view, Side::Left, "check-asked", sizes, asked_ui);
    // The band below is whole: first the card takes less, then the track is lower.
    let band = band_plot::least_height(ui) + page_frame(ui).total_margin().sum().y;
    let most = ui.available_height() - band - space(1.0) - 2.0 * ui.spacing().item_spacing.y;
    let height = if is_low(ui) { ui.available_height() * 0.46 } else { space(50.0) };
    answer_panel::answer_within_ui(ui, view, height.min(most), most);
    ui.add_space(space(1.0));
    rest_ui(ui, view, |ui, view| {
        column_ui(ui, "check-rest", |ui| {
            if view.session.welcomes() {
                first_panel::ways_ui(ui, view);
                ui.separator();
            }
            of_height(ui, space(50.0).min(ui.available_height()), |ui| band_card_ui(ui, view));
            status_ui(ui, view);
            ui.separator();
            of_height(ui, space(90.0), |ui| seen_ui(ui, view));
        });
    });
}

/// One column, the verdict above it.
fn one_ui(ui: &mut Ui, view: &mut View<'_>) {
    history_below_ui(ui, view, 0.0);
    let top = Panel::top("check-verdict-one").resizable(false).show_separator_line(false);
    top.frame(Frame::new().inner_margin(Side::Top.gap())).show(ui, |ui| answer_panel::answer_ui(ui, view, 0.0));
    rest_ui(ui, view, |ui, view| {
        keypad_ui(ui, view);
        column_ui(ui, "check-all", |ui| {
            asked_or_correction_ui(ui, view);
            ui.separator();
            if view.session.welcomes() {
                first_panel::ways_ui(ui, view);
                ui.separator();
            }
            of_height(ui, space(50.0), |ui| band_card_ui(ui, view));
            status_ui(ui, view);
            ui.separator();
            of_height(ui, space(90.0), |ui| seen_ui(ui, view));
        });
    });
}

/// What is asked, or the form of a correction, as a part of a column.
fn asked_or_correction_ui(ui: &mut Ui, view: &mut View<'_>) {
    match view.session.records().correcting.as_ref() {
        Some(form) => correction_ui(ui, view, form),
        None => asked_panel::asked_panel_ui(ui, view, false),
    }
}

/// The history over the width of the page: a table, or one line that unfolds where the window is small. What stands `above` it
/// has its height first.
fn history_below_ui(ui: &mut Ui, view: &mut View<'_>, above: f32) {
    if view.session.welcomes() && view.session.history().is_empty() {
        return;
    }
    let size = ui.available_size();
    if view.session.check().shows_rows() {
        let share = if size.y < space(175.0) { 0.55 } else { 0.45 };
        let sizes = (size.y * share, space(50.0)..=(size.y * 0.7).max(space(50.0)));
        return panel_ui(ui, view, Side::Bottom, "check-rows", sizes, |ui, view| below_ui(ui, view, false));
    }
    let has_keypad = view.session.has_keypad() && size.y < space(230.0);
    let folded = has_keypad || size.x < space(150.0) || size.y < space(150.0);
    if folded && !history_panel::is_unfolded(ui) {
        note_list(ui, false);
        lean_bar_ui(ui, view, Side::Bottom, ("strip", 4), history_panel::strip_ui);
        return;
    }
    let share = if folded || size.x * 1.3 < size.y { 0.38 } else { 0.31 };
    let least = space(32.0);
    let usual = (size.y * share).min((size.y - above).max(least));
    let sizes = (usual, least..=(size.y * 0.6).max(least));
    panel_ui(ui, view, Side::Bottom, ("check-history", folded), sizes, |ui, view| {
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
fn tall_ui(ui: &mut Ui, view: &mut View<'_>, least: f32) {
    history_below_ui(ui, view, 0.0);
    let width = ui.available_width();
    let sizes = (least.max(width * 0.4), least..=least.max(width * 0.65));
    let row = row_of_verdict(ui, view, "check-tall-answer", sizes.clone()).max(space(VERDICT));
    row_ui(ui, view, "check-tall", row, |ui, view| {
        area_ui(ui, view, Side::Right, "check-tall-answer", sizes, verdict_ui);
        rest_ui(ui, view, band_card_ui);
    });
    let width = ui.available_width();
    panel_ui(ui, view, Side::Left, "check-tall-asked", (width * 0.42, width * 0.35..=width * 0.65), asked_ui);
    rest_ui(ui, view, |ui, view| {
        column_ui(ui, "check-tall-rest", |ui| {
            if view.session.welcomes() {
                first_panel::ways_ui(ui, view);
                ui.separator();
            }
            status_ui(ui, view);
            ui.separator();
            of_height(ui, ui.available_height().max(space(70.0)), |ui| seen_ui(ui, view));
        });
    });
}

fn band_card_ui(ui: &mut Ui, view: &mut View<'_>) {
    band_plot::band_ui(ui, view);
}

/// What stands below the verdict in a card of its own; it scrolls where there is no room, and its buttons stay in sight.
fn status_card_ui(ui: &mut Ui, view: &mut View<'_>) {
    let content = |ui: &mut Ui, view: &mut View<'_>| {
        rest_of_answer_ui(ui, view);
        status_panel::window_ui(ui, view);
    };
    footed_column_ui(ui, view, "check-status", content, status_panel::tools_ui);
}

/// The same where it is a part of a column.
fn status_ui(ui: &mut Ui, view: &mut View<'_>) {
    rest_of_answer_ui(ui, view);
    status_panel::status_ui(ui, view);
}

/// What the row of a large file says, and what the verdict's card has no room for.
fn rest_of_answer_ui(ui: &mut Ui, view: &mut View<'_>) {
    rows_panel::shown_row_ui(ui, view);
    answer_panel::rest_of_card_ui(ui, view);
}

/// An imported lot, and what was measured.
fn seen_ui(ui: &mut Ui, view: &mut View<'_>) {
    if let Some(lot) = view.session.check().lot.as_ref() {
        // What was not judged is never cut off: it scrolls.
        return column_ui(ui, "check-lot", |ui| {
            answer_panel::lot_ui(ui, view, lot);
            of_height(ui, space(50.0), |ui| values_ui(ui, view));
        });
    }
    values_ui(ui, view);
}

/// The contacts, or the last values where no contacts are known, or both where there is room.
fn values_ui(ui: &mut Ui, view: &View<'_>) {
    let width = ui.available_width();
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
