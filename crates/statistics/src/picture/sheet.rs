//! The charts of a series on one sheet: values beside their histogram, their spread beside the probability plot, each with its title.

use fitcheck_core::message::message;
use fitcheck_core::words::Words;

use super::{
    Anchor, Mark, Picture, Tone, View, histogram, memory_chart, probability_plot, run_chart, spread_chart, value_range,
};
use crate::chart::{Chart, ChartKind};
use crate::fitted::{Family, Fitted};
use crate::shape::anderson_darling;
use crate::signal::signals;
use crate::tolerance::Tolerance;
use crate::weighted::MemoryPoint;

/// How wide and how high a sheet is.
const SIZE: [f64; 2] = [880.0, 660.0];
/// Room for a title.
const TITLE: f64 = 26.0;
const GAP: f64 = 20.0;
/// The share of the width that the first chart of a row has, and of the height that the first row has.
const FIRST: f64 = 0.72;
const UPPER: f64 = 0.56;

/// All charts of a series with its chart, its values, and what lengths are counted from; and the chart that remembers, where there is one.
pub fn sheet(
    chart: &Chart,
    values: &[f64],
    (tolerance, law): (Option<&Tolerance>, Family),
    (base, level): (f64, f64),
    memory: &[(usize, MemoryPoint)],
    words: &Words,
) -> Picture {
    let points = 0..chart.points.len();
    let range = value_range(chart, tolerance, &points);
    let fired = signals(chart);
    let [width, height] = SIZE;
    let upper = height * UPPER;
    let view = |width: f64, height: f64| View {
        size: [width, height - TITLE],
        points: points.clone(),
        values: range,
        base,
        words,
    };
    let mut sheet = Picture { size: SIZE, ..Picture::default() };
    let (first, rest) = (width * FIRST - GAP / 2.0, width * (1.0 - FIRST) - GAP / 2.0);
    let from_base = words.number(&format!("{base}"));
    let title = match chart.kind {
        ChartKind::Individuals => message!("statistics-chart-values").text("base", from_base),
        ChartKind::MeansRanges | ChartKind::MeansDeviations => {
            message!("statistics-chart-means").text("base", from_base)
        }
    };
    sheet.place([0.0, 0.0], words.say(&title), run_chart(chart, tolerance, &fired, &view(first, upper)));
    let fitted = Fitted::of(values, law);
    let drawn = histogram(values, fitted.as_ref().ok(), tolerance, &view(rest, upper));
    sheet.place([first + GAP, 0.0], words.get("statistics-chart-histogram"), drawn);
    let (half, below) = ((width - GAP) / 2.0, height - upper - GAP);
    let spread = match chart.kind {
        ChartKind::Individuals => words.get("statistics-chart-moving-range"),
        ChartKind::MeansRanges => words.get("statistics-chart-range"),
        ChartKind::MeansDeviations => words.get("statistics-chart-deviation"),
    };
    sheet.place([0.0, upper + GAP], spread, spread_chart(chart, &fired, &view(half, below)));
    let test = fitted.as_ref().map_err(Clone::clone).and_then(|fitted| anderson_darling(values, fitted));
    let title = match test {
        Ok(test) => {
            let statistic = words.number(&format!("{:.2}", test.statistic));
            let p = test.p.map_or_else(|| "–".to_owned(), |p| words.number(&format!("{p:.3}")));
            words.say(&message!("statistics-chart-probability-test").text("statistic", statistic).text("p", p))
        }
        Err(_) => words.get("statistics-chart-probability"),
    };
    let plot = probability_plot(values, fitted.as_ref().ok(), tolerance, level, &view(half, below));
    sheet.place([half + GAP, upper + GAP], title, plot);
    if let Some((_, first)) = memory.first() {
        let title = match first {
            MemoryPoint::Average(_) => words.get("statistics-chart-ewma"),
            MemoryPoint::Sums(_) => words.get("statistics-chart-cusum"),
        };
        sheet.place([0.0, height + GAP], title, memory_chart(memory, &view(width, below)));
        sheet.size[1] = height + GAP + below;
    }
    sheet
}

impl Picture {
    /// Puts a drawing below its title.
    fn place(&mut self, [x, y]: [f64; 2], title: String, drawn: Self) {
        self.bold([x + 4.0, y + TITLE / 2.0], Anchor::Start, Tone::Text, title);
        let by = [x, y + TITLE];
        let moved = |at: [f64; 2]| [at[0] + by[0], at[1] + by[1]];
        self.marks.extend(drawn.marks.into_iter().map(|mark| match mark {
            Mark::Area { from, to, tone } => Mark::Area { from: moved(from), to: moved(to), tone },
            Mark::Shape { points, tone } => Mark::Shape { points: points.into_iter().map(moved).collect(), tone },
            Mark::Line { points, tone, width, is_dashed } => {
                Mark::Line { points: points.into_iter().map(moved).collect(), tone, width, is_dashed }
            }
            Mark::Dot { at, radius, tone } => Mark::Dot { at: moved(at), radius, tone },
            Mark::Ring { at, radius, tone } => Mark::Ring { at: moved(at), radius, tone },
            Mark::Text { at, anchor, is_bold, tone, text } => Mark::Text { at: moved(at), anchor, is_bold, tone, text },
        }));
    }
}
