//! The text fields of the program page.

use fitcheck_nc::control::variables::Parameter;

use super::input::Input;

/// A text field of the program page.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum ProgramField {
    /// An input of 8255.
    Input(Input),
    /// The tool that is given to a parameter of Q330.
    Tool(Parameter),
    /// Diameter of the workpiece, mm.
    Diameter,
    /// Where its centre really lies, X, mm.
    WorkpieceX,
    /// The same in Y.
    WorkpieceY,
    /// Which parameters are listed.
    Filter,
    /// The parameter that is given a value before a run.
    Name,
    Value,
}
