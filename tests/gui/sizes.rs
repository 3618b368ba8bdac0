//! The window at every size, zoom and language, and with longer texts: the verdict is whole, no text is cut or covered by
//! another, nothing sticks out at the side.
//!
//! `PICTURES=FOLDER cargo test --all-features --test gui sizes` also writes pictures of every page at every size, light, dark and in high
//! contrast, in the language with the longest texts; with `IN=de` in light and in German, at one size, for whoever reads a language in its
//! place.

use fitcheck::session::WalkField;
use std::borrow::Cow;
use std::io::Write as _;
use std::sync::Arc;
use std::time::Duration;

use eframe::egui::accesskit::Role;
use eframe::egui::epaint::TextShape;
use eframe::egui::{FontFamily, Rect, Shape, Vec2, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use fitcheck::gui::App;
use fitcheck::gui::journal::Records;
use fitcheck::message::Bundle;
use fitcheck::session::help::{HelpPlace, HelpTopic};
use fitcheck::session::parts::{PartsView, PlanCommand, WalkCommand};
use fitcheck::session::{
    BudgetCommand, BudgetField, CheckCommand, CheckField, Command, CyclesCommand, Field, FilesCommand, FitField,
    HelpCommand, MeasureBy, Mode, Page, PairingCommand, PairingField, PartsCommand, ProgramCommand, Purpose,
    RecordsCommand, Section, SettingsCommand, SettingsField, Theme,
};
use fitcheck::tolerance::Feature;
use fitcheck::verdict::Status;
use fitcheck::verdict::rules::RuleName;
use fitcheck::words::{Language, Words};

use crate::fake_journal::Fake;
use crate::harness::{Window, nowhere};

/// Width and height in pixels, and the zoom.
const SIZES: [(f32, f32, f32); 13] = [
    (800.0, 600.0, 1.0),
    (1024.0, 600.0, 1.0),
    (1024.0, 768.0, 1.0),
    (1280.0, 800.0, 1.0),
    (1920.0, 1080.0, 1.0),
    (3840.0, 1080.0, 1.0),
    (800.0, 1600.0, 1.0),
    (1280.0, 800.0, 0.75),
    (1280.0, 800.0, 1.5),
    (1280.0, 800.0, 2.0),
    (1280.0, 800.0, 3.0),
    (800.0, 600.0, 1.5),
    (3840.0, 2160.0, 2.0),
];

/// The sizes that texts of a longer language are looked at.
const USUAL: [(f32, f32, f32); 4] =
    [(800.0, 600.0, 1.0), (1024.0, 768.0, 1.0), (1280.0, 800.0, 1.0), (1920.0, 1080.0, 1.0)];

/// The sizes that pictures are made at for people to look at.
const PICTURED: [(f32, f32); 6] =
    [(800.0, 600.0), (1024.0, 768.0), (1280.0, 800.0), (1920.0, 1080.0), (800.0, 1600.0), (3840.0, 2160.0)];

/// What the window speaks.
#[derive(Clone, Copy)]
struct Tongue {
    name: &'static str,
    language: Language,
    words: fn(Language) -> Words,
}

/// Every language of the window.
fn languages() -> impl Iterator<Item = Tongue> {
    Language::all().map(|language| Tongue { name: language.code(), language, words: Words::new })
}

/// The sizes that every language is looked at: where there is least room for texts that are not folded away, and where most columns stand
/// beside each other. English is looked at in all.
const OF_LANGUAGES: [(f32, f32, f32); 2] = [(800.0, 600.0, 1.0), READ];

/// The size at which a language is read.
const READ: (f32, f32, f32) = (1280.0, 800.0, 1.0);

/// The language that somebody wants to read in its place.
fn read_in() -> Option<String> {
    std::env::var("IN").ok()
}

/// Sizes with what the window speaks there.
fn combinations(sizes: &[(f32, f32, f32)]) -> impl Iterator<Item = ((f32, f32, f32), Tongue)> {
    let is_pictured = std::env::var("PICTURES").is_ok();
    let is_looked_at = move |(size, tongue): &(_, Tongue)| {
        OF_LANGUAGES.contains(size) || tongue.language == Language::En || is_pictured && tongue.language == Language::Nl
    };
    let all = sizes.iter().flat_map(|size| languages().map(move |tongue| (*size, tongue)));
    let is_read = |(size, tongue): &(_, Tongue)| *size == READ && read_in().as_deref() == Some(tongue.language.code());
    all.filter(move |both| if read_in().is_some() { is_read(both) } else { is_looked_at(both) })
}

/// English with longer words.
const LONG: Tongue = Tongue {
    name: "long",
    language: Language::En,
    words: |language| Words::of_bundle(language, Bundle::of(language.code()).transformed(longer)),
};

/// A text about 30 % longer: in words of three letters and more the second letter and every third one after it stand
/// twice. Lines break where they did; numbers, units and what is put into the text stay.
fn longer(text: &str) -> Cow<'_, str> {
    let mut long = String::new();
    for word in text.split_inclusive(' ') {
        let letters = word.chars().filter(|c| c.is_alphabetic()).count();
        let is_word = 3 <= letters && !word.contains(|c: char| c.is_ascii_digit() || c == 'µ');
        let mut number = 0;
        for c in word.chars() {
            long.push(c);
            number += usize::from(c.is_alphabetic());
            if is_word && c.is_alphabetic() && number % 3 == 2 {
                long.push(c);
            }
        }
    }
    Cow::Owned(long)
}

fn open(size: (f32, f32, f32), tongue: Tongue) -> Harness<'static, App> {
    let (width, height, zoom) = size;
    let Tongue { language, words, .. } = tongue;
    let records = Records {
        usual: Some("/shop/journal.sqlite".into()),
        journals: Arc::new(Fake::of(1, Duration::ZERO)),
        ..nowhere()
    };
    Window { size: vec2(width, height) / zoom, zoom, language, words, records, ..Window::default() }.open()
}

/// The first start: the first steps, and the paragraph of the manual beside the first field, which lies over the page.
fn first_start(size: (f32, f32, f32), tongue: Tongue) -> Vec<String> {
    let points = vec2(size.0, size.1) / size.2;
    let what = format!("first start {}x{} at {} {}", size.0, size.1, size.2, tongue.name);
    let mut window = open(size, tongue);
    send(&mut window, Command::Welcome(true));
    paint(&mut window, &what);
    let mut found = frame_faults(&window, points, &what);
    found.extend(faults(&window, tongue, &what));
    send(&mut window, Command::GoTo(CheckField::Measured.into()));
    window.run();
    send(&mut window, HelpCommand::Explain(true));
    window.run();
    paint(&mut window, &format!("{what} explained"));
    let explained = faults(&window, tongue, &format!("{what}, explained"));
    found.extend(explained.into_iter().filter(|fault| !fault.contains(" covers ")));
    found
}

fn send(window: &mut Harness<'_, App>, command: impl Into<Command>) {
    let ctx = window.ctx.clone();
    window.state_mut().send(&ctx, command.into());
    window.run_steps(3);
}

fn typed(window: &mut Harness<'_, App>, field: impl Into<Field>, text: &str) {
    send(window, field.into().typed(text.to_owned()));
}

fn measured(window: &mut Harness<'_, App>, values: &[&str]) {
    for value in values {
        typed(window, CheckField::Callout, "25 H7");
        typed(window, CheckField::Measured, value);
        send(window, CheckCommand::Measure);
    }
}

/// A picture for people to look at, where they asked for it.
fn paint(window: &mut Harness<'_, App>, name: &str) {
    let Ok(folder) = std::env::var("PICTURES") else { return };
    let points = window.ctx.content_rect().size();
    let pixels = points * window.ctx.zoom_factor();
    let usual = if pixels.x < 3000.0 { 1.0 } else { 2.0 };
    let is_usual = (window.ctx.zoom_factor() - usual).abs() < 0.01;
    let is_longest = window.state().session().language() == Language::Nl;
    if read_in().is_some() {
        return window.render().unwrap().save(std::path::Path::new(&folder).join(format!("{name}.png"))).unwrap();
    }
    if !is_longest || !is_usual || !PICTURED.contains(&(pixels.x.round(), pixels.y.round())) {
        return;
    }
    for (theme, look) in
        [(Theme::Dark, "dark"), (Theme::Contrast, "contrast"), (Theme::Inverted, "inverted"), (Theme::Light, "light")]
    {
        send(window, Command::SetTheme(theme));
        window.render().unwrap().save(std::path::Path::new(&folder).join(format!("{name} {look}.png"))).unwrap();
    }
}

/// The part of the screen that a widget covers, in points.
fn bounds(node: &egui_kittest::Node<'_>) -> Rect {
    node.rect()
}

/// What is wrong where the verdict is not whole, or something reaches beyond the sides.
fn frame_faults(window: &Harness<'_, App>, size: Vec2, what: &str) -> Vec<String> {
    let screen = Rect::from_min_size(eframe::egui::Pos2::ZERO, size).expand(0.6);
    let verdict = bounds(&window.get_by_role(Role::Status));
    let cut = (!screen.contains_rect(verdict)).then(|| format!("{what}: the verdict {verdict:?} is not in {screen:?}"));
    let roles = [Role::Button, Role::TextInput, Role::ComboBox, Role::RadioButton, Role::CheckBox, Role::Image];
    let all = roles.into_iter().flat_map(|role| window.query_all_by_role(role));
    let beyond = all.filter_map(|node| {
        let rect = bounds(&node);
        let inside = screen.left() <= rect.left() && rect.right() <= screen.right();
        let is_there = !(rect.bottom() < 0.0 || screen.bottom() < rect.top());
        let said = node.accesskit_node().label().unwrap_or_default();
        (is_there && !inside).then(|| format!("{what}: {said} reaches beyond the sides: {rect:?}"))
    });
    cut.into_iter().chain(beyond).collect()
}

/// A line of text on the screen.
struct Drawn {
    said: String,
    /// All of it.
    rect: Rect,
    /// What is in sight.
    seen: Rect,
    clip: Rect,
    is_shortened: bool,
    /// A status window or a program: what a control writes.
    is_of_control: bool,
}

fn texts(window: &Harness<'_, App>) -> Vec<Drawn> {
    fn collect(shape: &Shape, clip: Rect, into: &mut Vec<Drawn>) {
        match shape {
            Shape::Vec(shapes) => shapes.iter().for_each(|shape| collect(shape, clip, into)),
            Shape::Text(TextShape { pos, galley, .. }) => {
                let font = galley.job.sections.first().map(|section| &section.format.font_id.family);
                for row in galley.rows.iter().filter(|row| !row.text().trim().is_empty()) {
                    let rect = row.rect_without_leading_space().translate(pos.to_vec2());
                    into.push(Drawn {
                        said: row.text(),
                        rect,
                        seen: rect.intersect(clip),
                        clip,
                        is_shortened: galley.elided,
                        is_of_control: font == Some(&FontFamily::Monospace),
                    });
                }
            }
            _ => {}
        }
    }
    let mut drawn = Vec::new();
    for clipped in &window.output().shapes {
        collect(&clipped.shape, clipped.clip_rect, &mut drawn);
    }
    // What has scrolled out of sight is whole once it is scrolled back.
    drawn.retain(|text| text.rect.height() * 0.6 < text.seen.height() && 0.0 < text.seen.width());
    drawn
}

/// Texts that are cut at the side, shortened or covered by one another.
fn faults(window: &Harness<'_, App>, tongue: Tongue, what: &str) -> Vec<String> {
    let hint = (tongue.words)(tongue.language).get("tables-keys");
    let texts = texts(window);
    let session = window.state().session();
    let is_plan = session.page() == Page::Parts && session.parts().view == PartsView::Plan;
    let scrolls = matches!(session.page(), Page::Tables | Page::Program) || is_plan;
    // What a program says of its own structure is as long as its author wrote it, and whole in the open list.
    let program = session.program().shown().filter(|_| session.page() == Page::Program);
    let outline = program.map(|document| &document.outline);
    let is_of_outline = |said: &str| {
        let begin = said.trim_end_matches(['…', ' ']);
        outline.is_some_and(|outline| outline.iter().any(|entry| entry.text.starts_with(begin)))
    };
    let mut faults = Vec::new();
    for (number, text) in texts.iter().enumerate() {
        let is_cut = text.rect.left() < text.clip.left() - 1.0 || text.clip.right() + 1.0 < text.rect.right();
        // A table and a program scroll sideways; names of a program's parameters show whole under the pointer.
        let is_head = is_plan && (tongue.words)(tongue.language).get("parts-page-limits") == text.said.trim();
        let is_of_control = text.is_of_control || is_head || (scrolls && !text.said.contains(char::is_lowercase));
        if !is_of_control && is_cut {
            faults.push(format!("{what}: cut: {:?} {:?} in {:?}", text.said, text.rect, text.clip));
        }
        // The hint below the table's cells shows whole under the pointer.
        let is_hint = hint.starts_with(text.said.trim_end_matches('…'));
        if !is_of_control && !is_hint && text.is_shortened && !is_of_outline(&text.said) {
            faults.push(format!("{what}: shortened: {:?} {:?}", text.said, text.rect));
        }
        for other in texts.iter().skip(number + 1) {
            if text.seen.shrink2(vec2(1.0, 3.0)).intersects(other.seen.shrink2(vec2(1.0, 3.0))) {
                faults.push(format!("{what}: {:?} covers {:?} {:?}", other.said, text.said, text.rect));
            }
        }
    }
    faults
}

/// The check page with a rework, a lot and a simulated good.
fn check_page(size: (f32, f32, f32), tongue: Tongue, least: f32) -> Vec<String> {
    let points = vec2(size.0, size.1) / size.2;
    let what = format!("check {}x{} at {} {}", size.0, size.1, size.2, tongue.name);
    let mut window = open(size, tongue);
    let mut found = frame_faults(&window, points, &what);
    found.extend(faults(&window, tongue, &format!("{what}, empty")));
    measured(&mut window, &["25.012", "25.005", "25.0185", "25.023", "24.998"]);
    paint(&mut window, &format!("{what} rework"));
    found.extend(frame_faults(&window, points, &what));
    found.extend(faults(&window, tongue, &format!("{what}, rework")));
    let why = (tongue.words)(tongue.language).get("why");
    let is_whole = |text: &Drawn| text.said.trim() == why && text.clip.expand(0.6).contains_rect(text.rect);
    // In a very low window the card scrolls.
    if 480.0 <= points.y && !texts(&window).iter().any(is_whole) {
        found.push(format!("{what}, rework: the foot of the card is cut"));
    }
    let word = (tongue.words)(tongue.language).told(&Status::Rework);
    let label = window
        .get_all_by_label(&word)
        .map(|node| bounds(&node))
        .max_by(|one, other| one.height().total_cmp(&other.height()));
    assert!(label.is_some_and(|rect| least <= rect.height()), "{what}: {label:?}");
    let rows = b"id,callout,measured\nA1,25 H7,25.012\nA2,25 H7,25.030\nA3,25 H7,24.998\nA4,,25\n";
    let sources = std::sync::Arc::clone(window.state().session().sources());
    let now = jiff::civil::date(2026, 11, 21).at(10, 42, 7, 0);
    let lot = fitcheck::exchange::import("parts.csv", rows, &sources, now);
    send(&mut window, CheckCommand::Imported { name: "parts.csv".to_owned(), result: Ok(Box::new(lot)) });
    send(&mut window, Command::Close);
    found.extend(frame_faults(&window, points, &format!("{what}, a lot")));
    found.extend(faults(&window, tongue, &format!("{what}, a lot")));
    send(&mut window, CheckCommand::MeasureBy(MeasureBy::Simulating));
    send(&mut window, CheckCommand::Measure);
    paint(&mut window, &format!("{what} simulated"));
    found.extend(frame_faults(&window, points, &what));
    found.extend(faults(&window, tongue, &format!("{what}, simulated")));
    // An error is never folded away: rule and temperature unfold.
    send(&mut window, CheckCommand::UseRule(RuleName::IlacG8));
    typed(&mut window, CheckField::ScaleTemperature, "22");
    paint(&mut window, &format!("{what} rule"));
    found.extend(frame_faults(&window, points, &what));
    found.extend(faults(&window, tongue, &format!("{what}, rule")));
    send(&mut window, RecordsCommand::CorrectNumber(5));
    paint(&mut window, &format!("{what} correction"));
    found.extend(faults(&window, tongue, &format!("{what}, correction")));
    found
}

/// Any other page with something on it.
fn other_page(page: Page, size: (f32, f32, f32), tongue: Tongue) -> Vec<String> {
    let points = vec2(size.0, size.1) / size.2;
    let what = format!("{page:?} {}x{} at {} {}", size.0, size.1, size.2, tongue.name);
    let mut window = open(size, tongue);
    send(&mut window, Command::OpenPage(page));
    match page {
        Page::Fit => {
            typed(&mut window, FitField::Callout, "25 H7/g6");
            typed(&mut window, FitField::HoleMeasured, "25.012");
        }
        Page::Cycles => {
            let block = "TCH PROBE 421 ~\nQ273=50~\nQ274=20~\nQ262=25~\nQ275=25.02~\nQ276=25";
            send(&mut window, CyclesCommand::TypeBlock(block.to_owned()));
            send(&mut window, CyclesCommand::TakeBlock);
            send(&mut window, CyclesCommand::Run);
        }
        Page::Program => {
            send(&mut window, ProgramCommand::Run);
            window.run_steps(20);
        }
        Page::Budget => {
            send(&mut window, BudgetCommand::New);
            typed(&mut window, BudgetField::Touches, "3");
            typed(&mut window, BudgetField::Step, "60");
        }
        Page::Pairing => {
            typed(&mut window, PairingField::Wanted, "0.010..0.030");
            typed(&mut window, PairingField::Groups, "3");
            let folder = tempfile::tempdir().unwrap();
            for (feature, name, rows) in [(Feature::Hole, "holes.csv", HOLES), (Feature::Shaft, "shafts.csv", SHAFTS)] {
                let path = folder.path().join(name);
                std::fs::File::create(&path).and_then(|mut file| file.write_all(rows)).unwrap();
                send(&mut window, FilesCommand::Open(Purpose::OpenParts(feature), path));
            }
            send(&mut window, PairingCommand::Select(1));
        }
        Page::Records => recorded(&mut window),
        Page::Reports => {
            measured(&mut window, &["25.012", "24.998", "25.030"]);
            send(&mut window, Command::OpenPage(page));
        }
        Page::Parts => {
            send(&mut window, PartsCommand::Plan(PlanCommand::New));
            send(&mut window, PartsCommand::Show(PartsView::Plan));
        }
        Page::Help => send(&mut window, HelpCommand::Open(HelpPlace::of(HelpTopic::Manual("programs.md")))),
        Page::Settings => return settings_page(&mut window, tongue, &what),
        Page::Statistics => {
            measured(&mut window, &["25.012", "25.005", "25.0185", "25.023", "24.998"]);
            send(&mut window, Command::OpenPage(page));
        }
        Page::Check | Page::Tables => {}
    }
    paint(&mut window, &what);
    let mut found = if has_verdict(page) { frame_faults(&window, points, &what) } else { Vec::new() };
    found.extend(faults(&window, tongue, &what));
    found
}

/// Every section of the settings, and what a search finds.
fn settings_page(window: &mut Harness<'_, App>, tongue: Tongue, what: &str) -> Vec<String> {
    let mut found = Vec::new();
    for section in Section::ALL {
        send(window, SettingsCommand::Show(section));
        paint(window, &format!("{what} {section:?}"));
        found.extend(faults(window, tongue, &format!("{what}, {section:?}")));
    }
    typed(window, SettingsField::Find, "e");
    found.extend(faults(window, tongue, &format!("{what}, found")));
    found
}

/// Records in sight, one of them open and being corrected.
fn recorded(window: &mut Harness<'_, App>) {
    measured(window, &["25.012", "24.998", "25.030"]);
    send(window, RecordsCommand::Choose(3, true));
    send(window, RecordsCommand::Open(2));
    send(window, RecordsCommand::Correct(true));
}

/// Whether an answer stands on a page, whatever its size.
const fn has_verdict(page: Page) -> bool {
    match page {
        Page::Check | Page::Fit | Page::Cycles | Page::Pairing | Page::Budget => true,
        Page::Parts
        | Page::Tables
        | Page::Program
        | Page::Records
        | Page::Statistics
        | Page::Reports
        | Page::Help
        | Page::Settings => false,
    }
}

/// The pages that are looked at in one state; the check page has several, and the walk stands by itself.
fn other_pages() -> impl Iterator<Item = Page> {
    Page::ALL.into_iter().filter(|page| !matches!(page, Page::Check))
}

const HOLES: &[u8] = b"id;measured\nH1;25,012\nH2;25,004\nH3;25,001\nH4;25,021\nH5;\n";
const SHAFTS: &[u8] = b"id;measured\nS1;24,990\nS2;24,986\nS3;25,016\nS4;24,999\n";

#[test]
fn the_check_page_at_every_size() {
    let mut found = Vec::new();
    for (size, tongue) in combinations(&SIZES) {
        // Only a window that is narrower than the word may set it smaller.
        found.extend(check_page(size, tongue, if 500.0 <= size.0 / size.2 { 64.0 } else { 40.0 }));
    }
    assert!(found.is_empty(), "{}", found.join("\n"));
}

/// The walk through a part: before it, in the middle of it, and with a reason that is asked for.
fn walk(size: (f32, f32, f32), tongue: Tongue) -> Vec<String> {
    let points = vec2(size.0, size.1) / size.2;
    let what = format!("Walk {}x{} at {} {}", size.0, size.1, size.2, tongue.name);
    let mut window = open(size, tongue);
    send(&mut window, Command::OpenPage(Page::Parts));
    let plan = b"number;name;callout;x;y;z\n1;BORE;25 H7;40;30;-8\n2;PIN;20 g6;40;90;-8\n3;LOCATION HOLE OF THE COVER;8 H7;10;10;-5\n";
    let result = Ok(Box::new(fitcheck::part::Document::read(plan).unwrap()));
    send(&mut window, PartsCommand::Plan(PlanCommand::Read { path: "/plans/flange.csv".into(), result }));
    let mut found = faults(&window, tongue, &format!("{what}, begin"));
    send(&mut window, WalkCommand::Begin);
    typed(&mut window, WalkField::Value, "25.0134");
    send(&mut window, WalkCommand::Take);
    send(&mut window, WalkCommand::Simulate);
    paint(&mut window, &what);
    found.extend(frame_faults(&window, points, &what));
    found.extend(faults(&window, tongue, &what));
    send(&mut window, WalkCommand::AskSkip(true));
    found.extend(faults(&window, tongue, &format!("{what}, left out")));
    found
}

/// Panels beside a machine: dots, and dots in a millimetre.
const PANELS: [((f32, f32, f32), f32); 4] = [
    // 10.4, 10.1, 15 and 24 inches.
    ((800.0, 600.0, 1.0), 3.79),
    ((1024.0, 600.0, 1.0), 4.63),
    ((1024.0, 768.0, 1.0), 3.36),
    ((1920.0, 1080.0, 1.0), 3.61),
];

/// A capital of the bold face, of its size.
const CAPITAL: f32 = 0.66;

/// An operator's window with each verdict, and with a part.
fn operator((size, dots): ((f32, f32, f32), f32), tongue: Tongue) -> Vec<String> {
    let what = format!("operator {}x{} {}", size.0, size.1, tongue.name);
    let mut window = open(size, tongue);
    send(&mut window, Command::SetMode(Mode::Operator));
    let mut found = faults(&window, tongue, &format!("{what}, empty"));
    typed(&mut window, CheckField::Callout, "25 H7");
    for (value, status) in [("25.0123", Status::Good), ("24.9877", Status::Rework), ("25.0301", Status::Scrap)] {
        typed(&mut window, CheckField::Measured, value);
        send(&mut window, CheckCommand::Measure);
        let what = format!("{what}, {status:?}");
        paint(&mut window, &what);
        found.extend(frame_faults(&window, vec2(size.0, size.1), &what));
        found.extend(faults(&window, tongue, &what));
        let word = (tongue.words)(tongue.language).told(&status);
        let sizes = window.get_all_by_label(&word).map(|node| bounds(&node).height() / 1.326);
        let capital = sizes.fold(0.0, f32::max) * CAPITAL / dots;
        // 16 minutes of arc at two metres are 9.3 mm, 20 are 11.6.
        let least = if word.chars().count() < 8 { 11.6 } else { 9.3 };
        if capital < least {
            found.push(format!("{what}: the word is {capital:.1} mm high, and {least} mm are needed"));
        }
        send(&mut window, Command::GoOn);
    }
    send(&mut window, Command::OpenPage(Page::Parts));
    let plan =
        b"number;name;callout;x;y;z\n1;BORE;25 H7;40;30;-8\n2;PIN;20 g6;40;90;-8\n3;LOCATION HOLE;8 H7;10;10;-5\n";
    let result = Ok(Box::new(fitcheck::part::Document::read(plan).unwrap()));
    send(&mut window, PartsCommand::Plan(PlanCommand::Read { path: "/plans/flange.csv".into(), result }));
    found.extend(faults(&window, tongue, &format!("{what}, before a part")));
    send(&mut window, WalkCommand::Begin);
    typed(&mut window, WalkField::Value, "25.0134");
    send(&mut window, WalkCommand::Take);
    paint(&mut window, &format!("{what}, part"));
    found.extend(faults(&window, tongue, &format!("{what}, part")));
    send(&mut window, Command::OpenPage(Page::Records));
    found.extend(faults(&window, tongue, &format!("{what}, results")));
    found
}

#[test]
fn the_operators_window_on_every_panel_in_every_language() {
    let is_asked = |tongue: &Tongue| read_in().is_none_or(|code| code == tongue.language.code());
    let all = PANELS.into_iter().flat_map(|panel| languages().filter(is_asked).map(move |tongue| (panel, tongue)));
    let found: Vec<_> = all.flat_map(|(panel, tongue)| operator(panel, tongue)).collect();
    assert!(found.is_empty(), "{}", found.join("\n"));
}

#[test]
fn the_first_start_at_every_size() {
    let found: Vec<_> = combinations(&SIZES).flat_map(|(size, tongue)| first_start(size, tongue)).collect();
    assert!(found.is_empty(), "{}", found.join("\n"));
}

#[test]
fn the_walk_at_every_size() {
    let found: Vec<_> = combinations(&SIZES).flat_map(|(size, tongue)| walk(size, tongue)).collect();
    assert!(found.is_empty(), "{}", found.join("\n"));
}

#[test]
fn the_other_pages_at_every_size() {
    let pages = combinations(&SIZES)
        .flat_map(|(size, tongue)| other_pages().flat_map(move |page| other_page(page, size, tongue)));
    let found: Vec<_> = pages.collect();
    assert!(found.is_empty(), "{}", found.join("\n"));
}

#[test]
fn texts_that_are_a_third_longer_have_room() {
    let texts = ["Measured value", "to the nearest limit", "A built-in table is never changed"];
    let chars = |texts: [&str; 3]| texts.map(|text| text.chars().count()).iter().sum::<usize>();
    let (short, long) = (chars(texts), chars(texts.map(longer).each_ref().map(AsRef::as_ref)));
    assert!((short * 125..short * 140).contains(&(long * 100)), "{short} letters became {long}");
    let mut found = Vec::new();
    for size in USUAL {
        found.extend(check_page(size, LONG, 64.0));
        found.extend(first_start(size, LONG));
        found.extend(other_pages().flat_map(|page| other_page(page, size, LONG)));
    }
    assert!(found.is_empty(), "{}", found.join("\n"));
}
