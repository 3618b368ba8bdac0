//! One of the results: its verdict as it was shown, its band, and the reasons.

use eframe::egui::{Button, RichText, ScrollArea, Ui, vec2};

use super::below::{reasons_ui, verdict_height};
use super::verdict::big_card_ui;
use super::{gap, results, target};
use crate::gui::card::page_card_ui;
use crate::gui::check::{band_of_ui, check_card};
use crate::gui::columns::of_height;
use crate::gui::theme::{self, Icon, Weight, sizes, space};
use crate::gui::view::View;

/// The height of the band.
const BAND: f32 = 150.0;

/// Of a result nobody knows any more whether it was a diameter: nothing is said of sides.
pub(super) fn result_ui(ui: &mut Ui, view: &View<'_>) {
    let Some(record) = results::opened(ui) else { return };
    let name = view.text("operator-back-to-results");
    let text = RichText::new(&name).font(theme::bold(sizes().limits));
    let size = vec2(ui.available_width(), target(view).max(56.0));
    let button = Button::new((Icon::ListChecks.text(Weight::Regular, space(5.5)), text)).min_size(size);
    let back = theme::looking(ui, theme::tonal, |ui| ui.add(button)).accessible_name(&name);
    if back.clicked() {
        results::open(ui, None);
    }
    let height = verdict_height(ui);
    big_card_ui(ui, view, &check_card(view.words, &record, false), height);
    ui.add_space(f32::from(gap(ui)) - ui.spacing().item_spacing.y);
    if BAND * 1.8 < ui.available_height() {
        of_height(ui, BAND, |ui| page_card_ui(ui, |ui| band_of_ui(ui, view, &record.limits, Some(&record))));
        ui.add_space(f32::from(gap(ui)) - ui.spacing().item_spacing.y);
    }
    page_card_ui(ui, |ui| {
        ScrollArea::vertical().auto_shrink([false, false]).show(ui, |ui| reasons_ui(ui, view, &record, false));
    });
}
