//! The verdict's card: one word that can be read from two metres, its shape, and the lines below it.

use eframe::egui::accesskit::Role;
use eframe::egui::text::{LayoutJob, TextFormat, TextWrapping};
use eframe::egui::{Align2, Color32, FontId, Label, Margin, Response, RichText, Sense, Ui, WidgetInfo, pos2, vec2};

use super::card::{MARGIN, verdict_ui};
use super::room::{is_low, is_tiny};
use super::shapes::{self, Edge};
use super::theme::{self, Palette, control, palette, sizes, space};
use super::view::{Digits, View, doubt_text};
use crate::length::{Length, Unit};
use crate::message::{Message, Say as _, message};
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
    /// Whether nobody measured it, or the rule accepts what lies beyond a limit.
    pub edge: Edge,
    pub word: String,
    pub value: Option<String>,
    /// What is to be done, readable from as far as the word, and the rest of that sentence.
    pub instruction: Option<(String, String)>,
    /// The lines below.
    pub lines: Vec<String>,
    /// The least height of the card.
    pub height: f32,
    /// Whether there is little room: the word is no larger than it has to be, and a sentence stays on one line.
    pub is_close: bool,
}

impl Card {
    /// What a screen reader says.
    fn said(&self, simulated: Option<&String>) -> Vec<String> {
        let instruction = self.instruction.as_ref().map(|(what, rest)| format!("{}{rest}", ended(what, rest)));
        let parts = simulated.into_iter().chain([&self.word]).chain(&self.value).chain(&instruction).chain(&self.lines);
        parts.cloned().collect()
    }
}

/// The width that a card needs so that no word is set smaller than can be read from two metres.
pub(super) fn least_width(ui: &Ui, view: &View<'_>) -> f32 {
    let width = |status: Status| word_width(ui, &view.words.told(&status), WORD[0]);
    // The longest one stands on few cards, and there it is set as large as it has room.
    let usual = Status::ALL.into_iter().filter(|status| *status != Status::OutOfLimits);
    usual.map(width).fold(0.0, f32::max) + f32::from(MARGIN) * 2.0 + space(4.0)
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

/// The size of the word, at least and at most: the least can be read from two metres.
const WORD: [f32; 2] = [49.0, 76.0];

/// The size of the word at most where there is little room.
const CLOSE_WORD: f32 = 56.0;

/// The size of what comes first below the word: what to do, or else the value.
const FIRST: [f32; 2] = [24.0, 40.0];

fn word_width(ui: &Ui, word: &str, size: f32) -> f32 {
    ui.painter().layout_no_wrap(word.to_owned(), theme::bold(size), Color32::PLACEHOLDER).size().x
}

/// The side of a shape above a word: smaller where the window is low, and never left out.
fn shape_above(ui: &Ui) -> f32 {
    if is_tiny(ui) {
        space(6.0)
    } else if is_low(ui) {
        space(8.0)
    } else {
        space(11.0)
    }
}

/// How a card is set in a width.
struct Setting {
    word: f32,
    /// The side of its shape.
    shape: f32,
    /// Whether the shape stands beside the word; elsewhere it stands above it.
    is_beside: bool,
    /// What stands below the word, line by line.
    lines: Vec<LayoutJob>,
}

/// A line in a font.
fn line(text: &str, font: &FontId) -> LayoutJob {
    LayoutJob::single_section(text.to_owned(), TextFormat::simple(font.clone(), Color32::PLACEHOLDER))
}

/// What is to be done before the rest of its sentence, or before a sentence of its own.
fn ended(what: &str, rest: &str) -> String {
    let is_sentence = rest.chars().next().is_some_and(char::is_uppercase);
    if is_sentence { format!("{what}. ") } else { format!("{what} ") }
}

/// What is to be done, as large as leaves room for the rest of the sentence beside it; else that has a line of its own.
fn sentence(ui: &Ui, [what, rest]: [&str; 2], largest: f32, width: f32) -> Vec<LayoutJob> {
    let small = theme::font(sizes().body);
    let ended = ended(what, rest);
    let joined = ended.trim_end();
    let beside = ui.painter().layout_no_wrap(format!(" {rest}"), small.clone(), Color32::PLACEHOLDER).size().x;
    let size = largest.min((width - beside) * largest / word_width(ui, joined, largest).max(1.0)).floor();
    if size < FIRST[0] {
        return vec![line(what, &theme::bold(FIRST[0].min(largest))), line(rest, &small)];
    }
    let large = theme::bold(size);
    // Both stand on one line of writing, which the library sets by the lower edge of the texts.
    let [high, low] = [&large, &small].map(|font| {
        let galley = ui.painter().layout_no_wrap("0".to_owned(), font.clone(), Color32::PLACEHOLDER);
        let ascent = galley.rows.first().and_then(|row| row.glyphs.first()).map_or(0.0, |glyph| glyph.pos.y);
        (galley.size().y, ascent)
    });
    let mut job = line(joined, &large);
    // A text stands in the middle of a line that is higher than it.
    let line_height = Some(2.0 * (high.0 - high.1 + low.1) - low.0);
    job.append(&format!(" {rest}"), 0.0, TextFormat { line_height, ..TextFormat::simple(small, Color32::PLACEHOLDER) });
    vec![job]
}

impl Setting {
    /// The height of the line with the shape and the word.
    fn line(&self) -> f32 {
        (self.word * 1.34).ceil()
    }

    fn of(ui: &Ui, card: &Card, width: f32) -> Self {
        let [least, most] = if card.is_close { [WORD[0], CLOSE_WORD] } else { WORD };
        let wanted = if card.status.is_some() {
            (width * 0.2).min(ui.ctx().content_rect().height() * 0.12).clamp(least, most)
        } else {
            sizes().figure
        };
        let fits = |room: f32| wanted.min(wanted * room / word_width(ui, &card.word, wanted).max(1.0)).floor();
        // Word and shape grow together, the gap between them does not.
        let share = word_width(ui, &card.word, wanted) / wanted + 0.8;
        let beside = wanted.min((width - space(4.0)) / share).floor();
        // The shape goes above a long word.
        let is_beside = least.min(wanted) <= beside;
        let word = if is_beside { beside } else { fits(width) };
        let shape = if is_beside { word * 0.8 } else { shape_above(ui) };
        let first = theme::bold((width * 0.12).clamp(FIRST[0], FIRST[1]).min(word).floor());
        let mut lines = Vec::new();
        let mut value = first.clone();
        if let Some((what, rest)) = &card.instruction {
            if card.is_close {
                lines.extend(sentence(ui, [what, rest], first.size, width));
            } else if is_tiny(ui) {
                // On one line: a second one has no room.
                let room = width / word_width(ui, what, first.size).max(1.0);
                let size = (first.size * room.min(1.0)).max(sizes().small).floor();
                lines.push(line(what, &theme::bold(size)));
            } else {
                lines.push(line(what, &first));
                lines.push(line(rest, &theme::font(sizes().body)));
            }
            value = theme::bold(sizes().figure);
        }
        lines.extend(card.value.iter().map(|text| line(text, &value)));
        // Where there is no room the lines stand below the card.
        if !is_tiny(ui) {
            let size = if card.status.is_some() { sizes().limits } else { sizes().small };
            lines.extend(card.lines.iter().map(|text| line(text, &theme::font(size))));
        }
        Self { word, shape, is_beside, lines }
    }
}

/// The card, which is also a live region: a screen reader says the word and the lines.
pub(super) fn card_ui(ui: &mut Ui, view: &View<'_>, card: &Card) {
    footed_card_ui(ui, view, card, None);
}

/// What stands at the foot of a card, in its colour.
pub(super) type Foot<'a> = &'a mut dyn FnMut(&mut Ui, Color32);

/// The same with a line at its foot.
pub(super) fn footed_card_ui(ui: &mut Ui, view: &View<'_>, card: &Card, foot: Option<Foot<'_>>) {
    let (fill, colour) = colours(palette(ui.ctx()), card.status, card.edge);
    let simulated = (card.edge == Edge::Dashes).then(|| view.text("simulated"));
    verdict_ui(ui, (fill, colour), card.edge, Margin::same(MARGIN), |ui| {
        // What is asked or not there yet takes what it needs.
        let least = if foot.is_some() || card.status.is_none() { 0.0 } else { least_height(ui) };
        let least = least.max(card.height - f32::from(MARGIN) * 2.0);
        if foot.is_none() {
            ui.set_min_height(least);
        }
        ui.spacing_mut().item_spacing.y = space(1.0);
        ui.vertical(|ui| {
            if let Some(simulated) = &simulated {
                ui.label(RichText::new(simulated).font(theme::bold(sizes().body)).color(colour));
            }
            let setting = Setting::of(ui, card, ui.available_width());
            word_ui(ui, card, &setting, colour);
            for mut line in setting.lines {
                for section in &mut line.sections {
                    section.format.color = colour;
                }
                ui.label(line);
            }
        });
        if let Some(foot) = foot {
            let line = control(ui);
            let above =
                card.height - f32::from(MARGIN) * 2.0 - ui.min_rect().height() - line - ui.spacing().item_spacing.y;
            ui.add_space(above.max(0.0));
            ui.horizontal(|ui| {
                ui.set_min_height(line);
                foot(ui, colour);
            });
        }
        card.said(simulated.as_ref())
    });
}

/// The height that a card takes in what is left of the width.
pub(super) fn card_height(ui: &Ui, view: &View<'_>, card: &Card) -> f32 {
    card_height_in(ui, view, card, ui.available_width())
}

/// The height of the line at the foot of a card, with the gap above it.
pub(super) fn foot_height(ui: &Ui) -> f32 {
    control(ui) + space(1.0)
}

/// The same of a card in a width.
pub(super) fn card_height_in(ui: &Ui, view: &View<'_>, card: &Card, width: f32) -> f32 {
    let width = width - f32::from(MARGIN) * 2.0;
    let text =
        |text: &str, font: FontId| ui.painter().layout(text.to_owned(), font, Color32::PLACEHOLDER, width).size().y;
    let setting = Setting::of(ui, card, width);
    let mut heights = Vec::new();
    if setting.is_beside {
        heights.push(setting.line());
    } else {
        heights.push(text(&card.word, theme::bold(setting.word)));
        heights.push(setting.shape);
    }
    if card.edge == Edge::Dashes {
        heights.push(text(&view.text("simulated"), theme::bold(sizes().body)));
    }
    heights.extend(setting.lines.into_iter().map(|mut line| {
        line.wrap.max_width = width;
        ui.painter().layout_job(line).size().y
    }));
    let gaps = space(1.0) * f32::from(u8::try_from(heights.len()).unwrap_or(u8::MAX).saturating_sub(1));
    heights.into_iter().sum::<f32>() + gaps + f32::from(MARGIN) * 2.0
}

/// The height of what is in the card of a verdict at least, where there is room.
fn least_height(ui: &Ui) -> f32 {
    if is_low(ui) { 0.0 } else { space(54.0) }
}

/// The height of the tallest of the usual results in a width: a page keeps its height, whatever the result is.
pub(super) fn usual_height_in(ui: &Ui, view: &View<'_>, width: f32) -> f32 {
    let said = |id: &'static str| view.words.say(&Message::new(id).text("um", "88.8"));
    // A shorter word and a shorter value are set larger.
    let [rework, good] = [(Status::Rework, "88: 88.8888 mm"), (Status::Good, "8: 8.888 mm")].map(|(status, value)| {
        Card { status: Some(status), word: view.words.told(&status), value: Some(value.to_owned()), ..Card::default() }
    });
    let instruction = Some(remove(view.words, "88.8", Some("88.8".to_owned())));
    let usual = [
        Card { instruction, lines: vec![said("remove-to-middle")], ..rework },
        Card { lines: vec![said("above-minimum"), said("below-maximum")], ..good },
    ];
    let least = least_height(ui) + f32::from(MARGIN) * 2.0;
    usual.iter().map(|card| card_height_in(ui, view, card, width)).fold(least, f32::max)
}

/// A card that is no higher than the room, and the lines for which that has no place.
pub(super) fn fitted(mut card: Card, room: f32, height: impl Fn(&Card) -> f32) -> (Card, Vec<String>) {
    let mut below = Vec::new();
    while !card.lines.is_empty() && room < height(&card) {
        below.extend(card.lines.pop());
    }
    below.reverse();
    (card, below)
}

/// Shape and word.
fn word_ui(ui: &mut Ui, card: &Card, setting: &Setting, colour: Color32) {
    let text = RichText::new(&card.word).font(theme::bold(setting.word)).color(colour);
    let shape = vec2(setting.shape, setting.shape);
    let shape_ui = |ui: &mut Ui| {
        let (rect, _) = ui.allocate_exact_size(shape, Sense::hover());
        shapes::status(ui.painter(), rect, card.status, colour);
    };
    if setting.is_beside {
        ui.horizontal(|ui| {
            ui.spacing_mut().item_spacing.x = space(3.0);
            // The row has its height before anything is in it: both stand on one middle line.
            ui.set_min_height(setting.line());
            shape_ui(ui);
            ui.add(Label::new(text).extend());
        });
    } else {
        shape_ui(ui);
        ui.label(text);
    }
}

/// A small verdict: shape, text and colour.
pub(super) fn chip_ui(ui: &mut Ui, status: Status, text: &str) -> Response {
    edged_chip_ui(ui, (status, Edge::None), text)
}

/// The same of one value.
pub(super) fn edged_chip_ui(ui: &mut Ui, (status, edge): (Status, Edge), text: &str) -> Response {
    let (fill, colour) = colours(palette(ui.ctx()), Some(status), edge);
    let galley = ui.painter().layout_no_wrap(text.to_owned(), theme::bold(sizes().small), colour);
    let mark = space(3.5);
    let gap = space(1.5);
    let size = vec2(mark + gap + galley.size().x, galley.size().y.max(mark)) + vec2(16.0, 6.0);
    let (rect, response) = ui.allocate_exact_size(size, Sense::hover());
    let inner = rect.shrink2(vec2(8.0, 4.0));
    ui.painter().rect_filled(rect, 6.0, fill);
    shapes::edge(ui.painter(), (rect, 6.0), edge, colour);
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
pub(super) fn strip_ui(ui: &mut Ui, status: Option<Status>, edge: Edge, text: &str) {
    let (fill, colour) = colours(palette(ui.ctx()), status, edge);
    let (rect, response) = ui.allocate_exact_size(vec2(ui.available_width(), strip_height(ui)), Sense::hover());
    ui.painter().rect_filled(rect, 8.0, fill);
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
    shapes::edge(ui.painter(), (rect, 8.0), edge, colour);
    response.widget_info(|| WidgetInfo::labeled(Role::Label, true, text));
    if is_cut {
        response.on_hover_text(text);
    }
}

/// The fill of a verdict and the colour on it: pale within an edge.
pub(super) const fn colours(palette: &Palette, status: Option<Status>, edge: Edge) -> (Color32, Color32) {
    if matches!(edge, Edge::None) { palette.of_status(status) } else { palette.of_pale(status) }
}

/// What to remove of a size, up to what, and how much of it on each side where the size is a diameter.
pub(super) fn remove(words: &Words, um: &str, per_side: Option<String>) -> (String, String) {
    let up_to = match per_side {
        Some(um) => words.say(&message!("remove-to-limit-per-side").text("um", um)),
        None => words.get("remove-to-limit"),
    };
    (words.say(&message!("remove-amount").text("um", um)), up_to)
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
