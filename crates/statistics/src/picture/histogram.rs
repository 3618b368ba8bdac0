//! How often values are, beside the curve of a law: values upwards, counts to the right.
//!
//! The width of a bar is that of Scott, 3.49 s / ∛n (Biometrika 66 (1979), 605), rounded down to 1, 2 or 5 times a power of ten, and at least
//! the step in which values are given, so that no bar is empty for that.

use fitcheck_core::length::Length;

use super::plot::Plot;
use super::scale::{Scale, place};
use super::{Anchor, Picture, Tone, View};
use crate::fitted::Fitted;
use crate::moments::{Moments, count};
use crate::round::{round_down, round_up};
use crate::tolerance::Tolerance;

/// So many bars at most, whatever the values.
const MOST_BARS: f64 = 400.0;

/// The histogram, with the curve of a law where one fits; empty where it has no room.
pub fn histogram(values: &[f64], law: Option<&Fitted>, tolerance: Option<&Tolerance>, view: &View<'_>) -> Picture {
    let width = bar(values, view.values);
    let [from, to] = view.values;
    let first = ((from - view.base) / width).floor();
    let bars = bars(values, view.base, width, first, ((to - from) / width).ceil() + 1.0);
    let curve: Vec<(f64, f64)> = law.map(|law| expected(law, values.len(), width, view.values)).unwrap_or_default();
    let most = count(bars.iter().copied().max().unwrap_or_default()).max(1.0);
    let most = curve.iter().fold(most, |most, (_, expected)| most.max(*expected));
    let Some(mut plot) = Plot::new(view, [0.0, most * 1.08], false) else { return Picture::default() };
    plot.limits(tolerance, false);
    for (number, many) in bars.iter().enumerate().filter(|(_, many)| 0 < **many) {
        let low = (first + place(number)).mul_add(width, view.base);
        let [below, top] = [low.max(from), (low + width).min(to)].map(|value| plot.values.at(value));
        if 0.0 < below - top {
            plot.picture.area(
                [plot.across.places[0], top + 0.5],
                [plot.across.at(count(*many)), below - 0.5],
                Tone::Bar,
            );
        }
    }
    if !curve.is_empty() {
        let curve = curve.iter().map(|(value, expected)| [plot.across.at(*expected), plot.values.at(*value)]);
        let curve = curve.collect();
        plot.picture.line(curve, Tone::Law, 1.5);
    }
    axis(&mut plot);
    plot.finish()
}

/// How many values a law has in a bar about each of many places.
fn expected(law: &Fitted, values: usize, width: f64, [from, to]: [f64; 2]) -> Vec<(f64, f64)> {
    let below = |value: f64| law.law.tails(value).below;
    let places = (0..=200_u32).map(|step| from + (to - from) * f64::from(step) / 200.0);
    let of = |value: f64| (value, (below(value + width / 2.0) - below(value - width / 2.0)) * count(values));
    places.map(of).filter(|(_, expected)| expected.is_finite()).collect()
}

/// The width of a bar.
fn bar(values: &[f64], [from, to]: [f64; 2]) -> f64 {
    let deviation = Moments::of(values).and_then(|of| of.deviation()).unwrap_or_default();
    let scott = round_down(3.49 * deviation / libm::cbrt(count(values.len().max(1))));
    let least = round_up((to - from).max(1e-6) / MOST_BARS);
    let wide = scott.max(least).max(1e-6);
    let step = resolution(values);
    // A whole number of steps: bars of unequal numbers of possible values would show waves that are none.
    (wide / step).round().max(1.0) * step
}

/// The step in which values are given: a power of ten of nanometres, up to a millimetre.
fn resolution(values: &[f64]) -> f64 {
    let is_step = |step: i64| {
        let is_multiple = |value: &f64| Length::from_mm_f64(*value).is_ok_and(|value| value.nanometres() % step == 0);
        values.iter().all(is_multiple)
    };
    let steps = [1_000_000, 100_000, 10_000, 1_000, 100, 10];
    let step = steps.into_iter().find(|step| is_step(*step)).unwrap_or(1);
    Length::constant(step).to_mm_f64()
}

/// How many values each bar has.
#[expect(
    clippy::as_conversions,
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "below the number of bars"
)]
fn bars(values: &[f64], base: f64, width: f64, first: f64, number: f64) -> Vec<usize> {
    let number = number.clamp(1.0, MOST_BARS * 4.0) as usize;
    let mut bars = vec![0; number];
    for value in values {
        // A value on the edge belongs to the bar above it, whatever the last bits say.
        let at = ((value - base) / width + 1e-7).floor() - first;
        if 0.0 <= at
            && let Some(bar) = bars.get_mut(at as usize)
        {
            *bar += 1;
        }
    }
    bars
}

/// The counts below.
fn axis(plot: &mut Plot<'_>) {
    let scale: Scale = plot.across;
    let (_, ticks) = scale.ticks(60.0);
    let y = plot.values.places[0] + 14.0;
    for tick in ticks.into_iter().filter(|tick| tick.fract().abs() < 1e-9) {
        let text = plot.words.number(&format!("{tick:.0}"));
        plot.picture.text([scale.at(tick), y], Anchor::Middle, Tone::Quiet, text);
    }
    let ([left, top], [_, below]) = plot.field();
    plot.picture.line(vec![[left, top], [left, below]], Tone::Text, 1.0);
}
