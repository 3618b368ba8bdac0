//! The cycles page: every cycle of the seeds typed into its form, run, stepped and read back.

use std::path::PathBuf;
use std::time::Duration;

use eframe::egui::accesskit::{Role, Toggled};
use eframe::egui::{Key, Modifiers, OutputCommand, Theme, Vec2, ViewportId, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use fitcheck::gui::App;
use fitcheck::session::{CycleField, Page};
use fitcheck::words::Language;

use crate::harness::{DESK, Window, type_into, verdict};
use crate::pictures::can_paint;

/// The page, opened by its key.
fn open(window: Window) -> Harness<'static, App> {
    let mut harness = window.open();
    harness.key_press_modifiers(Modifiers::COMMAND, Key::Num3);
    harness.run();
    assert_eq!(harness.state().session().page(), Page::Cycles);
    harness
}

fn page() -> Harness<'static, App> {
    open(Window::default())
}

fn click(window: &mut Harness<'_, App>, role: Role, label: &str) {
    window.get_by_role_and_label(role, label).click_accesskit();
    window.run();
}

fn key(window: &mut Harness<'_, App>, modifiers: Modifiers, key: Key) {
    window.key_press_modifiers(modifiers, key);
    window.run();
}

/// Chooses a cycle by what the list calls it.
fn choose(window: &mut Harness<'_, App>, name: &str) {
    click(window, Role::ComboBox, "Cycle");
    click(window, Role::Button, name);
}

/// The name of a parameter's field: its key and the control's question.
fn name(window: &Harness<'_, App>, key: &str) -> String {
    let cycle = window.state().session().cycles().cycle();
    let parameter = cycle.parameter_named(key).unwrap_or_else(|| panic!("no {key}"));
    format!("{}  {}", parameter.key, parameter.question(window.state().session().language()))
}

/// Fills the form: fields are typed, choices are picked from their list.
fn fill(window: &mut Harness<'_, App>, settings: &[(&str, &str)]) {
    for (parameter, text) in settings {
        let name = name(window, parameter);
        if window.query_by_role_and_label(Role::ComboBox, &name).is_some() {
            click(window, Role::ComboBox, &name);
            let choice = window.get_all_by_role(Role::Button).find(|node| {
                let label = node.accesskit_node().label().unwrap_or_default();
                label.split("  ").next() == Some(&text.replace('-', "−")) && label.contains("  ")
            });
            choice.unwrap_or_else(|| panic!("no choice {text} for {name}")).click_accesskit();
            window.run();
        } else {
            type_into(window, &name, text);
        }
    }
}

/// What stands in the list of results behind a key.
fn result(window: &Harness<'_, App>, key: &str) -> String {
    let run = window.state().session().cycles().run().expect("a run");
    let found = run.found().unwrap_or_else(|| panic!("{:?}", run.result));
    let found = found.results.iter().find(|found| found.key.to_string() == key).expect(key);
    // The list shows it, too.
    window.get_by_label(key);
    found.value.to_string()
}

const BLOCK_427: [(&str, &str); 12] = [
    ("Q263", "+35"),
    ("Q264", "+45"),
    ("Q261", "+5"),
    ("Q320", "+0"),
    ("Q272", "3"),
    ("Q267", "-1"),
    ("Q260", "+20"),
    ("Q281", "1"),
    ("Q288", "+5,1"),
    ("Q289", "+4.95"),
    ("Q309", "0"),
    ("Q330", "+0"),
];

/// The page with the block of seed 004, typed.
fn coordinate(window: Window) -> Harness<'static, App> {
    let mut window = open(window);
    choose(&mut window, "427  MEASURE COORDINATE");
    fill(&mut window, &BLOCK_427);
    window
}

/// The page with cycle 422 on a stud that is a tenth too thick.
fn stud(window: Window) -> Harness<'static, App> {
    let mut window = open(window);
    choose(&mut window, "422  MEAS. CIRCLE OUTSIDE");
    let block = [("Q273", "50"), ("Q274", "50"), ("Q262", "75"), ("Q277", "74.9"), ("Q278", "74.8"), ("Q309", "1")];
    fill(&mut window, &block);
    window
}

#[test]
fn the_block_of_seed_004_is_typed_run_and_read_back() {
    let mut window = coordinate(Window::default());
    assert_eq!(verdict(&window), "No result");
    key(&mut window, Modifiers::NONE, Key::Enter);
    assert_eq!(
        verdict(&window),
        "GOOD. 5.0000 mm. measured coordinate. 50.0 µm above minimum. 100.0 µm below maximum"
    );
    assert_eq!((result(&window, "Q160"), result(&window, "Q180")), ("5".to_owned(), "1".to_owned()));
    window.get_by_label_contains("COORDINATE STATUS: GOOD");
    window.get_by_label("The control writes TCHPR427.TXT");
    window.get_by_label_contains("an outside dimension is assumed");
}

/// Runs the cycle and compares the picture.
fn picture(name: &str, open: fn(Window) -> Harness<'static, App>, theme: Theme, size: Vec2) {
    if can_paint(name) {
        let mut window = open(Window { theme, size, ..Window::default() });
        key(&mut window, Modifiers::NONE, Key::Enter);
        window.remove_cursor();
        window.snapshot(name);
    }
}

#[test]
fn a_coordinate_in_light() {
    picture("cycle_427_light", coordinate, Theme::Light, DESK);
}

#[test]
fn a_stud_to_rework_in_dark() {
    picture("cycle_422_dark", stud, Theme::Dark, DESK);
}

#[test]
fn a_stud_in_a_small_window() {
    picture("cycle_422_small", stud, Theme::Light, vec2(1024.0, 600.0));
}

#[test]
fn a_simulated_bore_in_light() {
    picture("cycle_421_light", hole, Theme::Light, DESK);
}

#[test]
fn a_point_in_dark() {
    picture("cycle_444_dark", point, Theme::Dark, DESK);
}

#[test]
fn a_circle_of_a_lathe_in_light() {
    picture("cycle_g785_light", lathe, Theme::Light, DESK);
}

/// The page with cycle 421 on a bore that is a little oval and lies a little off.
fn hole(window: Window) -> Harness<'static, App> {
    let mut window = open(window);
    let block =
        [("Q273", "50"), ("Q274", "20"), ("Q262", "25"), ("Q261", "-5"), ("Q275", "25.021"), ("Q276", "25"), ("Q281", "1")];
    fill(&mut window, &block);
    click(&mut window, Role::RadioButton, "Simulated");
    click(&mut window, Role::Button, "Fit to cycle");
    click(&mut window, Role::Button, "Workpiece…");
    for (name, text) in [("True diameter", "25.012"), ("Centre, 1st axis", "50.003")] {
        type_into(&mut window, name, text);
    }
    click(&mut window, Role::Button, "Close");
    fill(&mut window, &[("Q273", "50")]);
    window
}

/// The page with cycle 444 on a slanted surface.
fn point(window: Window) -> Harness<'static, App> {
    let mut window = open(window);
    choose(&mut window, "444  PROBING IN 3-D");
    let block =
        [("Q263", "1"), ("Q264", "2"), ("Q294", "3"), ("Q581", "0"), ("Q582", "1"), ("Q583", "1"), ("QS400", "0.4-0.1")];
    fill(&mut window, &block);
    window
}

/// The page with the block of seed 003.
fn lathe(window: Window) -> Harness<'static, App> {
    let mut window = open(window);
    choose(&mut window, "G785  CIRCLE MEASUREMENT");
    fill(&mut window, &[("R", "0"), ("BR", "0"), ("K", "2"), ("C", "0"), ("RC", "60"), ("I", "0"), ("J", "0")]);
    window
}
