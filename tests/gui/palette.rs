//! The palette in the window, by label and key.

use eframe::egui::accesskit::Role;
use eframe::egui::{Key, Modifiers};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;
use fitcheck::gui::App;
use fitcheck::session::{CheckField, Page, Theme};

use crate::harness::{click, press, scan, verdict, window};

fn opened() -> Harness<'static, App> {
    let mut window = window();
    window.key_press_modifiers(Modifiers::COMMAND, Key::K);
    window.run();
    window
}

#[test]
fn a_callout_is_typed_and_the_measured_value_comes_next() {
    let mut window = opened();
    scan(&mut window, "25 h6");
    window.get_by_label("Check 25 h6, 24.987 … 25.000 mm");
    press(&mut window, Key::Enter);
    assert_eq!(window.state().session().text(CheckField::Callout), "25 h6");
    scan(&mut window, "24.99⏎");
    assert!(verdict(&window).starts_with("GOOD. 24.990 mm"), "{}", verdict(&window));
}

#[test]
fn a_scanner_types_the_query_and_enter_at_once() {
    let mut window = opened();
    scan(&mut window, "dark⏎");
    assert_eq!(window.state().session().theme(), Theme::Dark);
    assert!(window.state().session().palette.is_none());
}

#[test]
fn what_comes_behind_enter_in_one_frame_is_the_measured_value() {
    let mut window = opened();
    scan(&mut window, "25 h6⏎24.99⏎");
    assert!(verdict(&window).starts_with("GOOD. 24.990 mm"), "{}", verdict(&window));
}

#[test]
fn arrows_choose_and_a_click_does_what_an_entry_stands_for() {
    let mut window = opened();
    scan(&mut window, "budget");
    let at = |window: &Harness<'_, App>| window.state().session().palette.as_ref().unwrap().at;
    press(&mut window, Key::ArrowDown);
    press(&mut window, Key::ArrowDown);
    press(&mut window, Key::ArrowUp);
    assert_eq!(at(&window), 1);
    click(&mut window, Role::ListBoxOption, "New budget, Uncertainty");
    assert_eq!(window.state().session().page(), Page::Budget);
}

#[test]
fn a_page_is_found_by_the_name_that_it_had() {
    for (query, name, page) in [
        ("fit", "Fits", Page::Fit),
        ("program", "Programs", Page::Program),
        ("budget", "Uncertainty", Page::Budget),
        ("passing", "Fits", Page::Fit),
        ("onzekerheid", "Uncertainty", Page::Budget),
    ] {
        let mut window = opened();
        scan(&mut window, query);
        click(&mut window, Role::ListBoxOption, name);
        assert_eq!(window.state().session().page(), page, "{query}");
    }
}

#[test]
fn escape_closes_it_and_the_keys_of_the_page_are_not_heard_meanwhile() {
    let mut window = opened();
    window.key_press_modifiers(Modifiers::COMMAND, Key::Num4);
    window.run();
    assert_eq!(window.state().session().page(), Page::Check);
    press(&mut window, Key::Escape);
    assert!(window.state().session().palette.is_none());
    // The keys are where they were before.
    scan(&mut window, "12 g6");
    assert_eq!(window.state().session().text(CheckField::Callout), "12 g6");
    window.key_press_modifiers(Modifiers::COMMAND, Key::Num4);
    window.run();
    assert_eq!(window.state().session().page(), Page::Fit);
}
