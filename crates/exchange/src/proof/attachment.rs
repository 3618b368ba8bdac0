//! The checks of a report as data: what a PDF has attached, or a file of JSON itself.
//!
//! A PDF is not read as a whole. Its attachments are streams, each behind a dictionary of its own that says `/Type /EmbeddedFile`; no other
//! object may hold one. So they are found by that word, wherever the table of objects says that they are: whoever moves one does not hide it.
//! What is packed is unpacked within bounds, for a file of some kilobytes may claim to hold gigabytes.

use std::io::Read as _;

use fitcheck_core::message::{Say, printed};
use flate2::read::ZlibDecoder;
use serde::Deserialize;
use serde::de::IgnoredAny;

/// The most that the attachments of a file have together, unpacked; and the largest file of JSON, bytes.
pub const LARGEST: u64 = 64 << 20;

/// What a PDF begins with, within its first bytes.
const PDF: &[u8] = b"%PDF-";
/// So far into a file a PDF may begin.
const HEAD: usize = 1_024;
/// A dictionary of an attachment has so many bytes on either side of its type.
const DICTIONARY: usize = 4_096;
/// So many attachments are looked at.
const MOST: usize = 1_000;

/// Why the data of a file cannot be read.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(prefix = "report-attachment", error)]
pub enum AttachmentError {
    /// Unpacked it has more bytes than are read.
    #[say(args(most = LARGEST))]
    TooLarge,
    /// It is packed in a way that Fitcheck does not write.
    Packed {
        /// The name of the filter in the file.
        filter: String,
    },
    /// What is packed is cut short or changed.
    Damaged {
        /// What the unpacker says.
        reason: String,
    },
    /// Several attachments hold checks: which of them counts is not for a program to choose.
    Several {
        #[say(with = printed)]
        count: usize,
    },
}

/// The data of a report's file: of a PDF what it has attached, of JSON the file itself. `None` where a file has no data with checks.
pub fn json_of(bytes: &[u8]) -> Option<Result<Vec<u8>, AttachmentError>> {
    let is_pdf = memchr::memmem::find(bytes.get(..HEAD).unwrap_or(bytes), PDF).is_some();
    if is_pdf {
        return attached_json(bytes);
    }
    let is_too_large = LARGEST < u64::try_from(bytes.len()).unwrap_or(u64::MAX);
    has_checks(bytes).then(|| if is_too_large { Err(AttachmentError::TooLarge) } else { Ok(bytes.to_vec()) })
}

/// What a PDF has attached that is JSON with checks; `None` where it has nothing of the kind.
pub fn attached_json(bytes: &[u8]) -> Option<Result<Vec<u8>, AttachmentError>> {
    let mut left = LARGEST;
    let mut found: Vec<Vec<u8>> = Vec::new();
    let mut failed = None;
    for stream in streams(bytes).take(MOST) {
        match unpacked(&stream, &mut left) {
            Ok(file) if has_checks(&file) => found.push(file),
            Ok(_another) => {}
            Err(AttachmentError::TooLarge) => return Some(Err(AttachmentError::TooLarge)),
            Err(error) => _ = failed.get_or_insert(error),
        }
    }
    // The same once more, as a program writes it that adds to a file, is no other one.
    found.dedup();
    match (found.pop(), found.len()) {
        (Some(file), 0) => Some(Ok(file)),
        (Some(_one), others) => Some(Err(AttachmentError::Several { count: others.saturating_add(1) })),
        (None, _) => failed.map(Err),
    }
}

/// Whether bytes are JSON with checks; nothing of it is kept.
fn has_checks(bytes: &[u8]) -> bool {
    #[derive(Deserialize)]
    struct File {
        #[serde(rename = "checks")]
        _checks: Vec<IgnoredAny>,
    }
    let starts = bytes.iter().find(|byte| !byte.is_ascii_whitespace()) == Some(&b'{');
    starts && serde_json::from_slice::<File>(bytes).is_ok()
}

/// An attachment as it lies in the file.
struct Stream<'a> {
    /// What its dictionary says.
    dictionary: &'a [u8],
    /// Its bytes and everything behind them: where they end is found when they are read.
    rest: &'a [u8],
}

/// The attachments of a PDF, in the order of the file.
fn streams(bytes: &[u8]) -> impl Iterator<Item = Stream<'_>> {
    const TYPE: &[u8] = b"/EmbeddedFile";
    let places = memchr::memmem::find_iter(bytes, TYPE).map(|at| (at, at.saturating_add(TYPE.len())));
    places.filter_map(|(at, after)| {
        // `/EmbeddedFiles` is the list of them.
        if bytes.get(after).is_some_and(u8::is_ascii_alphanumeric) {
            return None;
        }
        let before = bytes.get(at.saturating_sub(DICTIONARY)..at)?;
        let begins = memchr::memmem::rfind(before, b"obj").map_or(0, |found| found.saturating_add(3));
        let start = at.saturating_sub(before.len().saturating_sub(begins));
        let behind = bytes.get(after..)?;
        let behind = behind.get(..DICTIONARY).unwrap_or(behind);
        // Behind the dictionary, and not within it as in `application/octet-stream`.
        let is_end =
            |at: &usize| behind.get(..*at).is_some_and(|dictionary| dictionary.trim_ascii_end().ends_with(b">>"));
        let word = memchr::memmem::find_iter(behind, b"stream").find(is_end)?;
        // A name tree has no stream; what follows it belongs to another object.
        if memchr::memmem::find(behind.get(..word)?, b"endobj").is_some() {
            return None;
        }
        let end = after.saturating_add(word);
        let rest = bytes.get(end.saturating_add(6)..)?;
        let rest = rest.strip_prefix(b"\r\n").or_else(|| rest.strip_prefix(b"\n"))?;
        Some(Stream { dictionary: bytes.get(start..end)?, rest })
    })
}

/// The name of the way in which an attachment is packed; `None` where it lies there as it is.
fn filter(dictionary: &[u8]) -> Option<String> {
    const FILTER: &[u8] = b"/Filter";
    let at = memchr::memmem::find(dictionary, FILTER)?;
    let value = dictionary.get(at.saturating_add(FILTER.len())..)?;
    let value = value.trim_ascii_start();
    // A list of one is that one; a list of several says so by what stands behind the first.
    let value = value.strip_prefix(b"[").map_or(value, |list| list.trim_ascii_start());
    let end = value.iter().skip(1).position(|byte| b"/<>[] \r\n\t".contains(byte)).map_or(value.len(), |end| end + 1);
    let name = String::from_utf8_lossy(value.get(..end).unwrap_or(value));
    Some(fitcheck_core::message::shortened(name.trim_start_matches('/'), 40))
}

/// The bytes of an attachment, taken from what may still be unpacked.
fn unpacked(stream: &Stream<'_>, left: &mut u64) -> Result<Vec<u8>, AttachmentError> {
    let mut file = Vec::new();
    match filter(stream.dictionary).as_deref() {
        Some("FlateDecode" | "Fl") => {
            let mut packed = ZlibDecoder::new(stream.rest).take(left.saturating_add(1));
            let read = packed.read_to_end(&mut file);
            read.map_err(|error| AttachmentError::Damaged { reason: error.to_string() })?;
        }
        Some(other) => return Err(AttachmentError::Packed { filter: other.to_owned() }),
        None => {
            let end = memchr::memmem::find(stream.rest, b"endstream").unwrap_or(stream.rest.len());
            file.extend_from_slice(stream.rest.get(..end).unwrap_or(stream.rest));
        }
    }
    let bytes = u64::try_from(file.len()).unwrap_or(u64::MAX);
    *left = left.checked_sub(bytes).ok_or(AttachmentError::TooLarge)?;
    Ok(file)
}

#[cfg(test)]
mod tests {
    use std::io::Write as _;

    use flate2::Compression;
    use flate2::write::ZlibEncoder;

    use super::*;

    fn packed(bytes: &[u8]) -> Vec<u8> {
        let mut encoder = ZlibEncoder::new(Vec::new(), Compression::default());
        encoder.write_all(bytes).unwrap();
        encoder.finish().unwrap()
    }

    fn pdf(streams: &[(&str, Vec<u8>)]) -> Vec<u8> {
        let mut file = b"%PDF-1.7\n%\xe2\xe3\n1 0 obj\n<< /Names << /EmbeddedFiles 2 0 R >> >>\nendobj\n".to_vec();
        for (dictionary, bytes) in streams {
            file.extend_from_slice(format!("7 0 obj\n<< {dictionary} /Length {} >>\nstream\n", bytes.len()).as_bytes());
            file.extend_from_slice(bytes);
            file.extend_from_slice(b"\nendstream\nendobj\n");
        }
        file
    }

    const FLATE: &str = "/Type /EmbeddedFile /Subtype /application#2Fjson /Filter /FlateDecode";
    const DATA: &[u8] = br#"{"version":1,"checks":[{"id":"B1"}]}"#;

    #[test]
    fn the_attachment_with_checks_is_found_packed_and_as_it_is() {
        let csv = ("/Filter /FlateDecode /Type/EmbeddedFile /Subtype /application#2Foctet-stream\n", packed(b"a,b\n"));
        let both = pdf(&[csv.clone(), (FLATE, packed(DATA))]);
        assert_eq!(json_of(&both), Some(Ok(DATA.to_vec())));
        let plain = json_of(&pdf(&[("/Type /EmbeddedFile", DATA.to_vec())]));
        assert_eq!(plain.unwrap().unwrap().trim_ascii(), DATA);
        assert_eq!(json_of(&pdf(&[csv])), None);
        assert_eq!(
            json_of(&pdf(&[("/Filter [ /FlateDecode ] /Type /EmbeddedFile", packed(DATA))])),
            Some(Ok(DATA.to_vec()))
        );
        assert_eq!(json_of(DATA), Some(Ok(DATA.to_vec())));
        assert_eq!(json_of(b"<html></html>"), None);
        assert_eq!(json_of(br#"{"checks":1}"#), None);
    }

    #[test]
    fn what_cannot_be_unpacked_is_told() {
        let mut cut = packed(DATA);
        cut.truncate(cut.len() / 2);
        let mut file = pdf(&[(FLATE, cut)]);
        file.truncate(file.len() - "\nendstream\nendobj\n".len());
        assert!(matches!(json_of(&file), Some(Err(AttachmentError::Damaged { .. }))));
        let other = pdf(&[("/Type /EmbeddedFile /Filter /Crypt", DATA.to_vec())]);
        assert_eq!(json_of(&other), Some(Err(AttachmentError::Packed { filter: "Crypt".to_owned() })));
        let second = br#"{"checks":[]}"#.to_vec();
        let two = pdf(&[(FLATE, packed(DATA)), (FLATE, packed(&second))]);
        assert_eq!(json_of(&two), Some(Err(AttachmentError::Several { count: 2 })));
        assert_eq!(json_of(&pdf(&[(FLATE, packed(DATA)), (FLATE, packed(DATA))])), Some(Ok(DATA.to_vec())));
    }

    #[test]
    fn a_file_that_claims_to_hold_gigabytes_is_refused_after_megabytes() {
        let zeros = vec![b' '; 40 << 20];
        let bomb = packed(&zeros);
        assert!(bomb.len() < 100_000);
        let file = pdf(&[(FLATE, bomb.clone()), (FLATE, bomb)]);
        assert_eq!(json_of(&file), Some(Err(AttachmentError::TooLarge)));
    }

    #[test]
    fn whatever_stands_around_the_word_is_read_without_a_panic() {
        for text in [
            "%PDF-/EmbeddedFile",
            "%PDF-obj/EmbeddedFile stream",
            "%PDF-/EmbeddedFile/Filter stream\n",
            "%PDF-/EmbeddedFile stream\r\n",
        ] {
            for end in 0..=text.len() {
                let _found = json_of(text.get(..end).unwrap().as_bytes());
            }
        }
        assert_eq!(json_of(b"%PDF-obj<</Type/EmbeddedFile>>endobj stream\nx"), None);
    }
}
