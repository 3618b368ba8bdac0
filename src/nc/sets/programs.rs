//! The programs and the mask of a set, made from the built-in ones: block by block, with the differences changed.

use super::error::SetRemark;
use super::kind::{self, Called, NcKind};
use super::names::{Control, Names};
use super::{NcFeature, Planned, Target};
use crate::control::variables::Parameter;
use crate::length::Length;
use crate::nc::program::{Body, CycleValue, Expression, Operand, Program, TextExpression, TextOperand, Unit, write};
use crate::probing::cycle::{Key, Meaning, Window};
use crate::shipped;
use crate::tolerance::Feature;
use crate::words::Dialogue;

/// The last block that computes a limit: after it both are known.
const MINIMUM: Parameter = Parameter::q(33);

/// The nominal diameter of the cycles.
const NOMINAL_DIAMETER: Parameter = Parameter::q(262);

/// The parameter that replaces it if it must lie between the limits.
const BETWEEN: Parameter = Parameter::q(62);

/// Q62 becomes the nominal size or, if that lies outside, the limit next to it (TNC7 manual 81762x-19, cycle 421).
const BETWEEN_LIMITS: &[u8] = b"Q62 = Q1 ;Q33 <= Q62 <= Q23
FN 11: IF +Q62 GT +Q33 GOTO LBL 97
Q62 = Q33
LBL 97
FN 12: IF +Q62 LT +Q23 GOTO LBL 98
Q62 = Q23
LBL 98
";

/// Blocks with their comments.
type Blocks = Vec<(Body, String)>;

/// The bodies of blocks, without BEGIN and END.
fn blocks(text: &[u8]) -> Blocks {
    let Ok((program, _warnings)) = Program::read(text) else { return Blocks::new() };
    let blocks = program.blocks().iter().enumerate();
    let inner = blocks.filter(|(_, block)| !matches!(block.body, Body::Begin { .. } | Body::End { .. }));
    let comment = |number| program.comment_of(number).unwrap_or_default().to_owned();
    inner.map(|(number, block)| (block.body.clone(), comment(number))).collect()
}

/// A built-in program; these are part of Fitcheck, and tests make a set in every language.
fn shipped_program(name: &str, language: Dialogue) -> Blocks {
    blocks(shipped::file(shipped::NC, &format!("{name}_{language}.h")).unwrap_or_default())
}

/// The file of a program. All of it is ASCII, since names and texts are.
fn written(file: &str, blocks: &[(Body, String)]) -> Vec<u8> {
    // A program has the name of its file, without the ending.
    let name = file.rsplit_once('.').map_or(file, |(stem, _)| stem).to_owned();
    let begin = [bare(Body::Begin { name: name.clone(), unit: Unit::Mm })];
    let end = [bare(Body::End { name, unit: Unit::Mm })];
    let all = begin.iter().chain(blocks).chain(&end);
    write::program(all.map(|(body, comment)| (body, comment.as_str()))).into_bytes()
}

/// A block without a comment.
fn bare(body: Body) -> (Body, String) {
    (body, String::new())
}

fn print(names: &Names<'_>, called: Called, output: String) -> (Body, String) {
    bare(Body::Print { mask: names.operand(names.mask(called)), output: TextOperand::Text(output) })
}

/// The main program: for each feature its parameters, the call, a file with its result, and a stop.
pub(super) fn main(names: &Names<'_>, planned: &[Planned<'_>]) -> Vec<u8> {
    let blocks = shipped_program("8255", names.target.language);
    // Blocks that occur only once are before the first parameter or after the stop.
    let is_parameter = |(body, _): &(Body, String)| matches!(body, Body::Assign { .. } | Body::AssignText { .. });
    let first = blocks.iter().position(is_parameter).unwrap_or_default();
    let behind = blocks.iter().position(|(body, _)| matches!(body, Body::Stop(_))).map_or(first, |at| at + 1);
    let (head, rest) = blocks.split_at(first);
    let (each, tail) = rest.split_at(behind - first);
    let mut made = head.to_vec();
    for planned in planned {
        let text = format!("{}: {}", planned.feature.name, planned.feature.callout);
        made.push(bare(Body::Heading { depth: 2, text }));
        made.extend(each.iter().flat_map(|block| main_block(block, names, planned.feature)));
    }
    made.extend_from_slice(tail);
    written(&names.main, &made)
}

/// A block of the main program for a feature.
fn main_block((body, comment): &(Body, String), names: &Names<'_>, feature: &NcFeature) -> Blocks {
    let comment = comment.replace(Control::Itnc530.clearance(), names.target.control.clearance());
    match body {
        Body::Assign { to, .. } => {
            let value = match to.number {
                1 => feature.callout.nominal().to_mm_f64(),
                11 => feature.x.to_mm_f64(),
                21 => feature.y.to_mm_f64(),
                31 => feature.z.to_mm_f64(),
                41 if feature.kind != NcKind::Diameter => return axis_blocks(*to, names, feature.kind),
                41 => feature.angle.to_degrees_f64(),
                51 => feature.clearance.to_mm_f64(),
                _ => feature.clearance_height.to_mm_f64(),
            };
            vec![(Body::Assign { to: *to, value: Expression::Value(Operand::Number(value)) }, comment)]
        }
        Body::AssignText { to, .. } => {
            let class = feature.callout.class().map(|class| class.to_string()).unwrap_or_default();
            let value = TextExpression::Value(TextOperand::Text(class));
            vec![(Body::AssignText { to: *to, value }, comment)]
        }
        Body::CallProgram(_) => {
            let result = names.path(&names.result(&feature.name));
            let called = feature.kind.called();
            vec![bare(Body::CallProgram(names.operand(names.check(called)))), print(names, called, result)]
        }
        body => vec![(body.clone(), comment)],
    }
}

/// The measured axis in place of the angle, and for a face the direction.
fn axis_blocks(to: Parameter, names: &Names<'_>, kind: NcKind) -> Blocks {
    let called = kind.called();
    let named = |meanings: &[Meaning]| {
        let cycle = called.cycle(Feature::Shaft);
        let parameter = meanings.iter().find_map(|meaning| cycle?.meant(*meaning));
        parameter.map_or("", |parameter| parameter.name_in(names.target.language)).to_owned()
    };
    let assign = |to, value, comment| (Body::Assign { to, value: Expression::Value(Operand::Number(value)) }, comment);
    let [x, y, z] = kind.direction();
    let mut made = vec![assign(
        to,
        x.abs() + 2.0 * y.abs() + 3.0 * z.abs(),
        named(&[Meaning::AxisOfPlane, Meaning::MeasuredAxis]),
    )];
    if called == Called::Face {
        made.push(assign(Parameter::q(42), x + y + z, named(&[Meaning::Direction])));
    }
    made
}

/// The called program: other paths, for TNC7 a nominal size between the limits, and the cycle of the shape.
pub(super) fn check(names: &Names<'_>, called: Called) -> Vec<u8> {
    let mut cycles = [Feature::Hole, Feature::Shaft].into_iter();
    let moves_nominal = names.target.control.wants_nominal_between_limits();
    let mut made = Blocks::new();
    let mut tables = [Feature::Hole, Feature::Shaft].into_iter();
    for (body, comment) in shipped_program("82551", names.target.language) {
        match body {
            Body::TableOpen(_) => {
                let table = tables.next().map_or("", |feature| names.table(feature));
                made.push(bare(Body::TableOpen(names.operand(table))));
            }
            Body::Print { .. } => made.push(print(names, called, "SCREEN:".to_owned())),
            Body::Probe(_) if called != Called::Diameter => {
                let feature = cycles.next().unwrap_or(Feature::Shaft);
                let nominal = if moves_nominal { kind::BETWEEN } else { kind::NOMINAL };
                made.extend(blocks(&called.blocks(feature, nominal, names.target.language)));
            }
            Body::Probe(mut cycle) if moves_nominal => {
                for line in cycle.lines.iter_mut().filter(|line| line.parameter == NOMINAL_DIAMETER.into()) {
                    let value = Operand::Parameter { parameter: BETWEEN, is_negative: false };
                    line.value = CycleValue::Number { value, text: format!("+{BETWEEN}") };
                }
                made.push((Body::Probe(cycle), comment));
            }
            Body::Assign { to, .. } if moves_nominal && to == MINIMUM => {
                made.push((body, comment));
                made.extend(blocks(BETWEEN_LIMITS));
            }
            body => made.push((body, comment)),
        }
    }
    written(names.check(called), &made)
}

/// The mask, lines in CRLF. iTNC 530: that of a diameter as built in, the Dutch one as NC-Solution 8255 has it. Otherwise every
/// record ends in a semicolon, with `F` instead of `LF` if the control has it.
pub(super) fn mask(target: &Target, called: Called) -> Vec<u8> {
    let window = match called.cycle(Feature::Hole).map(|cycle| cycle.window) {
        Some(Window::Own(name)) if called != Called::Diameter => name,
        _ => "82552",
    };
    let original = shipped::file(shipped::MASKS, &format!("{window}_{}.a", target.language));
    let text = String::from_utf8_lossy(original.unwrap_or_default());
    let limits: Vec<(String, &str)> = match called.cycle(Feature::Hole) {
        Some(cycle) if called != Called::Diameter => {
            let of = |meanings: &[Meaning], to| {
                meanings
                    .iter()
                    .find_map(|meaning| cycle.meant(*meaning))
                    .map(|parameter| (parameter.key.to_string(), to))
            };
            let maximum = of(&[Meaning::MaximumWidth, Meaning::MaximumCoordinate], "Q23");
            let minimum = of(&[Meaning::MinimumWidth, Meaning::MinimumCoordinate], "Q33");
            maximum.into_iter().chain(minimum).collect()
        }
        _ => Vec::new(),
    };
    let number = if target.control == Control::Itnc530 { "LF" } else { "F" };
    let is_as_built_in = target.control == Control::Itnc530 && called == Called::Diameter;
    let lines = text.lines().map(|line| {
        if is_as_built_in {
            return format!("{line}\r\n");
        }
        // The limits are those of the called program, as in the mask of a diameter.
        let line = limits.iter().fold(line.trim_end().replace("LF", number), |line, (from, to)| line.replace(from, to));
        format!("{}{}\r\n", line, if line.ends_with(';') { "" } else { ";" })
    });
    lines.collect::<String>().into_bytes()
}

/// The nominal diameter that the check program passes to the cycle, if it differs from the nominal size.
pub(super) fn moved_nominal(planned: Planned<'_>, control: Control) -> Option<SetRemark> {
    let limits = planned.limits;
    let called = planned.feature.kind.called();
    let cycle = called.cycle(limits.feature)?;
    // A coordinate has no nominal size.
    let parameter = [Meaning::Diameter, Meaning::Width].iter().find_map(|meaning| cycle.meant(*meaning))?.key;
    let deviation = Key::Q(if called == Called::Diameter { 163 } else { 166 });
    let value: Length = limits.nominal.max(limits.minimum()).min(limits.maximum());
    (control.wants_nominal_between_limits() && value != limits.nominal).then(|| SetRemark::MovedNominal {
        name: planned.feature.name.clone(),
        callout: planned.feature.callout,
        value,
        parameter,
        deviation,
    })
}
