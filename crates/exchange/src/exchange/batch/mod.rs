//! A verdict for every row of a stream of any length: blocks of whole rows in, the same rows with their answers out.
//!
//! | file | what |
//! |---|---|
//! | `layout` | what the first rows say: separator, columns, header |
//! | `cut` | a stream cut into blocks of whole rows |
//! | `court` | what every worker needs to judge, and which rows are plain |
//! | `judge` | rows judged: most of them fast, the others as `import` reads them |
//! | `limits` | plain rows judged by limits in columns of their own |
//! | `judged`, `compared` | a row with its verdict; what the file says beside it |
//! | `known` | limit deviations, looked up once for each class and step |
//! | `csv`, `tsv`, `json_lines` | the rows as CSV again, with the columns that are added; as TSV for spreadsheets; as JSON |
//! | `typed` | rows of columns with types, as text |
//! | `row_groups`, `answers` | the same from and into Parquet, with the feature `parquet` |
//! | `marks` | which verdict and class each row has, in two bytes a row |
//! | `pick` | some rows of a block once more, with their cells |
//! | `again` | the rows of a list once more: which have some words, the worst first |
//! | `tally` | how many rows had which verdict, and the first remarks |
//!
//! Nothing here opens a file or starts a thread: `batch` does, and hands blocks to as many judges as there are workers.

use std::borrow::Cow;

mod again;
#[cfg(feature = "parquet")]
mod answers;
mod compared;
mod court;
mod csv;
mod cut;
mod figures;
mod json_lines;
mod judge;
mod judged;
mod known;
mod layout;
mod limits;
mod marks;
mod pick;
#[cfg(feature = "parquet")]
mod row_groups;
mod tally;
mod tsv;
mod typed;

pub use again::{ListedRows, MOST_SIFTED, Sifted, Sifting, StreamBytes};
#[cfg(feature = "parquet")]
pub use answers::{Answers, output_fields};
pub use court::StreamJudging;
pub use csv::Csv;
pub use cut::{BLOCK, Block, Cutter, read};
pub use json_lines::JsonLines;
pub use judge::{Counts, Judge, JudgedCounts, Take};
pub use judged::{Judged, Rank};
pub use known::Figures;
pub use layout::{HEAD, Layout};
pub use marks::{FATES, Filter, Marks, Part, RowFate, Sieve, Store};
pub use pick::{Picked, pick};
#[cfg(feature = "parquet")]
pub use row_groups::{Purpose, Typed, layout_of};
pub use tally::{FIRST, Note, Notes, RowNoteKind, Tally};
pub use tsv::Tsv;
pub use typed::TypedBlock;

pub use super::index::row_end;
pub use super::row::{TextRow, cells_of};
use fitcheck_core::text::Within as _;

/// The names of the columns that are added, in order. They must not change.
pub const ADDED: [&str; 6] = ["min_mm", "max_mm", "deviation_um", "status", "remove_um", "error"];

/// A reason with the cells that have no column, which are not written.
fn with_cells_beyond<'a>(row: &TextRow<'_>, count: usize, reason: &'a str) -> Cow<'a, str> {
    if (count..row.len()).all(|at| row.cell(at).is_none_or(|cell| cell.trim_ascii().is_empty())) {
        return Cow::Borrowed(reason);
    }
    let beyond = row.bytes().within(row.first_cells(count).len() + 1..);
    Cow::Owned(format!("{reason}: {}", super::given::shorten(&String::from_utf8_lossy(beyond))))
}
