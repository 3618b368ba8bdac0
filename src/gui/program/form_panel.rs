//! Left: the inputs of 8255, what is measured, and program and native answer side by side.

use eframe::egui::accesskit::{Live, Role};
use eframe::egui::{Button, ComboBox, Grid, RichText, Sense, Ui, WidgetInfo, vec2};

use crate::gui::field::{Look, error_ui, field_ui};
use crate::gui::shapes;
use crate::gui::theme::{self, palette, sizes, space};
use crate::gui::verdict_card::status_id;
use crate::gui::view::{View, heading, problem, quiet};
use crate::message::{Message, Say as _};
use crate::session::program::{Agreement, Input, Run, WorkpieceFrom};
use crate::session::{Action, ProgramCommand, ProgramField};
use crate::verdict::Status;

/// The panel's content.
pub(super) fn form_ui(ui: &mut Ui, view: &mut View<'_>) {
    if view.session.program().has_inputs() {
        inputs_ui(ui, view);
        ui.separator();
        native_ui(ui, view);
        ui.separator();
    }
    workpiece_ui(ui, view);
}

const fn input_id(input: Input) -> &'static str {
    match input {
        Input::Size => "nominal-size",
        Input::Class => "tolerance-class",
        Input::CentreX => "centre-x",
        Input::CentreY => "centre-y",
        Input::Height => "height-z",
        Input::Angle => "first-contact",
        Input::Clearance => "clearance",
    }
}

/// Two fields a row, each with its parameter and name above it; errors below.
fn inputs_ui(ui: &mut Ui, view: &mut View<'_>) {
    heading(ui, view.text("program-page-inputs"));
    let inputs: Vec<_> = view.session.program().inputs().collect();
    for pair in inputs.chunks(2) {
        let fields = pair.iter().map(|input| {
            let name = format!("{} {}", input.parameter(), view.text(input_id(*input)));
            (ProgramField::Input(*input), name, input.unit())
        });
        pair_ui(ui, view, &fields.collect::<Vec<_>>());
    }
}

fn pair_ui(ui: &mut Ui, view: &mut View<'_>, fields: &[(ProgramField, String, &str)]) {
    let width = (ui.available_width() - space(2.0)) / 2.0;
    let grid = Grid::new(("program-fields", fields.first().map(|(field, ..)| *field)));
    grid.num_columns(2).min_row_height(0.0).min_col_width(width).spacing(vec2(space(2.0), space(0.5))).show(ui, |ui| {
        let names: Vec<_> = fields.iter().map(|(_, name, _)| quiet(ui, name).id).collect();
        ui.end_row();
        for ((field, _, unit), name) in fields.iter().zip(names) {
            ui.horizontal(|ui| {
                let room = if unit.is_empty() { 0.0 } else { space(9.0) };
                field_ui(ui, view, *field, name, Look::number(width - room - space(2.0)));
                if !unit.is_empty() {
                    quiet(ui, *unit);
                }
            });
        }
        ui.end_row();
    });
    for (field, ..) in fields {
        error_ui(ui, view, *field);
    }
}

/// Fitcheck's own limits and verdict, the program's beside them, and whether they agree.
fn native_ui(ui: &mut Ui, view: &View<'_>) {
    heading(ui, view.text("program-page-answers"));
    let session = view.session;
    let limits = match session.program().limits(session.sources()) {
        Some(Ok(limits)) => Some(limits),
        Some(Err(error)) => {
            problem(ui, view.words.say(&error));
            None
        }
        None => {
            quiet(ui, view.text("program-page-no-limits"));
            return;
        }
    };
    let run = session.program().run();
    let dash = || "–".to_owned();
    let theirs = |number: u16| {
        let length = run.and_then(|run| run.length(crate::control::variables::Parameter::q(number)));
        length.map_or_else(dash, |length| view.words.mm(length, 3))
    };
    let word = |status: Option<Status>| status.map_or_else(dash, |status| view.text(status_id(Some(status))));
    let verdict = session.program().verdict(session.sources());
    let rows = [
        ("maximum", limits.as_ref().map_or_else(dash, |limits| view.words.mm(limits.maximum(), 3)), theirs(23)),
        ("minimum", limits.as_ref().map_or_else(dash, |limits| view.words.mm(limits.minimum(), 3)), theirs(33)),
        ("program-page-verdict", word(verdict.map(|(_, verdict)| verdict.status)), word(run.and_then(Run::status))),
    ];
    Grid::new("program-native").num_columns(3).min_row_height(0.0).spacing(vec2(space(4.0), 0.0)).show(ui, |ui| {
        quiet(ui, "");
        quiet(ui, "Fitcheck");
        quiet(ui, view.text("program-page-program"));
        ui.end_row();
        for (id, own, theirs) in rows {
            ui.label(view.text(id));
            ui.label(RichText::new(own).font(theme::bold(sizes().body)));
            ui.label(RichText::new(theirs).font(theme::bold(sizes().body)));
            ui.end_row();
        }
    });
    if let Some(limits) = &limits {
        quiet(ui, view.words.say(&Message::new("from-source").message("source", limits.source.message())));
    }
    agreement_ui(ui, view);
}

fn agreement_ui(ui: &mut Ui, view: &View<'_>) {
    let Some(agreement) = view.session.program().agreement(view.session.sources()) else { return };
    let (shape, said) = match agreement {
        Agreement::Agrees => (Some(Status::Good), view.text("program-page-agrees")),
        Agreement::BothRefuse => (None, view.text("program-page-both-refuse")),
        Agreement::Differs(differences) => {
            let differences: Vec<_> = differences.iter().map(|message| view.words.say(message)).collect();
            let message = Message::new("program-page-differs").text("what", differences.join("; "));
            (Some(Status::Scrap), view.words.say(&message))
        }
    };
    ui.horizontal_wrapped(|ui| {
        let palette = palette(ui.ctx());
        let (mark, _) = ui.allocate_exact_size(vec2(space(4.0), space(5.0)), Sense::hover());
        let colour = if shape == Some(Status::Scrap) { palette.error.0 } else { palette.text.0 };
        shapes::status(ui.painter(), mark, shape, colour);
        let label = ui.label(RichText::new(&said).font(theme::bold(sizes().body)));
        label.widget_info(|| WidgetInfo::labeled(Role::Status, true, &said));
        ui.ctx().accesskit_node_builder(label.id, |node| node.set_live(Live::Polite));
    });
}

const fn from_id(from: WorkpieceFrom, has_limits: bool) -> &'static str {
    match from {
        WorkpieceFrom::Perfect if !has_limits => "program-page-from-nominal",
        WorkpieceFrom::Perfect => "program-page-from-perfect",
        WorkpieceFrom::Given => "program-page-from-given",
        WorkpieceFrom::Simulated => "program-page-from-simulated",
        WorkpieceFrom::Recorded => "program-page-from-recorded",
    }
}

fn workpiece_ui(ui: &mut Ui, view: &mut View<'_>) {
    let name = heading(ui, view.text("program-page-workpiece"));
    let chosen = view.session.program().workpiece();
    let has_limits = view.session.program().has_inputs();
    let combo = ComboBox::from_id_salt("program-workpiece").selected_text(view.text(from_id(chosen, has_limits)));
    let response = combo.width(ui.available_width() - space(2.0)).truncate().show_ui(ui, |ui| {
        for from in WorkpieceFrom::ALL {
            if ui.selectable_label(chosen == from, view.text(from_id(from, has_limits))).clicked() {
                view.send(ProgramCommand::ChooseWorkpiece(from));
            }
        }
    });
    response.response.labelled_by(name.id);
    match chosen {
        WorkpieceFrom::Perfect => {}
        WorkpieceFrom::Given => {
            let named = |id: &str| view.text(id);
            let diameter = [(ProgramField::Diameter, named("true-diameter"), "mm")];
            let centre = [
                (ProgramField::WorkpieceX, named("program-page-workpiece-x"), "mm"),
                (ProgramField::WorkpieceY, named("program-page-workpiece-y"), "mm"),
            ];
            pair_ui(ui, view, &diameter);
            pair_ui(ui, view, &centre);
        }
        WorkpieceFrom::Simulated => {
            let button = Button::new(view.text("program-page-edit-workpiece")).min_size(vec2(0.0, sizes().field));
            view.button_as(ui, Action::EditWorkpiece, button);
            if let Some(error) = view.session.workpiece().problem() {
                problem(ui, view.words.say(&error));
            }
        }
        WorkpieceFrom::Recorded => {
            if let Some(recorded) = view.session.recorded() {
                let message = Message::new("program-page-recorded").text("name", &recorded.name);
                quiet(ui, view.words.say(&message.count("count", recorded.contacts.len())));
            }
            let button = Button::new(view.text("program-page-open-contacts")).min_size(vec2(0.0, sizes().field));
            view.button_as(ui, Action::OpenContacts, button);
        }
    }
}
