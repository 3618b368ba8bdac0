//! A study of a gauge through the window, by label and key: readings are opened, the layout is confirmed, figures, the budget.

use std::fmt::Write as _;
use std::path::Path;

use eframe::egui::accesskit::Role;
use eframe::egui::{Key, Modifiers, Vec2, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use fitcheck::gui::App;
use fitcheck::series::StudyKind;
use fitcheck::session::statistics::{StatisticsView, StudyCommand};
use fitcheck::session::{Command, Page, StatisticsCommand};
use fitcheck::words::Language;

use crate::dialogs::Dropped;
use crate::harness::{DESK, Window, click, press, rows, type_into};
use crate::pictures::can_paint;

/// Ten parts of 25 mm, read three times by three operators: parts scatter by 3 µm, a reading by 0.2 µm.
fn readings(columns: &str) -> String {
    let mut text = format!("{columns};measured [mm]\n");
    let parts = [0, 31, -24, 45, -38, 12, -9, 27, -45, 6];
    let steps = [0, 2, -2, 1, -1, 3, -3];
    for (part, off) in parts.iter().enumerate() {
        for (who, name) in ["Anna", "Ben", "Cleo"].iter().enumerate() {
            for repeat in 0..3 {
                let scatter = steps[(part * 5 + who * 3 + repeat * 2) % steps.len()];
                let nanometres = 25_000_000 + off * 100 + scatter * 100 + i32::try_from(who).unwrap() * 60;
                let mm = f64::from(nanometres) / 1e6;
                writeln!(text, "{};{name};{mm:.5}", part + 1).unwrap();
            }
        }
    }
    text
}

fn written(folder: &Path, name: &str, text: &str) -> String {
    let path = folder.join(name);
    fitcheck::files::write(&path, text.as_bytes()).unwrap();
    path.display().to_string()
}

/// The study on the page Statistics, with this file.
fn opened(size: Vec2, file: &str) -> Harness<'static, App> {
    let mut window = begun(size, Language::En);
    click(&mut window, Role::RadioButton, "Gauge study");
    window.key_press_modifiers(Modifiers::COMMAND, Key::O);
    window.run();
    type_into(&mut window, "File", file);
    press(&mut window, Key::Enter);
    window
}

fn begun(size: Vec2, language: Language) -> Harness<'static, App> {
    let mut window = Window { size, language, ..Window::default() }.open();
    send(&mut window, Command::OpenPage(Page::Statistics));
    window
}

fn send(window: &mut Harness<'_, App>, command: impl Into<Command>) {
    let ctx = window.ctx.clone();
    window.state_mut().send(&ctx, command.into());
    window.run();
}

/// Drops a file on the study, without a pointer that would be seen in a picture.
fn drop_file(window: &mut Harness<'_, App>, path: &Path) {
    send(window, StatisticsCommand::View(StatisticsView::Study));
    window.input_mut().dropped_files.push(std::sync::Arc::new(Dropped(path.to_owned())));
    window.run();
}

fn card(window: &Harness<'_, App>) -> String {
    window.get_by_role(Role::Status).accesskit_node().label().unwrap_or_default()
}

#[test]
fn a_study_is_opened_confirmed_and_answered_by_keys() {
    let folder = tempfile::tempdir().unwrap();
    let mut window = opened(DESK, &written(folder.path(), "study.csv", &readings("part;operator")));
    let said = card(&window);
    assert!(said.starts_with("How the file was understood. Crossed: 10 parts, 3 operators, 3 repeats"), "{said}");
    assert!(said.ends_with("Nothing is computed until you confirm this."), "{said}");
    type_into(&mut window, "Lower limit", "24.99");
    type_into(&mut window, "Upper limit", "25.01");
    press(&mut window, Key::Enter);
    let said = card(&window);
    assert!(
        said.starts_with("Is this gauge good enough?. ") || said.starts_with("Is this gauge good enough? "),
        "{said}"
    );
    assert!(
        said.contains("the gauge takes ") && said.contains("Smallest tolerance that it is good enough for: "),
        "{said}"
    );
    window.get_by_label("Share of the tolerance");
    // A limit that is typed over takes the answer away.
    type_into(&mut window, "Upper limit", "25.02");
    assert!(card(&window).starts_with("How the file was understood"), "{}", card(&window));
}

#[test]
fn a_swapped_layout_says_why_and_has_a_button_of_its_own() {
    let folder = tempfile::tempdir().unwrap();
    let mut window = opened(DESK, &written(folder.path(), "study.csv", &readings("operator;part")));
    assert!(card(&window).contains("are the columns of parts and operators swapped?"), "{}", card(&window));
    type_into(&mut window, "Lower limit", "24.99");
    press(&mut window, Key::Enter);
    assert!(card(&window).starts_with("How the file was understood"), "Enter confirms no doubt");
    click(&mut window, Role::Button, "Evaluate all the same");
    assert!(card(&window).starts_with("Is this gauge good enough?"), "{}", card(&window));
}

#[test]
fn a_dropped_file_with_a_missing_reading_names_it() {
    let folder = tempfile::tempdir().unwrap();
    let text = readings("part;operator");
    let text = text.trim_end().rsplit_once('\n').unwrap().0;
    written(folder.path(), "study.csv", text);
    let mut window = begun(DESK, Language::En);
    drop_file(&mut window, &folder.path().join("study.csv"));
    assert!(card(&window).contains("Readings of part 10 by operator Cleo: 2, expected 3"), "{}", card(&window));
    let evaluate = window.get_by_role_and_label(Role::Button, "Evaluate");
    assert!(evaluate.accesskit_node().is_disabled());
}

#[test]
fn the_scatter_is_saved_as_a_budget_and_opened_on_its_page() {
    let folder = tempfile::tempdir().unwrap();
    let mut window = opened(DESK, &written(folder.path(), "study.csv", &readings("part;operator")));
    // What was said of the file is read.
    press(&mut window, Key::Escape);
    click(&mut window, Role::Button, "Evaluate");
    click(&mut window, Role::Button, "Save as budget…");
    let budget = folder.path().join("gauge.toml");
    type_into(&mut window, "File", &budget.display().to_string());
    press(&mut window, Key::Enter);
    let text = std::fs::read_to_string(&budget).unwrap();
    assert!(text.starts_with("name = \"study.csv\"\ndate = 2026-11-21\n") && text.contains("type = \"A\""), "{text}");
    click(&mut window, Role::Button, "Open in Uncertainty");
    assert_eq!(window.state().session().page(), Page::Budget);
    assert!(
        rows(&window).iter().any(|row| row.starts_with("repeatability, crossed study, type A")),
        "{:?}",
        rows(&window)
    );
}

#[test]
fn every_field_of_every_kind_is_heard_by_its_name() {
    let folder = tempfile::tempdir().unwrap();
    let mut window = opened(DESK, &written(folder.path(), "study.csv", &readings("part;operator")));
    for (kind, names) in [
        ("Type 1", &["Lower limit", "Upper limit", "Calibrated size", "Step of the display"][..]),
        ("Nested", &["Lower limit", "Upper limit"]),
        ("Linearity", &["Calibrated size"]),
        ("Stability", &["Lower limit", "Upper limit", "Calibrated size"]),
    ] {
        click(&mut window, Role::RadioButton, kind);
        for name in names {
            window.get_by_role_and_label(Role::TextInput, name);
        }
    }
}

/// A study that is evaluated, for the manual.
pub fn evaluated() -> Harness<'static, App> {
    let folder = tempfile::tempdir().unwrap();
    written(folder.path(), "study.csv", &readings("part;operator"));
    let mut window = begun(DESK, Language::En);
    drop_file(&mut window, &folder.path().join("study.csv"));
    type_into(&mut window, "Lower limit", "24.99");
    type_into(&mut window, "Upper limit", "25.01");
    press(&mut window, Key::Enter);
    press(&mut window, Key::Escape);
    window
}

#[test]
fn a_stability_study_in_a_small_window_in_another_language() {
    if can_paint("study_small_de") {
        let folder = tempfile::tempdir().unwrap();
        let text =
            (0..40).fold("measured [mm]\n".to_owned(), |text, at| format!("{text}10.00{:02}\n", 20 + at * 7 % 11));
        written(folder.path(), "ring.csv", &text);
        let mut window = begun(vec2(1024.0, 768.0), Language::from_code("de").unwrap());
        drop_file(&mut window, &folder.path().join("ring.csv"));
        send(&mut window, StatisticsCommand::Study(StudyCommand::SetKind(StudyKind::Stability)));
        send(&mut window, StatisticsCommand::Study(StudyCommand::Evaluate { all_the_same: false }));
        press(&mut window, Key::Escape);
        window.snapshot("study_small_de");
    }
}
