//! From bodies to blocks as a control writes them: for programs that Fitcheck makes.
//!
//! Layout: block numbers padded to two characters, two blanks before axis words (one before incremental ones), explicit
//! signs, blanks in formulas, cycle lines indented by four, parameter and value padded to ten characters. The text
//! reads back as the same body. A program that was read is not written here: it keeps its text.

use super::block::{Body, Columns, Condition, FileFunction, Tool};
use super::cycle_block::{CycleBlock, CycleValue};
use super::expression::TextExpression;
use super::movement::{AxisWord, Feed, MachineFunction, Movement};
use super::operand::{Operand, TextOperand};
use super::words::{AXES, DEEPEST, RELATIONS, word};
use super::write_formula::{formula, quoted, signed, text_formula, word_value};
use crate::control::variables::{Family, Parameter};

/// A program of bodies with their comments: blocks numbered from 0, lines ended by CRLF. [`Body::Other`] is left out.
pub fn program<'a>(blocks: impl IntoIterator<Item = (&'a Body, &'a str)>) -> String {
    let mut text = String::new();
    let mut number = 0;
    for (body, comment) in blocks {
        let lines = commented(number, body, comment);
        number += u32::from(!lines.is_empty());
        for line in lines {
            text.push_str(&line);
            text.push_str("\r\n");
        }
    }
    text
}

/// The lines of a block; none for a block that is only read ([`Body::Other`], [`Body::PassedOver`], [`Body::Frame`],
/// [`Body::SystemRead`], those of lathe controls only), because a body does not hold its text.
///
/// Characters that would end a text are removed: line ends, quotation marks within others, a `~` at a line's end.
///
/// ```
/// use fitcheck_nc::program::{Body, Operand, Target, write};
///
/// let call = Body::CallLabel { label: Target::Name("LOOP".to_owned()), repeat: Some(Operand::Number(3.0)) };
/// assert_eq!(write::block(7, &call), ["7  CALL LBL \"LOOP\" REP 3"]);
/// ```
pub fn block(number: u32, body: &Body) -> Vec<String> {
    commented(number, body, "")
}

/// The lines of a block with a comment after it; for a cycle, after the first line. A heading takes everything after it
/// as its text.
pub fn commented(number: u32, body: &Body, comment: &str) -> Vec<String> {
    let comment = cleaned(comment);
    let front = format!("{number:<2} ");
    let (first, cycle) = match body {
        Body::Other
        | Body::PassedOver(_)
        | Body::Frame(_)
        | Body::SystemRead { .. }
        | Body::Branch { .. }
        | Body::Subprogram { .. }
        | Body::Show(_)
        | Body::Input { .. }
        | Body::ReadNoFurther => return Vec::new(),
        Body::Nothing => (format!(";{comment}"), None),
        Body::Probe(cycle) => (format!("TCH PROBE {} {}", cycle.number, cleaned(&cycle.name)), Some(cycle)),
        Body::CycleDefinition(cycle) => (format!("CYCL DEF {} {}", cycle.number, cleaned(&cycle.name)), Some(cycle)),
        Body::GlobalDefinition(cycle) => (format!("GLOBAL DEF {} {}", cycle.number, cleaned(&cycle.name)), Some(cycle)),
        body => (said(body), None),
    };
    let mut line = format!("{front}{}", first.trim_end());
    if !comment.is_empty() && *body != Body::Nothing {
        line.push_str(" ;");
        line.push_str(&comment);
    }
    let mut lines = vec![line];
    if let Some(cycle) = cycle {
        lines.extend(cycle_lines(cycle));
    }
    let last = lines.len() - 1;
    for (index, line) in lines.iter_mut().enumerate() {
        let end = line.trim_end_matches(|c: char| c == '~' || c.is_whitespace()).len();
        line.truncate(end);
        if index < last {
            line.push_str(" ~");
        } else if matches!(body, Body::Begin { .. } | Body::End { .. }) && comment.is_empty() {
            // As controls do.
            line.push(' ');
        }
    }
    lines
}

fn cycle_lines(cycle: &CycleBlock) -> impl Iterator<Item = String> {
    cycle.lines.iter().map(|line| {
        let value = match &line.value {
            CycleValue::Number { text, .. } => text.clone(),
            CycleValue::Text(text) => text_operand(text),
            CycleValue::Word(word) => format!(" {word}"),
        };
        let set = format!("{}={value}", line.parameter);
        match cleaned(&line.comment) {
            comment if comment.is_empty() => format!("    {set}"),
            comment => format!("    {set:<10} ;{comment}"),
        }
    })
}

/// The text of a block of one line.
fn said(body: &Body) -> String {
    match body {
        Body::Begin { name, unit } => format!("BEGIN PGM {} {unit}", cleaned(name)),
        Body::End { name, unit } => format!("END PGM {} {unit}", cleaned(name)),
        Body::Heading { depth, text } => {
            let text = cleaned(text);
            let blanks = (*depth).clamp(1, DEEPEST) * 2 - 1;
            // Without a text, blanks at the end would be lost.
            if text.is_empty() { format!("*{:blanks$}-", "") } else { format!("* -{:blanks$}{text}", "") }
        }
        Body::Label(label) => format!("LBL {label}"),
        Body::CallLabel { label, repeat: None } => format!("CALL LBL {label}"),
        Body::CallLabel { label, repeat: Some(repeat) } => format!("CALL LBL {label} REP {}", plain(*repeat)),
        Body::CallProgram(path) => format!("CALL PGM {}", path_operand(path)),
        Body::SelectProgram(path) => format!("SEL PGM {}", path_operand(path)),
        Body::CallSelectedProgram => "CALL SELECTED PGM".to_owned(),
        Body::Mode(mode) => format!("FUNCTION MODE {mode}"),
        Body::Assign { to, value } => formula(*to, value),
        Body::Undefine(parameter) => format!("FN 0: {parameter} SET UNDEFINED"),
        Body::AssignText { to, value: text @ TextExpression::Value(TextOperand::Text(_)) } => {
            format!("DECLARE STRING {to} = {}", text_formula(text))
        }
        Body::AssignText { to, value } => format!("{to} = {}", text_formula(value)),
        Body::Jump { condition, label } => format!("{} GOTO LBL {label}", jump(condition)),
        Body::Error(number) => format!("FN 14: ERROR= {}", word_value(*number)),
        Body::Print { mask, output } => {
            format!("FN 16: F-PRINT {} / {}", path_operand(mask), path_operand(output))
        }
        Body::File(FileFunction::Copy { from, to }) => {
            format!("FUNCTION FILECOPY {} TO {}", text_operand(from), text_operand(to))
        }
        Body::File(FileFunction::Move { from, to }) => {
            format!("FUNCTION FILEMOVE {} TO {}", text_operand(from), text_operand(to))
        }
        Body::File(FileFunction::Delete(path)) => format!("FUNCTION FILEDELETE {}", text_operand(path)),
        Body::TableOpen(path) => format!("FN 26: TABOPEN {}", path_operand(path)),
        Body::TableRead { to, row, columns } => format!("FN 28: TABREAD {to} = {}", cell(*row, columns)),
        Body::TableWrite { row, columns, from } => format!("FN 27: TABWRITE {} = {from}", cell(*row, columns)),
        Body::ToolCall { tool, axis, rest } => {
            let tool = match tool {
                None => String::new(),
                Some(Tool::Number(number)) => format!(" {}", plain(*number)),
                Some(Tool::Name(name)) => format!(" {}", text_operand(name)),
            };
            let axis = axis.map_or(String::new(), |axis| format!(" {}", word(&AXES, axis)));
            format!("TOOL CALL{tool}{axis} {}", cleaned(rest))
        }
        Body::Move(movement) => line(movement),
        Body::MachineFunctions(functions) => machine_functions(functions),
        Body::Stop(functions) => format!("STOP {}", machine_functions(functions)),
        Body::Nothing
        | Body::Other
        | Body::Probe(_)
        | Body::CycleDefinition(_)
        | Body::GlobalDefinition(_)
        | Body::PassedOver(_)
        | Body::Frame(_)
        | Body::SystemRead { .. }
        | Body::Branch { .. }
        | Body::Subprogram { .. }
        | Body::Show(_)
        | Body::Input { .. }
        | Body::ReadNoFurther => String::new(),
    }
}

fn line(movement: &Movement) -> String {
    let mut words = vec!["L".to_owned()];
    for AxisWord { axis, is_incremental, value } in &movement.axes {
        let front = if *is_incremental { 'I' } else { ' ' };
        words.push(format!("{front}{}{}", word(&AXES, *axis), signed(*value)));
    }
    words.extend(movement.compensation.clone());
    words.extend(movement.feed.map(|feed| match feed {
        Feed::Rapid => "FMAX".to_owned(),
        Feed::Auto => "FAUTO".to_owned(),
        Feed::Value(value) => format!("F{}", plain(value)),
    }));
    words.push(machine_functions(&movement.machine));
    words.join(" ")
}

fn machine_functions(functions: &[MachineFunction]) -> String {
    let words: Vec<String> = functions
        .iter()
        .map(|function| match cleaned(&function.rest) {
            rest if rest.is_empty() => format!("M{}", function.number),
            rest => format!("M{} {rest}", function.number),
        })
        .collect();
    words.join(" ")
}

fn jump(condition: &Condition) -> String {
    match condition {
        Condition::Compare(left, relation, right) => {
            let of = RELATIONS.iter().find(|(.., known)| known == relation);
            let (number, word) = of.map_or((9, "EQU"), |&(number, word, _)| (number, word));
            format!("FN {number}: IF {} {word} {}", signed(*left), signed(*right))
        }
        Condition::IsDefined(parameter) => format!("FN 9: IF {} IS DEFINED", with_plus(*parameter)),
        Condition::IsUndefined(parameter) => format!("FN 9: IF {} IS UNDEFINED", with_plus(*parameter)),
    }
}

fn with_plus(parameter: Parameter) -> String {
    if parameter.family == Family::Qs { parameter.to_string() } else { format!("+{parameter}") }
}

fn cell(row: Operand, columns: &Columns) -> String {
    match columns {
        Columns::Names(names) => format!("{}/{}", word_value(row), quoted(&names.join(","))),
        Columns::Parameter(parameter) => format!("{}/{parameter}", word_value(row)),
    }
}

/// A number or a parameter without a plus sign.
fn plain(operand: Operand) -> String {
    signed(operand).trim_start_matches('+').to_owned()
}

fn text_operand(text: &TextOperand) -> String {
    match text {
        TextOperand::Text(text) => quoted(text),
        TextOperand::Parameter(parameter) => parameter.to_string(),
    }
}

/// A path has no quotation marks, unless it would be read back differently.
fn path_operand(path: &TextOperand) -> String {
    match path {
        TextOperand::Parameter(parameter) => parameter.to_string(),
        TextOperand::Text(text) => {
            let is_plain = text.starts_with(|c: char| c.is_ascii_alphanumeric() || c == '.' || c == '\\')
                && !text.starts_with(['Q', 'q'])
                && !text.contains(['/', ';', '"', '~'])
                && text.trim() == text
                && !text.contains(char::is_control);
            if is_plain { text.clone() } else { quoted(text) }
        }
    }
}

/// A text of one line.
fn cleaned(text: &str) -> String {
    text.replace(char::is_control, " ").trim().to_owned()
}
