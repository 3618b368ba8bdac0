//! The user's own texts: which file was chosen, whether it was read, and what is to be said of it.

use std::path::PathBuf;
use std::sync::Arc;

use fitcheck_core::message::{Message, OwnTexts, Say, message};
use fitcheck_core::text::grouped;
use fitcheck_core::words::{Language, Words};

use super::Session;
use super::shared::{News, Shared};

/// As many refused texts are listed.
const MOST_LISTED: usize = 20;

/// A file of own texts that was chosen.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ChosenTexts {
    pub path: PathBuf,
    pub state: TextsState,
}

/// How it stands.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum TextsState {
    /// It is being read.
    Awaited,
    /// It could not be read, and why; it may be there the next time.
    Unread(Message),
    Read(Arc<OwnTexts>),
}

impl ChosenTexts {
    /// What is to be said of it: how many texts count, in which language, and which are refused.
    pub fn told(&self, language: Language) -> Vec<Message> {
        let file = self.path.display();
        let own = match &self.state {
            TextsState::Awaited => return vec![message!("settings-page-own-texts-reading").text("file", file)],
            TextsState::Unread(why) => {
                let unread = message!("settings-page-own-texts-unread").text("file", file);
                return vec![unread.message("why", why.clone())];
            }
            TextsState::Read(own) => own,
        };
        let number = |count: usize| u64::try_from(count).map_or_else(|_| count.to_string(), grouped);
        let count = message!("settings-page-own-texts-count").text("file", file).text("count", number(own.count()));
        let mut told = vec![count.text("all", number(OwnTexts::count_of_all()))];
        if own.code() != language.code() {
            let of = Language::from_code(own.code()).map_or(own.code(), Language::name);
            told.push(message!("settings-page-own-texts-elsewhere").text("language", of));
        }
        if 0 < own.refused_count() {
            told.push(message!("settings-page-own-texts-refused").count("count", own.refused_count()));
        }
        let listed = own.refused().iter().take(MOST_LISTED);
        let more = own.refused_count().saturating_sub(listed.len());
        told.extend(listed.map(Say::message));
        if 0 < more {
            told.push(message!("settings-page-own-texts-more").text("count", number(more)));
        }
        told
    }
}

impl Shared {
    /// The user's own texts of the language of the window.
    pub fn texts_of_window(&self) -> Option<&Arc<OwnTexts>> {
        match &self.own_texts.as_ref()?.state {
            TextsState::Read(own) if own.code() == self.language.code() => Some(own),
            _ => None,
        }
    }

    /// The texts of reports: their numbers follow the language and no setting of the window.
    pub fn report_words(&self) -> Words {
        Words::new(self.language).with_own(self.texts_of_window().map(Arc::clone))
    }

    /// The texts of what is written into the journal and other files that are read back: nobody's own.
    pub fn recorded_words(&self) -> Words {
        Words::new(self.language)
    }

    /// Chooses a file of own texts, or none. The answer of one that was still being read comes too late.
    fn choose_texts(&mut self, chosen: Option<ChosenTexts>) {
        let other = |old: &ChosenTexts| chosen.as_ref().is_none_or(|new| new.path != old.path);
        let old = self.own_texts.take().filter(|old| old.state == TextsState::Awaited && other(old));
        self.given_up_texts = old.map(|old| old.path).or_else(|| self.given_up_texts.take());
        self.own_texts = chosen;
        self.spread(News::StatusWindow);
    }
}

impl Session {
    /// The user's own texts of the language of the window: what it says in place of the built-in ones.
    pub fn texts_of_window(&self) -> Option<&Arc<OwnTexts>> {
        self.shared.texts_of_window()
    }

    /// The file of own texts that was chosen.
    pub const fn own_texts(&self) -> Option<&ChosenTexts> {
        self.shared.own_texts.as_ref()
    }

    /// Stops using own texts.
    pub(super) fn leave_texts(&mut self) {
        self.shared.choose_texts(None);
    }

    /// A file of own texts was read, or not.
    pub(super) fn texts_read(&mut self, path: PathBuf, result: Result<Arc<OwnTexts>, Message>) {
        let shared = &mut self.shared;
        if shared.answered.is_none() && shared.given_up_texts.take_if(|given_up| *given_up == path).is_some() {
            return;
        }
        let problem = result.as_ref().err().cloned();
        if let Some(own) = shared.file_answered(result) {
            let chosen = ChosenTexts { path, state: TextsState::Read(own) };
            let mut told = chosen.told(shared.language).into_iter();
            shared.choose_texts(Some(chosen));
            if let Some(message) = told.next() {
                shared.note_details(message, told.collect());
            }
        } else if let Some(chosen) = shared.own_texts.as_mut().filter(|chosen| chosen.path == path)
            && let Some(problem) = problem
        {
            // What was read before it changed says the same as before.
            if chosen.state == TextsState::Awaited {
                chosen.state = TextsState::Unread(problem);
            }
        }
    }
}
