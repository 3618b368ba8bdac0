//! Figures of a series: control charts, capability, gauge studies, trends and advice.
//!
//! Values come in as `f64` in one unit, which is that of every answer; the program uses millimetres. Every figure that is
//! estimated comes with its interval, and what is not defined is refused with a [`Reason`]. Nothing here reads a file,
//! starts a thread or asks for the time.
//!
//! | file | what |
//! |---|---|
//! | `reason` | why there is no figure |
//! | `moments` | count, mean and standard deviation of values; estimates with their intervals |
//! | `constants` | d2, d3 and c4 of control charts |
//! | `sigma` | the standard deviation within subgroups |
//! | `rules` | the rules of Nelson and of Western Electric |
//! | `chart` | charts of individuals, of means and ranges, of means and standard deviations |
//! | `signal` | what fires on a chart, as stretches of points |
//! | `weighted` | EWMA and CUSUM |
//! | `tolerance` | the limits of a feature |
//! | `capability` | what a process can do, by the normal law |
//! | `fitted` | the normal, lognormal, Weibull and folded normal law of given values |
//! | `shape` | whether values come from a law |
//! | `percentile` | what a process can do, by the percentiles of a law |
//! | `anova` | analysis of variance; the comparison of groups |
//! | `line` | a straight line through points |
//! | `trend` | where a series goes, and the offset of a tool |
//! | [`gauge`] | studies of gauges |
//! | [`picture`] | charts as drawings |
//! | [`round`] | round numbers of axes and scales |
//! | `advice` | what a person does with the figures, in sentences |
//!
//! To add a statistic or a chart:
//!
//! 1. Write a file with its function and what it answers, and its lines here. What is estimated is an [`Estimate`], what is not defined a
//!    [`Reason`], and the doc comment names the source of the formula.
//! 2. Test it in `tests/statistics` against published figures, and its interval against simulated series.
//! 3. `fitcheck stats` shows it: `crates/exchange/src/series/figures.rs`. A rule of charts is a variant of [`Rule`] with its place in `rules.rs`.
//! 4. What a reader must know of its source stands in `docs/SOURCES.md`; sentences stand in `statistics.ftl` in every folder of `assets/locales`.
//!
//! ```
//! use fitcheck_statistics::{ChartKind, ChartPlan, Sample, chart};
//!
//! let samples = [10.0, 12.0, 11.0, 13.0, 12.0].map(|value| Sample::of(vec![value]));
//! let drawn = chart(&samples, &ChartPlan::of(ChartKind::Individuals))?;
//! assert!((drawn.stages[0].sigma.value - 1.329_340_388_179_137).abs() < 1e-12);
//! # Ok::<(), fitcheck_statistics::Reason>(())
//! ```

#![warn(missing_docs)]

pub mod gauge;
pub mod picture;
pub mod round;

mod advice;
mod anova;
mod capability;
mod chart;
mod constants;
mod fitted;
mod line;
mod moments;
mod percentile;
mod reason;
mod rules;
mod shape;
mod sigma;
mod signal;
mod tolerance;
mod trend;
mod weighted;

pub use advice::{Advice, ENOUGH_POINTS, ENOUGH_VALUES, probability};
pub use anova::{GroupMean, Groups, Ratio, Row, compare};
pub use capability::{Capability, CapabilityPlan, Degrees, Indices, Side, capability};
pub use chart::{Baseline, Chart, ChartKind, ChartPlan, ChartPoint, Point, Sample, Stage, StageFigures, chart};
pub use constants::{LARGEST_RANGE, c4, d2, d3};
pub use fitted::{Family, Fitted, Law};
pub use line::{Coefficient, Line};
pub use moments::{Estimate, Moments, count, median};
pub use percentile::{Percentiles, percentiles};
pub use reason::Reason;
pub use rules::{Rule, Rules, RulesIter, Scanner};
pub use shape::{AndersonDarling, anderson_darling};
pub use sigma::{Method, Sigma};
pub use signal::{Place, Signal, signals};
pub use tolerance::Tolerance;
pub use trend::{Offset, Reach, Trend, offset, trend};
pub use weighted::{Cusum, CusumPoint, Ewma, EwmaPoint, MemoryPoint};
