//! The report as a reader sees it: complete, well-formed, escaped, the same every time.

#![cfg(test)]

use std::io::Write;

use fitcheck::journal::Record;
use fitcheck::length::Length;
use fitcheck::message::Message;
use fitcheck::probing::{Circle, Contact, Measurement, Origin};
use fitcheck::report::html::MOST_CHECKS;
use fitcheck::report::{Checks, RENDERINGS, Report, of_any_paper};
use fitcheck::tolerance::{Callout, Deviations, Limits, Source};
use fitcheck::verdict::{AxisPosition, PositionVerdict, doubt, judge};
use fitcheck::words::{Language, Words};
use jiff::civil::date;

fn um(um: i32) -> Length {
    Length::from_micrometres(um)
}

fn limits(callout: &str, upper: i32, lower: i32, source: Source) -> Limits {
    let callout: Callout = callout.parse().unwrap();
    let deviations = Deviations::new(um(upper), um(lower)).unwrap();
    Limits::new(callout.feature().unwrap(), callout.nominal(), deviations, source).unwrap()
}

fn iso() -> Source {
    let (over, to) = (um(18_000), um(30_000));
    Source::Standard {
        over,
        to,
        said: Message::new("source-iso286").with("over", &over).with("to", &to).into(),
        doubt: None,
    }
}

fn record(
    id: &str,
    callout: &str,
    limits: Limits,
    measurement: Measurement,
    axes: Option<[AxisPosition; 2]>,
) -> Record {
    Record {
        time: date(2026, 11, 21).at(10, 42, 7, 0),
        id: id.to_owned(),
        callout: callout.parse().ok(),
        verdict: judge(&limits, measurement.diameter, axes.map(|axes| PositionVerdict { axes })),
        doubt: doubt(&limits, measurement.diameter),
        correction: None,
        budget: None,
        limits,
        measurement,
    }
}

fn bore(id: &str, measured: &str) -> Record {
    let measurement = Measurement::of_diameter(measured.parse().unwrap(), Origin::Typed);
    record(id, "25 H7", limits("25 H7", 21, 0, iso()), measurement, None)
}

/// A good diameter on contacts at equal angles, the centre out in Y.
fn stud(contacts: u32) -> Record {
    let radius = 12.4925;
    let contact = |number: u32| {
        let angle = std::f64::consts::TAU * f64::from(number) / f64::from(contacts);
        Contact { x: radius * angle.cos(), y: radius * angle.sin() - 0.012, z: -5.0 }
    };
    let measurement = Measurement {
        diameter: um(24_985),
        centre: Some([um(0), um(-12)]),
        contacts: (0..contacts).map(contact).collect(),
        circle: Some(Circle { x: 0.0, y: -0.012, diameter: 2.0 * radius }),
        origin: Origin::Simulated { cycle: 422, seed: 1 },
    };
    let axes = [
        AxisPosition { deviation: um(0), tolerance: None },
        AxisPosition { deviation: um(-12), tolerance: Some(um(10)) },
    ];
    record("Stud", "25 g6", limits("25 g6", -7, -20, iso()), measurement, Some(axes))
}

fn report(checks: Vec<Record>) -> Report {
    Report { program: "Fitcheck 0.0.0".to_owned(), ..Report::new(date(2026, 11, 21).at(11, 0, 0, 0), checks) }
}

fn html(report: &Report, language: Language) -> String {
    let rendering = RENDERINGS.iter().find(|rendering| rendering.name == "html").unwrap();
    let page = String::from_utf8(rendering.bytes(report, &Words::new(language)).unwrap()).unwrap();
    check_well_formed(&page);
    // Lines are broken between tags, where that has no meaning.
    page.replace('\n', "")
}

#[test]
fn a_page_lists_what_is_not_good_where_all_checks_are_too_many() {
    let page = |count: usize, bad: usize| {
        let checks = (0..count).map(|n| bore(&format!("N{n}."), if n < bad { "24.998" } else { "25.012" }));
        html(&report(checks.collect()), Language::En)
    };
    let listed = |page: &str| page.matches("<section class=\"check\"").count();
    let whole = page(MOST_CHECKS, 1);
    assert_eq!((listed(&whole), whole.contains("This page lists")), (MOST_CHECKS, false));
    let some = page(MOST_CHECKS + 1, 3);
    assert_eq!(listed(&some), 3);
    for text in [
        "This page lists only the 3 of 2001 checks that are not good or in doubt.",
        "<td>1998</td>",
        "<td>2001</td>",
        "id=\"check-3\"",
        "N2.",
    ] {
        assert!(some.contains(text), "{text}");
    }
    assert!(!some.contains("N3."));
    let many = page(MOST_CHECKS + 2, MOST_CHECKS + 1);
    assert_eq!(listed(&many), MOST_CHECKS);
    assert!(many.contains("only the first 2000 of 2001 checks that are not good or in doubt, out of 2002 checks"));
    let good = page(MOST_CHECKS + 1, 0);
    assert_eq!(listed(&good), 0);
    assert!(good.contains("None of the 2001 checks is listed on this page: all are good"));
}

/// Checks that are made when they are asked for, and never all of them.
#[derive(Debug)]
struct Made(usize);

impl Checks for Made {
    fn each(&self, see: &mut dyn FnMut(&Record) -> std::io::Result<()>) -> std::io::Result<()> {
        (0..self.0).try_for_each(|number| see(&bore(&number.to_string(), "24.998")))
    }
}

/// A stream that keeps nothing: how much was written to it, and the largest piece.
#[derive(Default)]
struct Measured {
    all: usize,
    largest: usize,
}

impl Write for Measured {
    fn write(&mut self, bytes: &[u8]) -> std::io::Result<usize> {
        self.all += bytes.len();
        self.largest = self.largest.max(bytes.len());
        Ok(bytes.len())
    }

    fn flush(&mut self) -> std::io::Result<()> {
        Ok(())
    }
}

#[test]
fn a_report_is_written_check_by_check() {
    let report = Report::new(date(2026, 11, 21).at(11, 0, 0, 0), Made(5_000));
    for rendering in of_any_paper().map(|number| &RENDERINGS[number]) {
        let mut out = Measured::default();
        (rendering.render)(&report, &Words::new(Language::Nl), &mut out).unwrap();
        // Some bytes a check at least, and never many checks at once.
        assert!(100_000 < out.all && out.largest < 30_000, "{}: {}, {}", rendering.name, out.all, out.largest);
    }
}

#[test]
fn an_error_of_the_stream_stays_what_it_is() {
    struct Closed;
    impl Write for Closed {
        fn write(&mut self, _: &[u8]) -> std::io::Result<usize> {
            Err(std::io::ErrorKind::BrokenPipe.into())
        }
        fn flush(&mut self) -> std::io::Result<()> {
            Ok(())
        }
    }
    for rendering in of_any_paper().map(|number| &RENDERINGS[number]) {
        let report = report(vec![bore("A", "25.012"), bore("B", "25.012")]);
        let error = (rendering.render)(&report, &Words::new(Language::En), &mut Closed).unwrap_err();
        assert_eq!(error.kind(), std::io::ErrorKind::BrokenPipe, "{}", rendering.name);
    }
}

/// Every element is closed where it was opened, every attribute is quoted, every `&` begins an entity.
#[track_caller]
pub fn check_well_formed(page: &str) {
    let mut open: Vec<&str> = Vec::new();
    let mut rest = page.strip_prefix("<!DOCTYPE html>").expect("a document type");
    while let Some(start) = rest.find('<') {
        let (text, tag) = rest.split_at(start);
        check_text(text);
        let end = tag.find('>').unwrap_or_else(|| panic!("a tag without an end: {tag:.80}"));
        let (inside, after) = tag.split_at(end);
        let inside = inside.trim_start_matches('<');
        rest = after.trim_start_matches('>');
        if let Some(name) = inside.strip_prefix('/') {
            assert_eq!(open.pop(), Some(name), "closed before {rest:.80}");
            continue;
        }
        let (inside, alone) = inside.strip_suffix('/').map_or((inside, false), |inside| (inside.trim_end(), true));
        let (name, attributes) = inside.split_once(' ').unwrap_or((inside, ""));
        assert!(!name.is_empty() && name.bytes().all(|b| b.is_ascii_alphanumeric()), "a tag named {name:?}");
        check_attributes(attributes);
        if !alone {
            open.push(name);
        }
    }
    assert!(open.is_empty(), "never closed: {open:?}");
    assert_eq!(rest.trim(), "");
}

#[track_caller]
fn check_text(text: &str) {
    assert!(!text.contains('>'), "a stray > in {text:.80}");
    for (at, _) in text.match_indices('&') {
        let entity = text.split_at(at + 1).1.split(';').next().unwrap_or_default();
        let sound = entity.bytes().all(|b| b.is_ascii_alphanumeric() || b == b'#') && (2..=8).contains(&entity.len());
        assert!(sound, "a stray & in {text:.80}");
    }
}

#[track_caller]
fn check_attributes(mut attributes: &str) {
    while !attributes.trim().is_empty() {
        let (name, value) = attributes.split_once("=\"").unwrap_or_else(|| panic!("attributes {attributes}"));
        let name = name.trim();
        assert!(name.bytes().all(|b| b.is_ascii_alphanumeric() || b == b'-'), "an attribute named {name}");
        let (value, after) = value.split_once('"').unwrap_or_else(|| panic!("value of {name}"));
        check_text(value);
        attributes = after;
    }
}

#[track_caller]
fn check_contains(page: &str, texts: &[&str]) {
    for text in texts {
        assert!(page.contains(text), "{text:?} is missing in\n{page}");
    }
}

#[test]
fn a_report_says_everything_about_each_check() {
    let report = Report {
        part: Some("4711-A".to_owned()),
        order: Some("2026-118".to_owned()),
        inspector: Some("J. de Vries".to_owned()),
        notes: vec![Message::new("cli-report-empty")],
        ..report(vec![bore("Bore A", "25.012"), bore("Bore B", "24.998"), bore("Bore C", "25.030"), stud(4)])
    };
    let page = html(&report, Language::En);
    check_contains(
        &page,
        &[
            "<html lang=\"en\">",
            "<title>Inspection report</title>",
            "4711-A",
            "2026-118",
            "J. de Vries",
            "2026-11-21 11:00:00",
            "no check was usable, so no report was written",
            // counts
            "<th scope=\"col\">GOOD</th><th scope=\"col\">REWORK</th><th scope=\"col\">SCRAP</th>",
            "<td>1</td><td>1</td><td>2</td><td>4</td>",
            // verdicts, limits, values
            "<title>GOOD</title>",
            "<title>REWORK</title>",
            "<title>SCRAP</title>",
            "25 H7 <span class=\"quiet\">hole</span>",
            "25 g6 <span class=\"quiet\">shaft</span>",
            ">25.021 mm</td>",
            ">25.000 mm</td>",
            ">25.012 mm</td><td class=\"number\">+12 µm</td>",
            ">24.998 mm</td><td class=\"number\">\u{2212}2 µm</td>",
            "12 µm above minimum, 9 µm below maximum",
            "2 µm too small",
            "9 µm too large",
            // amounts to remove: on diameter and per side
            "<td class=\"number diameter\">2 µm</td><td class=\"number quiet\">1 µm</td>",
            "<td class=\"number diameter\">12.5 µm</td><td class=\"number quiet\">6.25 µm</td>",
            // position
            "X 0.000 mm: not monitored",
            "Y \u{2212}0.012 mm, permitted ± 0.010 mm: OUT",
            "the centre is out of position; the size alone is GOOD",
            // where each number comes from
            "ISO 286, over 18 up to 30 mm",
            "least-squares circle through 4 contacts",
            "no guard band, limits belong to the zone",
            "Limits of this measurement",
            // signature
            ">Name</th>",
            ">Date</th>",
            ">Signature</th>",
        ],
    );
}

#[test]
fn the_dutch_report_is_dutch_with_a_decimal_comma() {
    let page = html(&report(vec![bore("", "25.012"), bore("", "24.998"), stud(4)]), Language::Nl);
    check_contains(
        &page,
        &[
            "<html lang=\"nl\">",
            "<title>Meetrapport</title>",
            "GOED",
            "NABEWERKING",
            "AFGEKEURD",
            "25,012 mm",
            "\u{2212}2 µm",
            "6,25 µm",
            "ISO 286, boven 18 tot en met 30 mm",
            "Y \u{2212}0,012 mm, toegestaan ± 0,010 mm: BUITEN",
            "Handtekening",
        ],
    );
    for english in ["GOOD", "SCRAP", "25.012", "Signature", "not measured", "above minimum"] {
        assert!(!page.contains(english), "{english} in the Dutch report");
    }
}

#[test]
fn no_text_is_missing_in_a_language() {
    for language in Language::all() {
        let words = Words::new(language);
        let text = include_str!("../../assets/locales/en/report.ftl");
        let ids = text.lines().filter_map(|line| line.split_once(" = ")).map(|(id, _)| id);
        let missing: Vec<_> = ids.filter(|id| words.get(id) == *id).collect();
        assert!(missing.is_empty(), "{language}: {missing:#?}");
        let page = html(&report(vec![bore("", "12.5"), stud(40)]), language);
        assert!(!page.contains(">report-") && !page.contains("{ $"), "{page}");
    }
}

#[test]
fn nothing_in_a_text_becomes_a_tag_or_turns_the_figures_round() {
    let evil = "</title><script>alert('x')</script>\" onload=\"x&y\u{202e}\u{0}";
    let mut checks = vec![bore(evil, "25.012"), stud(3)];
    checks[0].limits.source = Source::File(evil.into());
    checks[1].measurement.origin = Origin::Contacts { file: evil.into() };
    let some = || Some(evil.to_owned());
    let report = Report {
        title: evil.to_owned(),
        part: some(),
        order: some(),
        inspector: some(),
        notes: vec![Message::new("report-note").text("place", evil)],
        ..report(checks)
    };
    let page = html(&report, Language::En);
    assert!(!page.contains("<script") && !page.contains("\" onload"));
    assert!(!page.contains('\u{202e}') && !page.contains('\0'));
    check_contains(&page, &["&#60;script&#62;alert(&#39;x&#39;)", "x&#38;y\u{fffd}\u{fffd}"]);
}

#[test]
fn the_page_needs_nothing_from_outside() {
    let page = html(&report(vec![bore("Bore A", "25.012"), stud(4)]), Language::En);
    for outside in ["http:", "https:", "src=", "url(", "@import", "<link", "<script", "<img", "<iframe"] {
        assert!(!page.contains(outside), "{outside}");
    }
    check_contains(&page, &["default-src 'none'", "@page", "size: A4", "break-inside: avoid"]);
}

#[test]
fn a_doubtful_value_is_doubted() {
    let page = html(&report(vec![bore("", "12.5")]), Language::En);
    check_contains(&page, &["measured value is half the nominal size: is it a radius?"]);
    assert!(!page.contains("class=\"overview\""), "one check needs no summary");
}

#[test]
fn long_lists_of_contacts_go_to_the_end() {
    let rows = |page: &str| page.matches("</td><td>\u{2212}5.0000</td>").count();
    let short = html(&report(vec![stud(16)]), Language::En);
    assert_eq!(rows(&short), 16);
    assert!(!short.contains("id=\"contacts-1\""));
    let long = html(&report(vec![stud(17)]), Language::En);
    assert_eq!(rows(&long), 17);
    check_contains(&long, &["href=\"#contacts-1\"", "id=\"contacts-1\""]);
}

#[test]
fn limits_without_a_class_have_a_heading_of_their_own() {
    let mut record = bore("", "25.0121");
    record.callout = None;
    record.limits.source = Source::File("TCHPR421.TXT".into());
    let page = html(&report(vec![record]), Language::En);
    // All sizes of a check have the decimals of the finest one.
    check_contains(&page, &["25 mm, limits without a class", "file TCHPR421.TXT", "25.0210 mm", "25.0121 mm"]);
}

#[test]
fn no_checks_at_all_is_said() {
    check_contains(&html(&report(Vec::new()), Language::En), &["This report has no checks."]);
}

#[test]
fn every_rendering_is_the_same_every_time() {
    let report = report(vec![bore("Bore A", "25.012"), stud(20)]);
    for rendering in of_any_paper().map(|number| &RENDERINGS[number]) {
        let once = || rendering.bytes(&report, &Words::new(Language::Nl)).unwrap();
        assert_eq!(once(), once(), "{}", rendering.name);
    }
}

proptest::proptest! {
    #[test]
    fn every_text_gives_a_well_formed_page(id in "\\PC{0,40}", measured in 1_i64..2_000_000_000) {
        let mut record = bore(&id, "25");
        record.measurement.diameter = Length::from_nanometres(measured).unwrap();
        record.verdict = judge(&record.limits, record.measurement.diameter, None);
        html(&report(vec![record]), Language::En);
    }
}
