//! The language of questions to a journal: what each word asks for, errors with their places, and texts that read back.

use fitcheck::journal::ask::{AskedKinds, LocalNow, Question};
use fitcheck::verdict::Status;
use jiff::Timestamp;
use jiff::tz::{Offset, TimeZone};
use proptest::prelude::*;
use proptest::sample::select;

/// A Monday afternoon, an hour ahead of UTC.
fn here() -> LocalNow {
    LocalNow { now: "2026-11-23T14:30:00Z".parse().unwrap(), zone: TimeZone::fixed(Offset::constant(1)) }
}

fn read(text: &str) -> Question {
    Question::read(text, &here()).unwrap_or_else(|error| panic!("{text}: {error}"))
}

fn ms(text: &str) -> i64 {
    text.parse::<Timestamp>().unwrap().as_millisecond()
}

#[test]
fn every_word_asks_for_what_it_says() {
    let some = |text: &str| Some(text.to_owned());
    let all = "part:Flange serial:17* feature:B1 callout:\"25H7\" class:H7 verdict:scrap,Rework who:Anna \
        station:\"Mill 3\" from:2026-11-01 to:2026-11-23 measured standing checks burr";
    let wanted = Question {
        part: some("Flange"),
        serial: some("17*"),
        feature: some("B1"),
        callout: some("25 H7"),
        class: some("H7"),
        verdicts: vec![Status::Scrap, Status::Rework],
        who: some("Anna"),
        station: some("Mill 3"),
        from_ms: Some(ms("2026-10-31T23:00:00Z")),
        before_ms: Some(ms("2026-11-23T23:00:00Z")),
        simulated: Some(false),
        standing: true,
        kinds: AskedKinds::Checks,
        words: vec!["burr".to_owned()],
    };
    assert_eq!(read(all), wanted);
    assert_eq!(read(" \t "), Question::default());
    assert_eq!(read("PART:x Simulated"), Question { part: some("x"), simulated: Some(true), ..Question::default() });
    assert_eq!(read("Reports flange").kinds, AskedKinds::Reports);
    assert_eq!(read("alarms standing").kinds, AskedKinds::Alarms);
    assert_eq!(read("\"reports\""), Question { words: vec!["reports".to_owned()], ..Question::default() });
    assert_eq!(read("part:\"\""), Question { part: some(""), ..Question::default() });
    assert_eq!(read("part:\"a \"\"b\"\"\"").part, some("a \"b\""));
    // Limits from a log have no callout.
    assert_eq!(read("callout:Ø25,30").callout, some("Ø 25.3"));
    assert_eq!(read("verdict:remeasure,RE-MEASURE").verdicts, [Status::ReMeasure]);
    assert_eq!(read("12:30 \"today\" \"part:x\" ::").words, ["12:30", "today", "part:x", "::"]);
}

#[test]
fn the_word_of_a_verdict_asks_for_it_unless_it_is_quoted() {
    let verdicts = |text: &str| (read(text).verdicts, read(text).words);
    assert_eq!(verdicts("Good burr"), (vec![Status::Good], vec!["burr".to_owned()]));
    assert_eq!(verdicts("scrap rework scrap").0, [Status::Scrap, Status::Rework], "any of them");
    assert_eq!(verdicts("re-measure").0, [Status::ReMeasure]);
    assert_eq!(verdicts("verdict:good scrap").0, [Status::Good, Status::Scrap]);
    assert!(read("good").standing && read("standing good").standing, "what is void has no verdict that counts");
    assert!(!read("verdict:good").standing && !read("\"good\"").standing);
    assert_eq!(verdicts("\"good\" scrapped"), (vec![], vec!["good".to_owned(), "scrapped".to_owned()]));
    // As the window calls them, also in two words.
    let named = [("GOED".to_owned(), Status::Good), ("OPNIEUW METEN".to_owned(), Status::ReMeasure)];
    let named = |text: &str| Question::read_named(text, &here(), &named).unwrap();
    assert_eq!(named("opnieuw meten goed").verdicts, [Status::ReMeasure, Status::Good]);
    assert_eq!(named("opnieuw \"meten\"").words, ["opnieuw", "meten"]);
}

#[test]
fn days_are_those_of_the_place() {
    let today = Question {
        from_ms: Some(ms("2026-11-22T23:00:00Z")),
        before_ms: Some(ms("2026-11-23T23:00:00Z")),
        ..Question::default()
    };
    assert_eq!(read("today"), today);
    assert_eq!(read("from:2026-11-23 to:2026-11-23"), today);
    let week = Question { before_ms: Some(ms("2026-11-29T23:00:00Z")), ..today.clone() };
    assert_eq!(read("week"), week);
    // A Sunday evening in UTC is a Monday in Auckland.
    let there = LocalNow { now: "2026-11-22T12:30:00Z".parse().unwrap(), zone: TimeZone::fixed(Offset::constant(13)) };
    let found = Question::read("week", &there).unwrap();
    assert_eq!((found.from_ms, found.before_ms), (Some(ms("2026-11-22T11:00:00Z")), Some(ms("2026-11-29T11:00:00Z"))));
    let times = read("from:2026-11-23T14:30 to:2026-11-23T13:45:10.5Z");
    assert_eq!(
        (times.from_ms, times.before_ms),
        (Some(ms("2026-11-23T13:30:00Z")), Some(ms("2026-11-23T13:45:10.5Z")))
    );
}

#[test]
fn a_day_on_which_clocks_change_is_whole() {
    let zone = TimeZone::posix("CET-1CEST,M3.5.0,M10.5.0/3").unwrap();
    let here = LocalNow { zone, ..here() };
    let found = Question::read("from:2026-10-25 to:2026-10-25", &here).unwrap();
    let hours = (found.before_ms.unwrap() - found.from_ms.unwrap()) / 3_600_000;
    assert_eq!((hours, found.text(&here).as_str()), (25, "from:2026-10-25 to:2026-10-25"));
}

#[track_caller]
fn refused(text: &str, wanted: &str) {
    match Question::read(text, &here()) {
        Ok(found) => panic!("{text}: {found:?}"),
        Err(error) => {
            assert_eq!(error.to_string(), wanted, "{text}");
            assert!(error.span.start <= error.span.end && error.span.end <= text.chars().count(), "{:?}", error.span);
        }
    }
}

#[test]
fn what_is_no_question_is_refused_with_its_place_and_what_is_allowed() {
    refused(
        "burr color:red",
        "color: is not a known keyword; expected part:, serial:, feature:, callout:, class:, verdict:, who:, station:, \
         from:, to:, or quotation marks around a word with a colon (character 6)",
    );
    refused("part: x", "part: has no value (character 1)");
    refused("ø part:a part:b", "part is given twice (character 10)");
    refused("verdict:good verdict:scrap", "verdict is given twice (character 14)");
    refused(
        "verdict:good,bad",
        "\"bad\" is not a verdict: expected good, rework, re-measure, out-of-limits, scrap (character 9)",
    );
    refused("verdict:", "verdict: has no value (character 1)");
    refused(
        "from:2026-02-30",
        "\"2026-02-30\" is not a day or a time: expected 2026-11-23 or 2026-11-23T14:30 (character 6)",
    );
    refused(
        "to:23.11.2026",
        "\"23.11.2026\" is not a day or a time: expected 2026-11-23 or 2026-11-23T14:30 (character 4)",
    );
    refused("from:2026-11-24 to:2026-11-23", "the period ends before it begins: from must be before to (character 17)");
    refused("today to:2026-11-30", "to is given twice (character 7)");
    refused("today week", "week is given twice (character 7)");
    refused("simulated measured", "simulated and measured exclude each other (character 11)");
    refused("standing standing", "standing is given twice (character 10)");
    refused("reports reports", "reports is given twice (character 9)");
    refused("reports checks", "reports and checks exclude each other (character 9)");
    refused("part:\"a b", "a quotation mark is not closed (character 6)");
    refused("part:\"a\"b", "expected a blank after the closing quotation mark, found b (character 9)");
    refused("\"\"", "a word in quotation marks is empty (character 1)");
    refused(
        "callout:25 H7",
        "a tolerance is missing, such as H7, h7, H7/g6, m, +0.1 -0.2 or ±0.1; a callout goes in quotation marks: callout:\"25 H7\" (character 9)",
    );
    assert!(Question::read(&"x".repeat(1 << 20), &here()).is_err());
}

fn any_text() -> impl Strategy<Value = String> {
    prop_oneof![
        "\\PC{0,8}",
        select(["a b", "\"", "part:x", "today", "good", "Scrap", "12:30", "", "ÄB", "17*", ":", "\"\""].as_slice())
            .prop_map(str::to_owned)
    ]
}

fn any_question() -> impl Strategy<Value = Question> {
    let names = proptest::collection::vec(proptest::option::of(any_text()), 5);
    let callout = proptest::option::of(
        select(["25 H7", "Ø 25.3", "12 ±0.02", "10m", "25 H7/g6"].as_slice()).prop_map(str::to_owned),
    );
    let class = proptest::option::of(select(["H7", "js6", "PF"].as_slice()).prop_map(str::to_owned));
    let verdicts = proptest::sample::subsequence(Status::ALL.to_vec(), 0..=4);
    let span = (
        0..4_000_000_000_000_i64,
        prop_oneof![Just(1), Just(86_400_000), 1..1_000_000_000_i64],
        0..4_u8,
        any::<bool>(),
    );
    let kinds = select([AskedKinds::All, AskedKinds::Checks, AskedKinds::Reports, AskedKinds::Alarms].as_slice());
    let rest = (proptest::option::of(any::<bool>()), any::<bool>(), kinds, proptest::collection::vec(any_text(), 0..3));
    (names, callout, class, verdicts, span, rest).prop_map(|(names, callout, class, verdicts, span, rest)| {
        let mut names = names.into_iter();
        let (begin, length, which, is_day) = span;
        let begin = if is_day { begin / 86_400_000 * 86_400_000 - 3_600_000 } else { begin };
        let (simulated, standing, kinds, words) = rest;
        Question {
            part: names.next().unwrap(),
            serial: names.next().unwrap(),
            feature: names.next().unwrap(),
            who: names.next().unwrap(),
            station: names.next().unwrap(),
            callout,
            class,
            verdicts,
            from_ms: (which & 1 == 1).then_some(begin),
            before_ms: (which & 2 == 2).then_some(begin + length),
            simulated,
            standing,
            kinds,
            words: words.into_iter().filter(|word| !word.trim().is_empty()).collect(),
        }
    })
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 1_000, ..ProptestConfig::default() })]

    #[test]
    fn a_printed_question_reads_back_as_the_same(question in any_question()) {
        let text = question.text(&here());
        prop_assert_eq!(Question::read(&text, &here()).unwrap(), question, "{}", text);
    }

    #[test]
    fn any_text_is_a_question_or_refused_with_a_place_in_it(text in "[ -~\"ø:]{0,40}|\\PC{0,40}") {
        match Question::read(&text, &here()) {
            Ok(question) => prop_assert_eq!(Question::read(&question.text(&here()), &here()).unwrap(), question),
            Err(error) => prop_assert!(error.span.end <= text.chars().count(), "{:?}", error),
        }
    }
}
