//! Whole parts.

use fitcheck_exchange::report::image::Image;
use fitcheck_exchange::report::{Report, part::PartSheet};

use super::made::{of_part, part, pdf, record, simulated, whole};

const SVG: &[u8] = b"<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 200 100\"><defs><linearGradient id=\"g\">\
    <stop stop-color=\"#fff\"/><stop offset=\"1\" stop-color=\"#abc\"/></linearGradient></defs>\
    <rect width=\"200\" height=\"100\" fill=\"url(#g)\" opacity=\".5\"/><circle cx=\"50\" cy=\"50\" r=\"20\" stroke=\"#000\"/></svg>";

fn first(report: &Report) -> String {
    let pdf = pdf(report, "en");
    pdf.text(pdf.pages()[0])
}

fn with_picture(picture: &[u8]) -> PartSheet {
    let mut sheet = part(&whole());
    sheet.picture = Some(Image::read("flange.png", picture));
    sheet
}

/// A PNG of 2 × 2 dots whose content is what is given.
fn png(content: &[u8]) -> Vec<u8> {
    let mut bytes = b"\x89PNG\r\n\x1a\n".to_vec();
    let header = [0, 0, 0, 2, 0, 0, 0, 2, 8, 2, 0, 0, 0];
    for (name, content) in [(b"IHDR", &header[..]), (b"IDAT", content), (b"IEND", &[])] {
        bytes.extend(u32::try_from(content.len()).unwrap().to_be_bytes());
        let start = bytes.len();
        bytes.extend(name);
        bytes.extend(content);
        let mut sum = flate2::Crc::new();
        sum.update(&bytes[start..]);
        bytes.extend(sum.sum().to_be_bytes());
    }
    bytes
}

fn packed(content: &[u8]) -> Vec<u8> {
    use std::io::Write as _;
    let mut packing = flate2::write::ZlibEncoder::new(Vec::new(), flate2::Compression::default());
    packing.write_all(content).unwrap();
    packing.finish().unwrap()
}

#[test]
fn a_part_begins_with_its_verdict_and_what_to_do() {
    let text = first(&of_part(part(&whole()), &whole()));
    for said in [
        "Flange 4711, serial number 17",
        "REWORK",
        "HUB: remove 2 µm on the diameter",
        "3 measured, 0 missing, 0 skipped",
        "4711-B",
        "Deburr the seat.",
        "19.990",
    ] {
        assert!(text.contains(said), "{said}: {text}");
    }
}

#[test]
fn a_missing_size_is_named_on_the_first_page_and_has_a_row() {
    let values = &whole()[..1];
    let report = of_part(part(values), values);
    let text = first(&report);
    for said in ["No verdict yet", "Missing: SEAT, HUB", "1 measured, 2 missing, 0 skipped"] {
        assert!(text.contains(said), "{said}: {text}");
    }
    let structure = pdf(&report, "en").structure();
    let rows = structure.find("TR");
    assert_eq!(rows.len(), 4);
    assert!(rows[3].said().contains("HUB 40 H7 40.000 40.025 – – – not measured –"), "{}", rows[3].said());
}

#[test]
fn what_was_left_out_is_told_with_its_reason() {
    let mut sheet = part(&whole()[..2]);
    sheet.skip(2, "gauge broken");
    let text = first(&of_part(sheet, &whole()[..2]));
    assert!(text.contains("HUB: skipped: gauge broken"), "{text}");
}

#[test]
fn a_simulated_part_is_never_taken_for_a_measured_one() {
    let values = [(0, simulated("BORE_A", "25 H7", "25.012"))];
    let text = first(&of_part(part(&values), &values));
    assert!(3 <= text.matches("SIMULATED").count(), "{text}");
    assert!(text.contains("One value is simulated"), "{text}");
}

#[test]
fn the_picture_has_its_balloons_in_words() {
    for picture in [SVG.to_vec(), png(&packed(&[0, 1, 2, 3, 4, 5, 6, 0, 1, 2, 3, 4, 5, 6]))] {
        let structure = pdf(&of_part(with_picture(&picture), &whole()), "en").structure();
        let figures = structure.find("Figure");
        let said = "Picture of the part; Balloon 1, BORE_A, GOOD; Balloon 2, SEAT, GOOD";
        assert_eq!(figures[0].alt.as_deref(), Some(said));
        // The picture, and a limit band for each value.
        assert_eq!(figures.len(), 4);
        let captions = structure.find("P");
        assert!(captions.iter().any(|p| p.text == "flange.png; one feature has no balloon on it"));
    }
}

#[test]
fn a_picture_that_cannot_be_drawn_leaves_the_report_whole() {
    for (picture, why) in [
        // Cut off within its dots.
        (png(&packed(&[0, 1, 2])), "flange.png cannot be read as a picture"),
        (png(b"nothing packed"), "flange.png cannot be read as a picture"),
        (
            b"<svg xmlns=\"http://www.w3.org/2000/svg\"><mask id=\"m\"><rect width=\"9\" height=\"9\"/></mask>\
              <rect width=\"9\" height=\"9\" mask=\"url(#m)\"/></svg>"
                .to_vec(),
            "flange.png would take too long to draw",
        ),
    ] {
        let text = first(&of_part(with_picture(&picture), &whole()));
        assert!(text.contains(why), "{text}");
        assert!(text.contains("39.998"), "{text}");
    }
}

#[test]
fn several_parts_are_listed_and_each_has_its_page() {
    let one = whole();
    let two = vec![(0, record("BORE_A", "25 H7", "25.030"))];
    let checks = one.iter().chain(&two).map(|(_, record)| record.clone()).collect();
    let report = Report { parts: vec![part(&one), part(&two)], ..super::made::report(checks) };
    let pdf = pdf(&report, "en");
    let text = pdf.text(pdf.pages()[0]);
    assert!(text.contains("Missing: SEAT, HUB"), "{text}");
    let structure = pdf.structure();
    let rows: Vec<String> = structure.find("Table")[0].find("TR").iter().map(|row| row.said()).collect();
    // The worst part comes first.
    assert_eq!(rows[1], "Flange 4711, serial number 17 SCRAP 1 2 0 0");
    assert_eq!(rows[2], "Flange 4711, serial number 17 REWORK 3 0 0 0");
    assert!(pdf.text(pdf.pages()[1]).contains("HUB: remove 2 µm on the diameter"));
    assert!(pdf.text(pdf.pages()[2]).contains("BORE_A: 9 µm too large"));
}

#[test]
fn values_that_are_in_no_part_stand_in_a_table_of_their_own() {
    let mut values = whole();
    let mut report = of_part(part(&values), &values);
    values.push((0, record("OTHER", "8 H9", "8.01")));
    report.checks = std::sync::Arc::new(values.into_iter().map(|(_, record)| record).collect::<Vec<_>>());
    let structure = pdf(&report, "en").structure();
    assert!(structure.find("H2").iter().any(|heading| heading.text == "All checks"));
    assert_eq!(structure.find("Table")[1].find("TR").len(), 5);
}
