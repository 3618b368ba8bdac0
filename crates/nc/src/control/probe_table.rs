//! The touch-probe table `tchprobe.tp`: from rows of a control's table to probes, and the built-in table.
//!
//! NO, `CAL_OF1`, `CAL_OF2`, F, FMAX, DIST and `SET_UP` are used, other columns are not. `SET_UP` and DIST as in cycle
//! 444 of TNC 640 (01/2021) and cycle 427 of TNC7; the list of columns is from memory.

use std::collections::BTreeSet;
use std::sync::LazyLock;

use fitcheck_core::length::{Length, LengthError, Unit};
use fitcheck_core::message::{Located, Say};
use fitcheck_core::probing::TouchProbe;
use fitcheck_shipped as shipped;

use super::table::{ControlTable, TableError, TableFile, TableUnit, TableWarning, is_blank};

/// The built-in table.
fn shipped_bytes() -> &'static [u8] {
    // Without it there would be no probe, and the first use of the table says so.
    shipped::file(shipped::TABLES, "tchprobe.tp").map_or(&[], |bytes| bytes)
}

/// A touch-probe table.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ProbeTable {
    /// The probes in the table's order, at least one; no number occurs twice.
    pub probes: Vec<TouchProbe>,
    /// Warnings about a table that could still be read.
    pub warnings: Vec<TableWarning>,
}

/// Why a file is not a touch-probe table.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(prefix = "probe-table", error)]
pub enum ProbeTableError {
    /// It is not a table of a control.
    #[say(transparent)]
    Table(#[from] TableError),
    /// A cell or a column that cannot be used.
    #[say(transparent)]
    Cell(#[from] Located<ProbeFault>),
}

/// What is wrong with a cell or a column.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(prefix = "probe-table", error)]
pub enum ProbeFault {
    /// A column that must be there is missing.
    NoColumn {
        /// Its name.
        column: &'static str,
    },
    /// There are no rows.
    NoProbe,
    /// A cell is not a length.
    NoLength {
        /// The column's name.
        column: &'static str,
        /// What is wrong.
        error: LengthError,
    },
    /// A length that is too small.
    TooSmall {
        /// The column's name.
        column: &'static str,
        given: Length,
        /// What is allowed.
        least: Least,
    },
    /// A cell is not a whole number.
    NotWhole {
        /// The column's name.
        column: &'static str,
        /// The text found.
        given: String,
    },
    /// A number occurs twice.
    Twice { number: u32 },
}

/// The smallest allowed length.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Say)]
#[say(prefix = "probe-table")]
pub enum Least {
    /// Zero itself is allowed.
    ZeroOrMore,
    /// Zero is not.
    AboveZero,
}

impl ProbeTable {
    /// The table that is embedded in the program.
    pub fn shipped() -> &'static Self {
        static TABLE: LazyLock<ProbeTable> = LazyLock::new(|| match ProbeTable::read(shipped_bytes(), "tchprobe.tp") {
            Ok(table) => table,
            // A test proves that it can be read.
            Err(error) => {
                log::error!("shipped table: {error}");
                ProbeTable { probes: vec![TouchProbe::default()], warnings: Vec::new() }
            }
        });
        &TABLE
    }

    /// Reads a table; `file` is its name in messages. Lengths are in the unit of the BEGIN line, else in millimetres.
    ///
    /// # Errors
    /// [`ProbeTableError`] with file, line and column.
    pub fn read(bytes: &[u8], file: &str) -> Result<Self, ProbeTableError> {
        let file = ControlTable::read(bytes, file)?;
        let columns = Columns::of(&file)?;
        let mut probes = Vec::new();
        let mut numbers = BTreeSet::new();
        for row in 0..file.table.rows.len() {
            let probe = columns.probe(&file, row)?;
            if !numbers.insert(probe.number) {
                return Err(file.at_cell(row, columns.number, ProbeFault::Twice { number: probe.number }).into());
            }
            probes.push(probe);
        }
        if probes.is_empty() {
            return Err(file.at_name(columns.number, ProbeFault::NoProbe).into());
        }
        Ok(Self { probes, warnings: file.warnings })
    }

    /// A probe by its number; the first one for `None`.
    pub fn probe(&self, number: Option<u32>) -> Option<&TouchProbe> {
        match number {
            Some(number) => self.probes.iter().find(|probe| probe.number == number),
            None => self.probes.first(),
        }
    }

    /// The probe of a number, or the first one; in a table without any it would be that of the built-in table.
    pub(crate) fn probe_or_first(&self, number: Option<u32>) -> TouchProbe {
        let of_number = number.and_then(|number| self.probe(Some(number)));
        of_number.or_else(|| self.probe(None)).map_or_else(TouchProbe::default, |probe| *probe)
    }
}

/// The positions of the columns.
struct Columns {
    number: usize,
    set_up: usize,
    longest_path: usize,
    offset: [Option<usize>; 2],
    feed: Option<usize>,
    rapid: Option<usize>,
}

impl Columns {
    fn of(file: &TableFile) -> Result<Self, ProbeTableError> {
        let column = |name| {
            let missing = || file.at_name(0, ProbeFault::NoColumn { column: name });
            file.table.column(name).ok_or_else(missing)
        };
        Ok(Self {
            number: column("NO")?,
            set_up: column("SET_UP")?,
            longest_path: column("DIST")?,
            offset: ["CAL_OF1", "CAL_OF2"].map(|name| file.table.column(name)),
            feed: file.table.column("F"),
            rapid: file.table.column("FMAX"),
        })
    }

    fn probe(&self, file: &TableFile, row: usize) -> Result<TouchProbe, ProbeTableError> {
        let usual = TouchProbe::default();
        let optional = |column: Option<usize>, name, otherwise| {
            column.map_or(Ok(otherwise), |column| whole(file, row, column, name, Some(otherwise)))
        };
        let offset = |column: Option<usize>, name| {
            column.map_or(Ok(Length::ZERO), |column| {
                if is_blank(file.table.cell(row, column)) { Ok(Length::ZERO) } else { length(file, row, column, name) }
            })
        };
        let [offset_1, offset_2] = self.offset;
        let at_least = |least: Least, column: usize, name| {
            let given = length(file, row, column, name)?;
            if Length::ZERO < given || (least == Least::ZeroOrMore && given == Length::ZERO) {
                return Ok(given);
            }
            Err(ProbeTableError::from(file.at_cell(row, column, ProbeFault::TooSmall { column: name, given, least })))
        };
        let set_up = at_least(Least::ZeroOrMore, self.set_up, "SET_UP")?;
        let longest_path = at_least(Least::AboveZero, self.longest_path, "DIST")?;
        Ok(TouchProbe {
            number: whole(file, row, self.number, "NO", None)?,
            offset: [offset(offset_1, "CAL_OF1")?, offset(offset_2, "CAL_OF2")?],
            feed: optional(self.feed, "F", usual.feed)?,
            rapid: optional(self.rapid, "FMAX", usual.rapid)?,
            longest_path,
            set_up,
        })
    }
}

fn length(file: &TableFile, row: usize, column: usize, name: &'static str) -> Result<Length, ProbeTableError> {
    let unit = if file.table.unit == Some(TableUnit::Inch) { Unit::Inch } else { Unit::Millimetre };
    let read = Length::parse_in(file.table.cell(row, column), unit);
    Ok(read.map_err(|error| file.at_cell(row, column, ProbeFault::NoLength { column: name, error }))?)
}

/// A whole number; a blank cell means `otherwise`, if there is such a number.
fn whole(
    file: &TableFile,
    row: usize,
    column: usize,
    name: &'static str,
    otherwise: Option<u32>,
) -> Result<u32, ProbeTableError> {
    let text = file.table.cell(row, column);
    let given = || ProbeFault::NotWhole { column: name, given: text.to_owned() };
    match otherwise {
        Some(number) if is_blank(text) => Ok(number),
        _ => Ok(text.parse().map_err(|_whole| file.at_cell(row, column, given()))?),
    }
}
