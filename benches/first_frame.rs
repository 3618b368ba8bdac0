//! The first frame and a settled frame of the window, without a graphics card: layout, shaping, tessellation.
//!
//! An empty window is measured in the same way, so that the figures can be read as ratios within one run.

use std::sync::Arc;

use criterion::{Criterion, criterion_group, criterion_main};
use eframe::egui::{CentralPanel, FontData, FontDefinitions, FontFamily, Ui};
use egui_kittest::Harness;
use fitcheck::gui::journal::Records;
use fitcheck::gui::{App, Errands, Setup, Store};
use fitcheck::session::{CheckCommand, Command, Field, FitField, Page};
use fitcheck::words::{Language, Words};

fn setup() -> Setup {
    Setup {
        store: Store::nowhere(),
        language: Language::En,
        words: Words::new,
        errands: Errands::AtOnce,
        clock: || jiff::civil::date(2026, 11, 21).at(10, 42, 7, 0),
        home: None,
        files: Vec::new(),
        records: Records::nowhere(),
        told: Vec::new(),
        notices_stay: None,
    }
}

/// An empty window with a font, as every program has to bring its own.
struct Empty;

impl Empty {
    fn open(cc: &mut eframe::CreationContext<'_>) -> Self {
        let mut fonts = FontDefinitions::empty();
        let font = FontData::from_static(include_bytes!("../assets/fonts/sans-regular.ttf"));
        fonts.font_data.insert("font".to_owned(), Arc::new(font));
        for family in [FontFamily::Proportional, FontFamily::Monospace] {
            fonts.families.insert(family, vec!["font".to_owned()]);
        }
        cc.egui_ctx.set_fonts(fonts);
        Self
    }
}

impl eframe::App for Empty {
    fn ui(&mut self, ui: &mut Ui, _frame: &mut eframe::Frame) {
        CentralPanel::default().show(ui, |ui| ui.label("empty"));
    }
}

fn frames(criterion: &mut Criterion) {
    let size = eframe::egui::vec2(1280.0, 800.0);
    criterion.bench_function("first frame, empty window", |bencher| {
        bencher.iter(|| Harness::builder().with_size(size).build_eframe(Empty::open));
    });
    criterion.bench_function("first frame, Fitcheck", |bencher| {
        bencher.iter(|| Harness::builder().with_size(size).build_eframe(|cc| App::new(cc, setup())));
    });
    let mut harness = Harness::builder().with_size(size).build_eframe(|cc| App::new(cc, setup()));
    harness.run();
    criterion.bench_function("settled frame, Fitcheck", |bencher| bencher.iter(|| harness.step()));
    let mut tables = Harness::builder().with_size(size).build_eframe(|cc| App::new(cc, setup()));
    let ctx = tables.ctx.clone();
    tables.state_mut().send(&ctx, Command::OpenPage(Page::Tables));
    tables.run();
    criterion.bench_function("settled frame, table page", |bencher| bencher.iter(|| tables.step()));
    let mut fits = Harness::builder().with_size(size).build_eframe(|cc| App::new(cc, setup()));
    let ctx = fits.ctx.clone();
    fits.state_mut().send(&ctx, Command::OpenPage(Page::Fit));
    fits.state_mut().send(&ctx, Field::from(FitField::Callout).typed("50 H7/p6".to_owned()));
    fits.run();
    criterion.bench_function("settled frame, fit page", |bencher| bencher.iter(|| fits.step()));
    let rows: Vec<String> = (0..10_000).map(|row| format!("part {row},25 H7,25.0{:02}\n", row % 40)).collect();
    let rows = rows.concat();
    let now = (setup().clock)();
    let sources = fitcheck::tolerance::Sources::default();
    let imported =
        fitcheck::exchange::import("parts.csv", format!("id,callout,measured\n{rows}").as_bytes(), &sources, now);
    assert_eq!(imported.records.len(), 10_000);
    let ctx = harness.ctx.clone();
    let command =
        Command::Check(CheckCommand::Imported { name: "parts.csv".to_owned(), result: Ok(Box::new(imported)) });
    harness.state_mut().send(&ctx, command);
    harness.run();
    criterion.bench_function("settled frame, Fitcheck with 10 000 checks", |bencher| bencher.iter(|| harness.step()));
}

criterion_group!(benches, frames);
criterion_main!(benches);
