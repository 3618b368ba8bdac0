//! Records by label and key: a check and its number, a restart, the records page with its question, an open record, a correction,
//! the walk along the chain; a million records that are read slowly; a full disk.

use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::atomic::Ordering::SeqCst;
use std::time::{Duration, Instant};

use eframe::egui::accesskit::Role;
use eframe::egui::{Event, Key, Modifiers, OutputCommand, Theme, Vec2, ViewportId, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use fitcheck::gui::journal::{Journals, Local, Records};
use fitcheck::gui::{App, Store};
use fitcheck::session::{
    CheckCommand, Command, CyclesCommand, Density, Field, FilesCommand, MeasureBy, Page, ProgramCommand, Purpose,
    Recorded, RecordsCommand, RecordsField,
};
use fitcheck::words::Language;
use jiff::tz::{TimeZone, offset};

use crate::fake_journal::Fake;
use crate::harness::{Window, check, click, cursor, moment, press, rows, scan, type_into, unfold, verdict};
use crate::pictures::can_paint;

fn records(journals: impl Journals + 'static, folder: &Path) -> Records {
    Records {
        journals: Arc::new(journals),
        usual: Some(folder.join("journal.sqlite")),
        station: "Mill 3".to_owned(),
        moment,
        zone: TimeZone::fixed(offset(1)),
        always_threads: false,
    }
}

/// A window that records into a folder.
fn at(folder: &Path) -> Window {
    let local = Local::with_anchors(Some(folder.join("heads.txt")));
    Window { records: records(local, folder), ..Window::default() }
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

fn type_part(window: &mut Harness<'_, App>, part: &str) {
    type_into(window, "Part or feature", part);
}

/// Three checks: a good bore, one to rework, a scrapped shaft.
fn three(window: &mut Harness<'_, App>) {
    for (part, callout, measured) in
        [("Flange 1", "25 H7", "25.012"), ("Flange 2", "25 H7", "24.998"), ("Pin 3", "25 h6", "24.980")]
    {
        type_part(window, part);
        check(window, callout, measured);
    }
}

#[test]
fn a_check_has_its_number_once_it_is_on_disk_and_is_there_after_a_restart() {
    let folder = tempfile::tempdir().unwrap();
    let mut window = at(folder.path()).open();
    three(&mut window);
    // The first entry is the beginning of the journal.
    window.get_by_label("Record 4");
    assert_eq!(window.state().session().check_recorded(), Some(Recorded::Kept(4)));
    let before = rows(&window);
    assert_eq!(before.len(), 3);
    eframe::App::on_exit(window.state_mut(), None);
    drop(window);
    let mut again = at(folder.path()).open();
    assert_eq!(rows(&again), before, "the history of the window before");
    assert!(!again.state().session().can(fitcheck::session::WindowAction::Undo), "nothing of it can be undone");
    assert!(verdict(&again).starts_with("No result"), "{}", verdict(&again));
    assert_eq!(again.state().session().notices(), []);
    check(&mut again, "25 H7", "25.010");
    again.get_by_label("Record 5");
    press_ctrl(&mut again, Key::Num3);
    assert_eq!(again.state().session().page(), Page::Records);
    let listed = rows(&again);
    assert_eq!(listed.len(), 4);
    assert!(listed[0].starts_with("Record 5, 2026-11-21 10:42:07,"), "{listed:?}");
    assert!(listed[1].contains("Pin 3, 25 h6, 24.980 mm, \u{2212}20 µm, SCRAP"), "{listed:?}");
    assert!(listed[3].contains("Flange 1, 25 H7, 25.012 mm, +12 µm, GOOD"), "{listed:?}");
    again.get_by_label("4 records");
    again.get_by_label_contains("journal.sqlite · entries: 5");
}

#[test]
fn clearing_tells_that_records_stay_and_undo_of_a_check_withdraws_its_record_for_good() {
    let folder = tempfile::tempdir().unwrap();
    let mut window = at(folder.path()).open();
    three(&mut window);
    let row = rows(&window)[2].clone();
    window.get_by_label(&row).click();
    window.run();
    window.get_by_label("Record 2");
    send(&mut window, CheckCommand::ClearHistory);
    window.get_by_label("Records stay in the journal");
    send(&mut window, Command::Close);
    send(&mut window, CheckCommand::Undo);
    check(&mut window, "25 H7", "25.010");
    send(&mut window, CheckCommand::Undo);
    window.get_by_label("1 check taken back; record 5 is withdrawn");
    send(&mut window, Command::OpenPage(Page::Records));
    let listed = rows(&window);
    assert_eq!(listed.len(), 5, "both entries stay");
    assert!(listed[0].contains("Withdraws 5") && listed[1].contains("Void, see 6"), "{listed:?}");
    drop(window);
    let again = at(folder.path()).open();
    assert_eq!(rows(&again).len(), 3, "what was taken back does not come back");
}

#[test]
fn a_question_is_typed_and_its_words_have_buttons() {
    let folder = tempfile::tempdir().unwrap();
    let mut window = at(folder.path()).open();
    three(&mut window);
    press_ctrl(&mut window, Key::Num3);
    press_ctrl(&mut window, Key::F);
    type_into(&mut window, "Find", "flange");
    assert_eq!(rows(&window).len(), 2);
    window.get_by_label("2 records");
    click(&mut window, Role::Button, "Filter");
    click(&mut window, Role::Button, "Not good");
    let field = window.get_by_role_and_label(Role::TextInput, "Find").accesskit_node().value();
    assert_eq!(field.as_deref(), Some("flange verdict:rework,re-measure,scrap standing"));
    assert_eq!(rows(&window).len(), 1);
    click(&mut window, Role::Button, "Not good");
    click(&mut window, Role::Button, "Today");
    assert_eq!(rows(&window).len(), 2, "recorded today");
    type_into(&mut window, "Find", "verdict:bent");
    assert!(window.state().session().error(RecordsField::Question).is_some());
    assert_eq!(rows(&window).len(), 2, "the rows of the question before");
    for (asked, count) in [("25 H7", 2), ("25H7", 2), ("scrap", 1), ("\"scrap\"", 0), ("3", 2)] {
        type_into(&mut window, "Find", asked);
        // By its number, and by its name: Pin 3.
        assert_eq!(rows(&window).len(), count, "{asked}");
    }
    type_into(&mut window, "Find", "serial:nothing");
    assert_eq!(rows(&window), [""; 0]);
    window.get_by_label("No record matches");
    press(&mut window, Key::Escape);
    assert_eq!(rows(&window).len(), 3, "Escape empties the question");
}

#[test]
fn the_bar_has_no_number_before_the_first_record_and_a_choice_moves_no_row() {
    let folder = tempfile::tempdir().unwrap();
    let mut window = at(folder.path()).open();
    window.get_by_label("Recording");
    three(&mut window);
    window.get_by_label("Recorded, 4");
    press_ctrl(&mut window, Key::Num3);
    window.get_by_role_and_label(Role::Button, "Report of 3…");
    let first = rows(&window)[0].clone();
    let place = |window: &Harness<'_, App>, name: &str| window.get_by_label_contains(name).rect();
    let before = place(&window, &first);
    click(&mut window, Role::CheckBox, "Choose record 4 for a report");
    window.get_by_role_and_label(Role::Button, "Report of 1…");
    let chosen = window.get_by_label("1 chosen").rect();
    assert!((place(&window, &first).top() - before.top()).abs() < 0.1);
    assert!(before.bottom() < chosen.top());
    click(&mut window, Role::CheckBox, "Choose record 4 for a report");
    window.get_by_role(Role::Grid).focus();
    window.run();
    press_ctrl(&mut window, Key::A);
    window.get_by_label("3 chosen");
}

#[test]
fn a_value_of_a_file_is_imported_and_its_distance_beyond_the_limit_is_said() {
    let folder = tempfile::tempdir().unwrap();
    let mut window = at(folder.path()).open();
    send(&mut window, RecordsCommand::UseName("Anna".to_owned()));
    let file = folder.path().join("lot.csv");
    let lot = b"id,callout,measured\nB1,25 H7,25.0236\nB2,25 H7,25.001\n";
    std::fs::File::create(&file).and_then(|mut file| std::io::Write::write_all(&mut file, lot)).unwrap();
    send(&mut window, FilesCommand::Open(Purpose::Import, file));
    press_ctrl(&mut window, Key::Num3);
    send(&mut window, RecordsCommand::Open(2));
    window.get_by_label("Imported by");
    assert!(window.query_by_label("2.6 µm above maximum").is_some());
    // The form for filters has verdicts.
    send(&mut window, RecordsCommand::CloseRecord);
    click(&mut window, Role::Button, "Filter");
    click(&mut window, Role::ComboBox, "Filter by");
    click(&mut window, Role::Button, "Status");
    click(&mut window, Role::Button, "GOOD");
    let asked = window.state().session().text(RecordsField::Question).to_owned();
    assert_eq!((asked.as_str(), rows(&window).len()), ("verdict:good standing", 1));
}

#[test]
fn chips_and_the_typed_question_are_one() {
    let folder = tempfile::tempdir().unwrap();
    let mut window = at(folder.path()).open();
    three(&mut window);
    press_ctrl(&mut window, Key::Num3);
    let asked = |window: &Harness<'_, App>| {
        window.get_by_role_and_label(Role::TextInput, "Find").accesskit_node().value().unwrap_or_default()
    };
    let chips = |window: &Harness<'_, App>| -> Vec<String> {
        let chips = window.query_all_by_role(Role::Button).filter_map(|button| button.accesskit_node().label());
        chips.filter_map(|name| name.strip_prefix("Remove filter ").map(str::to_owned)).collect()
    };
    // What is typed is seen as chips; a word that is searched for, or is being typed, is none.
    type_into(&mut window, "Find", "flange part:\"Flange 2\" verdict:rework,scrap today serial:");
    assert_eq!(chips(&window), ["Part Flange 2", "Status REWORK, SCRAP", "Today"]);
    type_into(&mut window, "Find", "flange part:\"Flange 2\" verdict:rework,scrap today");
    assert_eq!(rows(&window).len(), 1);
    window.get_by_label("1 record");
    click(&mut window, Role::Button, "Remove filter Status REWORK, SCRAP");
    assert_eq!(asked(&window), "flange part:\"Flange 2\" today");
    // A filter of the form is typed into the question, in the place of one about the same.
    click(&mut window, Role::Button, "Filter");
    type_into(&mut window, "Value", "Flange 1");
    press(&mut window, Key::Enter);
    assert_eq!(asked(&window), "flange today part:\"Flange 1\"");
    assert_eq!(rows(&window).len(), 1);
    assert!(rows(&window)[0].contains("Flange 1"), "{:?}", rows(&window));
    for name in ["Remove filter Part Flange 1", "Remove filter Today"] {
        click(&mut window, Role::Button, name);
    }
    assert_eq!((asked(&window), rows(&window).len(), chips(&window).len()), ("flange".to_owned(), 2, 0));
    // By another field, chosen from the list.
    click(&mut window, Role::ComboBox, "Filter by");
    click(&mut window, Role::Button, "Callout");
    type_into(&mut window, "Value", "25 H7");
    click(&mut window, Role::Button, "Add filter");
    assert_eq!(asked(&window), "flange callout:\"25 H7\"");
    assert_eq!(chips(&window), ["Callout 25 H7"]);
}

#[test]
fn keys_walk_the_list_and_enter_opens_a_record_with_its_reasoning() {
    let folder = tempfile::tempdir().unwrap();
    let mut window = at(folder.path()).open();
    type_into(&mut window, "Part or feature", "Flange 1");
    window.get_by_label("Record").click();
    window.run();
    type_into(&mut window, "Serial number", "S-17");
    type_into(&mut window, "Remark", "after the crash");
    send(&mut window, RecordsCommand::UseName("Anna".to_owned()));
    check(&mut window, "25 H7", "24.998");
    check(&mut window, "25 H7", "25.001");
    press_ctrl(&mut window, Key::Num3);
    press(&mut window, Key::ArrowDown);
    assert!(cursor(&window).starts_with("Record 3"), "{}", cursor(&window));
    press(&mut window, Key::ArrowDown);
    assert!(cursor(&window).starts_with("Record 2"), "{}", cursor(&window));
    press(&mut window, Key::Enter);
    for said in ["S-17", "after the crash", "Anna", "Mill 3", "25.000 … 25.021 mm", "REWORK"] {
        assert!(window.query_by_label(said).is_some(), "{said}");
    }
    window.get_by_label("2026-11-21 10:42:07 (+01:00 Europe/Amsterdam)");
    let hash = window.state().session().records().opened_row().unwrap().head.hash.to_string();
    window.get_by_label(&hash);
    press(&mut window, Key::Escape);
    assert_eq!(window.state().session().records().open.as_ref(), None);
    window.get_by_role(Role::Grid).focus();
    window.run();
    window.input_mut().events.push(Event::Copy);
    window.step();
    let copied = window.output().platform_output.commands.iter().find_map(|command| match command {
        OutputCommand::CopyText(text) => Some(text.clone()),
        _ => None,
    });
    let copied = copied.unwrap();
    assert!(copied.contains("2\t2026-11-21 10:42:07\tFlange 1\tS-17\t\t25 H7\t24.998\t-2\tREWORK\tAnna\t"), "{copied}");
}

#[test]
fn a_record_is_corrected_with_a_reason_and_both_stay() {
    let folder = tempfile::tempdir().unwrap();
    let mut window = at(folder.path()).open();
    three(&mut window);
    press_ctrl(&mut window, Key::Num3);
    let first = rows(&window)[2].clone();
    window.get_by_label(&first).click();
    window.run();
    // The Escape that closes a menu closes no record.
    click(&mut window, Role::Button, "Menu");
    window.get_by_label("Clear history");
    press(&mut window, Key::Escape);
    assert!(window.query_by_label("Clear history").is_none());
    assert!(window.state().session().records().open.is_some());
    click(&mut window, Role::Button, "Correct…");
    // What is said of the reason moves nothing.
    let below = |window: &Harness<'_, App>| {
        let reason = window.get_by_role_and_label(Role::TextInput, "Reason").rect();
        window.get_by_role_and_label(Role::CheckBox, "Withdraw the record").rect().top() - reason.top()
    };
    let before = below(&window);
    click(&mut window, Role::Button, "Record the correction");
    window.get_by_label("A correction needs a reason");
    assert!((below(&window) - before).abs() < 0.1, "{} {before}", below(&window));
    click(&mut window, Role::Button, "wrong part");
    let reason = window.get_by_role_and_label(Role::TextInput, "Reason").accesskit_node().value();
    assert_eq!(reason.as_deref(), Some("wrong part"));
    type_into(&mut window, "Reason", "read from the wrong part");
    click(&mut window, Role::Button, "Record the correction");
    window.get_by_label("Nothing is different: change a field, or withdraw the record");
    type_into(&mut window, "Measured value", "25.023");
    unfold(&mut window, "Part, serial number, name");
    type_into(&mut window, "Part", "Flange 7");
    click(&mut window, Role::Button, "Record the correction");
    // The new record is open, and stands in place of the old one.
    window.get_by_role_and_label(Role::Button, "In place of record 2");
    window.get_by_label("read from the wrong part");
    let listed = rows(&window);
    assert!(
        listed[0].contains("Record 5") && listed[0].contains("Flange 7, 25 H7, 25.023 mm, +23 µm, SCRAP"),
        "{listed:?}"
    );
    assert!(listed[3].contains("Record 2") && listed[3].contains("Void, see 5"), "{listed:?}");
    click(&mut window, Role::Button, "In place of record 2");
    window.get_by_role_and_label(Role::Button, "Corrected or withdrawn by record 5");
    window.get_by_label("Void because");
    window.get_by_label("read from the wrong part");
    window.get_by_label("25 H7, hole");
    window.get_by_label("12 µm above minimum, 9 µm below maximum");
    assert!(window.query_by_role_and_label(Role::Button, "Correct…").unwrap().accesskit_node().is_disabled());
    // A record is taken back, too.
    window.get_by_label(&listed[1]).click();
    window.run();
    click(&mut window, Role::Button, "Correct…");
    click(&mut window, Role::CheckBox, "Withdraw the record");
    window.get_by_role_and_label(Role::Button, "Withdraw the record");
    assert!(window.query_by_label_contains("A new record takes the place").is_none());
    type_into(&mut window, "Reason", "was a test");
    press(&mut window, Key::Enter);
    let listed = rows(&window);
    assert!(listed[0].contains("Record 6") && listed[0].contains("Withdraws 4"), "{listed:?}");
    // The history of the next window has what stands.
    drop(window);
    let again = at(folder.path()).open();
    let history = rows(&again);
    assert_eq!(history.len(), 2, "{history:?}");
    assert!(history[0].contains("Flange 7") && history[1].contains("Flange 2"), "{history:?}");
}

#[test]
fn a_check_of_the_history_is_corrected_in_one_step_and_undo_takes_it_back_in_one() {
    let folder = tempfile::tempdir().unwrap();
    let mut window = at(folder.path()).open();
    check(&mut window, "25 H7", "25.030");
    check(&mut window, "25 H7", "25.012");
    let [_, wrong] = <[String; 2]>::try_from(rows(&window)).unwrap();
    click(&mut window, Role::Row, &wrong);
    assert!(verdict(&window).starts_with("SCRAP"), "{}", verdict(&window));
    click(&mut window, Role::Button, "Correct…");
    window.get_by_label("Correct record 2");
    assert!(verdict(&window).starts_with("No result"), "no verdict beside other inputs: {}", verdict(&window));
    let value = |window: &Harness<'_, App>, name: &str| {
        window.get_by_role_and_label(Role::TextInput, name).accesskit_node().value().unwrap_or_default()
    };
    assert_eq!((value(&window, "Measured value"), value(&window, "Callout")), ("25.03".into(), "25 H7".into()));
    // The value was typed wrongly, and so was the callout.
    type_into(&mut window, "Measured value", "24.998");
    type_into(&mut window, "Callout", "25 X99");
    press(&mut window, Key::Enter);
    assert!(window.state().session().error(RecordsField::Callout).is_some());
    type_into(&mut window, "Callout", "25 h6");
    press(&mut window, Key::Enter);
    window.get_by_label("A correction needs a reason");
    type_into(&mut window, "Reason", "digits swapped");
    press(&mut window, Key::Enter);
    // 25 h6 is 24.987 to 25.000.
    assert!(verdict(&window).starts_with("GOOD"), "{}", verdict(&window));
    let listed = rows(&window);
    assert_eq!(listed.len(), 3, "{listed:?}");
    assert!(listed[0].contains("25 h6, 24.9980 mm") && listed[0].contains("GOOD"), "{listed:?}");
    assert!(listed[2].contains("25 H7, 25.0300 mm") && listed[2].contains("Void, see 4"), "{listed:?}");
    window.get_by_label("Record 4");
    click(&mut window, Role::Row, &listed[2]);
    window.get_by_label("Record 2, void: see 4");
    assert!(window.query_by_role_and_label(Role::Button, "Correct…").unwrap().accesskit_node().is_disabled());
    // The journal has one entry more, which names the old one and the reason.
    press_ctrl(&mut window, Key::Num3);
    assert!(rows(&window)[2].contains("Record 2") && rows(&window)[2].contains("Void, see 4"), "{:?}", rows(&window));
    let fourth = rows(&window)[0].clone();
    click(&mut window, Role::Row, &fourth);
    window.get_by_role_and_label(Role::Button, "In place of record 2");
    window.get_by_label("digits swapped");
    // One step back: what stood before stands again, and nothing is gone.
    press_ctrl(&mut window, Key::Num1);
    press_ctrl(&mut window, Key::Z);
    let listed = rows(&window);
    assert_eq!(listed.len(), 4, "{listed:?}");
    assert!(listed[0].contains("25 H7, 25.0300 mm") && listed[0].contains("SCRAP"), "{listed:?}");
    assert!(listed[1].contains("25 h6, 24.9980 mm") && listed[1].contains("Void, see 5"), "{listed:?}");
    assert!(verdict(&window).starts_with("SCRAP"), "{}", verdict(&window));
    press_ctrl(&mut window, Key::Z);
    let stand = |window: &Harness<'_, App>| {
        window.state().session().history().iter().map(|record| record.measured().to_string()).collect::<Vec<_>>()
    };
    assert_eq!(stand(&window), ["25.03"], "the next step is the check before");
    drop(window);
    let again = at(folder.path()).open();
    assert_eq!(stand(&again), ["25.03"], "what was taken back does not come back");
}

#[test]
fn a_correction_that_cannot_be_written_says_so_and_changes_nothing() {
    let fake = Fake::of(1, Duration::ZERO);
    let folder = tempfile::tempdir().unwrap();
    let mut window = Window { records: records(fake.clone(), folder.path()), ..Window::default() }.open();
    check(&mut window, "25 H7", "25.030");
    click(&mut window, Role::Button, "Correct…");
    type_into(&mut window, "Measured value", "25.003");
    type_into(&mut window, "Reason", "digits swapped");
    fake.is_full.store(true, SeqCst);
    press(&mut window, Key::Enter);
    assert!(rows(&window).len() == 1 && rows(&window)[0].contains("SCRAP"), "{:?}", rows(&window));
    assert!(window.query_all_by_role_and_label(Role::Button, "Try again").next().is_some());
    fake.is_full.store(false, SeqCst);
    send(&mut window, RecordsCommand::TryAgain);
    assert!(verdict(&window).starts_with("GOOD"), "{}", verdict(&window));
    assert_eq!(rows(&window).len(), 2);
    // Escape leaves a form, and nothing is recorded.
    click(&mut window, Role::Button, "Correct…");
    press(&mut window, Key::Escape);
    assert!(window.query_by_label("Reason").is_none());
    assert_eq!(fake.written.lock().unwrap().len(), 2);
}

#[test]
fn what_a_record_asked_for_is_measured_again() {
    let folder = tempfile::tempdir().unwrap();
    let mut window = at(folder.path()).open();
    three(&mut window);
    press_ctrl(&mut window, Key::Num3);
    let first = rows(&window)[2].clone();
    window.get_by_label(&first).click();
    window.run();
    click(&mut window, Role::Button, "Measure again");
    assert_eq!(window.state().session().page(), Page::Check);
    let value = |window: &Harness<'_, App>, name: &str| {
        window.get_by_role_and_label(Role::TextInput, name).accesskit_node().value().unwrap_or_default()
    };
    assert_eq!((value(&window, "Callout"), value(&window, "Part or feature")), ("25 H7".into(), "Flange 1".into()));
    assert_eq!(
        (value(&window, "Measured value"), verdict(&window)),
        (String::new(), "No result. 25.000 … 25.021 mm".into())
    );
}

#[test]
fn the_chain_is_walked_and_the_answer_has_its_date() {
    let folder = tempfile::tempdir().unwrap();
    let mut window = at(folder.path()).open();
    three(&mut window);
    press_ctrl(&mut window, Key::Num3);
    click(&mut window, Role::Button, "Verify");
    window.get_by_label_contains("2026-11-21 10:42:07: 4 entries verified, up to 4");
}

#[test]
fn a_report_of_chosen_records_leaves_simulated_ones_out_unless_they_are_asked_for() {
    let folder = tempfile::tempdir().unwrap();
    let mut window = at(folder.path()).open();
    three(&mut window);
    send(&mut window, CheckCommand::MeasureBy(MeasureBy::Simulating));
    send(&mut window, CheckCommand::Measure);
    send(&mut window, Command::OpenPage(Page::Records));
    assert!(rows(&window)[0].contains("SIMULATED"), "{:?}", rows(&window));
    for number in [4, 5] {
        click(&mut window, Role::CheckBox, &format!("Choose record {number} for a report"));
    }
    window.get_by_label("2 chosen");
    window.get_by_label("1 simulated check is left out");
    let report = |window: &mut Harness<'_, App>, name: &str| {
        let path = folder.path().join(name);
        let csv = fitcheck::report::RENDERINGS.iter().position(|to| to.name == "html").unwrap();
        send(window, Command::OpenDialog(Purpose::ReportRecords(csv)));
        send(window, Command::TypePath(path.display().to_string()));
        send(window, Command::Confirm);
        send(window, Command::Close);
        std::fs::read_to_string(path).unwrap()
    };
    let without = report(&mut window, "without.html");
    assert!(without.contains("Pin 3") && without.contains("1 simulated check is left out"));
    assert!(without.contains("records 4, 5; its newest entry is 5"));
    click(&mut window, Role::CheckBox, "With simulated checks");
    let with = report(&mut window, "with.html");
    assert!(with.contains("1 of these checks is simulated: it is not evidence"));
}

#[test]
fn a_report_that_was_written_is_a_row_and_its_checks_name_it() {
    let folder = tempfile::tempdir().unwrap();
    let mut window = at(folder.path()).open();
    three(&mut window);
    let path = folder.path().join("lot.html");
    send(&mut window, Command::OpenDialog(Purpose::Export(0)));
    send(&mut window, Command::TypePath(path.display().to_string()));
    send(&mut window, Command::Confirm);
    window.run();
    send(&mut window, Command::OpenPage(Page::Records));
    let listed = rows(&window);
    assert_eq!(listed.len(), 4, "{listed:?}");
    assert!(listed[0].contains("lot.html") && listed[0].contains("Report"), "{listed:?}");
    send(&mut window, RecordsCommand::Open(5));
    window.run();
    let sha256 = fitcheck::journal::chain::Hash::of_file(&std::fs::read(&path).unwrap()).to_string();
    window.get_by_label(&sha256);
    window.get_by_label("2 … 4");
    send(&mut window, RecordsCommand::Open(3));
    window.run();
    click(&mut window, Role::Button, "In report 5, lot.html");
    assert_eq!(window.state().session().records().open.as_ref().unwrap().number, 5);
}

#[test]
fn every_page_that_judges_records_and_says_so() {
    let folder = tempfile::tempdir().unwrap();
    let mut window = at(folder.path()).open();
    let block = "TCH PROBE 421 ~\nQ273=50~\nQ274=20~\nQ262=25~\nQ275=25.02~\nQ276=25";
    for command in [CyclesCommand::TypeBlock(block.to_owned()), CyclesCommand::TakeBlock, CyclesCommand::Run] {
        send(&mut window, command);
    }
    send(&mut window, Command::OpenPage(Page::Cycles));
    window.get_by_label("Record 2");
    send(&mut window, Command::OpenPage(Page::Program));
    send(&mut window, ProgramCommand::Run);
    while window.state().session().program().is_running() {
        window.run_steps(1);
    }
    window.run_ok();
    window.get_by_label("Record 3");
    let contacts = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/examples/plate_fit.csv");
    send(&mut window, Command::OpenPage(Page::Check));
    let path = folder.path().join("parts.csv");
    fitcheck::files::write(&path, b"id;callout;measured\nA;25 H7;25,012\nB;25 H7;24,998\n").unwrap();
    send(&mut window, FilesCommand::Open(Purpose::Import, path));
    send(&mut window, Command::Close);
    send(&mut window, Command::OpenPage(Page::Records));
    let listed = rows(&window);
    assert_eq!(listed.len(), 4, "{listed:?}");
    assert!(listed[3].contains("Cycle 421") && listed[3].contains("SIMULATED"), "{listed:?}");
    // A file that was used has its hash.
    window.get_by_label(&listed[0]).click();
    window.run();
    let hash = fitcheck::journal::chain::Hash::of_file(b"id;callout;measured\nA;25 H7;25,012\nB;25 H7;24,998\n");
    window.get_by_label(&format!("parts.csv · SHA-256 {hash}"));
    assert!(contacts.exists());
}

#[test]
fn who_measures_is_chosen_once_and_changed_with_two_touches() {
    let folder = tempfile::tempdir().unwrap();
    let store = Store::at(&folder.path().join("state.toml"));
    let mut window = Window { store: store.clone(), ..at(folder.path()) }.open();
    click(&mut window, Role::Button, "No name is chosen. Choose a name");
    // The field has the keys at once.
    scan(&mut window, "Anna⏎");
    assert!(window.query_by_role_and_label(Role::TextInput, "Another name").is_none(), "the menu has closed");
    click(&mut window, Role::Button, "Measured by Anna");
    type_into(&mut window, "Another name", "Bert");
    click(&mut window, Role::Button, "Use this name");
    // Two touches: the button and the name.
    click(&mut window, Role::Button, "Measured by Bert");
    click(&mut window, Role::RadioButton, "Anna");
    check(&mut window, "25 H7", "25.012");
    send(&mut window, Command::OpenPage(Page::Records));
    assert!(rows(&window)[0].ends_with("GOOD, Anna"), "{:?}", rows(&window));
    eframe::App::on_exit(window.state_mut(), None);
    drop(window);
    let again = Window { store, ..at(folder.path()) }.open();
    again.get_by_role_and_label(Role::Button, "Measured by Anna");
}

#[test]
fn a_full_disk_warns_in_the_card_and_the_verdict_stays_until_it_can_be_written() {
    let folder = tempfile::tempdir().unwrap();
    let fake = Fake::default();
    fake.is_full.store(true, SeqCst);
    let mut window = Window { records: records(fake.clone(), folder.path()), ..Window::default() }.open();
    check(&mut window, "25 H7", "25.012");
    assert!(verdict(&window).starts_with("GOOD"), "{}", verdict(&window));
    window.get_by_label("Not recorded: the system cannot start a thread for the journal");
    window.get_by_label("1 check is not recorded: the system cannot start a thread for the journal");
    // The window does not close over it without a question.
    send(&mut window, Command::AskToLeave);
    window.get_by_label("1 check is not recorded yet. It is lost if the window closes.");
    send(&mut window, Command::Leave(false));
    fake.is_full.store(false, SeqCst);
    let again = window.get_all_by_role_and_label(Role::Button, "Try again").next().unwrap();
    again.click();
    window.run();
    window.get_by_label("Record 1");
    assert_eq!(fake.written.lock().unwrap().len(), 1);
    assert_eq!(window.state().session().notices(), []);
}

#[test]
fn a_window_that_closes_waits_for_what_is_being_written_and_shows_it_as_not_recorded_until_then() {
    let fake = Fake::default();
    let records = Records { always_threads: true, ..records(fake.clone(), Path::new("/nowhere")) };
    let mut window = Window { records, ..Window::default() }.open();
    // The disk takes nothing before this is dropped.
    let disk = std::sync::Arc::clone(&fake.disk);
    let disk = disk.lock().unwrap();
    for measured in ["25.012", "25.013", "25.014"] {
        check(&mut window, "25 H7", measured);
    }
    window.get_by_label("Being recorded");
    assert!(window.query_by_label_contains("Record ").is_none());
    let viewport = window.input_mut().viewports.entry(ViewportId::ROOT).or_default();
    viewport.events.push(eframe::egui::ViewportEvent::Close);
    window.step();
    let cancels = |window: &Harness<'_, App>| {
        let commands = &window.output().viewport_output[&ViewportId::ROOT].commands;
        commands.contains(&eframe::egui::ViewportCommand::CancelClose)
    };
    assert!(cancels(&window), "it stays until all of them are on disk");
    drop(disk);
    eframe::App::on_exit(window.state_mut(), None);
    assert_eq!(fake.written.lock().unwrap().len(), 3, "and whatever ends it waits");
}

#[test]
fn without_a_folder_nothing_is_recorded_and_the_page_says_so() {
    let mut window = Window::default().open();
    check(&mut window, "25 H7", "25.012");
    assert_eq!(window.state().session().check_recorded(), None);
    press_ctrl(&mut window, Key::Num3);
    window.get_by_label("Checks are not recorded: there is no data folder for them");
}

#[test]
fn the_state_file_turns_recording_off_or_names_another_journal() {
    let folder = tempfile::tempdir().unwrap();
    let state = folder.path().join("state.toml");
    fitcheck::files::write(&state, b"version = 1\n[records]\noff = true\n").unwrap();
    let mut window = Window { store: Store::at(&state), ..at(folder.path()) }.open();
    press_ctrl(&mut window, Key::Num3);
    window.get_by_label("Checks are not recorded: recording is turned off in the state file");
    drop(window);
    let other = folder.path().join("other.sqlite");
    let text = format!("version = 1\n[records]\nfile = '{}'\n", other.display());
    fitcheck::files::write(&state, text.as_bytes()).unwrap();
    let mut window = Window { store: Store::at(&state), ..at(folder.path()) }.open();
    check(&mut window, "25 H7", "25.012");
    window.get_by_label("Record 2");
    assert!(other.exists() && !folder.path().join("journal.sqlite").exists());
}

/// A page over a million records that are read slowly, on threads of their own.
fn million(slow: Duration) -> (Harness<'static, App>, Fake) {
    page(1_000_000, slow)
}

fn page(count: u64, slow: Duration) -> (Harness<'static, App>, Fake) {
    let fake = Fake::of(count, slow);
    let records = Records { always_threads: true, ..records(fake.clone(), Path::new("/nowhere")) };
    let mut window = Window { records, ..Window::default() }.open();
    press_ctrl(&mut window, Key::Num3);
    (window, fake)
}

/// Frames until something holds.
#[track_caller]
fn until(window: &mut Harness<'_, App>, what: impl Fn(&Harness<'_, App>) -> bool) {
    let begin = Instant::now();
    while !what(window) {
        assert!(begin.elapsed() < Duration::from_mins(2), "it never comes: {:?}", rows(window));
        std::thread::sleep(Duration::from_millis(5));
        window.step();
    }
}

fn is_read(window: &Harness<'_, App>) -> bool {
    let rows = rows(window);
    !rows.is_empty() && rows.iter().all(|row| !row.contains('…'))
}

/// For how long this thread has been on a processor, where the system tells it: the machine is shared, and a clock on the wall
/// counts what others do.
pub fn worked() -> Option<Duration> {
    let told = std::fs::read_to_string("/proc/thread-self/schedstat").ok()?;
    Some(Duration::from_nanos(told.split_whitespace().next()?.parse().ok()?))
}

/// The work of a frame while a key is held, in the middle of many.
fn work(window: &mut Harness<'_, App>, frames: usize, key: Key) -> Option<Duration> {
    let mut took = Vec::new();
    for _ in 0..frames {
        window.key_press(key);
        let begin = worked()?;
        window.step();
        took.push(worked()?.saturating_sub(begin));
    }
    took.sort_unstable();
    took.get(frames / 2).copied()
}

#[test]
fn a_million_records_are_walked_to_the_last_one_and_no_frame_waits() {
    let (mut window, fake) = million(Duration::from_millis(200));
    until(&mut window, |window| !rows(window).is_empty());
    assert!(rows(&window)[0].contains("Record 1000000") || rows(&window)[0].contains('…'));
    until(&mut window, is_read);
    assert!(rows(&window)[0].contains("Record 1000000, 2026-11-21 10:42:07, P1000000"), "{:?}", rows(&window));
    window.get_by_role(Role::Grid).focus();
    window.step();
    let took = work(&mut window, 60, Key::PageDown);
    println!("a frame while a million records are paged: {took:?}");
    press(&mut window, Key::End);
    until(&mut window, is_read);
    let last = rows(&window).pop().unwrap();
    assert!(last.contains("Record 2, ") && last.contains("P2"), "{last}");
    assert!(cursor(&window).starts_with("Record 2,"));
    // Rows around those in sight, and never more than the pages that are kept.
    assert!(window.state().session().records().listing.read() <= 21 * 200);
    assert!(fake.read.load(SeqCst) < 60 * 400, "{:?}", fake.read);
    // A frame's work is that of what is in sight: no more than with a few records, whatever the machine does besides.
    let (mut small, _fake) = page(2_000, Duration::ZERO);
    until(&mut small, is_read);
    small.get_by_role(Role::Grid).focus();
    small.step();
    let usual = work(&mut small, 60, Key::PageDown);
    println!("and of two thousand: {usual:?}");
    let most = usual.map(|usual| 4 * usual + Duration::from_millis(8));
    assert!(took <= most, "{took:?}, and {usual:?} with two thousand");
}

#[test]
fn a_newer_question_ends_the_one_before_and_rows_come_before_the_count() {
    let (mut window, _fake) = million(Duration::from_millis(100));
    until(&mut window, is_read);
    for text in ["7", "77", "777"] {
        send(&mut window, Field::from(RecordsField::Question).typed(text.to_owned()));
        window.step();
    }
    until(&mut window, |window| rows(window).first().is_some_and(|row| row.contains("Record 999777,")));
    until(&mut window, |window| window.query_by_label("1\u{a0}000 records").is_some());
    // Nothing of the questions before comes late.
    for _ in 0..40 {
        std::thread::sleep(Duration::from_millis(5));
        window.step();
        assert!(rows(&window)[0].contains("Record 999777,"));
    }
}

#[test]
fn a_settled_page_asks_for_no_repaint_and_reads_nothing() {
    let (mut window, fake) = million(Duration::ZERO);
    until(&mut window, is_read);
    // However long the machine takes for it, it settles.
    let before = std::cell::Cell::new(usize::MAX);
    until(&mut window, |window| {
        let read = fake.read.load(SeqCst);
        let is_settled = window.output().viewport_output[&ViewportId::ROOT].repaint_delay == Duration::MAX;
        std::thread::sleep(Duration::from_millis(50));
        is_settled && before.replace(read) == read
    });
    let before = fake.read.load(SeqCst);
    window.run();
    assert_eq!(window.output().viewport_output[&ViewportId::ROOT].repaint_delay, Duration::MAX);
    assert_eq!(fake.read.load(SeqCst), before);
}

#[test]
fn a_walk_along_a_long_chain_shows_its_progress_and_is_cancelled() {
    let (mut window, _fake) = million(Duration::ZERO);
    until(&mut window, is_read);
    window.get_by_role_and_label(Role::Button, "Verify").click();
    until(&mut window, |window| window.query_by_label_contains("of 1\u{a0}000\u{a0}000 entries").is_some());
    window.get_by_role_and_label(Role::ProgressIndicator, "Progress of the verification");
    window.get_by_role_and_label(Role::Button, "Cancel verification").click();
    until(&mut window, |window| window.query_by_label("Verification cancelled").is_some());
}

#[test]
fn what_is_pressed_is_as_high_as_a_finger_needs() {
    let folder = tempfile::tempdir().unwrap();
    let mut window = at(folder.path()).open();
    three(&mut window);
    send(&mut window, Command::SetDensity(Density::Touch));
    send(&mut window, Command::OpenPage(Page::Records));
    send(&mut window, RecordsCommand::AskForFilter(true));
    send(&mut window, Field::from(RecordsField::Question).typed("part:Flange*".to_owned()));
    send(&mut window, Field::from(RecordsField::Question).typed("measured".to_owned()));
    send(&mut window, RecordsCommand::Open(3));
    for name in
        ["Verify", "Today", "Not good", "Remove filter Measured only", "Measure again", "Correct…", "Back to the list"]
    {
        let height = window.get_by_role_and_label(Role::Button, name).rect().height();
        assert!(44.0 <= height, "{name}: {height}");
    }
    for row in rows(&window) {
        let height = window.get_by_role_and_label(Role::Row, &row).rect().height();
        assert!(44.0 <= height, "{row}: {height}");
    }
}

/// A shop's week for pictures: good, rework, scrap, simulated, corrected.
fn week(window: Window) -> Harness<'static, App> {
    // One with the same hashes every time.
    let fake = Fake::of(1, Duration::ZERO);
    let folder = Path::new("/home/shop/.local/share/fitcheck");
    let mut window = Window { records: records(fake, folder), ..window }.open();
    send(&mut window, RecordsCommand::UseName("Anna".to_owned()));
    for (at, um) in (1..).zip([12, 4, -3, 9, 17, 21, 24, 8, 13, 1, 19, 6]) {
        send(&mut window, Field::from(fitcheck::session::CheckField::Part).typed("Flange 40-118".to_owned()));
        send(&mut window, Field::from(fitcheck::session::CheckField::Serial).typed(format!("S-{:04}", 210 + at)));
        send(&mut window, Field::from(fitcheck::session::CheckField::Callout).typed("25 H7".to_owned()));
        let nm: i64 = 25_000_000 + um * 1_000;
        let text = format!("{}.{:06}", nm / 1_000_000, nm % 1_000_000);
        send(&mut window, Field::from(fitcheck::session::CheckField::Measured).typed(text));
        send(&mut window, CheckCommand::Measure);
    }
    send(&mut window, RecordsCommand::UseName("Bert".to_owned()));
    send(&mut window, CheckCommand::MeasureBy(MeasureBy::Simulating));
    send(&mut window, CheckCommand::Measure);
    send(&mut window, Command::OpenPage(Page::Records));
    send(&mut window, RecordsCommand::Open(8));
    send(&mut window, RecordsCommand::Correct(true));
    for (field, text) in [(RecordsField::Reason, "read at the wrong bore"), (RecordsField::Measured, "25.020")] {
        send(&mut window, Field::from(field).typed(text.to_owned()));
    }
    send(&mut window, RecordsCommand::SendCorrection);
    send(&mut window, RecordsCommand::Open(4));
    window
}

fn picture(name: &str, theme: Theme, size: Vec2) {
    if can_paint(name) {
        let mut window = week(Window { size, theme, ..Window::default() });
        window.snapshot(name);
    }
}

#[test]
fn the_page_in_light() {
    picture("records_light", Theme::Light, vec2(1280.0, 800.0));
}

#[test]
fn the_page_in_dark() {
    picture("records_dark", Theme::Dark, vec2(1024.0, 600.0));
}

/// For people to look at, where they asked for it.
#[test]
fn pictures_of_other_sizes() {
    let Ok(pictures) = std::env::var("PICTURES") else { return };
    let pictures = PathBuf::from(pictures);
    for (language, theme, width, height) in [
        (Language::En, Theme::Light, 1280.0, 800.0),
        (Language::Nl, Theme::Dark, 1024.0, 600.0),
        (Language::En, Theme::Light, 480.0, 800.0),
        (Language::Nl, Theme::Light, 480.0, 320.0),
        (Language::En, Theme::Dark, 2560.0, 1440.0),
    ] {
        let mut window = week(Window { size: vec2(width, height), language, theme, ..Window::default() });
        let name = format!("records_{language}_{width}x{height}");
        window.render().unwrap().save(pictures.join(format!("{name}_open.png"))).unwrap();
        send(&mut window, RecordsCommand::Correct(true));
        window.render().unwrap().save(pictures.join(format!("{name}_correct.png"))).unwrap();
        send(&mut window, RecordsCommand::Correct(false));
        send(&mut window, RecordsCommand::CloseRecord);
        for number in [14, 15] {
            send(&mut window, RecordsCommand::Choose(number, true));
        }
        send(&mut window, RecordsCommand::Verify);
        window.render().unwrap().save(pictures.join(format!("{name}_list.png"))).unwrap();
        send(&mut window, Command::OpenPage(Page::Check));
        window.render().unwrap().save(pictures.join(format!("{name}_check.png"))).unwrap();
    }
}
