//! The pages of the manual as they are built in, in the order of its contents.

use std::sync::LazyLock;

use fitcheck_shipped as shipped;

use super::blocks::{Block, plain, read};
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
    /// The heading, and all of the section with it, in small letters.
    pub small_heading: String,
    pub small_text: String,
}

static MANUAL: LazyLock<Vec<ManualPage>> = LazyLock::new(|| {
    let files: Vec<&'static str> = shipped::MANUAL.iter().map(|(file, _)| *file).collect();
    let read = |file: &&'static str| ManualPage::read(file, &files);
    let mut pages: Vec<ManualPage> = files.iter().map(read).collect();
    let contents = pages.iter().find(|page| page.file == CONTENTS);
    let order: Vec<HelpTopic> =
        contents.map_or_else(Vec::new, |contents| contents.links().map(|link| link.topic).collect());
    let place = |page: &ManualPage| order.iter().position(|topic| *topic == HelpTopic::Manual(page.file));
    // A page that the contents leave out stands at the end.
    pages.sort_by_key(|page| (page.file != CONTENTS, place(page).unwrap_or(usize::MAX)));
    pages
});

/// Every page of the manual: its contents, and the pages in their order.
pub fn manual() -> &'static [ManualPage] {
    &MANUAL
}

impl ManualPage {
    fn read(file: &'static str, files: &[&'static str]) -> Self {
        let blocks = read(file, files, shipped::text(shipped::MANUAL, file));
        let title = blocks.iter().find_map(|block| match block {
            Block::Heading { spans, .. } => Some(plain(spans)),
            _ => None,
        });
        Self { file, title: title.unwrap_or_else(|| file.to_owned()), sections: sections(&blocks), blocks }
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

    /// Whether it has a heading of this anchor.
    pub fn has(&self, anchor: &str) -> bool {
        self.sections.iter().any(|section| section.anchor == anchor)
    }
}

fn sections(blocks: &[Block]) -> Vec<Section> {
    let mut sections: Vec<Section> = Vec::new();
    for block in blocks {
        if let Block::Heading { anchor, spans, .. } = block {
            let heading = plain(spans);
            let small_heading = heading.to_lowercase();
            let anchor = anchor.clone();
            sections.push(Section { heading, anchor, small_text: small_heading.clone(), small_heading });
        } else if let Some(section) = sections.last_mut() {
            section.small_text.push('\n');
            section.small_text.push_str(&block.text().to_lowercase());
        }
    }
    sections
}
