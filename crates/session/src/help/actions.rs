//! What can be done on the help page.

use super::{HelpCommand, HelpField};
use crate::action::row::{ActionRow, Actions, actions, keys, on, within};
use crate::action::{Held, Key, Part, Shortcut};
use crate::field::Field;
use crate::page::Page;
use crate::step::Step;

/// The list of topics.
pub const TOPICS: Part = Part::list(Page::Help, "help-topics");

actions! {
    /// What can be done on the help page.
    HelpAction

    /// Goes to the search field.
    SearchHelp;
    /// Opens the best of what was found.
    OpenFound;
    /// Shows what was read before.
    BackInHelp;
    /// Goes to another topic.
    MoveTopic(Step): [Step::Up, Step::Down, Step::First, Step::Last];
    /// Shows the text of the topic at which the keys are, where there is no room for both.
    ReadTopic;
    /// Scrolls the text.
    ScrollHelp(Step): [Step::PageUp, Step::PageDown];
    /// Shows the topics in the place of the text, where there is no room for both.
    ListTopics;
}

impl Actions for HelpAction {
    fn row(&self) -> ActionRow {
        match *self {
            Self::SearchHelp => on(Page::Help, "help-page-search", HelpCommand::Search).key(Shortcut::ctrl('F')),
            Self::OpenFound => on(Page::Help, "help-page-open-found", HelpCommand::Select(0))
                .when(|session| !session.help().found.is_empty()),
            Self::BackInHelp => on(Page::Help, "help-page-back", HelpCommand::Back)
                .key(Shortcut { held: Held::Alt, key: Key::Left })
                .when(|session| session.help().goes_back()),
            Self::MoveTopic(step) => within(TOPICS, "help-page-move", HelpCommand::Move(step))
                .when(|session| !session.help().found.is_empty())
                .key(keys(step)),
            Self::ReadTopic => within(TOPICS, "help-page-read", HelpCommand::Read).key(Shortcut::plain(Key::Enter)),
            Self::ScrollHelp(step) => on(Page::Help, "help-page-scroll", HelpCommand::Scroll(step)).key(keys(step)),
            Self::ListTopics => on(Page::Help, "help-page-topics", HelpCommand::ListTopics),
        }
    }

    fn on_enter(field: Field, _page: Page) -> Option<Self> {
        (field == HelpField::Search.into()).then_some(Self::OpenFound)
    }
}
