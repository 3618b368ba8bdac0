//! The budget as a table: what is changed there changes the text, and the other way round.

use std::path::Path;

use eframe::egui::Key;
use eframe::egui::accesskit::Role;
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use fitcheck::gui::App;
use fitcheck::session::{BudgetCommand, Command, FilesCommand, Page, Purpose};

use crate::harness::{Window, click, press, type_into, verdict};

type Harnessed = Harness<'static, App>;

fn send(window: &mut Harnessed, command: impl Into<Command>) {
    let ctx = window.ctx.clone();
    window.state_mut().send(&ctx, command.into());
    window.run();
}

/// The page with a budget of the samples, as a table.
fn with(name: &str) -> Harnessed {
    let mut page = Window::default().open();
    send(&mut page, Command::OpenPage(Page::Budget));
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/corpus/inputs").join(name);
    send(&mut page, FilesCommand::Open(Purpose::OpenBudget, path));
    page
}

fn text(page: &Harnessed) -> String {
    page.state().session().budget().document.text.clone()
}

/// Opens or closes a contribution by its row.
fn press_row(page: &mut Harnessed, begins: &str) {
    let row =
        page.get_by(|node| node.role() == Role::Button && node.label().is_some_and(|label| label.starts_with(begins)));
    row.scroll_to_me();
    page.run();
    page.get_by(|node| node.role() == Role::Button && node.label().is_some_and(|label| label.starts_with(begins)))
        .click();
    page.run();
}

fn choose(page: &mut Harnessed, list: &str, choice: &str) {
    page.get_by_role_and_label(Role::ComboBox, list).scroll_to_me();
    page.run();
    page.get_by_role_and_label(Role::ComboBox, list).click();
    page.run();
    page.get_by(|node| node.label().is_some_and(|label| label == choice) && node.role() == Role::Button).click();
    page.run();
}

#[test]
fn a_figure_typed_in_the_table_stands_in_the_text_and_changes_the_answer() {
    let mut page = with("station3.toml");
    let before = text(&page);
    assert!(verdict(&page).contains("U = 1.922 µm"), "{}", verdict(&page));
    press_row(&mut page, "Geometry of the machine");
    type_into(&mut page, "Half width", "2,0");
    assert_eq!(text(&page), before.replace("half_width_um = 1.0", "half_width_um = 2.0"));
    // The law is rectangular: 2/√3 = 1.155 with 0.5, 0.5 and 0.2875 is u = 1.384, as `fitcheck budget` has it.
    assert!(!verdict(&page).contains("U = 1.922 µm"), "{}", verdict(&page));
    click(&mut page, Role::RadioButton, "Text");
    let shown = page.get_by_role_and_label(Role::MultilineTextInput, "Budget as TOML");
    assert!(shown.accesskit_node().value().unwrap_or_default().contains("half_width_um = 2.0"));
}

#[test]
fn what_is_typed_in_the_text_stands_in_the_table() {
    let mut page = with("station3.toml");
    let new = text(&page).replace("Setting ring", "Gauge ring");
    send(&mut page, BudgetCommand::Edit(new));
    press_row(&mut page, "Gauge ring");
    assert_eq!(
        page.get_by_role_and_label(Role::TextInput, "Name").accesskit_node().value().as_deref(),
        Some("Gauge ring")
    );
}

#[test]
fn a_contribution_is_added_given_another_kind_and_removed() {
    let mut page = with("station3.toml");
    let before = text(&page);
    click(&mut page, Role::Button, "Add contribution");
    assert!(text(&page).ends_with(
        "\n[[contribution]]\nname = \"New contribution\"\ntype = \"B\"\nlaw = \"rectangular\"\nhalf_width_um = 1.0\n"
    ));
    choose(&mut page, "Counts for", "Temperature of the scales");
    assert!(
        text(&page).ends_with(
            "law = \"rectangular\"\nhalf_width_k = 1.0\nkind = \"scale-temperature\"\nalpha_per_k = 11.5e-6\n"
        )
    );
    choose(&mut page, "Law", "Normal law");
    choose(&mut page, "Given as", "Expanded uncertainty");
    assert!(text(&page).contains("law = \"normal\"\nexpanded_k = 1.0\n") && text(&page).ends_with("\nk = 2\n"));
    assert!(verdict(&page).starts_with("Expanded uncertainty"), "every change is a budget: {}", verdict(&page));
    click(&mut page, Role::Button, "Remove contribution");
    assert_eq!(text(&page), before);
}

#[test]
fn a_contribution_that_is_removed_is_named_and_takes_its_comments_with_it() {
    let mut page = with("station3.toml");
    let commented = text(&page).replace("name = \"Setting ring\"", "# Certificate 4711\nname = \"Setting ring\"");
    send(&mut page, BudgetCommand::Edit(commented));
    press_row(&mut page, "Setting ring");
    click(&mut page, Role::Button, "Remove contribution");
    assert!(!text(&page).contains("Setting ring") && !text(&page).contains("4711"));
    page.get_by_label("Contribution “Setting ring” removed from the budget");
    assert!(page.state().session().notices().first().unwrap().details.is_empty());
}

#[test]
fn a_figure_that_is_no_number_says_so_beside_its_field_and_no_answer_stays() {
    let mut page = with("station3.toml");
    press_row(&mut page, "Geometry of the machine");
    type_into(&mut page, "Half width", "-1");
    assert_eq!(verdict(&page), "No answer");
    page.get_by_role_and_label(Role::TextInput, "Half width");
    assert!(1 < page.get_all_by_label_contains("half_width_um").count(), "with its place, and beside the field");
    type_into(&mut page, "Half width", "1");
    assert!(verdict(&page).contains("U = 1.922 µm"), "{}", verdict(&page));
}

#[test]
fn a_faulty_text_keeps_the_table_as_it_was_and_nothing_in_it_can_be_pressed() {
    let mut page = with("station3.toml");
    let faulty = text(&page).replace("by = ", "by ");
    send(&mut page, BudgetCommand::Edit(faulty.clone()));
    page.get_by_label("The text has a fault: the table shows the contributions as they last were");
    page.get_by_label_contains("line ");
    let row = page.get_by(|node| node.label().is_some_and(|label| label.starts_with("Geometry of the machine")));
    assert!(row.accesskit_node().is_disabled());
    let add = page.get_by_role_and_label(Role::Button, "Add contribution");
    assert!(add.accesskit_node().is_disabled());
    send(&mut page, BudgetCommand::Choose(Some(0)));
    send(&mut page, BudgetCommand::Remove);
    assert_eq!(text(&page), faulty);
    press(&mut page, Key::Escape);
}
