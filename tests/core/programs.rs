//! Reading and writing NC programs.

use std::path::Path;

use fitcheck::control::program::{Body, Program};

fn sample(name: &str) -> Vec<u8> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/samples/programs");
    std::fs::read(folder.join(name)).unwrap()
}

const SAMPLES: [&str; 4] = ["cycle_427_italian.h", "fit_check.h", "fit_main.h", "syntax_zoo.h"];

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
fn of_the_samples_only_stock_and_system_data_are_kept_as_text() {
    let mut others = Vec::new();
    for name in SAMPLES {
        let (program, _) = Program::read(&sample(name)).unwrap();
        for (index, block) in program.blocks().iter().enumerate() {
            if block.body == Body::Other {
                others.push(program.text_of(index).next().unwrap().to_owned());
            }
        }
    }
    assert_eq!(
        others,
        [
            "1  BLK FORM 0.1 Z  X-50  Y-50  Z-20",
            "2  BLK FORM 0.2  X+50  Y+50  Z+0",
            "45 FN 18: SYSREAD Q40 = ID270 NR1 IDX1",
        ]
    );
}
