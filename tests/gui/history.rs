//! The history by label and key: walking, sorting, filtering, choosing, copying, exporting, undoing.

use std::time::Duration;

use eframe::egui::accesskit::{Role, SortDirection};
use eframe::egui::{Event, Key, Modifiers, OutputCommand, PointerButton, Vec2, ViewportId, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use fitcheck::exchange::import;
use fitcheck::gui::App;
use fitcheck::session::{CheckCommand, CheckField, Command};
use fitcheck::words::Language;

use crate::harness::{Window, check, click, cursor, press, rows, settle, type_into, window};

fn now() -> jiff::civil::DateTime {
    jiff::civil::date(2026, 11, 21).at(10, 42, 7, 0)
}

/// Reads a file of measurements as if it had been imported, and closes the notice about it.
fn read(window: &mut Harness<'_, App>, rows: &str) {
    let text = format!("id,callout,measured\n{rows}");
    let result = Ok(Box::new(import("lot.csv", text.as_bytes(), window.state().session().sources(), now())));
    let ctx = window.ctx.clone();
    window.state_mut().send(&ctx, CheckCommand::Imported { name: "lot.csv".to_owned(), result }.into());
    window.state_mut().send(&ctx, Command::Close);
    window.run();
}

const THREE: &str = "A10,25 H7,25.012\nA2,25 H7,24.998\nB,40 g6,39.9\n";

/// A window with a good, a rework and a scrap part.
fn three() -> Harness<'static, App> {
    let mut window = window();
    read(&mut window, THREE);
    window
}

fn focus_list(window: &mut Harness<'_, App>) {
    window.get_by_role(Role::Grid).focus();
    window.run();
}

fn press_ctrl(window: &mut Harness<'_, App>, key: Key) {
    window.key_press_modifiers(Modifiers::COMMAND, key);
    window.run();
}

/// The parts in sight, from above.
fn parts(window: &Harness<'_, App>) -> String {
    let parts: Vec<_> = rows(window).iter().map(|row| row.split(", ").nth(1).unwrap().to_owned()).collect();
    parts.join(" ")
}

fn shown(window: &Harness<'_, App>) -> String {
    window.state().session().check().shown.as_ref().map(|shown| shown.record.id.clone()).unwrap_or_default()
}

/// What a screen reader says has the focus: in the list, the row at which the keys are.
#[expect(clippy::redundant_closure_for_method_calls, reason = "the method alone is not general over lifetimes")]
fn focused(window: &Harness<'_, App>) -> String {
    window.get_by(|node| node.is_focused()).accesskit_node().label().unwrap_or_default()
}

/// The text that a key puts on the clipboard.
fn copied(window: &mut Harness<'_, App>, event: Event) -> Option<String> {
    window.input_mut().events.push(event);
    window.step();
    let copied = window.output().platform_output.commands.iter().find_map(|command| match command {
        OutputCommand::CopyText(text) => Some(text.clone()),
        _ => None,
    });
    window.run();
    copied
}

#[test]
fn a_row_says_date_part_callout_value_deviation_status_and_origin() {
    let window = three();
    assert_eq!(
        rows(&window)[..2],
        [
            "2026-11-21 10:42:07, B, 40 g6, 39.9000 mm, −100 µm, SCRAP, imported from lot.csv",
            "2026-11-21 10:42:07, A2, 25 H7, 24.9980 mm, −2 µm, REWORK, imported from lot.csv",
        ]
    );
    window.get_by_role_and_label(Role::Button, "Date and time");
}

#[test]
fn arrows_pages_home_and_end_walk_the_list_and_enter_shows_a_check() {
    let mut window = window();
    let lot: Vec<_> = (0..40).map(|number| format!("P{number:02},25 H7,25.012\n")).collect();
    read(&mut window, &lot.concat());
    focus_list(&mut window);
    for (key, part) in [
        (Key::Home, "P39"),
        (Key::ArrowDown, "P38"),
        (Key::ArrowDown, "P37"),
        (Key::ArrowUp, "P38"),
        (Key::PageDown, "P28"),
        (Key::PageUp, "P38"),
        (Key::End, "P00"),
        (Key::ArrowUp, "P01"),
    ] {
        press(&mut window, key);
        // The row is in sight, and a screen reader is told where the keys are.
        assert!(cursor(&window).contains(&format!(", {part}, ")), "{key:?}: {}", cursor(&window));
        let list = window.get_by_role(Role::Grid);
        let told = list.accesskit_node().data().active_descendant();
        let row = window.get_by(|node| node.role() == Role::Row && node.is_selected() == Some(true));
        assert!(told.is_some(), "{key:?}");
        assert!(list.rect().contains(row.rect().center()), "{key:?}: {:?} in {:?}", row.rect(), list.rect());
    }
    press(&mut window, Key::Enter);
    assert_eq!(shown(&window), "P01");
    assert!(focused(&window).contains(", P01, "), "the keys stay in the list: {}", focused(&window));
}

#[test]
fn a_click_shows_a_check_and_the_keys_go_on_from_there() {
    let mut window = three();
    window.get_by_label_contains(", A2, ").click();
    window.run();
    assert_eq!(shown(&window), "A2");
    press(&mut window, Key::ArrowDown);
    assert!(cursor(&window).contains(", A10, "), "{}", cursor(&window));
}

#[test]
fn space_chooses_a_check_for_export_and_what_is_chosen_is_said() {
    let mut window = three();
    focus_list(&mut window);
    press(&mut window, Key::Home);
    press(&mut window, Key::Space);
    window.get_by_label("1 chosen for export");
    assert!(cursor(&window).ends_with(", chosen for export"), "{}", cursor(&window));
    press(&mut window, Key::Space);
    assert!(window.query_by_label("1 chosen for export").is_none());
    press_ctrl(&mut window, Key::A);
    window.get_by_label("3 chosen for export");
    type_into(&mut window, "Filter", "A2");
    window.get_by_label("3 chosen for export, 2 of them not listed");
}

#[test]
fn a_head_sorts_and_says_how() {
    // Where there is room for every column.
    let mut window = Window { size: vec2(3840.0, 1080.0), ..Window::default() }.open();
    read(&mut window, THREE);
    assert_eq!(parts(&window), "B A2 A10");
    click(&mut window, Role::Button, "Part");
    let head = window.get_by_role_and_label(Role::Button, "Part, sorted ascending");
    assert_eq!(head.accesskit_node().data().sort_direction(), Some(SortDirection::Ascending));
    assert_eq!(parts(&window), "A2 A10 B");
    click(&mut window, Role::Button, "Part, sorted ascending");
    assert_eq!(parts(&window), "B A10 A2");
    click(&mut window, Role::Button, "Part, sorted descending");
    assert_eq!(parts(&window), "B A2 A10");
    for column in ["Date and time", "Callout", "Measured", "Deviation", "Status", "From"] {
        click(&mut window, Role::Button, column);
        window.get_by_role_and_label(Role::Button, &format!("{column}, sorted ascending"));
    }
    // A head is pressed by key, too.
    window.get_by_role_and_label(Role::Button, "Status").focus();
    window.run();
    press(&mut window, Key::Space);
    assert_eq!(parts(&window), "A10 A2 B");
}

/// Drags the edge before a head from where it is, and leaves it there.
fn drag_edge(window: &mut Harness<'_, App>, head: &str, by: f32) {
    let edge = window.get_by_role_and_label(Role::Button, head).rect().left_center();
    window.drag_at(edge);
    window.run();
    window.hover_at(edge + vec2(by, 0.0));
    window.run();
    window.drop_at(edge + vec2(by, 0.0));
    window.run();
}

#[test]
fn the_edge_of_a_head_is_dragged_and_a_double_click_gives_the_width_back() {
    let mut window = three();
    let left = |window: &Harness<'_, App>, head| window.get_by_role_and_label(Role::Button, head).rect().left();
    let (part, callout) = (left(&window, "Part"), left(&window, "Callout"));
    drag_edge(&mut window, "Callout", 40.0);
    assert!((left(&window, "Callout") - callout - 40.0).abs() < 1.0, "a part has more room");
    assert!((left(&window, "Part") - part).abs() < 1.0, "what is before it stays");
    assert_eq!(parts(&window), "B A2 A10", "nothing was sorted");
    drag_edge(&mut window, "Callout", -1000.0);
    assert!(part + 20.0 < left(&window, "Callout"), "a column stays wide enough to be taken again");
    let edge = window.get_by_role_and_label(Role::Button, "Callout").rect().left_center();
    let button = |pressed| Event::PointerButton {
        pos: edge,
        button: PointerButton::Primary,
        pressed,
        modifiers: Modifiers::NONE,
    };
    let twice = [true, false, true, false].map(button);
    window.input_mut().events.push(Event::PointerMoved(edge));
    window.input_mut().events.extend(twice);
    settle(&mut window);
    assert!((left(&window, "Callout") - callout).abs() < 0.01);
    assert_eq!(parts(&window), "B A2 A10");
}

#[test]
fn ctrl_f_goes_to_the_filter_and_escape_empties_it_and_leaves() {
    let mut window = three();
    press_ctrl(&mut window, Key::F);
    assert_eq!(focused(&window), "Filter");
    for (typed, found, count) in [("2", "B A2 A10", "3 checks"), ("5 h7", "A2 A10", "2 of 3 checks")] {
        window.get_by_role_and_label(Role::TextInput, "Filter").type_text(typed);
        window.run();
        if count == "2 of 3 checks" {
            assert_eq!(parts(&window), found);
        }
        window.get_by_label(count);
    }
    press(&mut window, Key::Escape);
    assert_eq!(parts(&window), "B A2 A10");
    assert!(focused(&window).contains(", B, "), "the keys are in the list: {}", focused(&window));
    assert_eq!(window.state().session().text(CheckField::HistoryFilter), "");
    // Enter in the filter measures nothing.
    type_into(&mut window, "Filter", "nothing like this");
    press(&mut window, Key::Enter);
    window.get_by_label("No check matches the filter");
    window.get_by_label("0 of 3 checks");
    assert_eq!(focused(&window), "Filter");
}

#[test]
fn ctrl_f_opens_the_list_of_a_small_window() {
    let mut window = Window { size: vec2(1024.0, 600.0), ..Window::default() }.open();
    check(&mut window, "25 H7", "25.012");
    assert!(window.query_by_role(Role::Grid).is_none());
    press_ctrl(&mut window, Key::F);
    assert_eq!(focused(&window), "Filter");
    window.get_by_role(Role::Grid);
}

#[test]
fn only_the_bad_are_listed_by_one_switch() {
    let mut window = three();
    click(&mut window, Role::CheckBox, "Only not good");
    assert_eq!(parts(&window), "B A2");
    window.get_by_label("2 of 3 checks");
    click(&mut window, Role::CheckBox, "Only not good");
    assert_eq!(parts(&window), "B A2 A10");
}

#[test]
fn rows_are_copied_by_key_in_either_form_that_a_system_sends() {
    let mut window = three();
    focus_list(&mut window);
    press(&mut window, Key::Home);
    let one = "Date and time\tPart\tCallout\tMeasured (mm)\tDeviation (µm)\tStatus\tFrom\n\
               2026-11-21 10:42:07\tB\t40 g6\t39.900\t-100\tSCRAP\timported from lot.csv\n";
    assert_eq!(copied(&mut window, Event::Copy).as_deref(), Some(one));
    let key =
        Event::Key { key: Key::C, physical_key: None, pressed: true, repeat: false, modifiers: Modifiers::COMMAND };
    assert_eq!(copied(&mut window, key).as_deref(), Some(one));
    press_ctrl(&mut window, Key::A);
    assert_eq!(copied(&mut window, Event::Copy).unwrap().lines().count(), 4);
    // A text field copies its own text.
    type_into(&mut window, "Callout", "30 H8");
    press_ctrl(&mut window, Key::A);
    assert_eq!(copied(&mut window, Event::Copy).as_deref(), Some("30 H8"));
}

#[test]
fn only_the_bad_are_exported_and_the_menu_says_what_will_be() {
    let folder = tempfile::tempdir().unwrap();
    let mut window = three();
    click(&mut window, Role::Button, "Export");
    window.get_by_label("All 3 checks will be exported");
    click(&mut window, Role::Button, "Choose 2 checks that are not good");
    window.get_by_label("2 chosen for export");
    click(&mut window, Role::Button, "Export");
    click(&mut window, Role::Button, "History as CSV…");
    let path = folder.path().join("bad.csv");
    type_into(&mut window, "File", path.to_str().unwrap());
    press(&mut window, Key::Enter);
    let text = std::fs::read_to_string(path).unwrap();
    assert_eq!(text.lines().count(), 3, "{text}");
    assert!(!text.contains("GOOD"), "{text}");
}

#[test]
fn clearing_says_how_many_and_undo_brings_them_back() {
    let mut window = three();
    click(&mut window, Role::Button, "Menu");
    click(&mut window, Role::Button, "Clear history");
    window.get_by_label("3 checks removed from the history. Undo (Ctrl+Z) brings them back.");
    assert!(rows(&window).is_empty());
    click(&mut window, Role::Button, "Menu");
    click(&mut window, Role::Button, "Undo: clear history");
    assert_eq!(parts(&window), "B A2 A10");
    assert!(window.query_by_label_contains("removed from the history").is_none());
}

#[test]
fn a_notice_undoes_what_it_tells_of_by_its_button_and_by_key() {
    let undo_by: [fn(&mut Harness<'_, App>); 3] = [
        |window| click(window, Role::Button, "Undo"),
        |window| press(window, Key::Space),
        |window| {
            window.key_press_modifiers(Modifiers::COMMAND, Key::Z);
            window.run();
        },
    ];
    for undo in undo_by {
        let mut window = three();
        click(&mut window, Role::Button, "Menu");
        click(&mut window, Role::Button, "Clear history");
        assert!(rows(&window).is_empty());
        window.get_by_role_and_label(Role::Button, "Undo").focus();
        window.run();
        undo(&mut window);
        assert_eq!(parts(&window), "B A2 A10");
        assert!(window.state().session().notices().is_empty());
    }
}

#[test]
fn a_notice_offers_no_undo_once_something_else_would_be_undone() {
    let mut window = window();
    let rows_of = import(
        "lot.csv",
        format!("id,callout,measured\n{THREE}").as_bytes(),
        window.state().session().sources(),
        now(),
    );
    let ctx = window.ctx.clone();
    let read = CheckCommand::Imported { name: "lot.csv".to_owned(), result: Ok(Box::new(rows_of)) };
    window.state_mut().send(&ctx, read.into());
    window.run();
    window.get_by_role_and_label(Role::Button, "Undo");
    check(&mut window, "25 H7", "25.012");
    window.get_by_label_contains("lot.csv:");
    assert!(window.query_by_role_and_label(Role::Button, "Undo").is_none());
    // Once the newer check is gone, the import can be undone again.
    let ctx = window.ctx.clone();
    window.state_mut().send(&ctx, CheckCommand::Undo.into());
    window.run();
    click(&mut window, Role::Button, "Undo");
    assert!(rows(&window).is_empty());
}

#[test]
fn ctrl_z_undoes_the_history_on_other_pages_unless_a_text_field_takes_it() {
    for (page, field) in [(Key::Num1, "Callout"), (Key::Num4, "Fit of hole and shaft")] {
        let mut window = three();
        press_ctrl(&mut window, page);
        type_into(&mut window, field, "30 H7");
        press_ctrl(&mut window, Key::Z);
        assert_eq!(window.state().session().history().len(), 3, "{field}: the field undoes its own edit");
    }
    for (page, told) in [(Key::Num1, false), (Key::Num4, true), (Key::Num7, true), (Key::Num8, true)] {
        let mut window = three();
        press_ctrl(&mut window, page);
        let focus = window.ctx.memory(eframe::egui::Memory::focused);
        window.ctx.memory_mut(|memory| focus.into_iter().for_each(|id| memory.surrender_focus(id)));
        window.run();
        press_ctrl(&mut window, Key::Z);
        assert_eq!(window.state().session().history().len(), 0, "{page:?}");
        assert_eq!(window.query_by_label("Undone: add 3 checks").is_some(), told, "{page:?}");
    }
    let mut window = three();
    press_ctrl(&mut window, Key::Num6);
    window.get_by_role(Role::Grid).focus();
    window.run();
    press_ctrl(&mut window, Key::Z);
    assert_eq!(window.state().session().history().len(), 3, "the table page undoes edits of its own");
}

#[test]
fn a_value_that_comes_back_from_the_history_stands_there_as_it_was_typed() {
    let mut window = window();
    for typed in ["25,03", "25.012", "25"] {
        check(&mut window, "25 H7", typed);
    }
    let value = |window: &Harness<'_, App>| {
        window.get_by_role_and_label(Role::TextInput, "Measured value").accesskit_node().value().unwrap_or_default()
    };
    let listed = rows(&window);
    for (row, typed) in listed.iter().zip(["25", "25.012", "25,03"]) {
        click(&mut window, Role::Row, row);
        assert_eq!(value(&window), typed);
    }
}

/// A window with a measured and a simulated check of the same callout.
fn simulated(size: Vec2) -> Harness<'static, App> {
    let mut window = Window { size, ..Window::default() }.open();
    check(&mut window, "25 H7", "25.012");
    click(&mut window, Role::RadioButton, "Simulate");
    click(&mut window, Role::Button, "Measure");
    window
}

#[test]
fn a_simulated_check_says_so_in_its_row_and_in_the_strip() {
    let window = simulated(vec2(1280.0, 800.0));
    let rows = rows(&window);
    assert!(rows[0].contains(", SIMULATED GOOD, "), "{rows:?}");
    assert!(rows[1].contains(", GOOD, ") && !rows[1].contains("SIMULATED"), "{rows:?}");
    let window = simulated(vec2(1024.0, 600.0));
    window.get_by_label_contains("SIMULATED GOOD, 25 H7, ");
    window.get_by_label("GOOD, 25 H7, 25.012 mm");
}

#[test]
fn touch_alone_shows_and_chooses_a_check() {
    let mut window = three();
    let row = rows(&window).remove(1);
    click(&mut window, Role::Row, &row);
    assert_eq!(shown(&window), "A2");
    click(&mut window, Role::CheckBox, "Choose A2 25 H7 24.9980 mm of 2026-11-21 10:42:07 for export");
    window.get_by_label("1 chosen for export");
    assert_eq!(shown(&window), "A2", "choosing shows nothing else");
}

#[test]
fn ten_thousand_checks_are_walked_and_only_those_in_sight_are_drawn() {
    let mut window = window();
    let lot: Vec<_> = (0..10_000).map(|number| format!("P{number},25 H7,25.0{:02}\n", number % 40)).collect();
    read(&mut window, &lot.concat());
    window.get_by_label("10000 checks");
    assert!(rows(&window).len() < 20, "{} rows", rows(&window).len());
    focus_list(&mut window);
    press(&mut window, Key::End);
    assert!(cursor(&window).contains(", P0, "), "{}", cursor(&window));
    assert!(rows(&window).len() < 20, "{} rows", rows(&window).len());
    // Nothing moves, and an idle window asks for no repaint.
    assert_eq!(window.output().viewport_output[&ViewportId::ROOT].repaint_delay, Duration::MAX);
    type_into(&mut window, "Filter", "P777");
    window.get_by_label("11 of 10000 checks");
}

#[test]
fn the_list_speaks_the_language_of_the_window() {
    let mut window = Window { language: Language::Nl, ..Window::default() }.open();
    read(&mut window, THREE);
    assert_eq!(
        rows(&window)[0],
        "2026-11-21 10:42:07, B, 40 g6, 39,9000 mm, −100 µm, AFGEKEURD, geïmporteerd uit lot.csv"
    );
    click(&mut window, Role::Button, "Gemeten");
    window.get_by_role_and_label(Role::Button, "Gemeten, oplopend gesorteerd");
}

#[test]
fn a_notice_that_asks_for_nothing_leaves_and_one_with_details_stays() {
    let mut window = Window { notices_stay: Some(6.0), ..Window::default() }.open();
    let ctx = window.ctx.clone();
    check(&mut window, "25 H7", "25.012");
    window.state_mut().send(&ctx, CheckCommand::ClearHistory.into());
    window.run_steps(4);
    assert_eq!(window.state().session().notices().len(), 1);
    // A frame of the harness is a quarter of a second.
    window.run_steps(30);
    assert_eq!(window.state().session().notices().len(), 0, "it only said what was done");
    let rows = "id,callout,measured\nA1,25 H7,25.012\nA2,25 H7,here\n";
    let result = Ok(Box::new(import("lot.csv", rows.as_bytes(), window.state().session().sources(), now())));
    window.state_mut().send(&ctx, CheckCommand::Imported { name: "lot.csv".to_owned(), result }.into());
    window.run_steps(60);
    let notices = window.state().session().notices();
    assert!(notices.iter().any(|notice| !notice.details.is_empty()), "{notices:?}");
}
