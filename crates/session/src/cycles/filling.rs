//! What fills fields besides typing: another cycle, NC blocks, what was saved; and the workpiece that suits them.

use fitcheck_core::length::Length;
use fitcheck_core::message::{Message, Say as _};
use fitcheck_core::probing::Source;
use fitcheck_core::probing::cycle::{Axis, Meaning};
use fitcheck_core::probing::cycles::cycle;
use fitcheck_core::probing::simulated::{Probe, Simulation, Surface, Walls, Workpiece};
use fitcheck_core::words::Dialogue;
use fitcheck_nc::control::probe_block;
use fitcheck_nc::machine::alone;

use super::CyclesPage;
use crate::saved::SavedCycles;
use crate::shared::Shared;

impl CyclesPage {
    pub(super) fn choose(&mut self, number: u16) {
        if let Some(cycle) = cycle(number) {
            self.cycle = cycle;
            self.changed();
        }
    }

    /// What survives a restart.
    pub(crate) fn saved(&self) -> SavedCycles {
        let typed = self.texts.iter().filter(|(_, text)| !text.is_empty());
        let texts = typed.map(|((number, key), text)| (format!("{number} {key}"), text.clone()));
        SavedCycles { cycle: Some(self.cycle.number), texts: texts.collect() }
    }

    /// Takes the saved values; those that no cycle knows any more are left out.
    pub(super) fn restore(&mut self, saved: &SavedCycles) {
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

    /// Takes all of a block or nothing: half of it would run with the rest of another.
    pub(super) fn take_block(&mut self) {
        let Some(text) = &self.block else { return };
        match self.taken(&text.clone()) {
            Ok(()) => {
                self.block = None;
                self.block_problem = None;
            }
            Err(problem) => self.block_problem = Some(problem),
        }
    }

    fn taken(&mut self, text: &str) -> Result<(), Message> {
        let block = probe_block::read_or_lines(text, self.cycle).map_err(|error| error.message())?;
        if let Some(unused) = &block.unused {
            return Err(unused.message());
        }
        if let Some(lost) = alone(text, &block).first() {
            return Err(lost.message());
        }
        let cycle = block.cycle;
        // A head alone says which cycle is meant, and nothing of its values.
        if !block.settings.is_empty() {
            self.texts.retain(|(number, _), _| *number != cycle.number);
        }
        for setting in &block.settings {
            // The reader has refused parameters that the cycle does not have.
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

    /// A workpiece that suits the cycle, its sizes in the middle of their limits as far as the probe meets them there; where the ball does
    /// not fit into it, the probe is a point.
    pub(crate) fn suited(&self, shared: &Shared) -> Result<Simulation, Message> {
        let nominal = self.cycle.nominal(&self.inputs).map_err(|error| error.message())?;
        let runs = |simulation: &Simulation| {
            let prober = Source::Simulated(simulation).prober(self.cycle, &self.inputs);
            prober.is_ok_and(|mut prober| self.cycle.measure(&self.inputs, &mut *prober).is_ok())
        };
        let suited = |surface| {
            let ball = shared.workpiece.form.suited(surface);
            let point = Simulation { probe: Probe { ball_radius: 0.0, calibration_error: 0.0, ..ball.probe }, ..ball };
            if !runs(&ball) && runs(&point) { point } else { ball }
        };
        let middle = suited(self.in_the_middle(nominal));
        Ok(if runs(&middle) { middle } else { suited(nominal) })
    }

    /// What is measured in the middle of its limits: a size at a limit would scatter beyond it.
    fn in_the_middle(&self, nominal: Surface) -> Surface {
        let limit = |meaning| self.cycle.length_of(&self.inputs, meaning).filter(|limit| Length::ZERO < *limit);
        let middle = |size: f64, minimum, maximum| match (limit(minimum), limit(maximum)) {
            (Some(minimum), Some(maximum)) => minimum.midpoint(maximum).to_mm_f64(),
            _ => size,
        };
        match nominal {
            Surface::Round(round, plane) => {
                let diameter = middle(round.diameter, Meaning::MinimumDiameter, Meaning::MaximumDiameter);
                Surface::Round(Workpiece { diameter, ..round }, plane)
            }
            Surface::Walls(walls) => {
                let side = |size, axis| middle(size, Meaning::MinimumSide(axis), Meaning::MaximumSide(axis));
                let (first, second) = walls.lengths;
                let lengths = match second {
                    Some(second) => (side(first, Axis::First), Some(side(second, Axis::Second))),
                    None => (middle(first, Meaning::MinimumWidth, Meaning::MaximumWidth), None),
                };
                Surface::Walls(Walls { lengths, ..walls })
            }
            Surface::Face(_) | Surface::Point(_) => nominal,
        }
    }
}
