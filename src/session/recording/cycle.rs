//! From the result of a cycle to what is kept of it.

use std::collections::BTreeMap;

use crate::journal::entry::{Compared, CycleCheck, CycleOrigin};
use crate::probing::cycle::{Cycle, CycleResult, FoundName, Value};

/// What a cycle says, where it judged something. `block` is the program's file and line that called it.
pub(in crate::session) fn cycle_check(
    cycle: &Cycle,
    result: &CycleResult,
    origin: CycleOrigin,
    block: Option<(String, u64)>,
) -> Option<CycleCheck> {
    let status = result.verdict()?;
    let parameters = cycle.parameters.iter().filter_map(|parameter| {
        let value = result.inputs.value(parameter.key)?;
        Some((parameter.key.to_string(), value.to_string()))
    });
    let figures: BTreeMap<_, _> = result
        .results
        .iter()
        .filter_map(|found| match found.value {
            Value::Length(length) => Some((found.name.in_files(), length)),
            _ => None,
        })
        .collect();
    let compared = result.checks.iter().map(|check| Compared {
        what: check.what.in_files(),
        measured: check.measured,
        minimum: check.minimum,
        maximum: check.maximum,
        status: check.status,
    });
    let is_size = |name: FoundName| name == FoundName::DIAMETER || name == FoundName::WIDTH;
    let of_size = result.checks.iter().find(|check| is_size(check.what));
    let measured = of_size.map(|check| check.measured);
    Some(CycleCheck {
        cycle: cycle.number,
        parameters: parameters.collect(),
        origin,
        contacts: result.contacts.clone(),
        figures,
        compared: compared.collect(),
        limits: of_size.map(|check| [check.minimum, check.maximum]),
        measured: measured.or_else(|| result.circle.as_ref().map(|circle| circle.diameter)),
        status: Some(status),
        block,
    })
}
