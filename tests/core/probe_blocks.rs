//! The block of a probing cycle: the manuals' examples read, every cycle written and read back.

use fitcheck::control::probe_block::{ProbeBlockError, ProbeBlockFault, read, read_or_lines, write};
use fitcheck::length::Length;
use fitcheck::message::Say as _;
use fitcheck::probing::Recorded;
use fitcheck::probing::cycle::{Angle, Cycle, CycleError, Inputs, Key, Parameter, Range, Unset, Value};
use fitcheck::probing::cycles::{CYCLES, cycle_named};
use fitcheck::tolerance::{Deviations, Nominal};
use fitcheck::words::{Dialogue, Language, Words};
use proptest::prelude::*;

/// The example in the manual of cycle 427 as printed: comments on their own lines, no `~` after the values.
const EXAMPLE_427: &str = "11 TCH PROBE 427 MISURAZ. COORDINATA ~\n\nQ263=+35\n\n;1. PUNTO 1. ASSE ~\n\nQ264=+45\n\n;1. PUNTO 2. ASSE ~\n\n\
    Q261=+5\n\n;ALTEZZA MISURATA ~\n\nQ320=+0\n\n;DISTANZA SICUREZZA ~\n\nQ272=+3\n\n;ASSE MISURATO ~\n\nQ267=-1\n\n\
    ;DIREZIONE ATTRAVERS. ~\n\nQ260=+20\n\n;ALTEZZA DI SICUREZZA ~\n\nQ281=+1\n\n;PROTOCOLLO DI MIS. ~\n\nQ288=+5.1\n\n\
    ;LIMITE MASSIMO ~\n\nQ289=+4.95\n\n;LIMITE MINIMO ~\n\nQ309=+0\n\n;STOP PGM SE ERRORE ~\n\nQ330=+0\n\n;UTENSILE ~\n\n\
    Q498=+0\n\n;INVERSIONE UTENSILE ~\n\nQ531=+0\n\n;ANGOLO DI INCLINAZ.";

/// The same as a control has it.
const WRITTEN_004: &str = "TCH PROBE 427 MISURAZ. COORDINATA ~
    Q263=+35   ;1. PUNTO 1. ASSE ~
    Q264=+45   ;1. PUNTO 2. ASSE ~
    Q261=+5    ;ALTEZZA MISURATA ~
    Q320=+0    ;DISTANZA SICUREZZA ~
    Q272=+3    ;ASSE MISURATO ~
    Q267=-1    ;DIREZIONE ATTRAVERS. ~
    Q260=+20   ;ALTEZZA DI SICUREZZA ~
    Q281=+1    ;PROTOCOLLO DI MIS. ~
    Q288=+5.1  ;LIMITE MASSIMO ~
    Q289=+4.95 ;LIMITE MINIMO ~
    Q309=+0    ;STOP PGM SE ERRORE ~
    Q330=+0    ;UTENSILE ~
    Q498=+0    ;INVERSIONE UTENSILE ~
    Q531=+0    ;ANGOLO DI INCLINAZ.
";

/// The example in the manual of G785.
const EXAMPLE_785: &str = "N3 G785 R0 BR0 K2 C0 RC60 I0 J0 Q0 P0 H0";

/// The pairs of a block, and what was skipped, or the error.
fn pairs(text: &str) -> String {
    match read(text) {
        Ok(block) => {
            let pairs: Vec<_> = block.settings.iter().map(|pair| format!("{}={}", pair.key, pair.text)).collect();
            let unused = block.unused.map(|unused| {
                let english = unused.to_string();
                assert_eq!(Words::new(Language::En).told(&unused), english);
                assert_ne!(Words::new(Language::Nl).told(&unused), english);
                format!(" | {english}")
            });
            format!("{}: {}{}", block.cycle.code, pairs.join(" "), unused.unwrap_or_default())
        }
        Err(error) => told(&error),
    }
}

fn told(error: &ProbeBlockError) -> String {
    let english = error.to_string();
    assert_eq!(Words::new(Language::En).told(error), english);
    let dutch = Words::new(Language::Nl).told(error);
    assert!(dutch != english && dutch != error.message().id, "{dutch}");
    english
}

#[track_caller]
fn check(text: &str, expected: &str) {
    assert_eq!(pairs(text), expected);
}

#[test]
fn parameters_beside_each_other_are_read_one_by_one() {
    let all = "421: Q273=+50 Q274=+20 Q262=+25";
    for text in [
        "TCH PROBE 421 MEASURE HOLE Q273=+50 Q274=+20 Q262=+25",
        "5 TCH PROBE 421 MEASURE HOLE ~\n Q273=+50 Q274=+20 ;CENTRE ~\n Q262=+25",
        "TCH PROBE 421 Q273=+50 ~\n Q274 = +20 Q262=+25",
    ] {
        assert_eq!(pairs(text), all, "{text}");
    }
    let unknown = pairs("TCH PROBE 421 MEASURE HOLE Q273=+50 Q999=+1");
    assert!(unknown.contains("Q999"), "{unknown}");
    let junk = pairs("TCH PROBE 421 ~\n Q273=+50 AND Q274=+20");
    assert!(junk.contains("Q273=+50 AND"), "what is no value stays with its name: {junk}");
}

#[test]
fn the_example_of_cycle_427_is_read_as_printed_and_written_as_a_control_does() {
    let block = read(EXAMPLE_427).unwrap();
    assert_eq!((block.line, block.cycle.code, block.settings.len(), &block.unused), (1, "427", 14, &None));
    let inputs = block.put_into(Inputs::new()).unwrap();
    assert_eq!(write(block.cycle, &inputs, Dialogue::It).unwrap().replace("\r\n", "\n"), WRITTEN_004);
    assert_eq!(pairs(EXAMPLE_427), pairs(WRITTEN_004));
    assert_eq!(pairs(EXAMPLE_427), pairs(&EXAMPLE_427.replace('\n', "\r\n")));
}

#[test]
fn the_example_of_g785_is_read_and_written_again() {
    check(EXAMPLE_785, "G785: R=0 BR=0 K=2 C=0 RC=60 I=0 J=0 Q=0 P=0 H=0");
    let block = read(EXAMPLE_785).unwrap();
    let inputs = block.put_into(Inputs::new()).unwrap();
    let written = write(block.cycle, &inputs, Dialogue::De).unwrap();
    assert_eq!(written, format!("{}\r\n", EXAMPLE_785.trim_start_matches("N3 ")));
}

#[test]
fn a_block_is_found_in_a_program_and_the_rest_of_it_is_named() {
    let program = include_str!("../data/samples/programs/cycle_427_italian.h");
    check(
        program,
        "427: Q263=+20 Q264=+12,5 Q261=-3 Q320=+0 Q272=+1 Q267=+1 Q260=+30 Q281=+1 Q288=+20.05 Q289=+19.95 Q309=+1 \
         Q330=+0 Q498=+0 Q531=+0 | line 2: 1  TOOL CALL 9 Z is not part of the probing cycle and was skipped, and 1 more",
    );
    check("; only a comment\nTCH PROBE 427\n\n* - heading\n", "427: ");
}

#[test]
fn numbers_names_order_case_blanks_and_comments_are_the_writer_s_own_business() {
    for text in [
        "TCH PROBE 427 ANYTHING ~\nQ267=-1 ~\nQ272=+3",
        "tch probe 427~\n  q267 = -1 ;~\n\n ; a line of comment ~\n\n  Q272=+3 ; the end",
        "/7 TCH PROBE 427 X ~\r\nQ267=-1 ;Richtung ~\r\nQ272=+3 ;Achse\r\n8 M30",
        "12 / TCH PROBE 427 Y ~ Q267=-1 ;A ~ Q272=+3 ;B",
        "TCH PROBE 427 ;\"quotes\" in a comment ~\nQ267=-1 ~\0Q272=+3",
    ] {
        let found = pairs(text).to_uppercase();
        assert!(found.starts_with("427: Q267=-1 Q272=+3"), "{text:?}: {found}");
    }
    check("TCH PROBE 444 ~\nQS400=\"0.4-0.1\" ;A;B ~\nMB=+10", "444: QS400=0.4-0.1 MB=+10");
    check("TCH PROBE 427 ~\nQS330=\"DRILL ~ 5;\" ;TOOL NAME", "427: QS330=DRILL ~ 5;");
    check("N30 G427 Q263=+35 Q272=+3 *", "427: Q263=+35 Q272=+3");
    check("g785 k-2.5 rc120 ; comment", "G785: k=-2.5 rc=120");
}

#[test]
fn what_is_wrong_with_a_block_is_named_with_its_line() {
    check("", "line 1: not a probing cycle: a block begins with TCH PROBE and a number, or with G785");
    check(
        "L X+5 R0 FMAX\nG1 X5",
        "line 1: not a probing cycle: a block begins with TCH PROBE and a number, or with G785",
    );
    let known: Vec<_> = CYCLES.iter().map(|cycle| cycle.code).filter(|code| !code.starts_with('G')).collect();
    let known = format!("the cycles are {}", known.join(", "));
    check("\nTCH PROBE 418 DATUM ~\nQ1=2", &format!("line 2: TCH PROBE 418: {known}"));
    check("TCH PROBE\n", &format!("line 1: TCH PROBE : {known}"));
    check(
        "TCH PROBE 427 ~\nQ263=+1\n\nTCH PROBE 427 ~\nQ263=+2",
        "line 4: second probing cycle: give one at a time; the first begins on line 1",
    );
    check("TCH PROBE 427 ~\n12 L Z+50", "line 2: 12 L Z+50 is not a parameter: write it as Q263=+35");
    check("TCH PROBE 427 ~\n=5", "line 2: =5 is not a parameter: write it as Q263=+35");
    check("TCH PROBE 427 ~\nQ263= ;EMPTY ~\nQ264=+1", "line 2: Q263 has no value");
    check("TCH PROBE 427 ~\nQ263=+1 ~\nq263=+1", "line 3: Q263 is given twice, first on line 2");
    check("TCH PROBE 427 ~\nQ330=+1 ~\nQS330=\"A\"", "line 3: Q330 is given twice, first on line 2");
    check("TCH PROBE 427 ~\nQS330=\"A", "line 2: a quotation mark is not closed");
    assert!(
        pairs("TCH PROBE 427 ~\nQ275=+1")
            .starts_with("line 2: cycle 427 has no parameter Q275: its parameters are Q263, ")
    );
    check(
        "TCH PROBE 427 ~\nQ263=+1 ;NO MORE\nQ264=+2",
        "line 3: Q264=+2 comes after the end of the block: every line but the last ends with ~",
    );
    check(
        "TCH PROBE 427 ~\nQ263=+1\n;NO MORE\n\nQ264=+2",
        "line 5: Q264=+2 comes after the end of the block: every line but the last ends with ~",
    );
    // A heading may contain a single inch mark.
    check("* - 1\" BORE\nTCH PROBE 427 ~\nQ263=+1", "427: Q263=+1");
    // Any other assignment after it is another block of the program.
    check(
        "TCH PROBE 427 ~\nQ263=+1\nQ5=+2",
        "427: Q263=+1 | line 3: Q5=+2 is not part of the probing cycle and was skipped",
    );
    check("TCH PROBE 427 ~\nQ263=+1 ~\n", "line 2: the block ends with ~, so a line is missing: it may be cut off");
    check("G785 K2 =3", "line 1: =3 is not a parameter: write it as Q263=+35");
    check("G785 K2 3", "line 1: 3 is not a parameter: write it as K2");
    check("G785 K RC60", "line 1: K has no value");
    assert!(pairs("G785 K2 X3").starts_with("line 1: cycle G785 has no parameter X: its parameters are R, BR, K, "));
    let long = format!("TCH PROBE 427 ~\n{}", "x".repeat(100_000));
    check(&long, &format!("line 2: {}… is not a parameter: write it as Q263=+35", "x".repeat(80)));
}

#[test]
fn a_value_that_is_none_is_named_with_its_line_and_a_program_s_parameter_as_such() {
    let said = |text: &str| told(&read(text).unwrap().put_into(Inputs::new()).unwrap_err());
    assert_eq!(said("TCH PROBE 427 ~\nQ263=+x"), "line 2: Q263 1ST POINT 1ST AXIS: +x is not a number");
    for (given, name) in [("+Q1", "Q1"), ("-QL12", "QL12"), ("QR3", "QR3")] {
        let said = said(&format!("TCH PROBE 427 ~\n\nQ263={given}"));
        assert_eq!(said, format!("line 3: Q263 = {name}: the value of {name} is known only while a program runs"));
    }
    assert_eq!(
        said("TCH PROBE 444 ~\nQS400=QS5"),
        "line 2: QS400 = QS5: the value of QS5 is known only while a program runs"
    );
    for (given, why) in [
        ("MAX", "MAX is not a number, and a tool name needs quotation marks"),
        ("Q5", "Q5 is not a number, and a tool name needs quotation marks"),
        ("+0*", "+0* is not a number, and a tool name needs quotation marks"),
        ("\"+0*\"", "+0* calls no tool: write its number, or its name"),
        ("\"25 5\"", "25 5 calls no tool: write its number, or its name"),
    ] {
        let text = format!("TCH PROBE 427 ~\nQ330={given}");
        let said = match read(&text) {
            Ok(block) => told(&block.put_into(Inputs::new()).unwrap_err()),
            Err(error) => told(&error),
        };
        assert_eq!(said, format!("line 2: Q330 TOOL NUMBER: {why}"));
    }
    // A tool may have any name that begins otherwise than a number.
    assert!(read("TCH PROBE 427 ~\nQ330=\"5_MILL\"").unwrap().put_into(Inputs::new()).unwrap().is_given(330));
    assert!(read("TCH PROBE 427 ~\nQS330=\"Q1\"").unwrap().put_into(Inputs::new()).unwrap().is_given(330));
}

#[test]
fn lines_without_their_head_are_those_of_the_cycle_that_is_named() {
    let taken = |text: &str, code: &str| match read_or_lines(text, cycle_named(code).unwrap()) {
        Ok(block) => {
            let pairs: Vec<_> = block.settings.iter().map(|pair| format!("{}={}", pair.key, pair.text)).collect();
            format!("{}: {}", block.cycle.code, pairs.join(" "))
        }
        Err(error) => told(&error),
    };
    assert_eq!(taken("QS400=\"0.4-0.1\" ;TOLERANCE", "444"), "444: QS400=0.4-0.1");
    assert_eq!(taken("  Q263=+35 ;A ~\n  Q264=+45 ;B", "427"), "427: Q263=+35 Q264=+45");
    assert_eq!(taken("K2 RC60", "G785"), "G785: K=2 RC=60");
    // A head says more than the name beside it.
    assert_eq!(taken(EXAMPLE_785, "427"), "G785: R=0 BR=0 K=2 C=0 RC=60 I=0 J=0 Q=0 P=0 H=0");
    assert_eq!(taken("Q263=+1 ~\nQ999=+1", "427").split(':').next(), Some("line 2"));
    assert_eq!(taken("L X+10 R0", "427"), "line 1: L X+10 R0 is not a parameter: write it as Q263=+35");
    for blank in ["", " \n"] {
        let none = "line 1: not a probing cycle: a block begins with TCH PROBE and a number, or with G785";
        assert_eq!(taken(blank, "427"), none);
    }
}

#[test]
fn a_text_that_no_block_can_hold_is_not_written() {
    let cycle = cycle_named("427").unwrap();
    for name in ["A\"B", "A\nB"] {
        let inputs = Inputs::new().with(330, Value::Text(name.to_owned()));
        let error = write(cycle, &inputs, Dialogue::En).unwrap_err();
        assert!(matches!(&error.what, ProbeBlockFault::NotWritable { key: Key::Q(330), .. }));
        assert!(told(&error).ends_with("a text in a block cannot contain quotation marks or line ends"), "{error}");
    }
}

#[test]
fn three_contacts_without_a_step_are_written_with_the_step_that_they_get() {
    let cycle = cycle_named("421").unwrap();
    let inputs = cycle.set(Inputs::new(), "Q423", "3").unwrap();
    assert!(write(cycle, &inputs, Dialogue::En).unwrap().contains("Q247=+120  ;STEPPING ANGLE ~"));
    assert!(write(cycle, &Inputs::new(), Dialogue::En).unwrap().contains("Q247=+90   ;STEPPING ANGLE ~"));
}

/// Any value that a parameter may have.
fn value(parameter: &'static Parameter) -> BoxedStrategy<Value> {
    let length = |nm: i64| Value::Length(Length::from_nanometres(nm).unwrap());
    let plain = match parameter.range {
        Range::Length { least, most } => (least.nanometres()..=most.nanometres()).prop_map(length).boxed(),
        Range::Nominal { least, most } => {
            let plain = |nm: i64| Nominal::of(Length::from_nanometres(nm).unwrap());
            let texts = ["25H7", "10m", "10+0.01-0.015", "8-1-2"].map(|text| text.parse().unwrap());
            prop_oneof![
                (least.nanometres()..=most.nanometres()).prop_map(plain),
                proptest::sample::select(texts.to_vec())
            ]
            .prop_map(Value::Nominal)
            .boxed()
        }
        Range::Angle { most, smallest } => {
            let sizes = smallest.ten_thousandths()..=most.ten_thousandths();
            let angle = |(size, sign): (i64, &str)| {
                let text = format!("{sign}{}.{:04}", size / 10_000, size % 10_000);
                Value::Angle(text.parse::<Angle>().unwrap())
            };
            (sizes, prop_oneof![Just(""), Just("-")]).prop_map(angle).boxed()
        }
        Range::Count { most } => (0..=i64::from(most)).prop_map(Value::Whole).boxed(),
        Range::OneOf(allowed) => proptest::sample::select(allowed).prop_map(Value::Whole).boxed(),
        Range::Number { most } => (-f64::from(most)..=f64::from(most)).prop_map(Value::Number).boxed(),
        Range::Tool => prop_oneof![
            (0..=999_999_u32).prop_map(|tenths| Value::Number(f64::from(tenths) / 10.0)),
            "[A-Zäé_;~=][A-Z 0-9_;~=]{0,20}[A-Z0-9_;~]".prop_map(Value::Text),
            "[0-9]{1,4}".prop_map(Value::Text),
        ]
        .boxed(),
        Range::Band => {
            let band = |(upper, lower): (i64, i64)| {
                let [upper, lower] = [upper, -lower].map(|nm| Length::from_nanometres(nm).unwrap());
                Value::Band((upper != lower).then(|| Deviations::new(upper, lower).unwrap()))
            };
            (0..5_000_000_i64, 0..5_000_000_i64).prop_map(band).boxed()
        }
    };
    if parameter.may_be_predef { prop_oneof![4 => plain, 1 => Just(Value::Predef)].boxed() } else { plain }
}

/// A cycle and inputs for it: the required ones, and some of the rest.
fn any_inputs() -> impl Strategy<Value = (&'static Cycle, Inputs)> {
    proptest::sample::select(CYCLES).prop_flat_map(|cycle| {
        let given: Vec<_> = cycle
            .parameters
            .iter()
            .map(|parameter| {
                let some = value(parameter).prop_map(Some).boxed();
                if parameter.unset == Unset::Refused { some } else { prop_oneof![some, Just(None)].boxed() }
            })
            .collect();
        given.prop_map(move |values| {
            let pairs = cycle.parameters.iter().zip(values);
            let inputs = pairs.fold(Inputs::new(), |inputs, (parameter, value)| match value {
                Some(value) => inputs.with(parameter.key, value),
                None => inputs,
            });
            (cycle, inputs)
        })
    })
}

/// The inputs that a cycle runs with, with PREDEF as 7.
fn effective(cycle: &Cycle, inputs: &Inputs) -> Vec<(Key, Option<Value>)> {
    let seven = Value::Length("7".parse().unwrap());
    let inputs = [260, 320].into_iter().fold(inputs.clone(), |inputs, key: u16| inputs.with_global(key, seven.clone()));
    let checked = cycle.checked(&inputs.with_global(301, Value::Whole(1))).unwrap();
    cycle.parameters.iter().map(|parameter| (parameter.key, checked.value(parameter.key).cloned())).collect()
}

proptest! {
    #[test]
    fn every_block_reads_back_as_the_same_inputs(
        (cycle, inputs) in any_inputs(),
        language in proptest::sample::select(Dialogue::ALL.to_vec()),
    ) {
        let text = write(cycle, &inputs, language).unwrap();
        let block = read(&text).unwrap();
        prop_assert_eq!(block.cycle.code, cycle.code);
        prop_assert_eq!(&block.unused, &None);
        let back = block.put_into(Inputs::new()).unwrap();
        prop_assert_eq!(effective(cycle, &back), effective(cycle, &inputs), "{}", text);
        // Written again, it is the same text.
        prop_assert_eq!(write(cycle, &back, language).unwrap(), text);
    }

    #[test]
    fn no_text_makes_the_reader_fail_otherwise_than_with_an_error(
        lines in prop::collection::vec(
            prop_oneof![
                Just("TCH PROBE 427 X ~".to_owned()), Just("N1 G785 K2".to_owned()), Just("Q263=+35 ;A ~".to_owned()),
                Just("Q272=+3".to_owned()), Just(";B ~".to_owned()), Just("\"".to_owned()), ".{0,20}",
                "(TCH PROBE |G)[0-9]{0,4}[ ~;=]{0,3}Q?[0-9]{0,3}=?",
            ],
            0..12,
        ),
    ) {
        let text = lines.join("\n");
        if let Ok(block) = read(&text) {
            prop_assert!(block.settings.len() <= block.cycle.parameters.len());
            let inputs = block.put_into(Inputs::new());
            if let Ok(inputs) = inputs {
                let ran: Result<_, CycleError> = block.cycle.measure(&inputs, &mut Recorded::new(Vec::new()));
                prop_assert!(ran.is_err());
            }
        }
    }
}

#[test]
fn a_block_of_iso_is_read_as_a_program_reads_it() {
    let words = "Q273=+40 Q274=+30 Q262=+25 Q330=+0";
    let settings = |text: &str| -> Vec<String> {
        read(text).unwrap().settings.iter().map(|found| format!("{}={}", found.key, found.text)).collect()
    };
    let expected: Vec<String> = words.split(' ').map(str::to_owned).collect();
    for text in [
        format!("N50 G421 {words}*"),
        format!("N50 G421 {words} *"),
        format!("N50 G421 {words}\n*"),
        format!("N50 G421\n{}*", words.replace(' ', "\n")),
        format!("N50 G421\n{}\n*\nN60 M30*", words.replace(' ', "\n")),
        format!("N50 G421 {words}\nN60 M30 *"),
    ] {
        assert_eq!(settings(&text), expected, "{text}");
    }
    assert_eq!(settings("N50 G421 Q273=+40*\nQ274=+30*"), ["Q273=+40"]);
}
