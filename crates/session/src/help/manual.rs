//! The pages of the manual as they are built in, in the order of its contents.

use std::sync::LazyLock;

use fitcheck_core::words::Language;
use fitcheck_shipped as shipped;

use super::blocks::{Block, Span, plain, read};
use super::{HelpPlace, HelpTopic};

/// The page that lists the others.
pub const CONTENTS: &str = "README.md";

/// A page of the manual.
#[derive(Debug)]
pub struct ManualPage {
    /// Its name in the folder of the manual.
    pub file: &'static str,
    pub title: String,
    pub blocks: Vec<Block>,
    pub(super) sections: Vec<Section>,
}

/// A heading with what stands below it, for the search.
#[derive(Debug)]
pub(super) struct Section {
    pub heading: String,
    pub anchor: String,
    pub lines: Vec<Line>,
}

/// A paragraph, an entry of a list, a row of a table or a line of code.
#[derive(Debug)]
pub(super) struct Line {
    /// The number of its block in the page, and its number within that, from 0: of a row below the head of a table, or of a line.
    pub block: usize,
    pub row: Option<usize>,
    pub text: String,
    /// What it explains: it begins with that in bold letters, or that is the first cell of its row.
    pub term: Option<String>,
    /// Whether it is a row that leads to another page.
    pub is_contents: bool,
}

static MANUAL: LazyLock<Vec<ManualPage>> = LazyLock::new(|| {
    let files: Vec<&'static str> = shipped::MANUAL.iter().map(|(file, _)| *file).collect();
    let read = |file: &&'static str| ManualPage::read(file, &files, shipped::text(shipped::MANUAL, file));
    let mut pages: Vec<ManualPage> = files.iter().map(read).collect();
    let contents = pages.iter().find(|page| page.file == CONTENTS);
    let order: Vec<HelpTopic> =
        contents.map_or_else(Vec::new, |contents| contents.links().map(|link| link.topic).collect());
    let place = |page: &ManualPage| order.iter().position(|topic| *topic == HelpTopic::Manual(page.file));
    // A page that the contents leave out stands at the end.
    pages.sort_by_key(|page| (page.file != CONTENTS, place(page).unwrap_or(usize::MAX)));
    pages
});

/// Pages in other languages, block by block as in English, so that what is found there is found here.
static TRANSLATED: LazyLock<Vec<(&'static str, ManualPage)>> = LazyLock::new(|| {
    let files: Vec<&'static str> = shipped::MANUAL.iter().map(|(file, _)| *file).collect();
    let page = |(path, _): &(&'static str, &[u8])| {
        let (code, file) = path.split_once('/')?;
        Some((code, ManualPage::read(file, &files, shipped::text(shipped::TRANSLATED, path))))
    };
    shipped::TRANSLATED.iter().filter_map(page).collect()
});

/// Every page of the manual: its contents, and the pages in their order.
pub fn manual() -> &'static [ManualPage] {
    &MANUAL
}

impl ManualPage {
    fn read(file: &'static str, files: &[&'static str], text: &'static str) -> Self {
        let blocks = read(file, files, text);
        let title = blocks.iter().find_map(|block| match block {
            Block::Heading { spans, .. } => Some(plain(spans)),
            _ => None,
        });
        Self { file, title: title.unwrap_or_else(|| file.to_owned()), sections: sections(&blocks), blocks }
    }

    /// The page of a file in a language; in English where it has not been translated.
    pub fn told(file: &str, language: Language) -> Option<&'static Self> {
        let is_it = |(code, page): &&(&str, Self)| *code == language.code() && page.file == file;
        TRANSLATED.iter().find(is_it).map(|(_, page)| page).or_else(|| Self::of(file))
    }

    /// The pages that have been translated, each with the code of its language.
    pub fn translated() -> impl Iterator<Item = (&'static str, &'static Self)> {
        TRANSLATED.iter().map(|(code, page)| (*code, page))
    }

    /// The page of a file.
    pub fn of(file: &str) -> Option<&'static Self> {
        MANUAL.iter().find(|page| page.file == file)
    }

    /// What stands below a heading, up to the next one.
    pub fn below(&self, anchor: &str) -> &[Block] {
        let is_it = |block: &Block| matches!(block, Block::Heading { anchor: known, .. } if known == anchor);
        let after = self.blocks.iter().position(is_it).map_or(self.blocks.len(), |place| place + 1);
        let rest = self.blocks.get(after..).unwrap_or(&[]);
        let end = rest.iter().position(|block| matches!(block, Block::Heading { .. })).unwrap_or(rest.len());
        rest.get(..end).unwrap_or(&[])
    }

    /// Where its links lead.
    pub fn links(&self) -> impl Iterator<Item = &HelpPlace> {
        self.blocks.iter().flat_map(Block::spans).filter_map(|span| span.link.as_ref())
    }

    /// Its headings below the title, each with its anchor.
    pub fn headings(&self) -> impl Iterator<Item = (&str, &str)> {
        self.sections.iter().skip(1).map(|section| (section.heading.as_str(), section.anchor.as_str()))
    }

    /// Whether it has a heading of this anchor.
    pub fn has(&self, anchor: &str) -> bool {
        self.sections.iter().any(|section| section.anchor == anchor)
    }
}

fn sections(blocks: &[Block]) -> Vec<Section> {
    let mut sections: Vec<Section> = Vec::new();
    for (block, content) in blocks.iter().enumerate() {
        if let Block::Heading { anchor, spans, .. } = content {
            sections.push(Section { heading: plain(spans), anchor: anchor.clone(), lines: Vec::new() });
        } else if let Some(section) = sections.last_mut() {
            section.lines.extend(lines(block, content));
        }
    }
    sections
}

/// The lines of a block.
fn lines(block: usize, content: &Block) -> Vec<Line> {
    let line = |row, text, term| Line { block, row, text, term, is_contents: false };
    match content {
        Block::Heading { .. } => Vec::new(),
        Block::Paragraph(spans) | Block::Item { spans, .. } => {
            let term = spans.first().filter(|span| span.is_bold).map(|span| span.text.clone());
            vec![line(None, plain(spans), term)]
        }
        Block::Table { rows, .. } => {
            let row = |(number, cells): (usize, &Vec<Vec<Span>>)| {
                let texts: Vec<String> = cells.iter().map(|cell| plain(cell)).collect();
                let is_contents = cells.iter().flatten().any(|span| span.link.is_some());
                Line { is_contents, ..line(Some(number), texts.join(" · "), texts.first().cloned()) }
            };
            rows.iter().enumerate().map(row).collect()
        }
        Block::Code(text) => text
            .lines()
            .enumerate()
            .filter(|(_, text)| !text.trim().is_empty())
            .map(|(number, text)| line(Some(number), text.trim().to_owned(), None))
            .collect(),
    }
}
