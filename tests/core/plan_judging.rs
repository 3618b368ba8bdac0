//! A plan judges alike wherever its values come from: what it says counts, and what is given beside it and does not count is told.

use assert_cmd::cargo::cargo_bin_cmd;
use fitcheck::exchange::import_each;
use fitcheck::journal::chain::{ChainId, Hash, Head};
use fitcheck::journal::entry::Checked;
use fitcheck::part::Document;
use fitcheck::session::parts::{PlanCommand, WalkCommand};
use fitcheck::session::{
    CheckCommand, CheckField, Command, Effect, Field, OpenJournal, Page, PartsCommand, RecordsCommand, Session,
};
use fitcheck::session::{PartsAction, WalkField};
use fitcheck::tolerance::Sources;
use fitcheck::verdict::rules::RuleName;
use fitcheck::words::{Language, Words};
use jiff::civil::{DateTime, date};
use jiff::tz::{TimeZone, offset};
use serde_json::Value as Json;

use crate::at_home::AtHome as _;

/// A value on the edge of each size: 25.0205 is 0.5 µm below the limit, 100.010 of the face 10 µm above its own.
const PLAN: &str = "\
name;kind;axis;callout;feature;rule;u_um;material
STRICT;;;25 H7;;iso14253-2017;1;aluminium
PLAIN;;;25 H7;;simple;;
SURE;;;25 H7;;;0.2;
OPEN;;;25 H7;;;;
WIDE;width;;16 H8;;;;
TOP;face;-Z;100 h6;;;;
SHAFT;;;25 h6;;;;steel
";

const VALUES: &str = "\
name;measured
STRICT;25.0205
PLAIN;25.0205
SURE;25.0205
OPEN;25.0205
WIDE;16.028
TOP;100.010
SHAFT;25.002
";

/// A verdict: name, measured value at 20 °C, status, rule.
type Verdict = (String, String, String, String);

fn now() -> DateTime {
    date(2026, 11, 24).at(10, 42, 7, 0)
}

/// What `fitcheck import` makes of the values, and what it says of each.
fn by_import(options: &[&str]) -> Vec<(Verdict, String)> {
    let folder = tempfile::tempdir().unwrap();
    for (name, text) in [("plan.csv", PLAN), ("v.csv", VALUES)] {
        fitcheck::files::write(&folder.path().join(name), text.as_bytes()).unwrap();
    }
    let mut command = cargo_bin_cmd!("fitcheck");
    command.at_home(folder.path()).current_dir(folder.path());
    let import = ["import", "--plan", "plan.csv", "v.csv", "--format", "json"];
    let output = command.args(import).args(options).output().unwrap();
    let text = String::from_utf8(output.stdout).unwrap();
    let rows: Vec<Json> = serde_json::from_str(&text).unwrap_or_else(|error| panic!("{error}: {text}"));
    let text = |value: &Json| value.as_str().unwrap_or_default().to_owned();
    let of = |row: &Json| {
        let rule = match row.get("rule_name").map_or("", |rule| rule.as_str().unwrap_or_default()) {
            "" => "simple".to_owned(),
            rule => rule.to_owned(),
        };
        let measured = row["measured_mm"].to_string();
        let measured = measured.trim_end_matches('0').trim_end_matches('.').to_owned();
        ((text(&row["id"]), measured, text(&row["status"]), rule), format!("{}{}", row["warnings"], row["error"]))
    };
    rows.iter().map(of).collect()
}

fn typed(session: &mut Session, field: impl Into<Field>, text: &str) {
    let command = field.into().typed(text.to_owned());
    session.apply(command, now());
}

/// What the walk makes of the same values, by the check page as `ask` has filled it in, and what it says of each.
fn by_session(ask: impl Fn(&mut Session)) -> Vec<(Verdict, String)> {
    let mut session = Session::new(Language::En);
    let mut send = |command: Command| session.apply(command, now());
    let (usual, zone) = (Some("/data/journal.sqlite".into()), TimeZone::fixed(offset(1)));
    send(RecordsCommand::Begin { usual, station: "Mill 3".to_owned(), zone }.into());
    let head = Head { number: 7, hash: Hash([7; 32]) };
    let journal = OpenJournal { chain: ChainId([1; 16]), head, remarks: Vec::new() };
    send(RecordsCommand::Opened(Ok((Box::new(journal), Vec::new()))).into());
    send(Command::OpenPage(Page::Parts));
    let document = Document::read(PLAN.as_bytes()).unwrap();
    let read = PlanCommand::Read { path: "/plans/p.csv".into(), result: Ok(Box::new(document)) };
    send(PartsCommand::Plan(read).into());
    ask(&mut session);
    typed(&mut session, WalkField::Serial, "1");
    let command = PartsAction::BeginPart.command(&session).expect("a part can be begun");
    session.apply(command, now());
    let mut items = Vec::new();
    import_each("v.csv", VALUES.as_bytes(), &Sources::default(), now(), &mut |item| items.push(item));
    let run = session.parts().walking.run;
    let imported = WalkCommand::Imported { name: "v.csv".to_owned(), run, result: Ok(items) };
    let effects = session.apply(imported.into(), now());
    let entries = effects.iter().find_map(|effect| match effect {
        Effect::Keep { entries, .. } => Some(entries.clone()),
        _ => None,
    });
    let words = Words::new(Language::En);
    let walking = &session.parts().walking;
    let entries = entries.unwrap_or_default();
    let of = |(at, entry): (usize, &fitcheck::journal::entry::Entry)| {
        let Checked::Size(record) = &entry.check().unwrap().what else { panic!("{entry:?}") };
        let verdict = &record.verdict;
        let measured = record.measurement.diameter.to_string();
        let measured = measured.trim_end_matches('0').trim_end_matches('.').to_owned();
        let rule = verdict.rule.name().word().to_owned();
        let said = walking.values(at).last().unwrap().remarks.iter().map(|remark| words.say(remark));
        ((record.id.clone(), measured, verdict.status().word().to_owned(), rule), said.collect::<Vec<_>>().join("; "))
    };
    entries.iter().enumerate().map(of).collect()
}

fn verdicts(of: &[(Verdict, String)]) -> Vec<&Verdict> {
    of.iter().map(|(verdict, _)| verdict).collect()
}

/// The verdict of a size, and that this is said of it in both.
#[track_caller]
fn has(all: [&[(Verdict, String)]; 2], name: &str, status: &str, said: &str) {
    for of in all {
        let found = of.iter().find(|((id, ..), _)| id == name).unwrap_or_else(|| panic!("{name}: {of:?}"));
        assert_eq!(found.0.2, status, "{found:?}");
        assert!(found.1.contains(said), "{said}: {found:?}");
    }
}

fn use_rule(session: &mut Session, rule: RuleName, u: &str) {
    session.apply(CheckCommand::UseRule(rule).into(), now());
    typed(session, CheckField::Uncertainty, u);
}

#[test]
fn command_line_and_window_judge_the_same_values_alike_by_the_plan_alone() {
    let (import, walk) = (by_import(&[]), by_session(|_| {}));
    assert_eq!(verdicts(&import), verdicts(&walk));
    let both = [&import[..], &walk[..]];
    has(both, "STRICT", "RE-MEASURE", "");
    has(both, "PLAIN", "GOOD", "");
    has(both, "TOP", "REWORK", "");
}

#[test]
fn the_plans_rule_and_uncertainty_count_over_those_that_are_given_and_the_others_apply_where_it_has_none() {
    let import = by_import(&["--rule", "ilac-g8", "--u", "2.5"]);
    let walk = by_session(|session| use_rule(session, RuleName::IlacG8, "2.5"));
    assert_eq!(verdicts(&import), verdicts(&walk));
    let both = [&import[..], &walk[..]];
    has(both, "STRICT", "RE-MEASURE", "judged by the plan's rule instead of ilac-g8: ISO 14253-1:2017");
    has(both, "STRICT", "RE-MEASURE", "judged with the plan's uncertainty instead of the given one: u = 1 µm");
    // An explicit simple rule is one.
    has(both, "PLAIN", "GOOD", "judged by the plan's rule instead of ilac-g8: no guard band");
    // The plan's uncertainty with the given rule: 0.4 µm are within 0.5 µm.
    has(both, "SURE", "GOOD", "judged with the plan's uncertainty instead of the given one: u = 0.2 µm");
    has(both, "OPEN", "RE-MEASURE", "");
    let is_silent = import.iter().find(|(verdict, _)| verdict.0 == "OPEN").is_some_and(|(_, said)| said == "[]null");
    assert!(is_silent, "{import:?}");
}

#[test]
fn what_does_not_differ_from_the_plan_is_not_warned_of() {
    let import = by_import(&["--rule", "iso14253-2017", "--u", "1", "--temperature", "20", "--material", "aluminium"]);
    let strict = import.iter().find(|(verdict, _)| verdict.0 == "STRICT").unwrap();
    assert_eq!((strict.0.2.as_str(), strict.1.as_str()), ("RE-MEASURE", "[]null"));
}

/// At 30 °C 25 mm of aluminium (23.1) are 5.8 µm longer, of steel (11.5) 2.9 µm, and 100 mm of a face are no size.
#[test]
fn values_of_files_are_brought_to_20_degrees_with_the_plans_material_and_places_on_the_part_are_not() {
    let import = by_import(&["--temperature", "30", "--material", "11.5"]);
    let walk = by_session(|session| {
        typed(session, CheckField::PartTemperature, "30");
        typed(session, CheckField::PartExpansion, "11.5");
    });
    assert_eq!(verdicts(&import), verdicts(&walk));
    let both = [&import[..], &walk[..]];
    has(both, "TOP", "REWORK", "not corrected to 20 °C: a location on the part is not a size");
    has(both, "STRICT", "GOOD", "corrected to 20 °C with the plan's material instead of the given one: aluminium");
    has(both, "SHAFT", "GOOD", "");
    assert_eq!((import[0].0.1.as_str(), import[6].0.1.as_str()), ("25.01472", "24.999125"));
    for (_, said) in walk.iter().filter(|(verdict, _)| verdict.0 != "TOP") {
        assert!(said.contains("corrected from 30 °C to 20 °C (expansion "), "{said}");
    }
}
