//! An open table: its edits, the selected cell, and how it compares with ISO 286.

use std::ops::Range;
use std::path::Path;

use fitcheck_core::length::Length;
use fitcheck_core::text::Within as _;
use fitcheck_core::tolerance::compare::{Comparison, Difference, compare};
use fitcheck_core::tolerance::table_edit::{TableEdit, standard_column};
use fitcheck_core::tolerance::{DeviationTable, Deviations, ToleranceClass, iso286};

use crate::document::DocumentFile;

/// Where an open table came from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Origin {
    /// One of the two built-in tables. It is never changed: an edit makes a copy.
    Shipped,
    /// From the user's folder.
    Own,
    /// From a file that was opened alone, or saved.
    File,
    /// A copy of a built-in table.
    Copy,
    /// Made from ISO 286.
    Made,
}

/// An open table.
#[derive(Debug, Clone)]
pub struct Document {
    /// What it is called; it may differ from the name within the table.
    pub title: String,
    /// Where it came from.
    pub origin: Origin,
    edit: TableEdit,
    file: DocumentFile<DeviationTable>,
    /// The options of the comparison with ISO 286.
    pub options: iso286::Options,
    /// How it compares with ISO 286.
    pub comparison: Comparison,
    /// The cells that differ, column by column: column number, size range number, and the numbers of the differences. A
    /// range may cover several steps of the standard and differ in each.
    differing: Vec<(usize, usize, Range<usize>)>,
    /// The selected cell: class, and number of the size range.
    pub selected: Option<(ToleranceClass, usize)>,
}

impl Document {
    /// A table that is stored somewhere in this state.
    pub(super) fn kept(table: DeviationTable, origin: Origin, options: iso286::Options) -> Self {
        Self { file: DocumentFile::unnamed(table.clone()), ..Self::unsaved(table, origin, options) }
    }

    /// A table that is not stored anywhere.
    pub(super) fn unsaved(table: DeviationTable, origin: Origin, options: iso286::Options) -> Self {
        let mut document = Self {
            title: table.name().to_owned(),
            origin,
            edit: TableEdit::new(table),
            file: DocumentFile::missing(),
            options,
            comparison: Comparison::default(),
            differing: Vec::new(),
            selected: None,
        };
        document.compare(options);
        document.keep_selection();
        document
    }

    #[must_use]
    pub(super) fn with_title(self, title: String) -> Self {
        Self { title, ..self }
    }

    /// A copy under another title, which can be changed and has no unsaved edits yet.
    pub(super) fn copy(&self, title: String) -> Self {
        let selected = self.selected;
        let copy = Self::kept(self.table().clone(), Origin::Copy, self.options);
        Self { title, selected, ..copy }
    }

    /// The table as it is now.
    pub const fn table(&self) -> &DeviationTable {
        self.edit.table()
    }

    /// How many cells differ.
    pub const fn differing(&self) -> usize {
        self.differing.len()
    }

    /// The cells that differ, column by column: number of the column, number of the size range.
    pub fn differing_cells(&self) -> impl DoubleEndedIterator<Item = (usize, usize)> {
        self.differing.iter().map(|(column, range, _)| (*column, *range))
    }

    /// What differs in a cell: number of the column, number of the size range. Several where the range covers several
    /// steps of the standard.
    pub fn differences(&self, column: usize, range: usize) -> &[Difference] {
        let place = self.differing.binary_search_by_key(&(column, range), |(column, range, _)| (*column, *range)).ok();
        let cell = place.and_then(|place| self.differing.get(place));
        cell.map_or(&[], |(.., numbers)| self.comparison.differences.within(numbers.clone()))
    }

    /// How many cells of a column differ.
    pub fn differing_in(&self, column: usize) -> usize {
        let first = self.differing.partition_point(|(other, ..)| *other < column);
        let beyond = self.differing.partition_point(|(other, ..)| *other <= column);
        beyond - first
    }

    /// The number of a class's column.
    pub fn column(&self, class: ToleranceClass) -> Option<usize> {
        self.table().columns().iter().position(|column| column.class == class)
    }

    /// Whether a class is not one of ISO 286.
    pub fn is_own_class(&self, class: ToleranceClass) -> bool {
        self.comparison.unknown.contains(&class)
    }

    pub fn cell(&self, class: ToleranceClass, range: usize) -> Option<Deviations> {
        let column = self.table().columns().iter().find(|column| column.class == class)?;
        column.cells.get(range).copied().flatten()
    }

    /// A size range: above this, up to and including this, mm.
    pub fn range(&self, range: usize) -> Option<(Length, Length)> {
        let ends = self.table().ends();
        let to = *ends.get(range)?;
        // The first range begins at zero.
        let over = range.checked_sub(1).and_then(|before| ends.get(before));
        Some((over.copied().unwrap_or(Length::ZERO), to))
    }

    /// What ISO 286 gives for a cell; `None` where it gives nothing, or several values for the size range.
    pub fn standard(&self, class: ToleranceClass, range: usize) -> Option<Deviations> {
        // The two ends of the range are enough.
        let (over, to) = self.range(range)?;
        let ends = if Length::ZERO < over { vec![over, to] } else { vec![to] };
        standard_column(class, &ends, self.options).cells.last().copied().flatten()
    }

    /// The size ranges in which ISO 286 defines a class: above and up to, mm.
    pub fn defined(&self, class: ToleranceClass) -> Vec<(Length, Length)> {
        // Beyond the standard's last size every class is refused, and the error knows where it is defined.
        let refused = iso286::deviations(class, Length::MAX, self.options);
        refused.map_or_else(|undefined| undefined.defined(), |_| Vec::new())
    }

    /// Whether there are edits that no file holds.
    pub fn is_unsaved(&self) -> bool {
        self.file.kept().is_none_or(|kept| !self.holds_what(kept))
    }

    /// Whether it is the user's own and has a title.
    pub(super) fn is_titled(&self, title: &str) -> bool {
        self.origin != Origin::Shipped && self.title.eq_ignore_ascii_case(title)
    }

    /// Whether a table that is read under the same name may replace it.
    pub(super) fn is_replaceable(&self) -> bool {
        self.origin != Origin::Shipped && !self.is_unsaved()
    }

    /// Whether its cells are those of another table, whatever their names.
    pub(super) fn holds_what(&self, other: &DeviationTable) -> bool {
        self.table().ends() == other.ends() && self.table().columns() == other.columns()
    }

    /// Whether an edit can be undone.
    pub fn can_undo(&self) -> bool {
        self.edit.can_undo()
    }

    /// Whether an undone edit can be redone.
    pub fn can_redo(&self) -> bool {
        self.edit.can_redo()
    }

    pub(super) const fn select(&mut self, class: ToleranceClass, range: usize) {
        self.selected = Some((class, range));
    }

    /// A table always has a selected cell, unless it has no column.
    pub(super) fn keep_selection(&mut self) {
        let columns = self.edit.table().columns();
        let has = |class| columns.iter().any(|column| column.class == class);
        if !self.selected.is_some_and(|(class, range)| has(class) && range < self.edit.table().ends().len()) {
            self.selected = columns.first().map(|column| (column.class, 0));
        }
    }

    /// Undoes the last edit and selects what it changed.
    pub(super) fn undo(&mut self) {
        self.change_and_show(|edit| _ = edit.undo());
    }

    /// Redoes an edit and selects what it changes.
    pub(super) fn redo(&mut self) {
        self.change_and_show(|edit| _ = edit.redo());
    }

    fn change_and_show(&mut self, change: impl FnOnce(&mut TableEdit)) {
        let before = self.table().clone();
        self.change(change);
        if let Some(changed) = first_change(&before, self.table()) {
            self.selected = Some(changed);
        }
    }

    pub(super) fn change<T>(&mut self, change: impl FnOnce(&mut TableEdit) -> T) -> T {
        let answer = change(&mut self.edit);
        self.compare(self.options);
        answer
    }

    /// It is being written as it is now.
    pub(super) fn save(&mut self, path: &Path) {
        let table = self.table().clone();
        self.file.save(path, table);
    }

    /// A file was written, or not; whether this table was saved by that, as it was then. It takes the file's name.
    pub(super) fn written(&mut self, path: &Path, is_whole: bool) -> bool {
        let is_saved = self.file.written(path, is_whole);
        if is_saved {
            self.title = self.file.name(&self.title);
            self.origin = Origin::File;
        }
        is_saved
    }

    /// Its file was overwritten by another table.
    pub(super) fn lose_file(&mut self, title: String) {
        self.title = title;
        self.file = DocumentFile::missing();
    }

    /// Compares with ISO 286 under these options.
    pub(super) fn compare(&mut self, options: iso286::Options) {
        self.options = options;
        self.comparison = compare(self.edit.table(), options);
        self.differing.clear();
        for (number, difference) in self.comparison.differences.iter().enumerate() {
            let columns = self.edit.table().columns();
            let Some(column) = columns.iter().position(|column| column.class == difference.class) else { continue };
            match self.differing.last_mut() {
                Some((last, range, numbers)) if (*last, *range) == (column, difference.range) => {
                    numbers.end = number + 1;
                }
                _ => self.differing.push((column, difference.range, number..number + 1)),
            }
        }
    }
}

/// The first cell of a table that differs from before; of a new column, its first cell.
fn first_change(before: &DeviationTable, after: &DeviationTable) -> Option<(ToleranceClass, usize)> {
    after.columns().iter().find_map(|column| {
        let Some(old) = before.columns().iter().find(|old| old.class == column.class) else {
            return Some((column.class, 0));
        };
        let range = column.cells.iter().zip(&old.cells).position(|(cell, old)| cell != old)?;
        Some((column.class, range))
    })
}
