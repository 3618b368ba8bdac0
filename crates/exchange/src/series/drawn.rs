//! The charts of a feature as drawings.

use std::ops::Range;

use fitcheck_core::words::Words;
use fitcheck_statistics::picture::{
    Picture, View, histogram, memory_chart, probability_plot, run_chart, sheet, spread_chart, value_range,
};
use fitcheck_statistics::{Family, Reason, Signal, Tolerance};

use super::{Answer, Evaluated, Series, Wanted};

/// A chart.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Drawn {
    /// Values or means in their order.
    Run,
    /// Moving ranges, ranges or standard deviations.
    Spread,
    /// Averages or sums that remember, where they are asked for.
    Memory,
    Histogram,
    Probability,
}

/// How far beyond the values a chart goes, as a share of their width; and where all of them are equal, in millimetres.
const MARGIN: f64 = 0.08;
const LEAST: f64 = 0.001;

impl Answer {
    /// All charts of the series of this answer on one sheet. Lengths are counted from the nominal size in millimetres, or else from a limit or a value.
    ///
    /// # Errors
    /// Why there is no chart.
    pub fn sheet(&self, series: &Series<'_>, nominal: Option<f64>, words: &Words) -> Result<Picture, Reason> {
        let [lower, upper] = self.wanted.limits;
        let samples = self.wanted.samples(series);
        let now = self.wanted.stages().last().map_or(0, |stage| stage.first);
        let counted = samples.iter().skip(now).filter(|sample| sample.left_out.is_none());
        let values: Vec<f64> = counted.flat_map(|sample| &sample.values).copied().collect();
        let base = nominal.or(lower).or(upper).or(values.first().copied()).ok_or(Reason::Empty)?;
        self.sheet_of(&values, base, words)
    }

    /// The chart of values or means in a size. Lengths are counted from a limit, or else from the mean in whole micrometres.
    ///
    /// # Errors
    /// Why there is no chart.
    pub fn run_chart(&self, signals: &[Signal], size: [f64; 2], words: &Words) -> Result<Picture, Reason> {
        let chart = self.chart.as_ref().map_err(Clone::clone)?;
        let [lower, upper] = self.wanted.limits;
        let tolerance = Tolerance::new(lower, upper).ok();
        let tolerance = tolerance.as_ref();
        let centre = chart.points.first().map_or(0.0, |point| (point.location.centre * 1_000.0).round() / 1_000.0);
        let base = lower.or(upper).unwrap_or(centre);
        let points = 0..chart.points.len();
        let view = View { size, values: value_range(chart, tolerance, &points), points, base, words };
        Ok(run_chart(chart, tolerance, signals, &view))
    }

    fn sheet_of(&self, values: &[f64], base: f64, words: &Words) -> Result<Picture, Reason> {
        let Wanted { limits: [lower, upper], law, level, .. } = self.wanted;
        let chart = self.chart.as_ref().map_err(Clone::clone)?;
        let tolerance = Tolerance::new(lower, upper).ok();
        let of_law = (tolerance.as_ref(), law.unwrap_or(Family::Normal));
        let memory = self.memory.as_ref().map_or(&[][..], |memory| &memory.points);
        Ok(sheet(chart, values, of_law, (base, level), memory, words))
    }
}

impl Evaluated {
    /// All charts on one sheet.
    ///
    /// # Errors
    /// Why there is no chart.
    pub fn sheet(&self, words: &Words) -> Result<Picture, Reason> {
        self.answer.sheet_of(&self.values, self.base, words)
    }

    /// A chart of a size, of these points.
    ///
    /// # Errors
    /// Why there is none.
    pub fn drawn(&self, what: Drawn, size: [f64; 2], points: Range<usize>, words: &Words) -> Result<Picture, Reason> {
        let [lower, upper] = self.answer.wanted.limits;
        let tolerance = Tolerance::new(lower, upper).ok();
        let tolerance = tolerance.as_ref();
        let chart = self.answer.chart.as_ref().map_err(Clone::clone);
        let law = self.answer.fitted.as_ref().ok();
        let values = match &chart {
            Ok(chart) => value_range(chart, tolerance, &points),
            Err(_) => self.range()?,
        };
        let view = View { size, points, values, base: self.base, words };
        Ok(match what {
            Drawn::Run => run_chart(chart?, tolerance, &self.signals, &view),
            Drawn::Spread => spread_chart(chart?, &self.signals, &view),
            Drawn::Memory => {
                chart?;
                memory_chart(&self.answer.remembered()?.points, &view)
            }
            Drawn::Histogram => histogram(&self.values, law, tolerance, &view),
            Drawn::Probability => probability_plot(&self.values, law, tolerance, self.answer.wanted.level, &view),
        })
    }

    /// From where to where values and limits are.
    fn range(&self) -> Result<[f64; 2], Reason> {
        if self.values.is_empty() {
            return Err(Reason::Empty);
        }
        let all = self.values.iter().copied().chain(self.answer.wanted.limits.into_iter().flatten());
        let [from, to] = all.fold([f64::INFINITY, f64::NEG_INFINITY], |[from, to], at| [from.min(at), to.max(at)]);
        let margin = ((to - from) * MARGIN).max(LEAST);
        Ok([from - margin, to + margin])
    }
}
