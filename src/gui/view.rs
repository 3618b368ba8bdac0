//! What every panel gets: the state, the words, and a place to put its commands.

use eframe::egui::{self, RichText, Ui};

use super::theme;
use crate::session::{Command, Session};
use crate::words::Words;

/// The arguments of every panel.
pub(super) struct View<'a> {
    /// The state; never changed while drawing.
    pub session: &'a Session,
    /// The texts of the window's language.
    pub words: &'a Words,
    /// What the user did in this frame.
    pub commands: Vec<Command>,
}

impl View<'_> {
    /// Sends a command.
    pub fn send(&mut self, command: Command) {
        self.commands.push(command);
    }

    /// A text by name.
    pub fn text(&self, id: &str) -> String {
        self.words.get(id)
    }
}

/// A heading of a part of the page.
pub(super) fn heading(ui: &mut Ui, text: impl Into<String>) -> egui::Response {
    ui.label(RichText::new(text).font(theme::bold(theme::sizes().heading)))
}

/// Text that may be overlooked.
pub(super) fn quiet(ui: &mut Ui, text: impl Into<String>) -> egui::Response {
    let colour = theme::palette(ui.ctx()).quiet.0;
    ui.label(RichText::new(text).color(colour).size(theme::sizes().small))
}

/// Text that says what is wrong.
pub(super) fn problem(ui: &mut Ui, text: impl Into<String>) -> egui::Response {
    let colour = theme::palette(ui.ctx()).error.0;
    ui.label(RichText::new(text).color(colour).size(theme::sizes().small))
}
