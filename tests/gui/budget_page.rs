//! The budget page: a budget is begun, edited as text, evaluated, used and saved, by label and key.

use std::path::{Path, PathBuf};
use std::time::Duration;

use eframe::egui::accesskit::{Live, Role};
use eframe::egui::{Key, Modifiers, Theme, Vec2, ViewportCommand, ViewportEvent, ViewportId, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use fitcheck::gui::App;
use fitcheck::session::{BudgetCommand, BudgetView, CheckCommand, Command, Density, FilesCommand, Page, Purpose};
use fitcheck::verdict::rules::RuleName;
use fitcheck::words::Language;

use crate::dialogs::Dropped;
use crate::harness::{DESK, Window, check, click, press, rows, type_into, verdict};
use crate::pictures::can_paint;

type Harnessed = Harness<'static, App>;

const TEXT: &str = "Budget as TOML";

fn sample(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/corpus/inputs").join(name)
}

fn send(window: &mut Harnessed, command: impl Into<Command>) {
    let ctx = window.ctx.clone();
    window.state_mut().send(&ctx, command.into());
    window.run();
}

/// The page, opened by its key, with the budget as text.
fn open(window: Window) -> Harnessed {
    let mut page = window.open();
    page.key_press_modifiers(Modifiers::COMMAND, Key::Num9);
    page.run();
    send(&mut page, BudgetCommand::Show(BudgetView::Text));
    page
}

/// The page with a budget of the samples.
fn with(window: Window, name: &str) -> Harnessed {
    let mut page = open(window);
    send(&mut page, FilesCommand::Open(Purpose::OpenBudget, sample(name)));
    page
}

fn text(page: &Harnessed) -> String {
    page.get_by_role_and_label(Role::MultilineTextInput, TEXT).accesskit_node().value().unwrap_or_default()
}

/// Types at the end of the text.
fn append(page: &mut Harnessed, more: &str) {
    page.get_by_role_and_label(Role::MultilineTextInput, TEXT).focus();
    page.run();
    page.key_press_modifiers(Modifiers::COMMAND, Key::End);
    page.get_by_role_and_label(Role::MultilineTextInput, TEXT).type_text(more);
    page.run();
}

fn description(page: &Harnessed, figure: &str) -> String {
    let node = page.get_by_role_and_label(Role::Image, figure);
    node.accesskit_node().data().description().unwrap_or_default().to_owned()
}

#[test]
fn a_new_budget_is_begun_by_key_and_says_its_answer() {
    let mut page = open(Window::default());
    page.get_by_label("Create a new budget, or open one");
    assert_eq!(verdict(&page), "No answer");
    page.key_press_modifiers(Modifiers::COMMAND, Key::N);
    page.run();
    assert!(text(&page).contains("date = 2026-11-21\n") && text(&page).contains("valid_until = 2027-11-20\n"));
    let said = verdict(&page);
    assert!(
        said.starts_with("Expanded uncertainty. U = 1.920 µm.") && said.ends_with("Valid until 2027-11-20"),
        "{said}"
    );
    let status = page.get_by_role(Role::Status);
    assert_eq!(status.accesskit_node().data().live(), Some(Live::Polite));
    assert_eq!(rows(&page).len(), 8, "one of each kind");
}

#[test]
fn the_table_and_the_bars_are_said_in_words() {
    let page = with(Window::default(), "station3.toml");
    assert_eq!(
        verdict(&page),
        "Expanded uncertainty. U = 1.922 µm. k = 2.008 for 95.45 %. For 25 mm; each check has the uncertainty of its own size. \
         Valid until 2999-01-14",
        "as `fitcheck budget station3.toml --size 25` has it"
    );
    assert_eq!(
        rows(&page),
        [
            "Scatter of a touch, type A, normal, u 0.500 µm, sensitivity 1.0000, contribution 0.500 µm, share 27.3 %, degrees of freedom 24.0",
            "Setting ring, type B, normal, u 0.500 µm, sensitivity 1.0000, contribution 0.500 µm, share 27.3 %, degrees of freedom infinite",
            "Temperature of the part, type B, normal, u 1.000 K, sensitivity 0.2875, contribution 0.287 µm, share 9.0 %, degrees of freedom infinite",
            "Geometry of the machine, type B, rectangular, u 0.577 µm, sensitivity 1.0000, contribution 0.577 µm, share 36.4 %, degrees of freedom infinite",
        ]
    );
    assert_eq!(
        description(&page, "Shares of the variance"),
        "Geometry of the machine 36.4 %, Scatter of a touch 27.3 %, Setting ring 27.3 %, Temperature of the part 9.0 %."
    );
    page.get_by_label("Geometry of the machine, 36.4 % of the variance");
    page.get_by_label_contains("Half of it: u = 0.8");
}

#[test]
fn an_error_shows_with_line_and_column_and_no_answer_stays_beside_it() {
    let mut page = with(Window::default(), "station3.toml");
    append(&mut page, "half_width = 1\n");
    page.get_by_label_contains("line 36, column 1: unknown field `half_width`");
    assert_eq!(verdict(&page), "No answer");
    assert!(page.query_by_role_and_label(Role::Image, "Shares of the variance").is_none());
    assert_eq!(rows(&page), [""; 0]);
    let node = page.get_by_role_and_label(Role::MultilineTextInput, TEXT);
    let said = node.accesskit_node().data().description().unwrap_or_default().to_owned();
    assert!(said.starts_with("line 36, column 1"), "{said}");
    page.get_by_label("station3.toml, not saved");
    // Undo of the text itself, not of the history.
    page.key_press_modifiers(Modifiers::COMMAND, Key::Z);
    page.run();
    assert!(verdict(&page).contains("U = 1.922 µm"), "{}", verdict(&page));
}

#[test]
fn fields_change_the_answer_and_have_their_errors_beside_them() {
    let mut page = with(Window::default(), "station3.toml");
    type_into(&mut page, "Number of contacts", "3");
    page.get_by_label_contains("give both the number of contacts and the step");
    assert_eq!(verdict(&page), "No answer");
    type_into(&mut page, "Step", "60");
    assert!(verdict(&page).contains("U = 3."), "{}", verdict(&page));
    page.get_by_label_contains("3 contacts evenly spaced around the full circle: u = 1.0");
    type_into(&mut page, "Day", "2999-01-15");
    assert!(verdict(&page).ends_with("EXPIRED. valid until 2999-01-14, on 2999-01-15"), "{}", verdict(&page));
    type_into(&mut page, "Day", "15.01.2999");
    page.get_by_label_contains("15.01.2999 is not a day");
    type_into(&mut page, "Day", "2001-01-14");
    assert!(verdict(&page).contains("NOT YET VALID. valid from 2001-01-15"), "{}", verdict(&page));
    type_into(&mut page, "Measured size", "-1");
    page.get_by_label_contains("1 is not above 0");
}

#[test]
fn contacts_of_the_shown_check_are_taken() {
    let mut page = with(Window::default(), "station3.toml");
    let button = page.get_by_role_and_label(Role::Button, "From the shown check");
    assert!(button.accesskit_node().is_disabled(), "no check has contacts");
    send(&mut page, Command::OpenPage(Page::Check));
    click(&mut page, Role::RadioButton, "Simulate");
    type_into(&mut page, "Callout", "25 H7");
    press(&mut page, Key::Enter);
    send(&mut page, Command::OpenPage(Page::Budget));
    click(&mut page, Role::Button, "From the shown check");
    page.get_by_label("4 contacts of the check 25 H7, 10:42:07, simulated");
    click(&mut page, Role::Button, "From the budget");
    assert!(page.query_by_label_contains("contacts of the check").is_none());
}

#[test]
fn a_budget_is_saved_and_used_for_checks() {
    let folder = tempfile::tempdir().unwrap();
    let mut page = open(Window { home: Some(folder.path().to_owned()), ..Window::default() });
    page.get_by_label("Checks use no budget");
    click(&mut page, Role::Button, "New budget");
    // The template's own words and figures are nobody's.
    let own = [("Station 1, probe 1", "Mill 3"), ("Who made it", "JJ"), ("standard_um = 0.5", "standard_um = 0.7")];
    let own = own.into_iter().fold(text(&page), |text, (from, to)| text.replace(from, to));
    send(&mut page, BudgetCommand::Edit(own));
    append(&mut page, "# ours\n");
    page.key_press_modifiers(Modifiers::COMMAND, Key::S);
    page.run();
    page.key_press(Key::Enter);
    page.run();
    page.get_by_label_contains("was written to");
    click(&mut page, Role::Button, "Close");
    let written = std::fs::read_to_string(folder.path().join("budget.toml")).unwrap();
    assert!(written.ends_with("# ours\n"), "{written}");
    click(&mut page, Role::Button, "Use for checks");
    page.get_by_label("“Mill 3” is chosen, but no rule on Check uses an uncertainty yet: choose the rule there");
    send(&mut page, CheckCommand::UseRule(RuleName::Iso14253Of2017));
    page.get_by_label("In use: Mill 3");
    append(&mut page, "# more\n");
    page.get_by_label("In use: Mill 3");
    append(&mut page, "[[contribution]]\nname = \"More\"\ntype = \"B\"\nlaw = \"normal\"\nstandard_um = 1\n");
    page.get_by_label("In use: Mill 3 from budget.toml, which differs from what is shown here");
    click(&mut page, Role::Button, "Stop using");
    page.get_by_label("Checks use no budget");
}

#[test]
fn changes_are_asked_about_before_another_budget_is_opened_and_when_the_window_closes() {
    let mut page = with(Window::default(), "station3.toml");
    append(&mut page, "# changed\n");
    click(&mut page, Role::Button, "New budget");
    page.get_by_label("Discard the changes?");
    page.get_by_label("station3.toml has unsaved changes.");
    // The safe answer has the focus.
    press(&mut page, Key::Enter);
    assert!(text(&page).ends_with("# changed\n"));
    click(&mut page, Role::Button, "New budget");
    press(&mut page, Key::Escape);
    assert!(text(&page).ends_with("# changed\n"));
    let info = page.input_mut().viewports.entry(ViewportId::ROOT).or_default();
    info.events.push(ViewportEvent::Close);
    page.step();
    let commands = page.output().viewport_output[&ViewportId::ROOT].commands.clone();
    assert!(commands.contains(&ViewportCommand::CancelClose), "{commands:?}");
    page.input_mut().viewports.entry(ViewportId::ROOT).or_default().events.clear();
    page.run();
    page.get_by_label("Close Fitcheck?");
    page.get_by_label("Not saved: station3.toml");
    click(&mut page, Role::Button, "Keep working");
    click(&mut page, Role::Button, "New budget");
    click(&mut page, Role::Button, "Discard changes");
    assert!(text(&page).contains("Station 1"));
}

#[test]
fn a_calibrated_piece_takes_readings_from_the_history() {
    let mut page = with(Window::default(), "ring30.toml");
    assert_eq!(
        page.get_all_by_label("20 readings in the budget").count(),
        2,
        "where they are asked for, and where they are shown"
    );
    let said = description(&page, "Terms and expanded uncertainty");
    assert!(said.contains("u_cal 0.300 µm, u_p 0.") && said.contains("U, 2011, corrected"), "{said}");
    send(&mut page, Command::OpenPage(Page::Check));
    for measured in ["30.0021", "30.0024", "30.0019"] {
        check(&mut page, "30 H7", measured);
    }
    send(&mut page, Command::OpenPage(Page::Budget));
    click(&mut page, Role::Button, "From the history");
    assert_eq!(page.get_all_by_label("3 readings: all checks of the history").count(), 2);
    page.get_by_label("3 readings of the calibrated piece: ISO 15530-3 asks for at least 20");
    click(&mut page, Role::Button, "From the budget");
    assert_eq!(
        page.get_all_by_label("20 readings in the budget").count(),
        2,
        "where they are asked for, and where they are shown"
    );
}

#[test]
fn a_dropped_file_is_a_budget_or_readings() {
    let mut page = open(Window::default());
    let drop = |page: &mut Harnessed, path: PathBuf| {
        page.input_mut().dropped_files.push(std::sync::Arc::new(Dropped(path)));
        page.run();
    };
    drop(&mut page, sample("ring30.toml"));
    assert_eq!(
        page.get_all_by_label("20 readings in the budget").count(),
        2,
        "where they are asked for, and where they are shown"
    );
}

#[test]
fn what_is_pressed_is_high_enough_for_fingers() {
    for name in ["station3.toml", "ring30.toml"] {
        let mut page = with(Window::default(), name);
        send(&mut page, Command::SetDensity(Density::Touch));
        for role in [Role::Button, Role::TextInput] {
            for node in page.query_all_by_role(role) {
                let (said, rect) = (node.accesskit_node().label().unwrap_or_default(), node.rect());
                assert!(43.5 <= rect.height(), "{name}: {said} {rect:?}");
            }
        }
    }
}

#[test]
fn the_settled_page_asks_for_no_repaint() {
    let mut page = with(Window::default(), "station3.toml");
    // A cursor that blinks would ask for one.
    click(&mut page, Role::Button, "Use for checks");
    page.run();
    let delay = page.output().viewport_output[&ViewportId::ROOT].repaint_delay;
    assert_eq!(delay, Duration::MAX);
}

#[test]
fn nothing_lies_beside_a_small_window() {
    for (size, language, name) in [
        (vec2(1024.0, 600.0), Language::En, TEXT),
        (vec2(1024.0, 600.0), Language::Nl, "Budget als TOML"),
        (vec2(480.0, 800.0), Language::En, TEXT),
        (vec2(480.0, 320.0), Language::Nl, "Budget als TOML"),
    ] {
        let page = with(Window { size, language, ..Window::default() }, "station3.toml");
        page.get_by_role_and_label(Role::MultilineTextInput, name);
        for node in page.get_all_by(|node| node.label().is_some()) {
            let rect = node.rect();
            let said = node.accesskit_node().label();
            assert!(-1.0 <= rect.left() && rect.right() <= size.x + 1.0, "{size:?}: {said:?} at {rect:?}");
        }
    }
}

fn picture(name: &str, theme: Theme, size: Vec2, budget: &str) {
    if !can_paint(name) {
        return;
    }
    let mut page = with(Window { size, theme, ..Window::default() }, budget);
    send(&mut page, BudgetCommand::Use);
    page.snapshot(name);
}

#[test]
fn a_budget_in_light() {
    picture("budget_light", Theme::Light, DESK, "station3.toml");
}

#[test]
fn a_calibrated_piece_in_dark() {
    picture("budget_ring_dark", Theme::Dark, vec2(1024.0, 600.0), "ring30.toml");
}
