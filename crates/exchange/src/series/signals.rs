//! Signals: the patterns that rules find on a chart, each with the points that it stretches over.

use fitcheck_statistics::{Chart, ChartPoint, Rule};

/// A pattern that a rule finds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Signal {
    /// The rule.
    pub rule: Rule,
    /// Whether it is found on moving ranges, ranges or standard deviations, and not on values or means.
    pub is_of_spread: bool,
    /// The first point of the pattern, from 0.
    pub first: usize,
    /// The last point at which the rule fires.
    pub last: usize,
}

/// All patterns, the earliest first. Where a rule fires at one point after another, that is one pattern.
pub fn signals(chart: &Chart) -> Vec<Signal> {
    let counted: Vec<usize> =
        (0..).zip(&chart.points).filter(|(_, point)| point.left_out.is_none()).map(|(at, _)| at).collect();
    let mut found = Vec::new();
    for is_of_spread in [false, true] {
        for rule in Rule::ALL {
            let mut open: Option<Signal> = None;
            for (number, at) in counted.iter().enumerate() {
                if !chart.points.get(*at).is_some_and(|point| fires(point, rule, is_of_spread)) {
                    found.extend(open.take());
                    continue;
                }
                let first = counted.get((number + 1).saturating_sub(rule.points())).copied().unwrap_or(*at);
                let of = open.get_or_insert(Signal { rule, is_of_spread, first, last: *at });
                of.last = *at;
            }
            found.extend(open);
        }
    }
    found.sort_by_key(|signal| (signal.last, signal.first, signal.is_of_spread));
    found
}

fn fires(point: &ChartPoint, rule: Rule, is_of_spread: bool) -> bool {
    let place = if is_of_spread { point.spread } else { Some(point.location) };
    place.is_some_and(|place| place.fired.has(rule))
}
