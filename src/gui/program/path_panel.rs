//! The path of the ball's centre so far, over the features of the simulated part, or over the workpiece that the last cycle
//! expects.

use eframe::egui::Ui;

use crate::gui::cycles::picture::{Surroundings, path_picture};
use crate::gui::view::{View, datum_lines, datum_text, heading, quiet};
use crate::journal::entry::DatumKept;
use crate::nc::machine::CycleRun;
use crate::session::program::{Run, WorkpieceFrom};

/// Whether the open program gets room for a path: it has one, or may get one.
pub(super) fn has_room(view: &View<'_>) -> bool {
    let program = view.session.program();
    program.main().is_some_and(|document| document.may_measure) || program.run.as_ref().is_some_and(Run::has_path)
}

/// The picture in the room that is left; its room is kept while there is none. A part is shown before it is measured.
pub(super) fn path_ui(ui: &mut Ui, view: &View<'_>) {
    heading(ui, view.text("program-page-path"));
    let program = view.session.program();
    let part = view.session.part().filter(|_| program.workpiece == WorkpieceFrom::Part).map(|open| &open.part);
    let run = program.run.as_ref().filter(|run| run.has_path());
    if run.is_none() && part.is_none() {
        quiet(ui, view.text("program-page-no-path"));
        return;
    }
    let path = run.map_or_else(Vec::new, Run::path);
    let last = run.and_then(|run| run.cycles().last());
    let datum = last.and_then(|cycle| cycle.datum.as_ref());
    if let Some(datum) = datum.map(DatumKept::from) {
        quiet(ui, datum_text(view.words, &datum)).on_hover_text(datum_lines(view.words, &datum).join("\n"));
    }
    let nominal = last.and_then(CycleRun::nominal);
    let system = last.and_then(CycleRun::axes);
    let features = part.map_or([].as_slice(), |part| part.features.as_slice());
    let ball_radius = part.map_or(0.0, |part| part.probe.ball_radius);
    path_picture(ui, view, &path, path.len(), Surroundings { nominal, features, ball_radius, system });
}
