//! How commands and news change the records page, and what the journal answers.

use std::ops::Range;
use std::path::PathBuf;
use std::sync::Arc;

use fitcheck_core::message::{Message, message};
use fitcheck_exchange::journal::Record;
use fitcheck_exchange::journal::chain::Head;
use fitcheck_exchange::journal::entry::{Check, Checked, Reported};
use jiff::civil::DateTime;

use super::{OpenRecord, RecordRow, RecordsCommand, RecordsField, RecordsPage};
use crate::Step;
use crate::command::Command;
use crate::effect::Effect;
use crate::page::Page;
use crate::recording::{OpenJournal, RESTORED};
use crate::saved::Saved;
use crate::shared::{News, Shared};
use crate::state::PageState;

impl PageState for RecordsPage {
    type Command = RecordsCommand;
    type Field = RecordsField;

    fn restored(_saved: &Saved, _shared: &Shared) -> Self {
        Self::default()
    }

    fn apply(&mut self, command: RecordsCommand, shared: &mut Shared, _now: DateTime) -> Vec<Effect> {
        match command {
            RecordsCommand::Type(field, text) => self.type_text(field, text, shared),
            RecordsCommand::Begin { usual, station, zone } => {
                shared.recording.zone = Some(zone);
                begin(usual, station, shared);
            }
            RecordsCommand::Opened(result) => self.journal_opened(result, shared),
            RecordsCommand::Kept { run, result } => self.kept(run, result, shared),
            RecordsCommand::TryAgain => {
                shared.notices.retain(|notice| !notice.records);
                shared.recording.try_again();
            }
            RecordsCommand::Measured { name, sha256 } => shared.recording.saw(name, sha256),
            RecordsCommand::Reported(report) => report_written(*report, shared),
            command @ (RecordsCommand::Sent { .. }
            | RecordsCommand::AskForServer(_)
            | RecordsCommand::TakeServer
            | RecordsCommand::LeaveServer
            | RecordsCommand::SendAgain
            | RecordsCommand::Server(_)) => return self.apply_server(command, shared),
            RecordsCommand::Note(note) => shared.note(note, Vec::new()),
            RecordsCommand::UseName(name) => shared.recording.use_name(&name),
            RecordsCommand::TakeName => {
                shared.recording.use_name(self.text(RecordsField::Who));
                self.texts.remove(&RecordsField::Who);
            }
            RecordsCommand::Toggle(shorthand) => self.toggle(shorthand, shared),
            RecordsCommand::RemoveFilter(word) => self.remove(&word, shared),
            RecordsCommand::AskForFilter(is_filtering) => {
                self.is_filtering = is_filtering;
                let focus = is_filtering.then_some(Effect::Focus(RecordsField::Filter.into()));
                return focus.into_iter().collect();
            }
            RecordsCommand::FilterBy(key) => self.filter_key = Some(key),
            RecordsCommand::AddFilter => self.add_filter(shared),
            RecordsCommand::AskAgain => self.ask(shared, false),
            RecordsCommand::See(places) => {
                let pages = self.listing.see(&places).into_iter();
                return pages.map(Effect::ReadRecords).collect();
            }
            RecordsCommand::Found { run, result } => self.found(run, result),
            RecordsCommand::Read { numbers, result } => {
                let gathered = self.gather_read(&numbers, &result, shared);
                self.read(numbers, result);
                self.correct_now(shared);
                return gathered;
            }
            RecordsCommand::ReportsRead { number, result } => self.reports_read(number, result),
            RecordsCommand::Move(step) => self.step(step),
            RecordsCommand::Open(number) => return self.open(number),
            RecordsCommand::CloseRecord => {
                self.open = None;
                self.correcting = None;
            }
            RecordsCommand::Choose(number, is_chosen) => self.choose(number, is_chosen),
            RecordsCommand::ChooseAll => return self.gather(None, shared),
            RecordsCommand::Report(format) => return self.report_now(format, shared),
            RecordsCommand::ChooseNone => self.chosen.clear(),
            RecordsCommand::WithSimulated(with) => self.with_simulated = with,
            RecordsCommand::Copy => return self.copied(&shared.report_words()).map(Effect::Copy).into_iter().collect(),
            RecordsCommand::MeasureAgain => self.measure_again(shared),
            RecordsCommand::Correct(is_open) => self.correct(is_open, shared),
            RecordsCommand::CorrectNumber(number) => return self.correct_number(number, shared),
            RecordsCommand::ChooseFeature(feature) => self.mean(feature, shared),
            RecordsCommand::Withdraw(withdraws) => self.withdraw(withdraws),
            RecordsCommand::SendCorrection => self.send_correction(shared),
            command @ (RecordsCommand::Verify
            | RecordsCommand::CancelVerify
            | RecordsCommand::Verifying { .. }
            | RecordsCommand::Verified { .. }) => return self.walk_on(command),
        }
        Vec::new()
    }

    fn follow(&mut self, news: &News, shared: &mut Shared) {
        match news {
            // What was recorded meanwhile, here and elsewhere.
            News::Opened(Page::Records) => self.ask(shared, false),
            News::ShowRecord(number) => {
                let effects = self.open(*number);
                self.errands.extend(effects);
            }
            News::UndoCorrection(new) => self.undo_correction(*new, shared),
            _ => {}
        }
    }

    fn take_errands(&mut self) -> Vec<Effect> {
        std::mem::take(&mut self.errands)
    }

    fn text(&self, field: RecordsField) -> &str {
        self.texts.get(&field).map_or("", String::as_str)
    }

    fn error(&self, field: RecordsField) -> Option<&Message> {
        self.errors.get(&field)
    }

    fn culprit(&self, field: RecordsField) -> Option<&Range<usize>> {
        self.culprit.as_ref().filter(|_| field == RecordsField::Question)
    }

    fn closes(&self) -> Option<Command> {
        self.leaves_form().or_else(|| self.open.as_ref().map(|_| RecordsCommand::CloseRecord.into()))
    }

    fn is_free_text(&self, field: RecordsField) -> bool {
        !matches!(field, RecordsField::Measured | RecordsField::Callout)
    }
}

impl RecordsPage {
    /// Closes the form of a correction, where it is open.
    pub(crate) fn leaves_form(&self) -> Option<Command> {
        self.correcting.as_ref().map(|_| RecordsCommand::Correct(false).into())
    }

    fn type_text(&mut self, field: RecordsField, text: String, shared: &Shared) {
        self.texts.insert(field, text);
        self.errors.remove(&field);
        match field {
            RecordsField::Question => self.ask(shared, true),
            RecordsField::Callout => self.read_callout(shared),
            _ => {}
        }
    }

    /// The journal is open: its newest checks stand in the history, as if the window had never been closed.
    fn journal_opened(&mut self, result: Result<(Box<OpenJournal>, Vec<RecordRow>), Message>, shared: &mut Shared) {
        match result {
            Ok((journal, rows)) => {
                for remark in &journal.remarks {
                    shared.note(remark.clone(), Vec::new());
                }
                let is_first = shared.recording.journal.is_none();
                shared.recording.opened(Ok(*journal));
                if is_first {
                    shared.recording.know_parts(rows.iter().filter_map(|row| row.entry.as_ref().ok()));
                    let stand: Vec<_> = rows.iter().filter_map(standing).collect();
                    let ids = shared.history.restore(stand.iter().map(|(_, record)| Arc::clone(record)).collect());
                    shared.recording.know(ids.into_iter().zip(stand.iter().map(|(number, _)| *number)));
                }
                if shared.page == Page::Records {
                    self.ask(shared, false);
                }
            }
            Err(problem) => {
                shared.tell_of_records(message!("records-page-not-opened").message("why", problem.clone()));
                shared.recording.opened(Err(problem));
            }
        }
        shared.spread(News::Journal);
    }

    /// The journal has answered about entries.
    fn kept(&mut self, run: u64, result: Result<Vec<Head>, Message>, shared: &mut Shared) {
        let problem = result.as_ref().err().cloned();
        shared.spread(News::Kept(run, problem.is_none()));
        let is_failure = shared.recording.kept(run, result);
        if let Some(name) = shared.recording.unknown_report(run) {
            let why = problem.unwrap_or_else(|| message!("records-page-not-kept-why"));
            return shared.tell(message!("records-page-report-unknown").text("name", name).message("why", why));
        }
        shared.go_on_undoing();
        let count = shared.recording.failed();
        if is_failure && 0 < count {
            let why = problem.unwrap_or_else(|| message!("records-page-not-kept-why"));
            let told = match shared.recording.not_withdrawn(run) {
                Some((records, numbers)) => {
                    message!("records-page-not-withdrawn").count("records", records).text("numbers", numbers)
                }
                None => message!("records-page-not-kept").count("count", count),
            };
            shared.tell_of_records(told.message("why", why));
        }
        if let Some((told, numbers)) = shared.recording.withdrawn(run) {
            shared.note(told, Vec::new());
            self.withdrawn(&numbers, shared);
        }
        self.correction_kept(run, shared);
    }

    /// Undo has withdrawn records: what is listed and open shows it.
    fn withdrawn(&mut self, numbers: &[u64], shared: &Shared) {
        for number in numbers {
            self.listing.forget(*number);
            self.chosen.remove(number);
        }
        if let Some(open) = self.open.as_ref().map(|open| open.number).filter(|open| numbers.contains(open)) {
            let effects = self.open(open);
            self.errands.extend(effects);
        }
        if shared.page == Page::Records {
            self.ask(shared, false);
        }
    }

    fn found(&mut self, run: u64, result: Result<super::FoundNumbers, Message>) {
        if run != self.asks {
            return;
        }
        match result {
            Ok(found) => {
                let is_first = self.listing.is_stale;
                self.listing.take(found);
                self.look += u64::from(is_first);
            }
            Err(problem) => self.listing.refuse(problem),
        }
    }

    fn read(&mut self, numbers: Vec<u64>, result: Result<Vec<Arc<RecordRow>>, Message>) {
        if let Some(open) = self.open.as_mut().filter(|open| open.row.is_none() && numbers.contains(&open.number)) {
            open.row = match &result {
                Ok(rows) => rows.iter().find(|row| row.head.number == open.number).cloned().map(Ok),
                Err(problem) => Some(Err(problem.clone())),
            };
        }
        self.read_corrector(result.iter().flatten());
        let corrected: Vec<u64> = {
            let entries = result.iter().flatten().filter_map(|row| row.entry.as_ref().ok());
            entries.filter_map(|entry| entry.corrects()).map(|correction| correction.target.number).collect()
        };
        // What is chosen is reported as it stands now.
        for row in result.iter().flatten() {
            if let Some(chosen) = self.chosen.get_mut(&row.head.number) {
                chosen.clone_from(row);
            }
        }
        self.listing.take_rows(numbers, result);
        for number in corrected {
            let is_old = |row: &Arc<RecordRow>| row.corrected_by.is_none();
            if self.listing.row(number).is_some_and(is_old) {
                self.listing.forget(number);
            }
            if self.chosen.get(&number).is_some_and(is_old) {
                self.chosen.remove(&number);
            }
        }
    }

    /// Moves the cursor. One that is not in the list counts as before its first row.
    fn step(&mut self, step: Step) {
        let Some(last) = self.listing.count().checked_sub(1) else { return };
        let here = self.cursor.and_then(|number| self.listing.place_of(number));
        self.cursor = self.listing.at(step.place(here, last));
        self.look += 1;
    }

    /// Opens a record; what was not read yet is asked for.
    pub(super) fn open(&mut self, number: u64) -> Vec<Effect> {
        let row = self.listing.row(number).map(|row| Ok(Arc::clone(row)));
        let mut effects = if row.is_none() { vec![Effect::ReadRecords(vec![number])] } else { Vec::new() };
        effects.push(Effect::ReadReports(number));
        self.cursor = Some(number);
        self.look += 1;
        self.open = Some(OpenRecord { number, row, by: None, asks_by: false, reports: Ok(Vec::new()) });
        self.correcting = None;
        self.corrects_soon = false;
        self.read_corrector(std::iter::empty());
        effects
    }

    /// Which reports show the open record.
    fn reports_read(&mut self, number: u64, result: Result<Vec<Arc<RecordRow>>, Message>) {
        if let Some(open) = self.open.as_mut().filter(|open| open.number == number) {
            open.reports = result;
        }
    }

    /// Why a record stands no longer is said by the entry that takes it back: it is read with it.
    fn read_corrector<'a>(&mut self, mut rows: impl Iterator<Item = &'a Arc<RecordRow>>) {
        let Some(by) = self.opened_row().and_then(|row| row.corrected_by) else { return };
        let read = rows.find(|row| row.head.number == by).or_else(|| self.listing.row(by)).map(Arc::clone);
        let Some(open) = self.open.as_mut().filter(|open| open.by.is_none()) else { return };
        match read {
            Some(row) => open.by = Some(row),
            None if !std::mem::replace(&mut open.asks_by, true) => self.errands.push(Effect::ReadRecords(vec![by])),
            None => {}
        }
    }

    /// Whether the open record asked for a size that can be measured again.
    pub fn can_measure_again(&self) -> bool {
        let check = self.opened_row().and_then(|row| row.entry.as_ref().ok()?.check());
        check.is_some_and(|check| matches!(check.what, Checked::Size(_)))
    }

    fn measure_again(&self, shared: &mut Shared) {
        let Some(entry) = self.opened_row().and_then(|row| row.entry.as_ref().ok()) else { return };
        let Some(Check { what: Checked::Size(record), .. }) = entry.check() else { return };
        shared.spread(News::MeasureAgain {
            record: Arc::clone(record),
            part: entry.about.part.clone(),
            serial: entry.about.serial.clone(),
        });
        shared.open(Page::Check);
    }
}

/// A check that the history shows: a size that no other entry corrects or takes back.
fn standing(row: &RecordRow) -> Option<(u64, Arc<Record>)> {
    let check = row.entry.as_ref().ok()?.check().filter(|_| row.corrected_by.is_none())?;
    match &check.what {
        Checked::Size(record) => {
            let part = &row.entry.as_ref().ok()?.about.part;
            let named = if record.id.is_empty() { record.called(part) } else { Arc::clone(record) };
            Some((row.head.number, named))
        }
        Checked::Cycle(_) => None,
    }
}

/// A report is whole on disk: the journal is told of it, or the user why not.
fn report_written(report: Reported, shared: &mut Shared) {
    let name = report.name.clone();
    if let Some(why) = shared.recording.keep_report(report) {
        shared.tell(message!("records-page-report-unknown").text("name", name).message("why", why));
    }
}

/// Recording begins; the history keeps room for what is restored.
fn begin(usual: Option<PathBuf>, station: String, shared: &mut Shared) {
    shared.recording.begin(usual, station);
    if shared.recording.is_on() {
        shared.history.leave_room(RESTORED);
    }
    shared.spread(News::Journal);
}
