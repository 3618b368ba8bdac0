//! Averages or sums that remember, in their order, with their limits.

use fitcheck_core::message::message;

use super::plot::Plot;
use super::run::{ends, numbers, thinned, with_margin};
use super::scale::place;
use super::{Picture, Spot, Tone, View};
use crate::weighted::MemoryPoint;

/// So many points beyond the limits are marked.
const MOST_MARKED: usize = 200;

/// The chart of averages, or of sums: those of what is above the mean upwards, of what is below it downwards. Points have numbers from 1.
/// Empty where it has no room.
pub fn memory_chart(points: &[(usize, MemoryPoint)], view: &View<'_>) -> Picture {
    let is_shown = |(number, _): &&(usize, MemoryPoint)| view.points.contains(&(number - 1));
    let shown: Vec<(usize, MemoryPoint)> = points.iter().filter(is_shown).copied().collect();
    let lines = |point: &MemoryPoint| match *point {
        MemoryPoint::Average(of) => [of.value, of.value, of.lower, of.upper],
        MemoryPoint::Sums(of) => [of.above, -of.below, -of.interval, of.interval],
    };
    let values = with_margin(shown.iter().flat_map(|(_, point)| lines(point)));
    let has_sums = matches!(shown.first(), Some((_, MemoryPoint::Sums(_))));
    let view = View { values, base: if has_sums { 0.0 } else { view.base }, ..view.clone() };
    let Some(mut plot) = Plot::new(&view, ends(&view.points), true) else { return Picture::default() };
    plot.limits(None, false);
    let line = |plot: &Plot<'_>, of: fn([f64; 4]) -> f64| {
        let spots = shown.iter().map(|(number, point)| {
            let number = number - 1;
            Spot { number, at: [plot.across.at(place(number)), plot.values.at(of(lines(point)))] }
        });
        thinned(plot, shown.len(), spots)
    };
    let at = |spots: &[Spot]| spots.iter().map(|spot| spot.at).collect::<Vec<_>>();
    let limits = [line(&plot, |[_, _, lower, _]| lower), line(&plot, |[_, _, _, upper]| upper)];
    for limit in limits {
        plot.picture.dashed(at(&limit), Tone::Control, 1.5);
    }
    let [first, second] = [line(&plot, |[first, ..]| first), line(&plot, |[_, second, ..]| second)];
    if has_sums {
        let level = plot.level(0.0);
        plot.picture.line(level, Tone::Centre, 1.5);
        plot.picture.line(at(&second), Tone::Data, 1.0);
    }
    plot.picture.line(at(&first), Tone::Data, 1.0);
    for (number, point) in shown.iter().filter(|(_, point)| point.is_out()).take(MOST_MARKED) {
        let [one, other, ..] = lines(point);
        let value = if one.abs() < other.abs() { other } else { one };
        let at = [plot.across.at(place(number - 1)), plot.values.at(value)];
        plot.picture.ring(at, 4.0, Tone::Text);
    }
    plot.picture.spots = first;
    numbers(&mut plot, &view);
    if let Some((_, last)) = shown.last() {
        let [.., lower, upper] = lines(last);
        let text = plot.deviation_text(upper);
        plot.label(upper, view.words.say(&message!("statistics-chart-upper").text("size", text)));
        let text = plot.deviation_text(lower);
        plot.label(lower, view.words.say(&message!("statistics-chart-lower").text("size", text)));
    }
    plot.finish()
}
