//! What is true of any bytes, and of any body that is written.

use fitcheck::control::variables::{Family, Parameter};
use fitcheck::nc::program::{
    Axis, AxisWord, Body, Columns, Condition, CycleBlock, CycleLine, CycleName, CycleValue, Expression, Feed,
    MachineFunction, Mode, Movement, NumberFunction, Operand, Operation, Program, Relation, Target, TextExpression,
    TextOperand, TextPlace, Tool, Unit, write,
};
use proptest::prelude::*;
use proptest::sample::select;

/// What is true of every file that is read.
pub(super) fn sound(bytes: &[u8]) -> Result<(), TestCaseError> {
    let Ok((program, warnings)) = Program::read(bytes) else { return Ok(()) };
    prop_assert_eq!(program.write(), bytes);
    // Every line that is not blank belongs to exactly one block, in order.
    let mut behind = 0;
    for (index, block) in program.blocks().iter().enumerate() {
        prop_assert!(behind <= block.lines.start && block.lines.start < block.lines.end);
        let is_blank =
            |line: usize| program.line(line).chars().all(|c| c.is_whitespace() || "\u{1a}\u{feff}".contains(c));
        prop_assert!((behind..block.lines.start).all(is_blank));
        prop_assert!(!is_blank(block.lines.start) && !is_blank(block.lines.end - 1));
        prop_assert_eq!(program.block_at(block.lines.start), Some(index));
        behind = block.lines.end;
    }
    prop_assert!(behind <= program.line_count());
    for warning in warnings {
        let (number, column) = (warning.place.line.unwrap(), warning.place.column.unwrap());
        let line = program.line(number - 1);
        prop_assert!(number <= program.line_count());
        prop_assert!(1 <= column && column <= line.chars().count() + 1);
    }
    Ok(())
}

/// Pieces of the language where mistakes are likely.
const PIECES: [&str; 60] = [
    "BEGIN PGM ",
    "END PGM ",
    " MM",
    " INCH",
    "\n",
    "\r\n",
    "\0",
    "~\n",
    " ",
    "/",
    ";",
    "\"",
    "* - ",
    "LBL ",
    "CALL LBL ",
    " REP ",
    "CALL PGM ",
    "TNC:\\",
    "FN 0: ",
    "FN 9: IF ",
    " EQU ",
    " NE ",
    " IS DEFINED",
    " GOTO LBL ",
    "FN 1:",
    "FN 14: ERROR=",
    "FN 16: F-PRINT ",
    "FN 26: TABOPEN ",
    "FN 27: TABWRITE ",
    "FN 28: TABREAD ",
    "DECLARE STRING ",
    "TOOL CALL ",
    "L ",
    "IX",
    "Y",
    "R0",
    "FMAX",
    "F",
    "M",
    "STOP",
    "TCH PROBE ",
    "CYCL DEF ",
    "Q1",
    "QS2",
    "QL499",
    "QR",
    " = ",
    "+",
    "-",
    "*",
    "^",
    "(",
    ")",
    "SIN ",
    "TOCHAR ( DAT",
    "SRC_",
    "||",
    "7",
    "12,5",
    "é",
];

proptest! {
    #[test]
    fn any_bytes_are_read_or_refused(bytes in prop::collection::vec(any::<u8>(), 0..400)) {
        sound(&bytes)?;
    }

    #[test]
    fn any_text_is_read(text in "[ -~\n\r\t~;\"äß]{0,300}") {
        sound(text.as_bytes())?;
    }

    #[test]
    fn any_pieces_of_the_language_are_read(pieces in prop::collection::vec(select(&PIECES[..]), 0..80)) {
        sound(pieces.concat().as_bytes())?;
    }

    #[test]
    fn windows_1252_is_written_as_it_was(bytes in prop::collection::vec(b' '..=255, 1..200)) {
        sound(&[b"BEGIN PGM a MM\r\n;", bytes.as_slice(), b"\xe4\r\nEND PGM a MM \r\n"].concat())?;
    }

    #[test]
    fn what_is_written_reads_back(bodies in prop::collection::vec(body(), 0..12)) {
        let begin = Body::Begin { name: "a b".to_owned(), unit: Unit::Inch };
        let end = Body::End { name: "a b".to_owned(), unit: Unit::Inch };
        let bodies: Vec<Body> = [vec![begin], bodies, vec![end]].concat();
        let text = write::program(bodies.iter().map(|body| (body, "x; \"y")));
        let (program, warnings) = Program::read(text.as_bytes()).unwrap();
        // A label may occur twice, and behind a cycle something may be set that looks like its next line.
        let is_known = |warning: &str| warning.contains("already defined") || warning.contains("has no ~ at its end");
        let odd = warnings.iter().find(|warning| !is_known(&warning.to_string()));
        prop_assert!(odd.is_none(), "{}\n{}", odd.unwrap(), text);
        let read: Vec<Body> = program.blocks().iter().map(|block| without_places(&block.body)).collect();
        prop_assert_eq!(read, bodies, "{}", text);
        for (number, block) in (0..).zip(program.blocks()) {
            prop_assert_eq!(block.number, Some(number));
            let is_heading = matches!(block.body, Body::Heading { .. });
            prop_assert!(is_heading || program.comment_of(usize::try_from(number).unwrap()) == Some("x; \"y"));
        }
    }
}

const NOWHERE: TextPlace = TextPlace { line: 0, column: 0 };

fn without_places(body: &Body) -> Body {
    let mut body = body.clone();
    match &mut body {
        Body::Probe(cycle) | Body::CycleDefinition(cycle) | Body::GlobalDefinition(cycle) => {
            cycle.lines.iter_mut().for_each(|line| line.place = NOWHERE);
        }
        // The comment of a heading is part of it.
        Body::Heading { text, .. } => *text = text.trim_end_matches(" ;x; \"y").to_owned(),
        _ => {}
    }
    body
}

fn number() -> impl Strategy<Value = f64> {
    prop_oneof![
        (-1000..1000).prop_map(f64::from),
        (-99_999_999..99_999_999).prop_map(|number| f64::from(number) / 10_000.0),
        any::<f64>().prop_filter("finite", |number| number.is_finite()),
    ]
}

fn numeric() -> impl Strategy<Value = Parameter> {
    let family = |family, most: u16| (0..=most).prop_map(move |number| Parameter { family, number });
    prop_oneof![family(Family::Q, 1999), family(Family::Ql, 499), family(Family::Qr, 499)]
}

fn textual() -> impl Strategy<Value = Parameter> {
    (0..=1999_u16).prop_map(Parameter::qs)
}

fn operand() -> impl Strategy<Value = Operand> {
    let parameter =
        (numeric(), any::<bool>()).prop_map(|(parameter, is_negative)| Operand::Parameter { parameter, is_negative });
    prop_oneof![number().prop_map(Operand::Number), parameter]
}

fn formula() -> impl Strategy<Value = Expression> {
    let leaf = prop_oneof![
        operand().prop_map(Expression::Value),
        Just(Expression::Pi),
        textual().prop_map(Expression::ToNumber),
        textual().prop_map(Expression::TextLength),
        (textual(), textual()).prop_map(|(source, other)| Expression::Compare { source, other }),
        (textual(), textual(), operand()).prop_map(|(source, wanted, from)| Expression::Position {
            source,
            wanted,
            from
        }),
    ];
    let functions = select(vec![
        NumberFunction::Square,
        NumberFunction::ArcTangent,
        NumberFunction::Negative,
        NumberFunction::Absolute,
        NumberFunction::Sign,
    ]);
    let operations = select(vec![
        Operation::Add,
        Operation::Subtract,
        Operation::Multiply,
        Operation::Divide,
        Operation::Power,
        Operation::Remainder,
    ]);
    leaf.prop_recursive(5, 40, 2, move |inner| {
        prop_oneof![
            (functions.clone(), inner.clone())
                .prop_map(|(function, operand)| Expression::Function(function, Box::new(operand))),
            (operations.clone(), inner.clone(), inner).prop_map(|(operation, left, right)| Expression::Binary(
                operation,
                Box::new(left),
                Box::new(right)
            )),
        ]
    })
}

/// FN 8 and FN 13 stand alone.
fn special() -> impl Strategy<Value = Expression> {
    let operations = select(vec![Operation::Hypotenuse, Operation::Angle]);
    let value = || operand().prop_map(|operand| Box::new(Expression::Value(operand)));
    (operations, value(), value()).prop_map(|(operation, left, right)| Expression::Binary(operation, left, right))
}

fn words() -> &'static str {
    "[A-Za-z0-9_.äß]([A-Za-z0-9_. äß-]{0,20}[A-Za-z0-9_.äß])?"
}

fn text_operand() -> impl Strategy<Value = TextOperand> {
    let any = "[ !#-~äß]{0,20}".prop_map(TextOperand::Text);
    prop_oneof![any, textual().prop_map(TextOperand::Parameter)]
}

fn text_item() -> impl Strategy<Value = TextExpression> {
    prop_oneof![
        text_operand().prop_map(TextExpression::Value),
        (operand(), prop::option::of(operand()))
            .prop_map(|(number, decimals)| TextExpression::FromNumber { number, decimals }),
        (textual(), operand(), prop::option::of(operand())).prop_map(|(source, from, length)| TextExpression::Part {
            source,
            from,
            length
        }),
        (operand(), operand()).prop_map(|(id, number)| TextExpression::System { id, number }),
    ]
}

fn text_formula() -> impl Strategy<Value = TextExpression> {
    prop_oneof![text_item(), prop::collection::vec(text_item(), 2..5).prop_map(TextExpression::Join)]
}

fn known_label() -> impl Strategy<Value = Target> {
    prop_oneof![(0..=65_535_u32).prop_map(Target::Number), "[ !#-~äß]{0,12}".prop_map(Target::Name)]
}

fn label() -> impl Strategy<Value = Target> {
    prop_oneof![known_label(), textual().prop_map(Target::Parameter), numeric().prop_map(Target::Parameter)]
}

fn condition() -> impl Strategy<Value = Condition> {
    let relation = select(vec![Relation::Equal, Relation::NotEqual, Relation::Greater, Relation::Less]);
    prop_oneof![
        (operand(), relation, operand()).prop_map(|(left, relation, right)| Condition::Compare(left, relation, right)),
        prop_oneof![numeric().boxed(), textual().boxed()].prop_map(Condition::IsDefined),
        textual().prop_map(Condition::IsUndefined),
    ]
}

fn columns() -> impl Strategy<Value = Columns> {
    prop_oneof![
        prop::collection::vec("[A-Za-z0-9]{1,6}", 1..4).prop_map(Columns::Names),
        textual().prop_map(Columns::Parameter)
    ]
}

fn axis() -> impl Strategy<Value = Axis> {
    select(vec![Axis::X, Axis::Y, Axis::Z, Axis::A, Axis::B, Axis::C, Axis::U, Axis::V, Axis::W])
}

fn machine_functions() -> impl Strategy<Value = Vec<MachineFunction>> {
    let rest = prop_oneof![Just(""), Just("MB MAX"), Just("F1000")].prop_map(str::to_owned);
    let one = (0..=9999_u32, rest).prop_map(|(number, rest)| MachineFunction { number, rest });
    prop::collection::vec(one, 1..3)
}

fn movement() -> impl Strategy<Value = Movement> {
    let word = (axis(), any::<bool>(), operand()).prop_map(|(axis, is_incremental, value)| AxisWord {
        axis,
        is_incremental,
        value,
    });
    let axes = prop::collection::vec(word, 0..4).prop_map(|mut axes| {
        axes.sort_by_key(|word| word.axis);
        axes.dedup_by_key(|word| word.axis);
        axes
    });
    let compensation = prop::option::of(select(vec!["R0", "RL", "RR"]).prop_map(str::to_owned));
    let feed = prop_oneof![Just(Feed::Rapid), Just(Feed::Auto), operand().prop_map(Feed::Value)];
    (axes, compensation, prop::option::of(feed), prop_oneof![Just(Vec::new()), machine_functions()])
        .prop_map(|(axes, compensation, feed, machine)| Movement { axes, compensation, feed, machine })
}

fn cycle() -> impl Strategy<Value = CycleBlock> {
    let value = prop_oneof![
        operand().prop_map(|value| {
            let text = match value {
                Operand::Number(number) => format!("{number:+}"),
                Operand::Parameter { parameter, is_negative } => {
                    format!("{}{parameter}", if is_negative { "-" } else { "+" })
                }
            };
            CycleValue::Number { value, text }
        }),
        text_operand().prop_map(CycleValue::Text),
        select(vec!["MAX", "AUTO", "PREDEF"]).prop_map(|word| CycleValue::Word(word.to_owned())),
    ];
    let word = select(vec!["MB", "x"]).prop_map(|word| CycleName::Word(word.to_owned()));
    let parameter = prop_oneof![
        numeric().prop_map(CycleName::Parameter).boxed(),
        textual().prop_map(CycleName::Parameter).boxed(),
        word.boxed()
    ];
    let line = (parameter, value, prop_oneof![Just(String::new()), words().prop_map(|text| text)])
        .prop_map(|(parameter, value, comment)| CycleLine { parameter, value, place: NOWHERE, comment });
    (select(vec!["421", "427", "14.1"]), words(), prop::collection::vec(line, 0..6))
        .prop_map(|(number, name, lines)| CycleBlock { number: number.to_owned(), name, lines })
}

fn tool_call() -> impl Strategy<Value = Body> {
    let tool = prop_oneof![operand().prop_map(Tool::Number), text_operand().prop_map(Tool::Name)];
    let rest = prop_oneof![Just(""), Just("S2000"), Just("S50 DL+0.1")].prop_map(str::to_owned);
    (prop::option::of(tool), prop::option::of(axis()), rest).prop_map(|(tool, axis, rest)| Body::ToolCall {
        tool,
        axis,
        rest,
    })
}

/// Every kind of body except the beginning, the end and what is kept as text.
fn body() -> impl Strategy<Value = Body> {
    let parameter = || prop_oneof![numeric().boxed(), textual().boxed()];
    prop_oneof![
        Just(Body::Nothing),
        (1..9_usize, words()).prop_map(|(depth, text)| Body::Heading { depth, text }),
        known_label().prop_map(Body::Label),
        (label(), prop::option::of(0..=65_534_u32)).prop_map(|(label, repeat)| Body::CallLabel {
            label,
            repeat: repeat.map(|repeat| Operand::Number(f64::from(repeat)))
        }),
        text_operand().prop_map(Body::CallProgram),
        (numeric(), prop_oneof![formula().boxed(), special().boxed()])
            .prop_map(|(to, value)| Body::Assign { to, value }),
        parameter().prop_map(Body::Undefine),
        (textual(), text_formula()).prop_map(|(to, value)| Body::AssignText { to, value }),
        (condition(), label()).prop_map(|(condition, label)| Body::Jump { condition, label }),
        operand().prop_map(Body::Error),
        (text_operand(), text_operand()).prop_map(|(mask, output)| Body::Print { mask, output }),
        text_operand().prop_map(Body::TableOpen),
        (parameter(), operand(), columns()).prop_map(|(to, row, columns)| Body::TableRead { to, row, columns }),
        (operand(), columns(), parameter()).prop_map(|(row, columns, from)| Body::TableWrite { row, columns, from }),
        tool_call(),
        movement().prop_map(Body::Move),
        machine_functions().prop_map(Body::MachineFunctions),
        prop_oneof![Just(Vec::new()), machine_functions()].prop_map(Body::Stop),
        cycle().prop_map(Body::Probe),
        cycle()
            // Dotted ones are not one block, and measuring ones begin with TCH PROBE.
            .prop_map(|cycle| Body::CycleDefinition(CycleBlock { number: "208".to_owned(), ..cycle })),
        cycle().prop_map(Body::GlobalDefinition),
        text_operand().prop_map(Body::SelectProgram),
        Just(Body::CallSelectedProgram),
        select(vec![Mode::Mill, Mode::Turn, Mode::Grind]).prop_map(Body::Mode),
    ]
}
