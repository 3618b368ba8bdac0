//! What the window has to know of a page, and how a page knows a file that is dropped on it.

use std::path::Path;

use eframe::egui::Ui;

use super::theme::Icon;
use super::view::View;
use crate::session::{Action, Command, CycleFile, FilesCommand, Purpose, WindowAction};

/// What pages are for: they stand together in the rail.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Group {
    Measure,
    Results,
    Design,
    Control,
    Uncertainty,
    /// At the foot of the rail.
    Foot,
}

impl Group {
    /// Those above the foot, from top to bottom.
    pub const RAIL: [Self; 5] = [Self::Measure, Self::Results, Self::Design, Self::Control, Self::Uncertainty];
}

/// What the window has to know of a page.
pub(super) struct PageView {
    pub group: Group,
    pub icon: Icon,
    pub ui: fn(&mut Ui, &mut View<'_>),
    /// The two sides of a page that has two, chosen beside its title.
    pub sides: &'static [Action],
    /// What brings in what the page is about.
    pub action: fn(&View<'_>) -> Action,
    /// The names of what is open on it: a part, a serial number, a file.
    pub opened: fn(&View<'_>) -> Vec<String>,
    /// What is done with a file that is dropped on it: its path, and its number among those that were dropped together.
    pub dropped: fn(&View<'_>, &Path, usize) -> Command,
}

impl PageView {
    /// A page of measurements, on which nothing else is opened.
    pub const fn of(group: Group, icon: Icon, ui: fn(&mut Ui, &mut View<'_>)) -> Self {
        Self {
            group,
            icon,
            ui,
            sides: &[],
            action: |_| WindowAction::Import.into(),
            opened: nothing,
            dropped: measurements,
        }
    }
}

/// A page on which nothing is opened.
const fn nothing(_view: &View<'_>) -> Vec<String> {
    Vec::new()
}

/// A file that is read for a purpose.
pub(super) fn open(purpose: Purpose, path: &Path) -> Command {
    FilesCommand::Open(purpose, path.to_owned()).into()
}

/// A dropped file of measurements.
fn measurements(_view: &View<'_>, path: &Path, _number: usize) -> Command {
    open(Purpose::Import, path)
}

/// The ending of a file in small letters; empty where it has none.
pub(super) fn ending(path: &Path) -> String {
    path.extension().map_or_else(String::new, |ending| ending.to_string_lossy().to_lowercase())
}

/// What kind of file for the cycles page it is, by its ending.
pub(super) fn cycle_file(path: &Path) -> CycleFile {
    match ending(path).as_str() {
        "toml" => CycleFile::Workpiece,
        "tp" => CycleFile::Probes,
        _ => CycleFile::Contacts,
    }
}
