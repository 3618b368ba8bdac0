//! Repeatability and reproducibility by analysis of variance (AIAG MSA; Montgomery; ISO/TR 12888).
//!
//! Crossed: every operator reads every part. The interaction of operators and parts is kept where it is significant, with a
//! probability of at most 5 % by default, and pooled with the repeatability elsewhere. Nested: every operator has parts of its
//! own, as where reading destroys them. Components of variance that come out negative are 0.

use crate::anova::{Ratio, Row};
use crate::moments::{Estimate, Moments, checked_level, count, parameter};
use crate::reason::Reason;
use fitcheck_core::law::chi_square_quantile;

/// How parts and operators go together.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Design {
    /// Every operator reads every part.
    Crossed,
    /// Every operator has parts of its own.
    Nested,
}

/// What is read before a result is believed: so many parts, operators and readings.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Layout {
    /// How parts and operators go together.
    pub design: Design,
    /// The parts; of each operator in a nested study.
    pub parts: usize,
    /// The operators, or whatever else changes between readings.
    pub operators: usize,
    /// The readings of a part by one operator.
    pub readings: usize,
}

/// How a study is evaluated.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StudyPlan {
    /// How many s a spread spans; 6.
    pub spread: f64,
    /// The probability up to which an interaction is kept; 0.05.
    pub keeps: f64,
    /// The level of the intervals.
    pub level: f64,
}

impl Default for StudyPlan {
    fn default() -> Self {
        Self { spread: 6.0, keeps: 0.05, level: 0.95 }
    }
}

/// A component of variance.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Component {
    /// The variance; 0 where it came out negative.
    pub variance: f64,
    /// Whether it came out negative.
    pub is_negative: bool,
}

impl Component {
    fn of(variance: f64) -> Self {
        Self { variance: variance.max(0.0), is_negative: variance < 0.0 }
    }

    /// The standard deviation.
    pub fn deviation(&self) -> f64 {
        self.variance.sqrt()
    }
}

/// What the variance of all readings is made of.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Components {
    /// The same part, read again.
    pub repeatability: Component,
    /// Other operators; 0 with one operator.
    pub operator: Component,
    /// Operators who differ more on some parts than on others; 0 where it is pooled.
    pub interaction: Component,
    /// Other parts.
    pub part: Component,
}

impl Components {
    /// The variance of the gauge: all but the parts.
    pub fn gauge(&self) -> f64 {
        self.repeatability.variance + self.operator.variance + self.interaction.variance
    }

    /// The variance of all readings.
    pub fn total(&self) -> f64 {
        self.gauge() + self.part.variance
    }
}

/// What a study found.
#[derive(Debug, Clone, PartialEq)]
pub struct Study {
    /// What was read.
    pub layout: Layout,
    /// The parts, in a nested study within operators.
    pub part: (Row, Ratio),
    /// The operators; `None` with one.
    pub operator: Option<(Row, Ratio)>,
    /// Their interaction with the parts, as it was before it was pooled; `None` with one operator and in nested studies.
    pub interaction: Option<(Row, Ratio)>,
    /// Whether the interaction is pooled with the repeatability.
    pub is_pooled: bool,
    /// The repeatability, with the interaction where it is pooled.
    pub repeatability: Row,
    /// The components of variance.
    pub components: Components,
    /// The standard deviation of the gauge. The interval is the modified large-sample one (Burdick and Larsen 1997; in nested
    /// studies without covariances).
    pub gauge: Estimate,
    /// The standard deviation of the repeatability.
    pub repeatability_deviation: Estimate,
    /// How many s a spread spans.
    spread: f64,
}

impl Study {
    /// The variance of the gauge in per cent of that of all readings.
    pub fn percent_contribution(&self) -> f64 {
        100.0 * self.components.gauge() / self.components.total()
    }

    /// The standard deviation of the gauge in per cent of that of all readings.
    pub fn percent_of_study(&self) -> f64 {
        100.0 * (self.components.gauge() / self.components.total()).sqrt()
    }

    /// The spread of the gauge in per cent of a tolerance of this width.
    pub fn percent_of_tolerance(&self, width: f64) -> Estimate {
        self.gauge.map(|deviation| 100.0 * self.spread * deviation / width)
    }

    /// How many classes of parts the gauge tells apart: 1.41 times the ratio of parts to gauge, whole, at least 1.
    pub fn categories(&self) -> f64 {
        (1.41 * (self.components.part.variance / self.components.gauge()).sqrt()).floor().max(1.0)
    }

    /// The smallest tolerance of which the spread of the gauge is at most this share: 0.1 is good, 0.3 the most that is accepted
    /// where it must be (AIAG MSA).
    pub fn smallest_tolerance(&self, share: f64) -> Estimate {
        self.gauge.map(|deviation| self.spread * deviation / share)
    }

    /// Whether operators differ more than parts do: then their columns may be swapped.
    pub fn may_be_swapped(&self) -> bool {
        self.components.part.variance < self.components.operator.variance
    }
}

/// A crossed study: readings by part, within it by operator.
///
/// # Errors
/// Fewer than two parts or two readings, no operator, cells of unequal size, readings that are no finite numbers or all
/// equal, parameters beyond their range.
pub fn crossed(parts: &[Vec<Vec<f64>>], plan: &StudyPlan) -> Result<Study, Reason> {
    let [outer, inner, readings] = checked(parts, plan, false)?;
    let layout = Layout { design: Design::Crossed, parts: outer, operators: inner, readings };
    let [p, o, r] = [outer, inner, readings].map(count);
    let all = Moments::of(&parts.concat().concat())?;
    let means = |groups: Vec<Vec<f64>>, size: f64| -> Result<f64, Reason> {
        let means = groups.iter().map(|group| Ok(Moments::of(group)?.mean)).collect::<Result<Vec<_>, _>>()?;
        Ok(Moments::of(&means)?.squares * size)
    };
    let by_operator = (0..inner)
        .map(|at| parts.iter().filter_map(|part| part.get(at)).flatten().copied().collect())
        .collect::<Vec<Vec<f64>>>();
    let part = Row { squares: means(parts.iter().map(|part| part.concat()).collect(), o * r)?, degrees: p - 1.0 };
    let operator = Row { squares: means(by_operator, p * r)?, degrees: o - 1.0 };
    let error = Row { squares: inside(parts)?, degrees: p * o * (r - 1.0) };
    let cells = means(parts.concat(), r)?;
    let interaction =
        Row { squares: (cells - part.squares - operator.squares).max(0.0), degrees: (p - 1.0) * (o - 1.0) };
    if all.squares <= 0.0 || error.squares <= 0.0 {
        return Err(Reason::AllEqual);
    }
    let interaction = (1 < inner).then(|| (interaction, interaction.against(&error)));
    let kept = interaction.filter(|(_, ratio)| ratio.p <= plan.keeps);
    let repeatability = match (interaction, kept) {
        (Some((row, _)), None) => row.pooled(&error),
        _ => error,
    };
    // What parts and operators are compared with.
    let base = kept.map_or(repeatability, |(row, _)| row);
    let operator = (1 < inner).then(|| (operator, operator.against(&base)));
    let [ms_part, ms_base, ms_error] = [part, base, repeatability].map(|row| row.mean_square());
    let components = Components {
        repeatability: Component::of(ms_error),
        operator: Component::of(operator.map_or(0.0, |(row, _)| (row.mean_square() - ms_base) / (p * r))),
        interaction: Component::of(kept.map_or(0.0, |(row, _)| (row.mean_square() - ms_error) / r)),
        part: Component::of((ms_part - ms_base) / (o * r)),
    };
    let terms = match (operator, kept) {
        (None, _) => vec![(1.0, repeatability)],
        (Some((operator, _)), None) => vec![(1.0 / (p * r), operator), (1.0 - 1.0 / (p * r), repeatability)],
        (Some((operator, _)), Some((interaction, _))) => {
            vec![(1.0 / (p * r), operator), ((p - 1.0) / (p * r), interaction), ((r - 1.0) / r, repeatability)]
        }
    };
    Ok(Study {
        layout,
        part: (part, part.against(&base)),
        operator,
        interaction,
        is_pooled: interaction.is_some() && kept.is_none(),
        repeatability,
        components,
        gauge: gauge_interval(components.gauge(), &terms, plan.level),
        repeatability_deviation: deviation_of(&repeatability, plan),
        spread: plan.spread,
    })
}

/// A nested study: readings by operator, within it by part.
///
/// # Errors
/// As those of a crossed one; a study with one operator is a crossed one.
pub fn nested(operators: &[Vec<Vec<f64>>], plan: &StudyPlan) -> Result<Study, Reason> {
    let [outer, inner, readings] = checked(operators, plan, true)?;
    let layout = Layout { design: Design::Nested, parts: inner, operators: outer, readings };
    let [o, p, r] = [outer, inner, readings].map(count);
    let mut part_squares = 0.0;
    let mut means = Vec::new();
    for operator in operators {
        let parts = operator.iter().map(|part| Ok(Moments::of(part)?.mean)).collect::<Result<Vec<_>, _>>()?;
        let parts = Moments::of(&parts)?;
        part_squares += parts.squares * r;
        means.push(parts.mean);
    }
    let operator = Row { squares: Moments::of(&means)?.squares * p * r, degrees: o - 1.0 };
    let part = Row { squares: part_squares, degrees: o * (p - 1.0) };
    let error = Row { squares: inside(operators)?, degrees: o * p * (r - 1.0) };
    if error.squares <= 0.0 {
        return Err(Reason::AllEqual);
    }
    let [ms_operator, ms_part, ms_error] = [operator, part, error].map(|row| row.mean_square());
    let components = Components {
        repeatability: Component::of(ms_error),
        operator: Component::of((ms_operator - ms_part) / (p * r)),
        interaction: Component::of(0.0),
        part: Component::of((ms_part - ms_error) / r),
    };
    let terms = [(1.0 / (p * r), operator), (-1.0 / (p * r), part), (1.0, error)];
    Ok(Study {
        layout,
        part: (part, part.against(&error)),
        operator: Some((operator, operator.against(&part))),
        interaction: None,
        is_pooled: false,
        repeatability: error,
        components,
        gauge: gauge_interval(components.gauge(), &terms, plan.level),
        repeatability_deviation: deviation_of(&error, plan),
        spread: plan.spread,
    })
}

fn deviation_of(row: &Row, plan: &StudyPlan) -> Estimate {
    Estimate::of_deviation(row.mean_square().sqrt(), row.degrees, plan.level)
}

/// The standard deviation of the gauge: the interval of a weighted sum of mean squares.
fn gauge_interval(variance: f64, terms: &[(f64, Row)], level: f64) -> Estimate {
    let rest = (1.0 - level) / 2.0;
    let (mut sum, mut down, mut up) = (0.0, 0.0, 0.0);
    for (weight, row) in terms {
        let part = weight * row.mean_square();
        let less = 1.0 - row.degrees / chi_square_quantile(row.degrees, 1.0 - rest);
        let more = row.degrees / chi_square_quantile(row.degrees, rest) - 1.0;
        let (less, more) = if *weight < 0.0 { (more, less) } else { (less, more) };
        sum += part;
        down += (less * part).powi(2);
        up += (more * part).powi(2);
    }
    let ends = [sum - down.sqrt(), sum + up.sqrt()].map(|end| end.max(0.0).sqrt());
    let value = variance.sqrt();
    Estimate { value, lower: ends[0].min(value), upper: ends[1].max(value) }
}

/// The squares of readings within their cells.
fn inside(cells: &[Vec<Vec<f64>>]) -> Result<f64, Reason> {
    cells.iter().flatten().map(|cell| Ok(Moments::of(cell)?.squares)).sum()
}

/// The number of outer groups, of inner ones and of readings, which are the same everywhere.
fn checked(cells: &[Vec<Vec<f64>>], plan: &StudyPlan, is_nested: bool) -> Result<[usize; 3], Reason> {
    checked_level(plan.level)?;
    if !(0.0 < plan.spread && plan.spread.is_finite()) {
        return Err(parameter("spread", plan.spread));
    }
    let inner = cells.iter().map(Vec::len).max().unwrap_or_default();
    let readings = cells.iter().flatten().map(Vec::len).max().unwrap_or_default();
    for (at, group) in cells.iter().enumerate() {
        for within in 0..inner {
            let found = group.get(within).map_or(0, Vec::len);
            if found != readings {
                let (part, operator) = if is_nested { (within + 1, at + 1) } else { (at + 1, within + 1) };
                return Err(Reason::UnevenCell { part, operator, found, needed: readings });
            }
        }
    }
    let least_inner = if is_nested { 2 } else { 1 };
    for (found, needed) in [(cells.len(), 2), (inner, least_inner), (readings, 2)] {
        if found < needed {
            return Err(if found == 0 { Reason::Empty } else { Reason::TooFew { found, needed } });
        }
    }
    Ok([cells.len(), inner, readings])
}
