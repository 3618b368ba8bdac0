//! What is around every card: an answer at which one look is enough. A screen reader says it whenever it changes.

use eframe::egui::accesskit::Live;
use eframe::egui::{Align, Color32, Frame, Layout, Margin, RichText, Sense, Ui, UiBuilder};

use super::room::is_low;
use super::shapes::{self, Edge};
use super::spoken::live;
use super::theme::{self, palette};

/// Around the text of a card.
pub(super) const MARGIN: i8 = 12;

/// Below this width of the window what is in a card comes closer to its edges.
const NARROW: f32 = 1_100.0;

/// The ground of a part of a page.
pub(super) fn page_frame(ui: &Ui) -> Frame {
    let palette = palette(ui.ctx());
    let is_small = is_low(ui) || ui.ctx().content_rect().width() < NARROW;
    let frame = Frame::new().fill(palette.surface.0).stroke(theme::line(ui.ctx())).corner_radius(12.0);
    frame.inner_margin(Margin::same(if is_small { 8 } else { 16 }))
}

/// A part of a page, on a ground of its own. It takes all the room there is.
pub(super) fn page_card_ui<T>(ui: &mut Ui, content: impl FnOnce(&mut Ui) -> T) -> T {
    in_frame_ui(ui, page_frame(ui), content)
}

/// The ground around what has a frame of its own.
pub(super) fn close_frame(ui: &Ui) -> Frame {
    page_frame(ui).inner_margin(Margin::same(8))
}

/// A part of a page on such a ground.
pub(super) fn close_card_ui<T>(ui: &mut Ui, content: impl FnOnce(&mut Ui) -> T) -> T {
    in_frame_ui(ui, close_frame(ui), content)
}

/// What is too much for a card is cut at its edge and moves nothing beside it.
fn in_frame_ui<T>(ui: &mut Ui, frame: Frame, content: impl FnOnce(&mut Ui) -> T) -> T {
    let rect = ui.available_rect_before_wrap();
    let inner = rect - frame.total_margin();
    ui.painter().add(frame.paint(inner));
    let mut child = ui.new_child(UiBuilder::new().max_rect(inner));
    child.set_clip_rect(rect.intersect(ui.clip_rect()));
    let shown = content(&mut child);
    ui.allocate_rect(rect, Sense::hover());
    shown
}

/// The card of a verdict in its colours; its content returns what is said of it, part by part.
pub(super) fn verdict_ui(
    ui: &mut Ui,
    (fill, colour): (Color32, Color32),
    edge: Edge,
    margin: Margin,
    content: impl FnOnce(&mut Ui) -> Vec<String>,
) {
    around_ui(ui, ("verdict", Live::Assertive), (fill, (edge, colour), margin), content);
}

/// A card that is no verdict on a part, so it does not have the colour of one.
pub(super) fn plain_ui(
    ui: &mut Ui,
    id: &'static str,
    is_simulated: bool,
    content: impl FnOnce(&mut Ui) -> Vec<String>,
) {
    let palette = palette(ui.ctx());
    let edge = if is_simulated { Edge::Dashes } else { Edge::None };
    let look = (palette.sunken.0, (edge, palette.text.0), Margin::same(MARGIN));
    around_ui(ui, (id, Live::Polite), look, |ui| ui.with_layout(Layout::top_down(Align::Center), content).inner);
}

/// A card as wide as its panel.
fn around_ui(
    ui: &mut Ui,
    (id, politeness): (&str, Live),
    (fill, (edge, colour), margin): (Color32, (Edge, Color32), Margin),
    content: impl FnOnce(&mut Ui) -> Vec<String>,
) {
    let shown = Frame::new().fill(fill).corner_radius(12.0).inner_margin(margin).show(ui, |ui| {
        ui.set_min_width(ui.available_width());
        content(ui)
    });
    let rect = shown.response.rect;
    shapes::edge(ui.painter(), (rect, 12.0), edge, colour);
    let response = ui.interact(rect, ui.scope_id().with(id), Sense::hover());
    live(ui, &response, &shown.inner.join(". "), politeness);
}

/// The word of such a card, as large as its shares of the card's width and of the window's height; a longer one is smaller.
pub(super) fn word_ui(ui: &mut Ui, word: &str, (of_width, of_height): (f32, f32)) {
    let colour = palette(ui.ctx()).text.0;
    let width = ui.available_width();
    let wanted = (width * of_width).min(ui.ctx().content_rect().height() * of_height);
    let galley = ui.painter().layout_no_wrap(word.to_owned(), theme::bold(wanted), colour);
    let size = wanted.min(wanted * width / galley.size().x.max(1.0));
    ui.label(RichText::new(word).font(theme::bold(size.floor())).color(colour));
}
