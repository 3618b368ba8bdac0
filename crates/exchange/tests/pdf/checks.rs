//! Checks without a plan.

use fitcheck_core::words::Language;
use fitcheck_exchange::report::Report;
use fitcheck_exchange::report::paper::Paper;

use super::made::{bytes, guarded, pdf, record, rendered, report, simulated, three};
use super::reader::{Element, Pdf};

/// The cells of the rows of a table, head first.
fn rows(pdf: &Pdf) -> Vec<Vec<String>> {
    let structure = pdf.structure();
    let tables = structure.find("Table");
    let said = |row: &&Element| row.children.iter().map(Element::said).collect();
    tables[0].find("TR").iter().map(said).collect()
}

fn attached(pdf: &Pdf, name: &str) -> Vec<u8> {
    pdf.attachments().into_iter().find(|(known, ..)| known == name).unwrap().2
}

/// What the first page says.
fn first(report: &Report) -> String {
    let pdf = pdf(report, "en");
    pdf.text(pdf.pages()[0])
}

#[test]
fn the_table_read_aloud_gives_every_cell_with_its_head() {
    let rows = rows(&pdf(&report(three()), "en"));
    assert_eq!(rows.len(), 4);
    let aloud = |row: &[String]| {
        let cells = rows[0].iter().zip(row).map(|(head, cell)| format!("{head}: {cell}"));
        cells.collect::<Vec<_>>().join("\n")
    };
    assert_eq!(
        aloud(&rows[2]),
        "No.: 2\nName: Bore B\nCallout: 25 H7\nMinimum mm: 25.0000\nMaximum mm: 25.0210\nMeasured mm: 24.9980\nDeviation µm: −2\n\
         Limit band: Limit band, measured 24.9980 mm (−2 µm): 2 µm below minimum, 23 µm below maximum\nVerdict: REWORK\n\
         Source: typed 2 µm too small To remove on diameter: 2 µm to the nearest limit, 12.5 µm to the middle of the zone "
    );
}

#[test]
fn heads_are_heads_of_columns_and_names_heads_of_rows() {
    let structure = pdf(&report(three()), "en").structure();
    let heads = structure.find("TH");
    let scopes: Vec<&str> = heads.iter().map(|head| head.scope.as_str()).collect();
    assert_eq!(scopes, [vec!["Column"; 10], vec!["Row"; 3]].concat());
    assert_eq!(structure.find("H1")[0].text, "Inspection report");
    for row in structure.find("TR") {
        assert_eq!(row.children.len(), 10);
    }
}

#[test]
fn every_row_says_what_the_attached_json_says() {
    let report = report(three());
    let pdf = pdf(&report, "en");
    let json: serde_json::Value = serde_json::from_slice(&attached(&pdf, "report.json")).unwrap();
    let checks = json["checks"].as_array().unwrap();
    let rows = rows(&pdf);
    assert_eq!(rows.len(), checks.len() + 1);
    for (row, check) in rows.iter().skip(1).zip(checks) {
        let number = |at: usize| row[at].replace('−', "-").parse::<f64>().unwrap();
        assert_eq!(row[1], check["id"].as_str().unwrap());
        assert_eq!(row[2], check["callout"].as_str().unwrap());
        for (at, name) in [(3, "min_mm"), (4, "max_mm"), (5, "measured_mm"), (6, "deviation_um")] {
            assert!((number(at) - check[name].as_f64().unwrap()).abs() < 1e-9, "{name}: {row:?}");
        }
        assert_eq!(row[8], check["status"].as_str().unwrap());
    }
}

#[test]
fn the_data_are_attached_as_they_are_written_alone() {
    let report = report(three());
    let attachments = pdf(&report, "nl").attachments();
    let names: Vec<(&str, &str)> = attachments.iter().map(|(name, kind, _)| (name.as_str(), kind.as_str())).collect();
    assert_eq!(names, [("checks.csv", "Data"), ("report.json", "Data")]);
    assert_eq!(attachments[0].2, rendered(&report, "nl", "csv"));
    assert_eq!(attachments[1].2, rendered(&report, "nl", "json"));
}

#[test]
fn the_same_report_gives_the_same_bytes_and_another_language_another_file() {
    let report = report(three());
    assert_eq!(bytes(&report, "de"), bytes(&report, "de"));
    assert_ne!(bytes(&report, "de"), bytes(&report, "en"));
}

#[test]
fn a_file_says_that_it_can_be_kept_and_read_aloud() {
    let pdf = pdf(&Report { title: "Shift 2".to_owned(), ..report(three()) }, "pl");
    let metadata = pdf.metadata();
    for text in [
        "<pdfaid:part>3</pdfaid:part>",
        "<pdfaid:conformance>A</pdfaid:conformance>",
        "<pdfuaid:part>1</pdfuaid:part>",
        "Shift 2",
        "2026-11-21T10:42:07",
    ] {
        assert!(metadata.contains(text), "{text}: {metadata}");
    }
    assert_eq!(pdf.root().get("Lang").unwrap().text(), "pl");
    assert!(pdf.root().get("Outlines").is_some() && pdf.root().get("StructTreeRoot").is_some());
}

#[test]
fn the_answer_of_a_single_check_is_large_with_what_to_do() {
    let text = first(&report(vec![record("Bore B", "25 H7", "24.998")]));
    for said in
        ["REWORK", "To remove on diameter: 2 µm to the nearest limit", "2 µm too small", "Page 1 of 1", "Signature"]
    {
        assert!(text.contains(said), "{said}: {text}");
    }
}

#[test]
fn several_checks_are_counted() {
    let structure = pdf(&report(three()), "en").structure();
    let said: Vec<String> = structure.find("P").iter().map(|p| p.text.clone()).collect();
    for count in ["1 GOOD", "1 REWORK", "1 SCRAP", "3 Total"] {
        assert!(said.iter().any(|text| text == count), "{count}: {said:?}");
    }
}

#[test]
fn simulated_values_are_told_on_every_page() {
    let mut checks: Vec<_> = (0..150).map(|n| record(&format!("N{n}"), "25 H7", "25.012")).collect();
    checks.push(simulated("S", "25 H7", "25.010"));
    let pdf = pdf(&report(checks), "en");
    let pages = pdf.pages();
    assert!(3 <= pages.len());
    for page in &pages {
        assert!(pdf.text(*page).contains("SIMULATED"), "{}", pdf.text(*page));
    }
    let text = pdf.text(pages[0]);
    assert!(text.contains("Simulated values, measured by nobody: 1 of 151"), "{text}");
    // Where nobody simulated, nothing says so.
    assert!(!first(&report(three())).contains("SIMULATED"));
}

#[test]
fn what_is_guarded_corrected_or_doubted_is_told_on_the_first_page() {
    let text = first(&report(vec![record("A", "25 H7", "25.012").by(guarded("1.5")), record("B", "25 H7", "25.012")]));
    assert!(text.contains("Values judged by a decision rule of their own: 1 of 2"), "{text}");
    assert!(text.contains("Accepted values: 25.003 to 25.018 mm"), "{text}");
    // Twice the nominal size: a diameter was taken for a radius.
    let text = first(&report(vec![record("A", "25 H7", "50.024"), record("B", "25 H7", "25.012")]));
    assert!(text.contains("Values in doubt, marked with a question mark: 1 of 2"), "{text}");
    assert!(text.contains("SCRAP ?"), "{text}");
}

#[test]
fn notes_stand_on_the_first_page_or_are_announced_there() {
    let page = |count| {
        let note = fitcheck_core::message::message!("report-total");
        first(&Report { notes: vec![note; count], ..report(three()) })
    };
    let few = page(2);
    assert_eq!((few.matches("Total").count(), few.contains("listed at the end")), (3, false), "{few}");
    let many = page(9);
    assert!(many.contains("Skipped rows and warnings, listed at the end: 9"), "{many}");
    assert_eq!(many.matches("Total").count(), 10, "{many}");
}

#[test]
fn a_report_without_checks_says_so() {
    assert!(first(&report(Vec::new())).contains("This report has no checks."));
}

#[test]
fn every_language_has_its_page() {
    let report = report(three());
    let mut seen = Vec::new();
    for language in Language::all() {
        let pdf = pdf(&report, language.code());
        let text = pdf.text(pdf.pages()[0]);
        assert_eq!(pdf.root().get("Lang").unwrap().text(), language.code());
        assert!(!text.contains('□') && !text.contains("report-"), "{text}");
        seen.push(text);
    }
    seen.dedup();
    assert_eq!(seen.len(), 8);
}

#[test]
fn paper_is_a4_or_letter() {
    let size = |paper| {
        let pdf = pdf(&Report { paper, ..report(three()) }, "en");
        format!("{:?}", pdf.page(pdf.pages()[0]).get("MediaBox").unwrap())
    };
    assert!(size(Paper::A4).contains("595.276"), "{}", size(Paper::A4));
    assert!(size(Paper::Letter).contains("612.0"), "{}", size(Paper::Letter));
}

#[test]
fn two_thousand_checks_stand_in_one_table_with_its_head_on_every_page() {
    let checks: Vec<_> = (0..2_000).map(|n| record(&format!("N{n}"), "25 H7", "25.012")).collect();
    let pdf = pdf(&report(checks), "en");
    assert_eq!(rows(&pdf).len(), 2_001);
    let pages = pdf.pages();
    assert!((45..60).contains(&pages.len()), "{}", pages.len());
    for (at, page) in (1..).zip(&pages) {
        let text = pdf.text(*page);
        assert!(text.contains(&format!("Page {at} of {}", pages.len())), "{text}");
        assert!(text.contains("Deviation") || at == pages.len(), "{text}");
    }
}
