//! The part that is measured, feature by feature.
//!
//! | file | what |
//! |---|---|
//! | here | the view in columns |
//! | `asked_panel` | left: the plan and the serial number; then the size that is asked for and its value |
//! | `skip_panel` | why a size is left out |
//! | `sizes_list` | every size with its verdict: below what is asked, or in the middle where that has no picture |
//! | `seen_panel` | middle: the picture over the limit band |
//! | `answer_panel` | right: the verdict of the value |
//! | `part_panel` | right, below: the values of the size, what they make of the part, and what is to do |
//! | `alarms_panel` | below it: rules of control charts that have fired, and the answers to them |
//! | `watch_panel` | below it: the watched folder |

mod alarms_panel;
mod answer_panel;
mod asked_panel;
mod part_panel;
mod seen_panel;
mod sizes_list;
mod skip_panel;
mod watch_panel;

use eframe::egui::{Event, Popup, Ui};

use crate::session::WalkField;
pub(in crate::gui) use alarms_panel::alarms_ui;
pub(in crate::gui) use answer_panel::{headline_card, question_ui as value_question_ui, recorded_of, value_card};
#[cfg(test)]
pub(in crate::gui) use sizes_list::COLUMNS as SIZES;
pub(in crate::gui) use sizes_list::{id as sizes_id, sizes_ui as features_ui};
pub(in crate::gui) use skip_panel::skip_ui;

use crate::gui::columns::{Page, Shape, THREE, columns_ui, of_height, scaled};
use crate::gui::theme::space;
use crate::gui::top_bar::{has_sides, sides_ui};
use crate::gui::verdict_card::least_width;
use crate::gui::view::View;
use crate::gui::{field, in_turn, keypad};
use crate::part::Size;
use crate::session::parts::WalkCommand;
use crate::words::Words;

/// From this width on the columns are wider.
const WIDE: f32 = 400.0;

/// Around what is in the left card: the gap beside it, its margins and the bar.
const AROUND: f32 = 15.0;

/// The least height of the list below what is asked, steps of space.
const LIST: f32 = 36.0;

/// What a size asks for: its callout, or the deviations of a point.
pub(in crate::gui) fn asked_text(words: &Words, size: &Size<'_>) -> String {
    let deviations = &size.limits.deviations;
    if size.callout.is_none() && deviations.upper() == deviations.lower().negated() {
        return format!("±{} µm", words.um(deviations.upper()));
    }
    let of_point = || format!("{} / {} µm", words.signed_um(deviations.upper()), words.signed_um(deviations.lower()));
    size.callout.map_or_else(of_point, |callout| callout.to_string())
}

/// Whether the part that is measured has a picture.
pub(in crate::gui) fn has_picture(view: &View<'_>) -> bool {
    let parts = view.session.parts();
    parts.walking.is_begun() && parts.walk_sight().is_some()
}

/// What is asked, and below it the sizes in the room that is left.
fn asked_over_sizes_ui(ui: &mut Ui, view: &mut View<'_>) {
    asked_panel::asked_ui(ui, view);
    ui.separator();
    let left = ui.clip_rect().height() - ui.min_rect().height() - space(5.0);
    of_height(ui, left.max(space(LIST)), |ui| sizes_list::sizes_ui(ui, view));
}

/// What a scanner or gauge types while no field has the focus goes into the field of the serial number or of the value.
pub(in crate::gui) fn catch_typing(ui: &Ui, view: &mut View<'_>) {
    let session = view.session;
    let walking = &session.parts().walking;
    let field = if walking.is_begun() { WalkField::Value } else { WalkField::Serial };
    let is_other = walking.is_skipping || session.dialog().is_some() || Popup::is_any_open(ui.ctx());
    let is_text = |event: &Event| matches!(event, Event::Text(text) if !text.trim().is_empty());
    if is_other || ui.ctx().text_edit_focused() || !ui.input(|input| input.events.iter().any(is_text)) {
        return;
    }
    let begins_next = |event: &Event| matches!(event, Event::Text(text) if walking.begins_next(text));
    if ui.input(|input| input.events.iter().any(begins_next)) {
        // The part is done: it is the serial number of the next one, whose field is drawn in the next frame.
        view.send(WalkCommand::Next);
        in_turn::give_back(ui, is_text);
    } else {
        field::go_to(ui.ctx(), session, field.into());
        // The next letter does not replace this one.
        keypad::keep_selection(ui.ctx(), field::id(field));
    }
}

pub(super) fn walk_ui(ui: &mut Ui, view: &mut View<'_>) {
    catch_typing(ui, view);
    let is_wide = space(WIDE) <= ui.available_width();
    let least = least_width(ui, view);
    let left = if is_wide { space(85.0) } else { space(82.0) };
    // Names that have no room beside their values stand below the picture.
    let names = || sizes_list::has_room(ui, &view.session.parts().walking, scaled(ui, left) - space(AROUND));
    let is_picture = Shape::of(ui, least, THREE) == Shape::Three && has_picture(view) && names();
    let page = Page {
        // Another size of window has widths of its own.
        name: if is_wide { "walk-wide" } else { "walk" },
        left,
        right: if is_wide { space(105.0) } else { space(88.0) },
        three: THREE,
        head: (!has_sides(ui)).then_some(sides_ui),
        asked: if is_picture { asked_over_sizes_ui } else { asked_panel::asked_ui },
        seen: if is_picture { seen_panel::picture_ui } else { seen_panel::list_ui },
        seen_height: if has_picture(view) { space(150.0) } else { space(90.0) },
        verdict: answer_panel::verdict_ui,
        least,
        answer: |ui, view| {
            answer_panel::answer_ui(ui, view);
            alarms_panel::alarms_ui(ui, view);
            watch_panel::watch_ui(ui, view);
        },
    };
    columns_ui(ui, view, &page);
}
