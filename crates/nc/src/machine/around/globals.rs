//! The values of GLOBAL DEF, for which `PREDEF` stands.

use super::super::fault::FaultKind;
use super::super::values::Values;
use super::Around;
use crate::control::variables::{Parameter, Value};
use crate::program::{CycleBlock, CycleName, CycleValue, Unit};

/// The GLOBAL DEF that measuring cycles take their values from (nc-programs, section 1).
const PROBING: &str = "120";

/// Whether a value is from that GLOBAL DEF.
pub(super) type IsProbing = bool;

/// A value of GLOBAL DEF.
#[derive(Debug, Clone, PartialEq)]
pub(in crate::machine) struct Global {
    /// The value as written.
    pub value: f64,
    /// The unit of the program that gave it.
    pub unit: Option<Unit>,
}

impl Around {
    /// GLOBAL DEF: the last one that was run counts.
    ///
    /// # Errors
    /// A parameter that stands twice in one block: which of the two a control takes is not documented.
    pub(in crate::machine) fn define(
        &mut self,
        block: &CycleBlock,
        unit: Option<Unit>,
        values: &Values,
    ) -> Result<(), FaultKind> {
        let is_probing = block.number == PROBING;
        for (at, line) in block.lines.iter().enumerate() {
            let mut before = block.lines.iter().take(at);
            if before.any(|before| before.parameter == line.parameter) {
                let number = block.number.clone();
                let parameter = line.parameter.clone();
                return Err(FaultKind::GlobalTwice { number, parameter });
            }
            match (&line.parameter, &line.value) {
                (CycleName::Parameter(parameter), CycleValue::Number { value, .. }) => {
                    let value = values.operand(*value)?;
                    self.globals.insert((is_probing, *parameter), Global { value, unit });
                }
                // An earlier value would stay in force.
                _ if is_probing => {
                    let number = block.number.clone();
                    let parameter = line.parameter.clone();
                    return Err(FaultKind::GlobalNotNumber { number, parameter });
                }
                _ => {}
            }
        }
        Ok(())
    }

    /// The value of GLOBAL DEF 120 for a parameter of a measuring cycle.
    pub(in crate::machine) fn global(&self, parameter: Parameter) -> Option<&Global> {
        self.globals.get(&(true, parameter))
    }

    /// The values of GLOBAL DEF are not known any more.
    pub(in crate::machine) fn lose_globals(&mut self) {
        self.globals.clear();
    }

    /// The parameters of a cycle, as a program may read them afterwards.
    ///
    /// A value from a GLOBAL DEF of a program in another unit may be a length or not: it is undefined then.
    pub(in crate::machine) fn stated(
        &self,
        block: &CycleBlock,
        is_probing: bool,
        unit: Option<Unit>,
        values: &mut Values,
    ) -> Result<(), FaultKind> {
        for line in &block.lines {
            // A word is not a parameter that a program could read.
            let CycleName::Parameter(parameter) = line.parameter else { continue };
            let value = match &line.value {
                CycleValue::Number { value, .. } => values.value(*value)?,
                CycleValue::Word(word) if word.eq_ignore_ascii_case("PREDEF") => {
                    let global = self.globals.get(&(is_probing, parameter)).filter(|global| global.unit == unit);
                    let Some(global) = global else {
                        values.undefine(parameter, false);
                        continue;
                    };
                    Value::Number(global.value)
                }
                CycleValue::Text(_) | CycleValue::Word(_) => continue,
            };
            values.put(parameter, value)?;
        }
        Ok(())
    }
}
