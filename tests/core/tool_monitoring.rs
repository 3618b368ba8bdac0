//! Q330 in a run: what each cycle changes in the tool table, breakage, and what a run says of its tools.
//!
//! The figures of the four cycles are those of the program `four_cycles_tools.h` (slot, ridge, pocket, boss), here
//! without its contour and datum shift; the walls are recorded contacts.

use std::sync::Arc;

use fitcheck::control::tool_table::ToolTable;
use fitcheck::control::variables::{Parameter, Value};
use fitcheck::nc::machine::{Contacts, Machine, Pause, Settings, Shipped, Step};
use fitcheck::nc::program::Program;
use fitcheck::probing::Contact;
use fitcheck::probing::cycle::Remark;
use fitcheck::words::Dialogue;

fn tools() -> ToolTable {
    let path = format!("{}/tests/data/samples/tools/tool_small.t", env!("CARGO_MANIFEST_DIR"));
    ToolTable::read(&std::fs::read(path).unwrap(), "tool_small.t").unwrap()
}

/// Contacts with these places, at one height.
fn contacts(places: &[[f64; 2]]) -> Contacts {
    Contacts::Recorded(places.iter().map(|[x, y]| Contact { x: *x, y: *y, z: -4.0 }).collect())
}

fn machine(blocks: &str, tools: Option<ToolTable>, contacts: Contacts) -> Machine {
    let text = format!("BEGIN PGM main MM\n{blocks}\nEND PGM main MM\n");
    let mut settings = Settings::new(Dialogue::En, jiff::civil::date(2026, 3, 7).at(8, 5, 9, 0));
    settings.tool_table = tools;
    Machine::new("main.h", Arc::new(Program::read(text.as_bytes()).unwrap().0), Shipped, contacts, settings)
}

/// Runs to the end or to a fault, which is returned without its place; pauses are skipped.
fn run(machine: &mut Machine) -> String {
    loop {
        match machine.step() {
            Ok(Step::Ended) => return "ended".to_owned(),
            Ok(_) => {}
            Err(fault) => return fault.kind.to_string(),
        }
    }
}

fn changes(machine: &Machine) -> Vec<String> {
    machine.tool_changes().iter().map(|changed| changed.change.to_string()).collect()
}

fn remarks(machine: &Machine) -> Vec<String> {
    let of_cycles = machine.cycles().iter().flat_map(|run| &run.result.remarks).map(ToString::to_string);
    machine.remarks().iter().map(|(_, remark)| remark.to_string()).chain(of_cycles).collect()
}

fn q(machine: &Machine, number: u16) -> Option<f64> {
    match machine.variables().get(Parameter::q(number))? {
        Value::Length(length) => Some(length.to_mm_f64()),
        Value::Number(number) => Some(*number),
        Value::Text(_) => None,
    }
}

/// DR of a tool, as the run has it now.
fn radius(machine: &Machine, tool: &str) -> String {
    let table = machine.tool_table().unwrap();
    table.tools()[table.row_of(tool.parse().unwrap()).unwrap()].delta_radius.to_string()
}

fn block(code: &str, parameters: &str, tool: &str) -> String {
    let lines: Vec<String> = parameters.split_whitespace().chain([tool]).map(|line| format!("   {line}")).collect();
    format!("TCH PROBE {code} MEASURE ~\n{}", lines.join(" ~\n"))
}

const SLOT: &str = "Q328=0 Q329=+25 Q310=+0 Q272=1 Q261=-4 Q260=+20 Q311=12 Q288=12.018 Q289=12 Q281=0 Q309=0";
const RIDGE: &str = "Q263=-20 Q264=+15 Q265=-20 Q266=-15 Q272=+2 Q261=-4 Q320=+1 Q260=+20 Q311=+30 Q288=+30 Q289=+29.979 Q281=+0 Q309=+0";
const POCKET: &str = "Q273=+0 Q274=+0 Q282=+40 Q283=+24 Q261=-4 Q320=+1 Q260=+20 Q301=+0 Q284=+40.05 Q285=+39.95 Q286=+24.05 Q287=+23.95 Q279=+0.1 Q280=+0.1 Q281=+0 Q309=+0";
const BOSS: &str = "Q273=+0 Q274=+0 Q282=+60 Q283=+20 Q261=-4 Q320=+1 Q260=+20 Q301=+1 Q284=+60.1 Q285=+59.9 Q286=+20.1 Q287=+19.9 Q281=+0 Q309=+0";
const HOLE: &str = "Q273=+0 Q274=+0 Q262=25 Q325=0 Q247=90 Q261=-4 Q320=0 Q260=20 Q301=0 Q275=25.1 Q276=24.9 Q279=0 Q280=0 Q281=0 Q309=0";
const SHAFT: &str = "Q273=+0 Q274=+0 Q262=25 Q325=0 Q247=90 Q261=-4 Q320=0 Q260=20 Q301=0 Q277=25.1 Q278=24.9 Q279=0 Q280=0 Q281=0 Q309=0";

/// Walls of the sample, plus side first in 425, plus wall first in 426.
const WALLS: [[f64; 2]; 12] = [
    [6.012, 25.0],
    [-6.002, 25.0],
    [-20.0, 15.004],
    [-20.0, -14.998],
    [20.01, 0.0],
    [0.0, 12.04],
    [-19.97, 0.0],
    [0.0, -12.04],
    [30.03, 0.0],
    [0.0, 10.0],
    [-30.03, 0.0],
    [0.0, -10.0],
];

fn four_cycles(last: &str) -> String {
    [
        "TOOL CALL \"PROBE\" Z".to_owned(),
        block("425", SLOT, "Q330=3"),
        "FN 0: Q60 = +Q180\nFN 0: Q61 = +Q157".to_owned(),
        block("426", RIDGE, "Q330=+3"),
        "FN 0: Q62 = +Q181".to_owned(),
        block("423", POCKET, "Q330=+3"),
        "FN 0: Q63 = +Q182".to_owned(),
        block("424", BOSS, last),
        "FN 0: Q64 = +Q180\nM30".to_owned(),
    ]
    .join("\n")
}

#[test]
fn four_cycles_correct_their_tool_and_stop_at_the_broken_one() {
    let mut machine = machine(&four_cycles("Q330=+4"), Some(tools()), contacts(&WALLS));
    let broken = "error 1065: tool 4 is broken: DR would change by -0.03 mm, RBREAK is 0.02 mm; the tool is locked and not \
                  corrected; its replacement is tool 6";
    assert_eq!(run(&mut machine), broken);
    assert_eq!(
        changes(&machine),
        [
            "tool 3 (MILL_D10): DR changed by 0.007 mm, from 0 to 0.007 mm",
            "tool 3 (MILL_D10): DR changed by -0.001 mm, from 0.007 to 0.006 mm",
            "tool 3 (MILL_D10): DR changed by -0.01 mm, from 0.006 to -0.004 mm",
            "tool 4 (MILL_D16): locked, TL = L",
        ]
    );
    let values = [60, 61, 62, 63, 64].map(|number| q(&machine, number));
    assert_eq!(values, [Some(1.0), Some(0.005), Some(1.0), Some(1.0), None], "the run stops in the block of 424");
    // What was measured stands.
    assert_eq!([154, 155, 164, 165, 180].map(|number| q(&machine, number)), [60.06, 20.0, 0.06, 0.0, 1.0].map(Some));
    assert_eq!(machine.cycles().len(), 4);
    assert_eq!((radius(&machine, "3"), radius(&machine, "4")), ("-0.004".to_owned(), "0".to_owned()));
    let table = machine.tool_table().unwrap();
    let locked: Vec<_> =
        table.tools().iter().filter(|tool| tool.is_locked).map(|tool| tool.number.to_string()).collect();
    assert_eq!(locked, ["4", "6"]);
    // Tool 9 is called PROBE and is one.
    assert_eq!(remarks(&machine), Vec::<String>::new());

    machine.restart(contacts(&WALLS));
    assert_eq!(
        (changes(&machine).len(), radius(&machine, "3")),
        (0, "0".to_owned()),
        "a restart has the table of the file"
    );
}

#[test]
fn without_a_tool_in_the_last_cycle_the_run_goes_on() {
    let mut machine = machine(&four_cycles("Q330=+0"), Some(tools()), contacts(&WALLS));
    assert_eq!(run(&mut machine), "ended");
    assert_eq!((q(&machine, 64), changes(&machine).len()), (Some(1.0), 3));
    assert!(!machine.tool_table().unwrap().tools()[2].is_locked);
}

/// A circle about the origin: four contacts.
fn circle(diameter: f64) -> [[f64; 2]; 4] {
    let radius = diameter / 2.0;
    [[radius, 0.0], [0.0, radius], [-radius, 0.0], [0.0, -radius]]
}

/// Every feature: what is too small or too large inside and outside, by hand from the table in `docs/SOURCES.md`.
#[test]
fn every_cycle_changes_its_value_by_its_rule() {
    let probed = |axis: u8, direction: &str| {
        format!("Q263=10 Q264=20 Q261=-4 Q272={axis} Q267={direction} Q260=20 Q281=0 Q288=10.1 Q289=9.9 Q309=0")
    };
    let at = |x: f64, y: f64, z: f64| Contacts::Recorded(vec![Contact { x, y, z }]);
    let pair = |one: [f64; 2], other: [f64; 2]| contacts(&[one, other]);
    let rectangle = |first: f64, second: f64| {
        contacts(&[[first / 2.0, 0.0], [0.0, second / 2.0], [-first / 2.0, 0.0], [0.0, -second / 2.0]])
    };
    let cases = [
        // Half the deviation of a size; too small a hole was cut by a tool that cuts small.
        ("421", HOLE.to_owned(), contacts(&circle(24.96)), "DR", "-0.02"),
        ("421", HOLE.to_owned(), contacts(&circle(25.05)), "DR", "0.025"),
        ("422", SHAFT.to_owned(), contacts(&circle(25.04)), "DR", "-0.02"),
        ("422", SHAFT.to_owned(), contacts(&circle(24.95)), "DR", "0.025"),
        // Only the first side counts.
        ("423", POCKET.to_owned(), rectangle(40.02, 23.0), "DR", "0.01"),
        ("424", BOSS.to_owned(), rectangle(60.02, 19.0), "DR", "-0.01"),
        ("425", SLOT.to_owned(), pair([6.006, 25.0], [-6.002, 25.0]), "DR", "0.004"),
        ("426", RIDGE.to_owned(), pair([-20.0, 15.01], [-20.0, -15.0]), "DR", "-0.005"),
        // The middle of the limits is 10. In plus direction the lower wall is met: below 10 material is left.
        ("427", probed(1, "+1"), at(9.99, 20.0, -4.0), "DR", "-0.01"),
        ("427", probed(1, "-1"), at(9.99, 20.0, -4.0), "DR", "0.01"),
        ("427", probed(2, "+1"), at(10.0, 10.02, -4.0), "DR", "0.02"),
        ("427", probed(2, "-1"), at(10.0, 10.02, -4.0), "DR", "-0.02"),
        // Too high a surface: the tool is shorter than its table says, whatever the direction.
        ("427", probed(3, "-1"), at(10.0, 20.0, 10.03), "DL", "-0.03"),
        ("427", probed(3, "+1"), at(10.0, 20.0, 9.97), "DL", "0.03"),
    ];
    for (code, parameters, contacts, column, by) in cases {
        let mut machine =
            machine(&format!("TOOL CALL 9 Z\n{}", block(code, &parameters, "Q330=3")), Some(tools()), contacts);
        assert_eq!(run(&mut machine), "ended", "{code} {parameters}");
        let expected = format!("tool 3 (MILL_D10): {column} changed by {by} mm, from 0 to {by} mm");
        assert_eq!(changes(&machine), [expected], "{code} {parameters}");
    }
}

/// Later measurements add to what stands there; a deviation of 0 changes nothing.
#[test]
fn corrections_add_up() {
    let hole = block("421", HOLE, "Q330=5");
    let walls = [circle(25.01), circle(25.0), circle(25.02)].concat();
    let mut machine = machine(&format!("TOOL CALL 9 Z\n{hole}\n{hole}\n{hole}"), Some(tools()), contacts(&walls));
    assert_eq!(run(&mut machine), "ended");
    assert_eq!(
        changes(&machine),
        [
            "tool 5 (MILL_D12): DR changed by 0.005 mm, from -0.005 to 0 mm",
            "tool 5 (MILL_D12): DR changed by 0.01 mm, from 0 to 0.01 mm",
        ]
    );
    assert_eq!(machine.tool_changes()[0].change.from, "-0.005");
    assert_eq!(machine.tool_changes()[0].change.to, "+0");
    let written = machine.tool_table().unwrap().write().unwrap();
    let expected = std::str::from_utf8(&written).unwrap().lines().nth(6).unwrap();
    assert!(expected.contains("+0        +0.01     +0      0  0"), "{expected}");
}

/// A change of exactly RBREAK is a correction, a nanometre more is breakage. The length has a tolerance of its own.
#[test]
fn breakage_begins_beyond_its_tolerance() {
    let hole = |diameter: f64| {
        let blocks = format!("TOOL CALL 9 Z\n{}", block("421", HOLE, "Q330=4"));
        let mut machine = machine(&blocks, Some(tools()), contacts(&circle(diameter)));
        (run(&mut machine), changes(&machine))
    };
    let (said, changed) = hole(24.96);
    assert_eq!(
        (said.as_str(), changed[0].as_str()),
        ("ended", "tool 4 (MILL_D16): DR changed by -0.02 mm, from 0 to -0.02 mm")
    );
    let (said, changed) = hole(24.959_998);
    assert!(
        said.starts_with("error 1065: tool 4 is broken: DR would change by -0.020001 mm, RBREAK is 0.02 mm"),
        "{said}"
    );
    assert_eq!(changed, ["tool 4 (MILL_D16): locked, TL = L"]);
    let height = "Q263=10 Q264=20 Q261=-4 Q272=3 Q267=-1 Q260=20 Q281=0 Q288=1 Q289=-1 Q309=0";
    let length = |z: f64| {
        let contacts = Contacts::Recorded(vec![Contact { x: 10.0, y: 20.0, z }]);
        let mut machine =
            machine(&format!("TOOL CALL 9 Z\n{}", block("427", height, "Q330=4")), Some(tools()), contacts);
        run(&mut machine)
    };
    assert_eq!(length(0.2), "ended");
    assert!(
        length(0.200_001)
            .starts_with("error 1065: tool 4 is broken: DL would change by -0.200001 mm, LBREAK is 0.2 mm")
    );
}

#[test]
fn tools_have_names_numbers_and_indices() {
    let table = b"BEGIN TOOL.T MM\nT    NAME  L   R   DL   DR      TL\n5    MILL  +9  +6  +0   +0\n5.1  MILL  +9  +6  +0   +0\n7    5     +9  +6  +0   +0\n[END]\n";
    let check = |tool: &str, said: &str, expected: &[&str]| {
        let table = ToolTable::read(table, "tool.t").unwrap();
        let blocks = format!("TOOL CALL 7 Z\nQS1 = \"mill\"\nQ1 = 5.1\n{}", block("421", HOLE, tool));
        let mut machine = machine(&blocks, Some(table), contacts(&circle(25.02)));
        assert_eq!(run(&mut machine), said, "{tool}");
        let changed: Vec<_> = machine.tool_changes().iter().map(|changed| changed.change.tool.to_string()).collect();
        let found: Vec<String> = changed.into_iter().chain(remarks(&machine)).collect();
        assert_eq!(found, expected, "{tool}");
    };
    let same = "another tool has the name MILL: the first one in the tool table was used";
    check("Q330=5", "ended", &["5"]);
    check("Q330=5.1", "ended", &["5.1"]);
    check("Q330=+Q1", "ended", &["5.1"]);
    check("QS330=\"MILL\"", "ended", &["5", same]);
    check("QS330=QS1", "ended", &["5", &same.replace("MILL", "mill")]);
    // The tool with the name 5, not the one with the number 5.
    check("QS330=\"5\"", "ended", &["7"]);
    check("Q330=6", "Q330 = 6: the tool table has no such tool; it has 5, 5.1, 7", &[]);
    check("QS330=\"DRILL\"", "Q330 = DRILL: the tool table has no such tool; it has MILL, MILL, 5", &[]);
    check("Q330=40000", "Q330 = 40000: the tool table has no such tool; it has 5, 5.1, 7", &[]);
}

#[test]
fn what_cannot_be_corrected_stops_with_the_reason() {
    let table = b"BEGIN TOOL.T MM\nT    L   R   DL   DR         TL\n5    +9  +6  +0   -999.9899\n[END]\n";
    let of = |contacts: Contacts, code: &str, parameters: &str| {
        let table = ToolTable::read(table, "tool.t").unwrap();
        let mut machine =
            machine(&format!("TOOL CALL 5 Z\n{}", block(code, parameters, "Q330=5")), Some(table), contacts);
        let said = run(&mut machine);
        assert_eq!(machine.tool_changes().len(), usize::from(said == "ended"));
        said
    };
    assert_eq!(of(contacts(&circle(24.98)), "421", HOLE), "ended", "-999.9999 belongs to the range");
    assert_eq!(
        of(contacts(&circle(24.979_998)), "421", HOLE),
        "tool 5: DR would change from -999.9899 to -999.999901 mm: the largest value is 999.9999 mm either way"
    );
    let free = "Q263=10 Q264=20 Q261=-4 Q272=1 Q267=+1 Q260=20 Q281=0 Q288=0 Q289=0 Q309=0";
    assert_eq!(
        of(contacts(&[[10.0, 20.0]]), "427", free),
        "Q330 = 5: cycle 427 has no limits here, so there is no deviation to correct the tool by"
    );
}

/// The correction is made, and then the run waits where Q309 says so.
#[test]
fn a_stop_of_the_tolerance_comes_after_the_correction() {
    let parameters = HOLE.replace("Q309=0", "Q309=1");
    let mut machine = machine(
        &format!("TOOL CALL 9 Z\n{}", block("421", &parameters, "Q330=3")),
        Some(tools()),
        contacts(&circle(25.2)),
    );
    let paused = loop {
        match machine.step().unwrap() {
            Step::Paused(pause) => break pause,
            Step::Ended => panic!("no pause"),
            Step::Went => {}
        }
    };
    assert!(matches!(paused, Pause::Tolerance(_)));
    assert_eq!(changes(&machine), ["tool 3 (MILL_D10): DR changed by 0.1 mm, from 0 to 0.1 mm"]);
}

#[test]
fn without_a_tool_table_the_answer_says_that_nothing_is_monitored() {
    let mut machine = machine(&four_cycles("Q330=+4"), None, contacts(&WALLS));
    assert_eq!(run(&mut machine), "ended");
    assert!(machine.tool_changes().is_empty() && machine.tool_table().is_none());
    let found = &machine.cycles()[3].result.remarks;
    assert_eq!(found, &[Remark::ToolNotMonitored { tool: "4".to_owned() }]);
    assert_eq!(found[0].to_string(), "Q330 = 4: the tool is not monitored: no tool table");
}

#[test]
fn a_called_tool_that_is_locked_or_no_probe_is_told_once_before_a_cycle() {
    let hole = block("421", HOLE, "Q330=0");
    let check = |call: &str, expected: &[&str]| {
        let walls = [circle(25.0), circle(25.0)].concat();
        let mut machine = machine(&format!("{call}\n{hole}\n{hole}"), Some(tools()), contacts(&walls));
        assert_eq!(run(&mut machine), "ended", "{call}");
        assert_eq!(remarks(&machine), expected, "{call}");
    };
    check("TOOL CALL 9 Z", &[]);
    check("TOOL CALL \"PROBE\" Z\nTOOL CALL Z S50", &[]);
    check("TOOL CALL 3 Z", &["tool 3 is not a touch probe: TYP = 0, expected 21"]);
    let old = ["tool 6 is locked in the tool table", "tool 6 is not a touch probe: TYP = 0, expected 21"];
    check("TOOL CALL \"MILL_D16_OLD\" Z", &old);
    check("TOOL CALL 7 Z", &["tool 7 is not in the tool table"]);
    check("TOOL CALL \"DRILL_D6\" Z", &["tool DRILL_D6 is not in the tool table"]);
    // A tool between is not used for probing.
    check("TOOL CALL 6 Z\nTOOL CALL 9 Z", &[]);
}
