//! The chosen records, as a report and on the clipboard. Only checks of a size that stand are reported; simulated ones only where
//! the user asks for them. What is left out is said.

use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

use fitcheck_core::message::{Message, message};
use fitcheck_core::text::{grouped, long};
use fitcheck_core::words::Words;
use fitcheck_exchange::journal::Record;
use fitcheck_exchange::journal::chain::{ChainId, Head};
use fitcheck_exchange::journal::entry::{Checked, Content};
use fitcheck_exchange::report::Report;
use fitcheck_exchange::report::csv::harmless;
use fitcheck_exchange::series::{EvaluatedSeries, FeatureSeries, Gathering as Gathered, Look};
use jiff::civil::DateTime;

use super::{PAGE, RecordRow, RecordsPage};
use crate::effect::Effect;
use crate::history::status_text;
use crate::shared::Shared;

/// How many of the chosen records a report leaves out, and why.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct LeftOut {
    /// Nobody measured.
    pub simulated: usize,
    /// Corrected or taken back, or a withdrawal itself.
    pub replaced: usize,
    /// What a cycle says by itself.
    pub cycles: usize,
    /// Files that were written, and alarms: no checks.
    pub reports: usize,
    /// Cannot be read.
    pub unread: usize,
}

/// What a report can make of a record.
enum Use {
    Reported(Arc<Record>),
    Simulated(Arc<Record>),
    Replaced,
    Cycle,
    Report,
    Unread,
}

fn use_of(row: &RecordRow) -> Use {
    let Ok(entry) = &row.entry else { return Use::Unread };
    if entry.report().is_some() || entry.alarm().is_some() {
        return Use::Report;
    }
    let Some(check) = entry.check().filter(|_| row.corrected_by.is_none()) else { return Use::Replaced };
    // The record's own name is what its file or field called it; the entry says which part it is.
    let named = |record: &Arc<Record>| match entry.about.name() {
        name if name.is_empty() => Arc::clone(record),
        name => record.called(&name),
    };
    match &check.what {
        Checked::Size(record) if check.is_simulated() => Use::Simulated(named(record)),
        Checked::Size(record) => Use::Reported(named(record)),
        Checked::Cycle(_) => Use::Cycle,
    }
}

/// The most records that are chosen or reported at once: more of them are narrowed by a question first.
pub const MOST_REPORTED: usize = 10_000;

/// What is listed is being read, all of it.
#[derive(Debug)]
pub(super) struct Gathering {
    rows: BTreeMap<u64, Arc<RecordRow>>,
    missing: BTreeSet<u64>,
    /// The format of the report that it is for; `None` to choose it.
    report: Option<usize>,
}

impl RecordsPage {
    /// Reads all that is listed: for a report in a format, or to choose it.
    pub(super) fn gather(&mut self, report: Option<usize>, shared: &mut Shared) -> Vec<Effect> {
        let count = self.listing.count();
        if MOST_REPORTED < count {
            let most = message!("records-page-too-many").text("count", grouped(long(count)));
            shared.tell(most.text("most", grouped(long(MOST_REPORTED))));
            return Vec::new();
        }
        if self.listing.is_stale || !self.listing.is_whole {
            shared.tell(message!("records-page-still-looking"));
            return Vec::new();
        }
        let mut gathering = Gathering { rows: BTreeMap::new(), missing: BTreeSet::new(), report };
        for number in (0..count).filter_map(|place| self.listing.at(place)) {
            match self.listing.row(number) {
                Some(row) => _ = gathering.rows.insert(number, Arc::clone(row)),
                None => _ = gathering.missing.insert(number),
            }
        }
        let missing: Vec<u64> = gathering.missing.iter().rev().copied().collect();
        self.gathering = Some(gathering);
        self.use_gathered(shared);
        missing.chunks(PAGE).map(|numbers| Effect::ReadRecords(numbers.to_vec())).collect()
    }

    /// Takes what was read of what is listed. What was asked for and did not come is asked for again.
    pub(super) fn gather_read(
        &mut self,
        numbers: &[u64],
        result: &Result<Vec<Arc<RecordRow>>, Message>,
        shared: &mut Shared,
    ) -> Vec<Effect> {
        let Some(gathering) = &mut self.gathering else { return Vec::new() };
        let rows = match result {
            Ok(rows) => rows,
            Err(problem) => {
                self.gathering = None;
                shared.tell(message!("records-page-unread").message("why", problem.clone()));
                return Vec::new();
            }
        };
        for row in rows {
            if gathering.missing.remove(&row.head.number) {
                gathering.rows.insert(row.head.number, Arc::clone(row));
            }
        }
        let again: Vec<u64> = numbers.iter().filter(|number| gathering.missing.contains(number)).copied().collect();
        self.use_gathered(shared);
        if again.is_empty() { Vec::new() } else { vec![Effect::ReadRecords(again)] }
    }

    /// Once all is read it is chosen, or its report is asked for.
    fn use_gathered(&mut self, shared: &mut Shared) {
        let Some(Gathering { rows, report, .. }) = self.gathering.take_if(|gathering| gathering.missing.is_empty())
        else {
            return;
        };
        let Some(format) = report else {
            self.chosen.extend(rows);
            return;
        };
        self.gathered = rows;
        if self.reported() == 0 {
            shared.tell(message!("records-page-nothing-to-report"));
        } else {
            self.report_soon = Some(format);
        }
    }

    /// Reports what is chosen, or else what is listed.
    pub(super) fn report_now(&mut self, format: usize, shared: &mut Shared) -> Vec<Effect> {
        if self.chosen.is_empty() {
            return self.gather(Some(format), shared);
        }
        self.report_soon = Some(format);
        Vec::new()
    }

    /// How many records a report would be of, as far as that is known before they are read.
    pub fn to_report(&self) -> usize {
        if self.chosen.is_empty() { self.listing.count() } else { self.reported() }
    }

    /// What a report is of.
    fn for_use(&self) -> &BTreeMap<u64, Arc<RecordRow>> {
        if self.chosen.is_empty() { &self.gathered } else { &self.chosen }
    }

    /// The records that the report has.
    fn rows_for_report(&self) -> impl Iterator<Item = &Arc<RecordRow>> {
        self.for_use().values().filter(|row| match use_of(row) {
            Use::Reported(_) => true,
            Use::Simulated(_) => self.with_simulated,
            _ => false,
        })
    }

    /// Chooses a record, or not; one that was not read cannot be chosen.
    pub(super) fn choose(&mut self, number: u64, is_chosen: bool) {
        match self.listing.row(number).filter(|_| is_chosen) {
            Some(row) => _ = self.chosen.insert(number, Arc::clone(row)),
            None => _ = self.chosen.remove(&number),
        }
    }

    /// How many are chosen.
    pub fn chosen_count(&self) -> usize {
        self.chosen.len()
    }

    /// How many of them a report leaves out.
    pub fn left_out(&self) -> LeftOut {
        let mut out = LeftOut::default();
        for row in self.for_use().values() {
            match use_of(row) {
                Use::Simulated(_) if !self.with_simulated => out.simulated += 1,
                Use::Reported(_) | Use::Simulated(_) => {}
                Use::Replaced => out.replaced += 1,
                Use::Cycle => out.cycles += 1,
                Use::Report => out.reports += 1,
                Use::Unread => out.unread += 1,
            }
        }
        out
    }

    /// How many of the chosen ones are simulated.
    pub fn chosen_simulated(&self) -> usize {
        self.for_use().values().filter(|row| matches!(use_of(row), Use::Simulated(_))).count()
    }

    /// How many records a report has.
    pub fn reported(&self) -> usize {
        let LeftOut { simulated, replaced, cycles, reports, unread } = self.left_out();
        self.for_use().len().saturating_sub(simulated + replaced + cycles + reports + unread)
    }

    /// The records of a report, the oldest first.
    pub(crate) fn for_report(&self) -> Vec<Arc<Record>> {
        let used = self.for_use().values().filter_map(|row| match use_of(row) {
            Use::Reported(record) => Some(record),
            Use::Simulated(record) if self.with_simulated => Some(record),
            _ => None,
        });
        used.collect()
    }

    /// The series of the records of a report: each feature over its values. What a report leaves out is left out and counted here, too.
    pub(crate) fn series(&self) -> EvaluatedSeries {
        let mut gathering = Gathered::default();
        for (number, row) in self.for_use() {
            if let Ok(entry) = &row.entry {
                gathering.take(*number, entry, row.corrected_by.is_some());
            }
        }
        let features: Vec<Arc<FeatureSeries>> = gathering.finish(usize::MAX).into_iter().map(Arc::new).collect();
        let answers = features.iter().map(|feature| feature.evaluate(&Look::default())).collect();
        EvaluatedSeries { features, answers: Arc::new(answers) }
    }

    /// The entries of the records of a report, in the same order.
    pub(crate) fn heads_for_report(&self) -> Vec<Head> {
        self.rows_for_report().map(|row| row.head).collect()
    }

    /// How many of the reported records stand in the place of a corrected one.
    fn corrections(&self) -> usize {
        let checks = self.rows_for_report().filter_map(|row| row.entry.as_ref().ok()?.check());
        checks.filter(|check| check.corrects.is_some()).count()
    }

    /// The chosen records as a report, which says what it leaves out and where its records stand.
    pub(crate) fn report(&self, now: DateTime, journal: Option<(ChainId, Head)>) -> Report {
        let mut report = Report::new(now, self.for_report());
        // A report of checks says nothing of reports: they are none that it could have.
        let LeftOut { simulated, replaced, cycles, reports: _, unread } = self.left_out();
        let with_simulated = if self.with_simulated { self.chosen_simulated() } else { 0 };
        for (id, count) in [
            ("records-page-report-simulated", with_simulated),
            ("records-page-out-simulated", simulated),
            ("records-page-out-replaced", replaced),
            ("records-page-report-corrects", self.corrections()),
            ("records-page-out-cycles", cycles),
            ("records-page-out-unread", unread),
        ] {
            if 0 < count {
                report.notes.push(Message::new(id).count("count", count));
            }
        }
        report.is_partial = 0 < unread;
        if let Some((chain, head)) = journal {
            let all = self.for_use().iter().filter(|(_, row)| !matches!(use_of(row), Use::Report)).map(|(key, _)| key);
            let numbers: Vec<String> = all.clone().take(20).map(u64::to_string).collect();
            let more = if numbers.len() < all.count() { ", …" } else { "" };
            let said = message!("records-page-report-from").text("numbers", numbers.join(", ") + more);
            let said = said.text("chain", chain).text("number", head.number).text("hash", head.hash.short());
            report.notes.push(said);
        }
        report
    }

    /// The chosen rows as a spreadsheet takes them, or the open record, or the row at which the keys are; `None` where there is none.
    pub(super) fn copied(&self, words: &Words) -> Option<String> {
        let cursor = self.open.as_ref().map(|open| open.number).or(self.cursor);
        let one = cursor.and_then(|number| self.listing.row(number)).or_else(|| self.opened_row());
        let rows: Vec<&Arc<RecordRow>> =
            if self.chosen.is_empty() { one.into_iter().collect() } else { self.chosen.values().rev().collect() };
        let heads = [
            "records-page-head-number",
            "head-time",
            "head-part",
            "records-page-serial",
            "records-page-feature",
            "head-callout",
            "head-measured",
            "head-deviation",
            "head-status",
            "records-page-who",
            "records-page-hash",
        ];
        let lines = rows.iter().map(|row| cells(row, words).join("\t") + "\n");
        let heads = heads.map(|id| words.get(id)).join("\t") + "\n";
        (!rows.is_empty()).then(|| std::iter::once(heads).chain(lines).collect())
    }
}

/// The cells of a row, exact.
fn cells(row: &RecordRow, words: &Words) -> [String; 11] {
    let text = |text: &str| harmless(&text.replace(char::is_control, " "));
    let number = row.head.number.to_string();
    let Ok(entry) = &row.entry else {
        let mut cells: [String; 11] = Default::default();
        cells[0] = number;
        return cells;
    };
    let cells = RowTexts::of(row, words);
    [
        number,
        cells.time,
        // A report has no part; its file is what it is called.
        text(entry.report().map_or(&entry.about.part, |report| &report.name)),
        text(&entry.about.serial),
        text(&entry.about.feature),
        text(&cells.callout),
        // A spreadsheet reads `-12,5` as a number, a true minus sign as text.
        cells.measured.replace('\u{2212}', "-"),
        cells.deviation.replace('\u{2212}', "-"),
        text(&cells.status),
        text(&entry.about.who),
        row.head.hash.to_string(),
    ]
}

/// Whether an alarm is open, answered, or the answer to one.
fn alarm_text(row: &RecordRow, words: &Words) -> String {
    let alarm = row.entry.as_ref().ok().and_then(|entry| entry.alarm());
    let answers = alarm.and_then(|alarm| alarm.answer.as_ref()).map(|answer| answer.target.number);
    words.say(&match (answers, row.corrected_by) {
        (Some(number), _) => message!("records-page-alarm-answers").text("number", number),
        (None, Some(number)) => message!("records-page-alarm-answered").text("number", number),
        (None, None) => message!("records-page-alarm"),
    })
}

/// The texts of a row that are the same in the list and on the clipboard.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct RowTexts {
    /// Date and time as the station's clock showed it.
    pub time: String,
    /// The callout; of a cycle its number.
    pub callout: String,
    /// The measured value, exact, mm.
    pub measured: String,
    /// The deviation, exact, µm, with its sign.
    pub deviation: String,
    /// The verdict's word; a simulated one says so. A withdrawal says what it is.
    pub status: String,
}

impl RowTexts {
    /// The texts of a row; empty where it cannot be read.
    pub fn of(row: &RecordRow, words: &Words) -> Self {
        let Ok(entry) = &row.entry else { return Self::default() };
        let time = super::local_time(&entry.about.time);
        let Some(check) = entry.check() else {
            let kind = match &entry.content {
                Content::Report(_) => "records-page-report-entry",
                Content::Alarm(_) => return Self { time, status: alarm_text(row, words), ..Self::default() },
                Content::Begin(_) | Content::Check(_) | Content::Withdrawal(_) => "records-page-withdrawal",
            };
            return Self { time, status: words.get(kind), ..Self::default() };
        };
        match &check.what {
            Checked::Size(record) => Self {
                time,
                callout: fitcheck_exchange::journal::query::callout(record),
                measured: words.mm(record.measurement.diameter, 3),
                deviation: words.signed_um(record.verdict.size.deviation),
                status: status_text(record, words),
            },
            Checked::Cycle(cycle) => {
                let word = cycle.status.map_or_else(|| words.get("word-none"), |status| words.told(&status));
                let simulated = message!("status-simulated").text("status", &word);
                Self {
                    time,
                    callout: words.say(&message!("records-page-cycle").text("cycle", cycle.cycle)),
                    // Not every cycle measures a length.
                    measured: cycle.measured.map_or_else(String::new, |length| words.mm(length, 3)),
                    deviation: String::new(),
                    status: if check.is_simulated() { words.say(&simulated) } else { word },
                }
            }
        }
    }
}
