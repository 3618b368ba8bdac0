//! The checks in AQDEF, the exchange format of Q-DAS, for statistics: characteristics with their limits, and values with their dates.
//!
//! Lines of a key and a text, each with CR and LF, decimals with a point, dates as day.month.year. A file that is not plain ASCII is UTF-8
//! and begins with its mark; our own reader and others know it by that. A text has at most the characters of its field.
//!
//! The format has limits and values, and no rules: whoever reads it judges by the limits. So the attribute of a value (K0002) is 255, not
//! valid, where that could call it better than the report does: it is simulated, in a guard band, or its centre is out of position. The
//! text of the value (K0009) says why, and always what the report says. A size of a part without a value has the attribute 255 as well.
//! Contacts and pictures have no place here. What the report says as a whole stands in the remark of the part (K1900).

use std::io::{self, Write};

use fitcheck_core::length::Length;
use fitcheck_core::tolerance::Feature;
use fitcheck_core::words::Words;
use jiff::civil::DateTime;

use super::given::{self, Catalogue, Found, Given, Known, Quantity, is_plain, remarks, standing};
use super::told::on_one_line;
use super::{Holds, Rendering, Report};
use crate::journal::Record;
use crate::row::Millimetres;

pub const RENDERING: Rendering = Rendering {
    name: "dfq",
    title: "AQDEF (Q-DAS)",
    is_for_people: false,
    holds: Holds::Report,
    endings: &["dfq"],
    render,
};

/// The attribute of a value that is not valid.
const NOT_VALID: &str = "255";

/// The most characters of a remark.
const REMARK: usize = 255;

fn render(report: &Report, _words: &Words, out: &mut dyn Write) -> io::Result<()> {
    let mut known = Catalogue::default();
    given::each(report, &mut |given| {
        known.see(given);
        Ok(())
    })?;
    // A file of ASCII alone needs no mark, and some readers know none.
    let mut probe = Probe::default();
    write(report, &known, &mut probe)?;
    if probe.has_other {
        out.write_all("\u{feff}".as_bytes())?;
    }
    write(report, &known, out)
}

/// Sees whether a file has anything but ASCII.
#[derive(Default)]
struct Probe {
    has_other: bool,
}

impl Write for Probe {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.has_other |= !bytes.is_ascii();
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

fn write(report: &Report, known: &Catalogue, out: &mut dyn Write) -> io::Result<()> {
    write!(out, "K0100 {}\r\n", known.count())?;
    part(report, out)?;
    let mut declared = 0;
    given::each(report, &mut |given| match known.of(given) {
        // They are numbered in the order in which they come.
        Some(of) if declared < of.number => {
            declared = of.number;
            characteristic(given, of, out)
        }
        _ => Ok(()),
    })?;
    given::each(report, &mut |given| {
        let serial = given.part.and_then(|at| report.parts.get(at)).map_or("", |part| part.serial());
        known.of(given).map_or(Ok(()), |of| value(given, (of.number, serial), report.created, out))
    })
}

/// The part: all values are those of one kind of part, and serial numbers stand beside them.
fn part(report: &Report, out: &mut dyn Write) -> io::Result<()> {
    let plan = report.parts.first().map(|part| &part.plan.head);
    let named = |text: &str| Some(text.to_owned()).filter(|text| !text.is_empty());
    let name = report.part.clone().or_else(|| named(&plan?.part));
    let name = name.unwrap_or_else(|| "-".to_owned());
    field(1001, 1, &name, 30, out)?;
    field(1002, 1, &name, 80, out)?;
    field(1041, 1, plan.map_or("", |plan| &plan.drawing), 30, out)?;
    field(1053, 1, report.order.as_deref().unwrap_or(""), 40, out)?;
    field(1222, 1, report.inspector.as_deref().unwrap_or(""), 40, out)?;
    field(1900, 1, &remark(report), REMARK, out)
}

/// The title, the program, how the parts stand, and the notes, as many of these as there is room for; the number of the others.
fn remark(report: &Report) -> String {
    let created = report.created.strftime("%Y-%m-%d %H:%M:%S");
    let title = Some(report.title.clone()).filter(|title| !title.is_empty());
    let mut said: Vec<String> = title.into_iter().chain([format!("{}, {created}", report.program)]).collect();
    let parts = report.parts.iter().map(|part| match part.serial() {
        "" => standing(part),
        serial => format!("{serial} {}", standing(part)),
    });
    said.extend(parts.chain(report.notes.iter().map(ToString::to_string)));
    // Room for what is said of the others.
    let most = REMARK - 40;
    let mut all = String::new();
    for (at, text) in said.iter().enumerate() {
        let next = if all.is_empty() { text.clone() } else { format!("{all}; {text}") };
        if most < next.chars().count() {
            return format!("{all}; {} more statements: see JSON", said.len() - at);
        }
        all = next;
    }
    all
}

fn characteristic(given: &Given<'_>, known: Known, out: &mut dyn Write) -> io::Result<()> {
    let asked = &given.asked;
    let limits = asked.limits;
    let Known { number, decimals, uncertainty, .. } = known;
    let mm = |length: Length| Millimetres(length).text(decimals);
    let title = asked.title();
    let own = if asked.number.is_empty() { number.to_string() } else { asked.number.to_owned() };
    field(2001, number, &own, 20, out)?;
    field(2002, number, &title, 80, out)?;
    field(2004, number, "0", 5, out)?;
    match asked.quantity {
        Quantity::Diameter => field(2009, number, "202", 5, out)?,
        Quantity::Coordinate => field(2009, number, "117", 5, out)?,
        // No number of these is known.
        Quantity::Width(_) | Quantity::Length => {}
    }
    field(2022, number, &decimals.to_string(), 5, out)?;
    field(2101, number, &mm(limits.nominal), 22, out)?;
    if let Some(class) = asked.class() {
        let class = class.to_string();
        let (letters, grade) = class.split_at(class.find(|c: char| c.is_ascii_digit()).unwrap_or(class.len()));
        // What the fields of letters and grade have no room for is a text.
        if letters.len() <= 2 && (1..=3).contains(&grade.len()) {
            field(2103, number, letters, 2, out)?;
            field(2104, number, grade, 3, out)?;
        } else {
            field(2151, number, &class, 20, out)?;
        }
    }
    if let Some(uncertainty) = uncertainty.and_then(|uncertainty| expanded(&uncertainty.expanded_um())) {
        field(2106, number, &uncertainty, 22, out)?;
    }
    field(2110, number, &mm(limits.minimum()), 22, out)?;
    field(2111, number, &mm(limits.maximum()), 22, out)?;
    field(2112, number, &mm(limits.deviations.lower()), 22, out)?;
    field(2113, number, &mm(limits.deviations.upper()), 22, out)?;
    match limits.feature {
        Some(Feature::Shaft) => field(2114, number, &mm(limits.minimum()), 22, out)?,
        Some(Feature::Hole) => field(2115, number, &mm(limits.maximum()), 22, out)?,
        None => {}
    }
    field(2120, number, "1", 3, out)?;
    field(2121, number, "1", 3, out)?;
    field(2142, number, "mm", 20, out)?;
    let callout = asked.callout.map_or_else(String::new, |callout| format!("{callout}, "));
    field(2900, number, &format!("{callout}{}", limits.source), REMARK, out)
}

/// Micrometres as millimetres, rounded up to the nanometre: an uncertainty is never told too small.
fn expanded(um: &str) -> Option<String> {
    let (whole, part) = um.split_once('.').unwrap_or((um, ""));
    let kept = format!("{part:0<3}");
    let (nanometres, rest) = kept.split_at_checked(3)?;
    let nm = format!("{whole}{nanometres}").parse::<i64>().ok()?;
    let up = i64::from(rest.bytes().any(|digit| digit != b'0'));
    Some(Millimetres(Length::from_nanometres(nm.checked_add(up)?).ok()?).text(4))
}

fn value(given: &Given<'_>, of: (usize, &str), created: DateTime, out: &mut dyn Write) -> io::Result<()> {
    let (number, serial) = of;
    let (measured, attribute, time, said) = match given.found {
        Found::Value(record) => of_record(record),
        Found::LeftOut(reason) => (Length::ZERO, NOT_VALID, created, format!("left out: {reason}")),
        Found::Missing => (Length::ZERO, NOT_VALID, created, "missing".to_owned()),
    };
    field(1, number, &Millimetres(measured).text(3), 22, out)?;
    field(2, number, attribute, 5, out)?;
    field(4, number, &time.strftime("%d.%m.%Y/%H:%M:%S").to_string(), 19, out)?;
    field(9, number, &said, REMARK, out)?;
    field(14, number, serial, 40, out)
}

fn of_record(record: &Record) -> (Length, &'static str, DateTime, String) {
    let attribute = if is_plain(record) { "0" } else { NOT_VALID };
    (record.measurement.diameter, attribute, record.time, remarks(record))
}

/// A line of a key, a number and a text of at most so many characters; none where there is no text.
fn field(key: u16, number: usize, text: &str, most: usize, out: &mut dyn Write) -> io::Result<()> {
    let mut text = on_one_line(text);
    if let Some((at, _)) = text.char_indices().nth(most) {
        text.truncate(at);
        text.pop();
        text.push('\u{2026}');
    }
    if text.is_empty() {
        return Ok(());
    }
    // In one piece: an error of the stream stays what it is.
    out.write_all(format!("K{key:04}/{number} {text}\r\n").as_bytes())
}

#[cfg(test)]
mod tests {
    use super::expanded;

    #[test]
    fn an_uncertainty_is_rounded_up() {
        for (um, mm) in [("2.4", "0.0024"), ("3", "0.0030"), ("0.0001", "0.000001"), ("1.2345", "0.001235")] {
            assert_eq!(expanded(um).as_deref(), Some(mm), "{um}");
        }
    }
}
