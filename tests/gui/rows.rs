//! The rows of a large file by label and key: counting, filtering, walking, showing one.

use std::fmt::Write as _;
use std::time::Duration;

use eframe::egui::accesskit::{Live, Role};
use eframe::egui::{Key, ViewportId, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use fitcheck::files;
use fitcheck::gui::App;
use fitcheck::session::{CheckCommand, LARGE, Purpose};
use fitcheck::verdict::rules::RuleName;

use crate::harness::{Window, click, cursor, press, rows, type_into, verdict};

/// A file that is too large for an import: of ten rows one is rework and one scrap; the last one cannot be read.
fn large() -> String {
    text_of(LARGE)
}

/// The same of at least so many bytes.
fn text_of(bytes: u64) -> String {
    let mut text = "id,callout,measured\n".to_owned();
    let mut number = 0;
    while text.len() < usize::try_from(bytes).unwrap() {
        let row = match number % 10 {
            0 => "25 H7,24.9900",
            1 => "40 g6,39.9000",
            _ => "25 H7,25.0100",
        };
        writeln!(text, "P{number:07},{row}").unwrap();
        number += 1;
    }
    text + "LAST,25 H7,\n"
}

/// A window that was opened with a file.
fn opened(name: &str, bytes: &[u8]) -> (tempfile::TempDir, Harness<'static, App>) {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join(name);
    files::write(&path, bytes).unwrap();
    let window = Window { files: vec![(Purpose::Import, path)], ..Window::default() }.open();
    (folder, window)
}

#[test]
fn a_large_file_shows_its_rows_and_counts_and_keeps_nothing_in_the_history() {
    let (_folder, window) = opened("big.csv", large().as_bytes());
    let count = window.state().session().check().rows.as_ref().unwrap().count();
    assert!(30_000 < count, "{count}");
    window.get_by_label_contains("all judged in");
    window.get_by_label_contains("1 MiB, more than 1 MiB: judged row by row");
    assert_eq!(
        rows(&window)[..2],
        [
            "line 2, P0000000, 25 H7, 24.9900 mm, −10 µm, REWORK, Remove 10 µm",
            "line 3, P0000001, 40 g6, 39.9000 mm, −100 µm, SCRAP",
        ]
    );
    assert!(rows(&window).len() < 40, "only those in sight are drawn");
    window.get_by_role_and_label(Role::CheckBox, "NOT JUDGED 1");
    assert!(window.state().session().history().is_empty());
    assert!(window.state().session().notices().is_empty());
    // Once it is settled nothing moves.
    assert_eq!(window.output().viewport_output[&ViewportId::ROOT].repaint_delay, Duration::MAX);
    assert!(window.query_by_role_and_label(Role::Button, "Cancel").is_none());
}

#[test]
fn keys_walk_the_rows_and_enter_shows_the_check_of_one() {
    let (_folder, mut window) = opened("big.csv", large().as_bytes());
    window.get_by_role(Role::Grid).focus();
    window.run();
    let list = |window: &Harness<'_, App>| window.get_by_role(Role::Grid).rect();
    for (key, part) in [
        (Key::Home, "P0000000"),
        (Key::ArrowDown, "P0000001"),
        (Key::PageDown, "P0000011"),
        (Key::ArrowUp, "P0000010"),
        (Key::PageUp, "P0000000"),
        (Key::End, "LAST"),
    ] {
        press(&mut window, key);
        assert!(cursor(&window).contains(&format!(", {part}, ")), "{key:?}: {}", cursor(&window));
        let row = window.get_by(|node| node.role() == Role::Row && node.is_selected() == Some(true));
        assert!(list(&window).contains(row.rect().center()), "{key:?}: {:?}", row.rect());
        assert!(window.get_by_role(Role::Grid).accesskit_node().data().active_descendant().is_some());
    }
    assert!(cursor(&window).ends_with("NOT JUDGED, measured: a length is missing"), "{}", cursor(&window));
    press(&mut window, Key::Enter);
    window.get_by_label_contains("No result. measured: a length is missing");
    press(&mut window, Key::Home);
    press(&mut window, Key::Enter);
    assert_eq!(verdict(&window).split(". ").next(), Some("REWORK"));
    window.get_by_label("Line 2 of big.csv");
    window.get_by_label("P0000000");
    let status = window.get_by_role(Role::Status);
    assert_eq!(status.accesskit_node().data().live(), Some(Live::Assertive));
    // The keys stay in the list.
    press(&mut window, Key::ArrowDown);
    assert!(cursor(&window).contains("P0000001"));
    click(&mut window, Role::Button, "Add to history");
    assert_eq!(window.state().session().history().len(), 1);
}

#[test]
fn a_click_shows_a_check_and_the_keys_go_on_from_there() {
    let (_folder, mut window) = opened("big.csv", large().as_bytes());
    window.get_by_label_contains("P0000001,").click();
    window.run();
    assert_eq!(verdict(&window).split(". ").next(), Some("SCRAP"));
    press(&mut window, Key::End);
    assert!(cursor(&window).contains(", LAST, "), "{}", cursor(&window));
}

#[test]
fn counts_and_classes_filter_the_rows() {
    let (_folder, mut window) = opened("big.csv", large().as_bytes());
    click(&mut window, Role::CheckBox, "NOT JUDGED 1");
    assert_eq!(rows(&window).len(), 1);
    window.get_by_label_contains("1 of ");
    click(&mut window, Role::CheckBox, "NOT JUDGED 1");
    let scrap = window
        .get_by(|node| node.role() == Role::CheckBox && node.label().is_some_and(|label| label.starts_with("SCRAP ")));
    scrap.click();
    window.run();
    assert!(rows(&window).iter().all(|row| row.contains("SCRAP") && row.contains("40 g6")), "{:?}", rows(&window));
    window.get_by_role_and_label(Role::ComboBox, "Classes").click();
    window.run();
    let class = window
        .get_by(|node| node.role() == Role::CheckBox && node.label().is_some_and(|label| label.starts_with("H7: ")));
    class.click();
    window.run();
    press(&mut window, Key::Escape);
    assert!(rows(&window).is_empty());
    window.get_by_label("No row matches the filter");
    click(&mut window, Role::Button, "Summary");
    window.get_by_label("1 row not judged");
    window.get_by_label_contains(": measured: a length is missing");
    window.get_by_label_contains("g6: SCRAP ");
}

#[test]
fn the_worst_part_is_shown_first_and_the_list_can_begin_with_it() {
    let text = large().replace("P0000021,40 g6,39.9000", "P0000021,40 g6,39.8000");
    let (_folder, mut window) = opened("big.csv", text.as_bytes());
    // Its line is 23: the head is the first.
    window.get_by_label("Line 23 of big.csv");
    assert_eq!(verdict(&window).split(". ").next(), Some("SCRAP"));
    click(&mut window, Role::Button, "Worst first");
    let listed = rows(&window);
    assert!(listed[0].contains("P0000021") && listed[0].contains("−200 µm"), "{listed:?}");
    // Of equals the first of the file is first.
    assert!(listed[1].contains("P0000001") && listed[2].contains("P0000011"), "{listed:?}");
    window.get_by_label("worst first");
    window.get_by_role(Role::Grid).focus();
    window.run();
    press(&mut window, Key::End);
    assert!(cursor(&window).contains(", LAST, "), "what has no verdict is last: {}", cursor(&window));
    click(&mut window, Role::Button, "Worst part");
    assert!(cursor(&window).contains("P0000021"), "{}", cursor(&window));
    click(&mut window, Role::Button, "Worst first");
    press(&mut window, Key::Escape);
    assert!(window.query_by_label("worst first").is_none());
}

#[test]
fn words_filter_the_rows_as_they_filter_the_history() {
    let (_folder, mut window) = opened("big.csv", large().as_bytes());
    for (words, only) in [("p0000011", "P0000011, 40 g6"), ("39,9 P0000021", "P0000021, 40 g6"), ("last", "LAST")] {
        type_into(&mut window, "Filter", words);
        let listed = rows(&window);
        assert!(listed.len() == 1 && listed[0].contains(only), "{words}: {listed:?}");
        window.get_by_label_contains("1 of ");
    }
    type_into(&mut window, "Filter", "rework");
    assert!(rows(&window).iter().all(|row| row.contains("REWORK")), "{:?}", rows(&window));
    // Both filters count.
    click(&mut window, Role::Button, "Worst first");
    let good = window
        .get_by(|node| node.role() == Role::CheckBox && node.label().is_some_and(|label| label.starts_with("GOOD ")));
    good.click();
    window.run();
    assert!(rows(&window).is_empty(), "{:?}", rows(&window));
    window.get_by_label("No row matches the filter");
}

#[test]
fn what_is_listed_is_exported_as_rows_and_as_a_report() {
    let (folder, mut window) = opened("big.csv", large().as_bytes());
    type_into(&mut window, "Filter", "P000001");
    click(&mut window, Role::Button, "Worst first");
    let save = |window: &mut Harness<'_, App>, item: &str, ending: &str| {
        window.get_all_by_role_and_label(Role::Button, "Export").last().unwrap().click();
        window.run();
        click(window, Role::Button, item);
        let path = folder.path().join(format!("out.{ending}"));
        type_into(window, "File", &path.display().to_string());
        press(window, Key::Enter);
        let told: Vec<_> = window.state().session().notices().iter().map(|notice| format!("{notice:?}")).collect();
        let text = std::fs::read_to_string(path).unwrap_or_else(|error| panic!("{error}: {told:?}"));
        click(window, Role::Button, "Close");
        text
    };
    let text = save(&mut window, "Rows of the file as CSV, with verdicts…", "csv");
    let lines: Vec<&str> = text.lines().collect();
    assert_eq!(lines[0], "id,callout,measured,min_mm,max_mm,deviation_um,status,remove_um,error");
    assert_eq!(lines[1], "P0000011,40 g6,39.9000,39.975,39.991,-100,SCRAP,,");
    assert_eq!(lines[2], "P0000010,25 H7,24.9900,25.000,25.021,-10,REWORK,10,");
    assert_eq!(lines[3], "P0000012,25 H7,25.0100,25.000,25.021,10,GOOD,,");
    assert_eq!(lines.len(), 11, "the head and ten rows");
    let text = save(&mut window, "Rows of the file as JSONL, with verdicts…", "jsonl");
    assert!(text.starts_with("{\"id\":\"P0000011\",") && text.lines().count() == 10, "{text}");
    let text = save(&mut window, "Inspection report (HTML)…", "html");
    assert!(text.contains("10 of them listed in this report") && text.contains("P0000011"));
    assert!(text.find("P0000011") < text.find("P0000010"), "in the order of the list");
    assert!(!text.contains("P0000020"));
}

#[test]
fn packed_rows_are_read_again_from_their_text() {
    let text = "id,callout,measured\n1,25 H7,25.01\n2,25 H7,24.99\n".as_bytes();
    let mut encoder = flate2::write::GzEncoder::new(Vec::new(), flate2::Compression::fast());
    std::io::Write::write_all(&mut encoder, text).unwrap();
    for (name, packed) in
        [("parts.csv.gz", encoder.finish().unwrap()), ("parts.csv.zst", zstd::encode_all(text, 1).unwrap())]
    {
        let (_folder, window) = opened(name, &packed);
        window.get_by_label_contains("Compressed: judged row by row");
        assert_eq!(
            rows(&window),
            [
                "line 2, 1, 25 H7, 25.0100 mm, +10 µm, GOOD",
                "line 3, 2, 25 H7, 24.9900 mm, −10 µm, REWORK, Remove 10 µm",
            ]
        );
    }
}

#[test]
fn a_file_that_changes_is_said_and_not_shown_wrong() {
    let (folder, mut window) = opened("big.csv", large().as_bytes());
    // In its place: a file of another content under the same name is another file.
    let mut file = std::fs::OpenOptions::new().write(true).open(folder.path().join("big.csv")).unwrap();
    std::io::Write::write_all(&mut file, large().replace("25.0100", "25.9100").as_bytes()).unwrap();
    drop(file);
    window.get_by_role(Role::Grid).focus();
    window.run();
    press(&mut window, Key::End);
    window.get_by_label_contains("the file has changed since it was judged");
    assert!(!rows(&window).iter().any(|row| row.contains("25.91")), "{:?}", rows(&window));
    click(&mut window, Role::Button, "Judge again");
    assert!(window.query_by_label_contains("the file has changed").is_none());
    window.get_by_label_contains("all judged in");
}

#[test]
fn a_file_that_cannot_be_read_to_its_end_is_incomplete() {
    let text = text_of(8 << 20);
    let mut encoder = flate2::write::GzEncoder::new(Vec::new(), flate2::Compression::fast());
    std::io::Write::write_all(&mut encoder, text.as_bytes()).unwrap();
    let packed = encoder.finish().unwrap();
    let (_folder, mut window) = opened("big.csv.gz", &packed[..packed.len() / 2]);
    window.get_by_label_contains("INCOMPLETE after");
    assert!(rows(&window).first().unwrap().starts_with("line 2, P0000000"));
    click(&mut window, Role::Button, "Summary");
    window.get_by_label("INCOMPLETE: the counts are not those of the whole file");
}

#[test]
fn rows_and_history_change_places_and_the_file_is_closed() {
    let (_folder, mut window) = opened("big.csv", large().as_bytes());
    click(&mut window, Role::Button, "History");
    window.get_by_label("Checks appear here, the newest first");
    click(&mut window, Role::Button, "Rows");
    assert!(!rows(&window).is_empty());
    click(&mut window, Role::Button, "Close file");
    assert!(window.state().session().check().rows.is_none());
    assert!(window.query_by_role_and_label(Role::Button, "Rows").is_none());
}

#[test]
fn every_size_shows_rows_and_the_verdict() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("big.csv");
    files::write(&path, large().as_bytes()).unwrap();
    for size in [
        vec2(800.0, 600.0),
        vec2(1024.0, 600.0),
        vec2(1280.0, 800.0),
        vec2(1920.0, 1080.0),
        vec2(800.0, 1280.0),
        vec2(2800.0, 1200.0),
    ] {
        let mut window = Window { size, files: vec![(Purpose::Import, path.clone())], ..Window::default() }.open();
        window.get_by_role(Role::Grid).focus();
        window.run();
        press(&mut window, Key::Home);
        press(&mut window, Key::Enter);
        assert!(2 <= rows(&window).len(), "{size:?}");
        let (grid, status) = (window.get_by_role(Role::Grid).rect(), window.get_by_role(Role::Status).rect());
        assert!(!grid.intersects(status.shrink(1.0)), "{size:?}: {grid:?} {status:?}");
    }
}

#[test]
fn rows_that_no_rule_has_judged_say_so() {
    let (_folder, mut window) = opened("big.csv", large().as_bytes());
    let said =
        "Judged by the limits alone: the decision rule and the temperature on this page do not apply to a large file";
    assert!(window.query_by_label(said).is_none());
    let ctx = window.ctx.clone();
    window.state_mut().send(&ctx, CheckCommand::UseRule(RuleName::Iso14253Of2017).into());
    window.run();
    window.get_by_label(said);
}
