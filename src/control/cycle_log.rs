//! The measuring log of a cycle's result: what the control would write beside its program, or show on its screen.
//!
//! The cycle's declaration says which it is: a text ([`super::log`]) of certain figures, a page of points
//! ([`super::point_log`]), or none. Nothing here opens a file or asks for the time.
//!
//! Whether a control overwrites a log of the same name or adds to it is not documented. Here a log is added to what is
//! there ([`CycleLog::append`]): no measurement is lost, and every reader of ours takes several logs in one file.

use jiff::civil::DateTime;

use super::log::{self, Figure, Further, LimitPair, Log, LogWriteError};
use super::point_log::{self, Band, PointLog, PointLogError};
use crate::length::{Length, Unit};
use crate::message::Say;
use crate::probing::cycle::{self, Axis, Cycle, CycleResult, FigureKind, FoundName, Meaning, Value};
use crate::probing::cycles::cycle as cycle_of;
use crate::tolerance::Feature;
use crate::verdict::{Status, classify};
use crate::words::Dialogue;

/// The log of a cycle's result.
#[derive(Debug, Clone, PartialEq)]
pub enum CycleLog {
    /// A text.
    Text(Log),
    /// A page of points.
    Page(PointLog),
}

/// What the head of a log tells.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Heading {
    /// When it was measured; left out where it is not known.
    pub date_time: Option<DateTime>,
    /// Path of the NC program on the control, `TNC:\PART1.H`; left out where there is none.
    pub program: Option<String>,
    /// Millimetres or inches: the unit of the main program, which the log is printed in.
    pub unit: Unit,
}

/// Why a log cannot be written.
#[derive(Debug, Clone, PartialEq, Eq, Say)]
#[say(error)]
pub enum CycleLogError {
    /// A text.
    #[say(transparent)]
    Text(#[from] LogWriteError),
    /// A page of points.
    #[say(transparent)]
    Page(#[from] PointLogError),
}

/// The log's rounded figures say something else than the cycle.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Say)]
#[say(id = "cycle-log-other-verdict", args(unit = name(*unit)))]
pub struct OtherVerdict {
    /// What the cycle said of the unrounded value.
    pub cycle: Status,
    /// What the log's own limits say of its rounded value.
    pub log: Status,
    /// The unit of the log: it has four decimals of it.
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
    /// The log of a result; `None` for a cycle that writes none, and for a result that is not this cycle's.
    ///
    /// The figures are the result's own, unrounded: limits and deviations are those that the cycle compared with, a
    /// centre without a tolerance has its nominal value as both limits, and a diameter or coordinate that was not
    /// monitored has limits of 0.
    pub fn of(cycle: &Cycle, result: &CycleResult, heading: &Heading, language: Dialogue) -> Option<Self> {
        let figures = match &cycle.log {
            cycle::Log::Screen => return None,
            cycle::Log::Points { .. } => return point(cycle, result, heading).map(Self::Page),
            cycle::Log::Text(log) => log.figures.iter().map(|of| figure(cycle, result, of.what, of.kind)),
        };
        let figures = figures.collect::<Option<_>>()?;
        let height = cycle.length_of(&result.inputs, Meaning::MeasuringHeight)?;
        Some(Self::Text(Log {
            date: heading.date_time.map(DateTime::date),
            time: heading.date_time.map(DateTime::time),
            program: heading.program.clone(),
            further: vec![Further::measuring_height(height, heading.unit, language)],
            ..Log::new(cycle.number, figures, heading.unit)
        }))
    }

    /// The log as a file of its own, in the words of a language.
    ///
    /// # Errors
    /// [`CycleLogError`]: whatever would not be read back as the same log.
    pub fn write(&self, language: Dialogue) -> Result<Vec<u8>, CycleLogError> {
        self.append(&[], language)
    }

    /// A file of logs with this one at its end; an empty file gets its first log.
    ///
    /// # Errors
    /// As for [`Self::write`]; also where the file is cut off or, for a page, is not one of these.
    pub fn append(&self, file: &[u8], language: Dialogue) -> Result<Vec<u8>, CycleLogError> {
        match self {
            Self::Text(log) => Ok(log::append(file, log, language)?),
            Self::Page(log) => Ok(point_log::append(file, log, language)?),
        }
    }

    /// What the log says when it is read back: the status by its own limits and its own rounded figures. `None` where
    /// nothing was monitored.
    pub fn status(&self, language: Dialogue) -> Option<Status> {
        match self {
            Self::Text(log) => status(&log.printed(language)),
            Self::Page(log) => log.status,
        }
    }

    /// Whether the log will say something else than the cycle did: where a value is outside a limit by less than the
    /// log prints. A value on or within its limits stays so, because both are rounded alike.
    pub fn other_verdict(&self, result: &CycleResult, language: Dialogue) -> Option<OtherVerdict> {
        let (Self::Text(Log { unit, .. }) | Self::Page(PointLog { unit, .. })) = self;
        let (cycle, log) = (result.status?, self.status(language)?);
        (cycle != log).then_some(OtherVerdict { cycle, log, unit: *unit })
    }
}

/// A figure of the log; `None` where the result is not this cycle's.
fn figure(cycle: &Cycle, result: &CycleResult, what: FoundName, kind: FigureKind) -> Option<Figure> {
    let actual = result.length(what)?;
    let of = |meaning| cycle.length_of(&result.inputs, meaning);
    let against = |nominal: Length, limits| {
        Some(Figure { nominal: Some(nominal), limits, actual, deviation: Some(actual.saturating_sub(nominal)) })
    };
    match kind {
        FigureKind::Centre(axis) => {
            let nominal = of(Meaning::Centre(axis))?;
            // A tolerance of 0 is that of an axis that is not monitored.
            let tolerance = of(Meaning::CentreTolerance(axis)).unwrap_or_default();
            let maximum = nominal.saturating_sub(tolerance.negated());
            against(nominal, Some(LimitPair { maximum, minimum: nominal.saturating_sub(tolerance) }))
        }
        FigureKind::Size(nominal) => against(of(nominal)?, compared(result, what)),
        FigureKind::Coordinate => Some(Figure::bare(compared(result, what), actual)),
        FigureKind::Information => Some(Figure::bare(None, actual)),
    }
}

/// The limits that the cycle compared a value with.
fn compared(result: &CycleResult, what: FoundName) -> Option<LimitPair> {
    let check = result.checks.iter().find(|check| check.what == what)?;
    Some(LimitPair { maximum: check.maximum, minimum: check.minimum })
}

const AXES: [Axis; 3] = [Axis::First, Axis::Second, Axis::Third];

fn point(cycle: &Cycle, result: &CycleResult, heading: &Heading) -> Option<PointLog> {
    let found = |names: [FoundName; 3]| all(names.map(|name| result.length(name)));
    let normal = |axis| match cycle.value_of(&result.inputs, Meaning::Normal(axis)) {
        Some(Value::Number(number)) => Some(*number),
        _ => None,
    };
    let deviation = result.length(FoundName::DEVIATION_ALONG)?;
    let tolerance = cycle.value_of(&result.inputs, Meaning::Band);
    let band = match tolerance {
        Some(Value::Band(Some(band))) => Some(Band { upper: band.upper(), lower: band.lower() }),
        _ => None,
    };
    Some(PointLog {
        date_time: heading.date_time,
        program: heading.program.clone(),
        unit: heading.unit,
        nominal: all(AXES.map(|axis| cycle.length_of(&result.inputs, Meaning::Point(axis))))?,
        normal: all(AXES.map(normal))?,
        measured: found([FoundName::POSITION_1, FoundName::POSITION_2, FoundName::POSITION_3])?,
        deviations: found([FoundName::DEVIATION_1, FoundName::DEVIATION_2, FoundName::DEVIATION_3])?,
        deviation,
        tolerance: tolerance.map(ToString::to_string).unwrap_or_default(),
        band,
        status: band.map(|band| band.status(deviation)),
    })
}

fn all<T>([x, y, z]: [Option<T>; 3]) -> Option<[T; 3]> {
    Some([x?, y?, z?])
}

/// The worst that a log's figures say: sizes and coordinates by their limits, a centre out of position is scrap.
fn status(log: &Log) -> Option<Status> {
    let feature = cycle_of(log.cycle)?.shape().feature();
    let figures = log::layout(log.cycle)?.figures.iter().zip(&log.figures);
    let judged = figures.filter_map(|(of, figure)| judged(of.kind, feature, figure));
    judged.max()
}

/// What the limits of a figure say of it; `None` where it was not monitored.
fn judged(kind: FigureKind, feature: Feature, figure: &Figure) -> Option<Status> {
    let (LimitPair { maximum, minimum }, actual) = (figure.limits?, figure.actual);
    let is_centre = matches!(kind, FigureKind::Centre(_));
    let is_within = minimum <= actual && actual <= maximum;
    match (is_centre, is_within) {
        (false, _) => Some(classify(feature, minimum, maximum, actual)),
        (true, _) if minimum == maximum => None,
        (true, true) => Some(Status::Good),
        (true, false) => Some(Status::Scrap),
    }
}
