//! Row groups, made by any thread, and the file that they become.

use std::collections::HashMap;
use std::hash::Hash;
use std::io::{self, Write};
use std::sync::Arc;

use parquet::data_type::{ByteArray, Int96};
use parquet::errors::ParquetError;
use parquet::file::properties::WriterProperties;
use parquet::file::statistics::Statistics;
use parquet::file::writer::SerializedFileWriter;
use parquet::schema::types::{SchemaDescPtr, SchemaDescriptor, Type};

use super::column::{Rows, Values};
use super::page::{Body, Chunk, Packer};
use super::{Field, delta};

/// A row group, ready to be written.
#[derive(Debug, Default)]
pub struct Group {
    chunks: Vec<Chunk>,
}

/// Makes the columns of row groups, one after the other.
pub(in crate::exchange) struct Chunks {
    schema: SchemaDescPtr,
    packer: Packer,
    done: Vec<Chunk>,
    /// The plain encoding of the column at hand.
    plain: Vec<u8>,
}

/// The schema of some columns.
fn schema(fields: &[Field]) -> Result<SchemaDescPtr, ParquetError> {
    let fields = fields.iter().map(|field| Arc::clone(&field.declared)).collect();
    let root = Type::group_type_builder("schema").with_fields(fields).build()?;
    Ok(Arc::new(SchemaDescriptor::new(Arc::new(root))))
}

impl Chunks {
    /// For row groups with these columns.
    pub(in crate::exchange) fn new(fields: &[Field]) -> Result<Self, ParquetError> {
        Ok(Self { schema: schema(fields)?, packer: Packer::new()?, done: Vec::new(), plain: Vec::new() })
    }

    fn add(
        &mut self,
        rows: usize,
        levels: &[i16],
        body: Body<'_>,
        statistics: Option<Statistics>,
    ) -> Result<(), ParquetError> {
        let column = self.schema.columns().get(self.done.len());
        let column = column.ok_or_else(|| ParquetError::General("more columns than the file has".to_owned()))?;
        let chunk = self.packer.chunk(column, rows, levels, body, statistics)?;
        self.done.push(chunk);
        Ok(())
    }

    /// The next column: whole numbers of 64 bits, in which those without a value are not.
    pub(in crate::exchange) fn numbers(
        &mut self,
        rows: usize,
        levels: &[i16],
        values: &[i64],
    ) -> Result<(), ParquetError> {
        let least = values.iter().min().copied();
        let most = values.iter().max().copied();
        let nulls = u64::try_from(rows.saturating_sub(values.len())).ok();
        self.numbers_with(rows, levels, values, Some(Statistics::int64(least, most, None, nulls, false)))
    }

    fn numbers_with(
        &mut self,
        rows: usize,
        levels: &[i16],
        values: &[i64],
        statistics: Option<Statistics>,
    ) -> Result<(), ParquetError> {
        if let Some((words, numbers)) = few(values.iter().copied()) {
            let plain: Vec<u8> = words.iter().flat_map(|word| word.to_le_bytes()).collect();
            let count = u32::try_from(words.len()).unwrap_or(u32::MAX);
            return self.add(rows, levels, Body::Words(&plain, count, &numbers), statistics);
        }
        let mut packed = std::mem::take(&mut self.plain);
        packed.clear();
        delta::put(values, &mut packed);
        let added = self.add(rows, levels, Body::Delta(&packed), statistics);
        self.plain = packed;
        added
    }

    /// The next column: texts in the plain encoding, each behind its length.
    pub(in crate::exchange) fn texts(&mut self, rows: usize, levels: &[i16], plain: &[u8]) -> Result<(), ParquetError> {
        self.add(rows, levels, Body::Plain(plain), None)
    }

    /// The next column: `true` and `false`.
    pub(in crate::exchange) fn booleans(
        &mut self,
        rows: usize,
        levels: &[i16],
        values: &[bool],
    ) -> Result<(), ParquetError> {
        let mut plain = Vec::new();
        put_booleans(values, &mut plain);
        self.add(rows, levels, Body::Plain(&plain), None)
    }

    /// The next column: for each value the number of its word.
    pub(in crate::exchange) fn words(
        &mut self,
        rows: usize,
        levels: &[i16],
        words: &[&str],
        numbers: &[u8],
    ) -> Result<(), ParquetError> {
        let mut plain = Vec::new();
        for word in words {
            put_text(word.as_bytes(), &mut plain);
        }
        let count = u32::try_from(words.len()).unwrap_or(u32::MAX);
        self.add(rows, levels, Body::Words(&plain, count, numbers), None)
    }

    /// The next columns: all of some rows that were read.
    pub(in crate::exchange) fn rows(&mut self, rows: &Rows) -> Result<(), ParquetError> {
        for column in &rows.columns {
            match &column.values {
                Values::Bytes(values) => {
                    if let Some((words, numbers)) = few(values.iter().map(ByteArray::data)) {
                        let mut plain = Vec::new();
                        for word in &words {
                            put_text(word, &mut plain);
                        }
                        let count = u32::try_from(words.len()).unwrap_or(u32::MAX);
                        self.add(rows.count, &column.levels, Body::Words(&plain, count, &numbers), None)?;
                        continue;
                    }
                }
                Values::Int64(values) => {
                    self.numbers_with(rows.count, &column.levels, values, None)?;
                    continue;
                }
                _ => {}
            }
            let mut plain = std::mem::take(&mut self.plain);
            plain.clear();
            put_plain(&column.values, &mut plain);
            let added = self.add(rows.count, &column.levels, Body::Plain(&plain), None);
            self.plain = plain;
            added?;
        }
        Ok(())
    }

    /// All columns of a row group; those of the next one follow.
    pub(in crate::exchange) fn group(&mut self) -> Group {
        Group { chunks: std::mem::take(&mut self.done) }
    }
}

/// A text behind its length.
pub(in crate::exchange) fn put_text(text: &[u8], out: &mut Vec<u8>) {
    // No cell is that long: pages are refused before.
    out.extend_from_slice(&u32::try_from(text.len()).unwrap_or(u32::MAX).to_le_bytes());
    out.extend_from_slice(text);
}

/// How many different words a column may have to be written as their numbers.
const WORDS: usize = 256;

/// How many values decide whether a column has few different words.
const LOOKED_AT: usize = 1_024;

/// The different values of a column and for each value the number of its own; `None` where there are many.
fn few<T: Copy + Eq + Hash>(values: impl ExactSizeIterator<Item = T>) -> Option<(Vec<T>, Vec<u8>)> {
    let mut known: HashMap<T, u8> = HashMap::new();
    let mut numbers = Vec::with_capacity(values.len().min(LOOKED_AT));
    let mut words = Vec::new();
    let mut last = None;
    for value in values {
        if let Some((before, number)) = last
            && before == value
        {
            numbers.push(number);
            continue;
        }
        let number = if let Some(number) = known.get(&value) {
            *number
        } else {
            let number = u8::try_from(words.len()).ok()?;
            if WORDS / 4 < words.len() && numbers.len() < LOOKED_AT {
                return None;
            }
            known.insert(value, number);
            words.push(value);
            number
        };
        last = Some((value, number));
        numbers.push(number);
    }
    Some((words, numbers)).filter(|(words, _)| !words.is_empty())
}

/// Eight to a byte, the first one in its lowest bit.
fn put_booleans(values: &[bool], out: &mut Vec<u8>) {
    let byte = |eight: &[bool]| eight.iter().rev().fold(0, |byte, is| byte << 1 | u8::from(*is));
    out.extend(values.chunks(8).map(byte));
}

/// The plain encoding of some values.
fn put_plain(values: &Values, out: &mut Vec<u8>) {
    match values {
        Values::Boolean(values) => put_booleans(values, out),
        Values::Int32(values) => values.iter().for_each(|value| out.extend_from_slice(&value.to_le_bytes())),
        Values::Int64(values) => values.iter().for_each(|value| out.extend_from_slice(&value.to_le_bytes())),
        Values::Int96(values) => {
            values.iter().flat_map(Int96::data).for_each(|word| out.extend_from_slice(&word.to_le_bytes()));
        }
        Values::Float(values) => values.iter().for_each(|value| out.extend_from_slice(&value.to_le_bytes())),
        Values::Double(values) => values.iter().for_each(|value| out.extend_from_slice(&value.to_le_bytes())),
        Values::Bytes(values) => values.iter().for_each(|value| put_text(value.data(), out)),
        Values::Fixed(values) => values.iter().for_each(|value| out.extend_from_slice(value.data())),
    }
}

/// Writes a file.
pub struct Writer<W: Write + Send> {
    file: SerializedFileWriter<W>,
}

impl<W: Write + Send> Writer<W> {
    /// The beginning of a file with these columns.
    ///
    /// # Errors
    /// What the stream reports.
    pub fn new(out: W, fields: &[Field]) -> io::Result<Self> {
        let properties = WriterProperties::builder().set_created_by(format!("fitcheck {}", env!("CARGO_PKG_VERSION")));
        let schema = schema(fields)?.root_schema_ptr();
        Ok(Self { file: SerializedFileWriter::new(out, schema, Arc::new(properties.build()))? })
    }

    /// The next row group.
    ///
    /// # Errors
    /// What the stream reports.
    pub fn write(&mut self, group: Group) -> io::Result<()> {
        let mut row_group = self.file.next_row_group()?;
        for chunk in group.chunks {
            row_group.append_column(&chunk.bytes, chunk.close)?;
        }
        row_group.close()?;
        Ok(())
    }

    /// The end of the file.
    ///
    /// # Errors
    /// What the stream reports.
    pub fn finish(mut self) -> io::Result<()> {
        self.file.finish()?;
        Ok(())
    }
}
