//! Values to places, and the values that an axis names.

use fitcheck_core::words::Words;

use crate::moments::count;
use crate::round::round_up;

/// Values from one end to the other, and the places of both ends.
#[derive(Debug, Clone, Copy)]
pub(super) struct Scale {
    pub(super) values: [f64; 2],
    pub(super) places: [f64; 2],
}

impl Scale {
    /// Values that are equal have the middle.
    pub(super) fn at(&self, value: f64) -> f64 {
        let [from, to] = self.values;
        let [start, end] = self.places;
        if to <= from { f64::midpoint(start, end) } else { start + (value - from) / (to - from) * (end - start) }
    }

    /// Whether a value has a place between both ends.
    pub(super) fn has(&self, value: f64) -> bool {
        self.values[0] <= value && value <= self.values[1]
    }

    /// Round values, about so many apart from each other as fit with this distance between their places.
    pub(super) fn ticks(&self, distance: f64) -> (f64, Vec<f64>) {
        let [from, to] = self.values;
        let most = ((self.places[1] - self.places[0]).abs() / distance).max(1.0);
        let step = round_up((to - from) / most);
        if !(0.0 < step && step.is_finite()) {
            return (1.0, vec![from]);
        }
        let first = (from / step).ceil();
        let number = ((to / step).floor() - first).clamp(0.0, 1_000.0);
        let numbers = (0..=1_000_u32).map(f64::from).take_while(|at| *at <= number);
        (step, numbers.map(|at| (first + at) * step).collect())
    }
}

/// How many decimals values have that are so far apart.
pub(super) fn decimals(step: f64) -> usize {
    [1.0, 0.1, 0.01, 0.001].into_iter().position(|unit| unit <= step * (1.0 + 1e-9)).unwrap_or(3)
}

/// A number with a sign, and zero without one.
pub(super) fn signed(value: f64, decimals: usize, words: &Words) -> String {
    let plain = format!("{value:+.decimals$}");
    let is_zero = !plain.contains(|c: char| ('1'..='9').contains(&c));
    words.number(if is_zero { plain.trim_start_matches(['+', '-']) } else { &plain })
}

/// The place of a number in a series.
pub(super) fn place(number: usize) -> f64 {
    count(number)
}
