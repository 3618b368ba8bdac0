//! The list of notices: what happened, and what can be done about it. The oldest one is shown in the corner: what asks for a look until
//! it is closed, anything else for some seconds.

use std::time::Duration;

use eframe::egui::{Align2, Button, Id, ScrollArea, Ui, vec2};

use super::over_page::fixed_window;
use super::theme::{control, sizes, space};
use super::view::{View, problem, quiet};
use crate::session::{Command, Notice, WindowAction};
use crate::text::Within as _;

pub(super) fn notices_ui(ui: &Ui, view: &mut View<'_>) {
    let Some(notice) = view.session.notices().first().cloned() else { return };
    let title = view.text(if notice.is_problem { "notice-problem" } else { "notice" });
    let from = vec2(-space(5.0), -space(5.0));
    let shown = fixed_window("notice", title, Align2::RIGHT_BOTTOM, from).title_bar(notice.is_problem);
    let shown = shown.show(ui, |ui| notice_ui(ui, view, &notice));
    let is_looked_at = shown.is_some_and(|shown| shown.response.contains_pointer());
    ui.data_mut(|data| data.insert_temp(looked_at_id(), is_looked_at));
}

fn looked_at_id() -> Id {
    Id::unique("notice-looked-at")
}

/// Whether somebody has to look at it: a problem, what was skipped or assumed, or a choice that it offers.
const fn asks(notice: &Notice) -> bool {
    notice.is_problem || notice.records || notice.columns.is_some() || !notice.details.is_empty()
}

/// Closes a notice that asks for nothing once it has been there for some seconds, unless somebody is at its buttons or something lies over it.
pub(super) fn leave_in_time(ui: &Ui, view: &mut View<'_>, stays: f64) {
    let session = view.session;
    let is_covered = session.is_leaving()
        || session.asks_about().is_some()
        || session.dialog().is_some()
        || session.open_columns().is_some()
        || session.working().is_some()
        || session.palette.is_some();
    let notice = session.notices().first().filter(|notice| !asks(notice) && !is_covered);
    let is_looked_at = ui.data(|data| data.get_temp(looked_at_id())) == Some(true);
    let Some(notice) = notice.filter(|_| !is_looked_at) else { return };
    let now = ui.input(|input| input.time);
    let id = Id::unique("notice-since");
    let this = (session.notices().len(), view.words.say(&notice.message));
    let kept: Option<(f64, (usize, String))> = ui.data(|data| data.get_temp(id));
    let since = match kept {
        Some((since, which)) if which == this => since,
        _ => {
            ui.data_mut(|data| data.insert_temp(id, (now, this)));
            now
        }
    };
    let left = since + stays - now;
    if left <= 0.0 {
        view.send(Command::Close);
    } else {
        ui.ctx().request_repaint_after(Duration::from_secs_f64(left));
    }
}

fn notice_ui(ui: &mut Ui, view: &mut View<'_>, notice: &Notice) {
    ui.set_max_width(space(150.0));
    let text = view.words.say(&notice.message);
    if notice.is_problem {
        problem(ui, text);
    } else {
        ui.label(text);
    }
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
