//! The log of cycle 444: the page, what programs read from it, and both together.

use fitcheck::control::point_log::{Band, PointFault, PointLog, append, is_log, read, write};
use fitcheck::exchange::{WhyUnjudged, import};
use fitcheck::length::{Length, Unit};
use fitcheck::tolerance::Sources;
use fitcheck::verdict::Status;
use fitcheck::words::Dialogue;
use proptest::prelude::*;

fn mm(text: &str) -> Length {
    text.parse().unwrap()
}

/// A point on a horizontal face with the tolerance 0.4-0.1.
pub(crate) fn point(deviation: &str) -> PointLog {
    let deviation = mm(deviation);
    let band = Band { upper: mm("0.4"), lower: mm("-0.1") };
    PointLog {
        date_time: Some(jiff::civil::date(2024, 3, 14).at(8, 5, 9, 0)),
        program: Some(r"TNC:\PART1.H".to_owned()),
        is_simulated: false,
        unit: Unit::Millimetre,
        nominal: [mm("35"), mm("-45.5"), mm("5")],
        normal: [0.0, 0.0, 2.0],
        measured: [mm("35"), mm("-45.5"), mm("5").checked_add(deviation).unwrap()],
        deviations: [Length::ZERO, Length::ZERO, deviation],
        deviation,
        tolerance: "0.4-0.1".to_owned(),
        band: Some(band),
        status: Some(band.status(deviation)),
    }
}

pub(crate) fn page(logs: &[PointLog], language: Dialogue) -> String {
    String::from_utf8(write(logs, language).unwrap()).unwrap()
}

fn points(page: &[u8]) -> Vec<PointLog> {
    read(page).into_iter().map(|answer| answer.unwrap().1).collect()
}

/// What people see of a page: the text outside of marks, blocks and styles, one line per cell.
fn seen(page: &str) -> Vec<String> {
    let (_, body) = page.split_once("<body>").unwrap();
    let (mut seen, mut rest) = (Vec::new(), body);
    while let Some((text, after)) = rest.split_once('<') {
        seen.push(text.trim().to_owned());
        let (mark, after) = after.split_once('>').unwrap();
        rest = if mark.starts_with("script") { after.split_once("</script>").unwrap().1 } else { after };
    }
    seen.retain(|text| !text.is_empty());
    seen
}

#[test]
fn borders_of_the_band_belong_to_it() {
    let status = |deviation: &str| point(deviation).status.unwrap();
    assert_eq!(status("0.4"), Status::Good);
    assert_eq!(status("0.400001"), Status::Rework);
    assert_eq!(status("-0.1"), Status::Good);
    assert_eq!(status("-0.100001"), Status::Scrap);
}

#[test]
fn a_page_shows_points_deviations_tolerance_and_status_in_words() {
    assert_eq!(
        seen(&page(&[point("-0.100001")], Dialogue::En)),
        [
            "Measuring log for touch probe cycle 444 Probing in 3-D",
            "No.",
            "Date, time, program",
            "Axis",
            "Nominal point",
            "Normal",
            "Measured point",
            "Deviation",
            "Along the normal",
            "+ oversize, − undersize",
            "Tolerance",
            "Status",
            "1",
            "2024-03-14 08:05:09",
            r"TNC:\PART1.H",
            "X",
            "35.0000",
            "0",
            "35.0000",
            "0.0000",
            "−0.100001",
            "mm",
            "+0.4000",
            "−0.1000",
            "0.4-0.1",
            "SCRAP",
            "Y",
            "−45.5000",
            "0",
            "−45.5000",
            "0.0000",
            "Z",
            "5.0000",
            "2",
            "4.899999",
            "−0.100001",
        ]
    );
}

#[test]
fn words_and_decimal_sign_are_those_of_the_language_and_colour_never_stands_alone() {
    let logs = [point("0.0123"), point("0.5"), point("-0.2"), PointLog { band: None, status: None, ..point("0") }];
    for (language, title, words, along) in [
        (Dialogue::En, "Probing in 3-D", ["GOOD", "REWORK", "SCRAP", "NOT JUDGED"], "+0.0123"),
        (Dialogue::Nl, "Tasten 3D", ["GOED", "NABEWERKING", "AFGEKEURD", "NIET BEOORDEELD"], "+0,0123"),
        (Dialogue::De, "Antasten 3D", ["GUT", "NACHARBEIT", "AUSSCHUSS", "NICHT BEURTEILT"], "+0,0123"),
        (Dialogue::It, "Tastatura 3D", ["BUONO", "RIPRESA", "SCARTO", "NON VALUTATO"], "+0,0123"),
    ] {
        let page = page(&logs, language);
        let seen = seen(&page);
        assert!(seen[0].ends_with(title), "{seen:?}");
        assert!(page.contains(&format!("<html lang=\"{language}\">")));
        assert!(seen.iter().any(|text| text == along), "{seen:?}");
        for (class, word) in ["good", "rework", "scrap", "none"].into_iter().zip(words) {
            let (_, row) = page.split_once(&format!("<tbody class=\"{class}\">")).unwrap();
            let (row, _) = row.split_once("</tbody>").unwrap();
            assert!(row.contains(&format!(">{word}</td>")), "{language}: {word} in {row}");
        }
        assert_eq!(points(page.as_bytes()), logs, "{language}");
    }
}

#[test]
fn the_page_is_self_contained_and_runs_nothing() {
    let page = page(&[point("0")], Dialogue::En);
    assert!(page.contains("default-src 'none'"));
    for outside in ["http:", "https:", "src=", "href=", "url(", "@import", "onload"] {
        assert!(!page.contains(outside), "{outside}");
    }
    // The only block of script is data.
    assert_eq!(page.matches("<script").count(), page.matches(r#"<script type="application/json""#).count());
    assert!(
        page.contains("@page") && page.contains("print-color-adjust: exact") && page.contains("break-inside: avoid")
    );
}

#[test]
fn everything_is_escaped_and_still_read_back() {
    let hostile = "</script><script>alert(1)</script>\"'&<!--\u{202e}\u{0}\r\n\u{2028}Ø\u{1f600}";
    let log = PointLog { program: Some(hostile.to_owned()), tolerance: hostile.to_owned(), ..point("0") };
    let page = page(std::slice::from_ref(&log), Dialogue::En);
    assert_eq!(page.matches("<script").count(), 1);
    assert_eq!(page.matches("</script>").count(), 1);
    assert!(!page.contains("<!--") && !page.contains('\u{202e}') && !page.contains('\0'));
    assert!(page.contains("&#60;script&#62;alert(1)"), "{page}");
    let block = page.split_once("data-fitcheck=\"444\">").unwrap().1.split_once("</script>").unwrap().0;
    assert!(block.is_ascii() && !block.contains(['<', '>', '&']), "{block}");
    assert_eq!(points(page.as_bytes()), [log]);
}

#[test]
fn measurements_are_added_to_a_page() {
    let logs = [point("0.1"), point("0.5"), point("-0.2")];
    let mut added = Vec::new();
    for log in &logs {
        added = append(&added, log, Dialogue::Nl).unwrap();
    }
    assert_eq!(added, write(&logs, Dialogue::Nl).unwrap());
    assert_eq!(points(&added), logs);
    let answers = read(&added);
    let lines: Vec<usize> = answers.iter().map(|answer| answer.as_ref().unwrap().0).collect();
    let text = String::from_utf8(added).unwrap();
    let marked = text.lines().zip(1..).filter(|(line, _)| line.contains("data-fitcheck=\"444\"")).map(|(_, n)| n);
    assert_eq!(lines, marked.collect::<Vec<usize>>());
}

/// The page of two points, changed.
#[track_caller]
fn check(from: &str, to: &str, expected: &[&str]) {
    let page = page(&[point("0.1"), point("0.5")], Dialogue::En);
    assert!(page.contains(from), "{from}");
    let changed = page.replacen(from, to, 1);
    let said = |answer: Result<(usize, PointLog), _>| match answer {
        Ok((_, log)) => log.deviation.to_string(),
        Err(error) => {
            let error: fitcheck::control::point_log::PointLogError = error;
            error.what.to_string()
        }
    };
    assert_eq!(read(changed.as_bytes()).into_iter().map(said).collect::<Vec<_>>(), expected, "{from} to {to}");
    let added = append(changed.as_bytes(), &point("0"), Dialogue::En);
    assert_eq!(added.is_err(), expected.iter().any(|said| said.len() > 3), "{added:?}");
}

#[test]
fn contradictions_and_damage_are_refused_and_the_others_kept() {
    check("a", "a", &["0.1", "0.5"]);
    check(
        "\"deviation_mm\":\"0.1\"",
        "\"deviation_mm\":\"0.3\"",
        &["deviation 0.3 along the normal does not follow from those of the axes, 0.1", "0.5"],
    );
    check("\"5.1\"]", "\"5.2\"]", &["deviation 0.1 in Z is not measured minus nominal coordinate, 0.2", "0.5"]);
    check("\"GOOD\"", "\"SCRAP\"", &["status SCRAP does not follow from deviation and tolerance, GOOD", "0.5"]);
    check("\"GOOD\"", "null", &["status - does not follow from deviation and tolerance, GOOD", "0.5"]);
    check(
        "\"upper_mm\":\"0.4\"",
        "\"upper_mm\":\"-0.4\"",
        &["upper deviation -0.4 is below lower deviation -0.1", "0.5"],
    );
    check(
        "\"lower_mm\":\"-0.1\"",
        "\"lower_mm\":null",
        &["the measurement cannot be read: only one of upper_mm and lower_mm is there", "0.5"],
    );
    check(
        "\"normal\":[\"0\",\"0\",\"2\"]",
        "\"normal\":[\"0\",\"0\",\"-0\"]",
        &["normal 0, 0, -0 has no direction: it needs three numbers that are not all 0", "0.5"],
    );
    check("\"5.1\"]", "\"5.l\"]", &["5.l is not a number", "0.5"]);
    check("\"version\":1", "\"version\":2", &["log version 2 is not supported: expected 1 or earlier", "0.5"]);
    check(
        "content=\"2\"",
        "content=\"3\"",
        &["0.1", "0.5", "the page says that it holds 3 measurements, but it holds 2: it is cut off or was changed"],
    );
    let json = read(page(&[point("0")], Dialogue::En).replace("\"version\":1", "\"version\":1,\"x\":1").as_bytes());
    let error = json[0].as_ref().unwrap_err().to_string();
    assert!(error.contains(": the measurement cannot be read: unknown field `x`"), "{error}");
}

#[test]
fn every_prefix_of_a_page_says_that_something_is_missing() {
    let page = write(&[point("0.1"), point("0.5")], Dialogue::En).unwrap();
    let last = page.len() - "\n</tbody>\n</table>\n</body>\n</html>".len();
    for end in 0..last {
        let answers = read(&page[..end]);
        let whole = answers.iter().filter(|answer| answer.is_ok()).count();
        assert!(whole == 2 || answers.iter().any(Result::is_err), "{end}");
    }
}

#[test]
fn what_is_no_log_says_so() {
    for bytes in [&b""[..], b"<html><body>TCHPR444</body></html>", b"\xff\xfe\0"] {
        let answers = read(bytes);
        assert_eq!(answers.len(), 1);
        assert_eq!(answers[0].as_ref().unwrap_err().what, PointFault::NoLog);
    }
    assert!(!is_log("<html></html>"));
    assert!(append(b"<html></html>", &point("0"), Dialogue::En).is_err());
}

#[test]
fn what_contradicts_itself_is_not_written() {
    let fault = |log: PointLog| write(&[point("0"), log], Dialogue::En).unwrap_err().to_string();
    assert_eq!(
        fault(PointLog { status: Some(Status::Rework), ..point("0") }),
        "line 2: status REWORK does not follow from deviation and tolerance, GOOD"
    );
    assert_eq!(
        fault(PointLog { status: None, band: None, normal: [0.0, f64::NAN, 1.0], ..point("0") }),
        "line 2: normal 0, NaN, 1 has no direction: it needs three numbers that are not all 0"
    );
    assert_eq!(fault(PointLog { unit: Unit::Micrometre, ..point("0") }), "line 2: a log is in mm or inch, not in µm");
}

#[test]
fn figures_may_be_apart_by_a_tenth_of_a_micrometre_and_no_nanometre_more() {
    let along = |deviation: &str| PointLog { deviation: mm(deviation), ..point("0") }.check().is_ok();
    assert!(along("0.0001") && along("-0.0001"));
    assert!(!along("0.000101") && !along("-0.000101"));
    // Across the normal, so that only the axis itself is wrong.
    let axis = |deviation: &str| {
        let deviations = [mm(deviation), Length::ZERO, Length::ZERO];
        PointLog { deviations, ..point("0") }.check().is_ok()
    };
    assert!(axis("0.0001") && axis("-0.0001"));
    assert!(!axis("0.000101") && !axis("-0.000101"));
}

#[test]
fn the_normal_may_have_any_length() {
    let mut log = point("0");
    for scale in [1.0, 1e-3, 10.0, 1e-300, 1e300] {
        log.normal = [3.0 * scale, 0.0, 4.0 * scale];
        let [x, y, z] = log.unit_normal().unwrap();
        assert!((x - 0.6).abs() < 1e-15 && y == 0.0 && (z - 0.8).abs() < 1e-15, "{scale}: {x} {y} {z}");
    }
}

#[test]
fn a_page_is_imported_as_deviations_with_their_status() {
    let logs = [point("0.4"), point("0.400001"), point("-0.2"), PointLog { band: None, status: None, ..point("0.1") }];
    let now = jiff::civil::date(2000, 1, 1).at(0, 0, 0, 0);
    let bytes = write(&logs, Dialogue::De).unwrap();
    let imported = import("points.html", &bytes, &Sources::default(), now);
    assert_eq!((imported.rows, imported.records.len(), imported.errors.len()), (4, 0, 0));
    let said = imported.unjudged.iter().map(|point| match &point.why {
        WhyUnjudged::Point(c) => {
            let remove = c.removal.map_or(String::new(), |r| format!(" remove {} or {}", r.to_limit, r.to_middle));
            format!("{} in {} to {} {}{remove}", point.measured.unwrap(), c.minimum, c.maximum, c.status)
        }
        why => format!("{} {why}", point.measured.unwrap()),
    });
    assert_eq!(
        said.collect::<Vec<_>>(),
        [
            "0.4 in -0.1 to 0.4 GOOD",
            "0.400001 in -0.1 to 0.4 REWORK remove 0.000001 or 0.250001",
            "-0.2 in -0.1 to 0.4 SCRAP",
            "0.1 not judged: the point was probed without a tolerance",
        ]
    );
    assert_eq!(imported.unjudged[0].time, logs[0].date_time.unwrap());
    let damaged = String::from_utf8(bytes).unwrap().replacen("REWORK\"", "GOOD\"", 1);
    let imported = import("points.html", damaged.as_bytes(), &Sources::default(), now);
    assert_eq!((imported.rows, imported.errors.len()), (4, 1));
    assert_eq!(
        imported.errors[0].to_string(),
        format!(
            "line {}: status GOOD does not follow from deviation and tolerance, REWORK",
            imported.errors[0].place.line.unwrap()
        )
    );
    assert_eq!(imported.errors[0].what.given, "GOOD");
}

fn length(most: i64) -> impl Strategy<Value = Length> {
    (-most..=most).prop_map(|nm| Length::from_nanometres(nm).unwrap())
}

fn any_point() -> impl Strategy<Value = PointLog> {
    let lengths = |most| [length(most), length(most), length(most)];
    let part = || prop_oneof![Just(0.0), -10.0..10.0, -1e-300..1e-300, -1e300..1e300];
    let normal = [part(), part(), part()].prop_filter("no direction", |n| n.iter().any(|part| *part != 0.0));
    let band = proptest::option::of([length(2_000_000), length(2_000_000)]);
    let seconds = proptest::option::of(0_i64..4_000_000_000);
    let texts = (proptest::option::of(any::<String>()), any::<String>(), any::<bool>());
    (lengths(99_999_999_900), lengths(3_000_000), normal, band, seconds, texts).prop_map(
        |(nominal, deviations, normal, band, seconds, (program, tolerance, inch))| {
            let measured = std::array::from_fn(|at| nominal[at].checked_add(deviations[at]).unwrap());
            let band = band.map(|[a, b]| Band { upper: a.max(b), lower: a.min(b) });
            let mut log = PointLog {
                date_time: seconds.map(|s| {
                    jiff::civil::date(1990, 1, 1)
                        .at(0, 0, 0, 0)
                        .checked_add(jiff::SignedDuration::from_secs(s))
                        .unwrap()
                }),
                program,
                is_simulated: inch,
                unit: if inch { Unit::Inch } else { Unit::Millimetre },
                nominal,
                normal,
                measured,
                deviations,
                deviation: Length::ZERO,
                tolerance,
                band,
                status: None,
            };
            let unit = log.unit_normal().unwrap();
            let along: f64 = unit.iter().zip(deviations).map(|(part, d)| part * d.to_mm_f64()).sum();
            log.deviation = Length::from_mm_f64(along).unwrap();
            log.status = band.map(|band| band.status(log.deviation));
            log
        },
    )
}

proptest! {
    /// Whatever was measured and whatever the texts hold, the page returns it exactly.
    #[test]
    fn a_page_reads_back_unchanged(
        logs in proptest::collection::vec(any_point(), 0..4),
        language in proptest::sample::select(Dialogue::ALL.to_vec()),
    ) {
        let page = write(&logs, language).unwrap();
        if logs.is_empty() {
            prop_assert!(read(&page).is_empty());
        } else {
            prop_assert_eq!(points(&page), logs);
        }
        prop_assert!(is_log(std::str::from_utf8(&page).unwrap()));
    }

    #[test]
    fn any_bytes_are_read_without_panic(
        before in any::<Vec<u8>>(),
        json in "[\\{\\}\\[\\]\":,a-z0-9\\\\ ]{0,60}",
        after in any::<Vec<u8>>(),
    ) {
        let open = b"<script type=\"application/json\" data-fitcheck=\"444\">";
        let _answers = read(&[&before[..], open, json.as_bytes(), b"</script>", &after].concat());
    }

    /// A page with one byte changed gives the same figures, or the byte is in one of them, or the page is refused.
    #[test]
    fn one_changed_byte_never_moves_a_verdict(at in 0..4000_usize, byte in any::<u8>()) {
        let log = point("0.1");
        let mut page = write(std::slice::from_ref(&log), Dialogue::En).unwrap();
        let at = at % page.len();
        page[at] = byte;
        for (_, read) in read(&page).into_iter().flatten() {
            let status = read.band.map(|band| band.status(read.deviation));
            prop_assert_eq!(read.status, status);
            prop_assert!(read.deviation == log.deviation || read.status == log.status, "{:?}", read);
        }
    }
}
