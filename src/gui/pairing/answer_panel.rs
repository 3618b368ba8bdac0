//! Right: the answer. How many pairs, their clearances, what is left over and what grinding would save, and its files.

use eframe::egui::{RichText, Ui};

use super::groups_panel::{groups_ui, range};
use crate::gui::card::{plain_ui, word_ui};
use crate::gui::room::is_tiny;
use crate::gui::theme::{palette, space};
use crate::gui::view::{View, heading, named_figures_ui, quiet};
use crate::message::message;
use crate::pairing::Grinding;
use crate::report::pairing::FORMATS;
use crate::session::{Paired, PairingAction};

/// The number of pairs, their clearances and what is left over. It is not a verdict, so it does not have the colour of one.
pub(super) fn count_ui(ui: &mut Ui, view: &View<'_>) {
    let paired = view.session.pairing().paired.as_deref();
    let lines = paired.map_or_else(Vec::new, |paired| lines(view, paired));
    let word = match paired {
        Some(paired) => view.words.say(&message!("pairing-page-count").count("count", paired.count())),
        None if view.session.pairing().is_pairing() => view.text("pairing-page-at-work"),
        None => view.text("pairing-page-none"),
    };
    plain_ui(ui, "pairs", paired.is_some_and(|paired| 0 < paired.simulated), |ui| {
        if paired.is_none() {
            quiet(ui, &word);
        } else {
            word_ui(ui, &word, (0.12, 0.1));
            for line in &lines {
                ui.label(RichText::new(line).color(palette(ui.ctx()).text.0));
            }
        }
        std::iter::once(word).chain(lines).collect()
    });
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
    let Some(paired) = session.pairing().paired.as_deref() else { return };
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
    named_figures_ui(ui, "pairing-figures", rows.map(|(id, value)| (view.text(id), value)));
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
