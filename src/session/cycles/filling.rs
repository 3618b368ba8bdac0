//! What fills fields besides typing: another cycle, NC blocks, files, a workpiece that suits.

use std::sync::Arc;

use super::{ContactsFrom, CyclesPage, RecordedContacts, WorkpieceForm};
use crate::control::probe_block;
use crate::control::probe_table::ProbeTable;
use crate::message::{Message, Say as _};
use crate::probing::cycles::cycle;
use crate::probing::simulated::{Probe, Simulation};
use crate::probing::{Contact, Source};
use crate::session::{Notice, SavedCycles, Session};
use crate::words::Dialogue;

impl CyclesPage {
    pub(super) fn choose(&mut self, number: u16) {
        if let Some(cycle) = cycle(number) {
            self.cycle = cycle;
            self.changed();
        }
    }

    /// What survives a restart.
    pub(in crate::session) fn saved(&self) -> SavedCycles {
        let typed = self.texts.iter().filter(|(_, text)| !text.is_empty());
        let texts = typed.map(|((number, key), text)| (format!("{number} {key}"), text.clone()));
        SavedCycles { cycle: Some(self.cycle.number), texts: texts.collect() }
    }

    /// Takes what was saved; what no cycle knows any more is left out.
    pub(in crate::session) fn restore(&mut self, saved: &SavedCycles) {
        for (name, text) in &saved.texts {
            let known = name.split_once(' ').and_then(|(number, key)| {
                let cycle = cycle(number.parse().ok()?)?;
                Some((cycle.number, cycle.parameter_named(key)?.key))
            });
            if let Some(place) = known {
                self.texts.insert(place, text.clone());
            }
        }
        self.choose(saved.cycle.unwrap_or(self.cycle.number));
    }

    pub(super) fn change_workpiece(&mut self, change: impl FnOnce(&mut WorkpieceForm)) {
        change(&mut self.workpiece);
        if self.from == ContactsFrom::Simulated {
            self.changed();
        }
    }

    /// All of a block or nothing: half of one would run with the rest of another.
    pub(super) fn take_block(&mut self) {
        let Some(text) = &self.block else { return };
        match self.taken(&text.clone()) {
            Ok(()) => (self.block, self.block_problem) = (None, None),
            Err(problem) => self.block_problem = Some(problem),
        }
    }

    fn taken(&mut self, text: &str) -> Result<(), Message> {
        let block = probe_block::read_or_lines(text, self.cycle).map_err(|error| error.message())?;
        if let Some(unused) = &block.unused {
            return Err(unused.message());
        }
        let cycle = block.cycle;
        self.texts.retain(|(number, _), _| *number != cycle.number);
        for setting in &block.settings {
            // The reader has refused what the cycle does not have.
            if let Some(parameter) = cycle.parameter_named(&setting.key) {
                let text = setting.text.trim_start_matches('+').to_owned();
                self.texts.insert((cycle.number, parameter.key), text);
            }
        }
        self.choose(cycle.number);
        Ok(())
    }

    /// The form as a block for the clipboard, with the line ends of a text.
    pub(super) fn written(&self, language: Dialogue) -> Result<String, Message> {
        let block = probe_block::write(self.cycle, &self.inputs, language);
        block.map(|block| block.replace("\r\n", "\n")).map_err(|error| error.message())
    }

    /// A workpiece that suits the cycle: where the ball does not go into it, a point measures.
    fn suited(&self) -> Result<Simulation, Message> {
        let nominal = self.cycle.nominal(&self.inputs).map_err(|error| error.message())?;
        let simulation = self.workpiece.suited(nominal);
        let point =
            Simulation { probe: Probe { ball_radius: 0.0, calibration_error: 0.0, ..simulation.probe }, ..simulation };
        let runs = |simulation: &Simulation| {
            let prober = Source::Simulated(simulation).prober(self.cycle, &self.inputs);
            prober.is_ok_and(|mut prober| self.cycle.measure(&self.inputs, &mut *prober).is_ok())
        };
        Ok(if !runs(&simulation) && runs(&point) { point } else { simulation })
    }
}

impl Session {
    pub(super) fn suit_workpiece(&mut self) {
        match self.cycles.suited() {
            Ok(simulation) => self.cycles.change_workpiece(|form| *form = WorkpieceForm::of(&simulation)),
            Err(problem) => self.tell(Message::new("cycles-cannot-suit").message("problem", problem)),
        }
    }

    pub(super) fn contacts_read(&mut self, name: String, result: Result<(Vec<Contact>, Vec<Message>), Message>) {
        match result {
            Ok((contacts, details)) => {
                self.file_done();
                if !details.is_empty() {
                    let message = Message::new("cycles-contacts-loaded").text("name", &name);
                    self.notices.push(Notice { message, details, is_problem: false });
                }
                self.cycles.recorded = Some(Arc::new(RecordedContacts { name, contacts }));
                self.cycles.from = ContactsFrom::Recorded;
                self.cycles.changed();
            }
            Err(problem) => self.file_failed(problem),
        }
    }

    pub(super) fn workpiece_read(&mut self, result: Result<Box<Simulation>, Message>) {
        match result {
            Ok(simulation) => {
                self.file_done();
                self.cycles.workpiece = WorkpieceForm::of(&simulation);
                self.cycles.from = ContactsFrom::Simulated;
                self.cycles.changed();
            }
            Err(problem) => self.file_failed(problem),
        }
    }

    pub(super) fn probes_read(&mut self, name: String, result: Result<ProbeTable, Message>) {
        match result {
            Ok(table) => {
                self.file_done();
                let details: Vec<_> = table.warnings.iter().map(crate::message::Say::message).collect();
                if !details.is_empty() {
                    let message = Message::new("cycles-probes-loaded").text("name", &name);
                    self.notices.push(Notice { message, details, is_problem: false });
                }
                (self.cycles.probes, self.cycles.probe) = (Some((name, table)), None);
                self.cycles.changed();
            }
            Err(problem) => self.file_failed(problem),
        }
    }

    /// The simulated machine as a file's bytes.
    pub(in crate::session) fn workpiece_bytes(&self) -> Result<Vec<u8>, Message> {
        let form = self.cycles.workpiece();
        let wrong = || form.problem().unwrap_or_else(|| Message::new("cycles-no-workpiece"));
        let simulation = form.simulation().ok_or_else(wrong)?;
        let refused = |error: toml::ser::Error| Message::new("cycles-not-written").text("reason", error);
        simulation.write().map(String::into_bytes).map_err(refused)
    }
}
