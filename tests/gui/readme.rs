//! The pictures of the README and the manual: what the window shows today, byte for byte in `docs/screenshots`.
//!
//! `UPDATE_SNAPSHOTS=1 cargo test --all-features --test gui` takes all of them anew.

use std::collections::BTreeSet;
use std::path::Path;

use eframe::egui::accesskit::Role;
use eframe::egui::{Key, Theme, Vec2, pos2, vec2};
use egui_kittest::Harness;
use fitcheck::gui::App;
use fitcheck::session::help::Sample;
use fitcheck::session::parts::WalkCommand;
use fitcheck::session::{
    self, BudgetCommand, CheckCommand, CheckField, Command, CycleFile, Field, FilesCommand, MeasureBy, Mode, Page,
    Purpose, WalkField,
};
use fitcheck::verdict::rules::RuleName;
use fitcheck::words::Language;

use crate::harness::{DESK, Window, check, click, picture_in, press, sheet_in, type_into};
use crate::pictures::can_paint;
use crate::statistics_page::{entries, flange, page_of};
use crate::studies::evaluated;
use crate::walk_page::with_alarm;

/// Takes a picture of a window, if pictures can be made here.
fn taken(name: &str, theme: Theme, size: Vec2, work: impl FnOnce(&mut Harness<'static, App>)) {
    if !can_paint(name) {
        return;
    }
    let mut window = Window { size, theme, ..Window::default() }.open();
    work(&mut window);
    window.run_ok();
    picture_in(&mut window, name, "docs/screenshots");
}

fn send(window: &mut Harness<'_, App>, command: impl Into<Command>) {
    let ctx = window.ctx.clone();
    window.state_mut().send(&ctx, command.into());
    window.run_ok();
}

#[test]
fn a_good_hole() {
    taken("good", Theme::Light, DESK, |window| check(window, "25 H7", "25.012"));
}

#[test]
fn a_hole_to_rework() {
    taken("rework", Theme::Light, DESK, |window| check(window, "25 H7", "24.998"));
}

#[test]
fn a_hole_that_is_scrap() {
    taken("scrap", Theme::Dark, DESK, |window| check(window, "25 H7", "25.030"));
}

#[test]
fn the_panel_of_a_control() {
    taken("panel", Theme::Light, vec2(800.0, 600.0), |window| check(window, "25 H7", "24.998"));
}

#[test]
fn a_wide_screen() {
    taken("wide", Theme::Light, vec2(1920.0, 1080.0), |window| {
        for measured in ["25.012", "25.005", "25.0185", "24.998", "25.014"] {
            check(window, "25 H7", measured);
        }
    });
}

#[test]
fn a_simulated_measurement_with_its_contacts() {
    taken("contacts", Theme::Dark, DESK, |window| {
        send(window, CheckCommand::Type(CheckField::Callout, "25 H7".to_owned()));
        send(window, CheckCommand::MeasureBy(MeasureBy::Simulating));
        send(window, CheckCommand::Measure);
    });
}

#[test]
fn a_value_in_a_guard_band() {
    taken("rule", Theme::Light, DESK, |window| {
        send(window, CheckCommand::UseRule(RuleName::Iso14253Of2017));
        send(window, CheckCommand::Type(CheckField::Uncertainty, "1.2".to_owned()));
        send(window, CheckCommand::Type(CheckField::PartTemperature, "24".to_owned()));
        // The header stays open: the rule had no uncertainty at first, and an error is never folded away.
        check(window, "25 H7", "25.0207");
    });
}

/// A part with its picture in an operator's window: the first value is good, and another one is looked at.
fn operator(window: &mut Harness<'static, App>, second: &str) {
    send(window, Command::SetMode(Mode::Operator));
    send(window, FilesCommand::Open(Sample::Part.purpose(), Sample::Part.path()));
    send(window, Command::OpenPage(Page::Parts));
    send(window, Field::from(WalkField::Serial).typed("A-0102".to_owned()));
    send(window, WalkCommand::Begin);
    for value in ["25.012", second] {
        send(window, Field::from(WalkField::Value).typed(value.to_owned()));
        send(window, WalkCommand::Take);
    }
}

#[test]
fn the_window_of_an_operator() {
    taken("operator", Theme::Light, vec2(1024.0, 768.0), |window| operator(window, "7.99"));
}

#[test]
fn the_report_of_a_part_as_it_will_print() {
    taken("reports", Theme::Light, DESK, |window| {
        send(window, FilesCommand::Open(Sample::Part.purpose(), Sample::Part.path()));
        send(window, Command::OpenPage(Page::Parts));
        send(window, Field::from(WalkField::Serial).typed("A-0102".to_owned()));
        send(window, WalkCommand::Begin);
        for value in ["25.012", "8.009", "8.011", "7.997", "8.021", "11.985"] {
            send(window, Field::from(WalkField::Value).typed(value.to_owned()));
            send(window, WalkCommand::Take);
        }
        send(window, Command::OpenPage(Page::Reports));
    });
}

/// The width of a picture of a sheet.
const WIDTH: u32 = 480;

/// The panels of ten, fifteen and twenty-four inches, light, dark and in high contrast, in the language of a sheet.
fn sheet(name: &str, code: &str) {
    if !can_paint(name) {
        return;
    }
    let language = Language::from_code(code).unwrap();
    let mut rows = Vec::new();
    for (size, second) in [((1024.0, 600.0), "7.99"), ((1024.0, 768.0), "8.05"), ((1920.0, 1080.0), "8.02")] {
        let mut row = Vec::new();
        let mut window = Window { size: size.into(), language, ..Window::default() }.open();
        operator(&mut window, second);
        for theme in [session::Theme::Light, session::Theme::Dark, session::Theme::Contrast] {
            send(&mut window, Command::SetTheme(theme));
            let picture = window.render().unwrap();
            let height = WIDTH * picture.height() / picture.width();
            row.push(image::imageops::resize(&picture, WIDTH, height, image::imageops::FilterType::Triangle));
        }
        rows.push(row);
    }
    let height = rows.iter().map(|row| row[0].height() + 8).sum();
    let mut sheet = image::RgbaImage::from_pixel((WIDTH + 8) * 3, height, image::Rgba([255, 255, 255, 255]));
    let mut top = 0;
    for row in rows {
        for (left, picture) in (0..).map(|place| place * i64::from(WIDTH + 8)).zip(&row) {
            image::imageops::replace(&mut sheet, picture, left, top);
        }
        top += i64::from(row[0].height() + 8);
    }
    sheet_in(&sheet, name, "docs/screenshots");
}

#[test]
fn the_operators_window_on_three_panels_in_four_languages() {
    for (name, code) in [("operator_en", "en"), ("operator_nl", "nl"), ("operator_de", "de"), ("operator_it", "it")] {
        sheet(name, code);
    }
}

/// A whole program with what it measures, run to its end.
fn program(name: &str, size: Vec2, program: &str, (kind, measured): (CycleFile, &str)) {
    taken(name, Theme::Light, size, |window| {
        let file = |name: &str| Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/examples").join(name);
        send(window, FilesCommand::Open(Purpose::OpenProgram, file(program)));
        send(window, Command::OpenPage(Page::Program));
        send(window, FilesCommand::Open(Purpose::OpenCycleFile(kind), file(measured)));
        press(window, Key::F5);
        while window.state().session().program().is_running() {
            window.run_steps(1);
        }
        assert!(window.state().session().program().run.as_ref().is_some_and(fitcheck::session::program::Run::is_over));
    });
}

#[test]
fn a_plate_is_milled_measured_and_reworked() {
    program("program_plate", DESK, "plate_fit.h", (CycleFile::Contacts, "plate_fit.csv"));
}

#[test]
fn a_flange_is_turned_and_measured() {
    program("program_flange", DESK, "flange_fit.nc", (CycleFile::Contacts, "flange_fit.csv"));
}

#[test]
fn a_part_as_it_was_clamped_is_aligned_and_measured() {
    program("program_datum", vec2(1600.0, 1000.0), "clamped_fit.h", (CycleFile::Workpiece, "clamped_fit.toml"));
}

/// Pictures of the documents that other tests take, too.
const OTHERS: [(&str, &str); 14] = [
    ("columns", "columns_light"),
    ("cycle_421", "cycle_421_light"),
    ("cycle_422", "cycle_422_dark"),
    ("cycle_427", "cycle_427_light"),
    ("cycle_444", "cycle_444_dark"),
    ("cycle_g785", "cycle_g785_light"),
    ("fit", "fit_interference_light"),
    ("pairing", "pairing_light"),
    ("plan", "plan_desk"),
    ("program", "program_light"),
    ("program_part", "program_part_light"),
    ("records", "records_light"),
    ("tables", "table_differs_light"),
    ("walk", "walk_picture"),
];

#[test]
fn the_other_pictures_are_those_of_the_tests() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    for (picture, of_test) in OTHERS {
        let shown = root.join("docs/screenshots").join(format!("{picture}.png"));
        let taken = root.join("tests/snapshots").join(format!("{of_test}.png"));
        if std::env::var_os("UPDATE_SNAPSHOTS").is_some() {
            std::fs::copy(&taken, &shown).unwrap();
        }
        assert!(std::fs::read(&shown).unwrap() == std::fs::read(&taken).unwrap(), "{picture} is not {of_test}");
    }
}

/// Pictures that no test takes, and what takes them.
const ELSEWHERE: [(&str, &str); 1] = [("windows", ".ci/windows")];

#[test]
fn every_picture_is_taken_by_a_test_and_shown_in_a_document() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    for (picture, script) in ELSEWHERE {
        assert!(root.join(script).is_file(), "{picture} is taken by {script}");
    }
    let source = std::fs::read_to_string(root.join("tests/gui/readme.rs")).unwrap();
    let mut shown = BTreeSet::new();
    let pages = std::fs::read_dir(root.join("docs/manual")).unwrap().map(|entry| entry.unwrap().path());
    for page in pages.chain([root.join("README.md")]) {
        let text = std::fs::read_to_string(&page).unwrap();
        for rest in text.split("screenshots/").skip(1) {
            let name = rest.split_once(".png)").unwrap().0;
            assert!(source.contains(&format!("(\"{name}\"")), "{name} in {} is taken by no test", page.display());
            shown.insert(format!("{name}.png"));
        }
    }
    let there = std::fs::read_dir(root.join("docs/screenshots")).unwrap();
    let there = there.map(|entry| entry.unwrap().file_name().to_string_lossy().into_owned());
    let there: BTreeSet<String> =
        there.filter(|name| ![".old.", ".new.", ".diff."].iter().any(|left| name.contains(left))).collect();
    assert_eq!(shown, there, "shown in a document, and in the folder");
}

fn statistics(name: &str, size: Vec2) {
    if can_paint(name) {
        picture_in(&mut page_of(size, entries(&flange())), name, "docs/screenshots");
    }
}

#[test]
fn the_statistics_of_a_flange() {
    statistics("statistics", vec2(1920.0, 1080.0));
}

#[test]
fn the_statistics_of_a_flange_in_a_small_window() {
    statistics("statistics_small", DESK);
}

#[test]
fn a_study_of_a_gauge() {
    if can_paint("study") {
        picture_in(&mut evaluated(), "study", "docs/screenshots");
    }
}

#[test]
fn an_alarm_of_a_control_chart() {
    if can_paint("alarm") {
        let folder = tempfile::tempdir().unwrap();
        let mut window = with_alarm(folder.path(), vec2(1280.0, 1000.0));
        click(&mut window, Role::Button, "Answer the alarm of Flange A");
        for _ in 0..2 {
            click(&mut window, Role::Button, "Close");
        }
        type_into(&mut window, "Cause", "Tool wear");
        window.hover_at(pos2(640.0, 500.0));
        picture_in(&mut window, "alarm", "docs/screenshots");
    }
}

#[test]
fn a_budget() {
    taken("budget", Theme::Light, DESK, |window| {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/corpus/inputs/station3.toml");
        send(window, FilesCommand::Open(Purpose::OpenBudget, path));
        send(window, BudgetCommand::Use);
    });
}
