//! A cell that cannot be used, and why.

use super::error::ImportErrorKind;

/// A cell and its place in the row, from 0.
#[derive(Debug, Clone, Copy)]
pub(super) struct Cell<'a> {
    pub(super) at: Option<usize>,
    pub(super) text: &'a str,
}

/// A cell that cannot be used.
pub(super) type Refused<'a> = (Cell<'a>, ImportErrorKind);
