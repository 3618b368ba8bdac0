//! What a measuring cycle found, as it is kept.

use fitcheck_core::probing::cycle::{Check, Cycle, CycleResult, Value};
use fitcheck_core::text::long;
use fitcheck_nc::machine::{CycleRun, DatumInForce, SetBy, Turn};

use super::entry::{BlockKept, Compared, CycleCheck, CycleOrigin, DatumKept};

impl CycleCheck {
    /// What a cycle found, on contacts from somewhere.
    pub fn of(cycle: &Cycle, result: &CycleResult, origin: CycleOrigin) -> Self {
        let parameters = cycle.parameters.iter().filter_map(|parameter| {
            let value = result.inputs.value(parameter.key)?;
            Some((parameter.key.to_string(), value.to_string()))
        });
        let figures = result.results.iter().filter_map(|found| {
            let Value::Length(length) = found.value else { return None };
            Some((found.name.in_files(), length))
        });
        let compared = result.checks.iter().map(|check| Compared {
            what: check.what.in_files(),
            measured: check.measured,
            minimum: check.minimum,
            maximum: check.maximum,
            status: check.status,
        });
        let size = size(&result.checks);
        Self {
            cycle: cycle.number,
            parameters: parameters.collect(),
            origin,
            contacts: result.contacts.clone(),
            figures: figures.collect(),
            compared: compared.collect(),
            limits: size.map(|size| [size.minimum, size.maximum]),
            measured: size.map(|size| size.measured).or_else(|| Some(result.circle.as_ref()?.diameter)),
            status: result.verdict(),
            block: None,
            datum: None,
        }
    }

    /// The same of a cycle that a program has run, with the datum that it counted from.
    pub fn of_run(run: &CycleRun, origin: CycleOrigin) -> Self {
        Self { datum: run.datum.as_ref().map(DatumKept::from), ..Self::of(run.cycle, &run.result, origin) }
    }
}

impl From<&DatumInForce> for DatumKept {
    fn from(datum: &DatumInForce) -> Self {
        let block = |by: &SetBy| BlockKept { line: long(by.line), text: by.text.clone() };
        Self {
            zero: datum.zero,
            set_by: datum.set_by.as_ref().map(block),
            rotation: datum.rotation.as_ref().map(|Turn { degrees: [angle], set_by }| (*angle, block(set_by))),
            tilt: datum.tilt.as_ref().map(|Turn { degrees, set_by }| (*degrees, block(set_by))),
        }
    }
}

/// What was compared besides the centre, where that is one value. A rectangle has two sides, and neither is its size.
fn size(checks: &[Check]) -> Option<&Check> {
    let mut sizes = checks.iter().filter(|check| !check.what.is_centre());
    let first = sizes.next()?;
    sizes.next().is_none().then_some(first)
}
