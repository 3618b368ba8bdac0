//! Rows as a spreadsheet takes them: tab-separated, with the columns' names, exact figures, and the user's decimal sign.

use fitcheck_core::length::{Length, Unit};
use fitcheck_core::message::{Say as _, message};
use fitcheck_core::words::Words;
use fitcheck_exchange::journal::Record;
use fitcheck_exchange::journal::query::{Records as _, TIME, callout};
use fitcheck_exchange::report::csv::harmless;

use super::History;

impl History {
    /// The chosen rows in the order of the list, or the row at which the keys are; `None` where there is neither.
    pub(super) fn copied(&self, words: &Words) -> Option<String> {
        let of_cursor = self.cursor.filter(|id| self.chosen.is_empty() && self.records.place_of(*id).is_some());
        let ids = self.chosen.iter().copied().chain(of_cursor);
        let mut rows: Vec<_> = ids.filter_map(|id| Some((id, self.records.get(id)?))).collect();
        if rows.is_empty() {
            return None;
        }
        self.records.query().arrange(&mut rows);
        let head = |id: &str| words.get(id);
        let with_unit = |id: &str, unit: &str| format!("{} ({unit})", words.get(id));
        let heads = [
            head("head-time"),
            head("head-part"),
            head("head-callout"),
            with_unit("head-measured", "mm"),
            with_unit("head-deviation", "µm"),
            head("head-status"),
            head("head-from"),
        ];
        let lines = rows.iter().map(|(_, record)| cells(record, words));
        Some(std::iter::once(heads).chain(lines).map(|cells| cells.join("\t") + "\n").collect())
    }
}

fn cells(record: &Record, words: &Words) -> [String; 7] {
    // A spreadsheet reads `-12,5` as a number, a true minus sign as text.
    let number =
        |length: Length, unit, decimals| length.exact(unit, decimals).replace('.', &words.decimal_sign().to_string());
    [
        record.time.strftime(TIME).to_string(),
        text(&record.id),
        text(&callout(record)),
        number(record.measurement.diameter, Unit::Millimetre, 3),
        number(record.verdict.size.deviation, Unit::Micrometre, 0),
        status_text(record, words),
        text(&words.say(&record.measurement.origin.message())),
    ]
}

/// A cell that is never computed, and stays one cell.
fn text(text: &str) -> String {
    harmless(&text.replace(char::is_control, " "))
}

/// The verdict's word, as the list shows it; a simulated one says so.
pub fn status_text(record: &Record, words: &Words) -> String {
    let word = words.told(&record.verdict);
    if record.measurement.origin.is_simulated() {
        words.say(&message!("status-simulated").text("status", word))
    } else {
        word
    }
}
