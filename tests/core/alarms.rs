//! Alarms of control charts: which rules fire at the newest value, how they are kept, found and shown, and how the walk asks for cause and
//! action.

use std::path::PathBuf;
use std::process::Output;
use std::sync::Arc;

use assert_cmd::cargo::cargo_bin_cmd;
use fitcheck::journal::ask::Question;
use fitcheck::journal::chain::{Hash, Head};
use fitcheck::journal::entry::{Content, Entry};
use fitcheck::journal::{Alarm, AlarmAnswer, body};
use fitcheck::message::Say as _;
use fitcheck::series::{FeatureSeries, Gathering, Look};
use fitcheck::session::parts::{AlarmSearch, AlarmsFound, NewestValue, WalkCommand, choices};
use fitcheck::session::{
    Command, Effect, PartsAction, RecordRow, RecordsCommand, Session, StatisticsAction, WalkField,
};
use fitcheck::statistics::{Place, Reason, Rule, Rules};
use fitcheck::store::StoreError;
use fitcheck::store::local::{Journal, Opening, Reader, verify};
use fitcheck::words::{Language, Words};
use serde_json::Value as Json;

use crate::at_home::AtHome as _;
use crate::local_journal::{check, moment};
use crate::session_walk::{act, head, kept, said, send, take, typed, walking_by};

/// Values about 25.010 mm that show no pattern, the newest last.
const CALM: [&str; 12] = [
    "25.010", "25.011", "25.009", "25.012", "25.010", "25.008", "25.011", "25.009", "25.010", "25.012", "25.009",
    "25.010",
];

fn entry(measured: &str, serial: &str) -> Entry {
    check("25 H7", measured, ["Flange", serial, "Anna"])
}

/// The series of these values with the numbers from 2 on.
fn series(values: &[&str]) -> FeatureSeries {
    let mut gathering = Gathering::default();
    for (number, measured) in (2..).zip(values) {
        gathering.take(number, &entry(measured, &format!("S-{number}")), false);
    }
    gathering.finish(125).pop().unwrap()
}

/// The rules that fire at the newest of these values, with the entries of the pattern.
fn fired(values: &[&str], known: &[Alarm]) -> Vec<(Rule, u64, u64)> {
    let newest = u64::try_from(values.len()).unwrap() + 1;
    let alarms = series(values).alarms(&Look::default(), newest, known).unwrap();
    alarms
        .iter()
        .map(|(_, alarm)| alarm)
        .filter(|alarm| alarm.place == Place::Location)
        .map(|alarm| (alarm.rule, alarm.first, alarm.last))
        .collect()
}

fn alarm(rule: Rule, first: u64, last: u64) -> Alarm {
    Alarm { rule, place: Place::Location, first, last, since: format!("S-{first}"), answer: None }
}

#[test]
fn only_a_pattern_of_the_newest_value_is_an_alarm() {
    assert_eq!(fired(&CALM, &[]), []);
    let out = [&CALM[..], &["25.020"]].concat();
    assert_eq!(fired(&out, &[]), [(Rule::BeyondLimits, 14, 14)]);
    // The next value is calm: what fired before is not its own.
    assert_eq!(fired(&[&out[..], &["25.010"]].concat(), &[]), []);
    // A value that is not the newest one fires nothing.
    assert_eq!(series(&out).alarms(&Look::default(), 13, &[]), Ok(Vec::new()));
    // A rule that is not looked at fires nothing.
    let look = Look { rules: Rules::NONE, ..Look::default() };
    assert_eq!(series(&out).alarms(&look, 14, &[]), Ok(Vec::new()));
    let since = series(&out).alarms(&Look::default(), 14, &[]).unwrap();
    assert!(since.iter().all(|(serial, alarm)| serial == "S-14" && alarm.since == "S-14"), "{since:?}");
    // Where limits were to come from values that are not there any more, nothing would be seen: that is told.
    let look = Look { baseline: Some([1, 9]), ..Look::default() };
    assert_eq!(series(&out).alarms(&look, 14, &[]), Err(Reason::NoBaseline));
}

#[test]
fn a_pattern_that_goes_on_is_one_alarm_and_each_point_beyond_the_limits_is_one() {
    let rising = ["25.006", "25.007", "25.008", "25.009", "25.010", "25.011"];
    let trend = [&CALM[..6], &rising[..]].concat();
    let of_trend = |known: &[Alarm], values: &[&str]| {
        fired(values, known).into_iter().filter(|(rule, ..)| *rule == Rule::SixTrend).collect::<Vec<_>>()
    };
    let [(rule, first, last)] = of_trend(&[], &trend)[..] else { panic!("{:?}", fired(&trend, &[])) };
    assert_eq!(last, 13);
    let known = [alarm(rule, first, last)];
    let longer = [&trend[..], &["25.012"]].concat();
    assert_eq!(of_trend(&[], &longer), [(Rule::SixTrend, first, 14)]);
    assert_eq!(of_trend(&known, &longer), []);
    // Another rule, and the other figure of the chart, are patterns of their own.
    assert_eq!(of_trend(&[alarm(Rule::NineOneSide, first, last)], &longer).len(), 1);
    assert_eq!(of_trend(&[Alarm { place: Place::Spread, ..known[0].clone() }], &longer).len(), 1);
    let out = [&CALM[..], &CALM[..], &["25.030", "25.030"]].concat();
    let known = [alarm(Rule::BeyondLimits, 26, 26)];
    assert!(fired(&out, &known).contains(&(Rule::BeyondLimits, 27, 27)), "{:?}", fired(&out, &known));
}

fn answer(target: Head) -> AlarmAnswer {
    AlarmAnswer { target, cause: "Tool wear".to_owned(), action: "Tool changed".to_owned() }
}

fn of_alarm(alarm: Alarm) -> Entry {
    let about = entry("25.012", "S-9").about;
    Entry { about, content: Content::Alarm(Box::new(alarm)) }
}

#[test]
fn an_alarm_is_of_the_sixth_version_and_what_it_cannot_say_is_refused() {
    let target = Head { number: 12, hash: Hash([7; 32]) };
    let entry = of_alarm(Alarm { answer: Some(answer(target)), ..alarm(Rule::NineOneSide, 2, 10) });
    let bytes = body::write(&entry).unwrap();
    let text = String::from_utf8(bytes.clone()).unwrap();
    assert!(text.starts_with("{\"v\":6,\"kind\":\"alarm\",\"about\":{"), "{text}");
    let expected = format!(
        "\"alarm\":{{\"rule\":\"nelson-2\",\"place\":\"location\",\"first\":2,\"last\":10,\"since\":\"S-2\",\
         \"answers\":{{\"number\":12,\"hash\":\"{}\"}},\"cause\":\"Tool wear\",\"action\":\"Tool changed\"}}}}",
        target.hash
    );
    assert!(text.ends_with(&expected), "{text}");
    assert_eq!(body::read(&bytes).unwrap(), entry);
    for (from, to) in [
        ("nelson-2", "nelson-9"),
        ("location", "middle"),
        ("\"first\":2,", "\"first\":1,"),
        ("\"number\":12", "\"number\":10"),
        ("Tool wear", " "),
        ("Tool changed", ""),
        ("\"v\":6", "\"v\":5"),
        ("\"v\":6", "\"v\":7"),
        ("\"kind\":\"alarm\"", "\"kind\":\"report\""),
    ] {
        assert!(text.contains(from), "{from}");
        assert!(body::read(text.replacen(from, to, 1).as_bytes()).is_err(), "{to}");
    }
    let found = body::found(&bytes).unwrap().unwrap();
    assert_eq!((found.corrects, &*found.reason, found.status), (Some(12), "Tool wear; Tool changed", None));
    let open = body::write(&of_alarm(alarm(Rule::NineOneSide, 2, 10))).unwrap();
    assert_eq!(body::found(&open).unwrap().unwrap().corrects, None);
}

/// A journal of ten checks, numbers 2 to 11, an alarm, 12, and its answer, 13.
struct Kept(tempfile::TempDir);

impl Kept {
    fn path(&self) -> PathBuf {
        self.0.path().join("j.sqlite")
    }

    fn open(&self) -> Journal {
        let opening = Opening { anchors: None, ..Opening::new("Mill 3", moment(1_795_456_800_000)) };
        Journal::open(&self.path(), &opening).unwrap()
    }

    fn with_alarm() -> (Self, Head) {
        let kept = Self(tempfile::tempdir().unwrap());
        let checks: Vec<Entry> = (2..12).map(|number| entry("25.012", &format!("S-{number}"))).collect();
        let mut journal = kept.open();
        journal.append(&checks).unwrap();
        let head = journal.append(&[of_alarm(alarm(Rule::NineOneSide, 2, 10))]).unwrap()[0].head;
        (kept, head)
    }

    fn numbers(&self, question: &str) -> Vec<u64> {
        let here = fitcheck::journal::ask::LocalNow { now: jiff::Timestamp::UNIX_EPOCH, zone: jiff::tz::TimeZone::UTC };
        let question = Question::read(question, &here).unwrap();
        Reader::open(&self.path()).unwrap().numbers(&question, None, 100).unwrap()
    }

    fn say(&self, line: &str) -> String {
        let mut command = cargo_bin_cmd!("fitcheck");
        command.env_remove("FITCHECK_JOURNAL");
        command.at_home(self.0.path()).env("TZ", "UTC").current_dir(self.0.path());
        let Output { status, stdout, stderr } =
            command.args(line.split(' ')).args(["--journal", "j.sqlite"]).output().unwrap();
        let out = String::from_utf8(stdout).unwrap();
        assert_eq!(status.code(), Some(0), "{line}: {out}{}", String::from_utf8_lossy(&stderr));
        out
    }
}

#[test]
fn alarms_are_found_answered_once_and_never_corrected() {
    let (kept, target) = Kept::with_alarm();
    assert_eq!(kept.numbers("alarms"), [12]);
    assert_eq!(kept.numbers("alarms standing"), [12]);
    assert_eq!(kept.numbers("alarms part:Flange"), [12]);
    assert_eq!(kept.numbers("checks").len(), 10);
    assert_eq!(kept.numbers("standing").len(), 10, "an alarm is no check");
    assert_eq!(kept.numbers("measured").len(), 10);
    let answered = Alarm { answer: Some(answer(target)), ..alarm(Rule::NineOneSide, 2, 10) };
    let mut journal = kept.open();
    // A check is no alarm, and another entry of that number is not the one that was meant.
    let first = journal.append(&[entry("25.012", "S-20")]).unwrap()[0].head;
    let wrong = Alarm { answer: Some(answer(first)), ..answered.clone() };
    let refused = journal.append(&[of_alarm(wrong)]).unwrap_err();
    assert!(matches!(refused, StoreError::NoAlarm { number: 13 }), "{refused:?}");
    let other = Head { hash: Hash([1; 32]), ..target };
    let wrong = Alarm { answer: Some(answer(other)), ..answered.clone() };
    assert!(matches!(journal.append(&[of_alarm(wrong)]).unwrap_err(), StoreError::OtherTarget { number: 12 }));
    journal.append(&[of_alarm(answered.clone())]).unwrap();
    let twice = journal.append(&[of_alarm(answered)]).unwrap_err();
    assert!(matches!(twice, StoreError::Corrected { number: 12, by: 14 }), "{twice:?}");
    let correction = fitcheck::journal::entry::Correction { target, reason: "x".to_owned(), by: String::new() };
    let withdrawal = Entry { content: Content::Withdrawal(correction), ..entry("25.012", "S-9") };
    assert!(matches!(journal.append(&[withdrawal]).unwrap_err(), StoreError::IsAlarm { number: 12 }));
    drop(journal);
    assert_eq!(kept.numbers("alarms"), [14, 12]);
    assert!(kept.numbers("alarms standing").is_empty());
    assert_eq!(kept.numbers("alarms wear"), [14]);
    let found = verify(&kept.path(), &[], &mut |_, _| std::ops::ControlFlow::Continue(())).unwrap();
    assert!(found.inspected.breaks.is_empty() && found.findings.is_empty());
}

#[test]
fn the_command_line_shows_alarms_and_leaves_them_out_of_tables_of_checks() {
    let (kept, target) = Kept::with_alarm();
    let answered = Alarm { answer: Some(answer(target)), ..alarm(Rule::NineOneSide, 2, 10) };
    kept.open().append(&[of_alarm(answered)]).unwrap();
    let rule = Rule::NineOneSide.message().to_string();
    let listed = kept.say("journal list");
    assert!(listed.contains("answers the alarm of entry 12: Tool wear; Tool changed"), "{listed}");
    assert!(listed.contains("alarm: ") && listed.contains("see entry 13"), "{listed}");
    let shown = kept.say("journal show 12");
    assert!(shown.contains(&format!("alarm        {rule}, since part S-2\n")), "{shown}");
    assert!(shown.contains("rule         nelson-2, location\n"), "{shown}");
    assert!(shown.contains("entry 13, which answers this one"), "{shown}");
    let shown = kept.say("journal show 13");
    assert!(shown.contains("cause        Tool wear\n") && shown.contains("action       Tool changed\n"), "{shown}");
    let json: Json = serde_json::from_str(&kept.say("journal list alarms --format json")).unwrap();
    assert_eq!(json[0]["alarm"]["answers"], 12);
    assert_eq!((&json[1]["alarm"]["rule"], &json[1]["corrected_by"]), (&Json::from("nelson-2"), &Json::from(13)));
    assert_eq!(kept.say("journal list --format csv").lines().count(), 11);
    assert_eq!(kept.say("journal export").lines().count(), 11);
    assert_eq!(kept.say("journal export alarms --format json").lines().count(), 2);
    assert!(kept.say("journal verify").contains("13"), "the chain is whole");
}

// ---- the walk ----

const PLAN: &str =
    "fitcheck_plan = 1\npart = \"Flange\"\n\n[[feature]]\nname = \"A\"\ncallout = \"25 H7\"\nx = 50\ny = 65\nz = -8\n";

/// What is looked for among the effects.
fn searched(effects: &[Effect]) -> Option<AlarmSearch> {
    effects.iter().find_map(|effect| match effect {
        Effect::FindAlarms(search) => Some((**search).clone()),
        _ => None,
    })
}

fn heads(session: &mut Session, run: u64, numbers: &[u64]) -> Vec<Effect> {
    let heads = numbers.iter().map(|number| head(*number)).collect();
    send(session, RecordsCommand::Kept { run, result: Ok(heads) })
}

fn row(number: u64, entry: Entry) -> RecordRow {
    RecordRow { head: head(number), entry: Ok(entry), corrected_by: None, went_back: false }
}

fn found(fired: Vec<(NewestValue, Alarm)>, open: Vec<RecordRow>) -> WalkCommand {
    WalkCommand::AlarmsFound(Ok(Box::new(AlarmsFound { fired, open, unchecked: Vec::new() })))
}

#[test]
fn a_recorded_value_is_looked_at_and_what_fires_is_kept_told_and_answered() {
    let mut session = walking_by(PLAN);
    let (run, _) = kept(&take(&mut session, "25.012"));
    let search = searched(&heads(&mut session, run, &[30])).unwrap();
    let value = NewestValue { number: 30, part: "Flange".into(), serial: "A-0099".into(), feature: "A".into() };
    assert_eq!((&search.newest[..], search.most, search.look), (&[value.clone()][..], 125, Look::default()));
    let verdict = session.parts().walking.status();
    // It fires: the alarm is an entry of its own, and is told.
    let fired = alarm(Rule::NineOneSide, 20, 30);
    let (run, entries) = kept(&send(&mut session, found(vec![(value.clone(), fired.clone())], Vec::new())));
    let [raised] = &entries[..] else { panic!("{entries:?}") };
    assert_eq!(raised.alarm(), Some(&fired));
    assert_eq!([&raised.about.part, &raised.about.serial, &raised.about.feature], ["Flange", "A-0099", "A"]);
    let told = said(&session.notices().last().unwrap().message);
    let rule = said(&Rule::NineOneSide.message());
    assert_eq!(told, format!("Flange A: {rule}, since part S-20"));
    assert_eq!(session.parts().walking.status(), verdict, "no verdict changes");
    // The same pattern that was sent is not sent again.
    let again = send(&mut session, found(vec![(value, Alarm { last: 31, ..fired.clone() })], Vec::new()));
    assert!(again.iter().all(|effect| !matches!(effect, Effect::Keep { .. })), "{again:?}");
    assert_eq!(session.parts().alarms.open().len(), 0, "it is open once it is on disk");
    let search = searched(&heads(&mut session, run, &[31])).unwrap();
    assert_eq!(search.newest, []);
    send(&mut session, found(Vec::new(), vec![row(31, raised.clone())]));
    assert_eq!(session.parts().alarms.open().len(), 1);
    // It is answered later, and then at once.
    let effects = act(&mut session, PartsAction::AskAlarm.into());
    assert_eq!(effects, [Effect::Focus(WalkField::Cause.into())]);
    act(&mut session, PartsAction::LeaveAlarm.into());
    assert_eq!(session.parts().alarms.open().len(), 1);
    act(&mut session, PartsAction::AskAlarm.into());
    act(&mut session, PartsAction::AnswerAlarm.into());
    assert_eq!(said(session.error(WalkField::Cause).unwrap()), "write a text, or choose one from the list");
    typed(&mut session, WalkField::Cause, "Tool wear");
    typed(&mut session, WalkField::Action, " Coolant filled up ");
    let (run, entries) = kept(&act(&mut session, PartsAction::AnswerAlarm.into()));
    let answer = entries[0].alarm().unwrap().answer.clone().unwrap();
    assert_eq!(answer, AlarmAnswer { target: head(31), cause: "Tool wear".into(), action: "Coolant filled up".into() });
    assert_eq!(session.parts().alarms.open(), []);
    // A list that was read before the answer was on disk does not bring it back.
    send(&mut session, found(Vec::new(), vec![row(31, raised.clone())]));
    assert_eq!(session.parts().alarms.open(), []);
    assert!(searched(&heads(&mut session, run, &[32])).is_some());
    assert_eq!(session.text(WalkField::Cause), "");
}

/// Nothing would be seen from now on: that is told, and not again at every value.
#[test]
fn rules_that_cannot_be_looked_at_are_told_once() {
    let mut session = walking_by(PLAN);
    let value = NewestValue { number: 30, part: "Flange".into(), serial: "A-1".into(), feature: "A".into() };
    let unchecked = vec![(value, Reason::NoBaseline.message())];
    let found = WalkCommand::AlarmsFound(Ok(Box::new(AlarmsFound { unchecked, ..AlarmsFound::default() })));
    send(&mut session, found.clone());
    let why = said(&Reason::NoBaseline.message());
    let expected = format!("Cannot look at the rules of control charts, Flange A: {why}");
    let told = |session: &Session| {
        session.notices().iter().filter(|notice| said(&notice.message).starts_with("Cannot look")).count()
    };
    assert_eq!(said(&session.notices().last().unwrap().message), expected);
    send(&mut session, found);
    assert_eq!(told(&session), 1);
}

#[test]
fn what_fires_at_one_value_is_answered_once() {
    let mut session = walking_by(PLAN);
    let at_one = [Place::Location, Place::Spread].map(|place| Alarm { place, ..alarm(Rule::BeyondLimits, 10, 10) });
    let open = at_one.into_iter().chain([alarm(Rule::NineOneSide, 2, 11)]);
    let rows = (12..).zip(open).map(|(number, alarm)| row(number, of_alarm(alarm))).collect();
    send(&mut session, found(Vec::new(), rows));
    act(&mut session, PartsAction::AskAlarm.into());
    typed(&mut session, WalkField::Cause, "Chips or dirt");
    typed(&mut session, WalkField::Action, "Machine cleaned");
    let (_, entries) = kept(&act(&mut session, PartsAction::AnswerAlarm.into()));
    let answered = entries.iter().map(|entry| entry.alarm().unwrap().answer.as_ref().unwrap().target.number);
    assert_eq!(answered.collect::<Vec<_>>(), [12, 13]);
    assert_eq!(session.parts().alarms.open().len(), 1);
}

#[test]
fn open_alarms_come_back_after_a_restart_and_are_counted_on_the_statistics_page() {
    let mut session = walking_by(PLAN);
    send(&mut session, found(Vec::new(), vec![row(12, of_alarm(alarm(Rule::NineOneSide, 2, 10)))]));
    let name = |session: &Session| {
        let action: fitcheck::session::Action = StatisticsAction::ShowAlarms.into();
        action.text(session, &Words::new(Language::En))
    };
    assert_eq!(name(&session), "Open alarms: 1");
    send(&mut session, Command::OpenPage(fitcheck::session::Page::Statistics));
    act(&mut session, StatisticsAction::ShowAlarms.into());
    assert_eq!(session.page(), fitcheck::session::Page::Parts);
    // They are asked for as soon as the journal is open.
    let mut session = Session::new(Language::En);
    crate::session_walk::begin_records(&mut session);
    let search = searched(&crate::session_walk::open_journal(&mut session, 7)).unwrap();
    assert_eq!(search.newest, []);
}

#[test]
fn a_simulated_value_raises_no_alarm() {
    let mut session = walking_by(PLAN);
    let (run, _) = kept(&act(&mut session, PartsAction::SimulateValue.into()));
    assert!(searched(&heads(&mut session, run, &[30])).is_none());
}

#[test]
fn what_cannot_be_looked_at_is_told() {
    let mut session = walking_by(PLAN);
    let why = fitcheck::message::message!("records-page-none");
    send(&mut session, WalkCommand::AlarmsFound(Err(why)));
    let told = said(&session.notices().last().unwrap().message);
    assert!(told.starts_with("Cannot look at the rules of control charts: "), "{told}");
}

#[test]
fn every_language_has_causes_and_actions_and_own_texts_replace_them() {
    for language in Language::all() {
        let words = Words::new(language);
        for id in ["walk-page-alarm-causes", "walk-page-alarm-actions"] {
            assert!(5 < choices(&words, id).len(), "{language:?} {id}");
        }
    }
    let own = fitcheck::message::OwnTexts::read("en.ftl", b"walk-page-alarm-causes = Coolant ; ;Night shift\n");
    let words = Words::new(Language::En).with_own(own.ok().map(Arc::new));
    assert_eq!(choices(&words, "walk-page-alarm-causes"), ["Coolant", "Night shift"]);
}
