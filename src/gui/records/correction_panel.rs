//! The form of a correction, for the records page and the check page: what the record should say, and why. The old entry stays.

use eframe::egui::{Button, Label, RichText, Ui, vec2};

use crate::gui::columns::footed_column_ui;
use crate::gui::field::{FieldStyle, error_ui, field_ui};
use crate::gui::limits::{feature_id, limits_text, source_ui};
use crate::gui::section::Section;
use crate::gui::theme::{self, Icon, control, sizes, space};
use crate::gui::view::{View, heading, problem, quiet, quiet_height};
use crate::journal::Record;
use crate::message::message;
use crate::session::records::Correcting;
use crate::session::{Field, RecordsAction, RecordsCommand, RecordsField, WindowAction};
use crate::tolerance::Feature;

/// Reasons that most corrections have.
const REASONS: [&str; 3] =
    ["records-page-reason-mistyped", "records-page-reason-wrong-part", "records-page-reason-trial"];

/// The form as a card of its own: it scrolls, and the button that records stays in sight.
pub(in crate::gui) fn correction_card_ui(ui: &mut Ui, view: &mut View<'_>, form: &Correcting) {
    let content = |ui: &mut Ui, view: &mut View<'_>| {
        fields_ui(ui, view, form);
        more_ui(ui, view, form);
    };
    footed_column_ui(ui, view, "correction", content, |ui, view| send_ui(ui, view, form));
}

/// The form above other things.
pub(in crate::gui) fn correction_ui(ui: &mut Ui, view: &mut View<'_>, form: &Correcting) {
    fields_ui(ui, view, form);
    send_ui(ui, view, form);
    more_ui(ui, view, form);
    ui.add_space(space(1.0));
    ui.separator();
}

/// What the record should say, and why.
fn fields_ui(ui: &mut Ui, view: &mut View<'_>, form: &Correcting) {
    let page = view.session.records();
    let number = page.open.as_ref().map_or(0, |open| open.number);
    heading(ui, view.words.say(&message!("records-page-correction").text("number", number)));
    let hint = if form.withdraws { "records-page-withdrawal-hint" } else { "records-page-correction-hint" };
    quiet(ui, view.text(hint));
    if !form.withdraws {
        if page.typed_value().is_some() {
            value_ui(ui, view);
        }
        if let Some(record) = page.opened_size() {
            callout_ui(ui, view, form);
            judged_ui(ui, view, record, number);
        }
    }
    let reason = quiet(ui, view.text("records-page-reason"));
    let width = ui.available_width();
    field_ui(ui, view, RecordsField::Reason, reason.id, FieldStyle::text(width));
    // Its room is kept: a second click hits what the first one did.
    let room = quiet_height(ui, &view.text("records-page-no-reason"), width);
    ui.allocate_ui(vec2(width, room), |ui| {
        ui.set_min_size(vec2(width, room));
        error_ui(ui, view, RecordsField::Reason);
    });
    ui.horizontal_wrapped(|ui| {
        for reason in REASONS {
            let text = view.text(reason);
            if ui.add(Button::new(&text).min_size(vec2(0.0, control(ui)))).clicked() {
                view.send(Field::from(RecordsField::Reason).typed(text));
            }
        }
    });
}

/// What is wrong, and the buttons.
fn send_ui(ui: &mut Ui, view: &mut View<'_>, form: &Correcting) {
    if let Some(why) = &form.problem {
        problem(ui, view.words.say(why));
    }
    ui.add_space(space(0.5));
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
}

/// What is rarely corrected, and whether nothing takes the place of the record.
fn more_ui(ui: &mut Ui, view: &mut View<'_>, form: &Correcting) {
    if !form.withdraws {
        rest_ui(ui, view);
    }
    view.checkbox(ui, RecordsAction::WithdrawRecord);
    if let Some(number) = view.session.records().corrects().filter(|_| form.withdraws) {
        quiet(ui, view.words.say(&message!("records-page-withdraw-neither").text("number", number.to_string())));
    }
}

/// The value as it should have been typed.
fn value_ui(ui: &mut Ui, view: &mut View<'_>) {
    let name = quiet(ui, view.text("measured-value"));
    let style = FieldStyle::value(ui, ui.available_width()).unit("mm");
    field_ui(ui, view, RecordsField::Measured, name.id, style);
    error_ui(ui, view, RecordsField::Measured);
}

/// What it was measured against: the callout, hole or shaft where that does not say it, and its limits.
fn callout_ui(ui: &mut Ui, view: &mut View<'_>, form: &Correcting) {
    let name = quiet(ui, view.text("callout"));
    let style = FieldStyle::callout(ui);
    field_ui(ui, view, RecordsField::Callout, name.id, style);
    error_ui(ui, view, RecordsField::Callout);
    if view.session.records().corrected_callout().is_some_and(|callout| callout.feature().is_none()) {
        ui.horizontal(|ui| {
            for feature in [Feature::Hole, Feature::Shaft] {
                if ui.radio(form.feature == Some(feature), view.text(feature_id(Some(feature)))).clicked() {
                    view.send(RecordsCommand::ChooseFeature(feature));
                }
            }
        });
    }
    if let Some((_, limits)) = &form.asked {
        quiet(ui, limits_text(view.words, limits));
        source_ui(ui, view, limits);
    }
}

/// What the verdict is computed anew by: what the record was judged by.
fn judged_ui(ui: &mut Ui, view: &View<'_>, record: &Record, number: u64) {
    let said = message!("records-page-correction-rule").text("number", number);
    let said = said.text("rule", view.words.say(&record.verdict.rule.rounded_message()));
    let mut said = view.words.say(&said);
    if let Some(correction) = record.correction {
        let temperature = view.words.number(&correction.part.temperature.to_string());
        let corrected = message!("records-page-correction-temperature").text("temperature", temperature);
        said = format!("{said} {}", view.words.say(&corrected));
    }
    ui.add(Label::new(RichText::new(said).font(theme::font(sizes().small))).wrap());
}

/// What else the record should say, folded away.
fn rest_ui(ui: &mut Ui, view: &mut View<'_>) {
    let fields = [
        (RecordsField::Part, "head-part"),
        (RecordsField::Serial, "records-page-serial"),
        (RecordsField::Feature, "records-page-feature"),
        (RecordsField::Measurer, "records-page-who"),
        (RecordsField::Remark, "records-page-remark"),
    ];
    let said = fields.map(|(field, _)| view.session.text(field).trim());
    let value = said.into_iter().filter(|text| !text.is_empty()).collect::<Vec<_>>().join(", ");
    // A long remark is read in its field.
    let value = if value.chars().count() <= 40 { value } else { String::new() };
    let is_wrong = fields.iter().any(|(field, _)| view.session.error(*field).is_some());
    let section = Section { icon: Icon::NotePencil, name: "records-page-correction-rest", value, is_wrong };
    section.show(ui, view, |ui, view| {
        for (field, name) in fields {
            let name = quiet(ui, view.text(name));
            let width = ui.available_width();
            field_ui(ui, view, field, name.id, FieldStyle::text(width));
            error_ui(ui, view, field);
        }
    });
}
