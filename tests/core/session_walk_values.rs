//! A value is of the size, the part and the limits that it was measured for, whatever comes meanwhile from files, keys and a restart.

use fitcheck::session::{PartsAction, WalkField};
use std::path::PathBuf;

use fitcheck::exchange::{FirstRows, Mapping};
use fitcheck::journal::chain::{ChainId, Hash};
use fitcheck::journal::entry::Entry;
use fitcheck::message::Message;
use fitcheck::session::parts::{PlanCommand, WalkCommand};
use fitcheck::session::{
    ColumnsCommand, ColumnsRequest, Command, Effect, Field, FilesCommand, ImportInto, OpenJournal, Page, PartsCommand,
    Purpose, ReadOutcome, RecordsCommand, Saved, Session, Step, WindowAction,
};
use fitcheck::verdict::Status;
use fitcheck::words::Language;

use crate::session_walk::{
    act, act_after, asked, begin_records, head, import, items, kept, look, open_journal, read_plan, rows, said, send,
    size, standing, take, typed, walking_by, watched,
};

const PLAN: &str = r#"fitcheck_plan = 1
part = "Flange"
[[feature]]
name = "A"
x = 40
y = 30
z = -8
callout = "25 H7"
[[feature]]
name = "B"
x = 60
y = 30
z = -8
callout = "25 H7"
[[feature]]
name = "C"
x = 80
y = 30
z = -8
callout = "20 g6"
"#;

fn walking() -> Session {
    walking_by(PLAN)
}

/// What the newest notice says, with its details.
fn noticed(session: &Session) -> String {
    let notice = session.notices().last().unwrap();
    let details = notice.details.iter().map(said);
    std::iter::once(said(&notice.message)).chain(details).collect::<Vec<_>>().join("\n")
}

/// All that is noticed.
fn all_noticed(session: &Session) -> String {
    let notices = session.notices().iter();
    notices
        .flat_map(|notice| std::iter::once(&notice.message).chain(&notice.details))
        .map(said)
        .collect::<Vec<_>>()
        .join("\n")
}

/// Name, part and value of every entry.
fn told(entries: &[Entry]) -> Vec<String> {
    let of_entry = |entry: &Entry| {
        let about = &entry.about;
        format!("{} {} {} {}", about.part, about.serial, about.feature, size(entry).measurement.diameter)
    };
    entries.iter().map(of_entry).collect()
}

/// The same part after a restart, by a plan that may have changed meanwhile.
fn restarted(session: &Session, entries: &[Entry], plan: &str) -> Session {
    let (mut back, _) = Session::restore(Saved::read(&session.saved().write().unwrap()).unwrap());
    begin_records(&mut back);
    read_plan(&mut back, plan);
    let effects = open_journal(&mut back, 7 + u64::try_from(entries.len()).unwrap());
    let run = effects.iter().find_map(|effect| match effect {
        Effect::ReadPart { run, .. } => Some(*run),
        _ => None,
    });
    send(&mut back, WalkCommand::Came { run: run.unwrap(), result: Ok(rows(entries, 8)) });
    back
}

#[test]
fn a_part_that_comes_back_counts_no_value_by_limits_that_its_plan_has_no_more() {
    let mut session = walking();
    let mut entries = Vec::new();
    for value in ["25.02", "25.01", "19.985"] {
        entries.extend(kept(&take(&mut session, value)).1);
    }
    assert_eq!(session.parts().walking.status(), Some(Status::Good));
    let same = restarted(&session, &entries, PLAN);
    assert_eq!(same.parts().walking.status(), Some(Status::Good));
    // 25 H6 goes to 25.013 mm.
    let back = restarted(&session, &entries, &PLAN.replace("25 H7", "25 H6"));
    assert_eq!(back.parts().walking.status(), None);
    assert_eq!(standing(&back), "1 measured, 2 missing, 0 skipped");
    assert_eq!(asked(&back).as_deref(), Some("A"));
    assert!(all_noticed(&back).contains("A: 25.02 mm was measured by 25 H7"), "{}", all_noticed(&back));
    // The same limits by another rule are another judgement.
    let ruled = PLAN.replace("name = \"C\"", "name = \"C\"\nrule = \"iso14253-2017\"\nu_um = 0.5");
    let back = restarted(&session, &entries, &ruled);
    assert_eq!(standing(&back), "2 measured, 1 missing, 0 skipped");
    assert!(all_noticed(&back).contains("C: 19.985 mm was measured by 20 g6"), "{}", all_noticed(&back));
}

#[test]
fn a_feature_without_a_name_gives_its_value_to_no_other_row() {
    let plan = "fitcheck_plan = 1\n[[feature]]\ncallout = \"25 H7\"\n[[feature]]\ncallout = \"25 H7\"\n";
    let mut session = walking_by(plan);
    let entries = kept(&take(&mut session, "25.06")).1;
    act(&mut session, PartsAction::SkipSize.into());
    send(&mut session, WalkCommand::Skip("no gauge".to_owned()));
    let same = restarted(&session, &entries, plan);
    assert_eq!(standing(&same), "1 measured, 0 missing, 1 skipped");
    let more = plan.replacen("[[feature]]", "[[feature]]\ncallout = \"25 H7\"\nx = 1\ny = 1\n[[feature]]", 1);
    let back = restarted(&session, &entries, &more);
    assert_eq!(standing(&back), "0 measured, 3 missing, 0 skipped");
    assert!(all_noticed(&back).contains("F1: 25.06 mm was measured by 25 H7"), "{}", all_noticed(&back));
    // Once more by the same plan: what was measured by the one before is still not of its rows.
    let again = restarted(&back, &entries, &more);
    assert_eq!(standing(&again), "0 measured, 3 missing, 0 skipped");
}

#[test]
fn a_file_that_comes_while_a_value_is_typed_does_not_move_the_size_that_it_is_typed_for() {
    let mut session = walking();
    let run = watched(&mut session);
    typed(&mut session, WalkField::Value, "25.010");
    let news = look(&session, 1, "name;measured\nA;25.012\n");
    send(&mut session, WalkCommand::Watched { run, news: Box::new(news) });
    assert_eq!(asked(&session).as_deref(), Some("A"));
    assert_eq!(told(&kept(&act(&mut session, PartsAction::TakeValue.into())).1), ["Flange A-0099 A 25.01"]);
    assert_eq!(asked(&session).as_deref(), Some("B"));
    import(&mut session, "name;measured\nB;25.012\n");
    assert_eq!(asked(&session).as_deref(), Some("C"), "nobody is at B");
}

#[test]
fn a_size_that_was_chosen_stays_until_it_has_its_value() {
    let mut session = walking();
    take(&mut session, "25.030");
    act(&mut session, PartsAction::SizeAgain.into());
    import(&mut session, "name;measured\nC;19.985\n");
    assert_eq!(asked(&session).as_deref(), Some("A"));
    assert_eq!(told(&kept(&take(&mut session, "25.010")).1), ["Flange A-0099 A 25.01"]);
    assert_eq!(asked(&session).as_deref(), Some("B"));
}

#[test]
fn a_question_and_the_panel_of_reasons_stay_with_their_size_when_a_file_comes() {
    let mut session = walking();
    take(&mut session, "2.501");
    assert!(session.parts().walking.question.is_some());
    import(&mut session, "name;measured\nA;25.01\n");
    assert!(session.parts().walking.question.is_some());
    assert_eq!(asked(&session).as_deref(), Some("A"));
    typed(&mut session, WalkField::Value, "");
    send(&mut session, WalkCommand::Go(1));
    act(&mut session, PartsAction::SkipSize.into());
    import(&mut session, "name;measured\nB;25.01\n");
    assert!(session.parts().walking.is_skipping);
    assert_eq!(asked(&session).as_deref(), Some("B"));
}

#[test]
fn a_value_is_taken_for_the_size_alone_that_it_was_typed_for() {
    let mut session = walking();
    typed(&mut session, WalkField::Value, "25.010");
    send(&mut session, WalkCommand::Go(1));
    assert_eq!(act(&mut session, PartsAction::TakeValue.into()), []);
    let refusal = said(session.error(WalkField::Value).unwrap());
    assert_eq!(refusal, "the value was typed for A, and B is asked for now: type it again");
    assert_eq!(told(&kept(&take(&mut session, "25.010")).1), ["Flange A-0099 B 25.01"]);
    // Leaving a size out moves on as well.
    typed(&mut session, WalkField::Value, "19.985");
    let at = asked(&session).unwrap();
    act(&mut session, PartsAction::SkipSize.into());
    send(&mut session, WalkCommand::Skip("no gauge".to_owned()));
    assert_ne!(asked(&session).unwrap(), at);
    assert_eq!(act(&mut session, PartsAction::TakeValue.into()), []);
    act(&mut session, PartsAction::MoveSize(Step::Last).into());
    assert_eq!(session.text(WalkField::Value), "19.985", "nothing that was typed is lost");
}

#[test]
fn a_file_that_was_read_for_one_part_is_not_taken_for_the_next_one() {
    let mut session = walking();
    let late = items("name;measured\nA;25.012\nB;25.010\n");
    let command =
        WalkCommand::Imported { run: session.parts().walking.run, name: "m.csv".to_owned(), result: Ok(late) };
    for _ in 0..2 {
        act(&mut session, PartsAction::NextPart.into());
    }
    act(&mut session, PartsAction::BeginPart.into());
    assert_eq!(session.parts().walking.serial(), "A-0100");
    assert_eq!(send(&mut session, command), []);
    assert_eq!(standing(&session), "0 measured, 3 missing, 0 skipped");
    assert_eq!(noticed(&session), "m.csv was read after the part had ended: its values are not used");
}

/// A plan whose first size has the number and the callout of a row of any morning.
const NUMBERED: &str = "fitcheck_plan = 1\npart = \"Flange\"\n[[feature]]\nnumber = \"1\"\nname = \"BORE\"\ncallout = \"25 H7\"\n\
    [[feature]]\nnumber = \"2\"\nname = \"PIN\"\ncallout = \"20 g6\"\n";

/// What is said of the newest import: the headline first.
fn noticed_lines(session: &Session) -> Vec<String> {
    let notice = session.notices().last().unwrap();
    std::iter::once(&notice.message).chain(&notice.details).map(said).collect()
}

#[test]
fn a_running_number_of_a_file_of_other_parts_is_no_name() {
    let mut session = walking_by(NUMBERED);
    let foreign = "nr;callout;measured\n1;25 H7;25.012\n2;30 H7;30.01\n3;18 K7;18.001\n";
    import(&mut session, foreign);
    assert_eq!(standing(&session), "0 measured, 2 missing, 0 skipped");
    let lines = noticed_lines(&session);
    assert_eq!(
        lines[..2],
        [
            "m.csv: 0 imported, 3 not",
            "Nothing in it is of this plan. Check can judge the file by what it asks for itself"
        ]
    );
    let running = "only its number matches BORE of the plan, and that may be a running number";
    assert!(lines.iter().any(|line| line.contains(running)), "{lines:?}");
    // The same numbers below a name that is of features, in a file of this plan alone, and beside names.
    for (text, expected) in [
        ("balloon;callout;measured\n1;25 H7;25.012\n2;30 H7;30.01\n", "1 measured, 1 missing, 0 skipped"),
        ("nr;callout;measured\n1;25 H7;25.012\n2;20 g6;19.985\n", "2 measured, 0 missing, 0 skipped"),
        ("id;measured\nBORE;25.012\n2;19.985\n", "2 measured, 0 missing, 0 skipped"),
        ("id;measured\nBORE;25.012\nNOBODY;3\n", "1 measured, 1 missing, 0 skipped"),
    ] {
        let mut session = walking_by(NUMBERED);
        import(&mut session, text);
        assert_eq!(standing(&session), expected, "{text}");
    }
}

#[test]
fn an_import_says_by_what_its_rows_were_found_and_is_undone_as_others_are() {
    let mut session = walking_by(NUMBERED);
    import(&mut session, "nr;name;callout;measured\n1;BORE;25 H7;25.012\n2;;20 g6;19.985\n");
    let lines = noticed_lines(&session);
    assert_eq!(lines[1..3], ["Matched by name: 1 row", "Matched by number alone, with their lines: PIN (3)"]);
    let notice = session.notices().last().unwrap();
    assert!(notice.change.is_some() && notice.change == session.history().last_change(), "Undo");
    assert_eq!(notice.unplanned, None);
    act(&mut session, WindowAction::Undo.into());
    assert_eq!(standing(&session), "0 measured, 2 missing, 0 skipped");
}

#[test]
fn a_file_that_is_not_of_the_plan_can_be_opened_on_the_check_page() {
    let mut session = walking_by(NUMBERED);
    import(&mut session, "nr;callout;measured\n7;30 H7;30.01\n");
    assert!(!session.can(WindowAction::JudgeUnplanned), "nobody knows where the file is");
    let path = PathBuf::from("/in/m.csv");
    let purpose = Purpose::ImportValues(session.parts().walking.run);
    send(&mut session, FilesCommand::Seen { purpose, path: path.clone(), fate: ReadOutcome::Read });
    let effects = act(&mut session, WindowAction::JudgeUnplanned.into());
    assert_eq!(effects, [Effect::Read(Purpose::Import, path)]);
    assert_eq!(session.page(), Page::Check);
}

#[test]
fn columns_that_are_chosen_when_the_next_part_is_begun_read_nothing_into_it() {
    let mut session = walking();
    let text = "what;how much\nA;25.012\n";
    let first = FirstRows::of("a.csv", text.as_bytes()).unwrap();
    let (name, path, mapping) = ("a.csv".to_owned(), PathBuf::from("/in/a.csv"), Mapping::default());
    let into = ImportInto::Part(session.parts().walking.run);
    let asked = ColumnsRequest { name, path, into, first, mapping, is_wanted: true };
    for _ in 0..2 {
        act(&mut session, PartsAction::NextPart.into());
    }
    act(&mut session, PartsAction::BeginPart.into());
    send(&mut session, ColumnsCommand::Ask(Box::new(asked)));
    assert!(session.open_columns().is_none());
    assert!(noticed(&session).contains("a.csv was read after the part had ended"), "{}", noticed(&session));
}

#[test]
fn a_file_of_several_parts_without_serial_numbers_is_not_one_part() {
    for plan in [PLAN.to_owned(), PLAN.replace("part = \"Flange\"\n", "")] {
        let mut session = walking_by(&plan);
        let effects = import(&mut session, "part;name;measured\nP1;A;25.080\nP2;A;25.060\nP3;A;25.012\n");
        assert_eq!(effects, []);
        assert_eq!(standing(&session), "0 measured, 3 missing, 0 skipped");
        assert!(noticed(&session).starts_with("m.csv: 0 imported, 3 not"), "{}", noticed(&session));
        let why = "line 2: of the part P1, and without a serial number it is not known to be this part";
        assert!(noticed(&session).contains(why), "{}", noticed(&session));
    }
}

#[test]
fn the_one_part_that_a_file_names_is_said_and_kept_and_another_one_is_not_taken_after_it() {
    let mut session = walking();
    let run = watched(&mut session);
    let news = look(&session, 1, "part;name;measured\nP1;A;25.012\n");
    let (_, entries) = kept(&send(&mut session, WalkCommand::Watched { run, news: Box::new(news) }));
    assert_eq!(told(&entries), ["Flange A-0099 A 25.012"]);
    assert_eq!(entries[0].about.remark, "Part in the file: P1");
    let said_of = |session: &Session| {
        let file = session.parts().watched.files().next().unwrap();
        file.said.iter().map(said).collect::<Vec<_>>().join("\n")
    };
    assert!(said_of(&session).contains("calls the part P1"), "{}", said_of(&session));
    // The next file is of the next part: it is dropped before that is begun.
    let news = look(&session, 2, "part;name;measured\nP2;A;25.060\nFlange;B;25.012\nA-0099;C;19.985\n");
    let (_, entries) = kept(&send(&mut session, WalkCommand::Watched { run, news: Box::new(news) }));
    assert_eq!(told(&entries), ["Flange A-0099 B 25.012", "Flange A-0099 C 19.985"]);
    assert!(said_of(&session).contains("of the part P2"), "{}", said_of(&session));
    assert_eq!(session.parts().walking.status(), Some(Status::Good));
}

#[test]
fn a_simulated_value_never_takes_the_place_of_a_measured_one() {
    let mut session = walking();
    take(&mut session, "25.06");
    assert_eq!(session.parts().walking.status(), Some(Status::Scrap));
    act(&mut session, PartsAction::SizeAgain.into());
    assert_eq!(act(&mut session, PartsAction::SimulateValue.into()), []);
    let refusal = said(session.parts().walking.refusal.as_ref().unwrap());
    assert_eq!(refusal, "A is measured: a simulated value never takes the place of a measured one");
    assert_eq!(session.parts().walking.status(), Some(Status::Scrap));
    // A measured one takes the place of a simulated one.
    send(&mut session, WalkCommand::Go(1));
    act(&mut session, PartsAction::SimulateValue.into());
    assert_eq!(session.parts().walking.standing().simulated, 1);
    send(&mut session, WalkCommand::Go(1));
    take(&mut session, "25.01");
    assert_eq!(session.parts().walking.standing().simulated, 0);
}

#[test]
fn a_scanner_that_sends_enter_twice_answers_no_question() {
    let mut session = walking();
    assert_eq!(take(&mut session, "25013"), []);
    assert!(session.parts().walking.question.is_some());
    for after in [0, 30, 499, 998] {
        assert_eq!(act_after(&mut session, PartsAction::TakeValue.into(), after), [], "{after} ms");
    }
    assert!(session.parts().walking.question.is_some());
    // What it may have been has a button of its own.
    kept(&act(&mut session, PartsAction::TakeMeantValue.into()));
    assert_eq!(session.parts().walking.shown().unwrap().1.record.measurement.diameter.to_string(), "25.013");
}

#[test]
fn a_serial_number_that_was_measured_already_is_asked_about_once() {
    let mut session = walking();
    take(&mut session, "25.06");
    for _ in 0..2 {
        act(&mut session, PartsAction::NextPart.into());
    }
    typed(&mut session, WalkField::Serial, "A-0099");
    assert_eq!(act(&mut session, PartsAction::BeginPart.into()), []);
    let question = said(session.error(WalkField::Serial).unwrap());
    assert!(question.starts_with("Serial number A-0099 has been measured already."), "{question}");
    assert_eq!(act_after(&mut session, PartsAction::BeginPart.into(), 20), [], "a scanner sends Enter twice");
    assert_eq!(
        act_after(&mut session, PartsAction::BeginPart.into(), 600),
        [Effect::Focus(Field::from(WalkField::Value))]
    );
    assert_eq!(session.parts().walking.serial(), "A-0099");
    // A part with values from a file is known, too.
    let mut values = items("name;measured\nA;25.012\n");
    for item in &mut values {
        if let fitcheck::exchange::Item::Unjudged(unjudged) = item {
            unjudged.labels.serial = "B-7".to_owned();
        }
    }
    let command =
        WalkCommand::Imported { run: session.parts().walking.run, name: "m.csv".to_owned(), result: Ok(values) };
    kept(&send(&mut session, command));
    for _ in 0..2 {
        act(&mut session, PartsAction::NextPart.into());
    }
    typed(&mut session, WalkField::Serial, "B-7");
    assert_eq!(act(&mut session, PartsAction::BeginPart.into()), []);
    typed(&mut session, WalkField::Serial, "B-8");
    act(&mut session, PartsAction::BeginPart.into());
    assert_eq!(session.parts().walking.serial(), "B-8");
}

#[test]
fn a_serial_number_among_the_newest_records_is_asked_about_after_a_restart() {
    let mut session = walking();
    let entries = kept(&take(&mut session, "25.06")).1;
    let mut back = Session::new(Language::En);
    begin_records(&mut back);
    let journal = OpenJournal { chain: ChainId([1; 16]), head: head(8), remarks: Vec::new() };
    send(&mut back, RecordsCommand::Opened(Ok((Box::new(journal), rows(&entries, 8)))));
    send(&mut back, Command::OpenPage(Page::Parts));
    read_plan(&mut back, PLAN);
    typed(&mut back, WalkField::Serial, "A-0099");
    assert_eq!(act(&mut back, PartsAction::BeginPart.into()), []);
    act_after(&mut back, PartsAction::BeginPart.into(), 600);
    assert!(back.parts().walking.is_begun());
}

#[test]
fn an_interrupted_part_that_waits_for_its_plan_is_not_given_up_silently() {
    let mut session = walking();
    take(&mut session, "25.06");
    let (mut back, _) = Session::restore(Saved::read(&session.saved().write().unwrap()).unwrap());
    begin_records(&mut back);
    open_journal(&mut back, 8);
    send(&mut back, Command::OpenPage(Page::Parts));
    let unread = Err(Message::new("records-page-no-thread"));
    send(&mut back, PartsCommand::Plan(PlanCommand::Read { path: "/plans/flange.toml".into(), result: unread }));
    assert_eq!(back.saved().walk.serial, "A-0099");
    let document = fitcheck::part::Document::read(PLAN.as_bytes()).unwrap();
    let read = PlanCommand::Read { path: "/plans/other.toml".into(), result: Ok(Box::new(document)) };
    send(&mut back, PartsCommand::Plan(read));
    typed(&mut back, WalkField::Serial, "T-1");
    act(&mut back, PartsAction::BeginPart.into());
    let said = noticed(&back);
    assert!(said.starts_with("The interrupted part A-0099 is not restored"), "{said}");
}

#[test]
fn an_answer_of_the_journal_for_a_part_that_was_ended_is_not_said() {
    let mut session = walking();
    let entries = kept(&take(&mut session, "25.06")).1;
    let (mut back, _) = Session::restore(Saved::read(&session.saved().write().unwrap()).unwrap());
    begin_records(&mut back);
    read_plan(&mut back, PLAN);
    open_journal(&mut back, 8);
    for _ in 0..2 {
        act(&mut back, PartsAction::NextPart.into());
    }
    let before = back.notices().len();
    send(&mut back, WalkCommand::Came { run: 1, result: Ok(rows(&entries, 8)) });
    assert_eq!(back.notices().len(), before, "{}", all_noticed(&back));
}

#[test]
fn what_was_left_out_is_said_when_the_part_is_ended() {
    let mut session = walking();
    take(&mut session, "25.01");
    take(&mut session, "25.01");
    act(&mut session, PartsAction::SkipSize.into());
    send(&mut session, WalkCommand::Skip("no gauge".to_owned()));
    act(&mut session, PartsAction::NextPart.into());
    assert!(!session.parts().walking.is_begun());
    assert_eq!(noticed(&session), "Not used for the part A-0099, which has ended\nC: no gauge");
}

#[test]
fn a_file_of_many_values_is_taken_by_a_large_plan() {
    let features = (0..1_000).map(|at| format!("[[feature]]\nname = \"H{at}\"\ncallout = \"25 H7\"\n"));
    let mut session = walking_by(&format!("fitcheck_plan = 1\n{}", features.collect::<String>()));
    let values = (0..3_000).map(|at| format!("H{};25.01\n", at % 1_000)).collect::<Vec<_>>().concat();
    send(&mut session, RecordsCommand::Measured { name: "m.csv".to_owned(), sha256: Hash([3; 32]) });
    let (_, entries) = kept(&import(&mut session, &format!("name;measured\n{values}")));
    assert_eq!((entries.len(), standing(&session).as_str()), (3_000, "1000 measured, 0 missing, 0 skipped"));
}

/// What the part is, and of which sizes values contradict each other.
fn decided(session: &Session) -> (Option<Status>, Option<&str>) {
    let walking = &session.parts().walking;
    (walking.status(), walking.contradicted().map(|(at, _)| walking.name(at)))
}

#[test]
fn two_values_of_a_size_in_one_file_are_a_question_and_not_good() {
    let mut session = walking();
    // 25 H7 is 25.000 … 25.021, 20 g6 is 19.980 … 19.993.
    import(&mut session, "name;measured\nA;25.030\nB;25.01\nC;19.99\nA;25.012\n");
    assert_eq!(decided(&session), (Some(Status::Scrap), Some("A")));
    assert!(all_noticed(&session).contains("A: values contradict each other"), "{}", all_noticed(&session));
    // Somebody chooses.
    act(&mut session, PartsAction::CountNewest.into());
    assert_eq!(decided(&session), (Some(Status::Good), None));
    assert!(noticed(&session).contains("the last value counts, as chosen"), "{}", noticed(&session));
}

#[test]
fn a_file_does_not_replace_a_scrap_that_was_measured() {
    let mut session = walking();
    take(&mut session, "25.030");
    import(&mut session, "name;measured\nA;25.012\nB;25.01\nC;19.99\n");
    assert_eq!(decided(&session), (Some(Status::Scrap), Some("A")));
    // Measured again by the person who goes back to it, the new value counts.
    send(&mut session, WalkCommand::Go(0));
    take(&mut session, "25.012");
    assert_eq!(decided(&session), (Some(Status::Good), None));
    // A value that a file brings while somebody is at the size is not settled by what is typed then.
    let mut session = walking();
    send(&mut session, WalkCommand::Go(0));
    import(&mut session, "name;measured\nA;25.030\nB;25.01\nC;19.99\n");
    take(&mut session, "25.012");
    assert_eq!(decided(&session), (Some(Status::Scrap), Some("A")));
}

#[test]
fn a_later_time_replaces_rework_and_never_scrap() {
    let rows = |first: &str, second: &str| {
        let rest = "B;25.01;2026-11-24T08:00\nC;19.99;2026-11-24T08:00\n";
        format!("name;measured;time\nA;{second};2026-11-24T09:00\nA;{first};2026-11-24T08:00\n{rest}")
    };
    for (first, second, expected) in [
        ("24.998", "25.012", (Some(Status::Good), None)),
        ("25.012", "24.998", (Some(Status::Rework), None)),
        ("25.030", "25.012", (Some(Status::Scrap), Some("A"))),
        ("25.012", "25.030", (Some(Status::Scrap), None)),
    ] {
        let mut session = walking();
        import(&mut session, &rows(first, second));
        assert_eq!(decided(&session), expected, "{first}, then {second}");
    }
}
