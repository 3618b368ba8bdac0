//! Limits of size as every page shows them: maximum and minimum with their deviations, and where they come from.

use eframe::egui::{Grid, RichText, Ui, vec2};

use super::theme::{self, sizes, space};
use super::view::{View, quiet};
use crate::message::{Say as _, message};
use crate::tolerance::{Feature, Limits};
use crate::words::Words;

/// The id of a feature's word.
pub(super) const fn feature_id(feature: Option<Feature>) -> &'static str {
    match feature {
        Some(Feature::Hole) => "feature-hole",
        Some(Feature::Shaft) => "feature-shaft",
        None => "feature-neither",
    }
}

/// Both limits and their source.
pub(super) fn limits_ui(ui: &mut Ui, view: &View<'_>, limits: &Limits) {
    let grid = Grid::new(("limits", limits.feature)).num_columns(3).min_row_height(0.0).spacing(vec2(space(4.0), 0.0));
    grid.show(ui, |ui| {
        for (id, size, deviation) in [
            ("maximum", limits.maximum(), limits.deviations.upper()),
            ("minimum", limits.minimum(), limits.deviations.lower()),
        ] {
            ui.label(view.text(id));
            ui.label(RichText::new(view.words.mm(size, 3)).font(theme::bold(sizes().limits)));
            quiet(ui, format!("{} µm", view.words.signed_um(deviation)));
            ui.end_row();
        }
    });
    source_ui(ui, view, limits);
}

/// Where limits come from.
pub(super) fn source_ui(ui: &mut Ui, view: &View<'_>, limits: &Limits) {
    quiet(ui, view.words.say(&message!("from-source").message("source", limits.source.message())));
}

/// The least and the largest size in words.
pub(super) fn limits_text(words: &Words, limits: &Limits) -> String {
    let [least, most] = [limits.minimum(), limits.maximum()].map(|size| words.mm(size, 3));
    format!("{least} … {most} mm")
}
