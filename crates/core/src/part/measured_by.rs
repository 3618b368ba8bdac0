//! Which cycle measures a feature of a plan, and with which further parameters.

use super::fault::PlanFault;
use super::kind::FeatureKind;
use super::values::{beginning, is_decided};
use crate::probing::cycle::{Control, Cycle, Inputs, Parameter};
use crate::probing::cycles::{cycle_named, measuring_cycles_of};
use crate::tolerance::Feature;

/// The cycle that a cell names, or else the usual one. Where the kind is not known, any measuring cycle may be named.
pub(super) fn cycle(
    text: Option<&str>,
    kind: Option<&FeatureKind>,
    feature: Feature,
) -> Result<Option<&'static Cycle>, PlanFault> {
    let Some(text) = text else { return Ok(kind.and_then(|kind| kind.cycle(feature))) };
    if let Some(kind) = kind.filter(|kind| kind.is_by_hand()) {
        return Err(PlanFault::NotOf { column: "cycle", kind: kind.word() });
    }
    let shape = kind.and_then(|kind| kind.shape(feature));
    let fits = |cycle: &&'static Cycle| shape.is_none_or(|shape| cycle.shape() == shape);
    let milling = || measuring_cycles_of(Control::Milling).filter(fits);
    let found = cycle_named(text).filter(|cycle| milling().any(|known| known.code == cycle.code));
    let known = || milling().map(|cycle| cycle.code).collect::<Vec<_>>().join(", ");
    match found {
        Some(cycle) => Ok(Some(cycle)),
        None => Err(PlanFault::Unknown { column: "cycle", given: beginning(text), known: known() }),
    }
}

/// Further parameters, separated by blanks; those that a column of the plan decides are refused. Where the cycle is not known, each has to
/// be one of any measuring cycle.
pub(super) fn parameters(text: &str, cycle: Option<&'static Cycle>) -> Result<Inputs, Vec<PlanFault>> {
    let mut inputs = Inputs::new();
    let mut faults = Vec::new();
    for word in text.split_whitespace() {
        let parts = word.split_once('=');
        let Some(cycle) = cycle else {
            if !parts
                .is_some_and(|(name, _)| measuring_cycles_of(Control::Milling).any(|cycle| free(cycle, name).is_some()))
            {
                faults.push(PlanFault::NoParameter { given: beginning(word) });
            }
            continue;
        };
        let Some((parameter, value)) = parts.and_then(|(name, value)| Some((free(cycle, name)?, value))) else {
            let known = cycle.parameters.iter().filter(|parameter| !is_decided(parameter.meaning));
            let known = known.map(|known| known.key.to_string()).collect::<Vec<_>>().join(", ");
            faults.push(PlanFault::Parameter { given: beginning(word), cycle: cycle.code, known });
            continue;
        };
        match parameter.accept(value) {
            Ok(value) => inputs = inputs.with(parameter.key, value),
            Err(error) => faults.push(PlanFault::Range(Box::new(error))),
        }
    }
    if faults.is_empty() { Ok(inputs) } else { Err(faults) }
}

/// A parameter of a cycle that no column of the plan decides.
fn free(cycle: &'static Cycle, name: &str) -> Option<&'static Parameter> {
    cycle.parameter_named(name).filter(|parameter| !is_decided(parameter.meaning))
}
