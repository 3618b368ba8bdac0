//! Tables of characteristics of CALYPSO, and what is said of damaged ones.

use std::path::Path;

use fitcheck::exchange::{FORMATS, Item, import_each};
use fitcheck::tolerance::Sources;

fn sample() -> Vec<u8> {
    std::fs::read(Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/calypso/plate_chr.txt")).unwrap()
}

fn items(bytes: &[u8]) -> Vec<Item> {
    let mut items = Vec::new();
    let now = jiff::civil::date(2000, 1, 1).at(0, 0, 0, 0);
    import_each("plate_chr.txt", bytes, &Sources::default(), now, &mut |item| items.push(item));
    items
}

/// `4 BORE1_D 25.0123: why`, `4.6: error`, `1? warning`.
fn said(bytes: &[u8]) -> Vec<String> {
    let line = |item: &Item| match item {
        Item::Record { line, record, .. } => format!("{line} {} {}", record.id, record.verdict.size.status.word()),
        Item::Unjudged(row) => {
            let why = row.why.to_string();
            format!("{} {} {}: {why}", row.line, row.id, row.measured.unwrap())
        }
        Item::Error(error) => match error.place.column {
            Some(column) => format!("{}.{column}: {}", error.place.line.unwrap(), error.what.kind),
            None => format!("{}: {}", error.place.line.unwrap(), error.what.kind),
        },
        Item::Warning(warning) => format!("{}? {}", warning.place.line.unwrap(), warning.what.kind),
        Item::Contacts(_) => "contacts".to_owned(),
    };
    items(bytes).iter().map(line).collect()
}

const HEADER: &str = "id\ttype\tidsymbol\tactual\tnominal\tuppertol\tlowertol\tdeviation\texceed\tunit\t\n";

/// What these rows below the header give, with the end of a table below them.
#[track_caller]
fn check(rows: &str, expected: &[&str]) {
    assert_eq!(said(format!("{HEADER}{rows}END\n").as_bytes()), expected, "{rows}");
}

const PLATE: [&str; 6] = [
    "2 BORE1_X GOOD",
    "3 BORE1_Y GOOD",
    "4 BORE1_D GOOD",
    "5 BORE2_D OUT OF LIMITS",
    "6 PIN1_D GOOD",
    "1? columns skipped: warningLimitCF, featureid, featuresigma, comment, link, linkmode, mmc, useruppertol, …",
];

#[test]
fn the_sample_has_its_values_places_and_parts() {
    assert_eq!(said(&sample()), PLATE);
    let rows = items(&sample());
    let Item::Record { labels, .. } = &rows[3] else { panic!("{:?}", rows[3]) };
    let place = labels.place.map(|length| length.unwrap().to_string());
    assert_eq!(place, ["90", "50", "-5"]);
    assert_eq!((labels.part.as_str(), labels.serial.as_str()), ("PN-4711-PLATE", "1"));
}

#[test]
fn every_encoding_and_line_end_gives_the_same() {
    let text = String::from_utf8(sample()).unwrap().replace("BORE1_X", "BOREØ_X");
    let expected: Vec<String> = PLATE.iter().map(|line| line.replace("BORE1_X", "BOREØ_X")).collect();
    let utf16 = |bytes: fn(u16) -> [u8; 2]| {
        std::iter::once(0xfeff).chain(text.encode_utf16()).flat_map(bytes).collect::<Vec<u8>>()
    };
    let files = [
        text.clone().into_bytes(),
        format!("\u{feff}{text}").into_bytes(),
        text.chars().map(|sign| u8::try_from(u32::from(sign)).unwrap()).collect(),
        utf16(u16::to_le_bytes),
        utf16(u16::to_be_bytes),
        text.replace("\r\n", "\n").into_bytes(),
        text.replace("\r\n", "\r").into_bytes(),
    ];
    for file in files {
        assert_eq!(said(&file), expected, "{}", String::from_utf8_lossy(&file));
    }
}

#[test]
fn a_diameter_is_told_by_either_column_and_other_columns_are_found_by_name() {
    for (short, word) in [("D1", "diameter"), ("diameter", "D1"), ("Diameter", "")] {
        check(
            &format!("a\t{short}\t{word}\t25.01\t25\t0.021\t0\n"),
            &["2? no unit given: lengths without a unit are read as mm", "2 a GOOD"],
        );
    }
    check(
        "a\tR1\t\t25.01\n",
        &["2? no unit given: lengths without a unit are read as mm", "2 a 25.01: R1: not a size of a hole or shaft"],
    );
    let turned = "unit\tLowerTol\tuppertol\tnominal\tactual\tidsymbol\tid\nmm\t0\t0,021\t25\t25,01\tdiameter\ta\nEND\n";
    assert_eq!(said(turned.as_bytes()), ["2 a GOOD"]);
}

#[test]
fn units_are_known_or_refused() {
    check("a\t\tdiameter\t1\t1\t0.001\t0\t\t\tinch\n", &["2 a GOOD"]);
    check("a\t\tdiameter\t1\t1\t0.001\t0\t\t\tdeg\n", &["2.10: unknown unit deg: use mm, µm or inch"]);
}

#[test]
fn rows_that_cannot_be_used_say_where() {
    check("a\t\tdiameter\n", &["2.4: no measured value in column actual"]);
    check("a\t\tdiameter\t25.0l\t25\t\t\t\t\tmm\n", &["2.4: actual: 25.0l is not a number"]);
    check("a\t\tdiameter\t25.01\t25\tx\t\t\t\tmm\n", &["2.6: uppertol: x is not a number"]);
    check(
        &format!("a{}x\n", "\t".repeat(12)),
        &["2: expected 10 cells, found 13: is the separator also used as decimal sign or within a text?"],
    );
    check("a\t\tdiameter\t25.01\t25\t0.021\t\t\t\tmm\n", &["2 a 25.01: not judged: one of the two limits is missing"]);
    check("a\t\tdiameter\t25.01\t\t\t\t\t\tmm\n", &["2 a 25.01: not judged: no limits given"]);
    check(
        "a\t\tdiameter\t25.01\t25\t0\t0.021\t\t\tmm\n",
        &["2 a 25.01: not judged: the lower limit 25.021 is above the upper limit 25"],
    );
    check("", &["1: no row holds a measurement"]);
}

#[test]
fn figures_of_the_table_that_contradict_each_other_are_told() {
    check(
        "a\t\tdiameter\t25.01\t25\t0.021\t0\t0.011\t\tmm\n",
        &["2? the table has a deviation of 0.011 mm, but its values give 0.01 mm", "2 a GOOD"],
    );
    check(
        "a\t\tdiameter\t25.03\t25\t0.021\t0\t0.03\t0\tmm\n",
        &["2? the table has 0 mm beyond the tolerance, but its values give 0.009 mm", "2 a OUT OF LIMITS"],
    );
    check("a\t\tdiameter\t24.99\t25\t0.021\t0\t-0.01\t-0.01\tmm\n", &["2 a OUT OF LIMITS"]);
    check(
        "a\t\tdiameter\t25.0100001\t25\t0.021\t0\t0.0100001\t\tmm\n",
        &[
            "2 a GOOD",
            "2? 1 measured value has digits beyond the nanometre, from this line on: it is rounded to the nearest nanometre",
        ],
    );
}

#[test]
fn a_table_cut_anywhere_says_so() {
    let whole = sample();
    let end = whole.len() - b"END\r\n".len();
    for cut in 0..whole.len() {
        let told = said(&whole[..cut]);
        let last = end + 3 <= cut;
        let is_told = told.iter().any(|line| line.contains("END, is missing") || line.starts_with("1: "));
        assert!(last || is_told, "{cut}: {told:?}");
    }
}

#[test]
fn what_comes_after_the_end_is_told() {
    let text = format!("{HEADER}a\t\tdiameter\t25.01\t\t\t\t\t\tmm\nEND\n\nx\n");
    assert_eq!(said(text.as_bytes())[1], "5? skipped after the line END: x");
}

#[test]
fn tables_are_told_by_their_header() {
    let named =
        |bytes: &[u8]| FORMATS.iter().find(|format| format.recognises(bytes, "a.csv")).map(|format| format.name);
    assert_eq!(named(&sample()), Some("calypso"));
    for text in [
        "id\tactual\tnominal\n",
        "id;actual;nominal;uppertol;lowertol\n",
        "id\tid\tactual\tnominal\tuppertol\tlowertol\n",
    ] {
        assert_ne!(named(text.as_bytes()), Some("calypso"), "{text}");
    }
}

#[test]
fn a_last_row_that_may_be_cut_off_is_refused() {
    let header = "id\tidsymbol\tnominal\tuppertol\tlowertol\tunit\tactual\n";
    let row = "a\tdiameter\t25\t0.021\t0\tmm\t25.0";
    let no_end = "2? the last line, END, is missing: the file may be cut off";
    assert_eq!(
        said(format!("{header}{row}").as_bytes()),
        [
            "2: the file ends here without a line end, so the row may be cut off: it is skipped; if it is complete, add a line end",
            no_end
        ]
    );
    let zeros = "2: the line has bytes of value 0, so the file was not written completely: the row is skipped";
    assert_eq!(said(format!("{header}{row}{}", "\0".repeat(100)).as_bytes()), [zeros, no_end]);
    assert_eq!(said(format!("{header}{row}\0003\nEND\n").as_bytes()), [zeros]);
    let behind = said(format!("{header}{row}\n{}", "\0".repeat(100)).as_bytes());
    assert_eq!(
        behind[1],
        "3? the file has bytes of value 0 here, so it was not written completely: rows may be missing"
    );
}
