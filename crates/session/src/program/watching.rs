//! Parameters with their names and changes, and values that are given before a run.

use std::collections::BTreeMap;

use fitcheck_core::length::Length;
use fitcheck_core::message::{Message, message};
use fitcheck_nc::control::variables::{Parameter, Value};

use super::{Input, ProgramField, ProgramPage};
use crate::state::PageState as _;

/// A parameter in the list.
#[derive(Debug, Clone, PartialEq)]
pub struct Watched<'a> {
    pub parameter: Parameter,
    /// Its value; `None` where a pinned one has none yet.
    pub value: Option<&'a Value>,
    /// Whether the last command changed it.
    pub is_changed: bool,
    /// Whether it stays at the top.
    pub is_pinned: bool,
}

/// What is known about a parameter.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Name<'a> {
    /// The control's own name for it, by the id of its text.
    Control(&'static str),
    /// The program's comment.
    Program(&'a str),
}

/// What the control itself puts into parameters, by the ids of their texts.
const CONTROL: [(u16, &str); 21] = [
    (108, "program-page-q108"),
    (109, "program-page-q109"),
    (110, "program-page-q110"),
    (111, "program-page-q111"),
    (113, "program-page-q113"),
    (114, "program-page-q114"),
    (115, "program-page-q115"),
    (116, "program-page-q116"),
    (117, "program-page-q117"),
    (150, "program-page-q150"),
    (151, "found-centre-1"),
    (152, "found-centre-2"),
    (153, "found-diameter"),
    (157, "found-coordinate"),
    (161, "found-centre-deviation-1"),
    (162, "found-centre-deviation-2"),
    (163, "found-diameter-deviation"),
    (180, "found-good"),
    (181, "found-rework"),
    (182, "found-scrap"),
    (183, "found-status"),
];

/// Those of them that tell tool, spindle and unit, whatever the program does with them.
const SET_UP: std::ops::RangeInclusive<Parameter> = Parameter::q(108)..=Parameter::q(114);

impl ProgramPage {
    /// The parameters that pass the filter, the pinned ones first, and last what the control says of tool, spindle and unit.
    pub fn watched(&self) -> Vec<Watched<'_>> {
        let pinned = self.pinned.iter().map(|&parameter| self.watch(parameter, self.value(parameter), true));
        let run = self.run.iter().flat_map(|run| run.variables().iter());
        // Before a run there are only the given values.
        let given = self.given.iter().filter(|_| self.run.is_none()).map(|(parameter, value)| (*parameter, value));
        let filter = self.text(ProgramField::Filter).trim().to_lowercase();
        let rest = run.chain(given).filter(|(parameter, _)| !self.pinned.contains(parameter));
        let rest = rest.filter(|(parameter, value)| self.is_wanted(*parameter, value, &filter));
        let mut rest: Vec<Watched<'_>> =
            rest.map(|(parameter, value)| self.watch(parameter, Some(value), false)).collect();
        rest.sort_by_key(|watched| SET_UP.contains(&watched.parameter));
        pinned.chain(rest).collect()
    }

    fn watch<'a>(&self, parameter: Parameter, value: Option<&'a Value>, is_pinned: bool) -> Watched<'a> {
        let is_changed = self.run.as_ref().is_some_and(|run| run.is_changed(parameter));
        Watched { parameter, value, is_changed, is_pinned }
    }

    /// The current value of a parameter, or the one that is given to it before a run.
    pub fn value(&self, parameter: Parameter) -> Option<&Value> {
        match &self.run {
            Some(run) => run.variables().get(parameter),
            None => self.given.get(&parameter),
        }
    }

    fn is_wanted(&self, parameter: Parameter, value: &Value, filter: &str) -> bool {
        if filter.is_empty() {
            return true;
        }
        let name = match self.name_of(parameter) {
            Some(Name::Program(name)) => name.to_lowercase(),
            _ => String::new(),
        };
        let text = match value {
            Value::Text(text) => text.to_lowercase(),
            _ => String::new(),
        };
        parameter.to_string().to_lowercase().starts_with(filter) || name.contains(filter) || text.contains(filter)
    }

    /// The name of a parameter: the control's, or a comment of the shown program, the open one, or another of the run.
    pub fn name_of(&self, parameter: Parameter) -> Option<Name<'_>> {
        let own = || CONTROL.iter().find(|(number, _)| Parameter::q(*number) == parameter).map(|(_, id)| *id);
        let mut documents = self.shown().into_iter().chain(self.main()).chain(self.documents.values());
        let comment = documents.find_map(|document| document.name_of(parameter));
        own().map(Name::Control).or_else(|| comment.map(Name::Program))
    }

    /// Values that are given to the next run, under "Start with" or by an input that was changed.
    pub fn given(&self) -> impl Iterator<Item = (Parameter, &Value)> {
        self.given.iter().map(|(parameter, value)| (*parameter, value))
    }
}

/// A parameter by its name: `Q5`, `ql7`, `QS 3`, `#l1`.
fn parameter(text: &str) -> Option<Parameter> {
    let text: String = text.chars().filter(|c| !c.is_whitespace()).collect();
    let parameter: Parameter = text.parse().ok()?;
    parameter.family.numbers().contains(&parameter.number).then_some(parameter)
}

/// What is typed for a parameter, as its value: any text for QS and `#x`, a number for all others.
fn value_of(parameter: Parameter, text: &str) -> Result<Value, Message> {
    if parameter.family.is_text() {
        return Ok(Value::Text(text.to_owned()));
    }
    let number = text.replace(',', ".").parse::<f64>().ok().filter(|number| number.is_finite());
    let number = number.ok_or_else(|| message!("program-page-no-number").text("given", text))?;
    // Up to six decimals are exact as a length.
    Ok(text.parse::<Length>().map_or(Value::Number(number), Value::Length))
}

/// What is wrong with what is typed for a parameter that is no input of the form.
pub(super) fn problem(parameter: Parameter, text: &str) -> Option<Message> {
    value_of(parameter, text.trim()).err()
}

/// What is given to a parameter, as its value: as its input allows, where it is one of the form.
fn read_given(parameter: Parameter, text: &str, input: Option<Input>) -> Result<Value, Message> {
    input.map_or_else(|| value_of(parameter, text), |input| input.read(text))
}

impl ProgramPage {
    /// Gives the value of the fields to the next run; a run that has begun is cleared.
    pub(super) fn give_value(&mut self) {
        for field in [ProgramField::Name, ProgramField::Value] {
            self.errors.remove(&field);
        }
        let name = self.text(ProgramField::Name).trim().to_owned();
        let Some(parameter) = parameter(&name) else {
            let problem = message!("program-page-no-parameter").text("given", name);
            self.errors.insert(ProgramField::Name, problem);
            return;
        };
        let text = self.text(ProgramField::Value).trim().to_owned();
        if let Err(problem) = read_given(parameter, &text, self.input_given(parameter)) {
            self.errors.insert(ProgramField::Value, problem);
            return;
        }
        self.typed.insert(parameter, text);
        self.texts.remove(&ProgramField::Name);
        self.texts.remove(&ProgramField::Value);
        self.check_inputs();
        self.reset();
    }

    /// Forgets what was given to a parameter: the program's own value counts again.
    pub(super) fn drop_value(&mut self, parameter: Parameter) {
        self.typed.remove(&parameter);
        // Without its form, a text that only its field could show would be out of reach.
        if !self.has_inputs() {
            let tools: Vec<_> = self.tool_inputs().collect();
            self.typed.retain(|parameter, text| tools.contains(parameter) || value_of(*parameter, text).is_ok());
        }
        self.check_inputs();
        self.reset();
    }

    /// The input of the form that a parameter is, once it has been given a value.
    fn input_given(&self, parameter: Parameter) -> Option<Input> {
        let input = Input::of(parameter)?;
        self.would_have_inputs(input).then_some(input)
    }

    /// Reads anew what was typed for parameters; what an input repeats of its program is not given.
    pub(super) fn read_typed(&mut self) {
        let inputs: Vec<_> = self.inputs().collect();
        let mut given = BTreeMap::new();
        for (&parameter, text) in &self.typed {
            let input = Input::of(parameter).filter(|input| inputs.contains(input));
            let Ok(value) = read_given(parameter, text, input) else { continue };
            if input.and_then(|input| self.own_value(input)).as_ref() != Some(&value) {
                given.insert(parameter, value);
            }
        }
        self.given = given;
    }
}
