//! Errors and warnings for a program.

use fitcheck_core::message::{Located, Say};

use super::block::{Target, Unit};
use super::fault::BlockFault;
use crate::control::variables::Parameter;

/// Why a file is not a program at all.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(prefix = "program", error)]
pub enum ProgramError {
    /// The file is empty.
    Empty,
    /// More MiB than any measuring program needs.
    TooLarge {
        /// What is allowed.
        most: usize,
    },
    /// More lines than any measuring program needs.
    TooManyLines {
        /// What is allowed.
        most: usize,
    },
    /// Too many bytes that do not occur in text.
    Binary {
        /// How many bytes are not characters.
        controls: usize,
        /// How many there are.
        bytes: usize,
    },
}

/// A warning about a program, with line and column.
pub type ProgramWarning = Located<ProgramWarningKind>;

/// A warning about a program that can still be read.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(prefix = "program", error)]
pub enum ProgramWarningKind {
    /// The first block is not `BEGIN PGM`.
    NoBegin,
    /// There is a second `BEGIN PGM`.
    SecondBegin,
    /// `END PGM` does not occur.
    NoEnd,
    /// Beginning and end have different units.
    Units {
        /// The unit of `BEGIN PGM`: this one counts.
        begin: Unit,
        /// The unit of `END PGM`.
        end: Unit,
    },
    /// A section that every program of a lathe control has.
    NoSection {
        /// What does not occur.
        section: &'static str,
    },
    /// The head does not say whether the program is in millimetres or inches.
    NoUnit,
    /// Something other than a subprogram follows `ENDE`.
    AfterLastSection,
    /// A comment without its closing bracket.
    UnclosedComment,
    /// Something follows `END PGM`.
    AfterEnd,
    /// Block numbers that do not rise; reported once.
    Numbers {
        /// The first number that does not rise.
        number: u32,
        /// The number before it.
        previous: u32,
        /// How many there are in all.
        count: usize,
    },
    /// A label is defined again; using it is an error.
    LabelAgain {
        label: Target,
        /// Where it is defined first.
        first: usize,
    },
    /// A quotation mark without its partner.
    UnclosedQuote,
    /// The file ends after a `~`.
    OpenEnd,
    /// A line of a cycle that does not belong to it, because the line before has no `~`.
    CycleCut {
        cycle: String,
        /// The cycle's last line.
        line: usize,
        /// What is assigned.
        parameter: Parameter,
    },
    /// Several lines of a cycle that do not belong to it, because the line before them has no `~`.
    CycleCutMany {
        cycle: String,
        /// The cycle's last line.
        line: usize,
        /// What is assigned first.
        parameter: Parameter,
        /// The last of these lines.
        last: usize,
    },
    /// A block of an ISO program without the `*` at its end.
    NoStar,
    /// An ISO program without its last block, `N99999999 %NAME G71 *`.
    IsoNoEnd,
    /// Beginning and end of an ISO program have different units.
    IsoUnits {
        /// The unit of the first block: this one counts.
        begin: Unit,
        /// The unit of the last block.
        end: Unit,
    },
    /// Something follows the last block of an ISO program.
    IsoAfterEnd,
    /// An assignment where a line of a cycle in ISO would stand, after its `*`.
    IsoCycleCut {
        cycle: String,
        /// The cycle's last line.
        line: usize,
        /// What is assigned.
        parameter: Parameter,
    },
    /// A comment holds what seems to be part of the program: it goes on to the end of its line.
    CommentHolds {
        /// What it holds.
        found: String,
    },
    /// Lines of a machining cycle or of global values without the `~` before them; they count as its lines.
    CycleWithoutTilde {
        cycle: String,
        /// The cycle's last line before it.
        line: usize,
    },
    /// A block that is no cycle ends in `~`, so a block behind it would be part of it.
    BlockGoesOn,
    /// A comment ends in `~`, so a block behind it would be part of the comment.
    CommentGoesOn,
    /// A block of a known kind that cannot be understood; it is kept as text.
    NotUnderstood(#[say(name = "reason")] BlockFault),
    /// Too many to list.
    More {
        /// How many.
        count: usize,
    },
}

/// Why a label cannot be jumped to.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(prefix = "program-label", error)]
pub enum LabelFault {
    /// It does not occur.
    Missing { label: Target },
    /// It occurs more than once.
    Twice {
        label: Target,
        /// The line where it occurs first.
        first: usize,
        /// The line where it occurs again.
        second: usize,
    },
    /// `LBL 0` ends subprograms and cannot be a destination.
    Zero,
    /// The parameter must first be replaced by its value.
    Parameter {
        /// The parameter.
        label: Target,
    },
}
