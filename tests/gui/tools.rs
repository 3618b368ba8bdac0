//! The tool table in the window: opened, a tool picked for Q330, corrected or locked, saved; by label and key.

use std::path::{Path, PathBuf};

use eframe::egui::accesskit::Role;
use eframe::egui::{Key, Modifiers, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use fitcheck::gui::App;
use fitcheck::words::Language;

use crate::dialogs::Dropped;
use crate::harness::{Window, click, press, type_into, unfold};

type Harnessed = Harness<'static, App>;

const TABLE: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/data/samples/tools/tool_small.t");
const MILL_D10: &str = "3 MILL_D10: L 88.12, R 5, DL 0, DR 0, LBREAK 0.2, RBREAK 0.2 mm";
const CORRECTED: &str = "tool 3 (MILL_D10): DR changed by 0.015 mm, from 0 to 0.015 mm";
const HINT: &str = "The table with these changes. The next run begins with the table as it was opened.";

/// Types a path into the open dialog and takes it.
fn take_file(page: &mut Harnessed, path: &Path) {
    type_into(page, "File", &path.display().to_string());
    press(page, Key::Enter);
}

/// A program in a folder of its own that measures a hole whose tool is in this line.
fn program(folder: &Path, tool: &str) -> PathBuf {
    let lines = "Q273=+0 Q274=+0 Q262=25 Q325=0 Q247=90 Q261=-4 Q320=0 Q260=20 Q301=0 Q275=25.1 Q276=24.9 Q279=0 Q280=0 Q281=0 Q309=0";
    let lines: Vec<String> = lines.split(' ').chain([tool]).map(|line| format!("   {line}")).collect();
    let text =
        format!("BEGIN PGM own MM\nTOOL CALL 9 Z\nTCH PROBE 421 HOLE ~\n{}\nEND PGM own MM\n", lines.join(" ~\n"));
    let path = folder.join("own.h");
    std::io::Write::write_all(&mut std::fs::File::create(&path).unwrap(), text.as_bytes()).unwrap();
    path
}

/// The program page with that program, on a hole of a diameter.
fn page(folder: &Path, tool: &str, diameter: &str) -> Harnessed {
    let mut page = Window::default().open();
    page.key_press_modifiers(Modifiers::COMMAND, Key::Num8);
    page.run();
    page.key_press_modifiers(Modifiers::COMMAND, Key::O);
    page.run();
    take_file(&mut page, &program(folder, tool));
    click(&mut page, Role::ComboBox, "Workpiece");
    click(&mut page, Role::Button, "perfect, diameter given");
    type_into(&mut page, "True diameter", diameter);
    page
}

fn open_table(page: &mut Harnessed) {
    click(page, Role::ComboBox, "Tool table");
    click(page, Role::Button, "Open a tool table…");
    take_file(page, Path::new(TABLE));
}

fn value(page: &Harnessed, role: Role, label: &str) -> String {
    page.get_by_role_and_label(role, label).accesskit_node().value().unwrap_or_default()
}

#[test]
fn a_tool_is_picked_from_the_table_corrected_and_saved() {
    let folder = tempfile::tempdir().unwrap();
    let mut page = page(folder.path(), "Q330=+Q5", "25.03");
    assert_eq!(value(&page, Role::ComboBox, "Tool table"), "none");
    page.get_by_label("Without a tool table, no tool is monitored (Q330)");
    open_table(&mut page);
    assert_eq!(value(&page, Role::ComboBox, "Tool table"), "tool_small.t, 6 tools");
    click(&mut page, Role::ComboBox, "Q5 from the tool table");
    for tool in ["0", "4 MILL_D16", "5 MILL_D12", "6 MILL_D16_OLD", "9 PROBE"] {
        let begins = format!("{tool}: L ");
        page.get_by(|node| node.role() == Role::Button && node.label().is_some_and(|label| label.starts_with(&begins)));
    }
    page.get_by_label("6 MILL_D16_OLD: L 94.9, R 8, DL 0, DR −0.03, LBREAK 0.2, RBREAK 0.02 mm, locked");
    click(&mut page, Role::Button, MILL_D10);
    assert_eq!(value(&page, Role::TextInput, "Q5 Tool for monitoring (Q330)"), "3");
    // The tool that is picked stays in sight with its lengths and tolerances.
    page.get_by_label(MILL_D10);
    press(&mut page, Key::F5);
    page.get_by_role_and_label(Role::Button, CORRECTED);
    page.get_by_label(HINT);
    click(&mut page, Role::Button, "Save tool table…");
    let new = folder.path().join("new.t");
    take_file(&mut page, &new);
    let before = std::fs::read_to_string(TABLE).unwrap();
    let written = std::fs::read_to_string(&new).unwrap();
    let changed: Vec<_> = before.lines().zip(written.lines()).filter(|(one, other)| one != other).collect();
    assert_eq!(changed.len(), 1, "{changed:?}");
    assert!(changed[0].1.contains("MILL_D10") && changed[0].1.contains("+0.015"), "{changed:?}");
    // Without a table the same run changes nothing.
    press(&mut page, Key::Escape);
    click(&mut page, Role::ComboBox, "Tool table");
    click(&mut page, Role::Button, "No tool table");
    assert!(page.query_by_label(CORRECTED).is_none(), "the run was made with the table");
    press(&mut page, Key::F5);
    assert!(page.query_by_label(CORRECTED).is_none());
}

/// The name of what has the focus.
#[expect(clippy::redundant_closure_for_method_calls, reason = "the method alone is not general over lifetimes")]
fn focused(window: &Harness<'_, App>) -> String {
    window.get_by(|node| node.is_focused()).accesskit_node().label().unwrap_or_default()
}

#[test]
fn a_tool_is_picked_and_typed_by_key_alone() {
    let folder = tempfile::tempdir().unwrap();
    let mut page = page(folder.path(), "Q330=+Q5", "25.03");
    // From the last field that was typed into, in reading order.
    for _ in 0..8 {
        if focused(&page) == "Tool table" {
            break;
        }
        press(&mut page, Key::Tab);
    }
    assert_eq!(focused(&page), "Tool table");
    press(&mut page, Key::Space);
    for _ in 0..60 {
        if focused(&page) == "Open a tool table…" {
            break;
        }
        press(&mut page, Key::Tab);
    }
    press(&mut page, Key::Enter);
    take_file(&mut page, Path::new(TABLE));
    // Typed, and run with Enter.
    type_into(&mut page, "Q5 Tool for monitoring (Q330)", "3");
    press(&mut page, Key::Enter);
    page.get_by_role_and_label(Role::Button, CORRECTED);
    // Picked.
    press(&mut page, Key::Tab);
    assert_eq!(focused(&page), "Q5 from the tool table");
    press(&mut page, Key::Space);
    for _ in 0..60 {
        if focused(&page).starts_with("5 MILL_D12") {
            break;
        }
        press(&mut page, Key::Tab);
    }
    press(&mut page, Key::Enter);
    assert_eq!(value(&page, Role::TextInput, "Q5 Tool for monitoring (Q330)"), "5");
    assert_eq!(focused(&page), "Q5 from the tool table");
    press(&mut page, Key::F5);
    page.get_by_role_and_label(Role::Button, "tool 5 (MILL_D12): DR changed by 0.015 mm, from −0.005 to 0.01 mm");
}

#[test]
fn a_broken_tool_is_said_as_the_control_says_it() {
    let folder = tempfile::tempdir().unwrap();
    let mut page = page(folder.path(), "Q330=4", "25.05");
    page.get_by_label("Q330 = 4 in the program");
    page.input_mut().dropped_files.push(std::sync::Arc::new(Dropped(TABLE.into())));
    page.run();
    page.get_by_label("4 MILL_D16: L 95.4, R 8, DL 0, DR 0, LBREAK 0.2, RBREAK 0.02 mm");
    press(&mut page, Key::F5);
    page.get_by_label_contains("error 1065: tool 4 is broken: DR would change by 0.025 mm, RBREAK is 0.02 mm");
    page.get_by_role_and_label(Role::Button, "tool 4 (MILL_D16): locked, TL = L");
    page.get_by_role_and_label(Role::Button, "Save tool table…");
}

#[test]
fn a_file_that_is_no_tool_table_is_refused_with_its_place() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("bad.t");
    std::io::Write::write_all(&mut std::fs::File::create(&path).unwrap(), b"BEGIN BAD.T MM\nT  L  R\n1  0  0\n[END]\n")
        .unwrap();
    let mut page = page(folder.path(), "Q330=4", "25");
    click(&mut page, Role::ComboBox, "Tool table");
    click(&mut page, Role::Button, "Open a tool table…");
    take_file(&mut page, &path);
    page.get_by_label_contains("the table has no column DL");
    press(&mut page, Key::Escape);
    assert_eq!(value(&page, Role::ComboBox, "Tool table"), "none");
}

/// The cycles page: the operator picks the tool of Q330 from the table.
#[test]
fn the_form_of_a_cycle_picks_its_tool_from_the_table() {
    let mut page = Window::default().open();
    page.key_press_modifiers(Modifiers::COMMAND, Key::Num7);
    page.run();
    click(&mut page, Role::ComboBox, "Cycle");
    click(&mut page, Role::Button, "427  MEASURE COORDINATE");
    for section in ["Probing", "Probing, optional", "Position, optional", "Tolerance, optional", "Output"] {
        unfold(&mut page, section);
    }
    for (name, text) in
        [("Q263", "35"), ("Q264", "45"), ("Q261", "5"), ("Q260", "20"), ("Q288", "5.1"), ("Q289", "4.9")]
    {
        let cycle = page.state().session().cycles().cycle;
        let parameter = cycle.parameter_named(name).unwrap();
        let label = format!("{}  {}", parameter.key, parameter.question(fitcheck::words::Dialogue::En));
        type_into(&mut page, &label, text);
    }
    for name in ["Q272", "Q267"] {
        let cycle = page.state().session().cycles().cycle;
        let parameter = cycle.parameter_named(name).unwrap();
        let label = format!("{}  {}", parameter.key, parameter.question(fitcheck::words::Dialogue::En));
        page.get_by_role_and_label(Role::ComboBox, &label).focus();
        page.run();
        page.event(eframe::egui::Event::Text(if name == "Q272" { "3" } else { "-" }.to_owned()));
        page.run();
    }
    open_table(&mut page);
    assert_eq!(value(&page, Role::ComboBox, "Tool table"), "tool_small.t, 6 tools");
    click(&mut page, Role::ComboBox, "Q330 from the tool table");
    click(&mut page, Role::Button, MILL_D10);
    assert_eq!(value(&page, Role::TextInput, "Q330  Tool for monitoring?"), "3");
    page.get_by_label(MILL_D10);
    press(&mut page, Key::F5);
    page.get_by_label("the measured value does not deviate: the tool is not changed");
}

/// A table of thousands of tools: only the rows in sight are drawn, and the list stays within the window.
#[test]
fn a_long_table_is_listed_as_far_as_it_is_seen() {
    let folder = tempfile::tempdir().unwrap();
    let mut text = "BEGIN TOOL.T MM\nT       NAME            L           R         DL        DR        TL\n".to_owned();
    let row = |number: i32| format!("{number:<8}MILL_{number:<11}+10         +5        +0        +0        0\n");
    text.extend((0..5000).map(row));
    let path = folder.path().join("tool.t");
    std::io::Write::write_all(&mut std::fs::File::create(&path).unwrap(), (text + "[END]\n").as_bytes()).unwrap();
    for (size, language) in [(vec2(1280.0, 800.0), Language::En), (vec2(800.0, 600.0), Language::Nl)] {
        let own = program(folder.path(), "Q330=+Q5");
        let files =
            vec![(fitcheck::session::Purpose::OpenProgram, own), (fitcheck::session::Purpose::OpenTools, path.clone())];
        let mut page = Window { size, language, files, ..Window::default() }.open();
        page.run();
        let words = fitcheck::words::Words::new(language);
        let picker = words.say(&fitcheck::message::Message::new("tools-pick-of").text("parameter", "Q5"));
        click(&mut page, Role::ComboBox, &picker);
        let rows: Vec<_> = page
            .get_all_by_role(Role::Button)
            .filter(|node| node.accesskit_node().label().is_some_and(|label| label.contains("MILL_")))
            .map(|node| node.rect())
            .collect();
        assert!((5..60).contains(&rows.len()), "{}", rows.len());
        assert!(rows.iter().all(|row| row.right() <= size.x && 0.0 <= row.left()), "{size:?}: {rows:?}");
    }
}
