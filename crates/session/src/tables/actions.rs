//! What can be done on the table page.

use fitcheck_core::message::message;
use fitcheck_core::text::sentence;
use fitcheck_core::tolerance::{Deviations, ToleranceClass};
use fitcheck_core::words::Words;
use fitcheck_exchange::exchange::tables::TABLE_FORMATS;

use super::{Document, TablesCommand, TablesField};
use crate::Session;
use crate::action::row::{ActionRow, Actions, Sends, actions, keys, on, within};
use crate::action::{ActionScope, Held, Key, Part, Shortcut};
use crate::command::Command;
use crate::field::Field;
use crate::page::Page;
use crate::purpose::Purpose;
use crate::step::Step;

/// The cells of the table.
pub const CELLS: Part = Part::cells(Page::Tables, "table-grid");

actions! {
    /// What can be done on the table page.
    TablesAction

    /// Reads a table.
    OpenTable;
    /// Writes the shown table in a format of the tables' list, by its number there.
    SaveTable(usize): 0..TABLE_FORMATS.len();
    /// Undoes the last edit of the shown table.
    UndoEdit;
    RedoEdit;
    /// Looks limits up in the shown table first.
    UseTable;
    /// Goes to the filter.
    FindInTable;
    /// Shows only what differs from ISO 286, or everything.
    OnlyDifferences;
    /// Selects the previous cell that differs from ISO 286.
    PreviousDifference;
    /// Selects the next one.
    NextDifference;
    /// Goes to another cell.
    MoveCell(Step): Step::CELLS;
    /// Goes to the fields of the cell.
    EditCell;
    /// Puts the fields into the cell.
    SetCell;
    /// Puts what ISO 286 says into the cell.
    TakeStandard;
    /// Empties the cell.
    EmptyCell;
    /// Adds classes to the shown table.
    AddColumns;
    /// Removes the selected cell's class.
    RemoveColumn;
    /// Makes a table from ISO 286.
    MakeTable;
}

impl Actions for TablesAction {
    fn row(&self) -> ActionRow {
        match *self {
            Self::OpenTable => on(Page::Tables, "tables-open", open(Purpose::OpenTable)).key(Shortcut::ctrl('O')),
            Self::SaveTable(number) => {
                let row = on(Page::Tables, "tables-save", open(Purpose::SaveTable(number))).when(has_table);
                if number == 0 { row.key(Shortcut::ctrl('S')) } else { row }
            }
            Self::UndoEdit => on(Page::Tables, "undo", TablesCommand::Undo)
                .key(Shortcut::ctrl('Z'))
                .when(|session| session.tables().shown().is_some_and(Document::can_undo)),
            Self::RedoEdit => on(Page::Tables, "tables-redo", TablesCommand::Redo)
                .keys(Shortcut::ctrl('Y'), Shortcut { held: Held::CtrlShift, key: Key::Character('Z') })
                .when(|session| session.tables().shown().is_some_and(Document::can_redo)),
            Self::UseTable => on(Page::Tables, "tables-use", TablesCommand::Use)
                .when(|session| has_table(session) && !session.tables().is_used(session.sources())),
            Self::FindInTable => on(Page::Tables, "tables-filter", Command::GoTo(TablesField::Filter.into()))
                .key(Shortcut::ctrl('F'))
                .when(has_table),
            Self::OnlyDifferences => ActionRow::new(
                ActionScope::Page(Page::Tables),
                "tables-only-differences",
                Sends::FromState(|session| {
                    TablesCommand::OnlyDifferences(!session.tables().shows_only_differences()).into()
                }),
            )
            .when(differs),
            Self::PreviousDifference => on(Page::Tables, "tables-previous", TablesCommand::PreviousDifference)
                .key(Shortcut::shift(Key::Function(8)))
                .when(differs),
            Self::NextDifference => on(Page::Tables, "tables-next", TablesCommand::NextDifference)
                .key(Shortcut::plain(Key::Function(8)))
                .when(differs),
            Self::MoveCell(step) => within(CELLS, "tables-move", TablesCommand::Move(step)).key(keys(step)),
            Self::EditCell => within(CELLS, "tables-edit-cell", Command::GoTo(TablesField::CellUpper.into()))
                .keys(Shortcut::plain(Key::Enter), Shortcut::plain(Key::Function(2)))
                .when(has_cell),
            Self::SetCell => on(Page::Tables, "tables-set", TablesCommand::SetCell).when(has_cell),
            Self::TakeStandard => {
                on(Page::Tables, "tables-take-standard", TablesCommand::TakeStandard).when(|session| {
                    let standard =
                        selected(session).and_then(|(document, (class, range))| document.standard(class, range));
                    standard.is_some() && standard != cell(session)
                })
            }
            Self::EmptyCell => within(CELLS, "tables-empty-cell", TablesCommand::EmptyCell)
                .key(Shortcut::plain(Key::Delete))
                .when(|session| cell(session).is_some()),
            Self::AddColumns => on(Page::Tables, "tables-add-columns", TablesCommand::AddColumns).when(has_table),
            Self::RemoveColumn => on(Page::Tables, "tables-remove-column", TablesCommand::RemoveColumn).when(has_cell),
            Self::MakeTable => on(Page::Tables, "tables-make", TablesCommand::Make),
        }
    }

    fn name(&self, session: &Session, words: &Words) -> Option<String> {
        match *self {
            Self::SaveTable(number) => {
                Some(sentence(&format!("{}…", words.get(TABLE_FORMATS.get(number)?.description))))
            }
            Self::RemoveColumn => {
                let class = selected(session).map(|(_, (class, _))| class.to_string());
                let class = class.unwrap_or_else(|| words.get("class-none"));
                Some(words.say(&message!("tables-remove-column").text("class", class)))
            }
            Self::UseTable if session.tables().is_used(session.sources()) => Some(words.get("tables-in-use")),
            _ => None,
        }
    }

    fn is_on(&self, session: &Session) -> Option<bool> {
        (*self == Self::OnlyDifferences).then(|| session.tables().shows_only_differences())
    }

    fn on_enter(field: Field, _page: Page) -> Option<Self> {
        match field {
            Field::Tables(TablesField::CellUpper | TablesField::CellLower) => Some(Self::SetCell),
            Field::Tables(TablesField::To) => Some(Self::MakeTable),
            _ => None,
        }
    }
}

const fn open(purpose: Purpose) -> Command {
    Command::OpenDialog(purpose)
}

fn has_table(session: &Session) -> bool {
    session.tables().shown().is_some()
}

fn differs(session: &Session) -> bool {
    session.tables().shown().is_some_and(|document| 0 < document.differing())
}

type Selected<'a> = (&'a Document, (ToleranceClass, usize));

fn selected(session: &Session) -> Option<Selected<'_>> {
    let document = session.tables().shown()?;
    Some((document, document.selected?))
}

fn has_cell(session: &Session) -> bool {
    selected(session).is_some()
}

/// What is in the selected cell.
fn cell(session: &Session) -> Option<Deviations> {
    let (document, (class, range)) = selected(session)?;
    document.cell(class, range)
}
