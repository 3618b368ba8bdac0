//! What is done in a shift, by keys alone and by touch alone, in the operator's window and in the full one: a language is chosen, a size is
//! checked, a part of six features is measured with one wrong value corrected, its reasons are read, and its report is written.

use eframe::egui::accesskit::Role;
use eframe::egui::{Event, Key, Modifiers, PointerButton, Pos2, TouchDeviceId, TouchId, TouchPhase, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use fitcheck::gui::App;
use fitcheck::session::{Action, CheckField, Mode, Page, PartsAction, Purpose};
use fitcheck::verdict::Status;
use fitcheck::words::{Language, Words};

use crate::dialogs::put;
use crate::harness::{Window, scan, settle, verdict};

const PLAN: &str = "number;name;callout;x;y;z\n1;BORE;25 H7;40;30;-8\n2;PIN;20 g6;40;90;-8\n3;SEAT;8 H7;10;10;-5\n\
    4;HOLE_1;6 H9;5;5;-5\n5;HOLE_2;6 H9;15;5;-5\n6;SLEEVE;30 h6;60;60;-8\n";

/// A good value of each feature.
const VALUES: [&str; 6] = ["25.012", "19.99", "8.003", "6.01", "6.02", "29.995"];

/// What the user has.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Hand {
    Keys,
    Touch,
}

/// As many stops of Tab lead round the largest page.
const ROUND: usize = 150;

struct User {
    window: Harness<'static, App>,
    hand: Hand,
    words: Words,
}

impl User {
    fn text(&self, id: &str) -> String {
        self.words.get(id)
    }

    /// Goes to what has a role and a name, and presses it.
    fn press(&mut self, role: Role, name: &str) {
        match self.hand {
            Hand::Keys => {
                self.tab_to(role, name);
                self.window.key_press(Key::Space);
            }
            Hand::Touch => {
                match self.window.query_by_role_and_label(role, name) {
                    Some(node) => node.scroll_to_me(),
                    None => self.lacks(role, name),
                }
                self.window.run();
                let at = self.window.get_by_role_and_label(role, name).rect().center();
                self.touch(at);
            }
        }
        self.window.run();
    }

    fn tab_to(&mut self, role: Role, name: &str) {
        let is_there = |window: &Harness<'_, App>| {
            window
                .query_by(|node| node.is_focused() && node.role() == role && node.label().as_deref() == Some(name))
                .is_some()
        };
        for _ in 0..ROUND {
            if is_there(&self.window) {
                return;
            }
            scan(&mut self.window, "⇥");
        }
        self.lacks(role, name);
    }

    fn lacks(&self, role: Role, name: &str) -> ! {
        let names: Vec<_> = self.window.query_all_by_role(role).map(|node| node.accesskit_node().label()).collect();
        panic!("{role:?} {name:?} is not reached; there are {names:?}");
    }

    /// What a system tells of a finger: a touch, and the pointer that follows it.
    fn touch(&mut self, at: Pos2) {
        let of_finger =
            |phase| Event::Touch { device_id: TouchDeviceId(1), id: TouchId(1), phase, pos: at, force: Some(0.5) };
        let button = |pressed| Event::PointerButton {
            pos: at,
            button: PointerButton::Primary,
            pressed,
            modifiers: Modifiers::NONE,
        };
        for event in [of_finger(TouchPhase::Start), Event::PointerMoved(at), button(true)] {
            self.window.event(event);
        }
        self.window.step();
        for event in [of_finger(TouchPhase::End), button(false), Event::PointerGone] {
            self.window.event(event);
        }
        settle(&mut self.window);
    }

    /// Types into a field that may have the focus already, and ends it with Enter.
    fn enter(&mut self, field: &str, text: &str) {
        match self.hand {
            Hand::Keys => {
                self.tab_to(Role::TextInput, field);
                scan(&mut self.window, &format!("{text}⏎"));
            }
            Hand::Touch => {
                self.press(Role::TextInput, field);
                text.chars().for_each(|sign| self.tap(sign));
                // The operator's window has a large button in the place of this key.
                let enter = self.text("key-enter");
                let is_there = self.window.query_by_role_and_label(Role::Button, &enter).is_some();
                let judge = if self.text_of_callout(field) { "operator-to-value" } else { "judge" };
                let name = if is_there { enter } else { self.text(judge) };
                self.press(Role::Button, &name);
            }
        }
    }

    fn text_of_callout(&self, field: &str) -> bool {
        field == self.text("callout")
    }

    /// A key of the keypad, on whichever sheet it is.
    fn tap(&mut self, sign: char) {
        if matches!(sign, ',' | '.') {
            let name = self.text("key-decimal");
            return self.press(Role::Button, &name);
        }
        let name = format!("{} {sign}", self.text("key"));
        let sheet = if sign.is_ascii_digit() { "key-figures" } else { "key-letters" };
        let sheet = self.text(sheet);
        if self.window.query_by_role_and_label(Role::Button, &name).is_none() {
            self.press(Role::Button, &sheet);
        }
        self.press(Role::Button, &name);
    }

    /// The class of a callout, on the sheet of its side.
    fn class(&mut self, class: &str) {
        let (sheet, key) = (self.text("key-holes"), format!("{} {class}", self.text("key")));
        self.press(Role::Button, &sheet);
        self.press(Role::Button, &key);
    }

    fn chooses_language_and_mode(&mut self, mode: Mode) {
        let operator = match mode {
            Mode::Operator => "operator-mode-operator",
            Mode::Full => "operator-mode-full",
        };
        if self.hand == Hand::Touch {
            // The first touch asks for both.
            self.touch(eframe::egui::pos2(2.0, 2.0));
            self.press(Role::RadioButton, "Nederlands");
            self.words = Words::new(Language::Nl);
            let name = self.text(operator);
            return self.press(Role::Button, &name);
        }
        self.press(Role::Button, "Settings");
        self.press(Role::ComboBox, "Language");
        self.press(Role::Button, "Nederlands");
        self.words = Words::new(Language::Nl);
        let name = self.text(operator);
        self.press(Role::RadioButton, &name);
    }

    fn checks_one_size(&mut self) {
        self.opens(Page::Check, "operator-one-size");
        let (callout, value) = (self.text("callout"), self.text("measured-value"));
        match self.hand {
            Hand::Keys => self.enter(&callout, "25 H7"),
            Hand::Touch => {
                self.press(Role::TextInput, &callout);
                "25".chars().for_each(|sign| self.tap(sign));
                self.class("H7");
            }
        }
        self.enter(&value, "25,030");
        let scrap = self.text("status-scrap");
        assert!(verdict(&self.window).starts_with(&scrap), "{}", verdict(&self.window));
        assert_eq!(self.window.state().session().text(CheckField::Callout), "25 H7");
    }

    /// By the rail, or by the buttons that an operator has.
    fn opens(&mut self, page: Page, of_operator: &str) {
        if self.window.state().session().page() == page {
            return;
        }
        let is_operator = self.window.state().session().is_for_operators();
        let name = self.text(if is_operator { of_operator } else { page.name() });
        self.press(Role::Button, &name);
        assert_eq!(self.window.state().session().page(), page);
    }

    fn measures(&mut self, value: &str) {
        let field = self.text("walk-page-value");
        self.enter(&field, &value.replace('.', ","));
    }

    fn walks(&mut self) {
        self.opens(Page::Parts, "operator-part");
        let serial = self.text("walk-page-serial");
        if self.hand == Hand::Keys {
            self.enter(&serial, "A17");
        } else {
            self.press(Role::TextInput, &serial);
            "A17".chars().for_each(|sign| self.tap(sign));
            let begin = self.text("walk-page-begin");
            self.press(Role::Button, &begin);
        }
        for value in &VALUES[..2] {
            self.measures(value);
        }
        self.measures("8.018");
        assert!(verdict(&self.window).starts_with(&self.text("status-scrap")), "{}", verdict(&self.window));
        let why = self.text("why");
        self.press(Role::Button, &why);
        assert!(self.window.query_by_label_contains("Grensmaten uit ISO 286").is_some(), "the reasons are in sight");
        self.press(Role::Button, &why);
        match self.hand {
            Hand::Keys => {
                self.window.key_press_modifiers(Modifiers::COMMAND, Key::Z);
                self.window.run();
            }
            Hand::Touch => {
                let is_operator = self.window.state().session().is_for_operators();
                let undo = self.text(if is_operator { "operator-undo" } else { "top-undo" });
                self.press(Role::Button, &undo);
            }
        }
        let walking = &self.window.state().session().parts().walking;
        assert_eq!((walking.at, walking.values(2).len()), (Some(2), 0), "back at the feature");
        for value in &VALUES[2..] {
            self.measures(value);
        }
        assert_eq!(self.window.state().session().parts().walking.status(), Some(Status::Good));
        // The last verdict is read.
        if self.window.state().session().rests() && self.window.state().session().is_for_operators() {
            let next = self.text("operator-next");
            self.press(Role::Button, &next);
        }
    }

    fn writes_the_report(&mut self) {
        if self.window.state().session().is_for_operators() {
            let report = self.text("operator-report");
            return self.press(Role::Button, &report);
        }
        let report = self.text("walk-page-report");
        self.press(Role::Button, &report);
        let for_people = Action::from(PartsAction::ReportPart(0)).text(self.window.state().session(), &self.words);
        self.press(Role::Button, &for_people);
        // A name is proposed.
        let save = self.text("dialog-save");
        self.press(Role::Button, &save);
    }
}

fn shift(hand: Hand, mode: Mode) {
    let folder = tempfile::tempdir().unwrap();
    let plan = folder.path().join("flange.csv");
    put(&plan, PLAN);
    let size = if mode == Mode::Operator { vec2(1024.0, 768.0) } else { vec2(1280.0, 800.0) };
    let window = Window {
        size,
        home: Some(folder.path().to_owned()),
        is_first: true,
        files: vec![(Purpose::OpenPlan, plan)],
        ..Window::default()
    };
    let mut user = User { window: window.open(), hand, words: Words::new(Language::En) };
    user.chooses_language_and_mode(mode);
    assert_eq!(user.window.state().session().language(), Language::Nl);
    assert_eq!(user.window.state().session().mode(), mode);
    if hand == Hand::Touch && !user.window.state().session().has_keypad() {
        let keypad = user.text("keypad");
        user.press(Role::Button, &keypad);
    }
    user.checks_one_size();
    user.walks();
    user.writes_the_report();
    let mut files = std::fs::read_dir(folder.path()).unwrap().map(|entry| entry.unwrap().path());
    let report = files.find(|path| path.extension().is_some_and(|ending| ending == "html"));
    let report = std::fs::read_to_string(report.expect("a report was written")).unwrap();
    for said in ["A17", "SEAT", "8,003"] {
        assert!(report.contains(said), "{said}");
    }
    assert!(!report.contains("8,018"), "what was undone is not in the report");
}

#[test]
fn an_operators_shift_by_keys_alone() {
    shift(Hand::Keys, Mode::Operator);
}

#[test]
fn an_operators_shift_by_touch_alone() {
    shift(Hand::Touch, Mode::Operator);
}

#[test]
fn a_shift_in_the_full_window_by_keys_alone() {
    shift(Hand::Keys, Mode::Full);
}

#[test]
fn a_shift_in_the_full_window_by_touch_alone() {
    shift(Hand::Touch, Mode::Full);
}
