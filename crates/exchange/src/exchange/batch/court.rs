//! What every worker needs to judge the rows of a stream, and which of them are plain.

use std::sync::Arc;

use super::known::Steps;
use super::layout::Layout;
use crate::exchange::beside::BesideColumn;
use crate::exchange::limits::LimitColumns;
use crate::exchange::quantity::QuantityColumn;
use crate::exchange::row::TextRow;
use fitcheck_core::length::Unit;
use fitcheck_core::tolerance::Sources;

/// What every worker needs to judge: the layout of the stream and where limits come from.
#[derive(Debug)]
pub struct StreamJudging<'a> {
    pub(super) layout: &'a Layout,
    pub(super) sources: &'a Sources,
    pub(super) steps: Steps,
    pub(super) fast: Fast<'a>,
    /// In place of the name of a file: no answer has it.
    pub(super) file: Arc<str>,
}

/// Which rows can be judged fast.
#[derive(Debug)]
#[expect(clippy::struct_excessive_bools, reason = "each answers another question about the rows")]
pub(super) struct Fast<'a> {
    pub(super) measured: (usize, Unit),
    pub(super) nominal: Option<(usize, Unit)>,
    pub(super) tolerance: Option<usize>,
    /// Limits in columns of their own.
    pub(super) limits: Option<&'a LimitColumns>,
    /// The column that says hole or shaft, where rows have limits; rows are looked at closely where several do.
    pub(super) side: Option<&'a BesideColumn>,
    /// The only column that states the unit of each row.
    pub(super) unit: Option<usize>,
    /// Whether lengths are in inch by a statement: a callout with a size of its own is doubtful.
    pub(super) is_inch: bool,
    /// Columns in which a row may say that nobody measured, or that the size alone does not decide.
    pub(super) aside: Vec<usize>,
    /// Columns that say what was measured: with one of its words of a size a row is plain.
    pub(super) quantities: &'a [QuantityColumn],
    pub(super) count: usize,
    /// A decimal sign that the measured values do not have.
    pub(super) foreign_sign: Option<u8>,
    /// Cells between commas, where a decimal comma may have become a separator.
    pub(super) has_commas: bool,
    /// Whether the cell before the callout may belong to it.
    pub(super) may_join: bool,
    /// Whether a line may be a comment.
    pub(super) has_comments: bool,
}

impl<'a> StreamJudging<'a> {
    /// For rows of a layout, with limits from these sources.
    pub fn new(layout: &'a Layout, sources: &'a Sources) -> Self {
        let columns = &layout.columns;
        let has_commas = layout.has_commas();
        let plain = columns.stated.plain();
        // Without a plain unit no row is fast.
        let (unit, is_inch) = plain.unwrap_or((None, false));
        let fast = Fast {
            measured: (columns.measured.at, columns.measured.unit),
            nominal: columns.nominal.map(|column| (column.at, column.unit)),
            // Without a column of callouts no row is fast; simulated rows are counted where each is read as a whole.
            tolerance: columns.tolerance.filter(|_| plain.is_some() && !columns.evidence.are_simulated),
            limits: columns
                .limits
                .as_ref()
                .filter(|_| plain.is_some() && !columns.evidence.are_simulated && columns.sides().len() < 2),
            side: match columns.sides().as_slice() {
                [one] => Some(one),
                _ => None,
            },
            unit,
            is_inch,
            aside: columns
                .simulated
                .into_iter()
                .chain(columns.evidence.origin)
                .chain(columns.evidence.word)
                .chain(columns.own.deciding().into_iter().flatten())
                .collect(),
            quantities: &columns.quantities,
            count: columns.count,
            foreign_sign: columns.decimal_sign.map(|sign| if sign == '.' { b',' } else { b'.' }),
            has_commas,
            may_join: has_commas && !columns.names_known,
            has_comments: !layout.is_typed,
        };
        Self { layout, sources, steps: Steps::of(sources), fast, file: Arc::from("") }
    }

    /// The layout of the rows.
    pub const fn layout(&self) -> &'a Layout {
        self.layout
    }

    /// Where limits come from.
    pub const fn sources(&self) -> &Sources {
        self.sources
    }
}

impl Fast<'_> {
    /// Whether nothing beside the value of a row has to be read, and its value is a size; `None` where cells are missing.
    #[inline]
    pub(super) fn is_plain_size(&self, row: &TextRow<'_>) -> Option<bool> {
        for at in &self.aside {
            if !row.cell(*at)?.is_empty() {
                return Some(false);
            }
        }
        for column in self.quantities {
            if !column.is_known_size(row.cell(column.at)?) {
                return Some(false);
            }
        }
        Some(true)
    }
}
