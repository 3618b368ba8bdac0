//! A header among the rows of a file, as where two exports were put together: below it the columns may be others.

use csv::StringRecord;
use fitcheck_core::length::Unit;

use super::cells::is_number;
use super::columns::Columns;
use super::role::Role;
use super::vocabulary::Rank;
use super::{units, words};

impl Columns {
    /// Whether a row that is no measurement names other columns than those of the file.
    pub(super) fn are_renamed_by(&self, cells: &StringRecord) -> bool {
        let role = |at: usize| cells.get(at).and_then(words::role).filter(|(_, rank)| *rank != Rank::Unsure);
        let roles: Vec<_> = (0..cells.len()).map(role).collect();
        let has_measured = roles.iter().flatten().any(|(role, _)| *role == Role::Measured);
        if !self.names_known || !has_measured || roles.iter().flatten().count() < 2 || cells.iter().any(is_number) {
            return false;
        }
        let is_of = |at: usize, wanted: Role| roles.get(at).copied().flatten().is_some_and(|(role, _)| role == wanted);
        let unit = |at: usize| cells.get(at).and_then(|name| units::unit(name).ok()).flatten();
        let is_in = |at: usize, own: Unit| unit(at).is_none_or(|unit| unit == own);
        let measured = &self.measured;
        let same = is_of(measured.at, Role::Measured)
            && is_in(measured.at, measured.unit)
            && self.tolerance.is_none_or(|at| is_of(at, Role::Tolerance))
            && self.nominal.as_ref().is_none_or(|own| is_in(own.at, own.unit) && !is_of(own.at, Role::Measured));
        !same
    }
}
