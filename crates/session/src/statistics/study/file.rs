//! The readings of a file, with what is to be said of them.

use std::collections::BTreeSet;

use fitcheck_core::message::{Located, Message, Say as _, message};
use fitcheck_exchange::exchange::Item;
use fitcheck_exchange::series::{Value, ValueReader, names_are_parts};

/// The readings of a file.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct StudyFile {
    /// Its name without the folder.
    pub name: String,
    pub values: Vec<Value>,
    /// The features that it names.
    pub features: BTreeSet<String>,
    /// What was not used, and what to check.
    pub notes: Vec<Message>,
}

impl StudyFile {
    /// The readings of what a file holds. A name that stands alone is that of the part.
    pub fn of(name: &str, items: &[Item]) -> Self {
        let mut file = Self { name: name.to_owned(), ..Self::default() };
        let mut reader = ValueReader::default();
        for item in items {
            let value = reader.take(item);
            file.notes.extend(note(item, value.is_some()));
            file.values.extend(value);
        }
        names_are_parts(&mut file.values);
        file.features = file.values.iter().map(|value| value.name.clone()).filter(|name| !name.is_empty()).collect();
        file
    }
}

/// What is to be said of what a file holds.
fn note(item: &Item, is_value: bool) -> Option<Message> {
    match item {
        Item::Record { line, record, .. } => record.doubt.map(|doubt| Located::in_line(*line, doubt).message()),
        Item::Unjudged(unjudged) => {
            (!is_value).then(|| Located::in_line(unjudged.line, unjudged.why.clone()).message())
        }
        Item::Error(error) => Some(error.message()),
        Item::Warning(warning) => Some(warning.message()),
        Item::Contacts(_) => Some(message!("columns-page-no-measured")),
    }
}
