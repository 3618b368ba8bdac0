//! The reports page by label and key: what is reported, templates, the pages as they will print, saving.

use eframe::egui::accesskit::Role;
use eframe::egui::{Key, Modifiers};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use fitcheck::gui::App;
use fitcheck::report::paper::Paper;
use fitcheck::session::{CheckField, Command, Field, Page, ReportOf, ReportsCommand};
use fitcheck::words::Language;

use crate::harness::{Window, click, press, type_into};

fn send(window: &mut Harness<'_, App>, command: impl Into<Command>) {
    let ctx = window.ctx.clone();
    window.state_mut().send(&ctx, command.into());
    window.run();
}

/// The page after a value was judged.
fn page() -> Harness<'static, App> {
    let mut window = Window::default().open();
    send(&mut window, Field::from(CheckField::Callout).typed("25 H7".to_owned()));
    send(&mut window, Field::from(CheckField::Measured).typed("25.012".to_owned()));
    send(&mut window, Command::Enter(CheckField::Measured.into()));
    send(&mut window, Command::OpenPage(Page::Reports));
    window
}

/// What is heard of the page in sight.
fn heard(window: &Harness<'_, App>) -> String {
    window.get_by_role(Role::Document).accesskit_node().label().unwrap_or_default()
}

#[test]
fn the_pages_are_shown_as_they_will_print() {
    let window = page();
    let heard = heard(&window);
    for said in ["Page of the report: Inspection report", "GOOD", "25 H7", "25.012"] {
        assert!(heard.contains(said), "{said}: {heard}");
    }
    assert!(window.query_by_label("Page 1 of 1").is_some());
}

#[test]
fn a_template_is_chosen_by_its_name_and_the_pages_follow() {
    let mut window = page();
    click(&mut window, Role::RadioButton, "Certificate, Values and statement of conformity");
    let certificate = heard(&window);
    assert!(certificate.contains("Statement of conformity: the value"), "{certificate}");
    type_into(&mut window, "Customer", "Northgate");
    assert!(heard(&window).contains("Northgate"), "{}", heard(&window));
    click(&mut window, Role::CheckBox, "Statement of conformity");
    assert!(!heard(&window).contains("Statement of conformity"), "{}", heard(&window));
}

#[test]
fn language_and_paper_are_those_of_the_report_alone() {
    let mut window = page();
    let german = Language::all().find(|language| language.code() == "de");
    send(&mut window, ReportsCommand::Language(german));
    assert!(heard(&window).contains("Page of the report: Prüfbericht"), "{}", heard(&window));
    send(&mut window, ReportsCommand::Paper(Some(Paper::Letter)));
    let pages = window.state().session().reports().pages();
    assert_eq!(pages.and_then(Result::ok).map(|pages| pages.size()), Some([612.0, 792.0]));
}

#[test]
fn the_keys_of_the_page_turn_pages_and_save() {
    let mut window = page();
    window.key_press_modifiers(Modifiers::COMMAND, Key::S);
    window.run();
    let dialog = window.state().session().dialog().map(|dialog| dialog.path.clone()).unwrap_or_default();
    assert_eq!(std::path::Path::new(&dialog).extension(), Some("pdf".as_ref()), "{dialog}");
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("bore.pdf");
    type_into(&mut window, "File", &file.display().to_string());
    press(&mut window, Key::Enter);
    assert!(std::fs::read(file).unwrap().starts_with(b"%PDF-1.7"));
}

#[test]
fn pages_are_turned_by_button_and_by_key() {
    let mut window = page();
    send(&mut window, Command::OpenPage(Page::Check));
    for value in 0..60 {
        send(&mut window, Field::from(CheckField::Measured).typed(format!("25.0{:02}", value % 20)));
        send(&mut window, Command::Enter(CheckField::Measured.into()));
    }
    send(&mut window, Command::OpenPage(Page::Reports));
    send(&mut window, ReportsCommand::Of(ReportOf::List));
    let count = window.state().session().reports().pages().and_then(Result::ok).map_or(0, |pages| pages.count());
    assert!(1 < count);
    click(&mut window, Role::Button, "Next page");
    assert!(window.query_by_label(&format!("Page 2 of {count}")).is_some());
    press(&mut window, Key::PageUp);
    assert!(window.query_by_label(&format!("Page 1 of {count}")).is_some());
}

#[test]
fn without_a_value_there_is_nothing_to_report_and_nothing_to_save() {
    let mut window = Window::default().open();
    send(&mut window, Command::OpenPage(Page::Reports));
    assert!(window.query_by_role(Role::Document).is_none());
    assert!(window.get_by_role_and_label(Role::Button, "Save PDF…").accesskit_node().is_disabled());
    assert!(window.get_all_by_label_contains("Judge a value").next().is_some());
}

#[test]
fn what_is_reported_is_chosen_among_what_there_is() {
    let window = page();
    for (name, is_possible) in [("The last verdict", true), ("The part being measured", false)] {
        let choice = window.get_by_role_and_label(Role::RadioButton, name);
        assert_eq!(!choice.accesskit_node().is_disabled(), is_possible, "{name}");
    }
}

#[test]
fn a_label_is_saved_as_a_picture_and_a_page_is_not() {
    let mut window = page();
    assert!(window.query_by_role_and_label(Role::Button, "PNG…").is_none());
    send(&mut window, ReportsCommand::Template("report-template-label".to_owned()));
    assert!(window.query_by_role_and_label(Role::Button, "PNG…").is_some());
    assert!(window.query_by_role_and_label(Role::Button, "New template").is_some());
}

#[test]
fn an_earlier_report_is_chosen_and_what_changed_stands_on_the_first_page() {
    let mut window = page();
    let folder = tempfile::tempdir().unwrap();
    let [earlier, text] = ["earlier.pdf", "notes.json"].map(|name| folder.path().join(name));
    click(&mut window, Role::Button, "Save PDF…");
    type_into(&mut window, "File", &earlier.display().to_string());
    press(&mut window, Key::Enter);
    send(&mut window, Command::OpenPage(Page::Check));
    send(&mut window, Field::from(CheckField::Measured).typed("24.998".to_owned()));
    send(&mut window, Command::Enter(CheckField::Measured.into()));
    send(&mut window, Command::OpenPage(Page::Reports));
    send(&mut window, ReportsCommand::Of(ReportOf::Check));
    let compare = |window: &mut Harness<'_, App>, file: &std::path::Path| {
        click(window, Role::Button, "Compare with a report…");
        type_into(window, "File", &file.display().to_string());
        press(window, Key::Enter);
    };
    compare(&mut window, &earlier);
    assert!(heard(&window).contains("25 H7: GOOD → REWORK"), "{}", heard(&window));
    assert!(window.query_by_label_contains("Says what changed since earlier.pdf of").is_some());
    std::io::Write::write_all(&mut std::fs::File::create(&text).unwrap(), b"{}").unwrap();
    compare(&mut window, &text);
    assert!(window.get_all_by_label_contains("notes.json is no report to compare with").next().is_some());
    press(&mut window, Key::Escape);
    assert!(heard(&window).contains("25 H7: GOOD → REWORK"), "a refused file changes nothing");
    click(&mut window, Role::Button, "Do not compare");
    assert!(!heard(&window).contains("GOOD → REWORK"), "{}", heard(&window));
}
