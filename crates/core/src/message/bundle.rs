//! The texts of one language.

use std::borrow::Cow;
use std::fmt;
use std::sync::OnceLock;

use fitcheck_shipped as shipped;
use fluent_bundle::concurrent::FluentBundle;
use fluent_bundle::{FluentArgs, FluentResource, FluentValue};

use super::{Arg, Message, tame};

/// Changes the wording of a text.
pub type Transform = fn(&str) -> Cow<'_, str>;

/// The texts of one language: the folder of its code in `assets/locales`.
pub struct Bundle {
    code: &'static str,
    files: Vec<TextFile>,
    /// The file that each text stands in, by name.
    places: &'static [(&'static str, usize)],
}

impl fmt::Debug for Bundle {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Bundle").field("code", &self.code).finish_non_exhaustive()
    }
}

/// One Fluent file, parsed when the first of its texts is wanted: a call on the command line needs two or three of
/// them. A text can refer to others of its own file only.
pub struct TextFile {
    code: &'static str,
    name: &'static str,
    bytes: &'static [u8],
    transform: Option<Transform>,
    parsed: OnceLock<FluentBundle<FluentResource>>,
}

impl fmt::Debug for TextFile {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("TextFile").field("name", &self.name).finish_non_exhaustive()
    }
}

impl TextFile {
    /// A built-in file of a language.
    pub const fn new(code: &'static str, (name, bytes): (&'static str, &'static [u8])) -> Self {
        Self { code, name, bytes, transform: None, parsed: OnceLock::new() }
    }

    fn parsed(&self) -> &FluentBundle<FluentResource> {
        self.parsed.get_or_init(|| {
            let language = match self.code.parse() {
                Ok(language) => vec![language],
                Err(error) => {
                    log::error!("locale {}: {error:?}", self.name);
                    Vec::new()
                }
            };
            let mut texts = FluentBundle::new_concurrent(language);
            // The marks U+2068 and U+2069 around every argument would show in reports and labels.
            texts.set_use_isolating(false);
            texts.set_transform(self.transform);
            let resource = match FluentResource::try_new(String::from_utf8_lossy(self.bytes).into_owned()) {
                Ok(resource) => resource,
                Err((resource, errors)) => {
                    log::error!("locale {}: {errors:?}", self.name);
                    resource
                }
            };
            if let Err(errors) = texts.add_resource(resource) {
                log::error!("locale {}: {errors:?}", self.name);
            }
            texts
        })
    }

    /// A text of the file, if it is there.
    pub fn find(&self, id: &str, args: Option<&FluentArgs<'_>>) -> Option<String> {
        let texts = self.parsed();
        let mut errors = Vec::new();
        let text = texts.format_pattern(texts.get_message(id)?.value()?, args, &mut errors).into_owned();
        if !errors.is_empty() {
            log::error!("locale {}, text {id}: {errors:?}", self.name);
        }
        Some(text)
    }
}

impl Bundle {
    /// The embedded texts of a language; nothing is read from disk.
    pub fn of(code: &'static str) -> Self {
        let files = shipped::LOCALES.iter().filter(|(name, _)| name.split('/').next() == Some(code));
        // A language that is not built in has no texts.
        let places = shipped::TEXTS.iter().find(|(known, _)| *known == code).map_or(&[][..], |(_, places)| *places);
        Self { code, files: files.map(|file| TextFile::new(code, *file)).collect(), places }
    }

    /// The same texts, each passed through a function without what is put into them: a language for tests, such as one
    /// with longer words.
    #[must_use]
    pub fn transformed(self, transform: Transform) -> Self {
        let transformed = |file: TextFile| TextFile { transform: Some(transform), parsed: OnceLock::new(), ..file };
        Self { files: self.files.into_iter().map(transformed).collect(), ..self }
    }

    /// The text of a name without arguments, if there is one.
    pub fn find(&self, id: &str) -> Option<String> {
        self.format(id, None)
    }

    /// The text of a name without arguments.
    pub fn get(&self, id: &str) -> String {
        self.format_or_name(id, None)
    }

    /// A sentence in this language; `number` prints decimal numbers in its way.
    pub fn say(&self, message: &Message, number: &dyn Fn(&str) -> String) -> String {
        let mut args = FluentArgs::new();
        for (name, arg) in &message.args {
            let value: FluentValue<'_> = match arg {
                Arg::Text(text) => tame(text).into(),
                Arg::Count(count) => (*count).into(),
                Arg::Number(plain) => number(plain).into(),
                Arg::Message(message) => self.say(message, number).into(),
                Arg::Name { plain, by_code } => {
                    by_code.iter().find(|(code, _)| *code == self.code).map_or(*plain, |(_, name)| *name).into()
                }
            };
            args.set(*name, value);
        }
        self.format_or_name(message.id, Some(&args))
    }

    fn format(&self, id: &str, args: Option<&FluentArgs<'_>>) -> Option<String> {
        let at = self.places.binary_search_by_key(&id, |(name, _)| name).ok()?;
        self.files.get(self.places.get(at)?.1)?.find(id, args)
    }

    /// An unknown name is shown as it is and logged: a missing text must never stop a measurement.
    fn format_or_name(&self, id: &str, args: Option<&FluentArgs<'_>>) -> String {
        self.format(id, args).unwrap_or_else(|| {
            log::error!("locale {}: no text {id}", self.code);
            id.to_owned()
        })
    }
}
