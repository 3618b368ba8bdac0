//! FN 26, FN 27 and FN 28: only one table is open at a time.

use std::collections::BTreeMap;
use std::sync::Arc;

use fitcheck_core::message::Arg;

use super::around::INCH;
use super::fault::{BlockPlace, Counted, FaultKind};
use super::files::Files;
use super::path::NcPath;
use super::remark::{Remark, Remarks};
use super::values::{Values, shown_arg};
use crate::control::deviations::other_spelling;
use crate::control::mask::FileUse;
use crate::control::simulated::{MARK, is_mark};
use crate::control::table::{Column, Comment, CommentPlace, TableFile, TableUnit, WriteError, is_blank, is_number};
use crate::control::variables::{Family, Parameter, Value};
use crate::program::{Columns, Operand, Unit};

/// The value of a cell, and what is worth knowing about its column.
type Cell = (Value, Vec<Remark>);

/// A table that FN 26 has opened.
#[derive(Debug, Clone)]
struct OpenTable {
    path: NcPath,
    file: Arc<TableFile>,
    /// How much memory it takes.
    bytes: usize,
    /// The first block that changed it.
    changed_at: Option<usize>,
}

impl OpenTable {
    fn name(&self) -> String {
        self.path.file_name().to_owned()
    }

    /// The number of a column; names are case-sensitive. NC-Solution 8255 spells its range column in two ways: a table that
    /// has only the other one is taken to mean it, and the remark says so.
    fn column(&self, name: &str) -> Result<(usize, Vec<Remark>), FaultKind> {
        let table = &self.file.table;
        if let Some(number) = table.column(name) {
            return Ok((number, Vec::new()));
        }
        let other = other_spelling(name).and_then(|other| Some((other, table.column(other)?)));
        let (other, number) = other.ok_or_else(|| {
            let columns: Vec<&str> = table.columns.iter().map(|column| column.name.as_str()).collect();
            FaultKind::NoColumn { table: self.name(), column: name.to_owned(), columns: columns.join(", ") }
        })?;
        let remark = Remark::OtherSpelling { table: self.name(), column: name.to_owned(), other: other.to_owned() };
        Ok((number, vec![remark]))
    }

    /// How many mm the unit of a column and that of the program have, where they differ: columns of type LENGTH are in the unit
    /// of the table, mm where its first line names none (heidenhain, section 2.4), and a control converts them.
    fn units(&self, number: usize, unit: Option<Unit>) -> Option<[f64; 2]> {
        let kind = self.file.table.columns.get(number)?.kind.as_deref()?;
        let is_inch = [self.file.table.unit == Some(TableUnit::Inch), unit == Some(Unit::Inch)];
        let [of_table, of_program] = is_inch.map(|is_inch| if is_inch { INCH } else { 1.0 });
        let differ = is_inch == [true, false] || is_inch == [false, true];
        (kind.eq_ignore_ascii_case("LENGTH") && differ).then_some([of_table, of_program])
    }

    /// The first row whose number in the column NR is not the one that FN 27 and FN 28 count, from 0.
    fn odd_row(&self) -> Option<Remark> {
        let table = &self.file.table;
        let number = table.column("NR")?;
        let cells = (0..table.rows.len()).map(|row| (row, table.cell(row, number)));
        let (row, found) = cells.into_iter().find(|(row, cell)| cell.parse::<usize>().ok() != Some(*row))?;
        Some(Remark::RowNumber { table: self.name(), row, found: found.to_owned() })
    }

    fn check_row(&self, row: usize) -> Result<(), FaultKind> {
        let rows = self.file.table.rows.len();
        match rows.checked_sub(1) {
            None => Err(FaultKind::NoRows(self.name())),
            Some(last) if last < row => Err(FaultKind::NoRow { table: self.name(), row, last }),
            Some(_) => Ok(()),
        }
    }

    /// The value of a cell for a parameter.
    fn read(&self, row: usize, name: &str, to: Parameter, unit: Option<Unit>) -> Result<Cell, FaultKind> {
        let (number, mut remarks) = self.column(name)?;
        self.check_row(row)?;
        let cell = self.file.table.cell(row, number);
        let table = self.name();
        let column = name.to_owned();
        if to.family == Family::Qs && !cell.is_empty() {
            return Ok((Value::Text(cell.to_owned()), remarks));
        }
        if is_blank(cell) {
            return Err(FaultKind::EmptyCell { table, row, column });
        }
        if self.file.touches(row, number) {
            return Err(FaultKind::Touches { table, row, column });
        }
        let plain = cell.replace(',', ".").replace('\u{2212}', "-");
        match plain.parse::<f64>() {
            Ok(value) if is_number(cell) => {
                let Some([of_table, of_program]) = self.units(number, unit) else {
                    return Ok((Value::Number(value), remarks));
                };
                remarks.push(Remark::LengthConverted { table, column });
                Ok((Value::Number(value * of_table / of_program), remarks))
            }
            _ => Err(FaultKind::NoNumberInCell { table, row, column, cell: cell.to_owned() }),
        }
    }

    /// Whether the decimals of a column have cut a value, by a tenth of a nanometre or more.
    fn rounded(&self, number: usize, from: Parameter, written: &str, values: &Values) -> Option<Remark> {
        let column = self.file.table.columns.get(number).filter(|column| column.decimals.is_some())?;
        let value = values.all().get(from).filter(|_value| from.family != Family::Qs)?;
        let exact: f64 = match value {
            Value::Length(length) => length.to_mm_f64(),
            Value::Number(number) => *number,
            Value::Text(_) => return None,
        };
        let is_off = written.parse::<f64>().is_ok_and(|written| 1e-7 <= (written - exact).abs());
        let table = self.name();
        let column = column.name.clone();
        let written = Arg::Number(written.to_owned());
        is_off.then(|| Remark::Rounded { table, column, value: shown_arg(value), written })
    }

    /// What a parameter writes into a cell: a text, or a number with the column's decimals.
    fn text(
        &self,
        (row, number): (usize, usize),
        from: Parameter,
        unit: Option<Unit>,
        values: &Values,
    ) -> Result<String, FaultKind> {
        let Some(column) = self.file.table.columns.get(number) else { return Ok(String::new()) };
        let text = if from.family == Family::Qs {
            let text = values.text(from)?.to_owned();
            if column.is_text() == Some(false) && !is_number(&text) && !is_blank(&text) {
                return Err(FaultKind::NoNumberInText { parameter: from, text });
            }
            text
        } else {
            let operand = Operand::Parameter { parameter: from, is_negative: false };
            let operand = match self.units(number, unit) {
                Some([of_table, of_program]) => Operand::Number(values.operand(operand)? * of_program / of_table),
                None => operand,
            };
            signed(values.decimal(operand, column.decimals)?, column)
        };
        // At least one blank must remain between the columns.
        if column.width <= text.chars().count() {
            let error = WriteError::TooWide { row, column: column.name.clone(), text, width: column.width };
            return Err(FaultKind::TableWrite { table: self.name(), error });
        }
        Ok(text)
    }
}

/// A number with decimals has its sign, `+115.0290`, where there is room for it.
fn signed(text: String, column: &Column) -> String {
    let has_decimals = column.decimals.is_some_and(|decimals| 0 < decimals);
    let has_room = text.chars().count() + 1 < column.width;
    if has_decimals && has_room && !text.starts_with('-') { format!("+{text}") } else { text }
}

/// What FN 27 writes: a row, and the text of each column by its number.
#[derive(Debug)]
pub(super) struct WrittenRow {
    row: usize,
    texts: Vec<(usize, String)>,
    /// What is worth knowing about the columns.
    pub(super) remarks: Vec<Remark>,
}

/// What FN 28 reads: the values of parameters.
#[derive(Debug, Default)]
pub(super) struct CellsRead {
    pub(super) values: Vec<(Parameter, Value)>,
    /// What is worth knowing about the columns.
    pub(super) remarks: Vec<Remark>,
}

/// The table that is open, and those that could not be written.
#[derive(Debug, Default)]
pub(super) struct Tables {
    open: Option<OpenTable>,
    changed: BTreeMap<NcPath, OpenTable>,
    /// How many times a changed table was closed, and so written.
    writes: usize,
}

impl Tables {
    /// The path of the open table.
    pub(super) fn path(&self) -> Option<&NcPath> {
        self.open.as_ref().map(|open| &open.path)
    }

    /// How many changed tables are kept in memory.
    pub(super) fn changed(&self) -> usize {
        self.changed.len()
    }

    fn open_table(&self) -> Result<&OpenTable, FaultKind> {
        self.open.as_ref().ok_or(FaultKind::NoTable)
    }

    /// FN 26; the previous table is already closed. Returns what the reader of the table has to say.
    pub(super) fn open(&mut self, path: NcPath, files: &mut Files) -> Result<Vec<Remark>, FaultKind> {
        if let Some(changed) = self.changed.get(&path) {
            self.open = Some(changed.clone());
            return Ok(Vec::new());
        }
        let (file, bytes) = files.table(&path)?;
        let mut remarks = Remark::read(&path, &file.warnings);
        let open = self.open.insert(OpenTable { path, file, bytes, changed_at: None });
        remarks.extend(open.odd_row());
        Ok(remarks)
    }

    /// FN 28: one column fills the parameter, several also fill the following ones.
    pub(super) fn read(
        &self,
        to: Parameter,
        row: Operand,
        columns: &Columns,
        unit: Option<Unit>,
        values: &Values,
    ) -> Result<CellsRead, FaultKind> {
        let open = self.open_table()?;
        let row = values.whole(Counted::Row, row)?;
        let mut cells = CellsRead::default();
        for (column, to) in names(columns, values)?.into_iter().zip(following(to)) {
            let (value, remarks) = open.read(row, column, to, unit)?;
            cells.values.push((to, value));
            cells.remarks.extend(remarks);
        }
        Ok(cells)
    }

    /// What FN 27 writes into the open table.
    pub(super) fn cells(
        &self,
        row: Operand,
        columns: &Columns,
        from: Parameter,
        unit: Option<Unit>,
        values: &Values,
    ) -> Result<WrittenRow, FaultKind> {
        let open = self.open_table()?;
        let row = values.whole(Counted::Row, row)?;
        let mut cells = WrittenRow { row, texts: Vec::new(), remarks: Vec::new() };
        for (column, from) in names(columns, values)?.into_iter().zip(following(from)) {
            let (number, remarks) = open.column(column)?;
            open.check_row(row)?;
            let text = open.text((row, number), from, unit, values)?;
            if open.units(number, unit).is_none() {
                cells.remarks.extend(open.rounded(number, from, &text, values));
            }
            cells.texts.push((number, text));
            cells.remarks.extend(remarks);
            let converted = open.units(number, unit).filter(|_units| from.family != Family::Qs);
            let table = open.name();
            let column = column.to_owned();
            cells.remarks.extend(converted.map(|_units| Remark::LengthConverted { table, column }));
        }
        Ok(cells)
    }

    /// FN 27: in memory; the file is written when the table is closed. What a simulation has measured gets its mark, as a comment.
    pub(super) fn write(
        &mut self,
        at: usize,
        cells: WrittenRow,
        is_simulated: bool,
        files: &mut Files,
    ) -> Result<(), FaultKind> {
        let changed = self.changed.len();
        let Some(open) = &mut self.open else { return Err(FaultKind::NoTable) };
        if open.changed_at.is_none() {
            files.keep(open.bytes, changed)?;
            open.changed_at = Some(at);
        }
        let table = &mut Arc::make_mut(&mut open.file).table;
        if is_simulated && !table.comments.iter().any(|comment| is_mark(&comment.text)) {
            table.comments.insert(0, Comment { place: CommentPlace::Header, text: MARK.to_owned() });
        }
        let rows = &mut table.rows;
        for (number, text) in cells.texts {
            if let Some(cell) = rows.get_mut(cells.row).and_then(|cells| cells.get_mut(number)) {
                *cell = text;
            }
        }
        Ok(())
    }

    /// Writes the open table if FN 27 has changed it. If nothing is written, the change stays in memory.
    pub(super) fn close(
        &mut self,
        program: &NcPath,
        files: &mut Files,
        remarks: &mut Remarks,
    ) -> Result<(), FaultKind> {
        let Some(open) = self.open.take() else { return Ok(()) };
        let Some(block) = open.changed_at else { return Ok(()) };
        files.count_table_write(&mut self.writes)?;
        let written = open.file.table.write();
        let bytes = written.map_err(|error| FaultKind::TableWrite { table: open.name(), error })?;
        let size = files.write(&open.path, &bytes, FileUse::Replace)?;
        let place = BlockPlace { program: program.clone(), block };
        let path = open.path.clone();
        if size.is_some() {
            remarks.add(place, Remark::TableWritten { path });
        } else {
            remarks.add(place, Remark::NotWritten { path: path.clone() });
            self.changed.insert(path, open);
        }
        // Counted even if nothing is written, because it was built: a loop with a large table could run for days.
        Ok(files.spend(size.unwrap_or(bytes.len()))?)
    }
}

fn names<'a>(columns: &'a Columns, values: &'a Values) -> Result<Vec<&'a str>, FaultKind> {
    Ok(match columns {
        Columns::Names(names) => names.iter().map(String::as_str).collect(),
        // H7,H8 would be two tolerance classes, of which only the first is measured against.
        Columns::Parameter(parameter) => match values.text(*parameter)?.trim() {
            several if several.contains(',') => {
                return Err(FaultKind::SeveralColumns { parameter: *parameter, text: several.to_owned() });
            }
            one => vec![one],
        },
    })
}

/// A parameter and the following ones.
fn following(first: Parameter) -> impl Iterator<Item = Parameter> {
    (first.number..=u16::MAX).map(move |number| Parameter { number, ..first })
}
