//! The ground of a chart: its field, the lines of its axes, and the labels beside it.

use fitcheck_core::message::message;
use fitcheck_core::words::Words;

use super::scale::{Scale, decimals, place, signed};
use super::{Anchor, Picture, Tone, View};
use crate::tolerance::Tolerance;

/// Room for the numbers of the axis of values.
const LEFT: f64 = 52.0;
/// Room for the labels of lines.
const RIGHT: f64 = 116.0;
/// Room above, and for the numbers below.
const TOP: f64 = 8.0;
const BELOW: f64 = 26.0;
/// Labels are at least so far apart.
const LINE: f64 = 16.0;

/// A field with values upwards; what is to the right depends on the chart.
pub(super) struct Plot<'a> {
    pub(super) picture: Picture,
    pub(super) across: Scale,
    pub(super) values: Scale,
    pub(super) words: &'a Words,
    /// The upper and the lower end of what is between the limits of size.
    pub(super) inner: [f64; 2],
    base: f64,
    labels: Vec<(f64, bool, String)>,
}

/// Micrometres of millimetres.
pub(super) fn micrometres(mm: f64) -> f64 {
    mm * 1_000.0
}

impl<'a> Plot<'a> {
    /// A field for what is shown; `None` where there is no room for it. Labels are beside it where they have room.
    pub(super) fn new(view: &View<'a>, across: [f64; 2], has_labels: bool) -> Option<Self> {
        let [width, height] = view.size;
        if !(160.0 <= width && 100.0 <= height) {
            return None;
        }
        let right = if has_labels && 320.0 <= width { width - RIGHT } else { width - 12.0 };
        let mut plot = Self {
            picture: Picture { size: view.size, ..Picture::default() },
            across: Scale { values: across, places: [LEFT, right] },
            values: Scale { values: view.values, places: [height - BELOW, TOP] },
            words: view.words,
            inner: [TOP + 2.0, height - BELOW - 2.0],
            base: view.base,
            labels: Vec::new(),
        };
        let ([left, top], [right, below]) = plot.field();
        plot.picture.area([left, top], [right, below], Tone::Ground);
        Some(plot)
    }

    /// The upper left and the lower right corner of the field.
    pub(super) const fn field(&self) -> ([f64; 2], [f64; 2]) {
        let ([left, right], [below, top]) = (self.across.places, self.values.places);
        ([left, top], [right, below])
    }

    /// A line from left to right at a value.
    pub(super) fn level(&self, value: f64) -> Vec<[f64; 2]> {
        let [left, right] = self.across.places;
        let y = self.values.at(value);
        vec![[left, y], [right, y]]
    }

    /// The zone between the limits, the lines of the axis, and the limits.
    pub(super) fn limits(&mut self, tolerance: Option<&Tolerance>, has_sizes: bool) {
        let [from, to] = self.values.values;
        let ends = tolerance.map(|tolerance| [tolerance.lower(), tolerance.upper()]);
        if let Some([lower, upper]) = ends {
            let [left, right] = self.across.places;
            let y = |value: f64| self.values.at(value.clamp(from, to));
            let corners = [[left, y(upper.unwrap_or(to))], [right, y(lower.unwrap_or(from))]];
            self.picture.area(corners[0], corners[1], Tone::Zone);
            self.inner = [corners[0][1] + 4.0, corners[1][1] - 4.0];
        }
        let limits: Vec<f64> = ends.into_iter().flatten().flatten().collect();
        self.grid(&limits);
        let ids = ["statistics-chart-minimum", "statistics-chart-maximum"];
        for (limit, id) in ends.into_iter().flatten().zip(ids) {
            let Some(limit) = limit.filter(|limit| self.values.has(*limit)) else { continue };
            let line = self.level(limit);
            self.picture.line(line, Tone::Limit, 2.0);
            if has_sizes {
                let size = self.words.number(&format!("{limit:.3}"));
                let text = match id {
                    "statistics-chart-minimum" => message!("statistics-chart-minimum").text("size", size),
                    _ => message!("statistics-chart-maximum").text("size", size),
                };
                self.labels.push((self.values.at(limit), true, self.words.say(&text)));
            }
        }
    }

    /// The axis of values: round numbers in micrometres, with limits in bold.
    fn grid(&mut self, limits: &[f64]) {
        let of = |value: f64| micrometres(value - self.base);
        let [from, to] = self.values.values;
        let scale = Scale { values: [of(from), of(to)], places: self.values.places };
        let (step, ticks) = scale.ticks(34.0);
        let [left, right] = self.across.places;
        let limits: Vec<f64> = limits.iter().map(|limit| of(*limit)).filter(|limit| scale.has(*limit)).collect();
        for tick in ticks {
            let y = scale.at(tick);
            self.picture.line(vec![[left, y], [right, y]], Tone::Grid, 1.0);
            if limits.iter().all(|limit| LINE <= (scale.at(*limit) - y).abs()) {
                let text = signed(tick, decimals(step), self.words);
                self.picture.text([left - 8.0, y], Anchor::End, Tone::Quiet, text);
            }
        }
        for limit in limits {
            let text = signed(limit, decimals_of(limit), self.words);
            self.picture.bold([left - 8.0, scale.at(limit)], Anchor::End, Tone::Text, text);
        }
    }

    /// The axis of values of a figure that counts from zero.
    pub(super) fn grid_from_zero(&mut self) {
        self.base = 0.0;
        let [from, to] = self.values.values.map(micrometres);
        let scale = Scale { values: [from, to], places: self.values.places };
        let (step, ticks) = scale.ticks(34.0);
        let [left, right] = self.across.places;
        for tick in ticks {
            let y = scale.at(tick);
            self.picture.line(vec![[left, y], [right, y]], Tone::Grid, 1.0);
            let text = self.words.number(&format!("{:.*}", decimals(step), tick.abs()));
            self.picture.text([left - 8.0, y], Anchor::End, Tone::Quiet, text);
        }
    }

    /// The numbers below: those of points, counted from 1.
    pub(super) fn numbers(&mut self) {
        let [first, last] = self.across.values;
        let shown = Scale { values: [first + 1.0, last + 1.0], places: self.across.places };
        let (_, ticks) = shown.ticks(90.0);
        let y = self.values.places[0] + 14.0;
        let [_, end] = shown.places;
        let inner = ticks.into_iter().filter(|tick| tick.fract().abs() < 1e-9 && shown.at(*tick) < end - 30.0);
        let mut all: Vec<f64> =
            inner.filter(|tick| first + 1.0 < *tick && 36.0 < shown.at(*tick) - shown.places[0]).collect();
        all.extend([first + 1.0, last + 1.0]);
        all.dedup();
        for tick in all {
            let text = self.words.number(&format!("{tick:.0}"));
            self.picture.text([shown.at(tick), y], Anchor::Middle, Tone::Quiet, text);
        }
    }

    /// A label beside the field, at a value.
    pub(super) fn label(&mut self, value: f64, text: String) {
        self.labels.push((self.values.at(value), false, text));
    }

    /// A length from the base, with one decimal more than a micrometre needs.
    pub(super) fn deviation_text(&self, value: f64) -> String {
        signed(micrometres(value - self.base), 1, self.words)
    }

    /// The drawing, with its labels beside it: none over another.
    pub(super) fn finish(mut self) -> Picture {
        let [_, right] = self.across.places;
        if self.picture.size[0] - right < RIGHT {
            return self.picture;
        }
        self.labels.sort_by(|one, other| one.0.total_cmp(&other.0));
        let mut next = f64::NEG_INFINITY;
        let below = self.picture.size[1] - LINE / 2.0;
        // Those that are pushed down have room for those after them.
        let room = |at: usize| below - LINE * place(self.labels.len().saturating_sub(at + 1));
        let placed: Vec<f64> = (0..)
            .zip(&self.labels)
            .map(|(at, (y, ..))| {
                let y = y.max(next).min(room(at));
                next = y + LINE;
                y
            })
            .collect();
        for (y, (_, is_bold, text)) in placed.into_iter().zip(std::mem::take(&mut self.labels)) {
            let at = [right + 8.0, y];
            if is_bold {
                self.picture.bold(at, Anchor::Start, Tone::Text, text);
            } else {
                self.picture.text(at, Anchor::Start, Tone::Text, text);
            }
        }
        self.picture
    }
}

/// How many decimals a limit in micrometres needs.
pub(super) fn decimals_of(um: f64) -> usize {
    let is_whole = |value: f64| (value - value.round()).abs() < 1e-6;
    [1.0, 10.0, 100.0].into_iter().position(|scale| is_whole(um * scale)).unwrap_or(3)
}
