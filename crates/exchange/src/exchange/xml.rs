//! XML piece by piece: elements one after the other, in constant memory, each with its line and column.
//!
//! The `quick-xml` crate finds the markup. What could grow without end is refused: a document type (and with it entities of
//! its own), nesting, long tags and texts. Texts that nobody asks for are passed over, whatever their length.

use std::borrow::Cow;
use std::io::{self, BufRead, BufReader, Read};

use encoding_rs::Encoding;
use encoding_rs_io::{DecodeReaderBytes, DecodeReaderBytesBuilder};
use fitcheck_core::message::{FilePlace, Located};
use quick_xml::events::{BytesStart, Event};
use quick_xml::{Reader, XmlVersion};

use super::error::ImportErrorKind;
use super::given::shorten;
use crate::exchange::cell::single_blanks;
use fitcheck_core::text::Within as _;

/// How many elements may stand within one another.
const DEEPEST: usize = 200;

/// The longest tag, comment or text that is asked for, 1 MiB.
const LONGEST: usize = 1 << 20;

/// The most that is kept of the text of one element.
const LONGEST_TEXT: usize = 64 << 10;

/// How much is read at a time.
const PIECE: usize = 64 << 10;

/// What is wrong, and where.
#[derive(Debug)]
pub(super) struct Fault(pub(super) Box<Located<ImportErrorKind>>);

impl From<Fault> for ImportErrorKind {
    fn from(fault: Fault) -> Self {
        Self::Located(fault.0)
    }
}

/// The beginning of an element.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub(super) struct Start {
    /// Its name without a prefix.
    pub(super) name: String,
    /// Those of its attributes that are asked for, by their names without a prefix.
    attributes: Vec<(&'static str, String)>,
    /// Where it begins: line and column.
    pub(super) at: (usize, usize),
}

impl Start {
    /// The value of an attribute without blanks around it, or an empty text.
    pub(super) fn attribute(&self, name: &str) -> &str {
        self.attributes.iter().find(|(own, _)| *own == name).map_or("", |(_, value)| value.trim())
    }
}

/// The longest value of an attribute that is kept whole, bytes.
const LONGEST_KEPT: usize = 200;

/// An element with what was asked for of its contents.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub(super) struct Element {
    pub(super) start: Start,
    /// Its own text, without blanks around it.
    pub(super) text: String,
    children: Vec<Self>,
    /// Whether there is an element in it that is not asked for.
    has_other: bool,
}

impl Element {
    /// The first child of this name.
    pub(super) fn child(&self, name: &str) -> Option<&Self> {
        self.children.iter().find(|child| child.start.name == name)
    }

    /// What is at the end of a path of children, each the first of its name.
    pub(super) fn at(&self, path: &[&str]) -> Option<&Self> {
        path.iter().try_fold(self, |element, name| element.child(name))
    }

    /// The text there, or an empty one.
    pub(super) fn text_at(&self, path: &[&str]) -> &str {
        self.at(path).map_or("", |element| &element.text)
    }

    pub(super) fn children(&self) -> impl Iterator<Item = &Self> {
        self.children.iter()
    }
}

/// How much of an element is kept: it may have more of what is asked for than that in a file that is not meant well.
const MOST_KEPT: usize = 10_000;

/// A file of XML, read from its beginning to its end.
pub(super) struct Xml<'b> {
    reader: Reader<CountedText<'b>>,
    buffer: Vec<u8>,
    /// The attributes that are kept.
    attributes: &'static [&'static str],
    depth: usize,
    /// Whether the bytes are decoded here: what cannot be becomes the replacement character.
    is_decoded: bool,
    /// Whether the reader of the markup stands before a text: behind the beginning or the end of an element.
    is_before_text: bool,
}

/// What was read.
enum Node {
    Start(Start),
    Text(String),
    End,
    Eof,
}

impl<'b> Xml<'b> {
    /// A file that begins with the bytes `head`.
    ///
    /// # Errors
    /// [`ImportErrorKind::XmlEncoding`] for an encoding that is not known.
    pub(super) fn new(
        body: &'b mut dyn Read,
        head: &[u8],
        attributes: &'static [&'static str],
    ) -> Result<Self, ImportErrorKind> {
        let encoding = encoding(head)?;
        let is_decoded = encoding != encoding_rs::UTF_8;
        let mut decoder = DecodeReaderBytesBuilder::new();
        decoder.utf8_passthru(true).strip_bom(true).bom_override(true).encoding(is_decoded.then_some(encoding));
        let input = CountedText {
            inner: BufReader::with_capacity(PIECE, decoder.build(body)),
            line: 1,
            column: 1,
            left: LONGEST,
        };
        let mut reader = Reader::from_reader(input);
        reader.config_mut().expand_empty_elements = true;
        Ok(Self { reader, buffer: Vec::new(), attributes, depth: 0, is_decoded, is_before_text: false })
    }

    /// The first element of the file.
    pub(super) fn root(&mut self) -> Result<Start, Fault> {
        match self.next(false)? {
            Node::Start(start) => Ok(start),
            Node::Text(_) | Node::End | Node::Eof => {
                Err(self.fault(ImportErrorKind::Xml { reason: "there is no element".to_owned() }))
            }
        }
    }

    /// The next element within the one that has begun, or `None` at its end.
    pub(super) fn child(&mut self) -> Result<Option<Start>, Fault> {
        match self.next(false)? {
            Node::Start(start) => Ok(Some(start)),
            Node::End => Ok(None),
            Node::Text(_) | Node::Eof => Err(self.cut_off()),
        }
    }

    /// Passes over the rest of an element that has begun.
    pub(super) fn skip(&mut self) -> Result<(), Fault> {
        let outside = self.depth.saturating_sub(1);
        while outside < self.depth {
            if matches!(self.next(false)?, Node::Eof) {
                return Err(self.cut_off());
            }
        }
        Ok(())
    }

    /// Reads the rest of an element that has begun: of its contents, whatever is in elements of the names `wanted`.
    pub(super) fn element(&mut self, start: Start, wanted: &[&str]) -> Result<Element, Fault> {
        let mut open: Vec<Element> = Vec::new();
        let mut element = Element { start, ..Element::default() };
        let mut kept = 0;
        loop {
            // Only what has no other element in it so far can have a text that counts.
            match self.next(element.children.is_empty())? {
                Node::Start(start) if wanted.contains(&start.name.as_str()) => {
                    kept += 1;
                    if MOST_KEPT < kept {
                        return Err(self.fault(ImportErrorKind::XmlLong { most: LONGEST >> 10 }));
                    }
                    element.text.clear();
                    open.push(element);
                    element = Element { start, ..Element::default() };
                }
                Node::Start(_) => {
                    element.has_other = true;
                    self.skip()?;
                }
                Node::Text(text) => {
                    element.text.push_str(&text);
                    if LONGEST_TEXT < element.text.len() {
                        return Err(self.fault(ImportErrorKind::XmlLong { most: LONGEST_TEXT >> 10 }));
                    }
                }
                Node::End => {
                    element.text = single_blanks(&element.text);
                    // 25.0<x/>123 is not 25.0123.
                    if element.has_other && !element.text.is_empty() {
                        return Err(fault(element.start.at, ImportErrorKind::XmlMixed { name: element.start.name }));
                    }
                    let Some(mut outer) = open.pop() else { return Ok(element) };
                    outer.children.push(element);
                    element = outer;
                }
                Node::Eof => return Err(self.cut_off()),
            }
        }
    }

    /// The next beginning of an element, wherever it is: with its depth, and how many bytes came before its end. `None` at the end of
    /// the file.
    pub(super) fn begin(&mut self) -> Result<Option<(Start, usize, u64)>, Fault> {
        loop {
            match self.next(false)? {
                Node::Start(start) => return Ok(Some((start, self.depth, self.reader.buffer_position()))),
                Node::Text(_) | Node::End => {}
                Node::Eof => return Ok(None),
            }
        }
    }

    /// Reads the rest of an element that has begun: its text, where that is one piece as a program writes it; `None` where a comment,
    /// another element or whatever else is in it. `may_refer` is whether entities may be.
    pub(super) fn plain_text(&mut self, may_refer: bool) -> Result<Option<String>, Fault> {
        self.is_before_text = false;
        let mut text = String::new();
        let mut runs = 0;
        loop {
            self.reader.get_mut().left = LONGEST;
            let at = self.reader.get_ref().at();
            self.buffer.clear();
            match self.reader.read_event_into(&mut self.buffer) {
                Ok(Event::Text(run)) => {
                    runs += 1;
                    text.push_str(&run.xml10_content());
                }
                Ok(Event::GeneralRef(_)) if may_refer => {}
                Ok(Event::End(_)) => {
                    self.depth = self.depth.saturating_sub(1);
                    self.is_before_text = true;
                    return Ok((may_refer || runs < 2).then_some(text));
                }
                Ok(Event::Eof) => return Err(self.cut_off()),
                Ok(_) => return Ok(None),
                Err(error) => return Err(self.broken(at, &error)),
            }
        }
    }

    /// Reads on; texts alone where `wants_text`, else they are passed over.
    fn next(&mut self, wants_text: bool) -> Result<Node, Fault> {
        loop {
            if self.is_before_text && !wants_text {
                self.pass_over_text()?;
            }
            self.is_before_text = false;
            self.reader.get_mut().left = LONGEST;
            let at = self.reader.get_ref().at();
            self.buffer.clear();
            let node = match self.reader.read_event_into(&mut self.buffer) {
                Ok(Event::Start(tag)) => {
                    self.depth += 1;
                    if DEEPEST < self.depth {
                        return Err(fault(at, ImportErrorKind::XmlDepth { most: DEEPEST }));
                    }
                    self.is_before_text = true;
                    let node = start(&tag, (self.attributes, self.is_decoded), at);
                    Node::Start(node.map_err(|kind| fault(at, kind))?)
                }
                Ok(Event::End(_)) => {
                    self.depth = self.depth.saturating_sub(1);
                    self.is_before_text = true;
                    Node::End
                }
                Ok(Event::Text(text)) if wants_text && self.is_decoded && is_odd(&text) => {
                    return Err(fault(at, ImportErrorKind::XmlBytes));
                }
                Ok(Event::Text(text)) if wants_text => Node::Text(text.xml10_content().into_owned()),
                Ok(Event::CData(text)) if wants_text => Node::Text(text.xml10_content().into_owned()),
                Ok(Event::GeneralRef(reference)) => {
                    let read = match reference.resolve_char_ref() {
                        Ok(Some(c)) => Ok(c),
                        Ok(None) => predefined(&reference),
                        Err(error) => Err(ImportErrorKind::Xml { reason: error.to_string() }),
                    };
                    Node::Text(read.map_err(|kind| fault(at, kind))?.into())
                }
                Ok(Event::DocType(_)) => return Err(fault(at, ImportErrorKind::XmlDoctype)),
                Ok(Event::Eof) if 0 < self.depth => return Err(self.cut_off()),
                Ok(Event::Eof) => Node::Eof,
                Ok(_) => continue,
                Err(error) => return Err(self.broken(at, &error)),
            };
            return Ok(node);
        }
    }

    /// Leaves out a text, up to the next tag: some have megabytes of points.
    fn pass_over_text(&mut self) -> Result<(), Fault> {
        let at = self.reader.get_ref().at();
        let mut stream = self.reader.stream();
        loop {
            stream.get_mut().left = LONGEST;
            let piece = stream.fill_buf().map_err(|error| fault(at, ImportErrorKind::read(&error)))?;
            let end = memchr::memchr(b'<', piece);
            let passed = end.unwrap_or(piece.len());
            let is_end = end.is_some() || piece.is_empty();
            stream.consume(passed);
            if is_end {
                return Ok(());
            }
        }
    }

    /// What the reader of the markup says.
    fn broken(&self, at: (usize, usize), error: &quick_xml::Error) -> Fault {
        let kind = match error {
            quick_xml::Error::Io(_) if self.reader.get_ref().left == 0 => {
                ImportErrorKind::XmlLong { most: LONGEST >> 10 }
            }
            quick_xml::Error::Io(error) => ImportErrorKind::read(error),
            quick_xml::Error::Syntax(_) => ImportErrorKind::XmlCutOff,
            quick_xml::Error::Encoding(_) => ImportErrorKind::XmlBytes,
            error => ImportErrorKind::Xml { reason: shorten(&error.to_string()) },
        };
        fault(at, kind)
    }

    fn cut_off(&self) -> Fault {
        self.fault(ImportErrorKind::XmlCutOff)
    }

    /// What is wrong here, where the file is read.
    fn fault(&self, kind: ImportErrorKind) -> Fault {
        fault(self.reader.get_ref().at(), kind)
    }
}

/// What is wrong at a line and column.
pub(super) fn fault((line, column): (usize, usize), what: ImportErrorKind) -> Fault {
    Fault(Box::new(Located { what, place: FilePlace::in_line(line, column) }))
}

/// One of the five entities that XML has by itself.
fn predefined(name: &str) -> Result<char, ImportErrorKind> {
    match name {
        "lt" => Ok('<'),
        "gt" => Ok('>'),
        "amp" => Ok('&'),
        "quot" => Ok('"'),
        "apos" => Ok('\''),
        _ => Err(ImportErrorKind::XmlEntity { name: shorten(name) }),
    }
}

fn start(
    tag: &BytesStart<'_>,
    (wanted, is_decoded): (&'static [&'static str], bool),
    at: (usize, usize),
) -> Result<Start, ImportErrorKind> {
    let name = shorten(tag.local_name().as_ref());
    let mut attributes: Vec<(&'static str, String)> = Vec::new();
    // Comparing each attribute with each other one would take long for a tag with thousands.
    for attribute in tag.attributes().with_checks(false) {
        let attribute = attribute.map_err(|error| ImportErrorKind::Xml { reason: shorten(&error.to_string()) })?;
        let own = attribute.key.local_name();
        let Some(&own) = wanted.iter().find(|wanted| **wanted == own.as_ref()) else { continue };
        if attributes.iter().any(|(name, _)| *name == own) {
            return Err(ImportErrorKind::Xml { reason: format!("attribute {own} stands twice") });
        }
        let value = attribute.normalized_value(XmlVersion::Implicit1_0).map_err(|error| unknown(&error))?;
        if is_decoded && is_odd(&value) {
            return Err(ImportErrorKind::XmlBytes);
        }
        let value = value.trim();
        // The types of relationships in a workbook are addresses, and their ends tell them apart.
        attributes.push((own, if value.len() <= LONGEST_KEPT { value.to_owned() } else { shorten(value) }));
    }
    Ok(Start { name, attributes, at })
}

fn unknown(error: &quick_xml::Error) -> ImportErrorKind {
    match error {
        quick_xml::Error::Escape(quick_xml::escape::EscapeError::UnrecognizedEntity(_, name)) => {
            ImportErrorKind::XmlEntity { name: shorten(name) }
        }
        error => ImportErrorKind::Xml { reason: shorten(&error.to_string()) },
    }
}

fn is_odd(text: &str) -> bool {
    text.contains(char::REPLACEMENT_CHARACTER)
}

/// The encoding by the first bytes: a byte order mark, the first sign in two bytes, or what the declaration says; else UTF-8.
fn encoding(head: &[u8]) -> Result<&'static Encoding, ImportErrorKind> {
    if let Some((encoding, _)) = Encoding::for_bom(head) {
        return Ok(encoding);
    }
    match head {
        [b'<', 0, ..] => return Ok(encoding_rs::UTF_16LE),
        [0, b'<', ..] => return Ok(encoding_rs::UTF_16BE),
        _ => {}
    }
    let Some(given) = declared(head) else { return Ok(encoding_rs::UTF_8) };
    let known = Encoding::for_label_no_replacement(given.as_bytes());
    let known = known.ok_or(ImportErrorKind::XmlEncoding { given: shorten(&given) })?;
    // The declaration was read byte by byte: it is not UTF-16.
    Ok(if known.is_ascii_compatible() { known } else { encoding_rs::UTF_8 })
}

/// The encoding that the declaration of a file names.
fn declared(head: &[u8]) -> Option<String> {
    let head = String::from_utf8_lossy(head.get(..512).unwrap_or(head));
    let declaration = head.trim_start().strip_prefix("<?xml")?.split_once("?>")?.0;
    let (_, behind) = declaration.split_once("encoding")?;
    let behind = behind.trim_start().strip_prefix('=')?.trim_start();
    let quote = behind.chars().next().filter(|c| matches!(c, '"' | '\''))?;
    Some(behind.get(1..)?.split_once(quote)?.0.to_owned())
}

/// The first part of a file of XML as text, for recognising it.
pub(super) fn text_of(head: &[u8]) -> Cow<'_, str> {
    encoding(head).map_or_else(|_unknown| String::from_utf8_lossy(head), |encoding| encoding.decode(head).0)
}

/// Bytes that count lines and columns as they are used.
struct CountedText<'b> {
    inner: BufReader<DecodeReaderBytes<&'b mut dyn Read, Vec<u8>>>,
    line: usize,
    column: usize,
    /// How much may come before the markup at hand ends.
    left: usize,
}

impl CountedText<'_> {
    const fn at(&self) -> (usize, usize) {
        (self.line, self.column)
    }
}

impl Read for CountedText<'_> {
    fn read(&mut self, into: &mut [u8]) -> io::Result<usize> {
        let mut piece = self.fill_buf()?;
        let read = piece.read(into)?;
        self.consume(read);
        Ok(read)
    }
}

impl BufRead for CountedText<'_> {
    fn fill_buf(&mut self) -> io::Result<&[u8]> {
        if self.left == 0 {
            return Err(io::Error::other("too long"));
        }
        self.inner.fill_buf()
    }

    fn consume(&mut self, amount: usize) {
        let used = self.inner.buffer().within(..amount);
        self.line += memchr::memchr_iter(b'\n', used).count();
        let last = memchr::memrchr(b'\n', used);
        let behind = last.map_or(used, |end| used.within(end + 1..));
        // Characters, not bytes: those that go on with one do not count.
        let characters = behind.iter().filter(|&&byte| byte & 0xc0 != 0x80).count();
        self.column = if last.is_some() { 1 } else { self.column } + characters;
        self.left = self.left.saturating_sub(amount);
        self.inner.consume(amount);
    }
}
