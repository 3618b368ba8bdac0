//! What can be done on the records page.

use fitcheck_core::message::message;
use fitcheck_core::text::{grouped, long};
use fitcheck_core::words::Words;
use fitcheck_exchange::report::of_any_paper;

use super::{RecordsCommand, RecordsField, Shorthand, Walk};
use crate::Session;
use crate::action::row::{ActionRow, Actions, Sends, actions, keys, on, within};
use crate::action::window::report_name;
use crate::action::{ActionScope, Key, Part, Shortcut};
use crate::command::Command;
use crate::field::Field;
use crate::page::Page;
use crate::step::Step;

/// The list of records.
pub const RECORDS: Part = Part::list(Page::Records, "records-list");

actions! {
    /// What can be done on the records page.
    RecordsAction

    /// Puts a word into the question to the journal, or takes it out.
    AskRecords(Shorthand): Shorthand::ALL;
    /// Opens or closes the form for another filter.
    AskForFilter;
    /// Puts the filter of the form into the question.
    AddFilter;
    /// Goes to the question.
    FindRecords;
    /// Goes to another record.
    MoveRecord(Step): Step::BLOCKS;
    OpenRecord;
    /// Chooses the record for the report, or not.
    ChooseRecord;
    /// Chooses all that are listed.
    ChooseAllRecords;
    /// Chooses none.
    ChooseNoRecords;
    /// Takes simulated checks into the report, or leaves them out.
    WithSimulated;
    /// Puts the chosen records, or the one at which the keys are, on the clipboard.
    CopyRecords;
    /// Writes the chosen records, or all that are listed, in a format of the report's list, by its number there.
    ReportRecords(usize): of_any_paper();
    /// Goes back to the list.
    CloseRecord;
    /// Takes what the record asked for to the check page.
    MeasureAgain;
    /// Opens the form of a correction.
    CorrectRecord;
    /// Writes the correction.
    SendCorrection;
    /// Closes the form.
    LeaveCorrection;
    /// Takes the record back without another in its place.
    WithdrawRecord;
    /// Walks the chain of the journal.
    VerifyRecords;
    /// Stops that.
    CancelVerify;
    /// Opens or closes the form for the server of the shop.
    AskForServer;
    /// Sends to the server in the field.
    TakeServer;
    /// Sends to no server any more.
    LeaveServer;
    /// Sends at once, whatever went wrong before.
    SendAgain;
}

impl Actions for RecordsAction {
    #[expect(clippy::too_many_lines, reason = "one row for everything that can be done")]
    fn row(&self) -> ActionRow {
        match *self {
            Self::AskRecords(shorthand) => {
                let text = match shorthand {
                    Shorthand::Today => "records-page-today",
                    Shorthand::ThisWeek => "records-page-this-week",
                    Shorthand::NotGood => "records-page-not-good",
                    Shorthand::Measured => "records-page-measured-only",
                    Shorthand::Standing => "records-page-standing",
                };
                on(Page::Records, text, RecordsCommand::Toggle(shorthand)).when(|session| session.recording().is_on())
            }
            Self::AskForFilter => ActionRow::new(
                ActionScope::Page(Page::Records),
                "records-page-filter",
                Sends::FromState(|session| RecordsCommand::AskForFilter(!session.records().is_filtering).into()),
            )
            .hint("records-page-filter-hint")
            .when(|session| session.recording().is_on()),
            Self::AddFilter => on(Page::Records, "records-page-add-filter", RecordsCommand::AddFilter)
                .when(|session| !session.text(RecordsField::Filter).trim().is_empty()),
            Self::FindRecords => {
                on(Page::Records, "records-page-question", Command::GoTo(RecordsField::Question.into()))
                    .key(Shortcut::ctrl('F'))
                    .when(|session| session.recording().is_on())
            }
            Self::MoveRecord(step) => {
                within(RECORDS, "records-page-move", RecordsCommand::Move(step)).when(has_records).key(keys(step))
            }
            Self::OpenRecord => ActionRow::new(
                ActionScope::Part(RECORDS),
                "records-page-open",
                Sends::AtCursor(|session| Some(RecordsCommand::Open(session.records().cursor?).into())),
            )
            .key(Shortcut::plain(Key::Enter))
            .when(has_cursor),
            Self::ChooseRecord => ActionRow::new(
                ActionScope::Part(RECORDS),
                "records-page-choose",
                Sends::AtCursor(|session| {
                    let number = session.records().cursor?;
                    Some(RecordsCommand::Choose(number, !session.records().is_chosen(number)).into())
                }),
            )
            .key(Shortcut::plain(Key::Space))
            .when(has_cursor),
            Self::ChooseAllRecords => {
                within(RECORDS, "choose-all", RecordsCommand::ChooseAll).key(Shortcut::ctrl('A')).when(has_records)
            }
            Self::ChooseNoRecords => on(Page::Records, "choose-none", RecordsCommand::ChooseNone).when(has_chosen),
            Self::WithSimulated => ActionRow::new(
                ActionScope::Page(Page::Records),
                "records-page-with-simulated",
                Sends::FromState(|session| RecordsCommand::WithSimulated(!session.records().with_simulated).into()),
            )
            .hint("records-page-with-simulated-hint"),
            Self::CopyRecords => within(RECORDS, "records-page-copy", RecordsCommand::Copy)
                .key(Shortcut::ctrl('C'))
                .when(|session| has_chosen(session) || has_cursor(session) || session.records().opened_row().is_some()),
            Self::ReportRecords(number) => {
                let row = on(Page::Records, "export", RecordsCommand::Report(number))
                    .when(|session| 0 < session.records().reported() || (has_records(session) && !has_chosen(session)));
                if number == 0 { row.key(Shortcut::ctrl('S')) } else { row }
            }
            Self::CloseRecord => on(Page::Records, "records-page-close", RecordsCommand::CloseRecord)
                .when(|session| session.records().open.is_some()),
            Self::MeasureAgain => on(Page::Records, "records-page-measure-again", RecordsCommand::MeasureAgain)
                .hint("records-page-measure-again-hint")
                .when(|session| session.records().can_measure_again()),
            Self::CorrectRecord => on(Page::Records, "records-page-correct", RecordsCommand::Correct(true))
                .hint("records-page-correct-hint")
                .when(|session| session.records().can_correct() && session.records().correcting.is_none()),
            Self::SendCorrection => on(Page::Records, "records-page-send-correction", RecordsCommand::SendCorrection)
                .when(|session| session.records().correcting.as_ref().is_some_and(|form| form.run.is_none())),
            Self::LeaveCorrection => on(Page::Records, "records-page-leave-correction", RecordsCommand::Correct(false))
                .when(|session| session.records().correcting.is_some()),
            Self::WithdrawRecord => ActionRow::new(
                ActionScope::Page(Page::Records),
                "records-page-withdraw",
                Sends::FromState(|session| {
                    RecordsCommand::Withdraw(!session.records().correcting.as_ref().is_some_and(|form| form.withdraws))
                        .into()
                }),
            )
            .hint("records-page-withdraw-hint")
            .when(|session| session.records().correcting.is_some()),
            Self::VerifyRecords => on(Page::Records, "records-page-verify", RecordsCommand::Verify)
                .hint("records-page-verify-hint")
                .when(|session| session.recording().is_on() && !is_walking(session)),
            Self::CancelVerify => {
                on(Page::Records, "records-page-verify-cancel", RecordsCommand::CancelVerify).when(is_walking)
            }
            Self::AskForServer => ActionRow::new(
                ActionScope::Page(Page::Records),
                "records-page-server",
                Sends::FromState(|session| RecordsCommand::AskForServer(!session.recording().asks_for_server()).into()),
            )
            .hint("records-page-server-hint")
            .when(|session| session.recording().is_on()),
            Self::TakeServer => on(Page::Records, "records-page-take-server", RecordsCommand::TakeServer)
                .when(|session| !session.text(RecordsField::Server).trim().is_empty()),
            Self::LeaveServer => on(Page::Records, "records-page-leave-server", RecordsCommand::LeaveServer)
                .when(|session| session.recording().server().is_some()),
            Self::SendAgain => on(Page::Records, "records-page-send-again", RecordsCommand::SendAgain)
                .when(|session| session.recording().trouble().is_some()),
        }
    }

    fn name(&self, session: &Session, words: &Words) -> Option<String> {
        match *self {
            Self::ReportRecords(0) => Some(words.say(&match session.records().to_report() {
                0 => message!("records-page-report"),
                count => message!("records-page-report-of").text("count", grouped(long(count))),
            })),
            Self::ReportRecords(number) => report_name(number, words),
            Self::SendCorrection if session.records().correcting.as_ref().is_some_and(|form| form.withdraws) => {
                Some(words.get("records-page-withdraw"))
            }
            _ => None,
        }
    }

    fn is_on(&self, session: &Session) -> Option<bool> {
        Some(match *self {
            Self::AskRecords(shorthand) => session.records().has(shorthand),
            Self::AskForFilter => session.records().is_filtering,
            Self::WithSimulated => session.records().with_simulated,
            Self::WithdrawRecord => session.records().correcting.as_ref().is_some_and(|form| form.withdraws),
            _ => return None,
        })
    }

    fn on_enter(field: Field, _page: Page) -> Option<Self> {
        match field {
            Field::Records(RecordsField::Question | RecordsField::Who) => None,
            Field::Records(RecordsField::Filter) => Some(Self::AddFilter),
            Field::Records(RecordsField::Server) => Some(Self::TakeServer),
            Field::Records(_) => Some(Self::SendCorrection),
            _ => None,
        }
    }
}

fn has_records(session: &Session) -> bool {
    0 < session.records().listing.count()
}

fn has_cursor(session: &Session) -> bool {
    session.records().look().1.is_some()
}

fn has_chosen(session: &Session) -> bool {
    0 < session.records().chosen_count()
}

fn is_walking(session: &Session) -> bool {
    matches!(session.records().walk, Walk::Running { .. })
}
