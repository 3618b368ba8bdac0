//! The answer in figures: the names that CSV and JSON share, the same in every language.
//!
//! Millimetres and micrometres as the names say, exact, with a point. Missing values are null, and empty in CSV.

use std::io::{Result, Write};

use fitcheck_core::pairing::{Grinding, Group, Groups, Pair, PairClearances};
use serde::Serialize;

use super::{Format, PairingAnswer, PairingParts};
use crate::report::csv::cell;
use crate::row::columns::{self, Cell as _, Column, columns, names};
use crate::row::figure::Figure;

/// The answer row by row.
pub(super) const CSV: Format = Format { name: "csv", endings: &["csv"], write: csv };

/// The answer as one object.
pub(super) const JSON: Format = Format { name: "json", endings: &["json"], write: json };

/// The names of the columns of CSV.
pub fn column_names() -> [&'static str; PairingRow::COLUMNS.len()] {
    names(&PairingRow::COLUMNS)
}

/// The whole answer in JSON.
#[derive(Serialize)]
struct Figures<'a> {
    fit: Option<String>,
    minimum_clearance_um: Figure,
    maximum_clearance_um: Figure,
    holes: usize,
    shafts: usize,
    /// What the pairs have; null without pairs.
    actual: Option<Actual>,
    pairs: Vec<PairFigures<'a>>,
    leftover_holes: Vec<PartFigures<'a>>,
    leftover_shafts: Vec<PartFigures<'a>>,
    grinding: Option<GrindingFigures>,
    saved: Vec<PairFigures<'a>>,
    groups: Option<Vec<GroupFigures>>,
    holes_outside_groups: Option<usize>,
    shafts_outside_groups: Option<usize>,
    refused: Vec<RefusedFigures<'a>>,
    warnings: Vec<String>,
}

#[derive(Serialize)]
struct Actual {
    pairs: usize,
    minimum_clearance_um: Figure,
    maximum_clearance_um: Figure,
    band_um: Figure,
}

#[derive(Serialize)]
struct PairFigures<'a> {
    hole: PartFigures<'a>,
    shaft: PartFigures<'a>,
    clearance_um: Figure,
}

#[derive(Serialize)]
struct PartFigures<'a> {
    id: &'a str,
    line: Figure,
    mm: Figure,
    group: Option<Figure>,
    simulated: bool,
}

#[derive(Serialize)]
struct GrindingFigures {
    /// Null where no amount saves a part.
    amount_um: Option<Figure>,
    pairs: Figure,
    tried_um: Figure,
    reach_um: Figure,
    bounded: bool,
}

#[derive(Serialize)]
struct GroupFigures {
    number: Figure,
    hole_from_mm: Figure,
    hole_to_mm: Figure,
    shaft_from_mm: Figure,
    shaft_to_mm: Figure,
    holes: Figure,
    shafts: Figure,
    pairs: Figure,
    minimum_clearance_um: Option<Figure>,
    maximum_clearance_um: Option<Figure>,
    all_within: Option<bool>,
}

#[derive(Serialize)]
struct RefusedFigures<'a> {
    file: &'a str,
    line: Option<Figure>,
    column: Option<Figure>,
    error: String,
}

/// A row of CSV.
#[derive(Default)]
struct PairingRow<'a> {
    result: &'static str,
    hole: Option<PartFigures<'a>>,
    shaft: Option<PartFigures<'a>>,
    clearance_um: Option<Figure>,
    grinding: Option<GrindingFigures>,
    group: Option<GroupFigures>,
    refused: Option<RefusedFigures<'a>>,
}

impl PairingRow<'_> {
    /// The columns of CSV: the names of JSON, joined where one is within another.
    const COLUMNS: [Column<Self>; 32] = columns! {
        result, hole.id, hole.line, hole.mm, hole.group, hole.simulated,
        shaft.id, shaft.line, shaft.mm, shaft.group, shaft.simulated, clearance_um,
        grinding.amount_um, grinding.pairs, grinding.tried_um, grinding.reach_um, grinding.bounded,
        group.number, group.hole_from_mm, group.hole_to_mm, group.shaft_from_mm, group.shaft_to_mm,
        group.holes, group.shafts, group.pairs, group.minimum_clearance_um, group.maximum_clearance_um,
        group.all_within,
        refused.file, refused.line, refused.column, refused.error,
    };
}

fn csv(answer: &PairingAnswer, out: &mut dyn Write) -> Result<()> {
    let mut writer = csv::Writer::from_writer(out);
    writer.write_record(column_names())?;
    let figures = Figures::of(answer);
    let of = |result| PairingRow { result, ..PairingRow::default() };
    let pair = |result, PairFigures { hole, shaft, clearance_um }| PairingRow {
        result,
        hole: Some(hole),
        shaft: Some(shaft),
        clearance_um: Some(clearance_um),
        ..PairingRow::default()
    };
    let rows = (figures.pairs.into_iter().map(|one| pair("pair", one)))
        .chain(figures.leftover_holes.into_iter().map(|hole| PairingRow { hole: Some(hole), ..of("leftover") }))
        .chain(figures.leftover_shafts.into_iter().map(|shaft| PairingRow { shaft: Some(shaft), ..of("leftover") }))
        .chain(figures.grinding.map(|grinding| PairingRow { grinding: Some(grinding), ..of("grinding") }))
        .chain(figures.saved.into_iter().map(|one| pair("saved", one)))
        .chain(figures.groups.into_iter().flatten().map(|group| PairingRow { group: Some(group), ..of("group") }))
        .chain(figures.refused.into_iter().map(|row| PairingRow { refused: Some(row), ..of("refused") }));
    for row in rows {
        writer.write_record(columns::cells(&PairingRow::COLUMNS, &row).map(|text| cell(&text).into_owned()))?;
    }
    writer.flush()
}

fn json(answer: &PairingAnswer, out: &mut dyn Write) -> Result<()> {
    serde_json::to_writer_pretty(&mut *out, &Figures::of(answer))?;
    writeln!(out)
}

fn number(count: usize) -> Figure {
    Figure(count.to_string())
}

impl<'a> Figures<'a> {
    fn of(answer: &'a PairingAnswer) -> Self {
        let PairingAnswer { asked, pairing, grinding, .. } = answer;
        let holes = asked.holes.as_ref();
        let shafts = asked.shafts.as_ref();
        let wanted = asked.wanted;
        let groups = answer.groups();
        let parts = BothSides { holes, shafts, groups };
        let refused =
            |parts: &'a PairingParts| parts.errors.iter().map(|error| RefusedFigures::of(parts.file(), error));
        let outside = groups.map(Groups::outside);
        let saving = grinding.as_ref().and_then(|grinding| grinding.best.as_ref());
        Self {
            fit: asked.fit.as_ref().map(|(callout, _)| callout.to_string()),
            minimum_clearance_um: Figure::um(wanted.minimum()),
            maximum_clearance_um: Figure::um(wanted.maximum()),
            holes: holes.sizes.len(),
            shafts: shafts.sizes.len(),
            actual: answer.clearances().map(|(smallest, largest)| Actual {
                pairs: pairing.pairs.len(),
                minimum_clearance_um: Figure::um(smallest),
                maximum_clearance_um: Figure::um(largest),
                band_um: Figure::um(pairing.band),
            }),
            pairs: pairing.pairs.iter().filter_map(|pair| parts.pair(pair)).collect(),
            leftover_holes: pairing.holes.iter().filter_map(|&at| parts.hole(at)).collect(),
            leftover_shafts: pairing.shafts.iter().filter_map(|&at| parts.shaft(at)).collect(),
            grinding: grinding.as_ref().map(GrindingFigures::of),
            saved: saving.iter().flat_map(|saving| &saving.pairs).filter_map(|pair| parts.pair(pair)).collect(),
            groups: groups.map(|groups| GroupFigures::all(groups, wanted)),
            holes_outside_groups: outside.map(|(holes, _)| holes),
            shafts_outside_groups: outside.map(|(_, shafts)| shafts),
            refused: refused(holes).chain(refused(shafts)).collect(),
            warnings: answer.warnings(),
        }
    }
}

/// Holes and shafts, and their groups if they are sorted.
struct BothSides<'a, 'g> {
    holes: &'a PairingParts,
    shafts: &'a PairingParts,
    groups: Option<&'g Groups>,
}

impl<'a> BothSides<'a, '_> {
    fn hole(&self, at: usize) -> Option<PartFigures<'a>> {
        PartFigures::of(self.holes, at, self.groups.map(|groups| groups.holes.as_slice()))
    }

    fn shaft(&self, at: usize) -> Option<PartFigures<'a>> {
        PartFigures::of(self.shafts, at, self.groups.map(|groups| groups.shafts.as_slice()))
    }

    fn pair(&self, pair: &Pair) -> Option<PairFigures<'a>> {
        let hole = self.hole(pair.hole)?;
        let shaft = self.shaft(pair.shaft)?;
        Some(PairFigures { hole, shaft, clearance_um: Figure::um(pair.clearance) })
    }
}

impl<'a> PartFigures<'a> {
    fn of(parts: &'a PairingParts, at: usize, groups: Option<&[Option<usize>]>) -> Option<Self> {
        let part = parts.sizes.get(at)?;
        let group = groups.and_then(|groups| *groups.get(at)?);
        Some(Self {
            id: &part.id,
            line: number(part.line),
            mm: Figure::mm(part.measured, 3),
            group: group.map(|group| number(group + 1)),
            simulated: part.is_simulated,
        })
    }
}

impl GrindingFigures {
    fn of(grinding: &Grinding) -> Self {
        let best = grinding.best.as_ref();
        Self {
            amount_um: best.map(|best| Figure::um(best.amount)),
            pairs: number(best.map_or(0, |best| best.pairs.len())),
            tried_um: Figure::um(grinding.tried),
            reach_um: Figure::um(grinding.reach),
            bounded: grinding.is_bounded(),
        }
    }
}

impl GroupFigures {
    fn all(groups: &Groups, wanted: PairClearances) -> Vec<Self> {
        (1..).zip(&groups.all).map(|(number, group)| Self::of(number, group, wanted)).collect()
    }

    fn of(at: usize, group: &Group, wanted: PairClearances) -> Self {
        Self {
            number: number(at),
            hole_from_mm: Figure::mm(group.hole_range.from, 3),
            hole_to_mm: Figure::mm(group.hole_range.to, 3),
            shaft_from_mm: Figure::mm(group.shaft_range.from, 3),
            shaft_to_mm: Figure::mm(group.shaft_range.to, 3),
            holes: number(group.holes),
            shafts: number(group.shafts),
            pairs: number(group.pairs()),
            minimum_clearance_um: group.clearances.map(|(smallest, _)| Figure::um(smallest)),
            maximum_clearance_um: group.clearances.map(|(_, largest)| Figure::um(largest)),
            all_within: group.all_within(wanted),
        }
    }
}

impl<'a> RefusedFigures<'a> {
    fn of(file: &'a str, error: &fitcheck_core::message::Located<crate::exchange::ImportError>) -> Self {
        Self {
            file,
            line: error.place.line.map(number),
            column: error.place.column.map(number),
            error: error.what.kind.to_string(),
        }
    }
}
