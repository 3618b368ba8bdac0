//! The statistics page by label and key: features, figures, the chart that is walked, signals that open their records, points left out.

use std::sync::{Arc, Mutex};

use eframe::egui::accesskit::Role;
use eframe::egui::{Key, Modifiers, OutputCommand, Theme, Vec2, vec2};
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
use crate::harness::{Window, click, cursor, moment, nowhere, picture_in, press, rows, type_into};
use crate::pictures::can_paint;

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

fn taken(name: &str, size: Vec2) {
    if can_paint(name) {
        picture_in(&mut page_of(size, entries(&flange())), name, "docs/screenshots");
    }
}

#[test]
fn the_page_on_a_wide_screen() {
    taken("statistics", vec2(1920.0, 1080.0));
}

#[test]
fn the_page_on_a_small_screen() {
    taken("statistics_small", vec2(1280.0, 800.0));
}
