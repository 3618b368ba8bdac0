//! The window at every size, zoom and language: the verdict is whole, nothing sticks out at the side.
//!
//! `PICTURES=FOLDER cargo test --all-features --test gui sizes` also writes a picture of every page at every size.

use eframe::egui::accesskit::Role;
use eframe::egui::{Rect, Vec2, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use fitcheck::gui::App;
use fitcheck::session::{
    CheckCommand, CheckField, Command, CyclesCommand, Field, FitField, MeasureBy, Page, ProgramCommand,
};
use fitcheck::words::Language;

use crate::harness::Window;

/// Width and height in pixels, and the zoom.
const SIZES: [(f32, f32, f32); 13] = [
    (800.0, 600.0, 1.0),
    (1024.0, 600.0, 1.0),
    (1024.0, 768.0, 1.0),
    (1280.0, 800.0, 1.0),
    (1920.0, 1080.0, 1.0),
    (3840.0, 1080.0, 1.0),
    (800.0, 1600.0, 1.0),
    (1280.0, 800.0, 0.75),
    (1280.0, 800.0, 1.5),
    (1280.0, 800.0, 2.0),
    (1280.0, 800.0, 3.0),
    (800.0, 600.0, 1.5),
    (3840.0, 2160.0, 2.0),
];

fn open(size: (f32, f32, f32), language: Language) -> Harness<'static, App> {
    let (width, height, zoom) = size;
    Window { size: vec2(width, height) / zoom, zoom, language, ..Window::default() }.open()
}

fn send(window: &mut Harness<'_, App>, command: impl Into<Command>) {
    let ctx = window.ctx.clone();
    window.state_mut().send(&ctx, command.into());
    window.run_steps(3);
}

fn typed(window: &mut Harness<'_, App>, field: impl Into<Field>, text: &str) {
    send(window, field.into().typed(text.to_owned()));
}

fn measured(window: &mut Harness<'_, App>, values: &[&str]) {
    for value in values {
        typed(window, CheckField::Callout, "25 H7");
        typed(window, CheckField::Measured, value);
        send(window, CheckCommand::Measure);
    }
}

/// A picture for people to look at, where they asked for it.
fn paint(window: &mut Harness<'_, App>, name: &str) {
    if let Ok(folder) = std::env::var("PICTURES") {
        window.render().unwrap().save(std::path::Path::new(&folder).join(format!("{name}.png"))).unwrap();
    }
}

/// The part of the screen that a widget covers, in points.
fn bounds(node: &egui_kittest::Node<'_>) -> Rect {
    node.rect()
}

/// The verdict is whole and in its size; nothing reaches beyond the sides.
#[track_caller]
fn check_frame(window: &Harness<'_, App>, size: Vec2, what: &str) {
    let screen = Rect::from_min_size(eframe::egui::Pos2::ZERO, size).expand(0.6);
    let status = window.get_by_role(Role::Status);
    assert!(screen.contains_rect(bounds(&status)), "{what}: the verdict {:?} is not in {screen:?}", bounds(&status));
    for role in [Role::Button, Role::TextInput, Role::ComboBox, Role::RadioButton, Role::CheckBox, Role::Figure] {
        for node in window.query_all_by_role(role) {
            let rect = bounds(&node);
            let inside = screen.left() <= rect.left() && rect.right() <= screen.right();
            let said = node.accesskit_node().label().unwrap_or_default();
            assert!(inside || rect.bottom() < 0.0 || screen.bottom() < rect.top(), "{what}: {said} {rect:?}");
        }
    }
}

#[test]
fn the_check_page_at_every_size() {
    for size in SIZES {
        for (language, word) in [(Language::En, "REWORK"), (Language::Nl, "NABEWERKING")] {
            let points = vec2(size.0, size.1) / size.2;
            let what = format!("check {}x{} at {} {}", size.0, size.1, size.2, language.code());
            let mut window = open(size, language);
            check_frame(&window, points, &what);
            measured(&mut window, &["25.012", "25.005", "25.0185", "25.023", "24.998"]);
            paint(&mut window, &format!("{what} rework"));
            check_frame(&window, points, &what);
            let label = window
                .get_all_by_label(word)
                .map(|node| bounds(&node))
                .max_by(|one, other| one.height().total_cmp(&other.height()));
            // Only a window that is narrower than the word may set it smaller.
            let least = if 500.0 <= points.x { 64.0 } else { 40.0 };
            assert!(label.is_some_and(|rect| least <= rect.height()), "{what}: {label:?}");
            let rows = b"id,callout,measured\nA1,25 H7,25.012\nA2,25 H7,25.030\nA3,25 H7,24.998\nA4,,25\n";
            let sources = std::sync::Arc::clone(window.state().session().sources());
            let now = jiff::civil::date(2026, 11, 21).at(10, 42, 7, 0);
            let lot = fitcheck::exchange::import("parts.csv", rows, &sources, now);
            send(&mut window, CheckCommand::Imported { name: "parts.csv".to_owned(), result: Ok(Box::new(lot)) });
            send(&mut window, Command::Close);
            check_frame(&window, points, &format!("{what}, a lot"));
            send(&mut window, CheckCommand::MeasureBy(MeasureBy::Simulating));
            send(&mut window, CheckCommand::Measure);
            paint(&mut window, &format!("{what} simulated"));
            check_frame(&window, points, &what);
        }
    }
}

#[test]
fn the_other_pages_at_every_size() {
    for size in SIZES {
        let points = vec2(size.0, size.1) / size.2;
        for page in [Page::Fit, Page::Cycles, Page::Program, Page::Tables] {
            let what = format!("{page:?} {}x{} at {}", size.0, size.1, size.2);
            let mut window = open(size, Language::En);
            send(&mut window, Command::OpenPage(page));
            match page {
                Page::Fit => {
                    typed(&mut window, FitField::Callout, "25 H7/g6");
                    typed(&mut window, FitField::HoleMeasured, "25.012");
                }
                Page::Cycles => {
                    let block = "TCH PROBE 421 ~\nQ273=50~\nQ274=20~\nQ262=25~\nQ275=25.02~\nQ276=25";
                    send(&mut window, CyclesCommand::TypeBlock(block.to_owned()));
                    send(&mut window, CyclesCommand::TakeBlock);
                    send(&mut window, CyclesCommand::Run);
                }
                Page::Program => {
                    send(&mut window, ProgramCommand::Run);
                    window.run_steps(20);
                }
                Page::Check | Page::Tables => {}
            }
            paint(&mut window, &what);
            if page != Page::Tables && page != Page::Program {
                check_frame(&window, points, &what);
            }
        }
    }
}
