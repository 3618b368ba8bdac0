//! Values or means in their order, with limits, control limits and signals; and their spread.

use std::ops::Range;

use fitcheck_core::message::message;

use super::plot::Plot;
use super::scale::place;
use super::{Anchor, Picture, Spot, Tone, View};
use crate::chart::{Chart, ChartPoint, Point};
use crate::signal::{Place, Signal};
use crate::tolerance::Tolerance;

/// Points nearer than this are drawn together.
const CLOSE: f64 = 2.5;
/// So many patterns of a rule are marked.
const MOST_STRETCHES: usize = 200;

/// The least and the greatest value that has room: values that are shown, control limits and limits of size, with a margin.
pub fn value_range(chart: &Chart, tolerance: Option<&Tolerance>, points: &Range<usize>) -> [f64; 2] {
    let shown = chart.points.get(points.clone()).unwrap_or_default();
    let of_points = shown.iter().flat_map(|point| {
        let Point { value, lower, upper, .. } = point.location;
        [value, lower, upper]
    });
    let limits = tolerance.into_iter().flat_map(|tolerance| [tolerance.lower(), tolerance.upper()]).flatten();
    with_margin(of_points.chain(limits))
}

pub(super) fn with_margin(values: impl Iterator<Item = f64>) -> [f64; 2] {
    let ends = values.fold([f64::INFINITY, f64::NEG_INFINITY], |[from, to], value| [from.min(value), to.max(value)]);
    let [from, to] = ends;
    if !(from.is_finite() && to.is_finite()) {
        return [0.0, 0.001];
    }
    let margin = if from < to { (to - from) * 0.08 } else { 0.001 };
    [from - margin, to + margin]
}

/// The chart of values or means; empty where it has no room.
pub fn run_chart(chart: &Chart, tolerance: Option<&Tolerance>, signals: &[Signal], view: &View<'_>) -> Picture {
    let Some(mut plot) = Plot::new(view, ends(&view.points), true) else { return Picture::default() };
    plot.limits(tolerance, true);
    draw(&mut plot, chart, Place::Location, signals, view);
    if let Some(last) = last(chart, view).map(|point| point.location) {
        let words = view.words;
        let label = |plot: &Plot<'_>, value: f64| plot.deviation_text(value);
        let upper = message!("statistics-chart-upper").text("size", label(&plot, last.upper));
        plot.label(last.upper, words.say(&upper));
        let mean = message!("statistics-chart-mean").text("size", label(&plot, last.centre));
        plot.label(last.centre, words.say(&mean));
        let lower = message!("statistics-chart-lower").text("size", label(&plot, last.lower));
        plot.label(last.lower, words.say(&lower));
    }
    plot.finish()
}

/// The chart of moving ranges, ranges or standard deviations; empty where it has no room.
pub fn spread_chart(chart: &Chart, signals: &[Signal], view: &View<'_>) -> Picture {
    let shown = chart.points.get(view.points.clone()).unwrap_or_default();
    let spreads = || shown.iter().filter_map(|point| point.spread);
    let [_, most] = with_margin(spreads().flat_map(|point| [0.0, point.value, point.upper]));
    let view = View { values: [0.0, most.max(1e-9)], ..view.clone() };
    let Some(mut plot) = Plot::new(&view, ends(&view.points), true) else { return Picture::default() };
    plot.grid_from_zero();
    draw(&mut plot, chart, Place::Spread, signals, &view);
    if let Some(last) = spreads().next_back() {
        let number = |value: f64| view.words.number(&format!("{:.1}", value * 1_000.0));
        let upper = message!("statistics-chart-upper").text("size", number(last.upper));
        plot.label(last.upper, view.words.say(&upper));
        let mean = message!("statistics-chart-mean").text("size", number(last.centre));
        plot.label(last.centre, view.words.say(&mean));
    }
    plot.finish()
}

/// A little room on both sides of the points.
pub(super) fn ends(points: &Range<usize>) -> [f64; 2] {
    let last = place(points.end.saturating_sub(1));
    let first = place(points.start);
    let margin = ((last - first) * 0.01).max(0.5);
    [first - margin, last + margin]
}

fn last<'a>(chart: &'a Chart, view: &View<'_>) -> Option<&'a ChartPoint> {
    chart.points.get(view.points.clone()).and_then(<[_]>::last)
}

fn draw(plot: &mut Plot<'_>, chart: &Chart, of: Place, signals: &[Signal], view: &View<'_>) {
    let own = (1..).zip(signals).filter(|(_, signal)| signal.place == of);
    let own: Vec<(usize, &Signal)> = own.collect();
    frames(plot, chart, &own, view);
    control(plot, chart, of, view);
    let drawn = series(plot, chart, of, view);
    plot.picture.spots = drawn;
    rings(plot, chart, of, &own, view);
    numbers(plot, view);
}

pub(super) fn numbers(plot: &mut Plot<'_>, view: &View<'_>) {
    let margins = plot.across;
    let [first, last] = [view.points.start, view.points.end.saturating_sub(1)].map(place);
    // Only whole points are named.
    let places = [first, last].map(|point| margins.at(point));
    plot.across = super::scale::Scale { values: [first, last], places };
    plot.numbers();
    plot.across = margins;
}

/// Centre line and control limits of each stage; in steps where subgroups differ in size.
fn control(plot: &mut Plot<'_>, chart: &Chart, of: Place, view: &View<'_>) {
    for stage in &chart.stages {
        let shown = stage.points.start.max(view.points.start)..stage.points.end.min(view.points.end);
        let Some(points) = chart.points.get(shown.clone()) else { continue };
        let figures: [fn(&Point) -> f64; 3] = [|point| point.lower, |point| point.centre, |point| point.upper];
        for (at, figure) in figures.into_iter().enumerate() {
            let mut line: Vec<[f64; 2]> = Vec::new();
            for (number, point) in (shown.start..).zip(points) {
                let Some(value) = of.of(point).map(figure) else { continue };
                let y = plot.values.at(value);
                let [left, right] = [-0.5, 0.5].map(|half| plot.across.at(place(number) + half));
                match line.as_mut_slice() {
                    [.., last] if (last[1] - y).abs() < 1e-9 => last[0] = right,
                    _ => line.extend([[left, y], [right, y]]),
                }
            }
            // Nothing is drawn for a lower limit of 0 on a spread: it is the axis.
            let is_axis = of == Place::Spread
                && at == 0
                && points.iter().all(|point| of.of(point).is_none_or(|of| of.lower <= 0.0));
            if line.len() < 2 || is_axis {
                continue;
            }
            if at == 1 {
                plot.picture.line(line, Tone::Centre, 1.5);
            } else {
                plot.picture.dashed(line, Tone::Control, 1.5);
            }
        }
    }
}

/// The line through the points with a dot for each. Where points are close, the least and the greatest of each place are drawn. Points that are
/// left out stand alone, as circles.
fn series(plot: &mut Plot<'_>, chart: &Chart, of: Place, view: &View<'_>) -> Vec<Spot> {
    let points = chart.points.get(view.points.clone()).unwrap_or_default();
    let drawn = (view.points.start..).zip(points).filter_map(|(number, point)| {
        let at = [plot.across.at(place(number)), plot.values.at(of.of(point)?.value)];
        Some((Spot { number, at }, point.left_out.is_some()))
    });
    let (apart, counted): (Vec<_>, Vec<_>) = drawn.partition(|(_, is_left_out)| *is_left_out);
    for (spot, _) in &apart {
        plot.picture.ring(spot.at, 3.5, Tone::LeftOut);
    }
    let spot = |(spot, _): &(Spot, bool)| *spot;
    let mut spots = thinned(plot, points.len(), counted.iter().map(spot));
    let line: Vec<[f64; 2]> = spots.iter().map(|spot| spot.at).collect();
    if !is_close(plot, points.len()) {
        for at in &line {
            plot.picture.dot(*at, 3.0, Tone::Data);
        }
        spots.extend(apart.iter().map(spot));
        spots.sort_by_key(|spot| spot.number);
    }
    plot.picture.line(line, Tone::Data, 1.0);
    spots
}

/// Whether so many points are so close that those of a place are drawn together.
fn is_close(plot: &Plot<'_>, count: usize) -> bool {
    let [left, right] = plot.across.places;
    (right - left) / place(count.max(1)) < CLOSE
}

/// What is drawn of so many points: all of them, or the least and the greatest of each place where they are close.
pub(super) fn thinned(plot: &Plot<'_>, count: usize, points: impl Iterator<Item = Spot>) -> Vec<Spot> {
    if !is_close(plot, count) {
        return points.collect();
    }
    let mut spots: Vec<Spot> = Vec::new();
    let mut column: Option<(f64, [Spot; 2])> = None;
    for spot in points {
        let at = spot.at;
        let here = (at[0] / CLOSE).floor();
        match &mut column {
            Some((place, [high, low])) if (*place - here).abs() < 0.5 => {
                if at[1] < high.at[1] {
                    *high = spot;
                } else if low.at[1] < at[1] {
                    *low = spot;
                }
            }
            _ => {
                spots.extend(column.take().into_iter().flat_map(|(_, ends)| in_order(ends)));
                column = Some((here, [spot, spot]));
            }
        }
    }
    spots.extend(column.into_iter().flat_map(|(_, ends)| in_order(ends)));
    spots
}

/// The two ends of a column as they follow each other; one where both are the same.
fn in_order([one, other]: [Spot; 2]) -> impl Iterator<Item = Spot> {
    let (first, second) = if one.number <= other.number { (one, other) } else { (other, one) };
    [Some(first), (first.number != second.number).then_some(second)].into_iter().flatten()
}

/// Stretches of several points, with the number of their signal.
fn frames(plot: &mut Plot<'_>, chart: &Chart, signals: &[(usize, &Signal)], view: &View<'_>) {
    let [left, right] = plot.across.places;
    let [top, below] = plot.inner;
    for (number, signal) in signals.iter().filter(|(_, signal)| 1 < signal.rule.points()) {
        for stretch in signal.stretches.iter().filter(|of| touches(of, view)).take(MOST_STRETCHES) {
            let end = stretch.end.min(chart.points.len());
            let from = plot.across.at(place(stretch.start) - 0.4).max(left);
            let to = plot.across.at(place(end) - 0.6).min(right);
            let (from, to) = ([from, top], [to, below]);
            plot.picture.area(from, to, Tone::Signal);
            let corners = vec![from, [to[0], from[1]], to, [from[0], to[1]], from];
            plot.picture.dashed(corners, Tone::Control, 1.0);
            plot.picture.bold([from[0] + 6.0, top + 10.0], Anchor::Start, Tone::Text, number.to_string());
        }
    }
}

/// Single points at which a rule fires, with the number of their signal.
fn rings(plot: &mut Plot<'_>, chart: &Chart, of: Place, signals: &[(usize, &Signal)], view: &View<'_>) {
    for (number, signal) in signals.iter().filter(|(_, signal)| signal.rule.points() == 1) {
        for stretch in signal.stretches.iter().filter(|of| touches(of, view)).take(MOST_STRETCHES) {
            let Some(figure) = chart.points.get(stretch.start).and_then(|point| of.of(point)) else { continue };
            let at = [plot.across.at(place(stretch.start)), plot.values.at(figure.value)];
            plot.picture.ring(at, 8.0, Tone::Text);
            plot.picture.bold([at[0] + 12.0, at[1]], Anchor::Start, Tone::Text, number.to_string());
        }
    }
}

const fn touches(stretch: &Range<usize>, view: &View<'_>) -> bool {
    stretch.start < view.points.end && view.points.start < stretch.end
}
