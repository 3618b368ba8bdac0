//! The control's tables as a source of limits. They are passed in; the room of the control reads them.

use super::Declaration;

pub(super) const DECLARATION: Declaration = Declaration {
    name: "control",
    help: "The control's two tables, 47 classes to 400 mm",
    text: "source-choice-control",
    standard: None,
};
