//! Right: the answer. How many pairs, their clearances, what is left over and what grinding would save, and its files.

use crate::session::PairingAction;
use eframe::egui::accesskit::Live;
use eframe::egui::{Align, Frame, Grid, Layout, Margin, RichText, Sense, Ui, vec2};

use super::groups_panel::groups_ui;
use crate::gui::columns::is_tiny;
use crate::gui::shapes;
use crate::gui::theme::{self, palette, sizes, space};
use crate::gui::view::{View, heading, live, quiet};
use crate::message::message;
use crate::pairing::Grinding;
use crate::report::pairing::FORMATS;
use crate::session::Paired;

/// The number of pairs, their clearances and what is left over. It is not a verdict, so it does not have the colour of one.
pub(super) fn count_ui(ui: &mut Ui, view: &View<'_>) {
    let palette = palette(ui.ctx());
    let paired = view.session.pairing().paired();
    let lines = paired.map_or_else(Vec::new, |paired| lines(view, paired));
    let word = match paired {
        Some(paired) => view.words.say(&message!("pairing-page-count").count("count", paired.count())),
        None if view.session.pairing().is_pairing() => view.text("pairing-page-at-work"),
        None => view.text("pairing-page-none"),
    };
    let card =
        Frame::new().fill(palette.background.0).corner_radius(6.0).inner_margin(Margin::same(12)).show(ui, |ui| {
            ui.set_min_width(ui.available_width());
            ui.with_layout(Layout::top_down(Align::Center), |ui| {
                if paired.is_none() {
                    quiet(ui, &word);
                    return;
                }
                let wanted = (ui.available_width() * 0.12).min(ui.ctx().content_rect().height() * 0.1);
                let galley = ui.painter().layout_no_wrap(word.clone(), theme::bold(wanted), palette.text.0);
                let size = wanted.min(wanted * ui.available_width() / galley.size().x.max(1.0));
                ui.label(RichText::new(&word).font(theme::bold(size.floor())).color(palette.text.0));
                for line in &lines {
                    ui.label(RichText::new(line).color(palette.text.0));
                }
            });
        });
    if paired.is_some_and(|paired| 0 < paired.simulated) {
        shapes::dashed_frame(ui.painter(), card.response.rect, palette.text.0);
    }
    let said = std::iter::once(word).chain(lines).collect::<Vec<_>>().join(". ");
    let response = ui.interact(card.response.rect, ui.scope_id().with("pairs"), Sense::hover());
    live(ui, &response, &said, Live::Polite);
}

/// A range of clearance with its signs: `+7 … +41 µm`.
pub(super) fn range(view: &View<'_>, (smallest, largest): (crate::length::Length, crate::length::Length)) -> String {
    format!("{} … {} µm", view.words.signed_um(smallest), view.words.signed_um(largest))
}

/// Below the number: the clearances, what is left over, what nobody measured.
fn lines(view: &View<'_>, paired: &Paired) -> Vec<String> {
    let pairing = &paired.answer.pairing;
    let clearances = paired.answer.clearances().map(|clearances| range(view, clearances));
    let left = match (pairing.holes.len(), pairing.shafts.len()) {
        (0, 0) => message!("pairing-page-nothing-left"),
        (holes, shafts) => message!("pairing-page-left").count("holes", holes).count("shafts", shafts),
    };
    let simulated = message!("pairing-page-simulated").count("count", paired.simulated);
    let simulated = (0 < paired.simulated).then(|| view.words.say(&simulated));
    clearances.into_iter().chain([view.words.say(&left)]).chain(simulated).collect()
}

/// Below it: what is done with the pairs, figures, grinding, groups.
pub(super) fn answer_ui(ui: &mut Ui, view: &mut View<'_>) {
    let session = view.session;
    let Some(paired) = session.pairing().paired() else { return };
    ui.add_space(space(1.0));
    ui.horizontal_wrapped(|ui| {
        ui.spacing_mut().item_spacing.y = space(1.0);
        view.field_button(ui, PairingAction::CopyPairs);
        for format in 0..FORMATS.len() {
            view.field_button(ui, PairingAction::SavePairs(format));
        }
    });
    if !is_tiny(ui) {
        ui.separator();
    }
    figures_ui(ui, view, paired);
    if let Some(grinding) = &paired.answer.grinding {
        ui.separator();
        grinding_ui(ui, view, grinding);
    }
    if let Some(groups) = paired.answer.groups() {
        ui.separator();
        groups_ui(ui, view, groups, paired.answer.asked.wanted);
    }
}

/// The clearances of the pairs, by name.
fn figures_ui(ui: &mut Ui, view: &View<'_>, paired: &Paired) {
    let Some((smallest, largest)) = paired.answer.clearances() else {
        quiet(ui, view.text("pairing-page-no-pair"));
        return;
    };
    let um = |um: String| format!("{um} µm");
    let rows = [
        ("pairing-page-smallest", um(view.words.signed_um(smallest))),
        ("pairing-page-largest", um(view.words.signed_um(largest))),
        ("pairing-page-middle", um(view.words.number(&paired.middle_um()))),
        ("pairing-page-band", um(view.words.um(paired.answer.pairing.band))),
    ];
    Grid::new("pairing-figures").num_columns(2).min_row_height(0.0).spacing(vec2(space(4.0), 0.0)).show(ui, |ui| {
        for (id, value) in rows {
            ui.label(view.text(id));
            ui.label(RichText::new(value).font(theme::bold(sizes().limits)));
            ui.end_row();
        }
    });
}

/// What grinding the leftovers would save.
fn grinding_ui(ui: &mut Ui, view: &View<'_>, grinding: &Grinding) {
    heading(ui, view.text("pairing-page-grinding"));
    let um = |length| view.words.um(length);
    match &grinding.best {
        Some(best) => {
            let message = message!("pairing-page-grind").text("amount", um(best.amount));
            ui.label(view.words.say(&message.count("count", best.pairs.len())));
            quiet(ui, view.text("pairing-page-grind-means"));
        }
        None => _ = ui.label(view.text("pairing-page-grind-nothing")),
    }
    if grinding.is_bounded() {
        let message = message!("pairing-page-grind-bounded");
        quiet(ui, view.words.say(&message.text("tried", um(grinding.tried)).text("reach", um(grinding.reach))));
    }
}
