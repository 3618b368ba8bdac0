//! What is shipped, byte for byte: texts, masks, programs and tables. The only room that knows which files there are.
//!
//! The lists are made from the folders when the program is built, so that a new file needs no line here.

include!(concat!(env!("OUT_DIR"), "/shipped.rs"));

/// A shipped file of a list by its name.
pub fn file(list: &'static [(&'static str, &'static [u8])], name: &str) -> Option<&'static [u8]> {
    list.iter().find(|(known, _)| *known == name).map(|(_, bytes)| *bytes)
}
