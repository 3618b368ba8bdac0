//! The gauge that is shown, its port, and the lines that came from it.

use eframe::egui::Ui;

use super::slot::{Slot, buttons_ui, value_ui};
use super::told::told;
use crate::gui::field::error_ui;
use crate::gui::theme::space;
use crate::gui::view::{View, one_of_ui, quiet};
use crate::message::message;
use crate::session::{Action, GaugeCommand, GaugeLine, SettingsCommand, SettingsField, Told};

/// Which gauge is shown: a list where there are several.
pub(super) fn gauge_ui(ui: &mut Ui, view: &mut View<'_>, actions: &[Action], slot: &Slot) {
    let gauges = &view.session.settings_page().gauges;
    let names: Vec<String> = gauges.list().iter().map(|gauge| gauge.name().to_owned()).collect();
    let shown = gauges.shown_place();
    if names.is_empty() {
        quiet(ui, view.text("gauges-none"));
    } else {
        let width = ui.available_width().min(space(80.0));
        let (chosen, list) =
            one_of_ui(ui, slot.name.with("gauges"), width - space(2.0), &shown, names.into_iter().enumerate());
        list.labelled_by(slot.name);
        if let Some(at) = chosen {
            view.send(SettingsCommand::Gauge(GaugeCommand::Show(at)));
        }
    }
    buttons_ui(ui, view, actions, slot);
}

/// The port by its name, the ports of this computer, and how it stands.
pub(super) fn port_ui(ui: &mut Ui, view: &mut View<'_>, actions: &[Action], slot: &Slot) {
    let field = SettingsField::GaugePort.into();
    value_ui(ui, view, (field, ""), slot);
    error_ui(ui, view, field);
    let ports = view.session.settings_page().gauges.ports.clone();
    if !ports.is_empty() {
        let now = view.session.text(SettingsField::GaugePort).to_owned();
        let name = quiet(ui, view.text("gauges-ports"));
        let width = ui.available_width().min(space(80.0));
        let entries = ports.into_iter().map(|port| (port.clone(), port));
        let (chosen, list) = one_of_ui(ui, slot.name.with("ports"), width - space(2.0), &now, entries);
        list.labelled_by(name.id);
        if let Some(port) = chosen {
            view.send(SettingsCommand::Gauge(GaugeCommand::UsePort(port)));
        }
    }
    if let Some(state) = told(view, Told::GaugePort) {
        quiet(ui, state);
    }
    buttons_ui(ui, view, actions, slot);
}

/// The lines that came last, as they came and as they were read.
pub(super) fn lines_ui(ui: &mut Ui, view: &View<'_>) {
    let Some(gauge) = view.session.settings_page().gauges.shown() else { return };
    ui.separator();
    ui.label(view.text("gauges-lines"));
    if gauge.lines().next().is_none() {
        quiet(ui, view.text("gauges-no-lines"));
    }
    for line in gauge.lines() {
        ui.label(said(view, line));
    }
}

fn said(view: &View<'_>, line: &GaugeLine) -> String {
    match &line.read {
        Ok(gauged) => {
            let said = message!("gauges-line-is").text("line", line.text.escape_debug());
            let value = view.words.say(&said.number("value", gauged.value));
            let remarks = gauged.remarks.iter().map(|remark| view.words.told(remark));
            std::iter::once(value).chain(remarks).collect::<Vec<_>>().join("; ")
        }
        Err(why) if line.text.is_empty() => view.words.say(why),
        Err(why) => {
            let said = message!("gauges-line-is-none").text("line", line.text.escape_debug());
            view.words.say(&said.message("why", why.clone()))
        }
    }
}
