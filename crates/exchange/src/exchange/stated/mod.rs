//! What a file states about the unit of its lengths beside the names of its columns: the one place that decides, for every reader of
//! columns and for `batch`.
//!
//! | where | what is done |
//! |---|---|
//! | a title above the header, a comment above the first row | the unit of every length that says no other one |
//! | a row of units below the header | the unit of each column |
//! | a column of units | the unit of each row, nominal size and measured value alike |
//! | a title or comment behind rows | must say what was read before |
//! | what the user says | must be what the file says |
//!
//! Two statements that contradict each other, and one that is not understood, are refused. `mention` has the words.

mod mention;

use csv::StringRecord;

use super::beside::BesideColumn;
use super::cells;
use super::columns::{Columns, LengthColumn, Sample, name_of};
use super::delimited::{SEPARATORS, lines};
use super::error::{ImportErrorKind, ImportWarningKind};
use super::given::shorten;
use super::pieces::Pieces;
use super::refused::{Cell, Refused};
use super::units;
use super::vocabulary::Rank;
use fitcheck_core::length::Unit;
use mention::{Mention, Word, behind_number, key, mentions, of_name, word};
pub(super) use mention::{
    are_units, inch_in, is_row_of_units, may_state, names_units, not_mm, plain_unit, states_other,
};

/// What a file states.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub(super) struct Stated {
    /// The columns whose cells state the unit of their rows.
    pub(super) columns: Vec<usize>,
    /// Those of them that state the unit of a temperature, as far as was seen.
    others: Vec<usize>,
    /// The unit of all lengths, by a statement or by the user.
    file: Option<Unit>,
    /// The line and the text of that statement.
    from: Option<(usize, String)>,
    /// Whether the user said it.
    is_given: bool,
    /// The row of units with its line.
    row: Option<(usize, StringRecord)>,
    /// The columns that state their own unit, by name or in the row of units.
    own: Vec<(usize, Unit)>,
    /// The only unit of the first rows, where a column states them.
    sampled: Option<Unit>,
    /// The letters of the header, to know it where it is repeated.
    header: String,
    /// The line of the first row.
    first: usize,
}

/// A line without what separates its words.
fn squeezed<'c>(cells: impl Iterator<Item = &'c str>) -> String {
    cells.flat_map(str::chars).filter(|c| c.is_alphanumeric()).flat_map(char::to_lowercase).collect()
}

fn joined(cells: &StringRecord) -> String {
    let text = cells.iter().map(str::trim).filter(|cell| !cell.is_empty()).collect::<Vec<_>>().join(" ");
    shorten(&text)
}

/// The sign of a unit.
pub(super) const fn sign(unit: Unit) -> &'static str {
    match unit {
        Unit::Millimetre => "mm",
        Unit::Micrometre => "\u{b5}m",
        Unit::Inch => "inch",
    }
}

fn differ((unit, at): (Unit, &str), (other, other_at): (Unit, &str)) -> ImportErrorKind {
    ImportErrorKind::UnitsDiffer { unit: sign(unit), at: shorten(at), other: sign(other), other_at: shorten(other_at) }
}

/// Decides the units of the columns of a file by its first rows.
///
/// # Errors
/// What contradicts, or is not understood.
pub(super) fn decide(sample: &Sample, columns: &mut Columns) -> Result<(), ImportErrorKind> {
    let is_header = |line: usize| columns.header == Some(line);
    let header = sample.rows.iter().find(|(line, _)| is_header(*line)).map(|(_, cells)| cells);
    let names = header.filter(|names| columns.names_known || names.len() == columns.count);
    let name = |at: usize| names.and_then(|names| names.get(at)).unwrap_or_default();
    let data = sample.rows.get(sample.above..).unwrap_or_default();
    let mut stated = Stated {
        row: sample.units_row.and_then(|at| sample.rows.get(at)).cloned(),
        header: header.map(|names| squeezed(names.iter())).unwrap_or_default(),
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
    for at in free.iter().copied().filter(|at| sample.is_empty(*at)) {
        let line = columns.header.unwrap_or_default();
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
    if stated.from.is_some() && !sample.has_place_unit {
        for place in columns.labels.place.iter_mut().flatten() {
            place.unit = unit(place.at);
        }
    }
    let is_stated = |ignored: &String| stated.columns.iter().any(|at| *ignored == name_of(*at, name(*at)));
    columns.ignored.retain(|ignored| !is_stated(ignored));
    columns.stated = stated;
    let decided = columns.stated.decided(columns);
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
        let cell = cells.get(columns.measured.at).unwrap_or_default();
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

fn has_figure(cells: &StringRecord) -> bool {
    cells.iter().any(|cell| cell.contains(|c: char| c.is_ascii_digit()))
}

/// The units that measured values and nominal sizes state by their names or in the row of units.
fn own_units<'n>(
    stated: &mut Stated,
    sample: &Sample,
    columns: &Columns,
    name: &impl Fn(usize) -> &'n str,
) -> Result<(), ImportErrorKind> {
    let sizes = [Some(columns.measured.at), columns.nominal.map(|column| column.at)];
    let places = columns.labels.place.iter().flatten().map(|column| column.at);
    for (at, is_size) in sizes.into_iter().flatten().map(|at| (at, true)).chain(places.map(|at| (at, false))) {
        let by_name = match of_name(name(at)) {
            Ok(unit) => unit,
            Err(unknown) => match sample.given.filter(|_| is_size) {
                Some(given) if unknown.split([',', ' ']).any(|part| word(part) == Word::Foreign) => {
                    return Err(given_differs(given, &unknown, name(at)));
                }
                _ => None,
            },
        };
        let cell = stated.row.as_ref().and_then(|(_, cells)| cells.get(at)).unwrap_or_default().trim();
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
    for &at in free {
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
                let (line, unit) = (line_of_first_row(sample), shorten(filled.first().copied().unwrap_or_default()));
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

/// The line of the first row.
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
        let cell = stated.row.as_ref().and_then(|(_, cells)| cells.get(at)).unwrap_or_default();
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

fn late(columns: &Columns, line: Option<usize>, unit: &str, text: &str) -> ImportErrorKind {
    let read = columns.stated.decided(columns).map_or("-", sign);
    let (unit, text) = (shorten(unit), shorten(text));
    match line {
        Some(line) => ImportErrorKind::UnitLate { line, unit, text, read },
        None => ImportErrorKind::UnitStray { unit, text, read },
    }
}

/// Why a line that is no row contradicts the units that rows are read by; whoever tells it says where it stands.
pub(super) fn stray(columns: &Columns, cells: &StringRecord) -> Option<ImportErrorKind> {
    let may_be = cells::is_comment(cells) || !has_figure(cells) && columns.stated.columns.is_empty();
    may_be.then(|| stray_of(columns, None, || cells.iter(), || joined(cells))).flatten()
}

/// The same of a row of a sheet, which may be one with values.
pub(super) fn stray_row(columns: &Columns, line: usize, cells: &StringRecord) -> Option<ImportErrorKind> {
    let says_its_own = !columns.stated.columns.is_empty();
    let may_be = columns.stated.first < line && (cells::is_comment(cells) || !says_its_own && !has_figure(cells));
    may_be.then(|| stray_of(columns, Some(line), || cells.iter(), || joined(cells))).flatten()
}

fn stray_of<'c, C: Iterator<Item = &'c str>>(
    columns: &Columns,
    line: Option<usize>,
    cells: impl Fn() -> C,
    text: impl Fn() -> String,
) -> Option<ImportErrorKind> {
    let stated = &columns.stated;
    let mentions = mentions(cells());
    if mentions.is_empty() || stated.row.as_ref().is_some_and(|(row, _)| Some(*row) == line) {
        return None;
    }
    if stated.header == squeezed(cells()) {
        return None;
    }
    let decided = stated.decided(columns);
    for (unit, is_clear) in mentions {
        match unit {
            Ok(unit) if decided == Some(unit) => {}
            Ok(unit) if is_clear || !stated.is_given => return Some(late(columns, line, sign(unit), &text())),
            Err(unknown) if !stated.is_given => return Some(late(columns, line, &unknown, &text())),
            Ok(_) | Err(_) => {}
        }
    }
    None
}

/// The most different statements that are kept: long before, two of them contradict each other.
const MOST_SAID: usize = 1_000;

/// A line with its number.
type Line = (usize, String);

/// The lines of a text that may state a unit and are no rows: comments, and those without any figure.
pub(super) fn unit_lines(pieces: &mut Pieces<'_>) -> Vec<Line> {
    // Of lines that say the same, the first one and the last one tell all. What cannot be read is told where rows are.
    let mut found: Vec<(Vec<Mention>, [Line; 2])> = Vec::new();
    let mut next = 1;
    while let Ok(Some(piece)) = pieces.next() {
        let mut last = next;
        for (line, from, to) in lines(&piece, 0, next) {
            last = line + 1;
            let text = piece.get(from..to).unwrap_or_default();
            let may_be = || !text.bytes().any(|byte| byte.is_ascii_digit());
            let is_comment = text.trim_start_matches([' ', '\t', '"']).starts_with('#');
            if !is_comment && !may_be() {
                continue;
            }
            let (said, this) = (mentions(split(text)), || (line, text.trim().to_owned()));
            let has_room = found.len() < MOST_SAID;
            match found.iter_mut().find(|(before, _)| *before == said) {
                _ if said.is_empty() => {}
                Some((_, [_, last])) => *last = this(),
                None if has_room => found.push((said, [this(), this()])),
                None => {}
            }
        }
        next = last;
    }
    found.into_iter().flat_map(|(_, lines)| lines).collect()
}

/// The cells of a line, whatever separates them.
fn split(text: &str) -> impl Iterator<Item = &str> {
    text.split(|c: char| u8::try_from(c).is_ok_and(|byte| SEPARATORS.contains(&byte)))
        .map(|cell| cell.trim().trim_matches('"'))
}

/// Refuses a file with a line behind its first row that states another unit.
pub(super) fn agree(columns: &Columns, lines: &[Line]) -> Result<(), ImportErrorKind> {
    // Where each row states its unit, only comments are about others.
    let is_about_rows = |text: &str| columns.stated.columns.is_empty() || text.starts_with('#');
    let behind = lines.iter().filter(|(line, text)| columns.stated.first < *line && is_about_rows(text));
    let mut reasons =
        behind.filter_map(|(line, text)| stray_of(columns, Some(*line), || split(text), || shorten(text)));
    reasons.next().map_or(Ok(()), Err)
}

impl Stated {
    /// The unit of the first rows; `None` where they have several.
    fn decided(&self, columns: &Columns) -> Option<Unit> {
        if self.columns.is_empty() { Some(columns.measured.unit) } else { self.file.or(self.sampled) }
    }

    /// Whether a row gives the units of the columns.
    pub(super) fn is_row_of_units(&self, cells: &StringRecord) -> bool {
        self.row.as_ref().is_some_and(|(_, row)| row == cells)
    }

    /// Whether a row is the names of the columns once more.
    pub(super) fn repeats_names(&self, cells: &StringRecord) -> bool {
        !self.header.is_empty() && squeezed(cells.iter()) == self.header
    }

    /// The line of the first row.
    pub(super) const fn first(&self) -> usize {
        self.first
    }

    /// The unit that the cells of a row state.
    fn of_row<'c>(&self, cells: &'c StringRecord) -> Result<Option<Unit>, Refused<'c>> {
        let mut found: Option<(Unit, &str)> = None;
        for &at in &self.columns {
            let text = cells.get(at).unwrap_or_default().trim();
            let cell = Cell { at: Some(at), text };
            let is_other = self.others.contains(&at);
            let unit = match word(text) {
                Word::Length(unit) => unit,
                Word::Other if is_other => continue,
                _ if text.is_empty() && (is_other || self.is_given) => continue,
                _ if text.is_empty() => return Err((cell, ImportErrorKind::UnitMissing)),
                _ => return Err((cell, ImportErrorKind::Unit { unit: shorten(text) })),
            };
            let before = found.or_else(|| Some((self.file?, self.from.as_ref().map_or("--columns", |(_, text)| text))));
            if let Some((before, text_before)) = before.filter(|(before, _)| *before != unit) {
                return Err((cell, differ((before, text_before), (unit, text))));
            }
            found = Some((unit, text));
        }
        Ok(found.map(|(unit, _)| unit))
    }

    /// A column of sizes as a row has it.
    pub(super) fn in_row<'c>(
        &self,
        column: LengthColumn,
        cells: &'c StringRecord,
    ) -> Result<LengthColumn, Refused<'c>> {
        if self.columns.is_empty() {
            return Ok(column);
        }
        let Some(unit) = self.of_row(cells)? else { return Ok(column) };
        let text = cells.get(column.at).unwrap_or_default().trim();
        let cell = Cell { at: Some(column.at), text };
        if let Some((_, own)) = self.own.iter().find(|(own, own_unit)| *own == column.at && *own_unit != unit) {
            return Err((cell, differ((*own, &name_of(column.at, "")), (unit, sign(unit)))));
        }
        if let Some(own) = behind_number(text).filter(|own| *own != unit) {
            return Err((cell, differ((own, text), (unit, sign(unit)))));
        }
        Ok(LengthColumn { unit, ..column })
    }

    /// The unit of a coordinate in a row.
    pub(super) fn of_place(&self, column: LengthColumn, cells: &StringRecord) -> Unit {
        let has_own = self.own.iter().any(|(own, _)| *own == column.at);
        let of_row = || self.of_row(cells).ok().flatten();
        if self.columns.is_empty() || has_own { column.unit } else { of_row().unwrap_or(column.unit) }
    }

    /// Whether a statement says that all lengths of a row are in inch: a callout with a size, which is in mm, would be doubtful.
    pub(super) fn is_inch(&self, cells: &StringRecord) -> bool {
        !self.is_given
            && (self.file == Some(Unit::Inch) || self.of_row(cells).is_ok_and(|unit| unit == Some(Unit::Inch)))
    }

    /// Whether rows are judged by the units of their columns, or by the only column of units; `None` where each row is looked at closely.
    pub(super) fn plain(&self) -> Option<(Option<usize>, bool)> {
        let is_inch = !self.is_given && self.file == Some(Unit::Inch);
        match self.columns.as_slice() {
            [] => Some((None, is_inch)),
            [at] if self.own.is_empty() && self.file.is_none() && self.others.is_empty() => Some((Some(*at), is_inch)),
            _ => None,
        }
    }

    /// What is said of a unit that is not mm and that no name of a column says, with its line.
    pub(super) fn told(&self, columns: &Columns) -> Option<(usize, ImportWarningKind)> {
        let unit = columns.measured.unit;
        if unit == Unit::Millimetre {
            return None;
        }
        let of_row = |(line, cells): &(usize, StringRecord)| {
            let is_stated = cells.get(columns.measured.at).is_some_and(|cell| units::known(cell).is_some());
            is_stated.then(|| (*line, joined(cells)))
        };
        let (line, text) = self.from.clone().or_else(|| self.row.as_ref().and_then(of_row))?;
        Some((line, ImportWarningKind::UnitRead { unit: sign(unit).to_owned(), text }))
    }

    /// What says the unit of measured values, as the file has it; `None` where nothing does.
    pub(super) fn source(&self, columns: &Columns, names: &[String]) -> Option<String> {
        let name = |at: usize| name_of(at, names.get(at).map_or("", String::as_str));
        if let Some(at) = self.columns.first() {
            return Some(name(*at));
        }
        let measured = columns.measured.at;
        if let Some((_, text)) = &self.from {
            return Some(text.clone());
        }
        self.own.iter().find(|(at, _)| *at == measured)?;
        let in_row = |(_, cells): &(usize, StringRecord)| {
            let cell = cells.get(measured).unwrap_or_default();
            (!cells::is_blank(cells) && units::known(cell).is_some()).then(|| joined(cells))
        };
        self.row.as_ref().and_then(in_row).or_else(|| Some(name(measured)))
    }
}
