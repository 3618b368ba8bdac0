//! Left: what is reported, and by which template.

use eframe::egui::accesskit::Role;
use eframe::egui::{Button, RichText, Ui, WidgetInfo, vec2};

use crate::gui::theme::{self, control, sizes};
use crate::gui::view::{View, heading, problem, quiet, quiet_text};
use crate::session::{ReportOf, ReportsAction, ReportsCommand};

pub(super) fn asked_ui(ui: &mut Ui, view: &mut View<'_>) {
    heading(ui, view.text("reports-page-about"));
    for of in ReportOf::ALL {
        view.radio(ui, ReportsAction::Of(of));
    }
    ui.separator();
    heading(ui, view.text("reports-page-templates"));
    let chosen = std::sync::Arc::clone(view.session.reports().template());
    let templates: Vec<_> = view.session.reports().templates().map(std::sync::Arc::clone).collect();
    for template in templates {
        let [name, purpose] = [&template.name, &template.purpose].map(|text| view.session.template_text(text, view.words));
        let is_on = chosen.name == template.name;
        let title = RichText::new(&name).font(theme::bold(sizes().body));
        let mut text = eframe::egui::text::LayoutJob::default();
        let style = ui.style().clone();
        let align = eframe::egui::Align::Center;
        title.append_to(&mut text, &style, eframe::egui::FontSelection::Default, align);
        quiet_text(ui, format!("\n{purpose}")).append_to(&mut text, &style, eframe::egui::FontSelection::Default, align);
        let size = vec2(ui.available_width(), control(ui));
        let button = ui.add(Button::selectable(is_on, text).min_size(size));
        let said = format!("{name}, {purpose}");
        button.widget_info(|| WidgetInfo::selected(Role::RadioButton, true, is_on, &said));
        if button.clicked() {
            view.send(ReportsCommand::Template(template.name.clone()));
        }
    }
    let refused: Vec<String> = view.session.reports().refused().map(|why| view.words.say(why)).collect();
    for why in refused {
        problem(ui, why);
    }
    if view.session.reportable().next().is_none() {
        ui.separator();
        quiet(ui, view.text("reports-page-nothing-hint"));
    }
}
