//! The drawing of a parameter: workpiece, probe, and what the parameter says about them, with its key.

use eframe::egui::accesskit::Role;
use eframe::egui::{Sense, Ui, WidgetInfo, vec2};

use super::canvas::Canvas;
use super::meaning::{Axis, Meaning, Scene};
use super::{choice, plan, section};
use crate::gui::theme::{self, palette, sizes, space};
use crate::gui::view::View;
use crate::message::Message;
use crate::probing::cycle::{Cycle, Key, Parameter};
use crate::words::Words;

/// The size of the drawing in steps; the sentence stands below it.
const STEPS: [f32; 2] = [65.0, 40.0];

/// So many lines of the sentence have room, so that the panel below does not jump from drawing to drawing.
const LINES: f32 = 3.0;

/// The drawing of a parameter and its sentence; nothing for a key that the cycle does not have.
pub(in crate::gui) fn parameter_picture(ui: &mut Ui, view: &View<'_>, cycle: &Cycle, key: Key) {
    let Some(parameter) = cycle.parameter(key) else { return };
    let meaning = Meaning::of(cycle, parameter);
    let said = sentence(view.words, parameter, meaning);
    let [width, height] = STEPS.map(space);
    let line = ui.text_style_height(&eframe::egui::TextStyle::Small);
    let (whole, response) = ui.allocate_exact_size(vec2(width, height + line * LINES + space(1.0)), Sense::hover());
    if ui.is_rect_visible(whole) {
        let palette = palette(ui.ctx());
        let rect = eframe::egui::Rect::from_min_size(whole.min, vec2(width, height));
        let canvas = Canvas::new(ui.painter(), palette, rect);
        draw(&canvas, Scene::of(cycle), meaning, &key.to_string());
        let galley = ui.painter().layout(said.clone(), theme::font(sizes().small), palette.text.0, width);
        ui.painter().galley(rect.left_bottom() + vec2(0.0, space(1.0)), galley, palette.text.0);
    }
    response.widget_info(|| WidgetInfo::labeled(Role::Figure, true, &said));
}

/// What the drawing says, in words.
pub(super) fn sentence(words: &Words, parameter: &Parameter, meaning: Meaning) -> String {
    let mut message = Message::new(meaning.id());
    if matches!(meaning, Meaning::Length | Meaning::Angle | Meaning::Choice(_) | Meaning::Number) {
        message = message.text("name", parameter.question(words.language().dialogue()));
    }
    if let Meaning::Choice(of) = meaning {
        let of: Vec<_> = of.iter().map(|number| words.number(&number.to_string())).collect();
        message = message.text("of", of.join(", "));
    }
    format!("{}: {}", parameter.key, words.say(&message))
}

fn draw(canvas: &Canvas<'_>, scene: Scene, meaning: Meaning, key: &str) {
    match meaning {
        Meaning::MeasuringHeight
        | Meaning::SetUpClearance
        | Meaning::ClearanceHeight
        | Meaning::Difference
        | Meaning::Band
        | Meaning::Retract
        | Meaning::Point(Axis::Third) => section::draw(canvas, scene, meaning, key),
        Meaning::Point(_) if scene == Scene::Surface => section::draw(canvas, scene, meaning, key),
        Meaning::MoveToClearance
        | Meaning::Traverse
        | Meaning::ContactCount
        | Meaning::Plane
        | Meaning::Side
        | Meaning::MeasuredAxis
        | Meaning::Direction
        | Meaning::Log
        | Meaning::Stop
        | Meaning::StopOnUndersize
        | Meaning::Tool
        | Meaning::Choice(_) => choice::draw(canvas, scene, meaning, key),
        _ => plan::draw(canvas, scene, meaning, key),
    }
}
