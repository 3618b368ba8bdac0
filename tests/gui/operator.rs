//! The window for an operator: what it has and what it has not, and its rhythm, by keyboard alone and by touch alone.

use std::sync::Arc;
use std::time::Duration;

use eframe::egui::accesskit::Role;
use eframe::egui::{Event, Key, Modifiers, PointerButton, Rect, TouchDeviceId, TouchId, TouchPhase, Vec2, pos2, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use fitcheck::gui::App;
use fitcheck::gui::journal::Records;
use fitcheck::session::parts::{PlanCommand, WalkCommand};
use fitcheck::session::{
    Action, CheckField, Command, Field, Mode, Page, PartsCommand, SettingsCommand, SettingsField, Theme, WalkField,
};
use fitcheck::verdict::Status;

use crate::dialogs::Dropped;
use crate::fake_journal::Fake;
use crate::harness::{Window, click, nowhere, press, scan, verdict};

const PANEL: Vec2 = vec2(1024.0, 768.0);

/// Six features, as a drawing has them.
const PLAN: &[u8] = b"number;name;callout;x;y;z\n1;BORE;25 H7;40;30;-8\n2;PIN;20 g6;40;90;-8\n3;SEAT;8 H7;10;10;-5\n4;HOLE_1;6 H9;5;5;-5\n\
    5;HOLE_2;6 H9;15;5;-5\n6;SLEEVE;30 h6;60;60;-8\n";

fn send(window: &mut Harness<'_, App>, command: impl Into<Command>) {
    let ctx = window.ctx.clone();
    window.state_mut().send(&ctx, command.into());
    window.run();
}

fn open() -> Harness<'static, App> {
    let mut window = Window { size: PANEL, ..Window::default() }.open();
    send(&mut window, Command::SetMode(Mode::Operator));
    window
}

fn open_plan(window: &mut Harness<'_, App>) {
    send(window, Command::OpenPage(Page::Parts));
    let result = Ok(Box::new(fitcheck::part::Document::read(PLAN).unwrap()));
    send(window, PartsCommand::Plan(PlanCommand::Read { path: "/plans/flange.csv".into(), result }));
}

/// What stands on the button that Enter is for.
fn main_button(window: &Harness<'_, App>) -> String {
    let names = ["Judge", "Next", "Next part", "Start part", "Value"];
    let is_there = |name: &&&str| window.query_by_role_and_label(Role::Button, name).is_some();
    names.iter().find(is_there).map_or_else(String::new, |name| (*name).to_owned())
}

#[test]
fn the_first_touch_asks_whom_the_window_is_for_and_enter_is_the_operator() {
    let mut window = Window { is_first: true, size: PANEL, ..Window::default() }.open();
    assert!(window.query_by_label("Who is this window for?").is_none(), "a mouse asks nothing");
    let touch =
        |phase| Event::Touch { device_id: TouchDeviceId(1), id: TouchId(1), phase, pos: pos2(5.0, 5.0), force: None };
    window.event(touch(TouchPhase::Start));
    window.event(touch(TouchPhase::End));
    window.run();
    assert!(window.query_by_label("Who is this window for?").is_some());
    assert!(window.get_by_role_and_label(Role::Button, "Operator").is_focused());
    window.event(Event::PointerMoved(pos2(9.0, 9.0)));
    window.run();
    assert!(window.query_by_label("Who is this window for?").is_some(), "a mouse that moves is no answer");
    press(&mut window, Key::Enter);
    assert_eq!(window.state().session().mode(), Mode::Operator);
    assert!(window.query_by_label("Who is this window for?").is_none());
    click(&mut window, Role::Button, "Leave");
    assert_eq!(window.state().session().mode(), Mode::Full);
}

#[test]
fn the_language_is_chosen_where_it_is_asked_whom_the_window_is_for() {
    let mut window = Window { is_first: true, size: PANEL, ..Window::default() }.open();
    send(&mut window, Command::Touched(true));
    click(&mut window, Role::RadioButton, "Deutsch");
    assert_eq!(window.state().session().language().code(), "de");
    click(&mut window, Role::Button, "Bediener");
    assert_eq!(window.state().session().mode(), Mode::Operator);
}

#[test]
fn an_operator_reaches_nothing_of_the_full_window() {
    let mut window = open();
    for name in ["Settings", "Tables", "Import", "Simulate", "Decision rule", "Status window", "Search"] {
        assert!(window.query_by_label(name).is_none(), "{name}");
    }
    window.key_press_modifiers(eframe::egui::Modifiers::COMMAND, Key::K);
    window.key_press_modifiers(eframe::egui::Modifiers::COMMAND, Key::Num4);
    window.run();
    let session = window.state().session();
    assert!(session.palette.is_none());
    assert_eq!(session.page(), Page::Check);
    for action in Action::all().filter(|action| !action.is_for_operators()) {
        assert!(!session.can(action), "{action:?}");
    }
    send(&mut window, Command::OpenPage(Page::Settings));
    assert_eq!(window.state().session().page(), Page::Check, "no command leads there either");
}

#[test]
fn after_good_a_digit_begins_the_next_value_and_after_scrap_it_waits() {
    let mut window = open();
    open_plan(&mut window);
    scan(&mut window, "A-17⏎");
    scan(&mut window, "25.012⏎");
    assert!(verdict(&window).starts_with("GOOD"), "{}", verdict(&window));
    assert_eq!(main_button(&window), "Next");
    scan(&mut window, "2");
    assert_eq!(window.state().session().text(WalkField::Value), "2", "the next feature has begun");
    scan(&mut window, "0.01⏎");
    assert!(verdict(&window).starts_with("REWORK"), "{}", verdict(&window));
    scan(&mut window, "8");
    assert_eq!(window.state().session().text(WalkField::Value), "", "a person must have read it");
    assert!(verdict(&window).starts_with("REWORK"));
    assert!(window.query_by_label_contains("press Next first").is_some(), "what was not taken is told");
    scan(&mut window, "⏎8.003⏎");
    assert!(verdict(&window).starts_with("GOOD"), "{}", verdict(&window));
}

#[test]
fn the_same_on_the_page_of_one_size() {
    let mut window = open();
    scan(&mut window, "25 H7⏎25.03⏎");
    assert!(verdict(&window).starts_with("SCRAP"), "{}", verdict(&window));
    scan(&mut window, "25.01");
    assert_eq!(window.state().session().text(CheckField::Measured), "25.03");
    scan(&mut window, "⏎");
    assert_eq!(window.state().session().text(CheckField::Measured), "");
    scan(&mut window, "25.01⏎");
    assert!(verdict(&window).starts_with("GOOD"), "{}", verdict(&window));
    scan(&mut window, "25.012⏎");
    assert_eq!(window.state().session().text(CheckField::Measured), "25.012", "it begins as the one before did");
    assert_eq!(window.state().session().history().len(), 3, "after GOOD nothing stands between two values");
}

#[test]
fn hole_or_shaft_is_said_after_out_of_limits_and_judges_at_once() {
    let mut window = open();
    scan(&mut window, "12 ±0.02⏎12.05⏎");
    assert!(verdict(&window).starts_with("OUT OF LIMITS"), "{}", verdict(&window));
    click(&mut window, Role::Button, "Shaft");
    assert!(verdict(&window).starts_with("REWORK"), "{}", verdict(&window));
    assert_eq!(window.state().session().history().len(), 1);
}

#[test]
fn what_a_code_reader_types_goes_where_it_belongs_by_its_shape() {
    let mut window = open();
    scan(&mut window, "25 H7⏎A-0102⏎");
    let session = window.state().session();
    assert_eq!(session.text(CheckField::Serial), "A-0102");
    assert_eq!((session.text(CheckField::Measured), session.history().len()), ("", 0));
    assert!(window.query_by_label_contains("A-0102 is not a value").is_some(), "it is told");
    scan(&mut window, "30 h6⏎");
    assert_eq!(window.state().session().text(CheckField::Callout), "30 h6");
    scan(&mut window, "29.O99⏎");
    assert!(window.state().session().error(CheckField::Measured).is_some(), "a mistyped value is no code");
}

#[test]
fn what_is_typed_by_touch_after_a_verdict_is_the_next_value_and_no_end_of_the_last_one() {
    let mut window = open();
    for key in ["Key 6", "Classes of holes", "Key H9", "Value", "Key 6", "Decimal sign", "Key 0", "Key 2", "Judge"] {
        click(&mut window, Role::Button, key);
    }
    assert!(verdict(&window).starts_with("GOOD"), "{}", verdict(&window));
    for key in ["Key 6", "Decimal sign", "Key 0", "Key 5"] {
        click(&mut window, Role::Button, key);
    }
    assert_eq!(window.state().session().text(CheckField::Measured), "6.05");
    click(&mut window, Role::Button, "Judge");
    assert!(verdict(&window).starts_with("SCRAP"), "{}", verdict(&window));
    click(&mut window, Role::Button, "Undo");
    assert_eq!(window.state().session().text(CheckField::Measured), "", "what was undone is typed anew");
    for key in ["Key 6", "Key 7"] {
        click(&mut window, Role::Button, key);
    }
    send(&mut window, Field::from(CheckField::Callout).typed("8 H7".to_owned()));
    assert_eq!(window.state().session().text(CheckField::Measured), "", "no value goes on to another size");
}

#[test]
fn a_name_is_typed_and_older_results_are_reached_by_touch_alone() {
    let records = Records {
        usual: Some("/shop/journal.sqlite".into()),
        journals: Arc::new(Fake::of(1, Duration::ZERO)),
        ..nowhere()
    };
    let mut window = Window { size: PANEL, records, ..Window::default() }.open();
    send(&mut window, Command::SetMode(Mode::Operator));
    click(&mut window, Role::Button, "No name is chosen. Choose a name");
    for key in ["Letters", "Key E", "More letters", "Key V", "Letters", "Key A"] {
        let name = if key == "More letters" { "M to X" } else { key };
        if key == "Letters" && window.query_by_role_and_label(Role::Button, "Letters").is_none() {
            click(&mut window, Role::Button, "Figures");
        }
        click(&mut window, Role::Button, name);
    }
    click(&mut window, Role::Button, "Use this name");
    assert_eq!(window.state().session().recording().who(), "EVA");
    scan(&mut window, "25 H7⏎");
    for value in 1..20 {
        scan(&mut window, &format!("25.0{value:02}⏎"));
    }
    click(&mut window, Role::Button, "Results");
    let said = |window: &Harness<'_, App>| -> Vec<String> {
        let rows = window.query_all_by_role(Role::Button);
        let names = rows.map(|row| row.accesskit_node().label().unwrap_or_default());
        names.filter(|name| name.contains(" mm, ")).collect()
    };
    assert!(!said(&window).iter().any(|row| row.contains("25.001")));
    click(&mut window, Role::Button, "Older");
    click(&mut window, Role::Button, "Older");
    assert!(said(&window).iter().any(|row| row.contains("25.001")), "{:?}", said(&window));
    click(&mut window, Role::Button, "25 H7, 25.001 mm, GOOD, 10:42");
    assert!(verdict(&window).starts_with("GOOD"), "{}", verdict(&window));
    assert!(window.query_by_label_contains("ISO 286").is_some(), "an older result has its reasons");
    click(&mut window, Role::Button, "Back to the results");
    assert!(said(&window).iter().any(|row| row.contains("25.001")), "the list is where it was");
}

#[test]
fn a_result_below_the_verdict_opens_with_its_reasons_and_measuring_goes_on() {
    let mut window = open();
    scan(&mut window, "25 H7⏎25.030⏎⏎25.010⏎");
    click(&mut window, Role::Button, "25 H7, 25.030 mm, SCRAP, 10:42");
    assert!(verdict(&window).starts_with("SCRAP"), "{}", verdict(&window));
    click(&mut window, Role::Button, "Measure");
    assert!(verdict(&window).starts_with("GOOD"), "{}", verdict(&window));
    click(&mut window, Role::Button, "Results");
    assert!(window.query_by_label("Back to the results").is_none(), "Results begins with the list");
}

#[test]
fn a_file_that_is_dropped_on_an_operators_window_is_told_and_the_notice_is_closed() {
    let mut window = open();
    let path = std::path::PathBuf::from("/plans/flange.csv");
    window.input_mut().dropped_files.push(Arc::new(Dropped(path)));
    window.run();
    window.get_by_label_contains("flange.csv is not opened here");
    click(&mut window, Role::Button, "Close");
    assert!(window.state().session().notices().is_empty());
}

#[test]
fn a_panel_that_loses_its_touch_presses_nothing_and_goes_on() {
    let mut window = open();
    scan(&mut window, "25 H7⏎25.010");
    let at = window.get_by_role_and_label(Role::Button, "Judge").rect().center();
    let button =
        |pressed| Event::PointerButton { pos: at, button: PointerButton::Primary, pressed, modifiers: Modifiers::NONE };
    let of_finger =
        |phase| Event::Touch { device_id: TouchDeviceId(1), id: TouchId(1), phase, pos: at, force: Some(0.5) };
    // What the window's library says when the panel is gone while a finger is on it: the pointer leaves, and nothing was released.
    for event in [of_finger(TouchPhase::Start), Event::PointerMoved(at), button(true)] {
        window.event(event);
    }
    window.step();
    for event in [of_finger(TouchPhase::Cancel), Event::PointerGone] {
        window.event(event);
    }
    window.run();
    assert_eq!(window.state().session().history().len(), 0);
    assert_eq!(window.state().session().text(CheckField::Measured), "25.010", "nothing is lost");
    click(&mut window, Role::Button, "Judge");
    assert!(verdict(&window).starts_with("GOOD"), "{}", verdict(&window));
}

#[test]
fn a_serial_number_that_was_scanned_stands_over_the_size() {
    let mut window = open();
    scan(&mut window, "25 H7⏎A-0102⏎");
    window.get_by_label("Serial number A-0102");
}

/// A part of six features, of which the third is typed wrong and taken back, with the report at the end.
fn walk(window: &mut Harness<'_, App>, enter: &mut dyn FnMut(&mut Harness<'_, App>, &str)) {
    for value in ["25.012", "19.99", "8.018"] {
        enter(window, value);
    }
    assert!(verdict(window).starts_with("SCRAP"), "{}", verdict(window));
    click(window, Role::Button, "Why?");
    assert!(window.query_by_label_contains("ISO 286").is_some(), "the reasons stand in the place of the picture");
    click(window, Role::Button, "Why?");
    click(window, Role::Button, "Undo");
    let walking = &window.state().session().parts().walking;
    assert_eq!((walking.at, walking.values(2).len()), (Some(2), 0), "back at the feature");
    for value in ["8.003", "6.01", "6.02", "29.995"] {
        enter(window, value);
    }
    let status = window.state().session().parts().walking.status();
    assert_eq!(status, Some(Status::Good));
    assert!(verdict(window).starts_with("GOOD"));
}

#[test]
fn a_part_with_a_wrong_value_corrected_by_keys_alone() {
    let folder = tempfile::tempdir().unwrap();
    let mut window = Window { size: PANEL, home: Some(folder.path().to_owned()), ..Window::default() }.open();
    send(&mut window, Command::SetMode(Mode::Operator));
    open_plan(&mut window);
    scan(&mut window, "A-17⏎");
    walk(&mut window, &mut |window, value| scan(window, &format!("{value}⏎")));
    // Nothing has a field any more: the button has the focus half a second later.
    for _ in 0..4 {
        window.run();
    }
    press(&mut window, Key::Enter);
    assert_eq!(main_button(&window), "Next part");
    click(&mut window, Role::Button, "Report");
    let written: Vec<_> = std::fs::read_dir(folder.path()).unwrap().map(|entry| entry.unwrap().file_name()).collect();
    assert_eq!(written.len(), 1, "{written:?}: no question about a name");
}

#[test]
fn a_part_with_a_wrong_value_corrected_by_touch_alone() {
    let mut window = open();
    open_plan(&mut window);
    let key = |window: &mut Harness<'_, App>, sign: char| {
        let name = if sign == '.' { "Decimal sign".to_owned() } else { format!("Key {sign}") };
        click(window, Role::Button, &name);
    };
    for sign in ["Letters", "Key A", "Figures", "Key 1", "Key 7", "Start part"] {
        click(&mut window, Role::Button, sign);
    }
    assert_eq!(window.state().session().parts().walking.serial(), "A17");
    walk(&mut window, &mut |window, value| {
        value.chars().for_each(|sign| key(window, sign));
        click(window, Role::Button, "Judge");
    });
}

#[test]
fn everything_that_is_pressed_is_48_points_or_more() {
    for size in [vec2(800.0, 600.0), vec2(1024.0, 600.0), PANEL, vec2(1920.0, 1080.0)] {
        let mut window = Window { size, ..Window::default() }.open();
        send(&mut window, Command::SetMode(Mode::Operator));
        let look = |window: &Harness<'_, App>, what: &str| {
            for role in [Role::Button, Role::TextInput, Role::RadioButton] {
                for node in window.query_all_by_role(role) {
                    let rect = node.rect();
                    let said = node.accesskit_node().label().unwrap_or_default();
                    assert!(47.5 <= rect.width() && 47.5 <= rect.height(), "{size:?}, {what}: {said} {rect:?}");
                }
            }
        };
        look(&window, "one size");
        open_plan(&mut window);
        look(&window, "before a part");
        send(&mut window, WalkCommand::Begin);
        look(&window, "a part");
        send(&mut window, Command::OpenPage(Page::Records));
        look(&window, "results");
    }
}

#[test]
fn the_keypad_covers_nothing_and_the_page_does_not_move_when_a_verdict_comes() {
    for size in [vec2(800.0, 600.0), vec2(1024.0, 600.0), PANEL, vec2(1920.0, 1080.0)] {
        let mut window = Window { size, ..Window::default() }.open();
        send(&mut window, Command::SetMode(Mode::Operator));
        scan(&mut window, "25 H7⏎");
        let places = |window: &Harness<'_, App>| {
            let band = window.get_by_role_and_label(Role::Image, "Limit band").rect();
            let value = window.get_by_role_and_label(Role::TextInput, "Measured value").rect();
            let keys = ["Key 7", "Empty"].map(|key| window.get_by_role_and_label(Role::Button, key).rect());
            [band, value, keys[0].union(keys[1])]
        };
        let is_same = |one: &[Rect; 3], other: &[Rect; 3]| {
            one.iter().zip(other).all(|(one, other)| one.min.distance(other.min) + one.max.distance(other.max) < 0.5)
        };
        let before = places(&window);
        for value in ["25.012⏎", "⏎24.99⏎", "⏎25.03⏎"] {
            scan(&mut window, value);
            let now = places(&window);
            assert!(is_same(&now, &before), "{size:?} {value}: {now:?}, {before:?}");
        }
        let [band, value, keys] = before;
        let verdict = window.get_by_role(Role::Status).rect();
        assert!(!keys.intersects(value) && !keys.intersects(band) && !keys.intersects(verdict), "{size:?}");
        let screen = Rect::from_min_size(eframe::egui::Pos2::ZERO, size);
        assert!(screen.contains_rect(keys) && screen.contains_rect(band), "{size:?}: {keys:?} {band:?}");
    }
}

#[test]
fn a_pin_locks_the_way_out_and_escape_stays() {
    let mut window = Window { size: PANEL, ..Window::default() }.open();
    send(&mut window, Field::from(SettingsField::NewPin).typed("471".to_owned()));
    send(&mut window, SettingsCommand::SetPin);
    assert!(window.state().session().error(SettingsField::NewPin).is_some(), "three signs are too few");
    send(&mut window, Field::from(SettingsField::NewPin).typed("4711".to_owned()));
    send(&mut window, SettingsCommand::SetPin);
    let saved = window.state().session().saved();
    assert!(saved.pin.is_some_and(|hash| hash.starts_with("$argon2id$")), "only its hash is kept");
    send(&mut window, Command::SetMode(Mode::Operator));
    click(&mut window, Role::Button, "Leave");
    press(&mut window, Key::Escape);
    assert!(window.query_by_role_and_label(Role::Button, "Unlock").is_none(), "back where one was");
    click(&mut window, Role::Button, "Leave");
    scan(&mut window, "4712⏎");
    window.run();
    assert_eq!(window.state().session().mode(), Mode::Operator);
    assert!(window.query_by_label("This is not the PIN").is_some());
    for key in ["Key 4", "Key 7", "Key 1", "Key 1"] {
        click(&mut window, Role::Button, key);
    }
    click(&mut window, Role::Button, "Unlock");
    window.run();
    assert_eq!(window.state().session().mode(), Mode::Full);
}

/// How a colour looks to somebody with protanopia, deuteranopia or tritanopia, in linear light (Machado, Oliveira and Fernandes 2009,
/// severity 1), and in grey (the luminance of sRGB).
const SEEN: [[[f64; 3]; 3]; 4] = [
    [[0.152_286, 1.052_583, -0.204_868], [0.114_503, 0.786_281, 0.099_216], [-0.003_882, -0.048_116, 1.051_998]],
    [[0.367_322, 0.860_646, -0.227_968], [0.280_085, 0.672_501, 0.047_413], [-0.011_820, 0.042_940, 0.968_881]],
    [[1.255_528, -0.076_749, -0.178_779], [-0.078_411, 0.930_809, 0.147_602], [0.004_733, 0.691_367, 0.303_900]],
    [[0.2126, 0.7152, 0.0722], [0.2126, 0.7152, 0.0722], [0.2126, 0.7152, 0.0722]],
];

/// Lightness of what is left of a colour, 0 to 100, and its two opponent colours (CIE L*a*b*, D65).
fn lab(pixel: image::Rgba<u8>, seen: &[[f64; 3]; 3]) -> [f64; 3] {
    let linear = |value: u8| {
        let value = f64::from(value) / 255.0;
        if value <= 0.040_45 { value / 12.92 } else { libm::pow((value + 0.055) / 1.055, 2.4) }
    };
    let rgb = [pixel[0], pixel[1], pixel[2]].map(linear);
    let [red, green, blue] =
        seen.map(|row| row.iter().zip(rgb).map(|(share, of)| share * of).sum::<f64>().clamp(0.0, 1.0));
    let shares = [
        (0.4124 * red + 0.3576 * green + 0.1805 * blue) / 0.9505,
        0.2126 * red + 0.7152 * green + 0.0722 * blue,
        (0.0193 * red + 0.1192 * green + 0.9505 * blue) / 1.089,
    ];
    let [first, light, third] =
        shares.map(|of| if 0.008_856 < of { libm::cbrt(of) } else { 7.787 * of + 16.0 / 116.0 });
    [116.0 * light - 16.0, 500.0 * (first - light), 200.0 * (light - third)]
}

/// Two verdicts are told apart by anybody: the cards as they are drawn differ, in light and in dark, in more than their fill.
#[test]
fn verdicts_as_they_are_drawn_differ_in_grey_and_for_three_kinds_of_colour_blindness() {
    for theme in [Theme::Light, Theme::Dark] {
        let mut window = open();
        send(&mut window, Command::SetTheme(theme));
        scan(&mut window, "25 H7⏎");
        let mut cards = Vec::new();
        for (value, word) in [("25.012⏎", "GOOD"), ("⏎24.99⏎", "REWORK"), ("⏎25.03⏎", "SCRAP")] {
            scan(&mut window, value);
            assert!(verdict(&window).starts_with(word));
            let rect = window.get_by_role(Role::Status).rect();
            let picture = window.render().unwrap();
            #[expect(
                clippy::as_conversions,
                clippy::cast_possible_truncation,
                clippy::cast_sign_loss,
                reason = "dots of a picture"
            )]
            let [x, y, w, h] = [rect.left(), rect.top(), rect.width(), rect.height()].map(|side| side.round() as u32);
            cards.push((word, image::imageops::crop_imm(&picture, x, y, w, h).to_image()));
        }
        for (place, (one_word, one)) in cards.iter().enumerate() {
            for (other_word, other) in &cards[place + 1..] {
                for (seen, kind) in SEEN.iter().zip(["protanopia", "deuteranopia", "tritanopia", "grey"]) {
                    let differs = |(one, other): (&image::Rgba<u8>, &image::Rgba<u8>)| {
                        let [a, b] = [lab(*one, seen), lab(*other, seen)];
                        10.0 < a.iter().zip(b).map(|(a, b)| (a - b).powi(2)).sum::<f64>().sqrt()
                    };
                    let count = one.pixels().zip(other.pixels()).filter(|pair| differs(*pair)).count();
                    let share = f64::from(u32::try_from(count).unwrap()) / f64::from(one.width() * one.height());
                    // Word and shape alone are a tenth of the card.
                    assert!(0.08 < share, "{theme:?}, {kind}: {one_word} and {other_word} differ in {share:.3}");
                }
            }
        }
    }
}
