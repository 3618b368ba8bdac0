//! A figure: its name, its value with its interval or why there is none, and its method.

use fitcheck_statistics::{Estimate, Reason};

/// How a figure is written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FigureKind {
    /// Millimetres.
    Length,
    /// Square millimetres.
    Square,
    /// An index, a statistic, a distance in s.
    Index,
    /// Per cent.
    Percent,
    /// Parts in a million.
    Ppm,
    /// A probability.
    Probability,
}

/// A figure.
#[derive(Debug, Clone)]
pub struct Figure {
    /// Its name for machines.
    pub name: &'static str,
    /// Its name for people.
    pub label: &'static str,
    pub kind: FigureKind,
    /// The figure, with an interval where it is estimated; or why there is none.
    pub value: Result<(f64, Option<[f64; 2]>), Reason>,
    pub method: String,
}

impl Figure {
    /// A figure with its interval, or the reason why there is none.
    pub(super) fn of(
        name: [&'static str; 2],
        kind: FigureKind,
        value: Result<Estimate, Reason>,
        method: impl Into<String>,
    ) -> Self {
        let value = value.map(|value| (value.value, Some([value.lower, value.upper])));
        Self { name: name[0], label: name[1], kind, value, method: method.into() }
    }

    /// A figure without an interval.
    pub(super) fn bare(name: [&'static str; 2], kind: FigureKind, value: f64, method: impl Into<String>) -> Self {
        Self { name: name[0], label: name[1], kind, value: Ok((value, None)), method: method.into() }
    }

    /// Why there is no figure.
    pub(super) fn none(name: [&'static str; 2], kind: FigureKind, why: Reason, method: impl Into<String>) -> Self {
        Self { name: name[0], label: name[1], kind, value: Err(why), method: method.into() }
    }
}
