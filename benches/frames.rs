//! A frame while a history of ten thousand checks or a program of fifty thousand blocks scrolls, and while the mouse moves
//! over a page: layout, shaping and tessellation, without the rasteriser.
//!
//! It may take 4 ms. An idle frame is measured in the same way, so that the figures can be read as ratios within one run.

use std::path::PathBuf;

use criterion::{Criterion, criterion_group, criterion_main};
use eframe::egui::accesskit::Role;
use eframe::egui::{Event, Modifiers, MouseWheelSource, MouseWheelUnit, Pos2, TouchPhase, Vec2, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use fitcheck::gui::journal::Records;
use fitcheck::gui::{App, Errands, Setup, Store};
use fitcheck::journal::query::Column;
use fitcheck::message::Say as _;
use fitcheck::session::program::Document;
use fitcheck::session::{CheckCommand, CheckField, Command, Field, ListCommand, Page, ProgramCommand};
use fitcheck::words::{Language, Words};
use jiff::civil::DateTime;

/// How many checks.
const CHECKS: usize = 10_000;

/// How many blocks.
const BLOCKS: usize = 50_000;

/// How many frames go down before they go up again.
const FRAMES: usize = 200;

fn now() -> DateTime {
    jiff::civil::date(2026, 11, 21).at(10, 42, 7, 0)
}

/// A window at the first start.
fn empty(size: Vec2) -> Harness<'static, App> {
    let (store, errands) = (Store::nowhere(), Errands::AtOnce);
    let setup = Setup {
        store,
        language: Language::En,
        words: Words::new,
        errands,
        clock: now,
        home: None,
        files: Vec::new(),
        records: Records::nowhere(),
        told: Vec::new(),
        notices_stay: None,
    };
    Harness::builder().with_size(size).with_max_steps(16).build_eframe(|cc| App::new(cc, setup))
}

/// A window with a history: below everything else, or beside it where the window is very wide.
fn window(size: Vec2) -> Harness<'static, App> {
    let mut window = empty(size);
    let rows: Vec<String> = (0..CHECKS).map(|row| format!("part {row},25 H7,25.0{:02}\n", row % 40)).collect();
    let rows = rows.concat();
    let sources = fitcheck::tolerance::Sources::default();
    let read =
        fitcheck::exchange::import("parts.csv", format!("id,callout,measured\n{rows}").as_bytes(), &sources, now());
    assert_eq!(read.records.len(), CHECKS);
    for command in
        [CheckCommand::Imported { name: "parts.csv".to_owned(), result: Ok(Box::new(read)) }.into(), Command::Close]
    {
        send(&mut window, command);
    }
    window
}

fn send(window: &mut Harness<'_, App>, command: Command) {
    let ctx = window.ctx.clone();
    window.state_mut().send(&ctx, command);
    window.run();
}

/// A frame with everything that comes before the rasteriser.
fn frame(window: &mut Harness<'_, App>) -> usize {
    window.step();
    window.ctx.tessellate(window.output().shapes.clone(), window.ctx.pixels_per_point()).len()
}

/// One turn of the wheel over the list, by somewhat more than a row.
fn turn(window: &mut Harness<'_, App>, over: Pos2, number: usize) -> usize {
    let down = (number / FRAMES).is_multiple_of(2);
    let delta = vec2(0.0, if down { -37.0 } else { 37.0 });
    let (unit, phase, source) = (MouseWheelUnit::Point, TouchPhase::Move, MouseWheelSource::Wheel);
    let events = &mut window.input_mut().events;
    events.push(Event::PointerMoved(over));
    events.push(Event::MouseWheel { unit, delta, phase, source, modifiers: Modifiers::NONE });
    frame(window)
}

/// In a very wide window the list is as high as the window, and has the most rows in sight.
fn scrolling_beside(criterion: &mut Criterion) {
    let mut window = window(vec2(2600.0, 1440.0));
    let over = window.get_by_role(Role::Grid).rect().center();
    let shown = window.query_all_by_role(Role::Row).count();
    assert!(30 < shown, "{shown} rows in sight");
    let mut number = 0;
    criterion.bench_function("frame while scrolling 10 000 checks in a very wide window", |bencher| {
        bencher.iter(|| {
            number += 1;
            turn(&mut window, over, number)
        });
    });
}

fn scrolling(criterion: &mut Criterion) {
    let mut window = window(vec2(1280.0, 800.0));
    criterion.bench_function("idle frame, 10 000 checks", |bencher| bencher.iter(|| frame(&mut window)));
    let over = window.get_by_role(Role::Grid).rect().center();
    let rows = |window: &Harness<'_, App>| {
        let rows = window.query_all_by_role(Role::Row).map(|row| row.accesskit_node().label());
        rows.collect::<Vec<_>>()
    };
    let before = rows(&window);
    for _ in 0..10 {
        turn(&mut window, over, 0);
    }
    assert_ne!(rows(&window), before, "the wheel scrolls the list");
    let mut number = 0;
    criterion.bench_function("frame while scrolling 10 000 checks", |bencher| {
        bencher.iter(|| {
            number += 1;
            turn(&mut window, over, number)
        });
    });
    for command in
        [ListCommand::SortBy(Column::Measured).into(), Field::from(CheckField::HistoryFilter).typed("25".to_owned())]
    {
        send(&mut window, command);
    }
    criterion.bench_function("frame while scrolling 10 000 checks, sorted and filtered", |bencher| {
        bencher.iter(|| {
            number += 1;
            turn(&mut window, over, number)
        });
    });
}

/// The listing of a long program.
fn scrolling_a_program(criterion: &mut Criterion) {
    let mut window = empty(vec2(1280.0, 800.0));
    let blocks: Vec<_> = (0..BLOCKS).map(|block| format!("L X+{}.5 Y-{} FMAX\n", block % 300, block % 70)).collect();
    let text = format!("BEGIN PGM x MM\n{}END PGM x MM\n", blocks.concat());
    let result = Document::read("x.h", text.as_bytes()).map_err(|error| error.message());
    let result = result.map(|(document, warnings)| (Box::new(document), warnings));
    send(&mut window, Command::OpenPage(Page::Program));
    send(&mut window, ProgramCommand::Read { path: PathBuf::from("x.h"), result }.into());
    let shown = window.state().session().program().shown().map(|document| document.program.blocks().len());
    assert_eq!(shown, Some(BLOCKS + 2));
    criterion.bench_function("idle frame, 50 000 blocks", |bencher| bencher.iter(|| frame(&mut window)));
    let over = window.get_by_role(Role::List).rect().center();
    let mut number = 0;
    criterion.bench_function("frame while scrolling 50 000 blocks", |bencher| {
        bencher.iter(|| {
            number += 1;
            turn(&mut window, over, number)
        });
    });
}

/// The mouse over a page where it changes nothing.
fn moving(criterion: &mut Criterion) {
    let mut window = window(vec2(1280.0, 800.0));
    let at = window.get_by_role_and_label(Role::Figure, "Limit band").rect().center();
    let mut number = 0.0;
    criterion.bench_function("frame while the mouse moves, 10 000 checks", |bencher| {
        bencher.iter(|| {
            number = if number < 20.0 { number + 1.0 } else { 0.0 };
            window.input_mut().events.push(Event::PointerMoved(at + vec2(number, 0.0)));
            frame(&mut window)
        });
    });
}

criterion_group!(benches, scrolling, scrolling_beside, scrolling_a_program, moving);
criterion_main!(benches);
