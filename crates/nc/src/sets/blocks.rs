//! What the programs of a set share: all are made from the built-in ones, block by block.

use fitcheck_core::words::Dialogue;
use fitcheck_shipped as shipped;

use super::called::Called;
use super::names::Names;
use crate::control::variables::Parameter;
use crate::program::{Body, Expression, Operand, Program, TextOperand, Unit, write};

/// Blocks with their comments.
pub(super) type Blocks = Vec<(Body, String)>;

/// The last block that computes a limit: after it both are known.
pub(super) const MINIMUM: Parameter = Parameter::q(33);

/// The bodies of blocks, without BEGIN and END.
pub(super) fn blocks(text: &[u8]) -> Blocks {
    let Ok((program, _warnings)) = Program::read(text) else { return Blocks::new() };
    let blocks = program.blocks().iter().enumerate();
    let inner = blocks.filter(|(_, block)| !matches!(block.body, Body::Begin { .. } | Body::End { .. }));
    let comment = |number| program.comment_of(number).map_or_else(String::new, str::to_owned);
    inner.map(|(number, block)| (block.body.clone(), comment(number))).collect()
}

/// A built-in program; these are part of Fitcheck, tests make a set in every language, and no set without blocks passes its proof.
pub(super) fn shipped_program(name: &str, language: Dialogue) -> Blocks {
    shipped::file(shipped::NC, &format!("{name}_{language}.h")).map_or_else(Blocks::new, blocks)
}

/// The file of a program. All of it is ASCII, since names and texts are.
pub(super) fn written(file: &str, blocks: &[(Body, String)]) -> Vec<u8> {
    // A program has the name of its file, without the ending.
    let name = file.rsplit_once('.').map_or(file, |(stem, _)| stem).to_owned();
    let begin = [bare(Body::Begin { name: name.clone(), unit: Unit::Mm })];
    let end = [bare(Body::End { name, unit: Unit::Mm })];
    let all = begin.iter().chain(blocks).chain(&end);
    write::program(all.map(|(body, comment)| (body, comment.as_str()))).into_bytes()
}

/// A block without a comment.
pub(super) fn bare(body: Body) -> (Body, String) {
    (body, String::new())
}

pub(super) fn print(names: &Names<'_>, called: Called, output: String) -> (Body, String) {
    bare(Body::Print { mask: names.operand(names.mask(called)), output: TextOperand::Text(output) })
}

pub(super) fn number(to: Parameter, value: f64, comment: String) -> (Body, String) {
    (Body::Assign { to, value: Expression::Value(Operand::Number(value)) }, comment)
}

/// Title, the blocks that find the limits, and those that measure: parted before the headings of the second and third.
pub(super) fn parts(made: Blocks) -> [Blocks; 3] {
    let is_tool = |(body, _): &(Body, String)| matches!(body, Body::ToolCall { .. });
    let is_section = |(body, _): &(Body, String)| matches!(body, Body::Heading { depth: 2, .. });
    let tool = made.iter().position(is_tool).unwrap_or(made.len());
    let measure = made.iter().take(tool).rposition(is_section).unwrap_or(tool);
    let find = made.iter().take(measure).take_while(|block| !is_section(block)).count();
    let mut title = made;
    let rest = title.split_off(measure);
    let lookup = title.split_off(find);
    [title, lookup, rest]
}
