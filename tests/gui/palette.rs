//! The palette in the window, by label and key.

use std::sync::Arc;
use std::time::{Duration, Instant};

use eframe::egui::accesskit::Role;
use eframe::egui::{Key, Modifiers};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;
use fitcheck::gui::App;
use fitcheck::gui::journal::Records;
use fitcheck::session::{CheckField, Field, FitField, HelpCommand, Page, PaletteCommand, TablesField, Theme};

use crate::fake_journal::Fake;
use crate::harness::{Window, click, nowhere, press, scan, settle, verdict, window};

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
fn a_callout_with_a_value_is_judged_at_once() {
    for (typed, said) in [("25 H7 25.013", "GOOD. 25.013 mm"), ("20 h6 20,005", "REWORK. 20.005 mm")] {
        let mut window = opened();
        scan(&mut window, &format!("{typed}⏎"));
        assert!(verdict(&window).starts_with(said), "{typed}: {}", verdict(&window));
        assert_eq!(window.state().session().page(), Page::Check);
    }
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

/// The names of the entries, from above.
fn entries(window: &Harness<'_, App>) -> Vec<String> {
    window.state().session().palette.as_ref().unwrap().found.iter().map(|entry| entry.text.clone()).collect()
}

#[test]
fn every_field_in_the_palette_has_the_focus_after_it_was_chosen() {
    let first = window();
    let session = first.state().session();
    let listed: Vec<Field> = session.fields().into_iter().filter(|field| session.stands(*field)).collect();
    assert!(50 < listed.len(), "{}", listed.len());
    let mut wrong = Vec::new();
    for page in Page::ALL {
        let mut window = window();
        for field in listed.iter().copied().filter(|field| field.page() == page) {
            let words = fitcheck::words::Words::new(fitcheck::words::Language::En);
            let name = window.state().session().field_name(field, &words);
            window.key_press_modifiers(Modifiers::COMMAND, Key::K);
            window.run();
            let number = window
                .state()
                .session()
                .palette
                .as_ref()
                .unwrap()
                .found
                .iter()
                .position(|entry| entry.text == name && entry.note.starts_with(&words.get(page.name())));
            let Some(number) = number else {
                wrong.push(format!("{field:?} is not listed as {name}"));
                continue;
            };
            let ctx = window.ctx.clone();
            window.state_mut().send(&ctx, PaletteCommand::Do(Some(number)).into());
            settle(&mut window);
            let at = window.state().session().help().at.as_ref().map(|(at, _)| *at);
            if at != Some(field) {
                wrong.push(format!("{name} of {page:?}: the focus is at {at:?}"));
            }
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}

#[test]
fn a_field_that_is_folded_away_is_found_unfolded_and_typed_into() {
    let mut window = opened();
    scan(&mut window, "set-up clearance check⏎");
    scan(&mut window, "5");
    assert_eq!(window.state().session().text(CheckField::Clearance), "5");
    window.get_by_role_and_label(Role::TextInput, "Set-up clearance");
}

#[test]
fn tab_offers_what_else_can_be_done_with_a_callout() {
    let mut window = opened();
    scan(&mut window, "25 h6");
    press(&mut window, Key::Tab);
    // ISO 286: the basic hole H7 beside a shaft.
    assert_eq!(
        entries(&window),
        ["Check 25 h6", "Fit 25 H7/h6", "25 h6 in the tables", "Uncertainty at 25 mm", "Records of 25 h6"]
    );
    press(&mut window, Key::ArrowDown);
    press(&mut window, Key::Enter);
    assert_eq!(
        (window.state().session().page(), window.state().session().text(FitField::Callout)),
        (Page::Fit, "25 H7/h6")
    );
    window.key_press_modifiers(Modifiers::COMMAND, Key::K);
    window.run();
    scan(&mut window, "25 h6");
    // By touch the same.
    click(&mut window, Role::Button, "What else with it");
    click(&mut window, Role::ListBoxOption, "25 h6 in the tables");
    assert_eq!(
        (window.state().session().page(), window.state().session().text(TablesField::Filter)),
        (Page::Tables, "h6 25")
    );
}

#[test]
fn escape_goes_back_from_what_else_there_is_to_what_was_found() {
    let mut window = opened();
    scan(&mut window, "25 h6");
    let found = entries(&window);
    press(&mut window, Key::Tab);
    assert_ne!(entries(&window), found);
    press(&mut window, Key::Escape);
    assert_eq!(entries(&window), found);
    press(&mut window, Key::Escape);
    assert!(window.state().session().palette.is_none());
}

fn with_journal(count: u64, slow: Duration, threads: bool) -> Harness<'static, App> {
    let records = Records {
        usual: Some("/shop/journal.sqlite".into()),
        journals: Arc::new(Fake::of(count, slow)),
        always_threads: threads,
        ..nowhere()
    };
    let mut window = Window { records, ..Window::default() }.open();
    window.key_press_modifiers(Modifiers::COMMAND, Key::K);
    window.run();
    window
}

#[test]
fn a_record_is_found_shown_and_corrected() {
    // The journal has the records that end with the word.
    let mut window = with_journal(1_000, Duration::ZERO, false);
    scan(&mut window, "237");
    assert_eq!(entries(&window), ["Record 237"]);
    press(&mut window, Key::Enter);
    assert_eq!(window.state().session().page(), Page::Records);
    assert_eq!(window.state().session().records().open.as_ref().unwrap().number, 237);
    window.key_press_modifiers(Modifiers::COMMAND, Key::K);
    window.run();
    scan(&mut window, "238");
    press(&mut window, Key::Tab);
    assert_eq!(entries(&window), ["Record 238", "Measure again", "Correct…"]);
    click(&mut window, Role::ListBoxOption, "Correct…");
    assert!(window.state().session().records().correcting.is_some());
    assert_eq!(window.state().session().records().open.as_ref().unwrap().number, 238);
}

/// Nobody waits for a slow journal, and its late answer moves nothing.
#[test]
fn over_a_million_records_the_palette_answers_within_a_frame() {
    let mut window = with_journal(1_000_000, Duration::from_secs(3), true);
    let begun = Instant::now();
    scan(&mut window, "25");
    let found = entries(&window);
    assert!(begun.elapsed() < Duration::from_secs(2), "{:?}", begun.elapsed());
    assert!(!found.iter().any(|entry| entry.starts_with("Record ")), "{found:?}");
    press(&mut window, Key::ArrowDown);
    let at = window.state().session().palette.as_ref().unwrap().at;
    while begun.elapsed() < Duration::from_secs(20) && entries(&window).len() == found.len() {
        std::thread::sleep(Duration::from_millis(10));
        window.step();
    }
    let now = entries(&window);
    assert_eq!(now[..found.len()], found[..], "what was there stays where it was");
    assert_eq!(
        now[found.len()..],
        ["Record 999925", "Record 999825", "Record 999725", "Record 999625", "Record 999525"]
    );
    assert_eq!(window.state().session().palette.as_ref().unwrap().at, at);
}

#[test]
fn while_the_palette_is_open_help_belongs_to_the_field_before_it() {
    let mut window = opened();
    scan(&mut window, "explain this field⏎");
    assert!(window.state().session().help().explains);
    window.get_by_label_contains("What the drawing says");
    let ctx = window.ctx.clone();
    window.state_mut().send(&ctx, HelpCommand::Explain(false).into());
    window.run();
    assert!(window.query_by_label_contains("What the drawing says").is_none());
}
