//! The plan as a table.
//!
//! | file | what |
//! |---|---|
//! | `form` | above the table: what the plan says of the part |
//! | `tools` | what can be done with rows and columns |
//! | `grid`, `paint` | the cells in sight, and how they look |
//! | `editor` | the cell that is typed into |
//! | `faults` | below it: everything that is wrong |

pub(super) mod editor;
pub(super) mod faults;
pub(super) mod form;
pub(super) mod grid;
mod paint;
pub(super) mod tools;

use crate::gui::key_names::part_id;
use crate::part::{Column, HeadField};
use crate::session::focused::PLAN;
use eframe::egui::Id;

/// The id of a column's name.
pub(super) fn column_id(column: Column) -> String {
    format!("parts-page-column-{}", column.key().replace('_', "-"))
}

/// The id of the name of a field of the part.
pub(super) fn head_id(field: HeadField) -> String {
    format!("parts-page-head-{}", field.key().replace('_', "-"))
}

/// The id of the table: it takes the focus as a whole.
pub(in crate::gui) fn grid_id() -> Id {
    part_id(PLAN)
}
