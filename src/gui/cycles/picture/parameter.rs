//! The drawing of a parameter: workpiece, probe, and what the parameter says about them, with its key.

use eframe::egui::{Sense, Ui, vec2};

use super::canvas::Canvas;
use super::scene::Scene;
use super::{choice, plan, section};
use crate::gui::spoken;
use crate::gui::theme::{self, palette, sizes, space};
use crate::gui::view::View;
use crate::message::{Message, message};
use crate::probing::cycle::{Axis, Cycle, Key, Meaning, Parameter, Range};
use crate::probing::simulated::Shape;
use crate::words::Words;

/// The size of the drawing in steps; the sentence is below it.
const STEPS: [f32; 2] = [65.0, 40.0];

/// This many lines of the sentence have room, so that the panel below does not jump from drawing to drawing.
const LINES: f32 = 3.0;

/// The sentence of a parameter, where it stands beside the drawing. The drawing has said it already.
pub(in crate::gui) fn parameter_sentence(ui: &mut Ui, view: &View<'_>, parameter: &Parameter) {
    let font = theme::font(sizes().small);
    let colour = palette(ui.ctx()).text.0;
    let galley = ui.painter().layout(sentence(view.words, parameter), font, colour, ui.available_width());
    let (rect, _) = ui.allocate_exact_size(galley.size(), Sense::hover());
    ui.painter().galley(rect.min, galley, colour);
}

/// The drawing of a parameter, with its sentence below it where that does not stand beside it; nothing for a key that the
/// cycle does not have.
pub(in crate::gui) fn parameter_picture(ui: &mut Ui, view: &View<'_>, cycle: &Cycle, key: Key, is_bare: bool) {
    let Some(parameter) = cycle.parameter(key) else { return };
    let said = sentence(view.words, parameter);
    let [width, height] = STEPS.map(space);
    let line = ui.text_style_height(&eframe::egui::TextStyle::Small);
    let below = if is_bare { 0.0 } else { line * LINES + space(1.0) };
    let (whole, response) = ui.allocate_exact_size(vec2(width, height + below), Sense::hover());
    if ui.is_rect_visible(whole) {
        let palette = palette(ui.ctx());
        let rect = eframe::egui::Rect::from_min_size(whole.min, vec2(width, height));
        let canvas = Canvas::new(ui.painter(), palette, rect);
        draw(&canvas, Scene::of(cycle), parameter);
        if !is_bare {
            let galley = ui.painter().layout(said.clone(), theme::font(sizes().small), palette.text.0, width);
            ui.painter().galley(rect.left_bottom() + vec2(0.0, space(1.0)), galley, palette.text.0);
        }
    }
    spoken::picture_named(&response, said);
}

/// What the drawing says, in words.
pub(super) fn sentence(words: &Words, parameter: &Parameter) -> String {
    let mut message = Message::new(parameter.meaning.sentence());
    if parameter.meaning.is_general() {
        message = message.text("name", parameter.question(words.language().dialogue()));
    }
    if let (Meaning::Choice, Range::OneOf(of)) = (parameter.meaning, parameter.range) {
        let of: Vec<_> = of.iter().map(|number| words.number(&number.to_string())).collect();
        message = message.text("of", of.join(", "));
    }
    format!("{}: {}", parameter.key, words.say(&message))
}

/// What the parameter may be.
pub(in crate::gui) fn parameter_range(view: &View<'_>, parameter: &Parameter) -> String {
    if matches!(parameter.range, Range::Tool | Range::Band) {
        return view.words.told(&parameter.range);
    }
    let range = view.words.say(&parameter.range.short());
    // A range without a unit ends the line.
    let unit = parameter.range.unit().unwrap_or("");
    view.words.say(&message!("cycles-allowed").text("range", range).text("unit", unit)).trim_end().to_owned()
}

fn draw(canvas: &Canvas<'_>, scene: Scene, parameter: &Parameter) {
    let meaning = parameter.meaning;
    let key = parameter.key.to_string();
    match meaning {
        Meaning::MeasuringHeight
        | Meaning::SecondHeight
        | Meaning::NextPoint(Axis::Third)
        | Meaning::SetUpClearance
        | Meaning::ClearanceHeight
        | Meaning::Difference
        | Meaning::Band
        | Meaning::Retract
        | Meaning::ToolAxisPoint(Axis::Third)
        | Meaning::NewDatum(Axis::Third)
        | Meaning::Point(Axis::Third) => section::draw(canvas, scene, meaning, &key),
        Meaning::Point(_) if scene.shape == Shape::Point => section::draw(canvas, scene, meaning, &key),
        Meaning::Tool => choice::draw(canvas, scene, (meaning, &[0, 1]), &key),
        _ => match parameter.range {
            Range::OneOf(numbers) => choice::draw(canvas, scene, (meaning, numbers), &key),
            _ => plan::draw(canvas, scene, meaning, &key),
        },
    }
}
