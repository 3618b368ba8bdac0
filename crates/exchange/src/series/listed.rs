//! Every feature in a line: how many values, how capable, how many signals; those that need a look first.

use std::collections::BTreeMap;

use fitcheck_statistics::Reason;

use super::evaluated::ASKED_INDEX;
use super::figures::Answer;
use super::value::Value;
use super::wanted::Wanted;
use super::{Grouping, Series, SeriesError};

/// Why a feature has no Ppk.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum NoPpk {
    /// It cannot be computed.
    Reason(Reason),
    /// Its values make no series.
    Series(SeriesError),
}

/// A feature with what is said of it first.
#[derive(Debug)]
pub struct ListedFeature {
    pub name: String,
    /// How many values count.
    pub count: usize,
    /// How many of them are outside the limits.
    pub outside: usize,
    /// Ppk with its interval.
    pub ppk: Result<(f64, Option<[f64; 2]>), NoPpk>,
    /// At how many points a rule fires.
    pub signals: usize,
}

impl ListedFeature {
    fn of(name: &str, values: Vec<&Value>, grouping: Grouping, wanted: &Wanted) -> Self {
        let mut listed =
            Self { name: name.to_owned(), count: 0, outside: 0, ppk: Err(NoPpk::Reason(Reason::NoLimits)), signals: 0 };
        let found = Series::of_feature(None, values, grouping).and_then(|series| {
            listed.count = series.count();
            let limits = series.limits()?;
            Ok(Answer::of(&series, &Wanted { limits, ..wanted.clone() }))
        });
        match found {
            Ok(answer) => {
                listed.outside = answer.outside.iter().sum();
                let mut points: Vec<usize> = answer.fired.iter().flat_map(|(_, points)| points).copied().collect();
                points.sort_unstable();
                points.dedup();
                listed.signals = points.len();
                let value = answer.figure("ppk").or_else(|| answer.figure("cpk")).map(|figure| figure.value.clone());
                listed.ppk = value.unwrap_or(Err(Reason::NoLimits)).map_err(NoPpk::Reason);
            }
            Err(error) => listed.ppk = Err(NoPpk::Series(error)),
        }
        listed
    }

    /// Whether somebody should look at it: values outside, too little capability, signals.
    pub fn needs_a_look(&self) -> bool {
        0 < self.outside || 0 < self.signals || self.ppk.as_ref().is_ok_and(|(ppk, _)| *ppk < ASKED_INDEX)
    }

    /// Features with values outside come first, then the less capable ones, then those with more signals.
    fn urgency(&self, other: &Self) -> std::cmp::Ordering {
        let ppk = |of: &Self| of.ppk.as_ref().map_or(f64::INFINITY, |(ppk, _)| *ppk);
        let is_inside = |of: &Self| of.outside == 0;
        is_inside(self)
            .cmp(&is_inside(other))
            .then_with(|| ppk(self).total_cmp(&ppk(other)))
            .then_with(|| other.signals.cmp(&self.signals))
    }
}

/// All features of the values, the most urgent first.
pub fn listed(values: &[Value], grouping: Grouping, wanted: &Wanted) -> Vec<ListedFeature> {
    let mut by_name: BTreeMap<&str, Vec<&Value>> = BTreeMap::new();
    for value in values {
        by_name.entry(&value.name).or_default().push(value);
    }
    let mut all: Vec<ListedFeature> =
        by_name.into_iter().map(|(name, values)| ListedFeature::of(name, values, grouping, wanted)).collect();
    all.sort_by(ListedFeature::urgency);
    all
}
