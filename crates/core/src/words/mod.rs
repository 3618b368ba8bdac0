//! Texts in the user's language: [`Message`]s in words, and numbers as people of this language read them.
//!
//! The window and the report use [`Words`]; files for machines never do.
//!
//! | file | what |
//! |---|---|
//! | `language` | the languages of the window and of reports: the folders of `assets/locales` |
//! | `dialogue` | the dialogue languages of the control: masks, logs, programs, cycles |
//! | `named` | enums whose variants all have a word |
//!
//! To add a language of the window:
//!
//! 1. Add a folder to `assets/locales` with every file of `en`. `language.ftl` has the name of the language and its decimal sign.
//! 2. Add the language to `assets/materials.toml` (names of materials) and `packaging/linux/fitcheck.desktop`. Letters beyond Latin and Greek
//!    need other fonts (`assets/fonts`).
//! 3. Add a call such as `fitcheck report … --language fr` to the corpus and record the answers (`tests/core/corpus.rs`).
//! 4. Say so in `docs/manual/window.md`, `docs/TERMS.md` and `CHANGELOG.md`.
//!
//! Tests name every missing text and call.
//!
//! To add a dialogue language of the control:
//!
//! 1. Add a value to [`Dialogue`], with its line in `ALL` and its code.
//! 2. Add its files to `assets/dialogues`, `assets/logs`, `assets/masks` and `assets/nc`. Tests name every missing file.
//! 3. Add the names and questions to the declarations of the cycles that have this language (`probing/cycles`).

mod dialogue;
mod language;
mod named;

pub use dialogue::{Dialogue, DialogueWords, PerDialogue, StatusWords};
pub use language::Language;

use std::sync::Arc;

use crate::length::{Length, Unit};
use crate::message::{Bundle, Message, OwnTexts, Say};

/// The texts of one language.
#[derive(Debug)]
pub struct Words {
    language: Language,
    decimal_sign: char,
    bundle: Bundle,
}

impl Words {
    /// Loads the embedded texts of a language; nothing is read from disk.
    pub fn new(language: Language) -> Self {
        Self::of_bundle(language, Bundle::of(language.code()))
    }

    /// The texts of a bundle, with numbers as a language writes them.
    pub fn of_bundle(language: Language, bundle: Bundle) -> Self {
        Self { language, decimal_sign: language.decimal_sign(), bundle }
    }

    /// The same texts with another decimal sign, a point or a comma, than the language's own.
    #[must_use]
    pub fn with_decimal_sign(self, decimal_sign: char) -> Self {
        Self { decimal_sign, ..self }
    }

    /// The same, with the user's own texts in place of those that these replace; own texts of another language do not count.
    #[must_use]
    pub fn with_own(self, own: Option<Arc<OwnTexts>>) -> Self {
        Self { bundle: self.bundle.with_own(own), ..self }
    }

    /// The user's own texts among them.
    pub const fn own(&self) -> Option<&Arc<OwnTexts>> {
        self.bundle.own()
    }

    /// What stands before the decimals of a number.
    pub const fn decimal_sign(&self) -> char {
        self.decimal_sign
    }

    /// Which language.
    pub const fn language(&self) -> Language {
        self.language
    }

    /// The text of a name without arguments.
    pub fn get(&self, id: &str) -> String {
        self.bundle.get(id)
    }

    /// The text of a name without arguments, if there is one.
    pub fn find(&self, id: &str) -> Option<String> {
        self.bundle.find(id)
    }

    /// A sentence in this language; [`Words::told`] takes what has one.
    pub fn say(&self, message: &Message) -> String {
        self.bundle.say(message, &|plain| self.number(plain))
    }

    /// The text of an error or a warning in this language; [`Words::say`] takes a message that was made by hand.
    pub fn told(&self, what: &impl Say) -> String {
        self.say(&what.message())
    }

    /// A machine's number (`-25.012`) as people of this language read it: with its decimal sign and a true minus sign.
    pub fn number(&self, plain: &str) -> String {
        let read = |c| match c {
            '.' => self.decimal_sign,
            '-' => '\u{2212}',
            c => c,
        };
        plain.chars().map(read).collect()
    }

    /// Millimetres with at least this many decimals, exactly.
    pub fn mm(&self, length: Length, decimals: usize) -> String {
        self.number(&length.exact(Unit::Millimetre, decimals))
    }

    /// Micrometres exactly, with a sign unless zero: `+12`, `−7,5`, `0`.
    pub fn signed_um(&self, length: Length) -> String {
        self.number(&length.signed_um())
    }

    /// Micrometres exactly, without a plus sign.
    pub fn um(&self, length: Length) -> String {
        self.number(&length.exact(Unit::Micrometre, 0))
    }
}
