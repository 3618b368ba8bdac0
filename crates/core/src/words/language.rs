//! A language of the window and of reports: a folder of `assets/locales`.

use std::fmt;

use fitcheck_shipped as shipped;
use serde::{Deserialize, Deserializer, Serialize, Serializer};

/// A language of the window and of reports: the language of the person at Fitcheck.
///
/// Each folder of `assets/locales` is one language and has its own name and decimal sign in `language.ftl`. The texts
/// on a control are in a [`Dialogue`](super::Dialogue) of the control.
///
/// A saved state keeps the code; a code without a folder is read as English.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Language(&'static str);

#[expect(non_upper_case_globals, reason = "they read as the values of Dialogue do")]
impl Language {
    /// English: the language of errors printed without [`Words`](super::Words), and the substitute for an unknown code.
    pub const En: Self = Self("en");

    /// Dutch, the language of NC-Solution 8255.
    pub const Nl: Self = Self("nl");
}

impl Language {
    /// Every language, by code.
    pub fn all() -> impl ExactSizeIterator<Item = Self> {
        shipped::languages().map(|(code, ..)| Self(code))
    }

    /// The folder's name, as in `--language nl`.
    pub const fn code(self) -> &'static str {
        self.0
    }

    /// What its folder says about it.
    fn own(self) -> Option<(&'static str, char)> {
        shipped::languages().find(|(code, ..)| *code == self.0).map(|(_, name, decimal_sign)| (name, decimal_sign))
    }

    /// Its name in its own language.
    pub fn name(self) -> &'static str {
        self.own().map_or(self.0, |(name, _)| name)
    }

    /// The decimal sign of the window.
    pub fn decimal_sign(self) -> char {
        self.own().map_or('.', |(_, decimal_sign)| decimal_sign)
    }

    /// The language of a code or a system locale such as `nl_NL.UTF-8`, if it is one of ours.
    pub fn from_code(code: &str) -> Option<Self> {
        let code = code.split(['-', '_', '.']).next().unwrap_or(code);
        Self::all().find(|language| language.0.eq_ignore_ascii_case(code))
    }
}

impl Default for Language {
    fn default() -> Self {
        Self::En
    }
}

impl Serialize for Language {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(self.0)
    }
}

impl<'de> Deserialize<'de> for Language {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        // A language of a later version is English here.
        String::deserialize(deserializer).map(|code| Self::from_code(&code).unwrap_or(Self::En))
    }
}

impl fmt::Display for Language {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.0)
    }
}
