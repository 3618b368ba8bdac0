//! Questions and Enter in the window; what is recorded of a file; what is exported; a budget that is nobody's yet.

use fitcheck::session::{BudgetAction, WalkField};
use std::path::Path;
use std::process::Command as Process;

use eframe::egui::accesskit::Role;
use eframe::egui::{Key, Modifiers};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use fitcheck::gui::App;
use fitcheck::journal::ask::Question;
use fitcheck::journal::entry::About;
use fitcheck::session::{BudgetCommand, CheckField, Command};
use fitcheck::store::local::Reader;
use fitcheck::tolerance::Feature;

use crate::harness::{DESK, check, click, press, scan, type_into, verdict, wait, window};
use crate::walk_page::{begun, drop_file, put, window_of};

type Harnessed = Harness<'static, App>;

#[expect(clippy::redundant_closure_for_method_calls, reason = "the method alone is not general over lifetimes")]
fn focused(window: &Harnessed) -> String {
    window.get_by(|node| node.is_focused()).accesskit_node().label().unwrap_or_default()
}

fn text(window: &Harnessed, field: CheckField) -> String {
    window.state().session().text(field).to_owned()
}

#[test]
fn enter_takes_what_is_highlighted_and_not_what_was_mistyped() {
    let mut window = window();
    check(&mut window, "25 H7", "2501");
    assert!(verdict(&window).starts_with("Is this right?"), "{}", verdict(&window));
    window.get_by_role_and_label(Role::Button, "Use 25.010 mm");
    wait(600);
    press(&mut window, Key::Enter);
    assert!(verdict(&window).starts_with("GOOD. 25.010 mm"), "{}", verdict(&window));
    assert_eq!(focused(&window), "Measured value");
    window.get_by_label("1 check");
}

#[test]
fn the_second_sign_at_the_end_of_a_line_answers_nothing() {
    let mut window = window();
    scan(&mut window, "25 H7⇥2501⏎");
    wait(20);
    scan(&mut window, "⏎");
    assert!(verdict(&window).starts_with("Is this right?"), "{}", verdict(&window));
    // And it records no value twice.
    type_into(&mut window, "Measured value", "25.01");
    wait(600);
    scan(&mut window, "⏎⏎");
    window.get_by_label("1 check");
    window.get_by_label("Judged already. To judge the same value again, type it again or press the button");
    assert!(verdict(&window).starts_with("GOOD. 25.010 mm"), "{}", verdict(&window));
}

#[test]
fn a_line_that_is_typed_in_one_go_chooses_neither_hole_nor_shaft_and_loses_no_value() {
    let mut window = window();
    scan(&mut window, "25 +0.021 0⇥25.012⏎");
    assert_eq!(window.state().session().check().feature(), None);
    assert_eq!((text(&window, CheckField::Measured).as_str(), focused(&window).as_str()), ("25.012", "Measured value"));
    assert!(verdict(&window).starts_with("GOOD. 25.012 mm"), "{}", verdict(&window));
    // Enter on the choice is none.
    press(&mut window, Key::Tab);
    assert_eq!(focused(&window), "Hole");
    press(&mut window, Key::Enter);
    assert_eq!(window.state().session().check().feature(), None);
    press(&mut window, Key::Space);
    assert_eq!(window.state().session().check().feature(), Some(Feature::Hole));
    assert_eq!(focused(&window), "Measured value");
    press(&mut window, Key::Enter);
    assert!(verdict(&window).starts_with("GOOD. 25.012 mm"), "{}", verdict(&window));
    // The next one is of neither again.
    type_into(&mut window, "Callout", "40 0 -0.025");
    assert_eq!(window.state().session().check().feature(), None);
    window.get_by_role_and_label(Role::RadioButton, "Shaft").click();
    window.run();
    assert_eq!(focused(&window), "Measured value");
}

#[test]
fn a_serial_number_that_is_scanned_while_a_part_is_measured_is_no_value() {
    let folder = tempfile::tempdir().unwrap();
    let mut page = begun(folder.path());
    scan(&mut page, "A-0099⏎");
    let session = page.state().session();
    assert_eq!(session.text(WalkField::Value), "");
    assert!(!session.error(WalkField::Value).unwrap().to_string().contains("is not a number"));
    // In the same frame as the key that ends the part.
    let key = |key, pressed| eframe::egui::Event::Key {
        key,
        physical_key: None,
        pressed,
        repeat: false,
        modifiers: Modifiers::NONE,
    };
    let ends = [(Key::F8, true), (Key::F8, false), (Key::F8, true), (Key::F8, false)];
    page.input_mut().events.extend(ends.map(|(of, pressed)| key(of, pressed)));
    scan(&mut page, "B-7001⏎25.01⏎");
    let walking = &page.state().session().parts().walking;
    assert_eq!((walking.serial(), walking.values(0).len()), ("B-7001", 1));
}

#[test]
fn a_serial_number_that_is_scanned_when_the_part_is_done_begins_the_next_one() {
    let folder = tempfile::tempdir().unwrap();
    put(&folder.path().join("flange.csv"), "number;name;callout\n1;A;25 H7\n");
    let mut page = begun(folder.path());
    scan(&mut page, "25.01⏎");
    page.get_by_label("Every size has a value or is skipped");
    scan(&mut page, "A-0205⏎25.002⏎");
    let walking = &page.state().session().parts().walking;
    assert_eq!((walking.serial(), walking.values(0).len()), ("A-0205", 1));
}

#[test]
fn the_card_is_of_the_size_that_stands_beside_it() {
    let folder = tempfile::tempdir().unwrap();
    let mut page = begun(folder.path());
    assert!(verdict(&page).contains("BORE"), "{}", verdict(&page));
    type_into(&mut page, "Measured value", "25.03");
    press(&mut page, Key::Enter);
    // The verdict of the bore stands beside the bore, and the next size is named as the next.
    assert!(verdict(&page).starts_with("SCRAP. BORE: 25.030 mm"), "{}", verdict(&page));
    page.get_by_label("1  BORE");
    assert!(page.query_by_label("2  PIN").is_none());
    page.get_by_label("Next: 2 PIN, 20 g6");
    // Heading, limits, field and verdict speak of one size: the field is empty and shows its value.
    let field = page.get_by_role_and_label(Role::TextInput, "Measured value");
    assert_eq!(field.accesskit_node().placeholder().unwrap_or_default(), "25.030");
    // Once that is begun, the page is about it alone.
    type_into(&mut page, "Measured value", "1");
    page.get_by_label("2  PIN");
    assert!(page.query_by_label("Next: 2 PIN, 20 g6").is_none() && page.query_by_label("1  BORE").is_none());
    assert!(!verdict(&page).contains("SCRAP") && verdict(&page).contains("PIN"), "{}", verdict(&page));
}

/// What a journal says of its only check.
fn about(journal: &Path) -> About {
    let reader = Reader::open(journal).unwrap();
    let numbers = reader.numbers(&Question::default(), None, 10).unwrap();
    assert_eq!(numbers.len(), 1);
    let kept = reader.entry(numbers[0]).unwrap().unwrap();
    fitcheck::journal::body::read(&kept.body).unwrap().about
}

#[test]
fn an_import_keeps_part_serial_number_and_operator_as_the_command_line_does() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("one_part.csv");
    put(&file, "part;name;callout;measured;operator;serial\nP001;B2;12 H6;12.0028;JJ;S-7\n");
    let by_command = folder.path().join("command.sqlite");
    let run = Process::new(env!("CARGO_BIN_EXE_fitcheck"))
        .args(["import", "--record", "--journal"])
        .args([&by_command, &file])
        .output()
        .unwrap();
    assert!(run.status.success(), "{run:?}");
    let mut page = window_of(folder.path(), DESK).open();
    let ctx = page.ctx.clone();
    page.state_mut().send(&ctx, Command::OpenPage(fitcheck::session::Page::Check));
    page.run();
    drop_file(&mut page, file);
    let [window, command] = [folder.path().join("journal.sqlite"), by_command].map(|journal| about(&journal));
    let said = |about: &About| [&about.part, &about.feature, &about.who, &about.serial].map(Clone::clone);
    assert_eq!(said(&window), ["P001", "B2", "JJ", "S-7"]);
    assert_eq!(said(&window), said(&command));
}

#[test]
fn what_is_listed_is_what_is_exported() {
    let folder = tempfile::tempdir().unwrap();
    let mut window = window();
    for value in ["25.001", "25.002", "25.03"] {
        check(&mut window, "25 H7", value);
    }
    type_into(&mut window, "Filter", "scrap");
    click(&mut window, Role::Button, "Export");
    window.get_by_label("The 1 listed check of 3 will be exported");
    click(&mut window, Role::Button, "History as CSV…");
    let path = folder.path().join("listed.csv");
    type_into(&mut window, "File", path.to_str().unwrap());
    press(&mut window, Key::Enter);
    let written = std::fs::read_to_string(path).unwrap();
    assert!(written.lines().count() == 2 && written.contains("25.03"), "{written}");
}

#[test]
fn the_rows_of_a_large_file_are_not_exported_as_the_history() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("big.csv");
    let rows = usize::try_from(fitcheck::session::LARGE).unwrap() / 20;
    put(&path, &format!("id,callout,measured\n{}", "P0000001,25 H7,25.0100\n".repeat(rows)));
    let mut window = window();
    check(&mut window, "25 H7", "25.012");
    drop_file(&mut window, path);
    assert!(window.state().session().lists_rows());
    click(&mut window, Role::Button, "Menu");
    // The list has such a menu, too.
    window.get_all_by_role_and_label(Role::Button, "Export").last().unwrap().click();
    window.run();
    window.get_by_label_contains("listed rows of big.csv will be exported");
}

#[test]
fn a_budget_of_the_template_is_used_by_no_check() {
    let mut page = window();
    page.key_press_modifiers(Modifiers::COMMAND, Key::Num9);
    page.run();
    page.key_press_modifiers(Modifiers::COMMAND, Key::N);
    page.run();
    page.get_by_label_contains(
        "still those of the template: its name (“Station 1, probe 1”), who made it (“Who made it”), the figures",
    );
    assert!(!page.state().session().can(BudgetAction::UseBudget));
    let ctx = page.ctx.clone();
    type_into(&mut page, "Name of the budget", "Mill 3");
    type_into(&mut page, "Made by", "JJ");
    let named = page.state().session().budget().document.text.clone();
    assert!(named.contains("name = \"Mill 3\"") && named.contains("by = \"JJ\""), "{named}");
    page.get_by_label_contains("still those of the template: the figures of all contributions.");
    // Another name of a contribution is no other figure.
    let renamed = named.replace("name = \"Display\"", "name = \"Dial\"");
    page.state_mut().send(&ctx, BudgetCommand::Edit(renamed).into());
    page.run();
    page.get_by_label_contains("still those of the template: the figures of all contributions.");
    page.state_mut().send(&ctx, BudgetCommand::Edit(named.replace("standard_um = 0.5", "standard_um = 0.7")).into());
    page.run();
    assert!(page.state().session().can(BudgetAction::UseBudget));
}
