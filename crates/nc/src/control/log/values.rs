//! A log's figures by their order, and whether they agree with each other.
//!
//! The cycle's declaration says which figures there are, and which other values each of them has.

use fitcheck_core::length::{Length, Unit};
use fitcheck_core::message::Located;
use fitcheck_core::probing::cycle::{FigureKind, LogFigure, ResultName, TextLog};

use super::error::{LogError, LogFault, LogWarning, LogWarningKind, Section as Name};
use super::lines::{Chunk, Pair, Section, Title};
use super::{Further, layout};

/// A measured value of a log, and the values that belong to it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Figure {
    /// Nominal value, if the log has one; for a diameter it is above zero.
    pub nominal: Option<Length>,
    /// Permitted values; `None` if both are 0, so that the control did not monitor it. For a centre they are
    /// symmetrical about the nominal value to the last digit, and equal to the nominal value if it is not monitored.
    pub limits: Option<LimitPair>,
    /// Measured value; for a diameter it is above zero.
    pub actual: Length,
    /// Deviation from the log, if it has one; equal to actual minus nominal to the last digit.
    pub deviation: Option<Length>,
}

/// A maximum and a minimum that is not above it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct LimitPair {
    /// The largest permitted value.
    pub maximum: Length,
    /// The smallest permitted value.
    pub minimum: Length,
}

/// What is left of a log below its header.
pub(super) struct Body<'a> {
    chunk: &'a Chunk,
    /// Sections with pairs; a log without headings is divided by its order.
    groups: Vec<Section<'a>>,
    unit: Unit,
}

/// A number that was read.
#[derive(Debug, Clone, Copy)]
struct Number<'a> {
    pair: Pair<'a>,
    value: Length,
}

impl<'a> Body<'a> {
    pub(super) fn new(chunk: &'a Chunk, mut groups: Vec<Section<'a>>, unit: Unit) -> Self {
        groups.retain(|section| !section.pairs.is_empty());
        Self { chunk, groups, unit }
    }

    pub(super) fn read(
        mut self,
        title: &Title,
        warnings: &mut Vec<LogWarning>,
    ) -> Result<(Vec<Figure>, Vec<Further>), LogError> {
        let Some(log) = layout(title.cycle) else { return Err(LogFault::other_cycle(title.cycle).at(title.line)) };
        if let [LogFigure { kind: FigureKind::Coordinate, .. }] = log.figures {
            let coordinate = self.coordinate()?;
            return Ok((vec![coordinate], self.further()));
        }
        let limited = log.limited().count();
        if let [_] = self.groups.as_slice() {
            self.cut_by_order([limited, 2 * limited, log.figures.len(), limited, usize::MAX]);
        }
        let figures = self.figures(log, limited, warnings)?;
        Ok((figures, self.further()))
    }

    /// A log without headings: nominal values, limits, actual values, deviations, further results.
    fn cut_by_order(&mut self, sizes: [usize; 5]) {
        let mut pairs: std::collections::VecDeque<_> =
            self.groups.drain(..).flat_map(|group| group.pairs.into_iter()).collect();
        for size in sizes {
            let pairs: Vec<_> = pairs.drain(..size.min(pairs.len())).collect();
            if let Some(first) = pairs.first() {
                self.groups.push(Section { line: first.line, pairs });
            }
        }
    }

    /// The sections of nominal values, limits, actual values and deviations, checked against each other.
    fn figures(
        &mut self,
        log: &TextLog,
        limited: usize,
        warnings: &mut Vec<LogWarning>,
    ) -> Result<Vec<Figure>, LogError> {
        let nominal = self.take(Name::Nominal, limited)?;
        let limits = self.take(Name::Limits, 2 * limited)?;
        let actual = self.take(Name::Actual, log.figures.len())?;
        let decimals = decimals(nominal.first());
        if let Some(last) = actual.last() {
            self.whole(last, decimals)?;
        }
        let compared = actual.iter().zip(log.figures).filter(|(_, figure)| figure.is_limited());
        let compared: Vec<_> = compared.map(|(actual, _)| *actual).collect();
        let deviations = self.deviations(&nominal, &compared, decimals)?;
        if deviations.is_none() {
            warnings.push(Located::in_line(self.chunk.last_line(), LogWarningKind::NoDeviations));
        }
        let is_diameter = |figure: &&LogFigure| figure.what == ResultName::DIAMETER;
        for numbers in [nominal.iter().zip(log.limited()), compared.iter().zip(log.limited())] {
            for (number, _) in numbers.filter(|(_, figure)| is_diameter(figure)) {
                if number.value <= Length::ZERO {
                    let given = number.pair.given.to_owned();
                    return Err(number.pair.wrong(LogFault::NotPositive { given }));
                }
            }
        }
        let mut found = Vec::new();
        let mut beside = nominal.iter().zip(limits.chunks_exact(2)).zip(0..);
        for (actual, figure) in actual.iter().zip(log.figures) {
            let with = if figure.is_limited() { beside.next() } else { None };
            let Some(((nominal, [maximum, minimum]), number)) = with else {
                found.push(Figure::bare(None, actual.value));
                continue;
            };
            let limits = match figure.kind {
                FigureKind::Centre(_) => Some(self.even(maximum, minimum, nominal)?),
                _ => monitored(limit_pair(maximum, minimum)?),
            };
            let deviation =
                deviations.as_ref().and_then(|deviations| deviations.get(number)).map(|number| number.value);
            found.push(Figure { nominal: Some(nominal.value), limits, actual: actual.value, deviation });
        }
        Ok(found)
    }

    /// Limits and actual value; nominal value and deviation may be absent, as the sizes of the sections show.
    fn coordinate(&mut self) -> Result<Figure, LogError> {
        let has_nominal = self.groups.first().is_some_and(|group| group.pairs.len() == 1);
        let nominal = if has_nominal { self.take(Name::Nominal, 1)?.first().copied() } else { None };
        let limits = self.take(Name::Limits, 2)?;
        let actual = self.take(Name::Actual, 1)?;
        let ([maximum, minimum], [actual]) = (limits.as_slice(), actual.as_slice()) else {
            // Every section has already been taken with this many numbers.
            return Err(LogFault::NoLog.at(self.chunk.last_line()));
        };
        self.whole(actual, decimals(Some(maximum)))?;
        let named_alike = self.groups.first().is_some_and(|group| labels_match(&group.pairs, &[*actual]));
        let mut deviation = None;
        if let (true, Some(nominal)) = (named_alike, nominal) {
            for number in self.take(Name::Deviations, 1)? {
                self.agrees(&number, actual, &nominal)?;
                deviation = Some(number.value);
            }
        }
        let nominal = nominal.map(|nominal| nominal.value);
        Ok(Figure { nominal, limits: monitored(limit_pair(maximum, minimum)?), actual: actual.value, deviation })
    }

    /// The next section, which must have this many numbers.
    fn take(&mut self, name: Name, expected: usize) -> Result<Vec<Number<'a>>, LogError> {
        if self.groups.is_empty() {
            return Err(LogFault::Missing { section: name }.at(self.chunk.last_line()));
        }
        let group = self.groups.remove(0);
        let numbers: Vec<_> = group.pairs.iter().map(|pair| self.figure(pair)).collect::<Result<_, _>>()?;
        if numbers.len() == expected {
            return Ok(numbers);
        }
        Err(LogFault::Count { section: name, found: numbers.len(), expected }.at(group.line))
    }

    fn figure(&self, pair: &Pair<'a>) -> Result<Number<'a>, LogError> {
        let value = Length::parse_in(pair.given, self.unit).map_err(|error| pair.wrong(LogFault::Number(error)))?;
        Ok(Number { pair: *pair, value })
    }

    /// The next section as deviations: if it has as many numbers, at least two, or the names of the actual values. If
    /// the file is cut off within one, the section is not used.
    fn deviations(
        &mut self,
        nominal: &[Number<'a>],
        actual: &[Number<'a>],
        decimals: usize,
    ) -> Result<Option<Vec<Number<'a>>>, LogError> {
        let Some(group) = self.groups.first() else { return Ok(None) };
        let expected = actual.len();
        let is_as_long = 1 < expected && group.pairs.len() == expected;
        if !is_as_long && !labels_match(&group.pairs, actual) {
            return Ok(None);
        }
        let is_last = self.groups.len() == 1;
        let cut = |pair: &Pair<'_>| self.chunk.ends_within(pair.line) && decimals_of(pair.given) < decimals;
        let whole = group.pairs.iter().take_while(|pair| !(is_last && cut(pair))).count();
        let mut numbers = Vec::with_capacity(expected);
        for ((pair, actual), nominal) in group.pairs.iter().take(whole).zip(actual).zip(nominal) {
            let deviation = self.figure(pair)?;
            self.agrees(&deviation, actual, nominal)?;
            numbers.push(deviation);
        }
        let found = group.pairs.len();
        if expected < found || !is_last && found < expected {
            return Err(LogFault::Count { section: Name::Deviations, found, expected }.at(group.line));
        }
        self.groups.remove(0);
        Ok((numbers.len() == expected).then_some(numbers))
    }

    /// If the file ends in a figure, it may be cut off: 25.01 of 25.0134. It is whole if it has as many decimals as the
    /// log's first figure.
    fn whole(&self, figure: &Number<'_>, decimals: usize) -> Result<(), LogError> {
        if self.chunk.ends_within(figure.pair.line) && decimals_of(figure.pair.given) < decimals {
            return Err(figure.pair.wrong(LogFault::CutFigure { given: figure.pair.given.to_owned() }));
        }
        Ok(())
    }

    /// The last digit of a log, 0.0001 of its unit: the most that rounding may change in a difference.
    fn last_figure(&self) -> Length {
        // Of micrometres it is less than a nanometre, and no log is in micrometres.
        Length::parse_in("0.0001", self.unit).unwrap_or(Length::ZERO)
    }

    fn agrees(&self, deviation: &Number<'_>, actual: &Number<'_>, nominal: &Number<'_>) -> Result<(), LogError> {
        let difference = actual.value.saturating_sub(nominal.value);
        if deviation.value.saturating_sub(difference).abs() <= self.last_figure() {
            return Ok(());
        }
        let reason = LogFault::Deviation {
            given: deviation.pair.given.to_owned(),
            actual: actual.pair.given.to_owned(),
            nominal: nominal.pair.given.into(),
        };
        Err(deviation.pair.wrong(reason))
    }

    /// Checks that the limits of the centre are symmetrical about the nominal value to the last digit.
    fn even(&self, maximum: &Number<'_>, minimum: &Number<'_>, nominal: &Number<'_>) -> Result<LimitPair, LogError> {
        let limits = limit_pair(maximum, minimum)?;
        let above = limits.maximum.saturating_sub(nominal.value);
        let below = nominal.value.saturating_sub(limits.minimum);
        if above.saturating_sub(below).abs() <= self.last_figure() && Length::ZERO <= above && Length::ZERO <= below {
            return Ok(limits);
        }
        let reason = LogFault::Uneven {
            minimum: minimum.pair.given.to_owned(),
            maximum: maximum.pair.given.to_owned(),
            nominal: nominal.pair.given.into(),
        };
        Err(maximum.pair.wrong(reason))
    }

    fn further(&self) -> Vec<Further> {
        let pairs = self.groups.iter().flat_map(|group| &group.pairs);
        pairs.map(|pair| Further { label: pair.label.to_owned(), value: pair.given.to_owned() }).collect()
    }
}

/// Limits of 0 and 0 monitor nothing.
fn monitored(limits: LimitPair) -> Option<LimitPair> {
    Some(limits).filter(|limits| limits.maximum != Length::ZERO || limits.minimum != Length::ZERO)
}

fn limit_pair(maximum: &Number<'_>, minimum: &Number<'_>) -> Result<LimitPair, LogError> {
    if maximum.value < minimum.value {
        let max = maximum.pair.given.to_owned();
        let min = minimum.pair.given.to_owned();
        return Err(maximum.pair.wrong(LogFault::Swapped { maximum: max, minimum: min }));
    }
    Ok(LimitPair { maximum: maximum.value, minimum: minimum.value })
}

/// Whether every pair has the name of the figure in its place, in any language.
fn labels_match(pairs: &[Pair<'_>], figures: &[Number<'_>]) -> bool {
    pairs.len() <= figures.len()
        && pairs.iter().zip(figures).all(|(pair, figure)| pair.label.to_lowercase() == figure.pair.label.to_lowercase())
}

fn decimals(figure: Option<&Number<'_>>) -> usize {
    figure.map_or(0, |figure| decimals_of(figure.pair.given))
}

fn decimals_of(number: &str) -> usize {
    number.split_once(['.', ',']).map_or(0, |(_, decimals)| decimals.bytes().take_while(u8::is_ascii_digit).count())
}
