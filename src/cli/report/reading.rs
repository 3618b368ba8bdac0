//! The checks of files and options: what a first look finds, and every look after it.

use std::io;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use jiff::civil::DateTime;

use super::super::admitted::Admits as _;
use super::super::judging::{Judge, Sizes, Warned};
use super::super::measured::{Measured, unreadable};
use super::super::progress::{Watched, Work, stopped};
use super::super::said::{CliRemark, warning};
use super::super::{CliError, Io, Outcome};
use super::part::ReportParts;
use crate::exchange::{self, ByPlan, Item, import_from};
use crate::files::{self, FileError};
use crate::journal::Record;
use crate::message::{Message, Say as _, message};
use crate::part::Plan;
use crate::report::Checks;
use crate::report::csv::More;
use crate::report::part::PartSheet;
use crate::tolerance::Sources;
use crate::verdict::Status;

/// The most notes on a report; all of them are on standard error.
const MOST_NOTES: usize = 1_000;

/// The checks of files and options. The files are read again for every look at the checks, so that they may be of any size.
#[derive(Debug)]
pub(super) struct ReportChecks {
    pub(super) files: Vec<(PathBuf, Measured, Work)>,
    /// From options.
    pub(super) typed: Vec<Record>,
    pub(super) sources: Sources,
    pub(super) now: DateTime,
    pub(super) judge: Judge,
    pub(super) plan: Option<Arc<Plan>>,
    /// Whether a value was brought to 20 °C, here or before.
    pub(super) are_corrected: bool,
}

impl ReportChecks {
    fn read(&self, (path, file, work): (&Path, &Measured, &Work), take: &mut dyn FnMut(Item)) {
        let beside = |ending: &str| files::beside(path, ending);
        let has_plan = self.plan.is_some();
        let temperature = self.judge.temperature();
        let usual = exchange::ImportInputs::new(&self.sources, self.now);
        let given = exchange::ImportInputs { beside: &beside, has_plan, temperature, ..usual };
        let by_plan = self.plan.as_deref().map(ByPlan::new);
        let mut take = |item: Item| {
            // What comes after the wish to stop is what it broke.
            if work.is_stopped() {
                return;
            }
            if item.is_row() {
                work.row();
            }
            match &by_plan {
                Some(by_plan) => by_plan.item(item, take),
                None => take(item),
            }
        };
        file.read(|body| import_from(&name(path), &mut Watched::new(body, work), given, &mut take));
    }

    /// How many rows were done, where Ctrl+C ended it.
    pub(super) fn stopped(&self) -> Option<CliError> {
        let is_stopped = self.files.iter().any(|(.., work)| work.is_stopped());
        is_stopped.then(|| CliError::Stopped { rows: self.files.iter().map(|(.., work)| work.rows()).sum() })
    }
}

/// The name of a file without its folder.
pub(super) fn name(path: &Path) -> String {
    files::name_of(path).to_string_lossy().into_owned()
}

impl Checks for ReportChecks {
    fn each(&self, see: &mut dyn FnMut(&Record) -> io::Result<()>) -> io::Result<()> {
        let sizes = Sizes::of(self.plan.as_deref());
        for (path, file, work) in &self.files {
            let mut seen = Ok(());
            work.again(&name(path));
            self.read((path, file, work), &mut |item| {
                // A file that cannot be read to its end the second time would leave out checks that the first look has counted.
                if let Some(error) = unreadable(path, &item) {
                    seen = Err(io::Error::other(error.to_string()));
                }
                // What cannot be judged was noted at the first look.
                if seen.is_ok()
                    && let Item::Record { record, labels, .. } = item
                    && let Ok((record, _said)) = self.judge.judged_of(&sizes, *record, &labels)
                {
                    seen = see(&record);
                }
            });
            seen?;
            if work.is_stopped() {
                return Err(stopped());
            }
            work.line().end();
            if !file.is_unchanged() {
                return Err(io::Error::other(FileError::Changed { path: path.clone() }.to_string()));
            }
        }
        self.typed.iter().try_for_each(see)
    }

    /// One way judges all of them, and the files may say that their values were corrected.
    fn more(&self) -> io::Result<More> {
        Ok(self.judge.more_of(self.plan.as_deref()).with(More::CORRECTED, self.are_corrected))
    }
}

/// What a first look at the checks finds, and what did not become a check.
#[derive(Debug, Default)]
pub(super) struct Collected {
    pub(super) worst: Option<Status>,
    /// How many there are.
    pub(super) checks: u64,
    /// The worst of the checks that are of no file: with a plan they are of no part.
    worst_typed: Option<Status>,
    /// What the parts make of the exit code, with a plan.
    outcome: Option<Outcome>,
    pub(super) notes: Vec<Message>,
    more_notes: usize,
    /// The part and the serial number of every value so far, where they are the same.
    one: Option<(String, String)>,
    /// How many values wait for hole or shaft.
    open: usize,
    pub(super) bad: bool,
    /// Whether parts are not shown as a whole.
    has_more_parts: bool,
    warned: Warned,
    /// Whether a value was brought to 20 °C, here or before.
    pub(super) are_corrected: bool,
    /// The whole parts, with a plan.
    pub(super) parts: Option<ReportParts>,
}

impl Collected {
    /// Looks at a file of measurements, which the system has to read to its end.
    pub(super) fn file(
        &mut self,
        (path, file, work): (&Path, &Measured, &Work),
        given: &ReportChecks,
        io: &mut Io<'_>,
    ) -> Result<(), FileError> {
        let mut read = Ok(());
        let name = &name(path);
        let line = |line: usize| message!("report-note-line").text("place", name).text("line", line);
        let sizes = Sizes::of(given.plan.as_deref());
        given.read((path, file, work), &mut |item| match item {
            Item::Record { record, line: at, labels } => match given.judge.judged_of(&sizes, *record, &labels) {
                Ok((record, said)) => {
                    for remark in &said {
                        self.note(line(at), remark.message(), io);
                    }
                    let of = (labels.part.clone(), labels.serial.clone());
                    self.one = if self.checks == 0 { Some(of) } else { self.one.take().filter(|one| *one == of) };
                    self.see(&record, io);
                    self.parts.iter_mut().for_each(|parts| parts.see(&record, &labels, at));
                }
                Err(error) => self.refuse(line(at), error.message(), io),
            },
            Item::Unjudged(unjudged) => self.refuse(line(unjudged.line), unjudged.why.message(), io),
            Item::Error(ref error) => match unreadable(path, &item) {
                Some(error) => read = Err(error),
                None => self.refuse(message!("report-note").text("place", name), error.message(), io),
            },
            Item::Warning(warning) => {
                if warning.what.kind.wants_a_look() {
                    io.look_first();
                }
                let place = warning.place.line.map_or_else(|| message!("report-note").text("place", name), line);
                self.note(place, warning.what.message(), io);
            }
            Item::Contacts(_) => {}
        });
        read
    }

    /// The whole parts, and the name of the part that the plan is of. What keeps them from being complete is told.
    /// `is_form` is a sheet that is filled in by hand, for a part that nobody has measured, too.
    pub(super) fn end_parts(&mut self, is_form: bool, io: &mut Io<'_>) -> (Vec<PartSheet>, Option<String>) {
        let Some(parts) = self.parts.take() else { return (Vec::new(), None) };
        if let Some(why) = parts.unseen() {
            io.tell(warning(why));
        }
        let name = Some(parts.plan.head.part.clone()).filter(|name| !name.is_empty());
        if is_form && parts.is_empty() {
            return (vec![parts.unmeasured()], name);
        }
        self.outcome = Some(parts.outcome(self.worst_typed));
        for contradiction in parts.contradictions() {
            io.look_first();
            io.tell(warning(&contradiction));
            self.notes.push(contradiction);
        }
        let (sheets, more) = parts.end(io);
        self.has_more_parts = more.is_some();
        self.notes.extend(more);
        (sheets, name)
    }

    pub(super) fn see(&mut self, record: &Record, io: &mut Io<'_>) {
        self.warned.see(record, io);
        if record.doubt.is_some() || record.measurement.origin.is_simulated() {
            io.look_first();
        }
        self.are_corrected |= record.correction.is_some();
        self.open += usize::from(record.is_open());
        self.worst = self.worst.max(Some(record.verdict.status()));
        self.checks = self.checks.saturating_add(1);
    }

    /// A check from an option.
    pub(super) fn see_typed(&mut self, record: &Record, io: &mut Io<'_>) {
        self.see(record, io);
        self.worst_typed = self.worst_typed.max(Some(record.verdict.status()));
    }

    /// The part and the serial number of all values; nothing where other values stand beside them.
    pub(super) fn one_part(&mut self, has_others: bool) -> (Option<String>, String) {
        let one = self.one.take().filter(|_| !has_others);
        one.map_or_else(Default::default, |(part, serial)| (Some(part).filter(|part| !part.is_empty()), serial))
    }

    /// Says how hole or shaft is said where it decides; of a plan's size the plan has said it.
    pub(super) fn tell_open(&self, has_plan: bool, io: &mut Io<'_>) {
        if 0 < self.open && !has_plan {
            io.remark(&CliRemark::Open { count: self.open });
        }
    }

    /// The outcome of the report; `None` where nothing was judged.
    pub(super) fn outcome(&self) -> Option<Outcome> {
        let judged = Outcome::Judged(self.worst?);
        Some(if self.bad { Outcome::BadData } else { self.outcome.unwrap_or(judged) })
    }

    /// Whether something was refused or not judged, or is not known of every part.
    pub(super) const fn is_partial(&self) -> bool {
        self.bad || self.has_more_parts
    }

    /// The notes of the report; the last one says how many more there are.
    pub(super) fn notes(self) -> Vec<Message> {
        let more = (0 < self.more_notes).then(|| message!("report-note-more").count("count", self.more_notes));
        self.notes.into_iter().chain(more).collect()
    }

    /// Notes what is not a check, so that nobody takes the report for complete.
    pub(super) fn refuse(&mut self, place: Message, what: Message, io: &mut Io<'_>) {
        self.bad = true;
        self.note(place, what, io);
    }

    /// Puts a sentence on the report, and in English on standard error.
    fn note(&mut self, place: Message, what: Message, io: &mut Io<'_>) {
        let note = place.message("what", what);
        io.fail(&note);
        if self.notes.len() < MOST_NOTES {
            self.notes.push(note);
        } else {
            self.more_notes += 1;
        }
    }
}
