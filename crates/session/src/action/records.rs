//! The rows of the records page in the table of actions, and of what is recorded on every page.

use super::row::{Row, Sends, everywhere, on, within};
use super::{Key, Part, Place, Shortcut};
use crate::records::{Shorthand, Walk};
use crate::{Command, Page, Purpose, RecordsCommand, RecordsField, Session, Step};

pub(super) fn ask(shorthand: Shorthand) -> Row {
    let text = match shorthand {
        Shorthand::Today => "records-page-today",
        Shorthand::ThisWeek => "records-page-this-week",
        Shorthand::NotGood => "records-page-not-good",
        Shorthand::Measured => "records-page-measured-only",
    };
    on(Page::Records, text, RecordsCommand::Toggle(shorthand)).when(|session| session.recording().is_on())
}

pub(super) fn find() -> Row {
    on(Page::Records, "records-page-question", Command::GoTo(RecordsField::Question.into()))
        .key(Shortcut::ctrl('F'))
        .when(|session| session.recording().is_on())
}

pub(super) fn step(step: Step) -> Row {
    within(Part::Records, "records-page-move", RecordsCommand::Move(step)).when(has_records)
}

pub(super) fn open() -> Row {
    Row::new(
        Place::Part(Part::Records),
        "records-page-open",
        Sends::FromState(|session| RecordsCommand::Open(session.records().cursor().unwrap_or_default()).into()),
    )
    .key(Shortcut::plain(Key::Enter))
    .when(has_cursor)
}

pub(super) fn choose() -> Row {
    Row::new(
        Place::Part(Part::Records),
        "records-page-choose",
        Sends::FromState(|session| {
            let number = session.records().cursor().unwrap_or_default();
            RecordsCommand::Choose(number, !session.records().is_chosen(number)).into()
        }),
    )
    .key(Shortcut::plain(Key::Space))
    .when(has_cursor)
}

pub(super) fn choose_none() -> Row {
    on(Page::Records, "choose-none", RecordsCommand::ChooseNone).when(has_chosen)
}

pub(super) fn with_simulated() -> Row {
    Row::new(
        Place::Page(Page::Records),
        "records-page-with-simulated",
        Sends::FromState(|session| RecordsCommand::WithSimulated(!session.records().with_simulated()).into()),
    )
    .hint("records-page-with-simulated-hint")
}

pub(super) fn copy() -> Row {
    within(Part::Records, "records-page-copy", RecordsCommand::Copy)
        .key(Shortcut::ctrl('C'))
        .when(|session| has_chosen(session) || has_cursor(session) || session.records().opened_row().is_some())
}

pub(super) fn report(number: usize) -> Row {
    let row = on(Page::Records, "export", Command::OpenDialog(Purpose::ReportRecords(number)))
        .when(|session| 0 < session.records().reported());
    if number == 0 { row.key(Shortcut::ctrl('S')) } else { row }
}

pub(super) fn close() -> Row {
    on(Page::Records, "records-page-close", RecordsCommand::CloseRecord)
        .when(|session| session.records().opened().is_some())
}

pub(super) fn measure_again() -> Row {
    on(Page::Records, "records-page-measure-again", RecordsCommand::MeasureAgain)
        .hint("records-page-measure-again-hint")
        .when(|session| session.records().can_measure_again())
}

pub(super) fn correct() -> Row {
    on(Page::Records, "records-page-correct", RecordsCommand::Correct(true))
        .hint("records-page-correct-hint")
        .when(|session| session.records().can_correct() && session.records().correcting().is_none())
}

pub(super) fn send_correction() -> Row {
    on(Page::Records, "records-page-send-correction", RecordsCommand::SendCorrection)
        .when(|session| session.records().correcting().is_some_and(|form| form.run.is_none()))
}

pub(super) fn leave_correction() -> Row {
    on(Page::Records, "records-page-leave-correction", RecordsCommand::Correct(false))
        .when(|session| session.records().correcting().is_some())
}

pub(super) fn withdraw() -> Row {
    Row::new(
        Place::Page(Page::Records),
        "records-page-withdraw",
        Sends::FromState(|session| {
            RecordsCommand::Withdraw(!session.records().correcting().is_some_and(|form| form.withdraws)).into()
        }),
    )
    .hint("records-page-withdraw-hint")
    .when(|session| session.records().correcting().is_some())
}

pub(super) fn verify() -> Row {
    on(Page::Records, "records-page-verify", RecordsCommand::Verify)
        .hint("records-page-verify-hint")
        .when(|session| session.recording().is_on() && !is_walking(session))
}

pub(super) fn cancel_verify() -> Row {
    on(Page::Records, "records-page-verify-cancel", RecordsCommand::CancelVerify).when(is_walking)
}

pub(super) fn try_again() -> Row {
    everywhere("records-page-try-again", RecordsCommand::TryAgain.into())
        .when(|session| 0 < session.recording().failed() || session.recording().has_failed_to_open())
}

pub(super) fn ask_for_server() -> Row {
    Row::new(
        Place::Page(Page::Records),
        "records-page-server",
        Sends::FromState(|session| RecordsCommand::AskForServer(!session.recording().asks_for_server()).into()),
    )
    .hint("records-page-server-hint")
    .when(|session| session.recording().is_on())
}

pub(super) fn take_server() -> Row {
    on(Page::Records, "records-page-take-server", RecordsCommand::TakeServer)
        .when(|session| !session.text(RecordsField::Server).trim().is_empty())
}

pub(super) fn leave_server() -> Row {
    on(Page::Records, "records-page-leave-server", RecordsCommand::LeaveServer)
        .when(|session| session.recording().server().is_some())
}

pub(super) fn send_again() -> Row {
    on(Page::Records, "records-page-send-again", RecordsCommand::SendAgain)
        .when(|session| session.recording().trouble().is_some())
}

pub(super) fn take_name() -> Row {
    everywhere("records-page-take-name", RecordsCommand::TakeName.into())
        .when(|session| !session.text(RecordsField::Who).trim().is_empty())
}

fn has_records(session: &Session) -> bool {
    0 < session.records().listing().count()
}

fn has_cursor(session: &Session) -> bool {
    session.records().look().1.is_some()
}

fn has_chosen(session: &Session) -> bool {
    0 < session.records().chosen_count()
}

fn is_walking(session: &Session) -> bool {
    matches!(session.records().walk(), Walk::Running { .. })
}
