//! The form of a correction: what the record should say, and why. The old entry stays.

use eframe::egui::{Ui, vec2};

use crate::gui::field::{FieldStyle, error_ui, field_ui};
use crate::gui::theme::{control, space};
use crate::gui::view::{View, heading, problem, quiet};
use crate::message::message;
use crate::session::RecordsField;
use crate::session::records::Correcting;
use crate::session::{RecordsAction, WindowAction};

pub(super) fn correction_ui(ui: &mut Ui, view: &mut View<'_>, form: &Correcting) {
    heading(ui, view.text("records-page-correction"));
    quiet(ui, view.text("records-page-correction-hint"));
    view.checkbox(ui, RecordsAction::WithdrawRecord);
    if let Some(number) = view.session.records().corrects().filter(|_| form.withdraws) {
        quiet(ui, view.words.say(&message!("records-page-withdraw-neither").text("number", number.to_string())));
    }
    field(ui, view, RecordsField::Reason, "records-page-reason");
    if !form.withdraws {
        for (of, name) in [
            (RecordsField::Part, "head-part"),
            (RecordsField::Serial, "records-page-serial"),
            (RecordsField::Feature, "records-page-feature"),
            (RecordsField::Measurer, "records-page-who"),
            (RecordsField::Remark, "records-page-remark"),
        ] {
            field(ui, view, of, name);
        }
        if view.session.records().typed_value().is_some() {
            field(ui, view, RecordsField::Measured, "records-page-typed");
        }
    }
    if let Some(why) = &form.problem {
        problem(ui, view.words.say(why));
    }
    ui.horizontal_wrapped(|ui| {
        let width = view.width_of(ui, &[RecordsAction::SendCorrection]);
        view.main_button(ui, RecordsAction::SendCorrection, vec2(width, control(ui)));
        view.field_button(ui, RecordsAction::LeaveCorrection);
        if form.problem.is_some() && view.session.can(WindowAction::RecordAgain) {
            view.field_button(ui, WindowAction::RecordAgain);
        } else if form.run.is_some() {
            quiet(ui, view.text("records-page-waiting"));
        }
    });
    ui.add_space(space(1.0));
    ui.separator();
}

fn field(ui: &mut Ui, view: &mut View<'_>, field: RecordsField, name: &str) {
    let name = quiet(ui, view.text(name));
    let look = FieldStyle::text(ui.available_width());
    field_ui(ui, view, field, name.id, look);
    error_ui(ui, view, field);
}
