//! The built-in files, byte for byte: texts, the manual, masks, programs and tables. Only this room knows which files exist.
//!
//! The build makes the lists from the folders, so that a new file needs no line here.

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
