//! `fitcheck report --plan`: the whole part first, with its picture and a balloon a feature.

use assert_cmd::cargo::cargo_bin_cmd;

use crate::report::check_well_formed;

/// One dot; the text is that of many pages of the web.
const DOT: &str = "iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR42mNk+M9QDwADhgGAWjR9awAAAABJRU5ErkJggg==";

const PLAN: &str = r#"fitcheck_plan = 1
part = "Flange 4711"
drawing = "4711-B"
picture = "flange.png"

[[feature]]
number = 1
name = "BORE_A"
callout = "25 H7"
balloon_x = 0.42
balloon_y = 0.3

[[feature]]
number = 2
name = "SEAT"
callout = "20 g6"
balloon_x = 1
balloon_y = 0

[[feature]]
number = 3
name = "HUB"
callout = "40 H7"
rule = "iso14253-2017"
u_um = 1
"#;

struct Place(tempfile::TempDir);

impl Place {
    fn new(plan: &str) -> Self {
        let place = Self(tempfile::tempdir().unwrap());
        place.write("plan.toml", plan.as_bytes());
        place.write("flange.png", &dot());
        place
    }

    fn write(&self, name: &str, bytes: &[u8]) {
        fitcheck::files::write(&self.0.path().join(name), bytes).unwrap();
    }

    fn values(&self, rows: &str) {
        self.write("values.csv", format!("name;callout;measured;serial\n{rows}").as_bytes());
    }

    /// Exit code, the report and standard error.
    fn report(&self, name: &str) -> (i32, String, String) {
        let mut command = cargo_bin_cmd!("fitcheck");
        let args = ["report", "--plan", "plan.toml", "values.csv", "--time", "2026-11-24T10:42", "-o", name];
        let output = command.current_dir(self.0.path()).args(args).output().unwrap();
        let err = String::from_utf8(output.stderr).unwrap();
        let page = std::fs::read_to_string(self.0.path().join(name)).unwrap_or_default();
        (output.status.code().unwrap(), page, err)
    }
}

/// The bytes of the picture.
fn dot() -> Vec<u8> {
    let value = |sign: u8| match sign {
        b'A'..=b'Z' => u32::from(sign - b'A'),
        b'a'..=b'z' => u32::from(sign - b'a') + 26,
        b'0'..=b'9' => u32::from(sign - b'0') + 52,
        b'+' => 62,
        _ => 63,
    };
    let signs: Vec<u8> = DOT.bytes().filter(|sign| *sign != b'=').collect();
    let mut bytes = Vec::new();
    for four in signs.chunks(4) {
        let all = (0..4).fold(0, |all, at| all << 6 | four.get(at).map_or(0, |sign| value(*sign)));
        bytes.extend_from_slice(&all.to_be_bytes()[1..four.len()]);
    }
    bytes
}

/// Asserts that texts stand one behind the other.
#[track_caller]
fn in_order(page: &str, texts: &[&str]) {
    let mut rest = page;
    for text in texts {
        let found = rest.split_once(text);
        (_, rest) = found.unwrap_or_else(|| panic!("{text:?} is missing from here:\n{rest:.4000}"));
    }
}

const ALL: &str = "BORE_A;25 H7;25.012;17\nSEAT;20 g6;19.990;17\nHUB;40 H7;40.010;17\n";

#[test]
fn the_page_begins_with_the_part_its_picture_and_every_value_with_its_origin_and_rule() {
    let place = Place::new(PLAN);
    place.values(ALL);
    let (code, page, err) = place.report("r.html");
    assert_eq!(code, 0, "{err}");
    check_well_formed(&page);
    let address = format!("<img src=\"data:image/png;base64,{DOT}\" alt=\"Picture of the part\" />");
    in_order(
        &page,
        &[
            "style-src 'unsafe-inline'; img-src data:\"",
            "Flange 4711, serial number 17",
            "4711-B",
            "<svg class=\"verdict good\"",
            "3 measured, 0 missing, 0 skipped",
            &address,
            "<svg class=\"balloon good\" x=\"42.00%\" y=\"30.00%\"",
            "<title>Balloon 1, BORE_A, GOOD</title>",
            "<circle class=\"disc\"",
            "d=\"M20 38 L33 52 L57 20\"",
            "<svg class=\"balloon good\" x=\"100.00%\" y=\"0.00%\"",
            "<title>Balloon 2, SEAT, GOOD</title>",
            "flange.png; one feature has no balloon on it",
            "<bdi>BORE_A</bdi></td><td class=\"whole\">25 H7</td><td class=\"whole\">25.000 … 25.021</td><td class=\"number\">25.012 mm</td><td class=\"number\">+12 µm</td>",
            "values.csv",
            "no guard band",
            "<bdi>HUB</bdi>",
            "ISO 14253-1:2017",
            // What every report has comes after it.
            "<table class=\"overview\">",
            "<section class=\"check\"",
        ],
    );
}

#[test]
fn a_part_that_lacks_a_value_has_no_verdict_and_names_what_is_missing() {
    let place = Place::new(PLAN);
    place.values("BORE_A;25 H7;25.012;17\n");
    let (code, page, err) = place.report("r.html");
    assert_eq!(code, 1, "{err}");
    assert!(err.contains("not measured: SEAT, HUB"), "{err}");
    in_order(
        &page,
        &[
            "No verdict yet",
            "1 measured, 2 missing, 0 skipped",
            "Missing: SEAT, HUB",
            "<title>Balloon 1, BORE_A, GOOD</title>",
            "<svg class=\"balloon open\" x=\"100.00%\"",
            "<title>Balloon 2, SEAT, not measured</title>",
        ],
    );
    // Scrap stays scrap, whatever is missing.
    place.values("BORE_A;25 H7;25.1;17\n");
    let (code, page, _) = place.report("r.html");
    assert_eq!(code, 11);
    in_order(
        &page,
        &["<svg class=\"verdict scrap\"", "Missing: SEAT, HUB", "balloon scrap", "d=\"M22 20 L54 52 M54 20 L22 52\""],
    );
}

#[test]
fn a_simulated_value_is_never_good_on_paper() {
    let place = Place::new(PLAN);
    let rows = ALL.replace('\n', ";true\n");
    place.write("values.csv", format!("name;callout;measured;serial;simulated\n{rows}").as_bytes());
    let (code, page, _) = place.report("r.html");
    assert_eq!(code, 14, "nothing is good of what nobody measured");
    in_order(&page, &["No verdict yet", "balloon good simulated", "GOOD, simulated"]);
}

#[test]
fn an_svg_picture_is_shown_as_a_picture_and_runs_no_script() {
    let place = Place::new(&PLAN.replace("flange.png", "flange.svg"));
    let svg = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"9\" height=\"9\" onload=\"alert(1)\"><script>alert(2)</script></svg>";
    place.write("flange.svg", svg.as_bytes());
    place.values(ALL);
    let (code, page, err) = place.report("r.html");
    assert_eq!(code, 0, "{err}");
    check_well_formed(&page);
    // `<svg xmlns=` in base64.
    in_order(&page, &["<img src=\"data:image/svg+xml;base64,PHN2ZyB4bWxucz0i", "alt=\"Picture of the part\""]);
    for text in ["<script", "onload", "alert", "default-src 'self'"] {
        assert!(!page.contains(text), "{text}");
    }
    assert!(page.contains("default-src 'none'"));
}

#[test]
fn a_picture_that_is_missing_or_is_none_is_told() {
    for (name, bytes, why) in [
        ("gone.png", None, "no such file or folder"),
        ("flange.bmp", Some(&b"BM\x00"[..]), "flange.bmp is not a PNG, JPEG or SVG picture"),
        ("half.png", Some(&b"\x89PNG\r\n\x1a\n\x00\x00"[..]), "half.png cannot be read as a picture"),
    ] {
        let place = Place::new(&PLAN.replace("flange.png", name));
        if let Some(bytes) = bytes {
            place.write(name, bytes);
        }
        place.values(ALL);
        let (code, page, err) = place.report("r.html");
        assert_eq!(code, 0, "{err}");
        assert!(err.contains(why), "{err}");
        in_order(&page, &["<figure class=\"picture\">", why, name, "<table class=\"features\">"]);
        assert!(!page.contains("<img") && !page.contains("img-src"));
        check_well_formed(&page);
    }
}

#[test]
fn each_serial_number_is_a_part_of_its_own() {
    let place = Place::new(PLAN);
    place.values(&format!("{ALL}{}", ALL.replace(";17", ";18").replace("25.012", "24.9")));
    let (code, page, err) = place.report("r.html");
    assert_eq!(code, 10, "{err}");
    in_order(&page, &["serial number 17", "verdict good", "<img", "serial number 18", "verdict rework", "<img"]);
}

#[test]
fn json_has_the_parts_and_csv_the_name_of_the_picture() {
    let place = Place::new(PLAN);
    place.values("BORE_A;25 H7;25.012;17\n");
    let (code, text, err) = place.report("r.json");
    assert_eq!(code, 1, "{err}");
    let read: serde_json::Value = serde_json::from_str(&text).unwrap();
    assert_eq!(read["part"], "Flange 4711");
    let expected = serde_json::json!([{
        "part": "Flange 4711", "serial": "17", "status": null, "measured": 1, "missing": ["SEAT", "HUB"],
        "left_out": [], "simulated": 0, "picture": "flange.png",
    }]);
    assert_eq!(read["parts"], expected);
    assert_eq!(read["checks"][0]["id"], "BORE_A");
    let (_, csv, _) = place.report("r.csv");
    let lines: Vec<&str> = csv.lines().collect();
    // The plan has a rule, so there are its columns, too.
    assert!(lines[0].contains(",simulated,rule_name,") && lines[0].ends_with(",picture"), "{csv}");
    assert!(lines[1].contains(",false,") && lines[1].ends_with(",flange.png"), "{csv}");
    assert_eq!(lines.len(), 2);
}
