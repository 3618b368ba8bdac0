//! Elements and attributes. Every text is escaped, and what XML has no place for becomes a replacement character.

use std::io::{self, Write};

use crate::report::told::on_one_line;

/// Writes elements one after the other.
pub(super) struct Elements<'w> {
    out: &'w mut dyn Write,
}

impl<'w> Elements<'w> {
    pub(super) fn new(out: &'w mut dyn Write) -> Self {
        Self { out }
    }

    /// Text that is XML already.
    pub(super) fn raw(&mut self, xml: &str) -> io::Result<()> {
        self.out.write_all(xml.as_bytes())
    }

    /// The beginning of an element with a number.
    pub(super) fn open(&mut self, name: &str, id: usize) -> io::Result<()> {
        self.raw(&format!("<{name} id=\"{id}\">\n"))
    }

    /// The beginning of a list of so many elements.
    pub(super) fn list(&mut self, name: &str, count: usize) -> io::Result<()> {
        self.raw(&format!("<{name} n=\"{count}\">\n"))
    }

    pub(super) fn close(&mut self, name: &str) -> io::Result<()> {
        self.raw(&format!("</{name}>\n"))
    }

    /// An element with a text.
    pub(super) fn text(&mut self, name: &str, text: &str) -> io::Result<()> {
        self.raw(&format!("<{name}>{}</{name}>\n", escaped(text)))
    }

    /// The same where the text may be empty: then there is no element.
    pub(super) fn some(&mut self, name: &str, text: &str) -> io::Result<()> {
        if on_one_line(text).is_empty() { Ok(()) } else { self.text(name, text) }
    }

    /// An element whose text is a number of another thing.
    pub(super) fn id(&mut self, name: &str, id: usize) -> io::Result<()> {
        self.raw(&format!("<{name}>{id}</{name}>\n"))
    }

    /// A list of one number of another thing.
    pub(super) fn only_id(&mut self, name: &str, id: usize) -> io::Result<()> {
        self.raw(&format!("<{name} n=\"1\"><Id>{id}</Id></{name}>\n"))
    }

    /// What the format has no element for, by name; empty texts are left out.
    pub(super) fn attributes(&mut self, all: &[(&str, String)]) -> io::Result<()> {
        let all: Vec<_> = all.iter().filter(|(_, text)| !text.is_empty()).collect();
        if all.is_empty() {
            return Ok(());
        }
        self.list("Attributes", all.len())?;
        for (name, text) in &all {
            self.raw(&format!("<AttributeStr name=\"{}\" value=\"{}\"/>\n", escaped(name), escaped(text)))?;
        }
        self.close("Attributes")
    }
}

/// A text on one line, with the five signs of XML as entities.
pub(super) fn escaped(text: &str) -> String {
    quick_xml::escape::escape(on_one_line(text)).into_owned()
}

#[cfg(test)]
mod tests {
    use super::escaped;

    #[test]
    fn a_text_stays_a_text() {
        assert_eq!(escaped("<a b=\"c\">&'\n\u{0}\u{ffff}"), "&lt;a b=&quot;c&quot;&gt;&amp;&apos; \u{fffd}\u{fffd}");
    }
}
