//! Values that were given before the run: which of them no block has replaced yet, and which had no effect at all.

use std::cell::RefCell;
use std::collections::BTreeMap;

use crate::control::variables::{Parameter, Value};

/// The values of `--set` and of the window's form.
#[derive(Debug, Default)]
pub(super) struct GivenValues {
    /// Those that no block has replaced yet.
    standing: BTreeMap<Parameter, Value>,
    /// Those that nothing has used yet.
    unread: RefCell<Vec<Parameter>>,
    /// Those that a block has overwritten before anything used them.
    lost: Vec<Parameter>,
}

impl GivenValues {
    pub(super) fn add(&mut self, parameter: Parameter, value: Value) {
        self.standing.insert(parameter, value);
        self.unread.get_mut().push(parameter);
    }

    /// The value, once: an assignment asks whether it takes its place.
    pub(super) fn take(&mut self, parameter: Parameter) -> Option<Value> {
        self.standing.remove(&parameter)
    }

    /// The values of some parameters that no block has replaced yet.
    pub(super) fn standing_of(&self, is_wanted: impl Fn(Parameter) -> bool) -> Vec<(Parameter, Value)> {
        let wanted = self.standing.iter().filter(|(parameter, _)| is_wanted(**parameter));
        wanted.map(|(parameter, value)| (*parameter, value.clone())).collect()
    }

    /// The value takes the place of a result, also where it was taken away before.
    pub(super) fn gives(&mut self, parameter: Parameter) {
        self.used(parameter);
        self.lost.retain(|lost| *lost != parameter);
    }

    /// The parameter was read, or its value took the place of an assignment.
    pub(super) fn used(&self, parameter: Parameter) {
        // In most runs nothing is left here after a few blocks.
        let mut unread = self.unread.borrow_mut();
        if !unread.is_empty() {
            unread.retain(|given| *given != parameter);
        }
    }

    /// A block gives the parameter another value.
    pub(super) fn overwritten(&mut self, parameter: Parameter) {
        let unread = self.unread.get_mut();
        if let Some(at) = unread.iter().position(|given| *given == parameter) {
            self.lost.push(unread.swap_remove(at));
        }
    }

    /// The parameters whose value had no effect.
    pub(super) fn without_effect(&self) -> Vec<Parameter> {
        let mut parameters: Vec<_> = self.unread.borrow().iter().chain(&self.lost).copied().collect();
        parameters.sort_unstable();
        parameters
    }
}
