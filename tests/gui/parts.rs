//! A simulated part of several features on the program page: opened, listed, measured and drawn; by label and key.

use std::path::{Path, PathBuf};

use eframe::egui::accesskit::Role;
use eframe::egui::{Key, Modifiers, Theme};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use fitcheck::gui::App;
use fitcheck::session::{Page, Purpose};
use fitcheck::words::Language;

use crate::dialogs::Dropped;
use crate::harness::{DESK, Window, click, press, type_into};
use crate::pictures::can_paint;

type Harnessed = Harness<'static, App>;

const PLAN: &str = "name;kind;axis;callout;callout2;x;y;z;angle;clearance;clearance_height
A1;;;25 H7;;40;30;-8;0;2;50
S1;;;20 g6;;40;90;-8;0;2;50
N1;width;Y;16 H8;;100;90;-8;0;2;50
R1;width;X;30 h9;;160;30,5;-8;0;2;50
P1;face;-Z;10 h9;;220;30;10;0;2;50
B1;boss;;18 s7;16 h9;140;100;-8;0;2;50
";

fn put(path: &Path, text: &str) {
    std::io::Write::write_all(&mut std::fs::File::create(path).unwrap(), text.as_bytes()).unwrap();
}

/// A set and its part, as `fitcheck nc` writes them: the main program and the part's file.
fn set(folder: &Path) -> [PathBuf; 2] {
    put(&folder.join("plan.csv"), PLAN);
    let args = ["nc", "plan.csv", "--control", "tnc7", "-o", "set", "--workpiece-out", "part.toml"];
    let said = std::process::Command::new(env!("CARGO_BIN_EXE_fitcheck")).current_dir(folder).args(args).output();
    assert!(said.as_ref().is_ok_and(|said| said.status.success()), "{said:?}");
    ["set/FIT_MAIN.H", "part.toml"].map(|name| folder.join(name))
}

/// Runs past every stop.
fn run_to_the_end(page: &mut Harnessed) {
    for _ in 0..40 {
        press(page, Key::F5);
        if page.query_by_label_contains("Ended after").is_some() {
            return;
        }
    }
    panic!("the run does not end");
}

fn figure(page: &Harnessed) -> String {
    page.get_by_role(Role::Image).accesskit_node().label().unwrap_or_default()
}

#[test]
fn the_part_of_a_plan_is_opened_listed_and_measured() {
    let folder = tempfile::tempdir().unwrap();
    let [program, part] = set(folder.path());
    let files = vec![(Purpose::OpenProgram, program)];
    let mut page = Window { files, ..Window::default() }.open();
    assert_eq!(page.state().session().page(), Page::Program);
    click(&mut page, Role::ComboBox, "Workpiece");
    click(&mut page, Role::Button, "part of several features");
    page.get_by_label("Open a simulated part of several features");
    type_into(&mut page, "File", &part.display().to_string());
    press(&mut page, Key::Enter);
    page.get_by_label("part.toml, 6 features, ball radius 0 mm");
    page.get_by_label("A1: Hole Ø 25.0105 mm, X 40 Y 30");
    page.get_by_label("B1: Boss 18.037 × 15.9785 mm, X 140 Y 100");
    // It is seen before it is measured.
    assert!(figure(&page).contains("Part with 6 features: A1, S1, N1, R1, P1, B1."), "{}", figure(&page));
    run_to_the_end(&mut page);
    let run = page.state().session().program().run.as_ref().unwrap();
    assert_eq!(run.cycles().len(), 6);
    assert_eq!(run.status(), Some(fitcheck::verdict::Status::Good));
    assert!(figure(&page).contains("Part with 6 features"), "{}", figure(&page));
    assert!(figure(&page).contains("contacts"), "{}", figure(&page));
}

#[test]
fn a_part_is_dropped_on_the_page_and_a_collision_is_told() {
    let folder = tempfile::tempdir().unwrap();
    let way = folder.path().join("way.h");
    put(&way, "BEGIN PGM way MM\nL X+40 Y+30 Z+50 FMAX\nL Z+4 FMAX\nL X+140 FMAX\nEND PGM way MM\n");
    let part = folder.path().join("part.toml");
    put(
        &part,
        "[[feature]]\nname = \"rib\"\nkind = \"ridge\"\ncentre = [90, 30]\nwidth = 8\nlength = 40\ntop = 5\n[probe]\nball_radius = 3\n",
    );
    let mut page = Window { files: vec![(Purpose::OpenProgram, way)], ..Window::default() }.open();
    page.input_mut().dropped_files.push(std::sync::Arc::new(Dropped(part)));
    page.run();
    page.get_by_label("rib: Ridge 8 mm, X 90 Y 30");
    press(&mut page, Key::F5);
    page.get_by_label_contains("the ball would touch rib, with the centre of the ball at X 83.000001 Y 30 Z 4 mm");
    assert!(figure(&page).ends_with("Part with one feature: rib."), "{}", figure(&page));
}

#[test]
fn a_broken_part_is_refused_with_its_place_and_cycles_refuses_every_part() {
    let folder = tempfile::tempdir().unwrap();
    let part = folder.path().join("part.toml");
    put(&part, "[[feature]]\nname = \"A1\"\nkind = \"bore\"\ncentre = [40, 30]\n");
    let mut page = Window::default().open();
    page.key_press_modifiers(Modifiers::COMMAND, Key::Num8);
    page.run();
    click(&mut page, Role::ComboBox, "Workpiece");
    click(&mut page, Role::Button, "part of several features");
    type_into(&mut page, "File", &part.display().to_string());
    press(&mut page, Key::Enter);
    page.get_by_label_contains("line 1, column 1");
    press(&mut page, Key::Escape);
    put(&part, "[[feature]]\nname = \"A1\"\nkind = \"bore\"\ncentre = [40, 30]\ndiameter = 25\n");
    page.key_press_modifiers(Modifiers::COMMAND, Key::Num7);
    page.run();
    page.input_mut().dropped_files.push(std::sync::Arc::new(Dropped(part)));
    page.run();
    page.get_by_label_contains("the programs page and fitcheck run measure such a part");
}

/// More features than are in sight are reached by key.
#[test]
fn a_long_list_of_features_is_scrolled_by_key() {
    let folder = tempfile::tempdir().unwrap();
    let part = folder.path().join("part.toml");
    let feature = |number: usize| {
        format!("[[feature]]\nname = \"H{number}\"\nkind = \"bore\"\ncentre = [{}, 0]\ndiameter = 10\n", 20 * number)
    };
    put(&part, &(1..=30).map(feature).collect::<String>());
    let mut page = Window { files: vec![(Purpose::OpenPart, part)], ..Window::default() }.open();
    page.run();
    assert!(page.query_by_label("H30: Hole Ø 10 mm, X 600 Y 0").is_none());
    page.get_by_role_and_label(Role::List, "Features of the part").focus();
    page.run();
    press(&mut page, Key::End);
    page.get_by_label("H30: Hole Ø 10 mm, X 600 Y 0");
    press(&mut page, Key::Home);
    press(&mut page, Key::ArrowDown);
    assert!(page.query_by_label("H30: Hole Ø 10 mm, X 600 Y 0").is_none());
    page.get_by_label("H2: Hole Ø 10 mm, X 40 Y 0");
}

fn picture(name: &str, theme: Theme, language: Language, is_run: bool) {
    if !can_paint(name) {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let [program, part] = set(folder.path());
    let files = vec![(Purpose::OpenProgram, program), (Purpose::OpenPart, part)];
    let mut page = Window { size: DESK, theme, language, files, ..Window::default() }.open();
    page.run();
    if is_run {
        run_to_the_end(&mut page);
    }
    page.remove_cursor();
    page.run();
    page.snapshot(name);
}

#[test]
fn picture_of_a_measured_part_in_light() {
    picture("program_part_light", Theme::Light, Language::En, true);
}

#[test]
fn picture_of_a_part_before_its_run_in_dark() {
    picture("program_part_dark", Theme::Dark, Language::Nl, false);
}
