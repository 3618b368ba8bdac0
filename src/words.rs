//! Texts in the user's language, from the Fluent files in `assets/locales`.
//!
//! A room's error types say in English what is wrong (`Display`) and name the same sentence for other languages
//! ([`Say`]). The window and the report ask [`Words`]; files made for machines never do.

use std::fmt;

use fluent_bundle::concurrent::FluentBundle;
use fluent_bundle::{FluentArgs, FluentResource, FluentValue};

use crate::length::{Length, Unit};

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

    /// The Fluent files, by name: one a room.
    const fn files(self) -> &'static [(&'static str, &'static str)] {
        match self {
            Self::Nl => &NL,
            // German and Italian texts follow; until then the window does not offer them.
            Self::En | Self::De | Self::It => &EN,
        }
    }
}

impl fmt::Display for Language {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.code())
    }
}

macro_rules! files {
    ($folder:literal: $($name:literal)*) => {
        [$(($name, include_str!(concat!("../assets/locales/", $folder, "/", $name, ".ftl")))),*]
    };
}

const EN: [(&str, &str); 7] = files!("en": "tolerance" "probing" "control" "exchange" "report" "window" "cycles-page");
const NL: [(&str, &str); 7] = files!("nl": "tolerance" "probing" "control" "exchange" "report" "window" "cycles-page");

/// A sentence without its language: the name of a text and what is put into it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Message {
    /// The text's name in the Fluent files.
    pub id: &'static str,
    /// What is put in, by name.
    pub args: Vec<(&'static str, Arg)>,
}

/// Something that is put into a [`Message`].
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Arg {
    /// A text as it is.
    Text(String),
    /// A whole number; it also chooses plural forms.
    Count(usize),
    /// A length, printed exactly in millimetres without its unit.
    Millimetres(Length),
    /// A sentence within the sentence.
    Message(Message),
}

impl Message {
    /// A message without arguments.
    pub const fn new(id: &'static str) -> Self {
        Self { id, args: Vec::new() }
    }

    /// The same with one more text put in.
    #[must_use]
    pub fn text(mut self, name: &'static str, text: impl fmt::Display) -> Self {
        self.args.push((name, Arg::Text(text.to_string())));
        self
    }

    /// The same with one more number put in.
    #[must_use]
    pub fn count(mut self, name: &'static str, count: usize) -> Self {
        self.args.push((name, Arg::Count(count)));
        self
    }

    /// The same with one more length put in.
    #[must_use]
    pub fn mm(mut self, name: &'static str, length: Length) -> Self {
        self.args.push((name, Arg::Millimetres(length)));
        self
    }

    /// The same with another message put in.
    #[must_use]
    pub fn message(mut self, name: &'static str, message: Self) -> Self {
        self.args.push((name, Arg::Message(message)));
        self
    }
}

/// What can be said in every language: error types and warnings.
pub trait Say {
    /// The sentence without its language. In English it reads exactly as `Display` does.
    fn message(&self) -> Message;
}

/// The texts of one language.
pub struct Words {
    language: Language,
    bundle: FluentBundle<FluentResource>,
}

impl fmt::Debug for Words {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Words").field("language", &self.language).finish_non_exhaustive()
    }
}

impl Words {
    /// Loads the embedded texts of a language; nothing is read from disk.
    pub fn new(language: Language) -> Self {
        let mut bundle = FluentBundle::new_concurrent(vec![locale(language)]);
        // The marks U+2068 and U+2069 around every argument would stand in reports and labels.
        bundle.set_use_isolating(false);
        for (name, text) in language.files() {
            let resource = match FluentResource::try_new((*text).to_owned()) {
                Ok(resource) => resource,
                Err((resource, errors)) => {
                    log::error!("locale {language}, file {name}.ftl: {errors:?}");
                    resource
                }
            };
            if let Err(errors) = bundle.add_resource(resource) {
                log::error!("locale {language}, file {name}.ftl: {errors:?}");
            }
        }
        Self { language, bundle }
    }

    /// Which language.
    pub const fn language(&self) -> Language {
        self.language
    }

    /// The text of a name without arguments.
    pub fn get(&self, id: &str) -> String {
        self.format(id, None)
    }

    /// The text of a name without arguments, where there is one.
    pub fn find(&self, id: &str) -> Option<String> {
        self.bundle.has_message(id).then(|| self.get(id))
    }

    /// A sentence in this language.
    pub fn say(&self, message: &Message) -> String {
        let mut args = FluentArgs::new();
        for (name, arg) in &message.args {
            let value: FluentValue<'_> = match arg {
                Arg::Text(text) => text.clone().into(),
                Arg::Count(count) => (*count).into(),
                Arg::Millimetres(length) => self.number(&length.to_string()).into(),
                Arg::Message(message) => self.say(message).into(),
            };
            args.set(*name, value);
        }
        self.format(message.id, Some(&args))
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
        let plain = length.exact(Unit::Micrometre, 0);
        let plus = if Length::ZERO < length { "+" } else { "" };
        format!("{plus}{}", self.number(&plain))
    }

    /// Micrometres exactly, without a plus sign.
    pub fn um(&self, length: Length) -> String {
        self.number(&length.exact(Unit::Micrometre, 0))
    }

    /// An unknown name is shown as itself and logged: a missing text must never stop a measurement.
    fn format(&self, id: &str, args: Option<&FluentArgs<'_>>) -> String {
        let Some(pattern) = self.bundle.get_message(id).and_then(|message| message.value()) else {
            log::error!("locale {}: no text {id}", self.language);
            return id.to_owned();
        };
        let mut errors = Vec::new();
        let text = self.bundle.format_pattern(pattern, args, &mut errors).into_owned();
        if !errors.is_empty() {
            log::error!("locale {}, text {id}: {errors:?}", self.language);
        }
        text
    }
}

fn locale(language: Language) -> unic_langid::LanguageIdentifier {
    language.code().parse().unwrap_or_default()
}
