//! What fires on a chart, as stretches of points: what a reader sees and counts.

use std::ops::Range;

use fitcheck_core::message::{Message, Say as _, message};

use crate::chart::{Chart, ChartPoint, Point};
use crate::rules::Rule;

/// Which of the two figures of a point.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Place {
    /// The value or mean.
    Location,
    /// The moving range, range or standard deviation.
    Spread,
}

impl Place {
    /// Both of them.
    pub const ALL: [Self; 2] = [Self::Location, Self::Spread];

    /// Its name in files.
    pub const fn word(self) -> &'static str {
        match self {
            Self::Location => "location",
            Self::Spread => "spread",
        }
    }

    /// A rule that fires on this figure, in words.
    pub fn said(self, rule: Rule) -> Message {
        match self {
            Self::Location => rule.message(),
            Self::Spread => message!("statistics-on-spread").message("rule", rule.message()),
        }
    }

    pub(crate) fn of(self, point: &ChartPoint) -> Option<&Point> {
        match self {
            Self::Location => Some(&point.location),
            Self::Spread => point.spread.as_ref(),
        }
    }
}

/// A rule that fires, with all stretches of points that it fires for.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Signal {
    /// The rule.
    pub rule: Rule,
    /// On which figure.
    pub place: Place,
    /// The points of each pattern, in order, counted from 0; patterns that touch each other are one.
    pub stretches: Vec<Range<usize>>,
}

impl Signal {
    /// How many points its patterns have.
    pub fn count(&self) -> usize {
        self.stretches.iter().map(Range::len).sum()
    }
}

/// All that fires on a chart: values first, then the spread, each in the order of its first pattern.
pub fn signals(chart: &Chart) -> Vec<Signal> {
    let counted: Vec<usize> = (0..).zip(&chart.points).filter(|(_, of)| of.left_out.is_none()).map(|of| of.0).collect();
    let mut all = Vec::new();
    for place in [Place::Location, Place::Spread] {
        let found = Rule::ALL.into_iter().filter_map(|rule| {
            let stretches = stretches(chart, &counted, place, rule);
            (!stretches.is_empty()).then_some(Signal { rule, place, stretches })
        });
        let mut found: Vec<_> = found.collect();
        found.sort_by_key(|signal| signal.stretches.first().map(|of| of.start));
        all.extend(found);
    }
    all
}

fn stretches(chart: &Chart, counted: &[usize], place: Place, rule: Rule) -> Vec<Range<usize>> {
    let mut found: Vec<Range<usize>> = Vec::new();
    for (number, place_in_chart) in counted.iter().enumerate() {
        let fires = chart.points.get(*place_in_chart).and_then(|point| place.of(point));
        if !fires.is_some_and(|point| point.fired.has(rule)) {
            continue;
        }
        // Points that are left out are none of the pattern's.
        let first = (number + 1).saturating_sub(rule.points());
        let start = counted.get(first).copied().unwrap_or(*place_in_chart);
        match found.last_mut() {
            Some(last) if start <= last.end && 1 < rule.points() => last.end = place_in_chart + 1,
            _ => found.push(start..place_in_chart + 1),
        }
    }
    found
}
