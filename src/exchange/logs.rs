//! HEIDENHAIN measuring logs as records.
//!
//! The limits come from the log, the callout is not in it. The verdict is computed: a log holds no status.

use std::path::Path;
use std::sync::Arc;

use super::imported::{Coordinate, Imported, Unjudged, WhyUnjudged};
use super::problem::{Reason, WarningReason};
use super::{Format, Source};
use crate::control::log::{self, Circle, LimitPair, Log, Values};
use crate::journal::Record;
use crate::length::{Length, LengthError};
use crate::message::Place;
use crate::probing::{Measurement, Origin};
use crate::tolerance::{Deviations, Feature, Limits, Source as LimitSource};
use crate::verdict::{AxisPosition, PositionVerdict, judge_size};

pub(super) const FORMAT: Format =
    Format { name: "log", endings: &["txt"], description: "exchange-format-logs", recognises, read };

/// The control's fixed names, `TCHPR421.TXT`, or a text that has the shape of a log.
fn recognises(source: &Source<'_>) -> bool {
    let name = source.file.to_ascii_uppercase();
    name.starts_with("TCHPR4") && Path::new(&name).extension().is_some_and(|ending| ending == "TXT")
        || log::is_log(&source.head())
}

fn read(source: &Source<'_>) -> Imported {
    let mut imported = Imported::default();
    for log in log::read(source.bytes) {
        match log {
            Ok(log) => add(&mut imported, log, source),
            Err(error) => {
                let given = error.reason.given();
                let place = Place { column: error.column, ..Place::line(error.line) };
                imported.refuse(place, Reason::Log(error.reason), given);
            }
        }
    }
    imported
}

fn add(imported: &mut Imported, log: Log, source: &Source<'_>) {
    let line = log.line;
    let time = log.date_time().unwrap_or(source.now);
    let id = id(&source.file);
    match log.values {
        Values::Circle(circle) => {
            let position = Some(position(&circle));
            let Some(pair) = circle.diameter_limits else {
                let why = WhyUnjudged::NoLimits { nominal: circle.nominal.diameter };
                let measured = Some(circle.actual.diameter);
                return finish(imported, log.warnings, line, |imported| {
                    imported.set_aside(Unjudged { line, id, time, measured, position, why });
                });
            };
            let Some(limits) = limits(circle.feature, circle.nominal.diameter, pair, &source.file) else {
                let given = pair.maximum.to_string();
                let reason = Reason::Limits(crate::tolerance::LimitsError::TooLarge { nominal: pair.maximum });
                return imported.refuse(Place::line(line), reason, given);
            };
            let measured = circle.actual.diameter;
            let origin = Origin::Imported { file: Arc::clone(&source.file) };
            let measurement =
                Measurement { centre: Some(circle.actual.centre), ..Measurement::of_diameter(measured, origin) };
            let record = Record::judged(time, id, None, limits, measurement, position);
            finish(imported, log.warnings, line, |imported| imported.keep(line, record));
        }
        Values::Coordinate(values) => {
            let measured = Some(values.actual);
            if values.limits.minimum == Length::ZERO && values.limits.maximum == Length::ZERO {
                // As in the cycle itself: limits of 0 monitor nothing.
                let why = WhyUnjudged::CoordinateWithoutLimits;
                return finish(imported, log.warnings, line, |imported| {
                    imported.set_aside(Unjudged { line, id, time, measured, position: None, why });
                });
            }
            // Cycle 427 assumes an outside dimension, so it is judged as a shaft is.
            let Some(limits) = limits(Feature::Shaft, values.limits.minimum, values.limits, &source.file) else {
                let given = values.limits.maximum.to_string();
                let reason = Reason::Measured(LengthError::TooLarge { text: given.clone() });
                return imported.refuse(Place::line(line), reason, given);
            };
            let verdict = judge_size(&limits, values.actual);
            let why = WhyUnjudged::Coordinate(Coordinate {
                nominal: values.nominal,
                maximum: limits.maximum(),
                minimum: limits.minimum(),
                status: verdict.status,
                removal: verdict.removal,
            });
            finish(imported, log.warnings, line, |imported| {
                imported.set_aside(Unjudged { line, id, time, measured, position: None, why });
            });
        }
    }
}

fn finish(imported: &mut Imported, warnings: Vec<log::LogWarning>, row: usize, add: impl FnOnce(&mut Imported)) {
    for warning in warnings {
        imported.warn(warning.line(), Some(row), WarningReason::Log(warning));
    }
    add(imported);
}

/// The name that a user gave the file, as users keep one file a feature; the control's own name says nothing.
fn id(file: &str) -> String {
    let stem = file.rsplit_once('.').map_or(file, |(stem, _)| stem);
    if stem.to_ascii_uppercase().starts_with("TCHPR4") { String::new() } else { stem.to_owned() }
}

fn limits(feature: Feature, nominal: Length, pair: LimitPair, file: &Arc<str>) -> Option<Limits> {
    let upper = pair.maximum.checked_sub(nominal)?;
    let lower = pair.minimum.checked_sub(nominal)?;
    let deviations = Deviations::new(upper, lower).ok()?;
    Limits::new(feature, nominal, deviations, LimitSource::File(Arc::clone(file)))
}

/// The centre by the log's own limits: a tolerance of 0 means that the axis is not monitored.
fn position(circle: &Circle) -> PositionVerdict {
    let [limits_1, limits_2] = circle.centre_limits;
    let [nominal_1, nominal_2] = circle.nominal.centre;
    let [actual_1, actual_2] = circle.actual.centre;
    PositionVerdict { axes: [axis(limits_1, nominal_1, actual_1), axis(limits_2, nominal_2, actual_2)] }
}

/// Rounding may leave the limits uneven by the last figure: the limit on the side where the centre is decides.
fn axis(limits: LimitPair, nominal: Length, actual: Length) -> AxisPosition {
    let deviation = actual.saturating_sub(nominal);
    let above = limits.maximum.saturating_sub(nominal);
    let below = nominal.saturating_sub(limits.minimum);
    let tolerance = if deviation < Length::ZERO { below } else { above };
    let monitored = Length::ZERO < above || Length::ZERO < below;
    AxisPosition { deviation, tolerance: monitored.then_some(tolerance) }
}
