//! What can be done on the help page.

use super::{HelpField, HelpPlace};
use crate::field::Field;
use crate::step::Step;

/// What can be done on the help page.
#[derive(Debug, Clone)]
pub enum HelpCommand {
    /// Replaces the text of a field.
    Type(HelpField, String),
    /// Opens the manual at what treats the field that has the focus, or else the part of the page that one is in, or else at its page about
    /// the open page; on the help page goes back to where one was.
    ForPage,
    /// The focus has gone to another field, which is treated there; or to none.
    At(Option<(Field, HelpPlace)>),
    /// One is in another part of the page, which is treated there; or in none.
    Within(Option<HelpPlace>),
    /// Shows the paragraph about the field that has the focus beside it, or hides it.
    Explain(bool),
    /// Opens the help page at a place.
    Open(HelpPlace),
    /// Shows what was found, by its number.
    Select(usize),
    /// Goes to another one of what was found.
    Move(Step),
    /// Shows what was read before; where nothing was read since the help was called from a page, goes back there.
    Back,
    /// Scrolls the text.
    Scroll(Step),
    /// Goes to the search field.
    Search,
    /// Shows the topics in the place of the text, where there is no room for both.
    ListTopics,
    /// Shows the text in the place of the topics, where there is no room for both.
    Read,
}
