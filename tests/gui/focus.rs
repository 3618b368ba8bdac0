//! What has the focus shows it by a ring of its own colour, on every page; what is under the pointer does not look so.

use std::path::Path;

use eframe::egui::epaint::{ColorMode, Shape, Stroke};
use eframe::egui::{Color32, Key, Rect, pos2};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use fitcheck::gui::App;
use fitcheck::session::{BudgetCommand, Command, FilesCommand, Page, Purpose};

use crate::harness::{check, press, type_into, window};

/// A page with something on it.
fn page(page: Page) -> Harness<'static, App> {
    let mut window = window();
    if page == Page::Check {
        check(&mut window, "25 H7", "25.012");
    }
    send(&mut window, Command::OpenPage(page));
    match page {
        Page::Parts => {
            let plan = Path::new(env!("CARGO_MANIFEST_DIR")).join("assets/samples/sample_plate.toml");
            send(&mut window, FilesCommand::Open(Purpose::OpenPlan, plan));
        }
        Page::Fit => type_into(&mut window, "Fit of hole and shaft", "25 H7/g6"),
        Page::Program => press(&mut window, Key::F10),
        Page::Budget => send(&mut window, BudgetCommand::New),
        _ => {}
    }
    window.run();
    window
}

fn send(window: &mut Harness<'_, App>, command: impl Into<Command>) {
    let ctx = window.ctx.clone();
    window.state_mut().send(&ctx, command.into());
    window.run();
}

/// The colour of the focus, and of nothing else.
fn of_focus(window: &Harness<'_, App>) -> Color32 {
    window.ctx.global_style().visuals.selection.stroke.color
}

/// The colour of the words of a verdict's button, on a card with a colour of its own.
fn of_card(window: &Harness<'_, App>) -> Option<Color32> {
    fn of(shape: &Shape) -> Option<Color32> {
        match shape {
            Shape::Vec(shapes) => shapes.iter().find_map(of),
            Shape::Text(text) if text.galley.text() == "Why?" => {
                text.galley.job.sections.first().map(|it| it.format.color)
            }
            _ => None,
        }
    }
    window.output().shapes.iter().find_map(|clipped| of(&clipped.shape))
}

/// Places that are framed, underlined or filled in a colour.
fn painted(shape: &Shape, colour: Color32, into: &mut Vec<Rect>) {
    let is_so = |stroke: &Stroke| stroke.color == colour && 1.0 < stroke.width;
    let found = match shape {
        Shape::Vec(shapes) => return shapes.iter().for_each(|shape| painted(shape, colour, into)),
        Shape::Rect(rect) => is_so(&rect.stroke) || rect.fill == colour,
        Shape::Circle(circle) => is_so(&circle.stroke),
        Shape::LineSegment { stroke, .. } => is_so(stroke),
        Shape::Path(path) => path.stroke.color == ColorMode::Solid(colour) && 1.0 < path.stroke.width,
        _ => false,
    };
    if found {
        into.push(shape.visual_bounding_rect());
    }
}

/// Whether something in a colour stands around a place, or along it.
fn has_ring(window: &Harness<'_, App>, place: Rect, colour: Color32) -> bool {
    let mut rings = Vec::new();
    for clipped in &window.output().shapes {
        let from = rings.len();
        painted(&clipped.shape, colour, &mut rings);
        rings.iter_mut().skip(from).for_each(|ring| *ring = ring.intersect(clipped.clip_rect));
    }
    rings.iter().any(|ring| ring.is_positive() && place.expand(12.0).contains_rect(*ring))
}

/// Goes with Tab once around the page; what has the focus at each stop: its name and its place.
fn around(window: &mut Harness<'_, App>, mut at_stop: impl FnMut(&mut Harness<'_, App>, String, Rect)) {
    let mut seen = Vec::new();
    loop {
        press(window, Key::Tab);
        let Some(id) = window.ctx.memory(eframe::egui::Memory::focused) else { continue };
        if seen.contains(&id) {
            break;
        }
        seen.push(id);
        let place = window.ctx.read_response(id).unwrap().rect;
        #[expect(
            clippy::redundant_closure_for_method_calls,
            reason = "the method has one lifetime, and all are asked for"
        )]
        let named = window.query_by(|node| node.is_focused());
        let name = named.and_then(|node| node.accesskit_node().label()).unwrap_or_default();
        at_stop(window, name, place);
    }
    assert!(12 < seen.len(), "{} stops", seen.len());
}

#[test]
fn whatever_has_the_focus_shows_it() {
    let mut bare = Vec::new();
    for of in Page::ALL {
        around(&mut page(of), |window, name, place| {
            let on_card = name == "Why?" && of_card(window).is_some_and(|colour| has_ring(window, place, colour));
            if !on_card && !has_ring(window, place, of_focus(window)) {
                bare.push(format!("{of:?}: {name} at {place:?}"));
            }
        });
    }
    assert!(bare.is_empty(), "{bare:#?}");
}

#[test]
fn whatever_is_under_the_pointer_does_not_look_as_if_it_had_the_focus() {
    let mut alike = Vec::new();
    for of in Page::ALL {
        let mut window = page(of);
        let mut places = Vec::new();
        around(&mut window, |_, name, place| places.push((name, place)));
        // The keys are elsewhere, whatever the pointer does.
        if let Some(id) = window.ctx.memory(eframe::egui::Memory::focused) {
            window.ctx.memory_mut(|memory| memory.surrender_focus(id));
        }
        for (name, place) in places {
            window.hover_at(pos2(1.0, 1.0));
            window.run();
            // The cell that was chosen last has a frame in any case.
            let has_frame = has_ring(&window, place, of_focus(&window));
            window.hover_at(place.center());
            window.run();
            if !has_frame && has_ring(&window, place, of_focus(&window)) {
                alike.push(format!("{of:?}: {name} at {place:?}"));
            }
        }
    }
    assert!(alike.is_empty(), "{alike:#?}");
}
