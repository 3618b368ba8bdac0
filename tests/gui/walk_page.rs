//! The walk through a part in the window, by label and key: values typed, gauged, simulated, from files and from a watched folder; touch
//! alone; interrupted and brought back.

use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::time::{Duration, Instant};

use eframe::egui::accesskit::Role;
use eframe::egui::{Key, Modifiers, Theme, Vec2, ViewportId, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use fitcheck::gui::journal::{Local, Records};
use fitcheck::gui::{App, Store};
use fitcheck::journal::ask::{AskedKinds, Question};
use fitcheck::session::parts::WalkCommand;
use fitcheck::session::{FilesCommand, Page, Purpose, WalkField};
use fitcheck::store::local::Reader;
use fitcheck::words::Language;
use jiff::tz::{TimeZone, offset};

use crate::dialogs::Dropped;
use crate::harness::{DESK, Window, click, moment, press, rows, type_into, verdict, wait};
use crate::pictures::can_paint;

/// Twelve features: the first is that of the sample log, by its place.
const PLAN: &str = "number;name;kind;axis;callout;callout2;x;y;z
1;BORE;;;25 H7;;40;30;-8
2;PIN;;;20 g6;;40;90;-8
3;SLOT;width;Y;16 H8;;100;90;-8
4;RIDGE;width;X;30 h9;;160;30;-8
5;TOP;face;-Z;10 h9;;220;30;10
6;BOSS;boss;;18 s7;16 h9;140;200;-8
7;POINT;point;-Z;±0,05;;260;30;12
8;D8;;;8 H7;;10;10;-5
9;D9;;;9 H7;;30;10;-5
10;D10;;;10 H7;;50;10;-5
11;D11;;;11 H7;;70;10;-5
12;D12;;;12 F9;;90;10;-5
";

pub type Harnessed = Harness<'static, App>;

pub fn put(path: &Path, text: &str) {
    std::io::Write::write_all(&mut std::fs::File::create(path).unwrap(), text.as_bytes()).unwrap();
}

fn records(folder: &Path) -> Records {
    Records {
        journals: Arc::new(Local::with_anchors(None)),
        usual: Some(folder.join("journal.sqlite")),
        station: "Mill 3".to_owned(),
        moment,
        zone: TimeZone::fixed(offset(1)),
        always_threads: false,
    }
}

/// A window that records in a folder, with the plan of that folder.
pub fn window_of(folder: &Path, size: Vec2) -> Window {
    let plan = folder.join("flange.csv");
    if !plan.exists() {
        put(&plan, PLAN);
    }
    let files = vec![(Purpose::OpenPlan, plan)];
    Window { size, files, records: records(folder), store: Store::at(&folder.join("state.toml")), ..Window::default() }
}

pub fn begun(folder: &Path) -> Harnessed {
    let mut page = window_of(folder, DESK).open();
    assert_eq!(page.state().session().page(), Page::Parts);
    type_into(&mut page, "Serial number", "A-0099");
    press(&mut page, Key::Enter);
    page
}

fn asked(page: &Harnessed) -> Option<String> {
    page.state().session().parts().walking.asked().map(|size| size.name())
}

fn value(page: &mut Harnessed, text: &str) {
    type_into(page, "Measured value", text);
    press(page, Key::Enter);
}

pub fn drop_file(page: &mut Harnessed, path: PathBuf) {
    page.input_mut().dropped_files.push(Arc::new(Dropped(path)));
    page.run();
}

#[track_caller]
pub fn until(page: &mut Harnessed, what: impl Fn(&Harnessed) -> bool) {
    let begin = Instant::now();
    while !what(page) {
        assert!(begin.elapsed() < Duration::from_mins(2), "it never comes: {:?}", rows(page));
        std::thread::sleep(Duration::from_millis(5));
        page.step();
    }
    page.run();
}

/// How many checks the journal has.
fn recorded(folder: &Path) -> usize {
    let reader = Reader::open(&folder.join("journal.sqlite")).unwrap();
    reader.numbers(&Question::default(), None, 1_000).unwrap().len()
}

#[test]
fn twelve_features_are_measured_from_everywhere() {
    let folder = tempfile::tempdir().unwrap();
    let mut page = begun(folder.path());
    // From the control's log: found by its place.
    let log = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/samples/logs/en/TCHPR421.TXT");
    drop_file(&mut page, log);
    assert_eq!(asked(&page).as_deref(), Some("PIN"));
    assert!(verdict(&page).contains("BORE: 25.0134 mm"), "{}", verdict(&page));
    press(&mut page, Key::Escape);
    // Typed, with a decimal comma.
    value(&mut page, "19,985");
    assert!(verdict(&page).starts_with("GOOD"), "{}", verdict(&page));
    // Simulated by the cycles of all kinds.
    for name in ["SLOT", "RIDGE", "TOP", "BOSS X", "POINT"] {
        assert_eq!(asked(&page).as_deref(), Some(name));
        press(&mut page, Key::F5);
        assert!(verdict(&page).starts_with("SIMULATED"), "{}", verdict(&page));
    }
    // A gauge that types its line.
    value(&mut page, "01A+0008.005");
    page.get_by_label("from channel 01");
    // From a file that is dropped.
    let csv = folder.path().join("values.csv");
    put(&csv, "name;measured\nD9;9.006\nNOBODY;3\n");
    drop_file(&mut page, csv);
    page.get_by_label("values.csv: 1 imported, 1 not");
    press(&mut page, Key::Escape);
    // From the watched folder.
    let drops = folder.path().join("drops");
    std::fs::create_dir(&drops).unwrap();
    click(&mut page, Role::Button, "More");
    click(&mut page, Role::Button, "Watch a folder…");
    type_into(&mut page, "Folder", &drops.display().to_string());
    // The first Enter goes into the folder, the second takes it.
    press(&mut page, Key::Enter);
    press(&mut page, Key::Enter);
    until(&mut page, |page| page.state().session().parts().watched.known.is_some());
    put(&drops.join("d.csv"), "name;measured\nD10;10.005\n");
    until(&mut page, |page| page.state().session().parts().watched.count == 1);
    assert!(page.query_by_label_contains("d.csv").is_some());
    assert_eq!(asked(&page).as_deref(), Some("D11"));
    // Left out for a reason, by key.
    press(&mut page, Key::F7);
    click(&mut page, Role::Button, "Not machined yet");
    value(&mut page, "12.07");
    assert!(verdict(&page).starts_with("SCRAP"), "{}", verdict(&page));
    // Measured again.
    press(&mut page, Key::F6);
    assert_eq!(asked(&page).as_deref(), Some("D12"));
    value(&mut page, "12.03");
    page.get_by_label("Measured 2 times: all values are kept, and this one is used");
    page.get_by_label("Every size has a value or is skipped");
    // Nothing is open: the large verdict is the part's, and the last size is the small line.
    let said = verdict(&page);
    assert!(said.starts_with("No verdict yet. The part A-0099"), "{said}");
    for reason in ["12 measured, 0 missing, 1 skipped", "Skipped: D11", "6 values are simulated"] {
        assert!(said.contains(reason), "{said}");
    }
    page.get_by_label("D12: 12.030 mm, GOOD");
    assert_eq!(recorded(folder.path()), 13);
    // The next part.
    press(&mut page, Key::F8);
    assert_eq!(page.state().session().text(fitcheck::session::WalkField::Serial), "A-0100");
    press(&mut page, Key::Enter);
    assert_eq!(asked(&page).as_deref(), Some("BORE"));
    assert_eq!(page.state().session().parts().walking.serial(), "A-0100");
}

#[test]
fn an_interrupted_part_is_there_after_a_restart() {
    let folder = tempfile::tempdir().unwrap();
    let mut page = begun(folder.path());
    value(&mut page, "25.03");
    press(&mut page, Key::F6);
    value(&mut page, "25.01");
    press(&mut page, Key::F7);
    type_into(&mut page, "Other reason", "pin is gone");
    press(&mut page, Key::Enter);
    // The state is kept soon after a change.
    let state = folder.path().join("state.toml");
    until(&mut page, |_| std::fs::read_to_string(&state).is_ok_and(|text| text.contains("pin is gone")));
    drop(page);
    let window = Window { files: Vec::new(), ..window_of(folder.path(), DESK) };
    let mut page = window.open();
    // The window opens where the part is, and what is typed is its next value.
    assert_eq!(page.state().session().page(), Page::Parts);
    page.get_by_label("The interrupted part A-0099 was restored with 2 values");
    assert!(has_focus(&page, Role::TextInput, "Measured value"));
    press(&mut page, Key::Escape);
    assert!(has_focus(&page, Role::TextInput, "Measured value"));
    assert_eq!(asked(&page).as_deref(), Some("SLOT"));
    let list = rows(&page);
    assert!(list[0].contains("GOOD") && list[0].contains("25.010 mm") && list[0].contains("2 values"), "{list:?}");
    assert!(list[1].contains("skipped: pin is gone"), "{list:?}");
    assert_eq!(recorded(folder.path()), 2, "nothing is recorded twice");
}

#[test]
fn the_watched_folder_takes_nothing_twice_and_an_idle_one_asks_for_no_frame() {
    let folder = tempfile::tempdir().unwrap();
    let drops = folder.path().join("drops");
    std::fs::create_dir(&drops).unwrap();
    put(&drops.join("d.csv"), "name;measured\nD10;10.005\nD11;11.005\n");
    for (round, known) in [(1, 0), (2, 1)] {
        // The second window finds the part of the first.
        let mut page = if round == 1 { begun(folder.path()) } else { window_of(folder.path(), DESK).open() };
        let ctx = page.ctx.clone();
        page.state_mut().send(&ctx, WalkCommand::Watch { folder: drops.clone(), is_folder: true }.into());
        until(&mut page, |page| page.state().session().parts().watched.known == Some(known));
        if round == 1 {
            until(&mut page, |page| page.state().session().parts().watched.count == 1);
        }
        // It looks a few times more, and then asks for no frame.
        std::thread::sleep(Duration::from_millis(600));
        until(&mut page, |page| page.output().viewport_output[&ViewportId::ROOT].repaint_delay == Duration::MAX);
        assert_eq!(recorded(folder.path()), 2, "round {round}");
        click(&mut page, Role::Button, "Stop watching");
        assert!(page.state().session().parts().watched.folder.is_none());
    }
}

#[test]
fn a_watched_folder_is_watched_again_after_a_restart_and_by_one_window_alone() {
    let folder = tempfile::tempdir().unwrap();
    let drops = folder.path().join("drops");
    std::fs::create_dir(&drops).unwrap();
    let mut page = begun(folder.path());
    let ctx = page.ctx.clone();
    page.state_mut().send(&ctx, WalkCommand::Watch { folder: drops.clone(), is_folder: true }.into());
    until(&mut page, |page| page.state().session().parts().watched.known.is_some());
    let state = folder.path().join("state.toml");
    until(&mut page, |_| std::fs::read_to_string(&state).is_ok_and(|text| text.contains("drops")));
    let window = || Window { files: Vec::new(), ..window_of(folder.path(), DESK) };
    let mut other = window().open();
    other.key_press_modifiers(Modifiers::COMMAND, Key::Num2);
    other.run();
    until(&mut other, |other| other.query_by_label_contains("another program watches this folder").is_some());
    // The folder is free when the first one is gone.
    drop(page);
    until(&mut other, |other| other.state().session().parts().watched.known.is_some());
    put(&drops.join("d.csv"), "name;measured\nD10;10.005\n");
    until(&mut other, |other| other.state().session().parts().watched.count == 1);
    assert!(other.query_by_label_contains("another program watches this folder").is_none());
    assert_eq!(recorded(folder.path()), 1);
}

#[test]
fn prints_are_read_back_through_the_users_own_mask() {
    let folder = tempfile::tempdir().unwrap();
    let mut page = begun(folder.path());
    let mask = folder.path().join("list.a");
    put(&mask, "\"Feature %-8s\",QS1;\n\"Result %8.3f\",Q153;\n");
    let ctx = page.ctx.clone();
    page.state_mut().send(&ctx, FilesCommand::Open(Purpose::LoadMask, mask).into());
    page.run();
    page.get_by_label("FN 16 output is read back through the mask list.a");
    let print = folder.path().join("list.txt");
    put(&print, "Feature BORE    \nResult   25.012\n");
    drop_file(&mut page, print);
    page.get_by_label("list.txt: 1 imported, 0 not");
    press(&mut page, Key::Escape);
    assert!(verdict(&page).contains("BORE: 25.012 mm"), "{}", verdict(&page));
    let drops = folder.path().join("drops");
    std::fs::create_dir(&drops).unwrap();
    page.state_mut().send(&ctx, WalkCommand::Watch { folder: drops.clone(), is_folder: true }.into());
    until(&mut page, |page| page.state().session().parts().watched.known.is_some());
    put(&drops.join("p.txt"), "Feature PIN     \nResult   19.985\n");
    until(&mut page, |page| page.state().session().parts().watched.count == 1);
    assert!(verdict(&page).contains("PIN: 19.985 mm"), "{}", verdict(&page));
    assert_eq!(recorded(folder.path()), 2);
}

#[test]
fn a_scanner_types_the_serial_number_once_a_plan_is_open() {
    let folder = tempfile::tempdir().unwrap();
    let mut page = window_of(folder.path(), DESK).open();
    page.event(eframe::egui::Event::Text("A-7".to_owned()));
    press(&mut page, Key::Enter);
    assert_eq!(page.state().session().parts().walking.serial(), "A-7");
    // The next part, too.
    for _ in 0..2 {
        press(&mut page, Key::F8);
    }
    page.event(eframe::egui::Event::Text("B-1".to_owned()));
    press(&mut page, Key::Enter);
    assert_eq!(page.state().session().parts().walking.serial(), "B-1");
}

/// Three sizes.
const THREE: &str = "number;name;callout\n1;A;25 H7\n2;B;20 H7\n3;C;16 H7\n";

fn begun_with_three(folder: &Path, size: Vec2) -> Harnessed {
    put(&folder.join("flange.csv"), THREE);
    let mut page = window_of(folder, size).open();
    type_into(&mut page, "Serial number", "A-1");
    press(&mut page, Key::Enter);
    page
}

#[test]
fn a_value_that_cannot_be_is_asked_about_and_confirmed_or_measured_again() {
    let folder = tempfile::tempdir().unwrap();
    put(&folder.path().join("flange.csv"), "name;callout;plausible\nA;25 H7;24.5 25.5\nB;20 H7;\n");
    let mut page = window_of(folder.path(), DESK).open();
    type_into(&mut page, "Serial number", "A-1");
    press(&mut page, Key::Enter);
    value(&mut page, "25.912");
    let asked_about = "outside what the plan says can be, 24.5 to 25.5 mm";
    assert!(0 < page.query_all_by_label_contains(asked_about).count());
    assert_eq!(recorded(folder.path()), 0);
    page.get_by_role_and_label(Role::Button, "Discard and measure again");
    // Enter gives the first answer once somebody can have read the question.
    wait(600);
    press(&mut page, Key::Enter);
    assert!(has_focus(&page, Role::TextInput, "Measured value"));
    assert_eq!(asked(&page).as_deref(), Some("A"));
    value(&mut page, "25.912");
    wait(600);
    // Below the value and in the question: both do the same.
    page.query_all_by_role_and_label(Role::Button, "It is so: judge 25.912 mm").last().unwrap().click();
    page.run();
    assert!(verdict(&page).contains("A: 25.912 mm"), "{}", verdict(&page));
    assert_eq!(asked(&page).as_deref(), Some("B"));
}

/// A part with a value at which rules of the control chart fire.
pub fn with_alarm(folder: &Path, size: Vec2) -> Harnessed {
    let plan = folder.join("flange.toml");
    put(&plan, "fitcheck_plan = 1\npart = \"Flange\"\n[[feature]]\nname = \"A\"\ncallout = \"25 H7\"\n");
    let window = window_of(folder, size);
    let mut page = Window { files: vec![(Purpose::OpenPlan, plan)], ..window }.open();
    type_into(&mut page, "Serial number", "A-01");
    press(&mut page, Key::Enter);
    for text in ["25.010", "25.011", "25.009", "25.010", "25.011", "25.009", "25.010", "25.009", "25.011", "25.010"] {
        value(&mut page, text);
        // The next part has the number behind this one.
        press(&mut page, Key::Enter);
        press(&mut page, Key::Enter);
    }
    assert!(page.query_by_label_contains("Open alarms").is_none());
    value(&mut page, "25.018");
    page
}

#[test]
fn a_rule_that_fires_asks_for_cause_and_action_and_changes_no_verdict() {
    let folder = tempfile::tempdir().unwrap();
    let mut page = with_alarm(folder.path(), DESK);
    assert!(verdict(&page).starts_with("GOOD"), "{}", verdict(&page));
    // The value and its distance from the one before: one answer is for both.
    page.get_by_label("Open alarms: 2");
    assert!(2 <= page.query_all_by_label_contains("since part A-11").count());
    // They are still open at the next part.
    press(&mut page, Key::Enter);
    page.get_by_label("Open alarms: 2");
    click(&mut page, Role::Button, "Answer the alarm of Flange A");
    assert!(has_focus(&page, Role::TextInput, "Cause"));
    // The notice of the alarm is closed by its own button, and the form stays.
    click(&mut page, Role::Button, "Close");
    page.get_by_role_and_label(Role::TextInput, "Cause");
    type_into(&mut page, "Cause", "Tool wear");
    type_into(&mut page, "Action", "Coolant filled up");
    press(&mut page, Key::Enter);
    assert!(
        page.query_by_label_contains("Open alarms").is_none(),
        "{:?}",
        page.state().session().error(WalkField::Cause)
    );
    let reader = Reader::open(&folder.path().join("journal.sqlite")).unwrap();
    let alarms = Question { kinds: AskedKinds::Alarms, ..Question::default() };
    let numbers = reader.numbers(&alarms, None, 10).unwrap();
    let rows = reader.rows(&numbers).unwrap();
    let answers = rows.iter().filter_map(|row| row.entry.as_ref().unwrap().alarm().unwrap().answer.clone());
    let answers: Vec<_> = answers.map(|answer| (answer.cause, answer.action)).collect();
    assert_eq!(answers, vec![("Tool wear".to_owned(), "Coolant filled up".to_owned()); 2]);
}

/// Whether what has a role and a name has the focus.
fn has_focus(page: &Harnessed, role: Role, name: &str) -> bool {
    page.get_by_role_and_label(role, name).accesskit_node().is_focused()
}

#[test]
fn the_large_verdict_is_the_parts_once_nothing_is_open() {
    let folder = tempfile::tempdir().unwrap();
    let mut page = begun_with_three(folder.path(), DESK);
    page.get_by_label("The part: no verdict yet");
    value(&mut page, "25.03");
    assert!(verdict(&page).starts_with("SCRAP"), "{}", verdict(&page));
    value(&mut page, "20.01");
    // The size is large, and that the part is scrap is plain to see.
    assert!(verdict(&page).starts_with("GOOD"), "{}", verdict(&page));
    page.get_by_label("The part: SCRAP");
    value(&mut page, "16.01");
    let said = verdict(&page);
    assert!(said.starts_with("SCRAP. The part A-1. Because of A. 3 measured, 0 missing, 0 skipped"), "{said}");
    page.get_by_label("C: 16.010 mm, GOOD");
    assert!(page.query_by_label_contains("The part: ").is_none());
    // The next part is the main thing to do.
    assert!(has_focus(&page, Role::Button, "Next part"));
    press(&mut page, Key::Enter);
    assert!(has_focus(&page, Role::TextInput, "Serial number"));
    assert!(!page.state().session().parts().walking.is_begun());
}

#[test]
fn measuring_again_is_of_the_selected_size_whose_own_verdict_is_shown() {
    let folder = tempfile::tempdir().unwrap();
    let mut page = begun_with_three(folder.path(), DESK);
    for text in ["25.03", "20.01"] {
        value(&mut page, text);
    }
    let row = |page: &mut Harnessed, name: &str| {
        page.get_by(|node| node.role() == Role::Row && node.label().is_some_and(|label| label.contains(name))).click();
        page.run();
    };
    row(&mut page, "1  A");
    assert!(verdict(&page).starts_with("SCRAP") && verdict(&page).contains("A: 25.030 mm"), "{}", verdict(&page));
    row(&mut page, "3  C");
    assert!(!verdict(&page).contains("mm"), "nothing is measured of it: {}", verdict(&page));
    row(&mut page, "2  B");
    press(&mut page, Key::F6);
    assert_eq!(asked(&page).as_deref(), Some("B"));
    assert!(has_focus(&page, Role::TextInput, "Measured value"));
    value(&mut page, "20.02");
    assert!(verdict(&page).contains("B: 20.020 mm"), "{}", verdict(&page));
    // After a value it is of the size that was measured last.
    press(&mut page, Key::F6);
    assert_eq!(asked(&page).as_deref(), Some("B"));
}

#[test]
fn the_part_says_what_is_to_do_and_leads_there() {
    let folder = tempfile::tempdir().unwrap();
    let mut page = begun_with_three(folder.path(), DESK);
    for text in ["25.03", "19.99", "16.01"] {
        value(&mut page, text);
    }
    for count in ["1 SCRAP", "1 REWORK", "1 GOOD"] {
        page.get_by_label(count);
    }
    page.get_by_role_and_label(Role::Button, "A: Set the part aside");
    assert!(page.query_by_label_contains("C: GOOD").is_none(), "nothing is to do with what is good");
    click(&mut page, Role::Button, "B: Remove 10 µm");
    press(&mut page, Key::F6);
    assert_eq!(asked(&page).as_deref(), Some("B"));
    value(&mut page, "20.01");
    // Both values are there, the newest first, and the size is no longer among what is to do.
    page.get_by_label("Values of B");
    assert!(page.get_by_label("20.010 mm").rect().top() < page.get_by_label("19.990 mm").rect().top());
    assert!(page.query_by_label("B: Remove 10 µm").is_none());
    page.get_by_label("2 GOOD");
}

/// Where the left edges and tops of some things are.
fn places(page: &Harnessed) -> Vec<(String, i32, i32)> {
    let names = ["Report…", "More", "Judge", "Skip", "Import values…"];
    let place = |name: &&str| {
        // In a low window the rail has a button `More`, too.
        let nodes = page.get_all_by_role_and_label(Role::Button, name).map(|node| node.rect());
        let rect = nodes.max_by(|one, other| one.left().total_cmp(&other.left())).unwrap();
        let dot = |side: f32| format!("{side:.0}").parse().unwrap();
        ((*name).to_owned(), dot(rect.left()), dot(rect.top()))
    };
    names.iter().map(place).collect()
}

#[test]
fn nothing_moves_when_a_verdict_or_an_error_comes() {
    for size in [DESK, vec2(1024.0, 600.0)] {
        let folder = tempfile::tempdir().unwrap();
        let mut page = begun_with_three(folder.path(), size);
        let before = places(&page);
        let columns = |page: &Harnessed| page.get_by_label_contains("2  B").rect();
        let row = columns(&page);
        for (said, text) in [("GOOD", "25.01"), ("REWORK", "19.99"), ("SCRAP", "16.03")] {
            value(&mut page, "abc");
            assert_eq!(places(&page), before, "an error at {size}");
            press(&mut page, Key::F7);
            press(&mut page, Key::Escape);
            assert_eq!(places(&page), before, "a reason that is not given at {size}");
            if said == "SCRAP" {
                break;
            }
            value(&mut page, text);
            assert!(verdict(&page).starts_with(said), "{}", verdict(&page));
            assert_eq!(places(&page), before, "{said} at {size}");
        }
        assert_eq!(columns(&page), row);
    }
}

#[test]
fn a_reason_is_asked_for_in_place_and_by_key() {
    let folder = tempfile::tempdir().unwrap();
    let mut page = begun_with_three(folder.path(), vec2(1024.0, 600.0));
    press(&mut page, Key::F7);
    assert!(has_focus(&page, Role::Button, "No access for the probe"));
    for name in ["Gauge missing", "Not machined yet", "Measured elsewhere", "Skip for this reason", "Do not skip"] {
        let rect = page.get_by_role_and_label(Role::Button, name).rect();
        assert!(rect.bottom() < 600.0, "{name}: {rect:?}");
    }
    press(&mut page, Key::Enter);
    assert_eq!(asked(&page).as_deref(), Some("B"));
    assert!(has_focus(&page, Role::TextInput, "Measured value"));
    press(&mut page, Key::F7);
    press(&mut page, Key::Escape);
    assert!(has_focus(&page, Role::TextInput, "Measured value"));
}

#[test]
fn the_focus_comes_back_to_the_value_and_the_ring_stays_where_it_is() {
    let folder = tempfile::tempdir().unwrap();
    let mut page = begun_with_three(folder.path(), DESK);
    // A notice, a dialog.
    let csv = folder.path().join("values.csv");
    put(&csv, "name;measured\nB;20.006\nNOBODY;3\n");
    drop_file(&mut page, csv);
    page.get_by_label("values.csv: 1 imported, 1 not");
    press(&mut page, Key::Escape);
    assert!(has_focus(&page, Role::TextInput, "Measured value"));
    click(&mut page, Role::Button, "More");
    click(&mut page, Role::Button, "Watch a folder…");
    press(&mut page, Key::Escape);
    assert!(has_focus(&page, Role::TextInput, "Measured value"));
    // What comes from a folder changes nothing of the focus.
    let drops = folder.path().join("drops");
    std::fs::create_dir(&drops).unwrap();
    let ctx = page.ctx.clone();
    page.state_mut().send(&ctx, WalkCommand::Watch { folder: drops.clone(), is_folder: true }.into());
    until(&mut page, |page| page.state().session().parts().watched.known.is_some());
    page.get_by_role_and_label(Role::Button, "Next part").focus();
    page.run();
    put(&drops.join("d.csv"), "name;measured\nC;16.005\n");
    until(&mut page, |page| page.state().session().parts().watched.count == 1);
    assert!(has_focus(&page, Role::Button, "Next part"));
}

#[test]
fn the_plan_is_named_where_another_one_is_open() {
    let folder = tempfile::tempdir().unwrap();
    let mut page = begun_with_three(folder.path(), DESK);
    assert!(page.query_by_label("Measured by the plan flange.csv").is_none());
    let other = folder.path().join("other.csv");
    put(&other, THREE);
    let ctx = page.ctx.clone();
    page.state_mut().send(&ctx, FilesCommand::Open(Purpose::OpenPlan, other).into());
    page.run();
    // Which plan counts is asked before another value is typed.
    page.get_by_label("This part is measured by flange.csv");
    page.get_by_label("Open now: other.csv");
    page.get_by_role_and_label(Role::Button, "Begin a part by other.csv");
    click(&mut page, Role::Button, "Measure this part on");
    assert!(page.query_by_label("This part is measured by flange.csv").is_none());
    page.get_by_label("Measured by the plan flange.csv");
    assert!(has_focus(&page, Role::TextInput, "Measured value"));
}

#[test]
fn touch_alone_does_the_walk() {
    let folder = tempfile::tempdir().unwrap();
    let mut page = window_of(folder.path(), vec2(1024.0, 768.0)).open();
    click(&mut page, Role::Button, "Next number");
    click(&mut page, Role::Button, "Start part");
    assert_eq!(page.state().session().parts().walking.serial(), "1");
    click(&mut page, Role::Button, "Keypad");
    for key in ["Key 2", "Key 5", "Decimal sign", "Key 0", "Key 1"] {
        click(&mut page, Role::Button, key);
    }
    click(&mut page, Role::Button, "Judge");
    assert!(verdict(&page).contains("BORE: 25.010 mm"), "{}", verdict(&page));
    click(&mut page, Role::Button, "Skip");
    click(&mut page, Role::Button, "Measured elsewhere");
    click(&mut page, Role::Button, "Simulate");
    assert!(verdict(&page).starts_with("SIMULATED"), "{}", verdict(&page));
    // A row of the list asks for its size.
    page.get_by(|node| node.role() == Role::Row && node.label().is_some_and(|label| label.contains("PIN")))
        .scroll_to_me();
    page.run();
    page.get_by(|node| node.role() == Role::Row && node.label().is_some_and(|label| label.contains("PIN"))).click();
    page.run();
    assert_eq!(asked(&page).as_deref(), Some("PIN"));
    for _ in 0..2 {
        click(&mut page, Role::Button, "Next part");
    }
    assert!(!page.state().session().parts().walking.is_begun());
    assert_eq!(page.state().session().text(fitcheck::session::WalkField::Serial), "2");
}

#[test]
fn the_list_is_walked_by_key() {
    let folder = tempfile::tempdir().unwrap();
    let mut page = begun(folder.path());
    page.get_by_role_and_label(Role::Grid, "Sizes of the part").focus();
    page.run();
    press(&mut page, Key::End);
    assert_eq!(asked(&page).as_deref(), Some("D12"));
    press(&mut page, Key::ArrowUp);
    assert_eq!(asked(&page).as_deref(), Some("D11"));
}

#[test]
fn a_gauge_types_into_the_value_whatever_was_clicked_before() {
    let folder = tempfile::tempdir().unwrap();
    let mut page = begun(folder.path());
    page.get_by(|node| node.role() == Role::Row && node.label().is_some_and(|label| label.contains("PIN"))).click();
    page.run();
    page.event(eframe::egui::Event::Text("19.985".to_owned()));
    press(&mut page, Key::Enter);
    assert!(verdict(&page).contains("PIN: 19.985 mm"), "{}", verdict(&page));
    // The list has the focus, or nothing has it.
    page.get_by_role_and_label(Role::Grid, "Sizes of the part").focus();
    page.run();
    page.event(eframe::egui::Event::Text("16.".to_owned()));
    page.run();
    page.event(eframe::egui::Event::Text("01".to_owned()));
    press(&mut page, Key::Enter);
    assert!(verdict(&page).contains("SLOT: 16.010 mm"), "{}", verdict(&page));
    let focused = page.ctx.memory(eframe::egui::Memory::focused).unwrap();
    page.ctx.memory_mut(|memory| memory.surrender_focus(focused));
    page.event(eframe::egui::Event::Text("29.97".to_owned()));
    press(&mut page, Key::Enter);
    assert!(verdict(&page).contains("RIDGE: 29.970 mm"), "{}", verdict(&page));
}

#[test]
fn a_key_that_is_held_ends_no_part_with_missing_sizes() {
    let folder = tempfile::tempdir().unwrap();
    let mut page = begun(folder.path());
    for _ in 0..5 {
        page.key_down(Key::F8);
        page.run();
    }
    assert!(page.state().session().parts().walking.is_warned);
    page.get_by_label_contains("Choose Next part again to end this part");
    page.key_up(Key::F8);
    page.run();
    press(&mut page, Key::F8);
    assert!(!page.state().session().parts().walking.is_begun());
}

#[test]
fn a_serial_number_that_was_measured_already_is_asked_about_beside_its_field() {
    let folder = tempfile::tempdir().unwrap();
    let mut page = begun(folder.path());
    value(&mut page, "25.01");
    for _ in 0..2 {
        press(&mut page, Key::F8);
    }
    page.event(eframe::egui::Event::Text("A-0099".to_owned()));
    for _ in 0..2 {
        // The clock of the tests stands still: both are one line of a scanner.
        press(&mut page, Key::Enter);
    }
    page.get_by_label_contains("Serial number A-0099 has been measured already.");
    assert!(!page.state().session().parts().walking.is_begun());
}

/// From Enter to the verdict on screen, with recording.
fn picture(name: &str, size: Vec2, language: Language, theme: Theme) {
    if !can_paint(name) {
        return;
    }
    let folder = tempfile::tempdir().unwrap();
    let mut page = Window { theme, language, ..window_of(folder.path(), size) }.open();
    let ctx = page.ctx.clone();
    let typed = |page: &mut Harnessed, field: fitcheck::session::WalkField, text: &str| {
        let command = fitcheck::session::Field::from(field).typed(text.to_owned());
        page.state_mut().send(&ctx, command);
    };
    typed(&mut page, fitcheck::session::WalkField::Serial, "A-0099");
    page.state_mut().send(&ctx, WalkCommand::Begin.into());
    for value in ["25.0134", "19,97"] {
        typed(&mut page, fitcheck::session::WalkField::Value, value);
        page.state_mut().send(&ctx, WalkCommand::Take.into());
    }
    page.state_mut().send(&ctx, WalkCommand::Simulate.into());
    page.state_mut().send(&ctx, WalkCommand::Skip("pin".to_owned()).into());
    typed(&mut page, fitcheck::session::WalkField::Value, "9,99");
    page.state_mut().send(&ctx, WalkCommand::Take.into());
    page.run();
    page.remove_cursor();
    page.run();
    page.snapshot(name);
}

#[test]
fn picture_of_the_walk_in_a_small_window() {
    picture("walk_small_en", vec2(480.0, 320.0), Language::En, Theme::Light);
}

#[test]
fn picture_of_the_walk_in_a_large_window() {
    picture("walk_large_nl", vec2(1920.0, 1080.0), Language::Nl, Theme::Dark);
}
