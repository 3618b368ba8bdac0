//! The pairing page without a window: what its fields mean, where parts come from, which answers still count.

#![cfg(test)]

use fitcheck::session::PairingAction;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use fitcheck::exchange::sizes;
use fitcheck::message::Message;
use fitcheck::report::pairing::FORMATS;
use fitcheck::report::pairing::PairingParts;
use fitcheck::session::{
    CheckCommand, CheckField, Command, Content, Effect, Field, FilesCommand, MeasureBy, Page, Paired, PairingCommand,
    PairingField, Purpose, Saved, Session, Step, usable,
};
use fitcheck::tolerance::{Base, Feature};
use fitcheck::words::{Language, Words};
use jiff::civil::DateTime;

const HOLES: &str = "id;measured\nH1;25,012\nH2;25,004\nH3;25,001\nH4;25,021\n";
const SHAFTS: &str = "id;measured\nS1;24,990\nS2;24,986\nS3;25,016\nS4;24,999\n";
const WANTED: &str = "0.010..0.020";

fn now() -> DateTime {
    jiff::civil::date(2026, 11, 21).at(10, 42, 7, 0)
}

/// Applies a command; questions are answered at once, and so on until nothing is left to do but these effects.
fn apply(session: &mut Session, command: impl Into<Command>) -> Vec<Effect> {
    let (mut waiting, mut left) = (session.apply(command.into(), now()), Vec::new());
    while let Some(effect) = waiting.pop() {
        match effect {
            Effect::Pair { run, asked } => {
                let paired = Arc::new(Paired::of(*asked));
                waiting.extend(session.apply(PairingCommand::Paired { run, paired }.into(), now()));
            }
            effect => left.push(effect),
        }
    }
    left
}

fn typed(session: &mut Session, field: PairingField, text: &str) {
    assert_eq!(apply(session, Field::from(field).typed(text.to_owned())), []);
}

/// What reading a file of this content answers.
fn read(feature: Feature, path: &str, content: &str) -> PairingCommand {
    let parts = PairingParts::of_file(path, sizes(path, content.as_bytes(), feature));
    PairingCommand::Read { feature, path: path.into(), result: usable(path, parts) }
}

fn open(session: &mut Session, feature: Feature, path: &str, content: &str) {
    let (purpose, path_buf) = (Purpose::OpenParts(feature), PathBuf::from(path));
    let asked = apply(session, FilesCommand::Open(purpose, path_buf.clone()));
    assert_eq!(asked, [Effect::Read(purpose, path_buf)]);
    assert_eq!(apply(session, read(feature, path, content)), []);
}

fn paired_with(wanted: &str, holes: &str, shafts: &str) -> Session {
    let mut session = Session::new(Language::En);
    apply(&mut session, Command::OpenPage(Page::Pairing));
    typed(&mut session, PairingField::Wanted, wanted);
    open(&mut session, Feature::Hole, "holes.csv", holes);
    open(&mut session, Feature::Shaft, "shafts.csv", shafts);
    session
}

fn told(message: Option<&Message>) -> String {
    message.map(|message| Words::new(Language::En).say(message)).unwrap_or_default()
}

fn error(session: &Session, field: PairingField) -> String {
    told(session.error(field))
}

/// `H3 S2 +15 +0` of each pair.
fn rows(session: &Session) -> Vec<String> {
    let Some(paired) = session.pairing().paired.as_deref() else { return Vec::new() };
    let row = |at| {
        let row = paired.row(at).unwrap();
        format!("{} {} {} {}", row.hole.id, row.shaft.id, row.clearance.signed_um(), row.from_middle.signed_um())
    };
    (0..paired.count()).map(row).collect()
}

/// The bytes of `fitcheck pair` for the same files.
fn of_command_line(holes: &str, shafts: &str, args: &[&str]) -> Vec<u8> {
    use std::io::Write as _;
    let folder = tempfile::tempdir().unwrap();
    for (name, content) in [("holes.csv", holes), ("shafts.csv", shafts)] {
        let mut file = std::fs::File::create(folder.path().join(name)).unwrap();
        file.write_all(content.as_bytes()).unwrap();
    }
    let mut command = assert_cmd::Command::cargo_bin("fitcheck").unwrap();
    command.current_dir(folder.path()).args(["pair", "holes.csv", "shafts.csv"]).args(args).output().unwrap().stdout
}

/// The bytes that the window saves.
fn saved(session: &mut Session, format: usize) -> Vec<u8> {
    apply(session, Command::OpenDialog(Purpose::SavePairs(format)));
    apply(session, Command::TypePath("/shop/pairs".into()));
    let effects = apply(session, Command::Confirm);
    let [effect] = effects.as_slice() else { panic!("{effects:?}") };
    let Effect::Save(path, content) = effect.errand() else { panic!("{effect:?}") };
    assert_eq!(path, Path::new(&format!("/shop/pairs.{}", FORMATS[format].name)));
    content.bytes().unwrap()
}

#[test]
fn the_window_saves_what_the_command_line_writes() {
    let bad = format!("{HOLES}H5;\nH6;x\nH1;25,030\n");
    for (wanted, groups, holes, args) in [
        (WANTED, "", HOLES, &["--clearance", WANTED][..]),
        ("-0.005..0.0201", "3", bad.as_str(), &["--clearance", "-0.005..0.0201", "--classes", "3"]),
        ("25 H7/g6", "5", HOLES, &["--fit", "25 H7/g6", "--classes", "5"]),
    ] {
        let mut session = paired_with(wanted, holes, SHAFTS);
        typed(&mut session, PairingField::Groups, groups);
        for (format, name) in FORMATS.iter().map(|format| format.name).enumerate() {
            let expected = of_command_line(holes, SHAFTS, &[args, &["--format", name]].concat());
            let bytes = saved(&mut session, format);
            assert_eq!(String::from_utf8_lossy(&bytes), String::from_utf8_lossy(&expected), "{wanted} {name}");
            apply(&mut session, Command::Close);
        }
    }
}

#[test]
fn pairs_have_their_clearance_and_their_distance_from_the_middle() {
    let mut session = paired_with(WANTED, HOLES, SHAFTS);
    assert_eq!(rows(&session), ["H3 S2 +15 0", "H2 S1 +14 -1", "H1 S4 +13 -2"]);
    let paired = session.pairing().paired.as_deref().unwrap();
    assert_eq!(paired.figures(paired.row(1).unwrap()), ["25.004", "24.990", "+14", "-1"]);
    // The middle is 15.0005 µm now: a half nanometre is not lost.
    typed(&mut session, PairingField::Wanted, "0.010..0.020001");
    assert_eq!(rows(&session)[0], "H3 S2 +15 -0.0005");
    let paired = session.pairing().paired.as_deref().unwrap();
    assert_eq!(paired.figures(paired.row(1).unwrap()), ["25.004", "24.990", "+14", "-1.0005"]);
    open(&mut session, Feature::Hole, "fine.csv", "id;measured\nH1;25,0012\nH2;25,004\n");
    let paired = session.pairing().paired.as_deref().unwrap();
    assert_eq!(paired.figures(paired.row(1).unwrap()), ["25.0040", "24.9900", "+14.0", "-1.0005"]);
    assert_eq!(told(session.pairing().understood().as_ref()), "Clearance +10 … +20.001 µm, middle +15.0005 µm");
    typed(&mut session, PairingField::Wanted, "-0.020..-0.005");
    assert_eq!(told(session.pairing().understood().as_ref()), "Clearance −20 … −5 µm, middle −12.5 µm");
}

#[test]
fn one_field_takes_clearances_or_a_fit_and_says_what_is_allowed() {
    for (text, understood, problem) in [
        ("", "", ""),
        ("0,010..0,030", "Clearance +10 … +30 µm, middle +20 µm", ""),
        ("25 H7/g6", "25 H7/g6: clearance +7 … +41 µm, middle +24 µm", ""),
        (" 10 µm..30 µm ", "Clearance +10 … +30 µm, middle +20 µm", ""),
        ("0.030..0.010", "", "the smallest clearance 0.03 mm is larger than the largest, 0.01 mm"),
        (
            "25 H7",
            "",
            "25 H7 is not a fit: write a size, a hole class and a shaft class, such as 25 H7/g6; allowed are a fit, such as \
             25 H7/g6, and two clearances in mm, such as 0.010..0.030",
        ),
    ] {
        let mut session = Session::new(Language::En);
        typed(&mut session, PairingField::Wanted, text);
        let (said, wrong) = (told(session.pairing().understood().as_ref()), error(&session, PairingField::Wanted));
        assert_eq!((said.as_str(), wrong.as_str()), (understood, problem), "{text}");
    }
    let mut session = Session::new(Language::En);
    for (text, problem) in
        [("0", "0 groups: expected 1 to 1000"), ("1001", "1001 groups: expected 1 to 1000"), ("1000", ""), ("", "")]
    {
        typed(&mut session, PairingField::Groups, text);
        assert_eq!(error(&session, PairingField::Groups), problem, "{text}");
    }
    typed(&mut session, PairingField::Groups, "2.5");
    assert!(error(&session, PairingField::Groups).contains("2.5"));
}

#[test]
fn a_fit_follows_the_source_of_limits() {
    let mut session = paired_with("25 H7/g6", HOLES, SHAFTS);
    let outside = session.pairing().paired.as_deref().unwrap().answer.outside.clone();
    assert_eq!(told(outside[0].as_ref().map(fitcheck::message::Say::message).as_ref()), "");
    assert!(outside[1].as_ref().unwrap().to_string().starts_with("2 parts are outside their own limits"));
    // The control's tables have no zc7.
    typed(&mut session, PairingField::Wanted, "25 H7/zc7");
    assert!(session.pairing().paired.is_some());
    apply(&mut session, Command::UseSource(Base::ControlTables));
    assert!(session.pairing().paired.is_none());
    assert!(error(&session, PairingField::Wanted).contains("zc7"), "{}", error(&session, PairingField::Wanted));
}

#[test]
fn a_change_clears_the_answer_at_once_and_an_older_answer_is_dropped() {
    let mut session = paired_with(WANTED, HOLES, SHAFTS);
    let type_wanted = |session: &mut Session, text: &str| {
        session.apply(Field::from(PairingField::Wanted).typed(text.to_owned()), now())
    };
    let first = type_wanted(&mut session, "0.010..0.015");
    let [Effect::Pair { run, asked }] = first.as_slice() else { panic!("{first:?}") };
    assert!(session.pairing().paired.is_none() && session.pairing().is_pairing());
    assert!(!session.can(PairingAction::SavePairs(0)) && !session.can(PairingAction::CopyPairs));
    // Only one question is being answered at a time.
    assert_eq!(type_wanted(&mut session, "0.010..0.016"), []);
    let late = PairingCommand::Paired { run: *run, paired: Arc::new(Paired::of(asked.as_ref().clone())) };
    let second = session.apply(late.clone().into(), now());
    assert!(session.pairing().paired.is_none(), "made for 0.010..0.015");
    let [Effect::Pair { run: again, asked }] = second.as_slice() else { panic!("{second:?}") };
    assert!(run < again);
    session.apply(late.into(), now());
    assert!(session.pairing().paired.is_none(), "twice is no better");
    let answer = PairingCommand::Paired { run: *again, paired: Arc::new(Paired::of(asked.as_ref().clone())) };
    assert_eq!(session.apply(answer.into(), now()), []);
    assert_eq!(rows(&session).len(), 3);
    // Nothing is asked any more, so nothing is shown.
    assert_eq!(type_wanted(&mut session, "0.010.."), []);
    assert!(session.pairing().paired.is_none() && !session.pairing().is_pairing());
}

#[test]
fn a_question_that_was_withdrawn_leaves_no_answer() {
    let mut session = paired_with(WANTED, HOLES, SHAFTS);
    let asked = session.apply(Field::from(PairingField::Wanted).typed("0..1".into()), now());
    let [Effect::Pair { run, asked }] = asked.as_slice() else { panic!("{asked:?}") };
    assert_eq!(session.apply(Field::from(PairingField::Wanted).typed(String::new()), now()), []);
    assert!(!session.pairing().is_pairing());
    let late = PairingCommand::Paired { run: *run, paired: Arc::new(Paired::of(asked.as_ref().clone())) };
    assert_eq!(session.apply(late.into(), now()), []);
    assert!(session.pairing().paired.is_none());
    typed(&mut session, PairingField::Wanted, WANTED);
    assert_eq!(rows(&session).len(), 3);
}

#[test]
fn a_late_file_changes_nothing_that_has_moved_on() {
    let mut session = paired_with(WANTED, HOLES, SHAFTS);
    let ask = |session: &mut Session, name: &str| {
        apply(session, FilesCommand::Open(Purpose::OpenParts(Feature::Hole), name.into()));
    };
    ask(&mut session, "slow.csv");
    ask(&mut session, "quick.csv");
    assert!(session.pairing().is_reading(Feature::Hole));
    apply(&mut session, read(Feature::Hole, "slow.csv", "id;measured\nX;25,002\n"));
    let name = |session: &Session| session.pairing().parts(Feature::Hole).unwrap().file().to_owned();
    assert_eq!(name(&session), "holes.csv");
    apply(&mut session, read(Feature::Hole, "quick.csv", "id;measured\nY;25,003\n"));
    assert_eq!((name(&session).as_str(), session.pairing().is_reading(Feature::Hole)), ("quick.csv", false));
    // Nobody asked for it.
    apply(&mut session, read(Feature::Hole, "other.csv", "id;measured\nZ;25,003\n"));
    assert_eq!(name(&session), "quick.csv");
    ask(&mut session, "folder");
    apply(&mut session, FilesCommand::IsFolder("folder".into()));
    assert!(!session.pairing().is_reading(Feature::Hole));
}

#[test]
fn refused_rows_stay_with_their_reason_and_a_useless_file_takes_nobodys_place() {
    let mut session = paired_with(WANTED, "id;measured\nH1;25,012\nH2;\nH3;x\nH1;25,013\n", SHAFTS);
    let parts = session.pairing().parts(Feature::Hole).unwrap();
    let errors: Vec<String> = parts.errors.iter().map(ToString::to_string).collect();
    assert_eq!(errors.len(), 2);
    assert_eq!(errors[0], "line 3, column 2: measured: a length is missing");
    assert_eq!(
        parts.warnings(),
        ["holes.csv: a row has the name of an earlier row, such as H1 on lines 2 and 5: each row counts as a part"]
    );
    let before = rows(&session);
    apply(&mut session, FilesCommand::Open(Purpose::OpenParts(Feature::Hole), "bad.csv".into()));
    apply(&mut session, read(Feature::Hole, "bad.csv", "id;measured\nH1;\nH2;x\n"));
    assert_eq!(rows(&session), before);
    let notice = session.notices().last().unwrap();
    assert_eq!(
        told(Some(&notice.message)),
        "bad.csv has no size that can be used: line 2, column 2: measured: a length is missing (2 rows refused)"
    );
}

#[test]
fn the_history_is_a_source_and_says_what_is_simulated() {
    let mut session = Session::new(Language::En);
    let check = |session: &mut Session, callout: &str, part: &str, measured: &str| {
        for (field, text) in
            [(CheckField::Callout, callout), (CheckField::Part, part), (CheckField::Measured, measured)]
        {
            apply(session, Field::from(field).typed(text.to_owned()));
        }
        apply(session, CheckCommand::Measure);
    };
    assert!(!session.can(PairingAction::HistoryParts(Feature::Hole)), "there is no history");
    check(&mut session, "25 H7", "A", "25.012");
    apply(&mut session, PairingCommand::TakeHistory(Feature::Shaft));
    let notice = told(session.notices().last().map(|notice| &notice.message));
    assert_eq!(notice, "The history has no checks of shafts.");
    check(&mut session, "25 g6", "", "24.990");
    check(&mut session, "25 H7", "A", "25.004");
    for (field, text) in [(CheckField::Callout, "25 g6"), (CheckField::Part, "S")] {
        apply(&mut session, Field::from(field).typed(text.to_owned()));
    }
    apply(&mut session, CheckCommand::MeasureBy(MeasureBy::Simulating));
    apply(&mut session, CheckCommand::Measure);
    apply(&mut session, PairingCommand::TakeHistory(Feature::Hole));
    apply(&mut session, PairingCommand::TakeHistory(Feature::Shaft));
    typed(&mut session, PairingField::Wanted, "0..1");
    let [holes, shafts] =
        [Feature::Hole, Feature::Shaft].map(|side| Arc::clone(session.pairing().parts(side).unwrap()));
    assert_eq!(holes.sizes.iter().map(|size| size.line).collect::<Vec<_>>(), [1, 3]);
    assert_eq!(
        holes.warnings(),
        ["history: a check has the name of an earlier check, such as A, checks 1 and 3: each check counts as a part"]
    );
    assert_eq!(shafts.warnings(), ["history: 1 check is simulated: nothing was measured"]);
    let paired = session.pairing().paired.as_deref().unwrap();
    assert_eq!((paired.count(), paired.simulated), (2, 1));
    let words = Words::new(Language::En);
    let nameless = shafts.sizes.iter().find(|size| size.id.is_empty()).unwrap();
    assert_eq!(paired.shaft_name(nameless, &words), "check 2");
    let remarks: Vec<_> = (0..2).filter_map(|at| paired.row(at)?.remark()).collect();
    assert_eq!(told(remarks.first()), "shaft simulated");
}

#[test]
fn dropped_files_take_the_sides_that_are_free() {
    let mut session = Session::new(Language::En);
    let sides = |session: &Session| [0, 1, 2].map(|number| session.pairing().side_of_dropped(number));
    assert_eq!(sides(&session), [Some(Feature::Hole), Some(Feature::Shaft), None]);
    apply(&mut session, FilesCommand::Open(Purpose::OpenParts(Feature::Hole), "holes.csv".into()));
    assert_eq!(sides(&session), [Some(Feature::Shaft), None, None], "the holes are being read");
    apply(&mut session, PairingCommand::NoSideFree { name: "more.csv".into() });
    assert!(told(session.notices().last().map(|notice| &notice.message)).starts_with("more.csv is not opened"));
}

#[test]
fn the_keys_walk_the_pairs_and_a_new_answer_begins_without_a_selection() {
    let mut session = paired_with(WANTED, HOLES, SHAFTS);
    let mut walked = Vec::new();
    for step in [Step::Down, Step::Down, Step::Last, Step::Down, Step::Up, Step::PageUp, Step::PageDown, Step::First] {
        apply(&mut session, PairingCommand::Move(step));
        walked.push(session.pairing().selected.unwrap());
    }
    assert_eq!(walked, [0, 1, 2, 2, 1, 0, 2, 0]);
    apply(&mut session, PairingCommand::Select(99));
    assert_eq!(session.pairing().selected, Some(0));
    typed(&mut session, PairingField::Groups, "2");
    assert_eq!((rows(&session).len(), session.pairing().selected), (3, None));
}

#[test]
fn groups_that_cannot_be_made_say_why_and_leave_the_pairs() {
    let mut session = paired_with("0..1", "id;measured\nA;25\nB;25\n", SHAFTS);
    typed(&mut session, PairingField::Groups, "3");
    assert_eq!(rows(&session).len(), 2);
    assert_eq!(
        told(session.pairing().group_error().as_ref()),
        "holes from 25 to 25 mm cannot be sorted into 3 groups: a group has at least one nanometre"
    );
    typed(&mut session, PairingField::Groups, "1");
    assert_eq!(session.pairing().group_error(), None);
}

#[test]
fn pairs_are_copied_for_a_spreadsheet_of_the_users_language() {
    let mut session = paired_with(WANTED, "id;measured\n=1+1;25,0125\n;25,001\n", SHAFTS);
    apply(&mut session, Command::SetLanguage(Language::Nl));
    let effects = apply(&mut session, PairingCommand::Copy);
    let [Effect::Copy(text)] = effects.as_slice() else { panic!("{effects:?}") };
    let expected = "Boring\tBoring (mm)\tAs\tAs (mm)\tSpeling (µm)\tVan het midden (µm)\tOpmerking\n\
        regel 3\t25,001\tS2\t24,986\t15\t0\t\n'=1+1\t25,0125\tS4\t24,999\t13,5\t-1,5\t\n";
    assert_eq!(text, expected);
}

#[test]
fn the_state_file_keeps_what_was_typed_and_the_files() {
    let mut session = Session::new(Language::En);
    typed(&mut session, PairingField::Wanted, "25 H7/g6");
    typed(&mut session, PairingField::Groups, "4");
    let path: PathBuf = "/shop/holes.csv".into();
    let (purpose, fate) = (Purpose::OpenParts(Feature::Hole), fitcheck::session::ReadOutcome::Read);
    apply(&mut session, FilesCommand::Seen { purpose, path: path.clone(), fate });
    let saved = Saved::read(&session.saved().write().unwrap()).unwrap();
    let (session, effects) = Session::restore(saved);
    assert_eq!(effects, []);
    assert_eq!((session.text(PairingField::Wanted), session.text(PairingField::Groups)), ("25 H7/g6", "4"));
    assert_eq!(
        told(session.pairing().understood().as_ref()),
        "25 H7/g6: clearance +7 … +41 µm, middle +24 µm",
        "and it means the same"
    );
    assert_eq!((session.recent_files()[0].purpose, &session.recent_files()[0].path), (purpose, &path));
}

#[test]
fn of_a_hundred_thousand_parts_only_those_in_sight_are_drawn() {
    let list = |name: &str, first: i64, count: i64| {
        let row =
            |at: i64| format!("{name}{at};{}.{:06}\n", (first + at * 10) / 1_000_000, (first + at * 10) % 1_000_000);
        (0..count).map(row).fold("id;measured\n".to_owned(), |text, row| text + &row)
    };
    let mut session = paired_with("0.010..0.030", &list("H", 25_000_000, 100_000), &list("S", 24_980_000, 100_000));
    let paired = session.pairing().paired.as_deref().unwrap();
    assert_eq!(paired.count(), 100_000);
    for place in [None, Some(0), Some(50_000), Some(99_999)] {
        let sight = paired.picture.sight(place);
        assert!(!sight.is_all && sight.pairs.range.contains(&place.unwrap_or_default()), "{place:?} {sight:?}");
        assert!((10..=60).contains(&sight.pairs.drawn().count()), "{place:?} {sight:?}");
    }
    // All of one size: thinned, and said so.
    let same = |name: &str, mm: &str| {
        (0..5_000).fold("id;measured\n".to_owned(), |text, at| format!("{text}{name}{at};{mm}\n"))
    };
    open(&mut session, Feature::Hole, "same.csv", &same("H", "25"));
    open(&mut session, Feature::Shaft, "too.csv", &same("S", "24.98"));
    let paired = session.pairing().paired.as_deref().unwrap();
    let sight = paired.picture.sight(Some(7));
    assert_eq!((sight.pairs.range.len(), sight.step(), sight.pairs.drawn().count()), (5_000, 84, 60));
    assert!(sight.low < sight.high);
}

#[test]
fn the_picture_has_a_pair_at_the_middle_level_and_every_part_on_its_scale() {
    let session = paired_with(WANTED, HOLES, SHAFTS);
    let paired = session.pairing().paired.as_deref().unwrap();
    let sight = paired.picture.sight(None);
    assert!(sight.is_all);
    let [hole, shaft] = paired.picture.pair(0).unwrap();
    assert!((hole - shaft).abs() < 1e-9, "+15 µm is the middle");
    let [hole, shaft] = paired.picture.pair(2).unwrap();
    assert!((hole - shaft + 2.0).abs() < 1e-9, "+13 µm is 2 µm tighter, and the shaft higher");
    let left = [paired.picture.hole(0).unwrap(), paired.picture.shaft(0).unwrap()];
    assert!(left.into_iter().all(|um| (0.0..=1.0).contains(&sight.fraction(um))));
    assert_eq!((paired.left_hole(0).unwrap().id.as_str(), paired.left_shaft(0).unwrap().id.as_str()), ("H4", "S3"));
    assert!(paired.picture.bins.iter().map(|bin| bin.holes + bin.left_holes).sum::<f64>() > 0.0);
}

#[test]
fn what_is_saved_is_what_is_shown() {
    let mut session = paired_with(WANTED, HOLES, SHAFTS);
    apply(&mut session, Command::OpenDialog(Purpose::SavePairs(0)));
    assert_eq!(session.dialog().unwrap().path, "pairs-2026-11-21.csv");
    let effects = apply(&mut session, Command::Confirm);
    let content = effects.iter().find_map(|effect| match effect.errand() {
        Effect::Save(_, content) => Some(content),
        _ => None,
    });
    assert!(matches!(content, Some(Content::Pairs { .. })));
}
