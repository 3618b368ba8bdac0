//! What can be done on the check page.

use fitcheck_core::message::Message;
use fitcheck_core::tolerance::fit::thermal::Expansion;
use fitcheck_core::tolerance::{Feature, ToleranceClass};
use fitcheck_core::verdict::rules::{Prover, RuleName};
use fitcheck_exchange::exchange::Imported;
use fitcheck_exchange::journal::query::RecordId;

use super::{CheckField, MeasureBy, UncertaintyFrom};
use crate::{ListCommand, RowsCommand, Step};

/// What can be done on the check page.
#[derive(Debug, Clone)]
pub enum CheckCommand {
    /// Replaces the text of a field, and takes the result away: it was made with another text.
    Type(CheckField, String),
    /// Takes a class from the chooser; the nominal size stays.
    ChooseClass(ToleranceClass),
    /// Says whether a hole or a shaft is meant, for a callout that does not say it; a value that waits for it is judged again.
    ChooseFeature(Option<Feature>),
    /// Judges every value of the file that is out of limits and waits for it as a hole or a shaft.
    JudgeAllAs(Feature),
    /// Chooses where the next measurement comes from.
    MeasureBy(MeasureBy),
    /// Chooses the decision rule.
    UseRule(RuleName),
    /// Says who has to prove.
    LetProve(Prover),
    /// Chooses how the uncertainty is told.
    TellUncertainty(UncertaintyFrom),
    /// Puts a material's expansion into a field.
    ChooseExpansion(CheckField, Expansion),
    /// Measures and judges. A typed value that may be another quantity is asked about first; a second time judges it.
    Measure,
    /// Takes what the typed value may have been instead of it, and judges that.
    TakeMeant,
    /// Takes what a doubted text probably means instead of it, and judges by that.
    TakeText,
    /// Judges by a doubted text as it stands.
    KeepText,
    /// Clears the result and the typed value; the history stays.
    Clear,
    /// Puts the status window's text on the clipboard.
    CopyStatus,
    /// Shows a record of the history again.
    Show(RecordId),
    /// Shows another row of the imported file: the first is the worst.
    ShowInLot(Step),
    /// Marks a record for the report, or takes the mark off.
    Choose(RecordId, bool),
    /// Does something with the list of the history.
    List(ListCommand),
    /// Empties the history.
    ClearHistory,
    /// Undoes the last change of the history.
    Undo,
    /// A file of measurements was read and understood, or not.
    Imported {
        /// Its name without the folder.
        name: String,
        /// What it holds.
        result: Result<Box<Imported>, Message>,
    },
    /// Does something with the rows of a large file.
    Rows(RowsCommand),
}
