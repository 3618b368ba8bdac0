//! The report's pictures as SVG: the limit band with its guard bands, and the verdict's sign.
//!
//! Shapes are painted, never backgrounds: browsers leave backgrounds out when they print. The two sides differ by
//! their hatching, not by colour alone, and so do guard bands. Colours are in `assets/report/report.css`, shapes in the templates.

use std::iter;

use askama::Template;
use fitcheck_core::length::Length;
use fitcheck_core::message::message;
use fitcheck_core::verdict::Status;
use fitcheck_core::words::Words;

use super::band::{Band, Guard, GuardBand, Guarded, Marker, Side};
use super::text;
use crate::journal::Record;

/// Left end of the axis in the picture's units; four units print as about a millimetre.
const LEFT: f64 = 20.0;
/// Length of the axis.
const WIDTH: f64 = 680.0;
/// Height of the band.
const HEIGHT: f64 = 66.0;
/// A side is wider than this where its words have room. Without guard bands every side is.
const SIDE: f64 = 60.0;
/// The width of a legend's swatch; half of it is the height.
const SWATCH: f64 = 28.0;
/// Labels closer than this would overlap.
const LABEL: f64 = 100.0;

/// The CSS class of a status.
pub(super) const fn status_class(status: Status) -> &'static str {
    match status {
        Status::Good => "good",
        Status::Rework => "rework",
        Status::ReMeasure => "remeasure",
        Status::OutOfLimits => "outoflimits",
        Status::Scrap => "scrap",
    }
}

#[derive(Template)]
#[template(path = "verdict.svg", config = "../../assets/report/askama.toml")]
struct VerdictPicture {
    class: &'static str,
    shape: &'static str,
    word: String,
    size: usize,
    baseline: usize,
}

/// The shape of a status around 38, 36: check mark, turning arrow, loop, arrows up and down, or cross; a dash where there is none.
pub(super) const fn shape(status: Option<Status>) -> &'static str {
    match status {
        Some(Status::Good) => "M20 38 L33 52 L57 20",
        Some(Status::Rework) => "M20 54 L20 36 A15 15 0 0 1 50 36 L50 50 M40 42 L50 53 L60 42",
        Some(Status::Scrap) => "M22 20 L54 52 M54 20 L22 52",
        Some(Status::ReMeasure) => {
            "M22.3 29.5 A17 17 0 0 1 54.6 31 M56 19 L55.3 31.8 L43 29 M53.7 42.5 A17 17 0 0 1 21.4 41 M20 53 L20.7 40.2 L33 43"
        }
        Some(Status::OutOfLimits) => "M38 16 L38 56 M27 27 L38 16 L49 27 M27 45 L38 56 L49 45",
        None => "M22 36 L54 36",
    }
}

/// The word of a verdict beside its shape.
pub(super) fn verdict(status: Status, word: String) -> askama::Result<String> {
    // 250 units are free for the word; a bold capital is about 0.72 of its size wide.
    let size = (347 / word.chars().count().max(1)).clamp(12, 40);
    VerdictPicture {
        class: status_class(status),
        shape: shape(Some(status)),
        word,
        size,
        baseline: 36 + size * 36 / 100,
    }
    .render()
}

struct SidePicture {
    class: &'static str,
    x: String,
    width: String,
    middle: String,
    hatch: String,
    cause: String,
    name: String,
    /// Whether there is room for its words.
    is_named: bool,
}

struct Tick {
    x: String,
    text: String,
    labelled: bool,
}

struct LimitPicture {
    x: String,
    deviation: String,
    size: String,
}

struct MarkerPicture {
    x: String,
    anchor: &'static str,
    value: String,
    distances: String,
    pointer: String,
}

/// A guard band, from its left end on.
struct GuardPicture {
    class: &'static str,
    x: String,
    width: String,
    hatch: String,
}

/// What a guard band means, below the picture: a swatch and words.
struct Legend {
    class: &'static str,
    x: String,
    text_x: String,
    hatch: String,
    name: String,
}

#[derive(Template)]
#[template(path = "band.svg", config = "../../assets/report/askama.toml")]
struct BandPicture {
    title: String,
    height: u16,
    sides: Vec<SidePicture>,
    guards: Vec<GuardPicture>,
    legends: Vec<Legend>,
    lower: LimitPicture,
    zone_width: String,
    zone_middle: String,
    zone_name: String,
    zone_named: bool,
    ticks: Vec<Tick>,
    nominal: Option<Tick>,
    nominal_name: String,
    limits: Vec<LimitPicture>,
    marker: Option<MarkerPicture>,
}

/// The limit band of a record with its measured value; sizes have at least this many decimals.
pub(super) fn band(record: &Record, decimals: usize, words: &Words) -> askama::Result<String> {
    let limits = &record.limits;
    let band = Band::by(&record.verdict.rule, limits, Some(record.measurement.diameter));
    let at = |um: f64| LEFT + WIDTH * band.fraction(um);
    let lower = at(band.lower_um);
    let upper = at(band.upper_um);
    let limit = |um: f64, deviation: Length, size: Length| LimitPicture {
        x: units(at(um)),
        deviation: format!("{} µm", words.signed_um(deviation)),
        size: format!("{} mm", words.mm(size, decimals)),
    };
    let lower_limit = || limit(band.lower_um, limits.deviations.lower(), limits.minimum());
    let mut both = vec![lower_limit()];
    if limits.deviations.lower() < limits.deviations.upper() {
        both.push(limit(band.upper_um, limits.deviations.upper(), limits.maximum()));
    }
    let clear = |x: f64, room: f64| room <= (x - lower).abs() && room <= (x - upper).abs();
    let ticks = band.ticks.iter().map(|&um| {
        let x = at(um);
        Tick { x: units(x), text: tick_text(um, words), labelled: clear(x, 24.0) && x < LEFT + WIDTH - 14.0 }
    });
    let nominal = band.shows(0.0).then(|| {
        let x = at(0.0);
        Tick { x: units(x), text: String::new(), labelled: clear(x, LABEL) }
    });
    let value = value_said(record, decimals, words);
    let distances = distances_said(record, words);
    let guard = band.guard.as_ref();
    // What is rejected begins where the rule says so; the zone is good as far as it is accepted.
    let rejected = match guard {
        Some(guard) => guard.rejected.map_or([LEFT, LEFT + WIDTH], |ends| ends.map(at)),
        None => [lower, upper],
    };
    let good = match guard {
        Some(guard) => guard.accepted.map(|ends| ends.map(|um| at(um).clamp(lower, upper))),
        None => Some([lower, upper]),
    };
    let [good_from, good_to] = good.unwrap_or([lower, lower]);
    let sides = [
        side(band.left, [LEFT, rejected[0].min(lower)], words.get("report-side-too-small"), words),
        side(band.right, [rejected[1].max(upper), LEFT + WIDTH], words.get("report-side-too-large"), words),
    ];
    BandPicture {
        title: title_said(&band, &value, &distances, words),
        height: if guard.is_some() { 206 } else { 184 },
        sides: sides.into_iter().flatten().collect(),
        guards: guard.map_or_else(Vec::new, |guard| guards(guard, at)),
        legends: guard.map_or_else(Vec::new, |guard| legends(guard, words)),
        lower: lower_limit(),
        zone_width: units(upper - lower),
        zone_middle: units(f64::midpoint(good_from, good_to)),
        zone_name: words.get("report-side-good"),
        zone_named: LABEL / 2.0 < good_to - good_from,
        ticks: ticks.collect(),
        nominal,
        nominal_name: words.say(&message!("report-band-nominal").number("size", limits.nominal)),
        limits: both,
        marker: band.marker.map(|place| marker(&band, place, value, distances)),
    }
    .render()
}

/// What the limit band of a record shows, for those who do not see it.
pub(super) fn band_said(record: &Record, decimals: usize, words: &Words) -> String {
    let band = Band::by(&record.verdict.rule, &record.limits, Some(record.measurement.diameter));
    title_said(&band, &value_said(record, decimals, words), &distances_said(record, words), words)
}

fn title_said(band: &Band, value: &str, distances: &str, words: &Words) -> String {
    let title = message!("report-band-title").text("value", value).text("distances", distances);
    let guards = band.guard.iter().flat_map(|guard| described(guard, words));
    iter::once(words.say(&title)).chain(guards).collect::<Vec<_>>().join("; ")
}

fn value_said(record: &Record, decimals: usize, words: &Words) -> String {
    let deviation = words.signed_um(record.verdict.size.deviation);
    format!("{} mm ({deviation} µm)", words.mm(record.measurement.diameter, decimals))
}

fn distances_said(record: &Record, words: &Words) -> String {
    text::distances(&record.verdict.size, words).map(|message| words.say(&message)).join(", ")
}

/// A side of the band, where the axis shows any of it.
fn side(side: Side, [from, to]: [f64; 2], cause: String, words: &Words) -> Option<SidePicture> {
    let width = to - from;
    (0.0 < width).then(|| SidePicture {
        class: match side {
            Side::Rework => "rework",
            Side::Scrap => "scrap",
            Side::Out => "outoflimits",
        },
        x: units(from),
        width: units(width),
        middle: units(f64::midpoint(from, to)),
        hatch: hatch(side, width),
        cause,
        name: words.say(&text::side(side)),
        is_named: SIDE < width,
    })
}

/// The guard bands of a rule.
fn guards(guard: &Guard, at: impl Fn(f64) -> f64) -> Vec<GuardPicture> {
    let picture = |band: &GuardBand| {
        let x = at(band.from_um);
        let width = at(band.to_um) - at(band.from_um);
        GuardPicture {
            class: guard_class(band.guarded),
            x: units(x),
            width: units(width),
            hatch: guard_hatch(band.guarded, width, HEIGHT),
        }
    };
    guard.bands.iter().map(picture).collect()
}

/// What the kinds of guard bands in the picture mean.
fn legends(guard: &Guard, words: &Words) -> Vec<Legend> {
    let kinds = [Guarded::Undecided, Guarded::AcceptedBeyond];
    let shown = kinds.into_iter().filter(|kind| guard.bands.iter().any(|band| band.guarded == *kind));
    let legend = |(x, guarded)| Legend {
        class: guard_class(guarded),
        x: units(x),
        text_x: units(x + SWATCH + 8.0),
        hatch: guard_hatch(guarded, SWATCH, SWATCH / 2.0),
        name: words.get(guard_name(guarded)),
    };
    [LEFT, LEFT + WIDTH / 2.0].into_iter().zip(shown).map(legend).collect()
}

/// Each guard band in words, for those who do not see it.
fn described(guard: &Guard, words: &Words) -> Vec<String> {
    let range = |band: &GuardBand| {
        words.say(
            &message!("report-guard-range")
                .text("what", words.get(guard_name(band.guarded)))
                .text("from", tick_text(band.from_um, words))
                .text("to", tick_text(band.to_um, words)),
        )
    };
    guard.bands.iter().map(range).collect()
}

const fn guard_class(guarded: Guarded) -> &'static str {
    match guarded {
        Guarded::Undecided => "undecided",
        Guarded::AcceptedBeyond => "beyond",
    }
}

const fn guard_name(guarded: Guarded) -> &'static str {
    match guarded {
        Guarded::Undecided => "report-guard-undecided",
        Guarded::AcceptedBeyond => "report-guard-beyond",
    }
}

/// Upright lines where nothing is decided, level ones where a value is accepted: no side has either.
fn guard_hatch(guarded: Guarded, width: f64, height: f64) -> String {
    let (end, line) = match guarded {
        Guarded::Undecided => (width, format!("v{}", units(height))),
        Guarded::AcceptedBeyond => (height, format!("h{}", units(width))),
    };
    let lines = (0_u16..).map(|n| 2.5 + 5.0 * f64::from(n)).take_while(|at| *at < end);
    lines
        .map(|at| match guarded {
            Guarded::Undecided => format!("M{} 0{line}", units(at)),
            Guarded::AcceptedBeyond => format!("M0 {}{line}", units(at)),
        })
        .collect()
}

/// Wide slanting lines for rework, a narrow lattice for scrap, a wide one where nobody knows: different even in black and white.
fn hatch(side: Side, width: f64) -> String {
    let step = match side {
        Side::Rework => 14.0,
        Side::Scrap => 10.0,
        Side::Out => 20.0,
    };
    let mut path = String::new();
    let mut x = 0.0;
    while x < width + HEIGHT {
        let start = units(x);
        path.extend(["M", &start, " 0 l-66 66"]);
        if side != Side::Rework {
            path.extend(["M", &start, " 66 l-66 -66"]);
        }
        x += step;
    }
    path
}

fn marker(band: &Band, place: Marker, value: String, distances: String) -> MarkerPicture {
    let (x, pointer) = match place {
        Marker::InSight(um) => {
            let x = LEFT + WIDTH * band.fraction(um);
            (x, format!("M{0} 58 l-9 -14 h18 z M{0} 58 V83", units(x)))
        }
        Marker::BeyondLeft(_) => (LEFT, "M2 71 l20 -14 v28 z M22 71 H62".to_owned()),
        Marker::BeyondRight(_) => (LEFT + WIDTH, "M718 71 l-20 -14 v28 z M698 71 H658".to_owned()),
    };
    let anchor = if x < LEFT + WIDTH * 0.3 {
        "start"
    } else if LEFT + WIDTH * 0.7 < x {
        "end"
    } else {
        "middle"
    };
    MarkerPicture { x: units(x), anchor, value, distances, pointer }
}

/// A tick's number. It is a round float, so it is shown at the nearest nanometre.
fn tick_text(um: f64, words: &Words) -> String {
    Length::from_mm_f64(um / 1e3).map_or_else(|_too_large| String::new(), |length| words.signed_um(length))
}

/// A coordinate with one decimal; never `-0.0`.
fn units(value: f64) -> String {
    format!("{:.1}", (value * 10.0).round() / 10.0 + 0.0)
}

/// How far a contact is outside (+) or inside (−) a circle, in micrometres with one decimal and a sign.
pub(super) fn radial_um(distance: f64, radius: f64, words: &Words) -> String {
    let Ok(deviation) = Length::from_mm_f64(distance - radius) else { return String::new() };
    let text = deviation.rounded(fitcheck_core::length::Unit::Micrometre, 1);
    let plus = if 0.05 <= deviation.to_um_f64() { "+" } else { "" };
    format!("{plus}{}", words.number(&text))
}

#[cfg(test)]
mod tests {
    use super::*;
    use fitcheck_core::words::Language;

    #[test]
    fn coordinates_are_plain_numbers() {
        assert_eq!(units(-0.04), "0.0");
        assert_eq!(units(359.96), "360.0");
    }

    #[test]
    fn radial_deviations_have_a_sign_unless_zero() {
        let words = Words::new(Language::En);
        assert_eq!(radial_um(12.5011, 12.5, &words), "+1.1");
        assert_eq!(radial_um(12.49996, 12.5, &words), "0.0");
        assert_eq!(radial_um(12.50004, 12.5, &words), "0.0");
        assert_eq!(radial_um(12.4989, 12.5, &words), "\u{2212}1.1");
        assert_eq!(radial_um(f64::NAN, 12.5, &words), "");
    }
}
