//! What can be done on the check page.

use fitcheck_core::length::Length;
use fitcheck_core::message::{Message, message};
use fitcheck_core::tolerance::Feature;
use fitcheck_core::words::Words;
use fitcheck_exchange::batch::FORMS;
use fitcheck_exchange::exchange::batch::RowFate;
use fitcheck_exchange::journal::query::Column;

use super::{CheckCommand, CheckField, Lot, MeasureBy};
use crate::Session;
use crate::action::possible::{can_export_rows, has_history, has_status};
use crate::action::row::{ActionRow, Actions, Sends, actions, keys, on, within};
use crate::action::{ActionScope, Held, Key, Part, Shortcut};
use crate::command::Command;
use crate::field::Field;
use crate::history::ListCommand;
use crate::page::Page;
use crate::purpose::Purpose;
use crate::recording::Recorded;
use crate::records::RecordsCommand;
use crate::rows::{Rows, RowsCommand, row_forms};
use crate::step::Step;

/// The list of checks.
pub const HISTORY: Part = Part::list(Page::Check, "history-list");

/// The list of the rows of a large file, in its place.
pub const ROWS: Part = Part::list(Page::Check, "rows-list");

actions! {
    /// What can be done on the check page.
    CheckAction

    /// Judges the typed value, or measures the simulated workpiece and judges that.
    Measure;
    /// Judges a typed value that was asked about, as it is.
    JudgeAnyway;
    /// Takes what a typed value may have been instead of it.
    TakeMeant;
    /// Takes what a doubted text probably means instead of it.
    TakeText;
    /// Judges by a doubted text as it stands.
    KeepText;
    /// Shows another row of the imported file, worst first.
    ShowInLot(Step): Step::PATH;
    /// Says hole or shaft of every value of the imported file that waits for it.
    JudgeAllAs(Feature): [Feature::Hole, Feature::Shaft];
    ClearResult;
    /// Chooses where the next measurement comes from.
    MeasureBy(MeasureBy): [MeasureBy::Typing, MeasureBy::Simulating];
    /// Puts the status window's text on the clipboard.
    CopyStatus;
    /// Goes to the filter of the history, or of the rows in its place.
    FindInHistory;
    /// Leaves the good checks out of the list.
    OnlyBad;
    /// Sorts the list by a column.
    SortHistory(Column): Column::ALL;
    /// Goes to another check of the list.
    MoveCheck(Step): Step::BLOCKS;
    /// Shows the check again.
    ShowCheck;
    /// Opens the form that corrects the shown check, or the one at which the keys are.
    CorrectCheck;
    /// Chooses the check for export, or not.
    ChooseCheck;
    /// Chooses every check of the list.
    ChooseAll;
    /// Puts the chosen checks, or the one at which the keys are, on the clipboard.
    CopyChecks;
    /// Shows the history, or the rows of the large file in its place.
    ShowRows(bool): [true, false];
    /// Cancels the run over a large file.
    CancelRows;
    /// Judges the large file once more.
    JudgeRowsAgain;
    /// Forgets the large file.
    CloseRows;
    /// Lists rows of a fate, or no longer.
    ListRows(RowFate): RowFate::ALL;
    /// Lists the rows of all classes.
    ListAllClasses;
    /// Puts the worst row first, or leaves the rows in the order of the file.
    WorstFirst;
    /// Shows the worst row.
    ShowWorstRow;
    /// Writes the listed rows in a form of text.
    ExportRows(usize): row_forms();
    /// Goes to another row of the large file.
    MoveRow(Step): Step::BLOCKS;
    /// Shows the check of the row.
    ShowRow;
    /// Adds the check of the shown row to the history.
    KeepRow;
}

impl Actions for CheckAction {
    #[expect(clippy::too_many_lines, reason = "one row for everything that can be done")]
    fn row(&self) -> ActionRow {
        match *self {
            Self::Measure => on(Page::Check, "judge", CheckCommand::Measure),
            Self::JudgeAnyway => on(Page::Check, "judge-anyway", CheckCommand::Measure)
                .when(|session| session.check().question.is_some()),
            Self::TakeMeant => on(Page::Check, "take-meant", CheckCommand::TakeMeant).when(|session| {
                session.check().question.as_ref().is_some_and(|question| question.doubt.meant().is_some())
            }),
            Self::TakeText => on(Page::Check, "take-text", CheckCommand::TakeText)
                .when(|session| session.check().doubted().is_some_and(|doubted| doubted.meant.is_some())),
            Self::KeepText => on(Page::Check, "keep-text", CheckCommand::KeepText)
                .when(|session| session.check().doubted().is_some_and(|doubted| doubted.can_stay)),
            Self::JudgeAllAs(feature) => {
                let text = match feature {
                    Feature::Hole => "check-all-holes",
                    Feature::Shaft => "check-all-shafts",
                };
                on(Page::Check, text, CheckCommand::JudgeAllAs(feature))
                    .when(|session| !session.check().open_of_lot(session.history()).is_empty())
            }
            Self::ShowInLot(step) => {
                let (text, possible): (_, fn(&Session) -> bool) = match step {
                    Step::First => ("lot-worst", is_after_worst),
                    Step::Left => ("lot-worse", is_after_worst),
                    Step::Right => ("lot-better", is_before_best),
                    _ => ("lot-best", is_before_best),
                };
                let row = on(Page::Check, text, CheckCommand::ShowInLot(step)).when(possible);
                row.key(Shortcut { held: Held::Alt, ..keys(step) })
            }
            Self::ClearResult => on(Page::Check, "clear", CheckCommand::Clear),
            Self::MeasureBy(by) => {
                let text = match by {
                    MeasureBy::Typing => "by-typing",
                    MeasureBy::Simulating => "by-simulating",
                };
                on(Page::Check, text, CheckCommand::MeasureBy(by))
            }
            Self::CopyStatus => on(Page::Check, "copy", CheckCommand::CopyStatus).when(has_status),
            Self::FindInHistory => ActionRow::new(
                ActionScope::Page(Page::Check),
                "history-filter",
                Sends::FromState(|session| {
                    let rows = session.check().shows_rows();
                    Command::GoTo(if rows { CheckField::RowsFilter } else { CheckField::HistoryFilter }.into())
                }),
            )
            .key(Shortcut::ctrl('F'))
            .when(|session| session.check().shows_rows() || has_history(session)),
            Self::OnlyBad => ActionRow::new(
                ActionScope::Page(Page::Check),
                "history-only-bad",
                Sends::FromState(|session| ListCommand::OnlyBad(!session.history().listed().query().only_bad).into()),
            )
            .hint("history-only-bad-hint"),
            Self::SortHistory(column) => {
                let text = match column {
                    Column::Time => "head-time",
                    Column::Part => "head-part",
                    Column::Callout => "head-callout",
                    Column::Measured => "head-measured",
                    Column::Deviation => "head-deviation",
                    Column::Status => "head-status",
                    Column::From => "head-from",
                };
                on(Page::Check, text, ListCommand::SortBy(column)).hint("history-sort-hint")
            }
            Self::MoveCheck(step) => {
                within(HISTORY, "history-move", ListCommand::Move(step)).key(keys(step)).when(has_listed)
            }
            Self::ShowCheck => ActionRow::new(
                ActionScope::Part(HISTORY),
                "history-show",
                Sends::AtCursor(|session| Some(CheckCommand::Show(session.history().cursor?).into())),
            )
            .key(Shortcut::plain(Key::Enter))
            .when(has_cursor),
            Self::CorrectCheck => ActionRow::new(
                ActionScope::Page(Page::Check),
                "records-page-correct",
                Sends::AtCursor(|session| Some(RecordsCommand::CorrectNumber(correctable(session)?).into())),
            )
            .hint("records-page-correct-hint")
            .when(|session| correctable(session).is_some()),
            Self::ChooseCheck => ActionRow::new(
                ActionScope::Part(HISTORY),
                "history-choose",
                Sends::AtCursor(|session| {
                    let id = session.history().cursor?;
                    Some(CheckCommand::Choose(id, !session.history().is_chosen(id)).into())
                }),
            )
            .key(Shortcut::plain(Key::Space))
            .when(has_cursor),
            Self::ChooseAll => {
                within(HISTORY, "choose-all", ListCommand::ChooseAll).key(Shortcut::ctrl('A')).when(has_listed)
            }
            Self::CopyChecks => within(HISTORY, "copy-checks", ListCommand::Copy)
                .key(Shortcut::ctrl('C'))
                .when(|session| 0 < session.history().chosen_count() || has_cursor(session)),
            Self::ShowRows(shows_rows) => {
                let text = if shows_rows { "rows" } else { "history" };
                on(Page::Check, text, RowsCommand::Show(shows_rows)).when(|session| session.check().rows.is_some())
            }
            Self::CancelRows => on(Page::Check, "rows-cancel", RowsCommand::Cancel)
                .key(Shortcut::plain(Key::Escape))
                .when(|session| session.check().rows.as_ref().is_some_and(Rows::is_running)),
            Self::JudgeRowsAgain => on(Page::Check, "rows-again", RowsCommand::Again)
                .when(|session| session.check().rows.as_ref().is_some_and(|rows| !rows.is_running())),
            Self::CloseRows => on(Page::Check, "rows-close", RowsCommand::Close)
                .hint("rows-close-hint")
                .when(|session| session.check().rows.is_some()),
            Self::ListRows(fate) => on(Page::Check, "rows-fate-only", RowsCommand::Fate(fate))
                .hint("rows-fate-hint")
                .when(|session| session.check().shows_rows()),
            Self::ListAllClasses => on(Page::Check, "rows-all-classes", RowsCommand::AllClasses)
                .when(|session| session.check().rows.as_ref().is_some_and(|rows| !rows.filter.classes.is_empty())),
            Self::WorstFirst => ActionRow::new(
                ActionScope::Page(Page::Check),
                "rows-worst-first",
                Sends::FromState(|session| {
                    let is_on = session.check().rows.as_ref().is_some_and(Rows::is_worst_first);
                    RowsCommand::WorstFirst(!is_on).into()
                }),
            )
            .hint("rows-worst-first-hint")
            .when(|session| session.check().shows_rows()),
            Self::ShowWorstRow => on(Page::Check, "rows-worst", RowsCommand::Worst).when(|session| {
                session.check().shows_rows() && session.check().rows.as_ref().is_some_and(|rows| rows.worst().is_some())
            }),
            Self::ExportRows(form) => {
                on(Page::Check, "export", Command::OpenDialog(Purpose::ExportRows(form))).when(can_export_rows)
            }
            Self::MoveRow(step) => within(ROWS, "rows-move", RowsCommand::Move(step)).key(keys(step)).when(has_rows),
            Self::ShowRow => ActionRow::new(
                ActionScope::Part(ROWS),
                "rows-show",
                Sends::AtCursor(|session| Some(RowsCommand::Check(session.check().rows.as_ref()?.cursor?).into())),
            )
            .key(Shortcut::plain(Key::Enter))
            .when(|session| session.check().rows.as_ref().is_some_and(|rows| rows.look().1.is_some())),
            Self::KeepRow => on(Page::Check, "rows-keep", RowsCommand::Keep).when(|session| {
                session
                    .check()
                    .rows
                    .as_ref()
                    .and_then(|rows| rows.shown.as_ref())
                    .is_some_and(|row| row.record.is_some())
            }),
        }
    }

    fn name(&self, session: &Session, words: &Words) -> Option<String> {
        let mm = |length: Option<Length>| length.map_or_else(String::new, |length| words.mm(length, 3));
        let message = match self {
            // Nobody measures a typed value here.
            Self::Measure if session.check().by == MeasureBy::Simulating => message!("measure"),
            Self::JudgeAnyway | Self::TakeMeant => {
                let question = session.check().question.as_ref();
                Message::new(self.row().text)
                    .text("measured", mm(question.map(|question| question.measured)))
                    .text("meant", mm(question.and_then(|question| question.doubt.meant())))
            }
            Self::TakeText | Self::KeepText => {
                let number = |text: Option<&String>| text.map_or_else(String::new, |text| words.number(text));
                let doubted = session.check().doubted();
                Message::new(self.row().text)
                    .text("given", number(doubted.map(|doubted| &doubted.text)))
                    .text("meant", number(doubted.and_then(|doubted| doubted.meant.as_ref())))
            }
            Self::ListRows(fate) => {
                let fate = fate.status().map_or_else(|| words.get("rows-not-judged"), |status| words.told(&status));
                Message::new(self.row().text).text("fate", fate)
            }
            Self::ExportRows(form) => {
                let (_, name, _) = FORMS.get(*form)?;
                message!("rows-export").text("format", name.to_uppercase())
            }
            _ => return None,
        };
        Some(words.say(&message))
    }

    fn is_on(&self, session: &Session) -> Option<bool> {
        Some(match *self {
            Self::ShowRows(shows_rows) => session.check().shows_rows() == shows_rows,
            Self::ListRows(fate) => session.check().rows.as_ref().is_some_and(|rows| rows.filter.fates.contains(&fate)),
            Self::WorstFirst => session.check().rows.as_ref().is_some_and(Rows::is_worst_first),
            Self::OnlyBad => session.history().listed().query().only_bad,
            Self::MeasureBy(by) => session.check().by == by,
            _ => return None,
        })
    }

    fn on_enter(field: Field, page: Page) -> Option<Self> {
        // Some fields also stand on the settings page: there nothing is measured.
        if page != Page::Check {
            return None;
        }
        Some(match field {
            Field::Check(CheckField::HistoryFilter | CheckField::RowsFilter) => return None,
            Field::Check(_) => Self::Measure,
            _ => return None,
        })
    }
}

fn is_after_worst(session: &Session) -> bool {
    session.check().lot.as_ref().and_then(Lot::shown).is_some_and(|(place, _)| 1 < place)
}

fn is_before_best(session: &Session) -> bool {
    session.check().lot.as_ref().is_some_and(|lot| lot.shown().is_some_and(|(place, _)| place < lot.judged()))
}

fn has_listed(session: &Session) -> bool {
    0 < session.history().listed().count()
}

/// The record of the shown check, or of the one at which the keys are, where it stands.
fn correctable(session: &Session) -> Option<u64> {
    let history = session.history();
    let shown = session.check().shown.as_ref().map_or(history.cursor, |shown| shown.id);
    match session.recording().of_check(shown.filter(|id| history.replaced_by(*id).is_none())?)? {
        Recorded::Kept(number) if session.records().correcting.is_none() => Some(number),
        _ => None,
    }
}

fn has_rows(session: &Session) -> bool {
    session.check().shows_rows() && session.check().rows.as_ref().is_some_and(|rows| 0 < rows.listed())
}

/// Whether the keys are at a row of the list.
fn has_cursor(session: &Session) -> bool {
    session.history().look().1.is_some()
}
