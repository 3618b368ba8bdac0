//! The settings page by label and key: settings are found, take effect at once, and go back to their defaults.

use eframe::egui::accesskit::Role;
use eframe::egui::{Key, Modifiers, Vec2, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use fitcheck::gui::{App, Store};
use fitcheck::session::{
    Action, Command, Density, Page, RowHeight, Section, SettingsAction, SettingsCommand, SettingsField, Theme, Zoom,
};
use fitcheck::tolerance::Base;
use fitcheck::verdict::rules::RuleName;
use fitcheck::words::Language;

use crate::harness::{Window, check, click, press, rows, scan, type_into};

fn send(window: &mut Harness<'_, App>, command: impl Into<Command>) {
    let ctx = window.ctx.clone();
    window.state_mut().send(&ctx, command.into());
    window.run();
}

fn page(window: Window) -> Harness<'static, App> {
    let mut window = window.open();
    send(&mut window, Command::OpenPage(Page::Settings));
    window
}

fn section(window: &mut Harness<'_, App>, section: Section) {
    send(window, SettingsCommand::Show(section));
}

#[test]
fn a_setting_is_found_by_words_and_takes_effect_at_once() {
    let mut window = page(Window::default());
    // The search has the focus.
    scan(&mut window, "dark");
    click(&mut window, Role::RadioButton, "Dark");
    assert_eq!(window.state().session().theme(), Theme::Dark);
    press(&mut window, Key::Escape);
    assert_eq!(window.state().session().text(SettingsField::Find), "");
    window.get_by_label("Language");
}

#[test]
fn the_sections_are_at_the_left_and_one_is_chosen() {
    let mut window = page(Window::default());
    click(&mut window, Role::Tab, "Rule and limits");
    assert_eq!(window.state().session().settings_page().section, Section::Rule);
    click(&mut window, Role::RadioButton, "The control's tables, 47 classes to 400 mm");
    assert_eq!(window.state().session().sources().base(), Base::ControlTables);
    click(&mut window, Role::Button, "Back to defaults");
    assert_eq!(window.state().session().sources().base(), Base::Iso286);
    let back = window.get_by_role_and_label(Role::Button, "Back to defaults");
    assert!(back.accesskit_node().is_disabled(), "nothing is left to set back");
}

#[test]
fn a_switch_has_the_name_of_its_row() {
    let mut window = page(Window::default());
    click(&mut window, Role::CheckBox, "Keypad");
    assert!(window.state().session().has_keypad());
}

#[test]
fn a_field_of_the_check_page_is_the_same_one_here() {
    let mut window = page(Window::default());
    section(&mut window, Section::Rule);
    type_into(&mut window, "Temperature of the part", "26");
    assert_eq!(window.state().session().text(fitcheck::session::CheckField::PartTemperature), "26");
    type_into(&mut window, "Temperature of the part", "warm");
    window.get_by_label_contains("warm");
    press(&mut window, Key::Enter);
    assert!(window.state().session().history().is_empty(), "nothing is measured here");
}

#[test]
fn a_rule_is_taken_from_its_list() {
    let mut window = page(Window::default());
    section(&mut window, Section::Rule);
    click(&mut window, Role::ComboBox, "Decision rule");
    click(&mut window, Role::Button, "ILAC-G8, multiple of U");
    assert_eq!(window.state().session().check().asked.worth.judging.rule, RuleName::IlacG8);
}

#[test]
fn the_language_changes_the_whole_page() {
    let mut window = page(Window::default());
    click(&mut window, Role::ComboBox, "Language");
    click(&mut window, Role::Button, "Nederlands");
    assert_eq!(window.state().session().language(), Language::Nl);
    window.get_by_role_and_label(Role::TextInput, "Instelling zoeken");
}

/// The scale of the window by buttons and by the keys of every program.
#[test]
fn the_window_is_scaled_by_buttons_and_keys() {
    let mut window = page(Window::default());
    section(&mut window, Section::Appearance);
    click(&mut window, Role::Button, "Zoom in");
    window.run();
    assert_eq!(window.state().session().zoom(), Zoom::from(110));
    assert!((window.ctx.zoom_factor() - 1.1).abs() < 0.001);
    window.key_press_modifiers(Modifiers::COMMAND, Key::Minus);
    window.run();
    window.key_press_modifiers(Modifiers::COMMAND, Key::Minus);
    window.run();
    assert_eq!(window.state().session().zoom(), Zoom::from(90));
    for _ in 0..5 {
        window.key_press_modifiers(Modifiers::COMMAND, Key::Minus);
        window.run();
    }
    assert_eq!(window.state().session().zoom(), Zoom::LEAST);
    assert!((window.ctx.zoom_factor() - 0.75).abs() < 0.001, "keys go no further than a window can be read");
    click(&mut window, Role::Button, "75 %, Zoom to 100 %");
    window.run();
    assert!((window.ctx.zoom_factor() - 1.0).abs() < 0.001);
}

#[test]
fn the_scale_survives_a_restart_and_the_page_says_where_it_is_kept() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("state.toml");
    let mut first = page(Window { store: Store::at(&path), ..Window::default() });
    send(&mut first, Command::SetZoom(Zoom::from(120)));
    section(&mut first, Section::About);
    first.get_by_label(&path.display().to_string());
    let version = format!("{}, commit ", env!("CARGO_PKG_VERSION"));
    first.get_by_label_contains(&version);
    first.get_by_label("MIT OR Apache-2.0");
    eframe::App::on_exit(first.state_mut(), None);
    let again = Window { store: Store::at(&path), ..Window::default() }.open();
    assert!((again.ctx.zoom_factor() - 1.2).abs() < 0.001);
}

#[test]
fn every_key_is_listed() {
    let mut window = page(Window::default());
    section(&mut window, Section::Keys);
    window.get_by_label("Ctrl+K");
    window.get_by_label("F10");
}

#[test]
fn a_narrow_window_has_the_sections_in_a_list() {
    const NARROW: Vec2 = vec2(480.0, 600.0);
    let mut window = page(Window { size: NARROW, ..Window::default() });
    assert!(window.query_all_by_role(Role::Tab).next().is_none());
    click(&mut window, Role::ComboBox, "Section");
    click(&mut window, Role::Button, "Appearance");
    click(&mut window, Role::RadioButton, "Touch");
    assert_eq!(window.state().session().density(), Density::Touch);
}

/// Whether a number stands in the history of the check page. The status window prints its own decimal sign.
fn shown(window: &Harness<'_, App>, number: &str) -> bool {
    rows(window).iter().any(|row| row.contains(number))
}

#[test]
fn numbers_have_the_chosen_decimal_sign_and_are_read_with_either() {
    let mut window = Window::default().open();
    check(&mut window, "25 H7", "25,012");
    assert!(shown(&window, "25.012") && !shown(&window, "25,012"), "English has a point");
    send(&mut window, Command::OpenPage(Page::Settings));
    section(&mut window, Section::Appearance);
    click(&mut window, Role::RadioButton, "25,012");
    send(&mut window, Command::OpenPage(Page::Check));
    check(&mut window, "25 H7", "25.014");
    assert!(shown(&window, "25,014") && shown(&window, "25,012"));
    assert!(!shown(&window, "25.014"));
}

#[test]
fn the_change_of_a_setting_is_told_and_taken_back() {
    let mut window = page(Window::default());
    section(&mut window, Section::Appearance);
    click(&mut window, Role::RadioButton, "Dark");
    window.get_by_label("Colours was changed");
    click(&mut window, Role::RadioButton, "High contrast on black");
    click(&mut window, Role::Button, "Undo");
    assert_eq!(window.state().session().theme(), Theme::Dark, "only the last change is taken back");
    assert!(window.query_by_label_contains("was changed").is_none());
    let close = Action::from(SettingsAction::UseRows(RowHeight::Close)).command(window.state().session());
    send(&mut window, close.unwrap());
    click(&mut window, Role::Button, "Back to defaults");
    window.get_by_label("2 settings were changed");
    click(&mut window, Role::Button, "Undo");
    let session = window.state().session();
    assert_eq!((session.theme(), session.rows()), (Theme::Dark, RowHeight::Close));
}

#[test]
fn ctrl_f_goes_to_the_search() {
    let mut window = page(Window::default());
    window.get_by_role_and_label(Role::CheckBox, "Keypad").focus();
    window.run();
    window.key_press_modifiers(Modifiers::COMMAND, Key::F);
    window.run();
    assert!(window.get_by_role_and_label(Role::TextInput, "Find a setting").accesskit_node().is_focused());
}

#[test]
fn settings_are_exported_to_a_file_and_imported_at_another_station() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("shop.toml").display().to_string();
    let mut window = page(Window::default());
    send(&mut window, Command::UseSource(Base::ControlTables));
    click(&mut window, Role::Button, "Export settings…");
    type_into(&mut window, "File", &path);
    press(&mut window, Key::Enter);
    window.get_by_label_contains("shop.toml was written");
    let mut other = page(Window::default());
    click(&mut other, Role::Button, "Import settings…");
    type_into(&mut other, "File", &path);
    press(&mut other, Key::Enter);
    assert_eq!(other.state().session().sources().base(), Base::ControlTables);
    other.get_by_label_contains("shop.toml: 1 setting changed");
}

#[test]
fn own_texts_are_chosen_said_told_and_read_again_at_the_next_start() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("en_OurShop.ftl");
    crate::dialogs::put(&path, "page-settings = Our settings\nlanguage = Tongue\nlanguge = x\n");
    let store = || Store::at(&folder.path().join("state.toml"));
    let mut window = page(Window { store: store(), ..Window::default() });
    click(&mut window, Role::Button, "Own texts…");
    type_into(&mut window, "File", &path.display().to_string());
    press(&mut window, Key::Enter);
    window.get_by_label("Tongue");
    // In its row, and in a notice.
    for said in ["en_OurShop.ftl: 2 of 4", "1 text is refused", "The nearest name is language: "] {
        assert!(window.query_all_by_label_contains(said).next().is_some(), "{said}");
    }
    eframe::App::on_exit(window.state_mut(), None);
    let mut again = page(Window { store: store(), ..Window::default() });
    again.get_by_label("Tongue");
    click(&mut again, Role::Button, "Stop using own texts");
    again.get_by_label("Language");
    assert_eq!(again.query_all_by_label("Tongue").count(), 0);
}
