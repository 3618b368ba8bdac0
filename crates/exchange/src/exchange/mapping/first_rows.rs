//! The beginning of a file, to be looked at with one mapping after the other.

use std::io::Cursor;

use fitcheck_core::tolerance::Sources;
use fitcheck_core::tolerance::fit::thermal::Temperature;
use jiff::civil::DateTime;

use super::detected::SHOWN;
use super::{Choice, Detected, Mapping, Separator};
use crate::exchange::columns::Columns;
use crate::exchange::delimited::without_separator_line;
use crate::exchange::error::ImportErrorKind;
use crate::exchange::imported::{Item, Sink};
use crate::exchange::lookup::Lookup;
use crate::exchange::role::Role;
use crate::exchange::sample::Sample;
use crate::exchange::source::{Context, ImportInputs, Source};
use crate::exchange::vocabulary::Rank;
use crate::exchange::{FORMATS, cells, measurements, words, xlsx};

/// The first rows of a CSV or workbook.
#[derive(Debug, Clone, PartialEq)]
pub struct FirstRows {
    file: String,
    held: Held,
}

#[derive(Debug, Clone, PartialEq)]
enum Held {
    Text(String),
    /// The sheets of a workbook that have rows, and the one that is read where none is said.
    Sheets(xlsx::Sheets, usize),
}

impl FirstRows {
    /// Those of a file; `None` where it is read in another way than by columns, or has no rows.
    pub fn of(file: &str, bytes: &[u8]) -> Option<Self> {
        Self::read(file, bytes, |file| {
            FORMATS.iter().find(|format| format.recognises(bytes, file)).map(|format| format.name)
        })
    }

    /// Those of a file that is read by its columns, whatever else it may be.
    pub fn of_columns(file: &str, bytes: &[u8]) -> Option<Self> {
        Self::read(file, bytes, |file| {
            let of_columns = [&xlsx::FORMAT, &measurements::FORMAT];
            of_columns.into_iter().find(|format| format.recognises(bytes, file)).map(|format| format.name)
        })
    }

    fn read(file: &str, bytes: &[u8], format: impl FnOnce(&str) -> Option<&'static str>) -> Option<Self> {
        let mut body = Cursor::new(bytes);
        let sources = Sources::default();
        let mut source = Source::new(file, &mut body, ImportInputs::new(&sources, DateTime::MIN)).ok()?;
        let format = format(file)?;
        let held = if format == xlsx::FORMAT.name {
            let (sheets, chosen) = xlsx::samples(&mut source).ok()?;
            Held::Sheets(sheets, chosen)
        } else if format == measurements::FORMAT.name {
            Held::Text(measurements::head(&mut source.pieces(measurements::LINE_ENDS).ok()?).ok()?)
        } else {
            return None;
        };
        let first = Self { file: file.to_owned(), held };
        (!first.sample(&Mapping::default()).rows.is_empty()).then_some(first)
    }

    /// The names of the sheets of a workbook that have rows; none where it is a text.
    pub fn sheets(&self) -> Vec<&str> {
        match &self.held {
            Held::Text(_) => Vec::new(),
            Held::Sheets(sheets, _) => sheets.iter().map(|(name, _)| name.as_str()).collect(),
        }
    }

    /// The first rows as a mapping splits them.
    pub(super) fn sample(&self, mapping: &Mapping) -> Sample {
        match &self.held {
            Held::Text(head) => {
                let (text, first_line, separator) = without_separator_line(head);
                Sample::of(text, first_line, mapping.separator().or(separator))
            }
            Held::Sheets(sheets, chosen) => {
                let said = mapping.sheet().and_then(|said| sheets.iter().find(|(name, _)| name == said));
                let sheet = said.or_else(|| sheets.get(*chosen));
                Sample::of_cells(sheet.into_iter().flat_map(|(_, rows)| rows.iter().cloned()))
            }
        }
    }

    /// What would be taken for what, as far as a mapping leaves it open.
    ///
    /// # Errors
    /// Why the columns are not known.
    pub fn detect(&self, mapping: &Mapping) -> Result<Detected, ImportErrorKind> {
        let mut sample = self.sample(mapping);
        let columns = mapping.columns(&mut sample)?;
        let mut detected = Detected::of(&sample, &columns);
        if let Held::Sheets(sheets, chosen) = &self.held {
            let chosen = sheets.get(*chosen).map(|(name, _)| name.clone());
            detected.mapping.sheet = mapping.sheet.clone().or(chosen);
            detected.mapping.separator = None;
        }
        Ok(detected)
    }

    /// Something to begin with: what is detected, or what single names say where that is refused.
    pub fn guess(&self, mapping: &Mapping) -> Choice {
        let asked = match self.detect(mapping) {
            Ok(detected) => {
                let &Mapping { decimal, unit, place_unit, first_row, .. } = mapping;
                return Choice { decimal, unit, place_unit, first_row, ..Choice::of(&detected) };
            }
            Err(ImportErrorKind::SeveralColumns { role, .. }) => Some(role),
            Err(_) => None,
        };
        let sample = self.sample(mapping);
        let header = sample.header.and_then(|at| sample.rows.get(at)).map(|(_, cells)| cells.clone());
        let role = |name: &str| {
            let label = words::label(name);
            let is_sure = |rank: Rank| !matches!(rank, Rank::Weak | Rank::Unsure);
            words::role(name).filter(|(_, rank)| is_sure(*rank)).map(|(role, _)| role).or(label)
        };
        let said: Vec<Option<Role>> = header.iter().flatten().map(role).collect();
        // What several columns may hold is chosen for none of them.
        let is_one = |role: &Option<Role>| *role != asked && said.iter().filter(|other| *other == role).count() == 1;
        let separator = match self.held {
            Held::Text(_) => Separator::of_byte(sample.separator),
            Held::Sheets(..) => None,
        };
        let sheet = match &self.held {
            Held::Text(_) => None,
            Held::Sheets(sheets, chosen) => {
                mapping.sheet.clone().or_else(|| sheets.get(*chosen).map(|(name, _)| name.clone()))
            }
        };
        let mut roles: Vec<Option<Role>> = said.iter().map(|role| role.filter(|_| is_one(role))).collect();
        roles.resize(self.width(mapping), None);
        Choice { sheet, separator, roles, ..Choice::default() }
    }

    /// The columns of a table of characteristics, which may have no measured values, and the separator of its cells.
    pub(in crate::exchange) fn planned(&self, mapping: &Mapping) -> Result<(Columns, u8), ImportErrorKind> {
        let mut sample = self.sample(mapping);
        let columns = match mapping.columns(&mut sample) {
            // What should be measured is not in doubt where several columns may say what was.
            Err(ImportErrorKind::NoMeasuredColumn | ImportErrorKind::SeveralColumns { role: Role::Measured, .. }) => {
                let mut without = self.sample(mapping);
                // A column that no row has.
                without.measured = Some(without.rows.iter().map(|(_, cells)| cells.len()).fold(0, usize::max) + 1);
                mapping.columns(&mut without)
            }
            columns => columns,
        };
        Ok((columns?, sample.separator))
    }

    /// The same where that is refused: what single names say.
    pub fn guessed(&self, mapping: &Mapping) -> Detected {
        let choice = self.guess(mapping);
        let names = self.sample(mapping);
        let header = names.header.and_then(|at| names.rows.get(at));
        Detected::guessed((choice.sheet, choice.separator), choice.roles, header, self.rows(mapping))
    }

    /// How many columns the shown rows have.
    pub fn width(&self, mapping: &Mapping) -> usize {
        self.rows(mapping).iter().map(|(_, cells)| cells.len()).fold(0, usize::max)
    }

    /// The first rows from the top, with their lines: header and what stands above it, too.
    pub fn rows(&self, mapping: &Mapping) -> Vec<(usize, Vec<String>)> {
        let rows = self.sample(mapping).rows.into_iter().take(SHOWN);
        rows.map(|(line, cells)| (line, cells.iter().map(|cell| cell.trim().to_owned()).collect())).collect()
    }

    /// Whether a number stands in any of the first rows.
    pub fn has_numbers(&self) -> bool {
        let rows = self.sample(&Mapping::default()).rows;
        rows.iter().any(|(_, row)| row.iter().any(cells::is_number))
    }

    /// What the first rows would become.
    ///
    /// # Errors
    /// Why the columns are not known.
    pub fn items(&self, mapping: &Mapping, given: ImportInputs<'_>) -> Result<Vec<Item>, ImportErrorKind> {
        let mut sample = self.sample(mapping);
        let columns = mapping.columns(&mut sample)?;
        let file = self.file.as_str().into();
        let lookup = Lookup::default();
        let counted = given.temperature.unwrap_or(Temperature::REFERENCE);
        let context = Context { file, sources: given.sources, now: given.now, counted, lookup };
        let mut items = Vec::new();
        let mut take = |item| items.push(item);
        let mut sink = Sink::up_to(usize::MAX, &mut take);
        let rows = sample.rows.iter().take(SHOWN);
        measurements::read_these(&context, (&columns, sample.separator, given.has_plan), rows, &mut sink);
        Ok(items)
    }

    /// Whether the file is a text, which something separates into cells.
    pub(super) const fn is_text(&self) -> bool {
        matches!(self.held, Held::Text(_))
    }
}
