//! Logs of points as deviations along the normal: these are not features of size, so none of them makes a record.
//!
//! The status is computed from deviation and tolerance; a log that has a different status is refused when it is read.

use std::sync::Arc;

use fitcheck_core::length::Length;
use fitcheck_core::message::FilePlace;
use fitcheck_core::probing::Origin;
use fitcheck_core::probing::cycle::Log;
use fitcheck_core::probing::cycles::CYCLES;
use fitcheck_core::text;
use fitcheck_core::tolerance::{Deviations, Feature, Limits, LimitsError, Source as LimitSource};
use fitcheck_nc::control::point_log::{self, Band, PointLog};

use super::error::ImportErrorKind;
use super::imported::{Coordinate, Sink, StatedLimits, Unjudged, WhyUnjudged};
use super::source::{Context, Source};
use super::{Format, Labels};

pub(super) const FORMAT: Format = Format {
    name: "log-444",
    endings: &["html", "htm"],
    description: "exchange-format-log-444",
    recognises: |beginning| point_log::is_log(&beginning.text()),
    read,
    plan: None,
    line_ends: b"",
    has_marks: true,
    shows_end: true,
};

fn read(source: &mut Source<'_>, sink: &mut Sink<'_>) -> Result<(), ImportErrorKind> {
    let bytes = source.whole()?;
    let page = text::decode(&bytes);
    for answer in point_log::each(&page) {
        let line = answer.as_ref().map_or_else(|error| error.place.line.unwrap_or(1), |(line, _)| *line);
        if sink.is_full(line) {
            break;
        }
        match answer {
            Ok((line, log)) => add(sink, line, &log, &source.context),
            Err(error) => {
                let given = error.what.given();
                sink.refuse(error.place, ImportErrorKind::Point(error.what), given);
            }
        }
    }
    Ok(())
}

fn add(sink: &mut Sink<'_>, line: usize, log: &PointLog, source: &Context<'_>) {
    let why = match log.band.map(|band| judged(log, band, source)) {
        None => WhyUnjudged::PointWithoutTolerance,
        Some(Some(coordinate)) => WhyUnjudged::Point(coordinate),
        Some(None) => {
            let reason = ImportErrorKind::Limits(LimitsError::TooLarge { nominal: Length::ZERO });
            return sink.refuse(FilePlace::line(line), reason, log.tolerance.clone());
        }
    };
    let file = Arc::clone(&source.file);
    sink.set_aside(Unjudged {
        line,
        id: String::new(),
        // Where the point should lie: by it a plan finds its feature.
        labels: Labels { place: log.nominal.map(Some), ..Labels::default() },
        time: log.date_time.unwrap_or(source.now),
        measured: Some(log.deviation),
        origin: if log.is_simulated { Origin::ImportedSimulation { file } } else { Origin::Imported { file } },
        position: None,
        asked: StatedLimits::default(),
        correction: None,
        why,
    });
}

/// The deviation is judged as a shaft is: oversize can be machined off, undersize cannot be put back.
fn judged(log: &PointLog, band: Band, source: &Context<'_>) -> Option<Coordinate> {
    let deviations = Deviations::new(band.upper, band.lower).ok()?;
    let from = LimitSource::File(Arc::clone(&source.file));
    let limits = Limits::new(Feature::Shaft, Length::ZERO, deviations, from)?;
    Some(Coordinate::judged(cycle_of_points(), Some(Length::ZERO), &limits, log.deviation))
}

/// The name of the cycle that writes such logs, as programs know it.
pub(super) fn cycle_of_points() -> &'static str {
    CYCLES.iter().find(|cycle| matches!(cycle.log, Log::Points { .. })).map_or("", |cycle| cycle.code)
}
