//! Left: what is reported, and by which template.

use std::sync::Arc;

use eframe::egui::accesskit::Role;
use eframe::egui::{Button, RichText, Ui, WidgetInfo, vec2};

use crate::gui::theme::{self, Icon, Weight, control, palette, sizes, space};
use crate::gui::view::{View, heading, problem, quiet};
use crate::session::{ReportOf, ReportsAction, ReportsCommand};

/// The name of the list of templates.
const TEMPLATES: &str = "report-templates";

pub(super) fn asked_ui(ui: &mut Ui, view: &mut View<'_>) {
    heading(ui, view.text("reports-page-about"));
    for of in ReportOf::ALL {
        ui.add_enabled_ui(view.session.can(ReportsAction::Of(of)), |ui| view.radio(ui, ReportsAction::Of(of)));
    }
    ui.separator();
    heading(ui, view.text("reports-page-templates"));
    let chosen = view.session.reports().template();
    let templates: Vec<_> = view.session.reports().templates().map(Arc::clone).collect();
    for (place, template) in templates.iter().enumerate() {
        let [name, purpose] = [&template.name, &template.purpose].map(|text| template.text(text, view.words));
        let is_on = chosen.name == template.name;
        let colour = palette(ui.ctx()).text.0;
        let icon = Icon::FileText.text(if is_on { Weight::Fill } else { Weight::Regular }, space(5.0)).color(colour);
        let text = RichText::new(&name).font(theme::bold(sizes().body)).color(colour);
        let button = Button::selectable(is_on, (icon, text)).min_size(vec2(ui.available_width(), control(ui)));
        let button = ui.push_id((TEMPLATES, place), |ui| ui.add(button)).inner.on_hover_text(&purpose);
        let said = format!("{name}, {purpose}");
        button.widget_info(|| WidgetInfo::selected(Role::RadioButton, true, is_on, &said));
        if button.clicked() {
            view.send(ReportsCommand::Template(template.name.clone()));
        }
        if is_on {
            quiet(ui, purpose);
        }
    }
    let refused: Vec<String> = view.session.reports().refused().map(|why| view.words.say(why)).collect();
    for why in refused {
        problem(ui, why);
    }
    view.button(ui, ReportsAction::NewTemplate);
    if view.session.report_of().is_none() {
        ui.separator();
        quiet(ui, view.text("reports-page-nothing-hint"));
    }
}
