//! Groups of values compared: people, machines, gauges or parts.

use std::borrow::Cow;

use fitcheck_statistics::{Advice, Reason, compare};

use super::figure::{Figure, FigureKind};
use super::figures::{Answer, Group};
use super::value::Origin;
use super::wanted::Wanted;
use super::{Series, SeriesError};

fitcheck_core::named! {
    /// What the values of a group have in common.
    #[derive(Debug, Clone, Copy, PartialEq, Eq)]
    pub enum Factor {
        ALL;
        /// Its name in files.
        fn word;
        Who = "who",
        Machine = "machine",
        Gauge = "gauge",
        Batch = "batch",
        Part = "part",
    }
}

impl Factor {
    pub(super) fn of(self, origin: &Origin) -> Cow<'_, str> {
        match self {
            Self::Who => origin.who.as_str().into(),
            Self::Machine => origin.machine.as_str().into(),
            Self::Gauge => origin.gauge.as_str().into(),
            Self::Batch => origin.batch.as_str().into(),
            Self::Part => origin.whole_part().into(),
        }
    }
}

const METHOD: &str = "one-way analysis of variance";

impl Answer {
    /// Whether groups of a series differ. Points that are left out are values, in the order of the series.
    ///
    /// # Errors
    /// Values that do not say to which group they belong.
    pub fn of_groups(series: &Series<'_>, wanted: &Wanted, factor: Factor) -> Result<Self, SeriesError> {
        let mut names: Vec<String> = Vec::new();
        let mut groups: Vec<Vec<f64>> = Vec::new();
        let mut known = std::collections::BTreeMap::new();
        let counted = series.counted_without(wanted);
        let count = counted.iter().filter(|value| factor.of(&value.origin).is_empty()).count();
        if 0 < count {
            return Err(Reason::Ungrouped { count }.into());
        }
        for value in counted {
            let index = *known.entry(factor.of(&value.origin)).or_insert_with_key(|name| {
                names.push(name.clone().into_owned());
                groups.push(Vec::new());
                groups.len() - 1
            });
            if let Some(group) = groups.get_mut(index) {
                group.push(value.measured.to_mm_f64());
            }
        }
        let mut answer = Self::begun(wanted);
        let found = match compare(groups.iter().map(Vec::as_slice), wanted.level) {
            Ok(found) => found,
            Err(reason) => {
                answer.figures.push(Figure::none(["f", "F"], FigureKind::Index, reason, METHOD));
                return Ok(answer);
            }
        };
        answer.bare(["f", "F"], FigureKind::Index, found.ratio.f, METHOD);
        answer.bare(["p", "p"], FigureKind::Probability, found.ratio.p, METHOD);
        answer.bare(["ms_between", "mean square between"], FigureKind::Square, found.between.mean_square(), METHOD);
        answer.bare(["ms_within", "mean square within"], FigureKind::Square, found.within.mean_square(), METHOD);
        answer.groups = names
            .into_iter()
            .zip(&found.means)
            .map(|(name, group)| Group {
                name,
                count: group.count,
                figure: Figure::of(
                    ["mean_mm", "mean"],
                    FigureKind::Length,
                    Ok(group.mean),
                    "mean, pooled standard deviation",
                ),
            })
            .collect();
        answer.advice.push(Advice::of_groups(&found, wanted.level));
        Ok(answer)
    }
}
