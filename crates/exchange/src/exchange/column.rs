//! One column: where it is, its name, and the unit that the name says.

use csv::StringRecord;
use fitcheck_core::length::Unit;

use super::error::ImportErrorKind;
use super::given::shorten;
use super::role::Role;
use super::units;
use crate::exchange::cell::{Cells as _, single_blanks};

/// How many columns a message names at most.
pub(super) const NAMED: usize = 8;

#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(super) struct LengthColumn {
    pub(super) at: usize,
    pub(super) unit: Unit,
}

/// That several columns could have a role.
pub(super) fn several(role: Role, header: &StringRecord, columns: &[usize]) -> ImportErrorKind {
    let mut columns = columns.to_vec();
    columns.sort_unstable();
    let columns = columns.iter().take(NAMED + 1);
    let names: Vec<String> = columns.map(|&at| name_of(at, header.cell(at))).collect();
    ImportErrorKind::SeveralColumns { role, columns: listed(&names) }
}

/// The first names of columns as one text, with an ellipsis where there are more.
pub(super) fn listed(names: &[String]) -> String {
    let mut list = names.get(..NAMED).unwrap_or(names).join(", ");
    if NAMED < names.len() {
        list.push_str(", …");
    }
    list
}

/// The unit that a column's name says; millimetres where it says none.
pub(super) fn unit_of(name: &str) -> Result<Unit, ImportErrorKind> {
    let unit = units::unit(name).map_err(|unit| ImportErrorKind::Unit { unit: shorten(&unit) })?;
    Ok(unit.unwrap_or(Unit::Millimetre))
}

/// The number of a column, and its name where it has one.
pub(super) fn name_of(at: usize, name: &str) -> String {
    let name = single_blanks(name);
    if name.is_empty() { (at + 1).to_string() } else { format!("{} ({})", at + 1, shorten(&name)) }
}
