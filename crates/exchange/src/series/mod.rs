//! Series of a feature: which values count, which are left out, how they are grouped, and what is computed of them.
//!
//! | file | what |
//! |---|---|
//! | `value` | one value with what is known of it, and why it is left out |
//! | `grouping` | what makes a subgroup |
//! | `wanted` | what is asked |
//! | `figure` | a figure with its interval and its method |
//! | `charted` | the chart: limits, rules that fire, EWMA and CUSUM |
//! | `figures` | all that is computed, and advice |
//! | `reading` | values from what a file holds |
//! | `layout` | parts, operators and readings of a study of a gauge |
//! | `study_wanted` | what is asked of it, and how its values are understood |
//! | `study` | what a study says |
//! | `budget` | what it gives an uncertainty budget |
//! | `compared` | groups such as machines, compared |
//! | `listed` | every feature in a line, those that need a look first |
//! | `drawn` | its charts as drawings |
//! | `journal` | the series of a journal, one for each feature |
//! | `evaluated` | what is computed of one, as it is looked at |
//! | `alarms` | which rules fire at its newest value |
//!
//! `fitcheck stats` and the page Statistics show the same figures.

mod alarms;
mod budget;
mod charted;
mod compared;
mod drawn;
mod evaluated;
mod figure;
mod figures;
mod grouping;
mod journal;
mod layout;
mod listed;
mod reading;
mod study;
mod study_wanted;
mod value;
mod wanted;

use std::collections::BTreeSet;

pub use alarms::FiredAlarm;
pub use charted::Remembered;
pub use compared::Factor;
pub use drawn::Drawn;
pub use evaluated::{ASKED_INDEX, Evaluated, EvaluatedSeries, Look};
pub use figure::{Figure, FigureKind, FigureMethod};
pub use figures::{Answer, Contribution, Group};
use fitcheck_core::length::Length;
use fitcheck_statistics::Reason;
pub use grouping::Grouping;
pub use journal::{FeatureKey, FeatureSeries, Gathering, MOST_READ};
pub use layout::{Layout, StudyError, StudyKind, Understood};
pub use listed::{ListedFeature, NoPpk, listed};
pub use reading::ValueReader;
pub use study_wanted::{Reference, StudyWanted};
pub use value::{LeftOut, Origin, Value, names_are_parts};
pub use wanted::{Memory, Wanted};

/// Why values make no series.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum SeriesError {
    /// Values of several features, of which none is named; some of their names.
    Features(String),
    /// A feature without values; some names that have values.
    NoFeature(String),
    /// Limits that differ from value to value.
    Limits,
    /// A point that the chart does not have.
    NoPoint { point: usize, count: usize },
    /// They make no groups.
    Reason(Reason),
}

impl From<Reason> for SeriesError {
    fn from(reason: Reason) -> Self {
        Self::Reason(reason)
    }
}

/// The values of one feature.
#[derive(Debug)]
pub struct Series<'a> {
    /// Its name, where it has one.
    pub name: Option<String>,
    /// The subgroups of the values that count, in millimetres.
    pub groups: Vec<Vec<f64>>,
    /// The values that count, in their order.
    pub counted: Vec<&'a Value>,
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
        Self::of_feature(name.map(str::to_owned), of, grouping)
    }

    /// The values of one feature.
    fn of_feature(name: Option<String>, of: Vec<&'a Value>, grouping: Grouping) -> Result<Self, SeriesError> {
        let counted: Vec<&Value> = of.iter().filter(|value| value.left_out.is_none()).copied().collect();
        let mm = |values: &[&Value]| values.iter().map(|value| value.measured.to_mm_f64()).collect();
        let groups = grouping.groups(&counted)?;
        let groups = groups.into_iter().filter_map(|places| counted.get(places)).map(mm).collect();
        Ok(Self { name, groups, counted, of })
    }

    /// The values that count without those that are left out, named by their place from 1.
    fn counted_without(&self, wanted: &Wanted) -> Vec<&'a Value> {
        let is_left_out = |number: usize| wanted.left_out.iter().any(|(point, _)| *point == number);
        (1..).zip(&self.counted).filter(|(number, _)| !is_left_out(*number)).map(|(_, value)| *value).collect()
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
