//! What programs call a parameter or a result: `Q273`, `QS400`, `BR`, `#i99`.

use std::fmt;

/// The name of a parameter or a result.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Key {
    /// A number parameter of a milling control, `Q273`.
    Q(u16),
    /// A text parameter of a milling control, `QS400`.
    Qs(u16),
    /// An address letter or a variable of a lathe control, `BR` or `#i99`.
    Word(&'static str),
}

impl fmt::Display for Key {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Q(number) => f.pad(&format!("Q{number}")),
            Self::Qs(number) => f.pad(&format!("QS{number}")),
            Self::Word(word) => f.pad(word),
        }
    }
}

crate::message::as_text!(Key);

impl From<u16> for Key {
    /// The Q parameter of this number.
    fn from(number: u16) -> Self {
        Self::Q(number)
    }
}

impl Key {
    /// Whether a text names this key: `q273` is Q273, and QS330 the text form of Q330.
    pub(super) fn is_named(self, text: &str) -> bool {
        self.is_exactly(text) || matches!(self, Self::Q(number) if Self::Qs(number).is_exactly(text))
    }

    /// Whether a text is the number parameter of a text parameter: Q1116 of QS1116.
    pub(super) fn is_number_of(self, text: &str) -> bool {
        matches!(self, Self::Qs(number) if Self::Q(number).is_exactly(text))
    }

    /// Whether a text is this key and not the text form of its number.
    pub(super) fn is_exactly(self, text: &str) -> bool {
        let text = text.trim();
        let (prefix, number) = match self {
            Self::Q(number) => ("Q", number),
            Self::Qs(number) => ("QS", number),
            Self::Word(word) => return word.eq_ignore_ascii_case(text),
        };
        let digits = text.split_at_checked(prefix.len()).filter(|(letters, _)| letters.eq_ignore_ascii_case(prefix));
        digits.is_some_and(|(_, digits)| {
            // As the key is printed: no sign, no zero before the number.
            digits.bytes().all(|byte| byte.is_ascii_digit())
                && digits.parse() == Ok(number)
                && (number == 0 && digits.len() == 1 || !digits.starts_with('0'))
        })
    }
}
