//! A page of three columns (what is asked, what is seen, the answer), and how they fold where the window is small.
//!
//! The verdict never scrolls and never gives way: it stands above its column, or above the whole page.

use eframe::egui::{Frame, Margin, Memory, Panel, ScrollArea, Ui, vec2};

use super::keypad::{self, keypad_ui};
use super::theme::space;
use super::view::View;

/// The least width of the left column.
const LEAST_ASKED: f32 = 224.0;

/// Draws a part of a page.
pub(super) type Draw = fn(&mut Ui, &mut View<'_>);

/// The parts of a page.
pub(super) struct Page {
    /// Its name, for the widths that the user gave its columns.
    pub name: &'static str,
    /// The width of the left column until the user changes it.
    pub left: f32,
    /// The same of the right one.
    pub right: f32,
    /// What stands above the left column and does not scroll.
    pub head: Option<Draw>,
    /// The left column.
    pub asked: Draw,
    /// The middle.
    pub seen: Draw,
    /// What the middle needs where it is one part of a column.
    pub seen_height: f32,
    /// The verdict, above the right column.
    pub verdict: Draw,
    /// The least width that the verdict needs, so that its word is never set smaller.
    pub least: f32,
    /// The right column.
    pub answer: Draw,
}

/// How many columns a window of a width has.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Shape {
    /// The verdict above, and everything else below it in one column.
    One,
    /// What is asked beside the rest.
    Two,
    /// All three.
    Three,
}

impl Shape {
    /// The shape of what is left of the window; `least` is the width of a verdict.
    pub fn of(ui: &Ui, least: f32) -> Self {
        match ui.available_width() {
            width if width < least + LEAST_ASKED => Self::One,
            width if width < space(225.0) => Self::Two,
            _ => Self::Three,
        }
    }
}

/// Whether the window is so low that pictures give way to words.
pub(super) fn is_low(ui: &Ui) -> bool {
    ui.ctx().content_rect().height() < space(160.0)
}

/// Whether there is only room for the word, the value and what to do.
pub(super) fn is_tiny(ui: &Ui) -> bool {
    ui.ctx().content_rect().height() < space(120.0)
}

/// The page in the shape that the window has room for.
pub(super) fn columns_ui(ui: &mut Ui, view: &mut View<'_>, page: &Page) {
    let least = page.least;
    match Shape::of(ui, least) {
        Shape::One => one_ui(ui, view, page),
        Shape::Two => two_ui(ui, view, page, least),
        Shape::Three => three_ui(ui, view, page, least),
    }
}

fn three_ui(ui: &mut Ui, view: &mut View<'_>, page: &Page, least: f32) {
    let (is_narrow, all) = (ui.available_width() < space(300.0), ui.available_width());
    let [left, right] = [page.left, page.right].map(|width| if is_narrow { width * 0.88 } else { width });
    // The middle keeps a fifth of the page, however wide the others are drawn.
    let least_asked = LEAST_ASKED.max(keypad::width(view));
    let most = (all * 0.8 - least).max(least_asked);
    let left = Panel::left((page.name, "asked", is_narrow)).resizable(true).default_size(left.min(most));
    left.size_range(least_asked..=most).show(ui, |ui| asked_ui(ui, view, page));
    let most = (ui.available_width() - space(40.0)).max(least);
    let right = Panel::right((page.name, "answer", is_narrow)).resizable(true).default_size(right.clamp(least, most));
    right.size_range(least..=most).show(ui, |ui| answer_ui(ui, view, page, false));
    ui.scope(|ui| {
        let frame = Frame::central_panel(ui.style());
        eframe::egui::CentralPanel::default().frame(frame).show(ui, |ui| (page.seen)(ui, view));
    });
}

fn two_ui(ui: &mut Ui, view: &mut View<'_>, page: &Page, least: f32) {
    let most = (ui.available_width() - least).max(LEAST_ASKED);
    let least_asked = LEAST_ASKED.max(keypad::width(view)).min(most);
    let panel = Panel::left((page.name, "asked", 2)).resizable(true).default_size(page.left.min(most));
    panel.size_range(least_asked..=most).show(ui, |ui| asked_ui(ui, view, page));
    eframe::egui::CentralPanel::default().show(ui, |ui| answer_ui(ui, view, page, true));
}

fn one_ui(ui: &mut Ui, view: &mut View<'_>, page: &Page) {
    let margin = Frame::side_top_panel(ui.style()).inner_margin(Margin::same(4));
    let top = Panel::top((page.name, "verdict")).frame(margin).resizable(false);
    top.show(ui, |ui| (page.verdict)(ui, view));
    keypad_ui(ui, view);
    eframe::egui::CentralPanel::default().show(ui, |ui| {
        column_ui(ui, (page.name, "all"), |ui| {
            for part in page.head.iter().chain([&page.asked]) {
                part(ui, view);
            }
            ui.separator();
            (page.answer)(ui, view);
            ui.separator();
            of_height(ui, page.seen_height, |ui| (page.seen)(ui, view));
        });
    });
}

fn asked_ui(ui: &mut Ui, view: &mut View<'_>, page: &Page) {
    keypad_ui(ui, view);
    if let Some(head) = page.head {
        ui.spacing_mut().item_spacing.y = space(1.0);
        head(ui, view);
        ui.separator();
    }
    column_ui(ui, (page.name, "asked"), |ui| (page.asked)(ui, view));
}

fn answer_ui(ui: &mut Ui, view: &mut View<'_>, page: &Page, with_seen: bool) {
    (page.verdict)(ui, view);
    column_ui(ui, (page.name, "answer"), |ui| {
        (page.answer)(ui, view);
        if with_seen {
            ui.separator();
            of_height(ui, page.seen_height, |ui| (page.seen)(ui, view));
        }
    });
}

/// Takes the whole of a panel that can be resized: it is as large as what is in it.
pub(super) fn fill(ui: &mut Ui) {
    ui.set_min_size(ui.available_size());
}

/// A part of a column with a height of its own.
pub(super) fn of_height(ui: &mut Ui, height: f32, content: impl FnOnce(&mut Ui)) {
    let size = vec2(ui.available_width(), height);
    ui.allocate_ui(size, |ui| {
        ui.set_max_height(height);
        content(ui);
    });
}

/// A column that scrolls where the window is low; the floating bar never covers its content, and the focus is always in
/// sight.
pub(super) fn column_ui(ui: &mut Ui, id: impl std::hash::Hash + std::fmt::Debug, content: impl FnOnce(&mut Ui)) {
    ScrollArea::vertical().id_salt(id).auto_shrink(false).show(ui, |ui| {
        ui.set_max_width(ui.available_width() - space(2.5));
        ui.spacing_mut().item_spacing.y = space(1.0);
        content(ui);
        follow_focus(ui);
    });
}

/// Scrolls to the widget that has just got the focus, if it was just drawn here.
pub(super) fn follow_focus(ui: &Ui) {
    let focused = ui.memory(Memory::focused);
    let last =
        ui.data_mut(|data| std::mem::replace(data.get_temp_mut_or_default(ui.unique_id().with("focused")), focused));
    let Some(rect) = focused.filter(|_| focused != last).and_then(|id| ui.ctx().read_response(id)) else { return };
    if rect.layer_id == ui.layer_id() && ui.min_rect().contains(rect.rect.center()) {
        ui.scroll_to_rect(rect.rect, None);
    }
}
