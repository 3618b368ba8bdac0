//! The history as CSV.

use fitcheck::report::csv::render;

use super::*;

#[track_caller]
fn check(records: &[Record], lines: &[&str]) {
    let text = String::from_utf8(render(records).unwrap()).unwrap();
    let mut expected = vec![
        "time,id,callout,feature,nominal_mm,min_mm,max_mm,measured_mm,deviation_um,status,remove_um,\
         remove_to_middle_um,position,centre_x_mm,centre_y_mm,contacts,source,origin,rule,warnings,simulated",
    ];
    expected.extend(lines);
    assert_eq!(text.lines().collect::<Vec<_>>(), expected);
    assert!(text.ends_with('\n') && !text.contains('\r'));
}

#[test]
fn no_check_is_a_header() {
    check(&[], &[]);
}

#[test]
fn every_column_has_its_figure() {
    check(
        &[good(), rework(), out_of_position()],
        &[
            "2026-11-21T10:42:07,Bore A,25 H7,hole,25,25.000,25.021,25.012,12,GOOD,,,,,,,\
             \"ISO 286, over 18 up to 30 mm\",typed,\
             \"no guard band, limits belong to the zone\",\
             one diameter only: form and position are unknown,false",
            "2026-11-21T10:43:00,,25 H7,hole,25,25.000,25.021,24.998,-2,REWORK,2,12.5,,,,,\
             \"ISO 286, over 18 up to 30 mm\",typed,\
             \"no guard band, limits belong to the zone\",\
             one diameter only: form and position are unknown,false",
            "2026-11-21T10:44:00,Stud,25 g6,shaft,25,24.980,24.993,24.985,-15,SCRAP,,,OUT,0.003,-0.012,\
             \"[[12.4955,-0.012,-5.0],[0.003,12.4805,-5.0],[-12.4895,-0.012,-5.0],[0.003,-12.5045,-5.0]]\",\
             \"ISO 286, over 18 up to 30 mm\",\"simulated, cycle 422, seed 1\",\
             \"no guard band, limits belong to the zone\",\
             the centre is out of position; the size alone is GOOD | 4 contacts: no form beyond ovality is detected,\
             true",
        ],
    );
}

/// The only row of a record with this name, read back.
fn row(id: &str) -> ::csv::StringRecord {
    let record = Record { id: id.to_owned(), ..rework() };
    let bytes = render(&[record]).unwrap();
    ::csv::Reader::from_reader(bytes.as_slice()).records().next().unwrap().unwrap()
}

#[test]
fn a_text_is_never_a_formula_and_a_number_stays_a_number() {
    for text in ["=1+1", "+1", "-1", "@SUM(A1)", " =1", "＝1"] {
        assert_eq!(row(text).get(1), Some(format!("'{text}").as_str()));
    }
    // Where a tab or a line end separates as well, what follows it is a cell of its own.
    assert_eq!(row("\t=1").get(1), Some("'\t'=1"));
    assert_eq!(row("\r\n=1").get(1), Some("'\r\n'=1"));
    for text in ["", "Bore A", "A=1", "'=1", "25-1", "\u{2212}1"] {
        assert_eq!(row(text).get(1), Some(text));
    }
    let row = row("=HYPERLINK(\"http://x\",\"y\")");
    assert_eq!(row.get(1), Some("'=HYPERLINK(\"http://x\",\"y\")"));
    assert_eq!(row.get(8), Some("-2"));
}
