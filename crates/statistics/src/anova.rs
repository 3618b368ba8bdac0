//! Analysis of variance: its rows, and the comparison of groups by one factor.

use crate::moments::{Estimate, Moments, checked_level, count};
use crate::reason::Reason;
use fitcheck_core::law::{fisher, student_factor};

/// A row of an analysis of variance.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Row {
    /// The sum of squares.
    pub squares: f64,
    /// The degrees of freedom; above 0.
    pub degrees: f64,
}

impl Row {
    /// The mean square.
    pub fn mean_square(&self) -> f64 {
        self.squares / self.degrees
    }

    /// How many times the mean square of another row, and how probable that is by chance.
    pub fn against(&self, other: &Self) -> Ratio {
        let f = self.mean_square() / other.mean_square();
        Ratio { f, p: fisher([self.degrees, other.degrees], f).above }
    }

    /// Both rows in one.
    #[must_use]
    pub fn pooled(&self, other: &Self) -> Self {
        Self { squares: self.squares + other.squares, degrees: self.degrees + other.degrees }
    }
}

/// A ratio of mean squares.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ratio {
    /// The ratio F.
    pub f: f64,
    /// The probability of at least this ratio where nothing differs.
    pub p: f64,
}

/// A group with its mean.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct GroupMean {
    /// How many values it has.
    pub count: usize,
    /// Its mean; the interval is that of the pooled standard deviation.
    pub mean: Estimate,
}

/// What groups such as stations, tools or shifts have to do with each other.
#[derive(Debug, Clone, PartialEq)]
pub struct Groups {
    /// Between the groups.
    pub between: Row,
    /// Within them.
    pub within: Row,
    /// Whether they differ.
    pub ratio: Ratio,
    /// The groups, in their order.
    pub means: Vec<GroupMean>,
}

/// Compares groups of values: one-way analysis of variance (NIST/SEMATECH e-Handbook 7.4.3).
///
/// # Errors
/// Fewer than two groups, an empty one, values that are no finite numbers or that are equal within each group.
pub fn compare<'a>(groups: impl IntoIterator<Item = &'a [f64]>, level: f64) -> Result<Groups, Reason> {
    checked_level(level)?;
    let groups = groups.into_iter().map(Moments::of).collect::<Result<Vec<_>, _>>()?;
    if groups.len() < 2 {
        return Err(Reason::TooFew { found: groups.len(), needed: 2 });
    }
    let all: usize = groups.iter().map(|group| group.count).sum();
    if all <= groups.len() {
        return Err(Reason::NoSubgroups);
    }
    // About the first mean: groups with nine equal leading digits keep what they differ by.
    let first = groups.first().map_or(0.0, |group| group.mean);
    let offset = groups.iter().map(|group| count(group.count) * (group.mean - first)).sum::<f64>() / count(all);
    let squares = groups.iter().map(|group| count(group.count) * (group.mean - first - offset).powi(2)).sum();
    let between = Row { squares, degrees: count(groups.len()) - 1.0 };
    let within = Row { squares: groups.iter().map(|group| group.squares).sum(), degrees: count(all - groups.len()) };
    if within.squares <= 0.0 {
        return Err(Reason::AllEqual);
    }
    let half = student_factor(within.degrees, level) * within.mean_square().sqrt();
    let means = groups.iter().map(|group| GroupMean {
        count: group.count,
        mean: Estimate::about(group.mean, half / count(group.count).sqrt()),
    });
    Ok(Groups { between, within, ratio: between.against(&within), means: means.collect() })
}
