//! What a written report says, against the journal that its checks are in.
//!
//! | file | what |
//! |---|---|
//! | `attachment` | the checks of a file as data: what a PDF has attached, or a file of JSON itself |
//! | `agreement` | each of these checks beside the entry that it was made from |
//! | `seen` | a file that is hashed while it is written |
//!
//! The bytes of a file are recognised by their SHA-256. What is here says more: which check of a file that is not the one that was written
//! is another one, and whether the data that a program reads is what the journal says.

mod agreement;
mod attachment;
mod seen;

pub use agreement::{Difference, Disagreement, JournalCheck, compare};
pub use attachment::{AttachmentError, LARGEST, attached_json, json_of};
pub use seen::{Seen, SeenFile};

use fitcheck_core::message::{Message, Say as _, message};

use crate::report::changes::EarlierReport;

/// The earlier report in a file: a PDF with its data, or JSON.
///
/// # Errors
/// It is none, or what a PDF has attached cannot be read.
pub fn earlier_report(file: &[u8]) -> Result<EarlierReport, Message> {
    let data = json_of(file).ok_or_else(|| message!("report-since-no-report"))?;
    EarlierReport::read(&data.map_err(|error| error.message())?)
}
