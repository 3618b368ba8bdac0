//! What a row says of its value beside it.

use csv::StringRecord;
use fitcheck_core::tolerance::Feature;

use super::BesideColumn;
use crate::exchange::cell::Cells as _;
use crate::exchange::claim::Claim;
use crate::exchange::columns::Columns;
use crate::exchange::remarks::{Heard, may_say};

impl Columns {
    /// What the cells of a row say of its value beside it.
    pub(in crate::exchange) fn claims(&self, cells: &StringRecord, heard: &mut Heard) -> Vec<Claim> {
        let mut claims = self.claims_of(cells, |_| true);
        for column in &self.remarks {
            let cell = cells.cell(column.at);
            if may_say(cell.as_bytes()) && !heard.says_nothing(column, cell) {
                claims.extend(column.claim(cell, self.asks_temperature(cells)));
            }
        }
        claims
    }

    /// Whether what a row says of a temperature counts: its value was not brought to 20 °C already.
    pub(in crate::exchange) fn asks_temperature(&self, cells: &StringRecord) -> bool {
        !self.own.are_corrected() && !self.evidence.is_corrected(cells)
    }

    /// The columns that tell holes and shafts apart.
    pub(in crate::exchange) fn sides(&self) -> Vec<&BesideColumn> {
        self.beside.iter().filter(|column| column.tells_sides()).collect()
    }

    /// Whether a row says that it is of a hole or of a shaft; `None` where nothing says it, or two cells contradict each other.
    pub(in crate::exchange) fn feature_of(&self, cells: &StringRecord) -> Option<Feature> {
        let mut said = self.beside.iter().filter_map(|column| column.feature(cells.get(column.at)?));
        let first = said.next()?;
        said.all(|other| other == first).then_some(first)
    }

    /// Those of them that are numbers.
    pub(in crate::exchange) fn figures(&self, cells: &StringRecord) -> Vec<Claim> {
        self.claims_of(cells, |column| !column.has_words())
    }

    fn claims_of(&self, cells: &StringRecord, is_asked: impl Fn(&BesideColumn) -> bool) -> Vec<Claim> {
        let of_row = self.stated.in_row(self.measured, cells);
        let unit = of_row.map_or(self.measured.unit, |column| column.unit);
        let is_corrected = self.evidence.is_corrected(cells);
        let counts = |column: &&BesideColumn| !is_corrected || !column.says.is_of_temperature();
        let asked = self.beside.iter().filter(|column| is_asked(column)).filter(counts);
        let of_all = self.evidence.warm.iter().filter(|_| !is_corrected).cloned();
        asked.filter_map(|column| column.claim(cells.get(column.at)?, unit)).chain(of_all).collect()
    }
}
