//! A plan as it is written: texts in cells, right or wrong. Every file of a plan is read into one, the window edits one, and
//! [`super::Plan`] is what a draft without a fault says.

use std::sync::Arc;

use super::column::{Column, HeadField};
use crate::message::FilePlace;

/// A text and where it stands in its file.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct DraftCell {
    /// The text; empty where nothing is given.
    pub text: String,
    /// Line and column of its file, where it is from one.
    pub place: FilePlace,
}

impl DraftCell {
    /// A text of a file.
    pub const fn at(text: String, place: FilePlace) -> Self {
        Self { text, place }
    }
}

/// A feature as it is written.
///
/// Its cells are shared until they are changed: every change that can be taken back keeps a whole draft.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct DraftFeature {
    cells: Arc<[DraftCell; Column::ALL.len()]>,
    /// Where it begins in its file, where it is from one.
    pub place: FilePlace,
}

impl Default for DraftFeature {
    fn default() -> Self {
        Self { cells: Arc::new(std::array::from_fn(|_| DraftCell::default())), place: FilePlace::default() }
    }
}

impl DraftFeature {
    /// An empty row that begins at a place of a file.
    pub fn at(place: FilePlace) -> Self {
        Self { place, ..Self::default() }
    }

    /// A row of texts.
    pub fn of(texts: impl IntoIterator<Item = (Column, String)>) -> Self {
        let mut row = Self::default();
        for (column, text) in texts {
            row.set(column, text);
        }
        row
    }

    /// A cell.
    pub fn cell(&self, column: Column) -> &DraftCell {
        static EMPTY: DraftCell =
            DraftCell { text: String::new(), place: FilePlace { file: None, line: None, column: None } };
        self.cells.get(column.at()).unwrap_or(&EMPTY)
    }

    /// The text of a cell without blanks around it; `None` where it is empty.
    pub fn text(&self, column: Column) -> Option<&str> {
        Some(self.said(column)).filter(|text| !text.is_empty())
    }

    /// The same where nothing given is an empty text.
    pub fn said(&self, column: Column) -> &str {
        self.cell(column).text.trim()
    }

    /// Writes a text that is from no file.
    pub fn set(&mut self, column: Column, text: String) {
        self.put(column, DraftCell { text, place: FilePlace::default() });
    }

    /// Writes a cell.
    pub fn put(&mut self, column: Column, cell: DraftCell) {
        if let Some(old) = Arc::make_mut(&mut self.cells).get_mut(column.at()) {
            *old = cell;
        }
    }

    /// Whether nothing is written.
    pub fn is_empty(&self) -> bool {
        self.cells.iter().all(|cell| cell.text.trim().is_empty())
    }
}

/// A plan as it is written.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Draft {
    head: [DraftCell; HeadField::ALL.len()],
    /// The features.
    pub rows: Vec<DraftFeature>,
}

impl Draft {
    /// A plan of features that says nothing of the part.
    pub fn of(rows: Vec<DraftFeature>) -> Self {
        Self { rows, ..Self::default() }
    }

    /// A field of the part.
    pub fn cell(&self, field: HeadField) -> &DraftCell {
        static EMPTY: DraftCell =
            DraftCell { text: String::new(), place: FilePlace { file: None, line: None, column: None } };
        self.head.get(field.at()).unwrap_or(&EMPTY)
    }

    /// The text of a field without blanks around it; `None` where it is empty.
    pub fn text(&self, field: HeadField) -> Option<&str> {
        Some(self.cell(field).text.trim()).filter(|text| !text.is_empty())
    }

    /// Writes a text that is from no file.
    pub fn set(&mut self, field: HeadField, text: String) {
        self.put(field, DraftCell { text, place: FilePlace::default() });
    }

    /// Writes a field.
    pub fn put(&mut self, field: HeadField, cell: DraftCell) {
        if let Some(old) = self.head.get_mut(field.at()) {
            *old = cell;
        }
    }

    /// Whether another draft has the same texts, wherever they are from.
    pub fn says_the_same(&self, other: &Self) -> bool {
        let same =
            |one: &[DraftCell], other: &[DraftCell]| one.iter().zip(other).all(|(one, other)| one.text == other.text);
        let rows = || self.rows.iter().zip(&other.rows);
        same(&self.head, &other.head)
            && self.rows.len() == other.rows.len()
            && rows().all(|(one, other)| Arc::ptr_eq(&one.cells, &other.cells) || same(&*one.cells, &*other.cells))
    }

    /// Numbers the features from 1 in their order.
    pub fn renumber(&mut self) {
        for (number, row) in (1..).zip(&mut self.rows) {
            let number: usize = number;
            row.set(Column::Number, number.to_string());
        }
    }

    /// The same with what is said of all features in each that says nothing itself.
    #[must_use]
    pub fn spread(&self) -> Self {
        let mut draft = self.clone();
        for field in HeadField::ALL {
            let (Some(column), Some(text)) = (field.column(), self.text(field)) else { continue };
            for row in draft.rows.iter_mut().filter(|row| row.text(column).is_none()) {
                row.set(column, text.to_owned());
            }
            draft.set(field, String::new());
        }
        draft
    }

    /// The columns that any feature has something in, in their order.
    pub fn used(&self) -> impl Iterator<Item = Column> {
        Column::ALL.into_iter().filter(|column| self.rows.iter().any(|row| row.text(*column).is_some()))
    }
}
