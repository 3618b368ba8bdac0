//! Cells of a draft: written, selected, placed on the picture.

use fitcheck_core::part::{Column, Draft, DraftFeature};

/// Writes a cell, unless that is what it has: a text that a file has stays where it is.
pub(super) fn write(row: &mut DraftFeature, column: Column, text: &str) {
    if row.cell(column).text != text {
        row.set(column, text.to_owned());
    }
}

/// The selected features.
pub(super) fn selected<'a>(
    draft: &'a mut Draft,
    rows: &std::ops::RangeInclusive<usize>,
) -> impl Iterator<Item = &'a mut DraftFeature> + use<'a> {
    let rows = clamped(rows, draft.rows.len());
    draft.rows.iter_mut().skip(rows.start).take(rows.len())
}

/// Selected rows as far as there are features.
pub(super) fn clamped(rows: &std::ops::RangeInclusive<usize>, count: usize) -> std::ops::Range<usize> {
    (*rows.start()).min(count)..(*rows.end() + 1).min(count)
}

/// Puts the balloon of a row on the picture.
pub(super) fn place(draft: &mut Draft, row: usize, at: [f64; 2]) {
    let Some(row) = draft.rows.get_mut(row) else { return };
    for (column, share) in [Column::BalloonX, Column::BalloonY].into_iter().zip(at) {
        write(row, column, &format!("{:.4}", share.clamp(0.0, 1.0)));
    }
}
