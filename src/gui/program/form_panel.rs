//! Left: the inputs of 8255, what is measured, and below them program and native answer side by side.

use eframe::egui::accesskit::Live;
use eframe::egui::{Button, Grid, RichText, Sense, TextStyle, Ui, vec2};

use super::create_panel::section_ui;
use super::part_panel::part_ui;
use super::tools_panel::tools_ui;
use crate::gui::field::pairs_ui;
use crate::gui::limits::source_ui;
use crate::gui::shapes;
use crate::gui::spoken::{gap_ui, live};
use crate::gui::theme::{self, control, palette, sizes, space};
use crate::gui::verdict_card::status_id;
use crate::gui::view::{View, heading, one_of_ui, problem, quiet};
use crate::message::message;
use crate::session::program::{Agreement, Input, Run, WorkpieceFrom};
use crate::session::{Field, ProgramCommand, ProgramField, WorkpieceAction};
use crate::verdict::Status;

/// The panel's content, with the files for a control where they have no room elsewhere.
pub(super) fn form_ui(ui: &mut Ui, view: &mut View<'_>, has_set: bool) {
    // What a run changes comes last: nothing below it can move.
    let has_inputs = view.session.program().has_inputs();
    if has_inputs {
        inputs_ui(ui, view);
        ui.separator();
    }
    workpiece_ui(ui, view);
    tools_ui(ui, view);
    if has_set {
        ui.separator();
        section_ui(ui, view);
    }
    if has_inputs {
        ui.separator();
        native_ui(ui, view);
    }
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

/// The inputs, each with its parameter and name.
fn inputs_ui(ui: &mut Ui, view: &mut View<'_>) {
    heading(ui, view.text("program-page-inputs"));
    let inputs: Vec<_> = view.session.program().inputs().collect();
    let named = |input: &Input| {
        let name = format!("{} {}", input.parameter(), view.text(input_id(*input)));
        (ProgramField::Input(*input).into(), name, input.unit())
    };
    let fields: Vec<_> = inputs.iter().map(named).collect();
    // Each row takes the room that there is: a long name may have widened it.
    for row in fields.chunks(2) {
        fields_ui(ui, view, row);
    }
}

fn fields_ui(ui: &mut Ui, view: &mut View<'_>, fields: &[(Field, String, &str)]) {
    pairs_ui(ui, view, fields);
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
    let run = session.program().run.as_ref();
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
        gap_ui(ui, &TextStyle::Small);
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
        source_ui(ui, view, limits);
    }
    agreement_ui(ui, view);
}

fn agreement_ui(ui: &mut Ui, view: &View<'_>) {
    let Some(agreement) = view.session.program().agreement(view.session.sources()) else { return };
    let (shape, said) = match agreement {
        Agreement::Agrees => (Some(Status::Good), view.text("program-page-agrees")),
        Agreement::BothRefuse => (None, view.text("program-page-both-refuse")),
        Agreement::Unfinished => (None, view.text("program-page-unfinished")),
        Agreement::OtherInputs => (None, view.text("program-page-other-inputs")),
        Agreement::Differs(differences) => {
            let differences: Vec<_> = differences.iter().map(|message| view.words.say(message)).collect();
            let message = message!("program-page-differs").text("what", differences.join("; "));
            (Some(Status::Scrap), view.words.say(&message))
        }
    };
    ui.horizontal_wrapped(|ui| {
        let palette = palette(ui.ctx());
        let (mark, _) = ui.allocate_exact_size(vec2(space(4.0), space(5.0)), Sense::hover());
        let colour = if shape == Some(Status::Scrap) { palette.error.0 } else { palette.text.0 };
        shapes::status(ui.painter(), mark, shape, colour);
        let label = ui.label(RichText::new(&said).font(theme::bold(sizes().body)));
        live(ui, &label, &said, Live::Polite);
    });
}

const fn from_id(from: WorkpieceFrom, has_limits: bool) -> &'static str {
    match from {
        WorkpieceFrom::Perfect if !has_limits => "program-page-from-nominal",
        WorkpieceFrom::Perfect => "program-page-from-perfect",
        WorkpieceFrom::Given => "program-page-from-given",
        WorkpieceFrom::Simulated => "program-page-from-simulated",
        WorkpieceFrom::Part => "program-page-from-part",
        WorkpieceFrom::Recorded => "program-page-from-recorded",
    }
}

fn workpiece_ui(ui: &mut Ui, view: &mut View<'_>) {
    let name = heading(ui, view.text("program-page-workpiece"));
    let chosen = view.session.program().workpiece;
    let has_limits = view.session.program().has_inputs();
    let width = ui.available_width() - space(2.0);
    let all = WorkpieceFrom::ALL.map(|from| (from, view.text(from_id(from, has_limits))));
    let (from, list) = one_of_ui(ui, "program-workpiece", width, &chosen, all);
    list.labelled_by(name.id);
    if let Some(from) = from {
        view.send(ProgramCommand::ChooseWorkpiece(from));
    }
    match chosen {
        WorkpieceFrom::Perfect => {}
        WorkpieceFrom::Given => {
            let mm = |field: ProgramField, id: &str| (field.into(), view.text(id), "mm");
            let diameter = [mm(ProgramField::Diameter, "true-diameter")];
            let x = mm(ProgramField::WorkpieceX, "program-page-workpiece-x");
            let centre = [x, mm(ProgramField::WorkpieceY, "program-page-workpiece-y")];
            fields_ui(ui, view, &diameter);
            fields_ui(ui, view, &centre);
        }
        WorkpieceFrom::Simulated => {
            let button = Button::new(view.text("program-page-edit-workpiece")).min_size(vec2(0.0, control(ui)));
            view.button_as(ui, WorkpieceAction::EditWorkpiece, button);
            if let Some(error) = view.session.workpiece().problem() {
                problem(ui, view.words.say(&error));
            }
        }
        WorkpieceFrom::Part => part_ui(ui, view),
        WorkpieceFrom::Recorded => {
            if let Some(recorded) = &view.session.program().recorded {
                let message = message!("program-page-recorded").text("name", &recorded.name);
                quiet(ui, view.words.say(&message.count("count", recorded.contacts.len())));
            }
            let button = Button::new(view.text("program-page-open-contacts")).min_size(vec2(0.0, control(ui)));
            view.button_as(ui, WorkpieceAction::OpenContacts, button);
        }
    }
}
