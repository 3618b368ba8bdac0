//! Long work in the window: how far a file is, the button that stops it, and the report of the part that is measured.

use fitcheck::session::WindowAction;
use std::path::Path;

use eframe::egui::Key;
use eframe::egui::accesskit::Role;
use egui_kittest::Harness;
use egui_kittest::kittest::Queryable as _;
use fitcheck::gui::App;
use fitcheck::session::{Command, FilesCommand, Page, Purpose, Working};

use crate::harness::{DESK, Window, click, press, type_into, window};

fn send(window: &mut Harness<'_, App>, command: impl Into<Command>) {
    let ctx = window.ctx.clone();
    window.state_mut().send(&ctx, command.into());
    window.run();
}

fn far(is_writing: bool) -> FilesCommand {
    let name = if is_writing { "report.html" } else { "bores.csv" }.to_owned();
    let (rows, all) = if is_writing { (0, None) } else { (120_000, Some(8_200_000)) };
    FilesCommand::Working(Some(Box::new(Working { name, is_writing, rows, bytes: 3_140_000, all, elapsed_ms: 500 })))
}

#[test]
fn a_file_that_takes_long_says_its_figures_and_can_be_stopped() {
    let mut window = window();
    send(&mut window, far(false));
    let line = "Reading bores.csv: 120\u{a0}000 rows, 3.1 of 8.2 MB, 240\u{a0}000 rows a second";
    window.get_by_label(line);
    window.get_by_role_and_label(Role::ProgressIndicator, "Reading progress");
    click(&mut window, Role::Button, "Stop");
    send(&mut window, FilesCommand::Working(None));
    assert!(window.query_by_label(line).is_none());
    assert!(!window.state().session().can(WindowAction::StopWorking));
    send(&mut window, far(true));
    window.get_by_label("Writing report.html: 3.1 MB, 0.5 s");
}

#[test]
fn the_dialog_that_waits_for_a_file_says_how_far_it_is() {
    let mut window = window();
    send(&mut window, Command::OpenDialog(Purpose::Import));
    window.get_by_role_and_label(Role::TextInput, "File");
    send(&mut window, far(false));
    // It does not wait yet, so nothing stands in its place.
    assert!(window.query_by_label_contains("Reading bores.csv").is_none());
}

/// A picture of one line beside its plan.
fn put_plan(folder: &Path) -> std::path::PathBuf {
    let plan = folder.join("flange.toml");
    let text = "fitcheck_plan = 1\npart = \"Flange\"\npicture = \"flange.svg\"\n[[feature]]\nnumber = 1\nname = \"BORE\"\n\
        callout = \"25 H7\"\nballoon_x = 0.25\nballoon_y = 0.5\n[[feature]]\nnumber = 2\nname = \"PIN\"\ncallout = \"20 g6\"\n";
    fitcheck::files::write(&plan, text.as_bytes()).unwrap();
    let svg = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"20\" height=\"10\"><path d=\"M0 0h20v10z\"/></svg>";
    fitcheck::files::write(&folder.join("flange.svg"), svg.as_bytes()).unwrap();
    plan
}

#[test]
fn the_part_that_is_measured_is_reported_with_its_picture_and_what_is_missing() {
    let folder = tempfile::tempdir().unwrap();
    let files = vec![(Purpose::OpenPlan, put_plan(folder.path()))];
    let mut page = Window { size: DESK, files, ..Window::default() }.open();
    assert_eq!(page.state().session().page(), Page::Parts);
    type_into(&mut page, "Serial number", "A-7");
    press(&mut page, Key::Enter);
    type_into(&mut page, "Measured value", "24.998");
    press(&mut page, Key::Enter);
    click(&mut page, Role::Button, "Report…");
    click(&mut page, Role::Button, "Inspection report (HTML)…");
    let path = folder.path().join("part.html");
    type_into(&mut page, "File", path.to_str().unwrap());
    press(&mut page, Key::Enter);
    let report = std::fs::read_to_string(&path).unwrap();
    let mut rest = report.as_str();
    for text in [
        "Flange, serial number A-7",
        "<svg class=\"verdict rework\"",
        "1 measured, 1 missing, 0 skipped",
        "Missing: PIN",
        "<img src=\"data:image/svg+xml;base64,PHN2ZyB4bWxucz0i",
        "<svg class=\"balloon rework\" x=\"25.00%\" y=\"50.00%\"",
        "flange.svg; one feature has no balloon on it",
        "<bdi>PIN</bdi>",
        "<section class=\"check\"",
    ] {
        let found = rest.split_once(text);
        (_, rest) = found.unwrap_or_else(|| panic!("{text:?} is missing in\n{report}"));
    }
}
