//! The verdict for two metres: shape and word as large as they fit, beside or above what is to be done, or else the value.

use eframe::egui::text::{LayoutJob, TextFormat};
use eframe::egui::{Align, Color32, FontId, Label, Layout, Margin, RichText, Sense, Ui, vec2};

use crate::gui::card::verdict_ui;
use crate::gui::columns::of_height;
use crate::gui::shapes::{self, Edge};
use crate::gui::theme::{self, palette, sizes, space};
use crate::gui::verdict_card::{Card, colours};
use crate::gui::view::View;
use crate::verdict::Status;

/// The size of the word at most. A capital has two thirds of it: 104 is 14 mm on a panel of ten inches with 1024 dots, 20 on
/// one of fifteen, which 20 minutes of arc (12 mm at 2 m) ask for.
const WORD: f32 = 104.0;

/// The size of what comes first after the word at most: what to do, or else the value. 16 minutes of arc are 9 mm at 2 m.
const FIRST: f32 = 66.0;

/// How high a line is for its size.
const LINE: f32 = 1.326;

/// The shares of both that are tried beside each other, the best first.
const BESIDE: [(f32, f32); 6] = [(1.0, 1.0), (1.0, 0.85), (1.0, 0.7), (0.9, 0.85), (0.9, 0.7), (0.85, 0.6)];

/// Below this height the rest stands beside the word where it can.
const LOW: f32 = 240.0;

/// Around the text.
const MARGIN: f32 = 16.0;

/// The share of the width that what comes first has, where lines stand beside it.
const FIRST_SHARE: f32 = 0.62;

/// How the lines stand.
struct Setting {
    word: f32,
    first: f32,
    /// Whether the rest stands beside the word; else it has a row below it.
    is_beside: bool,
}

fn width(ui: &Ui, text: &str, font: FontId) -> f32 {
    ui.painter().layout_no_wrap(text.to_owned(), font, Color32::PLACEHOLDER).size().x
}

/// What comes first has its unit in small letters.
fn first_job(first: &str, size: f32, colour: Color32) -> LayoutJob {
    let (number, unit) = match first.strip_suffix(" mm") {
        Some(number) => (number, " mm"),
        None => (first, ""),
    };
    let mut job = LayoutJob::default();
    job.append(number, 0.0, TextFormat::simple(theme::bold(size), colour));
    job.append(unit, 0.0, TextFormat::simple(theme::font(size * 0.45), colour));
    job
}

fn first_width(ui: &Ui, first: &str, size: f32) -> f32 {
    ui.painter().layout_job(first_job(first, size, Color32::PLACEHOLDER)).size().x
}

/// What comes first after the word, and the lines behind it.
fn texts(card: &Card) -> (String, Vec<String>) {
    let value = card.value.iter();
    // What has to be removed outranks the value.
    let mut lines = card.lines.clone();
    let first = match &card.instruction {
        Some((what, rest)) if card.status == Some(Status::Rework) => {
            lines.splice(0..0, std::iter::once(rest).chain(value).cloned());
            what.clone()
        }
        // How far it is beyond the limit comes first, then what to do.
        Some((what, rest)) => {
            let place = lines.len().min(1);
            lines.splice(place..place, [what.clone(), rest.clone()]);
            value.cloned().collect()
        }
        None => value.cloned().collect(),
    };
    (first, lines)
}

impl Setting {
    fn of(ui: &Ui, card: &Card, size: eframe::egui::Vec2) -> Self {
        let (first, lines) = texts(card);
        // The shape is four fifths as wide as the word is high.
        let across = |word: f32| word * 0.8 + space(3.0) + width(ui, &card.word, theme::bold(word));
        let line = |text: &String| width(ui, text, theme::font(sizes().limits));
        let widest = lines.iter().take(2).map(line).fold(0.0, f32::max);
        let beside = |word: f32, first_size: f32| {
            let right = first_width(ui, &first, first_size).max(widest);
            across(word) + space(6.0) + right <= size.x
        };
        // A card that is wide and low has the rest beside the word: the value gives way before the word does.
        for (word, share) in BESIDE {
            if size.y < LOW && beside(WORD * word, FIRST * share) {
                return Self { word: WORD * word, first: FIRST * share, is_beside: true };
            }
        }
        let fitted = WORD * (size.x / across(WORD)).min(1.0);
        // What comes first is at least three fifths as large as the word.
        let tall = size.y / (LINE * 1.6);
        let word = fitted.min(tall).min(WORD).floor();
        let room = size.x * FIRST_SHARE / first_width(ui, &first, FIRST).max(1.0);
        let first = (FIRST * room.min(1.0)).min(size.y / LINE - word).floor();
        Self { word, first, is_beside: false }
    }
}

/// The card over a height, which does not depend on what is in it.
pub(super) fn big_card_ui(ui: &mut Ui, view: &View<'_>, card: &Card, height: f32) {
    let (fill, colour) = colours(palette(ui.ctx()), card.status, card.edge);
    let simulated = (card.edge == Edge::Dashes).then(|| view.text("simulated"));
    let inner = vec2(ui.available_width(), height) - vec2(MARGIN, MARGIN) * 2.0;
    let margin = Margin::same(16);
    of_height(ui, height, |ui| {
        verdict_ui(ui, (fill, colour), card.edge, margin, |ui| {
            ui.set_min_size(inner);
            ui.set_max_height(inner.y);
            ui.spacing_mut().item_spacing = vec2(space(3.0), 0.0);
            if let Some(simulated) = &simulated {
                ui.label(RichText::new(simulated).font(theme::bold(sizes().body)).color(colour));
            }
            if card.status.is_none() {
                return waiting_ui(ui, card, colour);
            }
            let room = vec2(inner.x, inner.y - if simulated.is_some() { sizes().body * 1.4 } else { 0.0 });
            let setting = Setting::of(ui, card, room);
            let (first, lines) = texts(card);
            if setting.is_beside {
                ui.horizontal(|ui| {
                    ui.set_min_height(room.y);
                    word_ui(ui, card, &setting, colour);
                    ui.add_space(space(3.0));
                    ui.vertical(|ui| {
                        let lines_height = shapes::times(sizes().limits * 1.4, lines.len().min(3));
                        ui.add_space(((room.y - setting.first * LINE - lines_height) / 2.0).max(0.0));
                        ui.add(Label::new(first_job(&first, setting.first, colour)).extend());
                        lines_ui(ui, &lines, (room.y - setting.first * LINE, colour));
                    });
                });
            } else {
                ui.horizontal(|ui| {
                    ui.set_min_height(setting.word * LINE);
                    word_ui(ui, card, &setting, colour);
                });
                ui.horizontal_top(|ui| {
                    ui.add(Label::new(first_job(&first, setting.first, colour)).extend());
                    ui.vertical(|ui| lines_ui(ui, &lines, (room.y - setting.word * LINE, colour)));
                });
            }
            said(card, simulated.as_ref(), first, lines)
        });
    });
}

/// What a screen reader says: the word, then what stands beside it.
fn said(card: &Card, simulated: Option<&String>, first: String, lines: Vec<String>) -> Vec<String> {
    simulated
        .cloned()
        .into_iter()
        .chain([card.word.clone(), first])
        .chain(lines)
        .filter(|text| !text.is_empty())
        .collect()
}

/// Nothing is judged yet: what comes next, quietly.
fn waiting_ui(ui: &mut Ui, card: &Card, colour: Color32) -> Vec<String> {
    let texts: Vec<&String> = card.value.iter().chain(&card.lines).collect();
    ui.with_layout(Layout::top_down(Align::Min), |ui| {
        ui.spacing_mut().item_spacing.y = space(1.0);
        ui.label(RichText::new(&card.word).font(theme::bold(sizes().value)).color(colour));
        for text in &texts {
            ui.add(Label::new(RichText::new(*text).font(theme::font(sizes().limits)).color(colour)).wrap());
        }
    });
    std::iter::once(card.word.clone()).chain(texts.into_iter().cloned()).collect()
}

fn word_ui(ui: &mut Ui, card: &Card, setting: &Setting, colour: Color32) {
    let (rect, _) = ui.allocate_exact_size(vec2(setting.word * 0.8, setting.word * 0.8), Sense::hover());
    shapes::status(ui.painter(), rect, card.status, colour);
    ui.add(Label::new(RichText::new(&card.word).font(theme::bold(setting.word)).color(colour)).extend());
}

/// The sizes of lines that are tried, as shares of the usual one: the first two are always whole, the value among them.
const LINES: [f32; 3] = [1.0, 0.85, 0.7];

/// As many lines as have room; the reasons have all of them.
fn lines_ui(ui: &mut Ui, lines: &[String], (room, colour): (f32, Color32)) {
    let width = ui.available_width();
    let height =
        |line: &String, size: f32| ui.painter().layout(line.clone(), theme::font(size), colour, width).size().y;
    let has_room = |size: &f32| lines.iter().take(2).map(|line| height(line, *size)).sum::<f32>() <= room;
    let sizes = LINES.map(|share| sizes().limits * share);
    let size = sizes.into_iter().find(has_room).unwrap_or(sizes[2]);
    let heights: Vec<f32> = lines.iter().map(|line| height(line, size)).collect();
    let mut left = room;
    for (line, height) in lines.iter().zip(heights) {
        left -= height;
        if left < 0.0 {
            return;
        }
        ui.add(Label::new(RichText::new(line).font(theme::font(size)).color(colour)).wrap());
    }
}
