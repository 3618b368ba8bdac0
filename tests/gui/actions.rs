//! Every key does what its action does: a window driven by keys stays equal to a session that gets the commands.

use fitcheck::session::{CheckAction, CyclesAction, ProgramAction, WindowAction};
use std::collections::BTreeSet;

use eframe::egui::{Id, Key, Modifiers};
use egui_kittest::Harness;
use fitcheck::gui::App;
use fitcheck::session::action::{Held, Part, Shortcut};
use fitcheck::session::parts::{PartsView, PlanCommand};
use fitcheck::session::program::Speed;
use fitcheck::session::{
    Action, CheckCommand, CheckField, Command, CyclesCommand, Effect, Field, FitField, HelpCommand, Mode, Page, Paired,
    PairingCommand, PairingField, PaletteCommand, PartsCommand, ProgramCommand, Purpose, RecordsCommand, Session,
    SettingsField, Step, TablesCommand, Theme,
};
use fitcheck::tolerance::Feature;
use fitcheck::words::Language;

use crate::harness::{nowhere, window};

/// A window, and a session without one.
struct Pair {
    window: Harness<'static, App>,
    session: Session,
    done: BTreeSet<String>,
}

impl Pair {
    fn on(page: Page) -> Self {
        let mut pair = Self { window: window(), session: Session::new(Language::En), done: BTreeSet::new() };
        let nowhere = nowhere();
        pair.apply(RecordsCommand::Begin { usual: None, station: nowhere.station, zone: nowhere.zone }.into());
        pair.apply(Command::SetTheme(Theme::Light));
        pair.apply(Command::Welcome(false));
        pair.apply(Command::SetMode(Mode::Full));
        pair.send(Command::OpenPage(page));
        pair
    }

    fn apply(&mut self, command: Command) {
        let now = jiff::civil::date(2026, 11, 21).at(10, 42, 7, 0);
        for effect in self.session.apply(command, now) {
            // The window pairs at once.
            if let Effect::Pair { run, asked } = effect {
                let paired = std::sync::Arc::new(Paired::of(*asked));
                self.session.apply(PairingCommand::Paired { run, paired }.into(), now);
            }
        }
    }

    /// Gives both a command.
    fn send(&mut self, command: impl Into<Command>) {
        let (command, ctx) = (command.into(), self.window.ctx.clone());
        self.window.state_mut().send(&ctx, command.clone());
        self.window.step();
        self.apply(command);
    }

    #[track_caller]
    fn check_same(&self, what: &str) {
        let (window, session) = (told(self.window.state().session()), told(&self.session));
        let place = window.bytes().zip(session.bytes()).position(|(one, other)| one != other);
        let around = |text: &str, at: usize| text.get(at.saturating_sub(80)..at + 80).unwrap_or_default().to_owned();
        let shown = place.map(|at| (around(&window, at), around(&session, at)));
        assert!(window == session, "after {what}: {shown:?}");
    }

    /// Presses the keys of every action of the page, possible or not.
    #[track_caller]
    fn press_all(&mut self) {
        let page = self.session.page();
        for shortcut in Action::all().flat_map(Action::shortcuts) {
            self.press(shortcut);
            self.clean(page);
        }
    }

    /// Presses keys; the session does the action that they belong to.
    #[track_caller]
    fn press(&mut self, shortcut: Shortcut) {
        self.focus();
        self.follow();
        let page = self.session.page();
        let part = Part::of(page).next();
        let heard = self.session.keys(part, false).into_iter().find(|(heard, _)| *heard == shortcut);
        press(&mut self.window, shortcut);
        if let Some((_, action)) = heard {
            let command = action.command(&self.session).unwrap();
            self.apply(command);
            self.done.insert(named(action, shortcut));
        }
        self.follow();
        self.check_same(&format!("{shortcut} on {page:?} for {heard:?}"));
    }

    /// The session hears which field of the window has the focus, and in which part of the page one is.
    fn follow(&mut self) {
        let help = self.window.state().session().help();
        let (at, within) = (help.at.clone(), help.within.clone());
        self.apply(HelpCommand::At(at).into());
        self.apply(HelpCommand::Within(within).into());
    }

    /// Gives the focus to the part of the page; on pages without one, nothing has it.
    fn focus(&mut self) {
        // Without checks there is no list.
        if let Some(part) = Part::of(self.session.page()).next() {
            self.window.ctx.memory_mut(|memory| memory.request_focus(Id::unique(part.name)));
        }
        self.window.step();
        self.window.step();
    }

    /// Closes the palette and dialogs, and opens the page again.
    fn clean(&mut self, page: Page) {
        if self.session.palette.is_some() {
            self.send(PaletteCommand::Show(false));
        }
        if self.session.dialog().is_some() {
            self.send(Command::Close);
        }
        if self.session.asks_about().is_some() {
            self.send(Command::Discard(false));
        }
        if self.session.page() != page {
            self.send(Command::OpenPage(page));
        }
        if self.session.program().is_running() {
            self.send(ProgramCommand::Pause);
        }
    }

    /// Checks that keys did every action of the page that has some.
    #[track_caller]
    fn check_done(&self) {
        let page = self.session.page();
        // The rows of a large file have keys of their own, which `rows` presses; a field is explained in `help_page`.
        let is_of_rows = |action: &Action| {
            matches!(
                action,
                Action::Check(CheckAction::CancelRows | CheckAction::MoveRow(_) | CheckAction::ShowRow)
                    | Action::Window(WindowAction::Explain)
            )
        };
        for action in Action::all().filter(|action| action.shortcut_on(page).is_some() && !is_of_rows(action)) {
            for shortcut in action.shortcuts() {
                let name = named(action, shortcut);
                assert!(self.done.contains(&name), "{name} was never possible on {page:?}");
            }
        }
    }
}

/// An action by its own name, without the page's, and its keys.
fn named(action: Action, shortcut: Shortcut) -> String {
    let action = format!("{action:?}");
    let (_page, name) = action.split_once('(').unwrap();
    format!("{name} {shortcut}")
}

/// A whole session as text; of a program, whose labels have no order, only what is seen.
fn told(session: &Session) -> String {
    let program = session.program();
    let Some(document) = program.shown() else { return format!("{session:?}") };
    let run = program.run.as_ref().map(|run| (run.state, run.place(), run.blocks_run(), run.calls().count()));
    let block = (document.selected, program.has_breakpoint(document.selected), program.look());
    let over = (session.page(), session.dialog(), session.notices());
    format!("{run:?} {block:?} {over:?} {:?}", program.state_message())
}

fn press(window: &mut Harness<'_, App>, shortcut: Shortcut) {
    let modifiers = match shortcut.held {
        Held::Nothing => Modifiers::NONE,
        Held::Shift => Modifiers::SHIFT,
        Held::Ctrl => Modifiers::COMMAND,
        Held::CtrlShift => Modifiers::COMMAND | Modifiers::SHIFT,
        Held::Alt => Modifiers::ALT,
    };
    // As the key is shown: `←` is the arrow of another shape in the window's font.
    let name = match shortcut.key.to_string().as_str() {
        "←" => "Left".to_owned(),
        "→" => "Right".to_owned(),
        "↑" => "Up".to_owned(),
        "↓" => "Down".to_owned(),
        name => name.to_owned(),
    };
    window.key_press_modifiers(modifiers, Key::from_name(&name).unwrap());
    window.step();
}

#[test]
fn keys_of_the_check_page() {
    let mut pair = Pair::on(Page::Check);
    pair.press_all();
    pair.send(Field::from(CheckField::Callout).typed("25 H7".to_owned()));
    pair.send(Field::from(CheckField::Measured).typed("25.012".to_owned()));
    // Undo takes a check away, and the other keys still have some.
    for _ in 0..3 {
        pair.send(CheckCommand::Measure);
    }
    pair.press_all();
    let rows = b"callout,measured\n25 H7,25.012\n25 H7,25.03\n25 H7,24.99\n";
    let imported = fitcheck::exchange::import(
        "parts.csv",
        rows,
        pair.session.sources(),
        jiff::civil::date(2026, 11, 21).at(10, 42, 7, 0),
    );
    pair.send(CheckCommand::Imported { name: "parts.csv".to_owned(), result: Ok(Box::new(imported)) });
    for step in [Step::Right, Step::Left, Step::Last, Step::First] {
        pair.press(Action::from(CheckAction::ShowInLot(step)).shortcuts().next().unwrap());
    }
    pair.send(Command::Close);
    pair.send(Command::OpenDialog(Purpose::Import));
    pair.press(Action::from(WindowAction::Import).shortcuts().next().unwrap());
    pair.press(Action::from(WindowAction::Close).shortcuts().next().unwrap());
    assert!(pair.session.dialog().is_none());
    pair.check_done();
}

#[test]
fn keys_of_the_fit_page() {
    let mut pair = Pair::on(Page::Fit);
    pair.send(Field::from(FitField::Callout).typed("25 H7/g6".to_owned()));
    pair.press_all();
    let done = pair.done.iter().filter(|name| name.starts_with("MoveClass")).count();
    assert_eq!(done, 4);
}

#[test]
fn keys_of_the_settings_page() {
    let mut pair = Pair::on(Page::Settings);
    pair.send(Field::from(SettingsField::Find).typed("zoom".to_owned()));
    pair.press_all();
    for name in ["FindSetting", "Close"] {
        assert!(pair.done.iter().any(|done| done.starts_with(name)), "{name} was never possible");
    }
}

#[test]
fn keys_of_the_pairing_page() {
    let mut pair = Pair::on(Page::Check);
    for (callout, measured) in [("25 H7", "25.012"), ("25 H7", "25.004"), ("25 g6", "24.990"), ("25 g6", "24.985")] {
        pair.send(Field::from(CheckField::Callout).typed(callout.to_owned()));
        pair.send(Field::from(CheckField::Measured).typed(measured.to_owned()));
        pair.send(CheckCommand::Measure);
    }
    pair.send(Command::OpenPage(Page::Pairing));
    pair.send(PairingCommand::TakeHistory(Feature::Hole));
    pair.send(PairingCommand::TakeHistory(Feature::Shaft));
    pair.send(Field::from(PairingField::Wanted).typed("0..0.1".to_owned()));
    pair.press_all();
    for name in ["OpenParts(Hole)", "OpenParts(Shaft)", "SavePairs(0)", "CopyPairs"] {
        assert!(pair.done.iter().any(|done| done.starts_with(name)), "{name} was never possible");
    }
    assert_eq!(pair.done.iter().filter(|name| name.starts_with("MovePair")).count(), 6);
}

#[test]
fn keys_of_the_cycles_page() {
    let mut pair = Pair::on(Page::Cycles);
    pair.press_all();
    let block = "TCH PROBE 421 ~\nQ273=0~\nQ274=0~\nQ262=25~\nQ275=25.02~\nQ276=25";
    pair.send(CyclesCommand::TypeBlock(block.to_owned()));
    pair.send(CyclesCommand::TakeBlock);
    pair.press_all();
    pair.press(Action::from(CyclesAction::StepPath(Step::Left)).shortcuts().next().unwrap());
    let done = pair.done.iter().filter(|name| name.starts_with("StepPath") || name.starts_with("RunCycle")).count();
    assert_eq!(done, 5);
}

#[test]
fn keys_of_the_table_page() {
    let mut pair = Pair::on(Page::Tables);
    pair.press_all();
    pair.send(TablesCommand::EmptyCell);
    pair.press_all();
    pair.press_all();
    let wanted =
        ["UndoEdit", "RedoEdit", "NextDifference", "PreviousDifference", "FindInTable", "EditCell", "EmptyCell"];
    for name in wanted {
        assert!(pair.done.iter().any(|done| done.starts_with(name)), "{name} was never possible");
    }
    assert_eq!(pair.done.iter().filter(|name| name.starts_with("MoveCell")).count(), 10);
}

#[test]
fn keys_of_the_parts_page() {
    let mut pair = Pair::on(Page::Parts);
    pair.send(PartsCommand::Plan(PlanCommand::New));
    pair.send(PartsCommand::Show(PartsView::Plan));
    pair.press_all();
    pair.press_all();
    let wanted =
        ["UndoPlan", "RedoPlan", "InsertPlanRow", "DeletePlanRows", "NextFinding", "PreviousFinding", "EditPlanCell"];
    for name in wanted {
        assert!(pair.done.iter().any(|done| done.starts_with(name)), "{name} was never possible: {:?}", pair.done);
    }
    assert_eq!(pair.done.iter().filter(|name| name.starts_with("MoveInPlan")).count(), 10);
    assert_eq!(pair.done.iter().filter(|name| name.starts_with("ExtendInPlan")).count(), 10);
}

#[test]
fn keys_of_the_help_page() {
    let mut pair = Pair::on(Page::Help);
    pair.press_all();
    pair.press_all();
    for name in ["SearchHelp", "BackInHelp", "ReadTopic", "Help"] {
        assert!(pair.done.iter().any(|done| done.starts_with(name)), "{name} was never possible: {:?}", pair.done);
    }
    assert_eq!(pair.done.iter().filter(|name| name.starts_with("MoveTopic")).count(), 4);
    assert_eq!(pair.done.iter().filter(|name| name.starts_with("ScrollHelp")).count(), 2);
}

#[test]
fn keys_of_the_budget_page() {
    let mut pair = Pair::on(Page::Budget);
    pair.press_all();
    pair.press_all();
    for name in ["NewBudget", "OpenBudget", "SaveBudget"] {
        assert!(pair.done.iter().any(|done| done.starts_with(name)), "{name} was never possible");
    }
}

#[test]
fn keys_of_the_program_page() {
    let mut pair = Pair::on(Page::Program);
    pair.press_all();
    // A key that another page uses too may have run the program to its end.
    pair.send(ProgramCommand::Reset);
    for action in [ProgramAction::StepProgram, ProgramAction::StepOver] {
        pair.press(Action::from(action).shortcuts().next().unwrap());
    }
    for name in ["RunProgram", "StepProgram", "StepOver", "RunToSelected", "ToggleBreakpoint", "ResetProgram"] {
        assert!(pair.done.iter().any(|done| done.starts_with(name)), "{name} was never possible");
    }
    assert_eq!(pair.done.iter().filter(|name| name.starts_with("MoveBlock")).count(), 6);
    // The key that otherwise closes what lies over the page pauses a run that goes on.
    pair.send(ProgramCommand::SetSpeed(Speed::Slow));
    pair.send(ProgramCommand::Reset);
    pair.send(ProgramCommand::Run);
    assert!(pair.session.program().is_running());
    press(&mut pair.window, Action::from(ProgramAction::PauseProgram).shortcuts().next().unwrap());
    assert!(!pair.window.state().session().program().is_running());
}
