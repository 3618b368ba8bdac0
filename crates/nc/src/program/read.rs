//! From bytes to blocks, with warnings: text, notation, labels. The notations read the blocks.

use super::error::{ProgramError, ProgramWarning, ProgramWarningKind};
use super::labels::Labels;
use super::lines::Lines;
use super::notation::Notation;
use super::place::TextPlace;
use super::source::Source;
use super::warnings::Warnings;
use super::{Encoding, Program, din_plus, iso, klartext};

/// The largest file, 64 MiB: a program of about two million blocks.
const LARGEST: usize = 64 << 20;
const MOST_LINES: usize = 2_000_000;

impl Program {
    /// Reads a program in any notation: UTF-8 or Windows-1252, any line ends. Text is never an error; there is a list of
    /// warnings.
    ///
    /// ```
    /// use fitcheck_nc::program::{Body, Program, Target};
    ///
    /// let text = "0 BEGIN PGM fit MM\n1 LBL 11\n2 BLK FORM 0.1 Z X+0 Y+0 Z-20\n3 END PGM fit MM\n";
    /// let (program, warnings) = Program::read(text.as_bytes())?;
    /// assert!(warnings.is_empty());
    /// assert_eq!(program.blocks()[1].body, Body::Label(Target::Number(11)));
    /// assert!(matches!(program.blocks()[2].body, Body::PassedOver(_)));
    /// assert_eq!(program.label(&Target::Number(11)), Ok(1));
    /// assert_eq!(program.write(), text.as_bytes());
    /// # Ok::<(), fitcheck_nc::program::ProgramError>(())
    /// ```
    ///
    /// # Errors
    /// [`ProgramError`] if the file is empty, larger than 64 MiB or 2 million lines, or not a text.
    pub fn read(bytes: &[u8]) -> Result<(Self, Vec<ProgramWarning>), ProgramError> {
        if LARGEST < bytes.len() {
            return Err(ProgramError::TooLarge { most: LARGEST >> 20 });
        }
        is_text(bytes)?;
        let (text, encoding) = Encoding::decode(bytes);
        let lines = Lines::of(&text, MOST_LINES).ok_or(ProgramError::TooManyLines { most: MOST_LINES })?;
        let notation = notation_of(&text, &lines);
        let mut warnings = Warnings::default();
        let source = Source::new(&text, &lines, &mut warnings);
        let (blocks, has_unit) = match notation {
            Notation::Klartext => (klartext::read(source), true),
            Notation::Iso => (iso::read(source), true),
            Notation::DinPlus => din_plus::read(source),
        };
        if blocks.is_empty() {
            return Err(ProgramError::Empty);
        }
        let (labels, twice) = Labels::of(&blocks);
        for again in twice {
            let place = TextPlace { line: again.line, column: 1 };
            warnings.add(place, || ProgramWarningKind::LabelAgain { label: again.label.clone(), first: again.first });
        }
        let program = Self { text, encoding, lines, notation, blocks, labels, has_unit };
        Ok((program, warnings.sorted()))
    }
}

/// An error for bytes that are not text: more than a quarter of zeros (text transfer separates lines with byte 0, so
/// some are allowed), or more than a tenth of other control characters.
fn is_text(bytes: &[u8]) -> Result<(), ProgramError> {
    let is_odd = |byte: u8| byte < b' ' && !matches!(byte, 0 | b'\t' | b'\n' | b'\r' | 0x0c | 0x1a);
    let mut zeros = 0_usize;
    let mut odd = 0_usize;
    for &byte in bytes {
        zeros += usize::from(byte == 0);
        odd += usize::from(is_odd(byte));
    }
    if bytes.len() < zeros.saturating_mul(4) || bytes.len() < odd.saturating_mul(10) {
        return Err(ProgramError::Binary { controls: zeros + odd, bytes: bytes.len() });
    }
    Ok(())
}

/// In which notation a text is written.
fn notation_of(text: &str, lines: &Lines) -> Notation {
    if iso::begins(text, lines) {
        Notation::Iso
    } else if din_plus::is_written_so(text, lines) {
        Notation::DinPlus
    } else {
        Notation::Klartext
    }
}
