//! Lines of gauges that a terminal or a box has saved in a file, one value in each.
//!
//! Most of them say neither millimetres nor inches. Then the user says it (`unit` of a mapping), and until then the file is refused: digits
//! alone do not tell a value of 0.1 mm from one of 0.1 in. A plain list of numbers is a CSV.

use std::sync::Arc;

use fitcheck_core::length::Unit;
use fitcheck_core::message::FilePlace;
use fitcheck_core::probing::Origin;
use fitcheck_core::text::{LINE_END_BYTES, lines};

use super::{FRAME, GaugeError, GaugeRemark, Gauged, LineUnit, channel, is_error_text, read_line};
use crate::exchange::error::ImportErrorKind;
use crate::exchange::given::shorten;
use crate::exchange::imported::{Sink, StatedLimits, Unjudged, WhyUnjudged};
use crate::exchange::printed::{PrintedLine, each_line};
use crate::exchange::source::{Beginning, Source};
use crate::exchange::{Format, Labels};

pub(in crate::exchange) const FORMAT: Format = Format {
    name: "gauge",
    endings: &["txt"],
    description: "exchange-format-gauge",
    recognises,
    read,
    plan: None,
    line_ends: LINE_END_BYTES,
    has_marks: true,
    shows_end: true,
};

/// A line taken apart: the channel or the number of the feature, and the rest.
fn split(text: &str) -> (&str, &str) {
    let bare = text.trim_matches(FRAME);
    if let (Some(channel), rest) = channel(bare) {
        return (channel, rest);
    }
    // `1 +0012.345 mm =`
    match bare.split_once(' ') {
        Some((number, rest)) if number.len() == 1 && number.bytes().all(|byte| byte.is_ascii_digit()) => {
            let rest = rest.trim_start();
            if rest.starts_with(['+', '-']) { (number, rest) } else { ("", bare) }
        }
        _ => ("", bare),
    }
}

/// The value of a line, in what it says or else in this unit.
fn value(text: &str, unit: LineUnit) -> Result<(&str, Gauged), GaugeError> {
    let (channel, rest) = split(text);
    if channel.is_empty() && is_error_text(rest) {
        return Err(GaugeError::ErrorText { given: rest.to_owned() });
    }
    Ok((channel, read_line(rest, unit, None)?))
}

/// Whether all lines are those of a gauge, of which fewer than half may be broken, and one has what nothing else would write.
fn recognises(beginning: &Beginning<'_>) -> bool {
    let mut is_marked = false;
    let (mut whole, mut broken) = (0, 0);
    let text = beginning.text();
    let mut all = lines(&text).map(|(_, line)| line).filter(|line| !line.trim_matches(FRAME).is_empty());
    let is_of_gauge = all.all(|line| match value(line, LineUnit::Mm) {
        Ok((channel, gauged)) => {
            let is_opinion = |remark: &GaugeRemark| matches!(remark, GaugeRemark::Opinion { .. });
            let has_comma = line.rsplit_once(',').is_some_and(|(_, unit)| unit.contains(char::is_alphabetic));
            is_marked |= !channel.is_empty() || has_comma || gauged.remarks.iter().any(is_opinion);
            whole += 1;
            true
        }
        Err(GaugeError::ErrorText { .. }) => true,
        Err(_) => {
            broken += 1;
            let (channel, rest) = split(line);
            !channel.is_empty() || rest.starts_with(['+', '-'])
        }
    });
    is_of_gauge && is_marked && broken <= whole
}

fn read(source: &mut Source<'_>, sink: &mut Sink<'_>) -> Result<(), ImportErrorKind> {
    let unit = match source.given_unit() {
        None | Some(Unit::Micrometre) => LineUnit::Said,
        Some(Unit::Millimetre) => LineUnit::Mm,
        Some(Unit::Inch) => LineUnit::Inch,
    };
    let mut open = None;
    each_line(source, &mut |line| {
        // A line that is cut off may have lost its unit.
        let is_open = !line.is_open && matches!(value(line.text, unit), Err(GaugeError::NoUnit { .. }));
        open = open.take().or_else(|| is_open.then(|| (line.number, shorten(line.text.trim_matches(FRAME)))));
        open.is_none()
    })?;
    if let Some((line, given)) = open {
        return Err(ImportErrorKind::GaugeUnit { line, given });
    }
    let file = Arc::clone(&source.context.file);
    let now = source.context.now;
    let mut before = None;
    each_line(source, &mut |line| {
        if sink.is_full(line.number) {
            return false;
        }
        let PrintedLine { number, text, .. } = line;
        // As long as the line before it, and with its unit if that has one, it lacks nothing but its end.
        let shape = Some((text.len(), value(text, LineUnit::Said).is_ok()));
        let read = match line.broken(before == shape) {
            Some(kind) => Err(kind),
            None => value(text, unit).map_err(ImportErrorKind::Gauge),
        };
        before = shape;
        match read {
            Ok((channel, gauged)) => sink.set_aside(Unjudged {
                line: number,
                id: channel.to_owned(),
                labels: Labels::default(),
                time: now,
                measured: Some(gauged.value),
                origin: Origin::Imported { file: Arc::clone(&file) },
                position: None,
                asked: StatedLimits::default(),
                correction: None,
                why: WhyUnjudged::NoCallout,
            }),
            Err(kind) => {
                sink.refuse(FilePlace::line(number), kind, shorten(text.trim_matches(FRAME)));
            }
        }
        true
    })?;
    if sink.rows() == 0 { Err(ImportErrorKind::NoRows) } else { Ok(()) }
}
