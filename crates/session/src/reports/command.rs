//! What can be done on the reports page, and what comes back from outside.

use std::path::PathBuf;
use std::sync::Arc;

use fitcheck_core::message::Message;
use fitcheck_core::words::Language;
use fitcheck_exchange::report::changes::EarlierReport;
use fitcheck_exchange::report::paper::Paper;
use fitcheck_exchange::report::pdf::Pages;
use fitcheck_exchange::report::template::{Section, Template};

use super::{Magnification, ReportOf, ReportsField};
use crate::Step;

/// What can be done on the reports page.
#[derive(Debug, Clone)]
pub enum ReportsCommand {
    /// Replaces the text of a field.
    Type(ReportsField, String),
    /// Chooses what is reported.
    Of(ReportOf),
    /// Reports what the statistics page shows, and opens the reports page.
    OfStatistics,
    /// Chooses a template by its name.
    Template(String),
    /// Chooses the language of the report; `None` is that of the template, or of the window.
    Language(Option<Language>),
    /// Chooses the paper; `None` is that of the template.
    Paper(Option<Paper>),
    /// A file was read as an earlier report to compare with, or refused.
    Earlier {
        /// Its file's name.
        name: String,
        result: Result<Arc<EarlierReport>, Message>,
    },
    /// Compares with no earlier report.
    CompareNot,
    /// Leaves a section out, or takes it in again.
    Show(Section, bool),
    /// Goes to another page.
    Move(Step),
    Magnify(Magnification),
    /// The pages are drawn, or not.
    Drawn {
        /// The number of the question.
        run: u64,
        result: Result<Arc<Pages>, Message>,
    },
    /// Draws the pages no further.
    Stop,
    /// The files of the user's own templates, read or refused.
    Templates(Vec<Result<Arc<Template>, Message>>),
    /// Begins a template of the user's own.
    NewTemplate,
    /// It is written into this file, or not.
    TemplateMade(Result<PathBuf, Message>),
    /// Hands the pages to the system's printer.
    Print,
    /// The system has taken them, or why not.
    Printed(Result<(), Message>),
}
