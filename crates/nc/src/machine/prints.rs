//! FN 16: masks to windows and files.

use std::collections::BTreeSet;

use super::budget::{Budget, UsedUp};
use super::fault::{BlockPlace, FaultKind};
use super::files::Files;
use super::path::NcPath;
use super::remark::{Remark, Remarks};
use super::values::Values;
use crate::control::mask::{Context, FileUse, Mask, MaskWarningKind, Output};
use crate::control::simulated::MARK;

/// A window that FN 16 has opened.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Window {
    pub place: BlockPlace,
    /// The mask; the program itself for `PRINT` of a lathe control, which has none.
    pub mask: NcPath,
    /// The text, every line ended by LF.
    pub text: String,
    /// Whether it is still open: `SCLR:` closes all windows.
    pub is_open: bool,
}

/// What FN 16 has printed to a file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Written {
    pub place: BlockPlace,
    /// The file.
    pub path: NcPath,
    /// The text, every line ended by LF; in the file the lines end in CRLF.
    pub text: String,
    /// Whether it replaces the old content or follows it.
    pub how: FileUse,
    /// Whether it is in the file: only if a folder was chosen.
    pub is_saved: bool,
}

/// What has been printed so far.
#[derive(Debug)]
pub(super) struct Prints {
    budget: Budget,
    /// Whether nobody measured what is printed: files say so.
    is_simulated: bool,
    /// The files that have the mark of that.
    marked: BTreeSet<NcPath>,
    windows: Vec<Window>,
    outputs: Vec<Written>,
    /// How many times something was printed to a file, also in vain.
    printed: usize,
    /// The files that it went to.
    files: BTreeSet<NcPath>,
    /// The files that no mask has closed yet.
    open: BTreeSet<NcPath>,
    bytes: usize,
}

impl Prints {
    pub(super) const fn new(budget: Budget, is_simulated: bool) -> Self {
        Self {
            budget,
            is_simulated,
            marked: BTreeSet::new(),
            windows: Vec::new(),
            outputs: Vec::new(),
            printed: 0,
            files: BTreeSet::new(),
            open: BTreeSet::new(),
            bytes: 0,
        }
    }

    pub(super) fn windows(&self) -> &[Window] {
        &self.windows
    }

    pub(super) fn outputs(&self) -> &[Written] {
        &self.outputs
    }

    /// `SCLR:`
    pub(super) fn close_windows(&mut self) {
        self.windows.iter_mut().for_each(|window| window.is_open = false);
    }

    fn count(&mut self, text: &str) -> Result<(), UsedUp> {
        self.bytes += text.len();
        let most = self.budget.output_bytes;
        if most < self.bytes { Err(UsedUp::Output(most)) } else { Ok(()) }
    }

    /// Opens a window.
    pub(super) fn show(&mut self, place: BlockPlace, mask: NcPath, text: String) -> Result<(), UsedUp> {
        self.count(&text)?;
        Budget::one_more(self.windows.len(), self.budget.windows, UsedUp::Windows)?;
        self.windows.push(Window { place, mask, text, is_open: true });
        Ok(())
    }

    /// Counts a text that is printed to a file.
    pub(super) fn count_output(&mut self, path: &NcPath, text: &str) -> Result<(), UsedUp> {
        self.count(text)?;
        Budget::one_more(self.printed, self.budget.outputs, UsedUp::Outputs)?;
        self.printed += 1;
        if !self.files.contains(path) {
            Budget::one_more(self.files.len(), self.budget.output_files, UsedUp::OutputFiles)?;
            self.files.insert(path.clone());
        }
        Ok(())
    }

    /// A file is no longer there: what was printed to it is in no file.
    pub(super) fn removed(&mut self, path: &NcPath) {
        self.open.remove(path);
        self.marked.remove(path);
        self.outputs.iter_mut().filter(|output| output.path == *path).for_each(|output| output.is_saved = false);
    }

    /// Keeps the text that was printed to a file.
    pub(super) fn keep(&mut self, output: Written) {
        self.outputs.push(output);
    }

    /// Collects outputs to the same file until a mask closes it.
    pub(super) fn print(
        &mut self,
        place: BlockPlace,
        path: NcPath,
        output: Output,
        files: &mut Files,
        remarks: &mut Remarks,
    ) -> Result<(), FaultKind> {
        self.count_output(&path, &output.text)?;
        let is_open = self.open.contains(&path);
        let how = if is_open && output.file == FileUse::Replace { FileUse::Append } else { output.file };
        if output.close {
            self.open.remove(&path);
        } else {
            self.open.insert(path.clone());
        }
        if let FileUse::AppendMax(kilobytes) = how
            && is_full(&path, kilobytes, output.text.len(), files)?
        {
            remarks.add(place, Remark::Full { path, kilobytes });
            return Ok(());
        }
        // What stands below the mark is simulated: once is enough, until the file is replaced. A text without figures measures nothing.
        if how == FileUse::Replace {
            self.marked.remove(&path);
        }
        let has_figures = output.text.contains(|c: char| c.is_ascii_digit());
        let is_marked = self.is_simulated && has_figures && self.marked.insert(path.clone());
        let mark = if is_marked { format!("{MARK}\n") } else { String::new() };
        let is_saved = save(&path, &encoded(&(mark + &output.text)), how, files)?;
        if !is_saved {
            remarks.add(place.clone(), Remark::NotWritten { path: path.clone() });
        }
        self.keep(Written { place, path, text: output.text, how, is_saved });
        Ok(())
    }
}

/// A mask, filled in, and what its reader has to say.
pub(super) fn rendered(
    mask: &NcPath,
    context: &Context<'_>,
    values: &Values,
    files: &mut Files,
) -> Result<(Output, Vec<Remark>), FaultKind> {
    let broken = |error| FaultKind::Mask { mask: mask.clone(), error: Box::new(error) };
    let bytes = files.read(mask)?;
    if bytes.iter().all(u8::is_ascii_whitespace) {
        // Programs make an empty file with it.
        let output = Output { text: String::new(), file: FileUse::Replace, close: false };
        return Ok((output, vec![Remark::EmptyMask { mask: mask.clone() }]));
    }
    let (read, mut warnings) = Mask::read(&bytes).map_err(broken)?;
    // The masks of NC-Solution 8255 have such a line; nothing of it is lost.
    warnings.retain(|warning| warning.what != MaskWarningKind::NoSemicolon);
    let refused = |error| FaultKind::Render { mask: mask.clone(), error: Box::new(error) };
    let output = read.render(values.all(), context).map_err(|error| {
        // What a mask asks for may be undefined because the block that sets it was not run.
        let unknown = read.parameters().into_iter().find_map(|parameter| values.check_known(parameter).err());
        unknown.unwrap_or_else(|| refused(error))
    })?;
    values.printed(read.parameters());
    let mut remarks = Remark::read(mask, &warnings);
    remarks.extend(Remark::read(mask, read.other_languages(context.language).as_slice()));
    Ok((output, remarks))
}

/// Writes a file and returns whether it is there now.
pub(super) fn save(path: &NcPath, bytes: &[u8], how: FileUse, files: &mut Files) -> Result<bool, FaultKind> {
    let size = files.write(path, bytes, how)?;
    if let Some(size) = size {
        files.spend(size)?;
    }
    Ok(size.is_some())
}

/// Whether this many more bytes would make a file larger than this many kilobytes.
fn is_full(path: &NcPath, kilobytes: u32, more: usize, files: &mut Files) -> Result<bool, FaultKind> {
    let size = match files.read(path) {
        Err(FaultKind::Store(_)) => 0,
        read => read?.len(),
    };
    let most = usize::try_from(kilobytes).unwrap_or(usize::MAX).saturating_mul(1_024);
    Ok(most < size.saturating_add(more))
}

/// Text as a control writes it: CRLF; Windows-1252 if the text needs it, UTF-8 if that is not enough.
fn encoded(text: &str) -> Vec<u8> {
    let text = text.replace('\n', "\r\n");
    match encoding_rs::WINDOWS_1252.encode(&text) {
        (bytes, _, false) => bytes.into_owned(),
        (_, _, true) => text.into_bytes(),
    }
}
