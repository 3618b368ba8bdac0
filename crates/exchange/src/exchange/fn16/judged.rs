//! A print as a measurement: judged by its callout, or by the limits that were printed.

use std::sync::Arc;

use fitcheck_core::length::{Length, Unit};
use fitcheck_core::message::FilePlace;
use fitcheck_core::probing::Origin;
use fitcheck_core::probing::cycle::{Cycle, FigureKind};
use fitcheck_core::probing::cycles::{CYCLES, cycle};
use fitcheck_core::tolerance::{Callout, Deviations, Feature, Limits, Source as LimitSource};
use fitcheck_nc::control::log::layout;
use fitcheck_nc::control::mask::{FieldContent, Printed, Slot};
use fitcheck_nc::control::status::status_of;
use jiff::civil::{Date, DateTime, Time};

use super::fields::{Reading, ReadingKind, length, value};
use super::roles::{Roles, asked, is_printed, last_digit, limits};
use crate::exchange::characteristic::{Characteristic, CharacteristicKind, Value};
use crate::exchange::claim::Claim;
use crate::exchange::error::{ImportErrorKind, ImportWarningKind};
use crate::exchange::given::shorten;
use crate::exchange::imported::{Coordinate, Labels, Sink, StatedLimits, Unjudged, WhyUnjudged};
use crate::exchange::point_log;
use crate::exchange::quantity::is_shape;
use crate::exchange::source::Context;

/// What a print is judged with.
pub(super) struct PrintJudging<'a> {
    pub(super) slots: &'a [Slot],
    pub(super) roles: &'a Roles,
    pub(super) context: &'a Context<'a>,
    /// Whether a plan judges what is read: it may know that a value is no diameter.
    pub(super) has_plan: bool,
}

/// What a print says besides its value.
struct PrintFacts {
    line: usize,
    name: String,
    time: DateTime,
    labels: Labels,
    /// What the print says of the status.
    claims: Vec<Claim>,
    /// Whether the cycle that the name ends with measures inside or outside, or a word of the print says it.
    feature: Option<Feature>,
    /// Whether a simulation printed it.
    is_simulated: bool,
}

impl PrintJudging<'_> {
    /// Judges the values of a print that begins at a line.
    pub(super) fn judge(&self, line: usize, printed: &Printed, is_simulated: bool, sink: &mut Sink<'_>) {
        let name = self.roles.name.and_then(|at| value(printed, at)).unwrap_or("");
        let side = self.roles.side.and_then(|at| value(printed, at)).and_then(is_shape).map(side);
        let feature = cycle_in(name).map(|cycle| cycle.shape().feature()).or(side);
        let place = self.roles.centre.map(|centre| centre.map(|at| length(printed, at)));
        let place = place.map_or([None; 3], |[x, y]| [x, y, None]);
        let said = PrintFacts {
            line,
            name: name.to_owned(),
            time: self.time(line, printed, sink),
            labels: Labels { place, ..self.roles.part.labels(printed) },
            claims: self.claims(printed),
            feature,
            is_simulated,
        };
        for reading in &self.roles.readings {
            let labels = Labels { claims: self.claims_of(&said, reading, printed), ..said.labels.clone() };
            let name = self.name_of(&said, reading);
            let said = PrintFacts { labels, name, claims: Vec::new(), ..said };
            self.reading(&said, reading, printed, sink);
        }
    }

    /// What the print says of a value: with a status of its own this one, else that of the part. A part is good where all of its values
    /// are; which one is not, only a status of its own tells.
    fn claims_of(&self, said: &PrintFacts, reading: &Reading, printed: &Printed) -> Vec<Claim> {
        let word = |at| value(printed, at).and_then(|word| Some(Claim::of(word, status_of(word)?)));
        let is_alone = self.roles.readings.len() == 1 || reading.name.is_empty();
        match reading.status.and_then(word) {
            Some(own) => vec![own],
            None if is_alone => said.claims.clone(),
            None => said.claims.iter().filter(|claim| claim.is_of_each()).cloned().collect(),
        }
    }

    /// What a value is called: as the mask calls it, else as the print does.
    fn name_of(&self, said: &PrintFacts, reading: &Reading) -> String {
        if !reading.name.is_empty() {
            return reading.name.clone();
        }
        if self.roles.readings.len() == 1 {
            return said.name.clone();
        }
        let of = self.slots.get(reading.measured).map_or_else(String::new, |slot| slot.of.to_string());
        format!("{} {of}", said.name).trim_start().to_owned()
    }

    /// What the print says of the status: its word, and the markers of the cycle.
    fn claims(&self, printed: &Printed) -> Vec<Claim> {
        let word = self.roles.status.and_then(|at| value(printed, at)).filter(|word| !word.is_empty());
        let word =
            word.map(|word| status_of(word).map_or_else(|| Claim::unknown(word), |status| Claim::of(word, status)));
        let markers = self.roles.markers(printed);
        word.into_iter().chain(markers).collect()
    }

    fn reading(&self, said: &PrintFacts, reading: &Reading, printed: &Printed, sink: &mut Sink<'_>) {
        let text = value(printed, reading.measured).unwrap_or("");
        let measured = match Length::parse_in(&shorten(text), Unit::Millimetre) {
            Ok(measured) if reading.kind != ReadingKind::Size || Length::ZERO < measured => measured,
            Ok(measured) if self.has_plan => {
                let why = WhyUnjudged::NotPositive { given: shorten(text), column: 1 };
                return self.set_aside(said, measured, why, sink);
            }
            Ok(_) => {
                let reason = ImportErrorKind::NotPositive { given: shorten(text) };
                return sink.refuse(FilePlace::line(said.line), reason, shorten(text));
            }
            Err(error) => {
                return sink.refuse(FilePlace::line(said.line), ImportErrorKind::Measured(error), shorten(text));
            }
        };
        // The control itself has no status for this: it may have measured nothing.
        if let Some(undefined) = self.roles.undefined(printed) {
            return self.set_aside(said, measured, WhyUnjudged::NotValid { said: undefined }, sink);
        }
        let pair = reading.minimum.zip(reading.maximum);
        let pair = pair.and_then(|(minimum, maximum)| Some((length(printed, minimum)?, length(printed, maximum)?)));
        // As in the cycles, limits of 0 mean that nothing is compared.
        let pair = pair.filter(|pair| *pair != (Length::ZERO, Length::ZERO));
        match reading.kind {
            ReadingKind::Size => self.size(said, reading, (printed, measured, pair), sink),
            ReadingKind::Coordinate => {
                let judged = pair.and_then(|pair| self.compared(coordinate_cycle()?, pair, measured));
                let why = judged.map_or(WhyUnjudged::CoordinateWithoutLimits, WhyUnjudged::Coordinate);
                self.set_aside(said, measured, why, sink);
            }
            ReadingKind::Point => {
                let band = self.roles.band.and_then(|at| value(printed, at)).and_then(band);
                let judged = band.and_then(|band| self.deviating(band, measured));
                let why = judged.map_or(WhyUnjudged::PointWithoutTolerance, WhyUnjudged::Point);
                self.set_aside(said, measured, why, sink);
            }
        }
    }

    /// A coordinate against its limits, as in the log of its cycle.
    fn compared(&self, cycle: &Cycle, (minimum, maximum): (Length, Length), measured: Length) -> Option<Coordinate> {
        let deviations = Deviations::new(maximum.checked_sub(minimum)?, Length::ZERO).ok()?;
        let from = LimitSource::File(Arc::clone(&self.context.file));
        let limits = Limits::new(cycle.shape().feature(), minimum, deviations, from)?;
        Some(Coordinate::judged(cycle.code, None, &limits, measured))
    }

    /// A deviation along the normal against its band, as in the log of points.
    fn deviating(&self, (lower, upper): (Length, Length), measured: Length) -> Option<Coordinate> {
        let from = LimitSource::File(Arc::clone(&self.context.file));
        let limits = Limits::new(Feature::Shaft, Length::ZERO, Deviations::new(upper, lower).ok()?, from)?;
        Some(Coordinate::judged(point_log::cycle_of_points(), Some(Length::ZERO), &limits, measured))
    }

    fn set_aside(&self, said: &PrintFacts, measured: Length, why: WhyUnjudged, sink: &mut Sink<'_>) {
        if let WhyUnjudged::Coordinate(judged) | WhyUnjudged::Point(judged) = &why {
            for warning in said.labels.claims.iter().filter_map(|claim| claim.differs(judged.status)) {
                sink.warn(FilePlace::line(said.line), Some(said.line), warning);
            }
        }
        let file = Arc::clone(&self.context.file);
        sink.set_aside(Unjudged {
            line: said.line,
            id: said.name.clone(),
            labels: said.labels.clone(),
            time: said.time,
            measured: Some(measured),
            origin: if said.is_simulated { Origin::ImportedSimulation { file } } else { Origin::Imported { file } },
            position: None,
            asked: StatedLimits::default(),
            correction: None,
            why,
        });
    }

    fn size(
        &self,
        said: &PrintFacts,
        reading: &Reading,
        (printed, measured, pair): (&Printed, Length, Option<(Length, Length)>),
        sink: &mut Sink<'_>,
    ) {
        let at = reading.callout.or(self.roles.callout);
        let callout = asked(printed, at, reading.nominal.or(self.roles.nominal));
        let given = at.and_then(|at| value(printed, at)).unwrap_or("");
        // Limits that were printed with fewer digits than they have are those of the class.
        let of_class = callout.and_then(|callout| limits(&callout, self.context.sources));
        let is_of_class = of_class.is_some_and(|limits| {
            let is = |at: Option<usize>, limit| {
                at.and_then(|at| value(printed, at)).is_some_and(|text| is_printed(limit, text))
            };
            is(reading.minimum, limits.minimum()) && is(reading.maximum, limits.maximum())
        });
        let pair = pair.filter(|_| !is_of_class);
        let labels = Labels { rounded_by: rounded_by(value(printed, reading.measured)), ..said.labels.clone() };
        let nominal = || length(printed, reading.nominal.or(self.roles.nominal)?);
        // A class says it itself.
        let said_side = || reading.is_hole.map(side).or(said.feature);
        let is_said = callout.is_some_and(|callout| callout.feature().is_some());
        let characteristic = Characteristic {
            name: said.name.clone(),
            what: CharacteristicKind::Size,
            class: callout.map_or_else(|| given.to_owned(), |callout| class_of(&callout)),
            feature: if is_said { None } else { said_side() },
            nominal: callout.map(|callout| callout.nominal()).or_else(nominal),
            minimum: pair.map(|pair| pair.0),
            maximum: pair.map(|pair| pair.1),
            expanded: None,
            labels: labels.clone(),
        };
        let value = Value { line: said.line, measured, time: Some(said.time), labels, is_simulated: said.is_simulated };
        characteristic.judge(value, self.context, sink);
    }

    /// When it was printed; the time of import where the mask prints no date, and with a warning where there is none such.
    fn time(&self, line: usize, printed: &Printed, sink: &mut Sink<'_>) -> DateTime {
        let word = |word: &str| {
            let mut slots = (0..).zip(self.slots);
            slots.find_map(|(at, slot)| {
                value(printed, at).filter(|_| matches!(slot.of, FieldContent::Word(of) if of == word))
            })
        };
        let year = word("YEAR4").map(str::to_owned).or_else(|| word("YEAR2").map(|year| format!("20{year:0>2}")));
        let (Some(year), Some(month), Some(day)) = (year, word("MONTH"), word("DAY")) else { return self.context.now };
        let clock = ["HOUR", "MIN", "SEC"].map(|part| word(part).unwrap_or("0"));
        let read = || {
            let date = Date::new(year.parse().ok()?, month.parse().ok()?, day.parse().ok()?).ok()?;
            let [hour, minute, second] = clock.map(|part| part.parse().ok());
            Some(date.to_datetime(Time::new(hour?, minute?, second?, 0).ok()?))
        };
        read().unwrap_or_else(|| {
            let given = format!("{year}-{month}-{day} {}", clock.join(":"));
            sink.warn(FilePlace::line(line), Some(line), ImportWarningKind::Time { given: shorten(&given) });
            self.context.now
        })
    }
}

/// Hole or shaft.
const fn side(is_hole: bool) -> Feature {
    if is_hole { Feature::Hole } else { Feature::Shaft }
}

/// How far a value may be from what was printed of it, by the decimals that were printed.
fn rounded_by(text: Option<&str>) -> Length {
    Length::from_nanometres(text.map_or(0, last_digit) / 2).unwrap_or(Length::ZERO)
}

/// What stands behind the nominal size of a callout.
fn class_of(callout: &Callout) -> String {
    let text = callout.to_string();
    let nominal = callout.nominal().to_string();
    text.strip_prefix(&nominal).unwrap_or(&text).trim().to_owned()
}

/// The cycle that measures one coordinate.
fn coordinate_cycle() -> Option<&'static Cycle> {
    let is_one = |cycle: &&&Cycle| {
        layout(cycle.number).is_some_and(|log| log.figures.iter().all(|figure| figure.kind == FigureKind::Coordinate))
    };
    CYCLES.iter().find(is_one).copied()
}

/// The cycle in brackets behind what was checked, as the window of a cycle has it.
fn cycle_in(name: &str) -> Option<&'static Cycle> {
    let (_, behind) = name.rsplit_once('(')?;
    cycle(behind.strip_suffix(')')?.parse().ok()?)
}

/// The lower and the upper limit of a band as in QS400: `0.4-0.1`, `0.4`, `-0.1`.
fn band(text: &str) -> Option<(Length, Length)> {
    let length = |text: &str| Length::parse_in(text, Unit::Millimetre).ok();
    let second = text.char_indices().skip(1).find(|(_, c)| matches!(c, '+' | '-'));
    let Some((upper, lower)) = second.and_then(|(at, _)| text.split_at_checked(at)) else {
        let one = length(text)?;
        return Some((one.min(Length::ZERO), one.max(Length::ZERO)));
    };
    Some((length(lower)?, length(upper)?))
}
