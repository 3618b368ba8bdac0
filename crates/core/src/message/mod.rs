//! A sentence without its language: the name of a text and what is put into it.
//!
//! Errors, warnings and remarks derive [`Say`]; their only wording is in `assets/locales`. `Display` is the English
//! text, as logs and machines read it: with a decimal point and an ASCII minus. The window and the report ask
//! [`Words`](crate::words::Words) for their own language.
//!
//! | file | what |
//! |---|---|
//! | `arg` | what can be put into a text, and how |
//! | `bundle` | the texts of one language |
//! | `foreign` | texts that somebody else has written, where they could do harm |
//! | `own`, `own_reading`, `placeables` | the user's own texts of one language; reading them; whether one shows all that the built-in one shows |
//! | `located` | an error or a warning with its place in a file |
//!
//! To add an error, a warning or a remark:
//!
//! 1. Add a variant to the enum of its room, which derives [`Say`]. A place in a file is [`Located`], never a field.
//! 2. Add its text to every folder of `assets/locales`. Its name is the prefix of the enum and the variant in kebab case; its
//!    arguments are the fields. `crates/derive/src/lib.rs` has the attributes that change this. `Display` is the English text.
//! 3. If the command line shows it as a warning or a remark, decide in `cli/admitted.rs` whether it changes the exit code. A warning of a
//!    measurement file decides in `exchange/warning.rs`: `stands_against` (exit code 14), `is_loss` (the note of a watched folder) and
//!    `is_of_claim` (said again by a plan). If `batch` meets it in a row, it needs a `RowNoteKind` in `exchange/batch/tally.rs`, a line in
//!    `cli/batch/summary.rs` and one in `gui/check/rows_panel.rs` with its text in `window.ftl`.
//!
//! A missing English text does not compile, nor does a text with an argument that the variant lacks. The test `locales` finds a
//! missing text of another language. It also finds ids without a text that a declaration names or that the code composes.

mod arg;
mod bundle;
mod foreign;
mod located;
mod own;
mod own_reading;
mod placeables;

use std::fmt;
use std::sync::LazyLock;

pub use arg::{Arg, IntoArg, as_text, printed};
pub use bundle::{Bundle, Transform};
pub use fitcheck_derive::{Say, message};
pub use foreign::{guarded, is_formula, is_wild, tame};
pub use located::{FilePlace, Located};
pub use own::{LARGEST_TEXTS, OwnTextFault, OwnTexts, READ_BACK};

/// A sentence without its language: the name of a text and what is put into it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Message {
    /// The text's name in the Fluent files.
    pub id: &'static str,
    /// What is put in, by name.
    pub args: Vec<(&'static str, Arg)>,
}

impl Message {
    /// A message without arguments.
    pub const fn new(id: &'static str) -> Self {
        Self { id, args: Vec::new() }
    }

    /// A copy with one more value, put in as its type says.
    #[must_use]
    pub fn with(mut self, name: &'static str, value: &(impl IntoArg + ?Sized)) -> Self {
        self.args.push((name, value.arg()));
        self
    }

    /// A copy with one more text, put in as it is.
    #[must_use]
    pub fn text(mut self, name: &'static str, text: impl fmt::Display) -> Self {
        self.args.push((name, Arg::Text(text.to_string())));
        self
    }

    /// A copy with one more whole number.
    #[must_use]
    pub fn count(self, name: &'static str, count: usize) -> Self {
        self.with(name, &count)
    }

    /// A copy with one more decimal number, as it is printed with a point: the language's decimal sign takes its place. The
    /// text states the unit.
    #[must_use]
    pub fn number(mut self, name: &'static str, number: impl fmt::Display) -> Self {
        self.args.push((name, Arg::Number(number.to_string())));
        self
    }

    /// A copy with one more message.
    #[must_use]
    pub fn message(mut self, name: &'static str, message: Self) -> Self {
        self.args.push((name, Arg::Message(message)));
        self
    }
}

impl Say for Message {
    fn message(&self) -> Message {
        self.clone()
    }
}

/// The English text, with numbers as machines write them.
impl fmt::Display for Message {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        static ENGLISH: LazyLock<Bundle> = LazyLock::new(|| Bundle::of("en"));
        f.pad(&ENGLISH.say(self, &str::to_owned))
    }
}

/// Something with a sentence in every language: errors, warnings and remarks.
pub trait Say {
    /// The sentence without its language.
    fn message(&self) -> Message;
}

impl<T: Say + ?Sized> Say for Box<T> {
    fn message(&self) -> Message {
        self.as_ref().message()
    }
}

/// A given text as errors repeat it: at most this many characters, with control characters made visible, so that a
/// changed text can no longer be read as a number or callout.
pub fn shortened(text: &str, most: usize) -> String {
    let mut chars = text.chars().map(|c| if c.is_control() { char::REPLACEMENT_CHARACTER } else { c });
    let mut short: String = chars.by_ref().take(most).collect();
    if chars.next().is_some() {
        short.push('…');
    }
    short
}

/// `Display` for a type whose sentence is composed by hand: the English text.
#[macro_export]
macro_rules! display {
    ($($type:ty),+ $(,)?) => {$(
        impl ::std::fmt::Display for $type {
            fn fmt(&self, f: &mut ::std::fmt::Formatter<'_>) -> ::std::fmt::Result {
                ::std::fmt::Display::fmt(&$crate::message::Say::message(self), f)
            }
        }
    )+};
}
pub use crate::display;
