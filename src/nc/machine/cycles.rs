//! `TCH PROBE`: the cycles of `probing::cycles`, by number.

use super::budget::{Budget, UsedUp};
use super::fault::{BlockPlace, FaultKind};
use super::remark::Remark;
use super::run::Machine;
use super::step::{Pause, Step};
use super::values::length_of;
use crate::control::variables::{Parameter, Value};
use crate::length::Length;
use crate::nc::program::{CycleBlock, CycleLine, CycleValue, Operand, Tool, Unit};
use crate::probing::cycle::{
    self, Control, Cycle, CycleError, CycleResult, Inputs, Key, LogTarget, Move, Phase, Range,
};
use crate::probing::cycles::cycles_of;

/// A cycle that was run.
#[derive(Debug, Clone)]
pub struct CycleRun {
    /// The block.
    pub place: BlockPlace,
    /// Which cycle.
    pub cycle: &'static Cycle,
    /// What it found.
    pub result: CycleResult,
}

impl Machine {
    /// TOOL CALL: the probe of that number; a name stands for the first probe of the table.
    pub(super) fn call_tool(&mut self, tool: Option<&Tool>) -> Result<(), FaultKind> {
        let (number, name) = match tool {
            // Without a tool only speed or feed are changed.
            None => return Ok(()),
            Some(Tool::Number(number)) => {
                let value = self.operand(*number)?;
                let number = super::flow::whole(value).and_then(|number| u32::try_from(number).ok());
                (number, value.to_string())
            }
            Some(Tool::Name(name)) => (None, self.text_operand(name)?.to_owned()),
        };
        let table = &self.settings.probe_table;
        let found = number.and_then(|number| table.probe(Some(number)));
        self.probe = found.or_else(|| table.probe(None)).copied().unwrap_or_default();
        // With one probe there is no doubt which one is meant.
        let is_doubtful = found.is_none() && 1 < table.probes.len();
        self.other_tool = is_doubtful.then_some(name);
        Ok(())
    }

    /// Runs a cycle and hands its results over.
    pub(super) fn probe(&mut self, at: usize, block: &CycleBlock) -> Result<Step, FaultKind> {
        let Some(cycle) = milling_cycle(&block.number) else {
            if self.settings.skip_unknown {
                self.remark(at, Remark::Skipped);
                return Ok(Step::Went);
            }
            let known: Vec<&str> = cycles_of(Control::Milling).map(|cycle| cycle.code).collect();
            return Err(FaultKind::UnknownCycle { cycle: block.number.clone(), known: known.join(", ") });
        };
        if self.frame.unit == Some(Unit::Inch) {
            return Err(FaultKind::Inch);
        }
        Budget::one_more(self.cycles.len(), self.budget().cycles, UsedUp::Cycles)?;
        if let Some(tool) = self.other_tool.take() {
            self.remark(at, Remark::OtherProbe { tool, probe: self.probe.number });
        }
        let inputs = self.inputs(cycle, block)?;
        let (path, result) = self.probed.measure(cycle, &inputs)?;
        self.went_along(at, &path)?;
        let failed = |error| FaultKind::Cycle { cycle: cycle.code, error: Box::new(error) };
        let result = result.map_err(failed)?;
        self.hand_over(cycle, &result)?;
        self.log(at, cycle, &result)?;
        let step = match (&result.stop, result.log) {
            (Some(stop), _) => Step::Paused(Pause::Tolerance(Box::new(stop.clone()))),
            (None, LogTarget::Screen) => Step::Paused(Pause::Log),
            (None, LogTarget::None | LogTarget::File(_) | LogTarget::Shown) => Step::Went,
        };
        self.cycles.push(CycleRun { place: self.place_of(at), cycle, result });
        Ok(step)
    }

    fn inputs(&self, cycle: &'static Cycle, block: &CycleBlock) -> Result<Inputs, FaultKind> {
        let mut inputs = Inputs::new().with_probe(self.probe);
        if let Some(place) = self.position.place() {
            inputs = inputs.with_position(place);
        }
        for line in &block.lines {
            let parameter = line.parameter;
            let unknown = FaultKind::NoCycleParameter { cycle: cycle.code, parameter };
            let declared = cycle.parameter_named(&parameter.to_string()).ok_or(unknown)?;
            if inputs.is_given(declared.key) {
                return Err(FaultKind::CycleParameterTwice { cycle: cycle.code, parameter });
            }
            inputs = inputs.with(declared.key, self.input(cycle, declared, line)?);
        }
        Ok(inputs)
    }

    /// The value of a line in the kind that the parameter is declared as; the range is checked by the cycle.
    fn input(
        &self,
        cycle: &'static Cycle,
        declared: &cycle::Parameter,
        line: &CycleLine,
    ) -> Result<cycle::Value, FaultKind> {
        let refused = |error: CycleError| FaultKind::Cycle { cycle: cycle.code, error: Box::new(error) };
        let read = |text: &str| declared.read(text).map_err(refused);
        let operand: Operand = match &line.value {
            CycleValue::Word(word) => return read(word),
            CycleValue::Text(text) => {
                let text = self.text_operand(text)?;
                let is_name = declared.range == Range::Tool && !text.is_empty();
                return if is_name { Ok(cycle::Value::Text(text.to_owned())) } else { read(text) };
            }
            CycleValue::Number { value, .. } => *value,
        };
        let value = self.value(operand)?;
        let number = self.operand(operand)?;
        match declared.range {
            // At the nearest nanometre; what no length can be is said by the reader of such texts.
            Range::Length { .. } => {
                length_of(&value).map_or_else(|| read(&number.to_string()), |length| Ok(cycle::Value::Length(length)))
            }
            Range::Angle { .. } => read(&format!("{number:.4}")),
            Range::OneOf(_) | Range::Band => read(&number.to_string()),
            Range::Number { .. } | Range::Tool => Ok(cycle::Value::Number(number)),
        }
    }

    /// Results into their parameters, the number of the cycle into Q198, where the ball touched last into Q115 to Q117.
    fn hand_over(&mut self, cycle: &Cycle, result: &CycleResult) -> Result<(), FaultKind> {
        for found in &result.results {
            let value = match &found.value {
                cycle::Value::Length(length) => Value::Length(*length),
                cycle::Value::Angle(angle) => Value::Number(angle.to_degrees_f64()),
                cycle::Value::Whole(whole) => Value::Number(i32::try_from(*whole).map_or(0.0, f64::from)),
                cycle::Value::Number(number) => Value::Number(*number),
                other => Value::Text(other.to_string()),
            };
            match found.key {
                Key::Q(number) => self.put(Parameter::q(number), value)?,
                Key::Qs(number) => self.put(Parameter::qs(number), value)?,
                Key::Word(_) => {}
            }
        }
        self.put(Parameter::q(198), Value::Number(f64::from(cycle.number)))?;
        let last = result.path.iter().rev().find(|step: &&Move| step.phase == Phase::Contact);
        for (number, place) in (115..).zip(last.into_iter().flat_map(|step| step.to)) {
            if let Ok(length) = Length::from_mm_f64(place) {
                self.put(Parameter::q(number), Value::Length(length))?;
            }
        }
        Ok(())
    }
}

/// A cycle of milling controls: those of lathe controls are no `TCH PROBE`.
fn milling_cycle(number: &str) -> Option<&'static Cycle> {
    cycles_of(Control::Milling).find(|cycle| cycle.code == number)
}
