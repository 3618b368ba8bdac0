//! Reading and writing files by a typed path.

use std::path::{Path, PathBuf};

use eframe::egui::Key;
use eframe::egui::accesskit::Role;
use egui_kittest::Harness;
use egui_kittest::kittest::{By, Queryable as _};
use fitcheck::gui::App;
use fitcheck::session::{Command, FilesCommand, Page, Purpose};

use crate::harness::{Window, check, verdict, window};

pub fn put(path: &Path, text: &str) {
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
    window.get_by_label_contains("TCHPR421.TXT: 1 check, no rows refused");
    window.get_by_role_and_label(Role::Button, "Close").click();
    window.run();
    assert!(window.query_by_label_contains("no rows refused").is_none());
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
fn a_file_of_measurements_says_how_many_are_what_and_leads_there() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("parts.csv");
    put(&path, "id,callout,measured\nA1,25 H7,25.012\nA2,25 H7,25.030\nA3,25 H7,24.998\nA4,25 H7,25.001\n");
    let mut window = window();
    let ctx = window.ctx.clone();
    window.state_mut().send(&ctx, Command::OpenPage(Page::Fit));
    window.run();
    window.get_by_role_and_label(Role::Button, "Import…").click();
    window.run();
    type_path(&mut window, "File", &path);
    window.get_by_label_contains("parts.csv: 4 checks, no rows refused. GOOD 2, REWORK 1, SCRAP 1");
    window.get_by_role_and_label(Role::Button, "Show").click();
    window.run();
    assert_eq!(window.state().session().page(), Page::Check);
    assert!(window.query_by_role_and_label(Role::Button, "Show").is_none());
}

#[test]
fn a_typed_folder_is_listed_and_a_missing_file_is_refused_in_the_dialog() {
    let folder = tempfile::tempdir().unwrap();
    put(&folder.path().join("parts.csv"), "id,callout,measured\n");
    let mut window = window();
    window.get_by_role_and_label(Role::Button, "Import…").click();
    window.run();
    type_path(&mut window, "File", &folder.path().join("none.csv"));
    window.get_by_label_contains("no such file or folder");
    window.key_press_modifiers(eframe::egui::Modifiers::COMMAND, Key::A);
    type_path(&mut window, "File", folder.path());
    window.get(part(Role::ListBoxOption, "parts.csv"));
    assert!(window.query_by_label_contains("no such file or folder").is_none());
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
        ("Status window of Check as text…", "status.txt", "MEASURED DIAMETER:  24.9980"),
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

/// A problem is read again after it was closed, until the list is emptied; what was done is not kept.
#[test]
fn what_asked_for_a_look_can_be_read_again() {
    let folder = tempfile::tempdir().unwrap();
    let mut window = window();
    check(&mut window, "25 H7", "25.012");
    assert!(window.query_by_label("1 earlier message").is_none());
    for name in ["morning.csv", "evening.csv"] {
        let path = folder.path().join(name);
        put(&path, "id,callout,measured\nA1,25 H7,25.012\nA2,25 Q9,25.0\n");
        window.get_by_role_and_label(Role::Button, "Import…").click();
        window.run();
        type_path(&mut window, "File", &path);
        press(&mut window, &[Key::Escape]);
    }
    choose(&mut window, "Export", "History as CSV…");
    type_path(&mut window, "File", &folder.path().join("history.csv"));
    window.get_by_label_contains("history.csv was written");
    press(&mut window, &[Key::Escape]);
    let told = |window: &Harness<'_, App>| window.query_all_by_label_contains("csv: 1 check, 1 row refused").count();
    assert_eq!(told(&window), 0);
    window.get_by_label("2 earlier messages").click();
    window.run();
    assert_eq!(told(&window), 2);
    assert!(window.query_by_label_contains("was written").is_none());
    press(&mut window, &[Key::Escape]);
    assert_eq!(told(&window), 0);
    window.get_by_label("2 earlier messages").click();
    window.run();
    click(&mut window, Role::Button, "Empty this list");
    assert!(window.query_by_label("2 earlier messages").is_none());
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

/// A window whose dialogs begin in this folder.
fn at_home(folder: &Path) -> Harness<'static, App> {
    Window { home: Some(folder.to_owned()), ..Window::default() }.open()
}

/// A folder with one good part in `logs/parts.csv`, and files of other kinds.
fn shop() -> tempfile::TempDir {
    let folder = tempfile::tempdir().unwrap();
    std::fs::create_dir(folder.path().join("logs")).unwrap();
    put(&folder.path().join("logs/parts.csv"), "id,callout,measured\nA1,25 H7,25.012\n");
    put(&folder.path().join("logs/notes.pdf"), "%PDF");
    put(&folder.path().join("more.csv"), "id,callout,measured\nA2,25 H7,24.998\n");
    folder
}

fn press(window: &mut Harness<'_, App>, keys: &[Key]) {
    for key in keys {
        window.key_press(*key);
        window.run();
    }
}

/// Something whose name has this part.
fn part(role: Role, label: &str) -> By<'_> {
    By::new().role(role).label_contains(label)
}

fn click(window: &mut Harness<'_, App>, role: Role, label: &str) {
    window.get(part(role, label)).click();
    window.run();
}

fn open_import(window: &mut Harness<'_, App>) {
    window.key_press_modifiers(eframe::egui::Modifiers::COMMAND, Key::O);
    window.run();
}

fn rows(window: &Harness<'_, App>) -> usize {
    window.query_all_by_role(Role::ListBoxOption).count()
}

#[test]
fn a_file_is_found_and_read_by_keys_alone() {
    let folder = shop();
    let mut window = at_home(folder.path());
    open_import(&mut window);
    if let Ok(pictures) = std::env::var("PICTURES") {
        window.render().unwrap().save(Path::new(&pictures).join("dialog.png")).unwrap();
    }
    window.get(part(Role::ListBoxOption, "logs, Folder"));
    window.get(part(Role::ListBoxOption, "more.csv, 36 B"));
    press(&mut window, &[Key::ArrowDown, Key::Enter]);
    assert_eq!(rows(&window), 1, "notes.pdf holds no measurements");
    press(&mut window, &[Key::Backspace]);
    assert_eq!(rows(&window), 2);
    press(&mut window, &[Key::ArrowDown, Key::Enter, Key::ArrowDown, Key::Enter]);
    assert!(verdict(&window).starts_with("GOOD. 25.012 mm"), "{}", verdict(&window));
    assert!(window.query_by_role_and_label(Role::TextInput, "File").is_none());
}

#[test]
fn a_file_is_found_and_read_by_touch_alone() {
    let folder = shop();
    let mut window = at_home(folder.path());
    window.get_by_role_and_label(Role::Button, "Import…").click();
    window.run();
    click(&mut window, Role::ListBoxOption, "logs");
    window.get_by_label("1 entry is not shown");
    window.get_by_role_and_label(Role::CheckBox, "All files").click();
    window.run();
    assert_eq!(rows(&window), 2);
    click(&mut window, Role::Button, "Parent folder");
    click(&mut window, Role::ListBoxOption, "more.csv");
    window.get_by_role_and_label(Role::Button, "Open").click();
    window.run();
    assert!(verdict(&window).starts_with("REWORK. 24.998 mm"), "{}", verdict(&window));
}

#[test]
fn typing_filters_the_list_and_alt_with_an_arrow_goes_up() {
    let folder = shop();
    let mut window = at_home(folder.path());
    open_import(&mut window);
    window.get_by_role_and_label(Role::TextInput, "File").type_text("mor");
    window.run();
    assert_eq!(rows(&window), 1);
    press(&mut window, &[Key::ArrowDown]);
    assert_eq!(window.get_by_role_and_label(Role::TextInput, "File").value(), Some("more.csv".to_owned()));
    let parent = folder.path().parent().unwrap().display().to_string();
    window.key_press_modifiers(eframe::egui::Modifiers::ALT, Key::ArrowUp);
    window.run();
    window.get_by_label(&format!("Folder {parent}"));
    window.key_press_modifiers(eframe::egui::Modifiers::ALT, Key::Home);
    window.run();
    assert_eq!(rows(&window), 2);
}

#[test]
fn a_folder_that_is_gone_is_told_and_the_home_folder_helps() {
    let folder = shop();
    let mut window = at_home(&folder.path().join("none"));
    open_import(&mut window);
    window.get_by_label_contains("no such file or folder");
    click(&mut window, Role::Button, "Parent folder");
    assert_eq!(rows(&window), 2);
}

#[test]
fn a_long_list_follows_the_arrows_and_says_where_it_ends() {
    let folder = tempfile::tempdir().unwrap();
    for number in 0..=fitcheck::files::MOST_ENTRIES {
        put(&folder.path().join(format!("{number:05}.csv")), "");
    }
    let mut window = at_home(folder.path());
    open_import(&mut window);
    window.get_by_label_contains("Only the first 5000 entries are listed");
    assert!(rows(&window) < 20, "only what is in sight is drawn");
    press(&mut window, &[Key::ArrowUp]);
    window.run();
    let last = window.get_by_role_and_label(Role::TextInput, "File").value().unwrap();
    window.get(part(Role::ListBoxOption, &last));
}

#[test]
fn the_dialog_fits_every_window_and_asks_for_no_repaint() {
    let folder = shop();
    for (width, height) in [(427.0, 267.0), (533.0, 400.0), (800.0, 600.0), (1024.0, 600.0), (1280.0, 800.0)] {
        for language in fitcheck::words::Language::all() {
            let home = Some(folder.path().to_owned());
            let size = eframe::egui::vec2(width, height);
            let mut window = Window { size, language, home, ..Window::default() }.open();
            open_import(&mut window);
            let words = fitcheck::words::Words::new(language);
            for button in ["dialog-open", "dialog-browse", "dialog-cancel"] {
                let rect = window.get_by_role_and_label(Role::Button, &words.get(button)).rect();
                let what = format!("{width}x{height} {} {button}: {rect}", language.code());
                assert!(0.0 <= rect.top() && rect.bottom() <= height && rect.right() <= width, "{what}");
            }
            if 600.0 <= height {
                assert_eq!(rows(&window), 2, "{width}x{height}");
                let all = window.get_by_role_and_label(Role::CheckBox, &words.get("dialog-all-files")).rect();
                let open = window.get_by_role_and_label(Role::Button, &words.get("dialog-open")).rect();
                assert!(all.bottom() <= open.top(), "{width}x{height}: nothing scrolls");
            }
            let viewport = &window.output().viewport_output[&eframe::egui::ViewportId::ROOT];
            assert_eq!(viewport.repaint_delay, std::time::Duration::MAX);
        }
    }
}

#[test]
fn where_the_system_shows_no_dialog_the_list_is_there() {
    let folder = shop();
    let mut window = at_home(folder.path());
    open_import(&mut window);
    click(&mut window, Role::Button, "Browse…");
    window.get_by_label_contains("The system's dialog returned no file");
    assert_eq!(rows(&window), 2);
}

/// Exports the history as CSV to a file, up to the answer.
fn export(window: &mut Harness<'_, App>, path: &Path) {
    choose(window, "Export", "History as CSV…");
    type_path(window, "File", path);
}

#[test]
fn a_file_that_exists_is_asked_about_and_kept_by_enter() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("history.csv");
    put(&path, "mine");
    let mut window = window();
    check(&mut window, "25 H7", "25.012");
    for keep in [Key::Enter, Key::Escape] {
        export(&mut window, &path);
        window.get_by_label("history.csv already exists. Replace it?");
        press(&mut window, &[keep]);
        assert!(window.query_by_label_contains("Replace it?").is_none());
        assert_eq!(std::fs::read_to_string(&path).unwrap(), "mine");
        assert!(window.get_by_role_and_label(Role::TextInput, "File").is_focused(), "another name can be typed");
        press(&mut window, &[Key::Escape]);
    }
    export(&mut window, &path);
    click(&mut window, Role::Button, "Replace");
    assert!(std::fs::read_to_string(&path).unwrap().contains("25.012"));
    window.get_by_label_contains("history.csv was written to");
}

#[test]
fn a_proposed_name_is_written_in_the_last_folder() {
    let folder = tempfile::tempdir().unwrap();
    let mut window = at_home(folder.path());
    check(&mut window, "25 H7", "25.012");
    choose(&mut window, "Export", "History as CSV…");
    press(&mut window, &[Key::Enter]);
    let folder = folder.path().display();
    window.get_by_label(&format!("25H7-2026-11-21.csv was written to {folder}"));
}

#[test]
fn a_written_file_can_be_opened_and_shown_and_a_failure_is_told() {
    let folder = tempfile::tempdir().unwrap();
    let mut window = window();
    check(&mut window, "25 H7", "25.012");
    export(&mut window, &folder.path().join("history.csv"));
    for button in ["Open", "Show in folder"] {
        window.get_by_role_and_label(Role::Button, button).click();
        window.run();
        window.get_by_label_contains("the file cannot be opened");
        press(&mut window, &[Key::Escape]);
        window.get_by_label_contains("history.csv was written to");
    }
}

fn open_recent(window: &mut Harness<'_, App>) {
    for button in ["Menu", "Recent files"] {
        click(window, Role::Button, button);
    }
}

#[test]
fn a_recent_file_is_read_again_and_one_that_is_gone_is_told() {
    let folder = shop();
    let path = folder.path().join("more.csv");
    let store = fitcheck::gui::Store::at(&folder.path().join("state.toml"));
    let mut first = Window { store: store.clone(), ..Window::default() }.open();
    open_import(&mut first);
    type_path(&mut first, "File", &path);
    eframe::App::on_exit(first.state_mut(), None);
    let mut window = Window { store, ..Window::default() }.open();
    open_recent(&mut window);
    click(&mut window, Role::Button, "more.csv");
    assert!(verdict(&window).starts_with("REWORK. 24.998 mm"), "{}", verdict(&window));
    press(&mut window, &[Key::Escape]);
    std::fs::remove_file(&path).unwrap();
    open_recent(&mut window);
    click(&mut window, Role::Button, "more.csv");
    window.get_by_label_contains("no such file or folder");
    press(&mut window, &[Key::Escape]);
    assert!(window.state().session().recent_files().is_empty());
}

#[test]
fn the_window_is_started_with_files() {
    let folder = shop();
    let program = folder.path().join("bore.h");
    put(&program, "0 BEGIN PGM BORE MM\n1 END PGM BORE MM\n");
    let files: Vec<(Purpose, PathBuf)> =
        vec![(Purpose::Import, folder.path().join("more.csv")), (Purpose::OpenProgram, program)];
    let mut window = Window { files, ..Window::default() }.open();
    window.get_by_label_contains("BEGIN PGM BORE MM");
    window.key_press_modifiers(eframe::egui::Modifiers::COMMAND, Key::Num1);
    window.run();
    assert!(verdict(&window).starts_with("REWORK. 24.998 mm"), "{}", verdict(&window));
}

/// A window that used own tables the last time, in which H7 ends at +10 µm, and is started with these files.
fn with_own_tables(folder: &Path, is_there: bool, files: Vec<(Purpose, PathBuf)>) -> Harness<'static, App> {
    let tables = folder.join("own");
    if is_there {
        std::fs::create_dir(&tables).unwrap();
        put(
            &tables.join("own.tab"),
            "BEGIN own.tab MM\r\nNR   BEREICH H7\r\n0    30      +10\r\n1            +0\r\n[END]\r\n",
        );
    }
    let state = folder.join("state.toml");
    put(&state, &format!("version = 1\nlanguage = \"en\"\ntables_folder = {:?}\n", tables.display().to_string()));
    Window { store: fitcheck::gui::Store::at(&state), files, ..Window::default() }.open()
}

fn judged(window: &Harness<'_, App>) -> Vec<String> {
    let checks = window.state().session().history().iter();
    checks.map(|check| format!("{} by {}", check.verdict.status(), check.limits.source)).collect()
}

#[test]
fn a_file_that_the_window_is_started_with_is_judged_by_the_own_tables() {
    for is_at_start in [true, false] {
        let folder = tempfile::tempdir().unwrap();
        let part = folder.path().join("part.csv");
        put(&part, "id,callout,measured\nA1,25 H7,25.015\n");
        let files = if is_at_start { vec![(Purpose::Import, part.clone())] } else { Vec::new() };
        let mut window = with_own_tables(folder.path(), true, files);
        if !is_at_start {
            let ctx = window.ctx.clone();
            window.state_mut().send(&ctx, FilesCommand::Open(Purpose::Import, part).into());
            window.run();
        }
        assert_eq!(judged(&window), ["SCRAP by table own.tab, over 0 up to 30 mm"], "at the start: {is_at_start}");
    }
}

#[test]
fn a_file_that_is_judged_without_the_own_tables_says_so() {
    let folder = tempfile::tempdir().unwrap();
    let part = folder.path().join("part.csv");
    put(&part, "id,callout,measured\nA1,25 H7,25.015\n");
    let window = with_own_tables(folder.path(), false, vec![(Purpose::Import, part)]);
    let judged = judged(&window);
    assert!(judged.len() == 1 && judged[0].starts_with("GOOD by ISO 286") && judged[0].ends_with("could not be read"));
    assert!(window.get_all_by_label_contains("own tables in").count() > 0, "the limits on screen say it too");
    assert!(verdict(&window).ends_with("Judged without your own tables"), "{}", verdict(&window));
}
