//! From the fields to a run, and stepping along its path.

use std::sync::Arc;

use fitcheck_core::length::Unit;
use fitcheck_core::message::{Message, Say as _, message};
use fitcheck_core::probing::circle::Evaluation;
use fitcheck_core::probing::cycle::{Cycle, CycleError, CycleResult, LogTarget, Move};
use fitcheck_core::probing::simulated::Surface;
use fitcheck_core::probing::{Source, SourceError};
use fitcheck_core::text::decode;
use fitcheck_core::words::Dialogue;
use fitcheck_exchange::journal::entry::{CycleCheck, CycleOrigin, FileRole};
use fitcheck_nc::control::cycle_log::{CycleLog, Heading, OtherVerdict};
use fitcheck_nc::control::cycle_status::cycle_window;
use fitcheck_nc::control::mask::Mask;
use fitcheck_nc::control::simulated::marked;
use jiff::civil::DateTime;

use super::{ContactsFrom, CycleField, CyclesPage};
use crate::Step;
use crate::recording::used;
use crate::shared::Shared;
use crate::tools::Monitoring;

#[derive(Debug, Clone)]
pub struct CycleRun {
    pub cycle: &'static Cycle,
    /// Where its contacts came from.
    pub from: Message,
    /// Whether nobody measured: the workpiece was simulated, or perfect.
    pub is_simulated: bool,
    /// The path of the ball's centre, even where the cycle did not reach its end.
    pub path: Vec<Move>,
    /// The surface that the cycle expects.
    pub nominal: Option<Surface>,
    /// The ball's radius as calibrated, mm.
    pub ball_radius: f64,
    /// What it found, or why it did not.
    pub result: Result<Arc<CycleResult>, Message>,
    /// The evaluation of a circle's contacts.
    pub evaluation: Option<Evaluation>,
    /// How many recorded contacts it did not ask for.
    pub unused: usize,
    /// Its measuring log, where it asks for one (Q281), or why there is none.
    pub log: Option<Result<RunLog, Message>>,
    /// What the monitoring of its tool gave, where a tool table is open.
    pub monitoring: Option<Monitoring>,
    pub time: DateTime,
    /// The number under which it was sent to the journal; `None` where it judged nothing, or nothing is recorded.
    pub record: Option<u64>,
}

/// The measuring log of a run.
#[derive(Debug, Clone)]
pub struct RunLog {
    /// What the control calls the file.
    pub name: String,
    /// The file.
    pub bytes: Vec<u8>,
    /// The text of a log that the control shows on its screen.
    pub shown: Option<String>,
    /// The verdict of its rounded figures, where that differs from the cycle's.
    pub other: Option<OtherVerdict>,
}

impl RunLog {
    /// The log of a result, as Q281 asks for it; a page of points is only written, never shown.
    fn of(cycle: &Cycle, result: &CycleResult, heading: &Heading, language: Dialogue) -> Option<Result<Self, Message>> {
        let (LogTarget::File(_) | LogTarget::Screen) = result.log else { return None };
        let name = cycle.log.file()?.to_owned();
        let is_shown = result.log == LogTarget::Screen;
        let log = CycleLog::of(cycle, result, heading, language)?;
        Some(log.write(language).map_err(|error| error.message()).map(|bytes| Self {
            name,
            shown: is_shown.then(|| decode(&bytes).replace("\r\n", "\n").trim_end().to_owned()),
            bytes,
            other: log.other_verdict(result, language),
        }))
    }
}

impl CycleRun {
    pub fn found(&self) -> Option<&CycleResult> {
        self.result.as_deref().ok()
    }

    /// What is worth knowing: remarks of the cycle, warnings of the circle, contacts that were left over.
    pub fn remarks(&self) -> Vec<Message> {
        let remarks =
            self.found().into_iter().flat_map(|result| &result.remarks).map(fitcheck_core::message::Say::message);
        let warnings =
            self.evaluation.iter().flat_map(|found| &found.warnings).map(fitcheck_core::message::Say::message);
        let unused = (0 < self.unused).then(|| message!("cycles-unused").count("count", self.unused));
        let log = self.log.iter().filter_map(|log| match log {
            Ok(log) => log.other.map(|other| other.message()),
            Err(problem) => Some(problem.clone()),
        });
        let tools = self.monitoring.as_ref().and_then(Monitoring::remark);
        remarks.chain(warnings).chain(unused).chain(log).chain(tools).collect()
    }

    /// A run that did not begin.
    fn refused(cycle: &'static Cycle, problem: Message, time: DateTime) -> Self {
        Self {
            cycle,
            from: message!("cycles-from-perfect"),
            is_simulated: false,
            path: Vec::new(),
            nominal: None,
            ball_radius: 0.0,
            result: Err(problem),
            evaluation: None,
            unused: 0,
            log: None,
            monitoring: None,
            time,
            record: None,
        }
    }
}

impl CyclesPage {
    /// The number of the last move, from 0.
    pub fn last(&self) -> usize {
        self.run.as_ref().map_or(0, |run| run.path.len()).saturating_sub(1)
    }

    pub(super) fn go(&mut self, step: Step) {
        let last = self.last();
        self.step = match step {
            Step::First => 0,
            Step::Left => self.step.saturating_sub(1),
            Step::Right => self.step.saturating_add(1).min(last),
            Step::Last => last,
            _ => self.step,
        };
    }

    pub(super) fn measure(&mut self, shared: &mut Shared, now: DateTime) {
        self.clear();
        self.read();
        let missing: Vec<_> = self.missing().collect();
        for parameter in &missing {
            let key = parameter.key;
            let name = parameter.called();
            self.errors.insert(CycleField::Parameter(key), CycleError::Missing { key, name }.message());
        }
        let run = match self.errors.len() {
            0 => self.run_source(shared, now),
            count => Err(message!("cycles-fields-wrong").count("count", count)),
        };
        let mut run = run.unwrap_or_else(|problem| CycleRun::refused(self.cycle, problem, now));
        run.record = self.keep(&run, shared);
        self.run = Some(run);
        self.step = self.last();
    }

    /// Sends what the cycle says to the journal, where it judged something.
    fn keep(&self, run: &CycleRun, shared: &mut Shared) -> Option<u64> {
        let recorded = self.recorded.as_deref().filter(|_| self.from == ContactsFrom::Recorded);
        let origin = match (self.from, recorded) {
            (ContactsFrom::Recorded, recorded) => {
                CycleOrigin::Contacts { file: recorded.map_or("", |recorded| recorded.name.as_str()).into() }
            }
            (ContactsFrom::Simulated, _) => {
                let seed = shared.workpiece.form.simulation.as_ref().map_or(0, |simulation| simulation.seed);
                CycleOrigin::Workpiece { file: "".into(), seed }
            }
            (ContactsFrom::Perfect, _) => CycleOrigin::Perfect,
        };
        let result = run.found().filter(|result| result.verdict().is_some())?;
        let check = CycleCheck::of(run.cycle, result, origin);
        let file = recorded.and_then(|recorded| used(FileRole::Measurements, &recorded.name, recorded.sha256));
        let files: Vec<_> = file.into_iter().collect();
        shared.recording.keep_cycles(vec![check], &files)
    }

    fn run_source(&self, shared: &Shared, time: DateTime) -> Result<CycleRun, Message> {
        let cycle = self.cycle;
        let inputs = &self.inputs;
        let (source, from) = self.source(shared)?;
        let refused = |error: SourceError| error.message();
        let mut prober = source.prober(cycle, inputs).map_err(refused)?;
        let (path, result) = cycle.measure_along(inputs, &mut *prober);
        let table = shared.tool_table();
        let monitoring = table.zip(result.as_ref().ok()).map(|(table, result)| Monitoring::of(table, cycle, result));
        let is_simulated = self.from != ContactsFrom::Recorded;
        let heading = Heading { date_time: Some(time), program: None, unit: Unit::Millimetre, is_simulated };
        let result = result.map(|result| if table.is_some() { result.with_tool_table() } else { result });
        let evaluation = result.as_ref().ok().and_then(CycleResult::evaluation);
        Ok(CycleRun {
            cycle,
            from,
            is_simulated,
            log: result
                .as_ref()
                .ok()
                .and_then(|result| RunLog::of(cycle, result, &heading, shared.language.dialogue())),
            nominal: cycle.nominal(inputs).ok(),
            ball_radius: prober.ball_radius(),
            unused: if result.is_ok() { source.unused(&path) } else { 0 },
            path,
            result: result.map(Arc::new).map_err(|error| error.message()),
            evaluation,
            monitoring,
            time,
            record: None,
        })
    }

    /// The source of the contacts, and the message that names it.
    fn source<'a>(&'a self, shared: &'a Shared) -> Result<(Source<'a>, Message), Message> {
        match self.from {
            ContactsFrom::Perfect => Ok((Source::Perfect, message!("cycles-from-perfect"))),
            ContactsFrom::Simulated => {
                let wrong = |problem| message!("cycles-workpiece-wrong").message("problem", problem);
                let bench = shared.workpiece.machine().map_err(wrong)?;
                let said = message!("cycles-from-simulated").text("seed", bench.seed);
                Ok((Source::Simulated(bench), said))
            }
            ContactsFrom::Recorded => {
                let recorded = self.recorded.as_ref();
                let recorded = recorded.ok_or_else(|| message!("cycles-no-contacts"))?;
                let said = message!("cycles-from-recorded").text("file", &recorded.name);
                let source = Source::Recorded { contacts: &recorded.contacts, has_heights: recorded.has_heights };
                Ok((source, said))
            }
        }
    }

    /// The measuring log of the shown run.
    pub fn log(&self) -> Option<&RunLog> {
        self.run.as_ref()?.log.as_ref()?.as_ref().ok()
    }

    /// The status window of the shown run, drawn in a language and with the user's own mask; `None` where nothing was
    /// compared with limits.
    pub fn window(&self, (language, own): (Dialogue, Option<&Mask>)) -> Option<Result<String, Message>> {
        let run = self.run.as_ref()?;
        let window = cycle_window(run.cycle, run.found()?, language, own, run.time)?;
        Some(window.map_err(|error| error.message()))
    }

    /// That window as it leaves the program: below a mark where nobody measured.
    pub(crate) fn status_text(&self, drawn_with: (Dialogue, Option<&Mask>)) -> Option<String> {
        let text = self.window(drawn_with)?.ok()?;
        Some(marked(&text, self.run.as_ref()?.is_simulated))
    }

    pub(super) fn results_text(&self) -> Option<String> {
        let result = self.run.as_ref()?.found()?;
        let line = |found: &fitcheck_core::probing::cycle::ResultParameter| {
            // Without a parameter its name says what it is.
            let name = if found.key.is_some() { found.called() } else { found.name.to_string() };
            format!("{name} = {}\n", found.value.with_unit())
        };
        Some(result.results.iter().map(line).collect())
    }
}
