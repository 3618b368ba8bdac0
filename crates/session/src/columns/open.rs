//! A file whose columns are being looked at: what is chosen, and what that makes of its first rows.

use std::path::PathBuf;

use fitcheck_core::message::{Located, Message, Say as _, message};
use fitcheck_core::part::Plan;
use fitcheck_core::tolerance::Sources;
use fitcheck_exchange::exchange::{
    ByPlan, Choice, ColumnUnit, DecimalSign, Detected, FirstRows, ImportInputs, Item, Kept, Mapping, Role, Separator,
};
use jiff::civil::DateTime;

use crate::purpose::ImportInto;

/// What the columns of a file were taken for.
#[derive(Debug, Clone, PartialEq)]
pub struct UsedColumns {
    /// The file's name without its folder.
    pub name: String,
    /// The file.
    pub path: PathBuf,
    /// Where its values go.
    pub into: ImportInto,
    /// What each column holds.
    pub detected: Detected,
    /// The shape and the day of the mapping that was remembered for it.
    pub remembered: Option<(String, String)>,
}

/// A file whose columns are asked about.
#[derive(Debug, Clone, PartialEq)]
pub struct ColumnsRequest {
    /// Its name without the folder.
    pub name: String,
    /// The file.
    pub path: PathBuf,
    /// Where its values go.
    pub into: ImportInto,
    /// Its beginning.
    pub first: FirstRows,
    /// What was remembered for it, to begin with.
    pub mapping: Mapping,
    /// Whether the user asked to see its columns; otherwise they are not certain.
    pub is_wanted: bool,
}

/// What is chosen.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum ColumnChoice {
    /// What a column holds, from 0.
    Role(usize, Option<Role>),
    /// The sheet of a workbook; its columns are detected anew.
    Sheet(String),
    /// What separates cells; the columns are detected anew.
    Separator(Separator),
    /// The decimal sign; `None` as in the file.
    Decimal(Option<DecimalSign>),
    /// The unit of sizes; `None` as the names of the columns say.
    Unit(Option<ColumnUnit>),
    /// The unit of X, Y and Z; `None` as the names of the columns say.
    PlaceUnit(Option<ColumnUnit>),
    /// The line of the first row; `None` below the header.
    FirstRow(Option<usize>),
}

/// A file whose columns are being looked at.
#[derive(Debug, Clone)]
pub struct OpenColumns {
    /// The file, where its values go, and whether the user asked to see its columns.
    pub asked: ColumnsRequest,
    /// What is chosen.
    pub choice: Choice,
    /// The first rows from the top, with their lines.
    pub rows: Vec<(usize, Vec<String>)>,
    /// How many columns there are.
    pub width: usize,
    names: Vec<String>,
    /// The line of the header.
    pub header: Option<usize>,
    /// The lines of the shown rows that are read as values.
    pub lines: Vec<usize>,
    /// What says the unit of sizes, as it stands in the file.
    pub unit_from: Option<String>,
    /// How many of the shown rows become values.
    pub read: usize,
    /// What is wrong with the first one that becomes none.
    pub problem: Option<Message>,
    /// Why nothing can be taken.
    pub refusal: Option<Message>,
}

impl OpenColumns {
    pub(super) fn new(asked: ColumnsRequest, sources: &Sources, plan: Option<&Plan>, now: DateTime) -> Self {
        let choice = asked.first.guess(&asked.mapping);
        let mut open = Self {
            asked,
            choice,
            rows: Vec::new(),
            width: 0,
            names: Vec::new(),
            header: None,
            lines: Vec::new(),
            unit_from: None,
            read: 0,
            problem: None,
            refusal: None,
        };
        open.look(sources, plan, now);
        open
    }

    pub(super) fn choose(&mut self, choice: ColumnChoice) {
        match choice {
            ColumnChoice::Role(at, role) => self.choice.give(at, role),
            ColumnChoice::Sheet(sheet) => {
                self.choice = self.asked.first.guess(&Mapping::split(Some(sheet), None));
            }
            ColumnChoice::Separator(separator) => {
                self.choice = self.asked.first.guess(&Mapping::split(None, Some(separator)));
            }
            ColumnChoice::Decimal(decimal) => self.choice.decimal = decimal,
            ColumnChoice::Unit(unit) => self.choice.unit = unit,
            ColumnChoice::PlaceUnit(unit) => self.choice.place_unit = unit,
            ColumnChoice::FirstRow(line) => self.choice.first_row = line,
        }
    }

    /// What is chosen, as a mapping.
    pub(super) fn mapping(&self) -> Mapping {
        self.choice.mapping(&self.names)
    }

    pub(super) fn kept(&self, now: DateTime) -> Option<Kept> {
        Kept::of(&self.asked.first, &self.choice, now)
    }

    /// Looks at the first rows with what is chosen.
    pub(super) fn look(&mut self, sources: &Sources, plan: Option<&Plan>, now: DateTime) {
        self.names = self.asked.first.names(&self.choice);
        let mapping = self.mapping();
        self.rows = self.asked.first.rows(&mapping);
        self.width = self.asked.first.width(&mapping).max(self.choice.roles.len());
        let detected = self.asked.first.detect(&mapping);
        self.header = None;
        self.lines = Vec::new();
        self.read = 0;
        self.problem = None;
        self.refusal = None;
        self.unit_from = None;
        match &detected {
            Ok(detected) => {
                self.header = detected.header;
                self.unit_from.clone_from(&detected.unit_from);
                let is_shown = |line: &usize| self.rows.iter().any(|(shown, _)| shown == line);
                self.lines = detected.rows.iter().map(|(line, _)| *line).filter(is_shown).collect();
                self.refusal = refusal(self.asked.into, |role| detected.has(role));
            }
            Err(error) => {
                let chosen = refusal(self.asked.into, |role| self.choice.roles.contains(&Some(role)));
                self.refusal = Some(chosen.unwrap_or_else(|| error.message()));
            }
        }
        let given = ImportInputs { has_plan: plan.is_some(), ..ImportInputs::new(sources, now) };
        let Ok(items) = self.asked.first.items(&mapping, given) else { return };
        let items = match plan {
            Some(plan) => ByPlan::new(plan).file(items),
            None => items,
        };
        for item in items {
            see(&item, self.asked.into, &mut self.read, &mut self.problem);
        }
    }

    /// The file's name without its folder.
    pub fn name(&self) -> &str {
        &self.asked.name
    }

    /// The name of a column, from 0; empty where it has none.
    pub fn column_name(&self, at: usize) -> &str {
        self.names.get(at).map_or("", String::as_str)
    }

    /// What a column holds, from 0.
    pub fn role(&self, at: usize) -> Option<Role> {
        self.choice.roles.get(at).copied().flatten()
    }

    /// Whether a column has a coordinate.
    pub fn has_place(&self) -> bool {
        [Role::X, Role::Y, Role::Z].into_iter().any(|role| self.choice.roles.contains(&Some(role)))
    }
}

/// What is needed to use a file, where a column for it is missing: measured values, and what they are of.
pub fn refusal(into: ImportInto, has: impl Fn(Role) -> bool) -> Option<Message> {
    if !has(Role::Measured) && !has(Role::Sample) {
        return Some(message!("columns-page-no-measured"));
    }
    match into {
        ImportInto::History => {
            let limits = [Role::Tolerance, Role::Upper, Role::Lower, Role::Maximum, Role::Minimum];
            (!limits.into_iter().any(&has)).then(|| message!("columns-page-no-callout"))
        }
        ImportInto::Part(_) => {
            let is_found = has(Role::Id) || has(Role::Number) || has(Role::X) && has(Role::Y);
            (!is_found).then(|| message!("columns-page-no-name"))
        }
        // A part and an operator are needed by some studies only.
        ImportInto::Study => None,
    }
}

fn see(item: &Item, into: ImportInto, read: &mut usize, problem: &mut Option<Message>) {
    let wrong = match item {
        Item::Record { .. } => {
            *read += 1;
            return;
        }
        // A reading needs no limits.
        Item::Unjudged(unjudged) if into == ImportInto::Study && unjudged.measured.is_some() => {
            *read += 1;
            return;
        }
        Item::Error(error) => error.message(),
        Item::Unjudged(unjudged) => Located::in_line(unjudged.line, unjudged.why.clone()).message(),
        Item::Warning(_) | Item::Contacts(_) => return,
    };
    problem.get_or_insert(wrong);
}
