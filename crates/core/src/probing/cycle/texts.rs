//! Words of the control in the dialogue languages that have them.

use crate::words::Dialogue;

/// Words of the control by dialogue language.
pub type Texts = &'static [(Dialogue, &'static str)];

/// The text in a language, where it has one.
pub(super) fn in_language(texts: Texts, language: Dialogue) -> Option<&'static str> {
    texts.iter().find(|(known, _)| *known == language).map(|(_, text)| *text)
}
