//! The texts of one language.

use std::fmt;

use fluent_bundle::concurrent::FluentBundle;
use fluent_bundle::{FluentArgs, FluentResource, FluentValue};

use super::{Arg, Message};
use crate::shipped;

/// The texts of one language: the folder of its code in `assets/locales`.
pub struct Bundle {
    code: &'static str,
    texts: FluentBundle<FluentResource>,
}

impl fmt::Debug for Bundle {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Bundle").field("code", &self.code).finish_non_exhaustive()
    }
}

impl Bundle {
    /// Loads the embedded texts of a language; nothing is read from disk.
    pub fn of(code: &'static str) -> Self {
        Self::from_files(code, shipped::LOCALES.iter().filter(|(name, _)| name.split('/').next() == Some(code)))
    }

    /// The texts of some Fluent files of a language.
    pub fn from_files(code: &'static str, files: impl Iterator<Item = &'static (&'static str, &'static [u8])>) -> Self {
        let mut texts = FluentBundle::new_concurrent(vec![code.parse().unwrap_or_default()]);
        // The marks U+2068 and U+2069 around every argument would show in reports and labels.
        texts.set_use_isolating(false);
        for (name, bytes) in files {
            let resource = match FluentResource::try_new(String::from_utf8_lossy(bytes).into_owned()) {
                Ok(resource) => resource,
                Err((resource, errors)) => {
                    log::error!("locale {name}: {errors:?}");
                    resource
                }
            };
            if let Err(errors) = texts.add_resource(resource) {
                log::error!("locale {name}: {errors:?}");
            }
        }
        Self { code, texts }
    }

    /// The text of a name without arguments, if there is one.
    pub fn find(&self, id: &str) -> Option<String> {
        self.texts.has_message(id).then(|| self.format(id, None))
    }

    /// The text of a name without arguments.
    pub fn get(&self, id: &str) -> String {
        self.format(id, None)
    }

    /// A sentence in this language; `number` prints decimal numbers in its way.
    pub fn say(&self, message: &Message, number: &dyn Fn(&str) -> String) -> String {
        let mut args = FluentArgs::new();
        for (name, arg) in &message.args {
            let value: FluentValue<'_> = match arg {
                Arg::Text(text) => text.as_str().into(),
                Arg::Count(count) => (*count).into(),
                Arg::Number(plain) => number(plain).into(),
                Arg::Message(message) => self.say(message, number).into(),
                Arg::Name { plain, by_code } => {
                    by_code.iter().find(|(code, _)| *code == self.code).map_or(*plain, |(_, name)| *name).into()
                }
            };
            args.set(*name, value);
        }
        self.format(message.id, Some(&args))
    }

    /// An unknown name is shown as it is and logged: a missing text must never stop a measurement.
    fn format(&self, id: &str, args: Option<&FluentArgs<'_>>) -> String {
        let Some(pattern) = self.texts.get_message(id).and_then(|message| message.value()) else {
            log::error!("locale {}: no text {id}", self.code);
            return id.to_owned();
        };
        let mut errors = Vec::new();
        let text = self.texts.format_pattern(pattern, args, &mut errors).into_owned();
        if !errors.is_empty() {
            log::error!("locale {}, text {id}: {errors:?}", self.code);
        }
        text
    }
}
