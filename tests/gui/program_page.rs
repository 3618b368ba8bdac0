//! The program page: the built-in program opened, filled in, stepped, run and read, by label and key.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};

use eframe::egui::accesskit::Role;
use eframe::egui::{Color32, FontId, Key, Modifiers, Rect, TextStyle, Theme, Vec2, ViewportId, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use fitcheck::gui::App;
use fitcheck::nc::sets::Control;
use fitcheck::session::program::Run;
use fitcheck::session::{Page, ProgramCommand};
use fitcheck::verdict::Status;
use fitcheck::words::Language;

use crate::dialogs::Dropped;
use crate::harness::{DESK, Window, scan, type_into};
use crate::pictures::can_paint;

type Harnessed = Harness<'static, App>;

fn open(window: Window) -> Harnessed {
    let mut page = window.open();
    page.key_press_modifiers(Modifiers::COMMAND, Key::Num8);
    page.run();
    assert_eq!(page.state().session().page(), Page::Program);
    page
}

fn page() -> Harnessed {
    open(Window::default())
}

fn click(page: &mut Harnessed, role: Role, label: &str) {
    page.get_by_role_and_label(role, label).click_accesskit();
    page.run();
}

fn key(page: &mut Harnessed, modifiers: Modifiers, key: Key) {
    page.key_press_modifiers(modifiers, key);
    page.run();
}

fn press(page: &mut Harnessed, pressed: Key) {
    key(page, Modifiers::NONE, pressed);
}

/// Opens a file by its typed path.
fn open_file(page: &mut Harnessed, path: &Path) {
    key(page, Modifiers::COMMAND, Key::O);
    page.get_by_role_and_label(Role::TextInput, "File").type_text(&path.display().to_string());
    page.run();
    press(page, Key::Enter);
}

fn put(path: &Path, text: &str) {
    use std::io::Write as _;
    std::fs::File::create(path).unwrap().write_all(text.as_bytes()).unwrap();
}

/// A program in a folder of its own.
fn program(folder: &Path, name: &str, body: &str) -> PathBuf {
    let path = folder.join(name);
    let stem = name.trim_end_matches(".h");
    put(&path, &format!("BEGIN PGM {stem} MM\n{body}\nEND PGM {stem} MM\n"));
    path
}

/// What the page says, region by region.
fn said(page: &Harnessed) -> Vec<String> {
    let regions = page.get_all_by_role(Role::Status);
    regions.filter_map(|node| node.accesskit_node().label()).collect()
}

#[track_caller]
fn says(page: &Harnessed, wanted: &str) {
    let said = said(page);
    assert!(said.iter().any(|said| said.contains(wanted)), "{wanted}: {said:?}");
}

fn run(page: &Harnessed) -> &Run {
    page.state().session().program().run.as_ref().unwrap()
}

/// Selects a block by how its line begins; one below the edge of the listing is gone to first.
fn select(page: &mut Harnessed, line: &str) {
    for _ in 0..3 {
        let is_in_sight = page
            .query_by(|node| node.role() == Role::ListItem && node.label().is_some_and(|label| label.starts_with(line)))
            .is_some();
        if is_in_sight {
            break;
        }
        page.get_by_role(Role::List).focus();
        page.run();
        press(page, Key::PageDown);
    }
    page.get_by(|node| node.role() == Role::ListItem && node.label().is_some_and(|label| label.starts_with(line)))
        .click_accesskit();
    page.run();
}

#[test]
fn the_shipped_program_runs_to_the_end_and_agrees() {
    let mut page = page();
    page.get_by_role_and_label(Role::List, "8255_en.h, 15 blocks");
    says(&page, "Ready to run");
    press(&mut page, Key::F5);
    says(&page, "The program stopped itself");
    page.get_by_label_contains("FIT STATUS");
    press(&mut page, Key::F5);
    says(&page, "Ended after");
    says(&page, "GOOD");
    says(&page, "The program agrees with Fitcheck");
    assert_eq!(run(&page).status(), Some(Status::Good));
}

/// The parameters in sight, as a screen reader hears them.
fn parameters(page: &Harnessed) -> Vec<String> {
    let labels = page.get_all_by_role(Role::Label).filter_map(|node| node.accesskit_node().value());
    labels.filter(|label| label.starts_with('Q') && label.contains(" = ")).collect()
}

/// The line of the block that runs next.
fn current(page: &Harnessed) -> String {
    let lines = page.get_all_by_role(Role::ListItem).filter_map(|node| node.accesskit_node().label());
    lines.filter(|label| label.ends_with("next block")).collect()
}

#[test]
fn single_blocks_show_what_they_change() {
    let mut page = page();
    type_into(&mut page, "Q1 Nominal size", "30,5");
    type_into(&mut page, "QS1 Class", "g6");
    for _ in 0..4 {
        press(&mut page, Key::F10);
    }
    says(&page, "Single block");
    assert_eq!(current(&page), "4  DECLARE STRING QS1 = \"H7\" ;TOLERANCE CLASS, next block");
    press(&mut page, Key::F10);
    press(&mut page, Key::F10);
    assert_eq!(current(&page), "6  Q21 = 30 ;MEASURING CENTRE Y, next block");
    let parameters = parameters(&page);
    assert!(parameters.contains(&"Q1 NOMINAL SIZE = 30.5".to_owned()), "{parameters:?}");
    assert!(parameters.contains(&"Q11 MEASURING CENTRE X = 40, changed".to_owned()), "{parameters:?}");
    assert!(parameters.contains(&"QS1 TOLERANCE CLASS = \"g6\"".to_owned()), "{parameters:?}");
}

#[test]
fn a_value_that_cannot_be_read_is_said_beside_its_field_and_nothing_runs() {
    let mut page = page();
    type_into(&mut page, "Q1 Nominal size", "25..5");
    page.get_by_label_contains("25..5");
    press(&mut page, Key::F5);
    says(&page, "An input cannot be read");
    assert!(page.state().session().program().run.is_none());
    type_into(&mut page, "Q1 Nominal size", "0");
    page.get_by_label_contains("is not above 0");
}

#[test]
fn a_breakpoint_in_the_called_program_is_reached_and_left() {
    let mut page = page();
    // Into the called program, to set a breakpoint there.
    for _ in 0..12 {
        press(&mut page, Key::F10);
    }
    page.get_by_role_and_label(Role::Button, "82551_en.h");
    select(&mut page, "19 Q22 = Q22 + 2");
    press(&mut page, Key::F9);
    page.get_by_label("19 Q22 = Q22 + 2, breakpoint");
    key(&mut page, Modifiers::SHIFT, Key::F5);
    says(&page, "Ready to run");
    page.get_by_role_and_label(Role::List, "8255_en.h, 15 blocks");
    press(&mut page, Key::F5);
    says(&page, "Paused at a breakpoint");
    page.get_by_label("19 Q22 = Q22 + 2, breakpoint, next block");
    let before = run(&page).blocks_run();
    press(&mut page, Key::F5);
    says(&page, "Paused at a breakpoint");
    // Once round the loop that looks for the size range.
    assert_eq!(run(&page).blocks_run() - before, 6);
    press(&mut page, Key::F9);
    press(&mut page, Key::F5);
    says(&page, "The program stopped itself");
}

#[test]
fn the_run_goes_to_the_cursor_and_over_a_call() {
    let mut page = page();
    select(&mut page, "11 CALL PGM");
    key(&mut page, Modifiers::COMMAND, Key::F10);
    says(&page, "Paused at the cursor");
    assert!(current(&page).starts_with("11 CALL PGM 82551_en.h"));
    key(&mut page, Modifiers::SHIFT, Key::F10);
    says(&page, "Paused after the call");
    assert!(current(&page).starts_with("12 STOP"));
    says(&page, "GOOD");
}

#[test]
fn the_listing_is_walked_by_key() {
    let mut page = page();
    select(&mut page, "3  Q1");
    for (pressed, line) in [(Key::ArrowDown, 4), (Key::ArrowUp, 3), (Key::End, 14), (Key::Home, 0)] {
        press(&mut page, pressed);
        assert_eq!(page.state().session().program().shown().unwrap().selected, line, "{pressed:?}");
    }
}

#[test]
fn a_scrap_workpiece_is_scrap_in_both_answers() {
    let mut page = page();
    click(&mut page, Role::ComboBox, "Workpiece");
    click(&mut page, Role::Button, "perfect, diameter given");
    type_into(&mut page, "True diameter", "25.05");
    press(&mut page, Key::F5);
    says(&page, "SCRAP. 25.0500 mm");
    page.get_by_label_contains("FIT STATUS: SCRAP");
    says(&page, "The program agrees with Fitcheck");
    assert_eq!(run(&page).status(), Some(Status::Scrap));
    // Any other workpiece clears the verdict.
    type_into(&mut page, "True diameter", "25.01");
    says(&page, "Ready to run");
    assert!(page.query_by_label_contains("FIT STATUS").is_none());
    press(&mut page, Key::F5);
    says(&page, "GOOD. 25.0100 mm");
}

#[test]
fn four_parameters_are_in_sight_and_signs_stand_in_the_middle_of_their_rows() {
    for language in Language::all() {
        let mut page = open(Window { size: DESK, language, ..Window::default() });
        press(&mut page, Key::F5);
        press(&mut page, Key::F5);
        let is_value =
            |label: Option<String>| label.is_some_and(|label| label.starts_with('Q') && label.contains(" = "));
        let rows: Vec<Rect> = page
            .query_all_by(|node| node.role() == Role::Label && is_value(node.value()))
            .map(|node| node.rect())
            .filter(|row| row.bottom() <= DESK.y - 16.0)
            .collect();
        assert!(4 <= rows.len(), "{language:?}: {rows:?}");
        let signs = page.query_all_by(|node| {
            let is_sign = node.label().is_some_and(|label| label.contains('Q'));
            node.role() == Role::Button && is_sign
        });
        let signs: Vec<Rect> = signs.map(|node| node.rect()).filter(|sign| DESK.x * 0.9 < sign.left()).collect();
        let has_sign = |row: &Rect| signs.iter().any(|sign| (row.center().y - sign.center().y).abs() < 0.1);
        assert!(rows.iter().all(has_sign), "{language:?}: {rows:?} {signs:?}");
    }
}

#[test]
fn the_buttons_stand_still_whatever_the_program_is_called() {
    let folder = tempfile::tempdir().unwrap();
    let mut page = page();
    let before = page.get_by_role_and_label(Role::Button, "Reset").rect();
    let long = program(folder.path(), "a_program_with_a_very_long_name_indeed.h", "CALL PGM none.h");
    open_file(&mut page, &long);
    assert_eq!(page.get_by_role_and_label(Role::Button, "Reset").rect(), before);
    // What is not found says where it was looked for, and what helps.
    press(&mut page, Key::F5);
    let looked = format!("file not found: TNC:\\none.h. It was looked for in {}", folder.path().display());
    page.get_by_label_contains(&looked);
}

#[test]
fn the_simulated_workpiece_is_that_of_the_cycles_page() {
    let mut page = page();
    click(&mut page, Role::ComboBox, "Workpiece");
    click(&mut page, Role::Button, "simulated");
    click(&mut page, Role::Button, "Workpiece and probe…");
    click(&mut page, Role::Button, "Match workpiece to cycle");
    click(&mut page, Role::Button, "Close");
    press(&mut page, Key::F5);
    says(&page, "GOOD");
    says(&page, "The program agrees with Fitcheck");
    let bench = page.state().session().workpiece().simulation.as_ref().copied().unwrap();
    assert!(format!("{:?}", bench.surface).contains("centre: [40.0, 30.0]"), "{bench:?}");
}

#[test]
fn a_class_that_neither_knows_is_refused_by_both() {
    let mut page = page();
    type_into(&mut page, "QS1 Class", "I7");
    page.get_by(|node| node.role() == Role::Label && node.value().is_some_and(|value| value.starts_with("I7 is not")));
    press(&mut page, Key::F5);
    says(&page, "Stopped with an error");
    says(&page, "Neither the program nor Fitcheck gives an answer");
}

#[test]
fn a_size_beyond_the_tables_differs_and_says_how() {
    let mut page = page();
    type_into(&mut page, "Q1 Nominal size", "450");
    press(&mut page, Key::F5);
    says(&page, "The program differs: it stopped with an error");
}

#[test]
fn an_error_is_shown_and_a_click_goes_to_its_block() {
    let folder = tempfile::tempdir().unwrap();
    let mut body = "Q1 = 5\nQ2 = 0\n".to_owned();
    for _ in 0..100 {
        body += "Q3 = 1\n";
    }
    let path = program(folder.path(), "fault.h", &(body + "Q4 = Q1 / Q2"));
    let mut page = page();
    open_file(&mut page, &path);
    page.get_by_role_and_label(Role::List, "fault.h, 105 blocks");
    press(&mut page, Key::F5);
    says(&page, "Stopped with an error");
    page.get_by_label("Q4 = Q1 / Q2, error here");
    // Away from it, and back by the list of notes.
    page.get_by_role(Role::List).focus();
    page.run();
    press(&mut page, Key::Home);
    assert!(page.query_by_label("Q4 = Q1 / Q2, error here").is_none());
    page.get_by(|node| {
        node.role() == Role::Button && node.label().is_some_and(|label| label.contains("division by zero"))
    })
    .click();
    page.run();
    page.get_by_label("Q4 = Q1 / Q2, error here");
    assert_eq!(page.state().session().program().shown().unwrap().selected, 103);
}

/// Whole machining programs of milling and turning, block by block from the first to the last.
#[test]
fn whole_programs_are_stepped_to_their_end() {
    for (name, blocks, passed_over) in [("plate_fit.h", 63, "CYCL DEF 208"), ("flange_fit.nc", 99, "ROHTEIL")] {
        let mut page = page();
        open_file(&mut page, &Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/examples").join(name));
        for _ in 0..blocks {
            assert!(page.query_by_label_contains("Ended after").is_none(), "{name}");
            press(&mut page, Key::F10);
        }
        says(&page, &format!("Ended after {blocks} blocks"));
        page.get_by_label_contains(passed_over);
    }
}

#[test]
fn an_unknown_block_stops_the_run_or_is_passed_over() {
    let folder = tempfile::tempdir().unwrap();
    let path = program(folder.path(), "unknown.h", "Q1 = 5\nCUTTING DATA\nQ2 = Q1 + 1");
    let mut page = page();
    open_file(&mut page, &path);
    press(&mut page, Key::F5);
    says(&page, "Stopped with an error");
    click(&mut page, Role::Button, "Options");
    click(&mut page, Role::CheckBox, "Skip unknown blocks");
    says(&page, "Ready to run");
    press(&mut page, Key::F5);
    says(&page, "Ended after 5 blocks");
    page.get_by_label_contains("unknown block skipped");
}

#[test]
fn values_are_given_filtered_and_pinned() {
    let folder = tempfile::tempdir().unwrap();
    let path = program(folder.path(), "sum.h", "Q10 = Q5 + QL7 ;TOTAL");
    let mut page = page();
    open_file(&mut page, &path);
    for (name, value) in [("Q5", "2,5"), ("ql7", "4")] {
        type_into(&mut page, "Start with", name);
        type_into(&mut page, "Value", value);
        press(&mut page, Key::Enter);
    }
    type_into(&mut page, "Start with", "X5");
    press(&mut page, Key::Enter);
    page.get_by_label("X5 is not a parameter: write Q5, QL5, QR5 or QS5");
    press(&mut page, Key::F5);
    says(&page, "Ended after");
    page.get_by_label("Q10 TOTAL = 6.5, changed");
    type_into(&mut page, "Filter", "total");
    assert_eq!(parameters(&page), ["Q10 TOTAL = 6.5, changed"]);
    click(&mut page, Role::Button, "Keep Q10 at the top");
    type_into(&mut page, "Filter", "Q5");
    assert_eq!(parameters(&page), ["Q10 TOTAL = 6.5, changed", "Q5  = 2.5"]);
    click(&mut page, Role::Button, "Q5 = 2.5, remove");
    says(&page, "Ready to run");
}

#[test]
fn a_stop_and_a_skipped_block_are_switched() {
    let folder = tempfile::tempdir().unwrap();
    let path = program(folder.path(), "stops.h", "Q1 = 1\nM1\n/Q1 = 2\nQ2 = Q1");
    let mut page = page();
    open_file(&mut page, &path);
    for option in ["Skip blocks with /", "Stop at M1"] {
        click(&mut page, Role::Button, "Options");
        click(&mut page, Role::CheckBox, option);
        press(&mut page, Key::Escape);
    }
    press(&mut page, Key::F5);
    says(&page, "M1");
    press(&mut page, Key::F5);
    says(&page, "Ended");
    page.get_by_label("Q2  = 1, changed");
}

#[test]
fn tables_and_called_programs_lie_beside_the_program_and_nothing_is_written() {
    let folder = tempfile::tempdir().unwrap();
    program(folder.path(), "sub.h", "Q7 = 42");
    put(&folder.path().join("mask.a"), "\"VALUE %3.0LF\", Q7;\r\n");
    let body = "CALL PGM sub.h\nFN 16: F-PRINT mask.a / out.txt\nFN 16: F-PRINT mask.a / SCREEN:";
    let path = program(folder.path(), "main.h", body);
    let mut page = page();
    open_file(&mut page, &path);
    press(&mut page, Key::F5);
    says(&page, "Ended");
    page.get_by_label_contains("VALUE  42");
    page.get_by_label("TNC:\\out.txt");
    assert!(!folder.path().join("out.txt").exists());
}

#[test]
fn a_slow_run_goes_block_by_block_and_is_paused_by_escape() {
    let folder = tempfile::tempdir().unwrap();
    let path = program(folder.path(), "loop.h", "LBL 1\nQ1 = 1\nFN 9: IF +0 EQU +0 GOTO LBL 1");
    let mut page = page();
    open_file(&mut page, &path);
    click(&mut page, Role::ComboBox, "Speed");
    click(&mut page, Role::Button, "20 blocks/s");
    page.key_press(Key::F5);
    page.run_steps(10);
    says(&page, "Running");
    let blocks = run(&page).blocks_run();
    assert!((2..=12).contains(&blocks), "{blocks}");
    page.key_press(Key::Escape);
    page.run_steps(2);
    says(&page, "Paused");
    let blocks = run(&page).blocks_run();
    page.run_steps(5);
    assert_eq!(run(&page).blocks_run(), blocks);
    let output = page.output();
    assert_eq!(output.viewport_output[&ViewportId::ROOT].repaint_delay, std::time::Duration::MAX);
}

#[test]
fn an_endless_loop_at_full_speed_leaves_the_window_alive() {
    let folder = tempfile::tempdir().unwrap();
    let path = program(folder.path(), "loop.h", "LBL 1\nQ1 = 1\nFN 9: IF +0 EQU +0 GOTO LBL 1");
    let mut page = page();
    open_file(&mut page, &path);
    page.key_press(Key::F5);
    page.run_steps(5);
    says(&page, "Running");
    page.get_by_role_and_label(Role::Button, "Pause").click_accesskit();
    page.run_steps(3);
    says(&page, "Paused");
    assert!(2_000 <= run(&page).blocks_run());
}

#[test]
fn a_hundred_thousand_blocks_are_opened_and_walked() {
    let folder = tempfile::tempdir().unwrap();
    let mut body = String::new();
    for number in 1..=99_998 {
        match number % 1_000 {
            0 => writeln!(body, "{number} * - part {number}").unwrap(),
            _ => writeln!(body, "{number} L X+{} Y-{number}", number % 100).unwrap(),
        }
    }
    let path = program(folder.path(), "long.h", body.trim_end());
    let mut page = page();
    open_file(&mut page, &path);
    page.get_by_role_and_label(Role::List, "long.h, 100000 blocks");
    let rows = page.get_all_by_role(Role::ListItem).count();
    assert!((10..80).contains(&rows), "{rows} rows");
    page.get_by_role(Role::List).focus();
    page.run();
    press(&mut page, Key::End);
    page.get_by_label("END PGM long MM");
    assert!(page.get_all_by_role(Role::ListItem).count() < 80);
    // By the outline.
    click(&mut page, Role::ComboBox, "Go to");
    page.get_by_role_and_label(Role::Button, "part 1000").click();
    page.run();
    page.get_by_label("1000 * - part 1000");
}

#[test]
fn a_file_that_is_no_program_is_refused_in_the_dialog() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("empty.h");
    put(&path, "");
    let mut page = page();
    open_file(&mut page, &path);
    page.get_by_label_contains("the program is empty");
    press(&mut page, Key::Escape);
    page.get_by_role_and_label(Role::List, "8255_en.h, 15 blocks");
}

#[test]
fn the_settled_page_asks_for_no_repaint() {
    let mut page = page();
    press(&mut page, Key::F5);
    let output = page.output();
    assert_eq!(output.viewport_output[&ViewportId::ROOT].repaint_delay, std::time::Duration::MAX);
}

#[test]
fn programs_workpieces_and_contacts_are_dropped_on_the_page() {
    let folder = tempfile::tempdir().unwrap();
    let mut page = page();
    let drop = |page: &mut Harnessed, name: &str, text: &str| {
        let path = folder.path().join(name);
        put(&path, text);
        page.input_mut().dropped_files.push(std::sync::Arc::new(Dropped(path)));
        page.run();
    };
    drop(&mut page, "bore.toml", "[bore]\ncentre = [40.0, 30.0]\ndiameter = 24.99\n[probe]\nball_radius = 3.0\n");
    says(&page, "Ready to run");
    press(&mut page, Key::F5);
    says(&page, "REWORK. 24.99");
    says(&page, "The program agrees with Fitcheck");
    drop(&mut page, "bore.csv", "x,y,z\n52.505,30,-8\n40,42.505,-8\n27.495,30,-8\n40,17.495,-8\n");
    says(&page, "Ready to run");
    page.get_by_label("4 contacts from bore.csv");
    press(&mut page, Key::F5);
    says(&page, "GOOD. 25.0100 mm");
    drop(&mut page, "own.h", "BEGIN PGM own MM\nQ1 = 2\nEND PGM own MM\n");
    page.get_by_role_and_label(Role::List, "own.h, 3 blocks");
}

fn picture(name: &str, theme: Theme, size: Vec2, language: Language, steps: impl FnOnce(&mut Harnessed)) {
    if !can_paint(name) {
        return;
    }
    let mut page = open(Window { size, theme, language, ..Window::default() });
    steps(&mut page);
    page.remove_cursor();
    page.run();
    page.snapshot(name);
}

#[test]
fn picture_after_the_run_in_light() {
    picture("program_light", Theme::Light, DESK, Language::En, |page| {
        press(page, Key::F5);
    });
}

#[test]
fn picture_within_the_called_program_in_dark() {
    picture("program_dark", Theme::Dark, DESK, Language::En, |page| {
        type_into(page, "Q1 Nominal size", "30");
        type_into(page, "QS1 Class", "g6");
        for _ in 0..20 {
            press(page, Key::F10);
        }
    });
}

#[test]
fn picture_of_the_small_window_in_dutch() {
    picture("program_small", Theme::Light, vec2(1024.0, 600.0), Language::Nl, |page| {
        press(page, Key::F5);
    });
}

#[test]
fn picture_of_an_error_in_light() {
    let folder = tempfile::tempdir().unwrap();
    let path = program(folder.path(), "fault.h", "* - sums\nQ1 = 5\nQ2 = 0\nQ3 = Q1 / Q2\nCYCL DEF 7.0 DATUM\nSTOP");
    picture("program_fault", Theme::Light, vec2(1024.0, 600.0), Language::En, |page| {
        open_file(page, &path);
        press(page, Key::F5);
    });
}

#[test]
fn a_program_without_a_class_may_begin_with_a_q1_of_zero() {
    let folder = tempfile::tempdir().unwrap();
    let path = program(folder.path(), "count.h", "Q1 = 0\nQ2 = Q1 + 1");
    let mut page = page();
    open_file(&mut page, &path);
    assert!(page.query_by_role_and_label(Role::TextInput, "Q1 Nominal size").is_none());
    press(&mut page, Key::F5);
    says(&page, "Ended after 4 blocks");
    page.get_by_label("Q2  = 1, changed");
}

#[test]
fn what_is_given_to_an_input_is_in_its_field_and_in_both_answers() {
    let mut page = page();
    for (name, value) in [("Q1", "30"), ("QS1", "g6")] {
        type_into(&mut page, "Start with", name);
        type_into(&mut page, "Value", value);
        press(&mut page, Key::Enter);
    }
    for (name, value) in [("Q1 Nominal size", "30"), ("QS1 Class", "g6")] {
        let field = page.get_by_role_and_label(Role::TextInput, name);
        assert_eq!(field.accesskit_node().value().as_deref(), Some(value), "{name}");
    }
    press(&mut page, Key::F5);
    says(&page, "GOOD. 29.9865 mm");
    says(&page, "The program agrees with Fitcheck");
    page.get_by_label_contains("CHECKED FIT: 30 g6");
    // Removed there, it is the program's own again here.
    click(&mut page, Role::Button, "Q1 = 30, remove");
    let field = page.get_by_role_and_label(Role::TextInput, "Q1 Nominal size");
    assert_eq!(field.accesskit_node().value().as_deref(), Some("25"));
}

#[test]
fn run_and_pause_are_one_button_in_one_place() {
    let folder = tempfile::tempdir().unwrap();
    let path = program(folder.path(), "loop.h", "LBL 1\nQ1 = 1\nFN 9: IF +0 EQU +0 GOTO LBL 1");
    for language in [Language::En, Language::Nl] {
        let words = fitcheck::words::Words::new(language);
        let mut page = open(Window { language, ..Window::default() });
        press(&mut page, Key::Escape);
        key(&mut page, Modifiers::COMMAND, Key::O);
        let file = words.get("file-path");
        page.get_by_role_and_label(Role::TextInput, &file).type_text(&path.display().to_string());
        page.run();
        press(&mut page, Key::Enter);
        let place = |page: &Harnessed, id: &str| page.get_by_role_and_label(Role::Button, &words.get(id)).rect();
        let names = ["program-page-step", "program-page-reset", "program-page-options"];
        let before = names.map(|id| place(&page, id));
        let run = place(&page, "program-page-run");
        page.key_press(Key::F5);
        page.run_steps(5);
        assert_eq!(place(&page, "program-page-pause"), run, "{language:?}");
        assert_eq!(names.map(|id| place(&page, id)), before, "{language:?}");
        page.key_press(Key::Escape);
        page.run_steps(3);
    }
}

/// Where everything is that can be pressed, the lines of the listing included.
fn places(page: &Harnessed) -> Vec<(Role, String, Rect)> {
    let roles = [Role::Button, Role::ComboBox, Role::TextInput, Role::ListItem, Role::List];
    let nodes = roles.into_iter().flat_map(|role| page.query_all_by_role(role).collect::<Vec<_>>());
    let words = fitcheck::words::Words::new(page.state().session().language());
    // A line says that it is the next block.
    let next = format!(", {}", words.get("program-page-is-current"));
    let label = |label: String| label.trim_end_matches(next.as_str()).to_owned();
    nodes
        .map(|node| {
            (node.accesskit_node().role(), label(node.accesskit_node().label().unwrap_or_default()), node.rect())
        })
        .collect()
}

#[test]
fn nothing_moves_when_a_path_a_result_or_an_error_comes() {
    for language in [Language::En, Language::Nl] {
        for class in ["H7", "I7"] {
            let mut page = open(Window { language, ..Window::default() });
            let words = fitcheck::words::Words::new(language);
            let name = format!("QS1 {}", words.get("tolerance-class"));
            type_into(&mut page, &name, class);
            let before = places(&page);
            press(&mut page, Key::F5);
            assert!(run(&page).has_path() || class == "I7");
            let title = page.state().session().program().main().unwrap().title().to_owned();
            if page.state().session().program().shown().unwrap().title() != title {
                // An error leads to the called program: its own lines are shown.
                continue;
            }
            let after = places(&page);
            for place in before {
                assert!(after.contains(&place), "{language:?} {class}: {place:?} has moved");
            }
        }
    }
}

#[test]
fn errors_are_shown_whole() {
    let folder = tempfile::tempdir().unwrap();
    let path = program(
        folder.path(),
        "fault.h",
        "Q1 = 5\nQ2 = 0\nFN 14: ERROR = 1000\nCALL PGM a_program_with_a_long_name_that_is_not_there_at_all.h",
    );
    for size in [DESK, vec2(1024.0, 600.0), vec2(800.0, 600.0)] {
        let mut page = open(Window { size, ..Window::default() });
        open_file(&mut page, &path);
        press(&mut page, Key::F5);
        says(&page, "Stopped with an error");
        let message = page.state().session().program().note(0).unwrap().message;
        let said = fitcheck::words::Words::new(Language::En).say(&message);
        let note = page.get_by_role_and_label(Role::Button, &said).rect();
        let size_of_text = page.ctx.global_style().text_styles[&TextStyle::Small].size;
        let font = FontId::proportional(size_of_text);
        let needed = |width| {
            let (said, font) = (said.clone(), font.clone());
            page.ctx.fonts_mut(|fonts| fonts.layout(said, font, Color32::PLACEHOLDER, width).size())
        };
        assert!(needed(note.width()).y <= note.height() + 1.0, "{size:?}: {said} is cut: {note:?}");
        assert!(note.right() <= size.x && note.bottom() <= size.y, "{size:?}: {note:?}");
    }
}

/// The names in a folder, sorted.
fn names_in(folder: &Path) -> Vec<String> {
    let mut names: Vec<_> = folder
        .read_dir()
        .map(|entries| entries.map(|entry| entry.unwrap().file_name().to_string_lossy().into_owned()).collect())
        .unwrap_or_default();
    names.sort();
    names
}

/// Types a folder into the dialog and presses Enter.
fn into_folder(page: &mut Harnessed, folder: &Path) {
    type_into(page, "Folder", &folder.display().to_string());
    press(page, Key::Enter);
}

#[test]
fn a_set_for_a_control_is_created_from_the_callout_and_asks_before_it_replaces() {
    let folder = tempfile::tempdir().unwrap();
    let mut page = Window::default().open();
    type_into(&mut page, "Callout", "25 H7");
    type_into(&mut page, "Centre X", "40,5");
    // Whoever wonders how finds it by any of these words.
    for words in ["create control", "nc write", "create for"] {
        key(&mut page, Modifiers::COMMAND, Key::K);
        scan(&mut page, words);
        let found = &page.state().session().palette.as_ref().unwrap().found;
        assert!(found.iter().any(|entry| entry.text == "Create for a control…"), "{words}");
        press(&mut page, Key::Escape);
    }
    key(&mut page, Modifiers::COMMAND, Key::K);
    scan(&mut page, "create for a control⏎");
    assert_eq!(page.state().session().page(), Page::Program);
    page.get_by(|node| {
        node.role() == Role::ComboBox && node.value().is_some_and(|v| v == "25 H7 from Check, at X 40.5 Y 0 Z −5")
    });
    page.get_by_label("FIT_MAIN.H");
    page.get_by_label_contains("25 H7 gets exactly");
    let set = folder.path().join("set");
    click(&mut page, Role::Button, "Create 6 files…");
    into_folder(&mut page, &set);
    let names = ["FIT_CHECK.H", "FIT_HOLE.TAB", "FIT_MAIN.H", "FIT_SHAFT.TAB", "FIT_STATUS.A", "README.TXT"];
    assert_eq!(names_in(&set), names);
    page.get_by_label_contains("6 files were written to");
    let main = std::fs::read_to_string(set.join("FIT_MAIN.H")).unwrap();
    assert!(main.contains("Q11 = 40.5"), "{main}");
    // A second one asks, and nothing is replaced without leave.
    put(&set.join("FIT_MAIN.H"), "mine");
    click(&mut page, Role::Button, "Create 6 files…");
    into_folder(&mut page, &set);
    page.get_by_label_contains("already exists in this folder");
    click(&mut page, Role::Button, "Keep");
    assert_eq!(std::fs::read_to_string(set.join("FIT_MAIN.H")).unwrap(), "mine");
    page.run();
    into_folder(&mut page, &set);
    click(&mut page, Role::Button, "Replace");
    assert_eq!(std::fs::read_to_string(set.join("FIT_MAIN.H")).unwrap(), main);
    // What was written is opened here, and runs.
    let notices = page.state().session().notices().len();
    click(&mut page, Role::Button, "Open in Programs");
    assert_eq!(
        page.state().session().program().main().map(fitcheck::session::program::Document::title),
        Some("FIT_MAIN.H")
    );
    assert_eq!(page.state().session().notices().len() + 1, notices, "what it offered is done");
    press(&mut page, Key::F5);
    says(&page, "GOOD");
}

#[test]
fn a_set_for_a_series_or_with_texts_is_chosen_and_its_files_are_looked_at() {
    let mut page = Window::default().open();
    type_into(&mut page, "Callout", "25 H7");
    key(&mut page, Modifiers::COMMAND, Key::K);
    scan(&mut page, "create for a control⏎");
    let shown = |page: &Harness<'_, App>| {
        let creating = &page.state().session().program().creating;
        creating.shown().map(|(_, text)| text).unwrap_or_default()
    };
    page.get_by_label("FIT_CHECK.H").click();
    page.run();
    assert!(shown(&page).contains("TCH PROBE 421"), "{}", shown(&page));
    page.get_by_label_contains("TCH PROBE 421");
    // Only a control that has the cycle offers its texts.
    let texts = "Tolerances of diameters as texts of the cycle";
    assert!(page.query_by_label(texts).is_none());
    let ctx = page.ctx.clone();
    page.state_mut().send(&ctx, ProgramCommand::CreateFor(Control::Tnc7).into());
    page.run();
    page.get_by_label(texts).click();
    page.run();
    assert!(shown(&page).contains("TCH PROBE 1401"), "{}", shown(&page));
    page.get_by_label("FIT_CHECK.H").click();
    page.run();
    assert_eq!(shown(&page), "");
    page.get_by_label(texts).click();
    page.get_by_label("For a series: each start measures the next part").click();
    page.run();
    let set = page.state().session().program().creating.set().unwrap();
    assert!(set.files.iter().any(|file| file.name == "FIT_SERIES.TAB"));
}

#[test]
fn a_set_for_a_control_is_created_from_the_open_plan_or_says_what_is_wrong_with_it() {
    let folder = tempfile::tempdir().unwrap();
    let plan = folder.path().join("flange.csv");
    put(&plan, "name;callout;x;y;z\nA1;25 H7;40;30;-8\nA2;20 g6;90;30;-8\n");
    let files = vec![(fitcheck::session::Purpose::OpenPlan, plan)];
    let mut page = open(Window { files, ..Window::default() });
    click(&mut page, Role::Button, "Create for a control…");
    page.get_by(|node| {
        node.role() == Role::ComboBox && node.value().is_some_and(|v| v == "Plan flange.csv, 2 features")
    });
    page.get_by_label_contains("every feature gets the plan");
    // The control and the language decide what the files are called.
    click(&mut page, Role::ComboBox, "Control");
    click(&mut page, Role::Button, "iTNC 530");
    click(&mut page, Role::ComboBox, "Dialogue language");
    click(&mut page, Role::Button, "Deutsch");
    page.get_by_label("82551_de.h");
    page.get_by_label_contains(r"TNC:\8255\");
    let set = folder.path().join("set");
    click(&mut page, Role::Button, "Create 6 files…");
    into_folder(&mut page, &set);
    assert_eq!(names_in(&set).len(), 6, "{:?}", names_in(&set));
    // Without a plan's features there is nothing to create.
    click(&mut page, Role::ComboBox, "From");
    click(&mut page, Role::Button, "The callout on Check");
    page.get_by_label_contains("Enter a callout on Check");
    assert!(page.get_by_role_and_label(Role::Button, "Create files…").accesskit_node().is_disabled());
}

/// Drops a file of this text on the page.
fn drop_file(page: &mut Harnessed, folder: &Path, name: &str, text: &str) {
    let path = folder.join(name);
    put(&path, text);
    page.input_mut().dropped_files.push(std::sync::Arc::new(Dropped(path)));
    page.run();
}

/// A bore about 40/30.
const BORE: &str = "x,y,z\n52.505,30,-8\n40,42.505,-8\n27.495,30,-8\n40,17.495,-8\n";

#[test]
fn contacts_that_are_opened_for_a_program_are_not_measured_by_a_cycle() {
    let folder = tempfile::tempdir().unwrap();
    let mut page = page();
    drop_file(&mut page, folder.path(), "bore.csv", BORE);
    press(&mut page, Key::F5);
    says(&page, "GOOD. 25.0100 mm");
    key(&mut page, Modifiers::COMMAND, Key::Num7);
    assert_eq!(page.state().session().cycles().from, fitcheck::session::ContactsFrom::Perfect);
    assert!(page.state().session().cycles().recorded.is_none());
    // And the other way round: the program keeps its own.
    drop_file(&mut page, folder.path(), "other.csv", "x,y,z\n1,0,0\n");
    key(&mut page, Modifiers::COMMAND, Key::Num8);
    page.get_by_label("4 contacts from bore.csv");
}

#[test]
fn another_program_begins_without_the_filter_and_the_contacts_of_the_one_before_and_is_walked_by_key() {
    let folder = tempfile::tempdir().unwrap();
    let mut page = page();
    drop_file(&mut page, folder.path(), "bore.csv", BORE);
    type_into(&mut page, "Filter", "total");
    let path = program(folder.path(), "sum.h", "Q5 = 28.999999999999996\nQ6 = 40.00249999999999\nQ7 = 1 / 3");
    open_file(&mut page, &path);
    page.get_by_label("The contacts from bore.csv belong to the program before: this one measures a perfect workpiece");
    // The listing has the focus: a breakpoint is set where one is.
    press(&mut page, Key::ArrowDown);
    press(&mut page, Key::F9);
    page.get_by_label("Q5 = 28.999999999999996, breakpoint");
    press(&mut page, Key::F9);
    press(&mut page, Key::F5);
    says(&page, "Ended after");
    let parameters = parameters(&page);
    let named = |name: &str| parameters.iter().any(|said| said.trim_end_matches(", changed") == name);
    assert!(named("Q5  = 29") && named("Q6  = 40.0025") && named("Q7  = 0.333333"), "{parameters:?}");
    // A single block after the end is the first one.
    press(&mut page, Key::F10);
    says(&page, "Single block");
    assert_eq!(run(&page).blocks_run(), 1);
}

#[test]
fn the_window_that_is_exported_is_that_of_the_page() {
    let folder = tempfile::tempdir().unwrap();
    let mut page = page();
    let export = |page: &mut Harnessed| {
        click(page, Role::Button, "Menu");
        click(page, Role::Button, "Export");
    };
    export(&mut page);
    assert!(page.get_by_role_and_label(Role::Button, "Window of the program as text…").accesskit_node().is_disabled());
    press(&mut page, Key::Escape);
    press(&mut page, Key::F5);
    export(&mut page);
    click(&mut page, Role::Button, "Window of the program as text…");
    let path = folder.path().join("program.txt");
    type_into(&mut page, "File", &path.display().to_string());
    press(&mut page, Key::Enter);
    assert!(std::fs::read_to_string(&path).unwrap().contains("CHECKED FIT: 25 H7"));
    key(&mut page, Modifiers::COMMAND, Key::Num7);
    export(&mut page);
    page.get_by_role_and_label(Role::Button, "Status window of cycle 421 as text…");
}

#[test]
fn what_a_program_would_write_and_what_fitcheck_does_not_follow_is_said_with_what_to_do() {
    let folder = tempfile::tempdir().unwrap();
    let mut page = page();
    let log =
        "TOOL CALL 1 Z\nTCH PROBE 421 X ~\nQ273=+0 ~\nQ274=+0 ~\nQ262=+25 ~\nQ261=-5 ~\nQ320=+2 ~\nQ260=+50 ~\nQ281=+1";
    open_file(&mut page, &program(folder.path(), "log.h", log));
    press(&mut page, Key::F5);
    page.get_by_label_contains("TCHPR421.TXT would be written on the control");
    let path = program(folder.path(), "plane.h", "TOOL CALL 1 Z\nTCH PROBE 431 MEASURE PLANE ~\nQ263=+35");
    open_file(&mut page, &path);
    press(&mut page, Key::F5);
    page.get_by_label_contains("Fitcheck does not follow cycle 431, even where the control has it");
    page.get_by_label_contains("To run on without it, switch on Options → Skip unknown blocks");
}

#[test]
fn a_result_without_limits_has_no_verdict_and_a_broken_run_agrees_with_nothing() {
    let folder = tempfile::tempdir().unwrap();
    let cycle = |limits: &str| {
        format!(
            "TOOL CALL 1 Z\nTCH PROBE 421 X ~\nQ273=+0 ~\nQ274=+0 ~\nQ262=+25 ~\nQ261=-5 ~\nQ320=+2 ~\nQ260=+50 ~\n{limits}"
        )
    };
    let mut page = page();
    open_file(&mut page, &program(folder.path(), "bare.h", &cycle("Q275=+0 ~\nQ276=+0")));
    press(&mut page, Key::F5);
    says(&page, "No limits, no verdict");
    let body =
        format!("Q1 = 25\nDECLARE STRING QS1 = \"H7\"\n{}\nFN 14: ERROR = 1000", cycle("Q275=+25.021 ~\nQ276=+25"));
    open_file(&mut page, &program(folder.path(), "broken.h", &body));
    press(&mut page, Key::F5);
    says(&page, "Stopped with an error");
    says(&page, "Not compared: the program did not come to its end");
}
