//! Tables of a control that a program fills with FN 27, a row for each part: `NR PART SERIAL F1 F2 STATUS`.
//!
//! A column says which part a row is of, else the table is refused: a table of tools or of deviations has numbers, too. Every other column
//! of numbers is a value or a limit by its name (`series`). A row without any value is of a part that was not measured yet. The status
//! of a row is that of its part: where the part has several values, only GOOD says something of each of them.

use std::sync::Arc;

use fitcheck_core::length::{Length, LengthError, Unit};
use fitcheck_core::message::{FilePlace, Located};
use fitcheck_core::probing::Origin;
use fitcheck_core::tolerance::{Callout, Feature};
use fitcheck_nc::control::simulated::is_mark;
use fitcheck_nc::control::table::{Column, ControlTable, TableFile, TableUnit};

use super::characteristic::{Characteristic, CharacteristicKind, Value};
use super::claim::Claim;
use super::error::{ImportErrorKind, ImportWarningKind};
use super::given::shorten;
use super::imported::{Labels, Sink, StatedLimits, Unjudged, WhyUnjudged};
use super::measurements::date_time;
use super::quantity::is_shape;
use super::role::Role;
use super::series::{self, Figure, Group, Tells};
use super::source::{Beginning, Context, Source};
use super::{Format, cells, column, words};

pub(super) const FORMAT: Format = Format {
    name: "series-table",
    endings: &["tab"],
    description: "exchange-format-series-table",
    recognises: |beginning: &Beginning<'_>| {
        let text = beginning.text();
        let mut words = text.split_whitespace();
        words.next() == Some("BEGIN") && words.next().is_some_and(|name| name != "PGM")
    },
    read,
    plan: None,
    line_ends: b"",
    // Every other table of a control begins so, too.
    has_marks: false,
    shows_end: true,
};

/// What the columns of a table are, by their numbers from 0.
struct Columns {
    part: Vec<(usize, Tells)>,
    groups: Vec<(usize, Group)>,
    status: Option<usize>,
    time: Option<usize>,
    callout: Option<usize>,
    side: Option<usize>,
}

/// Whether a cell says nothing: a lone `-` stands for no value.
fn is_blank(cell: &str) -> bool {
    matches!(cell, "" | "-")
}

impl Columns {
    fn of(table: &ControlTable) -> Result<Self, ImportErrorKind> {
        let names = || (0..).zip(table.columns.iter().map(|column| column.name.as_str()));
        let is_number = |at: usize| holds_numbers(table, at);
        let part: Vec<(usize, Tells)> =
            names().filter_map(|(at, name)| Some((at, Tells::of(name, !is_number(at))?))).collect();
        if !part.iter().any(|(_, tells)| tells.is_of_part()) {
            return Err(ImportErrorKind::TableNoPart);
        }
        let is_status = |name: &str| words::is_status(name);
        let is_time = |name: &str| words::role(name).is_some_and(|(role, _)| role == Role::Time);
        let is_free = |at: usize, name: &str| {
            part.iter().all(|(own, _)| *own != at) && words::label(name).is_none() && !is_status(name) && !is_time(name)
        };
        let mut groups = Vec::new();
        for (at, name) in names().filter(|(at, name)| is_free(*at, name) && is_number(*at)) {
            let (name, figure) = series::said(name);
            series::add(&mut groups, (at, at), name, figure);
        }
        let measured = |group: Group| match group.measured() {
            Some(measured) => Ok((measured, group)),
            None => Err(ImportErrorKind::TableNoValue { name: shorten(&group.name) }),
        };
        let groups: Vec<(usize, Group)> = groups.into_iter().map(measured).collect::<Result<_, _>>()?;
        if groups.is_empty() {
            return Err(ImportErrorKind::TableNoValues);
        }
        let text = |is: fn(&str) -> bool| {
            names().map(|(at, _)| at).filter(|at| !is_number(*at)).find(|at| {
                let mut cells = filled(table, *at).peekable();
                cells.peek().is_some() && cells.all(is)
            })
        };
        Ok(Self {
            status: names().find(|(_, name)| is_status(name)).map(|(at, _)| at),
            time: names().find(|(_, name)| is_time(name)).map(|(at, _)| at),
            callout: text(|cell| cell.parse::<Callout>().is_ok()).filter(|_| groups.len() == 1),
            side: text(|cell| !cell.contains(' ') && is_shape(cell).is_some()),
            part,
            groups,
        })
    }

    /// The names of the columns that say nothing here; the number of the row is no news.
    fn ignored(&self, table: &ControlTable) -> Vec<String> {
        let mut used: Vec<usize> = self.groups.iter().flat_map(|(_, group)| group.all()).collect();
        used.extend([self.status, self.time, self.callout, self.side].into_iter().flatten());
        used.extend(self.part.iter().map(|(at, _)| *at));
        let names = (0..).zip(&table.columns).filter(|(at, column)| !used.contains(at) && column.name != "NR");
        names.map(|(_, column)| column.name.clone()).collect()
    }
}

/// The cells of a column that hold anything.
fn filled(table: &ControlTable, at: usize) -> impl Iterator<Item = &str> {
    (0..table.rows.len()).map(move |row| table.cell(row, at)).filter(|cell| !is_blank(cell))
}

/// Whether a column is one of numbers: its description says so, or else at least half of its cells do.
fn holds_numbers(table: &ControlTable, at: usize) -> bool {
    let said = table.columns.get(at).and_then(Column::is_text);
    let (mut numbers, mut others) = (0, 0);
    for cell in filled(table, at) {
        let is_number = cells::is_number(cell.strip_prefix('+').unwrap_or(cell));
        *(if is_number { &mut numbers } else { &mut others }) += 1;
    }
    said.map_or(0 < numbers && others <= numbers, |is_text| !is_text)
}

fn read(source: &mut Source<'_>, sink: &mut Sink<'_>) -> Result<(), ImportErrorKind> {
    let bytes = source.whole()?;
    let context = &source.context;
    let refused = |error: Located<_>| {
        let Located { what, place } = error;
        ImportErrorKind::Located(Box::new(Located { what: ImportErrorKind::Table(what), place }))
    };
    let file = ControlTable::read_with_short_rows(&bytes, &context.file).map_err(refused)?;
    let columns = Columns::of(&file.table)?;
    for Located { what, place } in &file.warnings {
        sink.warn(FilePlace { line: place.line, ..FilePlace::default() }, None, ImportWarningKind::Table(what.clone()));
    }
    let ignored = columns.ignored(&file.table);
    if !ignored.is_empty() {
        let columns = column::listed(&ignored);
        sink.warn(FilePlace::line(1), None, ImportWarningKind::IgnoredColumns { columns });
    }
    let unit = match file.table.unit {
        Some(TableUnit::Inch) => Unit::Inch,
        Some(TableUnit::Millimetre) => Unit::Millimetre,
        None => source.given_unit().unwrap_or_else(|| {
            sink.warn(FilePlace::line(1), None, ImportWarningKind::UnitAssumed);
            Unit::Millimetre
        }),
    };
    in_its_unit(&file.table, &columns)?;
    let is_simulated = file.table.comments.iter().any(|comment| is_mark(&comment.text));
    let has_plan = source.given.has_plan;
    let reader = Reader { file: &file, columns: &columns, context, unit, is_simulated, has_plan };
    for row in 0..file.table.rows.len() {
        if !reader.row(row, sink) {
            return Ok(());
        }
    }
    if sink.rows() == 0 { Err(ImportErrorKind::NoRows) } else { Ok(()) }
}

/// Only columns of type LENGTH are in the unit of the table: what a program writes into another column of a table in inch may be in mm.
fn in_its_unit(table: &ControlTable, columns: &Columns) -> Result<(), ImportErrorKind> {
    let is_length = |at: usize| {
        let kind = table.columns.get(at).and_then(|column| column.kind.as_deref());
        kind.is_some_and(|kind| kind.eq_ignore_ascii_case("LENGTH"))
    };
    let mut lengths = columns.groups.iter().flat_map(|(_, group)| group.all());
    match lengths.find(|at| table.unit == Some(TableUnit::Inch) && !is_length(*at)) {
        Some(at) => {
            let column = table.columns.get(at).map_or_else(String::new, |column| column.name.clone());
            Err(ImportErrorKind::TableUnit { column })
        }
        None => Ok(()),
    }
}

/// Reads the rows.
struct Reader<'a> {
    file: &'a TableFile,
    columns: &'a Columns,
    context: &'a Context<'a>,
    unit: Unit,
    is_simulated: bool,
    has_plan: bool,
}

impl Reader<'_> {
    /// Reads a row; `false` where no more are wanted.
    fn row(&self, row: usize, sink: &mut Sink<'_>) -> bool {
        let Columns { part, groups, status, .. } = self.columns;
        let cell = |at: usize| self.file.table.cell(row, at);
        if groups.iter().all(|(measured, _)| is_blank(cell(*measured))) {
            return true;
        }
        let line = self.file.cell_place(row, 0).line.unwrap_or(1);
        let labels =
            series::labels(part.iter().map(|(at, tells)| (*tells, cell(*at))).filter(|(_, cell)| !is_blank(cell)));
        let claim = status.map(cell).and_then(Claim::of_cell);
        let claims = claim.into_iter().filter(|claim| groups.len() == 1 || claim.is_of_each()).collect();
        let labels = Labels { claims, ..labels };
        for (measured, group) in groups {
            if sink.is_full(line) {
                return false;
            }
            if let Err(reason) = self.value((row, line), *measured, group, &labels, sink) {
                let place = FilePlace { file: None, ..self.file.cell_place(row, *measured) };
                sink.refuse(place, reason, shorten(cell(*measured)));
            }
        }
        true
    }

    /// The length of a cell; `None` where it is blank.
    fn length(&self, row: usize, at: Option<usize>) -> Result<Option<Length>, ImportErrorKind> {
        let Some(at) = at else { return Ok(None) };
        let cell = self.file.table.cell(row, at);
        if is_blank(cell) {
            return Ok(None);
        }
        if self.file.touches(row, at) {
            let column = self.file.table.columns.get(at).map_or_else(String::new, |column| column.name.clone());
            return Err(ImportErrorKind::TableTouches { column });
        }
        // FN 27 writes the sign.
        cells::length(cell.strip_prefix('+').unwrap_or(cell), self.unit).map(Some).map_err(ImportErrorKind::Measured)
    }

    fn value(
        &self,
        (row, line): (usize, usize),
        at: usize,
        group: &Group,
        labels: &Labels,
        sink: &mut Sink<'_>,
    ) -> Result<(), ImportErrorKind> {
        let cell = |at: Option<usize>| at.map_or("", |at| self.file.table.cell(row, at));
        let measured = self.length(row, Some(at))?.ok_or(ImportErrorKind::Measured(LengthError::Empty))?;
        let [minimum, maximum, nominal] =
            [Figure::Minimum, Figure::Maximum, Figure::Nominal].map(|figure| self.length(row, group.at(figure)));
        let given = cell(self.columns.time);
        let time = date_time(given);
        if time.is_none() && !is_blank(given) {
            sink.warn(FilePlace::line(line), Some(line), ImportWarningKind::Time { given: shorten(given) });
        }
        // FN 27 rounds to the decimals that the column is described with.
        let decimals = self.file.table.columns.get(at).and_then(|column| column.decimals);
        let labels = Labels {
            rounded_by: decimals.map_or(Length::ZERO, |decimals| half_of_last(decimals, self.unit)),
            ..labels.clone()
        };
        if measured <= Length::ZERO && self.has_plan {
            let file = Arc::clone(&self.context.file);
            sink.set_aside(Unjudged {
                line,
                id: group.name.clone(),
                labels,
                time: time.unwrap_or(self.context.now),
                measured: Some(measured),
                origin: if self.is_simulated { Origin::ImportedSimulation { file } } else { Origin::Imported { file } },
                position: None,
                asked: StatedLimits { nominal: nominal?, minimum: minimum?, maximum: maximum? },
                correction: None,
                why: WhyUnjudged::NotPositive { given: shorten(cell(Some(at))), column: 1 },
            });
            return Ok(());
        }
        let callout: Option<Callout> = cell(self.columns.callout).parse().ok();
        let side = is_shape(cell(self.columns.side)).or_else(|| is_shape(&group.name));
        let feature = side.map(|is_hole| if is_hole { Feature::Hole } else { Feature::Shaft });
        let characteristic = Characteristic {
            name: group.name.clone(),
            what: CharacteristicKind::Size,
            class: callout.and_then(|callout| callout.class()).map_or_else(String::new, |class| class.to_string()),
            feature: feature.filter(|_| callout.is_none_or(|callout| callout.feature().is_none())),
            nominal: callout.map(|callout| callout.nominal()).or(nominal?),
            minimum: minimum?,
            maximum: maximum?,
            expanded: None,
            labels: labels.clone(),
        };
        let value = Value { line, measured, time, labels, is_simulated: self.is_simulated };
        characteristic.judge(value, self.context, sink);
        Ok(())
    }
}

/// How far a length may be from what is written of it with so many decimals.
fn half_of_last(decimals: usize, unit: Unit) -> Length {
    let half = if unit == Unit::Inch { 12_700_000 } else { 500_000 };
    let power = u32::try_from(decimals).ok().and_then(|decimals| 10_i64.checked_pow(decimals));
    power.map_or(Length::ZERO, |power| Length::from_nanometres(half / power).unwrap_or(Length::ZERO))
}
