//! The path of the ball's centre so far, over the workpiece that the last cycle expects.

use eframe::egui::Ui;

use crate::gui::cycles::picture::path_picture;
use crate::gui::view::{View, heading};
use crate::session::program::Run;

/// Whether there is a path to show.
pub(super) fn has_path(view: &View<'_>) -> bool {
    view.session.program().run().is_some_and(Run::has_path)
}

/// The picture in the room that is left.
pub(super) fn path_ui(ui: &mut Ui, view: &View<'_>) {
    let Some(run) = view.session.program().run() else { return };
    heading(ui, view.text("program-page-path"));
    let path = run.path();
    let last = run.cycles().last();
    let nominal = last.and_then(|cycle| cycle.cycle.nominal(&cycle.result.inputs).ok());
    path_picture(ui, view, &path, path.len(), nominal, 0.0);
}
