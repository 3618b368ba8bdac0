//! Parquet: columns of typed values in and out, row group by row group.
//!
//! | file | what |
//! |---|---|
//! | `field` | what a column of a file is: its name, its type, and how its values are read |
//! | `column` | some rows of a column in memory, and one value of it |
//! | `typed` | what a stored value is, by the type of its column |
//! | `checked`, `guarded` | pages looked at before they are decoded; a panic of a decoder as an error |
//! | `read` | the rows of a file, a few thousand at a time, however large its row groups are |
//! | `page`, `delta` | the values of a column as a packed page; whole numbers as packed differences |
//! | `write` | row groups, made by any thread, and the file that they become |
//!
//! The format: Apache Parquet 2, <https://github.com/apache/parquet-format>. Nested columns are refused. Nothing here opens
//! a file: whatever can be read at any place will do.

mod checked;
mod column;
mod delta;
mod field;
mod guarded;
mod page;
mod read;
mod typed;
mod write;

pub(in crate::exchange) use column::Rows;
pub use field::Field;
pub(in crate::exchange) use field::added;
pub use parquet::file::reader::ChunkReader;
pub use read::{PortionSize, Reader};
pub(in crate::exchange) use typed::typed;
pub(in crate::exchange) use write::{Chunks, put_text};
pub use write::{Group, Writer};
