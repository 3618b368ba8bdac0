//! A figure: its name, its value with its interval or why there is none, and its method.

use fitcheck_core::message::{Say, printed};
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

/// How a figure was computed.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(prefix = "series-method")]
pub enum FigureMethod {
    /// A name that is the same in every language.
    Word {
        word: String,
    },
    /// A size that was given.
    Given,
    /// A mean, with Student's interval.
    Mean,
    /// A standard deviation with the interval of its chi-square.
    Deviation,
    /// A mean less its reference.
    Bias,
    TTest,
    /// A type 1 study.
    Type1,
    /// A share of the tolerance over so many standard deviations.
    Share {
        #[say(with = printed)]
        percent: String,
        #[say(with = printed)]
        spread: String,
    },
    /// What Cg and Cgk must reach.
    Required {
        #[say(with = printed)]
        required: String,
    },
    /// Analysis of variance.
    Anova,
    /// The same, with degrees of freedom.
    Degrees {
        #[say(with = printed)]
        degrees: String,
    },
    /// A ratio of mean squares.
    Ratio {
        #[say(with = printed)]
        f: String,
    },
    /// A variance that came out negative.
    Negative,
    ChiSquare,
    /// Modified large sample.
    LargeSample,
    /// A share of variances.
    Variances,
    /// How many groups of parts are told apart.
    Categories,
    Linearity,
    LeastSquares,
    /// The scatter within masters.
    WithinMasters,
}

impl From<&str> for FigureMethod {
    fn from(word: &str) -> Self {
        Self::Word { word: word.to_owned() }
    }
}

impl From<String> for FigureMethod {
    fn from(word: String) -> Self {
        Self::Word { word }
    }
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
    pub method: FigureMethod,
}

impl Figure {
    /// A figure with its interval, or the reason why there is none.
    pub(super) fn of(
        name: [&'static str; 2],
        kind: FigureKind,
        value: Result<Estimate, Reason>,
        method: impl Into<FigureMethod>,
    ) -> Self {
        let value = value.map(|value| (value.value, Some([value.lower, value.upper])));
        Self { name: name[0], label: name[1], kind, value, method: method.into() }
    }

    /// A figure without an interval.
    pub(super) fn bare(name: [&'static str; 2], kind: FigureKind, value: f64, method: impl Into<FigureMethod>) -> Self {
        Self { name: name[0], label: name[1], kind, value: Ok((value, None)), method: method.into() }
    }

    /// Why there is no figure.
    pub(super) fn none(
        name: [&'static str; 2],
        kind: FigureKind,
        why: Reason,
        method: impl Into<FigureMethod>,
    ) -> Self {
        Self { name: name[0], label: name[1], kind, value: Err(why), method: method.into() }
    }
}
