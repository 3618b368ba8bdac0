//! A language of the window and of reports: a folder of `assets/locales`.

use std::fmt;
use std::sync::LazyLock;

use fitcheck_shipped::{self as shipped, Files};
use serde::{Deserialize, Deserializer, Serialize, Serializer};

use crate::message::TextFile;

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

/// What a folder says about itself.
#[derive(Debug, PartialEq, Eq)]
struct Folder {
    code: &'static str,
    name: String,
    decimal_sign: char,
}

/// The languages in a list of built-in texts, in its order. The default name is the code, the default sign the point.
fn folders(locales: Files) -> Vec<Folder> {
    let own = locales.iter().filter_map(|file| Some((file.0.strip_suffix("/language.ftl")?, file)));
    let folder = |(code, file): (_, &(_, _))| {
        let own = TextFile::new(code, *file);
        let sign = own.find("language-decimal-sign", None).and_then(|sign| sign.chars().next());
        let name = own.find("language-name", None).unwrap_or_else(|| code.to_owned());
        Folder { code, name, decimal_sign: sign.unwrap_or('.') }
    };
    own.map(folder).collect()
}

static FOLDERS: LazyLock<Vec<Folder>> = LazyLock::new(|| folders(shipped::LOCALES));

impl Language {
    /// Every language, by code.
    pub fn all() -> impl ExactSizeIterator<Item = Self> {
        FOLDERS.iter().map(|folder| Self(folder.code))
    }

    /// The folder's name, as in `--language nl`.
    pub const fn code(self) -> &'static str {
        self.0
    }

    fn folder(self) -> Option<&'static Folder> {
        FOLDERS.iter().find(|folder| folder.code == self.0)
    }

    /// Its name in its own language.
    pub fn name(self) -> &'static str {
        self.folder().map_or(self.0, |folder| &folder.name)
    }

    /// The decimal sign of the window.
    pub fn decimal_sign(self) -> char {
        self.folder().map_or('.', |folder| folder.decimal_sign)
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_new_folder_is_a_language() {
        let french = "language-name = Français\nlanguage-decimal-sign = ,\n".as_bytes();
        let english = b"language-name = English\nlanguage-decimal-sign = .\n";
        let locales: Files = Box::leak(Box::new([
            ("en/language.ftl", &english[..]),
            ("fr/a.ftl", b"a = b\n"),
            ("fr/language.ftl", french),
        ]));
        let folder = |code, name: &str, decimal_sign| Folder { code, name: name.to_owned(), decimal_sign };
        assert_eq!(folders(locales), [folder("en", "English", '.'), folder("fr", "Français", ',')]);
    }
}
