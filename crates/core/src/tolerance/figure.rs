//! Figures to check before a verdict relies on them: those that ISO 286 or its transcriptions leave open, and cells of a
//! user's own table that differ from ISO 286.

use std::sync::Arc;

use super::callout::Callout;
use super::class::ToleranceClass;
use super::limits::{Limits, Source};
use super::sources::Sources;
use crate::length::Length;
use crate::message::{Message, Say};

/// A figure of a class to check, in one size step.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(prefix = "figure")]
pub enum FigureWarning {
    /// The user's own table differs from ISO 286.
    OwnTable {
        /// The class.
        class: ToleranceClass,
        /// The size step: above this,
        over: Length,
        /// up to and including this.
        to: Length,
        /// The table.
        table: Arc<str>,
        /// The upper deviation in ISO 286.
        upper: Length,
        /// The lower deviation in ISO 286.
        lower: Length,
    },
    /// The figure of the standard is contested or meant for trial use.
    Standard {
        /// The class.
        class: ToleranceClass,
        /// The size step: above this,
        over: Length,
        /// up to and including this.
        to: Length,
        /// Why, in the standard's words.
        why: Message,
    },
}

impl FigureWarning {
    /// What to check about a figure of a class in a size step, by where it comes from.
    pub fn of(class: ToleranceClass, (over, to): (Length, Length), source: &Source) -> Option<Self> {
        match source {
            Source::Table { name, instead_of: Some(standard), .. } => {
                let table = Arc::clone(name);
                let upper = standard.upper();
                let lower = standard.lower();
                Some(Self::OwnTable { class, over, to, table, upper, lower })
            }
            Source::Standard { doubt: Some(why), .. } => Some(Self::Standard { class, over, to, why: why.clone() }),
            Source::WithoutOwn { source, .. } => Self::of(class, (over, to), source),
            Source::Standard { .. }
            | Source::Table { .. }
            | Source::Iso2768 { .. }
            | Source::Callout
            | Source::File(_)
            | Source::Recorded { .. } => None,
        }
    }

    /// What to check about limits that a callout, or one part of a fit, has from these sources.
    pub fn of_limits(callout: &Callout, limits: &Limits, sources: &Sources) -> Option<Self> {
        let class = callout.of_part(limits.feature).class()?;
        // Most figures have no warning, and the step is looked for only where one does.
        Self::of(class, limits.source.range()?, &limits.source)?;
        let ends = sources.step_ends();
        let at = ends.partition_point(|end| *end < limits.nominal);
        let over = at.checked_sub(1).and_then(|before| ends.get(before)).map_or(Length::ZERO, |end| *end);
        Self::of(class, (over, *ends.get(at)?), &limits.source)
    }

    /// The class and the end of the size step: each has one figure.
    pub const fn cell(&self) -> (ToleranceClass, Length) {
        match self {
            Self::OwnTable { class, to, .. } | Self::Standard { class, to, .. } => (*class, *to),
        }
    }
}
