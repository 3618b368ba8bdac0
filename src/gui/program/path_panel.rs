//! The path of the ball's centre so far, over the workpiece that the last cycle expects.

use eframe::egui::Ui;

use crate::gui::cycles::picture::path_picture;
use crate::gui::view::{View, heading, quiet};
use crate::session::program::{Document, Run};

/// Whether the open program gets room for a path: it has one, or may get one.
pub(super) fn has_room(view: &View<'_>) -> bool {
    let program = view.session.program();
    program.main().is_some_and(Document::may_measure) || program.run().is_some_and(Run::has_path)
}

/// The picture in the room that is left; its room is kept while there is none.
pub(super) fn path_ui(ui: &mut Ui, view: &View<'_>) {
    heading(ui, view.text("program-page-path"));
    let Some(run) = view.session.program().run().filter(|run| run.has_path()) else {
        quiet(ui, view.text("program-page-no-path"));
        return;
    };
    let path = run.path();
    let last = run.cycles().last();
    let nominal = last.and_then(|cycle| cycle.cycle.nominal(&cycle.result.inputs).ok());
    path_picture(ui, view, &path, path.len(), nominal, 0.0);
}
