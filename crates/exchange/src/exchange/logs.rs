//! HEIDENHAIN measuring logs as records.
//!
//! The limits come from the log, which has no callout. The verdict is computed: a log holds no status. A diameter makes
//! a record; widths, sides and coordinates are judged, but make none.

use std::path::Path;
use std::sync::Arc;

use fitcheck_core::length::{Length, LengthError};
use fitcheck_core::message::FilePlace;
use fitcheck_core::probing::cycle::{Axis, Cycle, FigureKind, Meaning, ResultName, TextLog};
use fitcheck_core::probing::cycles::cycle;
use fitcheck_core::probing::{Measurement, Origin};
use fitcheck_core::text;
use fitcheck_core::tolerance::{Deviations, Feature, Limits, Source as LimitSource};
use fitcheck_core::verdict::{AxisPosition, PositionVerdict};
use fitcheck_nc::control::log::{self, Figure, LimitPair, Log, LogError, Logs, layout};
use jiff::civil::DateTime;

use super::error::{ImportErrorKind, ImportWarningKind};
use super::imported::{Coordinate, Sink, StatedLimits, Unjudged, WhyUnjudged};
use super::source::{Beginning, Context, Source};
use super::{Format, Labels};
use crate::journal::Record;

pub(super) const FORMAT: Format = Format {
    name: "log",
    endings: &["txt"],
    description: "exchange-format-logs",
    recognises,
    read,
    plan: None,
    line_ends: text::LINE_END_BYTES,
    has_marks: true,
    shows_end: true,
};

/// The control's fixed names, `TCHPR421.TXT`, or a text with the shape of a log.
fn recognises(beginning: &Beginning<'_>) -> bool {
    let name = beginning.file.to_ascii_uppercase();
    name.starts_with("TCHPR4") && Path::new(&name).extension().is_some_and(|ending| ending == "TXT")
        || log::is_log(&beginning.text())
}

fn read(source: &mut Source<'_>, sink: &mut Sink<'_>) -> Result<(), ImportErrorKind> {
    let context = source.context.clone();
    let mut pieces = source.pieces(text::LINE_END_BYTES)?;
    let mut logs = Logs::default();
    let mut line = 1;
    // Where the next log begins at the earliest, and the last line that is not blank.
    let mut first = 1;
    let mut last = 1;
    while let Some(piece) = pieces.next()? {
        for (number, text, is_open) in text::lines_open_from(&piece, line) {
            line = number + 1;
            if let Some(log) = logs.line(number, text, is_open) {
                sink.unit(log.as_ref().map_or(first, |log| log.line), last);
                first = number;
                if !take(sink, log, &context) {
                    return Ok(());
                }
            }
            last = if text.trim().is_empty() { last } else { number };
        }
    }
    if let Some(log) = logs.end() {
        sink.unit(log.as_ref().map_or(first, |log| log.line), last);
        take(sink, log, &context);
    }
    Ok(())
}

/// Takes a log; `false` where no more are wanted.
fn take(sink: &mut Sink<'_>, log: Result<Log, LogError>, context: &Context<'_>) -> bool {
    let line = log.as_ref().map_or_else(|error| error.place.line.unwrap_or(1), |log| log.line);
    if sink.is_full(line) {
        return false;
    }
    match log {
        Ok(log) => add(sink, log, context),
        Err(error) => {
            let given = error.what.given();
            sink.refuse(error.place, ImportErrorKind::Log(error.what), given);
        }
    }
    true
}

fn add(sink: &mut Sink<'_>, log: Log, source: &Context<'_>) {
    // The reader knows the cycle of every log that it has read.
    let Some((cycle, layout)) = cycle(log.cycle).zip(layout(log.cycle)) else { return };
    let file = Arc::clone(&source.file);
    let read = LogFacts {
        cycle,
        line: log.line,
        time: log.date_time().unwrap_or(source.now),
        id: id(&source.file),
        position: position(layout, &log.figures),
        centre: centre(layout, &log.figures),
        labels: labels(layout, &log.figures),
        origin: if log.is_simulated { Origin::ImportedSimulation { file } } else { Origin::Imported { file } },
    };
    for warning in log.warnings {
        sink.warn(warning.place, Some(log.line), ImportWarningKind::Log(warning.what));
    }
    let mut sizes = layout.figures.iter().zip(&log.figures).filter_map(|(of, figure)| match of.kind {
        FigureKind::Size(Meaning::Diameter) => Some((None, read.diameter(figure, source))),
        FigureKind::Size(Meaning::Side(axis)) => {
            Some((Some(usize::from(axis != Axis::First)), read.size(of.what, of.kind, figure, source)))
        }
        FigureKind::Size(_) | FigureKind::Coordinate => Some((None, read.size(of.what, of.kind, figure, source))),
        FigureKind::Centre(_) | FigureKind::Information => None,
    });
    // The centre is reported with the first size.
    let Some((side, first)) = sizes.next() else { return };
    first.add(sink, &read, side, read.position);
    sizes.for_each(|(side, other)| other.add(sink, &read, side, None));
}

/// What all sizes of a log share.
struct LogFacts {
    cycle: &'static Cycle,
    line: usize,
    time: DateTime,
    id: String,
    position: Option<PositionVerdict>,
    centre: Option<[Length; 2]>,
    labels: Labels,
    origin: Origin,
}

/// What a size of a log becomes.
enum LogSize {
    Record(Box<Record>),
    Unjudged { measured: Length, why: WhyUnjudged },
    Refused { reason: ImportErrorKind, given: String },
}

impl LogSize {
    fn add(self, sink: &mut Sink<'_>, read: &LogFacts, side: Option<usize>, position: Option<PositionVerdict>) {
        let line = read.line;
        let time = read.time;
        let id = read.id.clone();
        let labels = Labels { side, ..read.labels.clone() };
        match self {
            Self::Record(record) => sink.keep(line, *record, labels),
            Self::Unjudged { measured, why } => {
                let measured = Some(measured);
                let origin = read.origin.clone();
                let asked = StatedLimits::default();
                let correction = None;
                sink.set_aside(Unjudged { line, id, labels, time, measured, origin, position, asked, correction, why });
            }
            Self::Refused { reason, given } => sink.refuse(FilePlace::line(line), reason, given),
        }
    }
}

impl LogFacts {
    /// A diameter makes a record, with the centre's position.
    fn diameter(&self, figure: &Figure, source: &Context<'_>) -> LogSize {
        let measured = figure.actual;
        // Limits of a log without a nominal size count from 0.
        let nominal = figure.nominal.unwrap_or(Length::ZERO);
        let Some(pair) = figure.limits else {
            return LogSize::Unjudged { measured, why: WhyUnjudged::NoLimits { nominal } };
        };
        let feature = self.cycle.shape().feature();
        let Some(limits) = limits(feature, nominal, pair, &source.file) else {
            let reason =
                ImportErrorKind::Limits(fitcheck_core::tolerance::LimitsError::TooLarge { nominal: pair.maximum });
            return LogSize::Refused { reason, given: pair.maximum.to_string() };
        };
        if let Err(error) = source.sources.proportionate(&limits.bounds()) {
            return LogSize::Refused {
                reason: ImportErrorKind::Limits(error),
                given: format!("{}/{}", pair.maximum, pair.minimum),
            };
        }
        let measurement = Measurement::of_diameter(measured, self.origin.clone());
        let measurement = Measurement { centre: self.centre, ..measurement };
        LogSize::Record(Box::new(Record::judged(self.time, self.id.clone(), None, limits, measurement, self.position)))
    }

    /// Any other size, or a coordinate: its status, and no record.
    fn size(&self, what: ResultName, kind: FigureKind, figure: &Figure, source: &Context<'_>) -> LogSize {
        let measured = figure.actual;
        let is_coordinate = kind == FigureKind::Coordinate;
        let Some(pair) = figure.limits else {
            // As in the cycle itself, limits of 0 mean that nothing is monitored.
            let why = if is_coordinate {
                WhyUnjudged::CoordinateWithoutLimits
            } else {
                WhyUnjudged::SizeWithoutLimits { what }
            };
            return LogSize::Unjudged { measured, why };
        };
        let feature = self.cycle.shape().feature();
        let Some(limits) = limits(feature, pair.minimum, pair, &source.file) else {
            let given = pair.maximum.to_string();
            return LogSize::Refused {
                reason: ImportErrorKind::Measured(LengthError::TooLarge { text: given.clone() }),
                given,
            };
        };
        let in_proportion = if is_coordinate {
            source.sources.proportionate_coordinate(limits.nominal, limits.deviations)
        } else {
            source.sources.proportionate(&limits.bounds())
        };
        if let Err(error) = in_proportion {
            return LogSize::Refused {
                reason: ImportErrorKind::Limits(error),
                given: format!("{}/{}", pair.maximum, pair.minimum),
            };
        }
        let judged = Coordinate::judged(self.cycle.code, figure.nominal, &limits, measured);
        let why = if is_coordinate { WhyUnjudged::Coordinate(judged) } else { WhyUnjudged::Size { what, judged } };
        LogSize::Unjudged { measured, why }
    }
}

/// The name that a user gave the file, because users keep one file per feature; the control's own name says nothing.
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

/// The measured centre.
fn centre(layout: &TextLog, figures: &[Figure]) -> Option<[Length; 2]> {
    centre_figures(layout, figures).map(|figure| figure.actual).collect::<Vec<_>>().try_into().ok()
}

/// Where the centre should be.
fn labels(layout: &TextLog, figures: &[Figure]) -> Labels {
    let mut nominal = centre_figures(layout, figures).map(|figure| figure.nominal);
    let mut axis = || nominal.next().flatten();
    Labels { place: [axis(), axis(), None], ..Labels::default() }
}

/// The centre by the log's own limits: a tolerance of 0 means that the axis is not monitored.
fn position(layout: &TextLog, figures: &[Figure]) -> Option<PositionVerdict> {
    let of = |figure: &Figure| Some(axis(figure.limits?, figure.nominal?, figure.actual));
    let axes: Vec<_> = centre_figures(layout, figures).filter_map(of).collect();
    Some(PositionVerdict { axes: axes.try_into().ok()? })
}

/// The figures of a log for the centre's axes.
fn centre_figures<'a>(layout: &TextLog, figures: &'a [Figure]) -> impl Iterator<Item = &'a Figure> {
    let centre = layout.figures.iter().zip(figures).filter(|(of, _)| matches!(of.kind, FigureKind::Centre(_)));
    centre.map(|(_, figure)| figure)
}

/// Rounding may make the limits uneven in the last figure: the limit on the side of the centre decides.
fn axis(limits: LimitPair, nominal: Length, actual: Length) -> AxisPosition {
    let deviation = actual.saturating_sub(nominal);
    let above = limits.maximum.saturating_sub(nominal);
    let below = nominal.saturating_sub(limits.minimum);
    let tolerance = if deviation < Length::ZERO { below } else { above };
    let monitored = Length::ZERO < above || Length::ZERO < below;
    AxisPosition { deviation, tolerance: monitored.then_some(tolerance) }
}
