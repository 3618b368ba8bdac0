//! The name of a parameter as errors say it: in the language of the reader where the control has one.

use std::fmt;

use super::texts::Texts;
use crate::message::{Arg, IntoArg};

/// The name of a parameter in every dialogue language that has one.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ParameterName {
    english: &'static str,
    others: Texts,
}

impl ParameterName {
    /// The English name, and those in other dialogue languages.
    pub const fn new(english: &'static str, others: Texts) -> Self {
        Self { english, others }
    }
}

/// The English name, as machines read it.
impl fmt::Display for ParameterName {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.english)
    }
}

impl IntoArg for ParameterName {
    fn arg(&self) -> Arg {
        let by_code = self.others.iter().map(|(language, name)| (language.code(), *name)).collect();
        Arg::Name { plain: self.english, by_code }
    }
}
