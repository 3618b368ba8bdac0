//! A list of materials beside a field of expansion.

use std::fmt::Debug;
use std::hash::Hash;

use eframe::egui::{Id, Ui};

use super::view::{View, list_ui};
use crate::tolerance::fit::thermal::{Expansion, Temperature};

/// The list, named by `name`; returns the expansion of the material that was chosen. A typed value belongs to no material any
/// more.
pub(super) fn material_ui(
    ui: &mut Ui,
    view: &View<'_>,
    salt: impl Hash + Debug,
    now: Option<Expansion>,
    (name, width): (Id, f32),
) -> Option<Expansion> {
    let language = view.session.language();
    let chosen = view.session.materials().iter().find(|material| Some(material.expansion) == now);
    let shown = chosen.map_or_else(|| view.text("fit-own-value"), |material| material.name_in(language).to_owned());
    let mut taken = None;
    let list = list_ui(ui, salt, shown, width, |ui| {
        for material in view.session.materials().iter() {
            let value = view.words.number(&material.expansion.to_string());
            let text = format!("{}  {value}", material.name_in(language));
            let is = Some(material.expansion) == now;
            let certainty = view.words.told(&material.certainty);
            let source = material.source.as_deref().filter(|source| !source.is_empty());
            let hint = source.map_or_else(|| certainty.clone(), |source| format!("{certainty}: {source}"));
            let degrees = |temperature: Temperature| view.words.number(&temperature.to_string());
            let hint = format!("{hint}\n{} … {} °C", degrees(material.range.least), degrees(material.range.most));
            if ui.selectable_label(is, text).on_hover_text(hint).clicked() {
                taken = Some(material.expansion);
                ui.close();
            }
        }
    });
    list.labelled_by(name);
    taken
}
