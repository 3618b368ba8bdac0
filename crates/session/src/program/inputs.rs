//! The inputs of 8255 as fields, and Fitcheck's own answer beside the program's.

use std::collections::BTreeMap;

use fitcheck_core::length::Length;
use fitcheck_core::message::{Message, Say as _, message};
use fitcheck_core::tolerance::{Callout, Limits, Sources};
use fitcheck_core::verdict::{SizeVerdict, judge_size};
use fitcheck_nc::control::variables::{Parameter, Value};
use fitcheck_nc::program::{Body, Expression, NumberFunction, Operand, Program, TextExpression, TextOperand};

use super::{Input, ProgramField, ProgramPage, Run};
use crate::state::PageState as _;

/// A length of any sign.
pub(super) fn length(text: &str) -> Result<Length, Message> {
    text.parse::<Length>().map_err(|error| error.message())
}

/// What a program assigns to parameters before it calls, jumps or measures: plain values only.
pub(super) fn assigned(program: &Program) -> BTreeMap<Parameter, String> {
    let mut found = BTreeMap::new();
    for block in program.blocks() {
        let (to, text) = match &block.body {
            Body::Assign { to, value } => match plain(value) {
                Some(number) => (*to, number.to_string()),
                None => continue,
            },
            Body::AssignText { to, value: TextExpression::Value(TextOperand::Text(text)) } => (*to, text.clone()),
            Body::Begin { .. }
            | Body::Nothing
            | Body::Heading { .. }
            | Body::AssignText { .. }
            | Body::ToolCall { .. }
            | Body::Move(_)
            | Body::Other => continue,
            _ => break,
        };
        found.entry(to).or_insert(text);
    }
    found
}

/// A number, with or without a minus sign.
fn plain(value: &Expression) -> Option<f64> {
    match value {
        Expression::Value(Operand::Number(number)) => Some(*number),
        Expression::Function(NumberFunction::Negative, number) => plain(number).map(|number| -number),
        _ => None,
    }
}

/// Whether program and native answer say the same.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Agreement {
    /// They do.
    Agrees,
    /// Neither has an answer, each for its own reason.
    BothRefuse,
    /// The program has set other inputs since: it measures more than one feature.
    OtherInputs,
    /// The program did not come to its end: what it said until then differs in nothing.
    Unfinished,
    /// They do not: what differs, one sentence each.
    Differs(Vec<Message>),
}

impl ProgramPage {
    /// Whether the open program has the inputs of 8255: at least size and class, assigned or given. Without them Q1
    /// means whatever the program wants: it is no nominal size, and nothing is asked of it.
    pub fn has_inputs(&self) -> bool {
        self.has_input(Input::Size) && self.has_input(Input::Class)
    }

    fn has_input(&self, input: Input) -> bool {
        self.own(input).is_some() || self.typed.contains_key(&input.parameter())
    }

    /// Whether the program has the inputs of 8255 once this one has been given.
    pub(super) fn would_have_inputs(&self, given: Input) -> bool {
        [Input::Size, Input::Class].into_iter().all(|input| input == given || self.has_input(input))
    }

    /// The inputs of 8255 that the open program assigns or that were given to it; none where it has another purpose.
    pub fn inputs(&self) -> impl Iterator<Item = Input> {
        let has_inputs = self.has_inputs();
        Input::ALL.into_iter().filter(move |input| has_inputs && self.has_input(*input))
    }

    /// What the open program itself assigns to an input.
    fn own(&self, input: Input) -> Option<&str> {
        self.main()?.assigned().get(&input.parameter()).map(String::as_str)
    }

    pub(super) fn own_value(&self, input: Input) -> Option<Value> {
        input.read(self.own(input)?).ok()
    }

    fn input(&self, input: Input) -> Option<Value> {
        input.read(self.text(ProgramField::Input(input))).ok()
    }

    /// An input that is a length, mm.
    pub(super) fn input_length(&self, input: Input) -> Option<Length> {
        match self.input(input) {
            Some(Value::Length(length)) => Some(length),
            _ => None,
        }
    }

    /// Takes what was typed into an input's field.
    pub(super) fn type_input(&mut self, input: Input, text: String) {
        self.typed.insert(input.parameter(), text);
        self.check_inputs();
    }

    /// Reads the inputs and all other given values anew.
    pub(super) fn check_inputs(&mut self) {
        let asked: Vec<_> = self.inputs().collect();
        for input in Input::ALL {
            let field = ProgramField::Input(input);
            self.errors.remove(&field);
            if let Some(Err(problem)) = asked.contains(&input).then(|| input.read(self.text(field))) {
                self.errors.insert(field, problem);
            }
        }
        self.check_tools();
        self.read_typed();
    }
}

impl ProgramPage {
    /// Fitcheck's own limits for the program's inputs; `None` where the program has none.
    pub fn limits(&self, sources: &Sources) -> Option<Result<Limits, Message>> {
        if !self.has_inputs() {
            return None;
        }
        let size = self.input_length(Input::Size)?;
        let class = self.text(ProgramField::Input(Input::Class)).trim();
        let callout = format!("{size} {class}").parse::<Callout>().map_err(|error| error.message());
        let limits =
            callout.and_then(|callout| sources.feature_limits(&callout, None).map_err(|error| error.message()));
        Some(limits)
    }

    /// Whether the run has set size or class to other values than those of the form: then it measures another feature.
    fn has_other_inputs(&self, run: &Run) -> bool {
        let size = run.length(Input::Size.parameter());
        let has_other_size = size.is_some_and(|size| Some(size) != self.input_length(Input::Size));
        let has_other_class = match run.variables().get(Input::Class.parameter()) {
            Some(Value::Text(class)) => class.trim() != self.text(ProgramField::Input(Input::Class)).trim(),
            _ => false,
        };
        has_other_size || has_other_class
    }

    /// The diameter that the program measured (Q153), and Fitcheck's verdict on it by its own limits.
    pub fn verdict(&self, sources: &Sources) -> Option<(Length, SizeVerdict)> {
        let limits = self.limits(sources)?.ok()?;
        let run = self.run.as_ref().filter(|run| !self.has_other_inputs(run))?;
        run.status()?;
        let measured = run.length(Parameter::q(153))?;
        Some((measured, judge_size(&limits, measured)))
    }

    /// Whether the program's answer agrees with Fitcheck's: its limits Q33 and Q23, and its status. Known once the
    /// program has measured or has ended otherwise.
    pub fn agreement(&self, sources: &Sources) -> Option<Agreement> {
        let native = self.limits(sources)?;
        let run = self.run.as_ref()?;
        if self.has_other_inputs(run) {
            return run.status().map(|_| Agreement::OtherInputs);
        }
        let Ok(limits) = native else {
            // Both refuse, each in its own words: that is not a difference.
            return match (run.fault.as_ref(), run.status()) {
                (Some(_), _) => Some(Agreement::BothRefuse),
                (None, Some(_)) => Some(Agreement::Differs(vec![message!("program-page-differs-native-refuses")])),
                (None, None) => None,
            };
        };
        let Some(status) = run.status() else {
            return run.fault.as_ref().map(|_| Agreement::Differs(vec![message!("program-page-differs-fault")]));
        };
        let mut differences = Vec::new();
        for (id, parameter, own) in [
            ("program-page-differs-minimum", Parameter::q(33), limits.minimum()),
            ("program-page-differs-maximum", Parameter::q(23), limits.maximum()),
        ] {
            match run.length(parameter) {
                Some(theirs) if theirs != own => {
                    differences.push(Message::new(id).number("program", theirs).number("own", own));
                }
                _ => {}
            }
        }
        if let Some((_, verdict)) = self.verdict(sources).filter(|(_, verdict)| verdict.status != status) {
            let difference = message!("program-page-differs-status");
            differences.push(difference.with("program", &status).with("own", &verdict.status));
        }
        Some(match (differences.is_empty(), &run.fault) {
            (true, None) => Agreement::Agrees,
            (true, Some(_)) => Agreement::Unfinished,
            (false, _) => Agreement::Differs(differences),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_input_is_what_its_cycle_allows() {
        let length = |mm: &str| Ok(Value::Length(mm.parse().unwrap()));
        assert_eq!(Input::Size.read("25,5"), length("25.5"));
        assert_eq!(Input::Height.read("-5"), length("-5"));
        assert_eq!(Input::Angle.read("45"), Ok(Value::Number(45.0)));
        assert_eq!(Input::Class.read(" h7 "), Ok(Value::Text("h7".to_owned())));
        for (input, text) in [
            (Input::Size, "0"),
            (Input::Size, "100000"),
            (Input::Size, ""),
            (Input::Clearance, "-1"),
            (Input::Angle, "x"),
        ] {
            assert!(input.read(text).is_err(), "{input:?} {text}");
        }
    }
}
