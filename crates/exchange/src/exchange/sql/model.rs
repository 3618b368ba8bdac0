//! What the SQL holds: every cell of class and step, as the sources of limits answer it.

use std::collections::HashMap;
use std::sync::Arc;

use fitcheck_core::length::{Length, Unit};
use fitcheck_core::message::Say;
use fitcheck_core::tolerance::iso286::{self, Grade, Letter};
use fitcheck_core::tolerance::{Callout, DeviationTable, Feature, LimitsError, Sources, ToleranceClass};

/// The last millimetre that the table of steps reaches: far beyond any machine, and a bound for the size of the SQL.
const LAST_MM: u32 = 100_000;

/// The limit deviations of a class in a step.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Cell {
    pub class: ToleranceClass,
    /// The number of the step, from 1.
    pub step: usize,
    /// The step: above this many millimetres,
    pub over_mm: u32,
    /// up to and including this.
    pub to_mm: u32,
    /// Lower limit deviation.
    pub lower: Length,
    /// Upper limit deviation.
    pub upper: Length,
    /// The number of its source, from 1: see [`Model::sources`].
    pub source: usize,
}

/// Every cell, with what the cells refer to.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Model {
    options: iso286::Options,
    classes: Vec<ToleranceClass>,
    ends: Vec<u32>,
    sources: Vec<String>,
    cells: Vec<Cell>,
}

/// Why limits cannot be written as SQL.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(prefix = "sql", error)]
pub enum SqlError {
    /// A range of a table ends within a millimetre: the look-up goes by whole millimetres.
    Border { table: Arc<str>, end: Length },
    /// A range of a table ends beyond what the table of steps holds.
    #[say(args(most = Length::from_micrometres(LAST_UM)))]
    TooFar { table: Arc<str>, end: Length },
    /// A class is named twice.
    Twice { class: ToleranceClass },
    /// A chosen class has no limits at any size: the reason is that of the last step.
    #[say(transparent)]
    Limits(LimitsError),
}

/// [`LAST_MM`] in micrometres.
const LAST_UM: i32 = 100_000_000;

impl Model {
    /// The cells of some classes, or of every class that the sources know: those of the tables, then those of ISO 286.
    ///
    /// # Errors
    /// [`SqlError`] names the border of a table, or the class, that is not possible.
    pub fn new(sources: &Sources, chosen: Option<Vec<ToleranceClass>>) -> Result<Self, SqlError> {
        let is_chosen = chosen.is_some();
        let classes = chosen.unwrap_or_else(|| every_class(sources));
        if let Some(class) = first_twice(&classes) {
            return Err(SqlError::Twice { class });
        }
        let ends = ends(sources, &classes)?;
        let mut model =
            Self { options: sources.options(), classes: Vec::new(), ends, sources: Vec::new(), cells: Vec::new() };
        let mut numbers = HashMap::new();
        for class in classes {
            let cells_before = model.cells.len();
            let refused = model.add(class, sources, &mut numbers);
            match refused {
                Some(error) if is_chosen && model.cells.len() == cells_before => return Err(SqlError::Limits(error)),
                _ => model.classes.push(class),
            }
        }
        Ok(model)
    }

    /// Adds the cells of a class; the reason why it has none in the last step where that is so.
    fn add(
        &mut self,
        class: ToleranceClass,
        sources: &Sources,
        numbers: &mut HashMap<String, usize>,
    ) -> Option<LimitsError> {
        let mut refused = None;
        let mut over_mm = 0;
        for (step, &to_mm) in (1..).zip(&self.ends) {
            // No class changes within a step, so its end represents all of it.
            let callout = Callout::new(millimetres(to_mm)?, class).ok()?;
            match sources.limits(&callout, None) {
                Ok(limits) => {
                    let name = limits.source.with_difference();
                    let next = self.sources.len() + 1;
                    let source = *numbers.entry(name).or_insert_with_key(|name| {
                        self.sources.push(name.clone());
                        next
                    });
                    let lower = limits.deviations.lower();
                    let upper = limits.deviations.upper();
                    self.cells.push(Cell { class, step, over_mm, to_mm, lower, upper, source });
                    refused = None;
                }
                Err(error) => refused = Some(error),
            }
            over_mm = to_mm;
        }
        refused
    }

    /// The choices where editions of ISO 286 differ.
    pub const fn options(&self) -> iso286::Options {
        self.options
    }

    /// The classes that are known, in the order of the cells; some may have none.
    pub fn classes(&self) -> &[ToleranceClass] {
        &self.classes
    }

    /// The ends of the steps in whole millimetres, ascending; they belong to their steps, and the first begins above 0.
    pub fn ends(&self) -> &[u32] {
        &self.ends
    }

    /// Where limits come from, as every answer says it, and what ISO 286 says where an own table differs; a cell has the number of its source, from 1.
    pub fn sources(&self) -> &[String] {
        &self.sources
    }

    /// The cells that have limits: class by class, by ascending size.
    pub fn cells(&self) -> &[Cell] {
        &self.cells
    }

    /// How many classes have limits at some size.
    pub fn defined(&self) -> usize {
        self.cells.chunk_by(|one, next| one.class == next.class).count()
    }

    /// The end of the last step; 0 where there is none.
    pub(super) fn last(&self) -> u32 {
        self.ends.last().map_or(0, |end| *end)
    }

    /// Every whole millimetre with the number of its step: a size belongs to the step of the millimetre that it is
    /// rounded up to.
    pub fn millimetres(&self) -> impl Iterator<Item = (u32, usize)> {
        (1..=self.last()).map(|mm| (mm, self.ends.partition_point(|end| *end < mm) + 1))
    }
}

/// Those of the tables, table by table, then those of the standard.
fn every_class(sources: &Sources) -> Vec<ToleranceClass> {
    let mut classes: Vec<ToleranceClass> = Vec::new();
    for feature in [Feature::Hole, Feature::Shaft] {
        let standard = sources.base().is_standard().then(|| named_classes(feature));
        for class in sources.table_classes(feature).chain(standard.into_iter().flatten()) {
            if !classes.contains(&class) {
                classes.push(class);
            }
        }
    }
    classes
}

/// Every letter with every grade. Some, such as J9, are defined at no size, but the standard has their letter and grade:
/// they are refused as classes without limits and not as unknown.
fn named_classes(feature: Feature) -> impl Iterator<Item = ToleranceClass> {
    let class = move |letter| Grade::all().map(move |grade| iso286::class(feature, letter, grade));
    Letter::ALL.into_iter().flat_map(class)
}

fn first_twice(classes: &[ToleranceClass]) -> Option<ToleranceClass> {
    (0..)
        .zip(classes)
        .find(|(number, class)| classes.iter().take(*number).any(|before| before == *class))
        .map(|(_, class)| *class)
}

/// The ends of all steps that matter for the classes, in whole millimetres.
fn ends(sources: &Sources, classes: &[ToleranceClass]) -> Result<Vec<u32>, SqlError> {
    let has_class = |table: &DeviationTable| table.columns().iter().any(|column| classes.contains(&column.class));
    let mut ends = Vec::new();
    for table in sources.tables().filter(|table| has_class(table)) {
        for &end in table.ends() {
            let name = || table.name().into();
            match whole_millimetres(end) {
                None => return Err(SqlError::Border { table: name(), end }),
                Some(mm) if LAST_MM < mm => return Err(SqlError::TooFar { table: name(), end }),
                Some(mm) => ends.push(mm),
            }
        }
    }
    if sources.base().is_standard() {
        ends.extend(iso286::step_ends().filter_map(whole_millimetres));
    }
    ends.sort_unstable();
    ends.dedup();
    Ok(ends)
}

fn whole_millimetres(length: Length) -> Option<u32> {
    length.exact(Unit::Millimetre, 0).parse().ok()
}

fn millimetres(mm: u32) -> Option<Length> {
    Length::from_nanometres(i64::from(mm) * 1_000_000).ok()
}
