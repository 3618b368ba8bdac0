//! AQDEF: what files of Q-DAS say of their values, and what is said of files that are damaged.

use std::io::Cursor;
use std::path::{Path, PathBuf};

use fitcheck::exchange::{FORMATS, ImportInputs, Item, Labels, Quantity, import_from};
use fitcheck::tolerance::Sources;

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/aqdef")
}

fn bytes(name: &str) -> Vec<u8> {
    std::fs::read(folder().join(name)).unwrap()
}

/// Everything that is read from a file with this one beside it, where there is one.
fn items(name: &str, bytes: &[u8], beside: Option<(&str, &[u8])>) -> Vec<Item> {
    let mut items = Vec::new();
    let sources = Sources::default();
    let now = jiff::civil::date(2000, 1, 1).at(0, 0, 0, 0);
    let beside = |ending: &str| beside.filter(|(known, _)| *known == ending).map(|(_, bytes)| bytes.to_vec());
    let given = ImportInputs { beside: &beside, ..ImportInputs::new(&sources, now) };
    import_from(name, &mut Cursor::new(bytes), given, &mut |item| items.push(item));
    items
}

/// A line for everything: `41 BORE1 25 H7 25.0123 GOOD`, `8 D1 7.1: not judged …`, `4: error`, `1? warning`.
fn said(items: &[Item]) -> Vec<String> {
    let line = |item: &Item| match item {
        Item::Record { line, record, .. } => {
            let size = record.verdict.size.status.word();
            format!("{line} {} {} {size}", record.id, record.measurement.diameter)
        }
        Item::Unjudged(row) => {
            let measured = row.measured.map_or("-".to_owned(), |measured| measured.to_string());
            format!("{} {} {measured}: {}", row.line, row.id, row.why)
        }
        Item::Error(error) => format!("{}: {}", error.place.line.unwrap(), error.what.kind),
        Item::Warning(warning) => format!("{}? {}", warning.place.line.unwrap(), warning.what.kind),
        Item::Contacts(_) => "contacts".to_owned(),
    };
    items.iter().map(line).collect()
}

/// The same without the warnings.
fn values(items: &[Item]) -> Vec<String> {
    said(items).into_iter().filter(|line| !line.split(' ').next().unwrap().ends_with('?')).collect()
}

const HEAD: &str = "K0100 1\nK1001/1 P\nK2001/1 7\nK2002/1 D\nK2009/1 202\nK2101/1 25\nK2103/1 H\nK2104/1 7\nK2110/1 25\nK2111/1 25.021\nK2142/1 mm\n";

/// What a bore 25 H7 with these lines behind its declaration gives.
#[track_caller]
fn check(lines: &str, expected: &[&str]) {
    check_whole(&format!("{HEAD}{lines}"), expected);
}

#[track_caller]
fn check_whole(text: &str, expected: &[&str]) {
    assert_eq!(said(&items("a.dfq", text.as_bytes(), None)), expected, "{text}");
}

const SAMPLE: [&str; 6] = [
    "BORE1 25 H7 25.0123 GOOD",
    "SHAFT1 25 g6 24.9871 GOOD",
    "BORE1 25 H7 25.0118 GOOD",
    "SHAFT1 25 g6 24.9866 GOOD",
    "BORE1 25 H7 25.0131 GOOD",
    "SHAFT1 25 g6 24.9874 GOOD",
];

#[test]
fn both_notations_have_the_values_of_the_samples() {
    let with_keys: Vec<String> =
        [41, 48, 55, 62].iter().zip(SAMPLE).map(|(line, value)| format!("{line} {value}")).collect();
    assert_eq!(values(&items("keys.dfq", &bytes("keys.dfq"), None)), with_keys);
    let without: Vec<String> =
        [41, 41, 42, 42, 43, 43].iter().zip(SAMPLE).map(|(line, value)| format!("{line} {value}")).collect();
    assert_eq!(values(&items("a.dfq", &bytes("without_keys.dfq"), None)), without);
}

#[test]
fn a_record_has_the_callout_the_time_and_what_else_is_said() {
    for name in ["keys.dfq", "without_keys.dfq"] {
        let items = items(name, &bytes(name), None);
        let shaft = items.iter().find_map(|item| match item {
            Item::Record { record, labels, .. } if record.id.starts_with("SHAFT") => Some((record, labels)),
            _ => None,
        });
        let (record, labels) = shaft.unwrap();
        assert_eq!(record.callout.unwrap().to_string(), "25 g6");
        assert_eq!(record.time, jiff::civil::date(2025, 1, 15).at(10, 21, 33, 0));
        assert_eq!(
            (record.limits.minimum().to_string(), record.limits.maximum().to_string()),
            ("24.98".into(), "24.993".into())
        );
        let expected = Labels {
            number: "2".into(),
            part: "PN-4711".into(),
            who: "17".into(),
            batch: "B0815".into(),
            machine: "12".into(),
            gauge: "460".into(),
            time: Some(record.time),
            quantity: Some(Quantity::Diameter),
            ..Labels::default()
        };
        assert_eq!(*labels, expected);
        let told: Vec<String> = said(&items).into_iter().filter(|line| line.contains('?')).collect();
        assert!(
            told[0].ends_with(
                "the file states an expanded uncertainty of 0.0024 mm: no rule uses it, so give --u instead"
            )
        );
        let nest = if name == "keys.dfq" { "" } else { "K0007, " };
        assert_eq!(told.last().unwrap(), &format!("1? entries skipped: {nest}K1041, K1053, K1081"));
    }
}

/// Line, number of the characteristic and value in the file of three parts.
const THREE_PARTS: [(usize, usize, &str); 26] = [
    (11, 1, "1.6"),
    (13, 1, "1.7"),
    (15, 1, "1.8"),
    (17, 1, "1.9"),
    (19, 1, "2"),
    (21, 1, "2.1"),
    (23, 1, "2.2"),
    (25, 1, "2.3"),
    (36, 1, "1.6"),
    (43, 2, "3.1"),
    (50, 3, "4.6"),
    (61, 1, "1.6"),
    (63, 1, "1.7"),
    (65, 1, "1.8"),
    (72, 2, "3.1"),
    (74, 2, "3.2"),
    (76, 2, "3.3"),
    (83, 3, "4.6"),
    (85, 3, "4.7"),
    (87, 3, "4.8"),
    (94, 4, "6.1"),
    (96, 4, "6.2"),
    (98, 4, "6.3"),
    (105, 5, "7.6"),
    (107, 5, "7.7"),
    (109, 5, "7.8"),
];

#[test]
fn files_of_another_tool_have_the_values_that_they_hold() {
    let plan = |count| format!("1: {count} but no values: this is a plan, not measurements");
    // The limits of the first are 1 to 2 mm; those of the others are so wide that they are doubted.
    let within = |line: usize, code: usize, value: &str| match code {
        1 if "2" < value => format!("{line} <characteristic_code_{code}> {value} OUT OF LIMITS"),
        1 => format!("{line} <characteristic_code_{code}> {value} GOOD"),
        _ => {
            let (nominal, half, most) =
                [("3", "1", "1.4"), ("4.5", "1.5", "1.8"), ("6", "2", "1.8"), ("7.5", "2.5", "2.2")][code - 2];
            let zone = code;
            format!(
                "{line}: a zone of {zone} mm is out of all proportion to {nominal} mm, whose IT 18 is {most} mm: if the \
                 deviations are in micrometres, write {nominal} ±{}",
                half.parse::<f64>().unwrap() / 1000.0
            )
        }
    };
    let none = |line: usize, id: &str, value: &str| format!("{line} {id} {value}: not judged: no limits given");
    let code = |line, code: usize| none(line, &format!("<characteristic_code_{code}>"), "0.1");
    let three_parts: Vec<String> =
        THREE_PARTS.iter().map(|&(line, number, value)| within(line, number, value)).collect();
    let expected = [
        (
            "attributiveDfq_attributiveCharacteristic_and_errorLogSheet",
            vec![
                "8 <characteristic_code_1> -: not measured: a count of nonconforming parts (K2004 is 1)".to_owned(),
                "14 <characteristic_code_2> -: not measured: an error log sheet (K2004 is 6)".to_owned(),
            ],
        ),
        ("basicDfq_singlePart_noCharacteristics", vec!["1: neither characteristics nor values".to_owned()]),
        ("basicDfq_singlePart_singleCharacteristic_noValues", vec![plan("1 characteristic")]),
        (
            "basicDfq_singlePart_threeCharacteristics",
            [
                (11, 1, "1.6"),
                (13, 1, "1.7"),
                (15, 1, "1.8"),
                (22, 2, "3.1"),
                (24, 2, "3.2"),
                (26, 2, "3.3"),
                (33, 3, "4.6"),
                (35, 3, "4.7"),
                (37, 3, "4.8"),
            ]
            .iter()
            .map(|&(line, number, value)| within(line, number, value))
            .collect(),
        ),
        ("basicDfq_threeParts_differentNumberOfCharacteristics", three_parts),
        ("characteristicHierarchy_characteristicOrder", vec![plan("6 characteristics")]),
        ("characteristicHierarchy_singlePart_singleGroup_twoCharacteristics", vec![code(7, 2), code(11, 3)]),
        ("characteristicHierarchy_singlePart_threeCharacteristics", vec![code(7, 1), code(11, 2), code(15, 3)]),
        (
            "characteristicHierarchy_singlePart_twoChildCharacteristics_twoGroups",
            vec![code(7, 1), code(11, 2), code(15, 4), code(19, 6)],
        ),
        (
            "characteristicHierarchy_twoParts_singleGroup_twoCharacteristics",
            vec![code(7, 2), code(11, 3), code(21, 6), code(25, 7)],
        ),
        ("multipleParts", vec![none(4, "characteristic 1", "7.1"), none(8, "characteristic 2", "7.2")]),
    ];
    assert_eq!(std::fs::read_dir(folder().join("diribet")).unwrap().count(), expected.len() + 1);
    for (name, expected) in expected {
        assert_eq!(values(&items("a.dfq", &bytes(&format!("diribet/{name}.dfq")), None)), expected, "{name}");
    }
}

#[test]
fn characteristics_belong_to_the_part_named_before_them() {
    let items = items("a.dfq", &bytes("diribet/basicDfq_threeParts_differentNumberOfCharacteristics.dfq"), None);
    let parts: Vec<&str> = items
        .iter()
        .filter_map(|item| match item {
            Item::Record { labels, .. } => Some(labels.part.as_str()),
            _ => None,
        })
        .collect();
    // Of the second and third parts most characteristics are refused for their wide zones.
    assert_eq!(parts, [vec!["<part_number_1>"; 8], vec!["<part_number_2>"; 1], vec!["<part_number_3>"; 3]].concat());
}

#[test]
fn a_file_in_two_halves_is_read_from_either() {
    let (dfd, dfx) = (bytes("two_files.dfd"), bytes("two_files.dfx"));
    let expected: Vec<String> =
        [1, 1, 2, 2, 3, 3].iter().zip(SAMPLE).map(|(line, value)| format!("{line} {value}")).collect();
    let by_values = items("two.dfx", &dfx, Some(("dfd", &dfd)));
    assert_eq!(values(&by_values), expected);
    assert_eq!(said(&by_values)[0], "1? the characteristics come from two.dfd beside this file");
    let by_characteristics = items("two.dfd", &dfd, Some(("dfx", &dfx)));
    assert_eq!(values(&by_characteristics), expected);
    assert_eq!(
        said(&by_characteristics)[0],
        "1? the values come from two.dfx beside this file, and line numbers refer to it"
    );
}

#[test]
fn half_of_a_file_says_what_is_missing() {
    let alone = items("two.dfx", &bytes("two_files.dfx"), None);
    assert_eq!(said(&alone), ["1: values without characteristics: two.dfd is missing beside this file"]);
    let other = items("two.dfx", &bytes("two_files.dfx"), Some(("dfd", b"x")));
    assert_eq!(
        values(&other),
        [
            "1: two.dfd, line 1: expected a key and a text such as K0001/1 25.012, or a line of values",
            "1: values without characteristics: two.dfd is missing beside this file"
        ]
    );
    let plan = items("two.dfd", &bytes("two_files.dfd"), None);
    assert_eq!(
        values(&plan),
        [
            "1: 2 characteristics but no values, and no two.dfx of up to 64 MiB beside this file: this is a plan, not measurements; give two.dfx itself if it is larger"
        ]
    );
    let empty = items("two.dfd", &bytes("two_files.dfd"), Some(("dfx", b"\n")));
    assert_eq!(values(&empty), ["1: 2 characteristics but no values: this is a plan, not measurements"]);
    // A file with both is not half of one.
    let whole = items(
        "keys.dfq",
        &bytes("diribet/characteristicHierarchy_characteristicOrder.dfq"),
        Some(("dfx", &bytes("two_files.dfx"))),
    );
    assert_eq!(values(&whole), ["1: 6 characteristics but no values: this is a plan, not measurements"]);
}

#[test]
fn faults_of_the_other_half_are_told_with_its_lines() {
    let dfd = b"K0100 2\nK2001/1 7\nK2110/1 2x\nK0001/1 5\n";
    let read = items("a.dfx", b"K0001/1 25.01\n", Some(("dfd", dfd)));
    assert_eq!(
        said(&read),
        [
            "1? the characteristics come from a.dfd beside this file",
            "1? a.dfd has 1 line of values, which is not read",
            "1: a.dfd, line 3: K2110: 2x is not a number",
            "1 7 25.01: not judged: line 3 of its declaration cannot be used",
            "1? a.dfd, line 1: K0100 announces 2 characteristics, found 1: the file may be cut off",
        ]
    );
}

#[test]
fn keys_for_all_hold_where_none_of_their_own_is() {
    check_whole(
        "K0100 2\nK1001/0 P\nK2142/0 inch\nK2001/1 1\nK2101/1 1\nK2110/1 0.999\nK2111/1 1.001\nK2115/0 1.001\nK2001/2 2\nK2142/2 µm\nK2110/2 9990\nK2111/2 10010\nK2101/2 10000\nK2114/2 9990\nK2115/2\nK0001/1 1.0005\nK0001/2 10011\nK0004/0 1.2.24/3:04:05\nK0014/0 S1\nK0001/1 1.002\nK0014/0 S2\n",
        &[
            "16 1 25.4127 GOOD",
            "17 2 10.011 REWORK",
            "20? no date and time here: the time of import is used",
            "20 1 25.4508 SCRAP",
        ],
    );
}

#[test]
fn values_have_their_time_and_serial_number() {
    let text = format!(
        "{HEAD}K0001/1 25.01\nK0004/0 1.2.24/3:04:05\nK0014/0 S1\nK0001/1 25.011\nK0014/0 S2\nK0001/1/3 25.012\nK0014/1/3 S3\nK0014/1/1 late\nK0014/0/3 twice\n"
    );
    let read = items("a.dfq", text.as_bytes(), None);
    let serials: Vec<(&str, String)> = read
        .iter()
        .filter_map(|item| match item {
            Item::Record { record, labels, .. } => Some((labels.serial.as_str(), record.time.to_string())),
            _ => None,
        })
        .collect();
    let now = "2000-01-01T00:00:00".to_owned();
    assert_eq!(serials, [("S1", "2024-02-01T03:04:05".to_owned()), ("S2", now.clone()), ("S3", now)]);
    assert!(
        said(&read).contains(&"19? K0014 does not belong to a value read just before it: it is skipped".to_owned())
    );
}

#[test]
fn an_entry_of_all_values_may_come_first() {
    let text = format!("{HEAD}K0004/0 1.2.24/3:04:05\nK0001/1 25.01\nK0004/0 1.2.24/3:04:06\nK0001/1 25.011\n");
    let times: Vec<i8> = items("a.dfq", text.as_bytes(), None)
        .iter()
        .filter_map(|item| match item {
            Item::Record { record, .. } => Some(record.time.second()),
            _ => None,
        })
        .collect();
    assert_eq!(times, [5, 6]);
}

#[test]
fn dates_in_orders_that_are_not_known_are_told() {
    check(
        "K0001/1 25.01\nK0004/1 2018/05/20/18:05:10\nK0001/1 25.01\nK0004/1 2018-05-09T10:05:59+02:00\n",
        &[
            "12? 2018/05/20/18:05:10 is not a date and time: the time of import is used",
            "12 D 25.01 GOOD",
            "14? 2018-05-09T10:05:59+02:00 is stored as local time without its offset from UTC",
            "14 D 25.01 GOOD",
        ],
    );
}

#[test]
fn missing_and_marked_values_are_told() {
    check(
        "K0001/1 25.01\nK0002/1 255\nK0001/1 25.02\nK0002/1 256\nK0001/1\nK0001/1 25.01\nK0002/1 0\nK0001/1 25.01\nK0002/1 3\n\u{14}255\n25.03\u{14}255\n25.03\n",
        &[
            "17 D 25.01 GOOD",
            "19 D 25.01: not judged: marked with 3 (K0002); only 0 is known to mark a valid value",
            "23 D 25.03 SCRAP",
            "12? 5 values are empty or marked as missing (K0002 is 255 or 256), from this line on: they are skipped",
        ],
    );
}

#[test]
fn numbers_have_exponents_and_figures_beyond_the_nanometre() {
    check(
        "K0001/1 2.50130000000000E+0001\nK0001/1 25.0100000000002\nK0001/1 25.0,1\nK0001/1 0\n",
        &[
            "12 D 25.013 GOOD",
            "13 D 25.01 GOOD",
            "14: measured: 25.0,1 is ambiguous: write one decimal sign and no thousands separator",
            "15: measured: a diameter of 0 is not above 0",
            "13? 1 measured value has digits beyond the nanometre, from this line on: it is rounded to the nearest nanometre",
        ],
    );
}

#[test]
fn a_line_of_values_follows_the_order_of_the_characteristics() {
    let two = "K0100 2\nK2002/1 a\nK2002/2 b\nK2142/0 mm\n";
    let no = "not judged: no limits given";
    check_whole(
        &format!(
            "{two}1.5\u{14}0\u{f}2.5\u{f}\n1.6\n1\u{f}2\u{f}3\nK0014/1 S\n1.7\u{14}\u{f}2.7\u{14}0\u{14}1.1.20/1:02:03\nK0053/2 x\n"
        ),
        &[
            &format!("5 a 1.5: {no}"),
            &format!("5 b 2.5: {no}"),
            "6? expected 2 values, found 1",
            &format!("6 a 1.6: {no}"),
            "7: value of characteristic 3, which is not declared before this line",
            &format!("7 a 1: {no}"),
            &format!("7 b 2: {no}"),
            &format!("9 a 1.7: {no}"),
            &format!("9 b 2.7: {no}"),
            "1? entries skipped: K0053",
        ],
    );
}

#[test]
fn counted_parts_and_error_logs_are_set_aside_in_both_notations() {
    let head = "K0100 2\nK2002/1 a\nK2004/1 0\nK2002/2 b\nK2004/2 1\nK2142/0 mm\n";
    check_whole(
        &format!(
            "{head}1\u{14}0\u{14}1.1.14/0:00:00\u{f}100\u{14}0\u{14}0\u{14}0\u{14}1.1.14/0:00:00\n1{}\n",
            "\u{14}0".repeat(10)
        ),
        &[
            "7 a 1: not judged: no limits given",
            "7 b -: not measured: a count of nonconforming parts (K2004 is 1)",
            "8: expected at most 10 fields in a value, found 11",
            "8? expected 2 values, found 1",
        ],
    );
    for (kind, said) in
        [("5", "an error log sheet (K2004 is 5)"), ("3", "an unknown kind of characteristic (K2004 is 3)")]
    {
        check(&format!("K2004/1 {kind}\nK0001/1 5\n"), &[&format!("13 D -: not measured: {said}")]);
    }
}

#[test]
fn other_quantities_than_a_diameter_are_named() {
    for (number, name) in
        [("102", "roundness"), ("109", "position"), ("117", "a coordinate"), ("5", "a quantity other than a diameter")]
    {
        let said = |line| format!("{line} D 0.01: {name} (K2009 is {number}): not a size of a hole or shaft");
        let text = HEAD.replace("K2009/1 202", &format!("K2009/1 {number}"));
        let told = |text: &str| values(&items("a.dfq", format!("{text}K0001/1 0.01\n").as_bytes(), None));
        // What is known to be a length is judged by the limits of the file.
        assert_eq!(told(&text), [if number == "5" { said(12) } else { "12 D 0.01 OUT OF LIMITS".to_owned() }]);
        let without = text.lines().filter(|line| !line.starts_with("K211")).collect::<Vec<_>>().join("\n") + "\n";
        assert_eq!(told(&without), [said(without.lines().count() + 1)]);
    }
    for (value, status) in [("0.02", "GOOD"), ("0.021", "OUT OF LIMITS")] {
        let flat = format!("K0100 1\nK2002/1 F\nK2009/1 102\nK2142/1 mm\nK2111/1 0.02\nK0001/1 {value}\n");
        assert_eq!(values(&items("a.dfq", flat.as_bytes(), None)), [format!("6 F {value} {status}")]);
    }
    check_whole(
        "K0100 1\nK2002/1 angle\nK2009/1 5\nK2142/1 °\nK0001/1 30\n",
        &["5 angle -: a quantity other than a diameter (K2009 is 5): not a size of a hole or shaft"],
    );
}

#[test]
fn units_are_known_or_refused() {
    let celsius = HEAD.replace("K2142/1 mm", "K2142/1 °C");
    check_whole(&format!("{celsius}K0001/1 30\n"), &["12: unknown unit °C: use mm, µm or inch"]);
    check_whole(
        "K0100 2\nK2002/1 a\nK2002/2 b\nK0001/1 30\nK0001/2 30\n",
        &[
            "2? no unit given: lengths without a unit are read as mm",
            "4 a 30: not judged: no limits given",
            "5 b 30: not judged: no limits given",
        ],
    );
    for (unit, value) in [("mm", "25.01"), ("µm", "25010"), ("um", "25010"), ("inch", "0.98465"), ("\"", "0.98465")] {
        let head = format!("K0100 1\nK2002/1 D\nK2101/1 25\nK2142/1 {unit}\nK0001/1 {value}\n");
        assert!(values(&items("a.dfq", head.as_bytes(), None))[0].starts_with("5 D 25.01"), "{unit}");
    }
}

/// What is said of a characteristic with these entries, whose value is 25.03 mm.
#[track_caller]
fn declared(entries: &str, expected: &[&str]) {
    let text = format!("K0100 1\nK2002/1 D\nK2142/1 mm\n{entries}K0001/1 25.03\n");
    let end = format!("{} ", text.lines().count());
    let told: Vec<String> = said(&items("a.dfq", text.as_bytes(), None))
        .into_iter()
        .map(|line| line.replace(&format!("{end}D"), "D"))
        .collect();
    assert_eq!(told, expected, "{entries}");
}

#[test]
fn limits_are_those_of_the_file_and_scrap_limits_tell_the_side() {
    let limits = "K2101/1 25\nK2110/1 25\nK2111/1 25.021\n";
    let unknown = "D 25.03 OUT OF LIMITS";
    declared(limits, &[unknown]);
    declared(&format!("{limits}K2115/1 25.021\n"), &["D 25.03 SCRAP"]);
    declared(&format!("{limits}K2114/1 25\n"), &["D 25.03 REWORK"]);
    declared(&format!("{limits}K2114/1 25\nK2115/1 25.021\n"), &[unknown]);
    declared(
        &format!("{limits}K2115/1 25.03\n"),
        &[
            "7? the scrap limit 25.03 differs from the limit: it is skipped, and a value beyond the limit on this side is scrap",
            "D 25.03 SCRAP",
        ],
    );
    declared(
        &format!("{limits}K2103/1 H\nK2104/1 7\nK2114/1 25\n"),
        &["9? the scrap limit is that of a shaft, but 25 H7 is not: the tolerance class applies", "D 25.03 SCRAP"],
    );
    declared("K2101/1 25\nK2103/1 H\nK2104/1 7\n", &["D 25.03 SCRAP"]);
    declared("K2101/1 25\nK2151/1 H7\n", &["D 25.03 SCRAP"]);
    // A tolerance may be a number instead of a class.
    declared(&format!("{limits}K2151/1 0.0210\nK2152/1 0.021\n"), &[unknown]);
    declared(
        &format!("{limits}K2151/1 0.030\n"),
        &["7? K2151 has a tolerance of 0.03 mm, but the limits give 0.021 mm: the limits apply", unknown],
    );
    declared("K2101/1 25\nK2112/1 0\nK2113/1 0.021\nK2115/1 25.021\n", &["D 25.03 SCRAP"]);
    declared(
        &format!("{limits}K2112/1 0\nK2113/1 0.022\nK2115/1 25.021\n"),
        &["8? nominal size and allowance give 25.022, but the limit is different: the limit applies", "D 25.03 SCRAP"],
    );
    declared("K2111/1 25.021\n", &["D 25.03: not judged: one of the two limits is missing"]);
    declared(
        "K2110/1 26\nK2111/1 25\nK2115/1 25\n",
        &["D 25.03: not judged: the lower limit 26 is above the upper limit 25"],
    );
}

#[test]
fn kinds_of_limits_are_kept_or_told() {
    let limits = "K2101/1 25\nK2110/1 25\nK2111/1 25.021\nK2115/1 25.021\n";
    declared(&format!("{limits}K2120/1 1\nK2121/1 2\n"), &["D 25.03 SCRAP"]);
    declared(
        &format!("{limits}K2120/1 0\n"),
        &[
            "5? K2110 is given, but K2120 or K2121 says that there is no such limit: it is skipped",
            "D 25.03: not judged: one of the two limits is missing",
        ],
    );
    declared(
        &format!("{limits}K2121/1 3\n"),
        &["6? 3 is not a known kind of limit (0, 1 or 2): it is read as a limit", "D 25.03 SCRAP"],
    );
}

#[test]
fn a_declaration_that_cannot_be_used_is_an_error_and_its_values_are_set_aside() {
    declared(
        "K2111/1 25,0x\n",
        &["4: K2111: 25,0x is not a number", "D 25.03: not judged: line 4 of its declaration cannot be used"],
    );
    declared(
        "K2009/1 two\n",
        &["4: K2009: two is not a whole number", "D 25.03: not judged: line 4 of its declaration cannot be used"],
    );
    declared(
        "K2111/1 25.0210000001\n",
        &[
            "4? 25.0210000001 has digits beyond the nanometre: it is rounded to the nearest nanometre",
            "D 25.03: not judged: one of the two limits is missing",
        ],
    );
}

#[test]
fn what_is_no_entry_is_an_error_of_its_line() {
    check(
        "nonsense\nK0001/9 5\nK0001/1 25.01\nK2001/1/1 5\nK5002/1 g\nK8010/1 x\nK0014/2 x\n",
        &[
            "12: expected a key and a text such as K0001/1 25.012, or a line of values",
            "13: value of characteristic 9, which is not declared before this line",
            "15: expected a key and a text such as K0001/1 25.012, or a line of values",
            "14 D 25.01 GOOD",
            "1? entries skipped: K5002, K8010",
        ],
    );
}

#[test]
fn joined_files_are_read_one_after_the_other() {
    let twice = [bytes("keys.dfq"), bytes("without_keys.dfq")].concat();
    assert_eq!(values(&items("a.dfq", &twice, None)).len(), 10);
}

#[test]
fn files_are_told_by_content() {
    let named = |name: &str, bytes: &[u8]| {
        FORMATS.iter().find(|format| format.recognises(bytes, name)).map(|format| format.name)
    };
    for name in ["a.dfq", "a.txt", "a.csv", "TCHPR421.TXT"] {
        assert_eq!(named(name, &bytes("keys.dfq")), Some("aqdef"), "{name}");
        assert_eq!(named(name, &bytes("two_files.dfx")), Some("aqdef"), "{name}");
        assert_eq!(named(name, b"K0001/1 5\n"), Some("aqdef"), "{name}");
    }
    assert_eq!(named("a.dfx", b"25.01\n25.02\n"), Some("aqdef"));
    for text in [
        "25.01\n25.02\n",
        "K0001;25 H7;25.01\n",
        "K1001 bore;25 H7;25.01\n",
        "K0001\t25 H7\t25.01\n",
        "id\u{14};25 H7;25.01\n",
    ] {
        assert_ne!(named("a.dfq", text.as_bytes()), Some("aqdef"), "{text}");
    }
}

#[test]
fn every_encoding_and_line_end_gives_the_same() {
    let text = format!("{HEAD}K2002/1 Ø µ\nK0001/1 25.01\n25.011\u{14}0\n");
    let expected = ["13 Ø µ 25.01 GOOD", "14 Ø µ 25.011 GOOD"];
    let utf16 = |bytes: fn(u16) -> [u8; 2]| {
        std::iter::once(0xfeff).chain(text.encode_utf16()).flat_map(bytes).collect::<Vec<u8>>()
    };
    let latin = text.chars().map(|sign| u8::try_from(u32::from(sign)).unwrap()).collect();
    let files = [
        text.clone().into_bytes(),
        format!("\u{feff}{text}").into_bytes(),
        latin,
        utf16(u16::to_le_bytes),
        utf16(u16::to_be_bytes),
        text.replace('\n', "\r\n").into_bytes(),
        text.replace('\n', "\r").into_bytes(),
        format!("{text}\u{1a}").into_bytes(),
    ];
    for file in files {
        assert_eq!(values(&items("a.txt", &file, None)), expected, "{}", String::from_utf8_lossy(&file));
    }
}

#[test]
fn a_file_cut_anywhere_says_so_or_has_only_values_of_the_whole() {
    for name in ["keys.dfq", "without_keys.dfq"] {
        let whole = bytes(name);
        let all = values(&items("a.dfq", &whole, None));
        let declared = whole.windows(5).position(|at| at == b"K0001" || at == b"25.01").unwrap();
        for end in 0..whole.len() {
            let read = items("a.dfq", &whole[..end], None);
            let (found, told) = (values(&read), said(&read));
            assert!(!told.is_empty());
            if end < declared {
                assert!(found.iter().all(|line| !line.contains("GOOD")), "{name} {end}: {found:?}");
                continue;
            }
            let is_doubted =
                told.iter().any(|line| line.contains("may be cut off") || line.contains("expected 2 values"));
            for line in &found {
                let has_verdict = ["GOOD", "REWORK", "SCRAP", "not judged"].iter().any(|word| line.contains(word));
                assert!(is_doubted || !has_verdict || all.contains(line), "{name} {end}: {told:?}");
            }
        }
    }
}

#[test]
fn fewer_characteristics_than_announced_are_told() {
    check_whole(
        "K0100 2\nK2002/1 D\nK2142/1 mm\nK0001/1 5\n",
        &[
            "4 D 5: not judged: no limits given",
            "1? K0100 announces 2 characteristics, found 1: the file may be cut off",
        ],
    );
    check_whole(
        "K0100 x\nK2002/1 D\nK2142/1 mm\nK0001/1 5\n",
        &["1: K0100: x is not a whole number", "4 D 5: not judged: no limits given"],
    );
}

#[test]
fn a_line_of_any_length_and_any_number_of_characteristics_is_bounded() {
    let long = format!("{HEAD}K0001/1 {}\nK0001/1 25.01\n", "1".repeat(3 << 20));
    assert_eq!(
        values(&items("a.dfq", long.as_bytes(), None)),
        ["12: the row is longer than 1024 KiB", "13 D 25.01 GOOD"]
    );
    let many: Vec<String> = (0..300_000).map(|number| format!("K2002/{number} D\n")).collect();
    let many = format!("K0100 1\n{}", many.concat());
    assert_eq!(values(&items("a.dfq", many.as_bytes(), None)), ["1: the characteristics take more than 64 MiB"]);
}

#[test]
fn values_of_a_million_parts_are_handed_out_one_by_one() {
    let mut text = HEAD.to_owned();
    for _ in 0..20_000 {
        text.push_str("25.0123\u{14}0\n");
    }
    let mut count = 0;
    let sources = Sources::default();
    let now = jiff::civil::date(2000, 1, 1).at(0, 0, 0, 0);
    let given = ImportInputs::new(&sources, now);
    import_from("a.dfq", &mut Cursor::new(text.as_bytes()), given, &mut |item| {
        count += usize::from(matches!(item, Item::Record { .. }));
    });
    assert_eq!(count, 20_000);
}

#[test]
fn the_other_half_is_found_in_small_and_in_capital_letters() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name);
    std::fs::copy(self::folder().join("two_files.dfx"), path("A.DFX")).unwrap();
    std::fs::copy(self::folder().join("two_files.dfd"), path("b.dfd")).unwrap();
    assert_eq!(fitcheck::files::beside(&path("A.DFD"), "dfx"), Some(bytes("two_files.dfx")));
    assert_eq!(fitcheck::files::beside(&path("b.dfx"), "dfd"), Some(bytes("two_files.dfd")));
    assert_eq!(fitcheck::files::beside(&path("b.dfd"), "dfx"), None);
}

#[test]
fn a_value_before_bytes_of_zero_is_refused() {
    let zeros = "\0".repeat(100);
    let refused = "the line has bytes of value 0, so the file was not written completely: the line is skipped";
    for tail in [format!("K0001/1 25.0{zeros}"), format!("25.0{zeros}"), "K0001/1 25.0\x00003\n".to_owned()] {
        check(&tail, &[&format!("12: {refused}")]);
    }
    check(
        &format!("K0001/1 25.01\n{zeros}"),
        &[
            "13? the file has bytes of value 0 here, so it was not written completely: values may be missing",
            "12 D 25.01 GOOD",
        ],
    );
}

#[test]
fn a_last_value_without_a_line_end_is_refused_unless_its_decimals_say_that_it_is_whole() {
    let cut_off = |line: usize, given: &str| {
        format!(
            "{line}: the file ends here without a line end, so {given} may be cut off: it is skipped; if it is complete, add a line end"
        )
    };
    for text in ["K0001/1 25.0", "25.0", "K0001/1 2.501E+1", "25"] {
        check(text, &[&cut_off(12, text.rsplit(' ').next().unwrap())]);
    }
    check("K0001/1 25.012\nK0001/1 25.0", &["12 D 25.012 GOOD", &cut_off(13, "25.0")]);
    check("K0001/1 25.012\nK0001/1 25.013", &["12 D 25.012 GOOD", "13 D 25.013 GOOD"]);
    let with_decimals = |text: &str| format!("{HEAD}K2022/1 4\n{text}");
    check_whole(&with_decimals("K0001/1 25.0123"), &["13 D 25.0123 GOOD"]);
    check_whole(&with_decimals("K0001/1 25.012"), &[&cut_off(13, "25.012")]);
    // 255 would take the value out.
    check("K0001/1 25.01\nK0002/1 2", &[&cut_off(12, "2")]);
    check("K0001/1 25.01\nK0002/1 ", &[&cut_off(12, "")]);
    check("25.01\u{14}0", &["12 D 25.01 GOOD"]);
    check("25.01\u{14}", &[&cut_off(12, "25.01")]);
}

#[test]
fn a_value_of_all_characteristics_is_refused() {
    let refused = "K0001 with number 0 would be the value of every characteristic: it is skipped";
    check("K0001/0 25.05\nK0001/1 25.01\n", &[&format!("12: {refused}"), "13 D 25.01 GOOD"]);
}

#[test]
fn an_attribute_behind_a_line_of_values_takes_the_value_out() {
    let missing = "12? 1 value is empty or marked as missing (K0002 is 255 or 256), from this line on: it is skipped";
    let none = "1: 1 characteristic but no values: this is a plan, not measurements";
    for line in ["25.01", "25.01\u{14}0", "K0001/1 25.01\nK0002/1 0"] {
        check(&format!("{line}\nK0002/1 255\n"), &[missing, none]);
    }
    // Where the attribute comes first, the next one is that of the next value.
    let said =
        said(&items("a.dfq", format!("{HEAD}K0002/1 0\nK0001/1 25.01\nK0002/1 255\nK0001/1 25.02\n").as_bytes(), None));
    assert_eq!(said[0], "12 D 25.01 GOOD");
    assert_eq!(said.len(), 2);
}

#[test]
fn an_attribute_of_all_values_between_two_rows_leaves_neither_good() {
    let said = said(&items(
        "a.dfq",
        format!("{HEAD}K0001/1 25.01\nK0002/0 255\nK0001/1 25.02\nK0001/1 25.011\n").as_bytes(),
        None,
    ));
    assert_eq!(
        said,
        [
            "14: K0002/0 255 is between this row and the one before it and may apply to either: the value is skipped",
            "15 D 25.011 GOOD",
            "12? 1 value is empty or marked as missing (K0002 is 255 or 256), from this line on: it is skipped",
        ]
    );
    // Where each row has its own, it is that of the row.
    check(
        "K0001/1 25.01\nK0002/0 3\nK0001/1 25.012\nK0002/0 0\n",
        &["12 D 25.01: not judged: marked with 3 (K0002); only 0 is known to mark a valid value", "14 D 25.012 GOOD"],
    );
}

#[test]
fn a_limit_that_is_given_twice_judges_nothing() {
    let said = said(&items("a.dfq", format!("{HEAD}K2111/1 25.052\nK0001/1 25.03\n").as_bytes(), None));
    assert_eq!(
        said[0],
        "12: K2111 is given twice with different texts, before with 25.021: values of this characteristic are not judged"
    );
    assert!(said.iter().all(|line| !line.contains("GOOD") && !line.contains("SCRAP")), "{said:?}");
    // The same text twice contradicts nothing, and the words of a name judge nothing.
    check("K2111/1 25.021\nK0001/1 25.01\n", &["13 D 25.01 GOOD"]);
}

#[test]
fn a_width_of_the_zone_beside_the_limits_is_told_at_most_once_a_file() {
    let bytes = std::fs::read(Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/aqdef/width.dfq")).unwrap();
    let told = said(&items("width.dfq", &bytes, None));
    let rows = values(&items("width.dfq", &bytes, None));
    assert_eq!(rows, ["21 4A Gauss 3.220291 GOOD", "22 4A Gauss 3.260195 OUT OF LIMITS"]);
    assert!(!told.iter().any(|line| line.contains("class") || line.contains("2152")), "{told:?}");
}

#[test]
fn a_unit_may_be_the_centimetre() {
    let text =
        "K0100 1\nK2002/1 D\nK2142/1 cm\nK2101/1 2.5\nK2110/1 2.5\nK2111/1 2.5021\nK0001/1 2.50120000000000E+0000\n";
    let records: Vec<String> = items("a.dfq", text.as_bytes(), None)
        .iter()
        .filter_map(|item| match item {
            Item::Record { record, .. } => Some(format!("{} {}", record.measurement.diameter, record.limits.maximum())),
            _ => None,
        })
        .collect();
    assert_eq!(records, ["25.012 25.021"]);
}
