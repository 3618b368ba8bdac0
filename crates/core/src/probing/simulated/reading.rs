//! What the files of a simulated machine are read with: bounds, arrays of so many numbers, places, and the TOML reader's message.

use serde::Deserialize as _;

use super::Figure;
use super::figure::Table;

/// The largest file in bytes: a real one has some hundred, and the TOML reader takes fifty times as many.
pub const LARGEST: usize = 1 << 20;

/// The most characters of the TOML reader's message.
const LONGEST: usize = 300;

/// Whether a text is a file of several features.
pub(super) fn has_features(text: &str) -> bool {
    toml::de::DeTable::parse_recoverable(text).0.get_ref().contains_key("feature")
}

/// An array of as many numbers as are wanted: the TOML reader passes over further ones, which a decimal comma makes.
pub(super) fn exactly<'de, D: serde::Deserializer<'de>, const N: usize>(reader: D) -> Result<[f64; N], D::Error> {
    let numbers = Vec::<f64>::deserialize(reader)?;
    let refused =
        |numbers: Vec<f64>| serde::de::Error::custom(format_args!("expected {N} numbers, found {}", numbers.len()));
    numbers.try_into().map_err(refused)
}

/// The same where nothing may be given.
pub(super) fn exactly_or_none<'de, D: serde::Deserializer<'de>, const N: usize>(
    reader: D,
) -> Result<Option<[f64; N]>, D::Error> {
    exactly(reader).map(Some)
}

/// The TOML reader's message, cut off where a key is very long.
pub fn bounded(said: &str) -> String {
    match said.char_indices().nth(LONGEST).and_then(|(end, _)| said.split_at_checked(end)) {
        Some((beginning, _)) => format!("{beginning}…"),
        None => said.to_owned(),
    }
}

/// The TOML reader's message in a user's words: numbers instead of their types, and which key is there twice.
pub fn plain(error: &toml::de::Error, text: &str) -> String {
    let said = error.message().replace("expected f64", "expected a number");
    let said = said.replace("expected u64", "expected a whole number from 0 to 9223372036854775807");
    let said = said.replace(" as i128", "").replace("expected u32", "expected a whole number from 0");
    let key = error
        .span()
        .and_then(|span| text.get(..span.start)?.trim_end().strip_suffix('=')?.split_whitespace().next_back());
    if let Some(key) = key.filter(|_| error.message().contains(" numbers, found ")) {
        return format!("{key}: {said}");
    }
    match error.span().and_then(|span| text.get(span)) {
        Some(key) if said == "duplicate key" => format!("{said} {key}"),
        _ => said,
    }
}

/// The line of a place in a text, from 1.
pub fn line_at(text: &str, offset: usize) -> usize {
    1 + text.bytes().take(offset).filter(|byte| *byte == b'\n').count()
}

/// The character in its line of a place in a text, from 1.
pub fn column_at(text: &str, offset: usize) -> usize {
    let before = text.get(..offset);
    1 + before.map_or(0, |before| before.chars().rev().take_while(|character| *character != '\n').count())
}

/// The line of the key that gave a figure; the first line of the table if the figure was not given.
pub(super) fn line_of(text: &str, kind: &str, what: Figure) -> usize {
    let (table, key) = what.place();
    let table = match table {
        Table::Top => None,
        Table::Probe => Some("probe"),
        Table::Shape => Some(kind),
    };
    let Ok(root) = toml::de::DeTable::parse(text) else { return 1 };
    let root = root.get_ref();
    let place = match table {
        None => root.get(key).map(|value| value.span().start),
        Some(table) => root.get(table).map(|value| {
            let own = value.get_ref().as_table().and_then(|table| table.get(key)).map(|value| value.span().start);
            own.unwrap_or_else(|| value.span().start)
        }),
    };
    place.map_or(1, |place| line_at(text, place))
}
