//! The help page: the manual, which is part of the program, and a sheet of all keys.
//!
//! | file | what |
//! |---|---|
//! | here | the state |
//! | `manual`, `blocks` | the pages of the manual; how one is read |
//! | `query`, `search` | the words of a query; the places that it finds, the best first |
//! | `sheet` | the keys of all actions |
//! | `samples` | built-in files to try the program with |
//! | `field`, `command`, `apply`, `actions` | the search field; what can be done, how, and by which keys |
//!
//! Which page of the manual is about which page of the window is said in `page.rs`.

mod actions;
mod apply;
mod blocks;
mod command;
mod field;
mod manual;
mod query;
mod samples;
mod search;
mod sheet;

use fitcheck_core::words::Words;

pub use actions::{HelpAction, TOPICS};
pub use blocks::{Block, Marker, Span};
pub use command::HelpCommand;
pub use field::HelpField;
pub use manual::{CONTENTS, ManualPage, manual};
pub use query::HelpWords;
pub use samples::Sample;
pub use search::{HelpFound, LinePart};
pub(crate) use search::{TERMS, is_in_a_line};
pub use sheet::{KeyGroup, KeyRow, key_groups};

use super::field::Field;
use super::page::Page;
use super::step::Step;

/// Something that can be read.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum HelpTopic {
    /// The sheet of all keys.
    Keys,
    /// A page of the manual, by its file.
    Manual(&'static str),
}

impl HelpTopic {
    /// Its title: that of the sheet in the words of a language, that of a page as the manual has it.
    pub fn title(self, words: &Words) -> String {
        match self {
            Self::Keys => words.get("help-page-keys"),
            Self::Manual(file) => ManualPage::of(file).map_or_else(|| file.to_owned(), |page| page.title.clone()),
        }
    }
}

/// Everything that can be read: the contents of the manual, the keys, the pages in their order.
pub fn topics() -> impl Iterator<Item = HelpTopic> {
    let mut pages = manual().iter().map(|page| HelpTopic::Manual(page.file));
    pages.next().into_iter().chain([HelpTopic::Keys]).chain(pages)
}

/// A topic, from one of its headings on.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct HelpPlace {
    pub topic: HelpTopic,
    /// The anchor of the heading; `None` for the beginning.
    pub anchor: Option<String>,
    /// What is marked there.
    pub mark: Option<HelpMark>,
}

/// A line of a page of the manual that a search has found.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct HelpMark {
    /// The number of its block in the page, from 0.
    pub block: usize,
    /// Its row of a table or its line of code, from 0.
    pub row: Option<usize>,
    /// What was searched for.
    pub words: HelpWords,
}

impl HelpPlace {
    /// The beginning of a topic.
    pub const fn of(topic: HelpTopic) -> Self {
        Self { topic, anchor: None, mark: None }
    }

    /// A heading of a page of the manual.
    pub fn at(file: &'static str, anchor: &str) -> Self {
        Self { topic: HelpTopic::Manual(file), anchor: Some(anchor.to_owned()), mark: None }
    }
}

/// The state of the help page.
#[expect(clippy::struct_excessive_bools, reason = "each answers another question about the page")]
#[derive(Debug)]
pub struct HelpPage {
    /// What is searched for.
    query: String,
    /// What the query finds; every topic where nothing is searched for.
    pub found: Vec<HelpFound>,
    /// What is read.
    pub shown: HelpPlace,
    /// What was read before, the last one at the end.
    pub before: Vec<HelpPlace>,
    /// Goes up whenever the shown place has to come into sight.
    pub look: u64,
    /// How often the text was scrolled by keys, and where the last time.
    pub scrolled: (u64, Step),
    /// Whether the topics stand in the place of the text, where there is no room for both.
    pub lists_topics: bool,
    /// The page from which the help was opened.
    pub from: Page,
    /// The field that has the focus, and where it is treated.
    pub at: Option<(Field, HelpPlace)>,
    /// Where the part of the page is treated that one is in.
    pub within: Option<HelpPlace>,
    /// Whether the paragraph is shown beside the field.
    pub explains: bool,
    /// The field from which the help was opened.
    from_field: Option<Field>,
    /// Whether it was called from a page, to which one goes back behind what was read since.
    is_called: bool,
    /// Whether something was searched for since the help is open.
    is_searching: bool,
    /// Whether the keys go through the topics: those in between are not come back to.
    is_walking: bool,
}

impl HelpPage {
    /// Whether there is something to go back to: what was read before, or the page that called.
    pub const fn goes_back(&self) -> bool {
        self.is_called || !self.before.is_empty()
    }

    /// The place of what is shown among what was found.
    pub fn selected(&self) -> Option<usize> {
        let topic = self.shown.topic;
        let is_searched = !self.query.trim().is_empty();
        self.found.iter().position(
            |found| {
                if is_searched { found.place == self.shown } else { found.place.topic == topic }
            },
        )
    }
}
