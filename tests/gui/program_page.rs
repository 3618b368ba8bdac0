//! The program page: the shipped program opened, filled in, stepped, run and read, by label and key.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};

use eframe::egui::accesskit::Role;
use eframe::egui::{Key, Modifiers, Theme, Vec2, ViewportId, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use fitcheck::gui::App;
use fitcheck::session::Page;
use fitcheck::session::program::Run;
use fitcheck::verdict::Status;
use fitcheck::words::Language;

use crate::harness::{DESK, Window, type_into};
use crate::pictures::can_paint;

type Harnessed = Harness<'static, App>;

fn open(window: Window) -> Harnessed {
    let mut page = window.open();
    page.key_press_modifiers(Modifiers::COMMAND, Key::Num5);
    page.run();
    assert_eq!(page.state().session().page(), Page::Program);
    page
}

fn page() -> Harnessed {
    open(Window::default())
}

fn click(page: &mut Harnessed, role: Role, label: &str) {
    page.get_by_role_and_label(role, label).click_accesskit();
    page.run();
}

fn key(page: &mut Harnessed, modifiers: Modifiers, key: Key) {
    page.key_press_modifiers(modifiers, key);
    page.run();
}

fn press(page: &mut Harnessed, pressed: Key) {
    key(page, Modifiers::NONE, pressed);
}

/// Opens a file by its typed path.
fn open_file(page: &mut Harnessed, path: &Path) {
    key(page, Modifiers::COMMAND, Key::O);
    page.get_by_role_and_label(Role::TextInput, "File").type_text(&path.display().to_string());
    page.run();
    press(page, Key::Enter);
}

fn put(path: &Path, text: &str) {
    use std::io::Write as _;
    std::fs::File::create(path).unwrap().write_all(text.as_bytes()).unwrap();
}

/// A program in a folder of its own.
fn program(folder: &Path, name: &str, body: &str) -> PathBuf {
    let path = folder.join(name);
    let stem = name.trim_end_matches(".h");
    put(&path, &format!("BEGIN PGM {stem} MM\n{body}\nEND PGM {stem} MM\n"));
    path
}

/// What the page says, region by region.
fn said(page: &Harnessed) -> Vec<String> {
    let regions = page.get_all_by_role(Role::Status);
    regions.filter_map(|node| node.accesskit_node().label()).collect()
}

#[track_caller]
fn says(page: &Harnessed, wanted: &str) {
    let said = said(page);
    assert!(said.iter().any(|said| said.contains(wanted)), "{wanted}: {said:?}");
}

fn run(page: &Harnessed) -> &Run {
    page.state().session().program().run().unwrap()
}

/// Selects a block by how its line begins.
fn select(page: &mut Harnessed, line: &str) {
    page.get_by(|node| node.role() == Role::ListItem && node.label().is_some_and(|label| label.starts_with(line)))
        .click_accesskit();
    page.run();
}

#[test]
fn the_shipped_program_runs_to_the_end_and_agrees() {
    let mut page = page();
    page.get_by_role_and_label(Role::List, "8255_en.h, 15 blocks");
    says(&page, "Ready to run");
    press(&mut page, Key::F5);
    says(&page, "The program stopped itself");
    page.get_by_label_contains("FIT STATUS");
    press(&mut page, Key::F5);
    says(&page, "Ended after");
    says(&page, "GOOD");
    says(&page, "The program agrees with Fitcheck");
    assert_eq!(run(&page).status(), Some(Status::Good));
}

fn picture(name: &str, theme: Theme, size: Vec2, language: Language, steps: impl FnOnce(&mut Harnessed)) {
    if !can_paint(name) {
        return;
    }
    let mut page = open(Window { theme, size, language, ..Window::default() });
    steps(&mut page);
    page.remove_cursor();
    page.run();
    page.snapshot(name);
}

#[test]
fn pictures_of_the_page() {
    picture("program_light", Theme::Light, DESK, Language::En, |page| {
        press(page, Key::F5);
    });
    picture("program_dark", Theme::Dark, DESK, Language::En, |page| {
        type_into(page, "Q1 Nominal size", "30");
        type_into(page, "QS1 Class", "g6");
        for _ in 0..14 {
            press(page, Key::F10);
        }
    });
    picture("program_small", Theme::Light, vec2(1024.0, 600.0), Language::Nl, |page| {
        press(page, Key::F5);
    });
}
