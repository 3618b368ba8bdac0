//! The texts of one language.

use std::borrow::Cow;
use std::collections::HashMap;
use std::fmt;
use std::sync::{Arc, LazyLock, OnceLock};

use fitcheck_shipped as shipped;
use fluent_bundle::concurrent::FluentBundle;
use fluent_bundle::{FluentArgs, FluentResource, FluentValue};

use super::{Arg, Message, OwnTexts, tame};

/// Changes the wording of a text.
pub type Transform = fn(&str) -> Cow<'_, str>;

/// The texts of one language: the folder of its code in `assets/locales`.
///
/// A file is parsed when the first of its texts is wanted: a call on the command line needs two or three of them. A text can refer to
/// others of its own file only.
pub struct Bundle {
    code: &'static str,
    transform: Option<Transform>,
    /// The user's own texts of this language, which are said in place of the built-in ones.
    own: Option<Arc<OwnTexts>>,
    /// The texts in the order of their names.
    texts: OnceLock<Cow<'static, str>>,
    files: Vec<OnceLock<FluentBundle<FluentResource>>>,
}

impl fmt::Debug for Bundle {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Bundle").field("code", &self.code).finish_non_exhaustive()
    }
}

/// The names of all texts.
pub(super) struct Names {
    /// File by file, in the order in which a language has its texts.
    files: Vec<Vec<&'static str>>,
    /// The file of each.
    places: HashMap<&'static str, usize>,
}

pub(super) static NAMES: LazyLock<Names> = LazyLock::new(|| {
    let files: Vec<Vec<&str>> = shipped::NAMES.split("\n\n").map(|names| names.lines().collect()).collect();
    let places = files.iter().enumerate().flat_map(|(at, names)| names.iter().map(move |name| (*name, at))).collect();
    Names { files, places }
});

impl Names {
    /// All of them, in the order in which a language has its texts.
    pub(super) fn all(&self) -> impl Iterator<Item = &'static str> {
        self.files.iter().flatten().copied()
    }
}

impl Bundle {
    /// The embedded texts of a language; nothing is read from disk.
    pub fn of(code: &'static str) -> Self {
        let files = NAMES.files.iter().map(|_| OnceLock::new()).collect();
        Self { code, transform: None, own: None, texts: OnceLock::new(), files }
    }

    /// The same texts, each passed through a function without what is put into them: a language for tests, such as one
    /// with longer words.
    #[must_use]
    pub fn transformed(self, transform: Transform) -> Self {
        Self { transform: Some(transform), own: self.own, ..Self::of(self.code) }
    }

    /// The same texts, with the user's own in place of those that these replace; own texts of another language do not count.
    #[must_use]
    pub fn with_own(self, own: Option<Arc<OwnTexts>>) -> Self {
        let own = own.filter(|own| own.code() == self.code);
        Self { transform: self.transform, own, ..Self::of(self.code) }
    }

    /// The user's own texts among them.
    pub const fn own(&self) -> Option<&Arc<OwnTexts>> {
        self.own.as_ref()
    }

    /// The texts of a file as Fluent reads them.
    fn source(&self, at: usize) -> String {
        // A language that is not built in has no texts.
        let texts = self.texts.get_or_init(|| shipped::texts(self.code).unwrap_or(Cow::Borrowed("")));
        let before = NAMES.files.iter().take(at).map(Vec::len).sum();
        let names = NAMES.files.get(at).into_iter().flatten();
        let named = names.zip(texts.split('\0').skip(before)).filter(|(_, text)| !text.is_empty());
        let own = |name: &str| self.own.as_deref().and_then(|own| own.entry(name));
        named.fold(String::new(), |all, (name, text)| match own(name) {
            Some(entry) => all + entry,
            None => all + name + " = " + text + "\n",
        })
    }

    fn parsed(&self, at: usize) -> FluentBundle<FluentResource> {
        let code = self.code;
        let language = match code.parse() {
            Ok(language) => vec![language],
            Err(error) => {
                log::error!("locale {code}: {error:?}");
                Vec::new()
            }
        };
        let mut texts = FluentBundle::new_concurrent(language);
        // The marks U+2068 and U+2069 around every argument would show in reports and labels.
        texts.set_use_isolating(false);
        texts.set_transform(self.transform);
        let resource = match FluentResource::try_new(self.source(at)) {
            Ok(resource) => resource,
            Err((resource, errors)) => {
                log::error!("locale {code}: {errors:?}");
                resource
            }
        };
        if let Err(errors) = texts.add_resource(resource) {
            log::error!("locale {code}: {errors:?}");
        }
        texts
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
        let at = *NAMES.places.get(id)?;
        let texts = self.files.get(at)?.get_or_init(|| self.parsed(at));
        let mut errors = Vec::new();
        let text = texts.format_pattern(texts.get_message(id)?.value()?, args, &mut errors).into_owned();
        if !errors.is_empty() {
            log::error!("locale {}, text {id}: {errors:?}", self.code);
        }
        Some(text)
    }

    /// An unknown name is shown as it is and logged: a missing text must never stop a measurement.
    fn format_or_name(&self, id: &str, args: Option<&FluentArgs<'_>>) -> String {
        self.format(id, args).unwrap_or_else(|| {
            log::error!("locale {}: no text {id}", self.code);
            id.to_owned()
        })
    }
}
