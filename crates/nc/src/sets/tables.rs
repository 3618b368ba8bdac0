//! The two tables of a set: the 47 classes of NC-Solution 8255, and what else the plan needs.

use std::collections::BTreeSet;

use fitcheck_core::length::Length;
use fitcheck_core::tolerance::table::Column;
use fitcheck_core::tolerance::{Callout, DeviationTable, Deviations, Feature, Limits, Sources, ToleranceClass};

use super::Planned;
use super::error::{SetError, SetRemark};
use super::given::is_given;
use super::names::Names;
use crate::control::deviations::to_control_table;
use crate::control::shipped_tables;
use crate::control::table::WriteError;

/// The table of holes or of shafts, with its remarks. Size ranges are those of the built-in table, divided where the
/// user's own tables or the classes of the plan need it, so that no cell ever holds two values.
///
/// An iTNC 530 accepts at most 30 columns: if the classes beyond the 47 do not fit, only the plan's are written.
pub(super) fn table(
    feature: Feature,
    planned: &[Planned<'_>],
    sources: &Sources,
    names: &Names<'_>,
) -> Result<(Vec<u8>, Vec<SetRemark>), SetError> {
    let name = names.table(feature);
    let sizes = planned.iter().flat_map(Planned::sizes);
    // Limits without a class stand in the main program.
    let is_asked = |(callout, limits): &(Callout, &Limits)| !is_given(callout) && limits.feature == Some(feature);
    let asked: Vec<(Callout, &Limits)> = sizes.filter(is_asked).collect();
    let usual = usual_classes(feature);
    let mut own: Vec<ToleranceClass> = Vec::new();
    let mut wanted: Vec<ToleranceClass> = Vec::new();
    for class in asked.iter().filter_map(|(callout, _)| callout.class()) {
        if !wanted.contains(&class) {
            wanted.push(class);
        }
        if !usual.contains(&class) && !own.contains(&class) {
            own.push(class);
        }
    }
    let ends = ends(feature, &asked, sources);
    let all: Vec<ToleranceClass> = usual.iter().chain(&own).copied().collect();
    let mut remarks: Vec<SetRemark> = own.iter().map(|&class| SetRemark::OwnColumn { class, table: name }).collect();
    let generation = names.target.control.generation();
    let written = |classes: &[ToleranceClass]| {
        made(name, classes, &ends, sources).map(|table| to_control_table(&table, generation).write())
    };
    let bytes = match written(&all)? {
        Err(WriteError::TooManyColumns { .. } | WriteError::TooLong { .. }) if !own.is_empty() => {
            let classes = wanted.iter().map(ToleranceClass::as_str).collect::<Vec<_>>().join(" ");
            remarks.push(SetRemark::FewerColumns { table: name, classes });
            written(&wanted)?
        }
        written => written,
    };
    let bytes = bytes.map_err(|error| SetError::Table { table: name, error })?;
    Ok((bytes, remarks))
}

/// The classes of the built-in table.
fn usual_classes(feature: Feature) -> Vec<ToleranceClass> {
    let tables = shipped_tables();
    let classes = tables.iter().flat_map(|table| table.columns().iter().map(|column| column.class));
    classes.filter(|class| class.feature() == feature).collect()
}

fn ends(feature: Feature, asked: &[(Callout, &Limits)], sources: &Sources) -> Vec<Length> {
    let holds = |table: &DeviationTable| table.columns().iter().any(|column| column.class.feature() == feature);
    let tables = shipped_tables();
    let tables = tables.iter().chain(sources.tables()).filter(|table| holds(table));
    let mut ends: BTreeSet<Length> = tables.flat_map(|table| table.ends().iter().copied()).collect();
    for (over, to) in asked.iter().filter_map(|(_, limits)| limits.source.range()) {
        ends.extend([over, to]);
    }
    ends.remove(&Length::ZERO);
    ends.into_iter().collect()
}

fn made(
    name: &'static str,
    classes: &[ToleranceClass],
    ends: &[Length],
    sources: &Sources,
) -> Result<DeviationTable, SetError> {
    let ranges = || std::iter::once(Length::ZERO).chain(ends.iter().copied()).zip(ends.iter().copied());
    let column = |&class| Column { class, cells: ranges().map(|range| cell(class, range, sources)).collect() };
    DeviationTable::new(name, false, ends.to_vec(), classes.iter().map(column).collect())
        .map_err(|error| SetError::Shape { table: name, error })
}

/// A cell is filled if a single value of the source applies in the whole range: in one of its ranges, or in each of several (ISO 286-1 has R
/// in finer ranges than the table, with the same values in two of them).
fn cell(class: ToleranceClass, (over, to): (Length, Length), sources: &Sources) -> Option<Deviations> {
    let at = |size: Length| {
        let (deviations, source) = sources.deviations(&Callout::new(size, class).ok()?, None).ok()?;
        Some((deviations, source.range()?.0))
    };
    let (deviations, mut from) = at(to)?;
    while over < from {
        let (below, start) = at(from)?;
        // A range that does not end at its upper end would be looked at for ever.
        if below != deviations || from <= start {
            return None;
        }
        from = start;
    }
    Some(deviations)
}
