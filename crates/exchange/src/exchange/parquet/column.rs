//! Some rows of a column in memory, and one value of it.

use parquet::column::reader::ColumnReader;
use parquet::data_type::{ByteArray, FixedLenByteArray, Int96};
use parquet::errors::ParquetError;

use super::Field;

#[derive(Debug, Clone, Copy)]
pub(in crate::exchange) enum Value<'a> {
    Boolean(bool),
    Int32(i32),
    Int64(i64),
    Int96(Int96),
    Float(f32),
    Double(f64),
    Bytes(&'a [u8]),
}

/// The values of some rows, without those that are missing.
#[derive(Debug)]
pub(super) enum Values {
    Boolean(Vec<bool>),
    Int32(Vec<i32>),
    Int64(Vec<i64>),
    Int96(Vec<Int96>),
    Float(Vec<f32>),
    Double(Vec<f64>),
    Bytes(Vec<ByteArray>),
    Fixed(Vec<FixedLenByteArray>),
}

/// The same for each type.
macro_rules! each {
    ($values:expr, $own:ident => $do:expr) => {
        match $values {
            Values::Boolean($own) => $do,
            Values::Int32($own) => $do,
            Values::Int64($own) => $do,
            Values::Int96($own) => $do,
            Values::Float($own) => $do,
            Values::Double($own) => $do,
            Values::Bytes($own) => $do,
            Values::Fixed($own) => $do,
        }
    };
}

impl Values {
    fn new(reader: &ColumnReader) -> Self {
        match reader {
            ColumnReader::BoolColumnReader(_) => Self::Boolean(Vec::new()),
            ColumnReader::Int32ColumnReader(_) => Self::Int32(Vec::new()),
            ColumnReader::Int64ColumnReader(_) => Self::Int64(Vec::new()),
            ColumnReader::Int96ColumnReader(_) => Self::Int96(Vec::new()),
            ColumnReader::FloatColumnReader(_) => Self::Float(Vec::new()),
            ColumnReader::DoubleColumnReader(_) => Self::Double(Vec::new()),
            ColumnReader::ByteArrayColumnReader(_) => Self::Bytes(Vec::new()),
            ColumnReader::FixedLenByteArrayColumnReader(_) => Self::Fixed(Vec::new()),
        }
    }

    fn len(&self) -> usize {
        each!(self, own => own.len())
    }

    fn split_off(&mut self, at: usize) -> Self {
        match self {
            Self::Boolean(own) => Self::Boolean(own.split_off(at)),
            Self::Int32(own) => Self::Int32(own.split_off(at)),
            Self::Int64(own) => Self::Int64(own.split_off(at)),
            Self::Int96(own) => Self::Int96(own.split_off(at)),
            Self::Float(own) => Self::Float(own.split_off(at)),
            Self::Double(own) => Self::Double(own.split_off(at)),
            Self::Bytes(own) => Self::Bytes(own.split_off(at)),
            Self::Fixed(own) => Self::Fixed(own.split_off(at)),
        }
    }

    #[inline]
    fn get(&self, at: usize) -> Option<Value<'_>> {
        Some(match self {
            Self::Boolean(own) => Value::Boolean(*own.get(at)?),
            Self::Int32(own) => Value::Int32(*own.get(at)?),
            Self::Int64(own) => Value::Int64(*own.get(at)?),
            Self::Int96(own) => Value::Int96(*own.get(at)?),
            Self::Float(own) => Value::Float(*own.get(at)?),
            Self::Double(own) => Value::Double(*own.get(at)?),
            Self::Bytes(own) => Value::Bytes(own.get(at)?.data()),
            Self::Fixed(own) => Value::Bytes(own.get(at)?.data()),
        })
    }
}

/// Some rows of a column.
#[derive(Debug)]
pub(in crate::exchange) struct Column {
    pub(super) values: Values,
    /// For each row whether it has a value, 1 or 0; nothing where every row has one.
    pub(super) levels: Vec<i16>,
    pub(super) is_optional: bool,
}

impl Column {
    /// Reads the next rows behind those that are there; how many came.
    #[expect(clippy::needless_pass_by_ref_mut, reason = "each kind of reader is used mutably")]
    fn read(&mut self, reader: &mut ColumnReader, count: usize) -> Result<usize, ParquetError> {
        let levels = self.is_optional.then_some(&mut self.levels);
        let read = match (reader, &mut self.values) {
            (ColumnReader::BoolColumnReader(from), Values::Boolean(to)) => from.read_records(count, levels, None, to),
            (ColumnReader::Int32ColumnReader(from), Values::Int32(to)) => from.read_records(count, levels, None, to),
            (ColumnReader::Int64ColumnReader(from), Values::Int64(to)) => from.read_records(count, levels, None, to),
            (ColumnReader::Int96ColumnReader(from), Values::Int96(to)) => from.read_records(count, levels, None, to),
            (ColumnReader::FloatColumnReader(from), Values::Float(to)) => from.read_records(count, levels, None, to),
            (ColumnReader::DoubleColumnReader(from), Values::Double(to)) => from.read_records(count, levels, None, to),
            (ColumnReader::ByteArrayColumnReader(from), Values::Bytes(to)) => {
                from.read_records(count, levels, None, to)
            }
            (ColumnReader::FixedLenByteArrayColumnReader(from), Values::Fixed(to)) => {
                from.read_records(count, levels, None, to)
            }
            _ => Err(ParquetError::General("a column changes its type between row groups".to_owned())),
        };
        read.map(|(rows, ..)| rows)
    }

    /// How many values the first rows have.
    fn values_of(&self, rows: usize) -> usize {
        if self.is_optional { self.levels.iter().take(rows).filter(|level| **level != 0).count() } else { rows }
    }

    fn split_off(&mut self, rows: usize) -> Self {
        let values = self.values.split_off(self.values_of(rows).min(self.values.len()));
        let levels = if self.is_optional { self.levels.split_off(rows.min(self.levels.len())) } else { Vec::new() };
        Self { values, levels, is_optional: self.is_optional }
    }
}

/// The cells of a column one after the other.
#[derive(Debug)]
pub(in crate::exchange) struct ColumnCells<'a> {
    column: &'a Column,
    row: usize,
    value: usize,
}

impl<'a> ColumnCells<'a> {
    /// The next cell; `None` where it is empty.
    #[inline]
    pub(in crate::exchange) fn next(&mut self) -> Option<Value<'a>> {
        let is_there = !self.column.is_optional || self.column.levels.get(self.row).is_some_and(|level| *level != 0);
        self.row += 1;
        if !is_there {
            return None;
        }
        self.value += 1;
        self.column.values.get(self.value - 1)
    }
}

/// Some rows of all columns.
#[derive(Debug, Default)]
pub(in crate::exchange) struct Rows {
    pub(super) columns: Vec<Column>,
    pub(in crate::exchange) count: usize,
}

impl Rows {
    /// The cells of each column.
    pub(in crate::exchange) fn cells(&self) -> Vec<ColumnCells<'_>> {
        self.columns.iter().map(|column| ColumnCells { column, row: 0, value: 0 }).collect()
    }

    /// No rows of the columns that are read from here; what was there goes, and its memory is used again.
    pub(super) fn clear(&mut self, fields: &[Field], readers: &[ColumnReader]) {
        self.count = 0;
        if self.columns.len() != fields.len() {
            let new = |(field, reader): (&Field, &ColumnReader)| Column {
                values: Values::new(reader),
                levels: Vec::new(),
                is_optional: field.is_optional,
            };
            self.columns = fields.iter().zip(readers).map(new).collect();
        }
        for column in &mut self.columns {
            each!(&mut column.values, own => own.clear());
            column.levels.clear();
        }
    }

    /// Reads the next rows behind those that are there: all of `count`, or an error.
    pub(super) fn read(
        &mut self,
        readers: &mut [ColumnReader],
        fields: &[Field],
        count: usize,
    ) -> Result<(), ParquetError> {
        for ((column, reader), field) in self.columns.iter_mut().zip(readers).zip(fields) {
            let read = column.read(reader, count)?;
            let has_all = column.values.len() == column.values_of(self.count + count);
            if read != count || !has_all {
                let name = field.name();
                return Err(ParquetError::General(format!(
                    "column {name} has fewer values than its row group has rows"
                )));
            }
        }
        self.count += count;
        Ok(())
    }

    /// Keeps the first rows and gives the others.
    pub(super) fn split_off(&mut self, rows: usize) -> Self {
        let count = self.count.saturating_sub(rows);
        self.count = self.count.min(rows);
        Self { columns: self.columns.iter_mut().map(|column| column.split_off(rows)).collect(), count }
    }

    /// How many of the rows behind `from` have about so many bytes, at least one; and how many bytes these have.
    pub(super) fn up_to(&self, from: usize, most: usize) -> (usize, usize) {
        let mut texts: Vec<ColumnCells<'_>> = Vec::new();
        let mut fixed = 0;
        for column in &self.columns {
            fixed += match &column.values {
                Values::Bytes(_) | Values::Fixed(_) => {
                    texts.push(ColumnCells { column, row: from, value: column.values_of(from) });
                    4
                }
                Values::Boolean(_) => 1,
                Values::Int32(_) | Values::Float(_) => 4,
                Values::Int64(_) | Values::Double(_) => 8,
                Values::Int96(_) => 12,
            };
        }
        let mut bytes = 0;
        for row in from..self.count {
            let texts =
                texts.iter_mut().map(|cells| if let Some(Value::Bytes(text)) = cells.next() { text.len() } else { 0 });
            let next = bytes + fixed + texts.sum::<usize>();
            if most < next && from < row {
                return (row - from, bytes);
            }
            bytes = next;
        }
        (self.count - from, bytes)
    }
}
