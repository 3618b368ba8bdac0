//! From the result of a cycle to what is kept of it.

use std::collections::BTreeMap;

use crate::journal::entry::CycleCheck;
use crate::probing::cycle::{Cycle, CycleResult, FoundName, Value};

/// What a cycle says, where it judged something.
pub(in crate::session) fn cycle_check(cycle: &Cycle, result: &CycleResult, is_simulated: bool) -> Option<CycleCheck> {
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
    let of_size =
        result.checks.iter().find(|check| check.what == FoundName::DIAMETER || check.what == FoundName::WIDTH);
    let measured = of_size.map(|check| check.measured);
    Some(CycleCheck {
        cycle: cycle.number,
        parameters: parameters.collect(),
        contacts: result.contacts.clone(),
        figures,
        limits: of_size.map(|check| [check.minimum, check.maximum]),
        measured: measured.or_else(|| result.circle.as_ref().map(|circle| circle.diameter)),
        status: Some(status),
        is_simulated,
    })
}
