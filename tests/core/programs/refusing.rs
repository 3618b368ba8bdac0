//! Warnings about programs, with line and column; and what is not a program.

use fitcheck::control::variables::Parameter;
use fitcheck::nc::program::{Body, LabelFault, Program, ProgramError, Target};

#[track_caller]
fn warnings(text: &str) -> Vec<String> {
    let (program, warnings) = Program::read(text.as_bytes()).unwrap();
    assert_eq!(program.write(), text.as_bytes());
    warnings.iter().map(ToString::to_string).collect()
}

#[track_caller]
fn check(text: &str, wanted: &[&str]) {
    assert_eq!(warnings(text), wanted, "{text}");
}

/// A block that is known but not understood is kept as text, with a reason.
#[track_caller]
fn check_block(block: &str, wanted: &str) {
    let text = format!("0 BEGIN PGM t MM\n{block}\n999 END PGM t MM\n");
    check(&text, &[wanted]);
    assert_eq!(Program::read(text.as_bytes()).unwrap().0.blocks()[1].body, Body::Other, "{block}");
}

#[test]
fn beginning_and_end_are_asked_for() {
    check("0 BEGIN PGM a MM\n1 END PGM a MM\n", &[]);
    check(
        "M30",
        &["line 1, column 1: the program does not begin with BEGIN PGM", "line 1, column 1: END PGM is missing"],
    );
    check("0 BEGIN PGM a MM\n\n1 M30\n\n", &["line 3, column 1: END PGM is missing"]);
    check("BEGIN PGM a MM\nEND PGM a INCH", &["line 2, column 1: END PGM says INCH, BEGIN PGM says MM"]);
    let again = "line 2, column 1: second BEGIN PGM";
    check("BEGIN PGM a MM\nBEGIN PGM b MM\nEND PGM a MM", &[again]);
    let behind = "line 4, column 1: text after END PGM is not part of the program";
    check("BEGIN PGM a MM\nEND PGM a MM\n\n M30\nM30", &[behind]);
    check_block("1 END PGM", "line 2, column 10: not understood: MM or INCH is missing");
}

#[test]
fn block_numbers_that_do_not_rise_are_said_once() {
    let text = "0 BEGIN PGM a MM\n10 M5\n20 M5\n20 M5\nM5\n5 M5\n6 M5\n6 M5\n7 END PGM a MM";
    check(text, &["line 4, column 1: block number 20 follows 20; block numbers out of order: 3"]);
}

#[test]
fn a_label_twice_is_said_and_is_an_error_when_it_is_used() {
    let text = "0 BEGIN PGM a MM\n1 LBL 1\n2 LBL \"1\"\n3 LBL 1\n4 LBL 0\n5 LBL 0\n6 LBL 2\n7 END PGM a MM";
    check(text, &["line 4, column 1: LBL 1 is already defined in line 2"]);
    let program = Program::read(text.as_bytes()).unwrap().0;
    let fault = |label: Target| program.label(&label).unwrap_err().to_string();
    assert_eq!(program.label(&Target::Number(2)), Ok(6));
    assert_eq!(program.label(&Target::Name("1".to_owned())), Ok(2));
    assert_eq!(fault(Target::Number(1)), "LBL 1 is defined twice, in line 2 and line 4");
    assert_eq!(fault(Target::Name("x".to_owned())), "LBL \"x\" does not occur in the program");
    assert_eq!(program.label(&Target::Number(0)), Err(LabelFault::Zero));
    let parameter = Target::Parameter(Parameter::qs(5));
    assert_eq!(fault(parameter), "which label QS5 holds is known only while the program runs");
}

#[test]
fn quotation_marks_and_continued_lines_end() {
    check_block("5 CALL PGM \"TNC:\\a.h", "line 2, column 12: the quotation mark is not closed");
    check_block("5 ÄÖ \"x", "line 2, column 6: the quotation mark is not closed");
    let open = "0 BEGIN PGM a MM\n1 END PGM a MM\n2 TCH PROBE 421 A ~\n Q1=5 ~\n\n";
    let behind = "line 3, column 1: text after END PGM is not part of the program";
    check(open, &[behind, "line 4, column 1: the line ends in ~, but nothing follows"]);
}

#[test]
fn a_block_that_is_not_understood_tells_why() {
    check_block("1 Q1 = ", "line 2, column 7: not understood: a number or a Q parameter is missing");
    check_block("1 Q1 + 5", "line 2, column 6: not understood: expected =, found +");
    check_block("1 Q1 = 5 6", "line 2, column 10: not understood: unexpected text 6");
    check_block("1 Q1 = CFGREAD ( X )", "line 2, column 8: not understood: CFGREAD is not a function");
    check_block("1 Q1 = ( 5 + 3", "line 2, column 15: not understood: ) is missing");
    check_block("1 Q1 = QS5", "line 2, column 8: not understood: expected a number or a Q parameter, found QS5");
    check_block("1 QS1 = 5", "line 2, column 9: not understood: expected a quoted text or a QS parameter, found 5");
    check_block("1 Q2000 = 5", "line 2, column 3: not understood: Q2000 is not a parameter: Q goes from 0 to 1999");
    check_block("1 Q1 = QL500", "line 2, column 8: not understood: QL500 is not a parameter: QL goes from 0 to 499");
    check_block("1 LBL 65536", "line 2, column 7: not understood: 65536 is too large: at most 65535");
    check_block("1 LBL QS5", "line 2, column 7: not understood: QS5 cannot be the name of the label that begins here");
    check_block("1 LBL LOOP", "line 2, column 7: not understood: expected a label, found LOOP");
    check_block("1 CALL LBL 5 REP 65535", "line 2, column 18: not understood: 65535 is too large: at most 65534");
    check_block("1 CALL LBL 5 REP", "line 2, column 17: not understood: a number is missing");
    check_block("1 CALL PGM ;x", "line 2, column 11: not understood: a path is missing");
    let wrong = "line 2, column 16: not understood: FN 9 compares with EQU: found NE";
    check_block("1 FN 9: IF +Q1 NE +0 GOTO LBL 1", wrong);
    check_block("1 FN 9: IF +Q1 = 5", "line 2, column 16: not understood: expected EQU, NE, GT, LT or IS, found =");
    check_block("1 FN 9: IF +Q1 EQU 5 GO", "line 2, column 22: not understood: expected GOTO, found GO");
    check_block("1 FN 1: Q1 = 5", "line 2, column 15: not understood: + is missing");
    check_block("1 FN 16: F-PRINT a.a", "line 2, column 21: not understood: / is missing");
    check_block("1 FN 28: TABREAD Q1 = 5", "line 2, column 24: not understood: / is missing");
    check_block("1 L X+0 X+1", "line 2, column 9: not understood: an axis is given twice");
    check_block("1 L X+0 R0 FMAX foo", "line 2, column 17: not understood: unexpected text foo");
    check_block("1 L X+", "line 2, column 6: not understood: expected a number or a Q parameter, found +");
    check_block("1 STOP now", "line 2, column 8: not understood: unexpected text now");
    check_block("1 TCH PROBE PLANE", "line 2, column 13: not understood: expected a number, found PLANE");
    check_block("1 TCH PROBE 421 A ~\n  Q5 ;x", "line 3, column 5: not understood: = is missing");
    check_block("1 TCH PROBE 421 A ~\n  Q5=* ;x", "line 3, column 6: not understood: expected a value, found *");
    check_block(
        "1 TCH PROBE 421 A ~\n5 M30",
        "line 3, column 1: the block above ends in ~, so this block would be part of it",
    );
    check_block("1 Q1 = 5 + ~\n    foo", "line 3, column 5: not understood: foo is not a function");
    let large = format!("1 Q1 = {}", "9".repeat(400));
    check_block(&large, "line 2, column 8: not understood: 999999999999999999999999 is too large");
}

#[test]
fn formulas_and_blocks_are_bounded() {
    let deep = "line 2, column 68: not understood: brackets and functions are nested more than 64 deep";
    for nested in [format!("1 Q1={}1{}", "(".repeat(5000), ")".repeat(5000)), format!("1 Q1={}1", "-".repeat(5000))] {
        let told = warnings(&format!("0 BEGIN PGM t MM\n{nested}\n9 END PGM t MM"));
        assert_eq!(told.len(), 1);
        assert!(told[0].ends_with(deep.split(": ").last().unwrap()), "{}", told[0]);
    }
    let most = |count: usize| format!("1 Q1 = 1{}", "+1".repeat(count - 1));
    check(&format!("0 BEGIN PGM t MM\n{}\n9 END PGM t MM", most(500)), &[]);
    let many = "line 2, column 1008: not understood: the formula has more than 500 operands";
    check_block(&most(501), many);
    let long = format!("1 L  X+{}", "0".repeat(70_000));
    check_block(&long, "line 2, column 3: not understood: the block has more than 65536 characters");
}

#[test]
fn formulas_are_bounded_in_all() {
    let line = format!("FN 18: SYSREAD Q1 = {}\n", "x".repeat(60_000));
    let within = (8 << 20) / (line.len() - 1);
    let text = format!("0 BEGIN PGM t MM\n{}LBL 1\n9 END PGM t MM", line.repeat(within + 1));
    // What is kept as text also counts.
    let told = "not understood: formulas and long blocks take more than 8 MiB in all";
    check(&text, &[&format!("line {}, column 1: {told}", within + 2)]);
    let program = Program::read(text.as_bytes()).unwrap().0;
    assert_eq!(program.blocks()[within + 1].body, Body::Other);
    assert_eq!(program.label(&Target::Number(1)), Ok(within + 2));
}

#[test]
fn many_warnings_are_counted() {
    let text = format!("0 BEGIN PGM t MM\n{}9 END PGM t MM", "LBL\n".repeat(1000));
    let told = warnings(&text);
    assert_eq!(told.len(), 501);
    assert_eq!(told[499], "line 501, column 4: not understood: a label is missing");
    assert_eq!(told[500], "line 501, column 4: 500 more remarks are not listed");
}

#[test]
fn what_is_no_text_is_refused() {
    let refused = |bytes: &[u8]| Program::read(bytes).unwrap_err();
    assert_eq!(refused(b""), ProgramError::Empty);
    assert_eq!(refused(b" \r\n\t\n\x1a"), ProgramError::Empty);
    assert_eq!(refused(b"\x01\x02\x03 BEGIN PGM"), ProgramError::Binary { controls: 3, bytes: 13 });
    let utf16: Vec<u8> = "BEGIN PGM a MM".encode_utf16().flat_map(u16::to_le_bytes).collect();
    assert_eq!(refused(&utf16), ProgramError::Binary { controls: 14, bytes: 28 });
    assert_eq!(refused(&vec![b'a'; (64 << 20) + 1]), ProgramError::TooLarge { most: 64 });
    assert_eq!(refused(&b"M5\n".repeat(2_000_001)), ProgramError::TooManyLines { most: 2_000_000 });
}

#[test]
fn text_transfer_separates_lines_with_byte_0() {
    let text = "0 BEGIN PGM a MM\x001 M30\x002 END PGM a MM\x00";
    check(text, &[]);
    assert_eq!(Program::read(text.as_bytes()).unwrap().0.blocks().len(), 3);
}

/// A hole of 25 H7 whose cycle lacks a `~` behind Q301, numbered and not: what was lost is said, and no run goes on.
#[test]
fn a_line_of_a_cycle_without_its_tilde_is_refused() {
    let begins = |cycle: &str| format!("line 4, column 5: cycle {cycle} ended in line 3, which has no ~ at its end: ");
    let cut = |cycle: &str, parameter: &str| {
        format!("{}{parameter} is not part of it and would be assigned instead", begins(cycle))
    };
    let cut_many = |cycle: &str, parameter: &str| {
        format!(
            "{}the lines from {parameter} on, up to line 5, are not part of it and would be assigned instead. A ~ belongs at the \
             end of every line of a cycle but its last",
            begins(cycle)
        )
    };
    for (cycle, parameter) in [("421", "Q275"), ("422", "Q277"), ("427", "Q288"), ("444", "QS400")] {
        let value = if parameter == "QS400" { "\"0.1-0.1\"" } else { "+25.01" };
        for (number, behind) in [("1 ", " ;X ~"), ("1 ", " ;X"), ("", " ;X ~"), ("", "")] {
            let rest = format!("{parameter}={value}{behind}");
            let text = format!(
                "{number}BEGIN PGM a MM\n{number}TCH PROBE {cycle} A ~\n    Q301=+0 ;X\n    {rest}\n    Q309=+1 ;X\n{number}END PGM a MM\n"
            );
            let (program, warnings) = Program::read(text.as_bytes()).unwrap();
            let said: Vec<String> = warnings.iter().map(ToString::to_string).collect();
            assert_eq!(program.blocks()[2].body, Body::Other, "{text}");
            // Without a ~ behind it, the next line is one more, and all of them are said once.
            if rest.ends_with('~') {
                assert!(said.contains(&cut(cycle, parameter)), "{text}{said:?}");
            } else {
                let cut: Vec<&String> = said.iter().filter(|said| said.contains("ended in line")).collect();
                assert_eq!(cut, [&cut_many(cycle, parameter)], "{text}");
                assert_eq!(program.blocks()[3].body, Body::Other, "{text}");
            }
        }
    }
}

#[test]
fn a_tilde_too_many_at_the_end_of_a_cycle_is_said() {
    let text = "0 BEGIN PGM a MM\n1 TCH PROBE 421 A ~\n Q273=+40 ~\n2 L Z+50 R0 FMAX\n3 END PGM a MM\n";
    check(text, &["line 4, column 1: the block above ends in ~, so this block would be part of it"]);
    let text = "BEGIN PGM a MM\nTCH PROBE 421 A ~\n Q273=+40 ~\nL Z+50 R0 FMAX\nEND PGM a MM\n";
    check(text, &["line 4, column 1: the block above ends in ~, so this block would be part of it"]);
}

#[test]
fn the_speed_of_another_control_is_said_to_belong_into_the_tool_call() {
    let said = "line 2, column 18: not understood: S6000 stands in a straight line: the speed of the spindle belongs into TOOL CALL";
    check_block("1 L X+10 R0 FMAX S6000 M3", said);
}

#[test]
fn an_assignment_behind_a_cycle_is_one_where_it_has_a_number_or_another_parameter() {
    let cycle = "1 TCH PROBE 421 A ~\n    Q275=+25.01 ;X";
    let text = |block: &str| format!("0 BEGIN PGM a MM\n{cycle}\n{block}\n9 END PGM a MM\n");
    for block in ["2 Q20 = Q153 + 1", "2 ; a comment\n3 Q20=+5 ;X", "2 FN 0: Q275 = +25", "2 M5\n Q275=+25"] {
        check(&text(block), &[]);
    }
    let declared = text("2 Q275=+25.01 ;X");
    let said = "line 4, column 3: cycle 421 ended in line 3, which has no ~ at its end: Q275 is not part of it and would be assigned instead";
    check(&declared, &[said]);
    assert!(matches!(Program::read(declared.as_bytes()).unwrap().0.blocks()[2].body, Body::Assign { .. }));
    check("BEGIN PGM a MM\nTCH PROBE 421 A ~\n Q301=+0 ;X\nQ20 = Q153\nEND PGM a MM\n", &[]);
}

#[test]
fn a_comment_swallows_no_block() {
    let said = "line 2, column 3: the comment ends in ~, so this block would be part of it";
    check_block("1 Q1 = 5 ;go on ~\n2 M3", said);
    check_block("1 TOOL CALL 5 Z ;go on ~\n2 M3", said);
    let said = "line 3, column 1: the comment ends in ~, so this block would be part of it";
    check_block("1 ;go on ~\n2 M3", said);
    check_block("1 ;go on ~\nQ275=+25 ;X", said);
    check("0 BEGIN PGM a MM\n1 ;go on ~\n  with more, and 2 words ~\n  ;and more\n2 END PGM a MM\n", &[]);
}
