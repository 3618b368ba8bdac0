//! The window works by keyboard alone, and an idle window draws nothing.

use std::time::Duration;

use eframe::egui::accesskit::Role;
use eframe::egui::{Event, Key, Modifiers, PointerButton, TouchDeviceId, TouchId, TouchPhase, ViewportId, pos2};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use fitcheck::gui::App;
use fitcheck::session::{CheckField, Command, Control, Page, SETTINGS, Section, SettingsCommand};
use fitcheck::words::{Language, Words};

use crate::harness::{Window, check, type_into, unfold, verdict, window};

/// The name of the widget that has the focus.
#[expect(clippy::redundant_closure_for_method_calls, reason = "the method alone is not general over lifetimes")]
fn focused(window: &Harness<'_, App>) -> String {
    window.get_by(|node| node.is_focused()).accesskit_node().label().unwrap_or_default()
}

#[test]
fn typing_tab_typing_enter_is_a_check() {
    let mut window = window();
    assert_eq!(focused(&window), "Callout", "the callout has the focus at the start");
    window.get_by_role_and_label(Role::TextInput, "Callout").type_text("25 H7");
    window.run();
    window.key_press(Key::Tab);
    window.run();
    assert_eq!(focused(&window), "Measured value");
    window.get_by_role_and_label(Role::TextInput, "Measured value").type_text("25.012");
    window.run();
    window.key_press(Key::Enter);
    window.run();
    assert!(verdict(&window).starts_with("GOOD"));
    // The next value can come at once: the focus stays and typing replaces.
    assert_eq!(focused(&window), "Measured value");
    window.get_by_role_and_label(Role::TextInput, "Measured value").type_text("25.030");
    window.key_press(Key::Enter);
    window.run();
    assert!(verdict(&window).starts_with("SCRAP"), "{}", verdict(&window));
    window.get_by_label("2 checks");
}

#[test]
fn one_enter_is_one_check() {
    let mut window = window();
    check(&mut window, "25 H7", "25.012");
    window.get_by_label("1 check");
}

#[test]
fn tab_walks_in_reading_order() {
    let mut window = window();
    type_into(&mut window, "Callout", "25 H7");
    let mut walked = Vec::new();
    for _ in 0..14 {
        window.key_press(Key::Tab);
        window.run();
        walked.push(focused(&window));
    }
    assert_eq!(
        walked,
        [
            "Measured value",
            "Keypad",
            "Type",
            "Simulate",
            "Judge",
            "Clear",
            "Nominal size",
            "Class",
            "Probe position: X 0 Y 0 Z −5",
            "Simulated workpiece",
            "Decision rule: the limits decide",
            "Temperature: not corrected",
            "Part",
            "Record",
        ]
    );
}

#[test]
fn the_settled_window_asks_for_no_repaint() {
    let mut window = window();
    check(&mut window, "25 H7", "25.012");
    window.run();
    let delay = window.output().viewport_output[&ViewportId::ROOT].repaint_delay;
    assert_eq!(delay, Duration::MAX);
}

#[test]
fn a_check_works_by_touch_alone() {
    let mut window = window();
    window.get_by_role_and_label(Role::Button, "Keypad").click();
    window.run();
    let press = |window: &mut Harness<'_, App>, keys: &[&str]| {
        for key in keys {
            window.get_by_role_and_label(Role::Button, key).click();
            window.run();
        }
    };
    press(&mut window, &["Key 2", "Key 5"]);
    assert_eq!(window.state().session().text(CheckField::Measured), "25", "its key stands in the field of the value");
    press(&mut window, &["Clear"]);
    window.get_by_role_and_label(Role::TextInput, "Callout").click();
    window.run();
    press(&mut window, &["Key 2", "Key 5"]);
    assert_eq!(window.state().session().text(CheckField::Callout), "25");
    window.get_by_role_and_label(Role::ComboBox, "Class").scroll_to_me();
    window.run();
    window.get_by_role_and_label(Role::ComboBox, "Class").click();
    window.run();
    press(&mut window, &["H7"]);
    window.get_by_role_and_label(Role::TextInput, "Measured value").scroll_to_me();
    window.run();
    window.get_by_role_and_label(Role::TextInput, "Measured value").click();
    window.run();
    press(&mut window, &["Key 2", "Key 5", "Decimal sign", "Key 0", "Key 3", "Key 3"]);
    press(&mut window, &["Delete last character", "Key 0", "Enter"]);
    assert!(verdict(&window).starts_with("SCRAP. 25.030 mm"), "{}", verdict(&window));
}

/// Presses the pointer at a widget and releases it after some frames.
fn click_for(window: &mut Harness<'_, App>, name: &str, frames: usize) {
    let at = window.get_by_role_and_label(Role::TextInput, name).rect().center();
    let button =
        |pressed| Event::PointerButton { pos: at, button: PointerButton::Primary, pressed, modifiers: Modifiers::NONE };
    window.event(Event::PointerMoved(at));
    window.step();
    window.event(button(true));
    window.run_steps(frames);
    window.event(button(false));
    window.run_steps(2);
}

#[test]
fn a_click_selects_the_text_however_long_it_is() {
    for frames in [1, 4, 36] {
        let mut window = window();
        type_into(&mut window, "Callout", "25 H7");
        type_into(&mut window, "Measured value", "25.012");
        type_into(&mut window, "Callout", "25 H7");
        click_for(&mut window, "Measured value", frames);
        window.get_by_role_and_label(Role::TextInput, "Measured value").type_text("25.03");
        window.run();
        assert_eq!(window.state().session().text(CheckField::Measured), "25.03", "{frames} frames");
    }
}

#[test]
fn the_keypad_replaces_what_is_selected_and_keeps_the_focus_on_the_field() {
    let mut window = window();
    type_into(&mut window, "Callout", "25 H7");
    type_into(&mut window, "Measured value", "25.012");
    window.get_by_role_and_label(Role::Button, "Keypad").click();
    window.run();
    click_for(&mut window, "Callout", 4);
    click_for(&mut window, "Measured value", 4);
    let mut press = |key: &str| {
        window.get_by_role_and_label(Role::Button, key).click();
        window.run();
        assert_eq!(focused(&window), "Measured value", "after {key}");
        window.state().session().text(CheckField::Measured).to_owned()
    };
    let said = ["Key 2", "Key 5", "Decimal sign", "Decimal sign", "Key 0", "Decimal sign", "Key 3"].map(&mut press);
    assert_eq!(said, ["2", "25", "25.", "25.", "25.0", "25.0", "25.03"]);
    press("Enter");
    assert_eq!(press("Key 9"), "9", "after Enter the next value replaces the last one");
}

#[test]
fn the_keypad_has_letters_for_classes() {
    let mut window = window();
    window.get_by_role_and_label(Role::Button, "Keypad").click();
    window.run();
    click_for(&mut window, "Callout", 4);
    for (keys, after) in [
        (["Key 2", "Key 5", "Classes of holes", "Key H7"].as_slice(), "25 H7"),
        (&["Classes of holes", "Classes of shafts", "Key g6"], "25 g6"),
        (&["Classes of holes", "Letters", "M to X", "Y, Z and signs", "Space", "Figures", "Empty"], ""),
    ] {
        for key in keys {
            window.get_by_role_and_label(Role::Button, key).click();
            window.run();
        }
        assert_eq!(window.state().session().text(CheckField::Callout), after);
    }
}

fn send(window: &mut Harness<'_, App>, command: Command) {
    let ctx = window.ctx.clone();
    window.state_mut().send(&ctx, command);
    window.run();
}

fn press(window: &mut Harness<'_, App>, key: &str) {
    window.get_by_role_and_label(Role::Button, key).click();
    window.run();
}

#[test]
fn the_keypad_types_into_no_field_that_is_not_on_screen() {
    for page in [Page::Fit, Page::Cycles, Page::Tables, Page::Program] {
        let mut window = window();
        check(&mut window, "25 H7", "25.012");
        send(&mut window, Command::ShowKeypad(true));
        send(&mut window, Command::OpenPage(page));
        for key in ["Key 7", "Delete last character", "Enter"] {
            // Where there is nothing to type into, there is no keypad.
            if window.query_by_role_and_label(Role::Button, key).is_some() {
                press(&mut window, key);
            }
        }
        let session = window.state().session();
        assert_eq!(session.text(CheckField::Measured), "25.012", "{page:?}");
        assert_eq!((session.check().shown.is_some(), session.history().len()), (true, 1), "{page:?}");
        send(&mut window, Command::OpenPage(Page::Check));
        press(&mut window, "Key 7");
        assert_ne!(window.state().session().text(CheckField::Measured), "25.012", "there it types again");
    }
}

#[test]
fn the_keypad_types_points_into_a_name_and_one_into_a_number() {
    let mut window = window();
    send(&mut window, Command::ShowKeypad(true));
    unfold(&mut window, "Part");
    for (field, text, after) in [("Part or feature", "A1.2", "A1.2."), ("Measured value", "25.0", "25.0")] {
        type_into(&mut window, field, text);
        press(&mut window, "Decimal sign");
        let field = if field == "Measured value" { CheckField::Measured } else { CheckField::Part };
        assert_eq!(window.state().session().text(field), after);
    }
}

#[test]
fn the_keypad_covers_neither_band_nor_verdict() {
    for size in [(800.0, 600.0), (1024.0, 600.0), (1280.0, 800.0), (1920.0, 1080.0)] {
        let mut window = Window { size: size.into(), ..Window::default() }.open();
        check(&mut window, "25 H7", "25.012");
        window.get_by_role_and_label(Role::Button, "Keypad").click();
        window.run();
        let keys = ["Key 7", "Enter"].map(|key| window.get_by_role_and_label(Role::Button, key).rect());
        let keypad = keys[0].union(keys[1]);
        let verdict = window.get_by_role(Role::Status).rect();
        assert!(!keypad.intersects(verdict), "{size:?}: {keypad:?} {verdict:?}");
        let band = window.query_by_role_and_label(Role::Image, "Limit band").map(|band| band.rect());
        assert!(band.is_none_or(|band| !keypad.intersects(band)), "{size:?}: {keypad:?} {band:?}");
        assert!(55.0 <= keys[0].width() && 55.0 <= keys[0].height(), "{size:?}: {:?}", keys[0]);
        let screen = eframe::egui::Rect::from_min_size(eframe::egui::Pos2::ZERO, size.into());
        assert!(screen.contains_rect(keypad), "{size:?}: {keypad:?}");
    }
}

#[test]
fn the_edges_of_columns_are_moved_by_arrow_keys_and_stay() {
    let mut window = window();
    let left = |window: &Harness<'_, App>| window.get_by_role_and_label(Role::TextInput, "Callout").rect().width();
    let before = left(&window);
    let edge = |window: &Harness<'_, App>| {
        let edges = window.get_all_by_label("Edge of the left panel: arrow keys move it");
        edges.map(|edge| edge.rect().center().x).fold(f32::INFINITY, f32::min)
    };
    let at = edge(&window);
    let first = window
        .get_all_by_label("Edge of the left panel: arrow keys move it")
        .min_by(|one, other| one.rect().center().x.total_cmp(&other.rect().center().x));
    first.unwrap().focus();
    window.run();
    for (key, is_wider) in [(Key::ArrowRight, true), (Key::ArrowLeft, false)] {
        let (width, was) = (left(&window), edge(&window));
        window.key_press(key);
        window.run();
        assert_eq!((width < left(&window), was < edge(&window)), (is_wider, is_wider), "{key:?}");
    }
    assert!((left(&window) - before).abs() < 1.0 && (edge(&window) - at).abs() < 1.0);
    assert_eq!(focused(&window), "Edge of the left panel: arrow keys move it", "arrows stay on the edge");
    window.key_press(Key::ArrowRight);
    window.run();
    let width = left(&window);
    check(&mut window, "25 H7", "25.012");
    assert!((left(&window) - width).abs() < 1.0, "it stays so");
}

#[test]
fn every_setting_is_reached_by_tab_and_has_a_name() {
    let words = Words::new(Language::En);
    for section in [Section::Appearance, Section::Rule, Section::OwnFiles] {
        let mut window = window();
        send(&mut window, Command::OpenPage(Page::Settings));
        send(&mut window, SettingsCommand::Show(section).into());
        let mut walked = Vec::new();
        for _ in 0..60 {
            window.key_press(Key::Tab);
            window.run();
            let name = focused(&window);
            assert!(!name.is_empty(), "{section:?} after {walked:?}");
            walked.push(name);
        }
        let fields = SETTINGS.iter().filter(|setting| setting.section == section);
        let fields = fields.filter(|setting| (setting.counts)(window.state().session()));
        let fields = fields.filter(|setting| matches!(setting.control, Control::Field(..) | Control::Switch(_)));
        for name in fields.map(|setting| words.get(setting.name)) {
            assert!(walked.contains(&name), "{section:?} never leads to {name}: {walked:?}");
        }
    }
}

#[test]
fn every_stop_of_the_focus_has_a_name_and_does_something() {
    let pages = [Page::Check, Page::Fit, Page::Cycles, Page::Settings].map(|page| (page, "Import…"));
    for (page, own) in pages.into_iter().chain([Page::Tables, Page::Program].map(|page| (page, "Open…"))) {
        let mut window = window();
        let ctx = window.ctx.clone();
        window.state_mut().send(&ctx, Command::OpenPage(page));
        window.run();
        let mut walked = Vec::new();
        for _ in 0..80 {
            window.key_press(Key::Tab);
            window.run();
            let name = focused(&window);
            assert!(!name.is_empty(), "{page:?} after {walked:?}");
            walked.push(name);
        }
        for name in ["Check", own, "Menu"] {
            assert!(walked.iter().any(|walked| walked == name), "{page:?} never leads to {name}: {walked:?}");
        }
    }
}

#[test]
fn touch_makes_everything_higher_until_a_mouse_moves() {
    let mut window = window();
    let height = |window: &Harness<'_, App>| window.get_by_role_and_label(Role::Button, "Judge").rect().height();
    assert!((height(&window) - 44.0).abs() < 1.0, "{}", height(&window));
    let touch =
        |phase| Event::Touch { device_id: TouchDeviceId(1), id: TouchId(1), phase, pos: pos2(5.0, 5.0), force: None };
    window.event(touch(TouchPhase::Start));
    window.event(touch(TouchPhase::End));
    window.run();
    assert!((height(&window) - 56.0).abs() < 1.0, "{}", height(&window));
    window.event(Event::PointerMoved(pos2(6.0, 6.0)));
    window.run();
    assert!((height(&window) - 44.0).abs() < 1.0, "{}", height(&window));
}
