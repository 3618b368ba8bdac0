//! A log's figures by their order, and whether they agree with each other.

use super::Further;
use super::error::{LogError, LogReason, LogWarning, Section as Name};
use super::lines::{Chunk, Pair, Section, Title};
use crate::length::{Length, Unit};
use crate::tolerance::Feature;

/// The figures of a log.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Values {
    /// Cycles 421 and 422.
    Circle(Circle),
    /// Cycle 427.
    Coordinate(Coordinate),
}

/// The figures of cycle 421 or 422.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Circle {
    /// Hole for 421, shaft for 422.
    pub feature: Feature,
    /// Nominal values; the diameter is above zero.
    pub nominal: Place,
    /// Permitted positions of the centre in reference and minor axis, even about the nominal ones to the last figure.
    pub centre_limits: [LimitPair; 2],
    /// Limits of size; `None` where both are 0: the control did not monitor the diameter.
    pub diameter_limits: Option<LimitPair>,
    /// Actual values; the diameter is above zero.
    pub actual: Place,
    /// Deviations as the log gives them, if it does; they equal actual minus nominal to the last figure.
    pub deviations: Option<Place>,
}

/// A centre and a diameter.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Place {
    /// Reference axis, minor axis.
    pub centre: [Length; 2],
    /// The diameter.
    pub diameter: Length,
}

/// A maximum and a minimum that is not above it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct LimitPair {
    /// The largest permitted value.
    pub maximum: Length,
    /// The smallest permitted value.
    pub minimum: Length,
}

/// The figures of cycle 427.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Coordinate {
    /// Nominal value, where the log has one.
    pub nominal: Option<Length>,
    /// Permitted values.
    pub limits: LimitPair,
    /// The measured coordinate.
    pub actual: Length,
}

/// What is left of a log below its header.
pub(super) struct Body<'a> {
    chunk: &'a Chunk<'a>,
    /// Sections with pairs; a log without headings is cut by its order.
    groups: Vec<Group<'a>>,
    unit: Unit,
}

#[derive(Debug)]
struct Group<'a> {
    line: usize,
    pairs: Vec<Pair<'a>>,
}

/// A figure that was read.
#[derive(Debug, Clone, Copy)]
struct Figure<'a> {
    pair: Pair<'a>,
    value: Length,
}

impl<'a> Body<'a> {
    pub(super) fn new(chunk: &'a Chunk<'a>, sections: Vec<Section<'a>>, unit: Unit) -> Self {
        let with_pairs = sections.into_iter().filter(|section| !section.pairs.is_empty());
        let groups = with_pairs.map(|Section { line, pairs }| Group { line, pairs }).collect();
        Self { chunk, groups, unit }
    }

    pub(super) fn read(
        mut self,
        title: &Title<'_>,
        warnings: &mut Vec<LogWarning>,
    ) -> Result<(Values, Vec<Further>), LogError> {
        let feature = match title.cycle {
            421 => Feature::Hole,
            422 => Feature::Shaft,
            427 => {
                let coordinate = self.coordinate()?;
                return Ok((Values::Coordinate(coordinate), self.further()));
            }
            cycle => return Err(LogReason::OtherCycle { cycle }.at(title.line)),
        };
        if let [_] = self.groups.as_slice() {
            self.cut_by_order();
        }
        let circle = self.circle(feature, warnings)?;
        Ok((Values::Circle(circle), self.further()))
    }

    /// A log without headings: 3 nominal values, 6 limits, 3 actual values, 3 deviations, further results.
    fn cut_by_order(&mut self) {
        let mut pairs: std::collections::VecDeque<_> =
            self.groups.drain(..).flat_map(|group| group.pairs.into_iter()).collect();
        for size in [3, 6, 3, 3, usize::MAX] {
            let pairs: Vec<_> = pairs.drain(..size.min(pairs.len())).collect();
            if let Some(first) = pairs.first() {
                self.groups.push(Group { line: first.line, pairs });
            }
        }
    }

    fn circle(&mut self, feature: Feature, warnings: &mut Vec<LogWarning>) -> Result<Circle, LogError> {
        let nominal: [Figure<'_>; 3] = self.take(Name::Nominal)?;
        let limits: [Figure<'_>; 6] = self.take(Name::Limits)?;
        let actual: [Figure<'_>; 3] = self.take(Name::Actual)?;
        let decimals = decimals(nominal.first());
        if let Some(last) = actual.last() {
            self.whole(last, decimals)?;
        }
        let deviations = self.deviations(&nominal, &actual, decimals)?;
        if deviations.is_none() {
            warnings.push(LogWarning::NoDeviations { line: self.chunk.last_line() });
        }
        let [max_1, min_1, max_2, min_2, max_d, min_d] = limits;
        let [nominal_1, nominal_2, nominal_d] = nominal;
        positive(&nominal_d)?;
        positive(actual.last().unwrap_or(&nominal_d))?;
        let diameter = limit_pair(&max_d, &min_d)?;
        Ok(Circle {
            feature,
            centre_limits: [self.even(&max_1, &min_1, &nominal_1)?, self.even(&max_2, &min_2, &nominal_2)?],
            diameter_limits: Some(diameter)
                .filter(|limits| limits.maximum != Length::ZERO || limits.minimum != Length::ZERO),
            nominal: place(nominal),
            actual: place(actual),
            deviations: deviations.map(place),
        })
    }

    /// Limits and actual value; nominal value and deviation may be absent, and are told by the sizes of the sections.
    fn coordinate(&mut self) -> Result<Coordinate, LogError> {
        let has_nominal = self.groups.first().is_some_and(|group| group.pairs.len() == 1);
        let nominal: Option<[Figure<'_>; 1]> = if has_nominal { Some(self.take(Name::Nominal)?) } else { None };
        let [maximum, minimum]: [Figure<'_>; 2] = self.take(Name::Limits)?;
        let [actual]: [Figure<'_>; 1] = self.take(Name::Actual)?;
        self.whole(&actual, decimals(Some(&maximum)))?;
        let named_alike = self.groups.first().is_some_and(|group| labels_match(&group.pairs, &[actual]));
        if let (true, Some([nominal])) = (named_alike, nominal) {
            let [deviation]: [Figure<'_>; 1] = self.take(Name::Deviations)?;
            self.agrees(&deviation, &actual, &nominal)?;
        }
        let nominal = nominal.map(|[nominal]| nominal.value);
        Ok(Coordinate { nominal, limits: limit_pair(&maximum, &minimum)?, actual: actual.value })
    }

    /// The next section, which must have so many figures.
    fn take<const N: usize>(&mut self, name: Name) -> Result<[Figure<'a>; N], LogError> {
        if self.groups.is_empty() {
            return Err(LogReason::Missing { section: name }.at(self.chunk.last_line()));
        }
        let group = self.groups.remove(0);
        let mut figures = Vec::with_capacity(N);
        for pair in &group.pairs {
            figures.push(self.figure(pair)?);
        }
        figures.try_into().map_err(|figures: Vec<_>| {
            LogReason::Count { section: name, found: figures.len(), expected: N }.at(group.line)
        })
    }

    fn figure(&self, pair: &Pair<'a>) -> Result<Figure<'a>, LogError> {
        let value = Length::parse_in(pair.given, self.unit).map_err(|error| at(pair, LogReason::Number(error)))?;
        Ok(Figure { pair: *pair, value })
    }

    /// The next section as deviations: where it has three figures, or the names of the actual values. One that the
    /// file ends in is not used.
    fn deviations(
        &mut self,
        nominal: &[Figure<'a>; 3],
        actual: &[Figure<'a>; 3],
        decimals: usize,
    ) -> Result<Option<[Figure<'a>; 3]>, LogError> {
        let Some(group) = self.groups.first() else { return Ok(None) };
        if group.pairs.len() != 3 && !labels_match(&group.pairs, actual) {
            return Ok(None);
        }
        let is_last = self.groups.len() == 1;
        let cut = |pair: &Pair<'_>| self.chunk.ends_within(pair.line) && decimals_of(pair.given) < decimals;
        let whole = group.pairs.iter().take_while(|pair| !(is_last && cut(pair))).count();
        let mut figures = Vec::with_capacity(3);
        for ((pair, actual), nominal) in group.pairs.iter().take(whole).zip(actual).zip(nominal) {
            let deviation = self.figure(pair)?;
            self.agrees(&deviation, actual, nominal)?;
            figures.push(deviation);
        }
        if 3 < group.pairs.len() || !is_last && group.pairs.len() < 3 {
            let found = group.pairs.len();
            return Err(LogReason::Count { section: Name::Deviations, found, expected: 3 }.at(group.line));
        }
        self.groups.remove(0);
        Ok(figures.try_into().ok())
    }

    /// A figure that the file ends in may be cut off: 25.01 of 25.0134. It is whole if it has as many decimals as
    /// the log's first figure.
    fn whole(&self, figure: &Figure<'_>, decimals: usize) -> Result<(), LogError> {
        if self.chunk.ends_within(figure.pair.line) && decimals_of(figure.pair.given) < decimals {
            return Err(at(&figure.pair, LogReason::CutFigure { given: figure.pair.given.to_owned() }));
        }
        Ok(())
    }

    /// The last figure of a log, 0.0001 of its unit: what rounding may make of a difference.
    fn last_figure(&self) -> Length {
        match self.unit {
            Unit::Millimetre => Length::parse_in("0.0001", Unit::Millimetre),
            Unit::Micrometre => Length::parse_in("0.0001", Unit::Micrometre),
            Unit::Inch => Length::parse_in("0.0001", Unit::Inch),
        }
        .unwrap_or_default()
    }

    fn agrees(&self, deviation: &Figure<'_>, actual: &Figure<'_>, nominal: &Figure<'_>) -> Result<(), LogError> {
        let difference = actual.value.saturating_sub(nominal.value);
        if deviation.value.saturating_sub(difference).abs() <= self.last_figure() {
            return Ok(());
        }
        let reason = LogReason::Deviation {
            given: deviation.pair.given.to_owned(),
            actual: actual.pair.given.to_owned(),
            nominal: nominal.pair.given.to_owned(),
        };
        Err(at(&deviation.pair, reason))
    }

    /// Limits of the centre: even about the nominal value to the last figure.
    fn even(&self, maximum: &Figure<'_>, minimum: &Figure<'_>, nominal: &Figure<'_>) -> Result<LimitPair, LogError> {
        let limits = limit_pair(maximum, minimum)?;
        let above = limits.maximum.saturating_sub(nominal.value);
        let below = nominal.value.saturating_sub(limits.minimum);
        if above.saturating_sub(below).abs() <= self.last_figure() && Length::ZERO <= above && Length::ZERO <= below {
            return Ok(limits);
        }
        let reason = LogReason::Uneven {
            minimum: minimum.pair.given.to_owned(),
            maximum: maximum.pair.given.to_owned(),
            nominal: nominal.pair.given.to_owned(),
        };
        Err(at(&maximum.pair, reason))
    }

    fn further(&self) -> Vec<Further> {
        let pairs = self.groups.iter().flat_map(|group| &group.pairs);
        pairs.map(|pair| Further { label: pair.label.to_owned(), value: pair.given.to_owned() }).collect()
    }
}

fn at(pair: &Pair<'_>, reason: LogReason) -> LogError {
    LogError { line: pair.line, column: Some(pair.column), reason }
}

fn place([first, second, diameter]: [Figure<'_>; 3]) -> Place {
    Place { centre: [first.value, second.value], diameter: diameter.value }
}

fn limit_pair(maximum: &Figure<'_>, minimum: &Figure<'_>) -> Result<LimitPair, LogError> {
    if maximum.value < minimum.value {
        let (max, min) = (maximum.pair.given.to_owned(), minimum.pair.given.to_owned());
        return Err(at(&maximum.pair, LogReason::Swapped { maximum: max, minimum: min }));
    }
    Ok(LimitPair { maximum: maximum.value, minimum: minimum.value })
}

fn positive(figure: &Figure<'_>) -> Result<(), LogError> {
    if Length::ZERO < figure.value {
        return Ok(());
    }
    Err(at(&figure.pair, LogReason::NotPositive { given: figure.pair.given.to_owned() }))
}

/// Whether every pair has the name of the figure at its place, whatever the language.
fn labels_match(pairs: &[Pair<'_>], figures: &[Figure<'_>]) -> bool {
    pairs.len() <= figures.len()
        && pairs.iter().zip(figures).all(|(pair, figure)| pair.label.to_lowercase() == figure.pair.label.to_lowercase())
}

fn decimals(figure: Option<&Figure<'_>>) -> usize {
    figure.map_or(0, |figure| decimals_of(figure.pair.given))
}

fn decimals_of(number: &str) -> usize {
    number.split_once(['.', ',']).map_or(0, |(_, decimals)| decimals.bytes().take_while(u8::is_ascii_digit).count())
}
