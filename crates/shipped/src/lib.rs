//! The built-in files, byte for byte: texts, the manual, masks, programs and tables. Only this room knows which files exist.
//!
//! The build makes the lists from the folders, so that a new file needs no line here.

pub mod fonts;

use std::borrow::Cow;
use std::io::Read as _;

include!(concat!(env!("OUT_DIR"), "/shipped.rs"));

/// The files of one folder: name and bytes, ordered by name.
pub type Files = &'static [(&'static str, &'static [u8])];

/// A built-in file of a list by its name; case does not matter.
pub fn file(list: Files, name: &str) -> Option<&'static [u8]> {
    list.iter().find(|(known, _)| known.eq_ignore_ascii_case(name)).map(|(_, bytes)| *bytes)
}

/// A built-in text of a list by its name; empty where there is none, which a test finds.
pub fn text(list: Files, name: &str) -> &'static str {
    file(list, name).and_then(|bytes| std::str::from_utf8(bytes).ok()).unwrap_or_default()
}

/// A language as it is built in.
struct Packed {
    code: &'static str,
    name: &'static str,
    decimal_sign: char,
    /// Whether the texts are as they are read.
    is_plain: bool,
    texts: &'static [u8],
}

/// The languages by their codes, each with its name and its decimal sign.
pub fn languages() -> impl ExactSizeIterator<Item = (&'static str, &'static str, char)> {
    LANGUAGES.iter().map(|Packed { code, name, decimal_sign, .. }| (*code, *name, *decimal_sign))
}

/// The texts of a language in the order of [`NAMES`], with a zero between two of them; an empty one is missing.
pub fn texts(code: &str) -> Option<Cow<'static, str>> {
    let language = LANGUAGES.iter().find(|language| language.code == code)?;
    if language.is_plain {
        return std::str::from_utf8(language.texts).ok().map(Cow::Borrowed);
    }
    let mut texts = String::new();
    flate2::read::ZlibDecoder::new(language.texts).read_to_string(&mut texts).ok()?;
    Some(Cow::Owned(texts))
}
