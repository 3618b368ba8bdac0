//! The checks as QIF 3.0 (ISO 23952): features, characteristics with limits, and measurement results of each part.
//!
//! | file | what |
//! |---|---|
//! | `document` | the parts of the file in their order |
//! | `results` | the results of a part, and of the checks of no part |
//! | `ids` | the numbers of all things, known before they are written |
//! | `xml` | elements, with texts that stay texts |
//!
//! The status of a value says what the report says: PASS, REWORK, FAIL; `INDETERMINATE` where nothing is decided, `NOT_ANALYZED` where nobody
//! measured or a value is missing. Nothing but a good value that somebody measured is a PASS. What QIF has no element for stands in
//! attributes: the rule, the verdict in words, that it is simulated, what was measured before a correction, warnings, the notes of the
//! report. A place that is not known has the validity DUMMY. Contacts and pictures have no place here.

mod document;
mod ids;
mod results;
mod texts;
mod xml;

use std::io::{self, Write};

use fitcheck_core::words::Words;

use super::{Holds, Rendering, Report};

pub const RENDERING: Rendering =
    Rendering { name: "qif", title: "QIF", is_for_people: false, holds: Holds::Report, endings: &["qif"], render };

fn render(report: &Report, _words: &Words, out: &mut dyn Write) -> io::Result<()> {
    document::write(report, out)
}
