//! An entry as somebody names it: by its number, or by the first digits of its hash, as a report shows them.

use std::path::Path;

use super::{CliError, IntoCliError as _};
use crate::journal::chain::HashPrefix;
use crate::store::local::Reader;

/// As many digits are no number of an entry any more, and may be those of a hash that has no letters.
const MOST_FIGURES: usize = 15;

/// So many entries are named where several have the digits.
const NAMED: usize = 5;

/// An entry as it is named.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum EntryName {
    Number(u64),
    Hash(HashPrefix),
}

/// Reads the name of an entry: figures alone are a number.
pub(super) fn entry_name(text: &str) -> Result<EntryName, String> {
    if let Some(number) = figures(text) {
        return Ok(EntryName::Number(number));
    }
    let wrong = || {
        let fewest = HashPrefix::FEWEST;
        format!("expected the number of an entry, or at least {fewest} hexadecimal digits that its hash begins with")
    };
    HashPrefix::read(text).map(EntryName::Hash).ok_or_else(wrong)
}

fn figures(text: &str) -> Option<u64> {
    let is_number = text.bytes().all(|byte| byte.is_ascii_digit()) && text.len() <= MOST_FIGURES;
    is_number.then(|| text.parse().ok()).flatten()
}

impl EntryName {
    /// The number of the one entry that is meant.
    ///
    /// # Errors
    /// [`CliError`] where no hash of the journal begins so, or those of several do.
    pub(super) fn number(&self, reader: &Reader, path: &Path) -> Result<u64, CliError> {
        let prefix = match self {
            Self::Number(number) => return Ok(*number),
            Self::Hash(prefix) => prefix,
        };
        let found = reader.with_hash(prefix, NAMED.saturating_add(1)).said()?;
        match found.as_slice() {
            [] => Err(CliError::NoHash { prefix: prefix.to_string(), path: path.to_owned() }),
            [one] => Ok(one.number),
            several => {
                let named = several.iter().take(NAMED).map(|head| head.number.to_string());
                let more = (NAMED < several.len()).then(|| "…".to_owned());
                let numbers = named.chain(more).collect::<Vec<_>>().join(", ");
                Err(CliError::SeveralHashes { prefix: prefix.to_string(), numbers })
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn figures_are_a_number_unless_no_journal_is_so_long() {
        assert_eq!(entry_name("57"), Ok(EntryName::Number(57)));
        assert_eq!(entry_name("123456789012345"), Ok(EntryName::Number(123_456_789_012_345)));
        for text in ["1234567890123456", "9f86d081", "9F86D081884C7D65", &"0".repeat(64)] {
            assert!(matches!(entry_name(text), Ok(EntryName::Hash(_))), "{text}");
        }
        for text in ["", "-1", "9f86d08", "9f86d08g", "twelve", &"0".repeat(65), "1 2"] {
            assert!(entry_name(text).is_err(), "{text}");
        }
    }
}
