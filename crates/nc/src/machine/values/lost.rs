//! Parameters that a block may have set which was not run: nothing reads them, not even whether they are defined.

use std::collections::BTreeMap;
use std::sync::Arc;

use super::super::around::ChangingBlock;
use super::super::fault::FaultKind;
use super::Values;
use crate::control::variables::{Family, Parameter, Value};

/// What measuring cycles of milling controls set, those too that are not run here: contact, kinematics, results, markers, and the
/// values of cycles 14xx (heidenhain, section 4; datum-cycles, sections 7 and 12).
const RESULTS: [std::ops::RangeInclusive<u16>; 3] = [115..=119, 141..=199, 950..=999];

/// What those of lathe controls set.
const LATHE_RESULT: Parameter = Parameter { family: Family::LatheControl, number: 99 };

fn results() -> impl Iterator<Item = Parameter> {
    RESULTS.into_iter().flatten().map(Parameter::q).chain([LATHE_RESULT])
}

fn is_result(parameter: Parameter) -> bool {
    parameter == LATHE_RESULT
        || parameter.family == Family::Q && RESULTS.iter().any(|numbers| numbers.contains(&parameter.number))
}

/// Parameters, and the blocks that may have set them.
pub(super) type SettingBlocks = BTreeMap<Parameter, Arc<ChangingBlock>>;

/// The parameters, and the blocks that may have set them.
#[derive(Debug, Default)]
pub(super) struct LostParameters {
    by: SettingBlocks,
    /// Whether all results are among them.
    has_results: bool,
    /// Parameters of FN 18, which a control defines.
    system: BTreeMap<Parameter, Arc<ChangingBlock>>,
}

impl LostParameters {
    /// Takes away what is lost of some families.
    pub(super) fn take(&mut self, families: &[Family]) -> SettingBlocks {
        let all = std::mem::take(&mut self.by);
        let (taken, kept) = all.into_iter().partition(|(parameter, _)| families.contains(&parameter.family));
        self.by = kept;
        taken
    }

    /// Gives it back.
    pub(super) fn put(&mut self, taken: SettingBlocks) {
        self.by.extend(taken);
    }

    /// A block that was run has set the parameter, or made it undefined.
    pub(super) fn known(&mut self, parameter: Parameter) {
        self.system.remove(&parameter);
        if self.by.remove(&parameter).is_some() && is_result(parameter) {
            self.has_results = false;
        }
    }
}

impl Values {
    /// A block that was not run may have set a parameter.
    pub(in crate::machine) fn lose(&mut self, parameter: Parameter, by: &Arc<ChangingBlock>) {
        self.lost.by.insert(parameter, Arc::clone(by));
        if self.variables.get(parameter).is_some() {
            self.unset(parameter);
        }
    }

    /// An assignment was not run. Returns the value that was given before the run, if it takes the place of this one.
    pub(in crate::machine) fn lose_assigned(
        &mut self,
        to: Parameter,
        by: &Arc<ChangingBlock>,
        is_main: bool,
    ) -> Option<Value> {
        let given = self.given(to, is_main, || false);
        if given.is_none() {
            self.lose(to, by);
        }
        given
    }

    /// FN 18: a control defines the parameter, with a value that only it knows. Returns the value that was given before the run.
    pub(in crate::machine) fn lose_system(
        &mut self,
        to: Parameter,
        by: impl FnOnce() -> ChangingBlock,
        is_main: bool,
    ) -> Option<Value> {
        let given = self.undefine(to, is_main);
        if given.is_none() {
            self.lost.system.insert(to, Arc::new(by()));
        }
        given
    }

    /// A measurement was not run.
    pub(in crate::machine) fn lose_results(&mut self, by: &Arc<ChangingBlock>) {
        if !self.lost.has_results {
            results().for_each(|parameter| self.lose(parameter, by));
            self.lost.has_results = true;
        }
    }

    /// Results that were given before the run are those of a cycle that is passed over.
    pub(in crate::machine) fn give_results(&mut self) {
        for (parameter, value) in self.given.standing_of(is_result) {
            self.given.gives(parameter);
            self.set(parameter, value);
        }
    }

    /// An error for a parameter that a block may have set which was not run.
    pub(in crate::machine) fn check_known(&self, parameter: Parameter) -> Result<(), FaultKind> {
        lost(parameter, self.lost.by.get(&parameter))
    }

    /// An error for a parameter of which it is not known whether it has a value on a control.
    pub(super) fn check_defined(&self, parameter: Parameter) -> Result<(), FaultKind> {
        self.check_known(parameter)?;
        lost(parameter, self.lost.system.get(&parameter))
    }

    /// Why a parameter has no value.
    pub(super) fn missing(&self, parameter: Parameter) -> FaultKind {
        let is_of_tool = [108, 114].map(Parameter::q).contains(&parameter);
        let undefined = if is_of_tool { FaultKind::NoToolData(parameter) } else { FaultKind::Undefined(parameter) };
        self.check_known(parameter).err().unwrap_or(undefined)
    }
}

fn lost(parameter: Parameter, by: Option<&Arc<ChangingBlock>>) -> Result<(), FaultKind> {
    let Some(by) = by else { return Ok(()) };
    let ChangingBlock { line, text } = by.as_ref().clone();
    Err(FaultKind::Lost { parameter, line, text })
}
