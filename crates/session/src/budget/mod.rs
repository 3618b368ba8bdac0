//! The budget page: how sure a measured value is, and what would help most.
//!
//! | file | what |
//! |---|---|
//! | here | the state |
//! | `field` | the text fields |
//! | `command`, `apply` | what can be done, and doing it |
//! | `lines` | the contributions as the text has them, changed one line at a time |
//! | `table` | the same as a table: which one is open, and what its fields do to the text |
//! | `document` | the text of the budget, and its file |
//! | `answering` | from text and fields to the answer: read anew at every change |
//! | `contacts`, `readings` | what is taken from elsewhere: contacts, and readings of a calibrated piece |
//! | `picture` | the bars, and what would help most |
//! | `using` | which budget checks use |

mod actions;
mod answering;
mod apply;
mod command;
mod contacts;
mod document;
mod field;
mod lines;
mod open;
mod picture;
mod readings;
mod table;
mod using;

use std::collections::BTreeMap;
use std::path::PathBuf;

use fitcheck_core::budget::{Assessment, Basis, Budget, BudgetError};
use fitcheck_core::message::{Located, Message};
use jiff::civil::Date;

pub use actions::BudgetAction;
pub use command::BudgetCommand;
pub use contacts::TakenContacts;
pub use document::BudgetDocument;
pub use field::BudgetField;
pub use lines::WrittenContribution;
pub use open::OpenBudget;
pub use picture::{Bar, advice, bars};
pub use readings::{BothSizes, Readings};
pub use table::{BudgetView, GivenAs, KindChoice};
pub use using::{BudgetForce, UseOf};

use self::readings::Source;
use super::document::OpenDocument;
use super::texts::Texts;

/// What a budget asks for besides its text: as long as the text cannot be read, what it asked for before.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Asks {
    /// The measured size.
    pub size: bool,
    pub contacts: bool,
    /// Readings of a calibrated piece.
    pub readings: bool,
}

/// The state of the budget page.
#[derive(Debug, Default)]
pub struct BudgetPage {
    texts: Texts<BudgetField>,
    errors: BTreeMap<BudgetField, Message>,
    pub document: OpenDocument<BudgetDocument>,
    /// `None` while there is no text.
    pub read: Option<Result<Budget, Located<BudgetError>>>,
    /// Whether the budget is shown as a table or as text.
    pub shows: BudgetView,
    /// The contributions as the text has them; as long as it cannot be read, as it had them before.
    pub rows: Vec<WrittenContribution>,
    /// Whether the text has its contributions in another way than the table can change.
    pub is_other: bool,
    /// The contribution that is open in the table.
    pub chosen: Option<usize>,
    /// What the budget asks for besides its text.
    pub asks: Asks,
    /// The contacts that were taken over.
    pub contacts: Option<TakenContacts>,
    source: Option<Source>,
    /// The readings that take the place of those of the budget.
    pub readings: Option<Readings>,
    /// `None` while text or fields cannot be read.
    pub answer: Option<Result<Assessment, Message>>,
    today: Date,
    /// The file of the budget that checks use.
    used_file: Option<PathBuf>,
    /// Whether that file is being read at the start.
    awaits_used: bool,
}

impl BudgetPage {
    /// The day that it is evaluated for: today, unless another one is given.
    pub fn day_shown(&self) -> String {
        let given = self.texts.text(BudgetField::Day).trim();
        if given.is_empty() { self.today.to_string() } else { given.to_owned() }
    }

    /// How many readings the budget itself has.
    pub fn own_readings(&self) -> usize {
        match &self.read {
            Some(Ok(Budget { basis: Basis::Calibrated(piece), .. })) => piece.readings.len(),
            _ => 0,
        }
    }

    /// What it comes to.
    pub fn found(&self) -> Option<&Assessment> {
        self.answer.as_ref()?.as_ref().ok()
    }
}
