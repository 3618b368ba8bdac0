//! What is shipped, byte for byte: texts, masks, programs and tables. The only room that knows which files there are.
//!
//! The lists are made from the folders when the program is built, so that a new file needs no line here.

include!(concat!(env!("OUT_DIR"), "/shipped.rs"));

/// Files of one folder: name and bytes, by name.
pub type Files = &'static [(&'static str, &'static [u8])];

/// A shipped file of a list by its name, which may be in other capitals.
pub fn file(list: Files, name: &str) -> Option<&'static [u8]> {
    list.iter().find(|(known, _)| known.eq_ignore_ascii_case(name)).map(|(_, bytes)| *bytes)
}

/// A shipped text of a list by its name; empty where there is none, which a test finds.
pub fn text(list: Files, name: &str) -> &'static str {
    file(list, name).and_then(|bytes| std::str::from_utf8(bytes).ok()).unwrap_or_default()
}
