//! What blocks say, block by block.

use fitcheck::control::variables::{Family, Parameter};
use fitcheck::nc::program::{
    Axis, AxisWord, Body, Columns, Condition, CycleValue, Expression, Feed, MachineFunction, NumberFunction, Operand,
    Operation, Program, Relation, SystemDatum, Target, TextExpression, TextOperand, Tool, Unit,
};

/// The bodies between BEGIN and END; there must be no warning.
#[track_caller]
fn bodies(text: &str) -> Vec<Body> {
    let text = format!("0 BEGIN PGM t MM\n{text}\n999 END PGM t MM\n");
    let (program, warnings) = Program::read(text.as_bytes()).unwrap();
    assert!(warnings.is_empty(), "{text}{}", warnings[0]);
    let blocks = program.blocks();
    blocks[1..blocks.len() - 1].iter().map(|block| block.body.clone()).collect()
}

#[track_caller]
pub(super) fn body(text: &str) -> Body {
    let mut bodies = bodies(text);
    assert_eq!(bodies.len(), 1, "{text}");
    bodies.remove(0)
}

#[track_caller]
fn check(texts: &[&str], wanted: &Body) {
    for text in texts {
        assert_eq!(&body(text), wanted, "{text}");
    }
}

fn number(number: f64) -> Operand {
    Operand::Number(number)
}

fn q(number: u16) -> Operand {
    Operand::Parameter { parameter: Parameter::q(number), is_negative: false }
}

fn minus_q(number: u16) -> Operand {
    Operand::Parameter { parameter: Parameter::q(number), is_negative: true }
}

fn assign(to: u16, value: Expression) -> Body {
    Body::Assign { to: Parameter::q(to), value }
}

fn text(text: &str) -> TextOperand {
    TextOperand::Text(text.to_owned())
}

fn name(name: &str) -> Target {
    Target::Name(name.to_owned())
}

fn machine(number: u32, rest: &str) -> MachineFunction {
    MachineFunction { number, rest: rest.to_owned() }
}

/// A formula with brackets around everything that belongs together.
fn shape(expression: &Expression) -> String {
    let operand = |operand: &Operand| match operand {
        Operand::Number(number) => number.to_string(),
        Operand::Parameter { parameter, is_negative } => format!("{}{parameter}", if *is_negative { "-" } else { "" }),
    };
    match expression {
        Expression::Value(value) => operand(value),
        Expression::Pi => "pi".to_owned(),
        Expression::Function(function, inner) => format!("{function:?}({})", shape(inner)),
        Expression::Binary(operation, left, right) => {
            let sign = match operation {
                Operation::Add => "+",
                Operation::Subtract => "-",
                Operation::Multiply => "*",
                Operation::Divide => "/",
                Operation::Power => "^",
                Operation::Remainder => "%",
                Operation::Hypotenuse => "LEN",
                Operation::Angle => "ANG",
            };
            format!("[{} {sign} {}]", shape(left), shape(right))
        }
        Expression::ToNumber(source) => format!("number of {source}"),
        Expression::Position { source, wanted, from } => format!("{wanted} in {source} from {}", operand(from)),
        Expression::TextLength(source) => format!("length of {source}"),
        Expression::Compare { source, other } => format!("{source} to {other}"),
    }
}

#[track_caller]
fn check_formula(formula: &str, wanted: &str) {
    for text in [format!("Q1 = {formula}"), format!("5 Q1={formula} ; comment"), format!("/5 q1 ={formula}")] {
        let Body::Assign { to, value } = body(&text) else { panic!("{text}") };
        assert_eq!((to, shape(&value)), (Parameter::q(1), wanted.to_owned()), "{text}");
    }
}

#[test]
fn power_before_point_before_dash_and_left_before_right() {
    check_formula("5 * 3 + 2 * 10", "[[5 * 3] + [2 * 10]]");
    check_formula("SQ 10 - 3 ^ 3", "[Square(10) - [3 ^ 3]]");
    check_formula("SQ 10 - 3^3", "[Square(10) - [3 ^ 3]]");
    check_formula("8 - 4 - 2", "[[8 - 4] - 2]");
    check_formula("8 / 4 / 2", "[[8 / 4] / 2]");
    check_formula("8 / 4 * 2 % 3", "[[[8 / 4] * 2] % 3]");
    check_formula("2 ^ 3 ^ 2", "[[2 ^ 3] ^ 2]");
    check_formula("( 2 + 3 ) * 4", "[[2 + 3] * 4]");
    check_formula("Q2+Q3*Q4", "[Q2 + [Q3 * Q4]]");
    check_formula("1 + 2 * 3 ^ 4 - 5", "[[1 + [2 * [3 ^ 4]]] - 5]");
    check_formula("400 % 360", "[400 % 360]");
}

#[test]
fn a_function_and_a_sign_bind_only_the_operand_behind_them() {
    check_formula("SIN 30 + 1", "[Sine(30) + 1]");
    check_formula("SIN 30 * 2", "[Sine(30) * 2]");
    check_formula("SIN-Q5", "Sine(-Q5)");
    check_formula("SQRT4", "SquareRoot(4)");
    check_formula("INT ( ( Q1950 / Q1810 ) + 0.99999999 )", "Integer([[Q1950 / Q1810] + 0.99999999])");
    check_formula("- 15", "-15");
    check_formula("-Q3 - - 2", "[-Q3 - -2]");
    check_formula("- ( Q2 + 1 )", "Negative([Q2 + 1])");
    check_formula("- SIN 30", "Negative(Sine(30))");
    check_formula("NEG Q13", "Negative(Q13)");
    check_formula("NEG ABS SGN -Q13", "Negative(Absolute(Sign(-Q13)))");
    check_formula("Q2 * -3", "[Q2 * -3]");
    check_formula("+Q2 + +20", "[Q2 + 20]");
    check_formula("pi * cos Ql7", "[pi * Cosine(QL7)]");
}

#[test]
fn all_functions_have_their_names() {
    let names = [
        ("SQ", NumberFunction::Square),
        ("SQRT", NumberFunction::SquareRoot),
        ("SIN", NumberFunction::Sine),
        ("COS", NumberFunction::Cosine),
        ("TAN", NumberFunction::Tangent),
        ("ASIN", NumberFunction::ArcSine),
        ("ACOS", NumberFunction::ArcCosine),
        ("ATAN", NumberFunction::ArcTangent),
        ("LN", NumberFunction::NaturalLogarithm),
        ("LOG", NumberFunction::Logarithm),
        ("EXP", NumberFunction::Exponential),
        ("NEG", NumberFunction::Negative),
        ("INT", NumberFunction::Integer),
        ("ABS", NumberFunction::Absolute),
        ("FRAC", NumberFunction::Fraction),
        ("SGN", NumberFunction::Sign),
    ];
    for (name, function) in names {
        let wanted = assign(3, Expression::Function(function, Box::new(Expression::Value(q(4)))));
        check(&[&format!("Q3 = {name} Q4"), &format!("q3={} ( q4 )", name.to_lowercase())], &wanted);
    }
}

#[test]
fn numbers_have_point_or_comma_and_need_no_digits_on_one_side() {
    check_formula("12,75", "12.75");
    check_formula("12.75", "12.75");
    check_formula("25,", "25");
    check_formula(",5", "0.5");
    check_formula(".5 + 25.", "[0.5 + 25]");
    check_formula("0007", "7");
}

#[test]
fn functions_of_texts_give_numbers() {
    check_formula("TONUMB ( SRC_QS11 )", "number of QS11");
    check_formula("INSTR ( SRC_QS10 SEA_QS13 BEG2 )", "QS13 in QS10 from 2");
    check_formula("INSTR(SRC_QS10 SEA_QS13 BEG+Q2)", "QS13 in QS10 from Q2");
    check_formula("STRLEN ( SRC_QS15 ) - 1", "[length of QS15 - 1]");
    check_formula("STRCOMP ( SRC_QS12 SEA_QS14 )", "QS12 to QS14");
}

#[test]
fn fn_0_to_8_and_13_are_formulas_in_other_words() {
    let value = |operand| Expression::Value(operand);
    let two = |operation, left, right| Expression::Binary(operation, Box::new(value(left)), Box::new(value(right)));
    let one = |function, operand| Expression::Function(function, Box::new(value(operand)));
    check(&["FN 0: Q5 = +60", "FN0 : Q5 = 60", "fn 0:q5=+60", "Q5 = 60"], &assign(5, value(number(60.0))));
    check(&["FN0 : Q1 = -200.66", "FN 0: Q1 = - 200,66"], &assign(1, value(number(-200.66))));
    check(&["FN 0: Q1 = -Q2"], &assign(1, value(minus_q(2))));
    check(&["FN 1: Q1 = -Q2 + -5"], &assign(1, two(Operation::Add, minus_q(2), number(-5.0))));
    check(&["FN 2: Q1 = +10 - +5", "FN2:Q1=10-5"], &assign(1, two(Operation::Subtract, number(10.0), number(5.0))));
    check(&["FN 3: Q2 = +3 * +3"], &assign(2, two(Operation::Multiply, number(3.0), number(3.0))));
    check(&["FN 4: Q4 = +8 DIV +Q2", "FN 4: Q4 = 8 / Q2"], &assign(4, two(Operation::Divide, number(8.0), q(2))));
    check(&["FN 5: Q20 = SQRT 4", "FN 5: Q20 = SQRT +4"], &assign(20, one(NumberFunction::SquareRoot, number(4.0))));
    check(&["FN 6: Q20 = SIN-Q5"], &assign(20, one(NumberFunction::Sine, minus_q(5))));
    check(&["FN 7: Q21 = COS-Q5"], &assign(21, one(NumberFunction::Cosine, minus_q(5))));
    check(&["FN 8: Q10 = +5 LEN +4"], &assign(10, two(Operation::Hypotenuse, number(5.0), number(4.0))));
    check(&["FN 13: Q20 = +25 ANG-Q1"], &assign(20, two(Operation::Angle, number(25.0), minus_q(1))));
    let qr = |number| Parameter { family: Family::Qr, number };
    let of = |parameter| Operand::Parameter { parameter, is_negative: false };
    let sum = two(Operation::Add, of(qr(1)), number(20.0));
    check(&["FN 1: QR10 =+QR1 + +20"], &Body::Assign { to: qr(10), value: sum });
    check(&["FN 0: Q5 SET UNDEFINED", "Q5 SET UNDEFINED"], &Body::Undefine(Parameter::q(5)));
}

#[test]
fn texts_are_assigned_joined_and_made() {
    let assign = |to, value| Body::AssignText { to: Parameter::qs(to), value };
    let literal = |literal| TextExpression::Value(text(literal));
    let qs = |number| TextExpression::Value(TextOperand::Parameter(Parameter::qs(number)));
    check(&["DECLARE STRING QS1 = \"H7\"", "QS1 = \"H7\"", "declare string qs1=\"H7\";x"], &assign(1, literal("H7")));
    check(&["QS1 = \"a;b\" ;c"], &assign(1, literal("a;b")));
    check(&["QS1 = \"\""], &assign(1, literal("")));
    check(&["QS1 = QS2"], &assign(1, qs(2)));
    check(&["QS10 = QS12 || QS13 || \"x\""], &assign(10, TextExpression::Join(vec![qs(12), qs(13), literal("x")])));
    let made = |decimals| TextExpression::FromNumber { number: q(50), decimals };
    check(
        &["QS11 = TOCHAR ( DAT+Q50 DECIMALS3 )", "QS11=TOCHAR(DATQ50 DECIMALS3)"],
        &assign(11, made(Some(number(3.0)))),
    );
    check(&["QS11 = TOCHAR ( DAT+Q50 )"], &assign(11, made(None)));
    let part = |length| TextExpression::Part { source: Parameter::qs(10), from: number(2.0), length };
    check(&["QS13 = SUBSTR ( SRC_QS10 BEG2 LEN4 )"], &assign(13, part(Some(number(4.0)))));
    check(&["QS13 = SUBSTR ( SRC_QS10 BEG2 )"], &assign(13, part(None)));
    let system = TextExpression::System { id: number(10321.0), number: number(0.0) };
    check(&["QS5 = SYSSTR ( ID10321 NR0 )"], &assign(5, system));
}

#[test]
fn jumps_have_conditions_and_labels() {
    let jump =
        |left, relation, right, label| Body::Jump { condition: Condition::Compare(left, relation, right), label };
    let upcan = jump(q(1), Relation::Equal, q(3), name("UPCAN25"));
    check(&["FN 9: IF +Q1 EQU +Q3 GOTO LBL \"UPCAN25\"", "FN9:IF+Q1EQU+Q3 GOTO LBL\"UPCAN25\""], &upcan);
    check(
        &["FN 10: IF +10 NE -Q5 GOTO LBL 10"],
        &jump(number(10.0), Relation::NotEqual, minus_q(5), Target::Number(10)),
    );
    let by_text = Target::Parameter(Parameter::qs(5));
    check(&["FN 11: IF +Q1 GT +10 GOTO LBL QS5"], &jump(q(1), Relation::Greater, number(10.0), by_text));
    check(&["FN 12: IF Q5 LT +0 GOTO LBL \"a b\""], &jump(q(5), Relation::Less, number(0.0), name("a b")));
    let defined = |condition| Body::Jump { condition, label: name("X") };
    let undefined = Condition::IsUndefined(Parameter::q(1));
    check(&["FN 9: IF +Q1 IS UNDEFINED GOTO LBL \"X\""], &defined(undefined));
    check(&["FN 9: IF QS1 IS DEFINED GOTO LBL \"X\""], &defined(Condition::IsDefined(Parameter::qs(1))));
}

#[test]
fn labels_and_calls() {
    check(&["LBL 11", "LBL11", "lbl 11 ;x"], &Body::Label(Target::Number(11)));
    check(&["LBL \"LOOP\""], &Body::Label(name("LOOP")));
    let call = |label, repeat| Body::CallLabel { label, repeat };
    check(&["CALL LBL 7", "CALL LBL7"], &call(Target::Number(7), None));
    check(&["CALL LBL \"NAME\""], &call(name("NAME"), None));
    check(&["CALL LBL QS5"], &call(Target::Parameter(Parameter::qs(5)), None));
    check(&["CALL LBL 5 REP 3", "CALL LBL 5 REP3", "CALL LBL 5 REP 3/3"], &call(Target::Number(5), Some(number(3.0))));
    check(&["CALL PGM TNC:\\Plan.h", "CALL PGM TNC:\\Plan.h ;x"], &Body::CallProgram(text("TNC:\\Plan.h")));
    check(&["CALL PGM ..\\a b.h"], &Body::CallProgram(text("..\\a b.h")));
    check(&["CALL PGM \"TNC:\\a;b.h\""], &Body::CallProgram(text("TNC:\\a;b.h")));
    check(&["CALL PGM QS5"], &Body::CallProgram(TextOperand::Parameter(Parameter::qs(5))));
    check(&["CALL LBL 5 REP Q7", "CALL LBL 5 REPQ7"], &call(Target::Number(5), Some(q(7))));
    check(&["SEL PGM \"TNC:\\a.h\""], &Body::SelectProgram(text("TNC:\\a.h")));
    check(&["CALL SELECTED PGM"], &Body::CallSelectedProgram);
}

#[test]
fn functions_for_errors_prints_and_tables() {
    check(&["FN 14: ERROR= 1005", "FN 14: ERROR = 1005", "FN14:ERROR=+1005"], &Body::Error(number(1005.0)));
    let print = |mask, output| Body::Print { mask, output };
    check(
        &["FN 16: F-PRINT TNC:\\A.A / SCREEN:", "FN16:F-PRINT TNC:\\A.A/SCREEN:"],
        &print(text("TNC:\\A.A"), text("SCREEN:")),
    );
    check(&["FN 16: F-PRINT TNC:\\a b.a / TNC:\\c d.txt"], &print(text("TNC:\\a b.a"), text("TNC:\\c d.txt")));
    let qs = |number| TextOperand::Parameter(Parameter::qs(number));
    check(&["FN 16: F-PRINT :'QS1' / :'QS2'", "FN 16: F-PRINT QS1 / QS2"], &print(qs(1), qs(2)));
    check(&["FN 26: TABOPEN TNC:\\table\\tool.t"], &Body::TableOpen(text("TNC:\\table\\tool.t")));
    let names = |names: &[&str]| Columns::Names(names.iter().map(ToString::to_string).collect());
    let read = |row, columns| Body::TableRead { to: Parameter::q(10), row, columns };
    check(
        &["FN 28: TABREAD Q10 = 6/\"X,Y,D\"", "FN 28: TABREAD Q10=+6 / \"X, Y ,D\""],
        &read(number(6.0), names(&["X", "Y", "D"])),
    );
    check(&["FN 28: TABREAD Q10 = +Q22/QS1"], &read(q(22), Columns::Parameter(Parameter::qs(1))));
    let write = Body::TableWrite { row: number(40.0), columns: names(&["NAME"]), from: Parameter::qs(10) };
    check(&["FN 27: TABWRITE 40/\"NAME\" = QS10"], &write);
    let datum = SystemDatum { group: 270, number: Some(number(1.0)), index: Some(number(1.0)) };
    let system = |datum| Body::SystemRead { to: Parameter::q(1), datum };
    check(&["FN 18: SYSREAD Q1 = ID270 NR1 IDX1", "FN18 : SYSREAD Q1 = ID270 NR1 IDX+1"], &system(Some(datum)));
    let by_parameter = SystemDatum { group: 50, number: Some(number(19.0)), index: Some(q(1)) };
    check(&["FN 18: SYSREAD Q1 = ID50 NR19 IDXQ1"], &system(Some(by_parameter)));
    check(&["FN 18: SYSREAD Q1 = SOMETHING ELSE"], &system(None));
    check(&["FN 25: PRESET", "FN 99: X"], &Body::Other);
}

#[test]
fn lines_have_axes_feed_and_machine_functions() {
    let line = |text: &str| {
        let Body::Move(movement) = body(text) else { panic!("{text}") };
        movement
    };
    let axis = |axis, value| AxisWord { axis, is_incremental: false, value };
    let movement = line("L  X+10  Y+Q21 R0 FMAX M3");
    assert_eq!(movement.axes, [axis(Axis::X, number(10.0)), axis(Axis::Y, q(21))]);
    assert_eq!((movement.compensation.as_deref(), movement.feed), (Some("R0"), Some(Feed::Rapid)));
    assert_eq!(movement.machine, [machine(3, "")]);
    let incremental = line("L IX-QR4");
    let qr4 = Parameter { family: Family::Qr, number: 4 };
    let value = Operand::Parameter { parameter: qr4, is_negative: true };
    assert_eq!(incremental.axes, [AxisWord { axis: Axis::X, is_incremental: true, value }]);
    assert_eq!(line("L X + 0 Y0 Z - 2,5").axes, line("L  X+0  Y+0  Z-2.5").axes);
    assert_eq!(line("L X+10 FQ1822").feed, Some(Feed::Value(q(1822))));
    assert_eq!(line("L X+10 F 200 M3").feed, Some(Feed::Value(number(200.0))));
    assert_eq!(line("L X+25, FAUTO").feed, Some(Feed::Auto));
    assert_eq!(line("L Z-1 FMAX M91").machine, [machine(91, "")]);
    assert_eq!(line("L M140 MB MAX").machine, [machine(140, "MB MAX")]);
    assert_eq!(line("L  B+0  C+0 R0 F MAX M126 M128 F1000").machine, [machine(126, ""), machine(128, "F1000")]);
}

#[test]
fn stops_machine_functions_and_tools() {
    check(&["STOP"], &Body::Stop(vec![]));
    check(&["STOP M6", "stop m6"], &Body::Stop(vec![machine(6, "")]));
    check(&["M30", "M 30"], &Body::MachineFunctions(vec![machine(30, "")]));
    check(&["M5 M9"], &Body::MachineFunctions(vec![machine(5, ""), machine(9, "")]));
    let call = |tool, axis, rest: &str| Body::ToolCall { tool, axis, rest: rest.to_owned() };
    let by_number = |value| Some(Tool::Number(value));
    check(&["TOOL CALL 5 Z"], &call(by_number(number(5.0)), Some(Axis::Z), ""));
    check(&["TOOL CALL 5.1 Z S50 F100"], &call(by_number(number(5.1)), Some(Axis::Z), "S50 F100"));
    check(&["TOOL CALL Q5 Z DL+0.1"], &call(by_number(q(5)), Some(Axis::Z), "DL+0.1"));
    check(&["TOOL CALL \"PROBE 1\" Z S100"], &call(Some(Tool::Name(text("PROBE 1"))), Some(Axis::Z), "S100"));
    let by_text = Tool::Name(TextOperand::Parameter(Parameter::qs(4)));
    check(&["TOOL CALL QS4"], &call(Some(by_text), None, ""));
    check(&["TOOL CALL S2000"], &call(None, None, "S2000"));
    check(&["TOOL CALL Z S2000"], &call(None, Some(Axis::Z), "S2000"));
}

#[test]
fn cycles_have_lines_in_any_order_and_language() {
    let text = "5 TCH PROBE 421 METEN BORING ~\n Q274=+Q21;MITTE ~\n\n    Q273 = + 50,5 ;CENTRO~\n  Q320= PREDEF ;x ~\n\
                ; only a comment ~\n Q1=Q2 Q5=-3 ;two ~\n QS400=\"1-2\" ~\n QS401 = QS5\n6 M30";
    let bodies = bodies(text);
    let Body::Probe(cycle) = &bodies[0] else { panic!("{bodies:?}") };
    let lines: Vec<String> = cycle
        .lines
        .iter()
        .map(|line| {
            let value = match &line.value {
                CycleValue::Number { value, text } => format!("{value:?} {text}"),
                other => format!("{other:?}"),
            };
            format!("{}:{} {} {value} ;{}", line.place.line, line.place.column, line.parameter, line.comment)
        })
        .collect();
    let parameter = |number| format!("Parameter {{ parameter: {:?}, is_negative: false }}", Parameter::q(number));
    assert_eq!(
        lines,
        [
            format!("3:2 Q274 {} +Q21 ;MITTE", parameter(21)),
            "5:5 Q273 Number(50.5) +50,5 ;CENTRO".to_owned(),
            "6:3 Q320 Word(\"PREDEF\") ;x".to_owned(),
            format!("8:2 Q1 {} Q2 ;two", parameter(2)),
            "8:8 Q5 Number(-3.0) -3 ;two".to_owned(),
            "9:2 QS400 Text(Text(\"1-2\")) ;".to_owned(),
            format!("10:2 QS401 Text(Parameter({:?})) ;", Parameter::qs(5)),
        ]
    );
    let Body::CycleDefinition(drilling) = body("CYCL DEF 200 DRILLING ~\nQ200=2") else { panic!() };
    assert_eq!((drilling.number.as_str(), drilling.name.as_str(), drilling.lines.len()), ("200", "DRILLING", 1));
}

#[test]
fn headings_comments_and_blank_blocks() {
    let heading = |depth, text: &str| Body::Heading { depth, text: text.to_owned() };
    check(&["* - limits", "7 * - limits", "*- limits"], &heading(1, "limits"));
    check(&["*   - deeper; \"still", "* -   deeper; \"still"], &heading(2, "deeper; \"still"));
    check(&["*     - deepest"], &heading(3, "deepest"));
    check(&["7", "7 ;", "; comment", "/ ; x", "8 ; long ~\n and \"longer ~\n 9 lives"], &Body::Nothing);
}

#[test]
fn a_block_that_is_no_cycle_may_go_on_in_the_next_line() {
    check(&["Q1 = 5 + ~\n  ( 3 ~\n )"], &body("Q1 = 5 + ( 3 )"));
    // The star does not begin a heading here, so the comment ends the line.
    check(&["Q1 = 5 ~\n  * 3 ; three"], &body("Q1 = 5 * 3"));
}

#[test]
fn the_skip_mark_stands_on_either_side_of_the_number() {
    let text = "0 BEGIN PGM a INCH\n/43 L X+10\n44 /L Y+10\n/ M5\n45 M6\nend pgm a inch";
    let (program, warnings) = Program::read(text.as_bytes()).unwrap();
    assert!(warnings.is_empty(), "{warnings:?}");
    let skipped: Vec<_> = program.blocks().iter().map(|block| (block.number, block.may_be_skipped)).collect();
    let wanted = [(Some(0), false), (Some(43), true), (Some(44), true), (None, true), (Some(45), false), (None, false)];
    assert_eq!(skipped, wanted);
    assert_eq!(program.unit(), Some(Unit::Inch));
    assert!(!program.blocks().iter().any(|block| block.body == Body::Other));
}
