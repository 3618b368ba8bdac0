//! `fitcheck watch`: files are judged and recorded as they are dropped into a folder.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use super::import::{ImportRow, Printer, Rows};
use super::judging::{Judge, JudgeArgs};
use super::parts::PlanParts;
use super::record::{Stream, StreamArgs};
use super::said::{CliWarning, about, warning};
use super::{CliError, CliRemark, Format, Io, Outcome, TableArgs};
use crate::journal::body;
use crate::journal::entry::{Checked, Content, Entry, FileRole, UsedFile};
use crate::journal::found::FoundEntry;
use crate::message::{Located, Message, Say as _, message};
use crate::verdict::Status;
use crate::watch::{Alone, Batch, EVERY, FileJudging, FolderScan, TakenFiles, Waiting, Watcher};

/// How long after a journal that refused it is tried again.
const LATER: Duration = Duration::from_secs(1);

const EXAMPLES: &str = "\
Each file is imported once, and never half-written, in the order in which the files were written. It is recorded in \
the journal with its SHA-256, so a restart, another name or another folder imports no value twice. Files of lines \
(CSV, measuring logs, AQDEF) may grow: the new lines are imported. Files stay where they are. What cannot be read or \
judged is reported in a text file beside it, NAME.why.txt. Subfolders, hidden files and names such as .tmp and .part \
are not read; a .dfd is read with its .dfx.

Examples:
  fitcheck watch /srv/measured --plan flange.toml --who Anna
  fitcheck watch /srv/measured --until-idle 2 --format csv > /srv/verdicts.csv

The exit code is that of the worst verdict, a centre out of position counting as scrap; it is 1 if a row or file \
could not be used or judged, and 14 (judged, but look first: see fitcheck --help) instead of 0, 10 or 12 if something \
contradicts a verdict or a file was not recorded because it has the bytes of another.";

/// Judge and record files as they are dropped into a folder
#[derive(Debug, clap::Args)]
#[command(after_help = EXAMPLES)]
pub(super) struct Args {
    /// The folder
    #[arg(value_name = "FOLDER")]
    folder: PathBuf,

    /// Judge by a part plan: values are matched to features by name, number or location; the plan's limits and rule apply
    #[arg(long, value_name = "PLAN")]
    plan: Option<PathBuf>,

    /// End after this many seconds without a new file, once nothing is pending; default: run until stopped
    #[arg(long, value_name = "S")]
    until_idle: Option<f64>,

    /// Format of the verdicts
    #[arg(long, value_enum, default_value_t = Format::Text)]
    format: Format,

    /// Masks of a control: text that one of them printed with FN 16 is read back through it
    #[arg(long = "mask", value_name = "FILE.a")]
    masks: Vec<PathBuf>,

    #[command(flatten)]
    tables: TableArgs,

    #[command(flatten)]
    by: JudgeArgs,

    #[command(flatten)]
    record: StreamArgs,
}

/// What a run of it has.
struct Run<'a> {
    judging: FileJudging<'a>,
    judge: &'a Judge,
    journal: Stream,
    printer: Printer,
    worst: Option<Status>,
    is_bad: bool,
    /// The parts of the plan: without a serial number each file is one.
    parts: Option<PlanParts>,
    /// What was told of values that contradict each other.
    contradictions: BTreeSet<String>,
}

impl Args {
    pub(super) fn run(&self, io: &mut Io<'_>) -> Result<Outcome, CliError> {
        let duration = |seconds: f64| {
            Duration::try_from_secs_f64(seconds).map_err(|_range| CliError::NotSeconds { given: seconds.to_string() })
        };
        let idle = self.until_idle.map(duration).transpose()?;
        let sources = self.tables.load(io)?;
        let plan = self.plan.as_ref().map(|path| super::plan::read_plan(path, &sources, io)).transpose()?;
        let masks = self.masks.iter().map(|path| super::import::mask(path, io)).collect::<Result<Vec<_>, _>>()?;
        let judge = self.by.judge(io)?;
        judge.tell(io);
        judge.tell_rule(io);
        if !self.folder.is_dir() {
            return Err(CliError::NoFolder { path: self.folder.clone() });
        }
        let part = plan.as_ref().map(|plan| plan.head.part.as_str());
        let journal = self.record.stream(part, io)?;
        let alone = Alone::take(&self.folder, journal.file());
        match &alone {
            Ok(Some(_)) => {}
            Ok(None) => return Err(CliError::WatchedAlready { path: self.folder.clone() }),
            // Some shares have no locks.
            Err(error) => io.warn(&CliWarning::NotAlone { reason: error.to_string() }),
        }
        let mut parts = plan.as_ref().map(PlanParts::of_stream);
        let known = before(&journal, parts.as_mut())?;
        io.note(CliRemark::Watching { folder: self.folder.display().to_string(), known: known.count() });
        let printer = Printer::new(self.format, judge.more_of(plan.as_ref()), io);
        let plan = plan.as_ref();
        let sources = &sources;
        let masks = masks.as_slice();
        let now = super::now();
        let judging = FileJudging { plan, sources, masks, columns: None, now, temperature: None };
        let judge = &judge;
        let worst = None;
        let is_bad = false;
        let contradictions = BTreeSet::new();
        let mut run = Run { judging, judge, journal, printer, worst, is_bad, parts, contradictions };
        let mut watcher = Watcher::new(&self.folder, known);
        leave_own(&mut watcher, run.journal.file(), alone.as_ref().ok().and_then(Option::as_ref));
        run.watch(&mut watcher, idle, io)?;
        run.printer.end(io);
        run.journal.rest(io);
        Ok(match run.worst {
            _ if run.is_bad => Outcome::BadData,
            Some(worst) => Outcome::Judged(worst),
            None => Outcome::Done,
        })
    }
}

/// What the journal has: the files that were taken, and the values of the plan's parts, which later ones may contradict.
fn before(journal: &Stream, parts: Option<&mut PlanParts>) -> Result<TakenFiles, CliError> {
    let mut known = TakenFiles::default();
    let mut replaced = BTreeSet::new();
    let has_plan = parts.is_some();
    journal.each(&mut |_, body| {
        known.see(body);
        // What cannot be read is what `journal verify` is there for.
        if has_plan && let Ok(Some(FoundEntry { corrects: Some(number), .. })) = body::found(body) {
            replaced.insert(number);
        }
    })?;
    let Some(parts) = parts else { return Ok(known) };
    journal.each(&mut |number, body| {
        let is_of_plan = body::found(body).is_ok_and(|found| found.is_some_and(|found| parts.has(&found.feature)));
        if !is_of_plan || replaced.contains(&number) {
            return;
        }
        let Ok(Entry { about, content: Content::Check(check) }) = body::read(body) else { return };
        let Checked::Size(record) = &check.what else { return };
        let file = check.files.iter().find(|file| file.role == FileRole::Measurements);
        let part = journal.part_of(&about, file.map_or("", |file| &file.name));
        parts.see_of(part, record, None, Some(record.time));
    })?;
    Ok(known)
}

/// Leaves alone what this program itself writes: the journal, and what its output goes to.
fn leave_own(watcher: &mut Watcher, journal: &Path, alone: Option<&Alone>) {
    watcher.leave_journal(journal);
    if let Some(alone) = alone {
        watcher.leave(alone.file());
    }
    // Where the system has such files, they are the open ones.
    for output in ["/dev/stdout", "/dev/stderr"] {
        watcher.leave(Path::new(output));
    }
}

impl Run<'_> {
    fn watch(&mut self, watcher: &mut Watcher, idle: Option<Duration>, io: &mut Io<'_>) -> Result<(), CliError> {
        let begun = Instant::now();
        let mut last = begun;
        let mut told = None;
        let mut refused = BTreeSet::new();
        loop {
            let judging = FileJudging { now: super::now(), ..self.judging };
            match watcher.look(judging, begun.elapsed()) {
                Ok(look) => {
                    if !look.is_idle() {
                        last = Instant::now();
                    }
                    for (name, known) in &look.same {
                        if name == known {
                            io.tell(warning(&about(name, &message!("watch-same-again"))));
                        } else {
                            io.warn_about(name, &CliWarning::SameContent { known: known.clone() });
                        }
                    }
                    self.refused(&look, &mut refused, io);
                    if let Err(error) = watcher.tell(&|message: &Message| message.to_string()) {
                        io.warn(&error);
                    }
                    match self.take(watcher, look.ready, io) {
                        // The journal may be held, or the disk full: nothing is taken, and the next look tries again.
                        Err(error @ CliError::NotRecorded { .. }) if idle.is_none() => {
                            self.tell_once(&error.to_string(), &mut told, io);
                            std::thread::sleep(LATER);
                        }
                        taken => {
                            told = None;
                            taken?;
                        }
                    }
                }
                // A share may be gone for a while: it is told once.
                Err(error) => self.tell_once(&error.to_string(), &mut told, io),
            }
            if Duration::from_secs(1) <= last.elapsed() {
                self.journal.rest(io);
            }
            if io.is_closed() || idle.is_some_and(|idle| idle <= last.elapsed()) {
                return Ok(());
            }
            std::thread::sleep(EVERY);
        }
    }

    /// Tells which files cannot be read, each once.
    fn refused(&mut self, look: &FolderScan, told: &mut BTreeSet<String>, io: &mut Io<'_>) {
        let refused = look.waiting.iter().filter(|(_, why)| matches!(why, Waiting::Refused { .. }));
        let now: BTreeSet<String> = refused.clone().map(|(name, _)| name.clone()).collect();
        for (name, why) in refused.filter(|(name, _)| !told.contains(name)) {
            io.warn_about(name, why);
            self.is_bad = true;
        }
        *told = now;
    }

    /// Tells what stops the watch for a while, once.
    fn tell_once(&mut self, said: &str, told: &mut Option<String>, io: &mut Io<'_>) {
        if told.as_deref() != Some(said) {
            io.fail(said);
            self.is_bad = true;
            *told = Some(said.to_owned());
        }
    }

    /// Tells once which values of a file contradict each other, or those of the same part in a file before, whoever took that one.
    fn contradictions(&mut self, file: &str, rows: &[ImportRow], io: &mut Io<'_>) {
        let Some(parts) = &mut self.parts else { return };
        let mut keys = BTreeSet::new();
        for (row, record) in rows.iter().filter_map(|row| Some((row, row.judged.as_deref()?))) {
            let mut part = self.journal.part_of(&self.journal.about(&record.id, &row.labels), file);
            // Parts side by side in a file without serial numbers.
            if part.1.is_empty() {
                row.labels.piece().clone_into(&mut part.1);
            }
            keys.insert(part.clone());
            // Files are taken in the order in which they were written: the time at which they came is an order, too.
            parts.see_of(part, record, row.line, Some(record.time));
        }
        for contradiction in parts.contradictions_of(|key| keys.contains(key)) {
            let what = match &contradiction {
                CliWarning::ContradictionOf { who, name, .. } => format!("{who}: {name}"),
                other => other.to_string(),
            };
            if self.contradictions.insert(what) {
                io.warn(&contradiction);
            }
        }
    }

    /// Records what is ready, all of it or none, and then shows it.
    fn take(&mut self, watcher: &mut Watcher, mut ready: Vec<Batch>, io: &mut Io<'_>) -> Result<(), CliError> {
        let mut all: Vec<Vec<ImportRow>> = Vec::new();
        for batch in &mut ready {
            let mut rows = Rows::of(Path::new(&batch.name), self.judge, true).by(self.judging.plan);
            let mut rows: Vec<ImportRow> = batch.items.iter().cloned().filter_map(|item| rows.row(item)).collect();
            let file =
                UsedFile { role: FileRole::Measurements, name: batch.name.as_str().into(), sha256: batch.sha256 };
            for row in &mut rows {
                let Some(record) = row.judged.clone() else { continue };
                // What a journal cannot hold is told of its row, and keeps nothing else out.
                if let Err(error) = self.journal.size_of(record, &row.labels, file.clone()) {
                    let line = row.line.unwrap_or(1);
                    batch.problems.push(Located::in_line(line, error.message()).message());
                    *row =
                        ImportRow { error: Some(error.to_string()), status: None, judged: None, ..std::mem::take(row) };
                }
            }
            all.push(rows);
        }
        self.journal.keep(io)?;
        for (batch, rows) in ready.iter().zip(&all) {
            let noted = watcher.taken(batch, &|message: &Message| message.to_string());
            if let Err(error) = &noted {
                io.warn_about(&batch.name, error);
            }
            for remark in &batch.remarks {
                io.tell(warning(&about(&batch.name, remark)));
            }
            for item in &batch.items {
                super::import::warn(Path::new(&batch.name), item, io);
                if let Some(row) = ImportRow::against(Path::new(&batch.name), item) {
                    self.printer.against(&row, io)?;
                }
            }
            for row in rows {
                self.is_bad |= row.error.is_some();
                if row.wants_a_look {
                    io.look_first();
                }
                self.worst = self.worst.max(row.part_status());
                self.printer.row(row, io)?;
            }
            self.contradictions(&batch.name, rows, io);
            if noted.is_ok() && rows.iter().any(|row| row.error.is_some()) {
                io.warn_about(&batch.name, &CliWarning::SeeNote { note: crate::watch::NOTE_ENDING });
            }
        }
        // What is waited for must not stay in a buffer.
        self.printer.flush(io);
        Ok(())
    }
}
