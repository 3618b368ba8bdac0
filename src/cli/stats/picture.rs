//! `--picture`: all charts of a feature on one sheet.

use std::path::PathBuf;

use crate::cli::io::save;
use crate::cli::{CliError, Io};
use crate::message::Say as _;
use crate::report::png::of_svg;
use crate::series::{Answer, Series};
use crate::statistics::picture::svg;
use crate::words::{Language, Words};

/// Dots for each unit of the drawing: lines and texts stay sharp on a page.
const FINENESS: u16 = 3;

/// A file for a picture; its ending says the format.
#[derive(Debug, Clone)]
pub(super) struct PictureFile {
    path: PathBuf,
    is_png: bool,
}

/// Reads `--picture`: a wrong ending is wrong usage.
pub(super) fn file(text: &str) -> Result<PictureFile, String> {
    let path = PathBuf::from(text);
    let ending = path.extension().and_then(|ending| ending.to_str()).map(str::to_ascii_lowercase);
    match ending.as_deref() {
        Some("svg") => Ok(PictureFile { path, is_png: false }),
        Some("png") => Ok(PictureFile { path, is_png: true }),
        _ => Err("expected a file that ends in .svg or .png".to_owned()),
    }
}

impl PictureFile {
    pub(super) fn save(&self, series: &Series<'_>, answer: &Answer, io: &mut Io<'_>) -> Result<(), CliError> {
        let words = Words::new(Language::default());
        let sheet =
            answer.sheet(series, None, &words).map_err(|why| CliError::StatsNoPicture { why: why.message() })?;
        let name = series.name.as_deref().unwrap_or_default();
        let drawing = svg(&sheet, name);
        if self.is_png {
            let what = self.path.display().to_string();
            save(&self.path, &of_svg(&what, &drawing, FINENESS)?, io)
        } else {
            save(&self.path, drawing.as_bytes(), io)
        }
    }
}
