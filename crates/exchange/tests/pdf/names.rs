//! What names must not do.

use fitcheck_exchange::report::Report;

use super::made::{pdf, record, report};

#[test]
fn a_name_of_ten_thousand_signs_is_cut_and_that_is_told() {
    let long = "x".repeat(10_000);
    let named = Report {
        title: long.clone(),
        part: Some(format!("{long} {long}")),
        order: Some(long.clone()),
        inspector: Some(long.clone()),
        ..report(vec![record(&long, "25 H7", "25.012"), record("B", "25 H7", "25.012")])
    };
    let pdf = pdf(&named, "en");
    assert!(pdf.pages().len() <= 2);
    let text = pdf.text(pdf.pages()[0]);
    assert!(text.contains("x…") && !text.contains(&"x".repeat(400)), "{text}");
    let all: String = pdf.pages().iter().map(|page| pdf.text(*page)).collect();
    assert!(all.contains("A text that ends in … is cut here"), "{all}");
    // It is whole in the attached data.
    assert!(String::from_utf8(pdf.attachments()[1].2.clone()).unwrap().contains(&long));
}

#[test]
fn control_characters_are_visible() {
    let pdf = pdf(&report(vec![record("A\u{1b}[31m\u{7}\u{202e}B\tC", "25 H7", "25.012")]), "en");
    let structure = pdf.structure();
    let name = &structure.find("TH").last().unwrap().text.clone();
    assert_eq!(name, "A\u{fffd}[31m\u{fffd}\u{fffd}B C");
}

#[test]
fn signs_that_no_font_has_are_boxes_that_can_still_be_copied() {
    for name in ["Буртик 中文", "שלום עולם", "😀"] {
        let pdf = pdf(&report(vec![record(name, "25 H7", "25.012")]), "en");
        let text = pdf.text(pdf.pages()[0]);
        assert!(text.contains(name), "{text}");
        assert!(text.contains("A □ stands for a character that the fonts of these pages lack"), "{text}");
    }
}

#[test]
fn no_name_becomes_a_link_a_script_or_another_object() {
    let name = "(x) >> endobj 1 0 obj << /JS (app.alert) /URI (https://example.org) >> stream \\) Tj";
    let named = Report {
        title: name.to_owned(),
        inspector: Some(name.to_owned()),
        ..report(vec![record(name, "25 H7", "25.012")])
    };
    let pdf = pdf(&named, "en");
    let structure = pdf.structure();
    assert_eq!(structure.find("H1")[0].text.replace(' ', ""), name.replace(' ', ""));
    for key in
        ["\"JS\"", "\"JavaScript\"", "\"URI\"", "\"Annots\"", "\"OpenAction\"", "\"AA\"", "\"Launch\"", "\"AcroForm\""]
    {
        assert!(!pdf.keys().contains(key), "{key}");
    }
}

proptest::proptest! {
    #![proptest_config(proptest::test_runner::Config::with_cases(48))]

    #[test]
    fn every_name_gives_a_whole_file(name in proptest::prelude::any::<String>(), part in "\\PC{0,60}") {
        let named = Report { part: Some(part), ..report(vec![record(&name, "25 H7", "25.012"), record("B", "8 H9", "8.01")]) };
        let pdf = pdf(&named, "cs");
        assert_eq!(pdf.structure().find("TR").len(), 3);
    }
}
