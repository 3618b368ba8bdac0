//! The cycles page: a form made from a cycle's declaration, where its contacts come from, and what it found.
//!
//! | file | what |
//! |---|---|
//! | here | the state |
//! | `field` | the text fields |
//! | `command`, `apply` | what can be done, and doing it |
//! | `reading` | what the fields mean, read anew at every change |
//! | `workpiece`, `workpiece_field` | the simulated workpiece as text fields |
//! | `running` | from the fields to a run, and stepping along its path |
//! | `folding` | which parameters are folded away |
//! | `filling` | NC blocks and files into fields |
//!
//! A result is kept with what it was made with: any change of an input clears it.

mod actions;
mod apply;
mod command;
mod field;
mod filling;
mod folding;
mod reading;
mod running;
mod workpiece;
mod workpiece_field;

use std::collections::BTreeMap;
use std::sync::Arc;

use fitcheck_core::message::Message;
use fitcheck_core::probing::TouchProbe;
use fitcheck_core::probing::cycle::{Cycle, Inputs, Key, Parameter, ParameterGroup, Unset, Value};
use fitcheck_core::probing::cycles::CYCLES;
use fitcheck_nc::control::probe_table::ProbeTable;

use crate::state::PageState as _;
use crate::workpiece::RecordedContacts;

pub use actions::CyclesAction;
pub use command::CyclesCommand;
pub use field::{Axis, CycleField};
pub(crate) use folding::fold_of;
pub use folding::{fold_name, group_name, may_fold};
pub use running::{CycleRun, RunLog};
pub use workpiece::WorkpieceForm;
pub use workpiece_field::WorkpieceField;

/// Where contacts come from.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Hash)]
pub enum ContactsFrom {
    /// A perfect workpiece at nominal.
    #[default]
    Perfect,
    /// The simulated workpiece.
    Simulated,
    /// Contacts recorded in a file.
    Recorded,
}

impl ContactsFrom {
    /// Every source.
    pub const ALL: [Self; 3] = [Self::Perfect, Self::Simulated, Self::Recorded];
}

/// Where the value of a parameter comes from.
#[derive(Debug, Clone, PartialEq)]
pub enum ValueOrigin {
    /// It was typed.
    Given,
    /// Nothing was typed, and this counts.
    Default(Value),
    /// Nothing was typed, and it may be left out.
    Optional,
    /// Nothing was typed, and it must be given.
    Required,
}

/// The state of the cycles page.
#[derive(Debug)]
pub struct CyclesPage {
    /// The chosen cycle.
    pub cycle: &'static Cycle,
    texts: BTreeMap<(u16, Key), String>,
    globals: BTreeMap<(u16, Key), String>,
    position: BTreeMap<Axis, String>,
    errors: BTreeMap<CycleField, Message>,
    /// What was typed, as far as it can be used.
    pub inputs: Inputs,
    /// Where contacts come from.
    pub from: ContactsFrom,
    /// The contacts that were opened here: the program page has its own.
    pub recorded: Option<Arc<RecordedContacts>>,
    probes: Option<(String, ProbeTable)>,
    probe: Option<u32>,
    /// The NC block that is being typed, where its field is open.
    pub block: Option<String>,
    /// Why the NC block cannot be used.
    pub block_problem: Option<Message>,
    /// What the last run found; it belongs to the inputs on screen.
    pub run: Option<CycleRun>,
    /// The number of the move that is shown, from 0.
    pub step: usize,
}

impl Default for CyclesPage {
    fn default() -> Self {
        #[expect(clippy::expect_used, reason = "the list of cycles is a constant with members")]
        let cycle = CYCLES.first().copied().expect("there are cycles");
        let mut page = Self {
            cycle,
            texts: BTreeMap::new(),
            globals: BTreeMap::new(),
            position: BTreeMap::new(),
            errors: BTreeMap::new(),
            inputs: Inputs::new(),
            from: ContactsFrom::default(),
            recorded: None,
            probes: None,
            probe: None,
            block: None,
            block_problem: None,
            run: None,
            step: 0,
        };
        page.read();
        page
    }
}

impl CyclesPage {
    /// Whether the result on screen was made with what stands in the fields, and would come once more as it is.
    pub fn would_repeat(&self) -> bool {
        self.run.is_some() && self.from != ContactsFrom::Simulated
    }

    /// The value of a parameter: what was typed or its default, where that can be used.
    pub fn value(&self, parameter: &Parameter) -> Option<Value> {
        self.inputs.value(parameter.key).cloned().or_else(|| parameter.default_with(&self.inputs))
    }

    /// Where the value of a parameter comes from.
    pub fn standing(&self, parameter: &Parameter) -> ValueOrigin {
        let is_given = !self.text(CycleField::Parameter(parameter.key)).trim().is_empty();
        if is_given { ValueOrigin::Given } else { self.unset(parameter) }
    }

    /// What counts for a parameter while nothing is typed.
    pub fn unset(&self, parameter: &Parameter) -> ValueOrigin {
        match (parameter.default_with(&self.inputs), parameter.unset) {
            (None, Unset::Refused) => ValueOrigin::Required,
            (None | Some(Value::Band(None)), _) => ValueOrigin::Optional,
            (Some(value), _) => ValueOrigin::Default(value),
        }
    }

    /// Whether PREDEF was typed for a parameter, so that its value must be given elsewhere.
    pub fn is_predef(&self, key: Key) -> bool {
        self.inputs.value(key) == Some(&Value::Predef)
    }

    /// Whether every field can be used and none is missing.
    pub fn is_complete(&self) -> bool {
        self.errors.is_empty() && self.missing().next().is_none()
    }

    /// The first field, in the order of the form, that keeps the cycle from running.
    pub fn first_wrong(&self) -> Option<CycleField> {
        let of_parameter =
            |parameter: &Parameter| [CycleField::Parameter(parameter.key), CycleField::Global(parameter.key)];
        let parameters = self.cycle.parameters.iter().flat_map(of_parameter);
        let mut fields = parameters.chain(Axis::ALL.map(CycleField::Position));
        fields.find(|field| self.errors.contains_key(field))
    }

    /// The first parameter of the form that has no value of its own.
    pub fn first_needed(&self) -> Option<&'static Parameter> {
        let needed = |parameter: &&'static Parameter| parameter.default_value().is_none() && parameter.has_effect;
        let mut in_groups = ParameterGroup::ALL
            .into_iter()
            .flat_map(|group| self.cycle.parameters.iter().filter(move |parameter| parameter.meaning.group() == group));
        in_groups.find(needed)
    }

    /// The parameters that must be given and are not.
    fn missing(&self) -> impl Iterator<Item = &'static Parameter> {
        let is_missing = |parameter: &&Parameter| {
            parameter.unset == Unset::Refused && self.text(CycleField::Parameter(parameter.key)).trim().is_empty()
        };
        self.cycle.parameters.iter().filter(is_missing)
    }

    /// The name of the user's touch-probe table, where one was opened.
    pub fn probes_name(&self) -> Option<&str> {
        self.probes.as_ref().map(|(name, _)| name.as_str())
    }

    /// The probes of the table.
    pub fn probes(&self) -> &[TouchProbe] {
        &self.probe_table().probes
    }

    fn probe_table(&self) -> &ProbeTable {
        self.probes.as_ref().map_or_else(|| ProbeTable::shipped(), |(_, table)| table)
    }

    /// The probe that measures; where the table has none, that of the built-in table.
    pub fn probe(&self) -> TouchProbe {
        self.probe_table().probe(self.probe).map_or_else(TouchProbe::default, |probe| *probe)
    }
}
