//! The table of commands: complete, without duplicate keys, and the same as in the manual.

use fitcheck::session::{CheckAction, CyclesAction, FilesAction, ProgramAction, TablesAction, WindowAction};
use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use fitcheck::session::action::{Action, ActionScope, Key, Shortcut};
use fitcheck::session::{
    CheckCommand, CheckField, Command, CyclesCommand, Field, FilesCommand, FitField, Page, ProgramCommand,
    ProgramField, Session, TablesCommand, TablesField,
};
use fitcheck::words::{Language, Words};
use jiff::civil::DateTime;

fn now() -> DateTime {
    jiff::civil::date(2026, 11, 21).at(10, 42, 7, 0)
}

/// A session in which much is possible: a check, a fit, a run of a cycle, an edited table, a program that was stepped.
fn busy(page: Page) -> Session {
    let mut session = Session::new(Language::En);
    let mut commands: Vec<Command> = Page::ALL.map(Command::OpenPage).to_vec();
    commands.extend([
        Field::from(CheckField::Callout).typed("25 H7".into()),
        Field::from(CheckField::Measured).typed("25.012".into()),
        CheckCommand::Measure.into(),
        Field::from(FitField::Callout).typed("25 H7/g6".into()),
        CyclesCommand::TypeBlock("TCH PROBE 421 ~\nQ273=0~\nQ274=0~\nQ262=25~\nQ275=25.02~\nQ276=25".into()).into(),
        CyclesCommand::TakeBlock.into(),
        CyclesCommand::Run.into(),
        TablesCommand::EmptyCell.into(),
        ProgramCommand::Step.into(),
        Command::OpenPage(page),
    ]);
    for command in commands {
        session.apply(command, now());
    }
    session
}

#[test]
fn every_action_has_its_texts_in_every_language() {
    let session = busy(Page::Tables);
    let mut missing = Vec::new();
    for language in Language::all() {
        let words = Words::new(language);
        for action in Action::all() {
            let text = action.text(&session, &words);
            // A missing text is shown as its name.
            if text.chars().all(|c| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '-') {
                missing.push(format!("assets/locales/{language} has no text {text}: the name of {action:?}"));
            }
            if text.contains('{') {
                missing.push(format!("assets/locales/{language} asks for more than {action:?} gives: {text}"));
            }
            if let Some(hint) = action.hint().filter(|id| words.find(id).is_none()) {
                missing.push(format!("assets/locales/{language} has no text {hint}: the hint of {action:?}"));
            }
        }
    }
    assert!(missing.is_empty(), "{} texts:\n{}", missing.len(), missing.join("\n"));
}

#[test]
fn every_action_is_listed_once() {
    let all: Vec<Action> = Action::all().collect();
    assert!(90 < all.len(), "{}", all.len());
    assert_eq!(all.iter().collect::<std::collections::HashSet<_>>().len(), all.len());
}

/// How near a place is: where a nearer one has the same keys, that one counts.
fn nearness(place: ActionScope) -> u8 {
    match place {
        ActionScope::Part(_) | ActionScope::Dialog => 0,
        ActionScope::Page(_) | ActionScope::Workpiece => 1,
        ActionScope::Everywhere => 2,
    }
}

#[test]
fn no_two_actions_share_keys_on_a_page() {
    for page in Page::ALL {
        let mut taken = BTreeMap::new();
        for action in Action::all().filter(|action| action.place().is_on(page)) {
            for shortcut in action.shortcuts() {
                // Of two parts of a page only one has the focus.
                let part = matches!(action.place(), ActionScope::Part(_)).then(|| format!("{:?}", action.place()));
                let place = (nearness(action.place()), part, shortcut.to_string());
                let before = taken.insert(place, action);
                assert_eq!(before, None, "{shortcut} on {page:?}: {action:?}");
            }
        }
    }
}

#[test]
fn the_keys_that_are_told_are_those_that_are_heard() {
    for page in Page::ALL {
        let session = busy(page);
        let heard = session.keys(None, false);
        for action in
            Action::all().filter(|action| !matches!(action.place(), ActionScope::Part(_)) && session.can(*action))
        {
            let Some(told) = action.shortcut_on(page) else { continue };
            let first = heard.iter().find(|(shortcut, _)| *shortcut == told).map(|(_, action)| *action);
            assert_eq!(first, Some(action), "{told} on {page:?}");
        }
    }
}

#[test]
fn the_page_has_the_first_word() {
    let open = Shortcut { held: fitcheck::session::action::Held::Ctrl, key: Key::Character('O') };
    for (page, action, import) in [
        (Page::Check, Action::from(WindowAction::Import), Some(open)),
        (Page::Tables, TablesAction::OpenTable.into(), None),
        (Page::Program, ProgramAction::OpenProgram.into(), None),
    ] {
        assert_eq!(action.shortcut_on(page), Some(open));
        assert_eq!(Action::from(WindowAction::Import).shortcut_on(page), import, "{page:?}");
    }
    assert_eq!(Action::from(TablesAction::OpenTable).shortcut_on(Page::Check), None);
}

#[test]
fn what_is_impossible_sends_nothing_and_hears_no_keys() {
    for page in Page::ALL {
        for mut session in std::iter::once(Session::new(Language::En)).chain(std::iter::once(busy(page))) {
            session.apply(Command::OpenPage(page), now());
            let keys = session.keys(None, false);
            for action in Action::all() {
                let can = session.can(action);
                assert_eq!(action.command(&session).is_some(), can, "{action:?}");
                assert!(can || keys.iter().all(|(_, heard)| *heard != action), "{action:?}");
            }
        }
    }
    let fresh = Session::new(Language::En);
    for action in [
        Action::from(WindowAction::Export(0)),
        WindowAction::ExportStatus.into(),
        WindowAction::Undo.into(),
        WindowAction::ClearHistory.into(),
        CheckAction::CopyStatus.into(),
        WindowAction::Close.into(),
        CyclesAction::SaveLog.into(),
        TablesAction::UndoEdit.into(),
        ProgramAction::PauseProgram.into(),
        ProgramAction::ResetProgram.into(),
    ] {
        assert!(!fresh.can(action), "{action:?}");
    }
}

#[test]
fn what_is_possible_can_be_done_on_every_page() {
    for page in Page::ALL {
        let mut session = busy(page);
        for action in Action::all() {
            if let Some(command) = action.command(&session) {
                session.apply(command, now());
            }
        }
    }
}

#[test]
fn a_dialog_hears_only_its_own_keys_and_what_closes_it() {
    let mut session = busy(Page::Program);
    session.apply(Command::OpenDialog(fitcheck::session::Purpose::Import), now());
    let keys: Vec<_> = session.keys(None, false).into_iter().map(|(_, action)| action).collect();
    assert_eq!(keys, [WindowAction::Close.into()], "there is no folder to move in");
    session.apply(FilesCommand::Show("/shop".into()).into(), now());
    let keys: Vec<_> = session.keys(None, false).into_iter().map(|(_, action)| action).collect();
    assert_eq!(keys, [FilesAction::FolderUp.into(), WindowAction::Close.into()]);
    assert!(session.can(FilesAction::AllFiles) && session.can(FilesAction::Browse));
    for page in Page::ALL {
        let busy = busy(page);
        let dialog = |action: &Action| action.place() == ActionScope::Dialog;
        assert!(Action::all().filter(dialog).all(|action| !busy.can(action)), "without a dialog");
    }
}

#[test]
fn enter_measures_where_there_is_something_to_measure() {
    for (field, page, action) in [
        (Field::from(CheckField::Measured), Page::Check, Some(Action::from(CheckAction::Measure))),
        (FitField::HoleMeasured.into(), Page::Fit, None),
        (TablesField::Filter.into(), Page::Tables, None),
        (TablesField::CellUpper.into(), Page::Tables, Some(TablesAction::SetCell.into())),
        (TablesField::To.into(), Page::Tables, Some(TablesAction::MakeTable.into())),
        (fitcheck::session::WorkpieceField::Seed.into(), Page::Cycles, Some(CyclesAction::RunCycle.into())),
        (fitcheck::session::WorkpieceField::Seed.into(), Page::Program, Some(ProgramAction::RunProgram.into())),
        (ProgramField::Filter.into(), Page::Program, None),
        (ProgramField::Value.into(), Page::Program, Some(ProgramAction::GiveValue.into())),
    ] {
        assert_eq!(Action::on_enter(field, page), action, "{field:?}");
    }
}

/// Whether keys need no focus in a part and do not type text: `F5`, `Ctrl+O`.
fn is_told(word: &str) -> bool {
    let key = word.rsplit('+').next().unwrap_or(word);
    let number = key.strip_prefix('F').unwrap_or_default();
    let is_function = !number.is_empty() && number.chars().all(|c| c.is_ascii_digit());
    is_function || ["Ctrl+", "Shift+", "Alt+"].iter().any(|held| word.starts_with(held)) || word == "Esc"
}

#[test]
fn the_manual_tells_the_keys_of_the_table() {
    let keys = Action::all().flat_map(Action::shortcuts).map(|shortcut| shortcut.to_string());
    let keys: BTreeSet<String> = keys.filter(|keys| is_told(keys)).collect();
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    assert_eq!(told_in(&root.join("docs/manual/window.md")), keys);
    let pages = std::fs::read_dir(root.join("docs/manual")).unwrap().map(|entry| entry.unwrap().path());
    for page in pages.chain([root.join("README.md")]) {
        let unknown: Vec<String> = told_in(&page).difference(&keys).cloned().collect();
        assert!(unknown.is_empty(), "{}: {unknown:?}", page.display());
    }
}

/// The keys that a document names.
fn told_in(document: &Path) -> BTreeSet<String> {
    let text = std::fs::read_to_string(document).unwrap();
    let words = text.split(|c: char| c.is_whitespace() || "|,.;:()*`".contains(c));
    words.filter(|word| is_told(word)).map(str::to_owned).collect()
}
