//! DIN PLUS programs of lathe controls: what each form says, what is refused, and what a run makes of it.

use std::path::Path;
use std::sync::Arc;

use fitcheck::control::variables::{Parameter, Value};
use fitcheck::nc::machine::{Contacts, InMemory, Machine, Pause, Settings, Step};
use fitcheck::nc::program::{
    Axis, Body, Feed, Goes, Notation, Operand, PassedOver, Program, Target, TextOperand, Tool, Unit,
};
use fitcheck::probing::simulated::Simulation;
use fitcheck::words::Dialogue;
use proptest::prelude::*;
use proptest::sample::select;

use super::properties::sound;

fn sample() -> Vec<u8> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/samples/programs");
    std::fs::read(folder.join("fit_lathe.nc")).unwrap()
}

/// How many lines stand before the blocks of [`text`].
const BEFORE: usize = 4;

/// A whole program with these blocks.
fn text(blocks: &str) -> String {
    format!("%T.nc\nPROGRAMMKOPF\n#EINHEIT METRISCH\nBEARBEITUNG\n{blocks}\nENDE\n")
}

fn read(text: &str) -> (Program, Vec<String>) {
    let (program, warnings) = Program::read(text.as_bytes()).unwrap();
    assert_eq!(program.notation(), Notation::DinPlus, "{text}");
    (program, warnings.iter().map(ToString::to_string).collect())
}

/// The body of a block; there must be no warning.
#[track_caller]
fn body(block: &str) -> Body {
    let (program, warnings) = read(&text(block));
    assert_eq!(warnings, [""; 0], "{block}");
    program.blocks()[BEFORE].body.clone()
}

/// What is said about a block that is kept as text; lines count from the block's own.
#[track_caller]
fn refused(blocks: &str) -> String {
    let (program, warnings) = read(&text(blocks));
    assert!(program.blocks().iter().any(|block| block.body == Body::Other), "{blocks}");
    let place = warnings[0].strip_prefix("line ").unwrap();
    let (line, rest) = place.split_once(',').unwrap();
    format!(
        "{},{}",
        line.parse::<usize>().unwrap() - BEFORE,
        rest.replace("column ", "").replace("not understood: ", "")
    )
}

fn passed_over(words: &str, goes: Goes) -> Body {
    Body::PassedOver(PassedOver { words: words.to_owned(), goes, machine: Vec::new() })
}

fn settings() -> Settings {
    Settings::new(Dialogue::En, jiff::civil::date(2026, 3, 7).at(8, 5, 9, 0))
}

fn hole(diameter: &str) -> Contacts {
    let text = format!("[bore]\ncentre = [0.0, 0.0]\ndiameter = {diameter}\n");
    Contacts::Workpiece(Simulation::read(&text).unwrap().into())
}

fn machine_with(text: &[u8], store: InMemory, contacts: Contacts) -> Machine {
    Machine::new("t.nc", Arc::new(Program::read(text).unwrap().0), store, contacts, settings())
}

fn machine(blocks: &str) -> Machine {
    machine_with(text(blocks).as_bytes(), InMemory::new(), Contacts::Perfect)
}

/// Runs to the end; returns the blocks that paused.
#[track_caller]
fn to_end(machine: &mut Machine) -> Vec<Pause> {
    let mut pauses = Vec::new();
    loop {
        match machine.run(100_000).unwrap_or_else(|fault| panic!("{fault}")) {
            Step::Ended => return pauses,
            Step::Paused(pause) => pauses.push(pause),
            Step::Went => panic!("it does not end"),
        }
    }
}

#[track_caller]
fn ran(blocks: &str) -> Machine {
    let mut machine = machine(blocks);
    to_end(&mut machine);
    machine
}

#[track_caller]
fn fault(blocks: &str) -> String {
    machine(blocks).run(100_000).unwrap_err().kind.to_string()
}

fn value(machine: &Machine, name: &str) -> Option<f64> {
    let name: Parameter = name.parse().unwrap();
    match machine.variables().get(name) {
        Some(Value::Number(number)) => Some(*number),
        Some(Value::Length(length)) => Some(length.to_mm_f64()),
        other => {
            assert_eq!(other, None, "{name}");
            None
        }
    }
}

fn remarks(machine: &Machine) -> Vec<String> {
    machine.remarks().iter().map(|(place, remark)| format!("{}: {remark}", place.block)).collect()
}

#[test]
fn the_notation_is_told_by_what_the_text_says() {
    let notation = |text: &str| Program::read(text.as_bytes()).unwrap().0.notation();
    for text in [
        "%A.nc\nBEARBEITUNG\nENDE",
        "\n[a comment]\n%A.ncs \"TURN_V1.0\"\n",
        "%A\nPROGRAM HEAD\n",
        "MACHINING\nN1 M30\nEND",
        "PROGRAMMKOPF\n",
        "% A.NC [x]\n",
    ] {
        assert_eq!(notation(text), Notation::DinPlus, "{text}");
    }
    for text in
        ["0 BEGIN PGM A MM\n1 M30\n2 END PGM A MM\n", "%A G71 *\nN10 M30 *\n", "BEARBEITUNG 5 mm", "END", "Q1 = 5"]
    {
        assert_ne!(notation(text), Notation::DinPlus, "{text}");
    }
}

#[test]
fn the_sample_is_read_without_a_warning_and_written_as_it_was() {
    let (program, warnings) = Program::read(&sample()).unwrap();
    assert_eq!(warnings, []);
    assert_eq!(program.write(), sample());
    assert_eq!((program.name(), program.unit()), (Some("FIT_LATHE.nc"), Some(Unit::Mm)));
    assert!(program.blocks().iter().all(|block| block.body != Body::Other));
    assert_eq!(program.blocks()[11].number, Some(3));
    assert_eq!(program.comment_of(11), Some("nominal size, lower limit"));
}

/// The table of the sample's results: what the hole has, and what the program makes of it.
#[test]
fn the_sample_gives_its_results() {
    for (diameter, shown, global, pauses) in
        [("40.010", "", 0.0, 0), ("39.990", "rework 39.99\n", 0.0, 0), ("40.030", "", 9.0, 1)]
    {
        let mut machine = machine_with(&sample(), InMemory::new(), hole(diameter));
        let paused = to_end(&mut machine);
        let diameter: f64 = diameter.parse().unwrap();
        assert_eq!(paused, vec![Pause::Stop; pauses], "{diameter}");
        for (name, expected) in [("#l4", diameter), ("#l3", 0.0), ("#g1", global), ("#l2", 40.025), ("#i99", diameter)]
        {
            let found = value(&machine, name).unwrap();
            assert!((found - expected).abs() <= 1e-9, "{name} is {found}, not {expected}");
        }
        let windows: String = machine.windows().iter().map(|window| window.text.as_str()).collect();
        assert_eq!(windows, shown, "{diameter}");
        // Without limits there is nothing to judge.
        assert_eq!(machine.status(), None);
        assert_eq!(machine.cycles()[0].result.verdict(), None);
        let read = remarks(&machine).into_iter().filter(|remark| remark.starts_with("24: ")).collect::<Vec<_>>();
        assert_eq!(read, ["24: #i99 is read here, but it is not documented that it holds the diameter"]);
    }
}

#[test]
fn the_sample_stops_where_nothing_is_touched() {
    let mut machine = machine_with(&sample(), InMemory::new(), hole("90"));
    let fault = machine.run(1_000).unwrap_err();
    assert_eq!(fault.number, Some(14));
    assert_eq!(fault.kind.to_string(), "cycle G785: contact 1: the probe met nothing within the probing path of 30 mm");
    assert_eq!((value(&machine, "#l4"), value(&machine, "#l3"), value(&machine, "#g1")), (None, Some(0.0), Some(0.0)));
}

#[test]
fn the_subprogram_may_stand_before_the_end() {
    let whole = String::from_utf8(sample()).unwrap();
    let (main, subprogram) = whole.split_once("ENDE\r\n").unwrap();
    let moved = format!("{main}{subprogram}ENDE\r\n");
    for (diameter, global) in [("40.010", 0.0), ("40.030", 9.0)] {
        let mut machine = machine_with(moved.as_bytes(), InMemory::new(), hole(diameter));
        to_end(&mut machine);
        assert_eq!(value(&machine, "#g1"), Some(global));
    }
    // Whoever comes from above goes past it: without M30, too.
    let blocks = "N1 #l1=1\nSUBPROGRAM \"A\"\nN2 #l1=2\nRETURN\nN3 #l2=#l1";
    let machine = ran(blocks);
    assert_eq!((value(&machine, "#l1"), value(&machine, "#l2")), (Some(1.0), Some(1.0)));
    // And before the section that runs.
    let text = "%T.nc\n#EINHEIT METRISCH\nSUBPROGRAM \"A\"\nN2 #l1=2\nRETURN\nBEARBEITUNG\nN3 L\"A\" V0\nENDE\n";
    let mut machine = machine_with(text.as_bytes(), InMemory::new(), Contacts::Perfect);
    to_end(&mut machine);
    assert_eq!(value(&machine, "#l1"), Some(2.0));
}

/// The example of the manual's page on G785, in a program: `#i99` is the diameter of the circle that it touches.
#[test]
fn the_example_of_the_manual_runs() {
    let (program, warnings) = Program::read(b"BEARBEITUNG\nN3 G785 R0 BR0 K2 C0 RC60 I0 J0 Q0 P0 H0\nENDE\n").unwrap();
    let said: Vec<String> = warnings.iter().map(ToString::to_string).collect();
    let no_unit = "line 1, column 1: the head does not give the unit (#EINHEIT METRISCH / INCH): the program is read as one in mm";
    assert_eq!(said, ["line 1, column 1: %NAME.nc is missing", no_unit]);
    let Body::Probe(cycle) = &program.blocks()[1].body else { panic!("no cycle") };
    let words: Vec<String> = cycle.lines.iter().map(|line| line.parameter.to_string()).collect();
    assert_eq!((cycle.number.as_str(), words.join(" ")), ("G785", "R BR K C RC I J Q P H".to_owned()));
    // Letters know where they stand.
    let places: Vec<_> = cycle.lines.iter().map(|line| (line.place.line, line.place.column)).collect();
    assert_eq!(places[..3], [(2, 9), (2, 12), (2, 16)]);
    let mut machine = Machine::new("t.nc", Arc::new(program), InMemory::new(), hole("3"), settings());
    to_end(&mut machine);
    assert_eq!(value(&machine, "#i99"), Some(3.0));
    let unknown =
        "the position before the cycle is not known: without D it begins at the nominal center, without WB at height 0";
    let uncertain = "#i99 is read as the diameter: the manual does not say which value it holds";
    let idle = ["Q", "P", "H"].map(|letter| format!("{letter} is accepted but has no effect"));
    let short =
        "the contacts cover only 120.0° of arc: scatter in the diameter is 3.0 times that of 3 contacts at 120°";
    let said = [&[unknown.to_owned()], idle.as_slice(), &[uncertain.to_owned(), short.to_owned()]].concat();
    let said: Vec<String> = said.iter().map(|said| format!("1: {said}")).collect();
    assert_eq!(remarks(&machine), said);
}

#[test]
fn each_form_says_what_it_is() {
    let number = |number| Operand::Number(number);
    let Body::Move(rapid) = body("N7 G0 X40.01 Zi-2 M8") else { panic!() };
    assert_eq!((rapid.feed, rapid.machine[0].number), (Some(Feed::Rapid), 8));
    let axes: Vec<_> = rapid.axes.iter().map(|word| (word.axis, word.is_incremental, word.value)).collect();
    assert_eq!(axes, [(Axis::X, false, number(40.01)), (Axis::Z, true, number(-2.0))]);
    let Body::Move(line) = body("G95 F0.2 G1 Z#l5") else { panic!() };
    assert_eq!(line.feed, Some(Feed::Value(number(0.2))));
    let line = Operand::Parameter { parameter: "#l5".parse().unwrap(), is_negative: false };
    let Body::PassedOver(arc) = body("G2 X50 Z-20 I5 K0") else { panic!() };
    assert_eq!((arc.words.as_str(), arc.goes.is_unknown, arc.goes.axes.len()), ("G2", false, 2));
    for arc in ["G3 X1 Z1 R5", "G12 X1 Z1 R5", "G13 X1 Z1 R5"] {
        assert!(matches!(body(arc), Body::PassedOver(_)));
    }
    assert_eq!(body("G14 Q0"), passed_over("G14", Goes { is_unknown: true, axes: Vec::new() }));
    for (block, words) in
        [("G94 F200", "G94"), ("G95 F0.1", "G95"), ("G96 S180", "G96"), ("G97 S500", "G97"), ("S500", "S")]
    {
        assert_eq!(body(block), passed_over(words, Goes::default()));
    }
    for (block, rest) in [("T1 G96 S180 G95 F0.15 M4", "G96 G95 S180 F0.15 M4"), ("T1", ""), ("T1 M5", "M5")] {
        let tool = Some(Tool::Number(number(1.0)));
        assert_eq!(body(block), Body::ToolCall { tool, axis: None, rest: rest.to_owned() });
    }
    assert_eq!(body("G909"), Body::ReadNoFurther);
    assert!(matches!(body("N5 M30"), Body::MachineFunctions(functions) if functions[0].number == 30));
    assert_eq!(body("WINDOW(5)"), passed_over("WINDOW", Goes::default()));
    assert!(matches!(body("PRINT(\"a\",#l1,#x1,5)"), Body::Show(_)));
    assert!(matches!(body("INPUT(\"a\",#l1)"), Body::Input { question, .. } if question == "a"));
    let label = Target::Name("A".to_owned());
    assert_eq!(body("L\"A\" V0"), Body::CallLabel { label: label.clone(), repeat: None });
    assert_eq!(body("L\"A\""), Body::CallLabel { label, repeat: None });
    for (block, file) in [("L\"A\" V1", "A.ncs"), ("L\"b.ncs\" V1", "b.ncs")] {
        assert_eq!(body(block), Body::CallProgram(TextOperand::Text(file.to_owned())));
    }
    for block in ["N5", "[alone]", "N5 [alone]"] {
        assert_eq!(body(block), Body::Nothing);
    }
    assert!(matches!(body("G785 K#l5 RC120"), Body::Probe(cycle) if matches!(
        &cycle.lines[0].value, fitcheck::nc::program::CycleValue::Number { value, .. } if *value == line
    )));
}

#[test]
fn what_stands_in_other_sections_is_passed_over() {
    let head = "%T.nc\nPROGRAM HEAD\n#UNIT METRIC\n#FREE [ text\nTURRET 1\nT1 ID\"A\"\nCONST\n_n=0\nVAR\n#_a=#l1\nBLANK\nN1 G20 X80 Z60\n";
    let text =
        format!("{head}FINISHED PART\nN2 G0 X? Z0\nAUXILIARY CONTOUR\nFRONT\nSURFACE\nMACHINING\nN3 #l1=1\nEND\n");
    let (program, warnings) = read(&text);
    assert_eq!(warnings, ["line 4, column 7: the comment has no closing bracket ]"]);
    assert!(program.blocks().iter().all(|block| block.body != Body::Other));
    let mut machine = machine_with(text.as_bytes(), InMemory::new(), Contacts::Perfect);
    to_end(&mut machine);
    assert_eq!(value(&machine, "#l1"), Some(1.0));
    assert_eq!(machine.variables().iter().count(), 1);
}

#[test]
fn a_unit_is_passed_over_unless_it_acts() {
    let unit = |block: &str| format!("G0 X10 Z5\nUNIT ID\"G810\"\n{block}\nN7 G810 NS1 [cut]\nEND_OF_UNIT S2\n#l1=1");
    let machine = ran(&unit("G1 X20"));
    assert_eq!((value(&machine, "#l1"), machine.position()), (Some(1.0), [None, Some(0.0), None]));
    let acts = "3, 1: units are passed over, but this block measures, calls or sets a variable";
    for block in ["G785 K2 RC60", "#l1=5", "#_x=5", "L\"A\" V1", "INPUT(#l1)", "G787 K2"] {
        assert_eq!(refused(&unit(block)), acts, "{block}");
    }
    assert_eq!(refused("UNIT ID\"A\"\nG1 X2"), "1, 1: UNIT without END_OF_UNIT");
    assert_eq!(refused("END_OF_UNIT S1"), "1, 1: END_OF_UNIT without UNIT");
}

#[test]
fn x_is_a_diameter() {
    let machine = ran("G0 X40.01 Z2\nG1 Xi-2 Zi-1 F0.1");
    assert_eq!(machine.position(), [Some(40.01 / 2.0 - 1.0), Some(0.0), Some(1.0)]);
    assert_eq!(ran("G0 X40 Z2\nG14 Q0").position(), [None, Some(0.0), None]);
    assert_eq!(ran("G0 X40 Z2\nG3 X60 Zi-5 R8").position(), [Some(30.0), Some(0.0), Some(-3.0)]);
    // A subprogram in a file of its own counts in the unit of its caller.
    let main = "%T.nc\n#EINHEIT INCH\nBEARBEITUNG\nG0 X4 Z2\nL\"SUB\" V1\nENDE";
    let store = InMemory::new().with("SUB.ncs", "%SUB.ncs\nG0 X2 Z1\nRETURN\n");
    let mut machine = machine_with(main.as_bytes(), store, Contacts::Perfect);
    to_end(&mut machine);
    assert_eq!(machine.position(), [Some(25.4), Some(0.0), Some(25.4)]);
    let twice = read("%T.nc\n#EINHEIT INCH\n#EINHEIT METRISCH\nBEARBEITUNG\nENDE").1;
    assert_eq!(twice, ["line 3, column 1: not understood: another unit was given before"]);
    // The same in inches.
    let text = "%T.nc\n#EINHEIT INCH\nBEARBEITUNG\nG0 X2 Z1\nENDE";
    let mut machine = machine_with(text.as_bytes(), InMemory::new(), Contacts::Perfect);
    to_end(&mut machine);
    assert_eq!(machine.position(), [Some(25.4), Some(0.0), Some(25.4)]);
}

#[test]
fn formulas_and_variables() {
    for (formula, expected) in [
        ("2+3*4", 14.0),
        ("(2+3)*-4", -20.0),
        ("10/4", 2.5),
        ("SIN(30)", 0.5),
        ("COS(60)", 0.5),
        ("SQRT(16)", 4.0),
        ("ABS(-2.5)", 2.5),
        ("INT(2.7)", 2.0),
        ("#c1", 7.0),
        ("-#g199*2", -16.0),
    ] {
        let machine = ran(&format!("#c1=7\n#g199=8\n#l1={formula}"));
        let found = value(&machine, "#l1").unwrap();
        assert!((found - expected).abs() < 1e-12, "{formula} is {found}");
    }
    let machine = ran("#x1=\"bore\"\n#x20=#x1\n#g200=7\nPRINT(\"of\",#x20,#g200,1.5)");
    assert_eq!(machine.windows()[0].text, "of bore 7 1.5\n");
}

#[test]
fn conditions() {
    for (condition, holds) in [
        ("#l1==5", true),
        ("#l1<>5", false),
        ("#l1<5", false),
        ("#l1<=5", true),
        ("#l1>4", true),
        ("#l1>=6", false),
        ("#l1+1>2*3 OR #l1==5", true),
        ("#l1>1 AND #l1<5", false),
        ("(#l1>1) AND ((#l1<5) OR (#l1==5))", true),
        ("(#l1+1)*2==12", true),
        ("5==(#l1)", true),
    ] {
        for then in ["\nTHEN", " THEN", ""] {
            let machine = ran(&format!("#l1=5\n#l2=0\nIF {condition}{then}\n#l2=1\nELSE\n#l2=2\nENDIF\n#l3=1"));
            let expected = if holds { 1.0 } else { 2.0 };
            assert_eq!(value(&machine, "#l2"), Some(expected), "{condition}");
            assert_eq!(value(&machine, "#l3"), Some(1.0));
        }
    }
    assert_eq!(value(&ran("#l1=0\n#l2=7\nWHILE #l2>0\n#l1=#l1+#l2\n#l2=#l2-1\nENDWHILE"), "#l1"), Some(28.0));
}

#[test]
fn a_switch_takes_one_case() {
    let switch = |value: i32| {
        format!(
            "#l1={value}\n#l2=0\nSWITCH #l1\nCASE 1\n#l1=2\n#l2=1\nBREAK\nCASE 2:\nIF #l1==2\nTHEN\n#l2=2\nBREAK\nENDIF\nBREAK\n\
             CASE -3\n#l2=3\nBREAK\nDEFAULT\n#l2=9\nENDSWITCH\n#l3=1"
        )
    };
    for (given, expected) in [(1, 1.0), (2, 2.0), (-3, 3.0), (4, 9.0)] {
        let machine = ran(&switch(given));
        assert_eq!((value(&machine, "#l2"), value(&machine, "#l3")), (Some(expected), Some(1.0)), "{given}");
    }
    assert_eq!(refused("SWITCH #l1\nCASE 1\n#l2=1\nCASE 2\nBREAK\nENDSWITCH"), "4, 1: CASE without BREAK");
    assert_eq!(refused("SWITCH #l1\nCASE 1\nDEFAULT\nENDSWITCH"), "3, 1: DEFAULT without BREAK");
    assert_eq!(refused("SWITCH #l1\nDEFAULT\nBREAK\nCASE 1\nENDSWITCH"), "4, 1: CASE without ENDSWITCH");
    assert_eq!(refused("WHILE #l1>0\nBREAK\nENDWHILE"), "2, 1: BREAK without SWITCH");
}

#[test]
fn calls() {
    let subprogram = InMemory::new().with("SUB.ncs", "%SUB.ncs\nN1 #l1=5\nN2 #g1=#l1\nRETURN\n");
    let mut machine = machine_with(text("#l1=1\nL\"SUB\" V1\n#l2=#l1").as_bytes(), subprogram, Contacts::Perfect);
    to_end(&mut machine);
    // Local variables are those of a program.
    assert_eq!((value(&machine, "#g1"), value(&machine, "#l2")), (Some(5.0), Some(1.0)));
    let whole =
        InMemory::new().with("SUB.ncs", "%SUB.ncs\nPROGRAMMKOPF\n#EINHEIT METRISCH\nBEARBEITUNG\n#g1=6\nENDE\n");
    let mut machine = machine_with(text("L\"SUB\" V1\n#l2=1").as_bytes(), whole, Contacts::Perfect);
    to_end(&mut machine);
    assert_eq!((value(&machine, "#g1"), value(&machine, "#l2")), (Some(6.0), Some(1.0)));
    assert_eq!(fault("L\"NONE\" V0"), "LBL \"NONE\" does not occur in the program");
    assert_eq!(refused("L\"A\" V1 LA5"), "1, 9: LA5 is not known");
    assert_eq!(refused("L\"A\" V1 Q2"), "1, 9: Q2 is not known");
    assert_eq!(refused("L\"A\" V2"), "1, 7: 2 is too large: at most 1");
}

#[test]
fn what_a_run_refuses() {
    assert_eq!(fault("#l1=#l2"), "#l2 is undefined");
    assert_eq!(fault("#g200=2.5"), "#g200 holds whole numbers only, not 2.5");
    assert_eq!(fault("INPUT(\"size\",#l1)"), "INPUT \"size\" asks for #l1: give it a value before the run");
    assert_eq!(fault("G810 NS1"), "unknown block: Fitcheck runs only what it understands");
    let mut machine = machine("INPUT(\"size\",#l1)\n#l2=#l1");
    machine.set("#l1".parse().unwrap(), Value::Number(3.0)).unwrap();
    to_end(&mut machine);
    assert_eq!(value(&machine, "#l2"), Some(3.0));
    let beyond = machine.set("#l100".parse().unwrap(), Value::Number(3.0)).unwrap_err().to_string();
    assert_eq!(beyond, "variable #l100 does not exist: #l goes from 1 to 99");
}

#[test]
fn a_measurement_that_scatters_more_than_allowed_is_an_error() {
    let contacts = [10.0, 10.0, 10.1, 10.0, 10.0, 10.0].map(|x| fitcheck::probing::Contact::at([x, 0.0, 0.0]));
    let text = text("G0 X0 Z5\nG785 K30 C0 RC0 WE0.05 WB-8");
    let mut machine = machine_with(text.as_bytes(), InMemory::new(), Contacts::Recorded(contacts.to_vec()));
    let fault = machine.run(100).unwrap_err().kind.to_string();
    assert!(fault.contains("WE"), "{fault}");
}

#[test]
fn a_result_that_is_read_too_early_is_told() {
    let early = "G785 K30 RC120\n#l1=1\nPRINT(#i99)\nG909\n#l2=#i99";
    let machine = ran(early);
    let uncertain = "#i99 is read here, but it is not documented that it holds the diameter";
    let too_early =
        "#i99 is read without G909 after the cycle: a control reads blocks ahead and may not have measured yet";
    let unknown =
        "the position before the cycle is not known: without D it begins at the nominal center, without WB at height 0";
    let of_cycle = "#i99 is read as the diameter: the manual does not say which value it holds";
    let expected = [
        format!("4: {unknown}"),
        "4: the cycle has no nominal size: the probe meets the perfect workpiece half-way along K".to_owned(),
        format!("4: {of_cycle}"),
        format!("6: {uncertain}"),
        format!("6: {too_early}"),
        format!("8: {uncertain}"),
    ];
    assert_eq!(remarks(&machine), expected);
}

#[test]
fn errors_have_a_line_and_a_column() {
    let cases = [
        ("N1 G0 X1\n N2 G0 [text", "2, 8: the comment has no closing bracket ]"),
        ("PRINT(\"a,#l1)", "1, 7: the quotation mark is not closed"),
        ("N1 [a] G0 X1", "1, 8: unexpected text G0"),
        ("N1 IF #l1>5\nTHEN\nELSE", "1, 4: IF without ENDIF"),
        ("WHILE #l1>5", "1, 1: WHILE without ENDWHILE"),
        ("  SUBPROGRAM \"A\"\nM0", "1, 3: SUBPROGRAM without RETURN"),
        ("SWITCH #l1", "1, 1: SWITCH without ENDSWITCH"),
        ("SUBPROGRAM \"A\"\nIF #l1>5\nRETURN", "2, 1: IF without ENDIF"),
        ("ENDIF", "1, 1: ENDIF without IF"),
        ("N2 ELSE", "1, 4: ELSE without IF"),
        ("THEN", "1, 1: THEN without IF"),
        ("ENDWHILE", "1, 1: ENDWHILE without WHILE"),
        ("RETURN", "1, 1: RETURN without SUBPROGRAM"),
        ("CASE 1", "1, 1: CASE without SWITCH"),
        ("ENDSWITCH", "1, 1: ENDSWITCH without SWITCH"),
        ("IF #l1=5\nENDIF", "1, 7: expected ==, <>, <, <=, > / >=, found =5"),
        (
            "IF #l1==1 AND #l1==2 OR #l1==3\nENDIF",
            "1, 22: AND and OR in one condition need brackets that show which comes first",
        ),
        ("#l100=1", "1, 1: #l100=1 is not a parameter: #l goes from 1 to 99"),
        ("#l0=1", "1, 1: #l0=1 is not a parameter: #l goes from 1 to 99"),
        ("#x21=\"a\"", "1, 1: #x21=\"a\" is not a parameter: #x goes from 1 to 20"),
        ("#_a=1", "1, 1: expected a variable (#l, #c, #g, #x, #i), found #_a=1"),
        ("#__la=1", "1, 1: expected a variable (#l, #c, #g, #x, #i), found #__la=1"),
        ("#d901=1", "1, 1: expected a variable (#l, #c, #g, #x, #i), found #d901=1"),
        ("#l1=Q1", "1, 5: Q is not a function"),
        ("#l1=TAN(5)", "1, 5: TAN is not a function"),
        ("#l1=SIN 5", "1, 9: expected (, found 5"),
        ("#l1=2^3", "1, 6: unexpected text ^3"),
        ("#l1=", "1, 5: a number or a variable is missing"),
        ("G0 X? Z5", "1, 5: expected a number or a variable, found ?"),
        ("G0 X1 X2", "1, 7: X is given twice"),
        ("X20 Z5", "1, 1: G0 / G1 is missing"),
        ("G1 X20 B2", "1, 8: B2 is not known"),
        ("G0 X1 T5", "1, 7: T5 is not known"),
        ("G0 G1 X5", "1, 4: G0 and G1 cannot be in the same block"),
        ("T8 M30", "1, 1: T8 and M30 cannot be in the same block"),
        ("G785 K2 M30", "1, 1: G785 and M30 cannot be in the same block"),
        ("G785 K2 ZZ5", "1, 9: ZZ5 is not known"),
        ("G785 K2 K3", "1, 9: K is given twice"),
        ("G909 M30", "1, 1: G909 and M30 cannot be in the same block"),
        ("G26 S3000", "1, 1: G26 is not known"),
        ("M99", "1, 1: M99 is not known"),
        ("/N5 G0 X5", "1, 1: /N5 is not known"),
        ("ROHTEIL", "1, 1: ROHTEIL is not known"),
        ("INPUT(\"a\" #l1)", "1, 11: expected ,, found #l1)"),
    ];
    let (found, expected): (Vec<_>, Vec<_>) =
        cases.iter().map(|(blocks, said)| ((blocks, refused(blocks)), (blocks, (*said).to_owned()))).unzip();
    assert_eq!(found, expected);
}

#[test]
fn what_is_missing_in_a_program_is_told() {
    let said = |text: &str| read(text).1;
    let unit = "line 1, column 1: the head does not give the unit (#EINHEIT METRISCH / INCH): the program is read as one in mm";
    assert_eq!(said("%A.nc\nBEARBEITUNG\nN1 M30\nENDE"), [unit]);
    assert_eq!(
        said("%A.nc\n#EINHEIT METRISCH\nN1 M30\nENDE"),
        ["line 4, column 1: BEARBEITUNG / MACHINING is missing"]
    );
    assert_eq!(said("%A.nc\n#EINHEIT METRISCH\nBEARBEITUNG\nN1 M30"), ["line 4, column 1: ENDE / END is missing"]);
    assert_eq!(
        said("%A.nc\n#EINHEIT FOOT\nBEARBEITUNG\nENDE"),
        [unit, "line 2, column 10: not understood: MM or INCH is missing"]
    );
    assert_eq!(
        said("%A.nc 5\n#EINHEIT INCH\nBEARBEITUNG\nENDE\nM30\nM0"),
        [
            "line 1, column 7: not understood: unexpected text 5",
            "line 5, column 1: only subprograms may follow ENDE / END"
        ]
    );
    let twice = "%A.nc\n#EINHEIT INCH\nBEARBEITUNG\nENDE\nSUBPROGRAM \"A\"\nRETURN\nSUBPROGRAM \"A\"\nRETURN\n";
    assert_eq!(said(twice), ["line 7, column 1: LBL \"A\" is already defined in line 5"]);
    // In which unit it would be measured is not known.
    let mut machine = machine_with(b"%A.nc\n#EINHEIT FOOT\nBEARBEITUNG\nENDE", InMemory::new(), Contacts::Perfect);
    let stopped = machine.run(100).unwrap_err().to_string();
    assert!(stopped.contains("line 2") && stopped.contains("#EINHEIT FOOT"), "{stopped}");
    // Nothing runs: that is no good end.
    let mut machine = machine_with(b"%A.nc\nN1 M30\nENDE", InMemory::new(), Contacts::Perfect);
    assert!(machine.run(100).is_err());
    let mut machine = machine_with(b"%A.nc\nBEARBEITUNG\nN1 M5", InMemory::new(), Contacts::Perfect);
    assert_eq!(machine.run(100).unwrap_err().kind.to_string(), "the program is broken: ENDE is missing");
}

/// Lines of the language, right and wrong.
const LINES: [&str; 44] = [
    "%A.nc",
    "PROGRAMMKOPF",
    "#EINHEIT METRISCH",
    "REVOLVER",
    "BEARBEITUNG",
    "ENDE",
    "END",
    "SUBPROGRAM \"A\"",
    "RETURN",
    "UNIT ID\"A\"",
    "END_OF_UNIT S1",
    "IF #l1>5",
    "IF #l1",
    "THEN",
    "ELSE",
    "ENDIF",
    "WHILE #l1<3",
    "WHILE",
    "ENDWHILE",
    "SWITCH #l1",
    "CASE 1",
    "DEFAULT",
    "BREAK",
    "ENDSWITCH",
    "#l1=#l1+1",
    "#l1=0",
    "#i99=3",
    "#x1=\"a\"",
    "L\"A\" V0",
    "L\"A\" V1",
    "PRINT(\"a\",#l1)",
    "INPUT(#l1)",
    "G0 X10 Z5",
    "G1 Xi-2",
    "G14 Q0",
    "G785 K2 RC120",
    "G909",
    "T1 M4",
    "M30",
    "M0",
    "[a]",
    "[a",
    "\"",
    "N5 ((((",
];

proptest! {
    #[test]
    fn any_lines_are_read_and_run_without_a_panic(lines in prop::collection::vec(select(&LINES[..]), 0..40)) {
        for front in ["", "%A.nc\n#EINHEIT METRISCH\nBEARBEITUNG\n#l1=0\n"] {
            let text = format!("{front}{}", lines.join("\n"));
            sound(text.as_bytes())?;
            let Ok((program, _)) = Program::read(text.as_bytes()) else { continue };
            let mut settings = settings();
            settings.skip_unknown = lines.len() % 2 == 0;
            let mut machine =
                Machine::new("a.nc", Arc::new(program), InMemory::new(), Contacts::Perfect, settings);
            for _ in 0..300 {
                if machine.is_over() {
                    break;
                }
                let _either = machine.run(10);
            }
        }
    }

    #[test]
    fn any_pieces_are_read(pieces in prop::collection::vec(select(vec![
        "%A.nc\n", "BEARBEITUNG\n", "N1 ", "G1 ", "X", "Xi", "#l1", "#", "=", "IF ", "(", ")", "<", ">=", "AND ", "[", "]", "\"",
        "L\"A\"", "PRINT", ",", "\n", "\r\n", "5", "é", " ", "G785 ", "RC", "-", "*", "SIN", "M", "T", "~", ";", "CASE ",
    ]), 0..80)) {
        sound(format!("%A.nc\nBEARBEITUNG\n{}", pieces.concat()).as_bytes())?;
    }

    #[test]
    fn nested_brackets_end(depth in 0..300_usize, sign in select(vec!["", ">1", "+1"])) {
        let text = text(&format!("IF {}#l1{sign}{}>2\nENDIF", "(".repeat(depth), ")".repeat(depth)));
        sound(text.as_bytes())?;
    }
}
