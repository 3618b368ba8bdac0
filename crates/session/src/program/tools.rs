//! The tools that the cycles of the open program name in Q330: fixed ones, and parameters to which a tool can be given
//! before a run.

use fitcheck_core::message::Message;
use fitcheck_nc::control::variables::{Parameter, Value};

use super::named_tools::ToolOf;
use super::{Document, ProgramField, ProgramPage};
use crate::tools::NamedTool;

impl ProgramPage {
    /// The tools that the cycles of the open program name, each once.
    pub fn tools(&self) -> &[ToolOf] {
        self.main().map_or(&[], Document::tools)
    }

    /// The parameters among them: a tool can be given to each before a run.
    pub fn tool_inputs(&self) -> impl Iterator<Item = Parameter> {
        self.tools().iter().filter_map(|tool| match tool {
            ToolOf::Parameter(parameter) => Some(*parameter),
            ToolOf::Fixed(_) => None,
        })
    }

    /// What the program itself assigns to a parameter of a tool, where it is a plain value.
    pub fn own_tool(&self, parameter: Parameter) -> Option<&str> {
        self.main()?.assigned().get(&parameter).map(String::as_str)
    }

    /// The tool that a parameter names when the run begins: what is given to it, else what the program assigns. `None` where
    /// neither is known, and where it is 0: no tool.
    pub fn tool_of(&self, parameter: Parameter) -> Option<NamedTool> {
        match self.given.get(&parameter) {
            Some(Value::Text(name)) => Some(NamedTool::Name(name.clone())),
            Some(Value::Number(value)) => NamedTool::of_number(*value),
            Some(Value::Length(length)) => NamedTool::of_number(length.to_mm_f64()),
            None if parameter.family.is_text() => Some(NamedTool::Name(self.own_tool(parameter)?.to_owned())),
            None => NamedTool::of_number(self.own_tool(parameter)?.parse().ok()?),
        }
    }

    /// Takes what was typed or picked for the tool of a parameter; nothing typed is the program's own value.
    pub(super) fn type_tool(&mut self, parameter: Parameter, text: String) {
        if text.is_empty() {
            self.typed.remove(&parameter);
        } else {
            self.typed.insert(parameter, text);
        }
        self.check_inputs();
    }

    /// Reads the fields of the tools anew.
    pub(super) fn check_tools(&mut self) {
        self.errors.retain(|field, _| !matches!(field, ProgramField::Tool(_)));
        let problem = |parameter: Parameter| super::watching::problem(parameter, self.typed.get(&parameter)?);
        let wrong: Vec<(ProgramField, Message)> = self
            .tool_inputs()
            .filter_map(|parameter| Some((ProgramField::Tool(parameter), problem(parameter)?)))
            .collect();
        self.errors.extend(wrong);
    }
}
