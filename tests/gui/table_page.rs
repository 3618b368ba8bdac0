//! The table page: whether a table agrees with ISO 286, and changing it, by label and key.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::time::Duration;

use eframe::egui::accesskit::Role;
use eframe::egui::{Key, Modifiers, Theme, ViewportCommand, ViewportEvent, ViewportId, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use fitcheck::control::deviations::read_table;
use fitcheck::gui::App;
use fitcheck::session::{self, Command};
use fitcheck::tolerance::DeviationTable;

use crate::harness::{Window, type_into, window};

type Page = Harness<'static, App>;

/// The table page with the built-in hole table.
fn page() -> Page {
    open(Window::default())
}

fn open(window: Window) -> Page {
    let mut page = window.open();
    page.key_press_modifiers(Modifiers::COMMAND, Key::Num6);
    page.run();
    page
}

fn press(page: &mut Page, button: &str) {
    page.get_by_role_and_label(Role::Button, button).click();
    page.run();
}

/// Opens the menu of the tools that have no room.
fn more(page: &mut Page) {
    let row = page.get_by_role_and_label(Role::Button, "Save as").rect();
    let is_there = |rect: eframe::egui::Rect| (rect.center().y - row.center().y).abs() < 2.0;
    page.get_all_by_role_and_label(Role::Button, "More").find(|node| is_there(node.rect())).unwrap().click();
    page.run();
}

fn key(page: &mut Page, modifiers: Modifiers, key: Key) {
    page.key_press_modifiers(modifiers, key);
    page.run();
}

/// Clicks a cell, by its class and range.
fn choose(page: &mut Page, cell: &str) {
    page.get_by(|node| node.role() == Role::GridCell && node.label().is_some_and(|label| label.starts_with(cell)))
        .click();
    page.run();
}

fn cells(page: &Page) -> Vec<String> {
    let cells = page.get_all_by_role(Role::GridCell);
    cells.filter_map(|cell| cell.accesskit_node().label()).collect()
}

fn field(page: &Page, name: &str) -> String {
    page.get_by_role_and_label(Role::TextInput, name).accesskit_node().value().unwrap_or_default()
}

#[expect(clippy::redundant_closure_for_method_calls, reason = "the method alone is not general over lifetimes")]
fn focused(page: &Page) -> String {
    page.get_by(|node| node.is_focused()).accesskit_node().label().unwrap_or_default()
}

fn type_path(page: &mut Page, path: &Path) {
    page.get_by_role_and_label(Role::TextInput, "File").type_text(&path.display().to_string());
    page.run();
    key(page, Modifiers::NONE, Key::Enter);
}

fn put(path: &Path, text: &str) {
    use std::io::Write as _;
    std::fs::File::create(path).unwrap().write_all(text.as_bytes()).unwrap();
}

/// A table with one cell off by 4 µm (H7 over 18 up to 30 mm is +21 / 0), and a class of its own.
fn shop_table(folder: &Path) -> PathBuf {
    let path = folder.join("shop.tab");
    let mut text = "BEGIN shop.tab MM\r\nNR BEREICH H7   JS7   Q1  \r\n".to_owned();
    for (number, (to, h7, js7)) in
        [("3", "+10", "5"), ("6", "+12", "6"), ("10", "+15", "7.5"), ("18", "+18", "9"), ("30", "+25", "10.5")]
            .into_iter()
            .enumerate()
    {
        let row = number * 2;
        write!(text, "{row:<3}{to:<8}{h7:<5}{:<6}+5  \r\n", format!("+{js7}")).unwrap();
        write!(text, "{:<11}{:<5}{:<6}+1  \r\n", row + 1, "0", format!("-{js7}")).unwrap();
    }
    put(&path, &(text + "[END]\r\n"));
    path
}

/// The page with that table.
fn shop(folder: &Path) -> Page {
    let mut page = page();
    press(&mut page, "Open…");
    let path = shop_table(folder);
    type_path(&mut page, &path);
    page
}

fn read(path: &Path) -> DeviationTable {
    let (table, warnings) = read_table(&std::fs::read(path).unwrap(), "saved.tab", "saved.tab", false).unwrap();
    assert_eq!(warnings, []);
    table.unwrap()
}

#[test]
fn the_built_in_tables_agree_with_the_standard_in_every_cell() {
    let mut page = page();
    page.get_by_label_contains("agrees with ISO 286 in all");
    for tool in ["Differences only", "Next difference"] {
        assert!(page.get_by_role_and_label(Role::Button, tool).accesskit_node().is_disabled(), "{tool}");
    }
    page.get_by_role_and_label(Role::ComboBox, "Table").click();
    page.run();
    page.get_by_label("82553_shaft.tab, built in").click();
    page.run();
    page.get_by_label_contains("agrees with ISO 286 in all");
    assert!(cells(&page).iter().any(|cell| cell.starts_with("g6, over 18 up to 30 mm, \u{2212}7 / \u{2212}20 µm")));
}

#[test]
fn a_differing_cell_is_marked_and_named_with_how_much() {
    let folder = tempfile::tempdir().unwrap();
    let mut page = shop(folder.path());
    page.get_by_label("1 of 10 cells differs from ISO 286; 1 own class");
    page.get_by_label("H7, over 18 up to 30 mm, +25 / 0 µm, differs from ISO 286");
    press(&mut page, "Next difference");
    page.get_by_label("H7, over 18 up to 30 mm. ISO 286 has +21 / 0 µm; the table is off by +4 / 0 µm");
    page.get_by_label("+4");
    page.get_by_label("In ISO 286 the class is defined over 0 up to 3150 mm");
    choose(&mut page, "Q1, over 18 up to 30 mm");
    let said =
        page.get_by(|node| node.role() == Role::Status && node.label().is_some_and(|label| label.starts_with("Q1")));
    let said = said.accesskit_node().label().unwrap();
    assert!(
        said.starts_with("Q1, over 18 up to 30 mm. Q1 is not an ISO 286 tolerance class: letter Q does not exist"),
        "{said}"
    );
}

#[test]
fn differences_are_walked_by_key_and_round_again() {
    let folder = tempfile::tempdir().unwrap();
    let mut page = shop(folder.path());
    let here = |page: &Page| {
        let selected = page.get_by(|node| node.role() == Role::GridCell && node.is_selected() == Some(true));
        selected.accesskit_node().label().unwrap()
    };
    for shift in [Modifiers::NONE, Modifiers::NONE, Modifiers::SHIFT] {
        key(&mut page, shift, Key::F8);
        assert!(here(&page).starts_with("H7, over 18 up to 30 mm"), "{}", here(&page));
        key(&mut page, Modifiers::NONE, Key::ArrowUp);
    }
}

#[test]
fn differences_alone_are_shown_at_request() {
    let folder = tempfile::tempdir().unwrap();
    let mut page = shop(folder.path());
    let all = cells(&page);
    assert_eq!(all.len(), 15);
    press(&mut page, "Differences only");
    let differing = ["H7, over 18 up to 30 mm, +25 / 0 µm, differs from ISO 286"];
    assert_eq!(cells(&page), differing);
    page.get_by_label("1 of 3 classes");
    // The keys walk through what is shown, and the fields are those of the cell in sight.
    for arrow in [Key::ArrowUp, Key::ArrowLeft, Key::ArrowDown, Key::ArrowRight] {
        key(&mut page, Modifiers::NONE, arrow);
        assert_eq!(field(&page, "Upper"), "+25");
    }
    press(&mut page, "Differences only");
    assert_eq!(cells(&page), all);
    press(&mut page, "Differences only");
    // Once nothing differs everything is shown.
    press(&mut page, "Use ISO 286");
    assert_eq!(cells(&page).len(), 15);
    assert!(page.get_by_role_and_label(Role::Button, "Differences only").accesskit_node().is_disabled());
}

#[test]
fn the_tools_stand_in_one_row_and_the_rest_in_a_menu() {
    for (width, is_folded) in [(800.0, true), (1920.0, false)] {
        let mut page = open(Window { size: vec2(width, 600.0), ..Window::default() });
        let row = page.get_by_role_and_label(Role::Button, "Save as").rect();
        for tool in ["Filter", "Table"] {
            let tools = page.get_all_by_label(tool).filter(|node| node.accesskit_node().role() != Role::Label);
            let rects: Vec<_> = tools.map(|node| node.rect()).collect();
            assert!(rects.iter().any(|rect| (rect.center().y - row.center().y).abs() < 2.0), "{tool}: {rects:?}");
        }
        assert_eq!(page.query_by_role_and_label(Role::Button, "Use this table for limits").is_none(), is_folded);
        if is_folded {
            more(&mut page);
            page.get_by_role_and_label(Role::Button, "Use this table for limits");
        }
    }
}

#[test]
fn the_filter_chooses_columns_and_marks_a_row() {
    let mut page = page();
    page.get_by_label("24 of 24 classes");
    type_into(&mut page, "Filter", "H7 js7");
    page.get_by_label("2 of 24 classes");
    assert!(cells(&page).iter().all(|cell| cell.starts_with("H7,") || cell.starts_with("JS7,")));
    type_into(&mut page, "Filter", "h");
    assert!(cells(&page).iter().all(|cell| cell.starts_with('H')));
    type_into(&mut page, "Filter", "H7 25");
    assert!(cells(&page).iter().any(|cell| cell.starts_with("H7, over 18 up to 30 mm")));
    type_into(&mut page, "Filter", "g6");
    page.get_by_label("no match for g6");
    type_into(&mut page, "Filter", "");
    page.get_by_label("24 of 24 classes");
}

#[test]
fn an_edit_of_a_built_in_table_makes_a_copy_and_can_be_taken_back() {
    let mut page = page();
    type_into(&mut page, "Filter", "H7");
    choose(&mut page, "H7, over 18 up to 30 mm");
    page.get_by_label_contains("an edit makes a copy");
    assert_eq!((field(&page, "Upper"), field(&page, "Lower")), ("+21".into(), "0".into()));
    type_into(&mut page, "Upper", "22,5");
    key(&mut page, Modifiers::NONE, Key::Enter);
    page.get_by_label("H7, over 18 up to 30 mm, +22.5 / 0 µm, differs from ISO 286");
    page.get_by_label("Changes are not saved");
    assert_eq!(focused(&page), "Deviations of 82553_hole_copy.tab in µm", "arrows walk on");
    key(&mut page, Modifiers::COMMAND, Key::Z);
    page.get_by_label("H7, over 18 up to 30 mm, +21 / 0 µm");
    assert!(page.query_by_label("Changes are not saved").is_none());
    key(&mut page, Modifiers::COMMAND, Key::Y);
    page.get_by_label("H7, over 18 up to 30 mm, +22.5 / 0 µm, differs from ISO 286");
    press(&mut page, "Undo");
    press(&mut page, "Redo");
    press(&mut page, "Use ISO 286");
    page.get_by_label_contains("agrees with ISO 286 in all");
    page.get_by_role_and_label(Role::ComboBox, "Table").click();
    page.run();
    page.get_by_label("82553_hole.tab, built in").click();
    page.run();
    page.get_by_label_contains("an edit makes a copy");
}

#[test]
fn an_edit_in_the_wrong_order_or_without_a_number_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    let mut page = shop(folder.path());
    choose(&mut page, "JS7, over 18 up to 30 mm");
    type_into(&mut page, "Upper", "-11");
    key(&mut page, Modifiers::NONE, Key::Enter);
    page.get_by_label("upper deviation \u{2212}11 µm is below lower deviation \u{2212}10.5 µm");
    page.get_by_label("JS7, over 18 up to 30 mm, +10.5 / \u{2212}10.5 µm");
    type_into(&mut page, "Upper", "1.2.3");
    page.get_by_label("1.2.3 is not a number");
    // Another cell is shown only once the text can be read.
    choose(&mut page, "H7, over 10 up to 18 mm");
    assert_eq!(field(&page, "Upper"), "1.2.3");
    type_into(&mut page, "Upper", "");
    key(&mut page, Modifiers::NONE, Key::Enter);
    page.get_by_label("a length is missing");
    key(&mut page, Modifiers::NONE, Key::Escape);
    assert_eq!(field(&page, "Upper"), "+10.5");
    assert!(page.query_by_label("Changes are not saved").is_none());
}

#[test]
fn the_keyboard_alone_is_enough() {
    let folder = tempfile::tempdir().unwrap();
    let mut page = shop(folder.path());
    let grid = "Deviations of shop.tab in µm";
    for _ in 0..60 {
        if focused_or_none(&page).as_deref() == Some(grid) {
            break;
        }
        key(&mut page, Modifiers::NONE, Key::Tab);
    }
    assert_eq!(focused(&page), grid);
    for _ in 0..4 {
        key(&mut page, Modifiers::NONE, Key::ArrowDown);
    }
    key(&mut page, Modifiers::NONE, Key::Enter);
    assert_eq!(focused(&page), "Upper");
    page.get_by_role_and_label(Role::TextInput, "Upper").type_text("21");
    page.run();
    key(&mut page, Modifiers::NONE, Key::Enter);
    page.get_by_label("agrees with ISO 286 in all 10 cells; 1 own class");
    assert_eq!(focused(&page), grid);
    key(&mut page, Modifiers::NONE, Key::ArrowRight);
    page.get_by_label("JS7, over 18 up to 30 mm. As in ISO 286");
    key(&mut page, Modifiers::NONE, Key::Delete);
    page.get_by_label("JS7, over 18 up to 30 mm, empty, differs from ISO 286");
    key(&mut page, Modifiers::NONE, Key::Escape);
    assert_eq!(focused_or_none(&page), None);
}

#[expect(clippy::redundant_closure_for_method_calls, reason = "the method alone is not general over lifetimes")]
fn focused_or_none(page: &Page) -> Option<String> {
    page.query_by(|node| node.is_focused()).and_then(|node| node.accesskit_node().label())
}

#[test]
fn a_changed_table_is_saved_and_reads_back_in_every_generation() {
    let folder = tempfile::tempdir().unwrap();
    let mut page = shop(folder.path());
    press(&mut page, "Next difference");
    press(&mut page, "Use ISO 286");
    page.get_by_label("Changes are not saved");
    for (entry, name) in [
        ("Control table for iTNC 530…", "own table.tab"),
        ("Control table for TNC 620 and TNC 640…", "own640.tab"),
        ("Control table for TNC7…", "own7.tab"),
    ] {
        press(&mut page, "Save as");
        page.get_by_label_contains(entry).click();
        page.run();
        let path = folder.path().join(name);
        type_path(&mut page, &path);
        page.get_by_label_contains("was written to");
        press(&mut page, "Close");
        let saved = read(&path);
        let h7 = saved.columns()[0].cells[4].unwrap();
        assert_eq!((h7.upper().to_string(), h7.lower().to_string()), ("0.021".into(), "0".into()), "{name}");
        assert_eq!(saved.columns().len(), 3);
        assert!(page.query_by_label("Changes are not saved").is_none());
        page.get_by_role_and_label(Role::Grid, &format!("Deviations of {name} in µm"));
    }
}

#[test]
fn a_folder_that_is_not_there_keeps_the_changes_unsaved() {
    let folder = tempfile::tempdir().unwrap();
    let mut page = shop(folder.path());
    press(&mut page, "Remove H7");
    key(&mut page, Modifiers::COMMAND, Key::S);
    type_path(&mut page, &folder.path().join("none").join("own.tab"));
    page.get_by_label_contains("no such file or folder");
    press(&mut page, "Cancel");
    page.get_by_label("Changes are not saved");
}

#[test]
fn a_file_that_is_no_table_of_deviations_is_refused_in_the_dialog() {
    let mut page = page();
    key(&mut page, Modifiers::COMMAND, Key::O);
    let samples = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/samples");
    type_path(&mut page, &samples.join("tables/tchprobe.tp"));
    page.get_by_role_and_label(Role::TextInput, "File");
    page.get_by_label_contains("tchprobe.tp");
}

#[test]
fn classes_are_added_and_a_table_is_made_from_the_standard() {
    let folder = tempfile::tempdir().unwrap();
    let mut page = shop(folder.path());
    type_into(&mut page, "Classes, such as H7 K7 P9", "K7 H7");
    press(&mut page, "Add to this table");
    page.get_by_label("column H7 occurs twice");
    type_into(&mut page, "Classes, such as H7 K7 P9", "K7, P77");
    press(&mut page, "Add to this table");
    page.get_by_label_contains("P77 is not an ISO 286 tolerance class");
    type_into(&mut page, "Classes, such as H7 K7 P9", "K7, N9");
    press(&mut page, "Add to this table");
    page.get_by_label("5 of 5 classes");
    page.get_by_label("K7, over 18 up to 30 mm, +6 / \u{2212}15 µm");
    press(&mut page, "Undo");
    type_into(&mut page, "Classes, such as H7 K7 P9", "g6 h6");
    type_into(&mut page, "Sizes up to", "50");
    key(&mut page, Modifiers::NONE, Key::Enter);
    page.get_by_role_and_label(Role::Grid, "Deviations of iso286_shaft.tab in µm");
    page.get_by_label("Changes are not saved");
    page.get_by_label_contains("agrees with ISO 286 in all");
    page.get_by_label("g6, over 18 up to 30 mm, \u{2212}7 / \u{2212}20 µm");
}

#[test]
fn the_check_page_follows_a_table_that_is_used_for_limits() {
    let folder = tempfile::tempdir().unwrap();
    let mut page = shop(folder.path());
    more(&mut page);
    press(&mut page, "Use this table for limits");
    page.get_by_label_contains("Limits are looked up in shop.tab first");
    press(&mut page, "Close");
    more(&mut page);
    page.get_by_role_and_label(Role::Button, "Used for limits");
    key(&mut page, Modifiers::NONE, Key::Escape);
    key(&mut page, Modifiers::COMMAND, Key::Num1);
    type_into(&mut page, "Callout", "25 H7");
    page.get_by_label("25.025");
    page.get_by_label("from table shop.tab, over 18 up to 30 mm");
    press(&mut page, "Menu");
    press(&mut page, "Stop using own tables");
    page.get_by_label("25.021");
}

#[test]
fn enter_in_a_field_of_the_page_measures_nothing() {
    let mut page = window();
    type_into(&mut page, "Callout", "25 H7");
    key(&mut page, Modifiers::COMMAND, Key::Num6);
    for name in ["Filter", "Upper", "Classes, such as H7 K7 P9"] {
        type_into(&mut page, name, "7");
        key(&mut page, Modifiers::NONE, Key::Enter);
    }
    assert!(page.state().session().history().is_empty());
}

#[test]
fn the_settled_page_asks_for_no_repaint() {
    let folder = tempfile::tempdir().unwrap();
    let mut page = shop(folder.path());
    press(&mut page, "Next difference");
    key(&mut page, Modifiers::NONE, Key::Enter);
    page.run();
    assert_eq!(page.output().viewport_output[&ViewportId::ROOT].repaint_delay, Duration::MAX);
}

#[test]
fn only_the_cells_in_sight_are_drawn() {
    let mut page = page();
    let drawn = cells(&page).len();
    assert!((100..800).contains(&drawn), "{drawn}");
    key(&mut page, Modifiers::COMMAND, Key::End);
    assert!(cells(&page).len() < 800);
}

fn picture(name: &str, theme: Theme) {
    if !crate::pictures::can_paint(name) {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let mut page = open(Window { theme, size: vec2(1024.0, 600.0), ..Window::default() });
    let ctx = page.ctx.clone();
    let chosen = if theme == Theme::Light { session::Theme::Light } else { session::Theme::Dark };
    page.state_mut().send(&ctx, Command::SetTheme(chosen));
    if theme == Theme::Light {
        press(&mut page, "Open…");
        let path = shop_table(folder.path());
        type_path(&mut page, &path);
        press(&mut page, "Next difference");
    } else {
        type_into(&mut page, "Filter", "25");
    }
    page.remove_cursor();
    page.run();
    page.snapshot(name);
}

#[test]
fn a_table_that_differs_in_light() {
    picture("table_differs_light", Theme::Light);
}

#[test]
fn the_built_in_holes_in_dark() {
    picture("table_holes_dark", Theme::Dark);
}

/// What the window manager asks when the cross is clicked, and what the window answers.
fn close(page: &mut Page) -> Vec<ViewportCommand> {
    let root = page.input_mut().viewports.entry(ViewportId::ROOT).or_default();
    root.events.push(ViewportEvent::Close);
    page.step();
    let answer = page.output().viewport_output.get(&ViewportId::ROOT).map(|output| output.commands.clone());
    if let Some(root) = page.input_mut().viewports.get_mut(&ViewportId::ROOT) {
        root.events.clear();
    }
    page.run();
    answer.unwrap_or_default()
}

#[test]
fn closing_the_window_with_unsaved_changes_asks_first() {
    let mut page = page();
    type_into(&mut page, "Filter", "H7");
    assert!(!close(&mut page).contains(&ViewportCommand::CancelClose), "nothing is unsaved");
    assert!(page.query_by_label("Close Fitcheck?").is_none());
    choose(&mut page, "H7, over 18 up to 30 mm");
    type_into(&mut page, "Upper", "22,5");
    key(&mut page, Modifiers::NONE, Key::Enter);
    assert!(close(&mut page).contains(&ViewportCommand::CancelClose));
    page.get_by_label("Not saved: 82553_hole_copy.tab");
    page.key_press(Key::Enter);
    page.run();
    assert!(page.query_by_label("Close Fitcheck?").is_none(), "Enter goes on working");
    close(&mut page);
    page.get_by_role_and_label(Role::Button, "Close without saving").click();
    page.run();
    assert!(!close(&mut page).contains(&ViewportCommand::CancelClose), "asked once, answered once");
}

#[test]
fn limits_follow_an_edit_of_the_table_that_gives_them() {
    let folder = tempfile::tempdir().unwrap();
    let mut page = shop(folder.path());
    more(&mut page);
    press(&mut page, "Use this table for limits");
    press(&mut page, "Close");
    choose(&mut page, "JS7, over 18 up to 30 mm");
    type_into(&mut page, "Upper", "12");
    key(&mut page, Modifiers::NONE, Key::Enter);
    page.get_by_label_contains("gives the limits: checks use the change from now on");
    let session = page.state().session();
    let limits = session.sources().limits(&"25 JS7".parse().unwrap(), None).unwrap();
    assert_eq!(limits.maximum().to_string(), "25.012");
    assert!(session.tables().is_used(session.sources()), "the table in sight is the one that limits come from");
}
