//! Tables of the control, `.TAB` and relatives: read, converted and written.
//!
//! | file | what |
//! |---|---|
//! | `read` | bytes to a table: BEGIN line, names of the columns, rows, `[END]` |
//! | `reader` | the pass over its lines |
//! | `file` | a table as it is in a file, with the places of its parts |
//! | `block` | the two blocks that describe columns: `#STRUCTBEGIN` and `TableDescription` |
//! | `write` | a table to bytes |
//! | `patch` | other texts in some cells of a file, every other byte kept |
//! | `fault` | errors and warnings with file, line and column |
//!
//! A cell is only a text here. Other modules, such as [`super::deviations`], know what a column means. Formats and
//! rules: `docs/SOURCES.md`.

mod block;
mod fault;
mod file;
mod patch;
mod read;
mod reader;
mod write;

use fitcheck_core::length::decimal_parts;

pub use fault::{TableError, TableFault, TableWarning, TableWarningKind};
pub use file::TableFile;
pub use write::WriteError;

/// A control's table.
///
/// ```
/// use fitcheck_nc::control::table::ControlTable;
///
/// let file = ControlTable::read(b"BEGIN own.tab MM\r\nNR BEREICH U1\r\n0  3       +8\r\n[END]\r\n", "own.tab")?;
/// assert_eq!(file.table.rows, [["0", "3", "+8"]]);
/// # Ok::<(), fitcheck_nc::control::table::TableError>(())
/// ```
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct ControlTable {
    /// The name in the BEGIN line, without its suffix: `82553_hole`.
    pub name: String,
    /// The suffix without its dot, if there is one.
    pub suffix: Option<String>,
    /// The unit in the BEGIN line, if there is one.
    pub unit: Option<TableUnit>,
    /// The text in quotation marks after `Version:`.
    pub version: Option<String>,
    /// What else is in the BEGIN line: `U`, as far as known.
    pub mark: Option<String>,
    /// How the columns are described.
    pub generation: Generation,
    /// The columns in the table's order; no name occurs twice.
    pub columns: Vec<Column>,
    /// What a `TableDescription` says about the whole table, such as `primaryKey`: key and value as written.
    pub properties: Vec<(String, String)>,
    /// The rows; each has one trimmed text per column.
    pub rows: Vec<Vec<String>>,
    /// The comments in the file's order.
    pub comments: Vec<Comment>,
}

/// The unit of a table, in its BEGIN line.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum TableUnit {
    /// `MM`.
    Millimetre,
    Inch,
}

impl TableUnit {
    const fn word(self) -> &'static str {
        match self {
            Self::Millimetre => "MM",
            Self::Inch => "INCH",
        }
    }
}

/// The three kinds of header, by age.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub enum Generation {
    /// BEGIN line and names only.
    #[default]
    Plain,
    /// A block `#STRUCTBEGIN` … `#STRUCTEND`: iTNC 530 and older.
    Structure,
    /// A block `TableDescription ( … )`: TNC 640, TNC7, `MillPlus`.
    Description,
}

#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Column {
    /// The name: a run of characters without blanks, compared with its case.
    pub name: String,
    /// Characters from the start of this column to the start of the next one; more than the length of the name.
    pub width: usize,
    /// The word for the type, if a block gives one: `N`, `C`, `FLOAT`, `TEXT` …
    pub kind: Option<String>,
    /// Decimals, if a `#STRUCTBEGIN` block gives them (`DEC`).
    pub decimals: Option<usize>,
    /// Everything else that the block says, key and value as written: `DIA-ENGLISH`, `initial` …
    pub settings: Vec<(String, String)>,
}

impl Column {
    /// A column of a plain table.
    pub fn plain(name: &str, width: usize) -> Self {
        Self { name: name.to_owned(), width, kind: None, decimals: None, settings: Vec::new() }
    }

    /// Whether the block calls it a text; `None` if no block says so or otherwise.
    pub fn is_text(&self) -> Option<bool> {
        self.kind.as_deref().map(|kind| matches!(kind, "C" | "TEXT" | "UPTEXT" | "PATHNAME" | "TSTAMP" | "L" | "X"))
    }

    /// Whether the block says anything about it except its width.
    const fn is_described(&self) -> bool {
        self.kind.is_some() || self.decimals.is_some() || !self.settings.is_empty()
    }
}

/// A comment, without the sign that marks it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Comment {
    pub place: CommentPlace,
    pub text: String,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum CommentPlace {
    /// Between the BEGIN line and the names of the columns, outside a block.
    Header,
    Block,
    /// Before the row of this number, counted from 0; after the last row it is the number of rows.
    Row(usize),
}

impl ControlTable {
    /// The file name of the BEGIN line, `82553_hole.tab`.
    pub fn file_name(&self) -> String {
        match &self.suffix {
            Some(suffix) => format!("{}.{suffix}", self.name),
            None => self.name.clone(),
        }
    }

    /// The number of the column with this name.
    pub fn column(&self, name: &str) -> Option<usize> {
        self.columns.iter().position(|column| column.name == name)
    }

    /// The text of a cell; empty beyond the table.
    pub fn cell(&self, row: usize, column: usize) -> &str {
        self.rows.get(row).and_then(|cells| cells.get(column)).map_or("", String::as_str)
    }

    /// The same table with another kind of header.
    ///
    /// Types are translated (numbers, texts) or, if none is given, derived from the cells. Entries that only one kind
    /// of header can hold (dialogue texts, initial values, limits, properties of the table) are left out.
    #[must_use]
    pub fn to_generation(&self, generation: Generation) -> Self {
        let mut table = self.clone();
        if generation == self.generation {
            return table;
        }
        table.generation = generation;
        table.properties = Vec::new();
        for (number, column) in table.columns.iter_mut().enumerate() {
            let cells = || self.rows.iter().filter_map(|row| row.get(number).map(String::as_str));
            let is_text = column.is_text().unwrap_or_else(|| !cells().all(|cell| is_blank(cell) || is_number(cell)));
            let decimals = cells().map(decimals).fold(0, usize::max);
            // No #STRUCTBEGIN block contains the row number.
            let is_row_number = column.name == "NR" && generation == Generation::Structure;
            let kind = match generation {
                Generation::Plain => None,
                Generation::Structure if is_row_number => None,
                Generation::Structure => Some(if is_text { "C" } else { "N" }),
                Generation::Description if is_text => Some("TEXT"),
                Generation::Description if column.name == "NR" => Some("INT"),
                // Never LENGTH: a control set to inches would convert it.
                Generation::Description => Some("FLOAT"),
            };
            column.kind = kind.map(str::to_owned);
            column.decimals =
                (generation == Generation::Structure && !is_row_number).then_some(if is_text { 0 } else { decimals });
            column.settings = Vec::new();
        }
        if generation == Generation::Plain {
            for comment in &mut table.comments {
                if comment.place == CommentPlace::Block {
                    comment.place = CommentPlace::Header;
                }
            }
        }
        table
    }
}

/// Whether a cell holds no value: blank or a lone `-` (`docs/SOURCES.md`).
pub(crate) fn is_blank(cell: &str) -> bool {
    cell.is_empty() || cell == "-"
}

/// Whether a cell is written as a number: optional sign, digits, one point or comma.
pub(crate) fn is_number(cell: &str) -> bool {
    let digits = cell.strip_prefix(['+', '-', '\u{2212}']).unwrap_or(cell);
    decimal_parts(digits).is_some()
}

fn decimals(cell: &str) -> usize {
    if is_number(cell) { cell.split_once(['.', ',']).map_or(0, |(_, decimals)| decimals.len()) } else { 0 }
}
