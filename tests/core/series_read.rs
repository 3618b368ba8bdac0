//! Protocols of a series: a mask with `M_APPEND` that was printed once per part, read back with part, serial number and all values.

use std::io::Cursor;

use fitcheck::control::mask::{Context, Mask};
use fitcheck::control::variables::{Parameter, Value, Variables};
use fitcheck::exchange::{ByPlan, ImportInputs, Item, Labels, import_from};
use fitcheck::length::Length;
use fitcheck::part::Plan;
use fitcheck::tolerance::Sources;
use fitcheck::verdict::Status;
use fitcheck::words::Dialogue;
use jiff::civil::{DateTime, date};

use crate::plans;

const NOW: DateTime = date(2026, 3, 7).at(8, 5, 9, 0);

/// One cycle, with nominal size and limits of the cycle, and a serial number of the user's.
const OF_CYCLE: &str = "\"PART: %4D  SERIAL: %-10S\", Q1800, QS10;\n\
    \"NOMINAL %9.4F MAX %9.4F MIN %9.4F\", Q262, Q275, Q276;\n\
    \"HOLE %9.4F %S\", Q153, QS3;\n\
    M_APPEND;\nM_CLOSE;\n";

/// Several values of a part, kept by the program until the part is done.
const OF_PART: &str = "\"PART %4D\", Q1800;\n\"SERIAL NO. %S\", QS10;\n\
    \"BORE_1 %9.4F\", Q1801;\n\"BORE_2 %9.4F\", Q1802;\n\"PIN_3  %9.4F\", Q1803;\n\
    \"BORE_1 MEAN %9.4F RANGE %9.4F\", Q1811, Q1812;\n\"TEMP %5.1F\", Q1820;\nM_APPEND;\n";

fn plan() -> Plan {
    plans::read(
        "name,callout,x,y,z\nBORE_1,25 H7,0,0,-8\nBORE_2,25 H7,50,0,-8\nPIN_3,20 g6,90,0,-8\n",
        &Sources::default(),
    )
    .unwrap()
}

/// What a program prints of a part.
fn print(mask: &str, numbers: &[(u16, &str)], texts: &[(u16, &str)]) -> String {
    let mut variables = Variables::new();
    for (number, value) in numbers {
        variables.set(Parameter::q(*number), Value::Length(value.parse().unwrap()));
    }
    for (number, value) in texts {
        variables.set(Parameter::qs(*number), Value::Text((*value).to_owned()));
    }
    let context = Context { language: Dialogue::En, time: NOW, call_path: "" };
    Mask::read(mask.as_bytes()).unwrap().0.render(&variables, &context).unwrap().text
}

/// A value that was read: line, part, serial number, name, measured value, status, and what else is said.
fn read(mask: &str, text: &str, plan: Option<&Plan>) -> Vec<String> {
    import("series.txt", text, &[("m.a".to_owned(), Mask::read(mask.as_bytes()).unwrap().0)], plan)
}

fn import(file: &str, text: &str, masks: &[(String, Mask)], plan: Option<&Plan>) -> Vec<String> {
    let sources = Sources::default();
    let given = ImportInputs { masks, has_plan: plan.is_some(), ..ImportInputs::new(&sources, NOW) };
    let mut items = Vec::new();
    import_from(file, &mut Cursor::new(text.as_bytes()), given, &mut |item| items.push(item));
    let items = plan.map_or_else(|| items.clone(), |plan| ByPlan::new(plan).file(items.clone()));
    items.into_iter().map(told).collect()
}

fn of(labels: &Labels) -> String {
    format!("[{}|{}|{}]", labels.part, labels.serial, labels.sample)
}

fn told(item: Item) -> String {
    match item {
        Item::Record { line, record, labels } => {
            let callout = record.callout.map(|callout| callout.to_string()).unwrap_or_default();
            let limits = &record.limits;
            let range = format!("{} {}..{}", limits.nominal, limits.minimum(), limits.maximum());
            let status = record.verdict.status();
            let measured = record.measurement.diameter;
            format!("{line} {} {}: {callout} {range} {measured} {status}", of(&labels), record.id)
        }
        Item::Unjudged(unjudged) => {
            let measured = unjudged.measured.unwrap();
            let of = of(&unjudged.labels);
            format!("{} {of} {}: {measured}: {}", unjudged.line, unjudged.id, unjudged.why)
        }
        Item::Error(error) => error.to_string(),
        Item::Warning(warning) => format!("warning: {warning}"),
        Item::Contacts(_) => panic!("no contacts"),
    }
}

#[test]
fn fifty_parts_of_one_cycle_have_part_serial_limits_and_side() {
    let size = |part: i64| Length::from_nanometres(24_998_000 + 500 * part).unwrap();
    let mut text = String::new();
    for part in 1..=50 {
        let serial = format!("A-{part:03}");
        let number = part.to_string();
        let measured = size(part).to_string();
        let numbers = [(1800, number.as_str()), (262, "25"), (275, "25.021"), (276, "25"), (153, &measured)];
        text += &print(OF_CYCLE, &numbers, &[(10, &serial), (3, "GOOD")]);
    }
    let said: Vec<String> = read(OF_CYCLE, &text, None);
    // The program said GOOD of all: where the limits say otherwise, it is told.
    let values: Vec<&String> = said.iter().filter(|said| !said.starts_with("warning")).collect();
    assert_eq!(values.len(), 50, "{said:?}");
    for (part, value) in (1..).zip(values) {
        let measured = size(part);
        // 25 H7: below is rework of a hole, above scrap.
        let status = if measured < "25".parse().unwrap() {
            Status::Rework
        } else if measured <= "25.021".parse().unwrap() {
            Status::Good
        } else {
            Status::Scrap
        };
        let line = 3 * part - 2;
        assert_eq!(*value, format!("{line} [|A-{part:03}|{part}] :  25 25..25.021 {measured} {status}"));
    }
    let rework = said.iter().filter(|said| said.contains("the file says GOOD, but the limits say REWORK")).count();
    let scrap = said.iter().filter(|said| said.contains("the file says GOOD, but the limits say SCRAP")).count();
    assert_eq!((rework, scrap), (3, 4), "{said:?}");
}

#[test]
fn without_a_word_of_hole_or_shaft_only_a_plan_tells_rework_from_scrap() {
    let mask = OF_CYCLE.replace("HOLE ", "");
    let numbers = [(1800, "7"), (262, "25"), (275, "25.021"), (276, "25"), (153, "25.03")];
    let text = print(&mask, &numbers, &[(10, "A-007"), (3, "SCRAP")]);
    assert_eq!(read(&mask, &text, None), ["1 [|A-007|7] :  25 25..25.021 25.03 OUT OF LIMITS"]);
    // A text that says it counts as well.
    let mask = mask.replace("\"%9.4F %S\", Q153, QS3", "\"%S: %9.4F %S\", QS12, Q153, QS3");
    for (word, status) in [("HOLE", "SCRAP"), ("WELLE", "REWORK"), ("BOHRUNG", "SCRAP")] {
        let text = print(&mask, &numbers, &[(10, "A-007"), (3, status), (12, word)]);
        assert_eq!(read(&mask, &text, None), [format!("1 [|A-007|7] {word}:  25 25..25.021 25.03 {status}")]);
    }
    let named = OF_CYCLE.replace("HOLE %9.4F", "BORE_1 ACTUAL %9.4F");
    let text = print(&named, &numbers, &[(10, "A-007"), (3, "SCRAP")]);
    assert_eq!(read(&named, &text, Some(&plan())), ["1 [|A-007|7] BORE_1: 25 H7 25 25..25.021 25.03 SCRAP"]);
}

const THREE: [(u16, &str); 4] = [(1811, "25.01"), (1812, "0.002"), (1820, "21.5"), (1800, "1")];

fn three(part: &str, [one, two, three]: [&str; 3]) -> String {
    let numbers = [THREE.as_slice(), &[(1800, part), (1801, one), (1802, two), (1803, three)]].concat();
    print(OF_PART, &numbers, &[(10, &format!("S{part}"))])
}

#[test]
fn every_value_of_a_part_finds_its_feature_of_the_plan() {
    let text = three("1", ["25.01", "25.022", "19.99"]) + &three("2", ["24.999", "25.0105", "19.995"]);
    let skipped = "warning: line 1: columns skipped: Q1811, Q1812, Q1820";
    let expected = [
        skipped,
        "1 [|S1|1] BORE_1: 25 H7 25 25..25.021 25.01 GOOD",
        "1 [|S1|1] BORE_2: 25 H7 25 25..25.021 25.022 SCRAP",
        "1 [|S1|1] PIN_3: 20 g6 20 19.98..19.993 19.99 GOOD",
        "8 [|S2|2] BORE_1: 25 H7 25 25..25.021 24.999 REWORK",
        "8 [|S2|2] BORE_2: 25 H7 25 25..25.021 25.0105 GOOD",
        "8 [|S2|2] PIN_3: 20 g6 20 19.98..19.993 19.995 REWORK",
    ];
    assert_eq!(read(OF_PART, &text, Some(&plan())), expected);
    // A head line once, or each time, and blank lines between.
    let head = "SERIES OF PLATES\n";
    let (one, two) = (three("1", ["25.01", "25.022", "19.99"]), three("2", ["24.999", "25.0105", "19.995"]));
    for text in [format!("{head}\n{one}\n\n{two}"), format!("{head}{one}{head}{two}\n")] {
        let said = read(OF_PART, &text, Some(&plan()));
        let values = said.iter().filter(|said| said.contains("] ")).count();
        let heads = said.iter().filter(|said| said.contains("skipped, not a measurement: SERIES OF PLATES")).count();
        assert_eq!((values, heads), (6, text.matches("SERIES OF").count()), "{said:?}");
    }
}

#[test]
fn without_a_plan_every_value_is_told_with_its_part() {
    let said = read(OF_PART, &three("4", ["25.01", "25.022", "19.99"]), None);
    assert_eq!(said.len(), 4, "{said:?}");
    for (said, name) in said[1..].iter().zip(["BORE_1: 25.01", "BORE_2: 25.022", "PIN_3: 19.99"]) {
        assert!(said.starts_with(&format!("1 [|S4|4] {name}: ")), "{said}");
    }
}

#[test]
fn a_file_that_is_cut_off_within_a_part_gives_none_of_its_values() {
    let whole = three("1", ["25.01", "25.022", "19.99"]);
    let all = whole.repeat(2);
    for end in whole.len()..all.len() - 1 {
        let said = read(OF_PART, all.get(..end).unwrap(), Some(&plan()));
        let values = said.iter().filter(|said| said.contains("] ")).count();
        assert_eq!(values, 3, "{end}: {said:?}");
        let is_begun = "PART    1".len() <= end - whole.len();
        let is_told = said.iter().any(|said| said.contains("the record ends too early"));
        assert_eq!(is_told, is_begun, "{end}: {said:?}");
    }
    // The next run appends to what was cut off: no value of either part is taken for one of the other.
    let cut = whole.get(..whole.len() - 20).unwrap();
    let said = read(OF_PART, &format!("{whole}{cut}{}", three("9", ["25.01", "25.01", "19.99"])), Some(&plan()));
    assert!(!said.iter().any(|said| said.contains("[|S1|1]") && !said.starts_with("1 ")), "{said:?}");
}

#[test]
fn limits_and_callouts_may_stand_beside_each_value() {
    let mask = "\"STUECK: %D\", Q1800;\n\"ERGEBNIS: %S\", QS20;\n\
        \"F1: %S  MINDESTMASS:%9.4F  HOECHSTMASS:%9.4F  ISTMASS:%9.4F  %S\", QS21, Q1811, Q1812, Q1801, QS31;\n\
        \"F2: %S  MINDESTMASS:%9.4F  HOECHSTMASS:%9.4F  ISTMASS:%9.4F  %S\", QS22, Q1821, Q1822, Q1802, QS32;\n\
        \"F1 MITTELWERT:%9.4F  SPANNWEITE:%9.4F\", Q1831, Q1832;\nM_APPEND;\n";
    let numbers = [
        (1800, "3"),
        (1811, "25"),
        (1812, "25.021"),
        (1801, "25.03"),
        (1821, "19.98"),
        (1822, "19.993"),
        (1802, "19.99"),
        (1831, "25.02"),
        (1832, "0.03"),
    ];
    let texts = [(20, "AUSSCHUSS"), (21, "25 H7"), (22, "20 g6"), (31, "AUSSCHUSS"), (32, "GUT")];
    let text = print(mask, &numbers, &texts);
    assert_eq!(
        read(mask, &text, None),
        [
            "warning: line 1: columns skipped: Q1831, Q1832",
            "1 [|3|] F1: 25 H7 25 25..25.021 25.03 SCRAP",
            "1 [|3|] F2: 20 g6 20 19.98..19.993 19.99 GOOD",
        ]
    );
    // A part that the program calls good is told where one value is not.
    let text = text.replacen("AUSSCHUSS", "GUT", 1).replace("25.0300  AUSSCHUSS", "25.0300  ");
    let said = read(mask, &text, None);
    assert!(said.iter().any(|said| said.contains("the file says GUT, but the limits say SCRAP")), "{said:?}");
}

#[test]
fn a_mask_that_leaves_a_value_open_is_refused() {
    // Two numbers of one name, and nothing that says which of them was measured.
    let mask = "\"PART %D\", Q1800;\n\"BORE_1 MIN %9.4F LAST %9.4F NOW %9.4F\", Q1801, Q1802, Q1803;\nM_APPEND;\n";
    let text = "PART 1\nBORE_1 MIN   25.0000 LAST   25.0100 NOW   25.0110\n";
    let said = read(mask, text, Some(&plan()));
    assert!(!said.iter().any(|said| said.contains("GOOD")), "{said:?}");
    // Without a word that says which part it is, numbers stay as they were: only the callout tells them.
    let none = "\"BORE_1 %9.4F BORE_2 %9.4F\", Q1801, Q1802;\n";
    let said = read(none, "BORE_1   25.0100 BORE_2   25.0100\n", Some(&plan()));
    assert!(said[0].contains("any of these could be the measured value: Q1801, Q1802"), "{said:?}");
}

fn table(text: &str, plan: Option<&Plan>) -> Vec<String> {
    import("OWN.TAB", text, &[], plan)
}

const OWN: &str = "BEGIN OWN.TAB MM\r\nNR PART SERIAL BORE_1    PIN_3     STATUS\r\n\
    0  1    A-1    +25.0100  +19.9900  GOOD  \r\n1  2    A-2    +25.o100  +19.9950  REWORK\r\n\
    2  3    A-3    -         +19.9900  GOOD  \r\n3  0                               \r\n[END]\r\n";

#[test]
fn a_row_of_a_table_has_the_values_of_its_part_and_garbage_costs_its_cell() {
    let said = table(OWN, Some(&plan()));
    let values: Vec<&String> = said.iter().filter(|said| said.contains("] ")).collect();
    let limits = "19.98..19.993";
    let expected = [
        "3 [|A-1|1] BORE_1: 25 H7 25 25..25.021 25.01 GOOD".to_owned(),
        format!("3 [|A-1|1] PIN_3: 20 g6 20 {limits} 19.99 GOOD"),
        format!("4 [|A-2|2] PIN_3: 20 g6 20 {limits} 19.995 REWORK"),
        format!("5 [|A-3|3] PIN_3: 20 g6 20 {limits} 19.99 GOOD"),
    ];
    assert_eq!(values, expected.iter().collect::<Vec<_>>(), "{said:?}");
    assert!(said[2].contains("line 4") && said[2].contains("25.o100"), "{said:?}");
    assert!(said[4].contains("line 5"), "{said:?}");
    assert_eq!(said.len(), 6, "{said:?}");
    // A part that the program calls good is told where one of its values is not; which one is rework, its status does not say.
    let said = table(&OWN.replace("+19.9900  GOOD", "+19.9700  GOOD"), Some(&plan()));
    let told = said.iter().filter(|said| said.contains("the file says GOOD, but the limits say SCRAP")).count();
    assert_eq!(told, 2, "{said:?}");
}

#[test]
fn a_table_with_one_value_a_part_has_its_limits_and_status_beside_it() {
    let one = "BEGIN OWN.TAB MM\r\nNR SERIAL CALLOUT  MIN      MAX      ACTUAL   STATUS\r\n\
               0  A-1    25 H7    25.0000  25.0210  25.0300  GOOD  \r\n[END]\r\n";
    let told = "warning: line 3: the file says GOOD, but the limits say SCRAP";
    assert_eq!(table(one, None), [told, "3 [|A-1|] : 25 H7 25 25..25.021 25.03 SCRAP"]);
    // Inch: only a column that a control converts is in the unit of the table.
    assert!(table(&one.replace(" MM", " INCH"), None)[0].contains("LENGTH"));
    let inch = "BEGIN OWN.TAB INCH\r\nTableDescription (\r\n  columns:= [\r\n    CfgColumnDescription (\r\n      key:=\"SERIAL\",\r\n\
                width:=8,\r\n      unit:=TEXT\r\n    ),\r\n    CfgColumnDescription (\r\n      key:=\"BORE_1\",\r\n      width:=12,\r\n\
                unit:=LENGTH\r\n    )\r\n  ]\r\n)\r\nSERIAL  BORE_1      \r\nA-1     0.9844      \r\n[END]\r\n";
    // 0.9844 inch is 25.00376 mm.
    assert_eq!(table(inch, Some(&plan())), ["17 [|A-1|] BORE_1: 25 H7 25 25..25.021 25.00376 GOOD"]);
    // Without a unit it is read in mm, which is told.
    let said = table(&one.replace(" MM", ""), None);
    assert!(said[0].contains("mm") && said.last().unwrap().ends_with("25.03 SCRAP"), "{said:?}");
}

#[test]
fn a_table_that_says_no_part_or_is_cut_off_is_refused() {
    let none = "BEGIN OWN.TAB MM\r\nNR F1       F2       \r\n0  25.0100  25.0000  \r\n[END]\r\n";
    assert!(table(none, Some(&plan()))[0].contains("no column says which part"));
    for end in OWN.find("\r\n0").unwrap()..OWN.find("[END]").unwrap() {
        let said = table(OWN.get(..end).unwrap(), Some(&plan()));
        let values = said.iter().filter(|said| said.contains("[|A-")).count();
        let is_told = said.iter().any(|said| !said.contains("[|A-") && !said.contains("25.o100"));
        assert!(is_told && values <= 4, "{end}: {said:?}");
    }
}
