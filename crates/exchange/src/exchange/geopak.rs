//! Tolerances that GEOPAK of MCOSMOS (Mitutoyo) writes to a file, without names of columns: its columns stand in one order, which the
//! figures confirm, and the file is read as a CSV with these columns.
//!
//! `1;Diameter;Circle_1;25.000;0.021;0.000;25.012;0.012;;` has the number of the element, the tolerance, the name, the nominal value, the
//! upper and the lower tolerance, the actual value, the deviation, and how far it is out.

use std::sync::LazyLock;

use fitcheck_core::length::{Length, Unit};
use fitcheck_core::text::lines;

use super::error::ImportErrorKind;
use super::imported::Sink;
use super::mapping::Mapping;
use super::source::Source;
use super::{Format, cells, measurements};

pub(super) const FORMAT: Format = Format {
    name: "geopak",
    endings: &["txt", "csv", "asc"],
    description: "exchange-format-geopak",
    recognises: |beginning| lower(&beginning.text()).is_some(),
    read,
    plan: None,
    line_ends: measurements::LINE_ENDS,
    has_marks: true,
    shows_end: true,
};

/// The columns, where the lower tolerance has its sign, and where it has none.
static COLUMNS: LazyLock<[Option<Mapping>; 2]> = LazyLock::new(|| {
    let of = |lower: &str| {
        format!("separator=semicolon,quantity=2,name=3,nominal=4,upper=5,{lower}=6,measured=7").parse().ok()
    };
    [of("lower"), of("minus")]
});

/// How the lower tolerances of some lines stand.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Lower {
    Signed,
    /// None of them has a sign, and one is not below its upper tolerance.
    Unsigned,
}

/// That of a text whose lines are all of this form, and whose deviations are those of their figures; `None` of any other.
fn lower(text: &str) -> Option<Lower> {
    let mut lower = Lower::Unsigned;
    let (mut is_crossed, mut is_confirmed) = (false, false);
    for (_, line) in lines(text).filter(|(_, line)| !line.trim().is_empty()) {
        let cells: Vec<&str> = line.split(';').map(str::trim).collect();
        let [number, _, _, nominal, upper, below, actual, deviation, _, ..] = cells.as_slice() else { return None };
        if number.is_empty() || !number.bytes().all(|byte| byte.is_ascii_digit()) {
            return None;
        }
        let read = |cell: &&str| cells::length(cell, Unit::Millimetre).ok();
        let actual = read(actual)?;
        if let Some((nominal, deviation)) = read(nominal).zip(read(deviation)) {
            let off = actual.saturating_sub(nominal).saturating_sub(deviation).abs();
            // Each of the three is rounded by itself.
            if Length::from_micrometres(2) < off {
                return None;
            }
            is_confirmed = true;
        }
        if below.starts_with(['-', '+', '\u{2212}']) {
            lower = Lower::Signed;
        }
        is_crossed |=
            read(upper).zip(read(below)).is_some_and(|(upper, below)| upper <= below && below != Length::ZERO);
    }
    is_confirmed.then_some(if is_crossed { lower } else { Lower::Signed })
}

fn read(source: &mut Source<'_>, sink: &mut Sink<'_>) -> Result<(), ImportErrorKind> {
    let [signed, unsigned] = &*COLUMNS;
    let found = lower(&source.beginning().text());
    source.given.mapping = if found == Some(Lower::Unsigned) { unsigned.as_ref() } else { signed.as_ref() };
    (measurements::FORMAT.read)(source, sink)
}
