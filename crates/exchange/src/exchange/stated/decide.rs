//! The units of the columns of a file, decided by its first rows.

use csv::StringRecord;
use fitcheck_core::length::Unit;

use super::late::{late, stray_row};
use super::mention::{Mention, Word, key, mentions, of_name, word};
use super::{Stated, differ, joined, sign, squeezed};
use crate::exchange::beside::BesideColumn;
use crate::exchange::cell::Cells as _;
use crate::exchange::column::name_of;
use crate::exchange::columns::Columns;
use crate::exchange::error::ImportErrorKind;
use crate::exchange::given::shorten;
use crate::exchange::limits::LimitColumns;
use crate::exchange::role::Role;
use crate::exchange::sample::Sample;
use crate::exchange::vocabulary::Rank;
use crate::exchange::{cells, units};
use fitcheck_core::text::Within as _;

/// Decides the units of the columns of a file by its first rows.
///
/// # Errors
/// What contradicts, or is not understood.
#[expect(clippy::too_many_lines, reason = "each thing that may state a unit, one after the other")]
pub(in crate::exchange) fn decide(sample: &Sample, columns: &mut Columns) -> Result<(), ImportErrorKind> {
    let is_header = |line: usize| columns.header == Some(line);
    let header = sample.rows.iter().find(|(line, _)| is_header(*line)).map(|(_, cells)| cells);
    let names = header.filter(|names| columns.names_known || names.len() == columns.count);
    let name = |at: usize| names.map_or("", |names| names.cell(at));
    let data = sample.rows.within(sample.above..);
    let mut stated = Stated {
        row: sample.units_row.and_then(|at| sample.rows.get(at)).cloned(),
        header: header.map_or_else(String::new, |names| squeezed(names.iter())),
        first: data.first().map_or(usize::MAX, |(line, _)| *line),
        is_given: sample.given.is_some(),
        ..Stated::default()
    };
    let is_used: Vec<usize> = columns.used().into_iter().chain(columns.beside.iter().map(BesideColumn::at)).collect();
    let free: Vec<usize> = (0..columns.count).filter(|at| !is_used.contains(at)).collect();
    // What stands above the rows: titles, comments, and names of columns in which nothing stands.
    let is_row_of_units = |line: usize| stated.row.as_ref().is_some_and(|(row, _)| *row == line);
    let above = sample.rows.iter().take(sample.above).filter(|(line, cells)| {
        !(is_row_of_units(*line) || is_header(*line) && names.is_some_and(|names| names == cells))
    });
    let comments = sample.comments.iter().filter(|(line, _)| *line < stated.first);
    let mut said: Vec<(usize, String, Mention)> = Vec::new();
    for (line, cells) in above.chain(comments) {
        said.extend(mentions(cells.iter()).into_iter().map(|mention| (*line, joined(cells), mention)));
    }
    for (at, line) in free.iter().filter(|at| sample.is_empty(**at)).filter_map(|at| Some((*at, columns.header?))) {
        said.extend(mentions([name(at)].into_iter()).into_iter().map(|mention| (line, shorten(name(at)), mention)));
    }
    for (line, text, (unit, _)) in said.iter().filter(|(.., (_, is_clear))| *is_clear) {
        match (unit, sample.given, &stated.from) {
            (Ok(unit), Some(given), _) if *unit != given => return Err(given_differs(given, sign(*unit), text)),
            (Ok(unit), _, Some((_, before))) if stated.file != Some(*unit) => {
                let first = stated.file.unwrap_or(Unit::Millimetre);
                return Err(differ((first, before), (*unit, text)));
            }
            (Ok(unit), ..) => {
                stated.file = Some(*unit);
                stated.from.get_or_insert((*line, text.clone()));
            }
            (Err(unknown), Some(given), _) => {
                if unknown.split_whitespace().any(|part| word(part) == Word::Foreign) {
                    return Err(given_differs(given, unknown, text));
                }
            }
            (Err(unknown), None, _) => {
                let unit = shorten(unknown);
                return Err(ImportErrorKind::UnitStated { line: *line, unit, text: text.clone() });
            }
        }
    }
    stated.file = stated.file.or(sample.given);
    own_units(&mut stated, sample, columns, &name)?;
    unit_columns(&mut stated, sample, &free, &name)?;
    halves(&stated, columns, &name)?;
    let own = |at: usize| stated.own.iter().find(|(own, _)| *own == at).map(|(_, unit)| *unit);
    let unit = |at: usize| own(at).or(stated.file).unwrap_or(Unit::Millimetre);
    columns.set_unit(unit(columns.measured.at));
    if let Some(nominal) = &mut columns.nominal {
        nominal.unit = unit(nominal.at);
    }
    let open = Some(columns.measured.unit).filter(|unit| *unit == Unit::Inch);
    for limit in columns.limits.iter_mut().flat_map(LimitColumns::iter_mut) {
        limit.unit = own(limit.at).or(stated.file).or(open).unwrap_or(Unit::Millimetre);
    }
    if stated.from.is_some() && !sample.has_place_unit {
        for place in columns.labels.place.iter_mut().flatten() {
            place.unit = unit(place.at);
        }
    }
    let is_stated = |ignored: &String| stated.columns.iter().any(|at| *ignored == name_of(*at, name(*at)));
    columns.ignored.retain(|ignored| !is_stated(ignored));
    columns.remarks.retain(|remark| !stated.columns.contains(&remark.at));
    columns.stated = stated;
    let decided = columns.stated.decided(columns.measured);
    for (line, text, (unit, _)) in said.iter().filter(|(.., (_, is_clear))| !is_clear) {
        if sample.given.is_none() && decided.is_none_or(|decided| unit.as_ref() != Ok(&decided)) {
            let unit = unit.as_ref().map_or_else(Clone::clone, |unit| sign(*unit).to_owned());
            return Err(ImportErrorKind::UnitMentioned { line: *line, unit: shorten(&unit), text: text.clone() });
        }
    }
    for (line, cells) in sample.comments.iter().chain(data) {
        if let Some(reason) = stray_row(columns, *line, cells) {
            return Err(reason);
        }
    }
    in_place_of_a_value(data, columns)
}

/// Units where measured values should be, which is no row of units below the header.
fn in_place_of_a_value(data: &[(usize, StringRecord)], columns: &Columns) -> Result<(), ImportErrorKind> {
    // A row with a number is one whose value is wrong: it is refused by itself.
    for (line, cells) in data.iter().filter(|(_, cells)| !cells::has_number(cells)) {
        let cell = cells.cell(columns.measured.at);
        let unit = match word(cell) {
            Word::Length(unit) if unit != columns.measured.unit => sign(unit),
            Word::Foreign => cell.trim(),
            _ => continue,
        };
        return Err(late(columns, Some(*line), unit, &joined(cells)));
    }
    Ok(())
}

fn given_differs(given: Unit, unit: &str, text: &str) -> ImportErrorKind {
    ImportErrorKind::UnitGiven { given: sign(given), unit: shorten(unit), text: shorten(text) }
}

/// The units that measured values and nominal sizes state by their names or in the row of units.
fn own_units<'n>(
    stated: &mut Stated,
    sample: &Sample,
    columns: &Columns,
    name: &impl Fn(usize) -> &'n str,
) -> Result<(), ImportErrorKind> {
    let sizes = [Some(columns.measured.at), columns.nominal.map(|column| column.at)];
    let limits = columns.limits.iter().flat_map(LimitColumns::iter).map(|column| column.at);
    let places = columns.labels.place.iter().flatten().map(|column| column.at);
    let sizes = sizes.into_iter().flatten().map(|at| (at, true));
    // Deviations are often in micrometres, beside sizes in millimetres.
    for (at, is_size) in sizes.chain(limits.chain(places).map(|at| (at, false))) {
        let by_name = match of_name(name(at)) {
            Ok(unit) => unit,
            Err(unknown) => match sample.given.filter(|_| is_size) {
                Some(given) if unknown.split([',', ' ']).any(|part| word(part) == Word::Foreign) => {
                    return Err(given_differs(given, &unknown, name(at)));
                }
                _ => None,
            },
        };
        let cell = stated.row.as_ref().map_or("", |(_, cells)| cells.cell(at)).trim();
        let by_row = match word(cell) {
            Word::Length(unit) => Some(unit),
            Word::Foreign | Word::Other | Word::Unknown if cell.chars().any(char::is_alphanumeric) => {
                return Err(ImportErrorKind::Unit { unit: shorten(cell) });
            }
            _ => None,
        };
        if let Some((by_name, by_row)) = by_name.zip(by_row)
            && by_name != by_row
        {
            return Err(differ((by_name, name(at)), (by_row, cell)));
        }
        let Some(own) = by_name.or(by_row) else { continue };
        let text = if by_name.is_some() { name(at) } else { cell };
        match (sample.given, stated.file, &stated.from) {
            (Some(given), ..) if is_size && given != own => return Err(given_differs(given, sign(own), text)),
            (_, Some(file), Some((_, from))) if is_size && file != own => {
                return Err(differ((file, from), (own, text)));
            }
            _ => stated.own.push((at, own)),
        }
    }
    Ok(())
}

/// The columns that state the unit of each row: by their names, or by what stands in them.
///
/// # Errors
/// A column of words that may be units and may be something else: `IN` is a country, `Zoll` is a name.
fn unit_columns<'n>(
    stated: &mut Stated,
    sample: &Sample,
    free: &[usize],
    name: &impl Fn(usize) -> &'n str,
) -> Result<(), ImportErrorKind> {
    let is_length = |cell: &&&str| matches!(word(cell), Word::Length(_) | Word::Foreign);
    let rows = sample.rows.len().saturating_sub(sample.above);
    let is_temperature = |cell: &str| word(cell) == Word::Other;
    let mut units = Vec::new();
    let said = sample.said.iter().filter(|(role, _)| *role == Role::Units).map(|(_, at)| *at);
    stated.columns.extend(said);
    for &at in free {
        if sample.is_said(Role::Units, at) {
            units.extend(sample.cells(at).filter_map(units::known));
            continue;
        }
        let filled: Vec<&str> = sample.cells(at).collect();
        let lengths = filled.iter().filter(is_length).count();
        let sure = filled.iter().filter(is_length).filter(|cell| !may_be_a_name(cell)).count();
        let is_stated = match key(name(at)) {
            // Produced units are counted.
            Some(Rank::Exact) if !filled.is_empty() && filled.iter().all(|cell| cells::is_number(cell)) => false,
            // A name alone, as of a title that stands beside the names, has no rows.
            Some(Rank::Exact) => !filled.is_empty() || mentions([name(at)].into_iter()).is_empty(),
            Some(Rank::Contained) if lengths == filled.len() => 0 < lengths,
            _ if sure == 0 && lengths == rows && 0 < rows && !stated.is_given => {
                let line = line_of_first_row(sample);
                let unit = filled.first().map_or_else(String::new, |cell| shorten(cell));
                let text = shorten(&format!("{} {unit}", name_of(at, name(at))));
                return Err(ImportErrorKind::UnitMentioned { line, unit, text });
            }
            _ => 0 < sure && filled.len() < sure * 2,
        };
        if !is_stated {
            continue;
        }
        stated.columns.push(at);
        if !filled.is_empty() && filled.iter().all(|cell| is_temperature(cell)) {
            stated.others.push(at);
        }
        units.extend(filled.iter().filter_map(|cell| units::known(cell)));
    }
    let first = units.first().copied();
    stated.sampled = first.filter(|first| units.iter().all(|unit| unit == first));
    // A column of temperatures beside no other one leaves lengths as they are.
    if stated.columns == stated.others {
        stated.columns.clear();
    }
    Ok(())
}

/// Whether a unit is also the name of something else.
fn may_be_a_name(cell: &str) -> bool {
    let small = cell.trim().to_lowercase();
    units::is_also_a_word(&small)
        || small == "zoll"
        || small.chars().count() == 1 && small.contains(char::is_alphabetic)
}

fn line_of_first_row(sample: &Sample) -> usize {
    sample.rows.get(sample.above).map_or(1, |(line, _)| *line)
}

/// Refuses a file of which one column says inch and another one of lengths says nothing: it may be in inch as well, or not.
fn halves<'n>(stated: &Stated, columns: &Columns, name: &impl Fn(usize) -> &'n str) -> Result<(), ImportErrorKind> {
    if stated.file.is_some() || !stated.columns.is_empty() {
        return Ok(());
    }
    let own = |at: usize| stated.own.iter().find(|(own, _)| *own == at).map(|(_, unit)| *unit);
    let in_row = |at: usize| {
        let cell = stated.row.as_ref().map_or("", |(_, cells)| cells.cell(at));
        word(cell) == Word::Length(Unit::Inch)
    };
    let says_inch = |at: &usize| in_row(*at) || units::unit(name(*at)) == Ok(Some(Unit::Inch));
    let half = |inch: usize, open: usize| ImportErrorKind::UnitHalf {
        column: name_of(inch, name(inch)),
        open: name_of(open, name(open)),
    };
    let measured = columns.measured.at;
    if own(measured).is_none()
        && let Some(inch) = (0..columns.count).find(says_inch)
    {
        return Err(half(inch, measured));
    }
    match columns.nominal.filter(|nominal| own(nominal.at).is_none()) {
        Some(nominal) if own(measured) == Some(Unit::Inch) => Err(half(measured, nominal.at)),
        _ => Ok(()),
    }
}
