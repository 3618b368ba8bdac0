//! Gauges by label and key: one is added and taught, and its value is checked.

use eframe::egui::accesskit::Role;
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;
use fitcheck::gauges::News;
use fitcheck::gui::App;
use fitcheck::session::{Command, Page, Section, SettingsCommand, SettingsField};

use crate::harness::{Window, check, click, type_into};

fn send(window: &mut Harness<'_, App>, command: impl Into<Command>) {
    let ctx = window.ctx.clone();
    window.state_mut().send(&ctx, command.into());
    window.run();
}

fn hear(window: &mut Harness<'_, App>, news: News) {
    send(window, Command::Heard { run: 1, news });
}

#[test]
fn a_gauge_is_taught_in_the_settings_and_its_value_is_seen_on_the_check_page() {
    let mut window = Window::default().open();
    check(&mut window, "25 H7", "25.012");
    send(&mut window, Command::OpenPage(Page::Settings));
    send(&mut window, SettingsCommand::Show(Section::Gauges));
    click(&mut window, Role::Button, "Add a gauge");
    type_into(&mut window, "Name of the gauge", "Bench 1");
    type_into(&mut window, "Port", "/dev/ttyUSB0");
    click(&mut window, Role::Button, "Connect");
    hear(&mut window, News::Opened);
    hear(&mut window, News::Line("DIA=25.0310;OK".to_owned()));
    window.get_by_label_contains("DIA=25.0310;OK");
    type_into(&mut window, "The newest line gave", "25.031");
    click(&mut window, Role::Button, "Teach");
    assert_eq!(window.state().session().text(SettingsField::GaugeGave), "");
    window.get_by_label("DIA=25.0310;OK is 25.031 mm");
    // The button in the bar leads here from any page.
    send(&mut window, Command::OpenPage(Page::Check));
    click(&mut window, Role::Button, "Bench 1: Connected");
    assert_eq!(window.state().session().page(), Page::Settings);
    send(&mut window, Command::OpenPage(Page::Check));
    hear(&mut window, News::Line("DIA=25.0310;OK".to_owned()));
    window.get_by_label("measured with Bench 1");
    assert_eq!(window.state().session().text(fitcheck::session::CheckField::Measured), "25.031");
    assert_eq!(window.state().session().history().iter().count(), 2);
}
