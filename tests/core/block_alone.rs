//! `fitcheck cycle --block FILE`: what the program around the block would have changed is told, and the exit code says so.

use std::path::Path;

use assert_cmd::cargo::cargo_bin_cmd;

use crate::at_home::AtHome as _;

/// A whole block that measures a good bore of 25 H7.
const BORE: &str = "TCH PROBE 421 MEASURE HOLE ~\nQ273=+10 ~\nQ274=+20 ~\nQ262=+25 ~\nQ325=+0 ~\nQ247=+90 ~\nQ261=-5 ~\nQ320=+0 ~\n\
    Q260=+20 ~\nQ301=+0 ~\nQ275=+25.021 ~\nQ276=+25 ~\nQ279=+0 ~\nQ280=+0 ~\nQ281=+0 ~\nQ309=+0 ~\nQ330=+0 ~\nQ423=+4 ~\nQ365=+1\n";

/// The same in ISO.
const BORE_ISO: &str = "G421 Q273=+10 Q274=+20 Q262=+25 Q325=+0 Q247=+90 Q261=-5 Q320=+0 Q260=+20 Q301=+0 Q275=+25.021 Q276=+25 Q279=+0 \
    Q280=+0 Q281=+0 Q309=+0 Q330=+0 Q423=+4 Q365=+1 *\n";

fn within(folder: &Path, args: &[&str]) -> (i32, String) {
    let home = folder.join("home");
    let mut command = cargo_bin_cmd!("fitcheck");
    command.current_dir(folder).args(args).env("FITCHECK_JOURNAL", folder.join("j.sqlite"));
    let output = command.at_home(&home).output().unwrap();
    (output.status.code().unwrap(), String::from_utf8(output.stderr).unwrap())
}

fn block(cycle: &str, text: &str) -> (i32, String) {
    let folder = tempfile::tempdir().unwrap();
    fitcheck::files::write(&folder.path().join("a.h"), text.as_bytes()).unwrap();
    within(folder.path(), &["cycle", cycle, "--block", "a.h"])
}

/// A program with these blocks and the bore in it.
fn around(before: &str, after: &str) -> String {
    format!("0 BEGIN PGM A MM\nTOOL CALL 1 Z S100\n{before}{BORE}{after}END PGM A MM\n")
}

/// The program is told with this line and this word of it.
#[track_caller]
fn told(text: &str, line: usize, word: &str) {
    let (code, err) = block("421", text);
    let line = format!("line {line}: ");
    assert!(code == 14 && err.lines().any(|said| said.contains(&line) && said.contains(word)), "{code}: {err}\n{text}");
}

#[track_caller]
fn quiet(cycle: &str, text: &str) {
    let (code, err) = block(cycle, text);
    assert_eq!(code, 0, "{err}\n{text}");
}

#[test]
fn coordinates_that_are_moved_before_the_block_are_told() {
    for (lines, line, word) in [
        ("CYCL DEF 7.0 DATUM SHIFT\nCYCL DEF 7.1 X+10\n", 4, "CYCL DEF 7.1"),
        ("CYCL DEF 7.0 DATUM SHIFT\nCYCL DEF 7.1 X+10\nCYCL DEF 7.2 Y+0\n", 4, "CYCL DEF 7.1"),
        ("CYCL DEF 7.1 X+10\nCYCL DEF 7.1 IX-4\n", 3, "CYCL DEF 7.1"),
        ("Q1=+5\nCYCL DEF 7.1 X+Q1\n", 4, "X+Q1"),
        ("CYCL DEF 7.1 #5\n", 3, "#5"),
        ("CYCL DEF 8.1 X\n", 3, "CYCL DEF 8.1"),
        ("CYCL DEF 10.0 ROTATION\nCYCL DEF 10.1 ROT+15\n", 4, "ROT+15"),
        ("CYCL DEF 11.1 SCL 0.99\n", 3, "SCL"),
        ("PLANE SPATIAL SPA+0 SPB+30 SPC+0 STAY\n", 3, "PLANE"),
        ("PLANE VECTOR BX1 BY0 BZ0.5 NX0 NY0 NZ1 STAY\n", 3, "PLANE"),
        ("TRANS DATUM AXIS X+10\n", 3, "TRANS"),
        ("TRANS MIRROR AXIS X\n", 3, "TRANS"),
        ("FUNCTION MODE TURN\n", 3, "TURN"),
        ("TOOL CALL 1 Y S100\n", 3, "TOOL CALL"),
        ("L C+90 R0 FMAX\n", 3, "L C+90"),
        ("L Z+50 R0 FMAX M142\n", 3, "M142"),
        ("FN 17: SYSWRITE ID 210 NR2 =+5\n", 3, "FN 17"),
        ("CYCL DEF 392 BUILDER ~\nQ1=+5\n", 3, "CYCL DEF 392"),
        // The reset may be skipped.
        ("CYCL DEF 7.1 X+10\n/ CYCL DEF 7.1 X+0\n", 3, "CYCL DEF 7.1"),
        // It may be jumped over.
        ("CYCL DEF 10.1 ROT+15\nFN 9: IF +Q1 EQU +0 GOTO LBL 3\nCYCL DEF 10.1 ROT+0\nLBL 3\n", 3, "ROT+15"),
    ] {
        told(&around(lines, "M30\n"), line, word);
    }
}

#[test]
fn coordinates_that_were_reset_before_the_block_are_no_matter() {
    for lines in [
        "",
        "CYCL DEF 7.0 DATUM SHIFT\nCYCL DEF 7.1 X+10\nCYCL DEF 7.0 DATUM SHIFT\nCYCL DEF 7.1 X+0\n",
        "CYCL DEF 7.1 X+Q1\nCYCL DEF 7.1 X+0\n",
        "CYCL DEF 7.1 X+10\nTRANS DATUM RESET\n",
        "CYCL DEF 7.1 X+10\nCYCL DEF 7.1 IX-10\n",
        "CYCL DEF 8.1 X\nCYCL DEF 8.1\n",
        "CYCL DEF 10.1 ROT+15\nCYCL DEF 10.1 ROT+0\n",
        "CYCL DEF 10.1 ROT+360\n",
        "CYCL DEF 10.1 ROT-720\n",
        "CYCL DEF 11.1 SCL 0.99\nCYCL DEF 11.1 SCL 1\n",
        "PLANE SPATIAL SPA+0 SPB+30 SPC+0 TURN MB MAX FMAX\nPLANE RESET TURN MB MAX FMAX\n",
        "PLANE VECTOR BX1 BY0 BZ0 NX0 NY0 NZ1 TURN FMAX\n",
        "PLANE SPATIAL SPA+0 SPB+0 SPC+0 TURN FMAX\n",
        "FUNCTION MODE TURN\nFUNCTION MODE MILL\n",
        "L C+90 R0 FMAX\nL C+0 R0 FMAX\n",
        "CYCL DEF 247 DATUM SETTING ~\nQ339=+1\n",
        "LBL 1\nL X+10 R0 FMAX\n",
        "/ L Z+100 R0 FMAX\nM8\nSTOP\nM1\n",
        "Q1=+5\nFN 0: Q2 = +7\nFN 16: F-PRINT M.A / SCREEN:\n",
    ] {
        quiet("421", &around(lines, "M30\n"));
    }
}

#[test]
fn a_called_program_or_label_before_the_block_is_told() {
    for (lines, line, word) in [
        ("CALL PGM TNC:\\SHIFT.H\n", 3, "CALL PGM"),
        ("SEL PGM \"SHIFT.H\"\nCALL SELECTED PGM\n", 4, "CALL SELECTED PGM"),
        ("CYCL DEF 12.0 PGM CALL\nCYCL DEF 12.1 PGM SHIFT.H\nCYCL CALL\n", 3, "CYCL DEF 12.0"),
        ("CALL LBL 7\n", 3, "CALL LBL 7"),
        ("CALL LBL \"SHIFT\"\n", 3, "CALL LBL"),
        ("CALL LBL QS7\n", 3, "CALL LBL QS7"),
        ("LBL 7\nCYCL DEF 7.1 IX+10\nCALL LBL 7 REP 3\n", 5, "CALL LBL 7"),
    ] {
        told(&around(lines, "M30\nLBL 7\nCYCL DEF 7.1 X+10\nLBL 0\n"), line, word);
    }
    quiet("421", &around("", "CALL PGM TNC:\\NEXT.H\nM30\n"));
}

#[test]
fn a_block_that_no_control_runs_is_told() {
    for (text, line, word) in [
        (format!("0 BEGIN PGM A MM\nTOOL CALL 1 Z\nEND PGM A MM\n{BORE}"), 3, "END PGM"),
        (around("M30\n", ""), 3, "M30"),
        (around("L Z+50 R0 FMAX M2\n", ""), 3, "M2"),
        (around("STOP M2\n", ""), 3, "STOP"),
        (around("FN 9: IF +0 EQU +0 GOTO LBL 9\n", "LBL 9\n"), 3, "FN 9"),
        (around("FN 12: IF +Q1 LT +Q2 GOTO LBL \"END\"\n", "LBL \"END\"\n"), 3, "FN 12"),
        // With block skip it is, without it is not.
        (around("/ M30\n", ""), 3, "M30"),
        // Nobody calls the subprogram.
        (around("M30\nLBL 5\n", "LBL 0\n"), 3, "M30"),
        (format!("{BORE}END PGM A MM\n").replacen("TCH", "END PGM A MM\nTCH", 1), 1, "END PGM"),
    ] {
        told(&text, line, word);
    }
    quiet("421", &around("FN 9: IF +Q1 EQU +0 GOTO LBL 9\nL X+1 R0 FMAX\nLBL 9\n", "M30\n"));
    // A loop behind it comes back.
    quiet("421", &around("LBL 1\n", "FN 9: IF +Q180 EQU +0 GOTO LBL 1\nM30\n"));
}

#[test]
fn a_block_that_may_be_skipped_is_told() {
    told(&around("", "M30\n").replace("TCH PROBE", "/ TCH PROBE"), 3, "/");
    told(&around("", "M30\n").replace("TCH PROBE", "/12 TCH PROBE"), 3, "/");
    told(&BORE.replace("TCH PROBE", "12 / TCH PROBE"), 1, "/");
}

#[test]
fn a_block_that_is_not_understood_before_the_block_is_told() {
    told(&around("WHATEVER 5\n", "M30\n"), 3, "WHATEVER");
    quiet("421", &around("", "WHATEVER 5\nM30\n"));
}

#[test]
fn blocks_of_iso_programs_are_looked_at_too() {
    let program = |before: &str, after: &str| {
        format!("%A G71 *\nN10 T1 G17 S100 *\n{before}N50 {BORE_ISO}{after}N99999999 %A G71 *\n")
    };
    for (before, line, word) in [
        ("N20 G54 X+10 *\n", 3, "G54"),
        ("N20 G28 X *\n", 3, "G28"),
        ("N20 G90 *\nN30 G73 H+30 *\n", 4, "G73"),
        ("N20 G72 F0.99 *\n", 3, "G72"),
        ("N20 L5,0 *\n", 3, "L5,0"),
        ("N20 %SHIFT *\n", 3, "%SHIFT"),
        ("N20 M30 *\n", 3, "M30"),
        ("N20 T1 G18 S100 *\n", 3, "G18"),
    ] {
        told(&program(before, ""), line, word);
    }
    for before in [
        "",
        "N20 G90 *\nN30 G54 X+10 *\nN40 G54 X+0 *\n",
        "N20 G90 *\nN30 G73 H+30 *\nN40 G73 H+0 *\n",
        "N20 G00 G90 Z+50 *\n",
    ] {
        quiet("421", &program(before, ""));
    }
    // Cut out of a program, without its head.
    told(&format!("N20 G54 X+10 *\nN50 {BORE_ISO}"), 1, "G54");
    quiet("421", &format!("N20 G00 G90 Z+50 *\nN50 {BORE_ISO}"));
}

#[test]
fn a_lone_block_stays_quiet() {
    quiet("421", BORE);
    quiet("421", &format!("; from the program of the fixture\n\n{BORE}"));
    quiet("421", &format!("L Z+50 R0 FMAX\n{BORE}L Z+100 R0 FMAX\n"));
    quiet("421", &format!("N50 {BORE_ISO}"));
    for text in [
        "G785 R0 BR0 K2 C0 RC60 I0 J0 Q0 P0 H0\n",
        "N1 G26 S4000\nN2 T3\nN3 G96 S180 G95 F0.2 M4\nN4 G0 C90\nN5 G785 R0 BR0 K2 C0 RC60 I0 J0 Q0 P0 H0\n",
        "N10 G0 X0 Z5\nN20 G785 R0 BR0 K2 C0 RC60 I0 J0 Q0 P0 H0\n",
        "%A.nc\nPROGRAMMKOPF\n#UNIT METRIC\nBEARBEITUNG\nT1\nG0 X0 Z5\nG785 R0 BR0 K2 C0 RC60 I0 J0 Q0 P0 H0\nENDE\n",
    ] {
        quiet("G785", text);
    }
}

#[test]
fn a_preset_that_a_cycle_corrects_is_told() {
    let before = |correction: &str| {
        let circle =
            "TCH PROBE 1401 CIRCLE PROBING ~\nQS1100=\"+10\" ~\nQS1101=\"+20\" ~\nQS1102=\"-5\" ~\nQS1116=\"25H7\" ~\n";
        format!("{circle}Q1120={correction}\n")
    };
    for (correction, wanted) in [("+0", 0), ("+1", 14), ("+Q5", 14)] {
        let folder = tempfile::tempdir().unwrap();
        fitcheck::files::write(&folder.path().join("a.h"), around(&before(correction), "").as_bytes()).unwrap();
        let (code, err) = within(folder.path(), &["cycle", "421", "--block", "a.h", "--at", "9"]);
        assert_eq!(code, wanted, "{correction}: {err}");
        assert_eq!(err.contains("line 3: TCH PROBE 1401"), wanted == 14, "{correction}: {err}");
    }
}
