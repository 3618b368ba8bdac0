//! Reports of measuring machines and of gauges: QIF 2, printed reports and tables of CALYPSO, GEOPAK, GOM, and lines of gauges. The shapes are
//! those of `docs/SOURCES.md`; limits and verdicts are written here by hand.

use std::io::Cursor;
use std::path::Path;
use std::process::Command;

use fitcheck::exchange::{FORMATS, ImportInputs, Item, Mapping, import_each, import_given, read_plan};
use fitcheck::length::Length;
use fitcheck::tolerance::{Feature, Sources};

use super::printed_reports::{check, folder, said};

const NOW: jiff::civil::DateTime = jiff::civil::DateTime::constant(2000, 1, 1, 0, 0, 0, 0);

fn bytes(file: &str) -> Vec<u8> {
    std::fs::read(folder().join(file)).unwrap()
}

#[test]
fn the_older_versions_of_qif_say_what_the_new_one_says() {
    let of = |file: &str| {
        let mut found = Vec::new();
        import_each("a.qif", &bytes(file), &Sources::default(), NOW, &mut |item| match item {
            Item::Record { record, labels, .. } => {
                let limits = &record.limits;
                assert_eq!(limits.feature, Some(Feature::Hole), "{file}");
                let limits = format!("{} {}", limits.minimum(), limits.maximum());
                let part = format!("{} {}", labels.part, labels.serial);
                let place = labels.place.map(|place| place.map(|length| length.to_string()).unwrap_or_default());
                let status = record.verdict.size.status;
                found.push(format!("{} {limits} {part} {place:?} {} {status:?}", record.id, record.time));
            }
            Item::Warning(warning) => found.push(warning.what.kind.to_string()),
            item => panic!("{file}: {item:?}"),
        });
        found
    };
    let newest = of("qif/minimal_bore_25H7.qif");
    assert_eq!(newest.len(), 2, "{newest:?}");
    let first = newest.iter().find(|line| line.starts_with("BORE1")).unwrap();
    assert!(first.starts_with("BORE1 25 H7 25 25.021 PN-4711 SN-0001 "), "{first}");
    assert!(first.ends_with(" 2025-01-15T10:21:33 Good"), "{first}");
    for file in ["qif/bore_2_1.qif", "qif/bore_2_0.qif"] {
        assert_eq!(of(file), newest, "{file}");
    }
}

#[test]
fn the_older_versions_of_qif_keep_their_own_words() {
    let with = |from: &str, to: &str| {
        let text = String::from_utf8(bytes("qif/bore_2_0.qif")).unwrap();
        assert!(text.contains(from), "{from}");
        said("a.qif", text.replace(from, to).as_bytes(), false)
    };
    let good = " BORE1 25 H7 25.0123 in 25 … 25.021: GOOD";
    let told = with("<CharacteristicStatusEnum>PASS", "<CharacteristicStatusEnum>FAIL");
    assert!(told.iter().any(|line| line.ends_with("the file says FAIL, but the limits say GOOD")), "{told:?}");
    // A basic size has no tolerance, and is no doubt of the verdict.
    let told = with("<CharacteristicStatusEnum>PASS", "<CharacteristicStatusEnum>BASIC");
    assert!(told.len() == 2 && told.iter().any(|line| line.ends_with(good)), "{told:?}");
    let told = with("<CharacteristicActuals>", "<CharacteristicActuals N=\"2\">");
    assert!(
        told.iter()
            .any(|line| line.ends_with("CharacteristicActuals says n=2, but has 1: something may be missing or added")),
        "{told:?}"
    );
    let told = with("versionQIF=\"2.0.0\"", "versionQIF=\"1.0.0\"");
    let version = "QIF version 1.0.0: this program is made for versions 2.0, 2.1 and 3.0";
    assert!(told.iter().any(|line| line.ends_with(version)), "{told:?}");
}

#[test]
fn a_printed_report_of_calypso_is_judged_row_by_row() {
    check(
        "protocol/housing.txt",
        &[
            "10 Diameter_Bore1 25.012 in 25 … 25.021: GOOD",
            "11 Distance_1 40.2 in 39.9 … 40.1: OUT OF LIMITS",
            "12 Outer diameter A 49.962 in 49.95 … 49.975: GOOD",
            "13 Flatness_1 0.004 in 0 … 0.01: GOOD",
            "14 Cone angle 1: Cone angle 1: not a size of a hole or shaft",
            "15 Diameter_Bore2: not judged: no limits given",
        ],
    );
    let open = "the file ends here without a line end, so the row may be cut off: it is skipped; if it is complete, add a line end";
    check(
        "protocol/odd_rows.txt",
        &[
            "3: Measured value: 25.0l2 is not a number",
            "4: unknown unit km: use mm, µm or inch",
            "5: 4 figures below 6 columns: it is not clear which figure stands in which column; print the report with all columns",
            "6? the report has 0.012 mm beyond the tolerance, but its figures give 0.009 mm",
            "6 Diameter_Bore4 25.03 in 25 … 25.021: OUT OF LIMITS",
            "7? the report has a deviation of 0.021 mm, but its figures give 0.012 mm",
            "7 Diameter_Bore5 25.012 in 25 … 25.021: GOOD",
            "8 Diameter_Bore6: not judged: the lower limit 25.021 is above the upper limit 25",
            "9 Diameter_Bore7 25.012 in 25 … 25.021: GOOD",
            "10 Diameter_Bore8 25.011888 in 24.99995 … 25.020956: GOOD",
            "13 Diameter_Bore1 25.013 in 25 … 25.021: GOOD",
            &format!("14: {open}"),
        ],
    );
}

#[test]
fn the_head_of_a_printed_report_goes_on_until_it_says_something_else() {
    let mut found = Vec::new();
    import_each("a.txt", &bytes("protocol/odd_rows.txt"), &Sources::default(), NOW, &mut |item| {
        if let Item::Record { labels, record, .. } = item {
            found.push(format!("{} {} {}", labels.part, labels.serial, record.id));
        }
    });
    assert_eq!(found.first().map(String::as_str), Some("HOUSING 17 Diameter_Bore4"));
    assert_eq!(found.last().map(String::as_str), Some("HOUSING 18 Diameter_Bore1"));
    let told = said("a.txt", &bytes("protocol/housing.txt"), false);
    assert!(
        told.contains(&"4? read for all values: Drawing number D-4711, Time/Date 2026-09-29 09:00".to_owned()),
        "{told:?}"
    );
    let mut times = Vec::new();
    import_each("a.txt", &bytes("protocol/housing.txt"), &Sources::default(), NOW, &mut |item| {
        if let Item::Record { record, .. } = item {
            times.push(record.time.to_string());
        }
    });
    assert!(!times.is_empty() && times.iter().all(|time| time == "2026-09-29T09:00:00"), "{times:?}");
}

#[test]
fn the_borders_of_a_printed_report_are_exact() {
    let heading = "Name  Measured value  Nominal value  +Tol  -Tol  Deviation  +/-\n";
    for (measured, status) in [
        ("25.0210 mm", "GOOD"),
        ("25.0211 mm", "OUT OF LIMITS"),
        ("25.0000 mm", "GOOD"),
        ("24.9999 mm", "OUT OF LIMITS"),
    ] {
        let text = format!("{heading}Diameter 1  {measured}  25.000  0.021  0.000  0.000\n");
        let told = said("a.txt", text.as_bytes(), true);
        assert!(told.last().unwrap().ends_with(&format!(": {status}")), "{measured}: {told:?}");
    }
    // A value that is printed too coarsely is on neither side.
    let text = format!("{heading}Diameter 1  25.02 mm  25.000  0.021  0.000  0.02\n");
    assert!(!said("a.txt", text.as_bytes(), true).last().unwrap().contains("GOOD"));
}

#[test]
fn a_printed_report_is_a_plan() {
    let sources = Sources::default();
    let given = ImportInputs::new(&sources, NOW);
    let text = read_plan("a.txt", &bytes("protocol/housing.txt"), given).unwrap().draft.to_toml();
    for line in ["name = \"Diameter_Bore1\"", "callout = \"40 +0.1/-0.1\"", "kind = \"form\""] {
        assert!(text.contains(line), "{line}: {text}");
    }
}

#[test]
fn a_table_of_calypso_may_have_a_head_and_a_summary() {
    let told = said("a.csv", &bytes("calypso/key_value_head.csv"), true);
    assert_eq!(
        told,
        [
            "7 Bore_1 25.012 in 25 … 25.021: GOOD",
            "8 Length_1 40.2 in 39.9 … 40.1: OUT OF LIMITS",
            "9 Flank_L: Angle: not a size of a hole or shaft",
            "10 Length_2 40.2 in 39.9 … 40.1: OUT OF LIMITS",
            "11 Bore_2 25.012 in 25 … 25.021: GOOD",
        ]
    );
    // Half a row is no summary.
    let mut cut = bytes("calypso/key_value_head.csv");
    cut.truncate(cut.windows(9).position(|at| at == b"Bore_2;Di").unwrap() + 9);
    assert!(said("a.csv", &cut, true).iter().any(|line| line.starts_with("11: ")));
}

#[test]
fn tolerances_of_geopak_are_read_with_names_and_without() {
    let judged = [
        "1 Circle_1 25.012 in 25 … 25.021: GOOD",
        "2 Circle_2 10.052 in 9.98 … 10.02: OUT OF LIMITS",
        "3 Point_1 5.01 in 4.95 … 5.05: GOOD",
        "4 Plane_1 0.03 in 0 … 0.05: GOOD",
        "5 Line_1: Angle: not a size of a hole or shaft",
    ];
    let told = said("a.txt", &bytes("geopak/tolerances.txt"), true);
    assert_eq!(told, judged);
    let told = said("a.txt", &bytes("geopak/unsigned.txt"), true);
    let minus = "1? column 6 has no minus signs: its values are read as lower deviations below the nominal size";
    assert_eq!(told[0], minus);
    assert_eq!(told[2], "2 Circle_2 9.985 in 9.98 … 10.02: GOOD");
    check(
        "geopak/named.csv",
        &[
            "1? columns skipped: 10 (TolBar)",
            "2 Circle_1 25.012 in 25 … 25.021: GOOD",
            "3 Circle_2 10.052 in 9.98 … 10.02: OUT OF LIMITS",
            "4? the file says Deviation 0.021, but that is not the deviation of 10.012 from 10",
            "4? the file says OutOfSpec 0.001, but the limits say GOOD",
            "4 Circle_3 10.012 in 9.98 … 10.02: GOOD",
        ],
    );
}

#[test]
fn a_table_of_gom_has_forms_without_a_nominal_value() {
    check(
        "gom/table.csv",
        &[
            "1? columns skipped: 2 (Description), 11 (Alignment)",
            "2 Cylinder 1 25.012 in 25 … 25.021: GOOD",
            "3 Circle 2 10.052 in 9.98 … 10.02: OUT OF LIMITS",
            "4 Point 3 5.01 in 4.95 … 5.05: GOOD",
            "5 Plane 4 0.03 in 0 … 0.05: GOOD",
            "6 Angle 5: Angle: not a size of a hole or shaft",
            "7 Distance 6 40.01 in 39.9 … 40.1: GOOD",
            "8? the file says Out 0,032, but the limits say GOOD",
            "8 Circle 7 10.012 in 9.98 … 10.02: GOOD",
        ],
    );
    // A diameter, a radius or a place without a nominal value has none.
    let of = |property: &str| {
        let text = format!(
            "Element;Property;Nominal;Actual;Tol -;Tol +\nA;Diameter;25;25.01;0;0.02\nB;{property};;0.03;;0.05\n"
        );
        said("a.csv", text.as_bytes(), true).pop().unwrap()
    };
    assert_eq!(of("Position"), "3 B 0.03 in 0 … 0.05: GOOD");
    for property in ["Diameter", "Radius", "X"] {
        assert_eq!(of(property), "3: the limits are deviations, but there is no nominal size", "{property}");
    }
    // `°` says what the column does, too.
    let angle = "Element;Property;Nominal;Actual;Tol -;Tol +\nA;Diameter;25;25.01;0;0.02\nB;Angle;90°;90.1°;-1°;1°\n";
    assert_eq!(said("a.csv", angle.as_bytes(), true).pop().unwrap(), "3 B: Angle: not a size of a hole or shaft");
}

/// The channel and the value of each line in nanometres, or the error.
fn gauged(bytes: &[u8], columns: Option<&str>) -> Vec<String> {
    let mapping = columns.map(|columns| columns.parse::<Mapping>().unwrap());
    let sources = Sources::default();
    let given = ImportInputs { mapping: mapping.as_ref(), ..ImportInputs::new(&sources, NOW) };
    let read = import_given("a.txt", &mut Cursor::new(bytes), given);
    assert!(read.records.is_empty());
    let value = |value: Option<Length>| value.map(|value| value.nanometres().to_string()).unwrap_or_default();
    let values = read.unjudged.iter().map(|row| format!("{} {} {}", row.line, row.id, value(row.measured)));
    values.chain(read.errors.iter().map(ToString::to_string)).collect()
}

#[test]
fn lines_of_gauges_ask_for_their_unit() {
    let mitutoyo = bytes("gauges/mitutoyo.txt");
    let asked = "line 1: line 1 of these gauge lines, 01A+025.0120, says neither mm nor inch: give the unit with import --columns unit=mm \
                 or --columns unit=inch";
    assert_eq!(gauged(&mitutoyo, None), [asked]);
    assert_eq!(gauged(&mitutoyo, Some("unit=um")), [asked]);
    let error = "line 3: 911 may be an error number of the gauge: if it is a size, write it with its unit, 911 mm";
    assert_eq!(gauged(&mitutoyo, Some("unit=mm")), ["1 01 25012000", "2 01 24990000", "4 01 -13000", error]);
    assert_eq!(gauged(&mitutoyo, Some("unit=inch")), ["1 01 635304800", "2 01 634746000", "4 01 -330200", error]);
    // The same digits may be of either unit: the user's word counts.
    let box_of_inches = b"01A+00.12345\r01A+00.12346\r";
    assert_eq!(gauged(box_of_inches, Some("unit=inch")), ["1 01 3135630", "2 01 3135884"]);
    assert_eq!(gauged(box_of_inches, Some("unit=mm")), ["1 01 123450", "2 01 123460"]);
}

#[test]
fn lines_of_gauges_that_say_their_unit_are_read() {
    for columns in [None, Some("unit=mm"), Some("unit=inch")] {
        let cdi = gauged(&bytes("gauges/cdi.txt"), columns);
        assert_eq!(cdi, ["1  2138000", "2  25011380", "3  -12700"]);
        let mahr = gauged(&bytes("gauges/mahr.txt"), columns);
        assert_eq!(mahr, ["1 1 25012000", "2 2 24990000"]);
    }
}

#[test]
fn half_a_line_of_a_gauge_is_no_value() {
    let whole = b"01A+025.0120\r01A+024.9900\r";
    let values = gauged(whole, Some("unit=mm"));
    // Digits before the channel is whole are a plain list of numbers.
    for cut in 4..whole.len() {
        let read = gauged(&whole[..cut], Some("unit=mm"));
        let is_error = |line: &String| line.starts_with("line ");
        assert!(read.iter().all(|line| is_error(line) || values.contains(line)), "{cut}: {read:?}");
    }
    // As long as the line before it, but without the unit that this has.
    let cut = gauged(b"1380, MM\r\n+  0.984", Some("unit=inch"));
    assert!(cut.len() == 2 && cut[0] == "1  1380000000" && cut[1].starts_with("line 2"), "{cut:?}");
    let refused = gauged(b"01A+025.0120\r01A+024.99x0\r", Some("unit=mm"));
    assert_eq!(refused, ["1 01 25012000", "line 2: +024.99x0 is not a number"]);
}

#[test]
fn each_file_is_of_its_format() {
    for (file, name) in [
        ("qif/bore_2_0.qif", "qif"),
        ("qif/bore_2_1.qif", "qif"),
        ("protocol/housing.txt", "calypso-text"),
        ("protocol/odd_rows.txt", "calypso-text"),
        ("geopak/tolerances.txt", "geopak"),
        ("geopak/unsigned.txt", "geopak"),
        ("geopak/named.csv", "measurements"),
        ("gom/table.csv", "measurements"),
        ("calypso/key_value_head.csv", "measurements"),
        ("gauges/mitutoyo.txt", "gauge"),
        ("gauges/cdi.txt", "gauge"),
        ("gauges/mahr.txt", "gauge"),
    ] {
        let bytes = bytes(file);
        let found = FORMATS.iter().find(|format| format.recognises(&bytes, file)).map(|format| format.name);
        assert_eq!(found, Some(name), "{file}");
    }
}

#[test]
fn batch_sets_angles_aside_as_import_does() {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/gom/table.csv");
    let batch = Command::new(env!("CARGO_BIN_EXE_fitcheck")).arg("batch").arg(file).output().unwrap();
    let text = String::from_utf8_lossy(&batch.stdout);
    let angle = text.lines().find(|line| line.starts_with("Angle 5")).unwrap();
    assert!(angle.contains("Angle: not a size of a hole or shaft") && !angle.contains("GOOD"), "{angle}");
    let plane = text.lines().find(|line| line.starts_with("Plane 4")).unwrap();
    assert!(plane.contains("GOOD"), "{plane}");
}
