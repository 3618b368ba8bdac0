//! The plan of a part as a table, by label and key: typing, pasting, undo, faults, the picture and its balloons.

use fitcheck::session::PartsAction;
use std::path::{Path, PathBuf};

use eframe::egui::accesskit::{Invalid, Role};
use eframe::egui::{Event, Key, Modifiers, Theme, Vec2, ViewportId, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use fitcheck::gui::App;
use fitcheck::part::Column;
use fitcheck::session::{Command, Density, Purpose};
use fitcheck::words::Language;

use crate::harness::{DESK, Window, click, press, type_into};
use crate::pictures::can_paint;

type Page = Harness<'static, App>;

const PLATE: &str = "fitcheck_plan = 1
part = \"Plate 7\"
drawing = \"D-1001\"
picture = \"plate.svg\"
travel_x = [0, 500]

[[feature]]
number = 1
name = \"A1\"
callout = \"25 H7\"
x = 40
y = 30
z = -8
balloon_x = 0.25
balloon_y = 0.5

[[feature]]
number = 2
name = \"A2\"
callout = \"20 H7\"
x = 60
y = 30
z = -8
balloon_x = 0.75
balloon_y = 0.5

[[feature]]
number = 3
name = \"A10\"
callout = \"16 H7\"
x = 80
y = 30
z = -8
";

const PICTURE: &str = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"400\" height=\"200\">
<rect x=\"10\" y=\"10\" width=\"380\" height=\"180\" fill=\"#ddd\" stroke=\"black\" stroke-width=\"3\"/>
<circle cx=\"100\" cy=\"100\" r=\"40\" fill=\"white\" stroke=\"black\" stroke-width=\"2\"/>
<circle cx=\"300\" cy=\"100\" r=\"30\" fill=\"white\" stroke=\"black\" stroke-width=\"2\"/>
<text x=\"160\" y=\"105\" font-size=\"20\">Plate 7</text></svg>";

fn put(path: &Path, bytes: &[u8]) {
    std::io::Write::write_all(&mut std::fs::File::create(path).unwrap(), bytes).unwrap();
}

/// A plan in a folder with the picture beside it.
fn folder(text: &str) -> (tempfile::TempDir, PathBuf) {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("plate.toml");
    put(&path, text.as_bytes());
    put(&folder.path().join("plate.svg"), PICTURE.as_bytes());
    (folder, path)
}

/// The view of the plan of a file.
fn open(window: Window, path: &Path) -> Page {
    let files = vec![(Purpose::OpenPlan, path.to_owned())];
    let mut page = Window { files, ..window }.open();
    let ctx = page.ctx.clone();
    let show =
        PartsAction::ShowParts(fitcheck::session::parts::PartsView::Plan).command(page.state().session()).unwrap();
    page.state_mut().send(&ctx, show);
    page.run();
    page
}

fn plate() -> (tempfile::TempDir, Page) {
    let (folder, path) = folder(PLATE);
    (folder, open(Window::default(), &path))
}

fn cell(page: &mut Page, said: &str) {
    click(page, Role::GridCell, said);
}

fn texts(page: &Page, column: Column) -> Vec<String> {
    let document = &page.state().session().parts().document;
    document.draft().rows.iter().map(|row| row.cell(column).text.clone()).collect()
}

/// Types as a keyboard does: whoever has the focus gets it.
fn type_text(page: &mut Page, text: &str) {
    for sign in text.chars() {
        page.input_mut().events.push(Event::Text(sign.to_string()));
        page.step();
    }
    page.run();
}

#[test]
fn cells_are_typed_moved_and_left_by_key() {
    let (_folder, mut page) = plate();
    cell(&mut page, "Row 1, Callout, 25 H7");
    // Typing replaces, Enter goes down; the same again.
    type_text(&mut page, "30 H7");
    press(&mut page, Key::Enter);
    type_text(&mut page, "18 H8");
    press(&mut page, Key::Enter);
    assert_eq!(texts(&page, Column::Callout), ["30 H7", "18 H8", "16 H7"]);
    page.get_by_label("Row 1, Limits, 30.000 … 30.021");
    // F2 goes on with what is there, Escape leaves it as it was.
    press(&mut page, Key::F2);
    type_text(&mut page, "7");
    page.get_by_label_contains("Row 3, Callout, 16 H77, fault:");
    press(&mut page, Key::Escape);
    page.get_by_label("Row 3, Callout, 16 H7");
    // Tab takes what is typed and goes on to the right, Shift+Tab goes back; arrows move, too.
    press(&mut page, Key::ArrowLeft);
    press(&mut page, Key::ArrowLeft);
    type_text(&mut page, "B3");
    press(&mut page, Key::Tab);
    type_text(&mut page, "diameter");
    press(&mut page, Key::Tab);
    page.key_press_modifiers(Modifiers::SHIFT, Key::Tab);
    page.run();
    press(&mut page, Key::Delete);
    assert_eq!(texts(&page, Column::Name)[2], "B3");
    assert_eq!(texts(&page, Column::Kind)[2], "");
    // Undo, step by step: the emptied cell, the kind, the name, two callouts.
    for _ in 0..5 {
        page.key_press_modifiers(Modifiers::COMMAND, Key::Z);
        page.run();
    }
    assert_eq!(texts(&page, Column::Callout), ["25 H7", "20 H7", "16 H7"]);
    assert_eq!(texts(&page, Column::Name), ["A1", "A2", "A10"]);
    assert!(!page.state().session().parts().document.is_unsaved());
    page.key_press_modifiers(Modifiers::COMMAND, Key::Y);
    page.run();
    assert_eq!(texts(&page, Column::Callout)[0], "30 H7");
}

#[test]
fn a_block_is_pasted_from_a_spreadsheet_and_undone_at_once() {
    let (_folder, mut page) = plate();
    cell(&mut page, "Row 3, Name, A10");
    page.input_mut().events.push(Event::Paste("B1\t\t30 H7\r\nB2\twidth\t12 H8\r\nB3\t\t10 H7\r\n".to_owned()));
    page.run();
    assert_eq!(texts(&page, Column::Name), ["A1", "A2", "B1", "B2", "B3"]);
    assert_eq!(texts(&page, Column::Callout)[2..], ["30 H7", "12 H8", "10 H7"]);
    page.get_by_label("Row 5, Limits, 10.000 … 10.015");
    // What is selected is what was pasted, and is copied as it came.
    page.input_mut().events.push(Event::Copy);
    page.step();
    let copied = page.output().platform_output.commands.iter().find_map(|command| match command {
        eframe::egui::OutputCommand::CopyText(text) => Some(text.clone()),
        _ => None,
    });
    assert_eq!(copied.as_deref(), Some("B1\t\t30 H7\nB2\twidth\t12 H8\nB3\t\t10 H7"));
    page.key_press_modifiers(Modifiers::COMMAND, Key::Z);
    page.run();
    assert_eq!(texts(&page, Column::Name), ["A1", "A2", "A10"]);
}

#[test]
fn rows_are_changed_by_buttons() {
    let (_folder, mut page) = plate();
    cell(&mut page, "Row 1, Name, A1");
    click(&mut page, Role::Button, "Move down");
    click(&mut page, Role::Button, "Renumber");
    assert_eq!(texts(&page, Column::Name), ["A2", "A1", "A10"]);
    assert_eq!(texts(&page, Column::Number), ["1", "2", "3"]);
    click(&mut page, Role::Button, "Sort");
    assert_eq!(texts(&page, Column::Name), ["A1", "A2", "A10"]);
    // The head of a row selects all of it.
    let head = page.get_by_label("Row 2, No., 1").rect().left_center() - vec2(20.0, 0.0);
    page.drag_at(head);
    page.drop_at(head);
    page.run();
    let sheet = &page.state().session().parts().sheet;
    assert_eq!((sheet.selected_rows(), sheet.selected_places()), (1..=1, 0..=6));
    click(&mut page, Role::Button, "Insert row");
    page.get_by_label_contains("Row 2, Callout, empty, fault:");
    click(&mut page, Role::Button, "Delete rows");
    page.get_by_label("No faults in the plan");
    click(&mut page, Role::CheckBox, "All columns");
    assert_eq!(page.state().session().parts().sheet.columns.len(), Column::ALL.len());
}

#[test]
fn what_is_wrong_is_marked_listed_and_reached() {
    let faulty = PLATE.replace("25 H7", "25 Q7").replace("x = 80", "x = 800").replace("A2", "a1");
    let (_folder, path) = folder(&format!("colour = \"red\"\n{faulty}"));
    let mut page = open(Window::default(), &path);
    page.get_by_label("4 faults");
    page.get_by_label_contains("Not understood in the file: the plan measures and saves nothing");
    page.get_by_label_contains("line 1");
    let wrong = page.get_all_by(|node| node.role() == Role::GridCell && node.data().invalid().is_some());
    assert_eq!(wrong.count(), 3);
    let button =
        page.get_by(|node| node.role() == Role::Button && node.label().is_some_and(|l| l.starts_with("Row 3, X")));
    button.click();
    page.run();
    type_text(&mut page, "80");
    press(&mut page, Key::Enter);
    page.get_by_label("3 faults");
    click(&mut page, Role::Button, "Leave these out");
    page.get_by_label("2 faults");
    press(&mut page, Key::Escape);
    press(&mut page, Key::F4);
    page.key_press_modifiers(Modifiers::COMMAND, Key::Home);
    page.run();
    // The field of the part.
    type_into(&mut page, "Material", "unobtainium");
    page.get_by_label("3 faults");
    let field = page.get_by_role_and_label(Role::TextInput, "Material");
    assert_eq!(field.accesskit_node().data().invalid(), Some(Invalid::True));
}

/// Whether the table has the focus: then one of its cells is said.
fn is_at_table(page: &Page) -> bool {
    let cell = page.query_by(|node| node.role() == Role::GridCell && node.is_focused());
    cell.is_some() || page.get_by_role_and_label(Role::Grid, "Features of the plan").accesskit_node().is_focused()
}

#[test]
fn a_new_plan_is_typed_into_at_once_and_is_no_mistake() {
    let (_folder, path) = folder(PLATE);
    // On the walk, too: the new plan is where the keys are.
    let mut page = Window { files: vec![(Purpose::OpenPlan, path)], ..Window::default() }.open();
    page.key_press_modifiers(Modifiers::COMMAND, Key::N);
    page.run();
    page.get_by_label("Type the first feature, or paste rows from a spreadsheet");
    assert!(page.query_by_label_contains("fault").is_none());
    assert!(is_at_table(&page));
    type_text(&mut page, "1");
    press(&mut page, Key::Tab);
    type_text(&mut page, "A1");
    press(&mut page, Key::Enter);
    assert_eq!(texts(&page, Column::Name), ["A1"]);
    page.get_by_label("One fault");
}

#[test]
fn the_table_stays_where_it_is_whether_there_are_faults_or_not() {
    let (_folder, mut page) = plate();
    let top = page.get_by_label("Row 1, Callout, 25 H7").rect().top();
    cell(&mut page, "Row 3, Callout, 16 H7");
    type_text(&mut page, "16 Q7");
    page.get_by_label("One fault");
    assert!((page.get_by_label("Row 1, Callout, 25 H7").rect().top() - top).abs() < 0.5);
    press(&mut page, Key::Enter);
    // What leads to a fault leaves the keys there.
    press(&mut page, Key::F4);
    type_text(&mut page, "16 H7");
    press(&mut page, Key::Enter);
    page.get_by_label("No faults in the plan");
    assert!((page.get_by_label("Row 1, Callout, 25 H7").rect().top() - top).abs() < 0.5);
    // After a notice the keys are in the table.
    page.input_mut().events.push(Event::Paste("a\tb\tc\td\te\tf\tg\th\ti\n".to_owned()));
    page.run();
    page.get_by_label_contains("pasted column");
    press(&mut page, Key::Escape);
    assert!(is_at_table(&page));
}

#[test]
fn the_words_that_a_cell_may_have_are_offered_below_it() {
    let (_folder, path) = folder(&PLATE.replace("picture = \"plate.svg\"\n", ""));
    let mut page = open(Window::default(), &path);
    cell(&mut page, "Row 1, Kind, empty");
    press(&mut page, Key::F2);
    click(&mut page, Role::Button, "width");
    assert_eq!(texts(&page, Column::Kind)[0], "width");
    assert!(is_at_table(&page));
    // By key: the second of those that begin with what is typed.
    type_text(&mut page, "p");
    press(&mut page, Key::ArrowDown);
    press(&mut page, Key::ArrowDown);
    press(&mut page, Key::Enter);
    assert_eq!(texts(&page, Column::Kind)[1], "point");
    // A callout without letters: the column that says hole or shaft comes into sight.
    cell(&mut page, "Row 3, Callout, 16 H7");
    type_text(&mut page, "16 +0.1/0");
    press(&mut page, Key::Enter);
    cell(&mut page, "Row 3, Hole or shaft, empty");
    press(&mut page, Key::F2);
    click(&mut page, Role::Button, "hole");
    assert_eq!(texts(&page, Column::Feature)[2], "hole");
}

#[test]
fn without_a_plan_there_are_buttons_where_the_text_is() {
    let mut page = Window::default().open();
    page.key_press_modifiers(Modifiers::COMMAND, Key::Num2);
    page.run();
    click(&mut page, Role::RadioButton, "Plan");
    page.get_by_label("No plan yet: open or create one.");
    let lowest = page.get_all_by_role_and_label(Role::Button, "New plan").map(|node| node.rect().top());
    assert!(100.0 < lowest.fold(0.0, f32::max));
}

fn balloon(page: &Page, row: usize) -> Option<[f64; 2]> {
    page.state().session().parts().balloons()[row].at
}

#[test]
fn balloons_are_dragged_and_moved_by_key() {
    let (_folder, mut page) = plate();
    let figure = page.get_by_role_and_label(Role::Image, "Picture of the part");
    assert_eq!(figure.accesskit_node().data().description(), Some("Picture of the part, 2 of 3 balloons placed"));
    let (one, two) = (
        page.get_by_label("Balloon 1, A1, not measured").rect().center(),
        page.get_by_label("Balloon 2, A2, not measured").rect().center(),
    );
    // Where the plan has them: a quarter and three quarters of the picture's width.
    let middle = one + (two - one) / 2.0;
    page.drag_at(one);
    page.run();
    page.hover_at(middle);
    page.run();
    page.drop_at(middle);
    page.run();
    let at = balloon(&page, 0).unwrap();
    assert!((at[0] - 0.5).abs() < 0.01 && (at[1] - 0.5).abs() < 0.01, "{at:?}");
    page.key_press_modifiers(Modifiers::COMMAND, Key::Z);
    page.run();
    assert_eq!(balloon(&page, 0), Some([0.25, 0.5]), "a drag is one change");
    // What was let go is moved by the keys next.
    press(&mut page, Key::ArrowRight);
    assert!((balloon(&page, 0).unwrap()[0] - 0.255).abs() < 1e-6, "{:?}", balloon(&page, 0));
    press(&mut page, Key::ArrowLeft);
    // From beside the picture onto it.
    let three = page.get_by_label("Balloon 3, A10, not measured, not on the picture").rect().center();
    page.drag_at(three);
    page.run();
    page.hover_at(middle);
    page.run();
    page.drop_at(middle);
    page.run();
    let at = balloon(&page, 2).unwrap();
    assert!((at[0] - 0.5).abs() < 0.01, "{at:?}");
    page.get_by_label("Balloon 3, A10, not measured").focus();
    page.run();
    press(&mut page, Key::ArrowRight);
    assert!((balloon(&page, 2).unwrap()[0] - at[0] - 0.005).abs() < 1e-6);
    press(&mut page, Key::Delete);
    assert_eq!(balloon(&page, 2), None);
    page.get_by_label("Balloon 3, A10, not measured, not on the picture").focus();
    page.run();
    press(&mut page, Key::Enter);
    assert_eq!(balloon(&page, 2), Some([0.5, 0.5]));
}

/// A PNG file that says it has so many dots and has none.
fn bomb(width: u32, height: u32) -> Vec<u8> {
    let chunk = |kind: &[u8], data: &[u8]| {
        let body: Vec<u8> = kind.iter().chain(data).copied().collect();
        let mut crc = flate2::Crc::new();
        crc.update(&body);
        let length = u32::try_from(data.len()).unwrap().to_be_bytes();
        [&length[..], &body, &crc.sum().to_be_bytes()].concat()
    };
    let mut head = [width.to_be_bytes(), height.to_be_bytes()].concat();
    head.extend([8, 6, 0, 0, 0]);
    [&b"\x89PNG\r\n\x1a\n"[..], &chunk(b"IHDR", &head), &chunk(b"IDAT", &[]), &chunk(b"IEND", &[])].concat()
}

const SHAPE: &str = "<rect width=\"400\" height=\"200\" fill=\"red\"/>";

#[test]
fn a_picture_that_cannot_be_shown_says_why() {
    let (folder, path) = folder(&PLATE.replace("plate.svg", "plate.png"));
    let file = folder.path().join("plate.png");
    let nested = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"99999\" height=\"99999\"/>".to_owned();
    for (bytes, said) in [
        (bomb(60_000, 60_000), "plate.png has 60000 × 60000 pixels; a picture has at most 40 million pixels"),
        (bomb(10, 10), "plate.png cannot be read as a picture"),
        (b"%PDF-1.7".to_vec(), "plate.png is not a PNG, JPEG or SVG picture"),
        (b"<svg><g>".to_vec(), "plate.png cannot be read as a picture"),
        (vec![b' '; 17 << 20], "plate.png is not a PNG, JPEG or SVG picture"),
    ] {
        put(&file, &bytes);
        let page = open(Window::default(), &path);
        page.get_by_label_contains(said);
        page.get_by_label("Row 1, Name, A1");
    }
    let heavy = "plate.png would take too long to draw";
    let group = |open: &str, times: usize| format!("{}{SHAPE}{}", open.repeat(times), "</g>".repeat(times));
    let doubled =
        |level: usize| format!("<g id=\"g{}\"><use href=\"#g{level}\"/><use href=\"#g{level}\"/></g>", level + 1);
    for (body, said) in [
        (group("<g opacity=\"0.9\">", 40), heavy),
        (group("<g opacity=\"0.9\">", 900), heavy),
        (group("<g>", 5_000), "plate.png cannot be read as a picture"),
        (
            format!(
                "<filter id=\"f\"><feTurbulence numOctaves=\"9999999\"/></filter><g filter=\"url(#f)\">{SHAPE}</g>"
            ),
            heavy,
        ),
        (
            format!(
                "<pattern id=\"p\" width=\"90000\" height=\"90000\" patternUnits=\"userSpaceOnUse\">{SHAPE}</pattern>\
                 <rect width=\"9\" height=\"9\" fill=\"url(#p)\"/>"
            ),
            heavy,
        ),
        (SHAPE.repeat(5_000), heavy),
        (
            format!(
                "<defs><g id=\"g0\">{SHAPE}</g>{}</defs><use href=\"#g30\"/>",
                (0..30).map(doubled).collect::<String>()
            ),
            "plate.png",
        ),
    ] {
        let svg = format!("<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"400\" height=\"200\">{body}</svg>");
        put(&file, svg.as_bytes());
        let page = open(Window::default(), &path);
        page.get_by_label_contains(said);
    }
    std::fs::remove_file(&file).unwrap();
    let page = open(Window::default(), &path);
    page.get_by_label_contains("plate.png");
    // However large its sheet is, it is drawn as large as it is shown.
    put(&file, nested.as_bytes());
    let page = open(Window::default(), &path);
    page.get_by_role_and_label(Role::Image, "Picture of the part");
}

#[test]
fn png_and_jpeg_are_shown_no_larger_than_is_seen() {
    let (folder, path) = folder(&PLATE.replace("plate.svg", "plate.png"));
    let file = folder.path().join("plate.png");
    for format in [image::ImageFormat::Png, image::ImageFormat::Jpeg] {
        let picture =
            image::RgbImage::from_fn(3_000, 1_000, |x, _| image::Rgb([if x < 1_500 { 255 } else { 0 }, 0, 0]));
        // The ending is no witness of what is in it.
        picture.save_with_format(&file, format).unwrap();
        let page = open(Window::default(), &path);
        let Some(fitcheck::session::parts::PictureState::Seen(seen)) = page.state().session().parts().sight() else {
            panic!("{format:?} is not shown")
        };
        assert_eq!(seen.size, [2_048, 683]);
        assert!(200 < seen.dots[0] && seen.dots[4 * 2_000] < 50, "{format:?}");
    }
}

/// A plan of so many features.
fn many(count: usize) -> (tempfile::TempDir, PathBuf) {
    use std::fmt::Write as _;
    let mut text = "number;name;callout;x;y;z\n".to_owned();
    for row in 1..=count {
        writeln!(text, "{row};H{row};{} H7;{};{};-8", 6 + row % 40, row % 100 * 5, row / 100 * 40).unwrap();
    }
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("many.csv");
    put(&path, text.as_bytes());
    (folder, path)
}

#[test]
fn a_plan_of_a_thousand_features_draws_what_is_in_sight() {
    let (_folder, path) = many(1_000);
    let mut page = open(Window::default(), &path);
    page.get_by_label("1000 features");
    let cells = page.query_all_by_role(Role::GridCell).count();
    assert!(cells < 400, "{cells} cells are drawn");
    cell(&mut page, "Row 1, Name, H1");
    page.key_press_modifiers(Modifiers::COMMAND, Key::End);
    page.run();
    press(&mut page, Key::ArrowUp);
    page.get_by_label("Row 1000, Name, H1000");
    for sign in "12345678".chars() {
        page.input_mut().events.push(Event::Text(sign.to_string()));
        page.step();
    }
    press(&mut page, Key::Enter);
    page.run();
    // Nothing moves by itself.
    assert_eq!(page.output().viewport_output[&ViewportId::ROOT].repaint_delay, std::time::Duration::MAX);
}

/// A part of the plan is measured: one good, one to rework, the third is next.
fn measured(window: Window, path: &Path) -> Page {
    let files = vec![(Purpose::OpenPlan, path.to_owned())];
    let mut page = Window { files, ..window }.open();
    type_into(&mut page, "Serial number", "A-0099");
    press(&mut page, Key::Enter);
    for value in ["25.012", "19.99"] {
        type_into(&mut page, "Measured value", value);
        press(&mut page, Key::Enter);
    }
    page
}

#[test]
fn balloons_have_the_verdicts_of_the_walk_and_lead_to_their_features() {
    let (_folder, path) = folder(&PLATE.replace("16 H7\"", "16 H7\"\nballoon_x = 0.5\nballoon_y = 0.2"));
    let mut page = measured(Window::default(), &path);
    page.get_by_label("Balloon 1, A1, GOOD");
    page.get_by_label("Balloon 3, A10, not measured, next");
    page.get_by_label("Balloon 2, A2, REWORK").click();
    page.run();
    let walking = &page.state().session().parts().walking;
    assert_eq!(walking.at, Some(1), "the balloon leads to its feature");
    // On the plan they say the same.
    click(&mut page, Role::RadioButton, "Plan");
    page.get_by_label("Balloon 1, A1, GOOD");
}

#[test]
fn the_picture_stands_over_the_band_and_the_sizes_below_what_is_asked() {
    let long = "LOCATION HOLE OF THE COVER";
    // A name that has no room beside its value keeps the list in the middle.
    for (size, name, has_list_left) in [
        (DESK, "LOCATION HOLE", true),
        (DESK, long, false),
        (vec2(1920.0, 1080.0), long, true),
        (vec2(800.0, 1600.0), long, false),
    ] {
        let (_folder, path) = folder(&PLATE.replace("A10", name));
        let page = measured(Window { size, ..Window::default() }, &path);
        let figure = |name: &str| page.query_by_role_and_label(Role::Image, name).map(|node| node.rect());
        let picture = figure("Picture of the part").unwrap();
        let list = page.get_by_role_and_label(Role::Grid, "Sizes of the part").rect();
        let field = page.get_by_role_and_label(Role::TextInput, "Measured value").rect();
        assert!(240.0 <= picture.height(), "{size}: {picture:?}");
        assert_eq!(list.right() < picture.left(), has_list_left, "{size}");
        if has_list_left {
            assert!(field.bottom() < list.top(), "{size}: {list:?}");
            let band = page.get_by_role_and_label(Role::Image, "Limit band");
            assert!(picture.bottom() < band.rect().top(), "{size}");
            // The band is of the size whose verdict stands beside it: 19.990 of 20 H7, until the next one is begun.
            let said = band.accesskit_node().data().description().unwrap_or_default().to_owned();
            assert!(said.contains("zone from 0 to +21,") && said.contains("Measured \u{2212}10,"), "{said}");
        }
        let whole = |clipped: &eframe::egui::epaint::ClippedShape| match &clipped.shape {
            eframe::egui::Shape::Text(text) => {
                text.galley.text() == format!("3  {name}") && !text.galley.elided && list.contains(text.pos)
            }
            _ => false,
        };
        assert!(page.output().shapes.iter().any(whole), "{size}: the name is not whole");
    }
}

#[test]
fn picture_of_a_part_with_its_picture() {
    if !can_paint("walk_picture") {
        return;
    }
    let (_folder, path) = folder(&PLATE.replace("16 H7\"", "16 H7\"\nballoon_x = 0.5\nballoon_y = 0.2"));
    let mut page = measured(Window::default(), &path);
    page.remove_cursor();
    page.run();
    page.snapshot("walk_picture");
}

fn picture(name: &str, size: Vec2, (theme, language): (Theme, Language), density: Density) {
    if !can_paint(name) {
        return;
    }
    let faulty = PLATE.replace("20 H7", "20 Q7");
    let (_folder, path) = folder(&faulty);
    let mut page = open(Window { size, theme, language, ..Window::default() }, &path);
    let ctx = page.ctx.clone();
    page.state_mut().send(&ctx, Command::SetDensity(density));
    page.run();
    page.remove_cursor();
    page.run();
    page.snapshot(name);
}

#[test]
fn picture_of_a_plan_on_a_desk() {
    picture("plan_desk", DESK, (Theme::Light, Language::En), Density::Mouse);
}

#[test]
fn picture_of_a_plan_in_a_small_window() {
    picture("plan_small", vec2(480.0, 320.0), (Theme::Light, Language::En), Density::Mouse);
}

#[test]
fn picture_of_a_plan_in_a_wide_window_by_touch() {
    picture("plan_wide_touch", vec2(1920.0, 1080.0), (Theme::Dark, Language::Nl), Density::Touch);
}
