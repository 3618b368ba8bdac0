//! What can be done on the fit page.

use fitcheck_core::tolerance::fit::search::Scope;
use fitcheck_core::tolerance::fit::thermal::Expansion;
use fitcheck_core::tolerance::{Feature, ToleranceClass};

use super::FitField;
use crate::Step;

/// What can be done on the fit page.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum FitCommand {
    /// Replaces the text of a field.
    Type(FitField, String),
    /// Takes a hole's and a shaft's class; the nominal size stays.
    TakePair(ToleranceClass, ToleranceClass),
    /// Takes a class for its side; the nominal size and the other side stay.
    ChooseClass(ToleranceClass),
    /// Takes the next class of the map that is shown, in the direction of an arrow.
    Move(Step),
    /// Shows the map of hole classes or of shaft classes.
    ShowClasses(Feature),
    /// Puts a material's expansion into the field of a part.
    ChooseExpansion(Feature, Expansion),
    /// Searches among these pairs.
    SearchAmong(Scope),
    /// Takes one side of the fit to the check page.
    Check(Feature),
}
