//! The measuring log of a cycle's result: what the control would write beside its program, or show on its screen.
//!
//! Cycles 421, 422 and 427 have a text ([`super::log`]), 444 has a page ([`super::log444`]), G785 of the lathe has none.
//! Nothing here opens a file or asks for the time.
//!
//! Whether a control overwrites a log of the same name or adds to it is not documented. Here a log is added to what is
//! there ([`CycleLog::append`]): no measurement is lost, and every reader of ours takes several logs in one file.

use jiff::civil::DateTime;

use super::log::{self, Circle, Coordinate, Further, LimitPair, Log, LogWriteError, Place, Values};
use super::log444::{self, Band, PointLog, PointLogError};
use crate::length::{Length, Unit};
use crate::message::{Message, Say};
use crate::probing::cycle::{CircleFound, Cycle, CycleResult, Key, Value};
use crate::tolerance::Feature;
use crate::verdict::{Status, classify};
use crate::words::Dialogue;

/// The log of a cycle's result.
#[derive(Debug, Clone, PartialEq)]
pub enum CycleLog {
    /// `TCHPR421.TXT`, `TCHPR422.TXT`, `TCHPR427.TXT`.
    Text(Log),
    /// `TCHPR444.html`.
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
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum CycleLogError {
    /// A log of 421, 422 or 427.
    #[error(transparent)]
    Text(#[from] LogWriteError),
    /// A log of 444.
    #[error(transparent)]
    Page(#[from] PointLogError),
}

impl Say for CycleLogError {
    fn message(&self) -> Message {
        match self {
            Self::Text(error) => error.message(),
            Self::Page(error) => error.message(),
        }
    }
}

/// The log's rounded figures say something else than the cycle.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct OtherVerdict {
    /// What the cycle said of the unrounded value.
    pub cycle: Status,
    /// What the log's own limits say of its rounded value.
    pub log: Status,
    /// The unit of the log: it has four decimals of it.
    pub unit: Unit,
}

impl std::fmt::Display for OtherVerdict {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let Self { cycle, log, unit } = self;
        write!(f, "the log's values, rounded to 0.0001 {}, give {log} where the cycle gave {cycle}", name(*unit))
    }
}

impl Say for OtherVerdict {
    fn message(&self) -> Message {
        let message = Message::new("cycle-log-other-verdict").with("cycle", &self.cycle).with("log", &self.log);
        message.text("unit", name(self.unit))
    }
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
        if cycle.number == 444 {
            return point(result, heading).map(Self::Page);
        }
        let values = match cycle.number {
            421 => Values::Circle(circle(Feature::Hole, result)?),
            422 => Values::Circle(circle(Feature::Shaft, result)?),
            427 => Values::Coordinate(coordinate(result)?),
            _ => return None,
        };
        let height = length(result.inputs.value(261))?;
        Some(Self::Text(Log {
            date: heading.date_time.map(DateTime::date),
            time: heading.date_time.map(DateTime::time),
            program: heading.program.clone(),
            further: vec![Further::measuring_height(height, heading.unit, language)],
            ..Log::new(values, heading.unit)
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
            Self::Page(log) => Ok(log444::append(file, log, language)?),
        }
    }

    /// What the log says when it is read back: the status by its own limits and its own rounded figures. `None` where
    /// nothing was monitored.
    pub fn status(&self, language: Dialogue) -> Option<Status> {
        match self {
            Self::Text(log) => status(&log.printed(language).values),
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

fn length(value: Option<&Value>) -> Option<Length> {
    if let Some(Value::Length(length)) = value { Some(*length) } else { None }
}

/// The limits that the cycle compared a value with.
fn compared(result: &CycleResult, measured: Length, what: crate::probing::cycle::FoundName) -> Option<LimitPair> {
    let check = result.checks.iter().find(|check| check.what == what && check.measured == measured)?;
    Some(LimitPair { maximum: check.maximum, minimum: check.minimum })
}

fn circle(feature: Feature, result: &CycleResult) -> Option<Circle> {
    use crate::probing::cycle::FoundName;
    let CircleFound { centre, diameter, position, .. } = result.circle.as_ref()?;
    let nominal = Place {
        centre: [length(result.inputs.value(273))?, length(result.inputs.value(274))?],
        diameter: length(result.inputs.value(262))?,
    };
    let ([nominal_1, nominal_2], [axis_1, axis_2]) = (nominal.centre, position.axes);
    // A tolerance of 0 is that of an axis that is not monitored.
    let about = |nominal: Length, tolerance: Option<Length>| {
        let tolerance = tolerance.unwrap_or_default();
        let maximum = nominal.saturating_sub(tolerance.negated());
        LimitPair { maximum, minimum: nominal.saturating_sub(tolerance) }
    };
    Some(Circle {
        feature,
        nominal,
        centre_limits: [about(nominal_1, axis_1.tolerance), about(nominal_2, axis_2.tolerance)],
        diameter_limits: compared(result, *diameter, FoundName::DIAMETER),
        actual: Place { centre: *centre, diameter: *diameter },
        deviations: Some(Place {
            centre: [axis_1.deviation, axis_2.deviation],
            diameter: diameter.saturating_sub(nominal.diameter),
        }),
    })
}

fn coordinate(result: &CycleResult) -> Option<Coordinate> {
    use crate::probing::cycle::FoundName;
    let actual = length(result.value(160))?;
    let not_monitored = LimitPair { maximum: Length::ZERO, minimum: Length::ZERO };
    let limits = compared(result, actual, FoundName::COORDINATE).unwrap_or(not_monitored);
    Some(Coordinate { nominal: None, limits, actual })
}

fn point(result: &CycleResult, heading: &Heading) -> Option<PointLog> {
    let inputs = |keys: [u16; 3]| lengths(keys.map(|key| result.inputs.value(key)));
    let found = |keys: [u16; 3]| lengths(keys.map(|key| result.value(key)));
    let [normal_1, normal_2, normal_3] = [581, 582, 583].map(|key: u16| match result.inputs.value(key) {
        Some(Value::Number(number)) => Some(*number),
        _ => None,
    });
    let deviation = length(result.value(164))?;
    let tolerance = result.inputs.value(Key::Qs(400));
    let band = match tolerance {
        Some(Value::Band(Some(band))) => Some(Band { upper: band.upper(), lower: band.lower() }),
        _ => None,
    };
    Some(PointLog {
        date_time: heading.date_time,
        program: heading.program.clone(),
        unit: heading.unit,
        nominal: inputs([263, 264, 294])?,
        normal: [normal_1?, normal_2?, normal_3?],
        measured: found([151, 152, 153])?,
        deviations: found([161, 162, 163])?,
        deviation,
        tolerance: tolerance.map(ToString::to_string).unwrap_or_default(),
        band,
        status: band.map(|band| band.status(deviation)),
    })
}

fn lengths([x, y, z]: [Option<&Value>; 3]) -> Option<[Length; 3]> {
    Some([length(x)?, length(y)?, length(z)?])
}

/// The worst that a log's figures say: diameter or coordinate by its limits, a centre out of position is scrap.
fn status(values: &Values) -> Option<Status> {
    match values {
        Values::Circle(circle) => {
            let size = circle.diameter_limits.map(|LimitPair { maximum, minimum }| {
                classify(circle.feature, minimum, maximum, circle.actual.diameter)
            });
            let monitored = circle.centre_limits.into_iter().zip(circle.actual.centre);
            let axes = monitored.filter(|(limits, _)| limits.minimum < limits.maximum).map(|(limits, actual)| {
                let within = limits.minimum <= actual && actual <= limits.maximum;
                if within { Status::Good } else { Status::Scrap }
            });
            size.into_iter().chain(axes).max()
        }
        Values::Coordinate(coordinate) => {
            let LimitPair { maximum, minimum } = coordinate.limits;
            let monitored = maximum != Length::ZERO || minimum != Length::ZERO;
            monitored.then(|| classify(Feature::Shaft, minimum, maximum, coordinate.actual))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::control::log444::PointFault;
    use crate::words::{Language, Words};

    #[track_caller]
    fn said(what: &(impl std::fmt::Display + Say)) -> String {
        let english = what.to_string();
        assert_eq!(Words::new(Language::En).told(what), english);
        let dutch = Words::new(Language::Nl).told(what);
        assert!(dutch != english && dutch != what.message().id, "{dutch}");
        english
    }

    #[test]
    fn errors_and_warnings_are_said_in_english_and_dutch() {
        said(&CycleLogError::Text(LogWriteError::Unfinished));
        said(&CycleLogError::Page(PointLogError { line: 1, fault: PointFault::NoLog }));
        let other = OtherVerdict { cycle: Status::Scrap, log: Status::Good, unit: Unit::Inch };
        assert_eq!(said(&other), "the log's values, rounded to 0.0001 inch, give GOOD where the cycle gave SCRAP");
    }
}
