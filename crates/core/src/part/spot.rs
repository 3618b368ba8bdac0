//! Where in a plan something is wrong.

use super::column::{Column, HeadField};
use super::draft::Draft;
use super::fault::{PlanError, PlanFault};
use crate::message::{FilePlace, Located};

/// What a fault is about.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Spot {
    /// The plan as a whole.
    Plan,
    /// A field of the part.
    Head(HeadField),
    /// A feature, by its position in the plan from 0, and the cell where it is one.
    Feature(usize, Option<Column>),
}

/// A fault of a draft.
#[derive(Debug, Clone, PartialEq)]
pub struct Finding {
    /// Where in the plan.
    pub spot: Spot,
    /// What is wrong.
    pub what: PlanFault,
}

impl Finding {
    /// The same with its place in the draft's file.
    pub fn located(self, draft: &Draft) -> PlanError {
        let place = match self.spot {
            Spot::Plan => FilePlace::default(),
            Spot::Head(field) => draft.cell(field).place.clone(),
            Spot::Feature(at, column) => draft.rows.get(at).map_or_else(FilePlace::default, |row| {
                let cell = column.map(|column| row.cell(column).place.clone());
                cell.filter(|place| place.line.is_some()).unwrap_or_else(|| row.place.clone())
            }),
        };
        Located { what: self.what, place }
    }
}
