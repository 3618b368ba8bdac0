//! The list of notices: what happened, and what can be done about it. The oldest one is shown until it is closed.

use eframe::egui::{Align2, Button, ScrollArea, Ui, vec2};

use super::over_page::fixed_window;
use super::theme::{control, sizes, space};
use super::view::{View, problem, quiet};
use crate::session::{Notice, WindowAction};
use crate::text::Within as _;

pub(super) fn notices_ui(ui: &Ui, view: &mut View<'_>) {
    let Some(notice) = view.session.notices().first().cloned() else { return };
    let title = view.text(if notice.is_problem { "notice-problem" } else { "notice" });
    fixed_window("notice", title, Align2::CENTER_BOTTOM, -space(46.0)).show(ui, |ui| notice_ui(ui, view, &notice));
}

fn notice_ui(ui: &mut Ui, view: &mut View<'_>, notice: &Notice) {
    ui.set_max_width(space(150.0));
    let text = view.words.say(&notice.message);
    if notice.is_problem {
        problem(ui, text)
    } else {
        ui.label(text)
    };
    if !notice.details.is_empty() {
        ScrollArea::vertical().max_height(space(60.0)).show_rows(
            ui,
            sizes().body + 4.0,
            notice.details.len(),
            |ui, rows| {
                for detail in notice.details.within(rows) {
                    quiet(ui, view.words.say(detail));
                }
            },
        );
    }
    ui.horizontal_wrapped(|ui| {
        // Only what undo would take back now: other changes may have followed.
        if notice.change.is_some() && notice.change == view.session.history().last_change() {
            let undo = Button::new(view.text("undo")).min_size(vec2(space(24.0), control(ui)));
            view.button_as(ui, WindowAction::Undo, undo);
        }
        if notice.records {
            view.wide_button(ui, WindowAction::RecordAgain);
        }
        let of_columns = notice.columns.iter().flat_map(|columns| {
            let forget = columns.shape.is_some().then_some(WindowAction::ForgetColumns);
            std::iter::once(WindowAction::CorrectColumns).chain(forget)
        });
        for action in of_columns {
            view.field_button(ui, action);
        }
        let of_file =
            [WindowAction::OpenWritten, WindowAction::ShowWritten].into_iter().filter(|_| notice.file.is_some());
        for action in of_file.chain([WindowAction::Close]) {
            view.wide_button(ui, action);
        }
    });
}
