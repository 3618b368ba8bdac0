//! The columns of which something is compared with the answer of a value, and those in which a remark may stand.

use csv::StringRecord;
use fitcheck_core::length::{Length, Unit};

use super::{BesideColumn, Says, by_name, of_no_size};
use crate::exchange::cell::{Cells as _, joined};
use crate::exchange::claim::Claim;
use crate::exchange::column::name_of;
use crate::exchange::columns::Columns;
use crate::exchange::evidence::says_simulated;
use crate::exchange::quantity::{is_shape, may_be_named};
use crate::exchange::remarks::RemarkColumn;
use crate::exchange::role::Role;
use crate::exchange::sample::Sample;
use crate::exchange::warmth::{self, OfTemperature, Whose};
use crate::exchange::{units, words};

impl Sample {
    /// The columns beside the value of which something is compared; `names` are those of the columns, where there are any.
    pub(in crate::exchange) fn beside(
        &self,
        names: &StringRecord,
        columns: &Columns,
        used: &[usize],
    ) -> Vec<BesideColumn> {
        let is_verdict = |cell: &str| Claim::of_word(cell).is_some_and(|claim| claim.is_known());
        let column = |at: usize| {
            let name = names.cell(at);
            // With the unit below it.
            let unit = self.units_row.and_then(|row| self.rows.get(row)).map_or("", |(_, cells)| cells.cell(at));
            let with_unit = format!("{name} {unit}");
            let has_quantity = columns.quantities.iter().any(|column| column.at == at);
            let is_free = !used.contains(&at) && columns.evidence.origin != Some(at);
            let is_name = columns.id == Some(at) && columns.header.is_some();
            let said = if self.is_said(Role::Kind, at) {
                Some(Says::Feature)
            } else {
                self.is_said(Role::Status, at).then_some(Says::Status { is_named: true })
            };
            let says = match said.or_else(|| by_name(name, &with_unit).filter(|_| is_free && !has_quantity)) {
                None if is_name => self.cells(at).any(|cell| of_no_size(cell).is_some()).then_some(Says::Name),
                Some(says) => Some(says),
                None if has_quantity || is_free && may_be_named(name) => {
                    self.cells(at).any(|cell| is_shape(cell).is_some()).then_some(Says::Feature)
                }
                None if is_free && self.cells(at).any(is_verdict) => Some(Says::Status { is_named: false }),
                None if is_free && self.cells(at).any(|cell| warmth::mentioned(cell).is_some()) => Some(Says::Warmth),
                None => None,
            };
            // What Fitcheck corrected is at 20 °C, whatever it was measured at.
            let says = says.filter(|says| !says.is_of_temperature() || !columns.own.are_corrected());
            let unit = units::unit(name).ok().flatten();
            says.map(|says| BesideColumn { at, name: name.trim().to_owned(), unit, says })
        };
        let mut all: Vec<BesideColumn> = (0..columns.count).filter_map(column).collect();
        // How warm the room was says nothing where the part's own temperature stands beside it.
        let is_of = |column: &BesideColumn, wanted: Whose| matches!(column.says, Says::Temperature(OfTemperature { whose, .. }) if whose == Some(wanted));
        if all.iter().any(|column| is_of(column, Whose::Part)) {
            all.retain(|column| !is_of(column, Whose::Place));
        }
        all
    }

    /// At which temperature all values were measured, as the name of their column and the lines above the names say together.
    pub(in crate::exchange) fn said_of_all(&self, columns: &Columns, names: &StringRecord) -> Option<Claim> {
        if columns.own.are_corrected() || columns.evidence.are_corrected {
            return None;
        }
        let lines = self.comments.iter().chain(&self.rows);
        let above = lines.filter(|(line, _)| columns.header.is_some_and(|header| *line < header));
        let name = names.get(columns.measured.at).map(str::to_owned);
        let texts: Vec<String> = above.map(|(_, cells)| joined(cells)).chain(name).collect();
        let warm = warmth::mentioned(&texts.join("; "))?;
        let said = texts.iter().find(|text| warmth::mentioned(text) == Some(warm));
        Some(Claim::warm(said.map_or(texts.first()?, |said| said), warm))
    }

    /// The columns of an unknown name with other sizes near the measured ones: a second reading, another gauge, the largest and the smallest.
    pub(in crate::exchange) fn other_values(
        &self,
        names: &StringRecord,
        columns: &Columns,
        used: &[usize],
    ) -> Vec<String> {
        // The user has said which one is the measured value.
        if self.measured.is_some() {
            return Vec::new();
        }
        let is_free = |at: &usize| {
            let is_beside = columns.beside.iter().any(|column| column.at == *at);
            let has_quantity = columns.quantities.iter().any(|column| column.at == *at);
            let name = names.cell(*at);
            !used.contains(at) && !is_beside && !has_quantity && words::role(name).is_none() && !name.trim().is_empty()
        };
        let size = |cells: &StringRecord, at: usize| Length::parse_in(cells.get(at)?.trim(), Unit::Millimetre).ok();
        let is_other = |at: &usize| {
            let rows = self.rows.iter().skip(self.above);
            let pairs = rows.filter_map(|(_, cells)| Some((size(cells, columns.measured.at)?, size(cells, *at)?)));
            let mut all = 0;
            let mut near = 0;
            let mut differ = 0;
            for (measured, other) in pairs {
                let off = measured.saturating_sub(other).abs().nanometres();
                all += 1;
                // Half a percent: further than a tolerance reaches, and near enough to be no temperature of most rows.
                near += usize::from(off <= measured.nanometres() / 200);
                // A whole number is a nominal size.
                differ += usize::from(off != 0 && other.nanometres() % 1_000_000 != 0);
            }
            all < near * 2 && 0 < differ
        };
        let all = (0..columns.count).filter(is_free).filter(is_other);
        all.map(|at| name_of(at, names.cell(at))).collect()
    }

    /// A column with a cell that says that nobody measured, whatever it is called.
    pub(in crate::exchange) fn says_simulated(&self, columns: &Columns, used: &[usize]) -> Option<usize> {
        let is_free = |at: &usize| !used.contains(at) && columns.evidence.origin != Some(*at);
        (0..columns.count).filter(is_free).find(|at| self.cells(*at).any(says_simulated))
    }
}

impl Columns {
    /// The columns that are used for nothing and compared with nothing, and that of the names.
    pub(in crate::exchange) fn remarks_beside(&self, names: &StringRecord, used: &[usize]) -> Vec<RemarkColumn> {
        let is_compared = |at: &usize| self.beside.iter().any(|column| column.at() == *at);
        let is_free = |at: &usize| {
            let has_quantity = self.quantities.iter().any(|column| column.at == *at);
            let is_evidence = self.evidence.origin == Some(*at) || self.evidence.word == Some(*at);
            !used.contains(at) && !is_compared(at) && !has_quantity && !is_evidence
        };
        let name = |at: usize| names.cell(at).trim().to_owned();
        let names = self.id.filter(|at| self.header.is_some() && !is_compared(at));
        let free = (0..self.count).filter(is_free).map(|at| (at, false));
        let all = free.chain(names.map(|at| (at, true)));
        let unit = self.measured.unit;
        all.map(|(at, is_of_names)| RemarkColumn { at, name: name(at), is_of_names, unit }).collect()
    }
}
