//! How a page of the manual is read: Markdown to the few kinds of blocks that the window draws.
//!
//! Pictures are left out with the tables that hold them: they are not part of the program. So are links to files beside the manual; their
//! text stays.

use pulldown_cmark::{Event, HeadingLevel, Options, Parser, Tag, TagEnd};

use super::{HelpPlace, HelpTopic};

/// A part of a page.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Block {
    Heading {
        /// 1 for the title of the page.
        level: usize,
        /// What links call it.
        anchor: String,
        spans: Vec<Span>,
    },
    Paragraph(Vec<Span>),
    /// An entry of a list.
    Item {
        /// 1 for a list that is in no other one.
        depth: usize,
        marker: Marker,
        spans: Vec<Span>,
    },
    Table {
        head: Vec<Vec<Span>>,
        rows: Vec<Vec<Vec<Span>>>,
    },
    Code(String),
}

impl Block {
    /// Every text in it, in reading order.
    pub fn spans(&self) -> Vec<&Span> {
        match self {
            Self::Heading { spans, .. } | Self::Paragraph(spans) | Self::Item { spans, .. } => spans.iter().collect(),
            Self::Table { head, rows } => head.iter().chain(rows.iter().flatten()).flatten().collect(),
            Self::Code(_) => Vec::new(),
        }
    }
}

/// What stands before an entry of a list.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Marker {
    Bullet,
    Number(u64),
    /// Another paragraph of the entry.
    Nothing,
}

/// A text of one look.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Span {
    pub text: String,
    pub is_bold: bool,
    pub is_italic: bool,
    pub is_code: bool,
    /// Where a click on it leads.
    pub link: Option<HelpPlace>,
}

/// The text of several spans.
pub(super) fn plain(spans: &[Span]) -> String {
    spans.iter().map(|span| span.text.as_str()).collect()
}

/// The blocks of a page.
pub(super) fn read(file: &'static str, files: &[&'static str], text: &str) -> Vec<Block> {
    let mut reader = Reader { file, files: files.to_vec(), ..Reader::default() };
    for event in Parser::new_ext(text, Options::ENABLE_TABLES) {
        reader.take(event);
    }
    reader.blocks
}

#[derive(Debug, Default)]
struct Reader {
    /// The file that is read, and all of the manual.
    file: &'static str,
    files: Vec<&'static str>,
    blocks: Vec<Block>,
    /// The texts of the block that is being read.
    spans: Vec<Span>,
    /// How the next text looks.
    look: Span,
    /// The lists around it: the number of the next entry where they are numbered.
    lists: Vec<Option<u64>>,
    marker: Option<Marker>,
    cells: Vec<Vec<Span>>,
    head: Vec<Vec<Span>>,
    rows: Vec<Vec<Vec<Span>>>,
    code: Option<String>,
    is_in_picture: bool,
    /// Whether the table has pictures: its other cells are what stands above them.
    has_pictures: bool,
}

impl Reader {
    fn take(&mut self, event: Event<'_>) {
        match event {
            Event::Start(tag) => self.begin(tag),
            Event::End(tag) => self.end(tag),
            Event::Text(text) => match &mut self.code {
                Some(code) => code.push_str(&text),
                None => self.add(&text, false),
            },
            Event::Code(text) => self.add(&text, true),
            Event::SoftBreak | Event::HardBreak => self.add(" ", false),
            _ => {}
        }
    }

    fn add(&mut self, text: &str, is_code: bool) {
        if !self.is_in_picture {
            self.spans.push(Span { text: text.to_owned(), is_code, ..self.look.clone() });
        }
    }

    fn begin(&mut self, tag: Tag<'_>) {
        match tag {
            Tag::Heading { .. } | Tag::TableCell => self.spans.clear(),
            Tag::List(first) => {
                // An entry ends its own text before the list in it.
                self.end_text();
                self.lists.push(first);
            }
            Tag::Item => {
                self.marker = Some(match self.lists.last_mut() {
                    Some(Some(number)) => {
                        *number += 1;
                        Marker::Number(*number - 1)
                    }
                    _ => Marker::Bullet,
                });
            }
            Tag::CodeBlock(_) => self.code = Some(String::new()),
            Tag::Strong => self.look.is_bold = true,
            Tag::Emphasis => self.look.is_italic = true,
            Tag::Link { dest_url, .. } => self.look.link = self.place(&dest_url),
            Tag::Table(_) => self.has_pictures = false,
            Tag::Image { .. } => {
                self.is_in_picture = true;
                self.has_pictures = true;
            }
            _ => {}
        }
    }

    fn end(&mut self, tag: TagEnd) {
        match tag {
            TagEnd::Heading(level) => {
                let spans = std::mem::take(&mut self.spans);
                let anchor = anchor(&plain(&spans));
                self.blocks.push(Block::Heading { level: number(level), anchor, spans });
            }
            TagEnd::Paragraph | TagEnd::Item => self.end_text(),
            TagEnd::List(_) => _ = self.lists.pop(),
            TagEnd::TableCell => self.cells.push(std::mem::take(&mut self.spans)),
            TagEnd::TableHead => self.head = std::mem::take(&mut self.cells),
            TagEnd::TableRow => self.rows.push(std::mem::take(&mut self.cells)),
            TagEnd::Table => {
                let head = std::mem::take(&mut self.head);
                let rows = std::mem::take(&mut self.rows);
                if !std::mem::take(&mut self.has_pictures) {
                    self.blocks.push(Block::Table { head, rows });
                }
            }
            TagEnd::CodeBlock => {
                let code = self.code.take();
                self.blocks.extend(code.map(|code| Block::Code(code.trim_end().to_owned())));
            }
            TagEnd::Strong => self.look.is_bold = false,
            TagEnd::Emphasis => self.look.is_italic = false,
            TagEnd::Link => self.look.link = None,
            TagEnd::Image => self.is_in_picture = false,
            _ => {}
        }
    }

    /// A paragraph or an entry of a list ends. Nothing is left of one that is only a picture.
    fn end_text(&mut self) {
        let spans = std::mem::take(&mut self.spans);
        if spans.iter().all(|span| span.text.trim().is_empty()) {
            return;
        }
        let depth = self.lists.len();
        self.blocks.push(if depth == 0 {
            Block::Paragraph(spans)
        } else {
            Block::Item { depth, marker: self.marker.take().unwrap_or(Marker::Nothing), spans }
        });
    }

    /// The place of the manual that a link leads to.
    fn place(&self, to: &str) -> Option<HelpPlace> {
        let (file, anchor) = to.split_once('#').map_or((to, None), |(file, anchor)| (file, Some(anchor.to_owned())));
        let file = if file.is_empty() { self.file } else { self.files.iter().find(|known| **known == file)? };
        Some(HelpPlace { topic: HelpTopic::Manual(file), anchor, mark: None })
    }
}

const fn number(level: HeadingLevel) -> usize {
    match level {
        HeadingLevel::H1 => 1,
        HeadingLevel::H2 => 2,
        HeadingLevel::H3 => 3,
        HeadingLevel::H4 => 4,
        HeadingLevel::H5 => 5,
        HeadingLevel::H6 => 6,
    }
}

/// What links call a heading, as the places that show Markdown do: small letters and digits, with dashes for spaces.
fn anchor(heading: &str) -> String {
    let kept = heading.chars().filter(|c| c.is_alphanumeric() || matches!(c, ' ' | '-' | '_'));
    kept.flat_map(char::to_lowercase).map(|c| if c == ' ' { '-' } else { c }).collect()
}
