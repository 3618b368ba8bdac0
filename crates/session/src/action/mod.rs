//! Everything that a user can do by menu, button or key: what it is called, its keys, where it applies, whether it is
//! possible now, and the command that it sends.
//!
//! | file | what |
//! |---|---|
//! | here | what is asked of an action: its name, whether it is possible, its command |
//! | `list` | every action |
//! | `table` | a row for every action |
//! | `program`, `pairing`, `budget`, `records`, `parts` | the rows of these pages |
//! | `row` | what a row says |
//! | `possible`, `switches` | the conditions of the rows; what switches are set to |
//! | `place` | where an action applies |
//! | `shortcut` | keys, without a window |
//! | `keys` | which keys are heard and shown |
//! | `answers` | what a page asks, and what Enter answers |
//!
//! Choices among what a user has (a class, a table of the list, a block) are not actions: they send commands.
//!
//! To add an action (menu, button or key):
//!
//! 1. Add a variant to `list`.
//! 2. Add its row to `table`, or to the file of its page: text, keys, where it applies, when it is possible, and the command that it sends.
//! 3. Add its texts to every folder of `assets/locales`.
//! 4. Name the action in one line of `gui/` where it is a button or an entry of a menu. Keys and tooltips follow from the row.
//! 5. Write a new key into the tables of `docs/manual/window.md`: the test `session_actions` compares them.

mod answers;
mod budget;
mod keys;
mod list;
mod pairing;
mod parts;
mod place;
mod possible;
mod program;
mod records;
mod row;
mod shortcut;
mod switches;
mod table;

pub use list::Action;
pub use place::{Part, Place};
pub use shortcut::{Held, Key, Shortcut};

use fitcheck_core::length::Length;
use fitcheck_core::message::{Message, message};
use fitcheck_core::verdict::Status;
use fitcheck_core::words::Words;
use fitcheck_exchange::exchange::tables::TABLE_FORMATS;
use fitcheck_exchange::report::RENDERINGS;
use fitcheck_exchange::report::pairing::FORMATS as PAIR_FORMATS;

use self::row::Row;
use super::budget::BudgetCommand;
use super::columns::ColumnsCommand;
use super::cycles::CyclesCommand;
use super::parts::{PartsCommand, PlanCommand, WalkCommand};
use super::tables;
use super::workpiece::WorkpieceCommand;
use super::{Command, Page, RecordsCommand, Session};

impl Action {
    fn row(self) -> Row {
        table::row(self)
    }

    /// Where it applies.
    pub fn place(self) -> Place {
        self.row().place
    }

    /// Its name, in the words of a language.
    pub fn text(self, session: &Session, words: &Words) -> String {
        match self {
            Self::Export(number) => {
                RENDERINGS.get(number).map(|to| words.get(&format!("export-{}", to.name))).unwrap_or_default()
            }
            Self::ReportPart(number) => {
                RENDERINGS.get(number).map(|to| words.get(&format!("walk-page-report-{}", to.name))).unwrap_or_default()
            }
            Self::ReportRecords(number) => {
                RENDERINGS.get(number).map(|to| words.get(&format!("export-{}", to.name))).unwrap_or_default()
            }
            Self::SavePairs(number) => PAIR_FORMATS
                .get(number)
                .map(|to| words.get(&format!("pairing-page-save-{}", to.name)))
                .unwrap_or_default(),
            Self::SaveTable(number) => {
                let format = TABLE_FORMATS.get(number).map(|format| words.get(format.description));
                capitalised(&format.map(|format| format!("{format}…")).unwrap_or_default())
            }
            Self::RemoveColumn => {
                let selected = session.tables().shown().and_then(tables::Document::selected);
                let class = selected.map_or_else(|| words.get("class-none"), |(class, _)| class.to_string());
                words.say(&message!("tables-remove-column").text("class", class))
            }
            Self::JudgeAnyway | Self::TakeMeant => {
                let mm = |length: Option<Length>| length.map(|length| words.mm(length, 3)).unwrap_or_default();
                let question = session.check().question();
                let message = Message::new(self.row().text)
                    .text("measured", mm(question.map(|question| question.measured)))
                    .text("meant", mm(question.and_then(|question| question.doubt.meant())));
                words.say(&message)
            }
            Self::TakeText | Self::KeepText => {
                let doubted = session.check().doubted();
                let given = doubted.map(|doubted| words.number(&doubted.text)).unwrap_or_default();
                let meant = doubted.and_then(|doubted| doubted.meant.as_ref());
                let meant = meant.map(|meant| words.number(meant)).unwrap_or_default();
                words.say(&Message::new(self.row().text).text("given", given).text("meant", meant))
            }
            Self::TakeMeantCell => {
                let meant = session.parts().meant_here().map(|meant| words.number(&meant)).unwrap_or_default();
                words.say(&Message::new(self.row().text).text("meant", meant))
            }
            Self::TakeMeantValue => {
                let question = session.parts().walking().question();
                let meant = question.and_then(|question| question.doubt.meant());
                let meant = meant.map(|meant| words.mm(meant, 3)).unwrap_or_default();
                words.say(&Message::new(self.row().text).text("meant", meant))
            }
            Self::Undo => {
                let what = session.history().undoes();
                what.map_or_else(|| words.get("undo"), |what| words.say(&message!("undo-what").message("what", what)))
            }
            Self::ChooseBad => words.say(&message!("choose-bad").count("count", session.bad_count())),
            Self::UseTable if session.tables().is_used(session.sources()) => words.get("tables-in-use"),
            _ => words.get(self.row().text),
        }
    }

    /// The id of a further explanation.
    pub fn hint(self) -> Option<&'static str> {
        self.row().hint
    }

    /// Whether what it switches is on, where it switches something.
    pub fn is_on(self, session: &Session) -> Option<bool> {
        switches::is_on(self, session)
    }

    /// The command that it sends now; `None` where it is not possible.
    pub fn command(self, session: &Session) -> Option<Command> {
        let row = self.row();
        (row.possible)(session).then(|| row.sends.command(session))
    }
}

impl Session {
    /// Whether something can be done now.
    pub fn can(&self, action: Action) -> bool {
        (action.row().possible)(self)
    }

    /// How many listed checks are not good.
    fn bad_count(&self) -> usize {
        let counts = Status::ALL.into_iter().zip(self.history().listed().counts());
        counts.filter(|(status, _)| *status != Status::Good).map(|(_, count)| count).sum()
    }

    /// The command that closes the topmost thing over the page.
    fn uppermost(&self) -> Option<Command> {
        let is_on = |page| self.page() == page;
        let has_notice = !self.notices().is_empty();
        if self.is_leaving() {
            Some(Command::Leave(false))
        } else if self.budget().is_asking() {
            Some(BudgetCommand::Discard(false).into())
        } else if self.parts().is_asking() {
            Some(PartsCommand::Plan(PlanCommand::Discard(false)).into())
        } else if self.dialog().is_some() {
            Some(Command::Close)
        } else if self.open_columns().is_some() {
            Some(ColumnsCommand::Leave.into())
        } else if has_notice {
            Some(Command::Close)
        } else if self.parts().walking().is_skipping() && is_on(Page::Parts) {
            Some(WalkCommand::AskSkip(false).into())
        } else if self.cycles().block().is_some() && is_on(Page::Cycles) {
            Some(CyclesCommand::ShowBlock(false).into())
        } else if self.workpiece_is_open() && (is_on(Page::Cycles) || is_on(Page::Program)) {
            Some(WorkpieceCommand::Show(false).into())
        } else if self.records().correcting().is_some() && is_on(Page::Records) {
            Some(RecordsCommand::Correct(false).into())
        } else if self.records().opened().is_some() && is_on(Page::Records) {
            Some(RecordsCommand::CloseRecord.into())
        } else {
            None
        }
    }
}

/// Capitalised, as an entry of a menu.
fn capitalised(text: &str) -> String {
    let mut chars = text.chars();
    chars.next().map(|first| first.to_uppercase().chain(chars).collect()).unwrap_or_default()
}
