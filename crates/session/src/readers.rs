//! Readers of the state that belongs to every page.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use fitcheck_core::message::Message;
use fitcheck_core::tolerance::fit::materials::Materials;
use fitcheck_core::tolerance::{DeviationTable, Sources};
use fitcheck_core::words::{Dialogue, Language};
use fitcheck_nc::control::mask::Mask;
use fitcheck_nc::machine::Store;

use super::Session;
use super::cycles::WorkpieceForm;
use super::files::{Dialog, RecentFile, Working};
use super::history::History;
use super::notice::Notice;
use super::page::Page;
use super::purpose::Purpose;
use super::recording::{Recorded, Recording};
use super::ruler::Ruler;
use super::settings::{DecimalSign, Density, Mode, RowHeight, Theme};
use super::shared::{MaskChoice, ProgramFiles};
use super::workpiece::{OpenPart, RecordedContacts};
use super::zoom::Zoom;

impl Session {
    /// The open page.
    pub const fn page(&self) -> Page {
        self.shared.page
    }

    /// Where limits are looked up.
    pub const fn sources(&self) -> &Arc<Sources> {
        &self.shared.sources
    }

    /// The folder of the user's own tables, where one was chosen.
    pub const fn tables_folder(&self) -> Option<&PathBuf> {
        self.shared.tables_folder.as_ref()
    }

    /// The mask that the status window is drawn with.
    pub const fn mask(&self) -> &MaskChoice {
        &self.shared.mask
    }

    /// What a status window is drawn with: a language, and the user's own mask.
    pub fn drawn_with(&self) -> (Dialogue, Option<&Mask>) {
        self.shared.drawn_with()
    }

    /// The language of the window.
    pub const fn language(&self) -> Language {
        self.shared.language
    }

    /// Light or dark.
    pub const fn theme(&self) -> Theme {
        self.shared.theme
    }

    /// Whom the window is for.
    pub fn mode(&self) -> Mode {
        self.shared.mode.unwrap_or(Mode::Full)
    }

    /// Whether it is asked whom the window is for: a finger touched it, and nobody has said it.
    pub const fn asks_for_mode(&self) -> bool {
        self.shared.asks_for_mode
    }

    /// How large a millimetre is on this screen, where somebody has said it.
    pub const fn ruler(&self) -> Option<Ruler> {
        self.shared.ruler
    }

    /// The points of a window as it is scaled now that are as long as some millimetres; `None` where nobody has said how large one is.
    pub fn points(&self, millimetres: f32) -> Option<f32> {
        let scale = f32::from(self.zoom().percent()) / 100.0;
        self.ruler().map(|ruler| ruler.millimetre() * millimetres / scale)
    }

    /// Whether a PIN locks the operator's window.
    pub const fn has_pin(&self) -> bool {
        self.shared.pin.is_some()
    }

    pub fn is_for_operators(&self) -> bool {
        self.shared.is_for_operators()
    }

    /// How high everything is that is pressed, as it was chosen.
    pub const fn density(&self) -> Density {
        self.shared.density
    }

    /// The scale of the window.
    pub const fn rows(&self) -> RowHeight {
        self.shared.rows
    }

    /// What stands before the decimals of a number.
    pub const fn decimal(&self) -> DecimalSign {
        self.shared.decimal
    }

    /// The same as a sign.
    pub fn decimal_sign(&self) -> char {
        self.shared.decimal_sign()
    }

    /// The scale of the window.
    pub const fn zoom(&self) -> Zoom {
        self.shared.zoom
    }

    /// Whether a finger was used last.
    pub const fn is_touched(&self) -> bool {
        self.shared.is_touched
    }

    /// Whether the check page shows the first steps.
    pub const fn welcomes(&self) -> bool {
        self.shared.welcomes
    }

    /// Whether what is pressed is high enough for fingers.
    pub fn is_for_touch(&self) -> bool {
        match self.shared.density {
            _ if self.is_for_operators() => true,
            Density::ByUse => self.shared.is_touched,
            Density::Mouse => false,
            Density::Touch => true,
        }
    }

    /// Whether the keypad is shown.
    pub const fn has_keypad(&self) -> bool {
        self.shared.keypad
    }

    /// Whether a verdict is heard.
    pub const fn has_sounds(&self) -> bool {
        self.shared.sounds
    }

    /// All checks, how they are listed, and which are chosen.
    pub const fn history(&self) -> &History {
        &self.shared.history
    }

    /// The simulated workpiece that the cycles page and the program page measure.
    pub const fn workpiece(&self) -> &WorkpieceForm {
        &self.shared.workpiece.form
    }

    /// Whether its dialog is open.
    pub const fn workpiece_is_open(&self) -> bool {
        self.shared.workpiece.is_open
    }

    /// The recorded contacts that were read last, on whichever page.
    pub fn recorded(&self) -> Option<&RecordedContacts> {
        self.shared.workpiece.recorded.as_deref()
    }

    /// The simulated part of several features that the program page measures.
    pub fn part(&self) -> Option<&OpenPart> {
        self.shared.workpiece.part.as_deref()
    }

    /// What parts can be made of.
    pub const fn materials(&self) -> &Materials {
        &self.shared.materials
    }

    /// Adds the user's own materials to the built-in ones; one of the same name replaces it.
    pub fn use_materials(&mut self, own: Materials) {
        self.shared.materials = Materials::shipped().with_own(own);
    }

    /// The open file dialog.
    pub const fn dialog(&self) -> Option<&Dialog> {
        self.shared.dialog.as_ref()
    }

    /// The files that were read last, the latest first.
    pub fn recent_files(&self) -> &[RecentFile] {
        &self.shared.places.recent
    }

    /// Those that were read for one purpose, each with its number in that list.
    pub fn recent_of(&self, purpose: Purpose) -> impl Iterator<Item = (usize, &Path)> {
        let files = self.recent_files().iter().enumerate().filter(move |(_, file)| file.purpose == purpose);
        files.map(|(number, file)| (number, file.path.as_path()))
    }

    /// The folders that were used last, each once.
    pub fn recent_folders(&self) -> Vec<&Path> {
        self.shared.places.folders()
    }

    /// The user's own folder, where there is one.
    pub fn home(&self) -> Option<&Path> {
        self.shared.places.home.as_deref()
    }

    /// Sets the file that keeps the settings.
    pub fn use_state_file(&mut self, file: PathBuf) {
        self.settings_page.state_file = Some(file);
    }

    /// Sets where the NC program of a file finds other files.
    pub fn use_program_files(&mut self, files: fn(&Path) -> Box<dyn Store>) {
        self.shared.program_files = ProgramFiles(files);
    }

    /// Sets the folder in which dialogs begin until another one was used.
    pub fn use_home(&mut self, home: PathBuf) {
        self.shared.places.home = Some(home);
    }

    /// The file that is being read or written, where that takes long.
    pub fn working(&self) -> Option<&Working> {
        self.shared.working.as_deref()
    }

    /// The notices, oldest first.
    pub fn notices(&self) -> &[Notice] {
        self.shared.notices.open()
    }

    /// How many were told so far.
    pub fn notices_told(&self) -> u64 {
        self.shared.notices.told()
    }

    /// The one that is shown.
    pub fn notice(&self) -> Option<&Notice> {
        self.shared.notices.shown()
    }

    /// What was told before and asked for a look, newest first.
    pub fn earlier_notices(&self) -> impl ExactSizeIterator<Item = &Notice> {
        self.shared.notices.earlier().iter()
    }

    /// Whether they are shown.
    pub const fn shows_messages(&self) -> bool {
        self.shared.notices.shows_earlier
    }

    /// Adds a notice of something that happened outside, such as a state file that was set aside.
    pub fn tell(&mut self, message: Message) {
        self.shared.tell(message);
    }

    /// Whether and where checks are recorded, who measures, and what could not be written.
    pub const fn recording(&self) -> &Recording {
        &self.shared.recording
    }

    /// What has become of the shown check on its way to the journal; `None` where it was not sent.
    pub fn check_recorded(&self) -> Option<Recorded<'_>> {
        self.shared.recording.of_check(self.check.shown.as_ref()?.id?)
    }

    /// The user's own tables that are not open yet: number among [`Sources::own`], and table.
    pub fn unopened_tables(&self) -> impl Iterator<Item = (usize, &Arc<DeviationTable>)> {
        let own = self.shared.sources.own().iter().enumerate();
        own.filter(|(_, table)| self.tables.by_title(table.name()).is_none())
    }

    /// Whether something would be lost with the window: unsaved changes, or checks that could not be recorded.
    pub fn would_lose(&self) -> bool {
        !self.unsaved().is_empty() || 0 < self.shared.recording.failed()
    }

    /// Whether the user wants to close the window and something is unsaved.
    pub const fn is_leaving(&self) -> bool {
        self.shared.leaving
    }
}
