//! Series of a feature: which values count, which are left out, how they are grouped, and what is computed of them.
//!
//! | file | what |
//! |---|---|
//! | `value` | one value with what is known of it, and why it is left out |
//! | `figures` | what is computed, each figure with its method; rules that fire; advice |
//! | `drawn` | its charts as drawings |
//! | `journal` | the series of a journal, one for each feature, and what is computed of one |
//!
//! `fitcheck stats` and the page Statistics show the same figures.

mod drawn;
mod figures;
mod journal;
mod value;

use std::collections::BTreeSet;

pub use drawn::Drawn;
pub use figures::{Answer, Figure, FigureKind, Wanted};
use fitcheck_core::length::Length;
use fitcheck_statistics::Sample;
pub use journal::{ASKED_INDEX, Evaluated, FeatureKey, FeatureSeries, Gathering, Look, MOST_READ};
pub use value::{LeftOut, Origin, Value};

/// What makes a subgroup.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Grouping {
    /// Each value is one.
    Single,
    /// So many values in a row.
    Of(usize),
    /// The values of one part in a row.
    ByPart,
}

/// Why values make no series.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum SeriesError {
    /// Values of several features, of which none is named; some of their names.
    Features(String),
    /// A feature without values; some names that have values.
    NoFeature(String),
    /// Limits that differ from value to value.
    Limits,
    /// Values without parts.
    NoParts,
}

/// The values of one feature.
#[derive(Debug)]
pub struct Series<'a> {
    /// Its name, where it has one.
    pub name: Option<String>,
    /// The subgroups of the values that count, in millimetres.
    pub groups: Vec<Vec<f64>>,
    /// The subgroups that somebody left out and why, with their places among all of them.
    apart: Vec<(usize, Sample)>,
    of: Vec<&'a Value>,
}

impl<'a> Series<'a> {
    /// The values of a feature; without one, the files have one feature only.
    pub fn of(values: &'a [Value], feature: Option<&str>, grouping: Grouping) -> Result<Self, SeriesError> {
        let names: BTreeSet<&str> = values.iter().map(|value| value.name.as_str()).collect();
        let all = || names.iter().take(MOST_NAMES).copied().collect::<Vec<_>>().join(", ");
        let name = match feature {
            Some(given) if names.contains(given) => Some(given),
            Some(_) => return Err(SeriesError::NoFeature(all())),
            None if names.len() == 1 => names.first().copied().filter(|name| !name.is_empty()),
            // Names of parts: every value has its own, and all have the same limits.
            None if names.len() == values.len() && are_alike(values) => None,
            None if names.is_empty() => None,
            None => return Err(SeriesError::Features(all())),
        };
        let of: Vec<&Value> = values.iter().filter(|value| feature.is_none_or(|name| value.name == name)).collect();
        let counted: Vec<&Value> = of.iter().filter(|value| value.left_out.is_none()).copied().collect();
        let groups: Vec<&[&Value]> = match grouping {
            Grouping::Single => counted.chunks(1).collect(),
            Grouping::Of(size) => counted.chunks(size.max(1)).collect(),
            Grouping::ByPart if counted.iter().any(|value| value.origin.is_of_no_part()) => {
                return Err(SeriesError::NoParts);
            }
            Grouping::ByPart => counted.chunk_by(|one, other| one.origin.is_of_same_part(&other.origin)).collect(),
        };
        let mm = |group: &[&Value]| group.iter().map(|value| value.measured.to_mm_f64()).collect();
        let groups = groups.into_iter().map(mm).collect();
        Ok(Self { name: name.map(str::to_owned), groups, apart: Vec::new(), of })
    }

    /// All subgroups in their order.
    fn samples(&self) -> Vec<Sample> {
        let mut samples: Vec<Sample> = self.groups.iter().cloned().map(Sample::of).collect();
        for (point, sample) in &self.apart {
            samples.insert((*point).min(samples.len()), sample.clone());
        }
        samples
    }

    /// Lower and upper limit in millimetres, as far as the files state them.
    pub fn limits(&self) -> Result<[Option<f64>; 2], SeriesError> {
        let stated = self.of.iter().map(|value| value.limits).filter(|limits| limits != &[None, None]);
        let mut stated = stated.collect::<Vec<_>>();
        stated.dedup();
        match stated.as_slice() {
            [] => Ok([None, None]),
            [limits] => Ok(limits.map(|limit| limit.map(Length::to_mm_f64))),
            _ => Err(SeriesError::Limits),
        }
    }

    /// How many values count.
    pub fn count(&self) -> usize {
        self.groups.iter().map(Vec::len).sum()
    }

    /// How many values are left out for each reason, where there are any.
    pub fn left_out(&self) -> impl Iterator<Item = (LeftOut, usize)> {
        let count = |why: LeftOut| self.of.iter().filter(|value| value.left_out == Some(why)).count();
        LeftOut::ALL.into_iter().map(move |why| (why, count(why))).filter(|(_, count)| 0 < *count)
    }

    /// Whether doubtful values are left out.
    pub fn has_doubts(&self) -> bool {
        self.left_out().any(|(why, _)| why == LeftOut::Doubtful)
    }
}

/// So many names of features are listed.
const MOST_NAMES: usize = 20;

/// Whether all values have the same limits.
fn are_alike(values: &[Value]) -> bool {
    values.windows(2).all(|pair| matches!(pair, [one, other] if one.limits == other.limits))
}
