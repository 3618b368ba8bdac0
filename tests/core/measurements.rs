//! Files of measurements, as rows in and records, errors and warnings out.

use fitcheck::exchange::{FORMATS, Imported, import};
use fitcheck::length::Length;
use fitcheck::tolerance::table::Column;
use fitcheck::tolerance::{DeviationTable, Deviations, Sources};
use fitcheck::verdict::Status;
use jiff::civil::DateTime;

/// Up to 18 and up to 30 mm, after ISO 286-2.
fn tables() -> Sources {
    let um = Length::from_micrometres;
    let column = |class: &str, cells: [(i32, i32); 2]| Column {
        class: class.parse().unwrap(),
        cells: cells.iter().map(|&(upper, lower)| Deviations::new(um(upper), um(lower)).ok()).collect(),
    };
    let table = |name: &str, columns: Vec<Column>| {
        DeviationTable::new(name, true, vec!["18".parse().unwrap(), "30".parse().unwrap()], columns).unwrap()
    };
    Sources::of_tables(vec![
        table("hole.tab", vec![column("H7", [(18, 0), (21, 0)]), column("K7", [(6, -12), (6, -15)])]),
        table("shaft.tab", vec![column("g6", [(-6, -17), (-7, -20)])]),
    ])
}

fn now() -> DateTime {
    jiff::civil::date(2025, 1, 2).at(3, 4, 5, 0)
}

fn read(bytes: &[u8]) -> Imported {
    let imported = import("m.csv", bytes, &tables(), now());
    assert_eq!(imported.rows, imported.records.len() + imported.unjudged.len() + imported.errors.len());
    assert_eq!(imported.lines.len(), imported.records.len());
    imported
}

/// One text per record, unjudged measurement, error and warning.
fn said(bytes: &[u8]) -> Vec<String> {
    let imported = read(bytes);
    let mut said = Vec::new();
    for (record, line) in imported.records.iter().zip(&imported.lines) {
        let callout = record.callout.unwrap();
        let doubt = record.doubt.map_or(String::new(), |doubt| format!("; {doubt}"));
        let (id, measured) = (&record.id, record.measurement.diameter);
        said.push(format!("{line} {id}: {callout} is {measured} {}{doubt}", record.verdict.status()));
    }
    for unjudged in &imported.unjudged {
        let measured = unjudged.measured.map_or(String::new(), |measured| measured.to_string());
        said.push(format!("{} {}: {measured} {}", unjudged.line, unjudged.id, unjudged.why));
    }
    said.extend(imported.errors.iter().map(|error| format!("! {error} <{}>", error.what.given)));
    said.extend(imported.warnings.iter().map(|warning| format!("? {warning}")));
    said
}

#[track_caller]
fn check(text: &str, expected: &[&str]) {
    assert_eq!(said(text.as_bytes()), expected, "{text}");
}

#[test]
fn three_rows_are_judged() {
    let rows = ["2 b1: 25 H7 is 25.012 GOOD", "3 b2: 25 H7 is 24.998 REWORK", "4 b3: 20 g6 is 19.9799 SCRAP"];
    check("id,callout,measured\nb1,25 H7,25.012\nb2,25 H7,24.998\nb3,20 g6,19.9799\n", &rows);
    check("id;callout;measured\nb1;25 H7;25,012\nb2;25H7;24,998\nb3;Ø20 g6;19,9799", &rows);
    check("Teil\tPassung\tIstmaß [mm]\r\nb1\t25 H7\t25,012\r\nb2\t25 H7\t24,998\r\nb3\t20 g6\t19,9799\r\n", &rows);
    check("naam|passing|gemeten\nb1|25 H7|25,012\nb2|25 H7|24,998\nb3|20 g6|19,9799\n", &rows);
    check("pezzo;tolleranza;valore misurato\nb1;25 H7;25,012\nb2;25 H7;24,998\nb3;20 g6;19,9799\n", &rows);
    check("\u{feff}id;callout;measured_mm\nb1;25 H7;25.012 mm\nb2;25 H7;24.998\nb3;20 g6;19979.9 µm\n", &rows);
    check("id;callout;measured [µm]\nb1;25 H7;25012\nb2;25 H7;24998\nb3;20 g6;19979.9\n", &rows);
    check("part,nominal,class,measured\nb1,25,H7,25.012\nb2,25.0,H7,24.998\nb3,20,g6,19.9799\n", &rows);
    check("part,diameter,class,measured\nb1,25,H7,25.012\nb2,25.0,H7,24.998\nb3,20,g6,19.9799\n", &rows);
    check("name,fit,diameter\nb1,25 H7,25.012\nb2,25 H7,24.998\nb3,20 g6,19.9799\n", &rows);
    check(
        "\"id\",\"callout\",\"measured\"\n\"b1\",\"25 H7\",\"25,012\"\n\"b2\",\"25 H7\",\"24,998\"\nb3,20 g6,\"19,9799\"\n",
        &rows,
    );
}

#[test]
fn a_header_may_be_missing() {
    let rows = ["1 b1: 25 H7 is 25.012 GOOD", "2 b2: 20 g6 is 19.99 GOOD"];
    check("b1,25 H7,25.012\nb2,20 g6,19.990\n", &rows);
    check("b1;25 H7;25,012\nb2;20 g6;19,990\n", &rows);
    check("b1;25;H7;25,012\nb2;20;g6;19,990\n", &rows);
    check("b1\t25.012\t25 H7\nb2\t19.990\t20 g6\n", &rows);
    check("1,25 H7,25.012\n2,20 g6,19.990\n", &["1 1: 25 H7 is 25.012 GOOD", "2 2: 20 g6 is 19.99 GOOD"]);
    check("25 H7;25,012\n", &["1 : 25 H7 is 25.012 GOOD"]);
    check(
        "foo;bar;baz\nb1;25 H7;25,012\n",
        &["2 b1: 25 H7 is 25.012 GOOD", "? line 1: skipped, not a measurement: foo bar baz"],
    );
}

#[test]
fn borders_are_exact() {
    check(
        "callout;measured\n25 H7;25\n25 H7;25.021\n25 H7;24.999999\n25 H7;25.021001\n",
        &[
            "2 : 25 H7 is 25 GOOD",
            "3 : 25 H7 is 25.021 GOOD",
            "4 : 25 H7 is 24.999999 REWORK",
            "5 : 25 H7 is 25.021001 SCRAP",
        ],
    );
}

#[test]
fn bad_rows_are_listed_and_good_ones_kept() {
    check(
        "id;callout;measured\nb1;25 H7;25.012\nb2;25 H7;25.0l2\nb3;25 Z9;25.012\nb4;25 H7\nb5;25 H7;\nb6;25 Hh7;25\nb7;25 H7;1.234,5\nb8;40 H7;40.01\nb9;25 H7;25.01;9\nb10;25 H7;-25.01\nb11;25 H7;25,012\nb12;;25.012\n",
        &[
            "2 b1: 25 H7 is 25.012 GOOD",
            "13 b12: 25.012 not judged: no callout given",
            "! line 3, column 3: measured: 25.0l2 is not a number <25.0l2>",
            "! line 4, column 2: Z9 is not in table hole.tab; it has H7 K7 <25 Z9>",
            "! line 5: expected 3 cells, found 2 <25 H7>",
            "! line 6, column 3: measured: a length is missing <>",
            "! line 7, column 2: callout: Hh7 mixes upper and lower case: write HH7 for a hole or hh7 for a shaft (character 4) <25 Hh7>",
            "! line 8, column 3: measured: 1.234,5 has a different decimal sign than the other values: \".\" <1.234,5>",
            "! line 9, column 2: nominal size 40 mm is beyond table hole.tab, whose last range is over 18 up to and including 30 mm <40 H7>",
            "! line 10, column 4: expected 3 cells, found 4: is the separator also used as decimal sign or within a text? <9>",
            "! line 11, column 3: measured: a diameter of -25.01 is not above 0 <-25.01>",
            "! line 12, column 3: measured: 25,012 has a different decimal sign than the other values: \".\" <25,012>",
        ],
    );
}

#[test]
fn a_decimal_comma_between_separating_commas_is_never_taken_for_two_numbers() {
    let long = "expected 3 cells, found 4: is the separator also used as decimal sign or within a text?";
    check("id,callout,measured\nb1,25 H7,25,030\n", &[&format!("! line 2, column 4: {long} <030>")]);
    let one = "25,030 may be one number with a decimal comma: use a decimal point or another separator";
    check(
        "id,callout,measured,remark\nb1,25 H7,25,030\n",
        &[&format!("! line 2, column 3: {one} <25>"), "? line 1: columns skipped: 4 (remark)"],
    );
    check(
        "b1,25 H7,25.01,ok\nb2,25 H7,25,030\nb3,25 H7,25.02,ok\n",
        &["1 b1: 25 H7 is 25.01 GOOD", "3 b3: 25 H7 is 25.02 GOOD", &format!("! line 2, column 3: {one} <25>")],
    );
    // A column of whole numbers is one where the file shows it.
    check(
        "id,callout,measured,tool\nb1,25 H7,25.01,3\nb2,25 H7,25,3\nb3,25 H7,25.02,3\n",
        &[
            "2 b1: 25 H7 is 25.01 GOOD",
            "3 b2: 25 H7 is 25 GOOD",
            "4 b3: 25 H7 is 25.02 GOOD",
            "? line 1: columns skipped: 4 (tool)",
        ],
    );
    check(
        "25 H7,25,030\n25 H7,25,012\n",
        &[
            "! line 1: columns 2, 3 may each be the measured value: choose one with import --columns, such as measured=3, or name the columns in the first line so that only one fits, such as id;callout;measured <>",
        ],
    );
    check(
        "25,5 H7,25.512\n",
        &[
            "! line 1, column 2: 25,5 H7 may be one number with a decimal comma: use a decimal point or another separator <5 H7>",
        ],
    );
}

#[test]
fn what_could_be_two_columns_is_refused() {
    check(
        "id;callout;measured 1;measured 2\nb1;25 H7;25.01;25.02\n",
        &[
            "! line 1: columns 3 (measured 1), 4 (measured 2) may each be the measured value: choose one with import --columns, such as measured=3, or name the columns in the first line so that only one fits, such as id;callout;measured <>",
        ],
    );
    check(
        "id;callout;remark\nb1;25 H7;x\n",
        &["! line 1: no column of measured values: name it in the first line, such as id;callout;measured <>"],
    );
    check("id;callout;measured [cm]\nb1;25 H7;2.5\n", &["! line 1: unknown unit cm: use mm, µm or inch <>"]);
    check(
        "nominal;callout;measured\n24;25 H7;25.01\n",
        &["! line 2, column 2: callout 25 H7 does not match nominal size 24 in its own column <25 H7>"],
    );
}

#[test]
fn comments_blank_lines_and_what_stands_above_are_told_apart() {
    check(
        "Order 7;;\n\n# probed on machine 3\nid;callout;measured\n;;\n\"b1\";25 H7;25.012\n#b2;25 H7;25.013\n",
        &[
            "6 b1: 25 H7 is 25.012 GOOD",
            "! line 7: a line that begins with # is a comment, but this one holds a measurement <#b2>",
            "? line 1: skipped, not a measurement: Order 7",
        ],
    );
    check("sep=;\r\nid;callout;measured\r\nb1;25 H7;25,012\r\n", &["3 b1: 25 H7 is 25.012 GOOD"]);
    check(
        "id;callout;measured\n\"b1;25 H7;25.012\nb2;25 H7;25.012\n",
        &["3 b2: 25 H7 is 25.012 GOOD", "! line 2: a quotation mark is not closed on this line <\"b1;25 H7;25.012>"],
    );
}

#[test]
fn other_columns_are_named_and_times_are_used() {
    check(
        "id;callout;measured;shift\nb1;25 H7;25.012;A. B.\n",
        &["2 b1: 25 H7 is 25.012 GOOD", "? line 1: columns skipped: 4 (shift)"],
    );
    let time = |text: &str| read(text.as_bytes()).records[0].time.to_string();
    assert_eq!(time("callout;measured;time\n25 H7;25.012;2024-03-14 08:05:09\n"), "2024-03-14T08:05:09");
    assert_eq!(time("callout;measured;Datum;Uhrzeit\n25 H7;25.012;14.3.2024;8:05\n"), "2024-03-14T08:05:00");
    assert_eq!(time("callout;measured;date\n25 H7;25.012;\n"), "2025-01-02T03:04:05");
    check(
        "callout;measured;date\n25 H7;25.012;03/04/2024\n",
        &["2 : 25 H7 is 25.012 GOOD", "? line 2: 03/04/2024 is not a date and time: the time of import is used"],
    );
}

#[test]
fn values_of_another_quantity_are_doubted() {
    let inch = "measured value is the nominal size divided by 25.4: is it in inch?";
    check("callout;measured\n25 H7;0.984\n", &[&format!("2 : 25 H7 is 0.984 REWORK; {inch}")]);
    check("callout;measured [inch]\n25 H7;0.985\n", &["2 : 25 H7 is 25.019 GOOD"]);
}

#[test]
fn without_callouts_nothing_is_judged() {
    check("id;measured\nb1;25.012\n", &["2 b1: 25.012 not judged: no callout given"]);
}

#[test]
fn encodings_of_spreadsheets_are_read() {
    let text = "Teil;Passung;Istmaß\r\nBüchse;25 H7;25,012\r\n";
    let expected = ["2 Büchse: 25 H7 is 25.012 GOOD"];
    assert_eq!(said(text.as_bytes()), expected);
    assert_eq!(said(&encoding_rs::WINDOWS_1252.encode(text).0), expected);
    let utf16: Vec<u8> = "\u{feff}".encode_utf16().chain(text.encode_utf16()).flat_map(u16::to_le_bytes).collect();
    assert_eq!(said(&utf16), expected);
}

#[test]
fn what_is_no_measurement_says_so() {
    check("", &["! line 1: the file is empty <>"]);
    check("\u{feff}\r\n \r\n", &["! line 1: the file is empty <>"]);
    check("id;callout;measured\n", &["! line 1: no row holds a measurement <>"]);
    check("# nothing\n", &["! line 1: no row holds a measurement <>"]);
    check(
        "Hello world\n",
        &["! line 1: no column of measured values: name it in the first line, such as id;callout;measured <>"],
    );
    let garbage: Vec<u8> = (0..4096_u32).map(|n| n.wrapping_mul(2_654_435_761).to_le_bytes()[3]).collect();
    assert_eq!(said(&garbage), ["! line 1: not a file of a known format <>"]);
    assert_eq!(
        said(b"PK\x03\x04\x14\0\x06\0\x08\0\0\0!\0"),
        ["! line 1: the end of the workbook is missing: it may be cut off <>"]
    );
}

#[test]
fn long_cells_are_cut_in_what_is_said() {
    let long = "9".repeat(100_000);
    let imported = read(format!("id;callout;measured\nb;25 H7;{long}\nb;{long};25\n").as_bytes());
    for error in &imported.errors {
        assert!(error.what.given.chars().count() <= 61 && error.to_string().len() < 300, "{error}");
    }
    assert_eq!(imported.errors.len(), 2);
}

#[test]
fn formats_are_told_apart() {
    let format =
        |name: &str, bytes: &[u8]| FORMATS.iter().find(|format| format.recognises(bytes, name)).map(|f| f.name);
    assert_eq!(format("a.csv", b"id;callout;measured\nb;25 H7;25\n"), Some("measurements"));
    assert_eq!(format("a.csv", b"bore 421;25 H7;25.012\nbore 422;25 H7;25.012\n"), Some("measurements"));
    assert_eq!(format("a.csv", b"x,y\n1,2\n"), Some("contacts"));
    assert_eq!(format("a.csv", b"x [mm];y [mm];z [mm]\n1,5;2;3\n"), Some("contacts"));
    assert_eq!(format("a.csv", b"1.5 ,2.25\n-3e-3,4\n1,1\n"), Some("contacts"));
    assert_eq!(format("tchpr421.txt", b""), Some("log"));
    assert_eq!(format("a.bin", &[0, 1, 2, 3]), None);
}

proptest::proptest! {
    /// Whatever a row holds, it is a record, is kept apart or is an error, on its own line.
    #[test]
    fn nothing_is_dropped(rows in proptest::collection::vec("[a-c]?;(25 H7|25 Z9|20 g6|7|);(25\\.0[0-9]{2}|2[,.;x]5|\"25|)", 1..20)) {
        let text = format!("id;callout;measured\n{}\n", rows.join("\n"));
        let imported = read(text.as_bytes());
        let blank = rows.iter().filter(|row| row.trim_matches(';').is_empty()).count();
        proptest::prop_assume!(blank < rows.len());
        proptest::prop_assert_eq!(imported.rows, rows.len() - blank, "{}", text);
        let mut lines: Vec<usize> = imported.lines.clone();
        lines.extend(imported.unjudged.iter().map(|unjudged| unjudged.line));
        lines.extend(imported.errors.iter().map(|error| error.place.line.unwrap()));
        lines.sort_unstable();
        let expected: Vec<usize> = (2..).zip(&rows).filter(|(_, row)| !row.trim_matches(';').is_empty()).map(|(line, _)| line).collect();
        proptest::prop_assert_eq!(lines, expected, "{}", text);
    }

    #[test]
    fn any_text_is_read_without_panic(text in "[0-9a-zA-Z,;|\"#\n\r\t .H7-]{0,200}") {
        let _imported = read(text.as_bytes());
    }

    #[test]
    fn any_bytes_are_read_without_panic(bytes in proptest::collection::vec(proptest::prelude::any::<u8>(), 0..300)) {
        let _imported = read(&bytes);
    }

    /// Separator, decimal sign, header and line ends do not change a verdict.
    #[test]
    fn the_dialect_does_not_matter(nm in 24_900_000_i64..25_100_000, separator in 0_usize..3, comma: bool, header: bool, crlf: bool) {
        let measured = Length::from_nanometres(nm).unwrap();
        let written = if comma { measured.to_string().replace('.', ",") } else { measured.to_string() };
        let separator = [";", "\t", "|"][separator];
        let end = if crlf { "\r\n" } else { "\n" };
        let row = ["b1", "25 H7", &written].join(separator) + end;
        let text = if header { ["id", "fit", "actual"].join(separator) + end + &row } else { row };
        let imported = read(text.as_bytes());
        let expected = if nm < 25_000_000 { Status::Rework } else if nm <= 25_021_000 { Status::Good } else { Status::Scrap };
        proptest::prop_assert_eq!(imported.records[0].verdict.status(), expected);
        proptest::prop_assert_eq!(imported.records[0].measurement.diameter, measured);
    }
}

#[test]
fn a_value_that_a_file_calls_simulated_stays_simulated() {
    let imported = read(b"id;callout;measured;simulated\nA;25 H7;25.012;true\nB;25 H7;25.012;false\nC;25 H7;25.012;\n");
    let simulated: Vec<_> = imported.records.iter().map(|record| record.measurement.origin.is_simulated()).collect();
    assert_eq!((simulated, imported.warnings.len()), (vec![true, false, false], 0));
    check(
        "id;callout;measured;simulated\nA;25 H7;25.012;perhaps\n",
        &["! line 2, column 4: simulated: perhaps is neither true nor false <perhaps>"],
    );
}

#[test]
fn a_status_that_the_file_has_and_that_is_another_one_is_told() {
    check(
        "id;callout;measured;Ergebnis\nA;25 H7;25.012;n.i.O.\nB;25 H7;25.012;i.O.\nC;25 H7;25.03;OK\nD;25 H7;24.99;FAIL\nE;25 H7;25.01;?\n",
        &[
            "2 A: 25 H7 is 25.012 GOOD",
            "3 B: 25 H7 is 25.012 GOOD",
            "4 C: 25 H7 is 25.03 SCRAP",
            "5 D: 25 H7 is 24.99 REWORK",
            "6 E: 25 H7 is 25.01 GOOD",
            "? line 2: the file says n.i.O., but the limits say GOOD",
            "? line 4: the file says OK, but the limits say SCRAP",
            "? line 6: the file says ?, which is not a known status: the limits say GOOD",
        ],
    );
    check(
        "id;callout;measured;status\nA;25 H7;25.012;SCRAP\nB;25 H7;25.03;SCRAP\n",
        &[
            "2 A: 25 H7 is 25.012 GOOD",
            "3 B: 25 H7 is 25.03 SCRAP",
            "? line 2: the file says SCRAP, but the limits say GOOD",
        ],
    );
}
