//! Decision rules, uncertainty and temperature on the check page, by label and key.

use std::time::Duration;

use eframe::egui::accesskit::Role;
use eframe::egui::{Key, ViewportId};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use fitcheck::gui::App;
use fitcheck::session::{CheckCommand, Command, CyclesCommand, Page, ProgramCommand};
use fitcheck::verdict::rules::RuleName;

use crate::harness::{check, click, press, type_into, verdict, window};

/// Unfolds what a header folds away; its name says what is in force.
fn unfold(window: &mut Harness<'_, App>, header: &str) {
    window.get_by_label(header).click();
    window.run();
    window.run();
}

fn choose_rule(window: &mut Harness<'_, App>, name: &str) {
    click(window, Role::ComboBox, "Rule");
    window.run();
    let item = window.query_all_by_label(name).last().expect(name);
    item.click();
    window.run();
    window.run();
}

fn with_rule(name: &str, u: &str) -> Harness<'static, App> {
    let mut window = window();
    unfold(&mut window, "Decision rule: the limits decide");
    choose_rule(&mut window, name);
    type_into(&mut window, "Uncertainty u", u);
    window
}

fn band(window: &Harness<'_, App>) -> String {
    let band = window.get_by_role_and_label(Role::Image, "Limit band");
    band.accesskit_node().data().description().unwrap_or_default().to_owned()
}

#[test]
fn a_value_in_a_guard_band_is_measured_again() {
    let mut window = with_rule("ISO 14253-1:2017, 95 %", "1.2");
    window.get_by_label("Decision rule: ISO 14253-1:2017, 95 %");
    check(&mut window, "25 H7", "25.0195");
    let said = verdict(&window);
    assert!(said.starts_with("RE-MEASURE. 25.0195 mm. Measure again. The value lies in a guard band"), "{said}");
    assert!(said.contains("Not proven by the rule"), "{said}");
    assert!(band(&window).contains("The rule accepts from 1.974 to 19.026 µm."), "{}", band(&window));
    unfold(&mut window, "Why?");
    window.get_by_label("Probability of conformity 89.44 %; of too small 0.00 %, of too large 10.56 %");
    // Among the reasons, and below the rule.
    assert_eq!(window.query_all_by_label("Accepted from 25.001974 to 25.019026 mm").count(), 2);
}

/// metrology.md, section 5: u = 1.2 µm; the word by the limits, and whether the guard bands leave it undecided.
const NINE: [(&str, &str, bool); 9] = [
    ("24.9970", "REWORK", false),
    ("24.9990", "REWORK", true),
    ("25.0005", "GOOD", true),
    ("25.0025", "GOOD", false),
    ("25.0123", "GOOD", false),
    ("25.0185", "GOOD", false),
    ("25.0195", "GOOD", true),
    ("25.0215", "SCRAP", true),
    ("25.0235", "SCRAP", false),
];

/// The same for the shaft 25 g6.
const OF_SHAFT: [(&str, &str, bool); 8] = [
    ("24.9770", "SCRAP", false),
    ("24.9790", "SCRAP", true),
    ("24.9805", "GOOD", true),
    ("24.9825", "GOOD", false),
    ("24.9905", "GOOD", false),
    ("24.9915", "GOOD", true),
    ("24.9945", "REWORK", true),
    ("24.9955", "REWORK", false),
];

#[test]
fn the_published_sizes_have_their_words_and_say_whether_they_are_proven() {
    for rule in ["ISO 14253-1:2017, 95 %", "ISO 14253-1:1998, guard band U"] {
        let mut window = with_rule(rule, "1.2");
        for (callout, sizes) in [("25 H7", NINE.as_slice()), ("25 g6", OF_SHAFT.as_slice())] {
            for (size, word, is_undecided) in sizes {
                check(&mut window, callout, size);
                let said = verdict(&window);
                let word = if *is_undecided { "RE-MEASURE" } else { word };
                let proven = if *is_undecided { "Not proven by the rule" } else { "Proven by the rule" };
                assert!(said.starts_with(word) && said.contains(proven), "{rule} {callout} {size}: {said}");
            }
        }
    }
}

#[test]
fn an_uncertainty_that_leaves_no_zone_is_said() {
    let mut window = with_rule("ISO 14253-1:1998, guard band U", "6");
    check(&mut window, "25 H7", "25.0105");
    let said = verdict(&window);
    assert!(said.starts_with("RE-MEASURE"), "{said}");
    assert!(said.contains("No value is accepted: the rule leaves no part of this tolerance"), "{said}");
    assert!(band(&window).contains("The rule accepts no value."), "{}", band(&window));
}

#[test]
fn what_is_removed_aims_at_the_guarded_limit() {
    let mut window = with_rule("ISO 14253-1:1998, guard band U", "1.2");
    check(&mut window, "25 H7", "24.990");
    assert!(verdict(&window).contains("Remove 12.4 µm"), "{}", verdict(&window));
}

#[test]
fn another_rule_or_uncertainty_takes_the_verdict_away() {
    let mut window = with_rule("ISO 14253-1:2017, 95 %", "1.2");
    check(&mut window, "25 H7", "25.012");
    assert!(verdict(&window).starts_with("GOOD"));
    click(&mut window, Role::RadioButton, "Customer proves nonconformity");
    assert!(!verdict(&window).starts_with("GOOD"), "{}", verdict(&window));
    check(&mut window, "25 H7", "25.012");
    type_into(&mut window, "Uncertainty u", "1.3");
    assert!(!verdict(&window).starts_with("GOOD"), "{}", verdict(&window));
    type_into(&mut window, "Uncertainty u", "");
    window.get_by_label("the rule ISO 14253-1:2017, 95 % needs the uncertainty of the measured value: type it at the rule on Check, or use a budget");
}

#[test]
fn what_is_accepted_beyond_a_limit_is_not_called_good() {
    let mut window = with_rule("ISO 14253-1:1998, guard band U", "1");
    click(&mut window, Role::RadioButton, "Customer proves nonconformity");
    // The maximum is 25.021: 1 µm above it is within the guard band of 2 µm, and 2.1 µm are not.
    for (size, word, title) in [
        ("25.0210", "GOOD", "Status window"),
        ("25.0220", "ACCEPTED", "Status window: outside the limits, accepted by the rule"),
        ("24.9990", "ACCEPTED", "Status window: outside the limits, accepted by the rule"),
        ("25.0231", "SCRAP", "Status window"),
    ] {
        check(&mut window, "25 H7", size);
        let said = verdict(&window);
        assert!(said.starts_with(&format!("{word}. ")), "{size}: {said}");
        assert_eq!(
            said.contains("Outside the limits. Accepted by the rule, since it is not proven"),
            word == "ACCEPTED"
        );
        assert!(window.query_by_label(title).is_some(), "{size}: {title}");
    }
    assert!(window.query_by_label_contains("25.0220 mm, +22 µm, ACCEPTED").is_some());
    assert_eq!(window.state().session().history().listed().bad(), 3, "two are accepted and one is scrap");
}

#[test]
fn a_rule_is_chosen_by_keys_alone() {
    let mut window = window();
    let header = window.get_by_label("Decision rule: the limits decide");
    header.focus();
    window.run();
    press(&mut window, Key::Space);
    window.run();
    window.get_by_role_and_label(Role::ComboBox, "Rule").focus();
    window.run();
    press(&mut window, Key::Space);
    for _ in 0..2 {
        press(&mut window, Key::Tab);
    }
    press(&mut window, Key::Enter);
    window.run();
    let is_chosen = window.query_by_label_contains("Decision rule: ISO 14253-1").is_some();
    assert!(is_chosen || window.query_by_label("Decision rule: the limits decide").is_none());
}

#[test]
fn a_warm_part_says_what_was_measured_and_what_it_is_at_twenty_degrees() {
    let mut window = window();
    unfold(&mut window, "Temperature: not corrected");
    type_into(&mut window, "Part", "28");
    window.get_by_label("Temperature: 28 °C, corrected to 20 °C");
    type_into(&mut window, "Expansion of the part", "23.1");
    check(&mut window, "80 H7", "80.01");
    let said = verdict(&window);
    assert!(said.starts_with("REWORK. 79.995214 mm"), "{said}");
    assert!(said.contains("80.010 mm at 28 °C, -14.786 µm to 20 °C") || said.contains("−14.786 µm to 20 °C"), "{said}");
}

#[test]
fn the_settled_window_with_guard_bands_asks_for_no_repaint() {
    let mut window = with_rule("ISO 14253-1:2017, 95 %", "1.2");
    check(&mut window, "25 H7", "25.012");
    window.run();
    let delay = window.output().viewport_output[&ViewportId::ROOT].repaint_delay;
    assert_eq!(delay, Duration::MAX);
}

#[test]
fn cycles_and_programs_say_that_they_judge_by_their_limits_alone() {
    let said = "The cycle judges by its limits alone, as on a control: decision rule, uncertainty and temperature belong to the \
                check page";
    for (page, run) in [(Page::Cycles, Command::from(CyclesCommand::Run)), (Page::Program, ProgramCommand::Run.into())]
    {
        let mut window = window();
        let ctx = window.ctx.clone();
        let mut send = |command: Command| window.state_mut().send(&ctx, command);
        send(Command::OpenPage(page));
        send(
            CyclesCommand::TypeBlock("TCH PROBE 421 ~\nQ273=50~\nQ274=20~\nQ262=25~\nQ275=25.02~\nQ276=25".to_owned())
                .into(),
        );
        send(CyclesCommand::TakeBlock.into());
        send(run.clone());
        window.run_steps(30);
        assert!(window.query_by_label(said).is_none(), "{page:?}");
        window.state_mut().send(&ctx, CheckCommand::UseRule(RuleName::Iso14253Of2017).into());
        window.run_steps(3);
        assert!(window.query_by_label(said).is_some(), "{page:?}");
    }
}
