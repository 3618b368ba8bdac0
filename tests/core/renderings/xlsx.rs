//! The workbook, read by another program's reader: kinds of cells, results of formulas, names of sheets.

use std::io::{Cursor, Read as _};
use std::sync::Arc;

use calamine::{Data, Reader as _, Xlsx};
use fitcheck::report::template::{HeadField, Template};
use fitcheck::report::xlsx::{MOST_CHECKS, MOST_PART_SHEETS};

use super::dfq::{read_back, values, warnings};
use super::lots::{EVIL, bytes, corrected, hostile, lot, plan, sheet, undecided};
use super::*;

type Book = Xlsx<Cursor<Vec<u8>>>;

fn book(report: &Report, language: Language) -> Book {
    Xlsx::new(Cursor::new(bytes("xlsx", report, language))).unwrap()
}

/// The rows of a sheet, as texts.
fn rows(book: &mut Book, name: &str) -> Vec<Vec<String>> {
    let range = book.worksheet_range(name).unwrap_or_else(|error| panic!("{name}: {error}"));
    let (height, width) = range.end().map_or((0, 0), |(row, column)| (row + 1, column + 1));
    let cell = |row, column| range.get_value((row, column)).map_or_else(String::new, Data::to_string);
    (0..height).map(|row| (0..width).map(|column| cell(row, column)).collect()).collect()
}

/// A file of the package.
fn part(bytes: &[u8], name: &str) -> String {
    let mut zip = zip::ZipArchive::new(Cursor::new(bytes)).unwrap();
    let mut text = String::new();
    zip.by_name(name).unwrap().read_to_string(&mut text).unwrap();
    text
}

#[test]
fn numbers_are_numbers_dates_are_dates_and_formulas_have_results() {
    let mut book = book(&report(vec![good(), rework(), out_of_position()]), Language::En);
    assert_eq!(book.sheet_names(), ["Inspection report", "Checks", "Skipped rows and warnings"]);
    let range = book.worksheet_range("Checks").unwrap();
    let cell = |row, column| range.get_value((row, column)).cloned().unwrap();
    assert_eq!(cell(4, 0), Data::Float(1.0));
    assert!(matches!(cell(4, 2), Data::DateTime(time) if time.to_ymd_hms_milli() == (2026, 11, 21, 10, 42, 7, 0)));
    for (column, expected) in [(5, 25.0), (6, 25.0), (7, 25.021), (8, 24.998), (9, -2.0), (12, 2.0), (13, 12.5)] {
        assert_eq!(cell(5, column), Data::Float(expected), "{column}");
    }
    assert_eq!(cell(5, 10), Data::String("\u{21bb} REWORK".to_owned()));
    assert_eq!((range.get_value((5, 11)), cell(6, 11)), (Some(&Data::Empty), Data::String("SIMULATED".to_owned())));
    assert_eq!(cell(6, 10), Data::String("\u{2013} SIMULATED SCRAP".to_owned()));
    let formulas = book.worksheet_formula("Checks").unwrap();
    assert_eq!(formulas.get_value((5, 9)).unwrap(), "ROUND((I6-F6)*1000,3)");
    let counts = book.worksheet_formula("Inspection report").unwrap();
    let all: Vec<String> = counts.used_cells().map(|(_, _, formula)| formula.clone()).collect();
    assert!(all.contains(&"COUNTIF(Checks!$K$5:$K$7,\"~?*\")".to_owned()), "{all:?}");
    let rows = rows(&mut book, "Inspection report");
    let count = |word: &str| rows.iter().find(|row| row[0] == word).unwrap_or_else(|| panic!("{rows:#?}"))[1].clone();
    let found = ["\u{2713} GOOD", "\u{21bb} REWORK", "? RE-MEASURE", "\u{2717} SCRAP", "\u{2013} SIMULATED", "Total"];
    assert_eq!(found.map(count), ["1", "1", "0", "0", "1", "3"]);
}

#[test]
fn company_head_rule_and_statement_of_a_template_stand_on_every_page_for_people() {
    let text = "version = 1\nname = \"own\"\nsections = [\"head\", \"statement\"]\nhead = [\"customer\", \"revision\"]\n\
                rule-text = \"Our rule QA-7 applies.\"\n[company]\nname = \"Northgate Precision\"\naddress = [\"Mill shop 2\"]\n";
    let template = Arc::new(Template::read(text).unwrap());
    let mut report = report(vec![good()]).by(&template);
    report.order = Some("4711".to_owned());
    report.tell(HeadField::Revision, "C");
    report.tell(HeadField::Customer, "Aster");
    let rows = rows(&mut book(&report, Language::En), "Inspection report");
    let said: Vec<_> =
        rows.iter().map(|row| (row[0].as_str(), row[1].as_str())).filter(|row| *row != ("", "")).collect();
    let head = [
        ("Inspection report", ""),
        ("", "Northgate Precision"),
        ("", "Mill shop 2"),
        ("Customer", "Aster"),
        ("Revision", "C"),
    ];
    assert_eq!(said[..5], head);
    assert_eq!(said[5].0, "Date");
    // What the template does not show stands nowhere.
    assert!(!said.iter().any(|(_, value)| *value == "4711"), "{said:#?}");
    let statement = "Statement of conformity: the value lies within its limits";
    assert!(said.contains(&("", "Our rule QA-7 applies.")), "{said:#?}");
    assert!(said.iter().any(|(_, said)| said.starts_with(statement)), "{said:#?}");
    for rendering in ["markdown", "html"] {
        let page = String::from_utf8(bytes(rendering, &report, Language::En)).unwrap();
        assert!(["Aster", "Our rule QA", statement].iter().all(|text| page.contains(text)), "{page}");
        assert!(page.find("Customer") < page.find("Revision"), "{page}");
        assert!(!page.contains("4711"), "{page}");
    }
}

#[test]
fn every_sheet_with_a_simulated_value_says_so_at_its_head() {
    let mut book = book(&report(vec![good(), out_of_position()]), Language::En);
    for name in book.sheet_names() {
        assert!(rows(&mut book, &name)[1][0].starts_with("SIMULATED"), "{name}");
    }
    let mut lot = self::book(&lot(), Language::En);
    for name in ["Inspection report", "Parts", "Checks", "4 20"] {
        assert!(rows(&mut lot, name)[1][0].starts_with("SIMULATED"), "{name}");
    }
    assert!(!rows(&mut lot, "1 17")[1][0].contains("SIMULATED"));
}

#[test]
fn a_lot_has_a_sheet_with_the_worst_part_first_and_one_a_part() {
    let mut book = book(&lot(), Language::En);
    let names = ["Inspection report", "Parts", "Checks", "1 17", "2 18", "3 19", "4 20", "Skipped rows and warnings"];
    assert_eq!(book.sheet_names(), names);
    let parts = rows(&mut book, "Parts");
    let line = |row: &Vec<String>| [2, 3, 4, 5, 6, 7, 11, 12].map(|column: usize| row[column].clone()).join(" ");
    let found: Vec<String> = parts[4..].iter().map(line).collect();
    assert_eq!(
        found,
        [
            "19 \u{2717} SCRAP 3 0 0 2 1 0",
            "18 \u{2013} No verdict yet 1 1 1 1 0 0",
            "20 \u{2013} No verdict yet 3 0 0 0 0 3",
            "17 \u{2713} GOOD 3 0 0 3 0 0",
        ]
    );
    let lacking = rows(&mut book, "2 18");
    assert_eq!(lacking[1][0], "\u{2013} No verdict yet: 1 measured, 1 missing, 1 skipped");
    assert!(lacking[2][0].contains("Missing: SEAT") && lacking[2][0].contains("SLOT: skipped: no gauge"));
    assert_eq!((lacking[5][10].as_str(), lacking[5][8].as_str()), ("\u{2013} not measured", ""));
    assert_eq!((lacking[6][10].as_str(), lacking[6][19].as_str()), ("\u{2013} skipped", "no gauge"));
    assert_eq!(lacking[4][8], "25.012");
}

#[test]
fn our_reader_has_the_same_values_and_what_is_simulated_stays_so() {
    let nobody = Record { id: "Nobody".to_owned(), ..out_of_position() };
    let report = report(vec![good(), rework(), scrap(), undecided(), nobody]);
    let items = read_back("r.xlsx", &bytes("xlsx", &report, Language::En));
    let found: Vec<String> = values(&items);
    let expected = [
        "Bore A 25.012 25..25.021 GOOD 2026-11-21T10:42:07 []",
        " 24.998 25..25.021 REWORK 2026-11-21T10:43:00 []",
        "Bore C 25.03 25..25.021 SCRAP 2026-11-21T10:43:30 []",
        "Guarded 25.0205 25..25.021 GOOD 2026-11-21T10:42:07 []",
        "Nobody 24.985 24.98..24.993 GOOD 2026-11-21T10:44:00 []",
    ];
    assert_eq!(found, expected);
    let simulated = items.iter().filter_map(|item| match item {
        fitcheck::exchange::Item::Record { record, .. } => Some(record.measurement.origin.is_simulated()),
        _ => None,
    });
    assert_eq!(simulated.collect::<Vec<_>>(), [false, false, false, false, true]);
    // Verdicts are known by their marks and words, and one that the limits alone do not give is told.
    let said = warnings(&items);
    let differ: Vec<&String> = said.iter().filter(|said| said.starts_with("the file says")).collect();
    assert_eq!(differ[0], "the file says ? RE-MEASURE, but the limits say GOOD");
    assert!(differ.len() <= 2, "{said:#?}");
}

#[test]
fn a_guard_band_and_a_correction_are_said() {
    let mut book = book(&report(vec![undecided(), corrected()]), Language::En);
    let checks = rows(&mut book, "Checks");
    assert_eq!(checks[4][10], "? RE-MEASURE");
    assert!(checks[4][19].contains("guard band") && checks[4][18].contains("ILAC-G8"), "{checks:#?}");
    assert!(checks[5][19].contains("measured 25.012000 mm at 26 °C"), "{checks:#?}");
    assert_eq!((checks[3][15].as_str(), checks[5][15].as_str()), ("corrected to 20 °C", "\u{2212}1.726 µm"));
}

#[test]
fn no_name_becomes_a_formula_a_link_or_a_wrong_name_of_a_sheet() {
    let file = bytes("xlsx", &hostile(), Language::En);
    let mut book: Book = Xlsx::new(Cursor::new(file.clone())).unwrap();
    let names = book.sheet_names();
    assert_eq!(names.len(), 4 + EVIL.len());
    for name in &names {
        assert!(name.encode_utf16().count() <= 31 && !name.contains(['[', ']', ':', '*', '?', '/', '\\']), "{name}");
        let formulas = book.worksheet_formula(name).unwrap();
        assert!(formulas.used_cells().all(|(_, _, formula)| !formula.contains("HYPERLINK")), "{name}");
    }
    let checks = rows(&mut book, "Checks");
    assert_eq!(checks[4][1], EVIL[0]);
    assert_eq!(checks[12][1], EVIL[8], "an escape of the format stays a text");
    for number in 1..=names.len() {
        let sheet = part(&file, &format!("xl/worksheets/sheet{number}.xml"));
        assert!(!sheet.contains("hyperlink"), "{number}");
    }
}

#[test]
fn a_text_that_is_too_long_is_cut_and_told() {
    let long = Record { id: "x".repeat(40_000), ..good() };
    let mut book = book(&report(vec![long]), Language::En);
    assert_eq!(rows(&mut book, "Checks")[4][1].len(), 32_767);
    let notes = rows(&mut book, "Skipped rows and warnings");
    assert!(notes.last().unwrap()[1].starts_with("One text is cut short"), "{notes:?}");
}

#[test]
fn what_is_beyond_the_most_of_a_workbook_is_told() {
    let checks: Vec<Record> = (0..=MOST_CHECKS).map(|n| if n < 2 { rework() } else { good() }).collect();
    let mut many = book(&report(checks), Language::En);
    let listed = rows(&mut many, "Checks");
    assert_eq!(listed.len(), 6);
    assert!(listed[2][0].contains("only the 2 of 50001 checks"), "{listed:#?}");
    let summary = rows(&mut many, "Inspection report");
    assert!(summary.iter().any(|row| row[0] == "\u{2713} GOOD" && row[1] == "49999"), "{summary:#?}");
    let plan = plan();
    let parts = (0..=MOST_PART_SHEETS).map(|n| sheet(&plan, &n.to_string(), &[(0, good())])).collect();
    let mut lot = book(&Report { parts, ..report(vec![good()]) }, Language::En);
    assert_eq!(lot.sheet_names().len(), 4 + MOST_PART_SHEETS);
    assert_eq!(rows(&mut lot, "Parts").len(), 5 + MOST_PART_SHEETS);
    let notes = rows(&mut lot, "Skipped rows and warnings");
    assert!(notes.iter().any(|row| row[1].starts_with("Only the first 100 of 101 parts")), "{notes:?}");
}

#[test]
fn a_sheet_is_printed_on_a4_across_with_its_head_on_each_page() {
    let file = bytes("xlsx", &report(vec![good(), rework()]), Language::Nl);
    let checks = part(&file, "xl/worksheets/sheet2.xml");
    for text in [
        "paperSize=\"9\"",
        "orientation=\"landscape\"",
        "fitToHeight=\"0\"",
        "<pane ySplit=\"4\"",
        "<autoFilter ref=\"A4:T6\"/>",
        "Fitcheck 0.0.0",
        "conditionalFormatting sqref=\"K5:K6\"",
    ] {
        assert!(checks.contains(text), "{text} is missing in\n{checks:.3000}");
    }
    let workbook = part(&file, "xl/workbook.xml");
    for text in ["_xlnm.Print_Titles", "$4:$4", "_xlnm.Print_Area"] {
        assert!(workbook.contains(text), "{text} is missing in\n{workbook}");
    }
    assert!(part(&file, "docProps/core.xml").contains("2026-11-21T11:00:00Z"));
}

#[test]
fn every_language_has_its_texts() {
    for language in Language::all() {
        let mut book = book(&lot(), language);
        for name in book.sheet_names() {
            let rows = rows(&mut book, &name);
            let odd = rows.iter().flatten().find(|cell| cell.contains("report-") || cell.contains("{ $"));
            assert_eq!(odd, None, "{language} {name}");
        }
    }
}
