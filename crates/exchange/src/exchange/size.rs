//! One measured size, of a hole or of a shaft, and where readers put it.

use fitcheck_core::length::Length;
use fitcheck_core::tolerance::Feature;

/// A measured size.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Size {
    /// Its line, from 1.
    pub line: usize,
    /// Name of the part; empty where there is none.
    pub id: String,
    pub measured: Length,
    /// Whether the file says that nobody measured it.
    pub is_simulated: bool,
}

/// Where sizes go, and which side they are of.
pub(super) struct SizesOf<'a> {
    pub(super) feature: Feature,
    pub(super) take: &'a mut dyn FnMut(Size),
}
