//! FN 16: masks to windows and files.

use jiff::civil::DateTime;

use super::budget::{Budget, UsedUp};
use super::fault::{BlockPlace, FaultKind};
use super::path::NcPath;
use super::remark::Remark;
use super::run::Machine;
use super::store::StoreError;
use crate::control::mask::{Context, FileUse, Mask, Output};
use crate::nc::program::TextOperand;

/// A window that FN 16 has opened.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Window {
    /// The block.
    pub place: BlockPlace,
    /// The mask.
    pub mask: NcPath,
    /// The text, every line ended by LF.
    pub text: String,
    /// Whether it is still open: `SCLR:` closes all.
    pub is_open: bool,
}

/// What FN 16 has printed to a file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Written {
    /// The block.
    pub place: BlockPlace,
    /// The file.
    pub path: NcPath,
    /// The text, every line ended by LF; in the file they end in CRLF.
    pub text: String,
    /// Whether it stands in place of what was there or behind it.
    pub how: FileUse,
    /// Whether it is in the file: only where a folder was chosen.
    pub is_saved: bool,
}

impl Machine {
    pub(super) fn print(&mut self, at: usize, mask: &TextOperand, output: &TextOperand) -> Result<(), FaultKind> {
        let to = self.text_operand(output)?;
        let is = |word: &str| to.trim().eq_ignore_ascii_case(word);
        if is("SCLR:") {
            self.windows.iter_mut().for_each(|window| window.is_open = false);
            return Ok(());
        }
        let is_screen = is("SCREEN:");
        let path = if is_screen { None } else { Some(self.path_of(output)?) };
        let mask = self.path_of(mask)?;
        let output = self.rendered(&mask)?;
        self.output_bytes += output.text.len();
        if self.budget().output_bytes < self.output_bytes {
            return Err(UsedUp::Output(self.budget().output_bytes).into());
        }
        if let Some(path) = path {
            return self.print_to_file(at, path, output);
        }
        Budget::one_more(self.windows.len(), self.budget().windows, UsedUp::Windows)?;
        let place = self.place_of(at);
        self.windows.push(Window { place, mask, text: output.text, is_open: true });
        Ok(())
    }

    fn rendered(&mut self, mask: &NcPath) -> Result<Output, FaultKind> {
        let bytes = self.read(mask)?;
        let broken = |error| FaultKind::Mask { mask: mask.clone(), error: Box::new(error) };
        let (read, _warnings) = Mask::read(&bytes).map_err(broken)?;
        let call_path = self.frame.path.to_string();
        let time: DateTime = self.settings.time;
        let context = Context { language: self.settings.language, time, call_path: &call_path };
        let refused = |error| FaultKind::Render { mask: mask.clone(), error: Box::new(error) };
        read.render(&self.variables, &context).map_err(refused)
    }

    /// Outputs to the same file are collected until a mask closes it.
    fn print_to_file(&mut self, at: usize, path: NcPath, output: Output) -> Result<(), FaultKind> {
        Budget::one_more(self.outputs.len(), self.budget().outputs, UsedUp::Outputs)?;
        let is_open = self.open_outputs.contains(&path);
        let how = if is_open && output.file == FileUse::Replace { FileUse::Append } else { output.file };
        if output.close {
            self.open_outputs.remove(&path);
        } else {
            self.open_outputs.insert(path.clone());
        }
        if let FileUse::AppendMax(kilobytes) = how
            && self.is_full(&path, kilobytes, output.text.len())?
        {
            self.remark(at, Remark::Full { path, kilobytes });
            return Ok(());
        }
        let is_saved = match self.store.write(&path, &encoded(&output.text), how) {
            Ok(bytes) => {
                self.moved(bytes)?;
                true
            }
            Err(StoreError::ReadOnly) => {
                self.remark(at, Remark::NotWritten { path: path.clone() });
                false
            }
            Err(error) => return Err(error.into()),
        };
        let place = self.place_of(at);
        self.outputs.push(Written { place, path, text: output.text, how, is_saved });
        Ok(())
    }

    /// Whether so much more would make a file larger than so many kilobytes.
    fn is_full(&mut self, path: &NcPath, kilobytes: u32, more: usize) -> Result<bool, FaultKind> {
        let size = match self.read(path) {
            Err(FaultKind::Store(_)) => 0,
            read => read?.len(),
        };
        let most = usize::try_from(kilobytes).unwrap_or(usize::MAX).saturating_mul(1_024);
        Ok(most < size.saturating_add(more))
    }
}

/// Text as a control writes it: CRLF, Windows-1252 where the text needs it, UTF-8 where that is not enough.
fn encoded(text: &str) -> Vec<u8> {
    let text = text.replace('\n', "\r\n");
    match encoding_rs::WINDOWS_1252.encode(&text) {
        (bytes, _, false) => bytes.into_owned(),
        (_, _, true) => text.into_bytes(),
    }
}
