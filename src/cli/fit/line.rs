//! A named line of an answer, aligned with the others.

use std::fmt::Display;

use crate::cli::Io;

pub(super) fn line(name: &str, text: impl Display, io: &mut Io<'_>) {
    writeln!(io.people(), "  {name:<12} {text}");
}
