//! What is chosen for each column of a file, as a mapping that leaves nothing open.

use std::collections::BTreeMap;

use super::detected::{Detected, column_of};
use super::{Column, ColumnUnit, DecimalSign, Mapping, Separator};
use crate::exchange::role::Role;

/// What is chosen for a file. What each of its columns holds is said; a sign or unit that is not chosen is that of the file.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Choice {
    /// The sheet of a workbook.
    pub sheet: Option<String>,
    /// What separates cells; `None` where they need nothing.
    pub separator: Option<Separator>,
    pub decimal: Option<DecimalSign>,
    /// The unit of measured values and nominal sizes.
    pub unit: Option<ColumnUnit>,
    /// The unit of X, Y and Z.
    pub place_unit: Option<ColumnUnit>,
    /// The line of the first row.
    pub first_row: Option<usize>,
    /// What each column holds.
    pub roles: Vec<Option<Role>>,
}

impl Choice {
    /// What is detected in a file, to be corrected.
    pub fn of(detected: &Detected) -> Self {
        let Mapping { sheet, separator, .. } = &detected.mapping;
        Self { sheet: sheet.clone(), separator: *separator, roles: detected.roles.clone(), ..Self::default() }
    }

    /// A column holds something from now on, and no other column the same, or one more where two may have it.
    pub fn give(&mut self, at: usize, role: Option<Role>) {
        if self.roles.len() <= at {
            self.roles.resize(at + 1, None);
        }
        let most = role.map_or(1, Role::most);
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
                (role, _) if 1 < role.most() => Column::Several(columns),
                _ => columns.swap_remove(0),
            };
            (role.word().to_owned(), column)
        });
        Mapping {
            sheet: self.sheet.clone(),
            separator: self.separator,
            decimal: self.decimal,
            unit: self.unit,
            place_unit: self.place_unit,
            first_row: self.first_row,
            columns: columns.collect(),
            names: BTreeMap::new(),
        }
    }
}
