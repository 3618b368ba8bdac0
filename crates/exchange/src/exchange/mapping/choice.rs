//! What is chosen for each column of a file, as a mapping that leaves nothing open.

use super::detected::{Detected, column_of};
use super::words::{DECIMALS, SEPARATORS, UNITS};
use super::{Column, Mapping};
use crate::exchange::role::Role;

pub const SEPARATOR_WORDS: [&str; 4] = [SEPARATORS[0].0, SEPARATORS[1].0, SEPARATORS[2].0, SEPARATORS[3].0];

/// The words of the decimal signs.
pub const DECIMAL_WORDS: [&str; 2] = [DECIMALS[0].0, DECIMALS[1].0];

pub const UNIT_WORDS: [&str; 3] = [UNITS[0].0, UNITS[1].0, UNITS[2].0];

/// What is chosen for a file. What each of its columns holds is said; a sign or unit that is not chosen is that of the file.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Choice {
    /// The sheet of a workbook.
    pub sheet: Option<String>,
    /// The word of the separator; `None` where cells need none.
    pub separator: Option<String>,
    /// The word of the decimal sign.
    pub decimal: Option<String>,
    /// The word of the unit of measured values and nominal sizes.
    pub unit: Option<String>,
    /// The word of the unit of X, Y and Z.
    pub place_unit: Option<String>,
    /// The line of the first row.
    pub first_row: Option<usize>,
    /// What each column holds.
    pub roles: Vec<Option<Role>>,
}

impl Choice {
    /// What is detected in a file, to be corrected.
    pub fn of(detected: &Detected) -> Self {
        let Mapping { sheet, separator, .. } = detected.mapping.clone();
        Self { sheet, separator, roles: detected.roles.clone(), ..Self::default() }
    }

    /// A column holds something from now on, and no other column the same, or one more where two may have it.
    pub fn give(&mut self, at: usize, role: Option<Role>) {
        if self.roles.len() <= at {
            self.roles.resize(at + 1, None);
        }
        let most = if role.is_some_and(Role::may_be_two) { 2 } else { 1 };
        let others: Vec<usize> =
            (0..self.roles.len()).filter(|other| *other != at && self.roles.get(*other) == Some(&role)).collect();
        for other in others.into_iter().skip(most - 1).filter(|_| role.is_some()) {
            if let Some(other) = self.roles.get_mut(other) {
                *other = None;
            }
        }
        if let Some(column) = self.roles.get_mut(at) {
            *column = role;
        }
    }

    /// All of it as a mapping, for a header of these names.
    pub fn mapping(&self, names: &[String]) -> Mapping {
        let columns = Role::all().map(|role| {
            let of_it = (0..).zip(&self.roles).filter(|(_, of)| **of == Some(role));
            let mut columns: Vec<Column> = of_it.map(|(at, _)| column_of(at, names)).collect();
            let column = match (role, columns.len()) {
                (_, 0) => Column::none(),
                (role, _) if role.may_be_two() => Column::Several(columns),
                _ => columns.swap_remove(0),
            };
            (role.word().to_owned(), column)
        });
        Mapping {
            sheet: self.sheet.clone(),
            separator: self.separator.clone(),
            decimal: self.decimal.clone(),
            unit: self.unit.clone(),
            place_unit: self.place_unit.clone(),
            first_row: self.first_row,
            columns: columns.collect(),
        }
    }
}
