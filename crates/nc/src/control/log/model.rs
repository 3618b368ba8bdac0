//! Values on the way to a log: differences, limits about a nominal value, figures as printed.

use fitcheck_core::length::{Length, Unit};
use fitcheck_core::words::Dialogue;
use jiff::civil::Time;

use super::labels::Labels;
use super::{Figure, Further, LimitPair, Log};

/// Decimals of a log's figures, for millimetres and inches: as in the maker's published log; for inches our rule.
pub(super) const DECIMALS: usize = 4;

impl Log {
    /// A log to be written: day, time, program and further results are still empty; these fields are public.
    pub const fn new(cycle: u16, figures: Vec<Figure>, unit: Unit) -> Self {
        Self {
            line: 1,
            cycle,
            title: String::new(),
            date: None,
            time: None,
            program: None,
            unit,
            figures,
            further: Vec::new(),
            is_simulated: false,
            warnings: Vec::new(),
        }
    }

    /// The log that results when this one is written in a language and read back: every figure rounded half away from
    /// zero to four decimals of its unit (0.1 µm, or 0.0001 inch = 2.54 µm), whole seconds, the language's own title.
    ///
    /// The verdict of a log follows from its own limits: if a figure is finer than the log prints, this verdict may
    /// differ from that of the measurement. Compare the two before relying on the file.
    #[must_use]
    pub fn printed(&self, language: Dialogue) -> Self {
        let labels = Labels::of(language);
        let round = |length: Length| on_grid(length, self.unit);
        let pair = |pair: LimitPair| LimitPair { maximum: round(pair.maximum), minimum: round(pair.minimum) };
        let figure = |figure: &Figure| Figure {
            nominal: figure.nominal.map(round),
            limits: figure.limits.map(pair),
            actual: round(figure.actual),
            deviation: figure.deviation.map(round),
        };
        Self {
            // The log of a cycle without a title is not printed.
            title: labels.title(self.cycle).map_or_else(String::new, str::to_owned),
            date: self.date,
            time: self.time.map(whole_seconds),
            program: self.program.clone(),
            is_simulated: self.is_simulated,
            further: self.further.iter().map(|further| further.printed(labels)).collect(),
            ..Self::new(self.cycle, self.figures.iter().map(figure).collect(), self.unit)
        }
    }
}

impl Figure {
    /// A measured value with its nominal value; `None` beyond [`Length::MAX`].
    pub fn of(nominal: Length, limits: Option<LimitPair>, actual: Length) -> Option<Self> {
        Some(Self { nominal: Some(nominal), limits, actual, deviation: Some(actual.checked_sub(nominal)?) })
    }

    /// A measured value without a nominal value.
    pub const fn bare(limits: Option<LimitPair>, actual: Length) -> Self {
        Self { nominal: None, limits, actual, deviation: None }
    }
}

impl LimitPair {
    /// Limits symmetrical about a nominal value, as Q279 and Q280 set them for the centre: a tolerance of 0 means that
    /// the axis is not monitored. `None` for a negative tolerance and beyond [`Length::MAX`].
    pub fn about(nominal: Length, tolerance: Length) -> Option<Self> {
        if tolerance < Length::ZERO {
            return None;
        }
        Some(Self { maximum: nominal.checked_add(tolerance)?, minimum: nominal.checked_sub(tolerance)? })
    }
}

impl Further {
    /// The measuring height, with which every log ends.
    pub fn measuring_height(height: Length, unit: Unit, language: Dialogue) -> Self {
        let label = Labels::of(language).measuring_height.clone();
        Self { label, value: height.rounded(unit, DECIMALS) }
    }

    /// The result as printed: the measuring height gets its name in the log's language, a number gets a point.
    pub(super) fn printed(&self, labels: &Labels) -> Self {
        let known = Dialogue::ALL.map(|language| &Labels::of(language).measuring_height);
        let label = if known.contains(&&self.label) { &labels.measuring_height } else { &self.label };
        let is_number = Length::parse_in(&self.value, Unit::Millimetre).is_ok();
        let value = if is_number { self.value.replace(',', ".") } else { self.value.clone() };
        Self { label: label.clone(), value }
    }
}

/// The printed length. A length beyond [`Length::MAX`] stays unchanged, and is an error when it is read back.
fn on_grid(length: Length, unit: Unit) -> Length {
    Length::parse_in(&length.rounded(unit, DECIMALS), unit).unwrap_or(length)
}

fn whole_seconds(time: Time) -> Time {
    Time::new(time.hour(), time.minute(), time.second(), 0).unwrap_or(time)
}
