//! Texts in the user's language: [`Message`]s said in it, numbers written as its people read them.
//!
//! The window and the report ask [`Words`]; files made for machines never do.

use std::fmt;

use crate::length::{Length, Unit};
use crate::message::{Bundle, Message, Say};

/// A language of the window, the report and the masks.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Hash, serde::Serialize, serde::Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Language {
    /// English.
    #[default]
    En,
    /// Dutch.
    Nl,
    /// German.
    De,
    /// Italian.
    It,
}

impl Language {
    /// Every language that has a mask.
    pub const ALL: [Self; 4] = [Self::En, Self::Nl, Self::De, Self::It];

    /// The languages whose texts are complete: those that the window offers.
    pub const COMPLETE: [Self; 2] = [Self::En, Self::Nl];

    /// The two-letter code, as in `--language nl`.
    pub const fn code(self) -> &'static str {
        match self {
            Self::En => "en",
            Self::Nl => "nl",
            Self::De => "de",
            Self::It => "it",
        }
    }

    /// Its own name in itself.
    pub const fn name(self) -> &'static str {
        match self {
            Self::En => "English",
            Self::Nl => "Nederlands",
            Self::De => "Deutsch",
            Self::It => "Italiano",
        }
    }

    /// The language of a code or a system locale such as `nl_NL.UTF-8`, if it is one of ours.
    pub fn from_code(code: &str) -> Option<Self> {
        let code = code.split(['-', '_', '.']).next().unwrap_or(code);
        Self::ALL.into_iter().find(|language| language.code().eq_ignore_ascii_case(code))
    }

    /// The decimal sign of the window.
    pub const fn decimal_sign(self) -> char {
        match self {
            Self::En => '.',
            Self::Nl | Self::De | Self::It => ',',
        }
    }
}

impl fmt::Display for Language {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.code())
    }
}

/// The texts of one language.
#[derive(Debug)]
pub struct Words {
    language: Language,
    bundle: Bundle,
}

impl Words {
    /// Loads the embedded texts of a language; nothing is read from disk.
    pub fn new(language: Language) -> Self {
        // German and Italian texts follow; until then the window does not offer them.
        let code = if Language::COMPLETE.contains(&language) { language.code() } else { Language::En.code() };
        Self { language, bundle: Bundle::of(code) }
    }

    /// Which language.
    pub const fn language(&self) -> Language {
        self.language
    }

    /// The text of a name without arguments.
    pub fn get(&self, id: &str) -> String {
        self.bundle.get(id)
    }

    /// The text of a name without arguments, where there is one.
    pub fn find(&self, id: &str) -> Option<String> {
        self.bundle.find(id)
    }

    /// A sentence in this language.
    pub fn say(&self, message: &Message) -> String {
        self.bundle.say(message, &|plain| self.number(plain))
    }

    /// What an error or a warning says in this language.
    pub fn told(&self, what: &impl Say) -> String {
        self.say(&what.message())
    }

    /// A machine's number (`-25.012`) as people of this language read it: decimal sign, true minus sign.
    pub fn number(&self, plain: &str) -> String {
        let sign = self.language.decimal_sign();
        plain
            .chars()
            .map(|c| {
                if c == '.' {
                    sign
                } else if c == '-' {
                    '\u{2212}'
                } else {
                    c
                }
            })
            .collect()
    }

    /// Millimetres with at least so many decimals, exactly.
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
