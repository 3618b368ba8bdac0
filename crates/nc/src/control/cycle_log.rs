//! The measuring log of a cycle's result: what the control would write next to its program, or show on its screen.
//!
//! The cycle's declaration says which kind it is: a text ([`super::log`]) with certain figures, a page of points
//! ([`super::point_log`]), or none. Nothing here opens a file or reads the clock.
//!
//! Whether a control overwrites a log of the same name or adds to it is not documented. Here a log is added to the file
//! ([`CycleLog::append`]): no measurement is lost, and Fitcheck reads several logs in one file.

use fitcheck_core::length::{Length, Unit};
use fitcheck_core::message::Say;
use fitcheck_core::probing::cycle::{self, Axis, Cycle, CycleResult, FigureKind, Meaning, ResultName, Value};
use fitcheck_core::probing::cycles::cycle as cycle_of;
use fitcheck_core::tolerance::Feature;
use fitcheck_core::verdict::{Status, classify};
use fitcheck_core::words::Dialogue;
use jiff::civil::DateTime;

use super::log::{self, Figure, Further, LimitPair, Log, LogWriteError};
use super::point_log::{self, Band, PointLog, PointLogError};

/// The log of a cycle's result.
#[derive(Debug, Clone, PartialEq)]
pub enum CycleLog {
    Text(Log),
    Page(PointLog),
}

/// What the header of a log contains.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Heading {
    /// When it was measured; left out if not known.
    pub date_time: Option<DateTime>,
    /// Path of the NC program on the control, `TNC:\PART1.H`; left out if there is none.
    pub program: Option<String>,
    /// Millimetres or inches: the unit of the main program, which is also the unit of the log.
    pub unit: Unit,
    /// Whether a simulation gave the contacts: the log says so.
    pub is_simulated: bool,
}

/// Why a log cannot be written.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(error)]
pub enum CycleLogError {
    #[say(transparent)]
    Text(#[from] LogWriteError),
    #[say(transparent)]
    Page(#[from] PointLogError),
}

/// The log's rounded figures lead to another status than the cycle gave.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Say)]
#[say(id = "cycle-log-other-verdict", args(unit = name(*unit)))]
pub struct OtherVerdict {
    /// The status from the cycle, for the unrounded value.
    pub cycle: Status,
    /// The status from the log's own limits, for its rounded value.
    pub log: Status,
    /// The unit of the log, which has four decimals.
    #[say(skip)]
    pub unit: Unit,
}

const fn name(unit: Unit) -> &'static str {
    match unit {
        Unit::Millimetre => "mm",
        Unit::Micrometre => "µm",
        Unit::Inch => "inch",
    }
}

impl CycleLog {
    /// The log of a result; `None` for a cycle that writes no log, and for a result of another cycle.
    ///
    /// The figures are the result's own, unrounded: limits and deviations are those that the cycle used, a centre
    /// without a tolerance has its nominal value as both limits, and a diameter or coordinate that was not monitored
    /// has limits of 0.
    pub fn of(cycle: &Cycle, result: &CycleResult, heading: &Heading, language: Dialogue) -> Option<Self> {
        let figures = match &cycle.log {
            cycle::Log::Screen | cycle::Log::None => return None,
            cycle::Log::Points { .. } => return point(cycle, result, heading).map(Self::Page),
            cycle::Log::Text(log) => log.figures.iter().map(|of| figure(cycle, result, of.what, of.kind)),
        };
        let figures = figures.collect::<Option<_>>()?;
        let height = cycle.length_of(&result.inputs, Meaning::MeasuringHeight)?;
        Some(Self::Text(Log {
            date: heading.date_time.map(DateTime::date),
            time: heading.date_time.map(DateTime::time),
            program: heading.program.clone(),
            is_simulated: heading.is_simulated,
            further: vec![Further::measuring_height(height, heading.unit, language)],
            ..Log::new(cycle.number, figures, heading.unit)
        }))
    }

    /// The log as a file of its own, with the words of a language.
    ///
    /// # Errors
    /// [`CycleLogError`] for a log that would not be read back as the same log.
    pub fn write(&self, language: Dialogue) -> Result<Vec<u8>, CycleLogError> {
        self.append(&[], language)
    }

    /// A file of logs with this one at its end; an empty file gets its first log.
    ///
    /// # Errors
    /// As for [`Self::write`]; also if the file is cut off or, for a page, is not such a page.
    pub fn append(&self, file: &[u8], language: Dialogue) -> Result<Vec<u8>, CycleLogError> {
        match self {
            Self::Text(log) => Ok(log::append(file, log, language)?),
            Self::Page(log) => Ok(point_log::append(file, log, language)?),
        }
    }

    /// The status after reading the log back: by its own limits and its own rounded figures. `None` if nothing was
    /// monitored.
    pub fn status(&self, language: Dialogue) -> Option<Status> {
        match self {
            Self::Text(log) => status(&log.printed(language)),
            Self::Page(log) => log.status,
        }
    }

    /// Whether the log will give another status than the cycle did: if a value is outside a limit by less than the log
    /// prints. A value on or within its limits stays there, because both are rounded in the same way.
    pub fn other_verdict(&self, result: &CycleResult, language: Dialogue) -> Option<OtherVerdict> {
        let (Self::Text(Log { unit, .. }) | Self::Page(PointLog { unit, .. })) = self;
        let cycle = result.status?;
        let log = self.status(language)?;
        (cycle != log).then_some(OtherVerdict { cycle, log, unit: *unit })
    }
}

/// A figure of the log; `None` if the result is of another cycle.
fn figure(cycle: &Cycle, result: &CycleResult, what: ResultName, kind: FigureKind) -> Option<Figure> {
    let actual = result.length(what)?;
    let of = |meaning| cycle.length_of(&result.inputs, meaning);
    let against = |nominal: Length, limits| {
        Some(Figure { nominal: Some(nominal), limits, actual, deviation: Some(actual.saturating_sub(nominal)) })
    };
    match kind {
        FigureKind::Centre(axis) => {
            let nominal = of(Meaning::Centre(axis))?;
            // A tolerance of 0 means that the axis is not monitored.
            let tolerance = of(Meaning::CentreTolerance(axis)).unwrap_or(Length::ZERO);
            let maximum = nominal.saturating_sub(tolerance.negated());
            against(nominal, Some(LimitPair { maximum, minimum: nominal.saturating_sub(tolerance) }))
        }
        FigureKind::Size(nominal) => against(of(nominal)?, compared(result, what)),
        FigureKind::Coordinate => Some(Figure::bare(compared(result, what), actual)),
        FigureKind::Information => Some(Figure::bare(None, actual)),
    }
}

/// The limits that the cycle compared a value with.
fn compared(result: &CycleResult, what: ResultName) -> Option<LimitPair> {
    let check = result.checks.iter().find(|check| check.what == what)?;
    Some(LimitPair { maximum: check.maximum, minimum: check.minimum })
}

const AXES: [Axis; 3] = [Axis::First, Axis::Second, Axis::Third];

fn point(cycle: &Cycle, result: &CycleResult, heading: &Heading) -> Option<PointLog> {
    let found = |names: [ResultName; 3]| all(names.map(|name| result.length(name)));
    let normal = |axis| match cycle.value_of(&result.inputs, Meaning::Normal(axis)) {
        Some(Value::Number(number)) => Some(*number),
        _ => None,
    };
    let deviation = result.length(ResultName::DEVIATION_ALONG)?;
    let tolerance = cycle.value_of(&result.inputs, Meaning::Band);
    let band = match tolerance {
        Some(Value::Band(Some(band))) => Some(Band { upper: band.upper(), lower: band.lower() }),
        _ => None,
    };
    Some(PointLog {
        date_time: heading.date_time,
        program: heading.program.clone(),
        is_simulated: heading.is_simulated,
        unit: heading.unit,
        nominal: all(AXES.map(|axis| cycle.length_of(&result.inputs, Meaning::Point(axis))))?,
        normal: all(AXES.map(normal))?,
        measured: found([ResultName::POSITION_1, ResultName::POSITION_2, ResultName::POSITION_3])?,
        deviations: found([ResultName::DEVIATION_1, ResultName::DEVIATION_2, ResultName::DEVIATION_3])?,
        deviation,
        tolerance: tolerance.map_or_else(String::new, ToString::to_string),
        band,
        status: band.map(|band| band.status(deviation)),
    })
}

fn all<T>([x, y, z]: [Option<T>; 3]) -> Option<[T; 3]> {
    Some([x?, y?, z?])
}

/// The worst status from a log's figures: sizes and coordinates by their limits; a centre out of position is scrap.
fn status(log: &Log) -> Option<Status> {
    let feature = cycle_of(log.cycle)?.shape().feature();
    let figures = log::layout(log.cycle)?.figures.iter().zip(&log.figures);
    let judged = figures.filter_map(|(of, figure)| judged(of.kind, feature, figure));
    judged.max()
}

/// The status of a figure by its limits; `None` if it was not monitored.
fn judged(kind: FigureKind, feature: Feature, figure: &Figure) -> Option<Status> {
    let LimitPair { maximum, minimum } = figure.limits?;
    let actual = figure.actual;
    let is_centre = matches!(kind, FigureKind::Centre(_));
    let is_within = minimum <= actual && actual <= maximum;
    match (is_centre, is_within) {
        (false, _) => Some(classify(Some(feature), minimum, maximum, actual)),
        (true, _) if minimum == maximum => None,
        (true, true) => Some(Status::Good),
        (true, false) => Some(Status::Scrap),
    }
}
