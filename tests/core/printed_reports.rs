//! Reports that were printed: dimensions of PC-DMIS, and what probing macros print. The first two files are field cases with their answers;
//! the others are written here after the same shapes, each with a trap.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};

use fitcheck::exchange::{FORMATS, ImportInputs, Item, import_each, read_plan};
use fitcheck::tolerance::Sources;

pub(super) fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data")
}

fn items(name: &str, bytes: &[u8]) -> Vec<Item> {
    let mut items = Vec::new();
    let now = jiff::civil::date(2000, 1, 1).at(0, 0, 0, 0);
    import_each(name, bytes, &Sources::default(), now, &mut |item| items.push(item));
    items
}

/// `9 CIR5 25.012 GOOD`, `14: error`, `9? warning`. The head, the unit and skipped lines are left out where `is_short`.
pub(super) fn said(name: &str, bytes: &[u8], is_short: bool) -> Vec<String> {
    let line = |item: &Item| match item {
        Item::Record { line, record, .. } => {
            let limits = &record.limits;
            let (measured, word) = (record.measurement.diameter, record.verdict.size.status.word());
            format!("{line} {} {measured} in {} … {}: {word}", record.id, limits.minimum(), limits.maximum())
        }
        Item::Unjudged(row) => format!("{} {}: {}", row.line, row.id, row.why),
        Item::Error(error) => format!("{}: {}", error.place.line.unwrap(), error.what.kind),
        Item::Warning(warning) => format!("{}? {}", warning.place.line.unwrap(), warning.what.kind),
        Item::Contacts(_) => "contacts".to_owned(),
    };
    let usual = ["? read for all values: ", "? no unit given: ", "? skipped, not a measurement: "];
    let all = items(name, bytes);
    all.iter().map(line).filter(|line| !is_short || !usual.iter().any(|usual| line.contains(usual))).collect()
}

#[track_caller]
pub(super) fn check(file: &str, expected: &[&str]) {
    let bytes = std::fs::read(folder().join(file)).unwrap();
    assert_eq!(said(file.rsplit('/').next().unwrap(), &bytes, true), expected, "{file}");
}

#[test]
fn a_report_of_pc_dmis_has_the_answers_of_its_case() {
    check(
        "pcdmis/housing.txt",
        &[
            "9 CIR5 X 0.017 in -0.05 … 0.05: GOOD",
            "10 CIR5 Y 0.008 in -0.05 … 0.05: GOOD",
            "11 CIR5 25.012 in 25 … 25.021: GOOD",
            "14 CYL1 30.018 in 29.99 … 30.01: OUT OF LIMITS",
            "17 DIST1 4.271 in 4.15 … 4.5: GOOD",
        ],
    );
}

#[test]
fn a_print_of_a_probing_macro_has_the_answers_of_its_case() {
    check(
        "probed/two_features.txt",
        &[
            "5 FEATURE NO 1 25.012 in 24.979 … 25.021: GOOD",
            "6 FEATURE NO 1 X: not judged: no limits given",
            "7 FEATURE NO 1 Y: not judged: no limits given",
            "11 FEATURE NO 2 71.9072 in 70.9 … 71.1: OUT OF LIMITS",
        ],
    );
}

#[test]
fn the_head_of_a_report_says_part_serial_number_and_time() {
    let bytes = std::fs::read(folder().join("pcdmis/two_parts.txt")).unwrap();
    let mut found = Vec::new();
    for item in items("two_parts.txt", &bytes) {
        if let Item::Record { labels, record, .. } = item {
            let time = labels.time.map(|time| time.to_string()).unwrap_or_default();
            found.push(format!("{} {} {} {time}", labels.part, labels.serial, record.id));
        }
    }
    assert_eq!(found, ["HOUSING 17 CIR5 2025-09-17T10:09:47", "HOUSING 18 CIR5 "]);
    let said = said("two_parts.txt", &bytes, false);
    let head = "DATE 17-Sep-25, TIME 10:09:47 AM, PART NAME HOUSING, REV NUMBER E, SER NUMBER 17, STATS COUNT 1";
    assert_eq!(said[0], format!("9? read for all values: {head}"));
    assert_eq!(said[3], "18? 05/09/2025 10:09:47 AM is not a date and time: the time of import is used");
}

#[test]
fn a_unit_is_read_or_refused() {
    check(
        "pcdmis/inch.txt",
        &["9 CIR5 25.4127 in 25.4 … 25.42032: GOOD", "10 CIR5 25.42286 in 25.4 … 25.42032: OUT OF LIMITS"],
    );
}

#[test]
fn a_minus_tolerance_is_read_only_where_all_rows_leave_one_reading() {
    let x = "9 CIR5 X 40.01 in 39.95 … 40.05: GOOD";
    check("pcdmis/signed_minus.txt", &[x, "10 CIR5 24.997 in 24.995 … 25.021: GOOD"]);
    check("pcdmis/above_nominal.txt", &[x, "10 CIR5 25.003 in 25.007 … 25.028: OUT OF LIMITS"]);
    check(
        "pcdmis/open_minus.txt",
        &[
            "9: the minus tolerance -0.007 can lie below or above the nominal value, and no other row decides: print minus tolerances \
             without a sign",
        ],
    );
}

#[test]
fn columns_stand_in_any_order_and_a_position_has_its_bonus_alone() {
    check("pcdmis/columns_turned.txt", &["10 CIR5 25.012 in 25 … 25.021: GOOD", "11? columns skipped: MAX, MIN"]);
    check(
        "pcdmis/true_position.txt",
        &[
            "10 CIR5 X: not judged: no limits given",
            "11 CIR5 Y: not judged: no limits given",
            "12 CIR5 DF 25.012 in 25 … 25.021: GOOD",
            "13 CIR5 TP 0.028 in 0 … 0.032: GOOD",
            "17 PLN1 FLATNESS 0.023 in 0 … 0.02: OUT OF LIMITS",
            "20 ANGL1 A: 2D ANGLE A: not a size of a hole or shaft",
        ],
    );
}

#[test]
fn what_a_report_computed_is_compared() {
    check(
        "pcdmis/says_otherwise.txt",
        &[
            "9? the report has a deviation of -0.012 mm, but its figures give 0.012 mm",
            "9? the file says OUTTOL 0.012, but the limits say GOOD",
            "9 CIR5 25.012 in 25 … 25.021: GOOD",
            "10? the file says OUTTOL 0.000, but the limits say OUT OF LIMITS",
            "10 CIR5 25.03 in 25 … 25.021: OUT OF LIMITS",
            "11? the report has 0.007 mm beyond the tolerance, but its figures give 0.009 mm",
            "11 CIR5 25.03 in 25 … 25.021: OUT OF LIMITS",
        ],
    );
    check(
        "probed/says_otherwise.txt",
        &[
            "5? the report has a deviation of 0.03 mm, but its figures give 0.012 mm",
            "5? the file says OUT OF TOL 0.009, but the limits say GOOD",
            "5 FEATURE NO 1 25.012 in 24.979 … 25.021: GOOD",
        ],
    );
    check(
        "probed/late_error.txt",
        &[
            "5? the report has 0.005 mm beyond the tolerance, but its figures give 0.009 mm",
            "5 FEATURE NO 1 25.03 in 24.979 … 25.021: OUT OF LIMITS",
            "6 FEATURE NO 1 X: not judged: no limits given",
        ],
    );
    let out = "+++++OUT OF TOL+++++ ERROR  0.0090";
    let told =
        format!("6? the report says {out}, and none of its limits that are read here says so: look at the report");
    check("probed/no_size.txt", &[&told, "5 FEATURE NO 1 Z -8.01 in -8.05 … -7.95: GOOD"]);
}

#[test]
fn a_report_cut_in_the_middle_says_so() {
    let open = "the file ends here without a line end, so the row may be cut off: it is skipped; if it is complete, add a line end";
    check("pcdmis/cut.txt", &["9 CIR5 25.012 in 25 … 25.021: GOOD", &format!("10: {open}")]);
    check(
        "pcdmis/cut_heading.txt",
        &["9 CIR5 25.012 in 25 … 25.021: GOOD", "10: LOC2 has no row: the report may be cut off"],
    );
    let end = "the last line, END, is missing: the report may be cut off";
    check("probed/no_end.txt", &["5 FEATURE NO 1 25.012 in 24.979 … 25.021: GOOD", &format!("5? {end}")]);
    let row = "5 FEATURE NO 1 25.012 in 24.979 … 25.021: GOOD";
    check("probed/cut.txt", &[row, &format!("9: {open}"), &format!("9? {end}")]);
}

#[test]
fn a_report_cut_at_any_byte_gives_no_other_value() {
    let files = ["pcdmis/housing.txt", "probed/two_features.txt", "protocol/housing.txt", "geopak/tolerances.txt"];
    for file in files.into_iter().chain(["qif/bore_2_0.qif"]) {
        let whole = std::fs::read(folder().join(file)).unwrap();
        let rows = said("a.txt", &whole, true);
        for cut in 1..whole.len() {
            for line in said("a.txt", &whole[..cut], true) {
                let is_row = line.contains(" in ") && line.contains('…');
                assert!(!is_row || rows.contains(&line), "{file}, {cut} bytes: {line}");
            }
        }
    }
}

#[test]
fn rows_that_cannot_be_used_say_why() {
    check(
        "pcdmis/odd_rows.txt",
        &[
            "8: figures without a heading above them: the beginning of the dimension is missing",
            "11: unknown unit KM: use mm, µm or inch",
            "14: MEAS: 25.0l2 is not a number",
            "15: unknown axis Q: the row is skipped",
            "16: no measured value below MEAS",
            "17: 8 figures below 6 columns: it is not clear which figure stands in which column; print the report with all columns",
            "19: no column MEAS: add the measured values to the print format of the report",
            "20: figures without a heading above them: the beginning of the dimension is missing",
        ],
    );
    check(
        "probed/odd_rows.txt",
        &[
            "6: ACTUAL: 25.0l20 is not a number",
            "7: SIZE: a length is missing",
            "8: no measured value below ACTUAL",
            "9 FEATURE NO 1 D: FORM D: not a size of a hole or shaft",
        ],
    );
}

#[test]
fn a_print_of_a_cam_system_has_toolpaths_and_components() {
    check(
        "probed/cam.txt",
        &[
            "16? the report says +++++OUT OF POS+++++ ERROR TP  0.0100 RADIAL, and none of its limits that are read here says so: look at \
             the report",
            "10 Bore left 25.03 in 24.979 … 25.021: OUT OF LIMITS",
            "14 Bore left X: POSN X TOL TP: not a size of a hole or shaft",
            "15 Bore left Y: not judged: the file says NaN, so there may be no valid value",
            "21 Slot X 12.01 in 11.98 … 12.02: GOOD",
            "22 Slot: ANG: not a size of a hole or shaft",
        ],
    );
    let bytes = std::fs::read(folder().join("probed/two_components.txt")).unwrap();
    let mut serials = Vec::new();
    for item in items("two_components.txt", &bytes) {
        if let Item::Record { labels, .. } = item {
            serials.push(labels.serial);
        }
    }
    assert_eq!(serials, ["1", "2"]);
}

#[test]
fn the_sizes_of_a_report_are_a_plan() {
    let sources = Sources::default();
    for (file, expected) in [
        ("pcdmis/housing.txt", vec!["CIR5", "CYL1"]),
        ("pcdmis/two_parts.txt", vec!["CIR5"]),
        ("probed/two_features.txt", vec!["FEATURE NO 1", "FEATURE NO 2"]),
        ("probed/two_components.txt", vec!["FEATURE NO 1"]),
    ] {
        let bytes = std::fs::read(folder().join(file)).unwrap();
        let given = ImportInputs::new(&sources, jiff::civil::DateTime::default());
        let document = read_plan("a.txt", &bytes, given).unwrap();
        let text = document.draft.to_toml();
        for name in expected {
            assert!(text.contains(&format!("name = \"{name}\"")), "{file}: {text}");
        }
    }
}

#[test]
fn every_encoding_and_line_end_gives_the_same() {
    let text = String::from_utf8(std::fs::read(folder().join("pcdmis/housing.txt")).unwrap()).unwrap();
    let expected = said("a.txt", text.as_bytes(), false);
    let utf16: Vec<u8> = std::iter::once(0xfeff).chain(text.encode_utf16()).flat_map(u16::to_le_bytes).collect();
    let crlf = text.replace("\r\n", "\n").replace('\n', "\r\n");
    for bytes in [format!("\u{feff}{text}").into_bytes(), utf16, crlf.into_bytes()] {
        assert_eq!(said("a.txt", &bytes, false), expected);
    }
}

#[test]
fn other_texts_are_no_printed_reports() {
    let named = |text: &str| {
        let format = FORMATS.iter().find(|format| format.recognises(text.as_bytes(), "a.txt"));
        format.map_or("", |format| format.name)
    };
    for text in [
        "id;callout;measured\nDIM 1;25 H7;25.012\n",
        "AX\tNOMINAL\t+TOL\t-TOL\tMEAS\nD\t25\t0.021\t0\t25.012\n",
        "SIZE,ACTUAL\n25,25.012\n",
        "COMPONENT NO 1 FEATURE NO 1\n",
        "25.012\n25.013\n",
        "25.012 mm\n25.013 mm\n",
        "1;2;3;25.000;0.021;0.000;25.012;0.013;;\n1;2;3;25.000;0.021;0.000;25.012;0.020;;\n",
        "Name  Measured value  Nominal value  +Tol\nA  25.012 mm  25.000  0.021\n",
    ] {
        assert!(!["pcdmis", "probed", "calypso-text", "geopak", "gauge"].contains(&named(text)), "{text}");
    }
}

#[test]
fn a_file_that_is_known_and_not_read_is_named() {
    for (bytes, expected) in [
        (&b"ISO-10303-21;\nHEADER;\n"[..], "a STEP model: Fitcheck reads no models"),
        (b"solid part\n  facet normal 0 0 1\n", "a STL model: Fitcheck reads no models"),
        (b"  0\nSECTION\n  2\nHEADER\n", "a DXF drawing: Fitcheck reads no drawings"),
        (b"AC1027\0\0\0", "a DWG drawing: Fitcheck reads no drawings"),
        (b"%PDF-1.7\n%\xe2\xe3\xcf\xd3\n", "a PDF document: Fitcheck reads no documents"),
        (b"\x89PNG\r\n\x1a\n\0\0", "a PNG image: Fitcheck reads no images"),
        (b"\xff\xd8\xff\xe0\0\x10JFIF", "a JPEG image: Fitcheck reads no images"),
        (b"7z\xbc\xaf\x27\x1c\0\x04", "a 7z archive: unpack it"),
        (b"<!DOCTYPE html><html><body>25.012</body></html>", "a HTML document: Fitcheck reads no documents"),
    ] {
        let told = said("part.csv", bytes, false);
        assert!(told.len() == 1 && told[0].starts_with(&format!("1: {expected}")), "{expected}: {told:?}");
        let sources = Sources::default();
        let given = ImportInputs::new(&sources, jiff::civil::DateTime::default());
        let refused = read_plan("part.csv", bytes, given).map(|_| ()).unwrap_err();
        assert!(refused.what.to_string().contains(expected), "{}", refused.what);
    }
    let iges = format!("{:72}S      1\n{:72}S      2\n", "A part", "");
    assert!(said("part.igs", iges.as_bytes(), false)[0].starts_with("1: a IGES model"));
}

/// One table of what is read, made from the list of formats: where a page has another one, this is what belongs there.
#[test]
fn readme_and_manual_have_the_table_of_what_is_read() {
    let mut table = "| what Fitcheck reads | files |\n|---|---|\n".to_owned();
    for format in FORMATS {
        let endings: Vec<String> = format.endings.iter().map(|ending| format!("`.{ending}`")).collect();
        writeln!(table, "| {format} | {} |", endings.join(" ")).unwrap();
    }
    for page in ["README.md", "docs/manual/formats.md"] {
        let text = std::fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join(page)).unwrap();
        assert!(text.contains(&format!("{table}\n")), "{page}:\n{table}");
    }
}
