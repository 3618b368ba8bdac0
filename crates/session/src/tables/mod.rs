//! The table page: which tables are open, the shown one's selected cell, its filter, edits and comparison.
//!
//! | file | what |
//! |---|---|
//! | here | the state |
//! | `field` | the text fields |
//! | `command`, `apply` | what can be done, and doing it |
//! | `document` | an open table: its edits, and its comparison with ISO 286 |
//! | `filter` | which columns and rows a filter's text means |
//! | `editing` | from the fields to cells and columns |
//! | `walking` | moving from cell to cell |
//! | `opening` | which tables are open, and the shown one |
//! | `keeping` | saving, and using a table for limits |
//!
//! A table stays open, with its edits, until the window is closed: looking at another one loses nothing.

mod actions;
mod apply;
mod command;
mod document;
mod editing;
mod field;
mod filter;
mod keeping;
mod opening;
mod walking;

use std::collections::BTreeMap;

use fitcheck_core::message::Message;
use fitcheck_core::tolerance::Sources;

pub use actions::{CELLS, TablesAction};
pub use command::{TableChoice, TablesCommand};
pub use document::{Document, Origin};
pub use field::TablesField;
pub use filter::Filter;

use super::texts::Texts;

/// The state of the table page.
#[derive(Debug, Default)]
pub struct TablesPage {
    texts: Texts<TablesField>,
    /// The open tables, the two built-in ones first.
    pub documents: Vec<Document>,
    shown: usize,
    /// Whether only what differs from ISO 286 is asked for.
    only_differences: bool,
    /// What the filter makes of the shown table.
    pub filter: Filter,
    errors: BTreeMap<TablesField, Message>,
}

/// How many tables are open at most; beyond that the oldest without unsaved edits is closed.
const MOST_DOCUMENTS: usize = 32;

impl TablesPage {
    /// The shown table; `None` before the page was opened for the first time.
    pub fn shown(&self) -> Option<&Document> {
        self.documents.get(self.shown)
    }

    /// The shown table's number.
    pub const fn number(&self) -> usize {
        self.shown
    }

    /// Whether only what differs from ISO 286 is shown: never where nothing does.
    pub fn shows_only_differences(&self) -> bool {
        self.only_differences && self.shown().is_some_and(|document| 0 < document.differing())
    }

    /// What a filter's text makes of the shown table.
    fn filtered(&self, text: &str) -> Option<Filter> {
        let document = self.shown()?;
        let filter = Filter::of(text, document.table());
        Some(if self.shows_only_differences() { filter.differing(document) } else { filter })
    }

    /// Whether limits are looked up in the shown table first, as it stands.
    pub fn is_used(&self, sources: &Sources) -> bool {
        let (Some(document), Some(own)) = (self.shown(), sources.own().first()) else { return false };
        own.name() == document.title && document.holds_what(own)
    }

    fn shown_mut(&mut self) -> Option<&mut Document> {
        self.documents.get_mut(self.shown)
    }

    /// The open table with a title. Built-in ones do not count: a user's own may have the same title.
    pub(super) fn by_title(&self, title: &str) -> Option<usize> {
        self.documents.iter().position(|document| document.is_titled(title))
    }

    /// A title that no open table has: `own.tab`, `own_2.tab`.
    fn free_title(&self, wanted: &str) -> String {
        let (stem, ending) = wanted.rsplit_once('.').unwrap_or((wanted, "tab"));
        let mut title = format!("{stem}.{ending}");
        for number in 2_u32.. {
            if self.by_title(&title).is_none() {
                break;
            }
            title = format!("{stem}_{number}.{ending}");
        }
        title
    }

    /// Adds a table and returns its number, closing an old one without unsaved edits where there is no room.
    fn add(&mut self, document: Document) -> Option<usize> {
        if MOST_DOCUMENTS <= self.documents.len() {
            let old = self.documents.iter().position(|old| old.origin != Origin::Shipped && !old.is_unsaved())?;
            self.documents.remove(old);
        }
        self.documents.push(document);
        Some(self.documents.len() - 1)
    }
}
