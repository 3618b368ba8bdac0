//! How commands and news change the help page.

use fitcheck_core::message::Message;
use jiff::civil::DateTime;

use super::search::search;
use super::{CONTENTS, HelpCommand, HelpField, HelpPage, HelpPlace, HelpTopic};
use crate::command::Command;
use crate::effect::Effect;
use crate::page::Page;
use crate::saved::Saved;
use crate::shared::{News, Shared};
use crate::state::PageState;
use crate::step::Step;

/// How many places can be gone back to.
const MOST_BEFORE: usize = 100;

impl PageState for HelpPage {
    type Command = HelpCommand;
    type Field = HelpField;

    fn restored(_saved: &Saved, shared: &Shared) -> Self {
        Self {
            query: String::new(),
            // The manual is read when the page is opened: a start does not wait for it.
            found: Vec::new(),
            shown: HelpPlace::of(HelpTopic::Manual(CONTENTS)),
            before: Vec::new(),
            look: 0,
            scrolled: (0, Step::PageDown),
            lists_topics: false,
            from: shared.page,
            at: None,
            within: None,
            explains: false,
            from_field: None,
            is_called: false,
            is_searching: false,
            is_walking: false,
        }
    }

    fn apply(&mut self, command: HelpCommand, shared: &mut Shared, _now: DateTime) -> Vec<Effect> {
        match command {
            HelpCommand::Type(HelpField::Search, text) => {
                self.found = search(&text);
                self.is_searching = !text.is_empty();
                self.query = text;
                self.lists_topics = true;
            }
            HelpCommand::ForPage if shared.page == Page::Help => return self.leave(shared),
            HelpCommand::ForPage => {
                let page = || HelpPlace::of(HelpTopic::Manual(shared.page.manual()));
                let at = self.at.as_ref().map(|(_, place)| place.clone());
                let place = at.or_else(|| self.within.take());
                self.call(place.unwrap_or_else(page), shared);
            }
            HelpCommand::At(at) => {
                self.explains &= self.at.as_ref().map(|(field, _)| field) == at.as_ref().map(|(field, _)| field);
                self.at = at;
            }
            HelpCommand::Within(place) => self.within = place,
            HelpCommand::Explain(explains) => self.explains = explains && self.at.is_some(),
            HelpCommand::Open(place) if shared.page == Page::Help => self.go_to(place),
            HelpCommand::Open(place) => self.call(place, shared),
            HelpCommand::Select(number) => {
                if let Some(found) = self.found.get(number) {
                    self.go_to(found.place.clone());
                }
            }
            HelpCommand::Move(step) => self.walk(step),
            HelpCommand::Back => {
                if let Some(place) = self.before.pop() {
                    self.show(place);
                } else if self.is_called && shared.page == Page::Help {
                    return self.leave(shared);
                }
            }
            HelpCommand::Scroll(step) => self.scrolled = (self.scrolled.0 + 1, step),
            HelpCommand::Search => {
                self.lists_topics = true;
                return vec![Effect::Focus(HelpField::Search.into())];
            }
            HelpCommand::ListTopics => self.lists_topics = true,
            HelpCommand::Read => self.lists_topics = false,
        }
        Vec::new()
    }

    fn follow(&mut self, news: &News, _shared: &mut Shared) {
        if let News::Opened(page) = news {
            self.explains = false;
            self.is_searching = false;
            if *page == Page::Help {
                self.found = search(&self.query);
            } else {
                self.from = *page;
                self.from_field = None;
                self.is_called = false;
            }
        }
    }

    fn text(&self, _field: HelpField) -> &str {
        &self.query
    }

    fn error(&self, _field: HelpField) -> Option<&Message> {
        None
    }

    fn closes(&self) -> Option<Command> {
        let clear = HelpCommand::Type(HelpField::Search, String::new());
        Some(if self.is_searching { clear } else { HelpCommand::ForPage }.into())
    }

    fn is_free_text(&self, _field: HelpField) -> bool {
        true
    }
}

impl HelpPage {
    /// Opens the help from another page, at a place. What was read before that is not gone back to: the page that called is.
    fn call(&mut self, place: HelpPlace, shared: &mut Shared) {
        self.from_field = self.at.take().map(|(field, _)| field);
        self.before.clear();
        self.show(place);
        self.is_called = true;
        shared.open(Page::Help);
    }

    /// Goes back to the page and the field where one was.
    fn leave(&mut self, shared: &mut Shared) -> Vec<Effect> {
        shared.open(self.from);
        self.from_field.take().map(Effect::Focus).into_iter().collect()
    }

    /// Shows a place; the one before can be gone back to.
    fn go_to(&mut self, place: HelpPlace) {
        if self.shown != place {
            let before = std::mem::replace(&mut self.shown, place.clone());
            self.before.push(before);
            if MOST_BEFORE < self.before.len() {
                self.before.remove(0);
            }
        }
        self.show(place);
    }

    fn show(&mut self, place: HelpPlace) {
        self.shown = place;
        self.look += 1;
        self.lists_topics = false;
        self.is_walking = false;
    }

    /// Goes to another one of what was found. The keys stay in the list, and only what was read before the first step is gone back to.
    fn walk(&mut self, step: Step) {
        let Some(last) = self.found.len().checked_sub(1) else { return };
        let Some(found) = self.found.get(step.place(self.selected(), last)) else { return };
        let place = found.place.clone();
        if self.shown == place {
            return;
        }
        let lists_topics = self.lists_topics;
        if self.is_walking {
            self.show(place);
        } else {
            self.go_to(place);
        }
        self.is_walking = true;
        self.lists_topics = lists_topics;
    }
}
