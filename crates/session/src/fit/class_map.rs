//! Every class of holes or of shafts at one size: what can be chosen, where it lies, and its neighbours.

use std::collections::{BTreeMap, BTreeSet};

use fitcheck_core::length::Length;
use fitcheck_core::tolerance::iso286::{self, Grade, Letter};
use fitcheck_core::tolerance::{Callout, Deviations, Feature, Sources, ToleranceClass};

use crate::Step;

/// A class at the map's size.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MapCell {
    pub class: ToleranceClass,
    /// Its limit deviations.
    pub deviations: Deviations,
    /// The upper one in micrometres, for drawing.
    pub upper_um: f64,
    /// The lower one in micrometres, for drawing.
    pub lower_um: f64,
}

/// The classes by grade and letter.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct ClassMap {
    cells: BTreeMap<(Grade, Letter), MapCell>,
    grades: BTreeSet<Grade>,
    /// Classes of own tables that the standard does not have.
    pub others: Vec<ToleranceClass>,
}

impl ClassMap {
    /// Every class that the sources define at a size: those of the standard, where one is used, and those of the
    /// tables.
    pub(super) fn new(feature: Feature, nominal: Length, sources: &Sources) -> Self {
        let standard = sources.standard_classes_at(feature, nominal).map(|(class, _)| class);
        let mut map = Self::default();
        for class in standard.chain(sources.table_classes(feature)) {
            // An own table may differ from the standard, or say that the class is not defined here.
            let callout = Callout::new(nominal, class).ok();
            if let Some(limits) = callout.and_then(|callout| sources.limits(&callout, None).ok()) {
                map.put(class, limits.deviations);
            }
        }
        map
    }

    fn put(&mut self, class: ToleranceClass, deviations: Deviations) {
        let um = |length: Length| length.to_mm_f64() * 1000.0;
        let upper_um = um(deviations.upper());
        let lower_um = um(deviations.lower());
        match iso286::parts(class) {
            Some((letter, grade)) => {
                self.grades.insert(grade);
                self.cells.insert((grade, letter), MapCell { class, deviations, upper_um, lower_um });
            }
            None if self.others.contains(&class) => {}
            None => self.others.push(class),
        }
    }

    /// Whether there is no class at all.
    pub fn is_empty(&self) -> bool {
        self.cells.is_empty() && self.others.is_empty()
    }

    /// The grades that some class has, finest first.
    pub fn grades(&self) -> impl Iterator<Item = Grade> {
        self.grades.iter().copied()
    }

    /// The class of a letter and a grade, where it is defined.
    pub fn cell(&self, letter: Letter, grade: Grade) -> Option<&MapCell> {
        self.cells.get(&(grade, letter))
    }

    /// Whether a class is defined.
    pub fn has(&self, class: ToleranceClass) -> bool {
        let in_standard = iso286::parts(class).is_some_and(|(letter, grade)| self.cell(letter, grade).is_some());
        in_standard || self.others.contains(&class)
    }

    /// The lowest and the highest deviation of a grade in micrometres, with the zero line between them; never equal.
    pub fn range_um(&self, grade: Grade) -> (f64, f64) {
        let of_grade = || Letter::ALL.into_iter().filter_map(|letter| self.cell(letter, grade));
        let lowest = of_grade().map(|cell| cell.lower_um).fold(0.0, f64::min);
        let highest = of_grade().map(|cell| cell.upper_um).fold(0.0, f64::max);
        if lowest < highest { (lowest, highest) } else { (-1.0, 1.0) }
    }

    /// The next defined class in the direction of a step; `None` at the edge, or for a class that is not in the map.
    pub fn next(&self, class: ToleranceClass, step: Step) -> Option<ToleranceClass> {
        let (letter, grade) = iso286::parts(class)?;
        let in_row = |letter: &Letter| Some(self.cell(*letter, grade)?.class);
        let in_column = |grade: &Grade| Some(self.cell(letter, *grade)?.class);
        match step {
            Step::Left => Letter::ALL.iter().rev().filter(|other| **other < letter).find_map(in_row),
            Step::Right => Letter::ALL.iter().filter(|other| letter < **other).find_map(in_row),
            Step::Up => self.grades.iter().rev().filter(|other| **other < grade).find_map(in_column),
            Step::Down => self.grades.iter().filter(|other| grade < **other).find_map(in_column),
            _ => None,
        }
    }

    /// The class to begin with where none is chosen yet: H7 or h6 if the map has it, else the first.
    pub fn first(&self) -> Option<ToleranceClass> {
        let usual = |number| self.cell(Letter::H, Grade::numbered(number)?);
        let is_hole = self.cells.values().next()?.class.feature() == Feature::Hole;
        let cell = usual(if is_hole { 7 } else { 6 }).or_else(|| self.cells.values().next())?;
        Some(cell.class)
    }
}
