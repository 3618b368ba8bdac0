//! What every page is: a state that commands and news change, with text fields.

use std::ops::Range;
use std::path::Path;

use fitcheck_core::message::Message;
use jiff::civil::DateTime;

use super::action::Action;
use super::command::Command;
use super::effect::Effect;
use super::saved::Saved;
use super::shared::{News, Shared};

/// A question of a page before something is done. One rule for all of them: the first answer is the highlighted one, and Enter in the field
/// gives that one and no other.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct PageQuestion {
    /// What Enter would do without the question.
    pub about: Action,
    /// The answers, the highlighted one first.
    pub answers: Vec<Action>,
}

/// The state of a page.
pub(super) trait PageState: Sized {
    /// What can be done on the page.
    type Command;
    /// A text field of the page.
    type Field: Copy;

    /// The page as it was left.
    fn restored(saved: &Saved, shared: &Shared) -> Self;

    /// Adds what survives a restart.
    fn save(&self, _saved: &mut Saved) {}

    /// Does a command of the page.
    fn apply(&mut self, command: Self::Command, shared: &mut Shared, now: DateTime) -> Vec<Effect>;

    /// Follows what happened elsewhere.
    fn follow(&mut self, news: &News, shared: &mut Shared);

    /// What has to be done outside because of what happened elsewhere.
    fn take_errands(&mut self) -> Vec<Effect> {
        Vec::new()
    }

    fn text(&self, field: Self::Field) -> &str;

    /// What is wrong with a field.
    fn error(&self, field: Self::Field) -> Option<&Message>;

    /// Where in a field's text its error shows: characters counted from 0.
    fn culprit(&self, _field: Self::Field) -> Option<&Range<usize>> {
        None
    }

    /// What the page asks before it does something; `None` where nothing is asked.
    fn asks(&self) -> Option<PageQuestion> {
        None
    }

    /// What Enter would do only once more, because its result stands on screen already: it does not do that.
    fn repeated(&self) -> Option<Action> {
        None
    }

    /// The command that closes the topmost thing over the page.
    fn closes(&self) -> Option<Command> {
        None
    }

    /// The names of documents with changes that no file holds.
    fn unsaved(&self) -> Vec<String> {
        Vec::new()
    }

    /// The name of a document with such changes that waits for the answer whether another one may take its place.
    fn asks_about(&self) -> Option<String> {
        None
    }

    /// The answer: its changes may be lost, or are kept.
    fn discard(&mut self, _loses: bool, _shared: &mut Shared) {}

    /// A file was written whole, or not at all: of its document. What is to be said of that comes back.
    fn file_written(&mut self, _path: &Path, _is_whole: bool, _shared: &mut Shared) -> Option<Message> {
        None
    }

    /// Whether a field holds a name or words, and no figures.
    fn is_free_text(&self, _field: Self::Field) -> bool {
        false
    }
}
