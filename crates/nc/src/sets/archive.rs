//! A set as one zip file.

use std::io::{Cursor, Write as _};

use zip::write::SimpleFileOptions;
use zip::{CompressionMethod, System, ZipWriter};

use super::SetFile;
use super::error::SetError;

/// Files without folders, not compressed, without a time and as if from one system, so that the same files always give the same bytes.
pub(super) fn zip(files: &[SetFile]) -> Result<Vec<u8>, SetError> {
    let options = SimpleFileOptions::default()
        .compression_method(CompressionMethod::Stored)
        .system(System::Unix)
        .unix_permissions(0o644);
    let mut writer = ZipWriter::new(Cursor::new(Vec::new()));
    let mut add = |file: &SetFile| {
        writer.start_file(file.name.as_str(), options)?;
        writer.write_all(&file.bytes)?;
        Ok(())
    };
    let failed = |error: zip::result::ZipError| SetError::Archive { reason: error.to_string() };
    files.iter().try_for_each(&mut add).map_err(failed)?;
    writer.finish().map(Cursor::into_inner).map_err(failed)
}
