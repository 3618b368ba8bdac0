//! A file that is read, piece by piece or whole, and what is needed besides it.

use std::borrow::Cow;
use std::io::{Read, Seek, SeekFrom};
use std::sync::Arc;

use fitcheck_core::length::Unit;
use fitcheck_core::text;
use fitcheck_core::tolerance::Sources;
use fitcheck_core::tolerance::fit::thermal::Temperature;
use fitcheck_nc::control::mask::Mask;
use jiff::civil::DateTime;

use super::error::ImportErrorKind;
use super::lookup::Lookup;
use super::mapping::{ColumnUnit, Mapping};
use super::pieces::Pieces;

/// How much of a file is examined to recognise it.
pub(super) const HEAD: usize = 64 << 10;

/// The largest file of a format that is read whole, 64 MiB.
pub const WHOLE: u64 = 64 << 20;

/// The bytes of a file, from any place in it.
pub trait Body: Read + Seek {}

impl<T: Read + Seek> Body for T {}

/// What is needed to read a file, besides the file.
#[derive(Clone, Copy)]
pub struct ImportInputs<'a> {
    /// Where limits are looked up.
    pub sources: &'a Sources,
    /// The time of measurements whose file has none.
    pub now: DateTime,
    /// The bytes of the file beside it that has another ending, such as `dfx`: some formats are two files.
    pub beside: &'a dyn Fn(&str) -> Option<Vec<u8>>,
    /// The masks of which one has printed the file, with their names: with any, it is read through them and in no other way.
    pub masks: &'a [(String, Mask)],
    /// Which column of a CSV is which, as the user says: with it, every file is read as a CSV or a workbook of measurements.
    pub mapping: Option<&'a Mapping>,
    /// Whether a plan judges what is read: a value of zero or less may be a deviation or a coordinate, and the plan knows.
    pub has_plan: bool,
    /// From which temperature the values are brought to 20 °C later; `None` where they count as they are.
    pub temperature: Option<Temperature>,
    /// The most rows that are read, where all of them are kept in memory; an error says that there are more.
    pub most_rows: usize,
    /// Hears the first and the last line of each log, print or value that has several lines, also of one that could not be read.
    pub units: &'a dyn Fn(usize, usize),
}

impl<'a> ImportInputs<'a> {
    /// No file beside it, and as many rows as it has.
    pub fn new(sources: &'a Sources, now: DateTime) -> Self {
        Self {
            sources,
            now,
            beside: &|_ending| None,
            masks: &[],
            mapping: None,
            has_plan: false,
            temperature: None,
            most_rows: usize::MAX,
            units: &|_first, _last| {},
        }
    }
}

impl std::fmt::Debug for ImportInputs<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Given").field("sources", self.sources).field("now", &self.now).finish_non_exhaustive()
    }
}

/// The beginning of a file, by which it is recognised.
pub(super) struct Beginning<'a> {
    /// The file's name without its folder.
    pub(super) file: &'a str,
    /// At most [`HEAD`] bytes.
    pub(super) bytes: &'a [u8],
}

impl<'a> Beginning<'a> {
    /// That of a file of which these are the first bytes.
    pub(super) fn new(file: &'a str, bytes: &'a [u8]) -> Self {
        Self { file, bytes: bytes.get(..HEAD).unwrap_or(bytes) }
    }

    /// Whether it is the whole file, and nothing but blanks.
    fn is_blank(&self) -> bool {
        self.bytes.len() < HEAD && self.text().trim().is_empty()
    }

    /// Its text, in whole lines: UTF-16 with a byte order mark, UTF-8, else Windows-1252.
    pub(super) fn text(&self) -> Cow<'a, str> {
        if self.bytes.len() < HEAD {
            return decode(self.bytes);
        }
        let end = self.bytes.iter().rposition(|&byte| byte == b'\n').map_or(HEAD, |end| end + 1);
        decode(self.bytes.get(..end).unwrap_or(self.bytes))
    }
}

/// What every row of a file is judged with.
#[derive(Debug, Clone)]
pub(super) struct Context<'a> {
    /// The file's name without its folder.
    pub(super) file: Arc<str>,
    pub(super) sources: &'a Sources,
    /// The time of measurements whose file has none.
    pub(super) now: DateTime,
    /// The temperature at which values count as measured.
    pub(super) counted: Temperature,
    /// What its rows have asked so far.
    pub(super) lookup: Lookup,
}

/// A file and what is needed to judge its contents.
pub(super) struct Source<'a> {
    pub(super) context: Context<'a>,
    /// Its first bytes, up to [`HEAD`].
    head: Vec<u8>,
    /// How many bytes it has.
    length: u64,
    body: &'a mut dyn Body,
    pub(super) given: ImportInputs<'a>,
}

impl<'a> Source<'a> {
    /// A file at its beginning.
    ///
    /// # Errors
    /// [`ImportErrorKind::Read`] with what the system says.
    pub(super) fn new(
        file_name: &str,
        body: &'a mut dyn Body,
        given: ImportInputs<'a>,
    ) -> Result<Self, ImportErrorKind> {
        let mut head = Vec::new();
        let mut begin = |head: &mut Vec<u8>| {
            let length = body.seek(SeekFrom::End(0))?;
            body.rewind()?;
            let most = HEAD.try_into().unwrap_or(u64::MAX);
            Read::take(&mut *body, most).read_to_end(head)?;
            std::io::Result::Ok(length)
        };
        let length = begin(&mut head).map_err(|error| ImportErrorKind::read(&error))?;
        let context = Context {
            file: file_name.into(),
            sources: given.sources,
            now: given.now,
            counted: given.temperature.unwrap_or(Temperature::REFERENCE),
            lookup: Lookup::default(),
        };
        Ok(Self { context, head, length, body, given })
    }

    /// The unit of what says none, where the user has said it.
    pub(super) fn given_unit(&self) -> Option<Unit> {
        self.given.mapping.and_then(Mapping::unit).map(ColumnUnit::unit)
    }

    /// By what it is recognised.
    pub(super) fn beginning(&self) -> Beginning<'_> {
        Beginning::new(&self.context.file, &self.head)
    }

    /// Whether it has nothing but blanks.
    pub(super) fn is_blank(&self) -> bool {
        self.beginning().is_blank()
    }

    /// The bytes from the beginning.
    ///
    /// # Errors
    /// [`ImportErrorKind::Read`] with what the system says.
    pub(super) fn bytes(&mut self) -> Result<&mut dyn Body, ImportErrorKind> {
        self.body.rewind().map_err(|error| ImportErrorKind::read(&error))?;
        Ok(self.body)
    }

    /// The text in pieces of whole lines, from the beginning; each of the bytes `ends` ends a line.
    ///
    /// # Errors
    /// [`ImportErrorKind::Read`] with what the system says.
    pub(super) fn pieces(&mut self, ends: &'static [u8]) -> Result<Pieces<'_>, ImportErrorKind> {
        // A shorter file has no mark.
        let head: [u8; 2] = self.head.first_chunk().map_or([0; 2], |head| *head);
        Ok(Pieces::new(self.bytes()?, &head, ends))
    }

    /// All bytes of a format that is read whole.
    ///
    /// # Errors
    /// [`ImportErrorKind::TooLarge`] beyond [`WHOLE`], before it fills the memory; [`ImportErrorKind::Read`].
    pub(super) fn whole(&mut self) -> Result<Vec<u8>, ImportErrorKind> {
        let too_large = ImportErrorKind::TooLarge { most: WHOLE >> 20 };
        if WHOLE < self.length {
            return Err(too_large);
        }
        let mut all = Vec::new();
        // A file that grows has no length beforehand: one byte more than allowed tells.
        self.bytes()?.take(WHOLE + 1).read_to_end(&mut all).map_err(|error| ImportErrorKind::read(&error))?;
        if WHOLE < all.len().try_into().unwrap_or(u64::MAX) { Err(too_large) } else { Ok(all) }
    }
}

/// The text of a whole file: UTF-16 with a byte order mark, UTF-8, else Windows-1252.
pub(super) fn decode(bytes: &[u8]) -> Cow<'_, str> {
    match encoding_rs::Encoding::for_bom(bytes) {
        // Spreadsheets save "Unicode text" this way.
        Some((encoding, _)) if encoding != encoding_rs::UTF_8 => encoding.decode(bytes).0,
        _ => text::decode(bytes),
    }
}
