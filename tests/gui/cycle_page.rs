//! The cycles page: every documented cycle typed into its form, run, stepped and read back.

use std::path::PathBuf;
use std::time::Duration;

use eframe::egui::accesskit::Role;
use eframe::egui::{Color32, FontId, Key, Modifiers, OutputCommand, Rect, TextStyle, Theme, Vec2, ViewportId, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use fitcheck::gui::App;
use fitcheck::probing::cycles::cycle_named;
use fitcheck::session::{Command, CycleField, Page};
use fitcheck::verdict::Status;
use fitcheck::words::{Dialogue, Language};

use crate::harness::{DESK, Window, type_into, unfold, verdict};
use crate::pictures::can_paint;

/// The page, opened by its key.
fn open(window: Window) -> Harness<'static, App> {
    let mut harness = window.open();
    harness.key_press_modifiers(Modifiers::COMMAND, Key::Num7);
    harness.run();
    assert_eq!(harness.state().session().page(), Page::Cycles);
    unfold_all(&mut harness);
    harness
}

/// Opens what is folded away of the form.
fn unfold_all(window: &mut Harness<'_, App>) {
    let words = fitcheck::words::Words::new(window.state().session().language());
    for group in ["position", "probing", "tolerance", "output"] {
        for id in [format!("cycles-group-{group}"), format!("cycles-optional-{group}")] {
            unfold(window, &words.get(&id));
        }
    }
}

fn page() -> Harness<'static, App> {
    open(Window::default())
}

fn click(window: &mut Harness<'_, App>, role: Role, label: &str) {
    window.get_by_role_and_label(role, label).click_accesskit();
    window.run();
}

fn key(window: &mut Harness<'_, App>, modifiers: Modifiers, key: Key) {
    window.key_press_modifiers(modifiers, key);
    window.run();
}

/// Chooses a cycle by its name in the list.
fn choose(window: &mut Harness<'_, App>, name: &str) {
    click(window, Role::ComboBox, "Cycle");
    click(window, Role::Button, name);
    unfold_all(window);
}

/// The name of a parameter's field: its key and the control's question.
fn name(window: &Harness<'_, App>, key: &str) -> String {
    let cycle = window.state().session().cycles().cycle;
    let parameter = cycle.parameter_named(key).unwrap_or_else(|| panic!("no {key}"));
    format!("{}  {}", parameter.key, parameter.question(window.state().session().language().dialogue()))
}

/// Fills the form: fields are typed, choices are picked from their list.
fn fill(window: &mut Harness<'_, App>, settings: &[(&str, &str)]) {
    for (parameter, text) in settings {
        let name = name(window, parameter);
        if window.query_by_role_and_label(Role::ComboBox, &name).is_some() {
            click(window, Role::ComboBox, &name);
            let choice = window.get_all_by_role(Role::Button).find(|node| {
                let label = node.accesskit_node().label().unwrap_or_default();
                label.split("  ").next() == Some(&text.replace('-', "−")) && label.contains("  ")
            });
            choice.unwrap_or_else(|| panic!("no choice {text} for {name}")).click_accesskit();
            window.run();
        } else {
            type_into(window, &name, text);
        }
    }
}

/// The value in the list of results after a key.
fn result(window: &Harness<'_, App>, key: &str) -> String {
    let run = window.state().session().cycles().run.as_ref().expect("a run");
    let found = run.found().unwrap_or_else(|| panic!("{:?}", run.result));
    let found = found.results.iter().find(|found| found.called() == key).expect(key);
    // The list shows it, too.
    window.get_by_label(key);
    found.value.to_string()
}

const BLOCK_427: [(&str, &str); 12] = [
    ("Q263", "+35"),
    ("Q264", "+45"),
    ("Q261", "+5"),
    ("Q320", "+0"),
    ("Q272", "3"),
    ("Q267", "-1"),
    ("Q260", "+20"),
    ("Q281", "1"),
    ("Q288", "+5,1"),
    ("Q289", "+4.95"),
    ("Q309", "0"),
    ("Q330", "+0"),
];

/// The page with the example block of cycle 427, typed.
fn coordinate(window: Window) -> Harness<'static, App> {
    let mut window = open(window);
    choose(&mut window, "427  MEASURE COORDINATE");
    fill(&mut window, &BLOCK_427);
    window
}

/// The page with cycle 422 on a shaft that is a tenth too thick.
fn stud(window: Window) -> Harness<'static, App> {
    let mut window = open(window);
    choose(&mut window, "422  MEAS. CIRCLE OUTSIDE");
    let block = [("Q273", "50"), ("Q274", "50"), ("Q262", "75"), ("Q277", "74.9"), ("Q278", "74.8"), ("Q309", "1")];
    fill(&mut window, &block);
    window
}

/// What the live verdict says of a simulated workpiece, after the word that says so.
fn simulated(window: &Harness<'_, App>) -> String {
    let said = verdict(window);
    let word = ["SIMULATED. ", "GESIMULEERD. "].into_iter().find_map(|word| said.strip_prefix(word));
    word.unwrap_or_else(|| panic!("not said to be simulated: {said}")).to_owned()
}

#[test]
fn the_block_of_cycle_427_is_typed_run_and_read_back() {
    let mut window = coordinate(Window::default());
    assert_eq!(verdict(&window), "No result");
    key(&mut window, Modifiers::NONE, Key::Enter);
    assert_eq!(
        simulated(&window),
        "GOOD. 5.0000 mm. measured coordinate. 50.0 µm above minimum. 100.0 µm below maximum"
    );
    assert_eq!((result(&window, "Q160"), result(&window, "Q180")), ("5".to_owned(), "1".to_owned()));
    window.get_by_label_contains("COORDINATE STATUS: GOOD");
    window.get_by_label("The control writes TCHPR427.TXT");
    window.get_by_role_and_label(Role::Button, "Save log…");
    window.get_by_label_contains("an outside dimension is assumed");
}

/// Runs the cycle and compares the picture.
fn picture(name: &str, open: fn(Window) -> Harness<'static, App>, theme: Theme, size: Vec2) {
    if can_paint(name) {
        let mut window = open(Window { size, theme, ..Window::default() });
        key(&mut window, Modifiers::NONE, Key::Enter);
        window.remove_cursor();
        window.snapshot(name);
    }
}

#[test]
fn a_coordinate_in_light() {
    picture("cycle_427_light", coordinate, Theme::Light, DESK);
}

#[test]
fn a_stud_to_rework_in_dark() {
    picture("cycle_422_dark", stud, Theme::Dark, DESK);
}

#[test]
fn a_stud_in_a_small_window() {
    picture("cycle_422_small", stud, Theme::Light, vec2(1024.0, 600.0));
}

#[test]
fn a_simulated_bore_in_light() {
    picture("cycle_421_light", hole, Theme::Light, DESK);
}

#[test]
fn a_point_in_dark() {
    picture("cycle_444_dark", point, Theme::Dark, DESK);
}

#[test]
fn a_circle_of_a_lathe_in_light() {
    picture("cycle_g785_light", lathe, Theme::Light, DESK);
}

/// The page with cycle 421 on a hole that is a little oval and lies a little off.
fn hole(window: Window) -> Harness<'static, App> {
    let mut window = open(window);
    let block = [
        ("Q273", "50"),
        ("Q274", "20"),
        ("Q262", "25"),
        ("Q261", "-5"),
        ("Q275", "25.021"),
        ("Q276", "25"),
        ("Q281", "1"),
    ];
    fill(&mut window, &block);
    click(&mut window, Role::RadioButton, "Simulated");
    click(&mut window, Role::Button, "Match workpiece to cycle");
    click(&mut window, Role::Button, "Workpiece…");
    for (name, text) in [("True diameter", "25.012"), ("Centre, 1st axis", "50.003")] {
        type_into(&mut window, name, text);
    }
    click(&mut window, Role::Button, "Close");
    fill(&mut window, &[("Q273", "50")]);
    window
}

/// The page with cycle 444 on a slanted surface.
fn point(window: Window) -> Harness<'static, App> {
    let mut window = open(window);
    choose(&mut window, "444  PROBING IN 3-D");
    let block = [
        ("Q263", "1"),
        ("Q264", "2"),
        ("Q294", "3"),
        ("Q581", "0"),
        ("Q582", "1"),
        ("Q583", "1"),
        ("QS400", "0.4-0.1"),
    ];
    fill(&mut window, &block);
    window
}

/// The page with the example block of G785.
fn lathe(window: Window) -> Harness<'static, App> {
    let mut window = open(window);
    choose(&mut window, "G785  CIRCLE MEASUREMENT");
    fill(&mut window, &[("R", "0"), ("BR", "0"), ("K", "2"), ("C", "0"), ("RC", "60"), ("I", "0"), ("J", "0")]);
    window
}

#[test]
fn all_other_cycles_are_run_and_read_back() {
    let mut window = lathe(Window::default());
    key(&mut window, Modifiers::NONE, Key::F5);
    assert_eq!(simulated(&window), "No verdict. 2.0000 mm. no limits were given");
    assert_eq!((result(&window, "#i99"), result(&window, "X")), ("2".to_owned(), "0".to_owned()));
    window.get_by_label("No limits of size: the control shows no status window");
    assert_eq!(window.get_all_by_label_contains("3.0 times that of 3 contacts at 120°").count(), 2);

    let mut window = page();
    let block = [("Q273", "50"), ("Q274", "50"), ("Q262", "75"), ("Q275", "75.12"), ("Q276", "74.95"), ("Q423", "3")];
    fill(&mut window, &block);
    click(&mut window, Role::Button, "Run");
    assert!(simulated(&window).starts_with("GOOD. 75.0000 mm. measured diameter. 50.0 µm above minimum"));
    assert_eq!((result(&window, "Q153"), result(&window, "Q151")), ("75".to_owned(), "50".to_owned()));
    assert_eq!(window.state().session().cycles().run.as_ref().unwrap().found().unwrap().contacts.len(), 3);

    let mut window = point(Window::default());
    key(&mut window, Modifiers::NONE, Key::Enter);
    assert!(simulated(&window).starts_with("GOOD. 0.0000 mm. deviation along the normal. 100.0 µm above minimum"));
    assert_eq!((result(&window, "Q183"), result(&window, "Q153")), ("0".to_owned(), "3".to_owned()));
    window.get_by_label_contains("TOLERANCE: 0.4-0.1");
    window.get_by_label("The control writes TCHPR444.html");
}

#[test]
fn a_slot_and_a_boss_are_run_and_read_back() {
    let mut window = page();
    choose(&mut window, "425  MEASURE INSIDE WIDTH");
    fill(&mut window, &[("Q328", "50"), ("Q329", "10"), ("Q272", "1"), ("Q261", "-5"), ("Q311", "20")]);
    fill(&mut window, &[("Q288", "20,1"), ("Q289", "20"), ("Q281", "1")]);
    key(&mut window, Modifiers::NONE, Key::F5);
    let said = simulated(&window);
    assert!(said.starts_with("GOOD. 20.0000 mm. measured width. 0.0 µm above minimum"), "{said}");
    assert_eq!((result(&window, "Q156"), result(&window, "Q157")), ("20".to_owned(), "50".to_owned()));
    window.get_by_label("The control writes TCHPR425.TXT");
    window.get_by_label_contains("CENTRE LINE:  50.0000");

    choose(&mut window, "424  MEAS. RECTAN. OUTS.");
    fill(&mut window, &[("Q273", "50"), ("Q274", "20"), ("Q282", "60"), ("Q283", "40"), ("Q261", "-5")]);
    fill(&mut window, &[("Q284", "59,9"), ("Q285", "59,8")]);
    key(&mut window, Modifiers::NONE, Key::F5);
    let said = simulated(&window);
    assert!(
        said.starts_with("REWORK. 60.0000 mm. Remove 100.0 µm to the nearest limit. measured length, 1st side"),
        "{said}"
    );
    assert_eq!((result(&window, "Q155"), result(&window, "Q181")), ("40".to_owned(), "1".to_owned()));
}

#[test]
fn rework_says_how_much_stops_and_shows_the_control_s_window() {
    let mut window = stud(Window::default());
    let buttons = |window: &Harness<'_, App>| {
        let copies = window.get_all_by_role_and_label(Role::Button, "Copy").map(|node| node.rect());
        copies.min_by(|one, other| one.top().total_cmp(&other.top()))
    };
    let before = buttons(&window);
    key(&mut window, Modifiers::NONE, Key::Enter);
    assert_eq!(buttons(&window), before, "the stop moves nothing above it");
    assert_eq!(
        simulated(&window),
        "REWORK. 75.0000 mm. Remove 100.0 µm to the nearest limit, 50.0 µm per side. measured diameter. \
         100.0 µm above maximum. 150.0 µm to the middle of the zone"
    );
    window.get_by_label("program stop by Q309 = 1: measured diameter 75 mm is above its maximum 74.9 mm: REWORK");
    window.get_by_label_contains("FIT STATUS: REWORK\nCHECKED FIT: 75 (422)\nMINIMUM SIZE:  74.8000");
    assert_eq!(result(&window, "Q181"), "1");
}

#[test]
fn scrap_of_a_simulated_face() {
    let mut window = coordinate(Window::default());
    click(&mut window, Role::RadioButton, "Simulated");
    click(&mut window, Role::Button, "Match workpiece to cycle");
    click(&mut window, Role::Button, "Workpiece…");
    for (name, text) in [("Point Z", "4,9"), ("Surface scatter 1σ", "0"), ("Trigger scatter 1σ", "0")] {
        type_into(&mut window, name, text);
    }
    click(&mut window, Role::Button, "Close");
    key(&mut window, Modifiers::NONE, Key::F5);
    assert_eq!(simulated(&window), "SCRAP. 4.9000 mm. measured coordinate. 50.0 µm below minimum");
    window.get_by_label_contains("COORDINATE STATUS: SCRAP");
    window.get_by_label("Measured on the simulated workpiece, seed 1");
    assert_eq!(result(&window, "Q182"), "1");
    // No verdict stays beside other inputs.
    fill(&mut window, &[("Q289", "4.8")]);
    assert_eq!(verdict(&window), "No result");
    assert!(window.query_by_label_contains("COORDINATE STATUS").is_none());
}

#[test]
fn what_was_typed_is_kept_when_another_cycle_is_chosen() {
    let mut window = coordinate(Window::default());
    choose(&mut window, "421  MEASURE HOLE");
    choose(&mut window, "427  MEASURE COORDINATE");
    let name = name(&window, "Q288");
    let field = window.get_by_role_and_label(Role::TextInput, &name);
    assert_eq!(field.accesskit_node().value().as_deref(), Some("+5,1"));
}

#[test]
fn an_error_stands_beside_its_field_and_the_range_shows_on_focus() {
    let mut window = page();
    fill(&mut window, &[("Q247", "130")]);
    window.get_by_label("Q247 STEPPING ANGLE = 130°: at least 5° in size, at most 120°");
    window.get_by_label("Allowed: ±5 … ±120 °");
    window.get_by_label("90° if left empty");
    fill(&mut window, &[("Q262", "7.5.2")]);
    window.get_by_label("Q262 NOMINAL DIAMETER: 7.5.2 is not a number");
    window.get_by_label("Required");
    key(&mut window, Modifiers::NONE, Key::Enter);
    assert_eq!(verdict(&window), "Not measured. 4 fields cannot be used: see the form");
    window.get_by_label("Q273 CENTER IN 1ST AXIS is missing");
    // Its drawing describes itself.
    window.get_by_role_and_label(Role::Image, "Q262: nominal diameter");
}

#[test]
fn predef_asks_what_it_stands_for() {
    let mut window = coordinate(Window::default());
    fill(&mut window, &[("Q320", "predef")]);
    window.get_by_label("PREDEF: type the value that GLOBAL DEF gives");
    type_into(&mut window, "Q320  PREDEF stands for", "4");
    key(&mut window, Modifiers::NONE, Key::Enter);
    assert!(simulated(&window).starts_with("GOOD"), "{}", simulated(&window));
}

#[test]
fn the_path_is_stepped_by_button_by_key_and_by_slider() {
    let mut window = coordinate(Window::default());
    key(&mut window, Modifiers::NONE, Key::Enter);
    window.get_by_label("5 of 5: leave, from X 35  Y 45  Z 7 to X 35  Y 45  Z 20");
    click(&mut window, Role::Button, "First");
    window.get_by_label("1 of 5: pre-position, contact 1, from X 35  Y 45  Z 20 to X 35  Y 45  Z 7");
    click(&mut window, Role::Button, "Next");
    window.get_by_label("2 of 5: approach, contact 1, from X 35  Y 45  Z 7 to X 35  Y 45  Z 5");
    key(&mut window, Modifiers::ALT, Key::ArrowRight);
    window.get_by_label("3 of 5: contact 1, at X 35  Y 45  Z 5");
    key(&mut window, Modifiers::ALT, Key::ArrowLeft);
    window.get_by_label_contains("2 of 5: approach");
    key(&mut window, Modifiers::ALT, Key::End);
    window.get_by_label_contains("5 of 5: leave");
    key(&mut window, Modifiers::ALT, Key::Home);
    window.get_by_label_contains("1 of 5: pre");
    window.get_by_role_and_label(Role::Slider, "Move").focus();
    window.run();
    key(&mut window, Modifiers::NONE, Key::ArrowRight);
    window.get_by_label_contains("2 of 5: approach");
    click(&mut window, Role::Button, "Last");
    click(&mut window, Role::Button, "Back");
    window.get_by_label_contains("4 of 5: retract");
}

#[test]
fn recorded_contacts_are_opened_and_measured() {
    let folder = tempfile::tempdir().unwrap();
    let path: PathBuf = folder.path().join("bore.csv");
    let csv = "x,y,z,remark\n12.5,0,0,a\n0,12.502,0,b\n-12.5,0,0,c\n0,-12.502,0,d\n1,1,1,e\n";
    fitcheck::files::write(&path, csv.as_bytes()).unwrap();
    let mut window = page();
    fill(&mut window, &[("Q273", "0"), ("Q274", "0"), ("Q262", "25"), ("Q275", "25.021"), ("Q276", "25")]);
    click(&mut window, Role::RadioButton, "Recorded");
    window.get_by_label("no file yet");
    click(&mut window, Role::Button, "Contacts…");
    type_into(&mut window, "File", &path.display().to_string());
    key(&mut window, Modifiers::NONE, Key::Enter);
    window.get_by_label("Contacts of bore.csv are used");
    window.get_by_label("column remark is skipped");
    click(&mut window, Role::Button, "Close");
    window.get_by_label("5 contacts, bore.csv");
    key(&mut window, Modifiers::NONE, Key::F5);
    assert!(verdict(&window).starts_with("GOOD. 25.0020 mm"), "{}", verdict(&window));
    assert_eq!(result(&window, "Q153"), "25.002");
    window.get_by_label("The cycle left one contact of the file unused");
    window.get_by_label("Contacts from bore.csv");
    window.get_by_label("Criteria side by side");
}

#[test]
fn the_workpiece_is_bent_saved_and_opened_again() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("bore.toml");
    let mut window = hole(Window::default());
    key(&mut window, Modifiers::NONE, Key::F5);
    let before = result(&window, "Q153");
    click(&mut window, Role::Button, "Workpiece…");
    type_into(&mut window, "True diameter", "-1");
    window.get_by_label("diameter = −1: at least 0.001, at most 100000");
    type_into(&mut window, "True diameter", "25.012");
    click(&mut window, Role::Button, "Save…");
    type_into(&mut window, "File", &path.display().to_string());
    key(&mut window, Modifiers::NONE, Key::Enter);
    let ctx = window.ctx.clone();
    window.state_mut().send(&ctx, Command::Close);
    window.run();
    type_into(&mut window, "True diameter", "24.9");
    click(&mut window, Role::Button, "Open…");
    type_into(&mut window, "File", &path.display().to_string());
    key(&mut window, Modifiers::NONE, Key::Enter);
    let field = window.get_by_role_and_label(Role::TextInput, "True diameter");
    assert_eq!(field.accesskit_node().value().as_deref(), Some("25.012"));
    click(&mut window, Role::Button, "Close");
    key(&mut window, Modifiers::NONE, Key::F5);
    assert_eq!(result(&window, "Q153"), before, "the same seed gives the same result");
    click(&mut window, Role::Button, "Workpiece…");
    for kind in ["Shaft", "Face", "Free surface point", "Slot", "Ridge", "Pocket", "Boss", "Hole"] {
        click(&mut window, Role::RadioButton, kind);
        assert!(window.state().session().workpiece().simulation.is_some(), "{kind}");
    }
    click(&mut window, Role::RadioButton, "Z/X");
    assert_eq!(window.state().session().workpiece().plane, fitcheck::probing::cycle::Plane::Zx);
}

#[test]
fn a_block_is_pasted_and_copied() {
    let mut window = page();
    click(&mut window, Role::Button, "Paste NC block…");
    let block =
        "TCH PROBE 427 MISURAZ. COORDINATA ~ Q263=+35 ;1. PUNTO ~ Q264=+45 ~ Q261=+5 ~ Q272=+3 ~ Q267=-1 ~ Q9=+1";
    window.get_by(|node| node.role() == Role::MultilineTextInput).type_text(block);
    window.run();
    click(&mut window, Role::Button, "Fill the form");
    let known = cycle_named("427").unwrap().parameters.iter().map(|parameter| parameter.key.to_string());
    let known = known.collect::<Vec<_>>().join(", ");
    window.get_by_label(&format!("line 1: cycle 427 has no parameter Q9: its parameters are {known}"));
    for _ in 0.." ~ Q9=+1".len() {
        window.key_press(Key::Backspace);
    }
    window.run();
    click(&mut window, Role::Button, "Fill the form");
    assert_eq!(window.state().session().cycles().cycle.code, "427");
    key(&mut window, Modifiers::NONE, Key::F5);
    assert_eq!(result(&window, "Q160"), "5");
    window.get_by_role_and_label(Role::Button, "Copy as NC block").click_accesskit();
    // Only the frame of the click has the text.
    let copied = (0..4).find_map(|_| {
        window.step();
        window.output().platform_output.commands.iter().find_map(|command| match command {
            OutputCommand::CopyText(text) => Some(text.clone()),
            _ => None,
        })
    });
    assert!(copied.unwrap().starts_with("TCH PROBE 427 MEASURE COORDINATE ~\n    Q263=+35"), "copied");
}

#[test]
fn the_dialog_for_a_block_keeps_its_size_and_the_keys_of_the_page() {
    let mut window = coordinate(Window::default());
    let behind = window.get_by_role_and_label(Role::ComboBox, "Probe").rect().center();
    click(&mut window, Role::Button, "Paste NC block…");
    let field = |window: &Harness<'_, App>| window.get_by(|node| node.role() == Role::MultilineTextInput).rect();
    let place = |window: &Harness<'_, App>| window.get_by_role_and_label(Role::Button, "Fill the form").rect();
    window.run();
    let before = place(&window);
    let block = "TCH PROBE 427 MEASURE COORDINATE ~\n".repeat(40);
    window.get_by(|node| node.role() == Role::MultilineTextInput).type_text(&block);
    window.run();
    assert_eq!(place(&window), before, "a long block scrolls");
    click(&mut window, Role::Button, "Fill the form");
    assert!(window.state().session().cycles().block_problem.is_some());
    assert_eq!(place(&window), before, "there is room for what is wrong");
    assert!(field(&window).height() > before.height());
    // Nothing on the page is reached while it is open.
    key(&mut window, Modifiers::COMMAND, Key::Num1);
    key(&mut window, Modifiers::NONE, Key::F5);
    let session = window.state().session();
    assert!(session.page() == Page::Cycles && session.cycles().run.is_none());
    window.hover_at(behind);
    window.drag_at(behind);
    window.drop_at(behind);
    window.run();
    assert!(window.query_by_label("Own touch-probe table…").is_none());
    key(&mut window, Modifiers::NONE, Key::Escape);
    assert!(window.state().session().cycles().block.is_none());
}

#[test]
fn a_probe_is_chosen_from_a_table() {
    let mut window = coordinate(Window::default());
    click(&mut window, Role::ComboBox, "Probe");
    click(&mut window, Role::Button, "Own touch-probe table…");
    let table = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/data/samples/tables/tchprobe.tp");
    type_into(&mut window, "File", table);
    key(&mut window, Modifiers::NONE, Key::Enter);
    click(&mut window, Role::ComboBox, "Probe");
    click(&mut window, Role::Button, "2");
    window.get_by_label("SET_UP 1.5 mm, DIST 6 mm");
    key(&mut window, Modifiers::NONE, Key::F5);
    click(&mut window, Role::Button, "First");
    window.get_by_label_contains("to X 35  Y 45  Z 6.5");
}

#[test]
fn the_page_works_by_key_alone_and_in_dutch() {
    let mut window = open(Window { language: Language::Nl, ..Window::default() });
    assert!(focused(&window).starts_with("Q273"), "{}", focused(&window));
    for (next, text) in ["50", "50", "75"].into_iter().enumerate() {
        if 0 < next {
            key(&mut window, Modifiers::NONE, Key::Tab);
        }
        let now = focused(&window);
        window.get_by_role_and_label(Role::TextInput, &now).type_text(text);
        window.run();
    }
    key(&mut window, Modifiers::NONE, Key::Enter);
    assert_eq!(
        simulated(&window),
        "Geen oordeel. 75,0000 mm. geen grenzen opgegeven; een besturing meldt dan binnen de tolerantie"
    );
    let chooser = window.get_by_role_and_label(Role::ComboBox, "Cyclus");
    assert_eq!(chooser.accesskit_node().value().as_deref(), Some("421  METEN BORING"));
    window.get_by_label_contains("17 van 17: vrijzetten");
    // The settled page asks for no repaint.
    let delay = window.output().viewport_output[&ViewportId::ROOT].repaint_delay;
    assert_eq!(delay, Duration::MAX);
}

/// The name of the widget that has the focus.
#[expect(clippy::redundant_closure_for_method_calls, reason = "the method alone is not general over lifetimes")]
fn focused(window: &Harness<'_, App>) -> String {
    window.get_by(|node| node.is_focused()).accesskit_node().label().unwrap_or_default()
}

#[test]
fn parameters_without_effect_are_folded_away() {
    let mut window = coordinate(Window::default());
    let name = name(&window, "Q531");
    assert!(window.query_by_label(&name).is_none());
    window.get_by_label("Accepted without effect").click_accesskit();
    window.run();
    type_into(&mut window, &name, "5");
    key(&mut window, Modifiers::NONE, Key::Enter);
    window.get_by_label("Q531 is accepted but has no effect");
}

#[test]
fn the_keypad_types_into_a_parameter_and_runs() {
    let mut window = coordinate(Window::default());
    click(&mut window, Role::Button, "Keypad");
    fill(&mut window, &[("Q288", "5")]);
    for pressed in ["Decimal sign", "Key 2", "Enter"] {
        click(&mut window, Role::Button, pressed);
    }
    let session = window.state().session();
    assert_eq!(session.text(CycleField::Parameter(288.into())), "5.2");
    assert!(simulated(&window).starts_with("GOOD"), "{}", simulated(&window));
}

#[test]
fn choices_are_made_by_typing_their_number_too() {
    let mut window = page();
    choose(&mut window, "427  MEASURE COORDINATE");
    for (parameter, typed, chosen) in [("Q272", "3", "3"), ("Q267", "-", "-1"), ("Q267", "1", "1"), ("Q272", "7", "3")]
    {
        let name = name(&window, parameter);
        window.get_by_role_and_label(Role::ComboBox, &name).focus();
        window.run();
        window.get_by_role_and_label(Role::ComboBox, &name).type_text(typed);
        window.run();
        let key = window.state().session().cycles().cycle.parameter_named(parameter).unwrap().key;
        assert_eq!(window.state().session().text(CycleField::Parameter(key)), chosen, "{parameter} {typed}");
    }
}

#[test]
fn the_workpiece_s_dialog_takes_the_focus_and_is_whole_at_once() {
    let mut window = page();
    click(&mut window, Role::RadioButton, "Simulated");
    click(&mut window, Role::Button, "Workpiece…");
    assert_eq!(focused(&window), "Hole");
    let close = |window: &Harness<'_, App>| window.get_by_role_and_label(Role::Button, "Close").rect();
    let settled = close(&window);
    window.step();
    assert_eq!(close(&window), settled);
    key(&mut window, Modifiers::NONE, Key::Escape);
    assert!(!window.state().session().workpiece_is_open());
    // The focus is back where the dialog was opened from.
    assert_eq!(focused(&window), "Workpiece…");
}

#[test]
fn a_choice_by_key_keeps_the_focus_on_its_list() {
    let mut window = page();
    for (list, downs) in [("Cycle", 1), ("Q301  Move to clearance height (0/1)?", 1), ("Probe", 0)] {
        window.get_by_role_and_label(Role::ComboBox, list).focus();
        window.run();
        key(&mut window, Modifiers::NONE, Key::Space);
        for _ in 0..=downs {
            key(&mut window, Modifiers::NONE, Key::Tab);
        }
        key(&mut window, Modifiers::NONE, Key::Space);
        assert_eq!(focused(&window), list);
    }
    assert_eq!(window.state().session().cycles().cycle.code, "422");
    assert_eq!(window.state().session().text(CycleField::Parameter(301.into())), "1");
}

#[test]
fn what_gets_the_focus_is_scrolled_into_view() {
    let mut window = open(Window { size: vec2(1024.0, 600.0), ..Window::default() });
    let bottom = "Q365  Type of traverse? Line=0/arc=1";
    let mut tabs = 0;
    while focused(&window) != bottom {
        key(&mut window, Modifiers::NONE, Key::Tab);
        tabs += 1;
        assert!(tabs < 30, "{}", focused(&window));
        #[expect(clippy::redundant_closure_for_method_calls, reason = "the method alone is not general over lifetimes")]
        let rect = window.get_by(|node| node.is_focused()).rect();
        assert!(rect.bottom() <= 600.0, "{} at {rect}", focused(&window));
    }
}

#[test]
fn predef_can_be_chosen_where_there_is_a_list() {
    let mut window = hole(Window::default());
    let name = name(&window, "Q301");
    click(&mut window, Role::ComboBox, &name);
    click(&mut window, Role::Button, "PREDEF");
    let session = window.state().session();
    assert_eq!(session.text(CycleField::Parameter(301.into())), "PREDEF");
    assert!(session.cycles().is_predef(301.into()));
    assert!(session.error(CycleField::Global(301.into())).is_some());
    type_into(&mut window, "Q301  PREDEF stands for", "1");
    assert!(window.state().session().cycles().is_complete());
}

#[test]
fn a_run_that_cannot_begin_leads_to_the_first_field_that_is_wrong() {
    let mut window = open(Window { size: vec2(1024.0, 600.0), ..Window::default() });
    fill(&mut window, &[("Q273", "50"), ("Q262", "75"), ("Q280", "x"), ("Q275", "75")]);
    key(&mut window, Modifiers::NONE, Key::Enter);
    assert_eq!(focused(&window), name(&window, "Q274"));
    window.get_by_role_and_label(Role::TextInput, &name(&window, "Q274")).type_text("50");
    key(&mut window, Modifiers::NONE, Key::F5);
    assert_eq!(focused(&window), name(&window, "Q280"));
    // Typing replaces the text of the field.
    window.get_by_role_and_label(Role::TextInput, &name(&window, "Q280")).type_text("0,1");
    click(&mut window, Role::Button, "Run");
    assert!(simulated(&window).starts_with("GOOD"), "{}", simulated(&window));
    assert_eq!(window.state().session().text(CycleField::Parameter(280.into())), "0,1");
}

#[test]
fn result_parameters_show_all_their_digits_with_the_decimal_signs_below_each_other() {
    let mut window = hole(Window::default());
    fill(&mut window, &[("Q275", ""), ("Q276", "")]);
    key(&mut window, Modifiers::NONE, Key::Enter);
    let found = window.state().session().cycles().run.as_ref().unwrap().found().unwrap().clone();
    let lengths = found.results.iter().filter_map(|found| match found.value {
        fitcheck::probing::cycle::Value::Length(length) => Some(length),
        _ => None,
    });
    let lengths: Vec<_> = lengths.collect();
    assert_eq!(lengths.len(), 6);
    for length in lengths {
        let text = format!("{} mm", length.exact(fitcheck::length::Unit::Millimetre, 6)).replace('-', "\u{2212}");
        window.get_by_label(&text);
    }
    // The card rounds to 0.1 µm with and without limits.
    let said = simulated(&window);
    let figure = said.split_once(". ").and_then(|(_, rest)| rest.split_once(" mm")).map(|(figure, _)| figure).unwrap();
    assert_eq!(figure.split_once('.').map(|(_, decimals)| decimals.len()), Some(4), "{said}");
}

/// Whether a quiet text is drawn whole: as high as its words are in its width. One that was cut is too low.
#[track_caller]
fn assert_whole(window: &Harness<'_, App>, text: &str, rects: &[Rect]) {
    let size = window.ctx.global_style().text_styles[&TextStyle::Small].size;
    let font = FontId::proportional(size);
    let needed = |width| {
        let text = text.to_owned();
        window.ctx.fonts_mut(|fonts| fonts.layout(text, font.clone(), Color32::PLACEHOLDER, width).size())
    };
    for rect in rects {
        let within = needed(rect.width() + 1.0);
        assert!(within.y <= rect.height() + 1.0, "{text} is cut: {rect:?}, needs {within:?}");
    }
}

#[test]
fn the_names_of_questions_and_results_are_whole_in_every_language() {
    for language in Dialogue::ALL.map(Dialogue::language) {
        let mut window = page_with_421(Window { language, ..Window::default() });
        key(&mut window, Modifiers::NONE, Key::Enter);
        let words = fitcheck::words::Words::new(language);
        for found in &window.state().session().cycles().run.as_ref().unwrap().found().unwrap().results {
            // The verdict may say it, too, in larger type.
            let name = words.told(&found.name);
            let rects: Vec<_> = window.get_all_by_label(&name).map(|node| node.rect()).collect();
            assert_whole(&window, &name, &rects);
        }
        let cycle = window.state().session().cycles().cycle;
        for parameter in cycle.parameters.iter().filter(|parameter| parameter.has_effect) {
            let name = name(&window, &parameter.key.to_string());
            let field = window
                .get_by(|node| {
                    [Role::TextInput, Role::ComboBox].contains(&node.role()) && node.label() == Some(name.clone())
                })
                .rect();
            let label = window.get_by(|node| node.role() == Role::Label && node.value() == Some(name.clone())).rect();
            assert_whole(&window, &name, &[label]);
            let is_beside = label.right() <= field.left() && label.y_range().contains(field.center().y);
            // A long one has a line of its own.
            let is_above = label.bottom() <= field.top() && field.top() < label.bottom() + 8.0 && label.height() < 20.0;
            assert!(is_beside || is_above, "{name}: {label:?} {field:?}");
        }
    }
}

#[test]
fn required_default_and_given_values_are_told_apart() {
    let mut window = page();
    let said = |window: &Harness<'_, App>, key: &str| {
        let name = name(window, key);
        let node = window.get_by_role_and_label(Role::TextInput, &name);
        let node = node.accesskit_node();
        let placeholder = node.placeholder().unwrap_or_default().to_owned();
        (placeholder, node.data().description().unwrap_or_default().to_owned(), node.is_required())
    };
    assert_eq!(said(&window, "Q273"), ("required".into(), "Required".into(), true));
    assert_eq!(said(&window, "Q325"), ("0".into(), "0° if left empty".into(), false));
    fill(&mut window, &[("Q273", "50"), ("Q325", "0")]);
    for key in ["Q273", "Q325"] {
        assert_eq!(said(&window, key), (String::new(), String::new(), false), "{key}");
    }
    // An error is said in place of it.
    fill(&mut window, &[("Q325", "x")]);
    assert!(said(&window, "Q325").1.contains("x is not a number"));
}

#[test]
fn the_criteria_are_in_sight_after_a_run_without_scrolling() {
    for language in Dialogue::ALL.map(Dialogue::language) {
        let mut window = page_with_421(Window { language, ..Window::default() });
        key(&mut window, Modifiers::NONE, Key::Enter);
        let words = fitcheck::words::Words::new(language);
        for id in ["contacts", "cycles-criteria", "cycle-picture-least-squares", "cycle-picture-zone"] {
            let rect = window.get_by_label(&words.get(id)).rect();
            assert!(0.0 <= rect.top() && rect.bottom() <= DESK.y, "{language:?} {id}: {rect:?}");
        }
        let last = window.get_all_by_label_contains("2–4").map(|node| node.rect().bottom()).fold(0.0, f32::max);
        assert!(0.0 < last && last <= DESK.y, "{language:?}: {last}");
    }
}

/// Cycle 421 on a perfect part, in any language.
fn page_with_421(window: Window) -> Harness<'static, App> {
    let mut window = open(window);
    let block = [("Q273", "50"), ("Q274", "20"), ("Q262", "25"), ("Q261", "-5"), ("Q275", "25.021"), ("Q276", "25")];
    fill(&mut window, &block);
    window
}

#[test]
fn no_button_moves_when_a_result_comes() {
    for language in Dialogue::ALL.map(Dialogue::language) {
        let mut window = page_with_421(Window { language, ..Window::default() });
        let places = |window: &Harness<'_, App>| -> Vec<_> {
            let nodes = [Role::Button, Role::ComboBox, Role::RadioButton, Role::TextInput]
                .into_iter()
                .flat_map(|role| window.get_all_by_role(role).collect::<Vec<_>>());
            nodes.map(|node| (node.accesskit_node().label().unwrap_or_default(), node.rect())).collect()
        };
        let before = places(&window);
        key(&mut window, Modifiers::NONE, Key::Enter);
        let after = places(&window);
        for place in before {
            assert!(after.contains(&place), "{language:?}: {place:?} has moved, {after:#?}");
        }
    }
}

#[test]
fn the_card_keeps_its_height_whatever_the_verdict_is() {
    for (size, language) in [
        (DESK, Language::En),
        (DESK, Language::Nl),
        (vec2(1920.0, 1080.0), Language::En),
        (vec2(1024.0, 600.0), Language::Nl),
    ] {
        let mut window = page_with_421(Window { size, language, ..Window::default() });
        let words = fitcheck::words::Words::new(language);
        let places = |window: &Harness<'_, App>| {
            let name = words.get("copy");
            let copy = window.get_all_by_role_and_label(Role::Button, &name).map(|node| node.rect().top());
            (window.get_by_role(Role::Status).rect(), copy.fold(f32::INFINITY, f32::min))
        };
        let before = places(&window);
        for (minimum, maximum, status) in
            [("25", "25.021", Status::Good), ("25.01", "25.021", Status::Rework), ("24.97", "24.98", Status::Scrap)]
        {
            fill(&mut window, &[("Q276", minimum), ("Q275", maximum)]);
            key(&mut window, Modifiers::NONE, Key::F5);
            let word = words.told(&status);
            assert!(simulated(&window).starts_with(&word), "{}", verdict(&window));
            assert_eq!(places(&window), before, "{word} at {size:?}");
        }
    }
}

#[test]
fn several_values_out_are_told_below_and_the_card_keeps_its_height() {
    for (size, language) in [(DESK, Language::En), (DESK, Language::Nl), (vec2(1024.0, 600.0), Language::En)] {
        let mut window = page_with_421(Window { size, language, ..Window::default() });
        let words = fitcheck::words::Words::new(language);
        click(&mut window, Role::RadioButton, &words.get("cycles-simulated"));
        click(&mut window, Role::Button, &words.get("cycles-suit"));
        fill(&mut window, &[("Q273", "50.1"), ("Q274", "20.2"), ("Q279", "0.05"), ("Q280", "0.05"), ("Q276", "25.01")]);
        let place = |window: &Harness<'_, App>| window.get_by_role(Role::Status).rect();
        let before = place(&window);
        key(&mut window, Modifiers::NONE, Key::F5);
        assert_eq!(place(&window), before, "at {size:?}");
        let said = verdict(&window);
        let more = match language {
            Language::En => "2 more below",
            _ => "nog 2 hieronder",
        };
        assert!(said.contains(more), "{said}");
        let names: Vec<String> = {
            let found = window.state().session().cycles().run.as_ref().and_then(|run| run.found()).unwrap();
            found.checks.iter().filter(|check| check.is_out()).map(|check| words.told(&check.what)).collect()
        };
        assert_eq!(names.len(), 3, "{names:?}");
        assert!(!said.contains(&words.get("remove-to-limit")), "nothing is removed from scrap: {said}");
        for name in names.iter().filter(|name| !said.contains(*name)) {
            let mut lines = window.query_all_by_label_contains(name);
            let is_told = lines.any(|node| node.accesskit_node().value().is_some_and(|text| text.ends_with(" mm")));
            assert!(is_told, "{name} at {size:?}");
        }
    }
}

#[test]
fn what_has_a_default_is_folded_away_and_its_row_says_what_is_in_force() {
    let mut window = Window::default().open();
    window.key_press_modifiers(Modifiers::COMMAND, Key::Num7);
    window.run();
    let folded = "Probing: Q325 0°, Q247 90°, Q320 0 mm, Q260 50 mm, Q301 0, Q423 4, Q365 1";
    let clearance = name(&window, "Q320");
    assert!(window.query_by_label(&clearance).is_none());
    window.get_by_role_and_label(Role::Button, folded).click_accesskit();
    window.run();
    type_into(&mut window, &clearance, "1.5");
    let changed = folded.replace("Q320 0 mm", "Q320 1.5 mm");
    window.get_by_role_and_label(Role::Button, &changed).click_accesskit();
    window.run();
    assert!(window.query_by_label(&clearance).is_none());
    window.get_by_role_and_label(Role::Button, &changed);
    // Limits make the verdict: they are in sight, though they may be left out.
    window.get_by_role_and_label(Role::TextInput, &name(&window, "Q275"));
}

#[test]
fn a_cycle_is_chosen_by_its_tile_and_found_in_the_palette() {
    let mut window = page();
    click(&mut window, Role::ComboBox, "Cycle");
    let tiles: Vec<_> = window
        .get_all_by_role(Role::Button)
        .filter(|node| node.accesskit_node().label().is_some_and(|label| label.contains("  ") && label.len() < 40))
        .map(|node| (node.accesskit_node().label().unwrap_or_default(), node.rect()))
        .collect();
    assert_eq!(tiles.len(), fitcheck::probing::cycles::CYCLES.len(), "{tiles:?}");
    // Each has room for its picture beside its words.
    assert!(tiles.iter().all(|(_, rect)| 150.0 < rect.width() && 50.0 < rect.height()), "{tiles:?}");
    click(&mut window, Role::Button, "425  MEASURE INSIDE WIDTH");
    assert_eq!(window.state().session().cycles().cycle.code, "425");
    key(&mut window, Modifiers::COMMAND, Key::K);
    window.event(eframe::egui::Event::Text("cycle 423".to_owned()));
    window.run();
    key(&mut window, Modifiers::NONE, Key::Enter);
    assert_eq!(window.state().session().cycles().cycle.code, "423");
}
