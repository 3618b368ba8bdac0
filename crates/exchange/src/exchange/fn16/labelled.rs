//! The values of a part in a series, by the words before their fields: `BORE 1 MIN %9.4F MAX %9.4F ACTUAL %9.4F`.
//!
//! `series` has the words. A group that does not say which of its numbers was measured leaves the mask to the callouts.

use std::ops::Range;

use fitcheck_nc::control::mask::Slot;

use super::fields::{Fields, Reading, ReadingKind, is_callout, is_status};
use crate::exchange::quantity::is_shape;
use crate::exchange::series::{self, Figure, Group};
use crate::exchange::words;

/// The values of a mask that says which part it is; none where its words leave any of them open.
pub(super) fn readings(fields: &Fields<'_>, nominal: Option<usize>) -> Vec<Reading> {
    let numbers = fields.numbers();
    let mut groups: Vec<Group> = Vec::new();
    // A text may stand between the name and the first number: `BORE 1: %S MIN %9.4F`.
    let mut waiting: Option<(usize, String)> = None;
    for (at, slot) in (0..).zip(fields.slots).filter(|(at, _)| Some(*at) != nominal) {
        let (name, figure) = series::said(&slot.label);
        if numbers.contains(&at) {
            let begun = waiting.take();
            let (from, name) = if name.is_empty() { begun.unwrap_or((at, name)) } else { (at, name) };
            series::add(&mut groups, (from, at), name, figure);
        } else if is_name(slot, &name, figure) {
            waiting = Some((at, name));
        }
    }
    let ends = groups.iter().skip(1).map(|group| group.from).chain([fields.slots.len()]);
    groups.iter().zip(ends).map(|(group, end)| reading(fields, group, end)).collect::<Option<_>>().unwrap_or_default()
}

/// The value of a group, whose texts end before the next one.
fn reading(fields: &Fields<'_>, group: &Group, end: usize) -> Option<Reading> {
    // Its status may stand behind its numbers on their line.
    let line = |at: usize| fields.slots.get(at).map(|slot| slot.line);
    let end = (group.last..end).find(|at| line(*at) != line(group.last)).unwrap_or(end);
    let own: Range<usize> = group.from..end;
    let text = |kind: fn(&str) -> bool| fields.texts_that(kind).find(|at| own.contains(at));
    Some(Reading {
        minimum: group.at(Figure::Minimum),
        maximum: group.at(Figure::Maximum),
        nominal: group.at(Figure::Nominal),
        callout: text(is_callout),
        status: text(is_status),
        is_hole: side(fields, own.clone()),
        name: group.name.clone(),
        ..Reading::of(group.measured()?, ReadingKind::Size)
    })
}

/// Whether a text stands behind the name of a value: its label is no word of the part, of a figure or of a status.
fn is_name(slot: &Slot, name: &str, figure: Option<Figure>) -> bool {
    let label = slot.label.trim_end_matches([':', '=']);
    slot.digits.is_none()
        && figure.is_none()
        && name.contains(char::is_alphabetic)
        && words::label(label).is_none()
        && !words::is_status(label)
}

/// What the words before a field call it: a figure stands behind the name, or the name has a number.
pub(super) fn name(slots: &[Slot], at: usize) -> String {
    let (name, figure) = slots.get(at).map_or_else(Default::default, |slot| series::said(&slot.label));
    let is_name = figure.is_some() || name.contains(|c: char| c.is_ascii_digit());
    if is_name { name } else { String::new() }
}

/// Whether the words before some fields say that they are of a hole, or else of a shaft.
pub(super) fn side(fields: &Fields<'_>, of: impl Iterator<Item = usize>) -> Option<bool> {
    let labels = of.filter_map(|at| fields.slots.get(at)).map(|slot| slot.label.as_str());
    is_shape(&labels.collect::<Vec<_>>().join(" "))
}
