//! A table of deviations as a control's table, ready to be written.

use fitcheck_core::length::{Length, Unit};
use fitcheck_core::tolerance::DeviationTable;

use super::{RANGE, ROW_NUMBER};
use crate::control::table::{Column, ControlTable, Generation};

/// A table of deviations in the control's layout: explicit signs, decimal point, range end only in the upper row.
///
/// [`Generation::Structure`] also gets the texts that the control shows when an operator edits a cell.
pub fn to_control_table(table: &DeviationTable, generation: Generation) -> ControlTable {
    let (name, suffix) = table.name().rsplit_once('.').unwrap_or((table.name(), "tab"));
    // Six characters and a blank: 24 classes, NR and BEREICH take 184 of the 200 characters of an iTNC 530.
    let plain = |name: &str, width: usize| Column::plain(name, width.max(name.len() + 1));
    let mut columns = vec![plain(ROW_NUMBER, 8), plain(RANGE, 8)];
    columns.extend(table.columns().iter().map(|column| plain(column.class.as_str(), 7)));
    let mut rows = Vec::with_capacity(table.ends().len() * 2);
    for (number, &end) in table.ends().iter().enumerate() {
        for (half, range) in [(0, end.to_string()), (1, String::new())] {
            let mut row = vec![(number * 2 + half).to_string(), range];
            row.extend(table.columns().iter().map(|column| {
                let cell = column.cells.get(number).copied().flatten();
                let value = cell.map(|pair| if half == 0 { pair.upper() } else { pair.lower() });
                value.map_or_else(String::new, signed_micrometres)
            }));
            rows.push(row);
        }
    }
    for (number, column) in columns.iter_mut().enumerate() {
        let widths = rows.iter().filter_map(|row| row.get(number)).map(|cell| cell.len() + 1);
        column.width = widths.fold(column.width, usize::max);
    }
    let name = name.to_owned();
    let suffix = Some(suffix.to_owned());
    let plain = ControlTable { name, suffix, columns, rows, ..ControlTable::default() };
    with_dialogues(plain.to_generation(generation))
}

/// `+12`, `-7.5`, `+0`: as a control writes numbers.
fn signed_micrometres(value: Length) -> String {
    let sign = if value < Length::ZERO { "" } else { "+" };
    format!("{sign}{}", value.exact(Unit::Micrometre, 0))
}

/// What the control asks when an operator edits a cell, in the languages that its block may hold.
fn with_dialogues(mut table: ControlTable) -> ControlTable {
    if table.generation != Generation::Structure {
        return table;
    }
    for column in table.columns.iter_mut().filter(|column| column.kind.is_some()) {
        let texts = if column.name == RANGE {
            ["Size range up to, mm?", "Nennmassbereich bis, mm?", "Maatbereik tot en met, mm?"].map(str::to_owned)
        } else {
            // Leaves room for half micrometres even if no cell has one yet.
            column.decimals = column.decimals.map(|decimals| decimals.max(1));
            let name = &column.name;
            [format!("Deviation {name}, um?"), format!("Abmass {name}, um?"), format!("Afwijking {name}, um?")]
        };
        let keys = ["DIA-ENGLISH", "DIA-GERMAN", "DIA-DUTCH"].map(str::to_owned);
        column.settings = keys.into_iter().zip(texts).collect();
    }
    table
}
