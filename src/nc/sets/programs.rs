//! The programs and the mask of a set, made from the shipped ones: block by block, with what differs changed.

use super::error::SetRemark;
use super::listing::{Listing, formula_number};
use super::names::{Control, Names};
use super::{Planned, Target};
use crate::control::variables::Parameter;
use crate::length::Length;
use crate::nc::machine::Shipped;
use crate::nc::program::{Body, Program};
use crate::tolerance::Feature;
use crate::words::Dialogue;

/// The last block that computes a limit: behind it both are known.
const MINIMUM: Parameter = Parameter::q(33);

/// Q62 becomes the nominal size, or the limit next to it where it lies outside (TNC7 manual 81762x-19, cycle 421).
const BETWEEN_LIMITS: [&str; 7] = [
    "Q62 = Q1 ;Q33 <= Q62 <= Q23",
    "FN 11: IF +Q62 GT +Q33 GOTO LBL 97",
    "Q62 = Q33",
    "LBL 97",
    "FN 12: IF +Q62 LT +Q23 GOTO LBL 98",
    "Q62 = Q23",
    "LBL 98",
];

/// A block of a shipped program: what it says and how it is written, without its number.
struct ShippedBlock {
    body: Body,
    text: String,
}

impl ShippedBlock {
    /// The comment behind the block, with its semicolon.
    fn comment(&self) -> &str {
        self.text.find(" ;").and_then(|at| self.text.get(at..)).unwrap_or_default()
    }
}

/// A shipped file of a language.
fn shipped(name: &str, language: Dialogue, ending: &str) -> &'static [u8] {
    // They are part of Fitcheck, and tests make a set in every language.
    Shipped::file(&format!("{name}_{language}.{ending}")).unwrap_or_default()
}

/// The blocks of a shipped program between BEGIN and END.
fn blocks(bytes: &[u8]) -> Vec<ShippedBlock> {
    let Ok((program, _warnings)) = Program::read(bytes) else { return Vec::new() };
    let inner = program.blocks().iter().enumerate();
    let inner = inner.filter(|(_, block)| !matches!(block.body, Body::Begin { .. } | Body::End { .. }));
    inner
        .map(|(number, block)| {
            let lines: Vec<&str> = program.text_of(number).collect();
            let text = lines.join("\n");
            let text = text.trim_start_matches(|c: char| c.is_ascii_digit()).trim_start_matches(' ').to_owned();
            ShippedBlock { body: block.body.clone(), text }
        })
        .collect()
}

/// The name of a program: its file's without the ending.
fn stem(file: &str) -> &str {
    file.rsplit_once('.').map_or(file, |(stem, _)| stem)
}

/// The main program: for each feature its parameters, the call, a file with its result, and a stop.
pub(super) fn main(names: &Names<'_>, planned: &[Planned<'_>]) -> Vec<u8> {
    let blocks = blocks(shipped("8255", names.target.language, "h"));
    let mut listing = Listing::new(stem(&names.main));
    // What stands once stands before the first parameter and behind the stop.
    let is_parameter = |block: &ShippedBlock| matches!(block.body, Body::Assign { .. } | Body::AssignText { .. });
    let first = blocks.iter().position(is_parameter).unwrap_or_default();
    let behind = blocks.iter().position(|block| matches!(block.body, Body::Stop(_))).map_or(first, |at| at + 1);
    let (head, rest) = blocks.split_at(first);
    let (each, tail) = rest.split_at(behind - first);
    listing.extend(head.iter().map(|block| block.text.clone()));
    for planned in planned {
        listing.push(format!("* -   {}: {}", planned.feature.name, planned.feature.callout));
        for block in each {
            main_block(&mut listing, block, names, *planned);
        }
    }
    listing.extend(tail.iter().map(|block| block.text.clone()));
    listing.bytes()
}

fn main_block(listing: &mut Listing, block: &ShippedBlock, names: &Names<'_>, planned: Planned<'_>) {
    let feature = planned.feature;
    let comment = block.comment().replace(Control::Itnc530.clearance(), names.target.control.clearance());
    let angle = feature.angle.to_string().trim_end_matches('°').parse().unwrap_or_default();
    match &block.body {
        Body::Assign { to, .. } => {
            let value = match to.number {
                1 => feature.callout.nominal(),
                11 => feature.x,
                21 => feature.y,
                31 => feature.z,
                41 => angle,
                51 => feature.clearance,
                _ => feature.clearance_height,
            };
            listing.push(format!("{to} = {}{comment}", formula_number(value)));
        }
        Body::AssignText { to, .. } => {
            let class = feature.callout.class().map(|class| class.to_string()).unwrap_or_default();
            listing.push(format!("DECLARE STRING {to} = \"{class}\"{comment}"));
        }
        Body::CallProgram(_) => {
            listing.push(format!("CALL PGM {}", names.path(&names.check)));
            let result = names.path(&names.result(&feature.name));
            listing.push(format!("FN 16: F-PRINT {} / {result}", names.path(&names.mask)));
        }
        _ => listing.push(block.text.clone()),
    }
}

/// The called program: other paths, and for TNC7 a nominal diameter between the limits.
pub(super) fn check(names: &Names<'_>) -> Vec<u8> {
    let original = shipped("82551", names.target.language, "h");
    let moves_nominal = names.target.control.wants_nominal_between_limits();
    let mut listing = Listing::new(stem(&names.check));
    let mut tables = [Feature::Hole, Feature::Shaft].into_iter();
    for block in blocks(original) {
        match &block.body {
            Body::TableOpen(_) => {
                let table = tables.next().map_or("", |feature| names.table(feature));
                listing.push(format!("FN 26: TABOPEN {}", names.path(table)));
            }
            Body::Print { .. } => listing.push(format!("FN 16: F-PRINT {} / SCREEN:", names.path(&names.mask))),
            Body::Probe(_) if moves_nominal => listing.push(block.text.replace("Q262=+Q1 ", "Q262=+Q62")),
            Body::Assign { to, .. } if *to == MINIMUM => {
                listing.push(block.text);
                if moves_nominal {
                    listing.extend(BETWEEN_LIMITS.map(str::to_owned));
                }
            }
            _ => listing.push(block.text),
        }
    }
    listing.bytes()
}

/// The mask: every record ends in a semicolon, lines in CRLF; `F` in place of `LF` where the control knows it.
pub(super) fn mask(target: &Target) -> Vec<u8> {
    let original = shipped("82552", target.language, "a");
    let text = String::from_utf8_lossy(original);
    let number = if target.control == Control::Itnc530 { "LF" } else { "F" };
    let lines = text.lines().map(|line| {
        let line = line.trim_end().replace("LF", number);
        format!("{}{}\r\n", line, if line.ends_with(';') { "" } else { ";" })
    });
    lines.collect::<String>().into_bytes()
}

/// The nominal diameter that the check program gives to the cycle, where it is another than the nominal size.
pub(super) fn moved_nominal(planned: Planned<'_>, control: Control) -> Option<SetRemark> {
    let limits = planned.limits;
    let value: Length = limits.nominal.max(limits.minimum()).min(limits.maximum());
    (control.wants_nominal_between_limits() && value != limits.nominal).then(|| SetRemark::MovedNominal {
        name: planned.feature.name.clone(),
        callout: planned.feature.callout,
        value,
    })
}
