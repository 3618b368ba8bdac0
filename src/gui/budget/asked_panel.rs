//! Left, below the text: what the budget is evaluated for. Only what it asks for is shown.

use eframe::egui::Ui;

use crate::gui::field::pairs_ui;
use crate::gui::view::{View, heading, quiet};
use crate::message::message;
use crate::session::{BudgetAction, BudgetField, Readings};

/// How many notes on readings are shown; a notice had all of them.
const NOTES: usize = 5;

/// Size, contacts, readings, day.
pub(super) fn asked_ui(ui: &mut Ui, view: &mut View<'_>) {
    let asks = view.session.budget().asks;
    if view.session.budget().read.is_none() {
        return;
    }
    ui.separator();
    heading(ui, view.text("budget-page-for"));
    let size = (BudgetField::Size.into(), view.text("budget-page-size"), "mm");
    let day = (BudgetField::Day.into(), view.text("budget-page-day"), "");
    let fields = if asks.size { vec![size, day] } else { vec![day] };
    pairs_ui(ui, view, &fields);
    if view.session.text(BudgetField::Day).trim().is_empty() {
        let today = view.session.budget().day_shown();
        quiet(ui, view.words.say(&message!("budget-page-day-hint").text("day", today)));
    }
    if asks.contacts {
        contacts_ui(ui, view);
    }
    if asks.readings {
        readings_ui(ui, view);
    }
}

fn contacts_ui(ui: &mut Ui, view: &mut View<'_>) {
    heading(ui, view.text("budget-page-contacts"));
    let fields = [
        (BudgetField::Touches.into(), view.text("budget-page-touches"), ""),
        (BudgetField::Step.into(), view.text("budget-page-step"), "°"),
    ];
    pairs_ui(ui, view, &fields);
    match view.session.budget().contacts.as_ref() {
        Some(taken) => quiet(ui, view.words.say(&taken.of)),
        None => quiet(ui, view.text("budget-page-contacts-hint")),
    };
    buttons_ui(ui, view, &[BudgetAction::ContactsOfCheck, BudgetAction::ContactsRecorded, BudgetAction::OwnContacts]);
}

fn readings_ui(ui: &mut Ui, view: &mut View<'_>) {
    heading(ui, view.text("budget-page-readings"));
    if let Some(Readings { from, notes, .. }) = view.session.budget().readings.as_ref() {
        ui.label(view.words.say(from));
        for note in notes.iter().take(NOTES) {
            quiet(ui, view.words.say(note));
        }
        if let Some(more) = notes.len().checked_sub(NOTES).filter(|more| 0 < *more) {
            quiet(ui, view.words.say(&message!("budget-page-more-notes").count("count", more)));
        }
    } else {
        let count = view.session.budget().own_readings();
        ui.label(view.words.say(&message!("budget-page-readings-own").count("count", count)));
    }
    buttons_ui(ui, view, &[BudgetAction::OpenReadings, BudgetAction::TakeReadings, BudgetAction::OwnReadings]);
}

fn buttons_ui(ui: &mut Ui, view: &mut View<'_>, actions: &[BudgetAction]) {
    ui.horizontal_wrapped(|ui| {
        for action in actions {
            view.field_button(ui, *action);
        }
    });
}
