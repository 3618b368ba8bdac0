//! The columns of a file in the window, by label and key: shown where they are not certain, corrected, remembered, forgotten.

use std::path::Path;

use eframe::egui::accesskit::Role;
use eframe::egui::{Key, Modifiers, Theme, Vec2, vec2};
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use fitcheck::exchange::Role as Holds;
use fitcheck::session::{ColumnChoice, ColumnsCommand, Purpose};
use fitcheck::words::Language;

use crate::harness::{DESK, Window, click, press, verdict};
use crate::pictures::can_paint;
use crate::walk_page::{Harnessed, begun, drop_file, put, until, window_of};

/// Names that nobody knows, a comma in the numbers, inches. 0.98465 in is 25.01011 mm, 0.78675 in 19.98345 mm, 0.3547 in 9.00938 mm.
const ODD: &str = "Stelle;Kontur;Ergebnis in Zoll;Freigabe
BORE;12;0,98465;ja
PIN;7;0,78675;ja
D9;12;0,3547;nein
";

fn dropped(page: &mut Harnessed, folder: &Path, name: &str, text: &str) {
    let path = folder.join(name);
    put(&path, text);
    drop_file(page, path);
}

/// Chooses an entry of a list by pointer.
fn choose(page: &mut Harnessed, list: &str, entry: &str) {
    page.get_by_role_and_label(Role::ComboBox, list).click();
    page.run();
    page.get_by_role_and_label(Role::Button, entry).click();
    page.run();
}

fn held(page: &Harnessed, list: &str) -> String {
    page.get_by_role_and_label(Role::ComboBox, list).accesskit_node().value().unwrap_or_default()
}

fn can_take(page: &Harnessed) -> bool {
    !page.get_by_role_and_label(Role::Button, "Import").accesskit_node().is_disabled()
}

fn measured(page: &Harnessed) -> usize {
    page.state().session().parts().walking.standing().measured
}

fn is_open(page: &Harnessed) -> bool {
    page.state().session().open_columns().is_some()
}

#[test]
fn odd_columns_are_corrected_imported_remembered_after_a_restart_and_forgotten() {
    let folder = tempfile::tempdir().unwrap();
    let mut page = begun(folder.path());
    dropped(&mut page, folder.path(), "a.csv", ODD);
    page.get_by_label("Columns of a.csv");
    page.get_by_label("No column holds the measured value: choose one");
    assert!(!can_take(&page));
    assert_eq!(held(&page, "Separator"), "Semicolon");
    choose(&mut page, "3 Ergebnis in Zoll", "measured value");
    page.get_by_label("No column identifies the feature of a value: choose name, number, or X and Y");
    choose(&mut page, "1 Stelle", "name");
    page.get_by_label("Values read: 3 in 3 rows shown");
    assert_eq!(held(&page, "2 Kontur"), "not used");
    click(&mut page, Role::Button, "Import");
    assert!(!is_open(&page));
    page.get_by_label("a.csv: 3 imported, 0 not");
    page.get_by_label(
        "Columns: Stelle → name, Ergebnis in Zoll → measured value, Freigabe → status; unit of sizes: inch",
    );
    assert_eq!(measured(&page), 3);
    press(&mut page, Key::Escape);
    assert!(verdict(&page).contains("9.009"), "{}", verdict(&page));

    // The same shape once more, with other values and a line above the header.
    dropped(&mut page, folder.path(), "b.csv", &format!("Protokoll 12\n{ODD}D10;12;0,39390;ja\n"));
    assert!(!is_open(&page));
    page.get_by_label("b.csv: 4 imported, 0 not");
    page.get_by_label("Columns read as corrected on 2026-11-21");
    assert_eq!(measured(&page), 4);
    let state = folder.path().join("state.toml");
    until(&mut page, |_| std::fs::read_to_string(&state).is_ok_and(|text| text.contains("Ergebnis in Zoll")));
    drop(page);

    let mut page = Window { files: Vec::new(), ..window_of(folder.path(), DESK) }.open();
    page.key_press_modifiers(Modifiers::COMMAND, Key::Num2);
    page.run();
    press(&mut page, Key::Escape);
    dropped(&mut page, folder.path(), "c.csv", ODD);
    assert!(!is_open(&page));
    page.get_by_label("c.csv: 3 imported, 0 not");
    click(&mut page, Role::Button, "Forget these columns");
    page.get_by_label_contains("Columns forgotten");
    assert!(page.query_by_label("Forget these columns").is_none());
    press(&mut page, Key::Escape);
    dropped(&mut page, folder.path(), "d.csv", ODD);
    assert!(is_open(&page));
    press(&mut page, Key::Escape);
    assert!(!is_open(&page));
    assert_eq!(measured(&page), 4, "nothing was taken");
}

#[test]
fn a_certain_file_is_imported_at_once_and_says_what_its_columns_were_taken_for() {
    let folder = tempfile::tempdir().unwrap();
    let mut page = begun(folder.path());
    dropped(&mut page, folder.path(), "a.csv", "name;measured\nBORE;25,012\nPIN;19,985\n");
    page.get_by_label("a.csv: 2 imported, 0 not");
    page.get_by_label("Columns: name → name, measured → measured value; unit of sizes: mm");
    // It can be corrected afterwards.
    page.get_all_by_role_and_label(Role::Button, "Columns…").last().unwrap().click();
    page.run();
    page.get_by_label("Columns of a.csv");
    page.get_by_label("Values read: 2 in 2 rows shown");
    press(&mut page, Key::Escape);
    assert!(!is_open(&page));
    assert_eq!(measured(&page), 2);
}

#[test]
fn lines_of_a_gauge_are_read_in_the_unit_that_is_said() {
    let folder = tempfile::tempdir().unwrap();
    let mut page = begun(folder.path());
    dropped(&mut page, folder.path(), "gauge.txt", "01A+025.0120\r\n");
    page.get_by_label_contains("says neither mm nor inch");
    assert_eq!(measured(&page), 0);
    click(&mut page, Role::Button, "The lengths are in mm");
    until(&mut page, |page| measured(page) == 1);
    assert!(page.query_by_label("The lengths are in mm").is_none());
}

#[test]
fn the_keyboard_alone_corrects_and_takes() {
    let folder = tempfile::tempdir().unwrap();
    let mut page = begun(folder.path());
    dropped(&mut page, folder.path(), "a.csv", "feature;gauge 1;measured\nBORE;7;25,012\n");
    assert!(is_open(&page), "a column is unknown");
    // What is certain is taken with Enter.
    page.get_by_label("Values read: 1 in 1 row shown");
    page.get_by_role_and_label(Role::ComboBox, "2 gauge 1").focus();
    page.run();
    press(&mut page, Key::Space);
    // To “not used”, name, number, callout, nominal size, measured value, time, part, serial number, operator.
    for _ in 0..10 {
        press(&mut page, Key::ArrowDown);
    }
    press(&mut page, Key::Enter);
    assert_eq!(held(&page, "2 gauge 1"), "operator");
    page.key_press_modifiers(Modifiers::COMMAND, Key::Enter);
    page.run();
    page.get_by_label("a.csv: 1 imported, 0 not");
    press(&mut page, Key::Escape);
    // Where everything is as it should be, Enter is enough.
    dropped(&mut page, folder.path(), "b.csv", "feature;gauge 2;measured\nPIN;7;19,985\n");
    press(&mut page, Key::Enter);
    page.get_by_label("b.csv: 1 imported, 0 not");
}

#[test]
fn touch_alone_corrects_and_takes() {
    let folder = tempfile::tempdir().unwrap();
    let mut page = Window { size: vec2(800.0, 600.0), ..window_of(folder.path(), DESK) }.open();
    let ctx = page.ctx.clone();
    page.state_mut().send(&ctx, fitcheck::session::Command::SetDensity(fitcheck::session::Density::Touch));
    page.run();
    click(&mut page, Role::Button, "Start part");
    dropped(&mut page, folder.path(), "a.csv", ODD);
    for (list, entry) in [("1 Stelle", "name"), ("3 Ergebnis in Zoll", "measured value")] {
        let height = page.get_by_role_and_label(Role::ComboBox, list).rect().height();
        assert!(44.0 <= height, "{list}: {height}");
        choose(&mut page, list, entry);
    }
    assert!(44.0 <= page.get_by_role_and_label(Role::Button, "Import").rect().height());
    click(&mut page, Role::Button, "Import");
    page.get_by_label("a.csv: 3 imported, 0 not");
}

#[test]
fn the_check_page_asks_too() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.csv");
    put(&path, "Stelle;Vorgabe;Ergebnis;Rest\nb1;25 H7;25,012;a\n");
    let mut page = Window { files: vec![(Purpose::Import, path)], ..window_of(folder.path(), DESK) }.open();
    page.run();
    page.get_by_label("Columns of a.csv");
    for (list, entry) in [("1 Stelle", "name"), ("2 Vorgabe", "callout"), ("3 Ergebnis", "measured value")] {
        choose(&mut page, list, entry);
    }
    click(&mut page, Role::Button, "Import");
    press(&mut page, Key::Escape);
    assert!(verdict(&page).starts_with("GOOD"), "{}", verdict(&page));
}

fn picture(name: &str, size: Vec2, language: Language, theme: Theme) {
    if !can_paint(name) {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let mut page = Window { theme, language, ..window_of(folder.path(), size) }.open();
    let ctx = page.ctx.clone();
    page.state_mut().send(&ctx, fitcheck::session::parts::WalkCommand::Begin.into());
    dropped(&mut page, folder.path(), "messung.csv", ODD);
    for (at, role) in [(0, Holds::Id), (2, Holds::Measured)] {
        page.state_mut().send(&ctx, ColumnsCommand::Choose(ColumnChoice::Role(at, Some(role))).into());
    }
    page.run();
    page.remove_cursor();
    page.run();
    page.snapshot(name);
}

#[test]
fn picture_of_the_columns() {
    picture("columns_light", DESK, Language::En, Theme::Light);
}

#[test]
fn picture_of_the_columns_in_a_small_window() {
    picture("columns_small_nl", vec2(480.0, 320.0), Language::Nl, Theme::Dark);
}
