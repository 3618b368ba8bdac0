//! Values from what a file holds, one thing after another.

use super::value::Value;
use crate::exchange::Item;

/// Takes values from what a file holds.
#[derive(Debug, Default)]
pub struct ValueReader {
    /// The row that a warning was about.
    doubted: Option<usize>,
}

impl ValueReader {
    /// The value of what a file holds, where it has one. A warning about a row comes before the row.
    pub fn take(&mut self, item: &Item) -> Option<Value> {
        match item {
            Item::Record { line, record, labels } => {
                Some(Value::of_record(record, labels, record.doubt.is_some() || self.is_doubted(*line)))
            }
            Item::Unjudged(unjudged) => {
                Some(Value::of_unjudged(unjudged, unjudged.measured?, self.is_doubted(unjudged.line)))
            }
            Item::Warning(warning) => {
                if warning.what.kind.stands_against() {
                    self.doubted = warning.what.row.or(self.doubted);
                }
                None
            }
            Item::Error(_) | Item::Contacts(_) => None,
        }
    }

    fn is_doubted(&self, line: usize) -> bool {
        self.doubted == Some(line)
    }
}
