//! What the fields of the cycles page mean.

use fitcheck_core::length::Length;
use fitcheck_core::message::{Say as _, message};
use fitcheck_core::probing::cycle::{Inputs, Parameter, Value};

use super::{Axis, CycleField, CyclesPage};
use crate::state::PageState as _;

impl CyclesPage {
    /// Reads the fields anew.
    pub(super) fn read(&mut self) {
        self.errors.clear();
        let mut inputs = Inputs::new().with_probe(self.probe());
        for parameter in self.cycle.parameters {
            inputs = self.read_parameter(parameter, inputs);
        }
        if let Some(position) = self.read_position() {
            inputs = inputs.with_position(position);
        }
        self.inputs = inputs;
    }

    fn read_parameter(&mut self, parameter: &Parameter, inputs: Inputs) -> Inputs {
        let field = CycleField::Parameter(parameter.key);
        let text = self.text(field);
        if text.trim().is_empty() {
            return inputs;
        }
        match parameter.accept(text) {
            Ok(Value::Predef) => self.read_global(parameter, inputs.with(parameter.key, Value::Predef)),
            Ok(value) => inputs.with(parameter.key, value),
            Err(error) => {
                self.errors.insert(field, error.message());
                inputs
            }
        }
    }

    fn read_global(&mut self, parameter: &Parameter, inputs: Inputs) -> Inputs {
        let field = CycleField::Global(parameter.key);
        match parameter.accept(self.text(field)) {
            Err(_) if self.text(field).trim().is_empty() => {
                self.errors.insert(field, message!("cycles-predef-missing"));
                inputs
            }
            Ok(Value::Predef) => {
                self.errors.insert(field, message!("cycles-predef-missing"));
                inputs
            }
            Ok(value) => inputs.with_global(parameter.key, value),
            Err(error) => {
                self.errors.insert(field, error.message());
                inputs
            }
        }
    }

    /// All three or none: an incomplete position would be a guess.
    fn read_position(&mut self) -> Option<[f64; 3]> {
        if Axis::ALL.iter().all(|axis| self.text(CycleField::Position(*axis)).trim().is_empty()) {
            return None;
        }
        let [x, y, z] = Axis::ALL.map(|axis| {
            let field = CycleField::Position(axis);
            let read = self.text(field).parse().map(Length::to_mm_f64);
            read.map_err(|error| self.errors.insert(field, error.message())).ok()
        });
        Some([x?, y?, z?])
    }
}
