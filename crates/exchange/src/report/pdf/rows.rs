//! The rows of the table: a record in words, and what is special about it.

use fitcheck_core::length::Length;
use fitcheck_core::message::message;
use fitcheck_core::part::{Size, Step};
use fitcheck_core::verdict::{PositionVerdict, Status};
use fitcheck_core::words::Words;

use super::bands::BandShape;
use super::cells::Row;
use crate::journal::Record;
use crate::report::said::{cause, removal_said, undecided};
use crate::report::template::{Column, HeadField, Section};
use crate::report::{Report, origins, picture, text};

/// Makes rows: all sizes of a table have as many decimals, so that their decimal signs stand one below the other.
pub(super) struct Rows<'a> {
    pub words: &'a Words,
    pub decimals: usize,
    pub report: &'a Report,
}

impl Rows<'_> {
    /// A value, without what takes long: for the widths of columns.
    pub fn plain(&self, label: String, record: &Record) -> Row {
        let words = self.words;
        let Record { limits, measurement, verdict, .. } = record;
        let is_simulated = measurement.origin.is_simulated();
        let mut word = words.told(verdict);
        if record.doubt.is_some() {
            word.push_str(" ?");
        }
        if is_simulated {
            word.push('\n');
            word.push_str(&words.get("simulated"));
        }
        let callout = match &record.callout {
            Some(callout) => words.number(&callout.to_string()),
            None => format!("{} mm", words.mm(limits.nominal, 0)),
        };
        Row {
            label,
            status: Some(verdict.status()),
            is_simulated,
            name: record.id.clone(),
            callout,
            minimum: self.mm(limits.minimum()),
            maximum: self.mm(limits.maximum()),
            measured: self.mm(measurement.diameter),
            deviation: words.signed_um(verdict.size.deviation),
            band: None,
            word,
            source: words.told(&measurement.origin),
            instrument: self.instrument(),
            remark: String::new(),
            notes: Vec::new(),
        }
    }

    /// A value.
    pub fn record(&self, label: String, record: &Record) -> Row {
        let said = picture::band_said(record, self.decimals, self.words);
        Row { band: Some((BandShape::of(record), said)), notes: self.notes(record), ..self.plain(label, record) }
    }

    /// A size of a part, with its value where it has one.
    pub fn size(&self, label: &str, size: &Size<'_>, step: &Step, record: Option<&Record>) -> Row {
        let words = self.words;
        let deviations = &size.limits.deviations;
        let of_point =
            || format!("{} / {} µm", words.signed_um(deviations.upper()), words.signed_um(deviations.lower()));
        let callout = size.callout.map_or_else(of_point, |callout| words.number(&callout.to_string()));
        let mut row =
            record.map_or_else(|| self.empty(label, size, step), |record| self.record(label.to_owned(), record));
        row.name = size.name();
        row.callout = callout;
        let remark = &size.feature.remark;
        if self.report.template.columns.contains(&Column::Remark) {
            row.remark.clone_from(remark);
        } else if !remark.is_empty() && self.report.template.has(Section::Remarks) {
            row.notes.push(remark.clone());
        }
        row
    }

    /// A size without a value.
    fn empty(&self, label: &str, size: &Size<'_>, step: &Step) -> Row {
        let words = self.words;
        let left = step.skipped.as_ref();
        let word = if left.is_some() { "parts-page-balloon-skipped" } else { "parts-page-balloon-open" };
        let why = left.map(|why| words.say(&message!("walk-page-skipped").text("reason", why)));
        Row {
            label: label.to_owned(),
            minimum: self.mm(size.limits.minimum()),
            maximum: self.mm(size.limits.maximum()),
            word: words.get(word),
            notes: why.into_iter().collect(),
            ..Row::default()
        }
    }

    /// What every value was measured with, as far as the report says it.
    fn instrument(&self) -> String {
        self.report.given.get(&HeadField::Instrument).cloned().unwrap_or_else(String::new)
    }

    fn mm(&self, length: Length) -> String {
        self.words.mm(length, self.decimals)
    }

    /// What is special about a value: why it is not good and what to do, a correction, a zone of accepted values, the centre.
    fn notes(&self, record: &Record) -> Vec<String> {
        let words = self.words;
        let Record { verdict, .. } = record;
        let mut notes: Vec<String> = Vec::new();
        notes.extend(cause(verdict, words));
        if verdict.size.status != Status::Good || verdict.is_beyond_limits() {
            notes.push(words.say(&text::size(&verdict.size, words)));
        }
        notes.extend(undecided(verdict, words));
        notes.extend(record.doubt.map(|doubt| words.told(&doubt)));
        notes.extend(removal_said(verdict, words));
        notes.extend(verdict.position.map(|position| self.position(position, record)));
        notes.extend(
            record
                .correction
                .map(|correction| self.labelled("report-temperature", &origins::corrected(&correction, words))),
        );
        if let Some(decision) = record.decision() {
            let mut said = origins::accepted(&decision, words);
            if let Some(proof) = origins::proof(&decision, words) {
                said = format!("{said}; {proof}");
            }
            notes.push(self.labelled("report-accepted", &said));
        }
        notes
    }

    fn position(&self, position: PositionVerdict, record: &Record) -> String {
        let words = self.words;
        let mut said = words.say(&text::position(Some(position)));
        for (name, axis) in ["X", "Y"].iter().zip(&position.axes) {
            said = format!("{said}; {}", words.say(&text::axis(name, axis, words)));
        }
        if let Some([x, y]) = record.measurement.centre {
            let centre = message!("report-centre").text("x", words.mm(x, 3)).text("y", words.mm(y, 3));
            said = format!("{said}; {}", words.say(&centre));
        }
        self.labelled("report-position", &said)
    }

    fn labelled(&self, label: &str, said: &str) -> String {
        format!("{}: {said}", self.words.get(label))
    }
}
