//! Templates: what they show and leave out, and what none of them can leave out.

use std::sync::Arc;

use fitcheck_core::message::Message;
use fitcheck_exchange::journal::chain::{ChainId, Hash, Head};
use fitcheck_exchange::report::paper::Paper;
use fitcheck_exchange::report::pdf::{Canvas, CanvasEdge, Pages};
use fitcheck_exchange::report::template::{HeadField, Section, Template};
use fitcheck_exchange::report::{Report, ReportJournal};

use super::made::{of_part, part, pdf, record, report as report_of, simulated, three, whole};
use super::reader::Pdf;

fn template(word: &str) -> Arc<Template> {
    Arc::clone(Template::shipped().iter().find(|template| template.word() == word).unwrap())
}

fn text(pdf: &Pdf) -> String {
    pdf.pages().iter().map(|page| pdf.text(*page)).collect::<Vec<_>>().join("\n")
}

fn by(word: &str, report: Report) -> String {
    text(&pdf(&report.by(&template(word)), "en"))
}

fn good() -> Report {
    report_of(vec![record("Bore A", "25 H7", "25.012"), record("Bore B", "25 H7", "25.003")])
}

#[test]
fn a_certificate_states_conformity_only_of_measured_complete_good_values() {
    let mut report = good();
    report.tell(HeadField::Customer, " Northgate ");
    let said = by("certificate", report);
    assert!(said.contains("Statement of conformity: all 2 values lie within their limits"), "{said}");
    assert!(said.contains("Northgate"), "{said}");
    let said = by("certificate", report_of(three()));
    assert!(said.contains("No conformity: 2 of 3 values do not conform"), "{said}");
    let said = by("certificate", report_of(vec![simulated("A", "25 H7", "25.012")]));
    assert!(said.contains("No statement of conformity: one value is simulated"), "{said}");
    let some = &whole()[..1];
    let said = by("certificate", of_part(part(some), some));
    assert!(said.contains("No statement of conformity: values are missing, 2 in all"), "{said}");
    assert!(!said.contains("Statement of conformity: all"), "{said}");
}

#[test]
fn a_value_in_doubt_states_no_conformity() {
    // A radius where a diameter was asked for, and one that lies within its limits all the same.
    for (callout, measured) in [("25 H7", "12.506"), ("1 +0.1 -0.6", "0.5")] {
        let radius = record("Bore A", callout, measured);
        assert!(radius.doubt.is_some(), "{callout}");
        let said = by("certificate", report_of(vec![record("Bore B", "25 H7", "25.003"), radius]));
        assert!(!said.contains("Statement of conformity: all"), "{said}");
        assert!(said.contains("Values in doubt, marked with a question mark: 1 of 2"), "{said}");
    }
}

#[test]
fn rows_that_are_no_checks_keep_a_certificate_from_stating_conformity() {
    let said = by("certificate", Report { is_partial: true, ..good() });
    assert!(said.contains("No statement of conformity: some rows were refused, not judged or not read."), "{said}");
    assert!(!said.contains("Statement of conformity: all"), "{said}");
}

#[test]
fn a_label_says_first_what_must_be_known() {
    for paper in [Paper::SmallLabel, Paper::LargeLabel] {
        let label = |report: Report| {
            let report = report.by(&template("label"));
            text(&pdf(&Report { paper, ..report }, "en"))
        };
        let said = label(report_of(vec![record("Bore A", "25 H7", "12.506")]));
        assert!(said.contains("Values in doubt"), "{said}");
        let some = &whole()[..1];
        let said = label(of_part(part(some), some));
        assert!(said.contains("Missing: SEAT, HUB"), "{said}");
    }
}

#[test]
fn a_first_article_lists_every_feature_also_what_is_missing_with_its_instrument() {
    let some = &whole()[..1];
    let mut report = of_part(part(some), some);
    report.tell(HeadField::Instrument, "Mill 3, probe 1");
    let said = by("first-article", report);
    for name in ["BORE_A", "SEAT", "HUB", "Missing: SEAT, HUB", "Mill 3, probe 1"] {
        assert!(said.contains(name), "{name}: {said}");
    }
    // Once in the head, and once for the value that was measured with it.
    assert_eq!(said.matches("Mill 3, probe 1").count(), 2, "{said}");
}

#[test]
fn a_sheet_to_fill_in_shows_limits_and_no_value() {
    let said = by("sheet", of_part(part(&whole()), &whole()));
    for text in ["Measurement sheet", "HUB", "39.998", "REWORK", "Missing"] {
        assert_eq!(said.contains(text), matches!(text, "Measurement sheet" | "HUB"), "{text}: {said}");
    }
    assert!(said.contains("25.000") && said.contains("25.021"), "{said}");
}

#[test]
fn a_template_leaves_out_sections_and_no_warning() {
    let mut hidden = Section::ALL.iter().copied().collect::<std::collections::BTreeSet<_>>();
    hidden.remove(&Section::Verdict);
    let least = Arc::new(Template::usual().without(&hidden, Paper::A4));
    let some = &[(0, simulated("BORE_A", "25 H7", "25.012"))];
    let mut report = of_part(part(some), some).by(&least);
    report.notes.push(Message::new("report-no-checks"));
    let pdf = pdf(&report, "en");
    let first = pdf.text(pdf.pages()[0]);
    for said in ["SIMULATED", "Missing: SEAT, HUB", "This report has no checks.", "Flange 4711, serial number 17"] {
        assert!(first.contains(said), "{said}: {first}");
    }
    assert!(pdf.root().get("Outlines").is_some() && !first.contains("Callout"), "{first}");
}

#[test]
fn a_label_has_its_size_one_page_and_what_counts() {
    for (paper, size) in [(Paper::SmallLabel, [176, 82]), (Paper::LargeLabel, [283, 142])] {
        let report = of_part(part(&whole()), &whole()).by(&template("label"));
        let pdf = pdf(&Report { paper, ..report }, "de");
        let pages = pdf.pages();
        assert_eq!(pages.len(), 1);
        let said = pdf.text(pages[0]);
        for text in ["NACHARBEIT", "Flange 4711", "17", "2026-11-21"] {
            assert!(said.contains(text), "{text}: {said}");
        }
        let sides = &pdf.page(pages[0]).get("MediaBox").unwrap().items()[2..];
        assert_eq!(sides.iter().map(|side| side.whole().unwrap()).collect::<Vec<_>>(), size);
    }
}

#[test]
fn the_parts_of_a_lot_stand_with_the_worst_first() {
    let scrap = [(0, record("BORE_A", "25 H7", "25.050"))];
    let good = [(0, record("BORE_A", "25 H7", "25.010"))];
    let mut report = of_part(part(&good), &good);
    report.parts.push(part(&scrap));
    let pdf = pdf(&report, "en");
    let tree = pdf.structure();
    let table = tree.find("Table").into_iter().next().unwrap().clone();
    let rows: Vec<String> = table.find("TR").iter().map(|row| row.said()).collect();
    assert!(rows[1].contains("SCRAP") && !rows[2].contains("SCRAP"), "{rows:?}");
}

pub fn in_journal(report: Report) -> Report {
    let head = |number| Head { number, hash: Hash([u8::try_from(number).unwrap(); 32]) };
    let numbers = "5, 7 to 8".to_owned();
    let journal = ReportJournal { chain: ChainId([1; 16]), head: head(9), newest: Some(head(8)), numbers };
    Report { journal: Some(journal), ..report }
}

#[test]
fn the_code_and_the_head_of_the_journal_lead_back_to_the_records() {
    let said = by("inspection", in_journal(good()));
    assert!(said.contains("5, 7 to 8") && said.contains("8:08080808"), "{said}");
    assert!(said.contains("09090909"), "{said}");
    let pdf = pdf(&in_journal(good()), "en");
    let codes: Vec<String> = pdf.structure().find("Figure").iter().map(|figure| figure.said()).collect();
    let hash = "08".repeat(32);
    assert!(codes.iter().any(|said| said.contains(&hash)), "{codes:?}");
    let without = by("inspection", good());
    assert!(!without.contains("08080808"));
}

/// What is drawn, in numbers.
#[derive(Default)]
struct Counted {
    texts: Vec<String>,
    shapes: usize,
}

impl Canvas for Counted {
    fn text(&mut self, _at: [f32; 2], _size: f32, _is_bold: bool, _ink: [u8; 3], text: &str) {
        self.texts.push(text.trim().to_owned());
    }

    fn icon(&mut self, _middle: [f32; 2], _size: f32, _ink: [u8; 3], _icon: char) {
        self.shapes += 1;
    }

    fn block(&mut self, _area: [f32; 4], _radius: f32, _fill: Option<[u8; 3]>, _edge: Option<CanvasEdge>) {
        self.shapes += 1;
    }

    fn polygon(&mut self, _corners: &[[f32; 2]], _fill: Option<[u8; 3]>, _edge: Option<CanvasEdge>) {
        self.shapes += 1;
    }

    fn lines(&mut self, _lines: &[[[f32; 2]; 2]], _within: [f32; 4], _edge: CanvasEdge) {
        self.shapes += 1;
    }

    fn picture(&mut self, _area: [f32; 4], _number: usize) {
        self.shapes += 1;
    }
}

#[test]
fn the_window_gets_the_pages_that_the_file_has() {
    let report = of_part(part(&whole()), &whole());
    let language = fitcheck_core::words::Language::all().find(|known| known.code() == "en").unwrap();
    let pages = Pages::of(&report, &fitcheck_core::words::Words::new(language)).unwrap();
    let file = pdf(&report, "en");
    assert_eq!(pages.count(), file.pages().len());
    for (number, page) in file.pages().iter().enumerate() {
        let mut drawn = Counted::default();
        pages.draw(number, &mut drawn);
        let said = file.text(*page);
        for text in drawn.texts.iter().filter(|text| !text.is_empty()) {
            assert!(said.contains(text.as_str()), "{text} is not in the file: {said}");
        }
        assert!(10 < drawn.shapes);
    }
    assert!(pages.text(0).contains("REWORK"));
}
