//! A table of deviations against ISO 286, cell by cell.
//!
//! A table's range may cover several steps of the standard; it is compared on each of them, so that a range over 50 up
//! to 80 mm is found wrong for r6, whose deviations change at 65 mm.

use super::class::ToleranceClass;
use super::iso286::{self, Undefined};
use super::limits::Deviations;
use super::table::DeviationTable;
use crate::length::Length;

/// What a comparison found.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Comparison {
    /// Where the table differs, column by column and in each by ascending sizes.
    pub differences: Vec<Difference>,
    /// How many cells were compared.
    pub compared: usize,
    /// Columns that are no class of ISO 286: the user's own.
    pub unknown: Vec<ToleranceClass>,
}

/// Sizes for which a cell differs.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Difference {
    /// The class.
    pub class: ToleranceClass,
    /// The number of the table's size range, from 0.
    pub range: usize,
    /// The sizes for which the cell differs, which may be a part of its range: above this,
    pub over: Length,
    /// up to and including this.
    pub to: Length,
    /// What the table says; `None` for an empty cell.
    pub table: Option<Deviations>,
    /// What ISO 286 says, or why it does not define the class here.
    pub standard: Result<Deviations, Undefined>,
}

impl Comparison {
    /// The cells that differ, each by its class and the number of its range: a range that covers several steps of the
    /// standard may have several differences.
    pub fn cells(&self) -> Vec<(ToleranceClass, usize)> {
        let mut cells: Vec<_> = self.differences.iter().map(|found| (found.class, found.range)).collect();
        cells.dedup();
        cells
    }
}

impl Difference {
    /// How far the table's upper deviation lies above the standard's, where both have one.
    pub fn upper_by(&self) -> Option<Length> {
        Some(self.table?.minus(self.standard.as_ref().ok()?).0)
    }

    /// How far the table's lower deviation lies above the standard's, where both have one.
    pub fn lower_by(&self) -> Option<Length> {
        Some(self.table?.minus(self.standard.as_ref().ok()?).1)
    }
}

/// Compares every cell of a table with the standard.
pub fn compare(table: &DeviationTable, options: iso286::Options) -> Comparison {
    let mut found = Comparison::default();
    for column in table.columns() {
        if iso286::parts(column.class).is_none() {
            found.unknown.push(column.class);
            continue;
        }
        let mut over = Length::ZERO;
        for (range, (&to, &cell)) in table.ends().iter().zip(&column.cells).enumerate() {
            found.compared += 1;
            found.differences.extend(differences(column.class, range, (over, to), cell, options));
            over = to;
        }
    }
    found
}

/// What differs in one cell: neighbouring steps with the same difference are one.
fn differences(
    class: ToleranceClass,
    range: usize,
    (over, to): (Length, Length),
    table: Option<Deviations>,
    options: iso286::Options,
) -> Vec<Difference> {
    let mut found: Vec<Difference> = Vec::new();
    let mut over = over;
    let steps = iso286::step_ends().filter(|end| over < *end && *end < to).collect::<Vec<_>>();
    for end in steps.into_iter().chain([to]) {
        // Within a step no class changes, so its end speaks for all of it.
        let standard = iso286::deviations(class, end, options).map(|cell| cell.deviations);
        if standard.as_ref().ok() != table.as_ref() {
            match found.last_mut() {
                Some(last) if last.to == over && last.standard.as_ref().ok() == standard.as_ref().ok() => last.to = end,
                _ => found.push(Difference { class, range, over, to: end, table, standard }),
            }
        }
        over = end;
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tolerance::table::Column;

    fn pair(upper: i32, lower: i32) -> Option<Deviations> {
        Deviations::new(Length::from_micrometres(upper), Length::from_micrometres(lower)).ok()
    }

    fn table(ends: &[&str], columns: &[(&str, &[Option<Deviations>])]) -> DeviationTable {
        let columns =
            columns.iter().map(|(class, cells)| Column { class: class.parse().unwrap(), cells: cells.to_vec() });
        let ends = ends.iter().map(|end| end.parse().unwrap()).collect();
        DeviationTable::new("own.tab", false, ends, columns.collect()).unwrap()
    }

    #[track_caller]
    fn check(table: &DeviationTable, expected: &[&str]) {
        let said = |pair: Option<&Deviations>| pair.map_or("-".into(), |p| format!("{}/{}", p.upper(), p.lower()));
        let found: Vec<String> = compare(table, iso286::Options::default())
            .differences
            .iter()
            .map(|d| {
                let (is, should) = (said(d.table.as_ref()), said(d.standard.as_ref().ok()));
                format!("{} range {} over {} to {}: {is} not {should}", d.class, d.range, d.over, d.to)
            })
            .collect();
        assert_eq!(found, expected);
    }

    #[test]
    fn cells_that_agree_are_counted_and_own_columns_are_named() {
        let table = table(&["3", "6"], &[("H7", &[pair(10, 0), pair(12, 0)]), ("OWN1", &[pair(1, 0), None])]);
        let found = compare(&table, iso286::Options::default());
        assert_eq!((found.compared, found.differences.len()), (2, 0));
        assert_eq!(found.unknown, ["OWN1".parse().unwrap()]);
    }

    #[test]
    fn every_kind_of_difference_is_found() {
        check(
            &table(&["3", "6"], &[("H7", &[pair(11, 0), pair(12, -1)]), ("N9", &[pair(-4, -29), None])]),
            &[
                "H7 range 0 over 0 to 3: 0.011/0 not 0.01/0",
                "H7 range 1 over 3 to 6: 0.012/-0.001 not 0.012/0",
                // Up to 1 mm the standard refuses N9; above it the cell is right.
                "N9 range 0 over 0 to 1: -0.004/-0.029 not -",
                "N9 range 1 over 3 to 6: - not 0/-0.03",
            ],
        );
    }

    #[test]
    fn a_range_over_several_steps_is_wrong_in_some_of_them() {
        check(
            &table(&["50", "80"], &[("r6", &[None, pair(60, 41)])]),
            &[
                "r6 range 0 over 0 to 3: - not 0.016/0.01",
                "r6 range 0 over 3 to 6: - not 0.023/0.015",
                "r6 range 0 over 6 to 10: - not 0.028/0.019",
                "r6 range 0 over 10 to 18: - not 0.034/0.023",
                "r6 range 0 over 18 to 30: - not 0.041/0.028",
                "r6 range 0 over 30 to 50: - not 0.05/0.034",
                "r6 range 1 over 65 to 80: 0.06/0.041 not 0.062/0.043",
            ],
        );
    }

    #[test]
    fn a_table_that_goes_on_beyond_the_standard_differs_there() {
        let own = table(&["3150", "4000"], &[("H7", &[None, pair(210, 0)])]);
        let found = compare(&own, iso286::Options::default()).differences;
        let last = found.last().unwrap();
        assert_eq!((last.over.to_string(), last.to.to_string()), ("3150".into(), "4000".into()));
        let why = "nominal size 4000 mm is beyond ISO 286, which ends at 3150 mm";
        assert_eq!(last.standard.as_ref().unwrap_err().to_string(), why);
        assert_eq!((last.upper_by(), last.lower_by()), (None, None));
    }

    #[test]
    fn by_how_much_is_told_with_its_sign() {
        let own = table(&["3"], &[("h7", &[pair(1, -12)])]);
        let found = compare(&own, iso286::Options::default()).differences;
        let by = (found[0].upper_by(), found[0].lower_by());
        assert_eq!(by, (Some(Length::from_micrometres(1)), Some(Length::from_micrometres(-2))));
    }
}
