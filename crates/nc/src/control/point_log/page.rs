//! Measurements of cycle 444 as a page: one table, three lines per measurement, coloured by status.
//!
//! The template is `assets/logs/points.html`, its look `points.css`, its words `assets/logs/*.toml`; the template
//! escapes every value. Nothing here decides anything.

use askama::Template;
use fitcheck_core::length::{Length, Unit};
use fitcheck_core::verdict::Status;
use fitcheck_core::words::Dialogue;

use super::error::PointLogError;
use super::point::PointLog;
use super::read::read;
use super::stored;
use crate::control::log::labels::{Labels, Surface};
use crate::control::status::status_word;

/// How dates are written: as in the report.
const DATE: &str = "%Y-%m-%d %H:%M:%S";

/// The least number of decimals: as in the control's logs. Finer figures are shown whole.
const DECIMALS: usize = 4;

#[derive(Template)]
#[template(path = "points.html", config = "../../assets/logs/askama.toml")]
struct Page {
    language: Dialogue,
    words: &'static Surface,
    count_name: &'static str,
    rows: Vec<PointRow>,
}

/// One measurement.
struct PointRow {
    number: usize,
    /// The block for programs, already escaped.
    stored: String,
    class: &'static str,
    time: String,
    program: String,
    simulated: Option<&'static str>,
    axes: [Axis; 3],
    along: String,
    unit: &'static str,
    tolerance: Vec<String>,
    tolerance_text: String,
    status: String,
}

struct Axis {
    name: &'static str,
    nominal: String,
    normal: String,
    measured: String,
    deviation: String,
}

/// Measurements as one page, with the words of a language.
///
/// The page reads back as exactly the same measurements. Whole lengths are kept for programs; the table shows at least
/// four decimals, and inches rounded to seven.
///
/// ```
/// use fitcheck_nc::control::point_log::{self, Band, PointLog};
/// use fitcheck_core::length::{Length, Unit};
/// use fitcheck_core::words::Dialogue;
///
/// let band = Band { upper: "0.4".parse()?, lower: "-0.1".parse()? };
/// let deviation = "0.0123".parse()?;
/// let log = PointLog {
///     date_time: Some(jiff::civil::date(2024, 3, 14).at(8, 5, 9, 0)),
///     program: Some(r"TNC:\PART1.H".to_owned()),
///     is_simulated: false,
///     unit: Unit::Millimetre,
///     nominal: ["10".parse()?, "20".parse()?, "5".parse()?],
///     normal: [0.0, 0.0, 1.0],
///     measured: ["10".parse()?, "20".parse()?, "5.0123".parse()?],
///     deviations: [Length::ZERO, Length::ZERO, deviation],
///     deviation,
///     tolerance: "0.4-0.1".to_owned(),
///     band: Some(band),
///     status: Some(band.status(deviation)),
/// };
/// let page = point_log::write(std::slice::from_ref(&log), Dialogue::En)?;
/// let both = point_log::append(&page, &log, Dialogue::En)?;
/// let read: Vec<_> = point_log::read(&both).into_iter().flatten().map(|(_, log)| log).collect();
/// assert_eq!(read, [log.clone(), log]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// [`PointLogError`] with the number of the first measurement that contradicts itself.
///
/// # Panics
/// Never: the template writes texts into a text.
pub fn write(logs: &[PointLog], language: Dialogue) -> Result<Vec<u8>, PointLogError> {
    let words = &Labels::of(language).surface;
    let rows = logs
        .iter()
        .zip(1..)
        .map(|(log, number)| log.check().map(|()| row(log, number, words, language)).map_err(|fault| fault.at(number)));
    let page = Page { language, words, count_name: stored::COUNT, rows: rows.collect::<Result<_, _>>()? };
    #[expect(clippy::expect_used, reason = "the template writes texts into a text, which cannot fail")]
    let page = page.render().expect("a page is a text");
    Ok(page.into_bytes())
}

/// A page with one more measurement at its end; an empty file becomes a page with one. The whole page is rewritten with
/// the words of the language.
///
/// # Errors
/// As for [`write()`]; the [`PointLogError`] of the page if it is not such a page or is damaged: nothing is added to it
/// then.
pub fn append(page: &[u8], log: &PointLog, language: Dialogue) -> Result<Vec<u8>, PointLogError> {
    let mut logs = Vec::new();
    if !page.is_empty() {
        for answer in read(page) {
            logs.push(answer?.1);
        }
    }
    logs.push(log.clone());
    write(&logs, language)
}

fn of_axis<T>(name: &str, [x, y, z]: [T; 3]) -> T {
    match name {
        "X" => x,
        "Y" => y,
        _ => z,
    }
}

fn row(log: &PointLog, number: usize, words: &'static Surface, language: Dialogue) -> PointRow {
    let unit = log.unit;
    let plain = |length: Length| people(&length.exact(unit, DECIMALS), language);
    let signed = |length: Length| {
        let plus = if Length::ZERO < length { "+" } else { "" };
        format!("{plus}{}", plain(length))
    };
    let axes = ["X", "Y", "Z"].map(|name| Axis {
        name,
        nominal: plain(of_axis(name, log.nominal)),
        normal: people(&of_axis(name, log.normal).to_string(), language),
        measured: plain(of_axis(name, log.measured)),
        deviation: signed(of_axis(name, log.deviations)),
    });
    PointRow {
        number,
        stored: stored::block(log),
        class: class(log.status),
        time: log.date_time.map_or_else(String::new, |time| time.strftime(DATE).to_string()),
        program: log.program.as_deref().map_or_else(String::new, visible),
        simulated: log.is_simulated.then_some(words.simulated.as_str()),
        axes,
        along: signed(log.deviation),
        unit: if unit == Unit::Inch { "inch" } else { "mm" },
        tolerance: match log.band {
            Some(band) => vec![signed(band.upper), signed(band.lower)],
            None => vec![words.no_tolerance.clone()],
        },
        tolerance_text: visible(&log.tolerance),
        status: log
            .status
            .map_or_else(|| words.not_judged.clone(), |status| status_word(status, language).to_uppercase()),
    }
}

const fn class(status: Option<Status>) -> &'static str {
    match status {
        Some(Status::Good) => "good",
        Some(Status::Rework) => "rework",
        Some(Status::ReMeasure) => "remeasure",
        Some(Status::OutOfLimits) => "outoflimits",
        Some(Status::Scrap) => "scrap",
        None => "none",
    }
}

/// A plain number in the language's notation.
fn people(plain: &str, language: Dialogue) -> String {
    let sign = language.words().decimal_sign.to_string();
    plain.replace('.', &sign).replace('-', "\u{2212}")
}

/// The text without characters that no page may show: control characters, and marks that reverse the direction of
/// writing. Each becomes a replacement character, so that it is visible.
fn visible(text: &str) -> String {
    let hidden = |c: char| {
        c.is_control() || matches!(c, '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}' | '\u{fffe}' | '\u{ffff}')
    };
    text.replace(hidden, "\u{fffd}")
}
