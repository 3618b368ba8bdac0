//! Which column is which, by the names of the first line.

/// How many columns a message names.
const NAMED: usize = 8;

/// A column that is used.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Column {
    /// `planid`: the measuring plan.
    Plan,
    /// `partnb`: the number of the part that was measured.
    Part,
    /// `id`: the name of the characteristic.
    Id,
    /// `type` and `idsymbol`: what is measured, in short and as a word.
    Type,
    Symbol,
    Actual,
    Nominal,
    /// Deviations from the nominal value.
    Upper,
    Lower,
    Deviation,
    /// How far beyond the tolerance.
    Exceed,
    X,
    Y,
    Z,
    Unit,
}

/// Their names in small letters.
const NAMES: [(&str, Column); 15] = [
    ("planid", Column::Plan),
    ("partnb", Column::Part),
    ("id", Column::Id),
    ("type", Column::Type),
    ("idsymbol", Column::Symbol),
    ("actual", Column::Actual),
    ("nominal", Column::Nominal),
    ("uppertol", Column::Upper),
    ("lowertol", Column::Lower),
    ("deviation", Column::Deviation),
    ("exceed", Column::Exceed),
    ("featureposx", Column::X),
    ("featureposy", Column::Y),
    ("featureposz", Column::Z),
    ("unit", Column::Unit),
];

/// Those without which a file is no such table.
const NEEDED: [Column; 5] = [Column::Id, Column::Actual, Column::Nominal, Column::Upper, Column::Lower];

/// The columns of a table.
#[derive(Debug, Clone)]
pub(super) struct Columns {
    /// Where each is, with its name as it stands.
    found: Vec<(Column, usize, String)>,
    /// How many there are.
    pub(super) count: usize,
    /// The names of the others.
    skipped: Vec<String>,
}

impl Columns {
    /// Those of a header; `None` where it is none.
    pub(super) fn of(header: &str) -> Option<Self> {
        let mut columns = Self { found: Vec::new(), count: 0, skipped: Vec::new() };
        // The header has a tab at its end.
        for (at, name) in header.trim_end().split('\t').map(str::trim).enumerate() {
            columns.count = at + 1;
            let small = name.to_ascii_lowercase();
            match NAMES.iter().find(|(known, _)| *known == small) {
                // A name that stands twice is not known to be either.
                Some((_, column)) if columns.at(*column).is_some() => return None,
                Some((_, column)) => columns.found.push((*column, at, name.to_owned())),
                None => columns.skipped.push(crate::exchange::given::shorten(name)),
            }
        }
        NEEDED.iter().all(|&needed| columns.at(needed).is_some()).then_some(columns)
    }

    fn at(&self, wanted: Column) -> Option<usize> {
        self.found.iter().find(|(column, _, _)| *column == wanted).map(|(_, at, _)| *at)
    }

    /// The text of a cell; empty where the row is shorter, or the table has no such column.
    pub(super) fn text<'t>(&self, cells: &[&'t str], column: Column) -> &'t str {
        self.at(column).and_then(|at| cells.get(at)).map_or("", |text| text.trim())
    }

    /// The number of a column from 1, and its name.
    pub(super) fn named(&self, wanted: Column) -> (Option<usize>, String) {
        let found = self.found.iter().find(|(column, _, _)| *column == wanted);
        found.map_or((None, String::new()), |(_, at, name)| (Some(at + 1), name.clone()))
    }

    /// The names of the columns that are not used; empty where all are.
    pub(super) fn skipped(&self) -> String {
        let more = if NAMED < self.skipped.len() { ", …" } else { "" };
        let named: Vec<&str> = self.skipped.iter().take(NAMED).map(String::as_str).collect();
        format!("{}{more}", named.join(", "))
    }
}
