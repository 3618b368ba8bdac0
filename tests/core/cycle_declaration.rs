//! Compares the declarations of all cycles with the control's manuals, and tests the range errors made from them.

use fitcheck::length::Length;
use fitcheck::message::{Arg, Say};
use fitcheck::probing::cycle::{
    Angle, Cycle, CycleError, DatumTarget, Inputs, Key, Meaning, Parameter, Range, Remark, Unset, Value,
};
use fitcheck::probing::cycles::{CYCLES, cycle, cycle_named};
use fitcheck::probing::simulated::{Machine, Probe, Workpiece};
use fitcheck::probing::{Contact, Recorded, Source};
use fitcheck::shipped;
use fitcheck::tolerance::{Deviations, Feature, Nominal};
use fitcheck::verdict::Status;
use fitcheck::words::{Dialogue, Language, Words};

/// A text that every cycle accepts for a parameter, from its declaration.
fn usual(parameter: &Parameter) -> Value {
    match parameter.range {
        // The two points of a ridge lie on either side of it, and those of a line at two places.
        Range::Length { .. } if matches!(parameter.meaning, Meaning::SecondPoint(_) | Meaning::NextPoint(_)) => {
            length("0")
        }
        Range::Length { .. } => length("25"),
        // The second point of an edge lies elsewhere.
        Range::Nominal { .. } if parameter.name.starts_with("2ND") => nominal("0"),
        Range::Nominal { .. } => nominal("25"),
        Range::Angle { .. } => Value::Angle(Angle::from_degrees(60)),
        Range::OneOf(allowed) => Value::Whole(allowed[0]),
        Range::Count { .. } => Value::Whole(0),
        Range::Number { .. } | Range::Tool => Value::Number(1.0),
        Range::Band => Value::Band(None),
    }
}

/// Inputs with the parameters that must be given.
fn asked(cycle: &Cycle) -> Inputs {
    let required = cycle.parameters.iter().filter(|parameter| parameter.unset == Unset::Refused);
    required.fold(Inputs::new(), |inputs, parameter| inputs.with(parameter.key, usual(parameter)))
}

fn length(text: &str) -> Value {
    Value::Length(text.parse().unwrap())
}

fn nominal(text: &str) -> Value {
    Value::Nominal(text.parse().unwrap())
}

/// Runs a cycle that can make no contact: only what comes before probing matters.
fn error(cycle: &Cycle, inputs: &Inputs) -> CycleError {
    cycle.measure(inputs, &mut Recorded::new(Vec::new())).unwrap_err()
}

#[track_caller]
fn accepted(cycle: &Cycle, parameter: &Parameter, value: &Value) {
    match error(cycle, &asked(cycle).with(parameter.key, value.clone())) {
        // A row of a table needs to be told which table.
        CycleError::NoContact(_) | CycleError::LimitsSwapped { .. } | CycleError::NoTransfer { .. } => {}
        CycleError::NoRotation { key, .. } => assert_eq!(key, parameter.key),
        // The control's range begins at 0, but that of a circle, a path and a normal does not.
        CycleError::NoDiameter { key, .. } | CycleError::NoPath { key, .. } => {
            assert_eq!((key, value.length()), (parameter.key, Some(Length::ZERO)));
        }
        error => panic!("{} = {value}: {error}", parameter.key),
    }
}

#[track_caller]
fn refused(cycle: &Cycle, parameter: &Parameter, value: &Value) {
    let said = error(cycle, &asked(cycle).with(parameter.key, value.clone())).to_string();
    let given = value.with_unit();
    assert_eq!(said, format!("{} {} = {given}: {}", parameter.key, parameter.name, parameter.range));
}

/// The values at the ends of a range, and those one step outside.
fn bounds(range: Range) -> (Vec<Value>, Vec<Value>) {
    let beside = |length: Length, nm: i64| Value::Length(Length::from_nanometres(length.nanometres() + nm).unwrap());
    let turned = |angle: Angle, sign: &str, ten_thousandths: i64| {
        let size = angle.ten_thousandths() + ten_thousandths;
        Value::Angle(format!("{sign}{}.{:04}", size / 10_000, size % 10_000).parse().unwrap())
    };
    match range {
        Range::Length { least, most } => {
            (vec![Value::Length(least), Value::Length(most)], vec![beside(least, -1), beside(most, 1)])
        }
        Range::Nominal { least, most } => {
            let plain = |length: Length| Value::Nominal(Nominal::of(length));
            let nm = |length: Length, nm: i64| Length::from_nanometres(length.nanometres() + nm).unwrap();
            (vec![plain(least), plain(most)], vec![plain(nm(least, -1)), plain(nm(most, 1))])
        }
        Range::Angle { most, smallest } => {
            let mut outside = vec![turned(most, "", 1), turned(most, "-", 1)];
            if Angle::default() < smallest {
                outside.extend([turned(smallest, "", -1), turned(smallest, "-", -1), Value::Angle(Angle::default())]);
            }
            (["", "-"].map(|sign| [turned(most, sign, 0), turned(smallest, sign, 0)]).concat(), outside)
        }
        Range::OneOf(allowed) => {
            // Everything near the choices that is not one of them, and what no number can hold.
            let near = allowed.iter().min().unwrap() - 1..=allowed.iter().max().unwrap() + 1;
            let outside = near.filter(|whole| !allowed.contains(whole)).chain([i64::MIN, i64::MAX]);
            (allowed.iter().copied().map(Value::Whole).collect(), outside.map(Value::Whole).collect())
        }
        Range::Count { most } => {
            let most = i64::from(most);
            let outside = [-1, most + 1, i64::MIN, i64::MAX];
            ([0, 1, most].map(Value::Whole).to_vec(), outside.map(Value::Whole).to_vec())
        }
        Range::Number { most } => {
            let most = f64::from(most);
            let outside = [most.next_up(), -most.next_up(), f64::NAN, f64::INFINITY];
            (vec![Value::Number(most), Value::Number(-most)], outside.map(Value::Number).to_vec())
        }
        Range::Tool => {
            let name = |characters| Value::Text("ü".repeat(characters));
            let inside = [0.0, 5.1, 99_999.9].map(Value::Number);
            let outside = [-0.1, 5.01, 100_000.0, f64::NAN].map(Value::Number);
            (
                [inside.to_vec(), vec![name(1), name(255)]].concat(),
                [outside.to_vec(), vec![name(0), name(256)]].concat(),
            )
        }
        Range::Band => {
            let band = |upper: &str, lower: &str| {
                Value::Band(Some(Deviations::new(upper.parse().unwrap(), lower.parse().unwrap()).unwrap()))
            };
            (vec![band("0.4", "-0.1"), band("0", "-0.1"), Value::Band(None)], Vec::new())
        }
    }
}

#[test]
fn every_parameter_is_accepted_on_its_bounds_and_refused_one_step_outside() {
    for cycle in CYCLES {
        for parameter in cycle.parameters {
            let (inside, outside) = bounds(parameter.range);
            for value in inside {
                accepted(cycle, parameter, &value);
            }
            for value in outside {
                refused(cycle, parameter, &value);
            }
        }
    }
}

/// A value as people type it.
fn typed(value: &Value) -> String {
    match value {
        Value::Text(name) => name.clone(),
        value => value.to_string().trim_end_matches('°').to_owned(),
    }
}

#[test]
fn every_parameter_is_accepted_and_refused_alike_when_it_is_typed() {
    for cycle in CYCLES {
        for parameter in cycle.parameters {
            let (inside, outside) = bounds(parameter.range);
            for value in inside {
                for text in [typed(&value), format!("  {}\t", typed(&value)), typed(&value).replace('.', ",")] {
                    let said = parameter.accept(&text);
                    assert_eq!(said.as_ref().ok(), Some(&value), "{} = {text:?}: {said:?}", parameter.key);
                }
            }
            // Typed, NaN is the name of a tool.
            let is_name = |value: &Value| parameter.range == Range::Tool && typed(value) == "NaN";
            for value in outside.into_iter().filter(|value| !is_name(value)) {
                let text = typed(&value);
                let said = parameter.accept(&text).unwrap_err();
                let begins = format!("{} {}", parameter.key, parameter.name);
                assert!(said.to_string().starts_with(&begins), "{text}: {said}");
                // Everything that can be read is refused for its range, with the range in the sentence.
                let is_number = text.parse::<f64>().is_ok_and(f64::is_finite);
                if is_number {
                    assert_eq!(
                        said,
                        CycleError::OutOfRange {
                            key: parameter.key,
                            name: parameter.called(),
                            given: Box::new(Arg::Message(value.with_unit())),
                            range: parameter.range,
                        }
                    );
                }
            }
        }
    }
}

const COORDINATE: &str = "-99999.9999 … 99999.9999";
const SIZE: &str = "0 … 99999.9999";
const TOOL: &str = "0 … 99999.9, or at most 255 characters";

/// Name, range, and whether PREDEF is allowed.
type Documented = (&'static str, &'static str, bool);

/// 421 and 422: manuals of the TNC 320 and TNC7.
fn round_ranges(maximum: &'static str, minimum: &'static str) -> Vec<Documented> {
    vec![
        ("Q273", COORDINATE, false),
        ("Q274", COORDINATE, false),
        ("Q262", SIZE, false),
        ("Q325", "-360 … 360", false),
        ("Q247", "±5 … ±120", false),
        ("Q261", COORDINATE, false),
        ("Q320", SIZE, true),
        ("Q260", COORDINATE, true),
        ("Q301", "0, 1", true),
        (maximum, SIZE, false),
        (minimum, SIZE, false),
        ("Q279", SIZE, false),
        ("Q280", SIZE, false),
        ("Q281", "0, 1, 2", false),
        ("Q309", "0, 1", false),
        ("Q330", TOOL, false),
        ("Q423", "3, 4", false),
        ("Q365", "0, 1", false),
        ("Q498", "0, 1", false),
        ("Q531", "-180 … 180", false),
    ]
}

/// Manual TNC7 (Italian), line by line.
const OF_427: &[Documented] = &[
    ("Q263", COORDINATE, false),
    ("Q264", COORDINATE, false),
    ("Q261", COORDINATE, false),
    ("Q320", SIZE, true),
    ("Q272", "1, 2, 3", false),
    ("Q267", "-1, 1", false),
    ("Q260", COORDINATE, true),
    ("Q281", "0, 1, 2", false),
    ("Q288", COORDINATE, false),
    ("Q289", COORDINATE, false),
    ("Q309", "0, 1", false),
    ("Q330", TOOL, false),
    ("Q498", "0, 1", false),
    ("Q531", "-180 … 180", false),
];

/// Manual TNC 640 (01/2021) and the manual of the TNC 320; those of the normal, QS400 and MB are general knowledge.
const OF_444: &[Documented] = &[
    ("Q263", COORDINATE, false),
    ("Q264", COORDINATE, false),
    ("Q294", COORDINATE, false),
    ("Q581", "-10 … 10", false),
    ("Q582", "-10 … 10", false),
    ("Q583", "-10 … 10", false),
    ("Q320", SIZE, true),
    ("Q260", COORDINATE, true),
    ("QS400", "0.4-0.1, 0.4, -0.1 or nothing", false),
    ("Q309", "0, 1, 2", false),
    ("MB", SIZE, false),
];

/// 423 and 424: manual of the TNC 320; those of the limits by analogy.
const OF_RECTANGLES: &[Documented] = &[
    ("Q273", COORDINATE, false),
    ("Q274", COORDINATE, false),
    ("Q282", SIZE, false),
    ("Q283", SIZE, false),
    ("Q261", COORDINATE, false),
    ("Q320", SIZE, true),
    ("Q260", COORDINATE, true),
    ("Q301", "0, 1", true),
    ("Q284", SIZE, false),
    ("Q285", SIZE, false),
    ("Q286", SIZE, false),
    ("Q287", SIZE, false),
    ("Q279", SIZE, false),
    ("Q280", SIZE, false),
    ("Q281", "0, 1, 2", false),
    ("Q309", "0, 1", false),
    ("Q330", TOOL, false),
];

/// 425: manual of the TNC 320, Q272 is never the probe axis.
const OF_425: &[Documented] = &[
    ("Q328", COORDINATE, false),
    ("Q329", COORDINATE, false),
    ("Q310", COORDINATE, false),
    ("Q272", "1, 2", false),
    ("Q261", COORDINATE, false),
    ("Q260", COORDINATE, true),
    ("Q311", SIZE, false),
    ("Q288", SIZE, false),
    ("Q289", SIZE, false),
    ("Q281", "0, 1, 2", false),
    ("Q309", "0, 1", false),
    ("Q330", TOOL, false),
    ("Q320", SIZE, true),
    ("Q301", "0, 1", true),
];

/// 426: as 425 and 427.
const OF_426: &[Documented] = &[
    ("Q263", COORDINATE, false),
    ("Q264", COORDINATE, false),
    ("Q265", COORDINATE, false),
    ("Q266", COORDINATE, false),
    ("Q272", "1, 2", false),
    ("Q261", COORDINATE, false),
    ("Q320", SIZE, true),
    ("Q260", COORDINATE, true),
    ("Q311", SIZE, false),
    ("Q288", SIZE, false),
    ("Q289", SIZE, false),
    ("Q281", "0, 1, 2", false),
    ("Q309", "0, 1", false),
    ("Q330", TOOL, false),
];

/// 1400 and 1410, remembered: the points, what they have in common, and the rest.
fn of_1400(points: &[&'static str], rest: &[&'static str]) -> Vec<Documented> {
    let common = ["Q320", "Q260", "Q1125", "Q309"];
    let documented = |key: &&'static str| match *key {
        key @ "Q372" => (key, "-3, -2, -1, 1, 2, 3", false),
        key @ "Q320" => (key, SIZE, true),
        key @ "Q260" => (key, COORDINATE, true),
        key @ "Q1125" => (key, "-1, 0, 1, 2", false),
        key @ "Q1120" => (key, "0, 1", false),
        key @ ("Q309" | "Q1121" | "Q1126") => (key, "0, 1, 2", false),
        key => (key, COORDINATE, false),
    };
    points.iter().chain(&common).chain(rest).map(documented).collect()
}

/// Remembered, in the order of the sample.
const OF_1401: &[Documented] = &[
    ("QS1100", COORDINATE, false),
    ("QS1101", COORDINATE, false),
    ("QS1102", COORDINATE, false),
    ("QS1116", SIZE, false),
    ("Q1115", "0, 1", false),
    ("Q423", "3, 4, 5, 6, 7, 8, 9", false),
    ("Q325", "-360 … 360", false),
    ("Q1119", "±1 … ±360", false),
    ("Q320", SIZE, true),
    ("Q260", COORDINATE, true),
    ("Q1125", "-1, 0, 1, 2", false),
    ("Q309", "0, 1, 2", false),
    ("Q1120", "0, 1", false),
];

/// Manual CNC PILOT 640 gives no ranges except those of the choices.
const OF_785: &[Documented] = &[
    ("R", "0, 1, 2", false),
    ("BR", "0, 1", false),
    ("K", COORDINATE, false),
    ("C", "-360 … 360", false),
    ("RC", "-360 … 360", false),
    ("D", SIZE, false),
    ("WB", COORDINATE, false),
    ("I", COORDINATE, false),
    ("J", COORDINATE, false),
    ("WE", SIZE, false),
    ("Q", COORDINATE, false),
    ("P", COORDINATE, false),
    ("H", COORDINATE, false),
];

const RECTANGLE_DATUM: [&str; 12] =
    ["Q321", "Q322", "Q323", "Q324", "Q261", "Q320", "Q260", "Q301", "Q305", "Q331", "Q332", "Q303"];

/// 408 to 419: these parameters in this order, and those of the probe axis behind them.
fn of_datum(keys: &[&'static str], has_top: bool) -> Vec<Documented> {
    let top = ["Q381", "Q382", "Q383", "Q384", "Q333"];
    let keys = keys.iter().copied().chain(top.into_iter().filter(|_| has_top));
    let documented = |key| match key {
        "Q323" | "Q324" | "Q262" | "Q311" => (key, SIZE, false),
        "Q320" => (key, SIZE, true),
        "Q260" => (key, COORDINATE, true),
        "Q301" => (key, "0, 1", true),
        "Q272" => (key, "1, 2", false),
        "Q267" => (key, "-1, 1", false),
        "Q303" => (key, "-1, 0, 1", false),
        "Q305" => (key, "0 … 99999", false),
        "Q381" | "Q365" => (key, "0, 1", false),
        "Q325" => (key, "-360 … 360", false),
        "Q247" => (key, "±5 … ±120", false),
        "Q423" => (key, "3, 4", false),
        _ => (key, COORDINATE, false),
    };
    keys.map(documented).collect()
}

/// 412 and 413: manuals of iTNC 530 and TNC 320.
fn round_datum() -> Vec<Documented> {
    let keys = ["Q321", "Q322", "Q262", "Q325", "Q247", "Q261", "Q320", "Q260", "Q301", "Q305", "Q331", "Q332", "Q303"];
    [of_datum(&keys, true), of_datum(&["Q423", "Q365"], false)].concat()
}

#[test]
fn the_ranges_are_those_of_the_manuals() {
    let documented = [
        ("421", round_ranges("Q275", "Q276")),
        ("422", round_ranges("Q277", "Q278")),
        ("423", OF_RECTANGLES.to_vec()),
        ("424", OF_RECTANGLES.to_vec()),
        ("425", OF_425.to_vec()),
        ("426", OF_426.to_vec()),
        ("427", OF_427.to_vec()),
        ("444", OF_444.to_vec()),
        ("1400", of_1400(&["QS1100", "QS1101", "QS1102", "Q372"], &["Q1120"])),
        ("1401", OF_1401.to_vec()),
        ("1402", OF_1401.iter().copied().filter(|(key, ..)| *key != "Q1115").collect()),
        (
            "1410",
            of_1400(
                &["QS1100", "QS1101", "QS1102", "QS1103", "QS1104", "QS1105", "Q372"],
                &["Q1126", "Q1120", "Q1121"],
            )
            .into_iter()
            .map(|(key, range, predef)| match key {
                "Q372" => (key, "-2, -1, 1, 2", predef),
                "Q1120" => (key, "0, 1, 2, 3", predef),
                _ => (key, range, predef),
            })
            .collect(),
        ),
        ("G785", OF_785.to_vec()),
        (
            "408",
            of_datum(&["Q321", "Q322", "Q311", "Q272", "Q261", "Q320", "Q260", "Q301", "Q305", "Q405", "Q303"], true),
        ),
        ("409", of_datum(&["Q321", "Q322", "Q311", "Q272", "Q261", "Q320", "Q260", "Q305", "Q405", "Q303"], true)),
        ("410", of_datum(&RECTANGLE_DATUM, true)),
        ("411", of_datum(&RECTANGLE_DATUM, true)),
        ("412", round_datum()),
        ("413", round_datum()),
        ("417", of_datum(&["Q263", "Q264", "Q294", "Q320", "Q260", "Q305", "Q333", "Q303"], false)),
        (
            "419",
            of_datum(&["Q263", "Q264", "Q261", "Q320", "Q260", "Q272", "Q267", "Q305", "Q333", "Q303"], false)
                .into_iter()
                .map(|(key, range, predef)| (key, if key == "Q272" { "1, 2, 3" } else { range }, predef))
                .collect(),
        ),
    ];
    for (code, expected) in documented {
        let cycle = cycle_named(code).unwrap();
        let declared: Vec<_> = cycle
            .parameters
            .iter()
            .map(|p| (p.key.to_string(), p.range.short().to_string(), p.may_be_predef))
            .collect();
        let expected: Vec<_> =
            expected.into_iter().map(|(key, range, predef)| (key.to_owned(), range.to_owned(), predef)).collect();
        assert_eq!(declared, expected, "{}", cycle.code);
    }
}

#[test]
fn a_value_of_another_kind_is_refused_for_every_parameter() {
    let values = [
        length("10"),
        Value::Angle(Angle::from_degrees(90)),
        Value::Whole(1),
        Value::Number(1.0),
        Value::Text("T5".to_owned()),
        Value::Band(None),
        nominal("25H7"),
    ];
    for cycle in CYCLES {
        for parameter in cycle.parameters {
            let wanted: &[usize] = match parameter.range {
                Range::Length { .. } => &[0],
                Range::Angle { .. } => &[1],
                Range::OneOf(_) | Range::Count { .. } => &[2],
                Range::Number { .. } => &[3],
                Range::Tool => &[3, 4],
                Range::Band => &[5],
                Range::Nominal { .. } => &[6],
            };
            let others = (0..).zip(&values).filter(|(kind, _)| !wanted.contains(kind));
            others.for_each(|(_, value)| refused(cycle, parameter, value));
        }
    }
}

#[test]
fn a_text_that_is_no_value_is_refused_with_the_parameter_named() {
    for cycle in CYCLES {
        for parameter in cycle.parameters {
            let text = match parameter.range {
                // Any text may be the name of a tool.
                Range::Tool => "",
                Range::Band => "H7",
                _ => "1.234,5",
            };
            let said = cycle.set(Inputs::new(), &parameter.key.to_string(), text).unwrap_err().to_string();
            assert!(said.starts_with(&format!("{} {}: ", parameter.key, parameter.name)), "{said}");
        }
        let error = cycle.set(Inputs::new(), "Q999", "1").unwrap_err().to_string();
        let known: Vec<_> = cycle.parameters.iter().map(|parameter| parameter.key.to_string()).collect();
        assert_eq!(
            error,
            format!("cycle {} has no parameter Q999: its parameters are {}", cycle.code, known.join(", "))
        );
    }
}

#[test]
fn every_parameter_without_a_default_must_be_given() {
    for cycle in CYCLES {
        for parameter in cycle.parameters.iter().filter(|parameter| parameter.unset == Unset::Refused) {
            let others =
                cycle.parameters.iter().filter(|other| other.unset == Unset::Refused && other.key != parameter.key);
            let inputs = others.fold(Inputs::new(), |inputs, other| inputs.with(other.key, usual(other)));
            let expected = format!("{} {} is missing", parameter.key, parameter.name);
            assert_eq!(error(cycle, &inputs).to_string(), expected);
        }
    }
}

#[test]
fn predef_takes_the_value_of_global_def_and_nothing_else() {
    for cycle in CYCLES {
        for parameter in cycle.parameters {
            let predef = asked(cycle).with(parameter.key, Value::Predef);
            if !parameter.may_be_predef {
                refused(cycle, parameter, &Value::Predef);
                continue;
            }
            let said = error(cycle, &predef).to_string();
            assert_eq!(said, format!("{} {} = PREDEF: no GLOBAL DEF gives a value", parameter.key, parameter.name));
            let given = predef.with_global(parameter.key, usual(parameter));
            assert_eq!(cycle.checked(&given).unwrap().value(parameter.key), Some(&usual(parameter)));
        }
    }
}

#[test]
fn what_has_no_effect_is_kept_and_said() {
    for cycle in CYCLES {
        let required = asked(cycle);
        let run = |inputs: &Inputs| {
            let mut prober = Source::Perfect.prober(cycle, inputs).unwrap();
            cycle.measure(inputs, &mut *prober).unwrap()
        };
        // The required parameters are enough, and the workpiece at nominal size is good.
        let plain = run(&required);
        assert!(plain.stop.is_none() && matches!(plain.status, None | Some(Status::Good)), "{}", cycle.code);
        for found in &plain.results {
            assert_eq!(Words::new(Language::En).told(&found.name), found.name.to_string());
            for language in Language::all() {
                let id = found.name.message().id;
                assert_ne!(Words::new(language).told(&found.name), id, "assets/locales/{language} has no text {id}");
            }
        }
        for parameter in cycle.parameters.iter().filter(|parameter| !parameter.has_effect) {
            let given = run(&required.clone().with(parameter.key, usual(parameter)));
            assert!(given.remarks.contains(&Remark::WithoutEffect { key: parameter.key }), "{}", parameter.key);
            assert_eq!(given.results, plain.results, "{}", parameter.key);
            assert_eq!(given.inputs.value(parameter.key), Some(&usual(parameter)));
        }
    }
}

#[test]
fn every_cycle_and_parameter_has_its_name_and_question_in_every_dialogue() {
    let mut faults = Vec::new();
    let mut check = |what: String, texts: &[(Dialogue, &str)], wanted: &[Dialogue]| {
        let languages: Vec<_> = texts.iter().map(|(language, _)| *language).collect();
        if languages != wanted || texts.iter().any(|(_, text)| text.trim().is_empty()) {
            faults.push(format!("{what}: {texts:?}"));
        }
    };
    for cycle in CYCLES {
        let code = cycle.code;
        check(format!("name of {code}"), cycle.names, &Dialogue::ALL);
        // Q, P and H of G785 are only letters.
        for parameter in cycle.parameters.iter().filter(|parameter| 1 < parameter.name.len()) {
            // The English name stands apart.
            check(format!("{code}, name of {}", parameter.key), parameter.names, &Dialogue::ALL[1..]);
            check(format!("{code}, question of {}", parameter.key), parameter.questions, &Dialogue::ALL);
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

#[test]
fn names_stand_in_blocks_and_are_plain_there() {
    for (cycle, language) in CYCLES.iter().flat_map(|cycle| Dialogue::ALL.map(|language| (cycle, language))) {
        let names = cycle.parameters.iter().map(|parameter| parameter.name_in(language));
        for name in names.chain([cycle.name(language)]) {
            let is_plain = name.bytes().all(|byte| byte == b' ' || byte.is_ascii_graphic() && !b"~;".contains(&byte));
            assert!(is_plain && name == name.to_uppercase(), "{} {language}: {name}", cycle.code);
        }
    }
}

#[test]
fn the_built_in_program_calls_cycles_and_parameters_as_they_are_declared() {
    for language in Dialogue::ALL {
        let program = shipped::text(shipped::NC, &format!("82551_{language}.h"));
        let mut named = None;
        let mut seen = 0;
        for line in program.lines().map(|line| line.trim_end_matches(" ~")) {
            if let Some((_, called)) = line.split_once(" TCH PROBE ") {
                let (code, name) = called.split_once(' ').unwrap();
                let cycle = cycle_named(code).unwrap();
                assert_eq!(name, cycle.name(language), "{language}: {line}");
                named = Some(cycle);
            } else if let Some((key, (_, name))) =
                line.strip_prefix("    ").and_then(|pair| Some((pair.split_once('=')?.0, pair.split_once(" ;")?)))
            {
                let parameters = named.unwrap().parameters;
                let parameter = parameters.iter().find(|parameter| parameter.key.to_string() == key).unwrap();
                assert_eq!(name, parameter.name_in(language), "{language}: {line}");
                seen += 1;
            }
        }
        assert_eq!(seen, 32, "{language}");
    }
}

#[test]
fn every_error_and_remark_is_said_in_english_and_in_dutch() {
    fn check(what: &(impl std::fmt::Display + Say)) {
        let english = what.to_string();
        assert_eq!(Words::new(Language::En).told(what).replace('\u{2212}', "-"), english);
        let dutch = Words::new(Language::Nl).told(what);
        assert!(dutch != english && dutch != what.message().id, "{dutch}");
    }
    let (key, name) = (Key::Q(320), cycle(427).unwrap().parameter(320).unwrap().called());
    let mm = |text: &str| text.parse::<Length>().unwrap();
    let far = Length::from_mm_f64(2e9).unwrap_err();
    for error in [
        CycleError::Missing { key, name },
        CycleError::NoGlobal { key, name },
        CycleError::NoDiameter { key, name },
        CycleError::NoPath { key, name },
        CycleError::NoTransfer { key, row_key: key, row: 5 },
        CycleError::OtherFeature { key, name, given: "25h7".to_owned(), geometry: key },
        CycleError::NotMeasured { key, name, given: "25H7".to_owned() },
        CycleError::NoEdge { first: key, second: key },
        CycleError::NoSphere,
        CycleError::NoRotation { key, name },
        CycleError::InchTolerance { key, name, given: "25H7".to_owned() },
        CycleError::NoNormal { first: key, second: key, third: key },
        CycleError::NoSuchParameter { cycle: "427", parameter: "Q1".to_owned(), known: "Q263".to_owned() },
        CycleError::LimitsSwapped { minimum_key: key, minimum: mm("2"), maximum_key: key, maximum: mm("1") },
        CycleError::Apart { contact: 2, difference: mm("0.1"), key, most: mm("0.01") },
        CycleError::TooLarge(far.clone()),
        CycleError::TooFar(far),
    ] {
        check(&error);
    }
    for remark in [
        Remark::WithoutEffect { key },
        Remark::ToolNotMonitored { tool: "5.1".to_owned() },
        Remark::OutsideDimension,
        Remark::NominalOutsideLimits { nominal: mm("25") },
        Remark::NominalWidthOutsideLimits { nominal: mm("25") },
        Remark::VariableHoldsDiameter,
        Remark::NewDatum { axes: Arg::Number("X 1 → 0".to_owned()), target: DatumTarget::Preset { row: 5 } },
        Remark::NoTolerance { key: Key::Qs(400) },
    ] {
        check(&remark);
    }
    for cycle in CYCLES {
        for parameter in cycle.parameters {
            check(&parameter.range);
        }
    }
}

#[test]
fn order_numbers_and_defaults_are_those_of_the_control() {
    // The order of the lines in NC programs: a public post-processor's, then those of newer controls.
    for (number, maximum, minimum) in [(421, 275, 276), (422, 277, 278)] {
        let declared: Vec<_> = cycle(number).unwrap().parameters.iter().map(|p| (p.key, p.name, p.unset)).collect();
        let expected = [
            (Key::Q(273), "CENTER IN 1ST AXIS", Unset::Refused),
            (Key::Q(274), "CENTER IN 2ND AXIS", Unset::Refused),
            (Key::Q(262), "NOMINAL DIAMETER", Unset::Refused),
            (Key::Q(325), "STARTING ANGLE", Unset::Value(0)),
            (Key::Q(247), "STEPPING ANGLE", Unset::Value(900_000)),
            (Key::Q(261), "MEASURING HEIGHT", Unset::Value(0)),
            (Key::Q(320), "SET-UP CLEARANCE", Unset::Value(0)),
            (Key::Q(260), "CLEARANCE HEIGHT", Unset::Value(50_000_000)),
            (Key::Q(301), "MOVE TO CLEARANCE", Unset::Value(0)),
            (Key::Q(maximum), "MAXIMUM DIMENSION", Unset::Value(0)),
            (Key::Q(minimum), "MINIMUM DIMENSION", Unset::Value(0)),
            (Key::Q(279), "TOLERANCE 1ST CENTER", Unset::Value(0)),
            (Key::Q(280), "TOLERANCE 2ND CENTER", Unset::Value(0)),
            (Key::Q(281), "MEASURING LOG", Unset::Value(0)),
            (Key::Q(309), "PGM-STOP IF ERROR", Unset::Value(0)),
            (Key::Q(330), "TOOL NUMBER", Unset::Value(0)),
            (Key::Q(423), "NO. OF MEAS. POINTS", Unset::Value(4)),
            (Key::Q(365), "TYPE OF TRAVERSE", Unset::Value(1)),
            (Key::Q(498), "REVERSE TOOL", Unset::Value(0)),
            (Key::Q(531), "ANGLE OF INCIDENCE", Unset::Value(0)),
        ];
        assert_eq!(declared, expected);
    }
}

#[test]
fn a_scatter_of_zero_leaves_the_numbers_of_the_other_alone() {
    let contacts = |surface_scatter, trigger_scatter| -> Vec<Contact> {
        let part = Workpiece { surface_scatter, ..Workpiece::round(Feature::Hole, [25.0, 25.0], 25.0) };
        let mut machine = Machine::new(part, Probe { trigger_scatter, ..Probe::STILL }, 3).unwrap();
        cycle(421).unwrap().measure(&asked(cycle(421).unwrap()), &mut machine).unwrap().contacts
    };
    let (both, surface, probe, none) =
        (contacts(0.0003, 0.0005), contacts(0.0003, 0.0), contacts(0.0, 0.0005), contacts(0.0, 0.0));
    for (at, exact) in none.iter().enumerate() {
        let sum = (surface[at].x - exact.x) + (probe[at].x - exact.x);
        assert!((both[at].x - exact.x - sum).abs() < 1e-13, "touch {}", at + 1);
        assert!(surface[at] != *exact && probe[at] != *exact);
    }
}
