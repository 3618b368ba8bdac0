//! The tools that the cycles of a program name (Q330).

use fitcheck_core::probing::cycle::{Control, Range};
use fitcheck_core::probing::cycles::cycles_of;
use fitcheck_nc::control::variables::Parameter;
use fitcheck_nc::program::{Body, CycleBlock, CycleValue, Operand, Program, TextOperand};

use crate::tools::NamedTool;

/// What Q330 of a program's cycle says.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum ToolOf {
    /// Always this tool.
    Fixed(NamedTool),
    /// The value of a parameter is the tool.
    Parameter(Parameter),
}

/// The tools that a program's cycles name, each once, in the order of the program.
pub(super) fn named(program: &Program) -> Vec<ToolOf> {
    let mut found: Vec<ToolOf> = Vec::new();
    for block in program.blocks() {
        let Body::Probe(block) = &block.body else { continue };
        if let Some(tool) = of_block(block, program.notation().control()).filter(|tool| !found.contains(tool)) {
            found.push(tool);
        }
    }
    found
}

fn of_block(block: &CycleBlock, control: Control) -> Option<ToolOf> {
    let cycle = cycles_of(control).find(|cycle| cycle.code == block.number)?;
    let is_tool = |name: String| cycle.parameter_named(&name).is_some_and(|parameter| parameter.range == Range::Tool);
    let line = block.lines.iter().find(|line| is_tool(line.parameter.to_string()))?;
    match &line.value {
        CycleValue::Number { value: Operand::Number(number), .. } => NamedTool::of_number(*number).map(ToolOf::Fixed),
        CycleValue::Number { value: Operand::Parameter { parameter, is_negative: false }, .. }
        | CycleValue::Text(TextOperand::Parameter(parameter)) => Some(ToolOf::Parameter(*parameter)),
        CycleValue::Text(TextOperand::Text(name)) => Some(ToolOf::Fixed(NamedTool::Name(name.clone()))),
        // No tool has a number below zero.
        CycleValue::Number { .. } | CycleValue::Word(_) => None,
    }
}
