//! The statistics page by label and key: features, figures, the chart that is walked, signals that open their records, points left out.

use std::sync::{Arc, Mutex};

use eframe::egui::accesskit::Role;
use eframe::egui::{Event, Key, OutputCommand, Vec2, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use fitcheck::gui::App;
use fitcheck::gui::journal::Records;
use fitcheck::journal::Record;
use fitcheck::journal::entry::{About, Check, Checked, Content, Entry, Moment};
use fitcheck::length::Length;
use fitcheck::probing::{Measurement, Origin};
use fitcheck::session::{Command, Page, StatisticsField};
use fitcheck::tolerance::{Callout, Sources};
use jiff::ToSpan as _;

use crate::fake_journal::Fake;
use crate::harness::{Window, click, cursor, moment, nowhere, press, rows, type_into};

/// A bore of the flange: its name, its callout, and the values of its parts in nanometres from the nominal size.
pub struct Bore {
    pub name: &'static str,
    pub callout: &'static str,
    pub values: Vec<i64>,
}

/// Numbers that scatter like a bell, the same every time: sums of twelve steps of a linear congruential generator, with
/// the mean 0 and the standard deviation 1000.
fn scatter(seed: u64, count: usize) -> Vec<i64> {
    let mut state = seed;
    let mut step = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        i64::try_from(state >> 33).unwrap() * 1_000 / (1 << 31)
    };
    (0..count).map(|_| (0..12).map(|_| step()).sum::<i64>() - 6_000).collect()
}

/// Twelve bores of a flange, 125 parts.
pub fn flange() -> Vec<Bore> {
    let bores = [
        ("A1", "25 H7", 10_300, 2_500),
        ("A2", "25 H7", 10_900, 2_200),
        ("C1", "52 H7", 14_500, 3_900),
        ("C2", "62 H8", 23_000, 3_900),
        ("D1", "12 H7", 8_000, 2_800),
        ("D2", "12 H7", 8_800, 2_200),
        ("E1", "6 H7", 6_000, 1_350),
        ("S1", "80 g6", -20_000, 2_200),
        ("N1", "16 N9", -21_000, 3_300),
        ("T1", "40 h9", -30_000, 5_900),
        ("P1", "18 h9", -21_000, 4_400),
        ("F1", "10 F8", 23_000, 3_100),
    ];
    let values = |seed: usize, middle: i64, spread: i64| {
        scatter(u64::try_from(seed).unwrap(), 125).iter().map(|of| (middle + of * spread / 1_000) / 100 * 100).collect()
    };
    let bore = |(seed, (name, callout, middle, spread)): (usize, (&'static str, &'static str, i64, i64))| Bore {
        name,
        callout,
        values: values(seed + 3, middle, spread),
    };
    bores.into_iter().enumerate().map(bore).collect()
}

/// The checks of parts, one part after another.
pub fn entries(bores: &[Bore]) -> Vec<Entry> {
    let sources = Sources::default();
    let parts = bores.iter().map(|bore| bore.values.len()).max().unwrap_or_default();
    let mut entries = Vec::new();
    for part in 0..parts {
        let minutes = i64::try_from(part).unwrap() * 17;
        let time = jiff::civil::date(2026, 11, 17).at(7, 0, 0, 0) + minutes.minutes();
        for Bore { name, callout, values } in bores {
            let Some(nm) = values.get(part) else { continue };
            let callout: Callout = callout.parse().unwrap();
            let limits = sources.limits(&callout, None).unwrap();
            let nominal = limits.nominal;
            let measured = nominal.checked_add(Length::from_nanometres(*nm).unwrap()).unwrap();
            let measurement = Measurement::of_diameter(measured, Origin::Typed);
            let record = Record::judged(time, (*name).to_owned(), Some(callout), limits, measurement, None);
            let what = Checked::Size(Arc::new(record));
            let about = About {
                station: "Mill 3".to_owned(),
                time: Moment { utc_ms: moment().utc_ms + minutes * 60_000, ..moment() },
                who: if part % 2 == 0 { "Anna" } else { "Bert" }.to_owned(),
                part: "Flange 40-118".to_owned(),
                serial: format!("S-{:04}", part + 101),
                feature: (*name).to_owned(),
                remark: String::new(),
            };
            let check = Check { what, files: Vec::new(), corrects: None };
            entries.push(Entry { about, content: Content::Check(Box::new(check)) });
        }
    }
    entries
}

/// Where records are kept that are these.
pub fn kept(entries: Vec<Entry>) -> Records {
    let journal = Fake { count: 1, written: Arc::new(Mutex::new(entries)), ..Fake::default() };
    Records { usual: Some("/shop/journal.sqlite".into()), journals: Arc::new(journal), ..nowhere() }
}

/// The page with these checks.
pub fn page_of(size: Vec2, entries: Vec<Entry>) -> Harness<'static, App> {
    let mut window = Window { size, records: kept(entries), ..Window::default() }.open();
    send(&mut window, Command::OpenPage(Page::Statistics));
    window
}

fn send(window: &mut Harness<'_, App>, command: impl Into<Command>) {
    let ctx = window.ctx.clone();
    window.state_mut().send(&ctx, command.into());
    window.run_steps(4);
}

fn usual() -> Harness<'static, App> {
    page_of(vec2(1920.0, 1080.0), entries(&flange()))
}

#[test]
fn features_are_listed_with_ppk_and_walked_by_keys() {
    let mut window = usual();
    assert_eq!(rows(&window).len(), 12);
    assert!(cursor(&window).starts_with("A1, 25 H7, 125 values, Ppk 1."), "{}", cursor(&window));
    press(&mut window, Key::ArrowDown);
    assert!(cursor(&window).starts_with("A2, 25 H7"), "{}", cursor(&window));
    press(&mut window, Key::End);
    assert!(cursor(&window).starts_with("T1, 40 h9"), "{}", cursor(&window));
}

/// One bore of 21 parts: the last one is beyond the upper control limit.
fn with_chip() -> Harness<'static, App> {
    let mut values: Vec<i64> = (0..20).map(|at| 10_000 + (at * 7) % 5 * 100).collect();
    values.push(18_000);
    page_of(vec2(1920.0, 1080.0), entries(&[Bore { name: "A1", callout: "25 H7", values }]))
}

/// Goes to the chart and to its last point.
fn on_last_point(window: &mut Harness<'_, App>) {
    window.get_by_role_and_label(Role::Image, CHART).focus();
    window.run();
    press(window, Key::End);
}

const CHART: &str = "Flange 40-118, A1, 25 H7";

#[test]
fn the_chart_is_heard_as_one_sentence_with_its_figures() {
    let window = with_chip();
    let chart = window.get_by_role_and_label(Role::Image, CHART);
    let said = chart.accesskit_node().data().description().unwrap_or_default().to_owned();
    assert!(said.starts_with("21 points, centre line 25.0106 mm, control limits 25.0"), "{said}");
    assert!(said.contains("limits 25.000 mm … 25.021 mm"), "{said}");
    assert!(said.ends_with("signals, 0 outside the limits."), "{said}");
}

#[test]
fn a_point_is_reached_by_keys_and_opens_its_record() {
    let mut window = with_chip();
    on_last_point(&mut window);
    window.get_by_label_contains(
        "Point 21: 25.018 mm, S-0121, 2026-11-17 12:40, Anna. 2: 1 point beyond a control limit. 3: Spread: 1 point",
    );
    press(&mut window, Key::Enter);
    assert_eq!(window.state().session().page(), Page::Records);
}

#[test]
fn a_signal_opens_the_record_of_its_last_point() {
    let mut window = with_chip();
    let signal = "2  1 point beyond a control limit. Point 21: 25.018 mm, S-0121, 2026-11-17 12:40, Anna";
    click(&mut window, Role::Button, signal);
    assert_eq!(window.state().session().page(), Page::Records);
}

#[test]
fn a_point_is_left_out_with_a_reason_by_keys_alone() {
    let mut window = with_chip();
    on_last_point(&mut window);
    press(&mut window, Key::X);
    window.get_by_role_and_label(Role::TextInput, "Reason").type_text("chip on the probe");
    window.run();
    press(&mut window, Key::Enter);
    window.get_by_label("20 values, 1 left out: with a reason");
    window.get_by_label_contains("Left out: chip on the probe");
    window.get_by_role_and_label(Role::Button, "Include again");
}

#[test]
fn a_rule_is_switched_off_and_its_signal_is_gone() {
    let mut window = with_chip();
    click(&mut window, Role::Button, "Rules");
    click(&mut window, Role::CheckBox, "1 point beyond a control limit");
    assert!(window.query_by_label_contains("1 point beyond a control limit. Point 21").is_none());
}

#[test]
fn control_limits_are_taken_from_the_points_up_to_the_cursor() {
    let mut window = with_chip();
    on_last_point(&mut window);
    press(&mut window, Key::ArrowLeft);
    press(&mut window, Key::B);
    window.get_by_role_and_label(Role::Button, "Limits from all points");
    let chart = window.get_by_role_and_label(Role::Image, CHART);
    let said = chart.accesskit_node().data().description().unwrap_or_default().to_owned();
    assert!(said.starts_with("21 points, centre line 25.0102 mm"), "{said}");
}

#[test]
fn means_of_groups_are_chosen_and_their_size_is_typed() {
    let mut window = usual();
    click(&mut window, Role::RadioButton, "Means of 5");
    window.get_by_label("125 values, 25 groups of 5");
    type_into(&mut window, "Values per point", "25");
    press(&mut window, Key::Enter);
    window.get_by_label("125 values, 5 groups of 25");
    type_into(&mut window, "Values per point", "1");
    press(&mut window, Key::Enter);
    window.get_by_label_contains("must be a whole number from 2 to");
}

#[test]
fn means_are_of_one_person_by_the_list() {
    let mut window = usual();
    click(&mut window, Role::RadioButton, "Means of 5");
    click(&mut window, Role::ComboBox, "Mean of");
    click(&mut window, Role::Button, "values of one person");
    window.get_by_label("125 values, 125 groups of 1");
    assert!(window.query_by_label("Values per point").is_none());
    click(&mut window, Role::ComboBox, "Mean of");
    click(&mut window, Role::Button, "values without a pause");
    window.get_by_label("125 values, 1 group of 125");
    type_into(&mut window, "Pause in minutes", "16");
    press(&mut window, Key::Enter);
    window.get_by_label("125 values, 125 groups of 1");
}

#[test]
fn a_stage_begins_by_a_key_and_sums_stand_below_the_chart() {
    let mut window = with_chip();
    on_last_point(&mut window);
    for _ in 0..8 {
        press(&mut window, Key::ArrowLeft);
    }
    press(&mut window, Key::S);
    window.get_by_role_and_label(Role::Button, "Remove the stage");
    click(&mut window, Role::RadioButton, "CUSUM");
    let sums = window.get_by_role_and_label(Role::Image, "CUSUM");
    let said = sums.accesskit_node().data().description().unwrap_or_default().to_owned();
    assert!(said.starts_with("sum above the mean ") && said.contains("decision interval"), "{said}");
}

#[test]
fn the_question_narrows_the_records() {
    let mut window = usual();
    type_into(&mut window, "Records", "nobody:\"");
    press(&mut window, Key::Enter);
    assert_eq!(window.state().session().text(StatisticsField::Question), "nobody:\"");
}

#[test]
fn figures_and_signals_are_copied_as_a_table() {
    let mut window = with_chip();
    on_last_point(&mut window);
    window.input_mut().events.push(Event::Copy);
    window.step();
    let copied = window.output().platform_output.commands.iter().find_map(|command| match command {
        OutputCommand::CopyText(text) => Some(text.clone()),
        _ => None,
    });
    let copied = copied.expect("a table");
    assert!(copied.starts_with("Flange 40-118, A1, 25 H7\n21 values\nMean\t25.010"), "{copied}");
}
