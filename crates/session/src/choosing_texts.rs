//! Which file of own texts was chosen, and in whose words the window, reports and records speak.

use std::path::PathBuf;
use std::sync::Arc;

use fitcheck_core::message::{Message, OwnTexts};
use fitcheck_core::words::{Language, Words};

use super::Session;
use super::own_texts::{ChosenTexts, TextsState};
use super::shared::{News, Shared};

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

    /// The same in a language that was chosen for the report: own texts are those of the window's language.
    pub fn report_words_in(&self, language: Option<Language>) -> Words {
        language.filter(|language| *language != self.language).map_or_else(|| self.report_words(), Words::new)
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
