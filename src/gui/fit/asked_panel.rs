//! Left, above: the callout of the fit, and fits to pick from. Picking keeps the nominal size.

use eframe::egui::{Button, Grid, Id, Ui, vec2};

use crate::gui::field::{FieldStyle, error_ui, field_ui};
use crate::gui::theme::{control, space};
use crate::gui::view::{View, heading, list_ui, quiet};
use crate::session::{FitCommand, FitField};
use crate::tolerance::ToleranceClass;
use crate::tolerance::fit::preferred::{Function, Preference, function, preference};

/// The callout with its error, and the two lists.
pub(super) fn callout_ui(ui: &mut Ui, view: &mut View<'_>) {
    let name = heading(ui, view.text("fit-callout"));
    let width = ui.available_width();
    field_ui(ui, view, FitField::Callout, name.id, FieldStyle::large(width));
    error_ui(ui, view, FitField::Callout);
    if view.session.text(FitField::Callout).trim().is_empty() {
        quiet(ui, view.text("fit-callout-hint"));
    } else if let Some(hint) = view.session.fit().hint.as_ref() {
        quiet(ui, view.words.say(hint));
    }
    ui.add_space(space(1.0));
    let width = (width - space(2.0)) / 2.0;
    Grid::new("fit-picks").num_columns(2).min_row_height(0.0).spacing(vec2(space(2.0), space(0.5))).show(ui, |ui| {
        let preferred = quiet(ui, view.text("fit-preferred"));
        let function = quiet(ui, view.text("fit-function"));
        ui.end_row();
        preferred_ui(ui, view, preferred.id, width);
        function_ui(ui, view, function.id, width);
        ui.end_row();
    });
}

/// The pair on screen.
fn pair(view: &View<'_>) -> Option<(ToleranceClass, ToleranceClass)> {
    use crate::tolerance::Feature::{Hole, Shaft};
    view.session.fit().class(Hole).zip(view.session.fit().class(Shaft))
}

/// The preferred fits of ISO 286-1, hole basis and shaft basis.
fn preferred_ui(ui: &mut Ui, view: &mut View<'_>, name: Id, width: f32) {
    let chosen = pair(view).filter(|(hole, shaft)| preference(*hole, *shaft).is_some());
    let shown = chosen.map_or_else(|| view.text("class-none"), |(hole, shaft)| format!("{hole}/{shaft}"));
    let list = list_ui(ui, "fit-preferred", shown, width, |ui| {
        ui.set_min_width(space(210.0));
        for (list, title) in
            [(Preference::HoleBasis, "fit-list-hole-basis"), (Preference::ShaftBasis, "fit-list-shaft-basis")]
        {
            heading(ui, view.text(title));
            ui.horizontal_wrapped(|ui| {
                ui.spacing_mut().item_spacing = vec2(space(1.0), space(1.0));
                for (hole, shaft) in list.fits() {
                    let of_list = chosen.filter(|(hole, shaft)| preference(*hole, *shaft) == Some(list));
                    let button = Button::selectable(of_list == Some((hole, shaft)), format!("{hole}/{shaft}"));
                    let button = button.min_size(vec2(space(19.0), control(ui)));
                    if ui.add_enabled(view.session.fit().is_defined(hole, shaft), button).clicked() {
                        view.send(FitCommand::TakePair(hole, shaft));
                        ui.close();
                    }
                }
            });
        }
    });
    list.labelled_by(name);
}

/// The functions that ANSI B4.2 names, each in both bases.
fn function_ui(ui: &mut Ui, view: &mut View<'_>, name: Id, width: f32) {
    let chosen = pair(view);
    let is = chosen.and_then(|(hole, shaft)| function(hole, shaft));
    let shown = is.map_or_else(|| view.text("class-none"), |function| view.words.told(&function));
    let list = list_ui(ui, "fit-function", shown, width, |ui| {
        Grid::new("fit-functions").num_columns(3).spacing(vec2(space(2.0), space(1.0))).show(ui, |ui| {
            for function in Function::ALL {
                ui.label(view.words.told(&function));
                for fit in function.fits() {
                    let is = chosen == Some((fit.hole, fit.shaft));
                    let button = Button::selectable(is, format!("{}/{}", fit.hole, fit.shaft));
                    let button = button.min_size(vec2(space(22.0), control(ui)));
                    if ui.add_enabled(view.session.fit().is_defined(fit.hole, fit.shaft), button).clicked() {
                        view.send(FitCommand::TakePair(fit.hole, fit.shaft));
                        ui.close();
                    }
                }
                ui.end_row();
            }
        });
    });
    list.labelled_by(name);
}
