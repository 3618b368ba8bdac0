//! ISO programs: every form, with the block of Klartext that says the same; what is refused, with line and column.

use fitcheck::nc::program::{
    Axis, AxisWord, Body, CycleBlock, CycleLine, Frame, Goes, MachineFunction, Notation, Operand, PassedOver, Program,
    Target, TextPlace, Unit,
};
use proptest::prelude::*;
use proptest::sample::select;

const NOWHERE: TextPlace = TextPlace { line: 0, column: 0 };

fn without_places(mut body: Body) -> Body {
    if let Body::Probe(cycle) | Body::CycleDefinition(cycle) | Body::GlobalDefinition(cycle) = &mut body {
        for line in &mut cycle.lines {
            line.place = NOWHERE;
            line.comment.clear();
        }
        cycle.name.clear();
    }
    body
}

/// The bodies of a program and its warnings.
#[track_caller]
fn read(text: &str) -> (Vec<Body>, Vec<String>) {
    let (program, warnings) = Program::read(text.as_bytes()).unwrap();
    assert_eq!(program.write(), text.as_bytes());
    let bodies = program.blocks().iter().map(|block| without_places(block.body.clone())).collect();
    (bodies, warnings.iter().map(ToString::to_string).collect())
}

/// The bodies of blocks in a program where G90 is in force.
#[track_caller]
fn blocks(blocks: &str) -> (Vec<Body>, Vec<String>) {
    let (mut bodies, warnings) = read(&format!("%A G71 *\nN1 G90 *\n{blocks}\nN99999999 %A G71 *\n"));
    bodies.pop();
    (bodies.split_off(2), warnings)
}

#[track_caller]
fn body(block: &str) -> Body {
    let (mut bodies, warnings) = blocks(block);
    assert_eq!((bodies.len(), warnings), (1, Vec::new()), "{block}: {bodies:?}");
    bodies.remove(0)
}

/// A block of Klartext that says the same.
#[track_caller]
fn same(iso: &str, klartext: &str) {
    let (mut bodies, warnings) = read(&format!("BEGIN PGM A MM\n{klartext}\nEND PGM A MM\n"));
    assert_eq!(warnings, Vec::<String>::new(), "{klartext}");
    assert_eq!(body(iso), bodies.remove(1), "{iso}");
}

#[track_caller]
fn passed_over(block: &str, words: &str, is_unknown: bool, axes: &[(Axis, f64)]) {
    let axes =
        axes.iter().map(|&(axis, value)| AxisWord { axis, is_incremental: false, value: Operand::Number(value) });
    let goes = Goes { is_unknown, axes: axes.collect() };
    let wanted = PassedOver { words: words.to_owned(), goes, machine: Vec::new() };
    assert_eq!(body(block), Body::PassedOver(wanted), "{block}");
}

/// A block that is kept as text, with a warning.
#[track_caller]
fn refused(block: &str, wanted: &str) {
    let (bodies, warnings) = blocks(block);
    assert_eq!(warnings, [wanted], "{block}: {bodies:?}");
    assert!(bodies.contains(&Body::Other), "{block}: {bodies:?}");
}

#[test]
fn the_frame_says_name_and_unit() {
    for (text, name, unit) in [
        ("%FIT_ISO G71 *\nN99999999 %FIT_ISO G71 *\n", "FIT_ISO", Unit::Mm),
        ("\u{feff}%1 G70 *\r\nN9999 %1 G70\r\n", "1", Unit::Inch),
        ("; made by hand\n\n % A B g71*\nN99999999 %A B g71*", "A B", Unit::Mm),
        ("N0 %A G71 *\nN1 %A G71 *", "A", Unit::Mm),
    ] {
        let (program, warnings) = Program::read(text.as_bytes()).unwrap();
        assert!(warnings.is_empty(), "{text}: {warnings:?}");
        assert_eq!((program.notation(), program.name(), program.unit()), (Notation::Iso, Some(name), Some(unit)));
        let end = Body::End { name: name.to_owned(), unit };
        assert_eq!(program.blocks().last().map(|block| &block.body), Some(&end));
        assert_eq!(program.write(), text.as_bytes());
    }
    for text in ["%A *\nN1 M30 *", "% G71 A", "0 BEGIN PGM G71 MM\n", "G71", "%lathe.nc\n", "%lathe.nc \"TURN_V1.0\"\n"]
    {
        assert_ne!(Program::read(text.as_bytes()).unwrap().0.notation(), Notation::Iso, "{text}");
    }
    assert_eq!(
        read("%A G71 *\nN1 M3 *\n").1,
        ["line 2, column 1: the last block is missing: % with the name of the program"]
    );
    assert_eq!(read("%A G71 *\nN1 %A G70 *\n").1, ["line 2, column 1: the last block says INCH, the first MM"]);
    let behind = "line 3, column 1: text after the last block is not part of the program";
    assert_eq!(read("%A G71 *\nN1 %A G71 *\nN2 M30 *\nN3 M30 *\n").1, [behind]);
    let order = "line 3, column 1: block number 10 follows 10; block numbers out of order: 2";
    assert_eq!(read("%A G71 *\nN10 M3 *\nN10 M4 *\nN5 M5 *\nN99999999 %A G71 *\n").1, [order]);
}

#[test]
fn block_numbers_skip_marks_and_comments() {
    let text =
        "%A G71 *\n/N10 M8 *\nN20 /M9 * ;off\nN30 ;18 K7 *\n;alone\nN40 *\n*\nM5*\nN50 M3 ;on *\nN99999999 %A G71 *";
    let (program, warnings) = Program::read(text.as_bytes()).unwrap();
    assert!(warnings.is_empty(), "{warnings:?}");
    let blocks = program.blocks();
    let front: Vec<_> = blocks.iter().map(|block| (block.number, block.may_be_skipped)).collect();
    let numbers = [(Some(10), true), (Some(20), true), (Some(30), false), (None, false), (Some(40), false)];
    assert_eq!(front[1..6], numbers);
    let nothing = blocks.iter().filter(|block| block.body == Body::Nothing).count();
    assert_eq!((blocks.len(), nothing), (10, 4));
    let comments: Vec<_> = (0..blocks.len()).map(|block| program.comment_of(block)).collect();
    assert_eq!(comments[2..5], [Some("off"), Some("18 K7"), Some("alone")]);
    assert_eq!(comments[8], Some("on"));
    assert_eq!(body("N10 * - finishing *"), Body::Heading { depth: 1, text: "finishing".to_owned() });
}

#[test]
fn d_functions_are_those_of_fn() {
    for (iso, klartext) in [
        ("N10 D00 Q05 P01 +60 *", "FN 0: Q5 = +60"),
        ("D00 Q1 P01 -Q2 *", "FN 0: Q1 = -Q2"),
        ("D0QR1P01+1,5*", "FN 0: QR1 = +1,5"),
        ("D01 Q1 P01 -Q2 P02 -5 *", "FN 1: Q1 = -Q2 + -5"),
        ("D02 Q1 P01 +10 P02 +QL5 *", "FN 2: Q1 = +10 - +QL5"),
        ("D03 Q2 P01 +3 P02 +3 *", "FN 3: Q2 = +3 * +3"),
        ("D04 Q4 P01 +4 P02 +Q2 *", "FN 4: Q4 = +4 DIV +Q2"),
        ("D05 Q20 P01 +4 *", "FN 5: Q20 = SQRT +4"),
        ("D06 Q20 P01 -Q5 *", "FN 6: Q20 = SIN -Q5"),
        ("D07 Q20 P01 +30.5 *", "FN 7: Q20 = COS +30.5"),
        ("D08 Q10 P01 +5 P02 +4 *", "FN 8: Q10 = +5 LEN +4"),
        ("D13 Q10 P01 +10 P02 -Q1 *", "FN 13: Q10 = +10 ANG -Q1"),
        ("D09 P01 +Q1 P02 +Q3 P03 5 *", "FN 9: IF +Q1 EQU +Q3 GOTO LBL 5"),
        ("D10 P01 +10 P02 -Q5 P03 10 *", "FN 10: IF +10 NE -Q5 GOTO LBL 10"),
        ("D11 P01+Q1 P02+10 P03 5*", "FN 11: IF +Q1 GT +10 GOTO LBL 5"),
        ("D12 P01 +Q5 P02 +0 P03 1 *", "FN 12: IF +Q5 LT +0 GOTO LBL 1"),
        ("D14 P01 1072 *", "FN 14: ERROR= 1072"),
        ("D14 P01 +Q50 *", "FN 14: ERROR= +Q50"),
        ("Q1 = Q2 + 3 *", "Q1 = Q2 + 3"),
        ("Q1 = Q2 * 3*", "Q1 = Q2 * 3"),
        ("Q1=SIN 30*(Q2-Q3)^2 *;area", "Q1 = SIN 30 * (Q2 - Q3)^2"),
        ("QS1 = \"a;b\" || QS2 *", "QS1 = \"a;b\" || QS2"),
        ("D18 Q2 ID50 NR19 IDXQ1 *", "FN 18: SYSREAD Q2 = ID50 NR19 IDXQ1"),
        ("D18 Q2 P01 1 *", "FN 18: SYSREAD Q2 = P01 1"),
        ("D16 F-PRINT a.a/b.txt *", "FN 16: F-PRINT a.a / b.txt"),
        ("D16 P01 F-PRINT a.a/SCREEN: *", "FN 16: F-PRINT a.a / SCREEN:"),
    ] {
        same(iso, klartext);
    }
    for number in ["D19", "D20", "D29"] {
        passed_over(&format!("{number} P01 +Q1 *"), number, false, &[]);
    }
}

#[test]
fn labels_calls_and_programs() {
    same("N190 G98 L2 *", "LBL 2");
    same("G98L0*", "LBL 0");
    same("L1,0 *", "CALL LBL 1");
    same("N5 L 12 , 2 *", "CALL LBL 12 REP 2");
    same("%SUB *", "CALL PGM SUB");
    same("N10 %TNC:\\fit\\sub.i *", "CALL PGM TNC:\\fit\\sub.i");
    let (program, _) = Program::read(b"%A G71 *\nG98 L7 *\nG98 L0 *\n%A G71 *").unwrap();
    assert_eq!(program.label(&Target::Number(7)), Ok(1));
}

#[test]
fn tools_and_planes_have_their_axis() {
    same("T5 G17 S2500 DL+0.2 *", "TOOL CALL 5 Z S2500 DL+0.2");
    same("N80 T5 G17 S3000 DR+0.02 *", "TOOL CALL 5 Z S3000 DR+0.02");
    same("S50 G18 T12.1 DR2+0.1 *", "TOOL CALL 12.1 Y S50 DR2+0.1");
    same("T+Q5 G19 *", "TOOL CALL +Q5 X");
    same("T\"PROBE;1\" G17 *", "TOOL CALL \"PROBE;1\" Z");
    same("T0 *", "TOOL CALL 0");
    same("G17 *", "TOOL CALL Z");
    same("S5000 *", "TOOL CALL S5000");
    passed_over("N40 G99 T5 L+10 R+5 *", "G99", false, &[]);
    passed_over("G51 T7 *", "G51", false, &[]);
    let Body::PassedOver(speed) = body("S3000 M3 *") else { panic!() };
    assert_eq!(speed.machine, [MachineFunction { number: 3, rest: String::new() }]);
}

#[test]
fn straight_lines_are_moves() {
    same("N90 G00 G40 G90 Z+100 M3 *", "L Z+100 R0 FMAX M3");
    same("G01 X+20 Y+0 F500 *", "L X+20 Y+0 F500");
    same("G1X-Q1Y.5FQ2M8M99*", "L X-Q1 Y.5 FQ2 M8 M99");
    same("M3 G00 G41 X+5 *", "L X+5 RL FMAX M3");
    same("G01 G42 A+5 B-5 C+Q1 *", "L A+5 B-5 C+Q1 RR");
    same("G01 G91 Z-5 *", "L IZ-5");
    same("G00 X+0 M140 MB MAX *", "L X+0 FMAX M140 MB MAX");
    same("G00 X+0 M140 MB+50 M91 *", "L X+0 FMAX M140 MB+50 M91");
    same("M30 *", "M30");
    same("M5 M9 *", "M5 M9");
    same("G38 *", "STOP");
    same("G38 M6 *", "STOP M6");
}

#[test]
fn g90_g91_and_the_kind_of_path_stay_in_force() {
    let lines = |klartext: &str| read(&format!("BEGIN PGM A MM\n{klartext}\nEND PGM A MM\n")).0;
    let iso = "G00 G90 X+1 *\nY+2 *\nG01 G91 X+3 F100 *\nZ+4 *\nG90 *\nZ+5 *";
    let klartext = "L X+1 FMAX\nL Y+2 FMAX\nL IX+3 F100\nL IZ+4\nM1\nL Z+5";
    let (bodies, warnings) = blocks(iso);
    let wanted = lines(klartext);
    assert_eq!(warnings, Vec::<String>::new());
    assert_eq!((&bodies[..4], &bodies[5]), (&wanted[1..5], &wanted[6]));
    // After an arc, the next place is again on a path that is not followed, and known.
    let (bodies, _) = blocks("G02 X+1 Y+1 I+0 J+0 *\nX+5 Y+7 *");
    let Body::PassedOver(arc) = &bodies[1] else { panic!() };
    assert_eq!((arc.words.as_str(), arc.goes.axes.len(), arc.goes.is_unknown), ("X Y", 2, false));
}

#[test]
fn where_the_way_to_a_block_decides_g90_or_g91_must_be_written() {
    let unknown = |line: usize, column: usize| {
        format!("line {line}, column {column}: not understood: it is not known whether G90 or G91 is active here")
    };
    assert_eq!(read("%A G71 *\nG00 X+1 *\n%A G71 *").1, [unknown(2, 5)]);
    // A program without G91 has no doubt behind its labels.
    assert_eq!(blocks("G98 L1 *\nG01 X+5 *\nL1,2 *\nX+5 *").1, Vec::<String>::new());
    // One with G91 anywhere has: the label may be reached with either.
    assert_eq!(blocks("G98 L1 *\nG01 X+5 *\nG91 Y+5 *\nL1,2 *").1, [unknown(4, 5)]);
    assert_eq!(blocks("G98 L1 *\nG01 G90 X+5 *\nG91 Y+5 *\nL1,2 *").1, Vec::<String>::new());
    assert_eq!(blocks("L5,0 *\nG01 X+5 *\nG98 L5 *\nG91 *\nG98 L0 *").1, [unknown(4, 5)]);
    assert_eq!(blocks("%SUB *\nG01 X+5 *").1, [unknown(4, 5)]);
    assert_eq!(blocks("/G91 *\nG01 X+5 *").1, [unknown(4, 5)]);
    assert_eq!(blocks("/G90 *\nG01 X+5 *").1, Vec::<String>::new());
    let (_, warnings) = blocks("G91 G777 *\nG01 X+5 *");
    assert_eq!(warnings, ["line 3, column 5: not understood: G777 is not known".to_owned(), unknown(4, 5)]);
    assert_eq!(blocks("G54 G91 X+5 *\nG01 X+5 *").1, [unknown(4, 5)]);
    assert_eq!(blocks("G54 G90 X+5 *\nG01 X+5 *").1, Vec::<String>::new());
    assert_eq!(blocks("G91 *\nG54 X+5 *").1, [unknown(4, 5)]);
    assert_eq!(blocks("G91 *\nG73 H+5 *").1, [unknown(4, 1)]);
    // Behind a repeat nothing has changed but by the blocks before it.
    assert_eq!(blocks("G98 L1 *\nG01 G91 X+5 *\nL1,2 *\nX+5 *").1, Vec::<String>::new());
}

#[test]
fn paths_that_are_not_followed_end_where_it_is_written() {
    let xy = [(Axis::X, 0.0), (Axis::Y, 20.0)];
    for function in ["G02", "G03", "G05", "G06"] {
        passed_over(&format!("{function} X+0 Y+20 *"), function, false, &xy);
        passed_over(&format!("I+1 J-2 {function} X+0 Y+20 R+5 F100 *"), function, false, &xy);
    }
    passed_over("G7 X+0 *", "G07", false, &xy[..1]);
    for function in ["G10", "G11", "G12", "G13", "G15", "G16"] {
        passed_over(&format!("{function} R+5 H+30 *"), function, true, &[]);
        passed_over(&format!("{function} H-30 Z+5 *"), function, true, &[(Axis::Z, 5.0)]);
    }
    assert_eq!(blocks("G11 R+5 H+30 *\nH+60 *").1, Vec::<String>::new());
    for (block, words) in [
        ("I+0 J+0 *", "I J"),
        ("N5 K-5 *", "K"),
        ("G29 *", "G29"),
        ("G24 R5 *", "G24"),
        ("G25 R5 F100 *", "G25"),
        ("G04 F5 *", "G04"),
        ("N10 G30 G17 X-50 Y-50 Z-30 *", "G30"),
        ("N20 G31 G90 X+50 Y+50 Z+0 *", "G31"),
        ("G36 S90 *", "G36"),
        ("G62 T0.05 *", "G62"),
        ("G40 *", "G40"),
        ("G90 *", "G90"),
        ("F500 *", "F"),
    ] {
        passed_over(block, words, false, &[]);
    }
    for (block, words) in [("G26 R5 *", "G26"), ("G27 R5 F500 *", "G27"), ("G79 *", "G79")] {
        passed_over(block, words, true, &[]);
    }
    let Body::PassedOver(call) = body("G79 M3 *") else { panic!() };
    assert_eq!(call.machine.len(), 1);
}

#[test]
fn changes_of_the_system_are_those_of_klartext() {
    same("G54 X+60 Y+40 *", "CYCL DEF 7.1 X+60 Y+40");
    same("G54 G91 X+5 *", "CYCL DEF 7.1 IX+5");
    same("G53 P01 5 *", "CYCL DEF 7.1 #5");
    same("G28 X Y *", "CYCL DEF 8.1 X Y");
    same("G72 F0.99 *", "CYCL DEF 11.1 SCL 0.99");
    same("G73 G90 H+30 *", "CYCL DEF 10.1 ROT+30");
    same("G73 G91 H+30 *", "CYCL DEF 10.1 IROT+30");
    same("G80 A+0 B-90 C+Q1 *", "CYCL DEF 19.1 A+0 B-90 C+Q1");
    same("N10 G247 Q339=+1 *", "CYCL DEF 247 PRESET ~\nQ339=+1");
    assert_eq!(body("G80 *"), Body::Frame(Frame::Tilt { angles: Vec::new(), axes_stay: true }));
    assert_eq!(body("G28 *"), Body::Frame(Frame::Mirror(Vec::new())));
}

#[test]
fn cycles_have_their_words_in_one_line_or_in_several() {
    let klartext = "TCH PROBE 421 HOLE ~\nQ273=+40 ~\nQ274=+Q5 ~\nQ320=PREDEF ~\nQ275=25.021";
    for iso in [
        "N60 G421 Q273=+40 Q274=+Q5 Q320=PREDEF Q275=25.021 *",
        "G421Q273=+40Q274=+Q5Q320=PREDEF Q275=25.021*",
        "N60 G421 MEASURE HOLE ~\n  Q273=+40 ;CENTRE ~\n\n  Q274= + Q5 ;CENTRE ~\n  Q320= PREDEF ~\n  Q275=25.021 ;LIMIT *",
        "N60 G421 ~\n  Q273=+40 ;CENTRE ~\n  Q274=+Q5 ~\n  Q320=PREDEF ~\n  Q275=25.021 ;LIMIT\n*",
        "N60 G421\nQ273=+40 ;CENTRE\nQ274=+Q5\nQ320=PREDEF\nQ275=25.021 *",
        "N60 G421 Q273=+40 Q274=+Q5 ~\n Q320=PREDEF Q275=25.021 *",
    ] {
        same(iso, klartext);
    }
    same("G0421 Q275=5 *", "TCH PROBE 421 A ~\nQ275=5");
    for number in ["421", "422", "423", "424", "425", "426", "427", "444", "431"] {
        let Body::Probe(cycle) = body(&format!("G{number} Q1=5 *")) else { panic!("{number}") };
        assert_eq!(cycle.number, number);
    }
    same("N60 G200 Q200=2 Q201=-15 *", "CYCL DEF 200 DRILLING ~\nQ200=2 ~\nQ201=-15");
    same("G444 QS400=\"0.1;*\" Q263=+5 *", "TCH PROBE 444 A ~\nQS400=\"0.1;*\" ~\nQ263=+5");
    let text = "%A G71 *\nN1 G421 HOLE Q273=+40 Q274=+5 ~\n  Q275=5 *\nN99999999 %A G71 *";
    let (program, _) = Program::read(text.as_bytes()).unwrap();
    let Body::Probe(CycleBlock { name, lines, .. }) = &program.blocks()[1].body else { panic!() };
    let places: Vec<(usize, usize)> = lines.iter().map(|CycleLine { place, .. }| (place.line, place.column)).collect();
    assert_eq!((name.as_str(), places), ("HOLE", vec![(2, 14), (2, 23), (3, 3)]));
    assert_eq!(program.blocks()[1].lines, 1..3);
}

#[test]
fn global_values_are_lines_of_klartext() {
    let klartext = "GLOBAL DEF 120 PROBING ~\nQ320=+1 ~\nQ260=+50 ~\nQ301=+0";
    for iso in [
        "GLOBAL DEF 120 PROBING ~\n    Q320=+1    ;SET-UP CLEARANCE ~\n    Q260=+50 ~\n    Q301=+0    ;MOVE",
        "N5 GLOBAL DEF 120 ~\nQ320=+1 ~\nQ260=+50 ~\nQ301=+0 *",
        "N5 GLOBAL DEF 120 PROBING Q320=+1 Q260=+50 Q301=+0 *",
    ] {
        let Body::GlobalDefinition(cycle) = body(iso) else { panic!("{iso}") };
        let lines: Vec<_> = cycle.lines.iter().map(|line| line.parameter.to_string()).collect();
        assert_eq!((cycle.number.as_str(), lines.join(" ").as_str()), ("120", "Q320 Q260 Q301"), "{iso}");
    }
    if Program::read(format!("BEGIN PGM A MM\n{klartext}\nEND PGM A MM").as_bytes()).unwrap().0.blocks()[1].body
        != Body::Other
    {
        same("GLOBAL DEF 120 PROBING ~\nQ320=+1 ~\nQ260=+50 ~\nQ301=+0", klartext);
    }
}

#[test]
fn what_is_not_understood_says_what_was_found() {
    let not = |column: usize, what: &str| format!("line 3, column {column}: not understood: {what}");
    for (block, column, what) in [
        ("G55 *", 1, "the ISO form of G55 is not known"),
        ("N10 G39 P01 12 *", 5, "the ISO form of G39 is not known"),
        ("D15 P01 +Q1 *", 2, "the ISO form of D15 is not known"),
        ("D26 P01 a.tab *", 2, "the ISO form of D26 is not known"),
        ("D26 TABOPEN a.tab *", 2, "the ISO form of D26 is not known"),
        ("N7 D28 Q1 *", 5, "the ISO form of D28 is not known"),
        ("G83 P01 5 *", 1, "G83 is not known"),
        ("N10 G00 X+5 G777 *", 13, "G00 and G777 cannot be in the same block"),
        ("G120 Q1=5 *", 6, "Q1=5 is not known"),
        ("L1 *", 3, ", is missing"),
        ("L1,Q5 *", 4, "expected a number, found Q5"),
        ("L65536,0 *", 2, "65536,0 is too large: at most 65535"),
        ("G98 *", 4, "L is missing"),
        ("G98 L\"UP\" *", 6, "expected a label, found \"UP\""),
        ("D00 Q1 P02 +5 *", 8, "expected P01, found P02"),
        ("D00 Q1 +5 *", 8, "expected P01, found +5"),
        ("D00 P01 +5 *", 5, "expected a Q, QL or QR parameter, found P01"),
        ("D01 Q1 P01 +5 *", 14, "P02 is missing"),
        ("D01 Q1 P01 +5 P02 +6 P03 7 *", 22, "unexpected text P03"),
        ("D00 Q1 P01 QS5 *", 12, "expected a number or a Q parameter, found QS5"),
        ("D09 P01 +Q1 P02 +1 P03 Q5 *", 24, "expected a label, found Q5"),
        ("D09 P01 +Q1 P03 5 *", 13, "expected P02, found P03"),
        ("Q1 = 5 6 *", 8, "unexpected text 6"),
        ("Q2000 = 5 *", 1, "Q2000 is not a parameter: Q goes from 0 to 1999"),
        ("G00 X+5 X+6 *", 9, "an axis is given twice"),
        ("G01 F5 X+1 F6 *", 12, "F and F cannot be in the same block"),
        ("G00 G01 X+5 *", 5, "G00 and G01 cannot be in the same block"),
        ("G90 G91 X+5 *", 5, "G90 and G91 cannot be in the same block"),
        ("G01 X+5 G91 Y+6 *", 9, "unexpected text G91"),
        ("G40 G41 *", 5, "G40 and G41 cannot be in the same block"),
        ("G00 G17 X+5 *", 5, "G00 and G17 cannot be in the same block"),
        ("G54 G40 X+5 *", 5, "G54 and G40 cannot be in the same block"),
        ("G54 *", 1, "a number or a Q parameter is missing"),
        ("G28 X+5 *", 5, "unexpected text +"),
        ("G72 *", 1, "F is missing"),
        ("G73 F5 *", 5, "unexpected text F"),
        ("G01 X+5 R+3 *", 9, "unexpected text R"),
        ("G01 X+5 T3 *", 9, "unexpected text T"),
        ("G00 X *", 5, "a number or a Q parameter is missing"),
        ("G00 X+5 * N20 G00 Y+5 *", 9, "* is not known"),
        ("G00 X+5 ** ", 9, "* is not known"),
        ("G00 X+5 M118 X1 *", 14, "an axis is given twice"),
        ("M128 F100 G01 *", 0, ""),
        ("T5 T6 *", 4, "T6 is not known"),
        ("T5 G17 M6 *", 8, "unexpected text M"),
        ("T5 G17 X+5 *", 4, "unexpected text G17"),
        ("T *", 2, "a number or a Q parameter is missing"),
        ("H+5 *", 1, "unexpected text H"),
        ("E5 *", 1, "E5 is not known"),
        ("G00 XX5 *", 6, "an axis is given twice"),
        ("5 G00 X5 *", 1, "5 is not known"),
        ("N99999999999 M3 *", 1, "N99999999999 is not known"),
        ("TOOL CALL 5 Z *", 2, "expected a number or a Q parameter, found OOL"),
        ("CALL PGM A *", 4, "expected a number or a Q parameter, found L"),
        ("G421 Q273 *", 10, "= is missing"),
        ("G421 Q273 +40 Q274=5 *", 11, "expected =, found +40"),
        ("G421.5 Q274=5 *", 5, ".5 is not known"),
        ("G421 X+5 Q274=5 *", 6, "unexpected text X+5"),
        ("G421 HOLE Q2000=5 *", 11, "Q2000=5 is not a parameter: Q goes from 0 to 1999"),
        ("G421 Q273=* *", 11, "expected a value, found *"),
        ("G421 Q273=+5 M99 *", 14, "expected a parameter, found M99"),
        ("G421 Q273=+5 * ~", 1, "unexpected text ~"),
        ("G421 Q273=+5 ;X ~ *", 1, "unexpected text ~"),
        ("GLOBAL DEF 120 A ~\n Q320=1 ;X ~*", 0, "4 2"),
        ("* * - text *", 1, "unexpected text *"),
    ] {
        if what == "4 2" {
            refused(block, "line 4, column 2: not understood: unexpected text ~");
        } else if what.is_empty() {
            assert_eq!(blocks(block).1, Vec::<String>::new());
        } else {
            refused(block, &not(column, what));
        }
    }
    refused("T\"A *", "line 3, column 2: the quotation mark is not closed");
    let long = format!("G01 X+5 F{}1 *", "0".repeat(70_000));
    refused(&long, "line 3, column 1: not understood: the block has more than 65536 characters");
}

#[test]
fn a_missing_star_is_refused_and_takes_no_other_block_with_it() {
    let star = |line: usize, column: usize| format!("line {line}, column {column}: the block does not end in *");
    let (bodies, warnings) = blocks("N10 G00 X+5\nN20 M3 *");
    assert_eq!((bodies.len(), warnings), (2, vec![star(3, 12)]));
    assert_eq!((&bodies[0], matches!(bodies[1], Body::MachineFunctions(_))), (&Body::Other, true));
    // The next line has no number: it may be one of the same block.
    let (bodies, warnings) = blocks("G00 X+5\nY+6 *\nM3 *");
    assert_eq!((bodies.len(), &bodies[0]), (2, &Body::Other));
    assert_eq!(warnings, ["line 4, column 1: not understood: unexpected text Y+6"]);
    // A comment, blank lines and a skip mark.
    assert_eq!(blocks("N10 Q1 = 5 * 3\n\n;then\n/M3 *").1, [star(5, 1)]);
    assert_eq!(blocks("N10 Q1 = 5 ;five\n%SUB *").1, [star(3, 11)]);
    assert_eq!(blocks("N10 M3\nGLOBAL DEF 120 P ~\nQ320=1").1, [star(3, 7)]);
    let text = "%A G71 *\nN1 M3";
    assert_eq!(
        read(text).1,
        ["line 2, column 1: the last block is missing: % with the name of the program".to_owned(), star(2, 6)]
    );
    // The search for it ends.
    let many = format!("G421 Q1=5\n{}", "Q2=5\n".repeat(2000));
    let (bodies, warnings) = blocks(&many);
    assert_eq!((bodies.len(), bodies.iter().all(|body| *body == Body::Other), warnings.len()), (5, true, 5));
}

#[test]
fn a_cycle_that_is_cut_off_is_refused() {
    let star = |line: usize, column: usize| format!("line {line}, column {column}: the block does not end in *");
    let cycle = "N10 G421 ~\n  Q273=+40 ~\n  Q274=+30 ~";
    assert_eq!(blocks(&format!("{cycle}\nN20 M3 *")).1, [star(5, 11)]);
    assert_eq!(blocks(&format!("{cycle}\n  Q275=+5\nN20 M3 *")).1, [star(6, 10)]);
    assert_eq!(
        blocks("N5 GLOBAL DEF 120 A ~\nN20 M3 *").1,
        ["line 3, column 20: the line ends in ~, but nothing follows"]
    );
    // The * comes too early: what follows would be an assignment.
    let cut = "line 4, column 1: cycle 421 ended in line 3: Q275 is not part of it and would be assigned instead";
    refused("N10 G421 Q273=+40 Q274=+30 *\nQ275=+25.01 *", cut);
    refused("G421 Q273=+40 Q274=+30 *\nQ275=+25.01 *", cut);
    let comment = "line 5, column 1: cycle 421 ended in line 3: Q20 is not part of it and would be assigned instead";
    refused("N10 G421 Q273=+40 *\n;still here *\nQ20=+25.01 *", comment);
    let (bodies, warnings) = blocks("N10 G421 Q273=+40 *\nN20 Q275=+25.01 *");
    assert!(matches!(bodies[1], Body::Assign { .. }));
    assert_eq!(
        warnings,
        ["line 4, column 5: cycle 421 ended in line 3: Q275 is not part of it and would be assigned instead"]
    );
    for block in [
        "N10 G421 Q273=+40 *\nN20 Q40 = Q153 *",
        "G421 Q273=+40 *\nQ40 = Q153 *",
        "N10 G421 Q273=+40 *\nN20 D00 Q275 P01 +5 *",
    ] {
        assert_eq!(blocks(block).1, Vec::<String>::new(), "{block}");
    }
    // Two parameters behind it are none of Klartext's assignments.
    refused(
        "N10 G421 Q273=+40 *\nQ275=+25.01 Q276=+25 *",
        "line 4, column 13: not understood: unexpected text Q276=+25",
    );
}

#[test]
fn a_comment_swallows_neither_parameters_nor_blocks() {
    let said = |column: usize, found: &str| {
        format!("line 3, column {column}: {found} is part of the comment, which ends at the end of its line")
    };
    refused("N60 G421 Q273=+40 ;CENTRE Q274=+30 Q275=+25.01 *", &said(18, "Q274=+30"));
    refused("N60 G421 ;HOLE Q274=+30 ~\nQ275=+25.01 *", &said(9, "Q274=+30"));
    refused("N30 ;first * N40 M30 *", &said(5, "N40"));
    refused("N30 M3 ;on * N40 M30 *", &said(7, "N40"));
    for block in ["N30 ;2 * 3 N5 *", "N30 D00 Q1 P01 +5 ;Q2=7 *", ";Q274=+5 *"] {
        assert_eq!(blocks(block).1, Vec::<String>::new(), "{block}");
    }
}

#[test]
fn the_sample_is_read_without_a_warning() {
    let bytes = include_bytes!("../../data/samples/programs/fit_iso.i");
    let (program, warnings) = Program::read(bytes).unwrap();
    assert!(warnings.is_empty(), "{warnings:?}");
    assert_eq!(program.write(), bytes);
    assert!(program.blocks().iter().all(|block| block.body != Body::Other));
    assert_eq!((program.name(), program.unit(), program.blocks().len()), (Some("FIT_ISO"), Some(Unit::Mm), 28));
}

/// Pieces of the language where mistakes are likely.
const PIECES: [&str; 56] = [
    "%A G71 *\n",
    "N99999999 %A G71 *",
    "N10 ",
    "N",
    "/",
    "%",
    " *\n",
    "*",
    "\n",
    "\r\n",
    "\0",
    " ~\n",
    ";",
    "\"",
    " ",
    "G00 ",
    "G01",
    "G02 ",
    "G11 ",
    "G17",
    "G28 X",
    "G54 ",
    "G73 ",
    "G80 ",
    "G90 ",
    "G91 ",
    "G98 ",
    "G99 ",
    "G247 ",
    "G421 ",
    "G200",
    "L1",
    ",0",
    ",2",
    "T5 ",
    "S50",
    "D00 ",
    "D09 ",
    "D18 ",
    "P01 ",
    "P02+",
    "P03 1",
    "Q1",
    "QS2",
    "=",
    "+",
    "-",
    "X+5",
    "Y",
    "I+0 ",
    "H",
    "M30",
    "M140 MB MAX",
    "GLOBAL DEF 120",
    "7",
    "é",
];

fn sound(bytes: &[u8]) -> Result<(), TestCaseError> {
    let Ok((program, warnings)) = Program::read(bytes) else { return Ok(()) };
    prop_assert_eq!(program.write(), bytes);
    let mut behind = 0;
    for (index, block) in program.blocks().iter().enumerate() {
        prop_assert!(behind <= block.lines.start && block.lines.start < block.lines.end);
        let is_blank =
            |line: usize| program.line(line).chars().all(|c| c.is_whitespace() || "\u{1a}\u{feff}".contains(c));
        prop_assert!((behind..block.lines.start).all(is_blank));
        prop_assert_eq!(program.block_at(block.lines.start), Some(index));
        behind = block.lines.end;
        // What is kept as text is always said.
        if block.body == Body::Other && warnings.len() < 500 && program.notation() == Notation::Iso {
            let said = warnings.iter().filter_map(|warning| warning.place.line);
            prop_assert!(said.into_iter().any(|line| block.lines.contains(&(line - 1))));
        }
    }
    for warning in warnings {
        let (number, column) = (warning.place.line.unwrap(), warning.place.column.unwrap());
        prop_assert!(number <= program.line_count());
        prop_assert!(1 <= column && column <= program.line(number - 1).chars().count() + 1);
    }
    Ok(())
}

proptest! {
    #[test]
    fn any_bytes_are_read_and_written_as_they_were(bytes in prop::collection::vec(any::<u8>(), 0..300)) {
        sound(&[b"%A G71 *\r\nN10 ", bytes.as_slice(), b"\xe4*\r\nN99999999 %A G71 *"].concat())?;
    }

    #[test]
    fn any_pieces_of_the_language_are_read(pieces in prop::collection::vec(select(&PIECES[..]), 0..80)) {
        sound(pieces.concat().as_bytes())?;
        sound(format!("%A G71 *\n{}", pieces.concat()).as_bytes())?;
    }
}
