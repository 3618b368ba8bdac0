//! Keys that all come within one frame, as scanners and gauges type: each goes where the focus is after the key before it.

use eframe::egui::accesskit::Role;
use eframe::egui::{Event, Key, Modifiers, PointerButton};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use fitcheck::gui::App;
use fitcheck::part::Column;
use fitcheck::session::PartsAction;
use fitcheck::session::{BudgetCommand, BudgetView, CheckField, Command, Field, FitField, Page, RecordsField};

use crate::harness::{DESK, click, press, scan, settle, unfold, verdict, window};
use crate::walk_page::{begun, put, window_of};

type Harnessed = Harness<'static, App>;

fn text(window: &Harnessed, field: impl Into<Field>) -> String {
    window.state().session().text(field).to_owned()
}

/// A page, opened by its key.
fn page(digit: Key) -> Harnessed {
    let mut window = window();
    window.key_press_modifiers(Modifiers::COMMAND, digit);
    window.run();
    window
}

fn focus(window: &mut Harnessed, name: &str) {
    window.get_by_role_and_label(Role::TextInput, name).focus();
    window.run();
}

#[test]
fn what_is_scanned_behind_a_tab_is_the_measured_value_and_no_part_of_the_callout() {
    let mut window = window();
    scan(&mut window, "25 H7⇥25.012⏎");
    assert_eq!(text(&window, CheckField::Callout), "25 H7");
    assert!(verdict(&window).starts_with("GOOD. 25.012 mm"), "{}", verdict(&window));
    window.get_by_label("1 check");
    // The next values come line by line, and one line at a time is one check.
    scan(&mut window, "25.030⏎");
    assert!(verdict(&window).starts_with("SCRAP. 25.030 mm"), "{}", verdict(&window));
    scan(&mut window, "24.99⏎25.001⏎");
    assert!(verdict(&window).starts_with("GOOD. 25.001 mm"), "{}", verdict(&window));
    window.get_by_label("4 checks");
}

#[test]
fn a_key_behind_a_class_is_no_part_of_the_class() {
    let mut window = window();
    scan(&mut window, "25 H1⇥25.001");
    assert_eq!(
        (text(&window, CheckField::Callout), text(&window, CheckField::Measured)),
        ("25 H1".into(), "25.001".into())
    );
    // Back again, and what stands there is replaced.
    scan(&mut window, "⇤26 H7⇥26");
    assert_eq!(
        (text(&window, CheckField::Callout), text(&window, CheckField::Measured)),
        ("26 H7".into(), "26".into())
    );
}

#[test]
fn several_tabs_are_several_fields() {
    let mut window = window();
    unfold(&mut window, "Part");
    scan(&mut window, "25 H7⇥25.012⇥⇥⇥⇥⇥⇥⇥⇥⇥⇥⇥⇥⇥A7");
    assert_eq!(text(&window, CheckField::Part), "A7", "the field that thirteen single keys lead to");
    assert_eq!(text(&window, CheckField::Callout), "25 H7");
}

#[test]
fn a_click_and_keys_of_one_frame_go_to_what_was_clicked() {
    let mut window = window();
    let at = window.get_by_role_and_label(Role::TextInput, "Measured value").rect().center();
    let button =
        |pressed| Event::PointerButton { pos: at, button: PointerButton::Primary, pressed, modifiers: Modifiers::NONE };
    let events = [Event::PointerMoved(at), button(true), button(false), Event::Text("25.5".to_owned())];
    window.input_mut().events.extend(events);
    settle(&mut window);
    assert_eq!(
        (text(&window, CheckField::Callout), text(&window, CheckField::Measured)),
        (String::new(), "25.5".into())
    );
}

#[test]
fn a_page_is_open_before_the_next_key() {
    let mut window = window();
    let mut events = vec![Event::Text("25 H7".to_owned())];
    let key = |pressed| Event::Key {
        key: Key::Num4,
        physical_key: None,
        pressed,
        repeat: false,
        modifiers: Modifiers::COMMAND,
    };
    events.extend([Event::ModifiersChanged(Modifiers::COMMAND), key(true), key(false)]);
    events.extend([Event::ModifiersChanged(Modifiers::NONE), Event::Text("30 H7/g6".to_owned())]);
    window.input_mut().events.extend(events);
    settle(&mut window);
    assert_eq!(window.state().session().page(), Page::Fit);
    assert_eq!(
        (text(&window, CheckField::Callout), text(&window, FitField::Callout)),
        ("25 H7".into(), "30 H7/g6".into())
    );
}

#[test]
fn hole_and_shaft_of_a_fit_are_two_fields() {
    let mut window = page(Key::Num4);
    scan(&mut window, "25 H7/g6");
    focus(&mut window, "Measured hole");
    scan(&mut window, "25.010⇥24.990");
    let fields = [FitField::Callout, FitField::HoleMeasured, FitField::ShaftMeasured].map(|field| text(&window, field));
    assert_eq!(fields, ["25 H7/g6", "25.010", "24.990"]);
}

#[test]
fn parameters_of_a_cycle_are_a_field_each() {
    let mut slow = page(Key::Num7);
    let mut fast = page(Key::Num7);
    for typed in ["35", "⇥", "45", "⇥", "8", "⇥", "0", "⇥", "90", "⏎"] {
        scan(&mut slow, typed);
    }
    scan(&mut fast, "35⇥45⇥8⇥0⇥90⏎");
    let values = |window: &Harnessed| -> Vec<Option<String>> {
        let fields = window.query_all_by_role(Role::TextInput);
        fields.map(|field| field.accesskit_node().value()).collect()
    };
    assert_eq!(values(&fast), values(&slow));
    assert!(values(&fast).contains(&Some("45".to_owned())), "{:?}", values(&fast));
}

#[test]
fn a_walk_takes_serial_number_and_values_in_one_go() {
    let folder = tempfile::tempdir().unwrap();
    let mut page = window_of(folder.path(), DESK).open();
    focus(&mut page, "Serial number");
    scan(&mut page, "A-0001⏎25.01⏎19.985⏎16.01⏎");
    let walking = &page.state().session().parts().walking;
    assert_eq!(walking.serial(), "A-0001");
    let measured = [0, 1, 2].map(|at| walking.values(at).len());
    assert_eq!(measured, [1, 1, 1]);
    assert_eq!(walking.asked().map(|size| size.name()).as_deref(), Some("RIDGE"));
}

#[test]
fn keys_go_from_the_list_of_sizes_into_the_value() {
    let folder = tempfile::tempdir().unwrap();
    let mut page = begun(folder.path());
    // Escape takes the focus from the field, and what is typed finds it again.
    let ctx = page.ctx.clone();
    ctx.memory_mut(eframe::egui::Memory::stop_text_input);
    page.run();
    scan(&mut page, "25.01⏎");
    assert_eq!(page.state().session().parts().walking.values(0).len(), 1);
}

#[test]
fn cells_of_a_plan_are_typed_one_after_the_other() {
    let folder = tempfile::tempdir().unwrap();
    let mut page = window_of(folder.path(), DESK).open();
    let ctx = page.ctx.clone();
    let show =
        PartsAction::ShowParts(fitcheck::session::parts::PartsView::Plan).command(page.state().session()).unwrap();
    page.state_mut().send(&ctx, show);
    page.run();
    click(&mut page, Role::GridCell, "Row 1, Name, BORE");
    scan(&mut page, "B1⏎B2⏎B3⇥width⏎");
    let document = &page.state().session().parts().document;
    let texts = |column| document.draft().rows.iter().take(3).map(move |row| row.cell(column).text.clone());
    assert_eq!(texts(Column::Name).collect::<Vec<_>>(), ["B1", "B2", "B3"]);
    assert_eq!(texts(Column::Kind).next_back().as_deref(), Some("width"));
}

#[test]
fn a_budget_is_typed_with_its_line_breaks() {
    let mut page = page(Key::Num9);
    let ctx = page.ctx.clone();
    page.state_mut().send(&ctx, BudgetCommand::Edit(String::new()).into());
    page.state_mut().send(&ctx, BudgetCommand::Show(BudgetView::Text).into());
    page.run();
    page.get_by_role_and_label(Role::MultilineTextInput, "Budget as TOML").focus();
    page.run();
    scan(&mut page, "a = 1⏎b = 2⏎");
    assert_eq!(page.state().session().budget().document.text.as_str(), "a = 1\nb = 2\n");
}

#[test]
fn a_question_about_records_is_typed_behind_its_key() {
    let folder = tempfile::tempdir().unwrap();
    let mut page = window_of(folder.path(), DESK).open();
    let ctx = page.ctx.clone();
    page.state_mut().send(&ctx, Command::OpenPage(Page::Records));
    page.run();
    let key =
        |pressed| Event::Key { key: Key::F, physical_key: None, pressed, repeat: false, modifiers: Modifiers::COMMAND };
    page.input_mut().events.extend([key(true), key(false), Event::Text("serial:A-0001".to_owned())]);
    settle(&mut page);
    assert_eq!(text(&page, RecordsField::Question), "serial:A-0001");
}

#[test]
fn a_path_is_typed_into_the_dialog_that_its_key_opens() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("parts.csv");
    put(&path, "id,callout,measured\nA1,25 H7,25.012\n");
    let mut window = window();
    let key =
        |pressed| Event::Key { key: Key::O, physical_key: None, pressed, repeat: false, modifiers: Modifiers::COMMAND };
    let open = [Event::Text("3".to_owned()), key(true), key(false), Event::Text(path.display().to_string())];
    window.input_mut().events.extend(open);
    scan(&mut window, "⏎");
    window.get_by_label_contains("parts.csv: 1 check, no rows refused");
    assert!(verdict(&window).starts_with("GOOD. 25.012 mm"), "{}", verdict(&window));
}

#[test]
fn a_key_that_is_held_runs_through_a_list_without_a_frame_for_each() {
    let mut window = window();
    for value in ["25.001", "25.002", "25.003", "25.004", "25.005"] {
        crate::harness::check(&mut window, "25 H7", value);
    }
    let first = crate::harness::rows(&window)[0].clone();
    window.get_by_label(&first).click();
    window.run();
    let held = |pressed| Event::Key {
        key: Key::ArrowDown,
        physical_key: None,
        pressed,
        repeat: false,
        modifiers: Modifiers::NONE,
    };
    window.input_mut().events.extend([held(true), held(true), held(true), held(false)]);
    window.step();
    press(&mut window, Key::Enter);
    assert!(verdict(&window).contains("25.002 mm"), "{}", verdict(&window));
}
