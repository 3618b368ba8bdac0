//! The sample programs.

use std::path::Path;

use fitcheck::nc::program::{Body, Program, Target, Unit, write};

fn sample(name: &str) -> Vec<u8> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/samples/programs");
    std::fs::read(folder.join(name)).unwrap()
}

const SAMPLES: [&str; 4] = ["cycle_427_italian.h", "fit_check.h", "fit_main.h", "syntax_zoo.h"];
/// Whole programs around a measurement; what they do is in `around`.
const AROUND: [&str; 5] = ["cam_traps.h", "four_cycles_tools.h", "inch_main.h", "mm_note.h", "pocket_fit_rework.h"];

#[test]
fn the_samples_are_read_without_a_warning_and_written_as_they_were() {
    for name in SAMPLES {
        let bytes = sample(name);
        let (program, warnings) = Program::read(&bytes).unwrap();
        assert!(warnings.is_empty(), "{name}: {warnings:#?}");
        assert_eq!(program.write(), bytes, "{name}");
    }
}

#[test]
fn of_the_samples_nothing_is_kept_as_text_but_a_block_that_a_control_could_not_read() {
    let mut others = Vec::new();
    let around =
        AROUND.map(|name| std::fs::read(format!("{}/tests/data/samples/around/{name}", env!("CARGO_MANIFEST_DIR"))));
    for bytes in SAMPLES.map(sample).into_iter().chain(around.map(Result::unwrap)) {
        let (program, _) = Program::read(&bytes).unwrap();
        assert_eq!(program.write(), bytes);
        for (index, block) in program.blocks().iter().enumerate() {
            if block.body == Body::Other {
                others.push(program.text_of(index).next().unwrap().to_owned());
            }
        }
    }
    assert_eq!(others, ["23 ERROR = 23 TOOL CALL \"MILL D6\" Z S50"]);
}

#[test]
fn what_a_control_wrote_is_printed_as_it_stands() {
    for name in ["fit_check.h", "fit_main.h"] {
        let (program, _) = Program::read(&sample(name)).unwrap();
        for (index, block) in program.blocks().iter().enumerate() {
            let written: Vec<&str> = program.text_of(index).collect();
            let comment = program.comment_of(index).unwrap_or_default();
            assert_eq!(write::commented(block.number.unwrap(), &block.body, comment), written);
        }
    }
}

#[test]
fn labels_lines_and_blocks_are_found() {
    let (program, _) = Program::read(&sample("fit_check.h")).unwrap();
    assert_eq!((program.name(), program.unit()), (Some("fit_check"), Some(Unit::Mm)));
    let block = program.label(&Target::Number(99)).unwrap();
    assert_eq!(program.text_of(block).collect::<Vec<_>>(), ["22 LBL 99"]);
    assert_eq!(program.block_at(22), Some(22));
    // The first cycle has 17 lines.
    assert_eq!(
        (program.blocks()[33].lines.clone(), program.block_at(40), program.block_at(50)),
        (33..50, Some(33), Some(34))
    );
    assert_eq!(program.line_count(), program.blocks().last().unwrap().lines.end);
    assert_eq!(program.block_at(program.line_count()), None);
}

#[test]
fn a_blank_line_within_a_cycle_does_not_end_it() {
    let (program, _) = Program::read(&sample("cycle_427_italian.h")).unwrap();
    let Body::Probe(cycle) = &program.blocks()[2].body else { panic!("no cycle") };
    let set: Vec<String> = cycle.lines.iter().map(|line| line.parameter.to_string()).collect();
    let wanted = ["263", "264", "261", "320", "272", "267", "260", "281", "288", "289", "309", "330", "498", "531"];
    assert_eq!(set, wanted.map(|number| format!("Q{number}")));
    assert_eq!((cycle.number.as_str(), cycle.name.as_str()), ("427", "MISURAZ. COORDINATA"));
    assert_eq!(cycle.lines[13].comment, "ANGOLO DI INCLINAZ.");
    assert_eq!((cycle.lines[13].place.line, cycle.lines[13].place.column), (18, 5));
}
