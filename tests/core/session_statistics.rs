//! The statistics page without a window: what is asked of the journal, the figures of a feature, points that are walked, left out and
//! frozen, and why there is no figure.

use std::path::Path;
use std::sync::Arc;

use fitcheck::journal::Record;
use fitcheck::journal::entry::{About, Check, Checked, Content, Correction, Entry, Moment};
use fitcheck::length::Length;
use fitcheck::message::Message;
use fitcheck::probing::{Measurement, Origin};
use fitcheck::report::{Holds, RENDERINGS, rendering_for};
use fitcheck::series::{Drawn, Factor, FiredAlarm, Gathering, Grouping, LeftOut, Look};
use fitcheck::session::statistics::{Aside, Below, MeanOf, PointsOf, SeriesFound, Zooming};
use fitcheck::session::{
    Command, Content as Written, Effect, Page, Purpose, ReportOf, ReportsCommand, Session, StatisticsAction,
    StatisticsCommand, StatisticsField, Step,
};
use fitcheck::statistics::Rule;
use fitcheck::statistics::picture::Mark;
use fitcheck::tolerance::{Callout, Sources};
use fitcheck::words::{Language, Words};

use crate::session_records::{head, recording, send, typed};

fn words() -> Words {
    Words::new(Language::En)
}

/// A check of part `Flange`, serial `S-N`, by its number, its callout and its value.
fn check(number: u64, feature: &str, callout: &str, mm: &str) -> Entry {
    let callout: Callout = callout.parse().unwrap();
    let limits = Sources::default().limits(&callout, None).unwrap();
    let measurement = Measurement::of_diameter(mm.parse().unwrap(), Origin::Typed);
    let time = jiff::civil::date(2026, 11, 17).at(7, 30, 0, 0);
    let record = Record::judged(time, feature.to_owned(), Some(callout), limits, measurement, None);
    let about = About {
        station: "Mill 3".to_owned(),
        time: Moment { utc_ms: 1_795_254_127_000, offset_min: 60, zone: String::new() },
        who: "Anna".to_owned(),
        part: "Flange".to_owned(),
        serial: format!("S-{number}"),
        feature: feature.to_owned(),
        remark: String::new(),
    };
    let check = Check { what: Checked::Size(Arc::new(record)), files: Vec::new(), corrects: None };
    Entry { about, content: Content::Check(Box::new(check)) }
}

/// What a journal finds: entries with their numbers, and whether others stand in their places.
fn found(entries: &[(u64, Entry, bool)], most: usize) -> SeriesFound {
    let mut gathering = Gathering::default();
    for (number, entry, is_replaced) in entries {
        gathering.take(*number, entry, *is_replaced);
    }
    let features = gathering.finish(most).into_iter().map(Arc::new).collect();
    SeriesFound { features, read: entries.len(), ..SeriesFound::default() }
}

/// Checks of the feature A1, 25 H7.
fn of_values(values: &[&str]) -> Vec<(u64, Entry, bool)> {
    (2..).zip(values).map(|(number, mm)| (number, check(number, "A1", "25 H7", mm), false)).collect()
}

/// Computes what the page asks for, as the world outside does.
fn compute(session: &mut Session, effects: Vec<Effect>) {
    for effect in effects {
        if let Effect::EvaluateSeries { run, features, looks } = effect {
            let answers = features.iter().zip(&looks).map(|(feature, look)| feature.evaluate(look)).collect();
            send(session, StatisticsCommand::Evaluated { run, answers: Arc::new(answers) });
        }
    }
}

/// Does a command, and computes what it asks for.
fn doing(session: &mut Session, command: StatisticsCommand) {
    let effects = send(session, command);
    compute(session, effects);
}

#[track_caller]
fn asked(effects: &[Effect]) -> (u64, String, usize) {
    let asked = effects.iter().find_map(|effect| match effect {
        Effect::ReadSeries { run, question, most, .. } => Some((*run, format!("{question:?}"), *most)),
        _ => None,
    });
    asked.unwrap_or_else(|| panic!("{effects:?}"))
}

/// The page with these checks.
fn page(entries: &[(u64, Entry, bool)]) -> Session {
    let mut session = recording();
    let effects = send(&mut session, Command::OpenPage(Page::Statistics));
    let (run, _, most) = asked(&effects);
    doing(&mut session, StatisticsCommand::Found { run, result: Ok(Arc::new(found(entries, most))) });
    session
}

/// A figure by its name: value, unit, note.
#[track_caller]
fn figure(session: &Session, name: &str) -> [String; 3] {
    let figures = session.statistics().figures(&words());
    let figure = figures.iter().find(|figure| figure.name == name).unwrap_or_else(|| panic!("{name}: {figures:?}"));
    [figure.value.clone(), figure.unit.clone(), figure.note.clone()]
}

/// Ten values with the mean 25.0105 mm and the standard deviation √(82.5/9) µm: 6 to 15 µm above the nominal size.
const TEN: [&str; 10] =
    ["25.010", "25.011", "25.009", "25.012", "25.008", "25.013", "25.007", "25.014", "25.006", "25.015"];

#[test]
fn the_journal_is_asked_when_the_page_opens_and_when_the_question_changes() {
    let mut session = recording();
    let (_, question, most) = asked(&send(&mut session, Command::OpenPage(Page::Statistics)));
    assert!(question.contains("kinds: Checks") && question.contains("standing: false"), "{question}");
    assert_eq!(most, 125);
    let (_, question, _) = asked(&typed(&mut session, StatisticsField::Question, "part:Flange standing"));
    assert!(question.contains("Some(\"Flange\")"), "{question}");
    assert!(question.contains("standing: false"), "what is withdrawn is left out by the page, and counted: {question}");
    assert_eq!(asked(&typed(&mut session, StatisticsField::Last, "50")).2, 50);
    for wrong in ["0", "x", "100001", "-3"] {
        assert!(typed(&mut session, StatisticsField::Last, wrong).is_empty(), "{wrong}");
        assert!(session.error(StatisticsField::Last).is_some(), "{wrong}");
    }
    typed(&mut session, StatisticsField::Last, "125");
    assert!(typed(&mut session, StatisticsField::Question, "verdict:bent").is_empty());
    assert!(session.error(StatisticsField::Question).is_some());
}

#[test]
fn an_answer_to_an_older_question_changes_nothing() {
    let mut session = recording();
    let (run, _, most) = asked(&send(&mut session, Command::OpenPage(Page::Statistics)));
    send(&mut session, StatisticsCommand::ReadAgain);
    let result = Ok(Arc::new(found(&of_values(&TEN), most)));
    assert!(send(&mut session, StatisticsCommand::Found { run, result }).is_empty());
    assert!(session.statistics().open().is_none());
    let why = Message::new("records-page-none");
    send(&mut session, StatisticsCommand::Found { run: run + 1, result: Err(why.clone()) });
    assert_eq!(session.statistics().problem, Some(why));
}

#[test]
fn figures_have_intervals_and_proof_is_by_the_lower_bound() {
    let session = page(&of_values(&TEN));
    let page = session.statistics();
    assert_eq!(page.read_text(&words()).unwrap(), "10 values");
    // R: mean(x), sd(x); Ppk = 10.5/(3 s) for the middle of the zone; its interval as in figures.
    let [mean, unit, _] = figure(&session, "Mean");
    assert_eq!([mean.as_str(), unit.as_str()], ["25.0105", "mm"]);
    assert_eq!(figure(&session, "Standard deviation")[..2], ["3.03".to_owned(), "µm".to_owned()]);
    assert_eq!(figure(&session, "Ppk overall")[0], "1.16");
    assert_eq!(figure(&session, "Pp overall")[0], "1.16");
    assert!(figure(&session, "Ppk overall")[2].starts_with("95 %: 0."), "{:?}", figure(&session, "Ppk overall"));
    assert_eq!(figure(&session, "Outside the limits")[..2], ["0".to_owned(), "of 10".to_owned()]);
    let proof = page.proof_text(&words()).unwrap();
    assert!(proof.starts_with("Ppk of 1.33 is not proven: its lower bound is 0."), "{proof}");
    let precise: Vec<String> = (0..200).map(|at| format!("25.{:04}", 100 + (at * 7) % 11)).collect();
    let precise: Vec<&str> = precise.iter().map(String::as_str).collect();
    let session = self::page(&of_values(&precise));
    let proof = session.statistics().proof_text(&words()).unwrap();
    assert!(proof.starts_with("Ppk of 1.33 is proven: its lower bound is "), "{proof}");
}

#[test]
fn what_has_no_figure_says_why_where_the_figure_would_stand() {
    let none = page(&[]);
    assert!(none.statistics().open().is_none() && !none.statistics().is_working());
    let one = page(&of_values(&["25.010"]));
    assert_eq!(figure(&one, "Mean"), ["–", "", "too few values or groups: 1, at least 2 needed"]);
    assert!(one.statistics().chart_text(&words()).starts_with("No control limits: too few values"));
    let equal = page(&of_values(&["25.010"; 5]));
    assert_eq!(figure(&equal, "Ppk overall")[2], "all values are equal: there is no spread to compute with");
    assert!(equal.statistics().proof_text(&words()).unwrap().ends_with("there is no spread to compute with."));
    let mut out: Vec<_> = of_values(&TEN);
    for (_, _, is_replaced) in &mut out {
        *is_replaced = true;
    }
    let out = page(&out);
    assert_eq!(out.statistics().read_text(&words()).unwrap(), "0 values, 10 left out: corrected or withdrawn");
    assert_eq!(figure(&out, "Mean")[2], "there are no values");
}

#[test]
fn simulated_doubtful_and_withdrawn_values_are_left_out_and_counted_and_a_correction_stands_in_place() {
    let mut entries = of_values(&TEN);
    entries[3].2 = true;
    let mut correction = check(50, "A1", "25 H7", "25.0125");
    let Content::Check(of) = &mut correction.content else { panic!() };
    of.corrects = Some(Correction { target: head(5), reason: "misread".to_owned(), by: "Bert".to_owned() });
    entries.push((50, correction, false));
    // Ten times the size is another part's value.
    entries.push((51, check(51, "A1", "25 H7", "25.900"), false));
    let session = page(&entries);
    let page = session.statistics();
    let (feature, of) = page.open().unwrap();
    assert_eq!(of.values.len(), 10);
    assert_eq!(of.left_out, [(LeftOut::Doubtful, 1), (LeftOut::Withdrawn, 1)]);
    let numbers: Vec<u64> = of.shown.iter().filter_map(|at| feature.values[*at].origin.number).collect();
    assert_eq!(numbers, [2, 3, 4, 50, 6, 7, 8, 9, 10, 11], "the correction stands where the value stood");
    assert_eq!(
        page.read_text(&words()).unwrap(),
        "10 values, 1 left out: doubtful, 1 left out: corrected or withdrawn"
    );
}

#[test]
fn only_the_newest_values_of_each_feature_count() {
    let mut entries = of_values(&TEN);
    entries.extend((20..23).map(|number| (number, check(number, "B2", "8 H7", "8.004"), false)));
    let found = found(&entries, 4);
    let counts: Vec<(String, usize)> =
        found.features.iter().map(|feature| (feature.key.name.0.clone(), feature.values.len())).collect();
    assert_eq!(counts, [("A1".to_owned(), 4), ("B2".to_owned(), 3)]);
    let first = found.features[0].values[0].measured;
    assert_eq!(first, "25.007".parse::<Length>().unwrap());
}

#[test]
fn other_limits_begin_another_series() {
    let mut entries = of_values(&TEN);
    entries.push((30, check(30, "A1", "25 H8", "25.010"), false));
    let session = page(&entries);
    let names: Vec<String> = session.statistics().features().map(|(feature, _)| feature.key.callout.clone()).collect();
    assert_eq!(names, ["25 H7", "25 H8"]);
}

#[test]
fn points_are_means_of_as_many_values_as_the_field_says() {
    let mut session = page(&of_values(&TEN));
    doing(&mut session, StatisticsCommand::UsePoints(PointsOf::Means));
    assert_eq!(session.statistics().read_text(&words()).unwrap(), "10 values, 2 groups of 5");
    assert_eq!(StatisticsAction::UsePoints(PointsOf::Means).text(&session, &words()), "Means of 5");
    let effects = typed(&mut session, StatisticsField::Size, "2");
    compute(&mut session, effects);
    assert_eq!(session.statistics().count(), 5);
    typed(&mut session, StatisticsField::Size, "1");
    assert!(session.error(StatisticsField::Size).is_some());
}

/// Twenty values of little spread and one far above them: Nelson's first rule fires at it.
fn with_signal() -> Vec<(u64, Entry, bool)> {
    let mut values: Vec<String> = (0..20).map(|at| format!("25.{:04}", 100 + (at * 7) % 5)).collect();
    values.push("25.0180".to_owned());
    of_values(&values.iter().map(String::as_str).collect::<Vec<_>>())
}

#[test]
fn signals_say_rule_place_part_time_and_who_and_open_the_record() {
    let mut session = page(&with_signal());
    let signals = session.statistics().signals(&words());
    let first = signals.iter().find(|signal| signal.rule == "1 point beyond a control limit").unwrap();
    assert_eq!(first.place, "Point 21: 25.018 mm, S-22, 2026-11-17 07:30, Anna");
    assert_eq!(first.point, 20);
    doing(&mut session, StatisticsCommand::SwitchRule(Rule::BeyondLimits));
    let signals = session.statistics().signals(&words());
    assert!(signals.iter().all(|signal| !signal.rule.contains("beyond a control limit")), "{signals:?}");
    doing(&mut session, StatisticsCommand::SwitchRule(Rule::BeyondLimits));
    let effects = send(&mut session, StatisticsCommand::OpenRecord(Some(20)));
    assert_eq!(session.page(), Page::Records);
    assert!(effects.contains(&Effect::ReadRecords(vec![22])), "{effects:?}");
}

#[test]
fn a_point_is_left_out_with_a_reason_that_stays_and_is_taken_in_again() {
    let mut session = page(&with_signal());
    let before = figure(&session, "Ppk overall");
    doing(&mut session, StatisticsCommand::Move(Step::Last));
    let effects = send(&mut session, StatisticsCommand::LeaveOut);
    assert!(effects.contains(&Effect::Focus(StatisticsField::Reason.into())), "{effects:?}");
    doing(&mut session, StatisticsCommand::TakeReason);
    assert!(session.statistics().asks_why, "without a reason nothing is left out");
    typed(&mut session, StatisticsField::Reason, "chip on the probe");
    doing(&mut session, StatisticsCommand::TakeReason);
    let page = session.statistics();
    assert_eq!(page.reason_of(20), Some("chip on the probe"));
    assert_eq!(page.read_text(&words()).unwrap(), "20 values, 1 left out: with a reason");
    let (_, of) = page.open().unwrap();
    assert_eq!(of.values.len(), 20);
    let chart = of.answer.chart.as_ref().unwrap();
    assert_eq!(chart.points.len(), 21, "it stays on the chart");
    assert_eq!(chart.points[20].left_out.as_deref(), Some("chip on the probe"));
    assert!(page.cursor_text(&words()).unwrap().contains("Left out: chip on the probe"));
    assert_ne!(figure(&session, "Ppk overall"), before);
    assert_eq!(StatisticsAction::LeaveOut.text(&session, &words()), "Include again");
    doing(&mut session, StatisticsCommand::LeaveOut);
    assert_eq!(figure(&session, "Ppk overall"), before);
    // All of them: the reason stands in the place of the figures.
    for point in 0..21 {
        doing(&mut session, StatisticsCommand::ChoosePoint(point));
        send(&mut session, StatisticsCommand::LeaveOut);
        typed(&mut session, StatisticsField::Reason, "trial");
        doing(&mut session, StatisticsCommand::TakeReason);
    }
    assert_eq!(figure(&session, "Mean")[2], "there are no values");
}

#[test]
fn limits_come_from_the_chosen_points_and_later_points_do_not_move_them() {
    let mut session = page(&with_signal());
    let limits = |session: &Session| {
        let (_, of) = session.statistics().open().unwrap();
        of.answer.chart.as_ref().unwrap().stages[0].clone()
    };
    doing(&mut session, StatisticsCommand::ChoosePoint(9));
    doing(&mut session, StatisticsCommand::Freeze);
    let frozen = limits(&session);
    assert_eq!(frozen.baseline, 10);
    let mut more = with_signal();
    more.push((40, check(40, "A1", "25 H7", "25.0020"), false));
    let (run, _, most) = asked(&send(&mut session, StatisticsCommand::ReadAgain));
    doing(&mut session, StatisticsCommand::Found { run, result: Ok(Arc::new(found(&more, most))) });
    let (mean, sigma) = (limits(&session).mean.to_bits(), limits(&session).sigma.value.to_bits());
    assert_eq!((mean, sigma), (frozen.mean.to_bits(), frozen.sigma.value.to_bits()));
    // Where its first value is not in sight any more there are no limits, and that is said.
    let (run, _, _) = asked(&send(&mut session, StatisticsCommand::ReadAgain));
    doing(&mut session, StatisticsCommand::Found { run, result: Ok(Arc::new(found(&more, 15))) });
    let said = session.statistics().chart_text(&words());
    assert!(said.starts_with("No control limits: the baseline is not within its stage"), "{said}");
    doing(&mut session, StatisticsCommand::Freeze);
    assert!(!session.statistics().is_frozen());
    assert_eq!(limits(&session).baseline, 15);
}

/// Ten values of two parts of five, and another one of a third part that is not yet complete.
fn of_parts() -> Vec<(u64, Entry, bool)> {
    let mut entries = of_values(&[&TEN[..], &["25.010"]].concat());
    for (at, (_, entry, _)) in entries.iter_mut().enumerate() {
        entry.about.serial = format!("S-{}", at / 5 + 1);
    }
    entries
}

#[test]
fn means_are_of_one_part_of_one_person_or_of_what_was_measured_without_a_pause() {
    let mut entries = of_parts();
    for (at, (_, entry, _)) in entries.iter_mut().enumerate() {
        entry.about.who = if at < 4 { "Anna" } else { "Bert" }.to_owned();
        entry.about.station = if at < 9 { "Mill 3" } else { "Mill 4" }.to_owned();
    }
    let mut session = page(&entries);
    doing(&mut session, StatisticsCommand::UsePoints(PointsOf::Means));
    for (mean_of, expected) in [
        (MeanOf::Part, "11 values, 3 groups of 1–5"),
        (MeanOf::Person, "11 values, 2 groups of 4–7"),
        (MeanOf::Station, "11 values, 2 groups of 2–9"),
        (MeanOf::Pause, "11 values, 1 group of 11"),
        (MeanOf::Count, "11 values, 3 groups of 1–5"),
    ] {
        doing(&mut session, StatisticsCommand::UseMeansOf(mean_of));
        assert_eq!(session.statistics().read_text(&words()).as_deref(), Some(expected), "{mean_of:?}");
    }
}

#[test]
fn values_that_do_not_say_their_group_are_no_chart_and_say_so() {
    let mut entries = of_parts();
    entries[3].1.about.station.clear();
    let mut session = page(&entries);
    doing(&mut session, StatisticsCommand::UsePoints(PointsOf::Means));
    doing(&mut session, StatisticsCommand::UseMeansOf(MeanOf::Station));
    let said = session.statistics().chart_text(&words());
    assert!(said.contains("values that do not say to which group they belong: 1"), "{said}");
    assert!(!session.can(StatisticsAction::SaveChart));
    assert!(said_of_look(&session).contains("of the values of one station"));
    // The figures of all values need no groups.
    assert_eq!(session.statistics().read_text(&words()).as_deref(), Some("11 values"));
    let [mean, ..] = figure(&session, "Mean");
    assert_eq!(mean, "25.0105");
}

fn said_of_look(session: &Session) -> String {
    session.statistics().told_of_look(&words()).join("\n")
}

/// The part that is being measured may get more values: it is no point of which a rule fires.
#[test]
fn a_part_is_a_point_of_an_alarm_once_the_next_one_begins() {
    let quiet = ["25.010", "25.011", "25.009", "25.010"];
    let mut values: Vec<&str> = quiet.iter().cycle().take(40).copied().collect();
    values.extend(["25.018", "25.018"]);
    let mut entries = of_values(&values);
    for (at, (_, entry, _)) in entries.iter_mut().enumerate() {
        entry.about.serial = format!("S-{}", at / 2 + 1);
    }
    let look = Look { grouping: Grouping::By(Factor::Part), ..Look::default() };
    let alarms = |entries: &[(u64, Entry, bool)]| {
        let found = found(entries, 125);
        let newest = entries.last().map(|(number, ..)| *number).unwrap();
        found.features[0].alarms(&look, newest, &[]).unwrap()
    };
    let beyond = |alarms: &[FiredAlarm]| alarms.iter().any(|(_, alarm)| alarm.rule == Rule::BeyondLimits);
    assert!(!beyond(&alarms(&entries)), "part 21 may get more values");
    let next = of_values(&[&values[..], &["25.010"]].concat()).pop().unwrap();
    entries.push(next);
    let found = alarms(&entries);
    assert!(beyond(&found), "{found:?}");
    let (serial, alarm) = found.iter().find(|(_, alarm)| alarm.rule == Rule::BeyondLimits).unwrap();
    assert_eq!((alarm.first, alarm.last, alarm.since.as_str()), (42, 43, "S-21"));
    assert_eq!(serial, "S-21", "the alarm is of the part that fired it, not of the one that ended it");
}

#[test]
fn a_stage_begins_at_the_cursor_with_limits_of_its_own_and_ends_again() {
    let shifted = ["25.016", "25.017", "25.015", "25.016", "25.017", "25.015", "25.016", "25.017"];
    let mut session = page(&of_values(&[&TEN[..], &shifted].concat()));
    let before = session.statistics().chart_text(&words());
    send(&mut session, StatisticsCommand::ChoosePoint(0));
    assert!(!session.can(StatisticsAction::Stage), "the chart begins there");
    send(&mut session, StatisticsCommand::ChoosePoint(10));
    doing(&mut session, StatisticsCommand::Stage);
    let said = session.statistics().chart_text(&words());
    // The mean of the eight shifted values: 129 / 8 µm above the nominal size.
    assert!(said.contains("centre line 25.0161 mm"), "{said}");
    let [mean, ..] = figure(&session, "Mean");
    assert_eq!(mean, "25.0161", "the process as it is now");
    let [_, of, _] = figure(&session, "Outside the limits");
    assert_eq!(of, "of 8", "figures and counts are of the same values");
    assert_eq!(session.statistics().read_text(&words()).as_deref(), Some("18 values"));
    assert!(
        said_of_look(&session).contains("Points at which a stage begins: 11. The figures are those of the last stage.")
    );
    doing(&mut session, StatisticsCommand::Stage);
    assert_eq!(session.statistics().chart_text(&words()), before);
}

fn stages(session: &Session) -> Vec<(usize, usize)> {
    let (_, of) = session.statistics().open().unwrap();
    let stages = &of.answer.chart.as_ref().unwrap().stages;
    stages.iter().map(|stage| (stage.points.start, stage.baseline)).collect()
}

#[test]
fn a_stage_waits_until_it_has_limits_of_its_own() {
    let mut session = page(&of_values(&TEN));
    send(&mut session, StatisticsCommand::ChoosePoint(9));
    doing(&mut session, StatisticsCommand::Stage);
    assert_eq!(stages(&session), [(0, 10)], "one value has no limits");
    assert!(said_of_look(&session).contains("do not count so far: 1"), "{}", said_of_look(&session));
    assert_eq!(session.statistics().stage(), Some(true));
    let (run, _, most) = asked(&send(&mut session, StatisticsCommand::ReadAgain));
    let more = of_values(&[&TEN[..], &["25.012", "25.013"]].concat());
    doing(&mut session, StatisticsCommand::Found { run, result: Ok(Arc::new(found(&more, most))) });
    assert_eq!(stages(&session), [(0, 9), (9, 3)]);
}

#[test]
fn limits_are_frozen_within_the_stage_of_the_cursor() {
    let mut session = page(&of_values(&[TEN, TEN].concat()));
    send(&mut session, StatisticsCommand::ChoosePoint(10));
    doing(&mut session, StatisticsCommand::Stage);
    send(&mut session, StatisticsCommand::ChoosePoint(14));
    doing(&mut session, StatisticsCommand::Freeze);
    assert_eq!(stages(&session), [(0, 10), (10, 5)]);
    assert!(said_of_look(&session).contains("The control limits are those of points 11 to 15."));
    // A stage that begins among these points takes those that are its own.
    send(&mut session, StatisticsCommand::ChoosePoint(13));
    doing(&mut session, StatisticsCommand::Stage);
    assert_eq!(stages(&session), [(0, 10), (10, 3), (13, 7)]);
}

#[test]
fn a_stage_stays_when_its_first_value_is_withdrawn_and_no_group_goes_on_into_it() {
    let mut entries = of_values(&[TEN, TEN].concat());
    let mut session = page(&entries);
    send(&mut session, StatisticsCommand::ChoosePoint(12));
    doing(&mut session, StatisticsCommand::Stage);
    entries[12].2 = true;
    let (run, _, most) = asked(&send(&mut session, StatisticsCommand::ReadAgain));
    doing(&mut session, StatisticsCommand::Found { run, result: Ok(Arc::new(found(&entries, most))) });
    assert_eq!(stages(&session), [(0, 12), (12, 7)]);
    doing(&mut session, StatisticsCommand::UsePoints(PointsOf::Means));
    let (_, of) = session.statistics().open().unwrap();
    let sizes: Vec<usize> = of.points.iter().map(ExactSizeIterator::len).collect();
    assert_eq!(sizes, [5, 5, 2, 5, 2]);
    send(&mut session, StatisticsCommand::ChoosePoint(3));
    assert_eq!(session.statistics().stage(), Some(true));
    doing(&mut session, StatisticsCommand::Stage);
    assert_eq!(session.statistics().open().unwrap().1.stages, []);
}

#[test]
fn a_point_that_other_values_make_is_not_the_one_that_was_chosen() {
    let mut session = page(&of_values(&[TEN, TEN].concat()));
    doing(&mut session, StatisticsCommand::UsePoints(PointsOf::Means));
    send(&mut session, StatisticsCommand::ChoosePoint(2));
    send(&mut session, StatisticsCommand::LeaveOut);
    let effects = typed(&mut session, StatisticsField::Size, "4");
    compute(&mut session, effects);
    assert!(session.statistics().cursor.is_none() && !session.statistics().asks_why);
    typed(&mut session, StatisticsField::Size, "99");
    assert!(session.error(StatisticsField::Size).is_some());
    doing(&mut session, StatisticsCommand::UsePoints(PointsOf::Single));
    assert!(session.error(StatisticsField::Size).is_none(), "nobody could correct it");
}

/// A process that moved by one standard deviation: Shewhart's limits do not see it, the sums do.
#[test]
fn charts_that_remember_stand_below_the_chart_and_say_since_when() {
    let steady = ["25.010", "25.012", "25.009", "25.011", "25.008", "25.012", "25.010", "25.008"];
    let moved = ["25.013", "25.014", "25.013", "25.014", "25.013", "25.014", "25.013", "25.014"];
    let mut session = page(&of_values(&[&steady[..], &steady, &moved].concat()));
    send(&mut session, StatisticsCommand::ChoosePoint(15));
    doing(&mut session, StatisticsCommand::Freeze);
    for (below, figure) in [(Below::Ewma, "weighted average 25."), (Below::Cusum, "sum above the mean ")] {
        doing(&mut session, StatisticsCommand::ShowBelow(below));
        let said = session.statistics().aside_said(Aside::Spread, &words());
        assert!(said.starts_with(figure), "{said}");
        let advice = session.statistics().advice(&words()).join("\n");
        assert!(advice.contains("the mean has moved"), "{advice}");
        let (_, of) = session.statistics().open().unwrap();
        let drawn = of.drawn(Drawn::Memory, [600.0, 240.0], 0..24, &words()).unwrap();
        assert!(drawn.spots.len() == 24 && drawn.marks.iter().any(|mark| matches!(mark, Mark::Ring { .. })));
    }
    doing(&mut session, StatisticsCommand::ShowBelow(Below::Spread));
    assert!(session.statistics().aside_said(Aside::Spread, &words()).starts_with("mean spread"));
}

#[test]
fn the_charts_are_saved_as_a_drawing_or_a_picture() {
    let mut session = page(&of_values(&TEN));
    doing(&mut session, StatisticsCommand::ShowBelow(Below::Ewma));
    let mut written = |path: &str| {
        send(&mut session, Command::OpenDialog(Purpose::SaveChart));
        send(&mut session, Command::TypePath(path.to_owned()));
        let effects = send(&mut session, Command::Confirm);
        let bytes = effects.iter().find_map(|effect| match effect {
            Effect::ForDialog(_, effect) => match effect.as_ref() {
                Effect::Save(_, content) => Some(content.bytes().unwrap()),
                _ => None,
            },
            _ => None,
        });
        let problem = session.dialog().and_then(|dialog| dialog.problem.as_ref()).map(ToString::to_string);
        send(&mut session, Command::Close);
        (bytes, problem)
    };
    let (svg, _) = written("/charts/a1.svg");
    let svg = String::from_utf8(svg.unwrap()).unwrap();
    assert!(svg.starts_with("<svg") && svg.contains("Weighted averages (EWMA)"), "{svg}");
    assert!(written("/charts/a1.PNG").0.unwrap().starts_with(b"\x89PNG"));
    let (none, problem) = written("/charts/a1.pdf");
    assert_eq!((none, problem.as_deref()), (None, Some("The name of the file must end in .svg or .png.")));
}

#[test]
fn points_are_walked_and_the_window_follows() {
    let mut session = page(&with_signal());
    doing(&mut session, StatisticsCommand::Move(Step::Last));
    assert_eq!(session.statistics().cursor, Some(20));
    doing(&mut session, StatisticsCommand::Zoom(Zooming::In));
    assert_eq!(session.statistics().window(), 11..21, "ten points are shown at least");
    doing(&mut session, StatisticsCommand::Move(Step::First));
    assert_eq!(session.statistics().window(), 0..10);
    doing(&mut session, StatisticsCommand::Move(Step::PageDown));
    assert_eq!(session.statistics().window(), 1..11);
    doing(&mut session, StatisticsCommand::Zoom(Zooming::Out));
    assert_eq!(session.statistics().window().len(), 20);
    doing(&mut session, StatisticsCommand::Zoom(Zooming::Whole));
    assert_eq!(session.statistics().window(), 0..21);
    doing(&mut session, StatisticsCommand::See(5..18));
    assert_eq!(session.statistics().window(), 5..18);
}

#[test]
fn the_chart_is_one_sentence_with_its_figures_and_all_of_it_is_copied() {
    let mut session = page(&with_signal());
    let said = session.statistics().chart_text(&words());
    assert!(said.starts_with("21 points, centre line 25.01"), "{said}");
    assert!(said.contains("limits 25.000 mm … 25.021 mm") && said.ends_with("0 outside the limits."), "{said}");
    let effects = send(&mut session, StatisticsCommand::Copy);
    let [Effect::Copy(text)] = effects.as_slice() else { panic!("{effects:?}") };
    assert!(text.starts_with("Flange, A1, 25 H7\n21 values\nMean\t25.01"), "{text}");
    assert!(text.contains("\t1 point beyond a control limit\tPoint 21: 25.018 mm, S-22"), "{text}");
}

/// The report of what the page shows, as Markdown.
fn reported(session: &mut Session) -> (u64, String) {
    let effects = send(session, ReportsCommand::OfStatistics);
    assert_eq!((session.page(), session.report_of()), (Page::Reports, Some(ReportOf::Statistics)));
    let drawn = effects.into_iter().find_map(|effect| match effect {
        Effect::DrawReport { run, content } => Some((run, *content)),
        _ => None,
    });
    let Some((run, Written::Report { report, words, .. })) = drawn else { panic!("no pages are drawn") };
    let mut out = Vec::new();
    let markdown = rendering_for(Path::new("x.md")).unwrap();
    (markdown.render)(&report, &words, &mut out).unwrap();
    (run, String::from_utf8(out).unwrap())
}

#[test]
fn what_the_page_shows_is_reported_with_what_was_left_out_and_where_the_limits_come_from() {
    let mut session = page(&with_signal());
    doing(&mut session, StatisticsCommand::ChoosePoint(9));
    doing(&mut session, StatisticsCommand::Freeze);
    doing(&mut session, StatisticsCommand::Move(Step::Last));
    send(&mut session, StatisticsCommand::LeaveOut);
    typed(&mut session, StatisticsField::Reason, "chip on the probe");
    doing(&mut session, StatisticsCommand::TakeReason);
    let [ppk, _, interval] = figure(&session, "Ppk overall");
    let (_, said) = reported(&mut session);
    assert!(said.contains("20 values, 1 left out: with a reason"), "{said}");
    assert!(said.contains("Point 21: Left out: chip on the probe"), "{said}");
    assert!(said.contains("The control limits are those of points 1 to 10."), "{said}");
    assert!(said.contains(&format!("**Ppk overall**: {ppk} ({interval})")), "{said}");
}

#[test]
fn a_report_says_which_question_it_answers_and_waits_for_the_answer() {
    let mut session = page(&with_signal());
    let (run, _, most) = asked(&typed(&mut session, StatisticsField::Question, "part:Flange"));
    assert!(!session.can_report(ReportOf::Statistics), "what is shown answers another question");
    let mut answer = found(&with_signal(), most);
    (answer.unread, answer.has_more) = (2, true);
    doing(&mut session, StatisticsCommand::Found { run, result: Ok(Arc::new(answer)) });
    let (_, said) = reported(&mut session);
    for line in
        ["Flange", "Records asked for: part:Flange", "Older ones are not included.", "2 records cannot be read."]
    {
        assert!(said.contains(line), "{line}: {said}");
    }
}

#[test]
fn a_template_without_statistics_is_refused_for_them_and_says_which_one_to_take() {
    let mut session = page(&with_signal());
    let (run, _) = reported(&mut session);
    send(&mut session, ReportsCommand::Template("report-template-list".to_owned()));
    // The pages of the first template come late.
    send(&mut session, ReportsCommand::Drawn { run, result: Err(Message::new("reports-page-stopped")) });
    let why = session.reports().pages().unwrap().unwrap_err().to_string();
    assert_eq!(why, "This template shows no statistics: choose the template Statistics");
}

#[test]
fn a_format_without_statistics_is_refused_for_them_and_says_which_ones_there_are() {
    let mut session = page(&with_signal());
    reported(&mut session);
    for (number, rendering) in RENDERINGS.iter().enumerate().filter(|(_, rendering)| rendering.holds != Holds::Label) {
        send(&mut session, Command::OpenDialog(Purpose::Report(number)));
        send(&mut session, Command::TypePath(format!("/reports/bores.{}", rendering.endings[0])));
        let is_written =
            send(&mut session, Command::Confirm).iter().any(|effect| matches!(effect, Effect::ForDialog(..)));
        assert_eq!(is_written, ["html", "markdown", "pdf"].contains(&rendering.name), "{}", rendering.name);
        send(&mut session, Command::Close);
    }
}
