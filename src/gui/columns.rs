//! A page of three columns (what is asked, what is seen, the answer), and how they fold where the window is small.
//!
//! The verdict never scrolls and never gives way: it stands above its column, or above the whole page.

use std::ops::RangeInclusive;

use eframe::egui::accesskit::{Action, ActionRequest, TreeId};
use eframe::egui::containers::panel::PanelState;
use eframe::egui::{
    AsIdSalt, CentralPanel, Event, EventFilter, Frame, Id, Key, Margin, Memory, Panel, Rect, ScrollArea, Sense, Ui,
    UiBuilder, vec2,
};

use super::card::{page_card_ui, page_frame};
use super::keypad::{self, keypad_ui};
use super::room::is_tiny;
use super::theme::{control, palette, space};
use super::view::View;

/// The least width of the left column.
const LEAST_ASKED: f32 = 256.0;

/// From this width on a page has three columns.
pub(super) const THREE: f32 = 900.0;

/// The room of the bar of what scrolls.
const BAR: f32 = 2.5;

/// Between two cards.
pub(super) const GAP: i8 = 12;

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
    /// From this width on its parts have room beside each other: [`THREE`], or more.
    pub three: f32,
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
    Three,
}

impl Shape {
    /// The shape of what is left of the window; `least` is the width of a verdict.
    pub fn of(ui: &Ui, least: f32, three: f32) -> Self {
        match ui.available_width() {
            width if width < least + LEAST_ASKED => Self::One,
            width if width < three => Self::Two,
            _ => Self::Three,
        }
    }
}

/// The page in the shape that the window has room for.
pub(super) fn columns_ui(ui: &mut Ui, view: &mut View<'_>, page: &Page) {
    let least = page.least;
    match Shape::of(ui, least, page.three) {
        Shape::One => one_ui(ui, view, page),
        Shape::Two => two_ui(ui, view, page, least),
        Shape::Three => three_ui(ui, view, page, least),
    }
}

fn is_narrow(ui: &Ui) -> bool {
    ui.available_width() < space(300.0)
}

/// How wide a side column of this width is where there is little room.
pub(super) fn scaled(ui: &Ui, width: f32) -> f32 {
    if is_narrow(ui) { width * 0.88 } else { width }
}

fn three_ui(ui: &mut Ui, view: &mut View<'_>, page: &Page, least: f32) {
    let is_narrow = is_narrow(ui);
    let all = ui.available_width();
    let [left, right] = [page.left, page.right].map(|width| scaled(ui, width));
    // The middle keeps a fifth of the page, and the width of a drawing, however wide the others are drawn.
    let least_asked = LEAST_ASKED.max(keypad::width(view));
    let most = (all - (all * 0.2).max(space(72.0)) - least).max(least_asked);
    let sizes = (left.clamp(least_asked, most), least_asked..=most);
    let salt = (page.name, "asked", is_narrow);
    panel_ui(ui, view, Side::Left, salt, sizes, |ui, view| asked_ui(ui, view, page));
    let most = (ui.available_width() - space(40.0)).max(least);
    let sizes = (right.clamp(least, most), least..=most);
    let salt = (page.name, "answer", is_narrow);
    area_ui(ui, view, Side::Right, salt, sizes, |ui, view| answer_ui(ui, view, page, false));
    rest_ui(ui, view, page.seen);
}

fn two_ui(ui: &mut Ui, view: &mut View<'_>, page: &Page, least: f32) {
    // On its side a window has room for the pictures below both columns.
    let size = ui.available_size();
    let is_tall = size.x * 1.3 < size.y;
    if is_tall {
        let heights = (size.y * 0.46, size.y * 0.25..=size.y * 0.6);
        panel_ui(ui, view, Side::Bottom, (page.name, "seen", 2), heights, page.seen);
    }
    let most = (ui.available_width() - least).max(LEAST_ASKED);
    let least_asked = LEAST_ASKED.max(keypad::width(view)).min(most);
    let sizes = (page.left.clamp(least_asked, most), least_asked..=most);
    panel_ui(ui, view, Side::Left, (page.name, "asked", 2), sizes, |ui, view| asked_ui(ui, view, page));
    CentralPanel::default().frame(Frame::NONE).show(ui, |ui| answer_ui(ui, view, page, !is_tall));
}

fn one_ui(ui: &mut Ui, view: &mut View<'_>, page: &Page) {
    let margin = Frame::new().inner_margin(Side::Top.gap());
    let top = Panel::top((page.name, "verdict")).frame(margin).resizable(false).show_separator_line(false);
    top.show(ui, |ui| (page.verdict)(ui, view));
    keypad_ui(ui, view);
    rest_ui(ui, view, |ui, view| {
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
    // In a very low window it would leave no room for what is asked, so it scrolls with it.
    let scrolls = is_tiny(ui);
    let head_ui = |ui: &mut Ui, view: &mut View<'_>| {
        if let Some(head) = page.head {
            head(ui, view);
            ui.separator();
        }
    };
    if !scrolls {
        ui.spacing_mut().item_spacing.y = space(1.0);
        head_ui(ui, view);
    }
    column_ui(ui, (page.name, "asked"), |ui| {
        if scrolls {
            head_ui(ui, view);
        }
        (page.asked)(ui, view);
    });
}

fn answer_ui(ui: &mut Ui, view: &mut View<'_>, page: &Page, with_seen: bool) {
    (page.verdict)(ui, view);
    ui.add_space(f32::from(GAP) - ui.spacing().item_spacing.y);
    rest_ui(ui, view, |ui, view| {
        column_ui(ui, (page.name, "answer"), |ui| {
            (page.answer)(ui, view);
            if with_seen {
                ui.separator();
                of_height(ui, page.seen_height, |ui| (page.seen)(ui, view));
            }
        });
    });
}

/// The side of a page that a panel stands at.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Side {
    Left,
    Right,
    Top,
    Bottom,
}

impl Side {
    /// The gap between its panel and what is beside it.
    pub const fn gap(self) -> Margin {
        match self {
            Self::Left => Margin { right: GAP, ..Margin::ZERO },
            Self::Right => Margin { left: GAP, ..Margin::ZERO },
            Self::Top => Margin { bottom: GAP, ..Margin::ZERO },
            Self::Bottom => Margin { top: GAP, ..Margin::ZERO },
        }
    }

    /// The name of the text that names the edge of its panel.
    const fn edge(self) -> &'static str {
        match self {
            Self::Left => "edge-left",
            Self::Right => "edge-right",
            Self::Top => "edge-top",
            Self::Bottom => "edge-bottom",
        }
    }

    /// The arrows that make its panel larger and smaller.
    const fn arrows(self) -> [Key; 2] {
        match self {
            Self::Left => [Key::ArrowRight, Key::ArrowLeft],
            Self::Right => [Key::ArrowLeft, Key::ArrowRight],
            Self::Top => [Key::ArrowDown, Key::ArrowUp],
            Self::Bottom => [Key::ArrowUp, Key::ArrowDown],
        }
    }
}

/// A card whose edge is dragged with the pointer, or moved with the arrow keys once it has the focus. It keeps its
/// place, also after a restart.
pub(super) fn panel_ui(
    ui: &mut Ui,
    view: &mut View<'_>,
    side: Side,
    salt: impl AsIdSalt + Copy,
    sizes: (f32, RangeInclusive<f32>),
    content: impl FnOnce(&mut Ui, &mut View<'_>),
) {
    area_ui(ui, view, side, salt, sizes, |ui, view| page_card_ui(ui, |ui| content(ui, view)));
}

/// A card of its own height over the width of the page: tools, or what is always in sight.
pub(super) fn bar_ui(
    ui: &mut Ui,
    view: &mut View<'_>,
    side: Side,
    salt: &str,
    content: impl FnOnce(&mut Ui, &mut View<'_>),
) {
    lean_bar_ui(ui, view, side, (salt, 8), content);
}

/// The same with a margin above and below what is in it.
pub(super) fn lean_bar_ui(
    ui: &mut Ui,
    view: &mut View<'_>,
    side: Side,
    (salt, margin): (&str, i8),
    content: impl FnOnce(&mut Ui, &mut View<'_>),
) {
    let panel = if side == Side::Top { Panel::top(salt) } else { Panel::bottom(salt) };
    let panel = panel.resizable(false).show_separator_line(false).frame(Frame::new().inner_margin(side.gap()));
    panel.show(ui, |ui| {
        page_frame(ui).inner_margin(Margin::symmetric(12, margin)).show(ui, |ui| {
            ui.set_min_width(ui.available_width());
            content(ui, view);
        });
    });
}

/// What panels leave, as a card.
pub(super) fn rest_ui(ui: &mut Ui, view: &mut View<'_>, content: impl FnOnce(&mut Ui, &mut View<'_>)) {
    CentralPanel::default().frame(Frame::NONE).show(ui, |ui| page_card_ui(ui, |ui| content(ui, view)));
}

/// The same edge around cards that the content draws by itself.
pub(super) fn area_ui(
    ui: &mut Ui,
    view: &mut View<'_>,
    side: Side,
    salt: impl AsIdSalt + Copy,
    (size, range): (f32, RangeInclusive<f32>),
    content: impl FnOnce(&mut Ui, &mut View<'_>),
) {
    // As egui names a panel and its handle.
    let id = ui.scope_id().with(salt);
    let handle = id.with("__resize");
    arrows(ui, handle, side.arrows());
    let is_moved = is_moved(ui, handle);
    if let Some(PanelState { outer_rect }) = PanelState::load(ui.ctx(), id).filter(|_| !is_moved) {
        // egui keeps what a small window or long words made of it; here it keeps what the user made of it.
        let wanted = kept_size(ui, salt, (size, range.clone()));
        let outer_rect = match side {
            Side::Left | Side::Right => Rect::from_min_size(outer_rect.min, vec2(wanted, outer_rect.height())),
            Side::Top | Side::Bottom => Rect::from_min_size(outer_rect.min, vec2(outer_rect.width(), wanted)),
        };
        ui.data_mut(|data| data.insert_persisted(id, PanelState { outer_rect }));
    }
    let panel = match side {
        Side::Left => Panel::left(salt),
        Side::Right => Panel::right(salt),
        Side::Top => Panel::top(salt),
        Side::Bottom => Panel::bottom(salt),
    };
    let panel = panel.resizable(true).show_separator_line(false).frame(Frame::new().inner_margin(side.gap()));
    let shown = panel.default_size(kept_size(ui, salt, (size, range.clone()))).size_range(range).show(ui, |ui| {
        // A panel is as large as what is in it.
        ui.set_min_size(ui.available_size());
        content(ui, view);
    });
    if is_moved {
        let size = shown.response.rect.size();
        let size = if matches!(side, Side::Left | Side::Right) { size.x } else { size.y };
        ui.data_mut(|data| data.insert_persisted(kept_id(salt), size));
    }
    ui.ctx().accesskit_node_builder(handle, |node| node.set_label(view.text(side.edge())));
    if let Some(edge) = ui.ctx().read_response(handle).filter(|_| ui.memory(|memory| memory.has_focus(handle))) {
        let rect = edge.rect.shrink2(edge.rect.size() * vec2(0.3, 0.0));
        let thin = Rect::from_center_size(rect.center(), rect.size().max(vec2(3.0, 3.0)));
        let line = if thin.width() < thin.height() { vec2(3.0, thin.height()) } else { vec2(thin.width(), 3.0) };
        let line = Rect::from_center_size(thin.center(), line);
        ui.ctx().debug_painter().rect_filled(line, 1.0, palette(ui.ctx()).focus.0);
    }
}

fn kept_id(salt: impl AsIdSalt) -> Id {
    Id::unique(("kept-size", salt))
}

/// The size of a panel: what the user made of it, as far as there is room; else the usual one.
pub(super) fn kept_size(ui: &Ui, salt: impl AsIdSalt, (usual, range): (f32, RangeInclusive<f32>)) -> f32 {
    let kept = ui.data_mut(|data| data.get_persisted::<f32>(kept_id(salt)));
    kept.unwrap_or(usual).clamp(*range.start(), range.end().max(*range.start()))
}

/// Whether the user moves an edge in this frame: with the pointer, with a key, or through a screen reader.
fn is_moved(ui: &Ui, handle: Id) -> bool {
    let is_step = |event: &Event| {
        matches!(event, Event::AccessKitActionRequest(request) if request.target_node == handle.accesskit_id()
            && matches!(request.action, Action::Increment | Action::Decrement | Action::SetValue))
    };
    let is_dragged = ui.ctx().read_response(handle).is_some_and(|edge| edge.dragged() || edge.drag_stopped());
    is_dragged || ui.input(|input| input.events.iter().any(is_step))
}

/// Passes arrow keys on to the handle of a panel, as a screen reader would move it.
fn arrows(ui: &Ui, handle: Id, [larger, smaller]: [Key; 2]) {
    if !ui.memory(|memory| memory.has_focus(handle)) {
        return;
    }
    let filter = EventFilter { horizontal_arrows: true, vertical_arrows: true, ..EventFilter::default() };
    ui.memory_mut(|memory| memory.set_focus_lock_filter(handle, filter));
    ui.input_mut(|input| {
        for (key, action) in [(larger, Action::Increment), (smaller, Action::Decrement)] {
            let target_node = handle.accesskit_id();
            let target_tree = TreeId::ROOT;
            for _ in 0..input.num_presses(key) {
                let request = ActionRequest { action, target_tree, target_node, data: None };
                input.events.push(Event::AccessKitActionRequest(request));
            }
        }
    });
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
    // What scrolls ends where everything else in the card does: its bar stands in the margin, as far as there is one.
    let rect = ui.available_rect_before_wrap();
    let beside = (ui.clip_rect().right() - rect.right()).clamp(0.0, space(BAR));
    let outer = rect.with_max_x(rect.right() + beside);
    let mut child = ui.new_child(UiBuilder::new().max_rect(outer));
    ScrollArea::vertical().id_salt(id).auto_shrink(false).show(&mut child, |ui| {
        ui.set_max_width(rect.width() + beside - space(BAR));
        ui.spacing_mut().item_spacing.y = space(1.0);
        content(ui);
        follow_focus(ui);
    });
    ui.allocate_rect(rect, Sense::hover());
}

/// How high the two parts of such a column were.
#[derive(Debug, Clone, Copy)]
struct Heights {
    content: f32,
    foot: f32,
}

/// What scrolls where there is little room, and below it what is always in sight, in the order in which Tab goes.
pub(super) fn footed_column_ui(
    ui: &mut Ui,
    view: &mut View<'_>,
    salt: &'static str,
    content: impl FnOnce(&mut Ui, &mut View<'_>),
    foot: impl FnOnce(&mut Ui, &mut View<'_>),
) {
    // As in the frame before; at first the foot is one row below all the rest.
    let id = Id::unique(("footed", salt));
    let known = ui.data(|data| data.get_temp(id)).unwrap_or_else(|| Heights { content: f32::MAX, foot: control(ui) });
    let gap = space(1.0);
    ui.spacing_mut().item_spacing.y = gap;
    let height = (ui.available_height() - known.foot - gap).max(0.0).min(known.content);
    let top = ui.cursor().top();
    let mut shown = known;
    of_height(ui, height, |ui| {
        column_ui(ui, salt, |ui| {
            content(ui, view);
            shown.content = ui.min_rect().height().ceil();
        });
    });
    ui.add_space((top + height + gap - ui.cursor().top()).max(0.0));
    shown.foot = ui.vertical(|ui| foot(ui, view)).response.rect.height();
    if 0.5 < (shown.content - known.content).abs() || 0.5 < (shown.foot - known.foot).abs() {
        ui.data_mut(|data| data.insert_temp(id, shown));
        ui.ctx().request_repaint();
    }
}

/// Scrolls to the widget that has just got the focus, if it was just drawn here, and to the field of a keypad that has just come.
pub(super) fn follow_focus(ui: &Ui) {
    let focused = ui.memory(Memory::focused);
    let last =
        ui.data_mut(|data| std::mem::replace(data.get_temp_mut_or_default(ui.unique_id().with("focused")), focused));
    let followed = focused.filter(|_| focused != last).or_else(|| keypad::just_came_for(ui));
    let Some(rect) = followed.and_then(|id| ui.ctx().read_response(id)) else { return };
    if rect.layer_id == ui.layer_id() && ui.min_rect().contains(rect.rect.center()) {
        ui.scroll_to_rect(rect.rect, None);
    }
}
