//! The measured parts of a file; everything about it that has to be said goes to standard error.

use std::io::Cursor;
use std::path::Path;

use crate::cli::CliError;
use crate::cli::io::{Io, read_input};
use crate::cli::progress::{Watched, Work};
use crate::cli::said::warning;
use crate::exchange::{ImportError, sizes_from};
use crate::message::Located;
use crate::report::pairing::{Note, PairingParts};
use crate::tolerance::Feature;

/// Reads a file; errors and warnings also go to standard error.
pub(in crate::cli) fn read_parts(path: &Path, feature: Feature, io: &mut Io<'_>) -> Result<PairingParts, CliError> {
    let (name, bytes) = read_input(path, io)?;
    let file = if path.as_os_str() == "-" { name.clone() } else { path.display().to_string() };
    let work = Work::on(&name, u64::try_from(bytes.len()).ok());
    io.watch(&work);
    let mut body = Cursor::new(bytes.as_slice());
    let sizes = sizes_from(&name, &mut Watched::new(&mut body, &work), feature, &mut || work.row());
    if work.is_stopped() {
        return Err(CliError::Stopped { rows: work.rows() });
    }
    drop(work);
    let parts = PairingParts::of_file(file, sizes);
    for note in &parts.notes {
        tell(&parts, note, io);
    }
    for error in &parts.errors {
        io.tell(format_args!("{}: {}", place(&parts, error), error.what.kind));
    }
    Ok(parts)
}

/// `holes.csv:4: warning: …`
pub(super) fn tell(parts: &PairingParts, note: &Note, io: &mut Io<'_>) {
    io.tell(format_args!("{}: {}", parts.place_of(note), warning(&note.what)));
}

/// `holes.csv:4:2`
fn place(parts: &PairingParts, error: &Located<ImportError>) -> String {
    let column = error.place.column.map_or(String::new(), |column| format!(":{column}"));
    format!("{}:{}{column}", parts.file(), error.place.line.unwrap_or(1))
}
