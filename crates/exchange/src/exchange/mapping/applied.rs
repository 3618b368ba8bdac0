//! The columns of a file by a mapping: what it says, and what is detected for the rest.

use super::words::role_of;
use super::{Column, ColumnUnit, DecimalSign, Mapping, is_named};
use crate::exchange::cell::Cells as _;
use crate::exchange::cells;
use crate::exchange::column::{LengthColumn, listed, name_of, several, unit_of};
use crate::exchange::columns::{Columns, LabelColumns};
use crate::exchange::error::ImportErrorKind;
use crate::exchange::evidence::Evidence;
use crate::exchange::given::shorten;
use crate::exchange::limits::{self, Beside, Found, LimitColumns, LimitsAre};
use crate::exchange::own::OwnColumns;
use crate::exchange::quantity::QuantityColumn;
use crate::exchange::role::Role;
use crate::exchange::sample::Sample;
use crate::exchange::stated;
use fitcheck_core::text::Within as _;

/// The columns of limits.
const LIMITS: [Role; 5] = [Role::Upper, Role::Lower, Role::Minus, Role::Maximum, Role::Minimum];

/// What a mapping says of the columns of a file, and what is detected beside it.
struct Said<'a> {
    mapping: &'a Mapping,
    /// The columns that are said, from 0; `None` for a role that no column has.
    roles: Vec<(Role, Option<usize>)>,
    names: csv::StringRecord,
    found: Option<Columns>,
}

impl Mapping {
    /// What the columns of a file are: as detected, but for what is said here.
    pub(in crate::exchange) fn columns(&self, sample: &mut Sample) -> Result<Columns, ImportErrorKind> {
        if *self == Self::default() {
            return sample.columns();
        }
        if sample.rows.is_empty() {
            return Err(ImportErrorKind::NoRows);
        }
        self.place_header(sample);
        let width = sample.rows.iter().map(|(_, cells)| cells.len()).fold(0, usize::max);
        // Names that mean nothing to anybody else are names here.
        let unknown = sample.above.checked_sub(1).filter(|_| self.first_row.is_none());
        let header = sample.header.or(unknown).and_then(|at| sample.rows.get(at)).cloned();
        let names = header.as_ref().map_or_else(csv::StringRecord::new, |(_, names)| names.clone());
        let said = self.said(&names, width)?;
        sample.given = self.unit.map(ColumnUnit::unit);
        sample.has_place_unit = self.place_unit.is_some();
        sample.are_limits_said = said.iter().any(|(role, _)| LIMITS.contains(role));
        let of_row = |role: Role| matches!(role, Role::Kind | Role::Status | Role::Units);
        sample.said = said.iter().filter_map(|(role, at)| Some((*role, (*at).filter(|_| of_row(*role))?))).collect();
        // A plan is made of a table without measured values, too.
        let beyond = sample.measured;
        sample.measured = said.iter().find(|(role, _)| *role == Role::Measured).and_then(|(_, at)| *at).or(beyond);
        let samples: Vec<usize> =
            said.iter().filter(|(role, _)| *role == Role::Sample).filter_map(|(_, at)| *at).collect();
        sample.measured = sample.measured.or_else(|| samples.first().copied());
        let detected = sample.columns();
        let is_used = |at: usize| said.iter().any(|(_, of)| *of == Some(at));
        let at_measured = said.iter().find(|(role, _)| *role == Role::Measured).map(|(_, at)| *at);
        let measured = match (at_measured, &detected) {
            (Some(Some(at)), _) => at,
            _ if !samples.is_empty() => samples.first().copied().ok_or(ImportErrorKind::NoMeasuredColumn)?,
            _ if beyond.is_some() => beyond.ok_or(ImportErrorKind::NoMeasuredColumn)?,
            (None, Ok(detected)) if !is_used(detected.measured.at) => detected.measured.at,
            (None, Err(error)) => return Err(error.clone()),
            _ => return Err(ImportErrorKind::NoMeasuredColumn),
        };
        let said = Said { mapping: self, roles: said, names, found: detected.ok() };
        let mut columns = said.columns(measured, width)?;
        columns.quantities = said.quantities(&columns, sample);
        columns.tolerance_goes_both_ways =
            columns.tolerance.is_some_and(|at| limits::goes_both_ways(said.names.cell(at)));
        columns.limits = said.limits(&columns, sample)?;
        columns.header = header.map(|(line, _)| line).or_else(|| said.found.as_ref().and_then(|found| found.header));
        columns.names_known = sample.header.is_some();
        let found = said.found.as_ref().map_or_else(Vec::new, Columns::sample_places);
        let is_found = samples.is_empty() && said.of(Role::Sample).is_none() && found.first() == Some(&measured);
        let samples = if is_found { found.into_iter().filter(|at| !said.is_used(*at)).collect() } else { samples };
        columns.top = sample.top;
        columns.split_into(&samples, &said.names)?;
        columns.ignored = said.ignored(&columns);
        sample.look_at_values(&mut columns, &said.names);
        columns.decimal_sign = self.decimal.map(DecimalSign::sign).or(columns.decimal_sign);
        stated::decide(sample, &mut columns)?;
        columns.split_into(&columns.sample_places(), &said.names)?;
        Ok(columns)
    }

    /// Finds the header by the names that are said, or above the first row.
    fn place_header(&self, sample: &mut Sample) {
        let own = self.names.values().flatten().map(String::as_str);
        let names: Vec<&str> =
            self.columns.values().flat_map(Column::iter).filter_map(Column::name).chain(own).collect();
        let has = |cells: &csv::StringRecord, name: &str| cells.iter().any(|cell| is_named(cell, name));
        let first = self.first_row.and_then(|first| sample.rows.iter().position(|(line, _)| first <= *line));
        let above = sample.rows.within(..first.unwrap_or(sample.rows.len()));
        if !names.is_empty() {
            // The row that has most of the names; the first of equals.
            let count = |cells: &csv::StringRecord| names.iter().filter(|name| has(cells, name)).count();
            let best = above.iter().enumerate().rev().max_by_key(|(_, (_, cells))| count(cells));
            if let Some((at, _)) = best.filter(|(_, (_, cells))| 0 < count(cells)) {
                sample.header = Some(at);
                sample.above = at + 1;
            }
        } else if let Some(first) = first
            && sample.header.is_none_or(|at| first <= at)
        {
            // Between the names and the first row there may be units, or numbers of columns.
            let is_named = |cells: &csv::StringRecord| {
                cells::may_be_names(cells) && cells.iter().any(|cell| cell.chars().any(char::is_alphabetic))
            };
            sample.header = above.iter().rposition(|(_, cells)| is_named(cells));
        }
        if let Some(first) = first {
            sample.above = first;
        }
        sample.find_units_row();
    }

    /// The columns that are said, from 0; `None` for a role that no column has.
    fn said(&self, names: &csv::StringRecord, width: usize) -> Result<Vec<(Role, Option<usize>)>, ImportErrorKind> {
        let mut said: Vec<(Role, Option<usize>)> = Vec::new();
        for (word, column) in &self.columns {
            let Ok(role) = role_of(word) else { continue };
            for column in column.iter() {
                let at = place_of(column, role, names, width)?;
                let twice = said.iter().find(|(_, known)| at.is_some() && *known == at);
                if let Some(((first, _), at)) = twice.zip(at) {
                    let column = name_of(at, names.cell(at));
                    return Err(ImportErrorKind::ColumnTwice { column, first: *first, second: role });
                }
                said.push((role, at));
            }
        }
        // A name of the user's own counts where nothing else is said of its column, or of what it holds.
        for (word, own) in &self.names {
            let Ok(role) = role_of(word) else { continue };
            let is_own = |cell: &str| own.iter().any(|name| is_named(cell, name));
            let found = (0..).zip(names).filter(|(_, cell)| is_own(cell)).map(|(at, _)| at);
            for at in found.take(role.most()) {
                let is_open = !said.iter().any(|(known, of)| *of == Some(at) || *known == role && role.most() == 1);
                if is_open {
                    said.push((role, Some(at)));
                }
            }
        }
        Ok(said)
    }
}

impl Said<'_> {
    /// What is said of a role; `None` where nothing is.
    fn of(&self, role: Role) -> Option<&(Role, Option<usize>)> {
        self.roles.iter().find(|(of, _)| *of == role)
    }

    fn is_used(&self, at: usize) -> bool {
        self.roles.iter().any(|(_, of)| *of == Some(at))
    }

    /// The column that is said, or else the one that was found, unless that is said to be another one.
    fn either(&self, role: Role, found: impl Fn(&Columns) -> Option<usize>) -> Option<usize> {
        let found = || self.found.as_ref().and_then(found).filter(|at| !self.is_used(*at));
        self.of(role).map_or_else(found, |(_, at)| *at)
    }

    fn unit_of_name(&self, at: usize) -> Result<fitcheck_core::length::Unit, ImportErrorKind> {
        unit_of(self.names.cell(at))
    }

    fn length(&self, at: usize) -> Result<LengthColumn, ImportErrorKind> {
        Ok(LengthColumn { at, unit: self.mapping.unit.map_or_else(|| self.unit_of_name(at), |unit| Ok(unit.unit()))? })
    }

    /// The column of X, Y or Z, from 0.
    fn place(&self, role: Role, axis: usize) -> Result<Option<LengthColumn>, ImportErrorKind> {
        let found = |found: &Columns| found.labels.place.get(axis).copied().flatten().map(|column| column.at);
        let Some(at) = self.either(role, found) else { return Ok(None) };
        let unit = self.mapping.place_unit.map_or_else(|| self.unit_of_name(at), |unit| Ok(unit.unit()))?;
        Ok(Some(LengthColumn { at, unit }))
    }

    /// The columns of the times.
    fn times(&self) -> Vec<usize> {
        let found = self.found.as_ref().map_or_else(Vec::new, |found| found.time.clone());
        let is_list = matches!(self.mapping.columns.get(Role::Time.word()), Some(Column::Several(_)));
        let said = self.roles.iter().filter(|(role, _)| *role == Role::Time);
        match self.of(Role::Time) {
            // Date and time may have a column each, and one of them is named.
            Some((_, Some(at))) if !is_list && found.contains(at) => found,
            Some(_) => said.filter_map(|(_, at)| *at).collect(),
            None => found.into_iter().filter(|at| !self.is_used(*at)).collect(),
        }
    }

    /// The columns that say what was measured.
    fn quantities(&self, columns: &Columns, sample: &Sample) -> Vec<QuantityColumn> {
        let found = self.found.as_ref().map_or_else(Vec::new, |found| found.quantities.clone());
        if self.of(Role::Quantity).is_none() {
            return found.into_iter().filter(|column| !self.is_used(column.at)).collect();
        }
        let said = self.roles.iter().filter(|(role, _)| *role == Role::Quantity);
        said.filter_map(|(_, at)| sample.quantity(&self.names, (*at)?, columns.id)).collect()
    }

    /// The columns of the limits: those that are said; otherwise those that are found, but for columns that are said to be something else.
    fn limits(&self, columns: &Columns, sample: &Sample) -> Result<Option<LimitColumns>, ImportErrorKind> {
        let all = LIMITS;
        let said = |role: Role| self.of(role).and_then(|(_, at)| *at);
        if all.into_iter().any(|role| said(role).is_some()) {
            let are = match (said(Role::Maximum).or(said(Role::Minimum)), said(Role::Minus)) {
                (Some(_), _) => LimitsAre::Sizes,
                (None, Some(_)) => LimitsAre::UnsignedDeviations,
                (None, None) => LimitsAre::Deviations,
            };
            let (upper, lower) = match are {
                LimitsAre::Sizes => (said(Role::Maximum), said(Role::Minimum)),
                LimitsAre::Deviations | LimitsAre::UnsignedDeviations => {
                    (said(Role::Upper), said(Role::Lower).or(said(Role::Minus)))
                }
            };
            return Sample::said_limits(Found { upper, lower, are: Some(are) }, &self.names);
        }
        // Somebody says that there are none.
        if all.into_iter().any(|role| self.of(role).is_some()) {
            return Ok(None);
        }
        let beside = Beside {
            names: &self.names,
            measured: columns.measured.at,
            nominal: columns.nominal.map(|column| column.at),
            has_callouts: columns.tolerance.is_some(),
        };
        let used = columns.used();
        sample.limit_columns(beside, |at| !self.is_used(at) && !used.contains(&at))
    }

    fn columns(&self, measured: usize, width: usize) -> Result<Columns, ImportErrorKind> {
        let id = self.either(Role::Id, |found| found.id);
        let number = self.either(Role::Number, |found| found.labels.number);
        // Another column than the one that was found is what the user means by the number or the name of a feature.
        let may_be_running = self.found.as_ref().map_or(id.is_none() && number.is_none(), |found| {
            found.labels.may_be_running && (found.id, found.labels.number) == (id, number)
        });
        let labels = LabelColumns {
            number,
            part: self.either(Role::Part, |found| found.labels.part),
            serial: self.either(Role::Serial, |found| found.labels.serial),
            who: self.either(Role::Who, |found| found.labels.who),
            machine: self.either(Role::Machine, |found| found.labels.machine),
            batch: self.either(Role::Batch, |found| found.labels.batch),
            place: [self.place(Role::X, 0)?, self.place(Role::Y, 1)?, self.place(Role::Z, 2)?],
            may_be_running,
        };
        let beside = |at: Option<usize>| at.filter(|at| *at != measured);
        let nominal = beside(self.either(Role::Nominal, |found| found.nominal.map(|column| column.at)));
        let count = self.found.as_ref().map_or(width, |found| found.count);
        let count = if self.names.is_empty() { count } else { self.names.len() };
        Ok(Columns {
            id: beside(id),
            tolerance: beside(self.either(Role::Tolerance, |found| found.tolerance)),
            nominal: nominal.map(|at| self.length(at)).transpose()?,
            measured: self.length(measured)?,
            time: self.times(),
            simulated: self.either(Role::Simulated, |found| found.simulated),
            count: count.max(self.roles.iter().filter_map(|(_, at)| *at).max().map_or(0, |at| at + 1)),
            own: if self.names.is_empty() { OwnColumns::default() } else { OwnColumns::of(&self.names) },
            evidence: self.evidence(measured),
            labels,
            first: self.mapping.first_row,
            ..Columns::default()
        })
    }

    /// What the names say of how a value came about; of its origin only where no other column is said to tell it.
    fn evidence(&self, measured: usize) -> Evidence {
        let mut evidence = Evidence::of(&self.names, measured);
        evidence.origin = evidence.origin.filter(|at| self.of(Role::Simulated).is_none() && !self.is_used(*at));
        evidence
    }

    /// The names of the columns that are not used.
    fn ignored(&self, columns: &Columns) -> Vec<String> {
        let roles = roles(columns);
        let is_ignored = |at: &usize| {
            let is_own = columns.own.of_correction().chain(columns.evidence.origin).any(|own| own == *at);
            let is_named = self.names.is_empty() || self.names.get(*at).is_some_and(|name| !name.trim().is_empty());
            roles.get(*at).is_some_and(Option::is_none) && !is_own && is_named
        };
        let ignored = (0..columns.count).filter(is_ignored);
        ignored.map(|at| name_of(at, self.names.cell(at))).collect()
    }
}

/// The place of a column in the rows of a file; `None` where it is none.
fn place_of(
    column: &Column,
    role: Role,
    names: &csv::StringRecord,
    width: usize,
) -> Result<Option<usize>, ImportErrorKind> {
    match column {
        Column::Name(name) if !column.is_none() => {
            let found: Vec<usize> =
                (0..).zip(names).filter(|(_, cell)| is_named(cell, name)).map(|(at, _)| at).collect();
            match found.as_slice() {
                [] => Err(no_column(role, name, names, width)),
                [at] => Ok(Some(*at)),
                all => Err(several(role, names, all)),
            }
        }
        Column::Number(number) => match number.checked_sub(1).filter(|at| *at < width) {
            None => Err(no_column(role, &number.to_string(), names, width)),
            at => Ok(at),
        },
        Column::Name(_) | Column::Several(_) => Ok(None),
    }
}

fn no_column(role: Role, given: &str, names: &csv::StringRecord, width: usize) -> ImportErrorKind {
    let width = width.max(names.len());
    let names: Vec<String> = (0..width).map(|at| name_of(at, names.cell(at))).collect();
    ImportErrorKind::NoColumn { role, given: shorten(given), columns: listed(&names) }
}

/// What each column holds.
pub(super) fn roles(columns: &Columns) -> Vec<Option<Role>> {
    let labels = &columns.labels;
    let [x, y, z] = labels.place.map(|column| column.map(|column| column.at));
    let samples = columns.sample_places();
    let measured = Some(columns.measured.at).filter(|_| samples.is_empty());
    let one = [
        (Role::Measured, measured),
        (Role::Tolerance, columns.tolerance),
        (Role::Nominal, columns.nominal.map(|column| column.at)),
        (Role::Id, columns.id),
        (Role::Simulated, columns.simulated),
        (Role::Number, labels.number),
        (Role::Part, labels.part),
        (Role::Serial, labels.serial),
        (Role::Who, labels.who),
        (Role::Machine, labels.machine),
        (Role::Batch, labels.batch),
        (Role::X, x),
        (Role::Y, y),
        (Role::Z, z),
    ];
    let limits = columns.limits.iter().flat_map(|limits| {
        let [upper, lower] = match limits.are {
            LimitsAre::Sizes => [Role::Maximum, Role::Minimum],
            LimitsAre::Deviations => [Role::Upper, Role::Lower],
            LimitsAre::UnsignedDeviations => [Role::Upper, Role::Minus],
        };
        let at = |column: Option<LengthColumn>| column.map(|column| column.at);
        [(upper, at(limits.upper)), (lower, at(limits.lower))]
    });
    let units = columns.stated.columns.iter().map(|at| (Role::Units, Some(*at)));
    let beside = columns.beside.iter().filter_map(|column| Some((column.role()?, Some(column.at()))));
    let samples = samples.into_iter().map(|at| (Role::Sample, Some(at)));
    let times = columns.time.iter().map(|at| (Role::Time, Some(*at)));
    let quantities = columns.quantities.iter().map(|column| (Role::Quantity, Some(column.at)));
    let all: Vec<(Role, Option<usize>)> = one
        .into_iter()
        .chain(samples)
        .chain(times)
        .chain(quantities)
        .chain(limits)
        .chain(units)
        .chain(beside)
        .collect();
    (0..columns.count).map(|at| all.iter().find(|(_, of)| *of == Some(at)).map(|(role, _)| *role)).collect()
}
