//! The check page in small windows, as newcomers met it: the band is whole, a judged value can be corrected, the button that records the
//! correction is in sight, so are those of the status window, and the keypad leaves the field in sight.
//!
//! `PICTURES=FOLDER cargo test --all-features --test gui small_windows` also writes pictures.

use std::sync::Arc;
use std::time::Duration;

use eframe::egui::accesskit::Role;
use eframe::egui::epaint::TextShape;
use eframe::egui::{Pos2, Rect, Shape, Vec2, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;
use fitcheck::gui::App;
use fitcheck::gui::journal::Records;
use fitcheck::session::parts::{PlanCommand, WalkCommand};
use fitcheck::session::{
    Action, CheckAction, CheckCommand, CheckField, Command, Density, Field, Page, PartsCommand, Recorded, Theme,
};
use fitcheck::verdict::Status;
use fitcheck::verdict::rules::RuleName;
use fitcheck::words::{Language, Words};

use crate::fake_journal::Fake;
use crate::harness::{Window, click, nowhere, rows, verdict};

const SMALL: Vec2 = vec2(800.0, 600.0);
const SMALL_DESK: Vec2 = vec2(1024.0, 768.0);
const SIZES: [Vec2; 5] = [SMALL, vec2(800.0, 640.0), vec2(960.0, 600.0), vec2(1024.0, 600.0), SMALL_DESK];

/// A window that records.
fn open(size: Vec2, language: Language) -> Harness<'static, App> {
    let journals = Arc::new(Fake::of(1, Duration::ZERO));
    let records = Records { usual: Some("/shop/journal.sqlite".into()), journals, ..nowhere() };
    Window { size, language, records, ..Window::default() }.open()
}

fn send(window: &mut Harness<'_, App>, command: impl Into<Command>) {
    let ctx = window.ctx.clone();
    window.state_mut().send(&ctx, command.into());
    window.run();
}

fn typed(window: &mut Harness<'_, App>, field: CheckField, text: &str) {
    send(window, Field::from(field).typed(text.to_owned()));
}

fn measured(window: &mut Harness<'_, App>, value: &str) {
    typed(window, CheckField::Callout, "25 H7");
    typed(window, CheckField::Measured, value);
    send(window, CheckCommand::Measure);
}

fn shown(window: &Harness<'_, App>) -> Option<Status> {
    window.state().session().check().shown.as_ref().map(|shown| shown.record.verdict.status())
}

/// A picture for people to look at, where they asked for it.
fn paint(window: &mut Harness<'_, App>, name: &str) {
    let Ok(folder) = std::env::var("PICTURES") else { return };
    let size = window.ctx.content_rect().size();
    let name = format!("small {name} {}x{}.png", size.x, size.y);
    window.render().unwrap().save(std::path::Path::new(&folder).join(name)).unwrap();
}

fn screen(window: &Harness<'_, App>) -> Rect {
    Rect::from_min_size(Pos2::ZERO, window.ctx.content_rect().size())
}

/// Every text that is painted, with its place and what is in sight there.
fn texts(window: &Harness<'_, App>) -> Vec<(String, Rect, Rect)> {
    fn collect(shape: &Shape, clip: Rect, into: &mut Vec<(String, Rect, Rect)>) {
        match shape {
            Shape::Vec(shapes) => shapes.iter().for_each(|shape| collect(shape, clip, into)),
            Shape::Text(TextShape { pos, galley, .. }) => {
                into.push((galley.text().to_owned(), galley.rect.translate(pos.to_vec2()), clip));
            }
            _ => {}
        }
    }
    let mut found = Vec::new();
    for clipped in &window.output().shapes {
        collect(&clipped.shape, clipped.clip_rect, &mut found);
    }
    found
}

/// Whether the button of a name is whole in sight: its place, and its text within what is painted there.
fn is_in_sight(window: &Harness<'_, App>, button: &str) -> bool {
    let rect = window.get_by_role_and_label(Role::Button, button).rect();
    let is_whole = |(text, of_text, clip): &(String, Rect, Rect)| {
        text == button && rect.contains_rect(*of_text) && clip.expand(1.0).contains_rect(rect)
    };
    screen(window).contains_rect(rect) && texts(window).iter().any(is_whole)
}

/// What is wrong with the band: it paints within its own place alone, and where it is cut within less.
fn fault_of_band(window: &Harness<'_, App>) -> Option<String> {
    let name = Words::new(window.state().session().language()).get("limit-band");
    let Some(band) = window.query_by_role_and_label(Role::Image, &name) else { return Some("no band".into()) };
    let band = band.rect();
    let is_near = |one: Rect| (one.min - band.min).length() < 1.5 && (one.max - band.max).length() < 1.5;
    if !window.output().shapes.iter().any(|shape| is_near(shape.clip_rect)) {
        return Some(format!("the band {band:?} is cut"));
    }
    // A line of text has some room above its letters.
    let is_outside = |(_, rect, clip): &(String, Rect, Rect)| is_near(*clip) && !clip.expand(2.5).contains_rect(*rect);
    let outside = texts(window).into_iter().find(is_outside);
    outside.map(|(text, rect, _)| format!("{text:?} {rect:?} is not in the band {band:?}"))
}

#[test]
fn the_band_is_whole_whatever_the_verdict_says() {
    let densities = [Density::Mouse, Density::Touch];
    let looks =
        densities.into_iter().flat_map(|density| [Language::En, Language::Nl].map(|language| (density, language)));
    let looks = looks.flat_map(|look| SIZES.map(|size| (size, look)));
    let mut faults = Vec::new();
    for (size, (density, language)) in looks {
        let mut window = open(size, language);
        send(&mut window, Command::SetDensity(density));
        let mut look = |window: &mut Harness<'_, App>, what: &str| {
            let what = format!("{what} {density:?} {}", language.code());
            if size == SMALL && language == Language::En {
                paint(window, &what);
            }
            faults.extend(fault_of_band(window).map(|fault| format!("{size:?} {what}: {fault}")));
        };
        for value in ["25.012", "24.998", "25.030", "24.9"] {
            measured(&mut window, value);
            look(&mut window, value);
        }
        send(&mut window, CheckCommand::UseRule(RuleName::IlacG8));
        typed(&mut window, CheckField::Uncertainty, "1.2");
        measured(&mut window, "24.99");
        assert_eq!(shown(&window), Some(Status::Rework));
        look(&mut window, "by a rule");
        measured(&mut window, "25.0005");
        assert_eq!(shown(&window), Some(Status::ReMeasure));
        look(&mut window, "in a guard band");
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

#[test]
fn a_judged_value_is_corrected_where_its_verdict_is() {
    for size in SIZES {
        let mut window = open(size, Language::En);
        measured(&mut window, "24.998");
        assert_eq!(window.state().session().check_recorded(), Some(Recorded::Kept(2)));
        paint(&mut window, "offers");
        // Once: at the foot of the card, or with the list of checks where that is in sight.
        assert!(is_in_sight(&window, "Correct…"), "{size:?}");
        click(&mut window, Role::Button, "Correct…");
        window.get_by_label("Correct record 2");
        assert!(verdict(&window).starts_with("No result"), "no verdict beside other inputs: {}", verdict(&window));
    }
}

#[test]
fn the_button_that_records_a_correction_is_in_sight() {
    for size in SIZES {
        for density in [Density::Mouse, Density::Touch] {
            let mut window = open(size, Language::En);
            send(&mut window, Command::SetDensity(density));
            measured(&mut window, "24.998");
            send(&mut window, fitcheck::session::RecordsCommand::CorrectNumber(2));
            paint(&mut window, &format!("correction {density:?}"));
            for button in ["Record the correction", "Cancel"] {
                assert!(is_in_sight(&window, button), "{size:?} {density:?}: {button}");
            }
            // Without a reason it says what is missing, and stays where it is.
            click(&mut window, Role::Button, "Record the correction");
            window.get_by_label("A correction needs a reason");
            assert!(is_in_sight(&window, "Record the correction"), "{size:?} {density:?}, refused");
        }
    }
}

#[test]
fn the_buttons_of_the_status_window_are_whole() {
    let mut window = open(SMALL_DESK, Language::En);
    for value in ["25.012", "24.998", "25.021001"] {
        measured(&mut window, value);
        paint(&mut window, &format!("status {value}"));
        assert!(is_in_sight(&window, "Copy"), "{value}");
        let window_text = texts(&window).into_iter().find(|(text, ..)| text.contains("MEASURED DIAMETER:"));
        let is_whole = window_text.is_some_and(|(_, rect, clip)| clip.expand(1.0).contains_rect(rect));
        assert!(is_whole || value == "25.021001", "{value}: exact values besides may scroll");
        let mask = window.get_by_role_and_label(Role::ComboBox, "Mask").rect();
        let copy = window.get_by_role_and_label(Role::Button, "Copy").rect();
        assert!(mask.bottom() <= copy.bottom() + 1.0, "{value}: {mask:?} {copy:?}");
    }
}

#[test]
fn the_keypad_leaves_the_field_of_the_value_in_sight() {
    for size in [SMALL, vec2(1024.0, 600.0), SMALL_DESK, vec2(1280.0, 800.0), vec2(1920.0, 1080.0)] {
        let mut window = open(size, Language::En);
        typed(&mut window, CheckField::Callout, "25 H7");
        send(&mut window, Command::SetDensity(Density::Touch));
        send(&mut window, Command::ShowKeypad(true));
        let sees = |window: &mut Harness<'_, App>, what: &str| {
            paint(window, &format!("keypad {what}"));
            for name in ["Callout", "Measured value"] {
                let field = window.get_by_role_and_label(Role::TextInput, name).rect();
                let key = window.get_by_role_and_label(Role::Button, "Key 7").rect();
                assert!(field.bottom() <= key.top(), "{size:?}, {what}: {name} {field:?}, below {key:?}");
                let clip = texts(window).into_iter().find(|(text, ..)| text == name).map(|(.., clip)| clip);
                assert!(
                    clip.is_some_and(|clip| clip.contains_rect(field)),
                    "{size:?}, {what}: {name} {field:?} in {clip:?}"
                );
            }
        };
        sees(&mut window, "at once");
        for key in ["Key 2", "Key 4", "Decimal sign", "Key 9"] {
            window.get_by_role_and_label(Role::TextInput, "Measured value").focus();
            window.run();
            click(&mut window, Role::Button, key);
        }
        sees(&mut window, "typed");
        click(&mut window, Role::Button, "Enter");
        sees(&mut window, "judged");
        let keypad = window.get_by_role_and_label(Role::Button, "Key 7").rect();
        let keypad = keypad.union(window.get_by_role_and_label(Role::Button, "Enter").rect());
        let verdict = window.get_by_role(Role::Status).rect();
        assert!(!keypad.intersects(verdict), "{size:?}: {keypad:?} {verdict:?}");
        assert_eq!(fault_of_band(&window), None, "{size:?}");
    }
}

#[test]
fn the_keypad_leaves_the_value_of_a_walk_in_sight() {
    for size in [SMALL, vec2(1024.0, 600.0), SMALL_DESK] {
        let mut window = open(size, Language::En);
        send(&mut window, Command::OpenPage(Page::Parts));
        let plan = b"number;name;callout;x;y;z\n1;BORE;25 H7;40;30;-8\n2;PIN;20 g6;40;90;-8\n";
        let result = Ok(Box::new(fitcheck::part::Document::read(plan).unwrap()));
        send(&mut window, PartsCommand::Plan(PlanCommand::Read { path: "/plans/flange.csv".into(), result }));
        send(&mut window, WalkCommand::Begin);
        send(&mut window, Command::SetDensity(Density::Touch));
        send(&mut window, Command::ShowKeypad(true));
        paint(&mut window, "walk");
        let field = window.get_by_role_and_label(Role::TextInput, "Measured value").rect();
        let key = window.get_by_role_and_label(Role::Button, "Key 7").rect();
        assert!(0.0 < field.top() && field.bottom() <= key.top(), "{size:?}: {field:?}, below {key:?}");
    }
}

#[test]
fn a_notice_leaves_the_rail_below_the_page_free() {
    let mut window = open(vec2(800.0, 1600.0), Language::En);
    send(&mut window, Command::OpenPage(Page::Settings));
    send(&mut window, Command::SetTheme(Theme::Dark));
    let undo = window.query_all_by_role_and_label(Role::Button, "Undo").map(|node| node.rect().bottom());
    let lowest = undo.fold(0.0, f32::max);
    let rail = window.query_all_by_label("Records").map(|node| node.rect().top()).fold(0.0, f32::max);
    assert!(1_000.0 < lowest && lowest < rail, "the notice ends at {lowest}, the rail begins at {rail}");
}

/// Titles, filter and buttons of the history take one line, so that rows stay in sight.
#[test]
fn the_tools_of_the_history_stay_in_one_line() {
    for language in Language::all() {
        let mut window = open(SMALL_DESK, language);
        for value in ["25.012", "25.030", "24.998", "25.031"] {
            measured(&mut window, value);
        }
        let only_bad = Action::from(CheckAction::OnlyBad).command(window.state().session()).unwrap();
        send(&mut window, only_bad);
        let words = Words::new(language);
        let only_bad = window.get_by_role_and_label(Role::CheckBox, &words.get("history-only-bad")).rect();
        let correct = window.get_by_role_and_label(Role::Button, &words.get("records-page-correct")).rect();
        assert!(only_bad.y_range().contains(correct.center().y), "{language:?}: {only_bad:?} {correct:?}");
        assert!(2 <= rows(&window).len(), "{language:?}: {:?}", rows(&window));
        paint(&mut window, &format!("history {language:?}"));
    }
}
