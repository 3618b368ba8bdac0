//! Blocks around a measurement: what changes the system, what is passed over, cycles whose `~` is missing.

use fitcheck::control::variables::Parameter;
use fitcheck::nc::program::{Axis, AxisWord, Body, CycleBlock, Frame, Goes, Mode, Operand, PassedOver, Program};

use super::reading::body;

fn number(value: f64) -> Operand {
    Operand::Number(value)
}

fn at(axis: Axis, value: f64) -> AxisWord {
    AxisWord { axis, is_incremental: false, value: number(value) }
}

#[track_caller]
fn passed(text: &str) -> (String, Goes, Vec<u32>) {
    let Body::PassedOver(PassedOver { words, goes, machine }) = body(text) else { panic!("{text}: {:?}", body(text)) };
    (words, goes, machine.iter().map(|function| function.number).collect())
}

#[test]
fn paths_are_passed_over_and_leave_the_tool_where_they_end() {
    use Axis::{X, Y, Z};
    let nowhere = Vec::new;
    for (text, words, is_unknown, axes, functions) in [
        ("C X+0 Y+20 DR-", "C", false, vec![at(X, 0.0), at(Y, 20.0)], vec![]),
        ("C  X-50 Y+0 DR- R0 F200 M5 M9", "C", false, vec![at(X, -50.0), at(Y, 0.0)], vec![5, 9]),
        ("CR X+5 Y+5 R+10 DR+", "CR", false, vec![at(X, 5.0), at(Y, 5.0)], vec![]),
        ("CT X+5", "CT", false, vec![at(X, 5.0)], vec![]),
        ("CC X+0 Y+0", "CC", false, nowhere(), vec![]),
        ("CC", "CC", false, nowhere(), vec![]),
        ("CP IPA-360 DR- F120", "CP", true, nowhere(), vec![]),
        ("CP IPA-360 Z-5 DR-", "CP", true, vec![at(Z, -5.0)], vec![]),
        ("LP PR+30 PA+0 FMAX", "LP", true, nowhere(), vec![]),
        ("RND R5", "RND", false, nowhere(), vec![]),
        ("CHF 2 F100", "CHF", false, nowhere(), vec![]),
        ("APPR LCT X-50 Y+0 R5 RL F800", "APPR LCT", false, vec![at(X, -50.0), at(Y, 0.0)], vec![]),
        ("APPR PLT PR+15 PA-90 LEN15 RR", "APPR PLT", true, nowhere(), vec![]),
        ("DEP LT LEN10", "DEP LT", true, nowhere(), vec![]),
        ("DEP LCT X+10 Y+12 R8 M30", "DEP LCT", false, vec![at(X, 10.0), at(Y, 12.0)], vec![30]),
        ("FL X+10 AN+45", "FL", true, vec![at(X, 10.0)], vec![]),
        ("FPOL X+0 Y+0", "FPOL", false, nowhere(), vec![]),
        ("LN X+31.7 Y+4 Z+39 NX+0.2 NY-0.3 NZ+0.9", "LN", false, vec![at(X, 31.7), at(Y, 4.0), at(Z, 39.0)], vec![]),
        ("CYCL CALL", "CYCL CALL", true, nowhere(), vec![]),
        ("CYCL CALL PAT FMAX M3", "CYCL CALL", true, nowhere(), vec![3]),
        ("CYCL CALL POS X+10 Y+20", "CYCL CALL", true, vec![at(X, 10.0), at(Y, 20.0)], vec![]),
    ] {
        assert_eq!(passed(text), (words.to_owned(), Goes { is_unknown, axes }, functions), "{text}");
    }
}

#[test]
fn settings_of_machining_are_passed_over() {
    for (text, words) in [
        ("BLK FORM 0.1 Z X-50 Y-50 Z-20", "BLK FORM"),
        ("BLK FORM CYLINDER Z R50 L105 DIST+5 RI10", "BLK FORM"),
        ("TOOL DEF 5 L+0 R+3", "TOOL DEF"),
        ("PATTERN DEF POS1 (X+10 Y+10 Z+0) POS2 (X-10 Y+10 Z+0)", "PATTERN DEF"),
        ("SEL PATTERN \"TNC:\\a.pnt\"", "SEL PATTERN"),
        ("SEL TABLE \"TNC:\\a.d\"", "SEL TABLE"),
        ("FUNCTION TCPM F TCP AXIS POS", "FUNCTION TCPM"),
        ("FUNCTION RESET TCPM", "FUNCTION RESET"),
        ("FUNCTION DWELL TIME4", "FUNCTION DWELL"),
        ("FUNCTION TURNDATA SPIN VCONST:ON VC:120 SMAX3000", "FUNCTION TURNDATA"),
        ("CYCL DEF 32.0 TOLERANCE", "CYCL DEF 32"),
        ("CYCL DEF 32.1 T0.05", "CYCL DEF 32"),
        ("CYCL DEF 9.1 DWELL 0.5", "CYCL DEF 9"),
        ("FN 15: PRINT Q7/Q8", "FN 15"),
        ("FN 17: SYSWRITE ID50 NR1 IDXQ2 = Q1601", "FN 17"),
        ("FN 19: PLC =+4 / Q120", "FN 19"),
        ("FN20: WAIT FOR SYNC", "FN 20"),
        ("FN 29: PLC = +99992 / +0 / +0", "FN 29"),
        ("FN 38: SEND /\"text %f\" / +Q1", "FN 38"),
    ] {
        assert_eq!(passed(text), (words.to_owned(), Goes::default(), vec![]), "{text}");
    }
    // These touch files, run a program as a cycle, hand a value to the caller, or are unknown.
    for text in ["FN 37: EXPORT QS10", "FUNCTION FILECHECK \"a\"", "CYCL DEF 12.1 PGM A.H", "PRESET COPY #1 TO #2"] {
        assert_eq!(body(text), Body::Other, "{text}");
    }
}

#[test]
fn a_block_may_begin_with_its_axis() {
    assert_eq!(body("X+37.8 R+ F10 M7"), body("L X+37.8 R+ F10 M7"));
    assert!(matches!(body("C+45 R0 FMAX"), Body::Move(_)));
    assert!(matches!(body("C X+45"), Body::PassedOver(_)));
    assert!(matches!(body("IZ-5 FMAX"), Body::Move(_)));
}

#[test]
fn changes_of_the_system_are_understood() {
    use Axis::{A, B, C, X, Y, Z};
    let q = Operand::Parameter { parameter: Parameter::q(5), is_negative: false };
    let tilt = |angles: [AxisWord; 3], axes_stay| Frame::Tilt { angles: angles.to_vec(), axes_stay };
    let incremental = AxisWord { axis: X, is_incremental: true, value: number(5.0) };
    for (text, frame) in [
        ("CYCL DEF 7.0 DATUM SHIFT", Frame::Title),
        ("CYCL DEF 7.1 X+60", Frame::Shift(vec![at(X, 60.0)])),
        (
            "CYCL DEF 7.2 Y40 Z+Q5",
            Frame::Shift(vec![at(Y, 40.0), AxisWord { axis: Z, is_incremental: false, value: q }]),
        ),
        ("CYCL DEF 7.1 IX+5", Frame::Shift(vec![incremental])),
        ("CYCL DEF 7.1 #5", Frame::ShiftFromTable),
        ("CYCL DEF 7.1 #Q5", Frame::ShiftFromTable),
        ("TRANS DATUM AXIS X+10 Y-3", Frame::Shift(vec![at(X, 10.0), at(Y, -3.0)])),
        ("TRANS DATUM TABLE TABLINE 5", Frame::ShiftFromTable),
        ("TRANS DATUM RESET", Frame::NoShift),
        ("CYCL DEF 247 PRESETTING ~\n    Q339=+1 ;PRESET NUMBER", Frame::Preset(Some(number(1.0)))),
        ("PRESET SELECT #3", Frame::Preset(Some(number(3.0)))),
        ("PLANE RESET TURN FMAX", Frame::TurnedBack),
        ("PLANE SPATIAL SPB+0 SPA+30 SPC+0 STAY", tilt([at(B, 0.0), at(A, 30.0), at(C, 0.0)], true)),
        ("PLANE SPATIAL STAY", Frame::OtherTilt),
        ("CYCL DEF 19.1 ABST50", Frame::OtherTilt),
        ("CYCL DEF 19.2 ABST50 F500", Frame::Title),
        ("CYCL DEF 10.1 ROT+30", Frame::Rotation { angle: number(30.0), is_incremental: false }),
        ("CYCL DEF 10.1 IROT-5", Frame::Rotation { angle: number(-5.0), is_incremental: true }),
        ("TRANS ROTATION ROT+90", Frame::Rotation { angle: number(90.0), is_incremental: false }),
        ("TRANS ROTATION RESET", Frame::Rotation { angle: number(0.0), is_incremental: false }),
        ("CYCL DEF 8.1 X Y", Frame::Mirror(vec![X, Y])),
        ("CYCL DEF 8.1", Frame::Mirror(vec![])),
        ("TRANS MIRROR AXIS X", Frame::Mirror(vec![X])),
        ("CYCL DEF 11.1 SCL 0.99", Frame::Scaling(number(0.99))),
        ("TRANS SCALE RESET", Frame::Scaling(number(1.0))),
        ("CYCL DEF 26.1 X1.4 Y0.6 CCX+15 CCY+20", Frame::AxisScaling(vec![number(1.4), number(0.6)])),
        ("PLANE SPATIAL SPA+0 SPB+30 SPC+0 TURN MB MAX FMAX", tilt([at(A, 0.0), at(B, 30.0), at(C, 0.0)], false)),
        ("PLANE SPATIAL SPA0 SPB0 SPC0 STAY SEQ+ TABLE ROT", tilt([at(A, 0.0), at(B, 0.0), at(C, 0.0)], true)),
        ("PLANE AXIAL B+45 TURN FMAX", Frame::OtherTilt),
        ("PLANE RESET STAY", Frame::NoTilt),
        ("CYCL DEF 19.1 A+0 B-90 C+0", tilt([at(A, 0.0), at(B, -90.0), at(C, 0.0)], true)),
        ("CYCL DEF 19.1", Frame::Tilt { angles: vec![], axes_stay: true }),
    ] {
        assert_eq!(body(text), Body::Frame(frame), "{text}");
    }
    assert_eq!(body("FUNCTION MODE TURN \"AC_TABLE\""), Body::Mode(Mode::Turn));
    assert_eq!(body("FUNCTION MODE MILL"), Body::Mode(Mode::Mill));
    assert_eq!(body("FUNCTION MODE SET \"A\""), Body::Other);
}

fn read(text: &str) -> (Vec<Body>, Vec<String>) {
    let (program, warnings) = Program::read(text.as_bytes()).unwrap();
    assert_eq!(program.write(), text.as_bytes());
    let bodies = program.blocks().iter().map(|block| block.body.clone()).collect();
    (bodies, warnings.iter().map(ToString::to_string).collect())
}

#[test]
fn a_machining_cycle_and_global_values_keep_lines_whose_tilde_is_missing() {
    let (bodies, warnings) = read(
        "0 BEGIN PGM a MM\n1 CYCL DEF 200 DRILLING\n   Q200=2 ;CLEARANCE\n   Q201=-15 ;DEPTH ~\n   Q206=+Q2\n2 Q206 = 7\n\
         3 GLOBAL DEF 120 PROBING ~\n   Q320=+1 ;X\n   Q260=+50\n4 END PGM a MM\n",
    );
    let lines = |body: &Body| match body {
        Body::CycleDefinition(CycleBlock { lines, .. }) | Body::GlobalDefinition(CycleBlock { lines, .. }) => {
            lines.len()
        }
        other => panic!("{other:?}"),
    };
    assert_eq!((bodies.len(), lines(&bodies[1]), lines(&bodies[3])), (5, 3, 2));
    assert!(matches!(bodies[2], Body::Assign { .. }), "a numbered line is a block");
    assert_eq!(
        warnings,
        [
            "line 3, column 4: cycle 200 ended in line 2, which has no ~ at its end: the lines below are read as part of it",
            "line 9, column 4: cycle 120 ended in line 8, which has no ~ at its end: the lines below are read as part of it",
        ]
    );
}

#[test]
fn a_measuring_cycle_keeps_none_of_them() {
    let (bodies, warnings) = read("0 BEGIN PGM a MM\n1 TCH PROBE 421 X ~\n   Q273=+2\n   Q275=+25\n2 END PGM a MM\n");
    assert_eq!(bodies[2], Body::Other);
    assert!(warnings[0].contains("Q275 is not part of it"), "{warnings:?}");
}

/// Read alone each of these would change what is measured, or be the measurement.
#[test]
fn a_tilde_makes_no_block_part_of_another() {
    for (above, below) in [
        ("CYCL DEF 7.0 DATUM SHIFT ~", "CYCL DEF 7.1 X+0.5"),
        ("TOOL CALL 9 Z ~", "CYCL DEF 7.1 X+0.5"),
        ("L Z+100 R0 FMAX M5 ~", "2 CYCL DEF 10.1 ROT+30"),
        ("PLANE RESET STAY ~", "TCH PROBE 421 X"),
        ("PATTERN DEF POS1 (X+1 Y+1 Z+0) ~", "TCH PROBE 421 X"),
        ("TOOL DEF 5 ~", "Q1 = 5"),
        ("* - measure ~", "TCH PROBE 421 X"),
        ("; clamped left ~", "CYCL DEF 7.1 X+0.5"),
    ] {
        let (bodies, warnings) = read(&format!("0 BEGIN PGM a MM\n{above}\n{below}\n9 END PGM a MM\n"));
        assert_eq!(bodies[1], Body::Other, "{above}");
        let told = warnings
            .iter()
            .any(|warning| warning.starts_with("line 3") && warning.contains("so this block would be part"));
        assert!(told, "{above}: {warnings:?}");
    }
    // What belongs together may go on.
    let (bodies, warnings) = read(
        "0 BEGIN PGM a MM\n1 PATTERN DEF ~\n POS1 (X+1 Y+1 Z+0) ~\n POS2 (X+2 Y+1 Z+0)\n2 Q1 = 5 + ~\n Q2\n9 END PGM a MM\n",
    );
    assert!(matches!(bodies[1], Body::PassedOver(_)) && matches!(bodies[2], Body::Assign { .. }), "{warnings:?}");
}

#[test]
fn parameters_beside_the_name_of_a_cycle_are_its_own_and_none_is_lost_in_a_comment() {
    let (bodies, warnings) =
        read("0 BEGIN PGM a MM\n1 TCH PROBE 421 MEASURE HOLE Q279=+0.02 Q280=+0.02 ~\n Q262=+25\n9 END PGM a MM\n");
    let Body::Probe(cycle) = &bodies[1] else { panic!("{warnings:?}") };
    assert_eq!((cycle.name.as_str(), cycle.lines.len()), ("MEASURE HOLE", 3));
    assert_eq!((cycle.lines[0].place.line, cycle.lines[0].place.column), (2, 30));
    assert_eq!(body("CYCL DEF 247 SETTING Q339=+3"), Body::Frame(Frame::Preset(Some(number(3.0)))));
    let (bodies, warnings) =
        read("0 BEGIN PGM a MM\n1 TCH PROBE 421 X ~\n Q281=+0 ;LOG Q280=+0.02 ~\n Q262=+25\n9 END PGM a MM\n");
    assert_eq!(bodies[1], Body::Other);
    assert!(warnings[0].contains("Q280=+0.02"), "{warnings:?}");
}

#[test]
fn an_axis_behind_other_words_counts() {
    assert_eq!(body("TOOL CALL 9 S50 Z"), {
        let Body::ToolCall { tool, .. } = body("TOOL CALL 9 Z") else { panic!() };
        Body::ToolCall { tool, axis: Some(Axis::Z), rest: "S50 Z".to_owned() }
    });
    let Body::Move(movement) = body("L X+0 M8 C+90") else { panic!() };
    assert_eq!((movement.axes, movement.machine.len()), (vec![at(Axis::X, 0.0), at(Axis::C, 90.0)], 1));
    let Body::Move(movement) = body("L M126 C+45 M8") else { panic!() };
    assert_eq!((movement.axes, movement.machine.len()), (vec![at(Axis::C, 45.0)], 2));
}
