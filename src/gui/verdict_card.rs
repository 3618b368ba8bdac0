//! The verdict's card: one word that can be read from two metres, its shape, and the lines below it.

use eframe::egui::accesskit::Live;
use eframe::egui::{Align, Color32, Frame, Layout, Margin, Response, RichText, Sense, Ui, vec2};

use super::shapes;
use super::theme::{self, Palette, palette, sizes, space};
use super::view::{View, live};
use crate::length::{Length, Unit};
use crate::message::Say as _;
use crate::verdict::Status;

/// The name of a status in the locale files.
pub(super) fn status_id(status: Option<Status>) -> &'static str {
    status.map_or("word-none", |status| status.message().id)
}

/// What a card says.
pub(super) struct Card<'a> {
    /// Colour and shape; `None` is no result.
    pub status: Option<Status>,
    /// Whether the value was simulated: nobody measured it.
    pub is_simulated: bool,
    /// The word.
    pub word: String,
    /// The lines below it, the first one larger.
    pub lines: &'a [String],
}

/// The card, which is also a live region: a screen reader says the word and the lines.
pub(super) fn card_ui(ui: &mut Ui, view: &View<'_>, card: &Card<'_>) {
    let (fill, colour) = colours(palette(ui.ctx()), card.status, card.is_simulated);
    let simulated = card.is_simulated.then(|| view.text("simulated"));
    let shown = Frame::new().fill(fill).corner_radius(6.0).inner_margin(Margin::same(12)).show(ui, |ui| {
        ui.set_min_width(ui.available_width());
        ui.set_min_height(space(54.0));
        ui.with_layout(Layout::top_down(Align::Center), |ui| {
            if let Some(simulated) = &simulated {
                ui.label(RichText::new(simulated).font(theme::bold(sizes().value)).color(colour));
            }
            let (rect, _) = ui.allocate_exact_size(vec2(space(18.0), space(18.0)), Sense::hover());
            shapes::status(ui.painter(), rect, card.status, colour);
            // A long word (German, Italian) is set smaller rather than cut.
            // 64 points and up, according to the panel; no result is set smaller.
            let wanted = sizes().status.max(ui.available_width() * 0.2);
            let wanted = if card.status.is_some() { wanted } else { sizes().value };
            let galley = ui.painter().layout_no_wrap(card.word.clone(), theme::bold(wanted), colour);
            let size = wanted.min(wanted * ui.available_width() / galley.size().x.max(1.0));
            ui.label(RichText::new(&card.word).font(theme::bold(size.floor())).color(colour));
            for (number, line) in card.lines.iter().enumerate() {
                let font = if number == 0 { theme::bold(sizes().value) } else { theme::font(sizes().limits) };
                ui.label(RichText::new(line).font(font).color(colour));
            }
        });
    });
    if simulated.is_some() {
        shapes::dashed_frame(ui.painter(), shown.response.rect, colour);
    }
    let said = simulated.iter().chain([&card.word]).chain(card.lines).map(String::as_str).collect::<Vec<_>>();
    let response = ui.interact(shown.response.rect, ui.scope_id().with("verdict"), Sense::hover());
    live(ui, &response, &said.join(". "), Live::Assertive);
}

/// A small verdict: shape, text and colour.
pub(super) fn chip_ui(ui: &mut Ui, status: Status, text: &str) -> Response {
    let (fill, colour) = palette(ui.ctx()).of_status(Some(status));
    let frame = Frame::new().fill(fill).corner_radius(4.0).inner_margin(Margin::symmetric(8, 4));
    let chip = frame.show(ui, |ui| {
        ui.spacing_mut().interact_size.y = 0.0;
        ui.horizontal(|ui| {
            let (rect, _) = ui.allocate_exact_size(vec2(space(4.0), space(4.0)), Sense::hover());
            shapes::status(ui.painter(), rect, Some(status), colour);
            ui.label(RichText::new(text).font(theme::bold(sizes().body)).color(colour));
        });
    });
    chip.response
}

/// The fill of a verdict and the colour on it: pale where nobody measured.
pub(super) const fn colours(palette: &Palette, status: Option<Status>, is_simulated: bool) -> (Color32, Color32) {
    if is_simulated { palette.of_simulated(status) } else { palette.of_status(status) }
}

/// Half of a length in µm, exact.
pub(super) fn half_um(length: Length) -> String {
    let nm = length.nanometres();
    let whole =
        Length::from_nanometres(nm / 2).unwrap_or_default().exact(Unit::Micrometre, if nm % 2 == 0 { 0 } else { 3 });
    if nm % 2 == 0 { whole } else { format!("{whole}5") }
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
