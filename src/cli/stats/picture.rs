//! `--picture`: all charts of a feature on one sheet.

use std::path::PathBuf;

use crate::cli::io::save;
use crate::cli::{CliError, Io};
use crate::message::Say as _;
use crate::report::ChartFile;
use crate::series::{Answer, Series};
use crate::statistics::picture::svg;
use crate::words::{Language, Words};

/// A file for a picture; its ending says the format.
#[derive(Debug, Clone)]
pub(super) struct PictureFile {
    path: PathBuf,
    format: ChartFile,
}

/// Reads `--picture`: a wrong ending is wrong usage.
pub(super) fn file(text: &str) -> Result<PictureFile, String> {
    let path = PathBuf::from(text);
    let format = ChartFile::of(&path).ok_or("expected a file that ends in .svg or .png")?;
    Ok(PictureFile { path, format })
}

impl PictureFile {
    pub(super) fn save(&self, series: &Series<'_>, answer: &Answer, io: &mut Io<'_>) -> Result<(), CliError> {
        let words = Words::new(Language::default());
        let sheet =
            answer.sheet(series, None, &words).map_err(|why| CliError::StatsNoPicture { why: why.message() })?;
        let drawing = svg(&sheet, series.name.as_deref().unwrap_or_default());
        save(&self.path, &self.format.bytes(&self.path.display().to_string(), &drawing)?, io)
    }
}
