//! Reading and writing files by a typed path.

use std::path::Path;

use eframe::egui::Key;
use eframe::egui::accesskit::Role;
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;
use fitcheck::gui::App;

use crate::harness::{check, verdict, window};

fn put(path: &Path, text: &str) {
    use std::io::Write as _;
    std::fs::File::create(path).unwrap().write_all(text.as_bytes()).unwrap();
}

fn choose(window: &mut Harness<'_, App>, menu: &str, entry: &str) {
    window.get_by_role_and_label(Role::Button, menu).click();
    window.run();
    window.get_by_role_and_label(Role::Button, entry).click();
    window.run();
}

/// The dialog's path has the focus when it opens, so typing is enough.
fn type_path(window: &mut Harness<'_, App>, label: &str, path: &Path) {
    window.get_by_role_and_label(Role::TextInput, label).type_text(&path.display().to_string());
    window.run();
    window.key_press(Key::Enter);
    window.run();
}

#[test]
fn a_log_of_the_control_is_imported_and_judged() {
    let mut window = window();
    window.get_by_role_and_label(Role::Button, "Import…").click();
    window.run();
    let log = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/samples/logs/de/TCHPR421.TXT");
    type_path(&mut window, "File", &log);
    assert!(verdict(&window).starts_with("REWORK. 9.9962 mm. Remove 3.8 µm"), "{}", verdict(&window));
    window.get_by_label_contains("TCHPR421.TXT: 1 check, no row refused");
    window.get_by_role_and_label(Role::Button, "Close").click();
    window.run();
    assert!(window.query_by_label_contains("no row refused").is_none());
}

#[test]
fn bad_rows_are_listed_and_good_rows_are_kept() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("parts.csv");
    put(&path, "id,callout,measured\nA1,25 H7,25.012\nA2,25 Q9,25.0\nA3,25 H7,x\n");
    let mut window = window();
    window.get_by_role_and_label(Role::Button, "Import…").click();
    window.run();
    type_path(&mut window, "File", &path);
    window.get_by_label_contains("parts.csv: 1 check, 2 rows refused");
    window.get_by_label_contains("Q9");
    window.get_by_label("1 check");
}

#[test]
fn a_folder_or_a_missing_file_is_refused_in_the_dialog() {
    let folder = tempfile::tempdir().unwrap();
    let mut window = window();
    window.get_by_role_and_label(Role::Button, "Import…").click();
    window.run();
    type_path(&mut window, "File", folder.path());
    window.get_by_label_contains("this is a folder");
    window.get_by_role_and_label(Role::Button, "Cancel").click();
    window.run();
    assert!(window.query_by_role_and_label(Role::TextInput, "File").is_none());
}

#[test]
fn escape_closes_the_dialog() {
    let mut window = window();
    window.get_by_role_and_label(Role::Button, "Import…").click();
    window.run();
    window.get_by_role_and_label(Role::TextInput, "File");
    window.key_press(Key::Escape);
    window.run();
    assert!(window.query_by_role_and_label(Role::TextInput, "File").is_none());
}

#[test]
fn the_history_is_exported_as_csv_json_and_report() {
    let folder = tempfile::tempdir().unwrap();
    let mut window = window();
    check(&mut window, "25 H7", "25.012");
    check(&mut window, "25 H7", "24.998");
    for (entry, name, needle) in [
        ("History as CSV…", "history.csv", "25 H7,hole,25,25.000,25.021,24.998"),
        ("History as JSON…", "history.json", "\"status\": \"REWORK\""),
        ("Inspection report (HTML)…", "report.html", "<svg"),
        ("Status window as text…", "status.txt", "MEASURED DIAMETER:  24.9980"),
    ] {
        choose(&mut window, "Export", entry);
        let path = folder.path().join(name);
        type_path(&mut window, "File", &path);
        let text = std::fs::read_to_string(&path).unwrap();
        assert!(text.contains(needle), "{name}: {text}");
        window.get_by_role_and_label(Role::Button, "Close").click();
        window.run();
    }
}

#[test]
fn a_folder_that_cannot_be_written_is_told() {
    let folder = tempfile::tempdir().unwrap();
    let mut window = window();
    check(&mut window, "25 H7", "25.012");
    choose(&mut window, "Export", "History as CSV…");
    type_path(&mut window, "File", &folder.path().join("none").join("history.csv"));
    window.get_by_label_contains("no such file or folder");
}

#[test]
fn own_tables_come_first() {
    let samples = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/samples/tables");
    let folder = tempfile::tempdir().unwrap();
    std::fs::copy(samples.join("generation1_plain.tab"), folder.path().join("generation1_plain.tab")).unwrap();
    let mut window = window();
    choose(&mut window, "Menu", "Own tables…");
    type_path(&mut window, "Folder", folder.path());
    window.get_by_label_contains("1 table is used from");
    window.get_by_role_and_label(Role::Button, "Close").click();
    window.run();
    check(&mut window, "25 U1", "25.010");
    assert!(verdict(&window).starts_with("GOOD"), "{}", verdict(&window));
    window.get_by_label_contains("generation1_plain.tab");
}

#[test]
fn an_own_mask_draws_the_status_window() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("shop.a");
    put(&path, "\"BORE %S IS %S\", QS2, QS3;\nM_CLOSE;\n");
    let mut window = window();
    check(&mut window, "25 H7", "25.012");
    choose(&mut window, "Menu", "Own mask…");
    type_path(&mut window, "File", &path);
    window.get_by_label_contains("BORE 25 H7 IS GOOD");
}

#[test]
fn a_mask_with_an_undefined_variable_names_it() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("shop.a");
    put(&path, "\"%F\", Q999;\n");
    let mut window = window();
    check(&mut window, "25 H7", "25.012");
    choose(&mut window, "Menu", "Own mask…");
    type_path(&mut window, "File", &path);
    window.get_by_label_contains("Q999");
}

#[derive(Debug)]
pub struct Dropped(pub std::path::PathBuf);

impl eframe::egui::DroppedFile for Dropped {
    fn path(&self) -> &Path {
        &self.0
    }

    fn bytes(&self) -> Result<Vec<u8>, String> {
        std::fs::read(&self.0).map_err(|error| error.to_string())
    }
}

#[test]
fn files_dropped_on_the_window_are_imported() {
    let logs = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/samples/logs");
    let mut window = window();
    for name in ["nl/TCHPR421.TXT", "en/TCHPR421.TXT"] {
        window.input_mut().dropped_files.push(std::sync::Arc::new(Dropped(logs.join(name))));
    }
    window.run();
    window.get_by_label("2 checks");
    assert!(verdict(&window).starts_with("GOOD. 25.0134 mm"), "{}", verdict(&window));
}

#[test]
fn import_and_report_open_by_key() {
    let mut window = window();
    window.key_press_modifiers(eframe::egui::Modifiers::COMMAND, Key::O);
    window.run();
    window.get_by_label("Import measurements");
    window.key_press(Key::Escape);
    window.run();
    check(&mut window, "25 H7", "25.012");
    window.key_press_modifiers(eframe::egui::Modifiers::COMMAND, Key::S);
    window.run();
    window.get_by_role_and_label(Role::Button, "Save");
}
