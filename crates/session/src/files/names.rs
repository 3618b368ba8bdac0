//! Proposed names of files: the part and the date, in characters that every system allows.

use fitcheck_exchange::journal::Record;
use jiff::civil::DateTime;

/// The most characters of a part's name, and the most bytes: with date and ending a name stays below every limit.
const LONGEST: usize = 60;
const MOST_BYTES: usize = 160;

/// `A12-25H7-2026-11-21.csv` for checks of one feature, else `checks-2026-11-21.csv`.
pub(super) fn of_records<'a>(
    records: impl IntoIterator<Item = &'a Record>,
    several: &str,
    now: DateTime,
    ending: &str,
) -> String {
    let mut names = records.into_iter().map(of_record);
    let first = names.next().filter(|name| !name.is_empty());
    let is_one = first.is_some() && names.all(|name| first.as_ref() == Some(&name));
    dated(&first.filter(|_| is_one).unwrap_or_else(|| allowed(several)), now, ending)
}

/// `A12-25H7`: what a record's part is called, and its callout.
pub(crate) fn of_record(record: &Record) -> String {
    let callout = record.callout.as_ref().map(|callout| in_name(&callout.to_string()));
    let parts: Vec<_> = [Some(record.id.clone()), callout].into_iter().flatten().map(|part| allowed(&part)).collect();
    allowed(&parts.join("-"))
}

/// A callout without the signs that a name cannot have: `12+0.02-0.02` for ±0.02, and an underscore between two limits.
/// A hyphen in their place would read as a minus.
fn in_name(callout: &str) -> String {
    let text = callout.replace(' ', "").replace('/', "_");
    match text.split_once('±') {
        Some((nominal, deviation)) => format!("{nominal}+{deviation}-{deviation}"),
        None => text,
    }
}

/// A name with the date, and an ending.
pub(super) fn dated(name: &str, now: DateTime, ending: &str) -> String {
    let date = now.date();
    if name.is_empty() { format!("{date}.{ending}") } else { format!("{name}-{date}.{ending}") }
}

/// A file's name with another ending.
pub(super) fn with_ending(name: &str, ending: &str) -> String {
    let stem = name.rsplit_once('.').map_or(name, |(stem, _)| stem);
    format!("{stem}.{ending}")
}

/// A text in characters that every system allows in a name: letters, digits, and single `-`, `_`, `+` and `.` between
/// them.
pub(super) fn allowed(text: &str) -> String {
    let mut name = String::new();
    for character in text.chars() {
        if name.chars().count() == LONGEST || MOST_BYTES < name.len() + character.len_utf8() {
            break;
        }
        if character.is_alphanumeric() {
            name.push(character);
        } else if !name.ends_with(['-', '_', '+', '.']) && !name.is_empty() {
            name.push(if "_+.".contains(character) { character } else { '-' });
        }
    }
    name.truncate(name.trim_end_matches(['-', '_', '+', '.']).len());
    name
}
