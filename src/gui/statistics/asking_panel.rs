//! Above: which records, how many values, what was read.

use eframe::egui::Ui;

use crate::gui::field::{FieldStyle, error_ui, field_ui};
use crate::gui::theme::space;
use crate::gui::top_bar::folded_sides_ui;
use crate::gui::view::{View, keep_focus, one_of_ui, problem, quiet};
use crate::message::message;
use crate::session::{StatisticsAction, StatisticsCommand, StatisticsField};

pub(super) fn asking_ui(ui: &mut Ui, view: &mut View<'_>) {
    ui.spacing_mut().item_spacing.y = space(1.0);
    folded_sides_ui(ui, view);
    ui.horizontal_wrapped(|ui| {
        parts_ui(ui, view);
        let name = ui.label(view.text("statistics-page-question"));
        let width = (ui.available_width() - space(4.0)).clamp(space(30.0), space(70.0));
        let asked = field_ui(ui, view, StatisticsField::Question, name.id, FieldStyle::text(width));
        asked.on_hover_text(view.text("statistics-page-question-hint"));
        let name = ui.label(view.text("statistics-page-last"));
        field_ui(ui, view, StatisticsField::Last, name.id, FieldStyle::number(space(16.0)));
        read_ui(ui, view);
        if !view.session.parts().alarms.open().is_empty() {
            view.field_button(ui, StatisticsAction::ShowAlarms);
        }
    });
    for field in [StatisticsField::Question, StatisticsField::Last] {
        error_ui(ui, view, field);
    }
}

/// One of the parts that were found so far, or all.
fn parts_ui(ui: &mut Ui, view: &mut View<'_>) {
    let page = view.session.statistics();
    let all = (None, view.text("statistics-page-all-parts"));
    let parts = page.parts().map(|part| (Some(part.to_owned()), part.to_owned()));
    let name = quiet(ui, view.text("statistics-page-part"));
    let entries = std::iter::once(all).chain(parts);
    let (part, list) = one_of_ui(ui, "statistics-part", space(36.0), &page.part().map(str::to_owned), entries);
    keep_focus(ui, &list);
    list.labelled_by(name.id);
    if let Some(part) = part {
        view.send(StatisticsCommand::TakePart(part));
    }
}

/// What was read, before anything is said of it.
fn read_ui(ui: &mut Ui, view: &View<'_>) {
    let page = view.session.statistics();
    if page.is_working() {
        quiet(ui, view.text("statistics-page-reading"));
    } else if let Some(said) = page.read_text(view.words) {
        quiet(ui, said);
    }
    if let Some(said) = page.aside_text(view.words) {
        quiet(ui, said);
    }
    if let Some(why) = page.problem.as_ref().filter(|_| page.open().is_some()) {
        problem(ui, view.words.say(&message!("statistics-page-not-read").message("why", why.clone())));
    }
}
