//! The drawing of a check in the page.

use fitcheck::report::RENDERINGS;

use super::*;

/// The band of the one check of a page.
fn drawn(record: &Record) -> String {
    let html = RENDERINGS.iter().find(|rendering| rendering.name == "html").unwrap();
    let page = html.bytes(&report(vec![record.clone()]), &Words::new(Language::En)).unwrap();
    let page = String::from_utf8(page).unwrap();
    let (_, band) = page.split_once("<svg class=\"band\"").unwrap();
    let (band, _) = band.split_once("</svg>\n<table").unwrap();
    band.to_owned()
}

#[test]
fn the_band_names_zone_sides_and_value() {
    let svg = drawn(&good());
    for text in
        ["too small", ">rework<", ">good<", "too large", ">scrap<", "25.012 mm (+12 µm)", "25.021 mm", ">+21 µm<"]
    {
        assert!(svg.contains(text), "{text} is missing in {svg}");
    }
    assert!(svg.contains("12 µm above minimum, 9 µm below maximum"));
    let order = |svg: &str| svg.find("class=\"hatch rework\"") < svg.find("class=\"hatch scrap\"");
    assert!(order(&svg), "a hole's rework side is on the left");
    assert!(!order(&drawn(&out_of_position())), "a shaft's is on the right");
}

#[test]
fn a_value_far_outside_is_an_arrow_with_its_number() {
    let svg = drawn(&typed("635"));
    assert!(svg.contains("M718 71") && svg.contains("635.000 mm (+610000 µm)"), "{svg}");
    assert!(drawn(&typed("12.5")).contains("M2 71"));
}

#[test]
fn no_coordinate_is_infinite_or_no_number() {
    for record in [good(), scrap(), typed("0.001"), out_of_position()] {
        let svg = drawn(&record);
        assert!(!svg.contains("NaN") && !svg.contains("inf"), "{svg}");
    }
}
