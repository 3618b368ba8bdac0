//! The one place where a window for tests is built, and where image thresholds are decided.

use std::cell::Cell;
use std::path::PathBuf;
use std::time::Duration;

use eframe::egui::accesskit::{Role, Toggled};
use eframe::egui::{Event, Key, Modifiers, Theme, Vec2, ViewportId, vec2};
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use egui_kittest::{Harness, SnapshotOptions};
use fitcheck::gui::journal::Records;
use fitcheck::gui::{App, Errands, Setup, Store};
use fitcheck::journal::entry::Moment;
use fitcheck::message::Message;
use fitcheck::session::{Command, Mode, Purpose};
use fitcheck::words::{Language, Words};
use jiff::ToSpan as _;
use jiff::tz::{TimeZone, offset};

/// The size that most tests look at.
pub const DESK: Vec2 = vec2(1280.0, 800.0);

/// The same time with its zone.
pub fn moment() -> Moment {
    Moment { utc_ms: 1_795_254_127_000, offset_min: 60, zone: "Europe/Amsterdam".to_owned() }
}

/// Nothing is recorded.
pub fn nowhere() -> Records {
    let zone = TimeZone::fixed(offset(1));
    Records { moment, zone, station: "Mill 3".to_owned(), ..Records::nowhere() }
}

/// A window at a fixed time, in English, that keeps nothing.
pub fn window() -> Harness<'static, App> {
    Window::default().open()
}

thread_local! {
    /// How much later it is than at the start, milliseconds.
    static LATER: Cell<i64> = const { Cell::new(0) };
}

/// Lets time pass for the window of this test.
pub fn wait(milliseconds: i64) {
    LATER.set(LATER.get() + milliseconds);
}

/// How a window for a test is opened.
pub struct Window {
    pub size: Vec2,
    pub theme: Theme,
    pub language: Language,
    /// The texts of a language.
    pub words: fn(Language) -> Words,
    pub store: Store,
    /// The folder in which dialogs begin.
    pub home: Option<PathBuf>,
    /// The files that the window is started with.
    pub files: Vec<(Purpose, PathBuf)>,
    /// Pixels per point.
    pub zoom: f32,
    /// Where checks are recorded.
    pub records: Records,
    /// What is told at once.
    pub told: Vec<Message>,
    /// How long a notice stays that asks for nothing; for ever, unless a test is about it.
    pub notices_stay: Option<f64>,
    /// Whether it is the first start: the check page shows the first steps.
    pub is_first: bool,
}

impl Default for Window {
    fn default() -> Self {
        Self {
            size: DESK,
            theme: Theme::Light,
            language: Language::En,
            words: Words::new,
            store: Store::nowhere(),
            home: None,
            files: Vec::new(),
            zoom: 1.0,
            records: nowhere(),
            told: Vec::new(),
            notices_stay: None,
            is_first: false,
        }
    }
}

impl Window {
    pub fn open(self) -> Harness<'static, App> {
        let setup = Setup {
            store: self.store,
            language: self.language,
            words: self.words,
            errands: Errands::AtOnce,
            clock: || jiff::civil::date(2026, 11, 21).at(10, 42, 7, 0) + LATER.get().milliseconds(),
            home: self.home,
            files: self.files,
            records: self.records,
            told: self.told,
            notices_stay: self.notices_stay,
        };
        let mut harness = Harness::builder()
            .with_size(self.size)
            .with_theme(self.theme)
            .with_pixels_per_point(self.zoom)
            .with_max_steps(16)
            .build_eframe(|cc| App::new(cc, setup));
        // "Follow system" would follow the harness's idea of a system.
        let theme = match self.theme {
            Theme::Light => fitcheck::session::Theme::Light,
            Theme::Dark => fitcheck::session::Theme::Dark,
        };
        let ctx = harness.ctx.clone();
        harness.state_mut().send(&ctx, Command::SetTheme(theme));
        if !self.is_first {
            harness.state_mut().send(&ctx, Command::Welcome(false));
            harness.state_mut().send(&ctx, Command::SetMode(Mode::Full));
        }
        harness.run();
        harness
    }
}

/// Opens a part of a page that is folded away; an open one stays open.
pub fn unfold(harness: &mut Harness<'_, App>, section: &str) {
    let row = harness.query_by(|node| {
        let label = node.label().unwrap_or_default();
        let is_it = label == section || label.starts_with(&format!("{section}: "));
        is_it && node.role() == Role::Button && node.toggled() == Some(Toggled::False)
    });
    if let Some(row) = row {
        let focused = harness.ctx.memory(eframe::egui::Memory::focused);
        row.click_accesskit();
        harness.run();
        // Tests go on where they were, and not behind the part.
        if let Some(focused) = focused {
            harness.ctx.memory_mut(|memory| memory.request_focus(focused));
            harness.run();
        }
    }
}

/// Types into a field, by its name, as a user does: go there, replace, and stay.
pub fn type_into(harness: &mut Harness<'_, App>, name: &str, text: &str) {
    // Where a field of the check page is folded away.
    for (field, section) in
        [("Part or feature", "Part"), ("Serial number", "Record"), ("Remark", "Record"), ("Centre X", "Probe position")]
    {
        if field == name && harness.query_by_role_and_label(Role::TextInput, name).is_none() {
            unfold(harness, section);
        }
    }
    harness.get_by_role_and_label(Role::TextInput, name).focus();
    harness.run();
    harness.key_press_modifiers(Modifiers::COMMAND, Key::A);
    if text.is_empty() {
        harness.key_press(Key::Delete);
    } else {
        harness.get_by_role_and_label(Role::TextInput, name).type_text(text);
    }
    harness.run();
}

/// Types as a scanner or a gauge does, all within one frame: `⇥` `⇤` `⏎` `⎋` `↓` `↑` are keys, and so is everything else, which types
/// a sign.
pub fn scan(window: &mut Harness<'_, App>, typed: &str) {
    let events: Vec<Event> = typed.chars().flat_map(events_of).collect();
    window.input_mut().events.extend(events);
    settle(window);
}

/// What the system tells of a key: pressed, what it types, released.
fn events_of(sign: char) -> Vec<Event> {
    const SHIFT: Modifiers = Modifiers::SHIFT;
    let (key, modifiers, types) = match sign {
        '⇥' => (Some(Key::Tab), Modifiers::NONE, false),
        '⇤' => (Some(Key::Tab), SHIFT, false),
        '⏎' => (Some(Key::Enter), Modifiers::NONE, false),
        '⎋' => (Some(Key::Escape), Modifiers::NONE, false),
        '↓' => (Some(Key::ArrowDown), Modifiers::NONE, false),
        '↑' => (Some(Key::ArrowUp), Modifiers::NONE, false),
        sign => {
            let modifiers = if sign.is_uppercase() { SHIFT } else { Modifiers::NONE };
            (Key::from_name(&sign.to_uppercase().to_string()), modifiers, true)
        }
    };
    let of_key = |pressed| {
        let key = key?;
        Some(Event::Key { key, physical_key: None, pressed, repeat: false, modifiers })
    };
    let held = (modifiers != Modifiers::NONE).then_some(Event::ModifiersChanged(modifiers));
    let left = held.is_some().then_some(Event::ModifiersChanged(Modifiers::NONE));
    let text = types.then(|| Event::Text(sign.to_string()));
    held.into_iter().chain(of_key(true)).chain(text).chain(of_key(false)).chain(left).collect()
}

/// Draws until nothing asks for another frame at once.
pub fn settle(window: &mut Harness<'_, App>) {
    for _ in 0..1_000 {
        window.step();
        if window.output().viewport_output[&ViewportId::ROOT].repaint_delay != Duration::ZERO {
            return;
        }
    }
    panic!("the window never comes to rest");
}

/// Types a callout and a measured value and presses Enter.
pub fn check(harness: &mut Harness<'_, App>, callout: &str, measured: &str) {
    type_into(harness, "Callout", callout);
    type_into(harness, "Measured value", measured);
    harness.key_press(Key::Enter);
    harness.run();
}

/// What the live verdict says.
pub fn verdict(harness: &Harness<'_, App>) -> String {
    harness.get_by_role(Role::Status).accesskit_node().label().unwrap_or_default()
}

/// Compares a picture of the window with the one of a name in a folder.
#[expect(clippy::disallowed_methods, reason = "the folder alone; thresholds are those of every picture")]
pub fn picture_in(window: &mut Harness<'_, App>, name: &str, folder: &str) {
    window.snapshot_options(name, &SnapshotOptions::new().output_path(folder));
}

/// Compares a picture that was put together with the one of a name in a folder.
#[expect(clippy::disallowed_methods, reason = "the folder alone; thresholds are those of every picture")]
pub fn sheet_in(sheet: &image::RgbaImage, name: &str, folder: &str) {
    egui_kittest::image_snapshot_options(sheet, name, &SnapshotOptions::new().output_path(folder));
}

/// Whether a picture passes as another one, by the thresholds of every picture.
#[expect(clippy::disallowed_methods, reason = "the folder alone; thresholds are those of every picture")]
pub fn passes_as(picture: &image::RgbaImage, expected: &image::RgbaImage) -> bool {
    let folder = tempfile::tempdir().unwrap();
    expected.save(folder.path().join("picture.png")).unwrap();
    let options = SnapshotOptions::new().output_path(folder.path());
    egui_kittest::try_image_snapshot_options(picture, "picture", &options).is_ok()
}

/// Presses a key.
pub fn press(window: &mut Harness<'_, App>, key: Key) {
    window.key_press(key);
    window.run();
}

/// Clicks what has a role and a name.
pub fn click(window: &mut Harness<'_, App>, role: Role, name: &str) {
    window.get_by_role_and_label(role, name).scroll_to_me();
    window.run();
    window.get_by_role_and_label(role, name).click();
    window.run();
}

/// What a screen reader says of the rows in sight, from above.
pub fn rows(window: &Harness<'_, App>) -> Vec<String> {
    let mut rows: Vec<_> = window
        .query_all_by_role(Role::Row)
        .map(|row| (row.rect().top(), row.accesskit_node().label().unwrap_or_default()))
        .collect();
    rows.sort_by(|(one, _), (other, _)| one.total_cmp(other));
    rows.into_iter().map(|(_, said)| said).collect()
}

/// What a screen reader says of the row at which the keys are.
pub fn cursor(window: &Harness<'_, App>) -> String {
    let row = window.get_by(|node| node.role() == Role::Row && node.is_selected() == Some(true));
    row.accesskit_node().label().unwrap_or_default()
}
