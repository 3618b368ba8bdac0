//! AQDEF, the format of Q-DAS: `.dfq`, or `.dfd` with the characteristics and `.dfx` with the values.
//!
//! Lines of a key and a text (`K2110/1 25.0000`), or values without keys, a line for each part. A value is judged when the values of its
//! row are complete, so a file of any size takes the memory of its characteristics. What is not used is told: groups, catalogues, charts,
//! counted parts, error log sheets.
//!
//! | file | what |
//! |---|---|
//! | `keys` | a line, taken apart |
//! | `description`, `declared` | what a file declares; a characteristic of it |
//! | `row`, `values` | values that wait, and a value judged |
//! | `reader` | line by line |
//! | `told`, `error` | what is said |
//! | `dates` | dates in the orders that occur |

mod dates;
mod declared;
mod description;
mod error;
mod keys;
mod reader;
mod row;
mod told;
mod unit;
mod values;

use std::io::Cursor;
use std::path::Path;

pub use error::{AqdefFault, AqdefWarning};
use fitcheck_core::text::PLAIN_LINE_END_BYTES;
use keys::{BETWEEN_FIELDS, Level, Line, line};
use reader::{Half, Reader};

use super::characteristic::{Characteristic, CharacteristicKind, Characteristics};
use super::error::{ImportErrorKind, ImportWarningKind};
use super::imported::Sink;
use super::pieces::Pieces;
use super::source::{Beginning, Source, WHOLE};
use super::{Format, units};

pub(super) const FORMAT: Format = Format {
    name: "aqdef",
    endings: &["dfq", "dfd", "dfx"],
    description: "exchange-format-aqdef",
    recognises,
    read,
    plan: Some(plan),
    line_ends: PLAIN_LINE_END_BYTES,
    has_marks: true,
    shows_end: false,
};

/// How many lines are looked at.
const LOOKED_AT: usize = 20;

impl From<AqdefFault> for ImportErrorKind {
    fn from(fault: AqdefFault) -> Self {
        Self::Aqdef(Box::new(fault))
    }
}

impl From<AqdefWarning> for ImportWarningKind {
    fn from(warning: AqdefWarning) -> Self {
        Self::Aqdef(warning)
    }
}

/// The number of characteristics comes first; without it every line has a key, and one at least a number beside it, or has the signs
/// between values. Numbers alone are values where the name of the file says so.
fn recognises(beginning: &Beginning<'_>) -> bool {
    let text = beginning.text();
    let lines: Vec<Line<'_>> = lines_of(&text).take(LOOKED_AT).collect();
    let mut is_sure = false;
    for (at, line) in lines.iter().enumerate() {
        match line {
            Line::Entry(entry) if at == 0 && entry.key.level() == Level::Count => return true,
            Line::Entry(entry) => is_sure |= entry.has_index,
            // The first field is a number, or empty.
            Line::Values(text) => {
                let first = text.split_once(BETWEEN_FIELDS).map_or(*text, |(first, _)| first);
                let is_value = |sign: char| !sign.is_alphabetic() || matches!(sign, 'e' | 'E');
                if !first.chars().all(is_value) {
                    return false;
                }
                is_sure |= text.contains(BETWEEN_FIELDS) || has_ending(beginning.file, "dfx");
            }
            Line::Blank | Line::Unknown => return false,
        }
    }
    is_sure
}

fn has_ending(file: &str, wanted: &str) -> bool {
    Path::new(file).extension().is_some_and(|ending| ending.eq_ignore_ascii_case(wanted))
}

/// The lines of a text that are not blank.
fn lines_of(text: &str) -> impl Iterator<Item = Line<'_>> {
    fitcheck_core::text::lines(text).map(|(_, text)| line(text)).filter(|line| *line != Line::Blank)
}

/// Whether a file has values and declares nothing: its characteristics are in another one.
fn has_values_alone(beginning: &Beginning<'_>) -> bool {
    let text = beginning.text();
    let mut has_values = false;
    for line in lines_of(&text) {
        match line {
            Line::Entry(entry) => match entry.key.level() {
                Level::Part | Level::Characteristic => return false,
                Level::Value => has_values = true,
                Level::Count | Level::Other => {}
            },
            Line::Values(_) => has_values = true,
            Line::Blank | Line::Unknown => {}
        }
    }
    has_values
}

fn read(source: &mut Source<'_>, sink: &mut Sink<'_>) -> Result<(), ImportErrorKind> {
    let rows = sink.rows();
    let mut reader = Reader::new(source.context.clone(), sink);
    let missing = read_both(source, &mut reader)?;
    reader.end();
    let count = reader.description.count();
    match missing {
        _ if rows < reader.told.sink.rows() => Ok(()),
        Some(file) => Err(AqdefFault::NoValuesBeside { count, file, most: WHOLE >> 20 }.into()),
        None => Err(AqdefFault::NoValues { count }.into()),
    }
}

/// The name of the file beside this one.
fn beside(source: &Source<'_>, ending: &str) -> String {
    Path::new(&*source.context.file).with_extension(ending).display().to_string()
}

/// Reads a file, and the one beside it that has its characteristics or its values; the name of the latter, where there is none.
fn read_both(source: &mut Source<'_>, reader: &mut Reader<'_, '_>) -> Result<Option<String>, ImportErrorKind> {
    if has_values_alone(&source.beginning()) {
        read_description_beside(source, reader)?;
    }
    reader.read(source.pieces(PLAIN_LINE_END_BYTES)?)?;
    if reader.has_values || has_ending(&source.context.file, "dfq") {
        return Ok(None);
    }
    let file = beside(source, "dfx");
    let Some(bytes) = (source.given.beside)("dfx") else { return Ok(Some(file)) };
    reader.half = Half::Values;
    reader.told.warn(1, AqdefWarning::ValuesBeside { file }.into());
    reader.read(Pieces::new(Cursor::new(&bytes), &bytes, PLAIN_LINE_END_BYTES))?;
    Ok(None)
}

fn read_description_beside(source: &Source<'_>, reader: &mut Reader<'_, '_>) -> Result<(), ImportErrorKind> {
    let file = beside(source, "dfd");
    let missing = || AqdefFault::NoDescription { file: file.clone() };
    let bytes = (source.given.beside)("dfd").ok_or_else(missing)?;
    reader.told.declared_beside(file.clone());
    reader.half = Half::Characteristics;
    reader.read(Pieces::new(Cursor::new(&bytes), &bytes, PLAIN_LINE_END_BYTES))?;
    reader.half = Half::Values;
    if reader.description.count() == 0 {
        return Err(missing().into());
    }
    reader.told.warn(1, AqdefWarning::DescriptionBeside { file: file.clone() }.into());
    if 0 < reader.left {
        reader.told.warn(1, AqdefWarning::ValuesLeft { file, count: reader.left }.into());
    }
    Ok(())
}

/// The characteristics of all parts: those that are measured, and are no counts or error logs.
fn plan(source: &mut Source<'_>, found: &mut Characteristics) -> Result<(), ImportErrorKind> {
    let mut nowhere = |_item| {};
    let mut sink = Sink::new(&mut nowhere);
    let mut reader = Reader::new(source.context.clone(), &mut sink);
    if has_values_alone(&source.beginning()) {
        read_description_beside(source, &mut reader)?;
    } else {
        reader.half = Half::Characteristics;
        reader.read(source.pieces(PLAIN_LINE_END_BYTES)?)?;
    }
    let description = &reader.description;
    if let Some((_, expected, found)) = description.miscount() {
        return Err(AqdefFault::Count { expected, found }.into());
    }
    for number in description.characteristics() {
        let Some(asked) = description.of(number) else { continue };
        let line = asked.line();
        let declared = declared::Declared::read(asked);
        if let Some((_, error, _)) = declared.errors.into_iter().next() {
            found.refuse(line, error);
            continue;
        }
        if let Err(unit) = declared.unit {
            if !units::is_of_angle(&unit) {
                found.refuse(line, ImportErrorKind::Unit { unit });
                continue;
            }
            // An angle is no size, and refuses no other characteristic.
            found
                .found
                .push((line, Characteristic { what: CharacteristicKind::Other(unit), ..declared.characteristic }));
            continue;
        }
        if declared.kind.is_none_or(|kind| kind == 0) {
            found.found.push((line, declared.characteristic));
        }
    }
    found.found.sort_by_key(|(line, _)| *line);
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The lines, names, classes and limits of a file's plan, with this file beside it.
    fn planned(name: &str, bytes: &[u8], other: Option<&[u8]>) -> Result<Vec<String>, String> {
        let text = |(line, of): (usize, Characteristic)| {
            let size = |length: Option<fitcheck_core::length::Length>| {
                length.map_or("-".to_owned(), |length| length.to_string())
            };
            format!("{line} {} {} {} {}", of.id(), of.class, size(of.minimum), size(of.maximum))
        };
        Ok(FORMAT.declared(name, bytes, other)?.into_iter().map(text).collect())
    }

    const BOTH: &[u8] = include_bytes!("../../../../../tests/data/aqdef/keys.dfq");
    const CHARACTERISTICS: &[u8] = include_bytes!("../../../../../tests/data/aqdef/two_files.dfd");
    const VALUES: &[u8] = include_bytes!("../../../../../tests/data/aqdef/two_files.dfx");

    #[test]
    fn a_file_declares_a_plan_with_values_without_them_and_beside_them() {
        let expected = ["7 BORE1 25 H7 H7 25 25.021", "24 SHAFT1 25 g6 g6 24.98 24.993"].map(str::to_owned);
        assert_eq!(planned("a.dfq", BOTH, None).unwrap(), expected);
        assert_eq!(planned("a.dfd", CHARACTERISTICS, Some(VALUES)).unwrap(), expected);
        assert_eq!(planned("a.dfx", VALUES, Some(CHARACTERISTICS)).unwrap(), expected);
    }

    #[test]
    fn what_is_no_plan_says_why() {
        let said = |text: &str| planned("a.dfd", text.as_bytes(), None);
        assert_eq!(said("K0100 1\nK2002/1 a\nK2004/1 1\n"), Ok(Vec::new()));
        let cut_off = "K0100 announces 2 characteristics, found 1: the file may be cut off";
        assert_eq!(said("K0100 2\nK2002/1 a\n"), Err(cut_off.to_owned()));
        assert_eq!(said("K0100 1\nK2110/1 a\n"), Err("K2110: a is not a number".to_owned()));
        assert_eq!(said("K0100 1\nK2142/1 km\n"), Err("unknown unit km: use mm, µm or inch".to_owned()));
        let alone = "values without characteristics: a.dfd is missing beside this file";
        assert_eq!(planned("a.dfx", VALUES, None), Err(alone.to_owned()));
    }
}
