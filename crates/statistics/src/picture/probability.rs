//! Values in order against the shares of a law: on its line they come from it.
//!
//! Upwards is the normal quantile of the share, (i − 0.3) / (n + 0.4) for the value with rank i (Benard's approximation of the median rank). The band is
//! the interval of the law's own quantiles at the given level, by the delta method; values scatter more than that at both ends.

use fitcheck_core::words::Words;

use super::plot::{Plot, decimals_of, micrometres};
use super::scale::{Scale, decimals, place, signed};
use super::{Anchor, Mark, Picture, Spot, Tone, View};
use crate::fitted::Fitted;
use crate::moments::count;
use crate::tolerance::Tolerance;
use fitcheck_core::law::normal_quantile;

/// Shares that the axis names.
const SHARES: [f64; 9] = [0.0001, 0.001, 0.01, 0.1, 0.5, 0.9, 0.99, 0.999, 0.9999];
/// Of more values only some are drawn.
const ALL: usize = 2_000;
/// Points nearer than this are drawn once.
const CLOSE: f64 = 1.0;

/// The probability plot of values for a law; empty where it has no room. Spots have the places of the values in `values`.
pub fn probability_plot(
    values: &[f64],
    law: Option<&Fitted>,
    tolerance: Option<&Tolerance>,
    level: f64,
    view: &View<'_>,
) -> Picture {
    let mut order: Vec<(f64, usize)> = values.iter().copied().zip(0..).collect();
    order.sort_unstable_by(|(one, _), (other, _)| one.total_cmp(other));
    let share = |rank: usize| (place(rank) + 0.7) / (count(values.len()) + 0.4);
    let edge = normal_quantile(share(0)).abs().max(1.0) * 1.15;
    let view = View { values: [-edge, edge], ..view.clone() };
    let range = across([order.first(), order.last()].map(|end| end.map(|(value, _)| *value)));
    let Some(mut plot) = Plot::new(&view, range, false) else { return Picture::default() };
    let limits = tolerance.map_or([None, None], |tolerance| [tolerance.lower(), tolerance.upper()]);
    let limits: Vec<f64> = limits.into_iter().flatten().filter(|limit| plot.across.has(*limit)).collect();
    axes(&mut plot, &view, &limits);
    if let Some(law) = law {
        curve(&mut plot, law, level, edge);
    }
    for limit in limits {
        let ([_, top], [_, below]) = plot.field();
        let x = plot.across.at(limit);
        plot.picture.line(vec![[x, top], [x, below]], Tone::Limit, 2.0);
        let from_base = micrometres(limit - view.base);
        let text = signed(from_base, decimals_of(from_base), view.words);
        plot.picture.bold([x, below + 14.0], Anchor::Middle, Tone::Text, text);
    }
    let mut last = [f64::NEG_INFINITY; 2];
    for rank in ranks(values.len(), edge) {
        let Some((value, number)) = order.get(rank) else { continue };
        let at = [plot.across.at(*value), plot.values.at(normal_quantile(share(rank)))];
        if CLOSE <= (at[0] - last[0]).abs().max((at[1] - last[1]).abs()) {
            plot.picture.dot(at, 3.0, Tone::Data);
            plot.picture.spots.push(Spot { number: *number, at });
            last = at;
        }
    }
    plot.finish()
}

/// The ranks that are drawn: of many values those that are a step apart on the axis of shares, which has every one at both ends.
fn ranks(values: usize, edge: f64) -> Vec<usize> {
    if values <= ALL {
        return (0..values).collect();
    }
    let steps = (0..=800_u32).map(|step| (f64::from(step) / 400.0 - 1.0) * edge);
    let mut ranks: Vec<usize> =
        steps.map(|quantile| rank_of(fitcheck_core::law::normal(quantile).below, values)).collect();
    ranks.dedup();
    ranks
}

#[expect(
    clippy::as_conversions,
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "a rank of a value"
)]
fn rank_of(share: f64, values: usize) -> usize {
    let rank = (share * (count(values) + 0.4) - 0.7).round().clamp(0.0, count(values - 1));
    rank as usize
}

fn across(ends: [Option<f64>; 2]) -> [f64; 2] {
    let [Some(least), Some(greatest)] = ends else { return [0.0, 1.0] };
    let margin = ((greatest - least) * 0.25).max(1e-6);
    [least - margin, greatest + margin]
}

/// The room of a name below the axis.
const NAME: f64 = 40.0;

/// Shares upwards, lengths to the right; limits have their own names.
fn axes(plot: &mut Plot<'_>, view: &View<'_>, limits: &[f64]) {
    let ([left, _], [right, below]) = plot.field();
    for share in SHARES {
        let quantile = normal_quantile(share);
        if plot.values.has(quantile) {
            let y = plot.values.at(quantile);
            plot.picture.line(vec![[left, y], [right, y]], Tone::Grid, 1.0);
            plot.picture.text([left - 8.0, y], Anchor::End, Tone::Quiet, percent(share, view.words));
        }
    }
    let of = |value: f64| micrometres(value - view.base);
    let scale = Scale { values: plot.across.values.map(of), places: plot.across.places };
    let (step, ticks) = scale.ticks(80.0);
    let is_free = |tick: &f64| limits.iter().all(|limit| NAME <= (plot.across.at(*limit) - scale.at(*tick)).abs());
    for tick in ticks.into_iter().filter(is_free).collect::<Vec<_>>() {
        let text = signed(tick, decimals(step), view.words);
        plot.picture.text([scale.at(tick), below + 14.0], Anchor::Middle, Tone::Quiet, text);
    }
}

fn percent(share: f64, words: &Words) -> String {
    let percent = share * 100.0;
    let is_whole = (percent - percent.round()).abs() < 1e-6;
    let text =
        if is_whole { format!("{percent:.0}") } else { format!("{percent:.2}").trim_end_matches('0').to_owned() };
    format!("{} %", words.number(&text))
}

/// The line of the law, within its band.
fn curve(plot: &mut Plot<'_>, law: &Fitted, level: f64, edge: f64) {
    let mut line = Vec::new();
    let mut sides = [Vec::new(), Vec::new()];
    for step in 0..=60_u32 {
        let quantile = (f64::from(step) / 30.0 - 1.0) * edge;
        let share = fitcheck_core::law::normal(quantile).below;
        let value = law.law.quantile(share);
        let y = plot.values.at(quantile);
        if value.is_finite() && plot.across.has(value) {
            line.push([plot.across.at(value), y]);
        }
        if let Ok(estimate) = law.estimate(level, |law| law.quantile(share)) {
            let [from, to] = plot.across.values;
            for (side, end) in sides.iter_mut().zip([estimate.lower, estimate.upper]) {
                side.push([plot.across.at(end.clamp(from, to)), y]);
            }
        }
    }
    let [mut band, mut back] = sides;
    back.reverse();
    band.append(&mut back);
    if 2 < band.len() {
        plot.picture.marks.push(Mark::Shape { points: band, tone: Tone::Band });
    }
    plot.picture.line(line, Tone::Law, 1.5);
}
