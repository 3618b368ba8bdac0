//! What lies over a page: its title, its window, and when it is new.

use eframe::egui::{Align2, Id, Ui, Window, vec2};

use crate::session::{CycleFile, Purpose};
use crate::tolerance::Feature;

/// A window that cannot be moved, at a distance below its anchor.
pub(super) fn fixed_window(id: &str, title: String, anchor: Align2, below: f32) -> Window<'static> {
    let window = Window::new(title).id(Id::unique(id)).anchor(anchor, vec2(0.0, below));
    window.collapsible(false).resizable(false)
}

/// Whether something is drawn that was not drawn in the frame before.
pub(super) fn just_opened(ui: &Ui, id: Id) -> bool {
    let frame = ui.ctx().cumulative_frame_nr();
    let last = ui.data_mut(|data| std::mem::replace(data.get_temp_mut_or_default::<u64>(id), frame));
    last + 1 < frame
}

/// What a file is asked for, or was read for.
pub(super) const fn title_id(purpose: Purpose) -> &'static str {
    match purpose {
        Purpose::Import | Purpose::ImportValues(_) => "dialog-import",
        Purpose::AskColumns(_) => "columns-page-dialog",
        Purpose::LoadMask => "dialog-mask",
        Purpose::LoadTables => "dialog-tables",
        Purpose::Export(_) | Purpose::ReportRecords(_) | Purpose::ReportPart(_) => "dialog-export",
        Purpose::ExportStatus => "dialog-export-status",
        Purpose::OpenCycleFile(CycleFile::Contacts) => "cycles-dialog-contacts",
        Purpose::OpenCycleFile(CycleFile::Workpiece) => "cycles-dialog-workpiece",
        Purpose::OpenCycleFile(CycleFile::Probes) => "cycles-dialog-probes",
        Purpose::SaveWorkpiece => "cycles-dialog-save-workpiece",
        Purpose::SaveCycleLog => "cycles-dialog-save-log",
        Purpose::OpenTable => "tables-dialog-open",
        Purpose::OpenProgram => "program-page-dialog-open",
        Purpose::OpenPart => "program-page-dialog-part",
        Purpose::OpenTools => "tools-dialog-open",
        Purpose::SaveTools => "tools-dialog-save",
        Purpose::SaveTable(_) => "tables-dialog-save",
        Purpose::OpenBudget | Purpose::UseBudget => "budget-page-dialog-open",
        Purpose::SaveBudget => "budget-page-dialog-save",
        Purpose::OpenPlan => "parts-page-dialog-open",
        Purpose::WatchFolder => "walk-page-dialog-watch",
        Purpose::SavePlan(_) => "parts-page-dialog-save",
        Purpose::OpenPicture => "parts-page-dialog-picture",
        Purpose::OpenReadings => "budget-page-dialog-readings",
        Purpose::OpenParts(Feature::Hole) => "pairing-page-dialog-holes",
        Purpose::OpenParts(Feature::Shaft) => "pairing-page-dialog-shafts",
        Purpose::SavePairs(_) => "pairing-page-dialog-save",
    }
}
