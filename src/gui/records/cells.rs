//! The texts of a row of the list.

use crate::gui::shapes::Edge;
use crate::gui::table::{Cell, Row, Zoned, joined};
use crate::gui::view::Digits;
use crate::journal::entry::{Check, Checked};
use crate::message::message;
use crate::session::RecordRow;
use crate::session::records::RowTexts;
use crate::verdict::Status;
use crate::words::Words;

/// What is known of a row of the list.
#[derive(Debug, Default)]
pub(super) struct RecordCells {
    pub number: String,
    pub time: String,
    pub part: String,
    pub serial: String,
    pub feature: String,
    pub callout: String,
    pub measured: String,
    pub deviation: String,
    pub zone: Option<Zoned>,
    pub status: String,
    /// The record in whose place it stands.
    pub instead_of: String,
    pub who: String,
    /// The verdict, for colour and shape.
    pub verdict: Option<Status>,
    pub edge: Edge,
    /// Another entry stands in its place, or takes it back.
    pub is_struck: bool,
    /// Whether it is a check that may have a verdict.
    pub is_check: bool,
}

impl RecordCells {
    /// A row that was not read yet.
    pub fn missing(number: u64) -> Self {
        let wait = || "…".to_owned();
        Self {
            number: number.to_string(),
            time: wait(),
            part: wait(),
            callout: wait(),
            measured: wait(),
            status: wait(),
            ..Self::default()
        }
    }

    pub fn of(words: &Words, row: &RecordRow) -> Self {
        let number = row.head.number.to_string();
        let entry = match &row.entry {
            Ok(entry) => entry,
            Err(why) => return Self { number, part: words.say(why), ..Self::default() },
        };
        let RowTexts { time, callout, mut measured, mut deviation, status } = RowTexts::of(row, words);
        let check = entry.check();
        let mut zone = None;
        if let Some(Checked::Size(record)) = check.map(|check| &check.what) {
            let digits = Digits::of(record);
            measured = digits.mm(words, record.measurement.diameter, 3);
            deviation = digits.signed_um(words, record.verdict.size.deviation);
            zone = Some(Zoned::of(record));
        }
        let about = &entry.about;
        let time = if row.went_back { words.say(&message!("records-page-went-back").text("time", time)) } else { time };
        let is_void = row.corrected_by.is_some() && entry.alarm().is_none();
        let status = match (row.corrected_by.filter(|_| is_void), entry.corrects()) {
            (Some(by), _) => words.say(&message!("records-page-see").text("number", by)),
            (None, Some(correction)) if check.is_none() => {
                words.say(&message!("records-page-takes-back").text("number", correction.target.number))
            }
            _ => status,
        };
        Self {
            number,
            time,
            // A report has no part: its file is what it is called.
            part: entry.report().map_or(&about.part, |report| &report.name).clone(),
            serial: about.serial.clone(),
            feature: about.feature.clone(),
            callout,
            measured,
            deviation: if deviation.is_empty() { deviation } else { format!("{deviation} µm") },
            zone,
            status,
            instead_of: entry.corrects().filter(|_| check.is_some()).map_or_else(String::new, |correction| {
                words.say(&message!("records-page-instead").text("number", correction.target.number))
            }),
            who: about.who.clone(),
            verdict: check.and_then(Check::status),
            edge: check.map_or(Edge::None, edge_of),
            is_struck: is_void,
            is_check: check.is_some(),
        }
    }

    /// Its row in the table, behind the choice for a report.
    pub fn into_row(self, words: &Words, number: u64, (is_chosen, can_choose): (bool, bool)) -> Row<u64> {
        let said = self.said(words, is_chosen);
        let name = words.say(&message!("records-page-choose-record").text("number", number));
        let status = if self.is_check && !self.is_struck {
            let Self { verdict: status, edge, status: word, instead_of: beside, .. } = self;
            Cell::Verdict { status, edge, word, beside }
        } else {
            Cell::Text(self.status)
        };
        let texts =
            [self.number, self.time, self.part, self.serial, self.feature, self.callout, self.measured, self.deviation];
        let choice = Cell::Choice { is_chosen, can_choose, name };
        let rest = [Cell::Zone(self.zone), status, Cell::Text(self.who)];
        let cells = std::iter::once(choice).chain(texts.map(Cell::Text)).chain(rest);
        Row::new(number, cells.collect(), said)
    }

    /// What a screen reader says of a row.
    fn said(&self, words: &Words, is_chosen: bool) -> String {
        let number = words.say(&message!("records-page-record").text("number", &self.number));
        let measured = match self.measured.as_str() {
            "" => String::new(),
            "…" => self.measured.clone(),
            measured => format!("{measured} mm"),
        };
        let who = [&number, &self.time, &self.part, &self.serial, &self.feature];
        let what = [&self.callout, &measured, &self.deviation, &self.status, &self.instead_of, &self.who];
        let said = joined(who.into_iter().chain(what));
        if is_chosen { words.say(&message!("history-row-chosen").text("row", said)) } else { said }
    }
}

/// The edge of a check's verdict.
fn edge_of(check: &Check) -> Edge {
    match &check.what {
        Checked::Size(record) => Edge::of(record),
        Checked::Cycle(_) => Edge::of_simulated(check.is_simulated()),
    }
}
