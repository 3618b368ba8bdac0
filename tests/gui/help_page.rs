//! The help page in the window, by label and key.

use std::time::Duration;

use eframe::egui::accesskit::Role;
use eframe::egui::{Key, Modifiers, Rect, ViewportId, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use fitcheck::gui::{App, Store};
use fitcheck::session::help::{HelpPlace, HelpTopic, topics};
use fitcheck::session::parts::PictureState;
use fitcheck::session::{CheckField, Command, Density, HelpCommand, Page};
use fitcheck::words::Language;

use crate::harness::{Window, click, cursor, press, rows, scan, settle, type_into, verdict};

fn send(window: &mut Harness<'_, App>, command: impl Into<Command>) {
    let ctx = window.ctx.clone();
    window.state_mut().send(&ctx, command.into());
    settle(window);
}

fn page(window: &Harness<'_, App>) -> Page {
    window.state().session().page()
}

fn help() -> Harness<'static, App> {
    let mut window = Window::default().open();
    send(&mut window, Command::OpenPage(Page::Help));
    window
}

/// Where a paragraph stands.
fn text(window: &Harness<'_, App>, part: &str) -> Rect {
    let mut all = window.get_all_by_label_contains(part);
    all.find(|node| node.accesskit_node().role() == Role::Label).unwrap().rect()
}

#[test]
fn f1_opens_the_page_about_what_is_open_and_returns() {
    let mut window = Window::default().open();
    send(&mut window, Command::OpenPage(Page::Pairing));
    press(&mut window, Key::F1);
    // The page begins in its first field.
    assert_eq!((page(&window), cursor(&window).as_str()), (Page::Help, "Fields"));
    let heading = window.get_by_role_and_label(Role::Heading, "Wanted clearance or fit").rect();
    assert!(0.0 < heading.top() && heading.bottom() < 800.0, "{heading:?}");
    press(&mut window, Key::F1);
    assert_eq!(page(&window), Page::Pairing);
    // Where no field has the focus, it is the page.
    press(&mut window, Key::Escape);
    press(&mut window, Key::F1);
    assert_eq!((page(&window), cursor(&window).as_str()), (Page::Help, "Pairs of measured parts"));
    window.get_by_role_and_label(Role::Heading, "Pairs of measured parts");
}

#[test]
fn the_sign_at_a_field_shows_its_paragraph_and_moves_nothing() {
    let mut window = Window::default().open();
    type_into(&mut window, "Centre X", "40");
    let before = window.get_by_role_and_label(Role::TextInput, "Centre X").rect();
    window.get_by_role_and_label(Role::Button, "Help for Centre X").click();
    window.run();
    window.get_by_label_contains("Where the centre of the hole or shaft should be");
    window.get_by_role_and_label(Role::Image, "Q273: nominal centre in the first axis");
    assert_eq!(window.get_by_role_and_label(Role::TextInput, "Centre X").rect(), before);
    // The field keeps the keys, and Escape closes the paragraph alone.
    scan(&mut window, "41");
    assert_eq!(window.state().session().text(CheckField::CentreX), "41");
    press(&mut window, Key::Escape);
    assert!(window.query_by_label_contains("Where the centre of the hole or shaft should be").is_none());
}

#[test]
fn by_keys_the_paragraph_opens_and_f1_goes_on_reading() {
    let mut window = Window::default().open();
    type_into(&mut window, "Measured value", "25");
    window.key_press_modifiers(Modifiers::SHIFT, Key::F1);
    window.run();
    window.get_by_label_contains("Enter judges it.");
    click(&mut window, Role::Button, "In the manual");
    assert_eq!((page(&window), cursor(&window).as_str()), (Page::Help, "Fields"));
    press(&mut window, Key::F1);
    scan(&mut window, ".01⏎");
    assert_eq!(
        window.state().session().text(CheckField::Measured),
        ".01",
        "the field has the keys again, all of it selected"
    );
}

#[test]
fn a_finger_hits_the_sign_at_a_field() {
    let mut window = Window::default().open();
    send(&mut window, Command::SetDensity(Density::Touch));
    type_into(&mut window, "Measured value", "25");
    let sign = window.get_by_role_and_label(Role::Button, "Help for Measured value").rect();
    assert!(44.0 <= sign.height() + 0.1 && 44.0 <= sign.width() + 0.1, "{sign:?}");
}

#[test]
fn first_steps_stand_on_the_check_page_until_something_is_judged() {
    let mut window = Window { is_first: true, ..Window::default() }.open();
    window.get_by_label("First time here?");
    click(&mut window, Role::Button, "Try 25 H7 with 25.012");
    assert!(verdict(&window).starts_with("SIMULATED. GOOD. 25.012 mm"), "{}", verdict(&window));
    assert!(window.query_by_label("First time here?").is_none());
    assert!(window.state().session().recent_files().is_empty());
    send(&mut window, Command::OpenPage(Page::Help));
    click(&mut window, Role::Row, "The manual");
    click(&mut window, Role::Button, "First steps");
    assert_eq!(page(&window), Page::Check);
    window.get_by_label("First time here?");
}

#[test]
fn first_steps_are_dismissed_for_good() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("state.toml");
    let first = |path: &std::path::Path| Window { is_first: true, store: Store::at(path), ..Window::default() }.open();
    let mut window = first(&path);
    click(&mut window, Role::Button, "Done");
    assert!(window.query_by_label("First time here?").is_none());
    eframe::App::on_exit(window.state_mut(), None);
    assert!(first(&path).query_by_label("First time here?").is_none());
}

#[test]
fn the_ways_of_the_first_steps_open_samples_and_pages() {
    for (name, opens) in [
        ("Open a sample part", Page::Parts),
        ("Open a sample program", Page::Program),
        ("Parts", Page::Parts),
        ("Cycles", Page::Cycles),
    ] {
        let mut window = Window { is_first: true, ..Window::default() }.open();
        let buttons = window.query_all_by_role_and_label(Role::Button, name);
        // The rail has the pages by the same names, further to the left.
        let way = buttons.max_by(|one, other| one.rect().left().total_cmp(&other.rect().left())).unwrap();
        way.click();
        window.run();
        assert_eq!(page(&window), opens, "{name}");
    }
}

#[test]
fn words_are_typed_and_enter_opens_the_best_match() {
    let mut window = help();
    // The field has the focus.
    scan(&mut window, "guard band");
    let hits = rows(&window);
    assert!(hits[0].starts_with("Terms, Guard band: A strip along a limit"), "{hits:?}");
    assert!(hits.iter().any(|row| row.starts_with("Decision rules, ")), "{hits:?}");
    scan(&mut window, "⏎");
    assert_eq!(cursor(&window), hits[0]);
    let found = text(&window, "A strip along a limit in which");
    assert!(0.0 < found.top() && found.bottom() < 800.0, "it is in sight: {found:?}");
    type_into(&mut window, "Search the manual", "xyzzy");
    window.get_by_label("No page of the manual has these words.");
}

#[test]
fn a_hit_far_below_comes_into_sight() {
    let mut window = help();
    scan(&mut window, "three contacts in steps of 60⏎");
    settle(&mut window);
    let found = text(&window, "Three contacts in");
    assert!(0.0 < found.top() && found.bottom() < 800.0, "{found:?}");
}

#[test]
fn a_link_stands_in_its_line_and_is_as_high() {
    let mut window = help();
    send(&mut window, HelpCommand::Open(HelpPlace::of(HelpTopic::Manual("reports.md"))));
    let text = window.get_by_label_contains("say what a report adds for them").rect();
    let link = window.get_by_role_and_label(Role::Link, "Decision rules").rect();
    assert!(text.contains_rect(link.shrink(0.5)), "{link:?} in {text:?}");
    assert!(15.0 < link.height(), "{link:?}");
}

#[test]
fn no_line_of_code_is_cut() {
    let mut window = Window { size: vec2(900.0, 700.0), ..Window::default() }.open();
    send(&mut window, Command::OpenPage(Page::Help));
    send(&mut window, HelpCommand::Open(HelpPlace::at("records.md", "from-the-command-line")));
    let code = window.get_by_label_contains("fitcheck check \"25 H7\" --measured 25.012 --record").rect();
    assert!(code.right() <= 900.0, "{code:?}");
}

#[test]
fn f1_in_the_decision_rule_opens_what_is_said_of_it() {
    let mut window = Window::default().open();
    click(&mut window, Role::Button, "Decision rule: the limits decide");
    window.get_by_role_and_label(Role::ComboBox, "Rule").focus();
    settle(&mut window);
    press(&mut window, Key::F1);
    let heading = window.get_by_role_and_label(Role::Heading, "Choose a rule").rect();
    assert!(0.0 < heading.top() && heading.bottom() < 800.0, "{heading:?}");
}

#[test]
fn links_lead_from_page_to_page_and_back() {
    let mut window = help();
    click(&mut window, Role::Link, "Reports");
    assert_eq!(cursor(&window), "Reports");
    click(&mut window, Role::Button, "Back");
    assert_eq!(cursor(&window), "The manual");
    click(&mut window, Role::Link, "Records");
    window.key_press_modifiers(Modifiers::ALT, Key::ArrowLeft);
    window.run();
    assert_eq!(cursor(&window), "The manual");
}

#[test]
fn arrows_go_through_the_list_once_it_has_the_focus() {
    let mut window = help();
    click(&mut window, Role::Row, "Keyboard shortcuts");
    window.get_by_label("Ctrl+K: Search or do anything");
    press(&mut window, Key::ArrowDown);
    assert_eq!(cursor(&window), "Check one size");
    press(&mut window, Key::ArrowDown);
    assert_eq!(cursor(&window), "Gauges");
}

#[test]
fn page_keys_scroll_the_text_and_another_page_begins_at_its_top() {
    let mut window = help();
    let top = |window: &Harness<'_, App>, title: &str| window.get_by_role_and_label(Role::Heading, title).rect().top();
    click(&mut window, Role::Row, "Files and formats");
    let begin = top(&window, "Files and formats");
    press(&mut window, Key::PageDown);
    settle(&mut window);
    assert!(top(&window, "Files and formats") < begin - 300.0);
    click(&mut window, Role::Row, "Records");
    settle(&mut window);
    assert!((top(&window, "Records") - begin).abs() < 1.0);
}

#[test]
fn a_link_to_a_heading_brings_it_into_sight() {
    let mut window = help();
    let place = HelpPlace::at("window.md", "settings");
    send(&mut window, HelpCommand::Open(place));
    let rect = window.get_by_role_and_label(Role::Heading, "Settings").rect();
    assert!(0.0 < rect.top() && rect.bottom() < 800.0, "{rect:?}");
}

#[test]
fn where_there_is_no_room_the_topics_stand_in_the_place_of_the_text() {
    let mut window = Window { size: vec2(600.0, 500.0), ..Window::default() }.open();
    send(&mut window, Command::OpenPage(Page::Help));
    assert!(window.query_by_role(Role::Row).is_none());
    click(&mut window, Role::Button, "Contents");
    click(&mut window, Role::Row, "Whole parts");
    window.get_by_role_and_label(Role::Heading, "Whole parts");
    assert!(window.query_by_role(Role::Row).is_none());
    // By keys alone: to the field, into the list, along it, and into the text.
    window.key_press_modifiers(Modifiers::COMMAND, Key::F);
    settle(&mut window);
    scan(&mut window, "journal⇥");
    press(&mut window, Key::ArrowDown);
    let chosen = cursor(&window);
    press(&mut window, Key::Enter);
    assert!(window.query_by_role(Role::Row).is_none());
    let title = window.get_all_by_role(Role::Heading).next().and_then(|node| node.accesskit_node().label());
    assert!(title.as_ref().is_some_and(|title| chosen.starts_with(title.as_str())), "{chosen}: {title:?}");
}

/// A glyph that no font has ends the test.
#[test]
fn every_topic_is_drawn_in_every_language() {
    for language in Language::all() {
        let mut window = Window { size: vec2(1280.0, 4000.0), language, ..Window::default() }.open();
        for topic in topics() {
            send(&mut window, HelpCommand::Open(HelpPlace::of(topic)));
            window.run();
            let says = window.query_by_label_contains("De handleiding is alleen in het Engels").is_some();
            assert_eq!(says, language == Language::Nl && topic != HelpTopic::Keys, "{topic:?}");
        }
    }
}

#[test]
fn the_settled_page_asks_for_no_repaint() {
    let mut window = help();
    send(&mut window, HelpCommand::Open(HelpPlace::of(HelpTopic::Manual("formats.md"))));
    window.run();
    assert_eq!(window.output().viewport_output[&ViewportId::ROOT].repaint_delay, Duration::MAX);
}

#[test]
fn a_heading_is_read_out_as_one() {
    let window = help();
    let title = window.get_by_role_and_label(Role::Heading, "The manual");
    assert_eq!(title.accesskit_node().data().level(), Some(1));
}

#[test]
fn samples_open_from_the_contents_and_are_no_recent_files() {
    let mut window = help();
    click(&mut window, Role::Button, "Open a sample part");
    assert_eq!(page(&window), Page::Parts);
    let parts = window.state().session().parts();
    assert_eq!(parts.document.draft().rows.len(), 6);
    assert!(matches!(parts.sight(), Some(PictureState::Seen(_))), "{:?}", parts.sight());
    send(&mut window, Command::OpenPage(Page::Help));
    click(&mut window, Role::Button, "Open a sample file");
    assert_eq!(page(&window), Page::Check);
    assert_eq!(window.state().session().history().len(), 12);
    window.get_by_label("A sample is not recorded.");
    send(&mut window, Command::OpenPage(Page::Help));
    click(&mut window, Role::Button, "Open a sample program");
    assert_eq!(page(&window), Page::Program);
    window.get_by_label_contains("sample_plate.h is open");
    assert!(window.state().session().recent_files().is_empty());
}

#[test]
fn a_sample_is_found_in_the_palette() {
    let mut window = Window::default().open();
    window.key_press_modifiers(Modifiers::COMMAND, Key::K);
    window.run();
    scan(&mut window, "sample part⏎");
    assert_eq!(page(&window), Page::Parts);
}

#[test]
fn by_touch_the_topics_and_buttons_are_high_enough() {
    let mut window = help();
    send(&mut window, Command::SetDensity(Density::Touch));
    for role in [Role::TextInput, Role::Row] {
        assert!(window.get_all_by_role(role).all(|node| 44.0 <= node.rect().height() + 0.1), "{role:?}");
    }
    for name in ["Back", "Open a sample part"] {
        assert!(44.0 <= window.get_by_role_and_label(Role::Button, name).rect().height() + 0.1, "{name}");
    }
}

#[test]
fn escape_and_back_return_to_the_field_where_help_was_called() {
    let mut window = Window::default().open();
    for escapes in [true, false] {
        type_into(&mut window, "Measured value", "25");
        press(&mut window, Key::F1);
        assert_eq!((page(&window), cursor(&window).as_str()), (Page::Help, "Fields"));
        if escapes {
            // What is typed is searched for; Escape ends the search first.
            scan(&mut window, "guard⎋");
            assert_eq!(page(&window), Page::Help);
            press(&mut window, Key::Escape);
        } else {
            click(&mut window, Role::Row, "Reports");
            click(&mut window, Role::Button, "Back");
            assert_eq!((page(&window), cursor(&window).as_str()), (Page::Help, "Fields"));
            click(&mut window, Role::Button, "Back");
        }
        assert_eq!(page(&window), Page::Check);
        scan(&mut window, ".01⏎");
        assert_eq!(window.state().session().text(CheckField::Measured), ".01");
    }
}
