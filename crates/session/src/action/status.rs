//! The status window that is written as text: that of the open page.

use fitcheck_core::message::{Message, message};
use fitcheck_nc::control::simulated::marked;

use crate::Session;
use crate::page::Page;

/// A window of the control, as text.
pub(crate) struct StatusText {
    /// What is written: the window as the control prints it, below a mark where nobody measured.
    pub text: String,
    /// What its file is called, without ending and date.
    pub name: String,
}

impl Session {
    /// The window of the open page: that of the cycle, the last one that the program has opened, or that of the check. A page without one
    /// of its own writes that of the check.
    pub(crate) fn status_to_export(&self) -> Option<StatusText> {
        match self.page() {
            Page::Cycles => {
                let text = self.cycles().status_text(self.drawn_with())?;
                Some(StatusText { text, name: format!("{}-status", self.cycles().cycle.code) })
            }
            Page::Program => {
                let run = self.program().run.as_ref()?;
                let window = run.windows().iter().rev().find(|window| window.is_open)?;
                let name = self.program().main().map_or("", |main| main.title());
                let stem = name.rsplit_once('.').map_or(name, |(stem, _)| stem);
                let text = marked(&window.text, self.program().is_simulated());
                Some(StatusText { text, name: format!("{stem}-status") })
            }
            _ => {
                let shown = self.check().shown.as_ref()?;
                let text = self.check().status_text()?;
                Some(StatusText { text, name: format!("{}-status", crate::files::of_record(&shown.record)) })
            }
        }
    }

    /// Which window that is.
    pub(crate) fn status_named(&self) -> Message {
        match self.page() {
            Page::Cycles => message!("export-status-cycle").text("cycle", self.cycles().cycle.code),
            Page::Program => message!("export-status-program"),
            _ => message!("export-status-check"),
        }
    }
}
