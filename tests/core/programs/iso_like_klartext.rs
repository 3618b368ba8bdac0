//! The same measurement written in ISO and in Klartext gives the same bytes of JSON.

use std::fmt::Write as _;

use clap::Parser as _;
use fitcheck::cli::{Cli, Io};
use proptest::prelude::*;
use proptest::sample::select;
use serde_json::Value;

/// A program in both notations, block by block.
#[derive(Debug, Default)]
struct Both {
    iso: String,
    klartext: String,
    number: u32,
}

impl Both {
    fn block(&mut self, iso: &str, klartext: &str) {
        writeln!(self.iso, "N{} {iso} *", 10 * self.number + 10).unwrap();
        writeln!(self.klartext, "{} {klartext}", self.number + 1).unwrap();
        self.number += 1;
    }

    fn finished(self) -> (String, String) {
        (
            format!("%A G71 *\n{}N99999999 %A G71 *\n", self.iso),
            format!("0 BEGIN PGM A MM\n{}999 END PGM A MM\n", self.klartext),
        )
    }
}

/// What a run of a program says, without the places and the text of its blocks.
fn said(program: &str) -> (u8, String) {
    let cli = Cli::try_parse_from(["fitcheck", "run", "-", "--format", "json", "--max-blocks", "2000"]).unwrap();
    let (mut out, mut err) = (Vec::new(), Vec::new());
    let code = cli.run(&mut Io::new(&mut program.as_bytes(), &mut out, &mut err));
    let mut answer: Value = serde_json::from_slice(&out).unwrap();
    for list in ["cycles", "faults", "remarks"] {
        for entry in answer[list].as_array_mut().unwrap() {
            for place in ["program", "line", "number", "text"] {
                entry.as_object_mut().unwrap().remove(place);
            }
        }
    }
    let kept: Vec<String> = ["blocks", "status", "parameters", "cycles", "pauses", "faults", "remarks"]
        .iter()
        .map(|name| answer[*name].to_string())
        .collect();
    // Warnings of the reader are no part of the answer.
    let err = String::from_utf8(err).unwrap();
    assert!(!err.contains("not understood"), "{err}{program}");
    (code, kept.join("\n"))
}

/// The parameters of a cycle besides those that several have: those that say where, nominal sizes, limits of size.
type Parameters = (&'static str, &'static [u16], &'static [u16], &'static [u16]);

/// The cycles.
const CYCLES: [Parameters; 7] = [
    ("421", &[273, 274], &[262], &[275, 276]),
    ("422", &[273, 274], &[262], &[277, 278]),
    ("423", &[273, 274], &[282, 283], &[284, 285, 286, 287]),
    ("424", &[273, 274], &[282, 283], &[284, 285, 286, 287]),
    ("425", &[328, 329], &[311], &[288, 289]),
    ("426", &[263, 264, 265, 266], &[311], &[288, 289]),
    ("427", &[263, 264], &[], &[288, 289]),
];

/// A value of a cycle: a number, or the parameter that holds it.
#[derive(Debug, Clone)]
enum CycleNumber {
    Number(String),
    Parameter(u16),
    Missing,
}

/// What a random measurement is made of.
#[derive(Debug, Clone)]
#[expect(clippy::struct_excessive_bools, reason = "each is a choice of its own")]
struct Case {
    cycle: usize,
    places: Vec<i32>,
    size: i32,
    deviations: [i32; 2],
    axis: u8,
    is_positive: bool,
    height: i32,
    moves: bool,
    stops: bool,
    centre: i32,
    three: bool,
    through: Vec<u8>,
    operands: [i32; 3],
    repeats: u32,
    is_called: bool,
    jump: usize,
    is_in_lines: bool,
    tool: u16,
    drop: Option<usize>,
}

fn case() -> impl Strategy<Value = Case> {
    let where_ = (0..CYCLES.len(), prop::collection::vec(-900_000..900_000_i32, 4), 50_000..900_000_i32);
    let how = (prop::array::uniform2(-400..400_i32), 1..=3_u8, any::<bool>(), -300_000..0_i32, any::<bool>());
    let rest = (any::<bool>(), 0..300_i32, any::<bool>(), prop::collection::vec(0..4_u8, 12));
    let program = (prop::array::uniform3(-90_000..90_000_i32), 0..3_u32, any::<bool>(), 0..5_usize, any::<bool>());
    let odd = (select(vec![0_u16, 1, 9, 999]), prop::option::weighted(0.1, 0..12_usize));
    (where_, how, rest, program, odd).prop_map(|(where_, how, rest, program, odd)| Case {
        cycle: where_.0,
        places: where_.1,
        size: where_.2,
        deviations: how.0,
        axis: how.1,
        is_positive: how.2,
        height: how.3,
        moves: how.4,
        stops: rest.0,
        centre: rest.1,
        three: rest.2,
        through: rest.3,
        operands: program.0,
        repeats: program.1,
        is_called: program.2,
        jump: program.3,
        is_in_lines: program.4,
        tool: odd.0,
        drop: odd.1,
    })
}

/// Ten-thousandths of a millimetre, with a sign.
fn decimal(value: i32) -> String {
    format!("{}{}.{:04}", if value < 0 { '-' } else { '+' }, value.abs() / 10_000, value.abs() % 10_000)
}

impl Case {
    /// The parameters with their values.
    fn values(&self) -> Vec<(u16, i32)> {
        let (code, places, sizes, limits) = CYCLES[self.cycle];
        let mut values: Vec<(u16, i32)> = Vec::new();
        values.extend(places.iter().copied().zip(self.places.iter().copied()));
        values.extend(sizes.iter().map(|&key| (key, self.size)));
        let nominal = if code == "427" { self.places[0] } else { self.size };
        let [a, b] = self.deviations;
        values.extend(
            limits
                .iter()
                .enumerate()
                .map(|(index, &key)| (key, nominal + if index % 2 == 0 { a.max(b) } else { a.min(b) })),
        );
        let whole = |number: u8| i32::from(number) * 10_000;
        values.extend([(261, self.height), (320, 10_000), (260, 500_000), (281, 0), (309, whole(self.stops.into()))]);
        if matches!(code, "421" | "422") {
            values.extend([(325, 0), (247, 900_000), (423, whole(if self.three { 3 } else { 4 }))]);
        }
        if ["421", "422", "423", "424"].contains(&code) {
            values.extend([(279, self.centre), (280, 0)]);
        }
        if code != "427" {
            values.push((301, whole(self.moves.into())));
        }
        if ["425", "426", "427"].contains(&code) {
            values.push((272, whole(if code == "427" { self.axis } else { 1 + self.axis % 2 })));
        }
        if code == "427" {
            values.push((267, if self.is_positive { 10_000 } else { -10_000 }));
        }
        values
    }

    fn programs(&self) -> (String, String) {
        let mut both = Both::default();
        let [a, b, c] = self.operands.map(decimal);
        both.block(&format!("D00 Q1 P01 {a}"), &format!("FN 0: Q1 = {a}"));
        both.block(&format!("D01 Q2 P01 +Q1 P02 {b}"), &format!("FN 1: Q2 = +Q1 + {b}"));
        both.block(&format!("D02 Q3 P01 {c} P02 -Q2"), &format!("FN 2: Q3 = {c} - -Q2"));
        both.block("D03 Q4 P01 +Q1 P02 +Q3", "FN 3: Q4 = +Q1 * +Q3");
        both.block("D04 Q5 P01 +Q4 P02 +7", "FN 4: Q5 = +Q4 DIV +7");
        both.block("D08 Q6 P01 +Q1 P02 +Q2", "FN 8: Q6 = +Q1 LEN +Q2");
        both.block("D05 Q7 P01 +Q6", "FN 5: Q7 = SQRT +Q6");
        both.block("D06 Q8 P01 +Q1", "FN 6: Q8 = SIN +Q1");
        both.block("D13 Q9 P01 +Q1 P02 +Q2", "FN 13: Q9 = +Q1 ANG +Q2");
        both.block("Q10 = SQ Q8 + COS Q1 * ( Q7 - 3 )", "Q10 = SQ Q8 + COS Q1 * ( Q7 - 3 )");
        both.block(&format!("T{} G17 S50", self.tool), &format!("TOOL CALL {} Z S50", self.tool));
        both.block("G00 G40 G90 X+0 Y+0 Z+100", "L X+0 Y+0 Z+100 R0 FMAX");
        both.block("G01 G91 X+1.5 F500 M5", "L IX+1.5 F500 M5");
        let given: Vec<(u16, CycleNumber)> = self.given(&mut both);
        if self.is_called {
            both.block("L5,0", "CALL LBL 5");
            both.block("M30", "M30");
            both.block("G98 L5", "LBL 5");
        } else {
            both.block("G98 L5", "LBL 5");
        }
        self.cycle(&mut both, &given);
        both.block("Q60 = Q60 + Q180 + 2 * Q181", "Q60 = Q60 + Q180 + 2 * Q181");
        let (d, word) = [("09", "EQU"), ("10", "NE"), ("11", "GT"), ("12", "LT"), ("09", "EQU")][self.jump];
        let fn_number = d.trim_start_matches('0');
        both.block(
            &format!("D{d} P01 +Q182 P02 +Q1 P03 7"),
            &format!("FN {fn_number}: IF +Q182 {word} +Q1 GOTO LBL 7"),
        );
        both.block("D00 Q61 P01 +Q60", "FN 0: Q61 = +Q60");
        both.block("G98 L7", "LBL 7");
        if !self.is_called && 0 < self.repeats {
            both.block(&format!("L5,{}", self.repeats), &format!("CALL LBL 5 REP {}", self.repeats));
        }
        if self.jump == 4 {
            both.block("D14 P01 1072", "FN 14: ERROR= 1072");
        }
        both.block("G98 L0", "LBL 0");
        both.finished()
    }

    /// The values as the cycle gets them; those that a parameter holds are assigned before.
    fn given(&self, both: &mut Both) -> Vec<(u16, CycleNumber)> {
        let mut given = vec![];
        both.block("D00 Q60 P01 +0", "FN 0: Q60 = +0");
        for (index, (key, value)) in self.values().into_iter().enumerate() {
            let text = decimal(value);
            let holder = 20 + u16::try_from(index).unwrap();
            let way = self.through.get(index).copied().unwrap_or(0);
            match way {
                _ if self.drop == Some(index) => given.push((key, CycleNumber::Missing)),
                1 => {
                    both.block(&format!("D00 Q{holder} P01 {text}"), &format!("FN 0: Q{holder} = {text}"));
                    given.push((key, CycleNumber::Parameter(holder)));
                }
                2 => {
                    let formula = format!("Q{holder} = 3 * {text} - {text} * 2");
                    both.block(&formula, &formula);
                    given.push((key, CycleNumber::Parameter(holder)));
                }
                _ => given.push((key, CycleNumber::Number(text))),
            }
        }
        given
    }

    fn cycle(&self, both: &mut Both, given: &[(u16, CycleNumber)]) {
        let code = CYCLES[self.cycle].0;
        let words: Vec<String> = given
            .iter()
            .filter_map(|(key, given)| match given {
                CycleNumber::Number(text) => Some(format!("Q{key}={text}")),
                CycleNumber::Parameter(holder) => Some(format!("Q{key}=+Q{holder}")),
                CycleNumber::Missing => None,
            })
            .collect();
        let lines: Vec<String> = words.iter().map(|word| format!("    {word} ;X")).collect();
        let iso = if self.is_in_lines {
            format!("G{code} ~\n{}", lines.join(" ~\n"))
        } else {
            format!("G{code} {}", words.join(" "))
        };
        both.block(&iso, &format!("TCH PROBE {code} X ~\n{}", lines.join(" ~\n")));
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1000))]

    #[test]
    fn a_measurement_is_the_same_in_both(case in case()) {
        let (iso, klartext) = case.programs();
        let (found, wanted) = (said(&iso), said(&klartext));
        prop_assert_eq!(&found, &wanted, "{}\n{}", iso, klartext);
    }
}

/// That the cases above are measurements and not only faults.
#[test]
fn the_random_measurements_have_every_status() {
    use proptest::strategy::ValueTree as _;
    use proptest::test_runner::TestRunner;
    let mut runner = TestRunner::deterministic();
    let mut codes = [0_usize; 4];
    for _ in 0..200 {
        let case = case().new_tree(&mut runner).unwrap().current();
        let index = match said(&case.programs().0).0 {
            0 => 0,
            10 => 1,
            11 => 2,
            _ => 3,
        };
        codes[index] += 1;
    }
    assert!(codes.iter().all(|count| 5 < *count), "good, rework, scrap, faults: {codes:?}");
}
