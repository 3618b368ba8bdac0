//! The verdict's card: one word that can be read from two metres, its shape, and the lines below it.

use eframe::egui::accesskit::Role;
use eframe::egui::text::{LayoutJob, TextWrapping};
use eframe::egui::{
    Align, Align2, Color32, FontId, Layout, Margin, Response, RichText, Sense, Ui, WidgetInfo, pos2, vec2,
};

use super::card::{MARGIN, verdict_ui};
use super::columns::{is_low, is_tiny};
use super::shapes;
use super::theme::{self, Palette, control, palette, sizes, space};
use super::view::{Digits, View, doubt_text};
use crate::length::{Length, Unit};
use crate::message::{Say as _, message};
use crate::session::Question;
use crate::verdict::Status;
use crate::words::Words;

/// The name of a status in the locale files.
pub(super) fn status_id(status: Option<Status>) -> &'static str {
    status.map_or("word-none", |status| status.message().id)
}

/// What a card says.
#[derive(Debug, Default)]
pub(super) struct Card {
    /// Colour and shape; `None` is no result.
    pub status: Option<Status>,
    /// Whether the value was simulated: nobody measured it.
    pub is_simulated: bool,
    pub word: String,
    pub value: Option<String>,
    /// What is to be done, readable from as far as the word, and the rest of that sentence.
    pub instruction: Option<(String, String)>,
    /// The lines below.
    pub lines: Vec<String>,
    /// The least height of the card.
    pub height: f32,
}

impl Card {
    /// What a screen reader says.
    fn said(&self, simulated: Option<&String>) -> Vec<String> {
        let instruction = self.instruction.as_ref().map(|(what, rest)| format!("{what} {rest}"));
        let parts = simulated.into_iter().chain([&self.word]).chain(&self.value).chain(&instruction).chain(&self.lines);
        parts.cloned().collect()
    }
}

/// The width that a card needs so that no word is set smaller than its size.
pub(super) fn least_width(ui: &Ui, view: &View<'_>) -> f32 {
    let width = |status: Status| word_width(ui, &view.words.told(&status), sizes().status);
    Status::ALL.map(width).into_iter().fold(0.0, f32::max) + f32::from(MARGIN) * 2.0 + space(4.0)
}

/// The card of what is asked about a measured value before it is judged; as high as its page wants it.
pub(super) fn question_card(view: &View<'_>, question: &Question, height: f32) -> Card {
    Card {
        word: view.text("word-question"),
        value: Some(format!("{} mm", view.words.mm(question.measured, 3))),
        lines: vec![doubt_text(view.words, question.doubt), view.text("question-enter")],
        height,
        ..Card::default()
    }
}

/// The lines of a card for which it has no room.
pub(super) fn lines_below_ui(ui: &mut Ui, card: &Card) {
    if is_tiny(ui) {
        for line in card.instruction.iter().map(|(_, rest)| rest).chain(&card.lines) {
            ui.label(line);
        }
    }
}

/// The width of a word; of several words or parts, which go below each other, that of the longest.
fn word_width(ui: &Ui, word: &str, size: f32) -> f32 {
    let width =
        |part: &str| ui.painter().layout_no_wrap(part.to_owned(), theme::bold(size), Color32::PLACEHOLDER).size().x;
    word.split_inclusive(['-', ' ']).map(|part| width(part.trim_end())).fold(0.0, f32::max)
}

/// The card, which is also a live region: a screen reader says the word and the lines.
pub(super) fn card_ui(ui: &mut Ui, view: &View<'_>, card: &Card) {
    let (fill, colour) = colours(palette(ui.ctx()), card.status, card.is_simulated);
    let simulated = card.is_simulated.then(|| view.text("simulated"));
    verdict_ui(ui, (fill, colour), card.is_simulated, Margin::same(MARGIN), |ui| {
        let least = if is_low(ui) { 0.0 } else { space(54.0) };
        ui.set_min_height(least.max(card.height - f32::from(MARGIN) * 2.0));
        ui.spacing_mut().item_spacing.y = space(1.0);
        ui.vertical_centered(|ui| {
            if let Some(simulated) = &simulated {
                ui.label(RichText::new(simulated).font(theme::bold(sizes().figure)).color(colour));
            }
            let size = word_ui(ui, card, colour);
            if let Some((what, rest)) = &card.instruction {
                ui.label(RichText::new(what).font(theme::bold(instruction_size(size))).color(colour));
                if !is_tiny(ui) {
                    ui.label(RichText::new(rest).font(theme::font(sizes().limits)).color(colour));
                }
            }
            if let Some(value) = &card.value {
                ui.label(RichText::new(value).font(theme::bold(sizes().figure)).color(colour));
            }
            // Where there is no room the lines stand below the card.
            let lines = if is_tiny(ui) { [].as_slice() } else { card.lines.as_slice() };
            for line in lines {
                ui.label(RichText::new(line).font(theme::font(sizes().limits)).color(colour));
            }
        });
        card.said(simulated.as_ref())
    });
}

/// The height that a card takes in what is left of the width, so that a page can keep it for another result.
pub(super) fn card_height(ui: &Ui, view: &View<'_>, card: &Card) -> f32 {
    let width = ui.available_width() - f32::from(MARGIN) * 2.0;
    let text =
        |text: &str, font: FontId| ui.painter().layout(text.to_owned(), font, Color32::PLACEHOLDER, width).size();
    let size = word_size(ui, card, width);
    let word = text(&card.word, theme::bold(size));
    let mut heights = vec![word.y];
    if !is_beside(ui, card, size, width) {
        heights.push(shape_above(ui));
    }
    if card.is_simulated {
        heights.push(text(&view.text("simulated"), theme::bold(sizes().figure)).y);
    }
    if let Some((what, rest)) = &card.instruction {
        heights.push(text(what, theme::bold(instruction_size(size))).y);
        if !is_tiny(ui) {
            heights.push(text(rest, theme::font(sizes().limits)).y);
        }
    }
    heights.extend(card.value.iter().map(|value| text(value, theme::bold(sizes().figure)).y));
    if !is_tiny(ui) {
        heights.extend(card.lines.iter().map(|line| text(line, theme::font(sizes().limits)).y));
    }
    let gaps = space(1.0) * f32::from(u8::try_from(heights.len()).unwrap_or(u8::MAX).saturating_sub(1));
    heights.into_iter().sum::<f32>() + gaps + f32::from(MARGIN) * 2.0
}

/// The size of what is to be done, below a word of a size.
fn instruction_size(word: f32) -> f32 {
    (word * 0.5).ceil()
}

/// The size of a card's word: 64 points and up, according to the panel. Pages keep [`least_width`] for it; only a window
/// that is narrower than the word sets it smaller. No result is set smaller.
fn word_size(ui: &Ui, card: &Card, width: f32) -> f32 {
    let room = (width * 0.2).min(ui.ctx().content_rect().height() * 0.14);
    let wanted = if card.status.is_some() { sizes().status.max(room) } else { sizes().figure };
    wanted.min(wanted * width / word_width(ui, &card.word, wanted).max(1.0)).floor()
}

/// What a shape beside a word of a size takes of the width.
fn beside(size: f32) -> f32 {
    size + space(2.0)
}

/// Whether the shape stands beside the word: where the window is low and there is room. Elsewhere it stands above it.
fn is_beside(ui: &Ui, card: &Card, size: f32, width: f32) -> bool {
    let word = ui.painter().layout_no_wrap(card.word.clone(), theme::bold(size), Color32::PLACEHOLDER);
    is_low(ui) && word.size().x + beside(size) < width
}

/// The side of a shape above a word: smaller where the window is low, and never left out.
fn shape_above(ui: &Ui) -> f32 {
    if is_tiny(ui) {
        space(6.0)
    } else if is_low(ui) {
        space(9.0)
    } else {
        space(16.0)
    }
}

/// Shape and word; returns the word's size.
fn word_ui(ui: &mut Ui, card: &Card, colour: Color32) -> f32 {
    let width = ui.available_width();
    let size = word_size(ui, card, width);
    let text = RichText::new(&card.word).font(theme::bold(size)).color(colour);
    if is_beside(ui, card, size, width) {
        let galley = ui.painter().layout_no_wrap(card.word.clone(), theme::bold(size), colour);
        let beside = beside(size);
        let row = vec2(width, galley.size().y);
        ui.allocate_ui_with_layout(row, Layout::left_to_right(Align::Center), |ui| {
            ui.add_space((width - galley.size().x - beside) / 2.0);
            let (rect, _) = ui.allocate_exact_size(vec2(size * 0.8, size * 0.8), Sense::hover());
            shapes::status(ui.painter(), rect, card.status, colour);
            ui.label(text);
        });
    } else {
        let side = shape_above(ui);
        let (rect, _) = ui.allocate_exact_size(vec2(side, side), Sense::hover());
        shapes::status(ui.painter(), rect, card.status, colour);
        ui.label(text);
    }
    size
}

/// A small verdict: shape, text and colour.
pub(super) fn chip_ui(ui: &mut Ui, status: Status, text: &str) -> Response {
    let (fill, colour) = palette(ui.ctx()).of_status(Some(status));
    let galley = ui.painter().layout_no_wrap(text.to_owned(), theme::bold(sizes().body), colour);
    let mark = space(4.0);
    let gap = space(2.0);
    let size = vec2(mark + gap + galley.size().x, galley.size().y.max(mark)) + vec2(16.0, 8.0);
    let (rect, response) = ui.allocate_exact_size(size, Sense::hover());
    let inner = rect.shrink2(vec2(8.0, 4.0));
    ui.painter().rect_filled(rect, 4.0, fill);
    let shape = Align2::LEFT_CENTER.align_size_within_rect(vec2(mark, mark), inner);
    shapes::status(ui.painter(), shape, Some(status), colour);
    let at = Align2::RIGHT_CENTER.align_size_within_rect(galley.size(), inner);
    ui.painter().galley(at.min, galley, colour);
    response.widget_info(|| WidgetInfo::labeled(Role::Label, true, text));
    response
}

pub(super) fn strip_height(ui: &Ui) -> f32 {
    control(ui) + space(1.0)
}

/// A verdict in one line of its own: shape, text and colour, as wide as there is room.
pub(super) fn strip_ui(ui: &mut Ui, status: Option<Status>, is_simulated: bool, text: &str) {
    let (fill, colour) = colours(palette(ui.ctx()), status, is_simulated);
    let (rect, response) = ui.allocate_exact_size(vec2(ui.available_width(), strip_height(ui)), Sense::hover());
    ui.painter().rect_filled(rect, 4.0, fill);
    let inner = rect.shrink2(vec2(space(2.0), space(1.0)));
    let side = space(5.0);
    let mark = Align2::LEFT_CENTER.align_size_within_rect(vec2(side, side), inner);
    shapes::status(ui.painter(), mark, status, colour);
    let of_size = |size: f32| {
        let mut job = LayoutJob::simple_singleline(text.to_owned(), theme::bold(size), colour);
        job.wrap = TextWrapping::truncate_at_width(inner.width() - side - space(2.0));
        ui.painter().layout_job(job)
    };
    // A text that would be cut is smaller.
    let mut galley = of_size(sizes().limits);
    if galley.elided {
        galley = of_size(sizes().body);
    }
    let is_cut = galley.elided;
    ui.painter().galley(pos2(mark.right() + space(2.0), inner.center().y - galley.size().y / 2.0), galley, colour);
    if is_simulated {
        shapes::dashed_frame(ui.painter(), rect, colour);
    }
    response.widget_info(|| WidgetInfo::labeled(Role::Label, true, text));
    if is_cut {
        response.on_hover_text(text);
    }
}

/// The fill of a verdict and the colour on it: pale where nobody measured.
pub(super) const fn colours(palette: &Palette, status: Option<Status>, is_simulated: bool) -> (Color32, Color32) {
    if is_simulated { palette.of_simulated(status) } else { palette.of_status(status) }
}

/// What to remove, and up to what.
pub(super) fn remove(words: &Words, um: &str) -> (String, String) {
    (words.say(&message!("remove-amount").text("um", um)), words.get("remove-to-limit"))
}

/// Half of a length as it is shown, µm.
pub(super) fn half(words: &Words, digits: Digits, length: Length) -> String {
    match digits {
        Digits::Exact => words.number(&half_um(length)),
        Digits::Rounded => digits.um(words, length.midpoint(Length::ZERO)),
    }
}

/// Half of a length in µm, exact.
fn half_um(length: Length) -> String {
    let odd = Length::constant(length.nanometres() % 2);
    let whole = length.saturating_sub(odd).midpoint(Length::ZERO);
    if odd == Length::ZERO {
        whole.exact(Unit::Micrometre, 0)
    } else {
        format!("{}5", whole.exact(Unit::Micrometre, 3))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn half_of_a_length_is_exact() {
        for (nm, half) in [(2_000, "1"), (25_000, "12.5"), (1, "0.0005"), (3, "0.0015"), (9_001, "4.5005")] {
            assert_eq!(half_um(Length::from_nanometres(nm).unwrap()), half);
        }
    }
}
