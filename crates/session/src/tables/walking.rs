//! Moving from cell to cell: by steps, and from difference to difference.

use fitcheck_core::tolerance::ToleranceClass;

use super::{TablesField, TablesPage};
use crate::Step;
use crate::shared::Shared;
use crate::state::PageState as _;

/// How many size ranges make a page.
const PAGE: usize = 10;

impl TablesPage {
    pub(super) fn select(&mut self, class: ToleranceClass, range: usize, shared: &Shared) {
        if let Some(document) = self.shown_mut() {
            document.select(class, range);
            document.keep_selection();
        }
        self.fill_cell_fields(shared);
    }

    /// Moves the selection to where the filter points: to the row of a size, and into the columns that are shown.
    pub(super) fn filter_changed(&mut self, shared: &mut Shared) {
        let Some(document) = self.shown() else { return };
        let Some(filter) = self.filtered(self.text(TablesField::Filter)) else { return };
        let Some((class, range)) = document.selected else { return };
        let is_shown = document.column(class).is_some_and(|column| filter.columns.contains(&column));
        let first = filter.columns.first().and_then(|&column| document.table().columns().get(column));
        let wanted = first.filter(|_| !is_shown).map_or(class, |column| column.class);
        let row = filter.rows.first().copied().unwrap_or(range);
        let first = filter.ranges.first().copied().unwrap_or(row);
        let row = if filter.ranges.contains(&row) { row } else { first };
        self.filter = filter;
        if (wanted, row) != (class, range) && self.settle_cell(shared) {
            self.select(wanted, row, shared);
        }
    }

    /// Moves by a step among the shown columns. A selected cell that the filter hides counts as the nearest shown one.
    pub(super) fn move_by(&mut self, step: Step, shared: &Shared) {
        let Some(document) = self.shown() else { return };
        let table = document.table();
        let shown = &self.filter.columns;
        let Some((class, range)) = document.selected else { return };
        let Some(here) = document.column(class) else { return };
        let place = shown.partition_point(|&column| column < here);
        let is_shown = shown.get(place) == Some(&here);
        let last_place = shown.len().saturating_sub(1);
        let ranges = &self.filter.ranges;
        let row = ranges.partition_point(|&shown| shown < range);
        let below = row + usize::from(ranges.get(row) == Some(&range));
        let last_row = ranges.len().saturating_sub(1);
        let (place, row) = match step {
            Step::Left => (place.saturating_sub(1), row),
            Step::Right if is_shown => (place + 1, row),
            Step::Right => (place, row),
            Step::Up => (place, row.saturating_sub(1)),
            Step::Down => (place, below),
            Step::PageUp => (place, row.saturating_sub(PAGE)),
            Step::PageDown => (place, row.saturating_add(PAGE)),
            Step::First => (0, row),
            Step::Last => (last_place, row),
            Step::Top => (place, 0),
            Step::Bottom => (place, last_row),
        };
        let column = shown.get(place.min(last_place)).and_then(|&column| table.columns().get(column));
        if let (Some(column), Some(&range)) = (column, ranges.get(row.min(last_row))) {
            let class = column.class;
            self.select(class, range, shared);
        }
    }

    /// Selects the next or previous cell that differs, column by column and round again. A hidden one ends the filter.
    pub(super) fn select_difference(&mut self, forwards: bool, shared: &Shared) {
        let Some(document) = self.shown() else { return };
        let here = document.selected.and_then(|(class, range)| Some((document.column(class)?, range)));
        let mut cells = document.differing_cells();
        let next = if forwards {
            cells.find(|cell| here < Some(*cell)).or_else(|| document.differing_cells().next())
        } else {
            cells.rfind(|cell| Some(*cell) < here).or_else(|| document.differing_cells().next_back())
        };
        drop(cells);
        let Some((column, range)) = next else { return };
        let Some(class) = document.table().columns().get(column).map(|column| column.class) else { return };
        if !self.filter.columns.contains(&column)
            && let Some(filter) = self.filtered("")
        {
            self.filter = filter;
            self.texts.set(TablesField::Filter, "");
        }
        self.select(class, range, shared);
    }
}
