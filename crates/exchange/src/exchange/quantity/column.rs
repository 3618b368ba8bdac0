//! The columns that say what was measured, and what a row says there.

use std::collections::BTreeMap;

use csv::StringRecord;

use super::Quantity;
use super::said::{Name, name, said};
use crate::exchange::cell::Cells as _;
use crate::exchange::cells;
use crate::exchange::column::name_of;
use crate::exchange::given::shorten;
use crate::exchange::sample::Sample;

/// How many words a message names.
const NAMED: usize = 3;

/// A column that says what was measured.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(in crate::exchange) struct QuantityColumn {
    pub(in crate::exchange) at: usize,
    /// Whether words that are not known are taken for a size.
    takes_unknown: bool,
    /// Whether letters such as `R` are quantities in it.
    reads_codes: bool,
    /// Its first words that are not known, and its name, where they are taken for a size.
    unknown: Option<(String, String)>,
    /// Its first cells that say a size, as they stand.
    sizes: Vec<String>,
}

impl QuantityColumn {
    /// What a row says was measured; `None` where its cell is empty, or says nothing and is taken for a size.
    pub(in crate::exchange) fn of(&self, cells: &StringRecord) -> Option<Quantity> {
        let text = cells.cell(self.at).trim();
        if text.is_empty() {
            return None;
        }
        let said = said(text).filter(|said| self.reads_codes || !said.is_code);
        said.map(|said| said.quantity).or_else(|| (!self.takes_unknown).then_some(Quantity::Other))
    }

    /// Whether a cell is one of those that say a size, byte by byte.
    pub(in crate::exchange) fn is_known_size(&self, cell: &[u8]) -> bool {
        cell.is_empty() || self.sizes.iter().any(|size| size.as_bytes() == cell)
    }

    /// The name of the column and its words that say nothing known and are taken for a size.
    pub(in crate::exchange) fn taken(&self) -> Option<&(String, String)> {
        self.unknown.as_ref()
    }
}

/// What a row says was measured, by all columns that do, with the text of the first that says it is no size.
pub(in crate::exchange) fn of_row<'c>(
    columns: &[QuantityColumn],
    cells: &'c StringRecord,
) -> Option<(usize, &'c str, Quantity)> {
    let all = columns.iter().filter_map(|column| {
        let quantity = column.of(cells)?;
        Some((column.at, cells.cell(column.at).trim(), quantity))
    });
    let rank = |quantity: &Quantity| match quantity {
        Quantity::Other | Quantity::Length => 0,
        Quantity::Coordinate(_) => 1,
        Quantity::Diameter | Quantity::Width => 2,
        Quantity::Size => 3,
    };
    all.min_by_key(|(_, _, quantity)| rank(quantity))
}

/// What the first cells of a column hold.
#[derive(Default)]
struct ColumnSample<'s> {
    filled: usize,
    numbers: usize,
    /// Cells with a word that is known, and those with nothing else.
    known: usize,
    plain: usize,
    shapes: usize,
    codes: usize,
    has_diameter: bool,
    has_other: bool,
    sizes: Vec<&'s str>,
    unknown: Vec<&'s str>,
}

impl<'s> ColumnSample<'s> {
    fn of(cells: impl Iterator<Item = &'s str>, reads_codes: bool) -> Self {
        let mut seen = Self::default();
        for cell in cells {
            seen.filled += 1;
            seen.numbers += usize::from(cells::is_number(cell));
            let Some(said) = said(cell).filter(|said| reads_codes || !said.is_code) else {
                if !seen.unknown.contains(&cell) {
                    seen.unknown.push(cell);
                }
                continue;
            };
            seen.known += 1;
            seen.plain += usize::from(said.is_plain);
            seen.shapes += usize::from(said.is_shape);
            seen.codes += usize::from(said.is_code);
            seen.has_diameter |= said.quantity == Quantity::Diameter;
            seen.has_other |= !said.quantity.is_size();
            if said.quantity.is_size() && !seen.sizes.contains(&cell) {
                seen.sizes.push(cell);
            }
        }
        seen
    }

    /// Whether the cells can hardly be anything else than quantities, whatever their column is called: words, or letters of which some
    /// are a diameter and others are none. One letter alone may be a tick, and `L` and `R` are left and right.
    fn are_quantities(&self) -> bool {
        self.filled < self.plain * 2 || self.known == self.filled && self.has_diameter && self.has_other
    }

    /// Whether the letters of a column that may say a quantity say one.
    const fn tells_codes(&self) -> bool {
        self.codes < self.known || self.has_diameter || self.unknown.is_empty()
    }

    /// Whether a column of a name that says a quantity holds nothing else.
    fn all_known(&self, name: Name) -> bool {
        name != Name::None && 0 < self.filled && self.known == self.filled
    }
}

/// A column that may say what was measured, before its cells are looked at.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(in crate::exchange) enum Free {
    /// Nothing else is known of it.
    Yes,
    /// Its name says that it names features, and another column does so as well.
    NamesToo,
    /// It is used otherwise.
    No,
}

impl Sample {
    /// The columns that say what was measured, of those that are free to; `names` is the column of the features' names.
    pub(in crate::exchange) fn quantities(
        &self,
        header: &StringRecord,
        names: Option<usize>,
        free: impl Fn(usize) -> Free,
    ) -> Vec<QuantityColumn> {
        let width = self.rows.iter().map(|(_, cells)| cells.len()).fold(0, usize::max);
        let all = (0..width).filter_map(|at| {
            let free = free(at);
            if free == Free::No {
                return None;
            }
            let name = name(header.cell(at));
            let (column, seen) = self.look(header, at, name, names)?;
            let is_read = match name {
                _ if free == Free::NamesToo => seen.shapes == 0 && (seen.are_quantities() || seen.all_known(name)),
                // What is empty in the first rows may say it further down.
                Name::Strong | Name::Weak => true,
                Name::None => seen.shapes == 0 && seen.are_quantities(),
            };
            is_read.then_some(column)
        });
        all.collect()
    }

    /// The column that the user says has them.
    pub(in crate::exchange) fn quantity(
        &self,
        header: &StringRecord,
        at: usize,
        names: Option<usize>,
    ) -> Option<QuantityColumn> {
        self.look(header, at, Name::Strong, names).map(|(column, _)| column)
    }

    /// What a column would say; `None` where it holds numbers.
    fn look(
        &self,
        header: &StringRecord,
        at: usize,
        name: Name,
        names: Option<usize>,
    ) -> Option<(QuantityColumn, ColumnSample<'_>)> {
        let with_codes = ColumnSample::of(self.cells(at), true);
        if 0 < with_codes.numbers && with_codes.filled <= with_codes.numbers * 2 {
            return None;
        }
        // "A" and "B" are variants of a part, unless something else is said, too.
        let reads_codes = name != Name::Weak || with_codes.tells_codes();
        let seen = if reads_codes { with_codes } else { ColumnSample::of(self.cells(at), false) };
        let takes_unknown = seen.known == 0
            && match name {
                // One word for all rows tells nothing apart.
                Name::Strong => seen.unknown.len() == 1,
                Name::Weak => !names.is_some_and(|names| self.tells_apart(at, names)),
                Name::None => false,
            };
        let is_taken = takes_unknown && !seen.unknown.is_empty();
        let words = || seen.unknown.iter().take(NAMED).map(|word| shorten(word)).collect::<Vec<_>>().join(", ");
        let column = QuantityColumn {
            at,
            takes_unknown,
            reads_codes,
            unknown: is_taken.then(|| (name_of(at, header.cell(at)), words())),
            sizes: seen.sizes.iter().map(|size| (*size).to_owned()).collect(),
        };
        Some((column, seen))
    }

    /// Whether rows of one name have different words in a column: then these say different things of one feature.
    fn tells_apart(&self, at: usize, names: usize) -> bool {
        let mut words: BTreeMap<&str, &str> = BTreeMap::new();
        let rows = self.rows.iter().skip(self.above).filter_map(|(_, cells)| Some((cells.get(names)?, cells.get(at)?)));
        rows.map(|(name, word)| (name.trim(), word.trim()))
            .filter(|(name, word)| !name.is_empty() && !word.is_empty())
            .any(|(name, word)| words.insert(name, word).is_some_and(|other| other != word))
    }
}
