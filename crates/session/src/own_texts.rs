//! A file of the user's own texts: whether it was read, and what is to be said of it.

use std::path::PathBuf;
use std::sync::Arc;

use fitcheck_core::message::{Message, OwnTexts, Say, message};
use fitcheck_core::text::grouped;
use fitcheck_core::words::Language;

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
