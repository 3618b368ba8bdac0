//! What can be done on the reports page.

use fitcheck_core::words::Words;
use fitcheck_exchange::report::{Holds, RENDERINGS};

use super::{Magnification, ReportOf, ReportsCommand};
use crate::Session;
use crate::action::Shortcut;
use crate::action::row::{ActionRow, Actions, actions, keys, on};
use crate::command::Command;
use crate::page::Page;
use crate::purpose::Purpose;
use crate::step::Step;

actions! {
    /// What can be done on the reports page.
    ReportsAction

    /// Writes the report as it is shown.
    SavePdf;
    /// Hands it to the system's printer.
    Print;
    /// Writes it in a format of the report's list, by its number there.
    Save(usize): 0..RENDERINGS.len();
    /// Chooses what is reported.
    Of(ReportOf): ReportOf::ALL;
    /// Goes to another page.
    Move(Step): [Step::PageUp, Step::PageDown];
    /// Shows the whole page.
    WholePage;
    /// Draws the pages no further.
    StopPages;
    /// Chooses an earlier report, to say what changed since.
    Compare;
    /// Compares with none.
    CompareNot;
    /// Begins a template of the user's own.
    NewTemplate;
    /// Goes to the records, to choose others.
    OpenRecords;
}

/// The place of the PDF in the list of renderings.
fn pdf() -> usize {
    RENDERINGS.iter().position(|rendering| rendering.name == "pdf").unwrap_or(0)
}

impl Actions for ReportsAction {
    fn row(&self) -> ActionRow {
        match *self {
            Self::SavePdf => on(Page::Reports, "reports-page-save", Command::OpenDialog(Purpose::Report(pdf())))
                .key(Shortcut::ctrl('S'))
                .when(has_report),
            Self::Print => {
                on(Page::Reports, "reports-page-print", ReportsCommand::Print).key(Shortcut::ctrl('P')).when(has_report)
            }
            Self::Save(number) => on(Page::Reports, "reports-page-save", Command::OpenDialog(Purpose::Report(number)))
                .when(if RENDERINGS.get(number).is_some_and(|to| to.holds == Holds::Label) {
                    has_label
                } else {
                    has_report
                }),
            Self::Of(of) => on(Page::Reports, of.name(), ReportsCommand::Of(of)).when(match of {
                ReportOf::Part => |session| session.can_report(ReportOf::Part),
                ReportOf::Check => |session| session.can_report(ReportOf::Check),
                ReportOf::List => |session| session.can_report(ReportOf::List),
                ReportOf::Records => |session| session.can_report(ReportOf::Records),
                ReportOf::Statistics => |session| session.can_report(ReportOf::Statistics),
            }),
            Self::Move(step) => on(Page::Reports, "reports-page-move", ReportsCommand::Move(step)).key(keys(step)),
            Self::OpenRecords => on(Page::Reports, "reports-page-open-records", Command::OpenPage(Page::Records)),
            Self::StopPages => on(Page::Reports, "working-stop", ReportsCommand::Stop)
                .when(|session| session.reports().at_work().is_some()),
            Self::Compare => {
                on(Page::Reports, "reports-page-compare", Command::OpenDialog(Purpose::CompareReport)).when(has_report)
            }
            Self::CompareNot => on(Page::Reports, "reports-page-compare-not", ReportsCommand::CompareNot)
                .when(|session| session.reports().earlier().is_some()),
            Self::NewTemplate => on(Page::Reports, "reports-page-new-template", ReportsCommand::NewTemplate)
                .when(|session| session.settings_page().state_file.is_some()),
            Self::WholePage => {
                on(Page::Reports, "reports-page-whole", ReportsCommand::Magnify(Magnification::WholePage))
            }
        }
    }

    fn name(&self, _session: &Session, words: &Words) -> Option<String> {
        match *self {
            // On its page the format alone says it.
            Self::Save(number) => Some(format!("{}…", RENDERINGS.get(number)?.title)),
            Self::Move(Step::PageUp) => Some(words.get("reports-page-before")),
            Self::Move(_) => Some(words.get("reports-page-next")),
            _ => None,
        }
    }

    fn is_on(&self, session: &Session) -> Option<bool> {
        match *self {
            Self::Of(of) => Some(session.report_of() == Some(of)),
            Self::WholePage => Some(session.reports().magnification == Magnification::WholePage),
            _ => None,
        }
    }
}

fn has_report(session: &Session) -> bool {
    session.report_of().is_some()
}

fn has_label(session: &Session) -> bool {
    has_report(session) && session.reports().paper().is_label()
}
