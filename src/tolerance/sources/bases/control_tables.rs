//! The control's tables as a source of limits. They are handed in: reading them belongs to the room of the control.

use super::Declaration;

pub(super) const DECLARATION: Declaration = Declaration {
    name: "control",
    help: "The control's two tables, 47 classes to 400 mm",
    text: "source-choice-control",
    standard: None,
};
