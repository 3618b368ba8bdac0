//! Rules of control charts that have fired: which, since which part, and the form for cause and action. No verdict is told here.

use eframe::egui::{Button, Ui, vec2};

use crate::gui::field::{FieldStyle, error_ui, field_ui};
use crate::gui::theme::{self, control, space};
use crate::gui::view::{View, heading, one_of_ui, quiet};
use crate::message::message;
use crate::session::parts::{OpenAlarm, WalkCommand, choices};
use crate::session::{Field, PartsAction, WalkField};

/// So many open alarms are shown.
const MOST: usize = 6;

/// The open alarms, the oldest first; nothing where there is none.
pub(in crate::gui) fn alarms_ui(ui: &mut Ui, view: &mut View<'_>) {
    let open = view.session.parts().alarms.open();
    if open.is_empty() {
        return;
    }
    ui.separator();
    heading(ui, view.words.say(&message!("walk-page-alarms").count("count", open.len())));
    for (at, alarm) in open.iter().enumerate().take(MOST) {
        ui.add_space(space(1.0));
        ui.label(view.words.say(&alarm.message()));
        // What fired at one value is answered once, below all of it.
        if !open.get(at + 1).is_some_and(|next| next.is_with(alarm)) {
            alarm_ui(ui, view, alarm);
        }
    }
    let more = open.len().saturating_sub(MOST);
    if 0 < more {
        quiet(ui, view.words.say(&message!("walk-page-alarms-more").count("count", more)));
    }
}

fn alarm_ui(ui: &mut Ui, view: &mut View<'_>, alarm: &OpenAlarm) {
    if view.session.parts().answered_alarm().is_some_and(|answered| answered.is_with(alarm)) {
        return answer_ui(ui, view);
    }
    let name = view.words.say(&message!("walk-page-alarm-ask-of").text("name", alarm.name()));
    let button = Button::new(name).wrap().min_size(vec2(ui.available_width(), control(ui)));
    if theme::looking(ui, theme::tonal, |ui| ui.add(button)).clicked() {
        view.send(WalkCommand::AskAlarm(alarm.head.number));
    }
}

/// Cause and action, each from the shop's own list or in other words.
fn answer_ui(ui: &mut Ui, view: &mut View<'_>) {
    for (field, id, list) in [
        (WalkField::Cause, "walk-page-alarm-cause", "walk-page-alarm-causes"),
        (WalkField::Action, "walk-page-alarm-action", "walk-page-alarm-actions"),
    ] {
        let name = ui.label(view.text(id));
        let now = view.session.text(field).to_owned();
        let entries = choices(view.words, list).into_iter().map(|text| (text.clone(), text));
        let width = ui.available_width();
        let (chosen, button) = one_of_ui(ui, list, width, &now, entries);
        button.labelled_by(name.id);
        if let Some(text) = chosen {
            view.send(Field::from(field).typed(text));
        }
        field_ui(ui, view, field, name.id, FieldStyle::text(width));
        error_ui(ui, view, field);
    }
    ui.horizontal_wrapped(|ui| {
        for action in [PartsAction::AnswerAlarm, PartsAction::LeaveAlarm] {
            view.field_button(ui, action);
        }
    });
}
