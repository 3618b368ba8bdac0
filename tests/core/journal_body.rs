//! Entries of a journal as bytes: what is written reads back as the same, what is no entry is refused with its field, and the
//! golden bodies in `tests/data/journal` never change.

use std::path::Path;
use std::sync::Arc;

use fitcheck::budget::{BudgetWarning, Provenance, Validity};
use fitcheck::journal::body::{self, BodyError, read, write};
use fitcheck::journal::chain::{ChainId, Hash, Head, entry_hash};
use fitcheck::journal::entry::{
    About, Begin, BlockKept, Check, CheckRemark, Checked, Compared, Content, Correction, CycleCheck, CycleOrigin,
    DatumKept, Entry, FileRole, Moment, Reported, Shown, UsedFile,
};
use fitcheck::journal::ranges::EntryRanges;
use fitcheck::journal::{Alarm, AlarmAnswer, Record};
use fitcheck::length::Length;
use fitcheck::probing::{Circle, Contact, Measurement, Origin, measure_contacts};
use fitcheck::statistics::{Place, Rule as ChartRule};
use fitcheck::tolerance::fit::thermal::{self, Warm};
use fitcheck::tolerance::{Base, Callout, Feature, Limits, Source, Sources};
use fitcheck::verdict::rules::{Prover, RuleInputs, RuleName, Uncertainty};
use fitcheck::verdict::{AxisPosition, Doubt, PositionVerdict, Rule, Status};
use jiff::civil::date;
use proptest::prelude::*;
use proptest::sample::select;

fn mm(text: &str) -> Length {
    text.parse().unwrap()
}

fn nm(nm: i64) -> Length {
    Length::from_nanometres(nm).unwrap()
}

pub fn about() -> About {
    About {
        station: "Mill 3".to_owned(),
        time: Moment { utc_ms: 1_795_435_200_123, offset_min: 60, zone: "Europe/Amsterdam".to_owned() },
        who: "Anna".to_owned(),
        part: "Flange".to_owned(),
        serial: "17-0042".to_owned(),
        feature: "B1".to_owned(),
        remark: "after the second cut, Ø \"fine\"".to_owned(),
    }
}

/// A typed bore of 25 H7.
pub fn bore(measured: &str) -> Record {
    let callout: Callout = "25 H7".parse().unwrap();
    let limits = Sources::default().limits(&callout, None).unwrap();
    let measurement = Measurement::of_diameter(mm(measured), Origin::Typed);
    Record::judged(date(2026, 11, 23).at(13, 0, 0, 0), "B1".to_owned(), Some(callout), limits, measurement, None)
}

fn of_record(record: Record) -> Entry {
    let check = Check { what: Checked::Size(Arc::new(record)), files: Vec::new(), corrects: None };
    Entry { about: about(), content: Content::Check(Box::new(check)) }
}

fn written(entry: &Entry) -> String {
    String::from_utf8(write(entry).unwrap()).unwrap()
}

#[track_caller]
fn refused(body: &str) -> BodyError {
    read(body.as_bytes()).unwrap_err()
}

// ---- whatever a record holds ----

const NAMES: [&str; 6] = ["", "B1", "Ø 25 \"left\" \\ right", "\u{202e}evil", "名前", "'; DROP TABLE entry; --"];

fn any_name() -> impl Strategy<Value = String> {
    prop_oneof![select(NAMES.as_slice()).prop_map(str::to_owned), "\\PC{0,12}"]
}

fn any_length(most: i64) -> impl Strategy<Value = Length> {
    (-most..=most).prop_map(nm)
}

fn any_about() -> impl Strategy<Value = About> {
    let time = (-377_705_023_201_000..253_402_207_200_999_i64, -1559..1559_i32, any_name());
    let time = time.prop_map(|(utc_ms, offset_min, zone)| Moment { utc_ms, offset_min, zone });
    let texts = (any_name(), any_name(), any_name(), any_name(), any_name(), any_name());
    (time, texts).prop_map(|(time, (station, who, part, serial, feature, remark))| About {
        station,
        time,
        who,
        part,
        serial,
        feature,
        remark,
    })
}

/// Callouts with limits from the standard, the control's tables, the callout itself and a file.
fn any_limits() -> impl Strategy<Value = (Option<Callout>, Limits)> {
    let callouts =
        ["25 H7", "25 h6", "8 JS5", "20 EF7", "600 h4", "10m", "12 ±0.02", "12.01/11.985", "0.5 +0.01 -0.015"];
    let of_sources = (select(callouts.to_vec()), select([Feature::Hole, Feature::Shaft].as_slice()), any::<bool>());
    let of_sources = of_sources.prop_map(|(text, feature, control)| {
        let callout: Callout = text.parse().unwrap();
        let control = control && ["25 H7", "25 h6"].contains(&text);
        let base = if control { Base::ControlTables } else { Base::Iso286 };
        let sources = Sources::default().with_base(base, fitcheck::control::shipped_tables);
        (Some(callout), sources.limits(&callout, callout.feature().or(Some(feature))).unwrap())
    });
    let of_file = Just(()).prop_map(|()| {
        let limits = bore("25").limits;
        let source = Source::File("log.txt".into());
        (None, Limits::new(limits.feature, limits.nominal, limits.deviations, source).unwrap())
    });
    prop_oneof![6 => of_sources, 1 => of_file]
}

fn any_contacts() -> impl Strategy<Value = Vec<Contact>> {
    let noise = || prop_oneof![-0.01..0.01_f64, Just(0.0), Just(-0.0), Just(1e-17), Just(1.0 / 3.0 * 1e-3)];
    proptest::collection::vec((noise(), noise(), -50.0..50.0_f64), 3..8).prop_map(|noise| {
        let count = f64::from(u32::try_from(noise.len()).unwrap());
        let places = (0_u32..).zip(noise).map(|(number, (dx, dy, z))| {
            let angle = f64::from(number) / count * std::f64::consts::TAU;
            Contact { x: 12.5 * angle.cos() + dx, y: 12.5 * angle.sin() + dy, z }
        });
        places.collect()
    })
}

fn any_measurement() -> impl Strategy<Value = Measurement> {
    let origin = prop_oneof![
        Just(Origin::Typed),
        (any::<u16>(), any::<u64>()).prop_map(|(cycle, seed)| Origin::Simulated { cycle, seed }),
        Just(Origin::Contacts { file: "contacts.csv".into() }),
        Just(Origin::Imported { file: "log.txt".into() }),
        Just(Origin::ImportedSimulation { file: "lot 2.csv".into() }),
    ];
    let plain = (1..1_000_000_000_i64).prop_map(|size| Measurement::of_diameter(nm(size), Origin::Typed));
    let near = (-40_000..40_000_i64).prop_map(|off| Measurement::of_diameter(nm(25_000_000 + off), Origin::Typed));
    let round = any_contacts().prop_map(|contacts| measure_contacts(&contacts, Origin::Typed).unwrap());
    let centred = (any_length(1_000_000), any_length(1_000_000)).prop_map(|(x, y)| Measurement {
        centre: Some([x, y]),
        ..Measurement::of_diameter(mm("25.01"), Origin::Typed)
    });
    let any = prop_oneof![1 => plain, 3 => near, 2 => round, 1 => centred];
    (any, origin).prop_map(|(measurement, origin)| Measurement { origin, ..measurement })
}

fn any_rule() -> impl Strategy<Value = Rule> {
    let uncertainty =
        (1..5_000_000_i64, 1_000..10_000_u32).prop_map(|(pm, k)| Uncertainty::of_picometres(pm, k).unwrap());
    let given = (
        proptest::option::weighted(0.8, uncertainty),
        proptest::option::of(0..5_000_u32),
        proptest::option::of(any_length(20_000)),
        select([Prover::Supplier, Prover::Customer].as_slice()),
    );
    (select(RuleName::ALL.as_slice()), given).prop_map(|(name, (uncertainty, factor, width, prover))| {
        let factor = factor.filter(|_| name.takes_factor());
        let width = width.filter(|_| name.takes_width());
        let prover = if name.takes_prover() { prover } else { Prover::Supplier };
        Rule::new(name, RuleInputs { uncertainty, factor, width, prover }).unwrap_or(Rule::SIMPLE)
    })
}

fn any_budget() -> impl Strategy<Value = Provenance> {
    let day = || (2020..2030_i16, 1..12_i8, 1..28_i8).prop_map(|(year, month, day)| date(year, month, day));
    let validity = select([Validity::Valid, Validity::Expired, Validity::NotYet].as_slice());
    (any_name(), any_name(), day(), day(), validity, any::<bool>(), any::<bool>()).prop_map(
        |(name, by, date, valid_until, validity, counts_contacts, is_off)| {
            let mut warnings = match validity {
                Validity::Valid => Vec::new(),
                Validity::Expired => vec![BudgetWarning::Expired { until: valid_until.to_string() }],
                Validity::NotYet => vec![BudgetWarning::NotYet { date: date.to_string() }],
            };
            if is_off {
                warnings.push(BudgetWarning::FewReadings { readings: 5, fewest: 20 });
            }
            Provenance { name, date, by, valid_until, counts_contacts, validity, warnings }
        },
    )
}

fn any_correction() -> impl Strategy<Value = (Warm, Option<Warm>)> {
    let warm = || {
        (-20_000..500_000_i32, -273_150..1_000_000_i32).prop_map(|(expansion, temperature)| Warm {
            expansion: thermal::Expansion::from_thousandths(expansion).unwrap(),
            temperature: thermal::Temperature::from_thousandths(temperature).unwrap(),
        })
    };
    (warm(), proptest::option::of(warm()))
}

fn any_position() -> impl Strategy<Value = PositionVerdict> {
    let axis = || {
        (any_length(200_000), proptest::option::of((0..200_000_i64).prop_map(nm)))
            .prop_map(|(deviation, tolerance)| AxisPosition { deviation, tolerance })
    };
    (axis(), axis()).prop_map(|(one, other)| PositionVerdict { axes: [one, other] })
}

fn any_record() -> impl Strategy<Value = Record> {
    let time = (0..2_000_000_i64).prop_map(|minutes| {
        date(2026, 1, 1).at(0, 0, 7, 0).checked_add(jiff::SignedDuration::from_mins(minutes)).unwrap()
    });
    let beside = (
        proptest::option::of(any_position()),
        proptest::option::of(any_correction()),
        proptest::option::of(any_budget()),
    );
    ((time, any_name()), any_limits(), any_measurement(), any_rule(), beside).prop_map(
        |((time, id), (callout, limits), measurement, rule, (position, correction, budget))| {
            let measured = measurement.diameter;
            let record = Record::judged(time, id, callout, limits, measurement, position);
            let record = match correction {
                Some((part, scale)) => record.corrected(thermal::Correction::new(measured, part, scale)),
                None => record,
            };
            match budget {
                Some(budget) => record.by_budget(rule, Arc::new(budget)),
                None => record.by(rule),
            }
        },
    )
}

fn any_cycle() -> impl Strategy<Value = CycleCheck> {
    let origin = prop_oneof![
        Just(CycleOrigin::Perfect),
        (any_name(), any::<u64>()).prop_map(|(file, seed)| CycleOrigin::Workpiece { file: file.into(), seed }),
        any_name().prop_map(|file| CycleOrigin::Contacts { file: file.into() }),
    ];
    let figure = || (any_name(), any_length(1_000_000_000));
    let compared = (any_name(), any_length(99), any_length(99), any_length(99), select(Status::ALL.as_slice()));
    let compared = compared.prop_map(|(what, measured, minimum, maximum, status)| Compared {
        what,
        measured,
        minimum,
        maximum,
        status,
    });
    let lists = (
        proptest::collection::vec((any_name(), any_name()), 0..4),
        proptest::collection::btree_map(any_name(), figure().prop_map(|(_, length)| length), 0..4),
        proptest::collection::vec(compared, 0..3),
    );
    let answer = (
        proptest::option::of((0..100_i64, 0..100_i64).prop_map(|(one, more)| [nm(one), nm(one + more)])),
        proptest::option::of(any_length(1_000)),
        proptest::option::of(select(Status::ALL.as_slice())),
        proptest::option::of((any_name(), 0..100_000_u64)),
        proptest::option::of(any_datum()),
    );
    ((any::<u16>(), origin, any_contacts()), lists, answer).prop_map(
        |((cycle, origin, contacts), (parameters, figures, compared), (limits, measured, status, block, datum))| {
            CycleCheck {
                cycle,
                parameters,
                origin,
                contacts,
                figures,
                compared,
                limits,
                measured,
                status,
                block,
                datum,
            }
        },
    )
}

fn any_datum() -> impl Strategy<Value = DatumKept> {
    let block = || (0..100_000_u64, any_name()).prop_map(|(line, text)| BlockKept { line, text });
    let angle = || -360.0..360.0_f64;
    let rotation = proptest::option::of((angle(), block()));
    let tilt = proptest::option::of(([angle(), angle(), angle()], block()));
    let zero = [any_length(999), any_length(999), any_length(999)];
    (zero, proptest::option::of(block()), rotation, tilt).prop_map(|(zero, set_by, rotation, tilt)| DatumKept {
        zero,
        set_by,
        rotation,
        tilt,
    })
}

fn any_head() -> impl Strategy<Value = Head> {
    (1..1_u64 << 53, any::<[u8; 32]>()).prop_map(|(number, hash)| Head { number, hash: Hash(hash) })
}

fn any_report() -> impl Strategy<Value = Reported> {
    let name = || "[a-zé ]{0,9}x(\\.html)?";
    let checks = proptest::collection::vec(2..1_u64 << 53, 0..9).prop_map(EntryRanges::of);
    let shown = (checks, 0..1_u64 << 53, any::<[u8; 32]>(), any::<bool>());
    let shown = shown.prop_map(|(checks, unrecorded, hash, is_head)| {
        let number = checks.last().or(is_head.then_some(7));
        Shown { checks, unrecorded, head: number.map(|number| Head { number, hash: Hash(hash) }) }
    });
    (name(), name(), any::<[u8; 32]>(), 0..1_u64 << 53, any_name(), shown).prop_map(
        |(name, format, sha256, bytes, title, shown)| Reported {
            name,
            format,
            sha256: Hash(sha256),
            bytes,
            title,
            shown,
        },
    )
}

fn any_content() -> impl Strategy<Value = Content> {
    let correction = || {
        (any_head(), "[a-zé ]{0,9}x").prop_map(|(target, reason)| Correction {
            target,
            by: reason.chars().rev().collect(),
            reason,
        })
    };
    let begin = (any::<[u8; 16]>(), any_name(), proptest::option::of((any::<[u8; 16]>(), any_head())));
    let begin = begin.prop_map(|(chain, program, after)| Begin {
        chain: ChainId(chain),
        program,
        after: after.map(|(chain, head)| (ChainId(chain), head)),
    });
    let what = prop_oneof![
        3 => any_record().prop_map(|record| Checked::Size(Arc::new(record))),
        1 => any_cycle().prop_map(|cycle| Checked::Cycle(Box::new(cycle))),
    ];
    let file = (select(FileRole::ALL.as_slice()), any_name(), any::<[u8; 32]>());
    let file = file.prop_map(|(role, name, sha256)| UsedFile { role, name: name.into(), sha256: Hash(sha256) });
    let check = (what, proptest::collection::vec(file, 0..3), proptest::option::of(correction()));
    let check = check.prop_map(|(what, files, corrects)| Check { what, files, corrects });
    prop_oneof![
        1 => begin.prop_map(Content::Begin),
        1 => correction().prop_map(Content::Withdrawal),
        1 => any_report().prop_map(Content::Report),
        1 => any_alarm().prop_map(|alarm| Content::Alarm(Box::new(alarm))),
        8 => check.prop_map(|check| Content::Check(Box::new(check))),
    ]
}

fn any_alarm() -> impl Strategy<Value = Alarm> {
    let values =
        (select(ChartRule::ALL.as_slice()), select(Place::ALL.as_slice()), 2..1_000_u64, 0..100_u64, any_name());
    let answer = (1..100_u64, any::<[u8; 32]>(), "[a-zé]{1,9}", "[a-zé ]{1,9}x");
    (values, proptest::option::of(answer)).prop_map(|((rule, place, first, more, since), answer)| {
        let last = first + more;
        let answer = answer.map(|(after, hash, cause, action)| {
            let target = Head { number: last + after, hash: Hash(hash) };
            AlarmAnswer { target, cause, action }
        });
        Alarm { rule, place, first, last, since, answer }
    })
}

/// The same entry with the warnings of its budget as texts, as far as nothing else is kept of them.
fn as_kept(mut entry: Entry) -> Entry {
    if let Content::Check(check) = &mut entry.content
        && let Checked::Size(record) = &mut check.what
    {
        let record = Arc::make_mut(record);
        if let Some(budget) = &mut record.budget {
            for warning in &mut Arc::make_mut(budget).warnings {
                if !warning.is_about_validity() {
                    *warning = BudgetWarning::Recorded { text: warning.to_string() };
                }
            }
        }
        // Where the file of the limits is not the file of the value, the text remains.
        if let Source::File(_) = &record.limits.source
            && !matches!(&record.measurement.origin, Origin::Imported { file } if &**file == "log.txt")
        {
            let text = record.limits.source.with_difference().into();
            record.limits.source = Source::Recorded { text, range: None };
        }
    }
    entry
}

/// Every number of a body is whole and exact wherever JSON is read.
fn has_whole_numbers(value: &serde_json::Value) -> bool {
    match value {
        serde_json::Value::Number(number) => number.as_i64().is_some_and(|number| number.unsigned_abs() <= 1 << 53),
        serde_json::Value::Array(list) => list.iter().all(has_whole_numbers),
        serde_json::Value::Object(object) => object.values().all(has_whole_numbers),
        _ => true,
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 1_000, ..ProptestConfig::default() })]

    #[test]
    fn what_is_written_reads_back_as_the_same(about in any_about(), content in any_content()) {
        let entry = Entry { about, content };
        let bytes = write(&entry).unwrap();
        let found = read(&bytes).unwrap();
        prop_assert_eq!(&found, &as_kept(entry));
        prop_assert_eq!(write(&found).unwrap(), &bytes[..]);
        let json: serde_json::Value = serde_json::from_slice(&bytes).unwrap();
        prop_assert!(has_whole_numbers(&json), "{}", json);
        let is_plain = |record: &Record| {
            record.limits.feature.is_some() && record.callout.is_none_or(|callout| callout.notes().is_empty())
        };
        let version = match &found.content {
            Content::Report(_) => '2',
            Content::Alarm(_) => '6',
            Content::Check(check) if matches!(&check.what, Checked::Cycle(cycle) if cycle.datum.is_some()) => {
                let Checked::Cycle(cycle) = &check.what else { unreachable!() };
                let DatumKept { set_by, rotation, tilt, .. } = cycle.datum.as_ref().unwrap();
                if set_by.is_none() || rotation.is_some() || tilt.is_some() { '5' } else { '4' }
            }
            Content::Check(check) if matches!(&check.what, Checked::Size(record) if !is_plain(record)) => '3',
            _ => '1',
        };
        let begins = format!("{{\"v\":{version},\"kind\":\"");
        prop_assert!(bytes.starts_with(begins.as_bytes()), "{}", String::from_utf8_lossy(&bytes));
        // What this version wrote, it decides the same.
        prop_assert_eq!(found.check().and_then(Check::remark), None);
    }

    #[test]
    fn changed_bytes_are_another_entry_or_refused(
        content in any_content(),
        changes in proptest::collection::vec((any::<proptest::sample::Index>(), any::<u8>()), 1..4),
    ) {
        let mut bytes = write(&Entry { about: about(), content }).unwrap();
        for (at, byte) in changes {
            let at = at.index(bytes.len());
            bytes[at] = byte;
        }
        if let Ok(found) = read(&bytes) {
            let again = write(&found).unwrap();
            prop_assert_eq!(read(&again).unwrap(), found);
        }
    }
}

// ---- texts ----

#[test]
fn a_text_with_a_control_character_is_refused_with_its_field() {
    for (text, code, place) in
        [("a\nb", "U+000A", 2), ("\0", "U+0000", 1), ("ab\u{7f}", "U+007F", 3), ("\u{85}", "U+0085", 1)]
    {
        let entry = Entry { about: About { who: text.to_owned(), ..about() }, ..of_record(bore("25.01")) };
        let wanted = BodyError::Control { field: "about.who", code: code.to_owned(), place };
        assert_eq!(write(&entry), Err(wanted));
    }
    // The same where somebody else wrote it.
    let body = written(&of_record(bore("25.01"))).replace("Anna", "An\\nna");
    assert_eq!(refused(&body), BodyError::Control { field: "about.who", code: "U+000A".to_owned(), place: 3 });
    assert_eq!(
        refused(&body).to_string(),
        "about.who has the control character U+000A as its character 3: texts of a journal are one line without control characters"
    );
}

#[test]
fn a_text_may_be_as_long_as_it_may_be_and_a_byte_longer_is_refused() {
    let with = |name: usize, remark: usize| {
        let about = About { serial: "é".repeat(name / 2), remark: "r".repeat(remark), ..about() };
        write(&Entry { about, ..of_record(bore("25.01")) })
    };
    assert!(with(1_024, 65_536).is_ok());
    assert_eq!(with(1_026, 0), Err(BodyError::TooLong { field: "about.serial", bytes: 1_026, most: 1_024 }));
    assert_eq!(with(0, 65_537), Err(BodyError::TooLong { field: "about.remark", bytes: 65_537, most: 65_536 }));
}

#[test]
fn ten_megabytes_of_text_are_refused_in_both_directions() {
    let entry = Entry { about: About { part: "x".repeat(10 << 20), ..about() }, ..of_record(bore("25.01")) };
    assert!(matches!(write(&entry), Err(BodyError::TooLong { field: "about.part", .. })));
    let body = written(&of_record(bore("25.01"))).replace("Flange", &"x".repeat(10 << 20));
    assert!(matches!(refused(&body), BodyError::TooLong { field: "about.part", .. }));
    assert!(matches!(read(&vec![b' '; body::LONGEST + 1]), Err(BodyError::TooLarge { .. })));
}

#[test]
fn a_reason_is_never_empty() {
    let withdrawal = |reason: &str| {
        let target = Head { number: 2, hash: Hash([1; 32]) };
        let content = Content::Withdrawal(Correction { target, reason: reason.to_owned(), by: "Bert".to_owned() });
        write(&Entry { about: about(), content })
    };
    assert!(withdrawal("wrong part").is_ok());
    assert_eq!(withdrawal(" \u{a0} "), Err(BodyError::Empty { field: "withdrawal.reason" }));
}

#[test]
fn a_contact_that_is_no_number_is_not_kept() {
    let mut record = bore("25.01");
    record.measurement.contacts = vec![Contact { x: f64::NAN, y: 0.0, z: 0.0 }];
    let wanted = BodyError::Value { field: "check.size.measurement.contacts_mm", given: "NaN".to_owned() };
    assert_eq!(write(&of_record(record)), Err(wanted));
}

// ---- bytes that are no entry ----

/// A body of a good bore with one text replaced by another one.
fn changed(from: &str, to: &str) -> BodyError {
    let body = written(&of_record(bore("25.01")));
    assert!(body.contains(from), "{body}");
    refused(&body.replacen(from, to, 1))
}

#[track_caller]
fn check_value(from: &str, to: &str, field: &str) {
    let found = changed(from, to);
    assert!(matches!(&found, BodyError::Value { field: at, .. } if *at == field), "{found:?}");
}

#[test]
fn numbers_out_of_range_are_refused_with_their_field() {
    check_value("\"utc_ms\":1795435200123", "\"utc_ms\":253402207201000", "about.time.utc_ms");
    check_value("\"offset_min\":60", "\"offset_min\":-1560", "about.time.offset_min");
    check_value("\"nominal_nm\":25000000", "\"nominal_nm\":1000000000000001", "check.size.limits.nominal_nm");
    check_value("\"diameter_nm\":25010000", "\"diameter_nm\":9007199254740993", "check.size.measurement.diameter_nm");
    check_value("\"u_pm\":null,\"k_thousandths\":null", "\"u_pm\":0,\"k_thousandths\":2000", "check.size.rule.u_pm");
    check_value("\"u_pm\":null,\"k_thousandths\":null", "\"u_pm\":5,\"k_thousandths\":999", "check.size.rule.u_pm");
    check_value("\"name\":\"simple\"", "\"name\":\"simplest\"", "check.size.rule.name");
    check_value("\"name\":\"simple\"", "\"name\":\"ilac-g8\"", "check.size.rule");
    check_value("\"callout\":\"25 H7\"", "\"callout\":\"25 H7 \"", "check.size.callout");
    check_value("\"local_time\":\"2026-11-23T13:00:00\"", "\"local_time\":\"2026-11-23\"", "check.size.local_time");
    for number in ["25010000.0", "2.501e7", "\"25010000\"", "-0", "1e400", "99999999999999999999", "true", "null"] {
        assert!(matches!(
            changed("\"diameter_nm\":25010000", &format!("\"diameter_nm\":{number}")),
            BodyError::Json { .. }
        ));
    }
}

#[test]
fn what_contradicts_itself_is_refused() {
    let contradiction = |from, to, field| assert_eq!(changed(from, to), BodyError::Contradiction { field });
    contradiction("\"min_nm\":25000000", "\"min_nm\":25000001", "check.size.limits.min_nm");
    contradiction("\"max_nm\":25021000", "\"max_nm\":25020999", "check.size.limits.max_nm");
    contradiction("\"upper_nm\":21000", "\"upper_nm\":-1", "check.size.limits.upper_nm");
    contradiction("\"status\":\"GOOD\"", "\"status\":\"SCRAP\"", "check.status");
    contradiction("\"simulated\":false", "\"simulated\":true", "check.simulated");
    contradiction("\"kind\":\"check\"", "\"kind\":\"begin\"", "kind");
    contradiction("\"to_limit_nm\":null", "\"to_limit_nm\":5", "check.size.verdict.to_middle_nm");
}

#[test]
fn an_unknown_field_is_an_error_in_this_version_and_a_later_version_says_that_it_is_one() {
    assert!(matches!(changed("\"who\"", "\"whom\""), BodyError::Json { .. }));
    assert!(matches!(changed("\"files\":[]", "\"files\":[],\"colour\":1"), BodyError::Json { .. }));
    assert!(matches!(changed("{\"kind\":\"typed\"}", "{\"kind\":\"typed\",\"by\":1}"), BodyError::Json { .. }));
    assert!(matches!(changed("{\"v\":1,", "{\"v\":2,\"colour\":{},"), BodyError::Json { .. }));
    assert_eq!(changed("{\"v\":1,", "{\"v\":7,\"colour\":{},"), BodyError::Newer { version: 7 });
    // An entry has one body: what version 1 can hold is of version 1.
    assert_eq!(changed("{\"v\":1,", "{\"v\":2,"), BodyError::Contradiction { field: "v" });
    assert_eq!(
        refused("{\"v\":7}").to_string(),
        "made by a newer Fitcheck: version 7 of the format, this Fitcheck reads versions up to 6"
    );
    assert_eq!(refused("{\"v\":0}"), BodyError::Value { field: "v", given: "0".to_owned() });
    for text in ["", "{}", "null", "[1]", "{\"v\":-1}", "{\"v\":1.0}", "{\"v\":1}", "{\"v\":1} x", "\u{feff}{\"v\":1}"]
    {
        assert!(matches!(refused(text), BodyError::Json { .. }), "{text}");
    }
    assert!(matches!(refused(&"[".repeat(1 << 20)), BodyError::Json { .. }));
    assert!(matches!(read(b"{\"v\":1,\"kind\":\"\xff\"}"), Err(BodyError::Json { .. })));
}

// ---- reports ----

fn report() -> Reported {
    let head = Some(Head { number: 9, hash: Hash([9; 32]) });
    let shown = Shown { checks: EntryRanges::of([2, 4, 5, 6]), unrecorded: 1, head };
    Reported {
        name: "flange.html".to_owned(),
        format: "html".to_owned(),
        sha256: Hash::of_file(b"<html>"),
        bytes: 6,
        title: "Flange 17".to_owned(),
        shown,
    }
}

fn of_report(report: Reported) -> Entry {
    Entry { about: about(), content: Content::Report(report) }
}

/// A body of a report with one text replaced by another one.
fn changed_report(from: &str, to: &str) -> BodyError {
    let body = written(&of_report(report()));
    assert!(body.contains(from), "{body}");
    refused(&body.replacen(from, to, 1))
}

#[test]
fn a_size_that_is_neither_hole_nor_shaft_is_of_the_third_version_and_its_first_entries_are_read() {
    let hole = bore("25.03");
    let mut limits = hole.limits.clone();
    limits.feature = None;
    let body = written(&of_record(hole.asked_again(None, limits)));
    assert!(body.starts_with("{\"v\":3,\"kind\":\"check\"") && body.contains("OUT OF LIMITS"), "{body}");
    let first = body.replacen("{\"v\":3", "{\"v\":1", 1);
    assert_eq!(read(first.as_bytes()).unwrap(), read(body.as_bytes()).unwrap());
    let second = body.replacen("{\"v\":3", "{\"v\":2", 1);
    assert_eq!(read(second.as_bytes()).unwrap_err(), BodyError::Contradiction { field: "v" });
}

#[test]
fn a_cycle_behind_a_datum_is_of_the_fourth_version_and_says_what_set_it() {
    let block = |line, text: &str| BlockKept { line, text: text.to_owned() };
    let datum = DatumKept {
        zero: [nm(400_000), nm(-300_000), nm(0)],
        set_by: Some(block(4, "TCH PROBE 412 DATUM ~")),
        rotation: None,
        tilt: None,
    };
    let cycle = CycleCheck {
        cycle: 421,
        parameters: Vec::new(),
        origin: CycleOrigin::Perfect,
        contacts: Vec::new(),
        figures: std::collections::BTreeMap::new(),
        compared: Vec::new(),
        limits: None,
        measured: None,
        status: Some(Status::Good),
        block: None,
        datum: Some(datum.clone()),
    };
    let of_cycle = |cycle: &CycleCheck| {
        let what = Checked::Cycle(Box::new(cycle.clone()));
        let content = Content::Check(Box::new(Check { what, files: Vec::new(), corrects: None }));
        Entry { about: about(), content }
    };
    let entry = of_cycle(&cycle);
    let body = String::from_utf8(write(&entry).unwrap()).unwrap();
    assert!(body.starts_with("{\"v\":4,\"kind\":\"check\""), "{body}");
    let kept = "\"measured_nm\":null,\"datum\":{\"zero_nm\":[400000,-300000,0],\"line\":4,\"text\":\"TCH PROBE 412 DATUM ~\"}}";
    assert!(body.contains(kept), "{body}");
    assert_eq!(read(body.as_bytes()).unwrap(), entry);
    // Where its axes are turned it is of the fifth.
    let rotation = Some((0.4, block(6, "TCH PROBE 400 BASIC ROTATION ~")));
    let tilt = Some(([0.0, 90.0, -30.5], block(9, "PLANE SPATIAL SPA+0 SPB+90 SPC-30.5")));
    let turned = DatumKept { set_by: None, rotation, tilt, ..datum };
    let entry = of_cycle(&CycleCheck { datum: Some(turned), ..cycle });
    let body = String::from_utf8(write(&entry).unwrap()).unwrap();
    assert!(body.starts_with("{\"v\":5,\"kind\":\"check\""), "{body}");
    let kept = "\"datum\":{\"zero_nm\":[400000,-300000,0],\"line\":null,\"text\":null,\
                \"rotation\":{\"degrees\":[\"0.4\"],\"line\":6,\"text\":\"TCH PROBE 400 BASIC ROTATION ~\"},\
                \"tilt\":{\"degrees\":[\"0\",\"90\",\"-30.5\"],\"line\":9,\"text\":\"PLANE SPATIAL SPA+0 SPB+90 SPC-30.5\"}}}";
    assert!(body.contains(kept), "{body}");
    assert_eq!(read(body.as_bytes()).unwrap(), entry);
    let half = body.replace("\"line\":null", "\"line\":3");
    assert!(read(half.as_bytes()).is_err());
    let short = body.replace("[\"0\",\"90\",", "[\"90\",");
    assert!(read(short.as_bytes()).is_err());
}

#[test]
fn a_report_is_of_the_second_version_and_found_by_its_file_and_title() {
    let body = written(&of_report(report()));
    assert!(body.starts_with("{\"v\":2,\"kind\":\"report\""), "{body}");
    assert!(body.contains("\"checks\":[[2,2],[4,6]],\"unrecorded\":1,\"head\":{\"number\":9,"), "{body}");
    let found = body::found(body.as_bytes()).unwrap().unwrap();
    let of_report = found.report.clone().unwrap();
    assert_eq!((&*of_report.name, of_report.sha256), ("flange.html", Hash::of_file(b"<html>")));
    assert!(["flange", "html", "17"].iter().all(|word| found.words().iter().any(|found| found == word)));
    assert_eq!((found.status, found.measured_nm, found.corrects), (None, None, None));
    let bare = Reported { title: String::new(), shown: Shown::default(), ..report() };
    let entry = Entry { about: about(), content: Content::Report(bare) };
    assert_eq!(read(&write(&entry).unwrap()).unwrap(), entry);
}

#[test]
fn what_a_report_cannot_say_is_refused_with_its_field() {
    assert_eq!(changed_report("{\"v\":2,", "{\"v\":1,"), BodyError::Contradiction { field: "v" });
    let contradiction = BodyError::Contradiction { field: "report.checks" };
    for checks in ["[[4,2]]", "[[2,4],[4,6]]", "[[4,6],[2,2]]", "[[0,1]]", "[[2,10]]"] {
        assert_eq!(changed_report("[[2,2],[4,6]]", checks), contradiction, "{checks}");
    }
    assert_eq!(changed_report("\"head\":{\"number\":9,", "\"head\":{\"number\":5,"), contradiction);
    let value = |from, to, field| {
        let found = changed_report(from, to);
        assert!(matches!(&found, BodyError::Value { field: at, .. } if *at == field), "{found:?}");
    };
    value("[[2,2]", "[[1,2]", "report.checks");
    value("flange.html", "out/flange.html", "report.name");
    value("\"bytes\":6", "\"bytes\":9007199254740993", "report.bytes");
    value("\"unrecorded\":1", "\"unrecorded\":9007199254740993", "report.unrecorded");
    value("\"sha256\":\"", "\"sha256\":\"00", "report.sha256");
    let empty = |field| BodyError::Empty { field };
    assert_eq!(changed_report("flange.html", " "), empty("report.name"));
    assert_eq!(changed_report("\"format\":\"html\"", "\"format\":\"\""), empty("report.format"));
    for text in ["[[2,2,3]]", "[2,4]", "[[2.0,2]]", "[[-2,2]]", "null"] {
        assert!(matches!(changed_report("[[2,2],[4,6]]", text), BodyError::Json { .. }), "{text}");
    }
    let long = |name: usize| write(&of_report(Reported { name: "x".repeat(name), ..report() }));
    assert!(long(1_024).is_ok());
    assert_eq!(long(1_025), Err(BodyError::TooLong { field: "report.name", bytes: 1_025, most: 1_024 }));
}

#[test]
fn a_report_has_a_thousand_ranges_and_no_more() {
    let of = |count: u64| {
        let checks = EntryRanges::of((1..=count).map(|number| 2 * number));
        let head = Some(Head { number: 2 * count, hash: Hash([9; 32]) });
        write(&of_report(Reported { shown: Shown { checks, unrecorded: 0, head }, ..report() }))
    };
    assert!(of(1_000).is_ok());
    let refused = of(1_001).unwrap_err();
    assert_eq!(refused, BodyError::TooMany { field: "report.checks", count: 1_001, most: 1_000 });
    assert_eq!(refused.to_string(), "report.checks has 1001 entries, at most 1000 are allowed");
}

// ---- what was decided stands ----

#[test]
fn another_status_than_today_is_kept_and_told() {
    let body = written(&of_record(bore("25.01")));
    let scrap =
        body.replace("\"status\":\"GOOD\"", "\"status\":\"SCRAP\"").replace("\"size\":\"GOOD\"", "\"size\":\"SCRAP\"");
    let entry = read(scrap.as_bytes()).unwrap();
    let check = entry.check().unwrap();
    assert_eq!(check.status(), Some(Status::Scrap));
    let remark = check.remark().unwrap();
    assert_eq!(remark, CheckRemark::JudgedOtherwise { kept: Status::Scrap, now: Status::Good });
    assert_eq!(remark.to_string(), "decided as SCRAP, which stands; this version of Fitcheck decides GOOD");
    assert_eq!(written(&entry), scrap);
}

#[test]
fn a_source_that_is_gone_says_what_it_said() {
    let body = written(&of_record(bore("25.01")));
    let own = "table shop.tab, over 18 up to 30 mm, instead of 0 / +21 µm in ISO 286";
    let body = body.replace("ISO 286, over 18 up to 30 mm", own);
    let entry = read(body.as_bytes()).unwrap();
    let Checked::Size(record) = &entry.check().unwrap().what else { panic!() };
    assert_eq!(record.limits.source.to_string(), own);
    assert_eq!(record.limits.source.range(), Some((mm("18"), mm("30"))));
    assert_eq!(written(&entry), body);
    // The standard's own text is the standard, so the window says it in its language.
    let live = read(written(&of_record(bore("25.01"))).as_bytes()).unwrap();
    let Checked::Size(record) = &live.check().unwrap().what else { panic!() };
    assert!(matches!(record.limits.source, Source::Standard { .. }));
}

#[test]
fn a_doubt_is_kept() {
    for (measured, doubt) in
        [("635", "times-inch"), ("0.985", "inches"), ("50", "double"), ("12.5", "half"), ("250.1", "decimal-sign")]
    {
        let record = bore(measured);
        assert!(record.doubt.is_some());
        let body = written(&of_record(record));
        assert!(body.contains(&format!("\"doubt\":{{\"kind\":\"{doubt}\"")), "{body}");
    }
    let far = Record { doubt: Some(Doubt::Far { distance: mm("3") }), ..bore("25.01") };
    let entry = of_record(far);
    assert_eq!(read(&write(&entry).unwrap()).unwrap(), entry);
}

#[test]
fn seeds_of_the_fuzzer_are_entries() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("fuzz/corpus/journal_body");
    for file in std::fs::read_dir(folder).unwrap() {
        let path = file.unwrap().path();
        let read = read(&std::fs::read(&path).unwrap());
        assert_eq!(read.is_ok(), !path.ends_with("newer.json"), "{}: {read:?}", path.display());
    }
}

// ---- golden bodies ----

fn folder() -> std::path::PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/journal")
}

/// A chain of four: its beginning, a check, a check in its place, and a report of the latter.
fn four(chain: ChainId) -> Vec<Vec<u8>> {
    let begin = Begin { chain, program: "fitcheck 0.1.0".to_owned(), after: None };
    let first = write(&Entry { about: about(), content: Content::Begin(begin) }).unwrap();
    let u = Uncertainty::standard("1.2").unwrap();
    let given = RuleInputs { uncertainty: Some(u), ..RuleInputs::default() };
    let contacts: Vec<Contact> =
        [[12.505, 0.0, -5.0], [0.1, 12.507, -5.0], [-12.503, 0.0, -5.0], [0.1, -12.5, -5.0]].map(Contact::at).to_vec();
    // Whatever the last bit of a square root is elsewhere.
    let circle = Circle { x: 0.001, y: 0.0035, diameter: 25.007_892_417_358_82 };
    let measurement = Measurement::of_circle(circle, contacts, Origin::Contacts { file: "bore.csv".into() }).unwrap();
    let bore = bore("25");
    let record = Record::judged(bore.time, bore.id, bore.callout, bore.limits, measurement, None).by(Rule::new(
        RuleName::Iso14253Of2017,
        given,
    )
    .unwrap());
    let file = UsedFile { role: FileRole::Measurements, name: "bore.csv".into(), sha256: Hash::of_file(b"x,y\n") };
    let check = Check { what: Checked::Size(Arc::new(record)), files: vec![file], corrects: None };
    let second = write(&Entry { about: about(), content: Content::Check(Box::new(check.clone())) }).unwrap();
    let before = Head { number: 1, hash: entry_hash(chain, Head::default(), &first).unwrap() };
    let target = Head { number: 2, hash: entry_hash(chain, before, &second).unwrap() };
    let corrects = Some(Correction {
        target,
        reason: "the serial number was that of the next part".to_owned(),
        by: "Bert".to_owned(),
    });
    let corrected = About { serial: "17-0043".to_owned(), ..about() };
    let content = Content::Check(Box::new(Check { corrects, ..check }));
    let third = write(&Entry { about: corrected, content }).unwrap();
    let head = Head { number: 3, hash: entry_hash(chain, target, &third).unwrap() };
    let shown = Shown { checks: EntryRanges::of([3]), unrecorded: 1, head: Some(head) };
    let fourth = write(&of_report(Reported { shown, ..report() })).unwrap();
    vec![first, second, third, fourth]
}

/// The hashes in the folder are those of `hashes.py` there, which shares no line with Fitcheck.
#[test]
fn golden_bodies_and_their_hashes_never_change() {
    let chain: ChainId = "000102030405060708090a0b0c0d0e0f".parse().unwrap();
    let bodies = four(chain);
    if std::env::var_os("JOURNAL_GOLDEN").is_some_and(|value| value == "write") {
        for (number, body) in (1..).zip(&bodies) {
            fitcheck::files::write(&folder().join(format!("{number}.json")), body).unwrap();
        }
    }
    let hashes = std::fs::read_to_string(folder().join("hashes.txt")).unwrap();
    let mut head = Head::default();
    for ((number, body), hash) in (1..).zip(&bodies).zip(hashes.lines()) {
        let golden = std::fs::read(folder().join(format!("{number}.json"))).unwrap();
        assert_eq!(String::from_utf8_lossy(body), String::from_utf8_lossy(&golden), "{number}.json");
        assert_eq!(write(&read(&golden).unwrap()).unwrap(), golden, "{number}.json");
        head = Head { number, hash: entry_hash(chain, head, &golden).unwrap() };
        assert_eq!(format!("{number} {}", head.hash), hash);
    }
    assert_eq!(head.number, 4);
}
