//! The history: filter, order, choice, copy, export, undo.

use std::io::Read as _;

use fitcheck::exchange::import;
use fitcheck::journal::query::{Column, RecordId};
use fitcheck::report::{RENDERINGS, of_any_paper};
use fitcheck::session::{
    Action, CheckCommand, CheckField, Command, Effect, Field, ListCommand, MeasureBy, Page, Purpose, Session, Step,
};
use fitcheck::session::{CheckAction, TablesAction, WindowAction};
use fitcheck::verdict::Status;
use fitcheck::words::{Language, Words};
use jiff::civil::{DateTime, date};

fn now() -> DateTime {
    date(2026, 11, 21).at(10, 42, 7, 0)
}

fn run(session: &mut Session, commands: impl IntoIterator<Item = Command>) -> Vec<Effect> {
    commands.into_iter().map(|command| session.apply(command, now())).last().unwrap_or_default()
}

fn typed(field: impl Into<Field>, text: &str) -> Command {
    field.into().typed(text.to_owned())
}

fn measure(session: &mut Session, part: &str, callout: &str, measured: &str) {
    run(
        session,
        [
            typed(CheckField::Callout, callout),
            typed(CheckField::Part, part),
            typed(CheckField::Measured, measured),
            CheckCommand::Measure.into(),
        ],
    );
}

/// A good, a rework and a scrap part, and a simulated one: A10, A2, B, C.
fn four(language: Language) -> Session {
    let mut session = Session::new(language);
    measure(&mut session, "A10", "25 H7", "25.012");
    measure(&mut session, "A2", "25 H7", "24.998");
    measure(&mut session, "B", "40 g6", "39.9");
    let by = CheckCommand::MeasureBy(MeasureBy::Simulating).into();
    run(&mut session, [typed(CheckField::Callout, "8 H7"), typed(CheckField::Part, "C"), by]);
    run(&mut session, [CheckCommand::Measure.into()]);
    session
}

/// The parts in the list, from above.
fn listed(session: &Session) -> String {
    let listed = session.history().listed();
    let parts: Vec<_> = listed.page(0..listed.count()).iter().map(|(_, record)| record.id.clone()).collect();
    parts.join(" ")
}

fn filter(session: &mut Session, text: &str) -> String {
    run(session, [typed(CheckField::HistoryFilter, text)]);
    listed(session)
}

fn list(session: &mut Session, command: ListCommand) -> Vec<Effect> {
    run(session, [command.into()])
}

fn cursor(session: &Session) -> String {
    let id = session.history().cursor.unwrap();
    session.history().get(id).unwrap().id.clone()
}

fn name(session: &Session, action: Action) -> String {
    action.text(session, &Words::new(session.language()))
}

/// The notices in words, oldest first.
fn notices(session: &Session) -> Vec<String> {
    let words = Words::new(session.language());
    session.notices().iter().map(|notice| words.say(&notice.message)).collect()
}

#[test]
fn a_column_sorts_up_then_down_then_not_at_all() {
    let mut session = four(Language::En);
    assert_eq!(listed(&session), "C B A2 A10", "the newest is first");
    for (column, up) in [
        (Column::Time, "A10 A2 B C"),
        (Column::Part, "A2 A10 B C"),
        (Column::Callout, "C A10 A2 B"),
        (Column::Measured, "C A2 A10 B"),
        (Column::Deviation, "B A2 C A10"),
        (Column::Status, "A10 C A2 B"),
        (Column::From, "A10 A2 B C"),
    ] {
        list(&mut session, ListCommand::SortBy(column));
        assert_eq!(listed(&session), up, "{column:?} ascending");
        list(&mut session, ListCommand::SortBy(column));
        let down: Vec<_> = up.split(' ').rev().collect();
        assert_eq!(listed(&session), down.join(" "), "{column:?} descending");
        list(&mut session, ListCommand::SortBy(column));
        assert_eq!(listed(&session), "C B A2 A10", "{column:?} no more");
    }
    // Another column starts anew.
    list(&mut session, ListCommand::SortBy(Column::Part));
    list(&mut session, ListCommand::SortBy(Column::Measured));
    assert_eq!(listed(&session), "C A2 A10 B");
}

#[test]
fn the_filter_knows_values_and_the_words_of_the_language() {
    let mut session = four(Language::En);
    for (text, expected) in [
        ("a2", "A2"),
        ("h7 a", "C A2 A10"),
        ("25 h7", "A2 A10"),
        ("24.998", "A2"),
        ("scrap", "B"),
        ("good", "C A10"),
        ("good 25", "A10"),
        ("simulated", "C"),
        ("typed", "B A2 A10"),
        ("2026-11-21", "C B A2 A10"),
        ("none such", ""),
        ("", "C B A2 A10"),
    ] {
        assert_eq!(filter(&mut session, text), expected, "{text:?}");
    }
    filter(&mut session, "goed");
    assert_eq!(listed(&session), "");
    run(&mut session, [Command::SetLanguage(Language::Nl)]);
    assert_eq!(listed(&session), "C A10", "the filter follows the language");
}

#[test]
fn a_filter_takes_no_verdict_away_and_is_not_kept() {
    let mut session = four(Language::En);
    assert!(session.check().shown.is_some());
    filter(&mut session, "B");
    assert!(session.check().shown.is_some());
    assert_eq!(session.saved().inputs.texts.get("history-filter"), None);
    assert!(session.saved().inputs.texts.contains_key("callout"));
}

#[test]
fn only_bad_leaves_the_good_ones_out() {
    let mut session = four(Language::En);
    assert_eq!(CheckAction::OnlyBad.is_on(&session), Some(false));
    let turn = CheckAction::OnlyBad.command(&session).unwrap();
    run(&mut session, [turn]);
    assert_eq!((listed(&session).as_str(), CheckAction::OnlyBad.is_on(&session)), ("B A2", Some(true)));
    // A new check joins the list only where it is bad.
    measure(&mut session, "D", "25 H7", "25.010");
    measure(&mut session, "E", "25 H7", "25.03");
    run(&mut session, [CheckCommand::MeasureBy(MeasureBy::Typing).into()]);
    assert_eq!(listed(&session), "E B A2");
    let turn = CheckAction::OnlyBad.command(&session).unwrap();
    run(&mut session, [turn]);
    assert_eq!(listed(&session), "E D C B A2 A10");
}

#[test]
fn the_keys_walk_the_rows_as_they_are_listed() {
    let mut session = Session::new(Language::En);
    list(&mut session, ListCommand::Move(Step::Down));
    assert_eq!(session.history().cursor, None);
    for number in 0..25 {
        measure(&mut session, &format!("P{number}"), "25 H7", "25.012");
    }
    assert_eq!(cursor(&session), "P24", "a new check takes the cursor");
    for (step, part) in [
        (Step::Up, "P24"),
        (Step::Down, "P23"),
        (Step::PageDown, "P13"),
        (Step::PageDown, "P3"),
        (Step::PageDown, "P0"),
        (Step::PageUp, "P10"),
        (Step::First, "P24"),
        (Step::Last, "P0"),
        (Step::Down, "P0"),
        (Step::Up, "P1"),
    ] {
        list(&mut session, ListCommand::Move(step));
        assert_eq!(cursor(&session), part, "{step:?}");
    }
    // The cursor stays on its check when the order changes, and starts above where it is filtered out.
    list(&mut session, ListCommand::SortBy(Column::Part));
    list(&mut session, ListCommand::Move(Step::Down));
    assert_eq!(cursor(&session), "P2");
    filter(&mut session, "P1");
    assert!(!session.can(CheckAction::ShowCheck), "a row out of sight is not shown by Enter");
    list(&mut session, ListCommand::Move(Step::Down));
    assert_eq!(cursor(&session), "P1");
}

#[test]
fn a_row_is_shown_and_chosen_by_its_action() {
    let mut session = four(Language::En);
    list(&mut session, ListCommand::Move(Step::Last));
    let show = CheckAction::ShowCheck.command(&session).unwrap();
    run(&mut session, [show]);
    assert_eq!(session.check().shown.as_ref().unwrap().record.id, "A10");
    for expected in [true, false, true] {
        let choose = CheckAction::ChooseCheck.command(&session).unwrap();
        run(&mut session, [choose]);
        assert_eq!(session.history().is_chosen(RecordId(0)), expected);
    }
}

#[test]
fn everything_listed_can_be_chosen_or_only_the_bad() {
    let mut session = four(Language::En);
    filter(&mut session, "25");
    list(&mut session, ListCommand::ChooseAll);
    assert_eq!((session.history().chosen_count(), session.history().hidden_count()), (2, 0));
    filter(&mut session, "B");
    assert_eq!((session.history().chosen_count(), session.history().hidden_count()), (2, 2));
    filter(&mut session, "");
    assert_eq!(session.history().hidden_count(), 0);
    assert_eq!(name(&session, WindowAction::ChooseBad.into()), "Choose 2 checks that are not good");
    list(&mut session, ListCommand::ChooseBad);
    let chosen = |session: &Session| (0..4).filter(|id| session.history().is_chosen(RecordId(*id))).collect::<Vec<_>>();
    assert_eq!(chosen(&session), [1, 2], "the good ones are no longer chosen");
    list(&mut session, ListCommand::ChooseNone);
    assert_eq!(chosen(&session), [0_u64; 0]);
    assert!(!session.can(WindowAction::ChooseNone));
    filter(&mut session, "good");
    assert!(!session.can(WindowAction::ChooseBad), "there is no bad one in the list");
}

#[test]
fn every_rendering_exports_only_the_bad_once_they_are_chosen() {
    for (number, rendering) in of_any_paper().map(|number| (number, &RENDERINGS[number])) {
        let mut session = four(Language::En);
        let export = [
            ListCommand::ChooseBad.into(),
            Command::OpenDialog(Purpose::Export(number)),
            Command::TypePath("bad".to_owned()),
            Command::Confirm,
        ];
        let effects = run(&mut session, export);
        let Some(Effect::Save(path, content)) = effects.first().map(Effect::errand) else { panic!("{effects:?}") };
        assert_eq!(path.file_stem(), Some("bad".as_ref()), "{}", path.display());
        let text = unpacked(&content.bytes().unwrap());
        let has = ["24.998", "39.9", "25.012"].map(|measured| text.contains(measured));
        assert_eq!(has, [true, true, false], "{}", rendering.name);
    }
}

/// A file with what is packed in it, as in a PDF or a workbook: its attachments, its sheets.
fn unpacked(file: &[u8]) -> String {
    let mut all = String::from_utf8_lossy(file).into_owned();
    if let Ok(mut packed) = zip::ZipArchive::new(std::io::Cursor::new(file)) {
        for at in 0..packed.len() {
            packed.by_index(at).unwrap().read_to_string(&mut all).unwrap();
        }
    }
    let start = b"stream\n";
    for (at, _) in file.windows(start.len()).enumerate().filter(|(_, piece)| *piece == start) {
        let mut text = Vec::new();
        // What is not packed adds nothing.
        let read = flate2::read::ZlibDecoder::new(&file[at + start.len()..]).read_to_end(&mut text);
        if read.is_ok() {
            all.push_str(&String::from_utf8_lossy(&text));
        }
    }
    all
}

#[test]
fn copied_rows_are_a_table_for_a_spreadsheet() {
    let mut session = four(Language::Nl);
    list(&mut session, ListCommand::Move(Step::Last));
    assert_eq!(
        list(&mut session, ListCommand::Copy),
        [Effect::Copy(
            "Datum en tijd\tOnderdeel\tPassing\tGemeten (mm)\tAfwijking (µm)\tStatus\tHerkomst\n\
             2026-11-21 10:42:07\tA10\t25 H7\t25,012\t12\tGOED\tgetypt\n"
                .to_owned()
        )]
    );
    // The chosen ones, in the order of the list, also those that the filter hides.
    list(&mut session, ListCommand::ChooseAll);
    list(&mut session, ListCommand::SortBy(Column::Measured));
    filter(&mut session, "B");
    let effects = list(&mut session, ListCommand::Copy);
    let [Effect::Copy(text)] = effects.as_slice() else { panic!("{effects:?}") };
    let cells: Vec<Vec<&str>> = text.lines().map(|line| line.split('\t').collect()).collect();
    assert!(cells.iter().all(|cells| cells.len() == 7), "{text}");
    let part: Vec<_> = cells.iter().map(|cells| cells[1]).collect();
    assert_eq!(part, ["Onderdeel", "C", "A2", "A10", "B"]);
    // A number keeps a sign that a spreadsheet reads.
    let deviation: Vec<_> = cells.iter().skip(2).map(|cells| cells[4]).collect();
    assert_eq!(deviation, ["-2", "12", "-100"]);
    assert_eq!(cells[1][5], "GESIMULEERD GOED", "a simulated row says so");
}

#[test]
fn a_name_is_no_formula_and_stays_one_cell() {
    let mut session = Session::new(Language::En);
    measure(&mut session, "=1+1\tA", "25 H7", "25.012");
    let effects = list(&mut session, ListCommand::Copy);
    let [Effect::Copy(text)] = effects.as_slice() else { panic!("{effects:?}") };
    assert!(text.lines().nth(1).unwrap().contains("\t'=1+1 A\t25 H7\t"), "{text:?}");
}

#[test]
fn nothing_is_copied_where_there_is_nothing() {
    let mut session = Session::new(Language::En);
    assert!(list(&mut session, ListCommand::Copy).is_empty());
    for action in [
        Action::from(CheckAction::CopyChecks),
        CheckAction::ChooseAll.into(),
        WindowAction::ChooseBad.into(),
        CheckAction::ShowCheck.into(),
        CheckAction::FindInHistory.into(),
    ] {
        assert!(!session.can(action), "{action:?}");
    }
}

#[test]
fn clearing_says_how_many_and_undo_says_what() {
    let mut session = four(Language::En);
    assert_eq!(name(&session, WindowAction::Undo.into()), "Undo: add 1 check");
    list(&mut session, ListCommand::ChooseBad);
    let before = listed(&session);
    run(&mut session, [CheckCommand::ClearHistory.into()]);
    assert_eq!((listed(&session).as_str(), session.history().len()), ("", 0));
    assert_eq!(notices(&session), ["4 checks removed from the history. Undo (Ctrl+Z) brings them back."]);
    assert_eq!(name(&session, WindowAction::Undo.into()), "Undo: clear history");
    let undo = WindowAction::Undo.command(&session).unwrap();
    run(&mut session, [undo]);
    assert_eq!((listed(&session), session.history().chosen_count()), (before, 2));
    assert!(notices(&session).is_empty(), "what was brought back is no longer said to be removed");
    assert_eq!(name(&session, WindowAction::Undo.into()), "Undo: add 1 check");
}

#[test]
fn an_import_is_one_step_that_names_its_size() {
    let mut session = four(Language::En);
    let rows = b"id,callout,measured\nX1,25 H7,25.012\nX2,25 H7,25.030\nX3,25 H7,24.9\n";
    let result = Ok(Box::new(import("lot.csv", rows, session.sources(), now())));
    run(&mut session, [CheckCommand::Imported { name: "lot.csv".to_owned(), result }.into()]);
    assert_eq!(name(&session, WindowAction::Undo.into()), "Undo: add 3 checks");
    run(&mut session, [CheckCommand::Choose(RecordId(0), true).into(), CheckCommand::Choose(RecordId(5), true).into()]);
    run(&mut session, [CheckCommand::Undo.into()]);
    // Only what was added goes, with its choice.
    assert_eq!((listed(&session).as_str(), session.history().chosen_count()), ("C B A2 A10", 1));
}

#[test]
fn undo_is_one_action_on_every_page_and_says_what_is_not_in_sight() {
    for page in [Page::Fit, Page::Cycles, Page::Program, Page::Check] {
        let mut session = four(Language::En);
        run(&mut session, [CheckCommand::ClearHistory.into(), Command::Close, Command::OpenPage(page)]);
        let undo = |session: &Session| {
            session.keys(None, false).into_iter().find(|(_, action)| *action == WindowAction::Undo.into())
        };
        assert_eq!(undo(&session).unwrap().0.to_string(), "Ctrl+Z", "{page:?}");
        run(&mut session, [CheckCommand::Undo.into()]);
        assert_eq!(session.history().len(), 4);
        let told: &[&str] = if page == Page::Check { &[] } else { &["Undone: clear history"] };
        assert_eq!(notices(&session), told, "{page:?}");
        assert!(
            session.keys(None, true).iter().all(|(_, action)| *action != WindowAction::Undo.into()),
            "a text field undoes itself"
        );
    }
}

#[test]
fn the_tables_own_undo_keeps_its_keys_even_while_there_is_nothing_to_undo() {
    let mut session = four(Language::En);
    run(&mut session, [Command::OpenPage(Page::Tables)]);
    assert!(session.can(WindowAction::Undo) && !session.can(TablesAction::UndoEdit));
    let keys = session.keys(None, false);
    assert!(keys.iter().all(|(shortcut, _)| shortcut.to_string() != "Ctrl+Z"), "{keys:?}");
}

#[test]
fn many_steps_are_undone_and_records_are_not_copied_for_it() {
    let mut session = Session::new(Language::En);
    for number in 0..60 {
        measure(&mut session, &number.to_string(), "25 H7", "25.012");
    }
    let record = std::sync::Arc::clone(session.history().iter().next().unwrap());
    // The history holds it once; this test a second time.
    assert_eq!(std::sync::Arc::strong_count(&record), 2);
    let mut steps = 0;
    while let Some(undo) = WindowAction::Undo.command(&session) {
        run(&mut session, [undo]);
        steps += 1;
    }
    assert_eq!((steps, session.history().len()), (50, 10));
}

#[test]
fn the_list_counts_by_status() {
    let session = four(Language::En);
    let counts: Vec<_> = Status::ALL.into_iter().zip(session.history().listed().counts()).collect();
    assert_eq!(
        counts,
        [(Status::Good, 2), (Status::Rework, 1), (Status::ReMeasure, 0), (Status::OutOfLimits, 0), (Status::Scrap, 1)]
    );
}
