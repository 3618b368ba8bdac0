//! The parts page: a plan of a thousand features opens, scrolls and is typed into, and a step of the walk from Enter to the verdict with
//! its record on disk: layout, shaping and tessellation, without the rasteriser.
//!
//! A frame may take 16 ms (60 a second) and a step 50 ms. An idle frame is measured in the same way, so that the figures can be read as
//! ratios within one run.

#![expect(clippy::expect_used, reason = "a bench may stop")]

use fitcheck::session::PartsAction;
use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::{Duration, Instant};

use criterion::{Criterion, criterion_group, criterion_main};
use eframe::egui::accesskit::Role;
use eframe::egui::{Event, Key, Modifiers, MouseWheelSource, MouseWheelUnit, TouchPhase, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;
use fitcheck::gui::journal::{Local, Records};
use fitcheck::gui::{App, Errands, Setup, Store};
use fitcheck::session::Purpose;
use fitcheck::session::parts::PartsView;
use fitcheck::words::{Language, Words};

/// How many features.
const FEATURES: usize = 1_000;

/// A plan of so many bores.
fn plan(folder: &Path) -> PathBuf {
    let mut text = "number;name;callout;x;y;z\n".to_owned();
    for row in 1..=FEATURES {
        writeln!(text, "{row};H{row};25 H7;{};{};-8", row % 100 * 5, row / 100 * 40).expect("memory");
    }
    let path = folder.join("many.csv");
    fitcheck::files::write(&path, text.as_bytes()).expect("a file");
    path
}

/// A window that records in a folder, with a plan.
fn window(folder: &Path, plan: PathBuf) -> Harness<'static, App> {
    let journals = Arc::new(Local::with_anchors(None));
    let records = Records { journals, usual: Some(folder.join("journal.sqlite")), ..Records::nowhere() };
    let setup = Setup {
        store: Store::nowhere(),
        language: Language::En,
        words: Words::new,
        errands: Errands::AtOnce,
        clock: || jiff::civil::date(2026, 11, 21).at(10, 42, 7, 0),
        home: None,
        files: vec![(Purpose::OpenPlan, plan)],
        records,
        told: Vec::new(),
        notices_stay: None,
    };
    let size = vec2(1280.0, 800.0);
    let mut window = Harness::builder().with_size(size).with_max_steps(16).build_eframe(|cc| App::new(cc, setup));
    window.run();
    window
}

/// A frame with everything that comes before the rasteriser.
fn frame(window: &mut Harness<'_, App>) -> usize {
    window.step();
    window.ctx.tessellate(window.output().shapes.clone(), window.ctx.pixels_per_point()).len()
}

/// The view of the plan.
fn shown(folder: &Path) -> Harness<'static, App> {
    let mut window = window(folder, plan(folder));
    let ctx = window.ctx.clone();
    let show = PartsAction::ShowParts(PartsView::Plan).command(window.state().session()).expect("a view");
    window.state_mut().send(&ctx, show);
    window.run();
    window.get_by_label("1000 features");
    window
}

fn plans(criterion: &mut Criterion) {
    let folder = tempfile::tempdir().expect("a folder");
    criterion.bench_function("a window opens with a plan of 1 000 features", |bencher| {
        bencher.iter(|| frame(&mut shown(folder.path())));
    });
    let mut window = shown(folder.path());
    criterion.bench_function("idle frame, a plan of 1 000 features", |bencher| bencher.iter(|| frame(&mut window)));
    let over = window.get_by_label("Row 1, Name, H1").rect().center();
    let mut number = 0_usize;
    criterion.bench_function("frame while scrolling a plan of 1 000 features", |bencher| {
        bencher.iter(|| {
            number += 1;
            let delta = vec2(0.0, if (number / 400).is_multiple_of(2) { -37.0 } else { 37.0 });
            let (unit, phase, source) = (MouseWheelUnit::Point, TouchPhase::Move, MouseWheelSource::Wheel);
            let events = &mut window.input_mut().events;
            events.push(Event::PointerMoved(over));
            events.push(Event::MouseWheel { unit, delta, phase, source, modifiers: Modifiers::NONE });
            frame(&mut window)
        });
    });
    let mut window = shown(folder.path());
    window.get_by_label("Row 1, Name, H1").click();
    window.run();
    let mut number = 0_usize;
    criterion.bench_function("a sign typed into a plan of 1 000 features, with its frame", |bencher| {
        bencher.iter(|| {
            number += 1;
            let sign = char::from(b'a'.wrapping_add(u8::try_from(number % 26).unwrap_or_default()));
            // A name has at most eighty.
            if number.is_multiple_of(40) {
                window.key_press_modifiers(Modifiers::COMMAND, Key::A);
            }
            window.input_mut().events.push(Event::Text(sign.to_string()));
            frame(&mut window)
        });
    });
}

/// Types a value, and waits for the verdict.
fn step(window: &mut Harness<'_, App>) -> Duration {
    if window.state().session().parts().walking.asked().is_none() {
        for key in [Key::F8, Key::Enter] {
            window.key_press(key);
            window.run();
        }
    }
    let field = window.get_by_role_and_label(Role::TextInput, "Measured value");
    field.focus();
    field.type_text("25.01");
    window.run();
    let before = window.state().session().parts().walking.standing().measured;
    let begin = Instant::now();
    window.key_press(Key::Enter);
    while window.state().session().parts().walking.standing().measured == before {
        frame(window);
    }
    frame(window);
    let taken = begin.elapsed();
    window.run();
    taken
}

fn walk(criterion: &mut Criterion) {
    let folder = tempfile::tempdir().expect("a folder");
    let mut window = window(folder.path(), plan(folder.path()));
    let field = window.get_by_role_and_label(Role::TextInput, "Serial number");
    field.focus();
    field.type_text("A-0001");
    window.run();
    window.key_press(Key::Enter);
    window.run();
    criterion.bench_function("a step of the walk, from Enter to the verdict with its record", |bencher| {
        bencher.iter_custom(|count| (0..count).map(|_| step(&mut window)).sum());
    });
}

criterion_group!(benches, plans, walk);
criterion_main!(benches);
