//! What comes in and goes out: plain, packed with gzip or Zstandard, and UTF-16 turned into UTF-8.

use std::io::{self, Cursor, Read, Write as _};
use std::path::Path;

use fitcheck_core::text::utf16;
use flate2::Compression;
use flate2::read::MultiGzDecoder;
use flate2::write::GzEncoder;

use crate::exchange::batch::{BLOCK, HEAD, Layout, read};
use crate::exchange::{ImportErrorKind, Mapping, pieces};

/// The largest window of a Zstandard stream, 2^23 bytes: up to level 19 none is larger, and each takes memory.
const WINDOW_LOG: u32 = 23;

/// What a stream is packed with.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub enum Packing {
    /// Nothing.
    #[default]
    Plain,
    /// gzip (RFC 1952).
    Gzip,
    /// Zstandard (RFC 8878).
    Zstandard,
}

impl Packing {
    /// The packing that a file's last ending names, and the name without it and without its folder.
    pub fn of_name(path: &Path) -> (Self, &Path) {
        // A name need not be text.
        let found = [("gz", Self::Gzip), ("zst", Self::Zstandard)];
        let found = path.extension().zip(path.file_stem()).and_then(|(last, before)| {
            let packing = found.into_iter().find(|(ending, _)| last.eq_ignore_ascii_case(ending));
            packing.map(|(_, packing)| (packing, Path::new(before)))
        });
        found.unwrap_or((Self::Plain, path))
    }

    fn of_head(head: &[u8]) -> Self {
        match head {
            [0x1f, 0x8b, ..] => Self::Gzip,
            [0x28, 0xb5, 0x2f, 0xfd, ..] => Self::Zstandard,
            _ => Self::Plain,
        }
    }

    /// A text packed by itself; several of them one after the other are one stream. At the fastest level, because the
    /// next ones take three times as long for a tenth less.
    ///
    /// # Errors
    /// What the packer reports.
    pub fn pack<'a>(self, text: &'a [u8], packed: &'a mut Vec<u8>) -> io::Result<&'a [u8]> {
        packed.clear();
        match self {
            Self::Plain => Ok(text),
            Self::Gzip => {
                let mut encoder = GzEncoder::new(packed, Compression::fast());
                encoder.write_all(text)?;
                encoder.finish().map(|packed| packed.as_slice())
            }
            Self::Zstandard => {
                let mut encoder = zstd::Encoder::new(packed, 1)?;
                encoder.write_all(text)?;
                encoder.finish().map(|packed| packed.as_slice())
            }
        }
    }
}

/// Whether a file begins like Parquet: its mark, and then bytes that no text has.
fn is_parquet(head: &[u8]) -> bool {
    let is_text = |byte: &u8| !byte.is_ascii_control() || matches!(byte, b'\t' | b'\n' | b'\r');
    head.strip_prefix(b"PAR1").is_some_and(|rest| !rest.first().is_some_and(is_text))
}

/// A stream of text, whatever it is packed with.
pub struct Stream<'a> {
    /// The rest of the text.
    pub input: Box<dyn Read + Send + 'a>,
    /// Its first bytes, as far as its layout was looked for in them.
    pub head: Vec<u8>,
    pub packing: Packing,
    /// Whether it is UTF-16 and was turned into UTF-8.
    pub is_utf16: bool,
    /// Whether all of it is in the head.
    pub is_all: bool,
    /// Whether it is a Parquet file, which is no text.
    pub is_parquet: bool,
}

impl<'a> Stream<'a> {
    /// Looks at the first bytes of a stream.
    ///
    /// # Errors
    /// What the stream reports.
    pub fn of(mut raw: Box<dyn Read + Send + 'a>) -> io::Result<Self> {
        let head = beginning(&mut raw)?;
        let is_parquet = is_parquet(&head);
        let packing = Packing::of_head(&head);
        let whole: Box<dyn Read + Send + 'a> = Box::new(Cursor::new(head).chain(raw));
        let mut text: Box<dyn Read + Send + 'a> = match packing {
            Packing::Plain => whole,
            Packing::Gzip => Box::new(MultiGzDecoder::new(whole)),
            Packing::Zstandard => {
                let mut decoder = zstd::Decoder::new(whole)?;
                decoder.window_log_max(WINDOW_LOG)?;
                Box::new(decoder)
            }
        };
        let head = beginning(&mut text)?;
        let encoding = utf16(&head);
        let input: Box<dyn Read + Send + 'a> = match encoding {
            None => Box::new(Cursor::new(head).chain(text)),
            Some(encoding) => Box::new(pieces::as_utf8(encoding, Cursor::new(head).chain(text))),
        };
        Ok(Self { input, head: Vec::new(), packing, is_utf16: encoding.is_some(), is_all: false, is_parquet })
    }
}

impl Stream<'_> {
    /// Reads until the columns are known. `is_patient` as for [`Cutter`](crate::exchange::batch::Cutter).
    ///
    /// # Errors
    /// What the stream reports; within that, why nothing in it can be judged.
    pub fn layout(&mut self, is_patient: bool, name: &str) -> io::Result<Result<Layout, ImportErrorKind>> {
        self.mapped(is_patient, name, None)
    }

    /// The same with what the user says of the columns.
    ///
    /// # Errors
    /// As above.
    pub fn mapped(
        &mut self,
        is_patient: bool,
        name: &str,
        mapping: Option<&Mapping>,
    ) -> io::Result<Result<Layout, ImportErrorKind>> {
        loop {
            let wanted = if is_patient { HEAD } else { BLOCK };
            self.is_all = !read(&mut self.input, wanted, is_patient, &mut self.head)?;
            let is_enough = self.is_all || HEAD <= self.head.len();
            match Layout::mapped(&self.head, self.is_all, name, mapping) {
                Ok(layout) if layout.has_rows || is_enough => return Ok(Ok(layout)),
                Err(error) if is_enough => return Ok(Err(error)),
                Ok(_) | Err(_) => {}
            }
        }
    }
}

/// The first five bytes, or fewer where there are no more.
fn beginning(input: &mut dyn Read) -> io::Result<Vec<u8>> {
    let mut head = Vec::new();
    input.take(5).read_to_end(&mut head)?;
    Ok(head)
}
