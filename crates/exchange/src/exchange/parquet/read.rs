//! The rows of a file, a few thousand at a time, however large its row groups are.

use parquet::basic::Type as Physical;
use parquet::column::reader::{ColumnReader, get_column_reader};
use parquet::errors::ParquetError;
use parquet::file::reader::{ChunkReader, FileReader as _, SerializedFileReader};

use super::Field;
use super::checked::Checked;
use super::column::Rows;
use super::guarded::guarded;
use crate::exchange::error::ImportErrorKind;
use fitcheck_core::text::long;

/// How many rows are read of one column before the next one's turn.
const STEP: usize = 8_192;

/// About how many bytes of rows are read before they are counted, 2 MiB.
const STEP_BYTES: usize = 2 << 20;

/// How many rows are given out at a time.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct PortionSize {
    /// So many rows,
    pub rows: usize,
    /// or so many bytes of them, at least one row.
    pub bytes: usize,
}

/// Reads a file from its beginning to its end.
pub struct Reader<R: ChunkReader> {
    file: SerializedFileReader<R>,
    fields: Vec<Field>,
    /// The row group that comes next.
    group: usize,
    /// The columns of the row group at hand.
    readers: Vec<ColumnReader>,
    /// How many rows of it were not read yet.
    left: usize,
    /// What was read beyond what was wanted.
    rest: Option<Rows>,
    /// About how many bytes a row has.
    row_bytes: usize,
    /// How many bytes the file has.
    size: u64,
    /// How many rows were given out.
    given: u64,
}

impl<R: ChunkReader + 'static> Reader<R> {
    /// Reads the end of a file, where its columns are.
    ///
    /// # Errors
    /// Why it is no Parquet file, or cannot be read as rows of cells.
    pub fn new(file: R) -> Result<Self, ImportErrorKind> {
        let damaged = |error: ParquetError| ImportErrorKind::Parquet { reason: reason(&error) };
        let size = file.len();
        let file = guarded(|| SerializedFileReader::new(file)).map_err(damaged)?;
        let columns = file.metadata().file_metadata().schema_descr().columns();
        let fields: Result<Vec<Field>, String> = columns.iter().map(|column| Field::of(column)).collect();
        let fields = fields.map_err(|column| ImportErrorKind::ParquetNested { column })?;
        Ok(Self {
            file,
            fields,
            group: 0,
            readers: Vec::new(),
            left: 0,
            rest: None,
            row_bytes: STEP_BYTES / STEP,
            size,
            given: 0,
        })
    }

    /// The columns.
    pub fn fields(&self) -> &[Field] {
        &self.fields
    }

    /// About how many bytes of the file were given out, by its rows.
    pub fn bytes(&self) -> u64 {
        let rows = self.file.metadata().file_metadata().num_rows().max(1).unsigned_abs();
        let bytes = u128::from(self.size) * u128::from(self.given.min(rows)) / u128::from(rows);
        u64::try_from(bytes).unwrap_or(self.size)
    }

    /// Reads the next rows; `false` at the end.
    ///
    /// # Errors
    /// What is damaged.
    pub(in crate::exchange) fn next(&mut self, wanted: PortionSize, rows: &mut Rows) -> Result<bool, ParquetError> {
        let is_there = guarded(|| self.fill(wanted, rows))?;
        self.given += long(rows.count);
        Ok(is_there)
    }

    fn fill(&mut self, wanted: PortionSize, rows: &mut Rows) -> Result<bool, ParquetError> {
        let mut bytes = 0;
        let mut counted = 0;
        if let Some(rest) = self.rest.take() {
            *rows = rest;
        } else {
            if self.left == 0 && !self.open_next()? {
                return Ok(false);
            }
            rows.clear(&self.fields, &self.readers);
        }
        loop {
            let (some, more) = rows.up_to(counted, wanted.bytes.saturating_sub(bytes));
            if counted + some < rows.count {
                self.rest = Some(rows.split_off(counted + some));
                return Ok(true);
            }
            if let Some(bytes) = more.checked_div(some) {
                self.row_bytes = bytes.max(1);
            }
            counted += some;
            bytes += more;
            if wanted.rows <= counted || wanted.bytes <= bytes {
                return Ok(true);
            }
            if self.left == 0 && !self.open_next()? {
                return Ok(0 < rows.count);
            }
            let step = STEP.min((STEP_BYTES / self.row_bytes).max(1)).min(self.left).min(wanted.rows - counted);
            rows.read(&mut self.readers, &self.fields, step)?;
            self.left -= step;
        }
    }

    /// Opens the next row group that has rows; `false` where there is none.
    fn open_next(&mut self) -> Result<bool, ParquetError> {
        while self.left == 0 {
            if self.file.num_row_groups() <= self.group {
                return Ok(false);
            }
            let group = self.file.get_row_group(self.group)?;
            let of_group = group.metadata();
            let rows = of_group.num_rows();
            for (column, field) in of_group.columns().iter().zip(&self.fields) {
                let name = field.name();
                let general = |what: &str| Err(ParquetError::General(format!("column {name} {what}")));
                if column.num_values() != rows {
                    return general("has not as many values as its row group rows");
                }
                let begin = column.dictionary_page_offset().unwrap_or_else(|| column.data_page_offset());
                let begin_and_size = (u64::try_from(begin), u64::try_from(column.compressed_size()));
                match begin_and_size {
                    (Ok(begin), Ok(size)) if begin.checked_add(size).is_some_and(|end| end <= self.size) => {}
                    _ => return general("is not where the file says"),
                }
            }
            self.left = usize::try_from(rows)
                .map_err(|error| ParquetError::General(format!("the rows of a row group: {error}")))?;
            self.readers = (0..)
                .zip(of_group.columns())
                .map(|(at, column)| {
                    let checked = Checked {
                        pages: group.get_column_page_reader(at)?,
                        has_texts: column.column_type() == Physical::BYTE_ARRAY,
                        has_gaps: 0 < column.column_descr().max_def_level(),
                        has_words: false,
                    };
                    Ok(get_column_reader(column.column_descr_ptr(), Box::new(checked)))
                })
                .collect::<Result<_, ParquetError>>()?;
            // A file may say anything of its size: this only decides how many rows are read at once.
            let all = usize::try_from(of_group.total_byte_size()).map_or(0, |all| all);
            self.row_bytes = (all / self.left.max(1)).max(1);
            self.group += 1;
        }
        Ok(true)
    }
}

/// What is wrong, without the name of the format in front of it.
pub(super) fn reason(error: &ParquetError) -> String {
    match error {
        ParquetError::General(reason) | ParquetError::NYI(reason) | ParquetError::EOF(reason) => reason.clone(),
        other => other.to_string(),
    }
}
