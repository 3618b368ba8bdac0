//! What can be put into a text, and how each type goes in.

use std::fmt;
use std::path::PathBuf;
use std::sync::Arc;

use super::{Message, Say};

/// Something that is put into a [`Message`].
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Arg {
    /// A text as it is.
    Text(String),
    /// A whole number; it also chooses plural forms.
    Count(usize),
    /// A decimal number with a point and an ASCII minus; each language prints it in its own way.
    Number(String),
    /// A sentence within the sentence.
    Message(Message),
    /// A name that a control has in several languages.
    Name {
        /// Where the language has none.
        plain: &'static str,
        /// By the code of a language.
        by_code: Vec<(&'static str, &'static str)>,
    },
}

/// How a value goes into a text.
pub trait IntoArg {
    /// The value as an argument.
    fn arg(&self) -> Arg;
}

impl<T: Say> IntoArg for T {
    fn arg(&self) -> Arg {
        Arg::Message(self.message())
    }
}

impl IntoArg for Box<Arg> {
    fn arg(&self) -> Arg {
        Arg::clone(self)
    }
}

impl IntoArg for Arg {
    fn arg(&self) -> Arg {
        self.clone()
    }
}

/// Types that go in as the text that they print.
#[macro_export]
macro_rules! as_text {
    ($($type:ty),+ $(,)?) => {$(
        impl $crate::message::IntoArg for $type {
            fn arg(&self) -> $crate::message::Arg {
                $crate::message::Arg::Text(self.to_string())
            }
        }
    )+};
}
pub use crate::as_text;

as_text!(str, &str, String, Arc<str>, char, i8, i16, i32, i64, u64);

/// A computed value, as each language prints it.
impl IntoArg for f64 {
    fn arg(&self) -> Arg {
        Arg::Number(self.to_string())
    }
}

/// A number that was already printed, with a point and an ASCII minus; for `#[say(with = printed)]`.
pub fn printed(plain: &impl fmt::Display) -> Arg {
    Arg::Number(plain.to_string())
}

/// Small numbers choose plural forms.
macro_rules! as_count {
    ($($type:ty),+) => {$(
        impl IntoArg for $type {
            fn arg(&self) -> Arg {
                usize::try_from(*self).map_or_else(|_| Arg::Text(self.to_string()), Arg::Count)
            }
        }
    )+};
}

as_count!(u8, u16, u32, usize);

impl IntoArg for PathBuf {
    fn arg(&self) -> Arg {
        Arg::Text(self.display().to_string())
    }
}
