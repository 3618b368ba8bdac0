//! Hole against shaft: typing a fit, picking one, choosing classes, searching, measured parts.

use std::time::Duration;

use eframe::egui::accesskit::{Live, Role, Toggled};
use eframe::egui::{Key, Modifiers, Theme, Vec2, ViewportId, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use fitcheck::gui::{App, Store};
use fitcheck::session::{CheckField, FitField, Page};
use fitcheck::words::Language;

use crate::harness::{DESK, Window, type_into, verdict};
use crate::pictures::can_paint;

/// The fit page, opened by its key.
fn open(window: Window) -> Harness<'static, App> {
    let mut harness = window.open();
    harness.key_press_modifiers(Modifiers::COMMAND, Key::Num4);
    harness.run();
    harness
}

fn page() -> Harness<'static, App> {
    open(Window::default())
}

/// The fit page with a fit.
fn fit(callout: &str) -> Harness<'static, App> {
    let mut window = page();
    type_into(&mut window, "Fit of hole and shaft", callout);
    window
}

fn callout(window: &Harness<'_, App>) -> String {
    window.state().session().text(FitField::Callout).to_owned()
}

fn click(window: &mut Harness<'_, App>, role: Role, label: &str) {
    window.get_by_role_and_label(role, label).click();
    window.run();
}

/// The name of the widget that has the focus.
#[expect(clippy::redundant_closure_for_method_calls, reason = "the method alone is not general over lifetimes")]
fn focused(window: &Harness<'_, App>) -> String {
    window.get_by(|node| node.is_focused()).accesskit_node().label().unwrap_or_default()
}

#[test]
fn the_kind_of_a_fit_depends_on_the_size() {
    for (typed, said) in [
        (
            "50 H7/p6",
            "Interference fit. −42 … −1 µm. Maximum interference 42 µm. Minimum interference 1 µm. Mean interference 21.5 µm",
        ),
        (
            "2 H7/p6",
            "Transition fit. −12 … +4 µm. Maximum clearance 4 µm. Maximum interference 12 µm. Mean interference 4 µm",
        ),
        (
            "25 H7/h6",
            "Clearance fit. 0 … +34 µm. Maximum clearance 34 µm. Minimum clearance 0 µm. Mean clearance 17 µm",
        ),
        (
            "25 H7-g6",
            "Clearance fit. +7 … +41 µm. Maximum clearance 41 µm. Minimum clearance 7 µm. Mean clearance 24 µm",
        ),
    ] {
        assert_eq!(verdict(&fit(typed)), said, "{typed}");
    }
}

#[test]
fn an_empty_page_shows_an_example_until_something_is_typed() {
    let mut window = page();
    let example = "an example: 25 H7/g6";
    // ISO 286-2: H7 of 25 mm is 0 to +21, g6 is -20 to -7.
    let said = format!(
        "{example}. Clearance fit. +7 … +41 µm. Maximum clearance 41 µm. Minimum clearance 7 µm. Mean clearance 24 µm"
    );
    assert_eq!(verdict(&window), said);
    let picture = window.get_by_role_and_label(Role::Image, "Hole and shaft zones");
    let described = picture.accesskit_node().data().description().unwrap_or_default().to_owned();
    assert!(
        described.starts_with("an example: 25 H7/g6. Zero line at 25 mm. Hole H7 from 0 to +21 µm."),
        "{described}"
    );
    // It is in no field, has no classes to choose and nothing to check.
    assert_eq!(callout(&window), "");
    window.get_by_label("The classes appear with a nominal size");
    assert!(window.query_by_label("Check the hole").is_none());
    for field in ["Fit of hole and shaft", "Measured hole", "Measured shaft", "Minimum", "Maximum"] {
        type_into(&mut window, field, "3");
        assert_eq!(verdict(&window), "No fit yet", "{field}");
        assert!(window.query_by_label(example).is_none(), "{field}");
        assert!(window.query_by_role_and_label(Role::Image, "Hole and shaft zones").is_none(), "{field}");
        type_into(&mut window, field, "");
        assert_eq!(verdict(&window), said, "{field}");
    }
}

#[test]
fn the_answer_is_polite_and_names_limits_and_their_source() {
    let window = fit("50 H7/p6");
    let status = window.get_by_role(Role::Status);
    assert_eq!(status.accesskit_node().data().live(), Some(Live::Polite));
    for text in ["50.025", "50.000", "50.042", "50.026", "+25 µm", "+42 µm", "+26 µm"] {
        window.get_by_label(text);
    }
    assert_eq!(window.get_all_by_label("from ISO 286, over 30 up to 50 mm").count(), 2);
    window.get_by_label("H7/p6: preferred fit of the hole basis; ANSI B4.2: locational interference");
}

#[test]
fn the_picture_describes_itself() {
    let mut window = fit("25 H7/g6");
    type_into(&mut window, "Measured hole", "25.010");
    let picture = window.get_by_role_and_label(Role::Image, "Hole and shaft zones");
    let said = picture.accesskit_node().data().description().unwrap_or_default().to_owned();
    assert_eq!(
        said,
        "Zero line at 25 mm. Hole H7 from 0 to +21 µm. Fundamental deviation 0 µm. Shaft g6 from −20 to −7 µm. \
         Fundamental deviation −7 µm. Maximum clearance 41 µm. Minimum clearance 7 µm. Hole measured at +10 µm."
    );
}

#[test]
fn measured_parts_have_a_clearance_and_a_verdict_each() {
    let mut window = fit("50 H7/p6");
    type_into(&mut window, "Measured hole", "50.010");
    window.get_by_label("Clearance with a good shaft");
    window.get_by_label("−32 … −16 µm");
    type_into(&mut window, "Measured shaft", "50.030");
    window.get_by_label("Interference 20 µm");
    window.get_by_label("Within the limits of the callout");
    window.get_by_role_and_label(Role::Label, "Hole GOOD");
    window.get_by_role_and_label(Role::Label, "Shaft GOOD");
    // A nanometre past the border of the range and of the shaft.
    type_into(&mut window, "Measured hole", "50.000");
    type_into(&mut window, "Measured shaft", "50.042");
    window.get_by_label("Within the limits of the callout");
    type_into(&mut window, "Measured shaft", "50.042001");
    window.get_by_label("Outside the limits of the callout");
    window.get_by_role_and_label(Role::Label, "Shaft REWORK");
}

#[test]
fn errors_stand_beside_their_field() {
    let mut window = fit("24 H7/t6");
    window.get_by_label_contains("it is defined over 24 up to 3150 mm");
    assert_eq!(verdict(&window), "No fit yet");
    type_into(&mut window, "Fit of hole and shaft", "25 g6/H7");
    window.get_by_label_contains("the shaft comes before the hole: write 25 H7/g6");
    type_into(&mut window, "Fit of hole and shaft", "25 H7");
    window.get_by_label("The shaft's class is missing, such as g6 in 25 H7/g6");
    type_into(&mut window, "Measured hole", "25.0.1");
    window.get_by_label("25.0.1 is not a number");
    type_into(&mut window, "Measured hole", "-25");
    window.get_by_label_contains("25 is not above 0");
    type_into(&mut window, "Temperature", "2000");
    window.get_by_label_contains("a temperature of 2000 °C is out of range");
    type_into(&mut window, "Hole, µm/(m K)", "steel");
    window.get_by_label("steel is not a number");
}

#[test]
fn a_preferred_fit_is_picked_from_the_list() {
    let mut window = fit("25,5 H7/g6");
    click(&mut window, Role::ComboBox, "Preferred fit");
    window.get_by_label("Shaft basis");
    click(&mut window, Role::Button, "F8/h9");
    assert_eq!(callout(&window), "25,5 F8/h9");
    window.get_by_label_contains("preferred fit of the shaft basis");
}

#[test]
fn a_function_is_picked_in_either_basis() {
    let mut window = fit("25 H7/p6");
    click(&mut window, Role::ComboBox, "Function");
    window.get_by_label("sliding");
    click(&mut window, Role::Button, "G7/h6");
    assert_eq!(callout(&window), "25 G7/h6");
    window.get_by_label_contains("ANSI B4.2: sliding");
}

#[test]
fn a_class_is_chosen_in_the_map() {
    let mut window = fit("25 H7/g6");
    let chosen = |window: &Harness<'_, App>, class: &str| {
        window.get_by_role_and_label(Role::RadioButton, class).accesskit_node().data().toggled()
    };
    assert_eq!(chosen(&window, "H7"), Some(Toggled::True));
    assert_eq!(chosen(&window, "H8"), Some(Toggled::False));
    click(&mut window, Role::RadioButton, "F8");
    assert_eq!(callout(&window), "25 F8/g6");
    click(&mut window, Role::Button, "Shaft classes");
    click(&mut window, Role::RadioButton, "zc9");
    assert_eq!(callout(&window), "25 F8/zc9");
    // 25 mm has a T and a t, 24 mm has none.
    window.get_by_role_and_label(Role::RadioButton, "t6");
    type_into(&mut window, "Fit of hole and shaft", "24 H7/g6");
    assert!(window.query_by_role_and_label(Role::RadioButton, "t6").is_none());
    window.get_by_role_and_label(Role::RadioButton, "s6");
}

#[test]
fn the_map_appears_with_the_size_and_makes_a_fit_of_it() {
    let mut window = page();
    window.get_by_label("The classes appear with a nominal size");
    type_into(&mut window, "Fit of hole and shaft", "40");
    window.get_by_label("Classes at 40 mm");
    click(&mut window, Role::RadioButton, "H7");
    click(&mut window, Role::Button, "Shaft classes");
    click(&mut window, Role::RadioButton, "k6");
    assert_eq!(callout(&window), "40 H7/k6");
    assert!(verdict(&window).starts_with("Transition fit"));
}

#[test]
fn arrows_walk_over_defined_classes() {
    let mut window = fit("25 H7/g6");
    window.get_by_role_and_label(Role::RadioGroup, "Hole classes").focus();
    window.run();
    for (key, class) in [
        (Key::ArrowRight, "J7"),
        (Key::ArrowDown, "J8"),
        (Key::ArrowDown, "J8"),
        (Key::ArrowLeft, "H8"),
        (Key::ArrowUp, "H7"),
        (Key::ArrowLeft, "G7"),
    ] {
        window.key_press(key);
        window.run();
        assert_eq!(callout(&window), format!("25 {class}/g6"), "{key:?}");
    }
    assert_eq!(focused(&window), "Hole classes", "the focus stays");
}

#[test]
fn the_equivalent_fit_is_told_and_taken_over() {
    let mut window = fit("25 H7/p6");
    window.get_by_label("Exactly the same clearances");
    click(&mut window, Role::Button, "Equivalent fit");
    assert_eq!(callout(&window), "25 P7/h6");
    // The hole's Δ is made for a shaft one grade finer: P7 is −14 to −35, p7 +43 to +22.
    type_into(&mut window, "Fit of hole and shaft", "25 H7/p7");
    window.get_by_label("Not the same: smallest clearance +8 µm, largest +8 µm");
}

#[test]
fn a_search_finds_the_classes_that_give_a_clearance() {
    let mut window = fit("25 H8/f7");
    type_into(&mut window, "Minimum", "7 µm");
    window.get_by_label_contains("The smallest and the largest clearance");
    type_into(&mut window, "Maximum", "0.041");
    window.get_by_label_contains(" fits");
    let pair = "H7/g6  +7 … +41 µm  preferred";
    click(&mut window, Role::Button, pair);
    assert_eq!(callout(&window), "25 H7/g6");
    // A nanometre less on either side and the pair is gone.
    for (minimum, maximum) in [("7.001 µm", "41 µm"), ("7 µm", "40.999 µm")] {
        type_into(&mut window, "Minimum", minimum);
        type_into(&mut window, "Maximum", maximum);
        assert!(window.query_by_role_and_label(Role::Button, pair).is_none(), "{minimum} {maximum}");
    }
    type_into(&mut window, "Minimum", "1");
    window.get_by_label_contains("smallest clearance 1 mm is above largest clearance");
}

#[test]
fn the_nearest_miss_is_offered_and_the_scope_narrows() {
    let mut window = fit("25 H7/g6");
    type_into(&mut window, "Minimum", "0.007");
    type_into(&mut window, "Maximum", "0.041");
    click(&mut window, Role::ComboBox, "Among");
    click(&mut window, Role::Button, "Preferred and named fits");
    window.get_by_role_and_label(Role::Button, "H7/g6  +7 … +41 µm  preferred");
    type_into(&mut window, "Minimum", "0.0405");
    window.get_by_label("No fit matches. The nearest one");
    window.get_by_label_contains("µm too little");
}

#[test]
fn the_clearance_follows_temperature_and_materials() {
    let mut window = fit("50 H7/g6");
    click(&mut window, Role::ComboBox, "Material of the hole");
    click(&mut window, Role::Button, "aluminium  23.1");
    type_into(&mut window, "Temperature", "80");
    // (23.1 − 11.5) · 60 · 50 mm = 34.8 µm; H7/g6 at 50 mm is 9 to 50 µm.
    window.get_by_label("At 80 °C");
    window.get_by_label("+43.8 … +84.8 µm");
    window.get_by_label("Clearance fit; clearance changes by +34.8 µm");
    type_into(&mut window, "Hole, µm/(m K)", "24");
    window.get_by_label("Clearance fit; clearance changes by +37.5 µm");
}

#[test]
fn both_sides_go_to_the_check_page() {
    for (button, text) in [("Check the hole", "25 H7"), ("Check the shaft", "25 g6")] {
        let mut window = fit("25 H7/g6");
        click(&mut window, Role::Button, button);
        assert_eq!(window.state().session().page(), Page::Check);
        assert_eq!(window.state().session().text(CheckField::Callout), text);
        window.get_by_role_and_label(Role::TextInput, "Measured value");
    }
}

#[test]
fn the_page_works_by_key_alone_and_enter_measures_nothing() {
    let mut window = page();
    assert_eq!(focused(&window), "Fit of hole and shaft");
    window.get_by_role_and_label(Role::TextInput, "Fit of hole and shaft").type_text("50 H7/p6");
    window.key_press(Key::Enter);
    window.run();
    assert!(verdict(&window).starts_with("Interference fit"));
    let mut walked = Vec::new();
    for _ in 0..14 {
        window.key_press(Key::Tab);
        window.run();
        walked.push(focused(&window));
    }
    assert_eq!(
        walked,
        [
            "Preferred fit",
            "Function",
            "Measured hole",
            "Measured shaft",
            "Temperature",
            "Material of the hole",
            "Hole, µm/(m K)",
            "Material of the shaft",
            "Shaft, µm/(m K)",
            "Length of the joint",
            "Hub outside",
            "Shaft bore",
            "Minimum",
            "Maximum",
        ]
    );
    assert!(window.state().session().history().is_empty());
}

#[test]
fn decimal_commas_in_dutch() {
    let mut window = open(Window { language: Language::Nl, ..Window::default() });
    type_into(&mut window, "Passing van boring en as", "50,5 H7/p6");
    type_into(&mut window, "Gemeten boring", "50,510");
    type_into(&mut window, "Gemeten as", "50,5405");
    window.get_by_label("Overmaat 30,5 µm");
    assert!(verdict(&window).starts_with("Perspassing. −51 … −2 µm"), "{}", verdict(&window));
    window.get_by_label("50,530");
    click(&mut window, Role::ComboBox, "Materiaal as");
    click(&mut window, Role::Button, "gietijzer  10,5");
    assert_eq!(window.state().session().text(FitField::ShaftExpansion), "10,5");
}

#[test]
fn the_fields_survive_a_restart() {
    let folder = tempfile::tempdir().unwrap();
    let store = Store::at(&folder.path().join("fitcheck").join("state.toml"));
    let mut first = open(Window { store: store.clone(), ..Window::default() });
    type_into(&mut first, "Fit of hole and shaft", "50 H7/p6");
    type_into(&mut first, "Measured hole", "50.010");
    eframe::App::on_exit(first.state_mut(), None);
    let again = open(Window { store, ..Window::default() });
    assert_eq!(callout(&again), "50 H7/p6");
    again.get_by_label("Clearance with a good shaft");
}

#[test]
fn own_materials_are_offered_and_a_broken_file_is_told() {
    let folder = tempfile::tempdir().unwrap();
    let put = |text: &str| {
        let path = folder.path().join("materials.toml");
        std::fs::File::create(path).and_then(|mut file| std::io::Write::write_all(&mut file, text.as_bytes())).unwrap();
    };
    let own_window = || {
        let store = Store::at(&folder.path().join("state.toml"));
        let mut window = open(Window { store, ..Window::default() });
        type_into(&mut window, "Fit of hole and shaft", "50 H7/h6");
        window
    };
    put("version = 1\n[[material]]\nname = \"steel\"\nexpansion = 17.3\nsource = \"our mill\"\n");
    let mut window = own_window();
    click(&mut window, Role::ComboBox, "Material of the hole");
    click(&mut window, Role::Button, "steel  17.3");
    // 50 mm, (17.3 - 11.5) in a million and a kelvin, 60 K.
    type_into(&mut window, "Temperature", "80");
    // The shaft's field still has its last value.
    window.get_by_label("Clearance fit; clearance changes by +17.4 µm");
    put("version = 1\n[[material]]\nname = 7\n");
    let window = own_window();
    window.get_by_label_contains("materials.toml, line 3");
}

#[test]
fn the_settled_page_asks_for_no_repaint() {
    let mut window = fit("50 H7/p6");
    type_into(&mut window, "Measured hole", "50.010");
    type_into(&mut window, "Measured shaft", "50.030");
    type_into(&mut window, "Minimum", "0");
    type_into(&mut window, "Maximum", "0.2");
    window.run();
    let delay = window.output().viewport_output[&ViewportId::ROOT].repaint_delay;
    assert_eq!(delay, Duration::MAX);
}

#[test]
fn nothing_lies_beside_a_small_window() {
    let mut window = open(Window { size: vec2(1024.0, 600.0), ..Window::default() });
    type_into(&mut window, "Fit of hole and shaft", "50 H7/p6");
    type_into(&mut window, "Measured hole", "50.010");
    type_into(&mut window, "Measured shaft", "50.030");
    let seen = window.get_all_by(|node| node.label().is_some());
    for node in seen {
        let rect = node.rect();
        assert!(-1.0 <= rect.left() && rect.right() <= 1025.0, "{:?} at {rect:?}", node.accesskit_node().label());
    }
}

/// The whole map lies left of the answer, even where words are longer.
#[test]
fn a_small_window_shows_every_class_in_dutch_too() {
    let mut window = open(Window { size: vec2(1024.0, 600.0), language: Language::Nl, ..Window::default() });
    type_into(&mut window, "Passing van boring en as", "25 H7/g6");
    let answer = window.get_by_label("Spelingpassing").rect();
    for class in ["A7", "H7", "ZC7"] {
        let rect = window.get_by_role_and_label(Role::RadioButton, class).rect();
        assert!(rect.right() < 1024.0 && !rect.intersects(answer), "{class}: {rect:?} {answer:?}");
    }
}

fn picture(name: &str, theme: Theme, size: Vec2, callout: &str, parts: [&str; 2]) {
    if !can_paint(name) {
        return;
    }
    let mut window = open(Window { size, theme, ..Window::default() });
    type_into(&mut window, "Fit of hole and shaft", callout);
    for (name, text) in ["Measured hole", "Measured shaft"].into_iter().zip(parts) {
        type_into(&mut window, name, text);
    }
    type_into(&mut window, "Minimum", "-42 µm");
    type_into(&mut window, "Maximum", "41 µm");
    window.snapshot(name);
}

#[test]
fn an_interference_fit_with_parts_in_light() {
    picture("fit_interference_light", Theme::Light, DESK, "50 H7/p6", ["50.010", "50.030"]);
}

#[test]
fn a_clearance_fit_in_dark() {
    picture("fit_clearance_dark", Theme::Dark, vec2(1024.0, 600.0), "25 H7/g6", ["25.012", "24.900"]);
}

#[test]
fn a_measured_part_that_may_be_another_quantity_is_doubted() {
    let mut window = fit("25 H7/g6");
    type_into(&mut window, "Measured hole", "250.12");
    window.get_by_label_contains("is it 25.012 mm?");
    type_into(&mut window, "Measured hole", "25.012");
    assert!(window.query_by_label_contains("is it 25.012 mm?").is_none());
}
