//! The pairing page by label and key: the wanted clearance, files through the dialog, walking the pairs, saving.

use std::io::Write as _;
use std::path::{Path, PathBuf};
use std::time::Duration;

use eframe::egui::accesskit::{Live, Role};
use eframe::egui::{Event, Key, Modifiers, OutputCommand, Theme, Vec2, ViewportId, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use fitcheck::gui::App;
use fitcheck::session::{Command, Density, Field, FilesCommand, Page, PairingField, Purpose};
use fitcheck::tolerance::Feature;
use fitcheck::words::Language;

use crate::dialogs::Dropped;
use crate::harness::{Window, click, cursor, press, rows, type_into, verdict};
use crate::pictures::can_paint;
use crate::records_page::worked;

const HOLES: &str = "id;measured\nH1;25,012\nH2;25,004\nH3;25,001\nH4;25,021\n";
const SHAFTS: &str = "id;measured\nS1;24,990\nS2;24,986\nS3;25,016\nS4;24,999\n";
const FIELD: &str = "Wanted clearance or fit";
const FIGURE: &str = "Parts by size";

fn put(folder: &Path, name: &str, text: &str) -> PathBuf {
    let path = folder.join(name);
    std::fs::File::create(&path).and_then(|mut file| file.write_all(text.as_bytes())).unwrap();
    path
}

fn send(window: &mut Harness<'_, App>, command: impl Into<Command>) {
    let ctx = window.ctx.clone();
    window.state_mut().send(&ctx, command.into());
    window.run();
}

fn press_ctrl(window: &mut Harness<'_, App>, key: Key) {
    window.key_press_modifiers(Modifiers::COMMAND, key);
    window.run();
}

/// The pairing page, opened by its key.
fn page(window: Window) -> Harness<'static, App> {
    let mut window = window.open();
    press_ctrl(&mut window, Key::Num5);
    window
}

/// Types a path into the open dialog and takes it.
fn take_file(window: &mut Harness<'_, App>, path: &Path) {
    type_into(window, "File", &path.display().to_string());
    press(window, Key::Enter);
}

/// The page with these parts, given from outside.
fn paired(window: Window, wanted: &str, holes: &str, shafts: &str) -> Harness<'static, App> {
    let folder = tempfile::tempdir().unwrap();
    let mut window = page(window);
    send(&mut window, Field::from(PairingField::Wanted).typed(wanted.to_owned()));
    for (feature, name, text) in [(Feature::Hole, "holes.csv", holes), (Feature::Shaft, "shafts.csv", shafts)] {
        let path = put(folder.path(), name, text);
        send(&mut window, FilesCommand::Open(Purpose::OpenParts(feature), path));
    }
    window
}

fn usual() -> Harness<'static, App> {
    paired(Window::default(), "0.010..0.020", HOLES, SHAFTS)
}

fn description(window: &Harness<'_, App>) -> String {
    let picture = window.get_by_role_and_label(Role::Image, FIGURE);
    picture.accesskit_node().data().description().unwrap_or_default().to_owned()
}

/// A file of so many parts, `step` nanometres apart.
fn many(name: &str, first_nm: i64, step: i64, count: i64) -> String {
    let row = |at: i64| {
        let nm = first_nm + at * step;
        format!("{name}{at};{}.{:06}\n", nm / 1_000_000, nm % 1_000_000)
    };
    (0..count).map(row).fold("id;measured\n".to_owned(), |text, row| text + &row)
}

#[test]
fn by_keys_alone_files_are_opened_paired_walked_and_saved() {
    let folder = tempfile::tempdir().unwrap();
    let (holes, shafts) = (put(folder.path(), "holes.csv", HOLES), put(folder.path(), "shafts.csv", SHAFTS));
    let mut window = page(Window::default());
    assert_eq!(verdict(&window), "No answer yet");
    window.get_by_label("→ Type the wanted clearance or a fit.");
    // The field has the focus.
    window.get_by_role_and_label(Role::TextInput, FIELD).type_text("0.010..0.020");
    window.run();
    window.get_by_label("Clearance +10 … +20 µm, middle +15 µm");
    window.get_by_label("✓ Type the wanted clearance or a fit.");
    press_ctrl(&mut window, Key::O);
    window.get_by_label("Open measured holes");
    take_file(&mut window, &holes);
    window.get_by_label("holes.csv, 4 parts");
    window.key_press_modifiers(Modifiers::COMMAND.plus(Modifiers::SHIFT), Key::O);
    window.run();
    window.get_by_label("Open measured shafts");
    take_file(&mut window, &shafts);
    assert_eq!(verdict(&window), "3 pairs. +13 … +15 µm. left over: 1 hole, 1 shaft");
    let status = window.get_by_role(Role::Status);
    assert_eq!(status.accesskit_node().data().live(), Some(Live::Polite));
    assert_eq!(
        rows(&window),
        [
            "H3 25.001 mm with S2 24.986 mm, clearance +15 µm, 0 µm from the middle",
            "H2 25.004 mm with S1 24.990 mm, clearance +14 µm, −1 µm from the middle",
            "H1 25.012 mm with S4 24.999 mm, clearance +13 µm, −2 µm from the middle",
        ]
    );
    window.get_by_role(Role::Grid).focus();
    window.run();
    for (key, hole) in
        [(Key::ArrowDown, "H3"), (Key::ArrowDown, "H2"), (Key::End, "H1"), (Key::ArrowUp, "H2"), (Key::Enter, "H2")]
    {
        press(&mut window, key);
        assert!(cursor(&window).starts_with(hole), "{key:?}: {}", cursor(&window));
    }
    // Ctrl+C comes as an event of its own.
    window.event(Event::Copy);
    window.step();
    let commands = &window.output().platform_output.commands;
    assert!(
        commands
            .iter()
            .any(|command| matches!(command, OutputCommand::CopyText(text) if text.contains("H3\t25.001\tS2")))
    );
    press_ctrl(&mut window, Key::S);
    window.get_by_label("Save pairs");
    take_file(&mut window, &folder.path().join("answer"));
    window.get_by_label_contains("answer.csv");
    let saved = std::fs::read_to_string(folder.path().join("answer.csv")).unwrap();
    assert!(saved.lines().nth(1).unwrap().starts_with("pair,H3,4,25.001"), "{saved}");
}

#[test]
fn the_answer_names_figures_leftovers_grinding_and_groups() {
    let mut window = usual();
    for text in ["Smallest clearance", "+13 µm", "Largest clearance", "Wanted middle", "Band around it", "4 µm"] {
        assert!(0 < window.get_all_by_label(text).count(), "{text}");
    }
    window.get_by_label("5 µm off the leftover shafts, or out of the leftover holes: 1 more pair");
    type_into(&mut window, "Groups", "2");
    window.get_by_label_contains("Group 1: ");
    type_into(&mut window, "Groups", "x");
    window.get_by_label("x is not a whole number");
    assert_eq!(verdict(&window), "No answer yet");
    type_into(&mut window, "Groups", "");
    type_into(&mut window, FIELD, "0.010");
    assert_eq!(verdict(&window), "No answer yet");
    window.get_by_label_contains("allowed are a fit, such as 25 H7/g6, and two clearances in mm");
}

#[test]
fn the_picture_says_what_it_shows() {
    let mut window = usual();
    assert_eq!(
        description(&window),
        "4 holes on the left, 4 shafts on the right, on one scale of size; shafts are shifted by +15 µm, so that a pair at \
         the middle of the wanted clearance is level. 3 pairs are drawn as lines. left over: 1 hole, 1 shaft."
    );
    window.get_by_label_contains("H2 25.004 mm with S1").click();
    window.run();
    assert!(description(&window).ends_with("Selected: H2 with S1, clearance +14 µm."), "{}", description(&window));
    assert!(cursor(&window).starts_with("H2"));
    press(&mut window, Key::ArrowDown);
    assert!(cursor(&window).starts_with("H1"), "the list has the focus after a click");
}

#[test]
fn refused_rows_warnings_and_simulated_parts_are_said() {
    let holes = "id;measured;simulated\nH1;25,012;false\nH2;;false\nH1;25,004;true\n";
    let window = paired(Window::default(), "0.010..0.020", holes, SHAFTS);
    window.get_by_label("1 row refused");
    window.get_by_label("line 3, column 2: measured: a length is missing");
    window.get_by_label_contains("a row has the name of an earlier row, such as H1 on lines 2 and 4");
    window.get_by_label("1 row is simulated: nothing was measured");
    assert!(verdict(&window).ends_with("1 pair with a simulated part"), "{}", verdict(&window));
    assert!(rows(&window).iter().any(|row| row.ends_with("hole simulated")), "{:?}", rows(&window));
}

#[test]
fn many_refused_rows_open_with_a_button() {
    let bad = (0..40).fold(HOLES.to_owned(), |text, at| format!("{text}B{at};x\n"));
    let mut window = paired(Window::default(), "0.010..0.020", &bad, SHAFTS);
    assert_eq!(window.get_all_by_label_contains("column 2").count(), 4);
    click(&mut window, Role::Button, "All 40 refused rows");
    assert!(12 < window.get_all_by_label_contains("column 2").count());
}

#[test]
fn checks_of_the_history_are_parts() {
    let mut window = Window::default().open();
    crate::harness::check(&mut window, "25 H7", "25.012");
    crate::harness::check(&mut window, "25 g6", "24.990");
    press_ctrl(&mut window, Key::Num5);
    type_into(&mut window, FIELD, "25 H7/g6");
    click(&mut window, Role::Button, "Holes of the history");
    click(&mut window, Role::Button, "Shafts of the history");
    assert_eq!(window.get_all_by_label("From the history, 1 part").count(), 2);
    assert_eq!(verdict(&window), "1 pair. +22 µm … +22 µm. nothing left over".replace(" µm …", " …"));
    assert_eq!(rows(&window), ["check 1 25.012 mm with check 2 24.990 mm, clearance +22 µm, −2 µm from the middle"]);
}

#[test]
fn dropped_files_are_the_holes_and_then_the_shafts() {
    let folder = tempfile::tempdir().unwrap();
    let mut window = page(Window::default());
    type_into(&mut window, FIELD, "0.010..0.020");
    let drop = |window: &mut Harness<'_, App>, files: &[(&str, &str)]| {
        for (name, text) in files {
            let path = put(folder.path(), name, text);
            window.input_mut().dropped_files.push(std::sync::Arc::new(Dropped(path)));
        }
        window.run();
    };
    drop(&mut window, &[("one.csv", HOLES), ("two.csv", SHAFTS)]);
    window.get_by_label("one.csv, 4 parts");
    window.get_by_label("two.csv, 4 parts");
    assert_eq!(verdict(&window), "3 pairs. +13 … +15 µm. left over: 1 hole, 1 shaft");
    drop(&mut window, &[("three.csv", SHAFTS)]);
    window.get_by_label_contains("three.csv is not opened");
    window.get_by_label("one.csv, 4 parts");
}

#[test]
fn by_touch_everything_is_high_enough() {
    let mut window = usual();
    send(&mut window, Command::SetDensity(Density::Touch));
    for name in ["Open holes…", "Open shafts…", "Holes of the history", "Copy pairs", "Save as CSV…", "Save as JSON…"]
    {
        let rect = window.get_by_role_and_label(Role::Button, name).rect();
        assert!(44.0 <= rect.height() + 0.1, "{name}: {rect:?}");
    }
    for role in [Role::TextInput, Role::Row] {
        assert!(window.get_all_by_role(role).all(|node| 44.0 <= node.rect().height() + 0.1), "{role:?}");
    }
}

#[test]
fn the_settled_page_asks_for_no_repaint() {
    let windows: [fn() -> Harness<'static, App>; 2] = [|| page(Window::default()), usual];
    for open in windows {
        let mut window = open();
        window.run();
        // A focused field's cursor blinks.
        window.ctx.memory_mut(|memory| memory.surrender_focus(memory.focused().unwrap_or(eframe::egui::Id::NULL)));
        for _ in 0..3 {
            window.step();
        }
        let output = window.output();
        let delay = output.viewport_output[&ViewportId::ROOT].repaint_delay;
        assert_eq!(delay, Duration::MAX);
    }
}

#[test]
fn a_hundred_thousand_of_each_are_paired_and_walked() {
    let (holes, shafts) = (many("H", 25_000_000, 100, 100_000), many("S", 24_980_000, 100, 100_000));
    let mut window = paired(Window::default(), "0.010..0.030", &holes, &shafts);
    assert!(verdict(&window).starts_with("100000 pairs"), "{}", verdict(&window));
    assert!(rows(&window).len() < 40);
    assert!(description(&window).contains("pairs are visible"), "{}", description(&window));
    window.get_by_role(Role::Grid).focus();
    window.run();
    press(&mut window, Key::End);
    assert!(cursor(&window).starts_with("H99999 "), "{}", cursor(&window));
    press(&mut window, Key::PageUp);
    assert!(cursor(&window).starts_with("H99989 "), "{}", cursor(&window));
    // A frame draws what is in sight only: without optimisation, on a loaded machine, it is still far below a second.
    let begin = worked();
    for _ in 0..20 {
        window.step();
    }
    let took = worked().and_then(|end| end.checked_sub(begin?));
    assert!(took.is_none_or(|took| took < Duration::from_secs(10)), "{took:?}");
}

#[test]
fn in_dutch_with_a_comma() {
    let mut window = page(Window { language: Language::Nl, ..Window::default() });
    type_into(&mut window, "Gewenste speling of passing", "0,010..0,0205");
    window.get_by_label("Speling +10 … +20,5 µm, midden +15,25 µm");
}

/// Twelve holes and thirteen shafts of a shop, with leftovers.
fn shop(window: Window) -> Harness<'static, App> {
    let list = |name: &str, sizes: &[&str]| {
        let rows = (1..).zip(sizes).map(|(at, mm): (usize, _)| format!("{name}{at};{mm}\n"));
        rows.fold("id;measured\n".to_owned(), |text, row| text + &row)
    };
    let holes = [
        "25.0035", "25.0120", "25.0081", "25.0154", "25.0190", "25.0062", "25.0107", "25.0021", "25.0143", "25.0205",
        "25.0098", "24.9905",
    ];
    let shafts = [
        "24.9822", "24.9905", "24.9871", "24.9930", "24.9988", "24.9849", "24.9893", "24.9812", "24.9941", "25.0046",
        "24.9884", "25.0090", "24.9798",
    ];
    let mut window = paired(window, "0.012..0.030", &list("H", &holes), &list("S", &shafts));
    send(&mut window, Field::from(PairingField::Groups).typed("3".to_owned()));
    send(&mut window, fitcheck::session::PairingCommand::Select(4));
    window.ctx.memory_mut(|memory| memory.surrender_focus(memory.focused().unwrap_or(eframe::egui::Id::NULL)));
    window.run();
    window
}

fn picture(name: &str, theme: Theme, size: Vec2) {
    if can_paint(name) {
        let mut window = shop(Window { size, theme, ..Window::default() });
        assert_eq!(window.state().session().page(), Page::Pairing);
        window.snapshot(name);
    }
}

#[test]
fn pairs_of_a_shop_in_light() {
    picture("pairing_light", Theme::Light, vec2(1280.0, 800.0));
}

#[test]
fn pairs_of_a_shop_in_dark() {
    picture("pairing_dark", Theme::Dark, vec2(1024.0, 600.0));
}

/// For people to look at, where they asked for it.
#[test]
fn pictures_of_other_sizes_and_of_many_parts() {
    let Ok(folder) = std::env::var("PICTURES") else { return };
    let save = |mut window: Harness<'_, App>, name: &str| {
        window.render().unwrap().save(Path::new(&folder).join(format!("{name}.png"))).unwrap();
    };
    for (width, height) in
        [(1280.0, 800.0), (1024.0, 600.0), (480.0, 800.0), (480.0, 320.0), (2560.0, 1440.0), (800.0, 1280.0)]
    {
        save(shop(Window { size: vec2(width, height), ..Window::default() }), &format!("pairing_{width}x{height}"));
    }
    save(page(Window::default()), "pairing_empty");
    let (holes, shafts) = (many("H", 25_000_000, 177, 100_000), many("S", 24_980_000, 181, 100_000));
    let mut window = paired(Window::default(), "0.010..0.030", &holes, &shafts);
    send(&mut window, fitcheck::session::PairingCommand::Select(40_000));
    save(window, "pairing_many");
}
